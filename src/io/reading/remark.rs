//! Remarks about a spectrum, as facts; the words are made once, when all is decided.

use super::decision::{Decision, Decisions};
use crate::io::choices::Counted;
use crate::io::text::units::WavelengthUnit;
use crate::languages::said;

/// The note on a spectrum that counts photons.
pub(crate) const PHOTON_NOTE: &str = later!(
    "the file counts photons, not energy: unless they are turned into power, its values weigh long \
     wavelengths too heavily"
);

/// One thing to say about a spectrum. What may still change is put in words when all is decided.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// The line of provenance.
    Line,
    /// The kind of its values.
    Kind,
    /// The scale of its values.
    Counted,
    /// The note of a file written here on the one before it, unless the line of provenance already
    /// states it: both were most often read in the same way.
    Before(String),
    /// Words that hang on nothing else.
    Note(String),
}

/// The note on a light over an axis that does not count lengths.
pub(crate) const PER_OTHER: &str = later!(
    "the values are kept as written: where they are per unit of that axis \
     (per THz, per 1/cm, per eV) and not per nm, they are not rescaled"
);

/// The note on wavelengths measured in vacuum.
pub(crate) const TO_AIR: &str =
    later!("wavelengths in vacuum turned into those in air, as lines of lamps are listed");
pub(crate) const KEPT_IN_VACUUM: &str = later!(
    "wavelengths in vacuum kept: those in air are shorter by less than a \
     tenth of the steps"
);

/// A decision that was a guess, in words.
pub(crate) fn taken_as(chosen: &str, reason: &str) -> String {
    tr!("taken as {chosen}: {reason}", chosen, reason)
}

impl Remark {
    /// The remark in words; `None` where there is nothing to say.
    pub(crate) fn words(self, decisions: &Decisions) -> Option<String> {
        match self {
            Self::Line => None,
            Self::Kind => {
                let kind = &decisions.kind;
                let guess = kind.is_guess();
                guess.then(|| taken_as(said(kind.value.word()), &kind.reason))
            }
            Self::Counted => decisions.counted.as_ref().and_then(counted_words),
            Self::Before(words) | Self::Note(words) => Some(words),
        }
    }
}

/// The words for a guessed unit of an axis: "nm", or "nm, not Å" where the file states otherwise.
pub(crate) fn unit_words(unit: WavelengthUnit, against: Option<&str>) -> String {
    match against {
        Some(other) => tr!("{unit}, not {other}", unit = unit.word(), other),
        None => unit.word().to_owned(),
    }
}

/// The note on the unit of an axis; `against` is another one that the file names.
pub(crate) fn axis_words(unit: &Decision<WavelengthUnit>, against: Option<&str>) -> Option<String> {
    if unit.is_guess() {
        return Some(taken_as(&unit_words(unit.value, against), &unit.reason));
    }
    (unit.value != WavelengthUnit::Nanometre).then(|| {
        tr!(
            "wavelengths converted from {unit} ({reason})",
            unit = unit.value.word(),
            reason = unit.reason
        )
    })
}

fn counted_words(counted: &Decision<Counted>) -> Option<String> {
    let reason = &counted.reason;
    if counted.is_guess() {
        return Some(taken_as(said(counted.value.word()), reason));
    }
    match counted.value {
        Counted::Percent => Some(tr!("per cent divided by 100 ({reason})", reason)),
        Counted::TenThousandths => Some(tr!("values divided by 10000 ({reason})", reason)),
        Counted::SixteenBits => Some(tr!("values divided by 65535 ({reason})", reason)),
        Counted::EightBits => Some(tr!("values divided by 255 ({reason})", reason)),
        Counted::Fraction | Counted::Otherwise => None,
    }
}
