//! What is made of measurements: formulas, means of scans, spliced ranges, slits, corrections by an
//! instrument, and what changed between two sets. The command line and the window ask the same way.

pub mod act;
mod example;
mod formula;
mod instrument;
mod parts;
mod result;
mod scans;
mod slit;
pub mod table;
mod verb;
pub mod words;

use std::fmt::Display;

use super::{instruments, readings::Reading};
use crate::{
    languages::with_sign,
    measurements::{Formula, Normalise, Slit},
};

pub use act::Act;
pub use example::{Drawn, example};
pub use instrument::{KeptInstrument, known_of_words, learnt};
pub use parts::{Part, measurements};
pub use result::{Found, LineRow, ScanRow, doubts_of};
pub use scans::of_change;
pub use verb::{Slot, Verb};

impl Act {
    /// What it makes of the parts.
    ///
    /// # Errors
    /// A sentence for combinations that mean nothing.
    pub fn of(&self, parts: &[Part]) -> Result<Found, String> {
        let all = || measurements(parts);
        let mut found = match self {
            Self::Formula {
                text,
                keep_all,
                equal,
                of_surface,
            } => {
                let formula = Formula::parse(text).map_err(said)?;
                let parts = formula::at_equal(parts, *equal)?;
                let mut found = formula::of_formula(&formula, text, &parts, *keep_all)?;
                formula::name_quotient(&mut found, &formula, &parts, *of_surface);
                if let Some(equal) = equal {
                    found.notes.push(match equal {
                        Normalise::Peak => {
                            said!("Lights are brought to equal peak first.").to_owned()
                        }
                        Normalise::Area => {
                            said!("Lights are brought to equal area first.").to_owned()
                        }
                        Normalise::At(nm) => tr!(
                            "Lights are brought to equal value at {place} nm first.",
                            place = with_sign(nm.to_string())
                        ),
                        Normalise::Y => said!("Lights are brought to equal Y first.").to_owned(),
                    });
                }
                found
            }
            Self::Mean { keep_all } => {
                scans::of_composites(scans::of_scans(&all(), *keep_all)?, parts)?
            }
            Self::Splice { is_sound } => formula::of_ranges(&all(), *is_sound)?,
            Self::Slit { fwhm_nm, shape } => slit::through(
                all(),
                Slit {
                    shape: *shape,
                    fwhm_nm: *fwhm_nm,
                },
            )?,
            Self::Unslit { fwhm_nm, shape } => slit::taken_off(all(), *fwhm_nm, *shape)?,
            Self::Corrected { instrument } => {
                instrument::used(instruments::of(instrument)?, &all())?
            }
        };
        let readings: Vec<Reading> = parts.iter().map(|part| part.reading.clone()).collect();
        found.reading = Reading::of_parts(&readings, found.result().quantity);
        found.cut_lines();
        Ok(found)
    }
}

impl Act {
    /// The name of what it makes of the parts.
    pub fn name(&self, parts: &[Part]) -> String {
        let name = |index: usize| parts.get(index).map_or("", |part| part.of.name.as_str());
        match self {
            Self::Formula { text, .. } => {
                let letter = |c: char| match c {
                    'A'..='Z' => name(usize::from(c as u8 - b'A')).to_owned(),
                    c => c.to_string(),
                };
                text.chars().map(letter).collect()
            }
            Self::Mean { .. } => tr!(
                "{name}, mean of {count}",
                name = name(0),
                count = parts.len()
            ),
            Self::Splice { .. } => tr!(
                "{first} and {second} spliced",
                first = name(0),
                second = name(1)
            ),
            Self::Slit { fwhm_nm, .. } => tr!(
                "{name} through {width} nm",
                name = name(0),
                width = with_sign(fwhm_nm.to_string())
            ),
            Self::Unslit { .. } => tr!("{name} without its slit", name = name(0)),
            Self::Corrected { .. } => tr!("{name} corrected", name = name(0)),
        }
    }
}

/// An error as its sentence.
fn said(why: impl Display) -> String {
    why.to_string()
}
