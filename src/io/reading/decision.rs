//! What was decided about a spectrum, by whom and why: every fact once.

use crate::io::choices::Counted;
use crate::io::text::units::WavelengthUnit;
use crate::spectrum::Kind;

/// What is said of a decision that a person took.
pub(crate) const BY_HAND: &str = "chosen by hand";

/// What is said of one that the format leaves no choice about.
const ITS_FORMAT: &str = "its format";

/// What a decision stands on, the firmest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A person.
    Chosen,
    /// The file, or its format.
    Stated,
    /// Words or numbers that leave hardly a doubt.
    Evident,
    /// What is usual: a person should look.
    Likely,
}

/// A decision about a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision<T> {
    /// What was decided.
    pub value: T,
    /// What it stands on.
    pub origin: Origin,
    /// What spoke for it, in words.
    pub reason: String,
}

impl<T> Decision<T> {
    fn of(value: T, origin: Origin, reason: impl Into<String>) -> Self {
        let reason = reason.into();
        Self {
            value,
            origin,
            reason,
        }
    }

    /// A person's.
    pub(crate) fn chosen(value: T) -> Self {
        Self::of(value, Origin::Chosen, BY_HAND)
    }

    /// One that the file states.
    pub(crate) fn stated(value: T, reason: impl Into<String>) -> Self {
        Self::of(value, Origin::Stated, reason)
    }

    /// One that the format leaves no choice about.
    pub(crate) fn of_format(value: T) -> Self {
        Self::stated(value, ITS_FORMAT)
    }

    /// A guess, from what leaves hardly a doubt or from what is usual.
    pub(crate) fn guessed(value: T, is_evident: bool, reason: impl Into<String>) -> Self {
        let origin = match is_evident {
            true => Origin::Evident,
            false => Origin::Likely,
        };
        Self::of(value, origin, reason)
    }

    /// Whether neither a person nor the file says so.
    pub(crate) fn is_guess(&self) -> bool {
        matches!(self.origin, Origin::Evident | Origin::Likely)
    }

    /// Whether a person should look.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.origin == Origin::Likely
    }
}

/// What the wavelength axis of a spectrum counts.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisDecision {
    /// Wavelengths or their like.
    Unit(Decision<WavelengthUnit>),
    /// Raman shifts from the line of a laser, nm.
    Laser(Decision<f64>),
}

impl AxisDecision {
    /// Whether a person should look: anything but nanometres is rare enough to ask.
    pub(crate) fn is_doubtful(&self) -> bool {
        match self {
            Self::Unit(unit) => unit.is_doubtful() && unit.value != WavelengthUnit::Nanometre,
            Self::Laser(laser) => laser.is_doubtful(),
        }
    }
}

/// How a spectrum or an image was understood, what was stated as well as what was guessed.
#[derive(Clone, Debug, PartialEq)]
pub struct Decisions {
    /// What the wavelength axis counts; `None` where the format leaves it no choice.
    pub axis: Option<AxisDecision>,
    /// What the values stand for.
    pub kind: Decision<Kind>,
    /// What the values are counted in; `None` where they are no factor.
    pub counted: Option<Decision<Counted>>,
}

impl Decisions {
    /// What spoke for each decision.
    pub(crate) fn reasons(&mut self) -> impl Iterator<Item = &mut String> {
        let axis = self.axis.as_mut().map(|axis| match axis {
            AxisDecision::Unit(unit) => &mut unit.reason,
            AxisDecision::Laser(laser) => &mut laser.reason,
        });
        let counted = self.counted.as_mut().map(|counted| &mut counted.reason);
        let kind = Some(&mut self.kind.reason);
        [kind, axis, counted].into_iter().flatten()
    }

    /// Whether a person should look.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.kind.is_doubtful()
            || self.counted.as_ref().is_some_and(Decision::is_doubtful)
            || self.axis.as_ref().is_some_and(AxisDecision::is_doubtful)
    }
}
