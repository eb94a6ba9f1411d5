//! Decisions about a spectrum, with origin and reason: every fact once.

use crate::io::choices::Counted;
use crate::io::text::units::WavelengthUnit;
use crate::languages::said;
use crate::spectrum::Kind;

/// The reason given for a decision by the user.
pub(crate) const BY_HAND: &str = later!("chosen by hand");

/// The reason given for a decision to which the format leaves no alternative.
const ITS_FORMAT: &str = later!("its format");

/// The basis of a decision, the firmest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A person.
    Chosen,
    /// The file, or its format.
    Stated,
    /// Words or numbers that leave hardly a doubt.
    Evident,
    /// The usual case: to be reviewed.
    Likely,
}

/// A decision about a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Decision<T> {
    /// The decided value.
    pub value: T,
    /// The basis of the decision.
    pub origin: Origin,
    /// The evidence for it, in words.
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
        Self::of(value, Origin::Chosen, said(BY_HAND))
    }

    /// One that the file states.
    pub(crate) fn stated(value: T, reason: impl Into<String>) -> Self {
        Self::of(value, Origin::Stated, reason)
    }

    /// One that the format leaves no choice about.
    pub(crate) fn of_format(value: T) -> Self {
        Self::stated(value, said(ITS_FORMAT))
    }

    /// A guess, from what leaves hardly a doubt or from what is usual.
    pub(crate) fn guessed(value: T, is_evident: bool, reason: impl Into<String>) -> Self {
        let origin = match is_evident {
            true => Origin::Evident,
            false => Origin::Likely,
        };
        Self::of(value, origin, reason)
    }

    /// True if stated neither by the user nor by the file.
    pub(crate) fn is_guess(&self) -> bool {
        matches!(self.origin, Origin::Evident | Origin::Likely)
    }

    /// True if it should be reviewed.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.origin == Origin::Likely
    }
}

/// The quantity along the wavelength axis of a spectrum.
#[derive(Clone, Debug, PartialEq)]
pub enum AxisDecision {
    /// Wavelengths or their like.
    Unit(Decision<WavelengthUnit>),
    /// Raman shifts from the line of a laser, nm.
    Laser(Decision<f64>),
}

impl AxisDecision {
    /// True if it should be reviewed: anything but nanometres is rare enough to ask about.
    pub(crate) fn is_doubtful(&self) -> bool {
        match self {
            Self::Unit(unit) => unit.is_doubtful() && unit.value != WavelengthUnit::Nanometre,
            Self::Laser(laser) => laser.is_doubtful(),
        }
    }
}

/// The interpretation of a spectrum or an image, stated as well as guessed.
#[derive(Clone, Debug, PartialEq)]
pub struct Decisions {
    /// The quantity along the wavelength axis; `None` where the format leaves no choice.
    pub axis: Option<AxisDecision>,
    /// The kind of the values.
    pub kind: Decision<Kind>,
    /// The scale of the values; `None` where they are not a factor.
    pub counted: Option<Decision<Counted>>,
}

impl Decisions {
    /// The evidence for each decision.
    pub(crate) fn reasons(&mut self) -> impl Iterator<Item = &mut String> {
        let axis = self.axis.as_mut().map(|axis| match axis {
            AxisDecision::Unit(unit) => &mut unit.reason,
            AxisDecision::Laser(laser) => &mut laser.reason,
        });
        let counted = self.counted.as_mut().map(|counted| &mut counted.reason);
        let kind = Some(&mut self.kind.reason);
        [kind, axis, counted].into_iter().flatten()
    }

    /// True if any of them should be reviewed.
    pub(crate) fn is_doubtful(&self) -> bool {
        self.kind.is_doubtful()
            || self.counted.as_ref().is_some_and(Decision::is_doubtful)
            || self.axis.as_ref().is_some_and(AxisDecision::is_doubtful)
    }
}
