//! What is said about a spectrum, as facts; the words are made once, when all is decided.

use std::fmt;

use super::decision::{AxisDecision, Decision, Decisions};
use crate::io::choices::Counted;
use crate::io::text::units::WavelengthUnit;
use crate::spectrum::Kind;

/// What is said of a spectrum that counts photons.
pub(crate) const PHOTON_NOTE: &str = "the file counts photons, not energy: unless they are turned into power, its values weigh long \
     wavelengths too heavily";

/// One thing to say about a spectrum.
#[derive(Clone, Debug, PartialEq)]
pub enum Remark {
    /// The line of provenance.
    Line,
    /// What its axis counts.
    Axis,
    /// What its values stand for.
    Kind,
    /// What its values are counted in.
    Counted,
    /// What the file says of the kind, against a person's decision.
    Against(Decision<Kind>),
    /// Points at a wavelength of zero were dropped.
    AtZero(usize),
    /// Points without a value were dropped.
    Missing(usize),
    /// Numbers that instruments write for "not measured" were taken so.
    NotMeasured { value: f64, count: usize },
    /// Wavelengths that fell were turned round.
    TurnedRound,
    /// Wavelengths that step back were put in order.
    StepsBack(usize),
    /// Values at one wavelength were averaged.
    Averaged(usize),
    /// Wavelengths in vacuum were turned into those in air, or kept.
    FromVacuum(bool),
    /// The values count photons.
    Photons,
    /// The values may be per unit of an axis that counts no lengths.
    PerOther,
    /// What a file that was written here says of the one before it, unless the line of provenance
    /// says so already: how that was read is most often how this one is.
    Before(String),
    /// The reader's own words.
    Note(String),
}

/// What is said of a light over an axis that counts no lengths.
const PER_OTHER: &str = "the values are kept as written: where they are per unit of that axis \
     (per THz, per 1/cm, per eV) and not per nm, they are not rescaled";

/// What is said of wavelengths that were measured in vacuum.
const TO_AIR: &str = "wavelengths in vacuum turned into those in air, as lines of lamps are listed";
const KEPT_IN_VACUUM: &str = "wavelengths in vacuum kept: those in air are shorter by less than a \
     tenth of the steps";

/// A decision that was a guess, in words.
pub(crate) fn taken_as(chosen: &str, reason: &str) -> String {
    format!("taken as {chosen}: {reason}")
}

impl Remark {
    /// The remark in words; `None` where there is nothing to say. `against` is another unit that
    /// the file names for its axis.
    pub fn words(self, decisions: &Decisions, against: Option<&str>) -> Option<String> {
        match self {
            Self::Line => None,
            Self::Axis => match &decisions.axis {
                Some(AxisDecision::Unit(unit)) => axis_words(unit, against),
                Some(AxisDecision::Laser(_)) | None => None,
            },
            Self::Kind => {
                let kind = &decisions.kind;
                let guess = kind.is_guess();
                guess.then(|| taken_as(kind.value.word(), &kind.reason))
            }
            Self::Counted => decisions.counted.as_ref().and_then(counted_words),
            Self::Against(own) => Some(format!(
                "chosen by hand as {}: {} tells {}",
                decisions.kind.value, own.reason, own.value
            )),
            other => Some(other.to_string()),
        }
    }
}

/// What a guessed unit of an axis is called: "nm", or "nm, not Å" where the file says otherwise.
pub(crate) fn unit_words(unit: WavelengthUnit, against: Option<&str>) -> String {
    match against {
        Some(other) => format!("{}, not {other}", unit.word()),
        None => unit.word().to_owned(),
    }
}

fn axis_words(unit: &Decision<WavelengthUnit>, against: Option<&str>) -> Option<String> {
    if unit.is_guess() {
        return Some(taken_as(&unit_words(unit.value, against), &unit.reason));
    }
    let word = unit.value.word();
    (unit.value != WavelengthUnit::Nanometre)
        .then(|| format!("wavelengths converted from {word} ({})", unit.reason))
}

fn counted_words(counted: &Decision<Counted>) -> Option<String> {
    let reason = &counted.reason;
    if counted.is_guess() {
        return Some(taken_as(counted.value.word(), reason));
    }
    match counted.value {
        Counted::Percent => Some(format!("per cent divided by 100 ({reason})")),
        Counted::TenThousandths => Some(format!("values divided by 10000 ({reason})")),
        Counted::SixteenBits => Some(format!("values divided by 65535 ({reason})")),
        Counted::EightBits => Some(format!("values divided by 255 ({reason})")),
        Counted::Fraction | Counted::Otherwise => None,
    }
}

/// The words of what hangs on no decision.
impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line | Self::Axis | Self::Kind | Self::Counted | Self::Against(_) => Ok(()),
            Self::AtZero(1) => f.write_str("1 point at a wavelength of 0 dropped"),
            Self::AtZero(n) => write!(f, "{n} points at a wavelength of 0 dropped"),
            Self::Missing(1) => f.write_str("1 missing value dropped"),
            Self::Missing(n) => write!(f, "{n} missing values dropped"),
            Self::NotMeasured { value, count: 1 } => {
                write!(f, "1 value of {value} taken as not measured")
            }
            Self::NotMeasured { value, count } => {
                write!(f, "{count} values of {value} taken as not measured")
            }
            Self::TurnedRound => f.write_str("falling wavelengths turned round"),
            Self::StepsBack(1) => f.write_str("wavelengths step back once: put in rising order"),
            Self::StepsBack(n) => {
                write!(f, "wavelengths step back {n} times: put in rising order")
            }
            Self::Averaged(1) => f.write_str("1 doubled wavelength averaged"),
            Self::Averaged(n) => write!(f, "{n} doubled wavelengths averaged"),
            Self::FromVacuum(true) => f.write_str(TO_AIR),
            Self::FromVacuum(false) => f.write_str(KEPT_IN_VACUUM),
            Self::Photons => f.write_str(PHOTON_NOTE),
            Self::PerOther => f.write_str(PER_OTHER),
            Self::Before(words) | Self::Note(words) => f.write_str(words),
        }
    }
}
