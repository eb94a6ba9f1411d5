//! What the page Combine is set to: a verb and the spectra of the library that it is asked of.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::{Act, Found, Part, of_change};
use crate::{
    app::{App, Entry, Recipe},
    measurements::{Kernel, Measurement, Normalise},
};

/// What is done with the spectra.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verb {
    #[default]
    Mean,
    Difference,
    Sum,
    Quotient,
    QuotientLessDark,
    Absorbance,
    Splice,
    Slit,
    Unslit,
    Changed,
}

/// One of the places that a verb needs a spectrum for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slot {
    pub name: &'static str,
    pub meaning: &'static str,
}

const fn slot(name: &'static str, meaning: &'static str) -> Slot {
    Slot { name, meaning }
}

impl Verb {
    /// Every verb, in the order offered.
    pub const ALL: [Self; 10] = [
        Self::Mean,
        Self::Difference,
        Self::Sum,
        Self::Quotient,
        Self::QuotientLessDark,
        Self::Absorbance,
        Self::Splice,
        Self::Slit,
        Self::Unslit,
        Self::Changed,
    ];

    /// What it is called.
    pub fn title(self) -> &'static str {
        match self {
            Self::Mean => "mean of scans",
            Self::Difference => "A less B",
            Self::Sum => "A and B together",
            Self::Quotient => "A over B",
            Self::QuotientLessDark => "A over B, less dark C",
            Self::Absorbance => "absorbance of A over B",
            Self::Splice => "A and B spliced",
            Self::Slit => "seen through a slit",
            Self::Unslit => "its slit taken off",
            Self::Changed => "what changed",
        }
    }

    /// What it is for, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Mean => "Scans of one light: three or more tell how far every figure is known.",
            Self::Difference => "A light less its dark, or less a background.",
            Self::Sum => "Two lights at once.",
            Self::Quotient => "A sample over its reference: how much is let through, or sent back.",
            Self::QuotientLessDark => "The same for counts, the instrument's dark taken off both.",
            Self::Absorbance => "The decadic absorbance of a sample over its reference.",
            Self::Splice => "Two ranges of one light that share 20 nm or more.",
            Self::Slit => "A light as an instrument of a wider slit sees it.",
            Self::Unslit => "A light without what the instrument's slit did to it.",
            Self::Changed => "What differs between two sets of scans beyond their noise.",
        }
    }

    /// The places that it needs a spectrum for; none for verbs of any number of scans.
    pub fn slots(self) -> &'static [Slot] {
        const LIGHT: Slot = slot("Light A", "The light that is looked at.");
        const SAMPLE: Slot = slot("Sample A", "The light behind the sample, or off it.");
        const REFERENCE: Slot = slot("Reference B", "The same light without the sample.");
        match self {
            Self::Mean | Self::Changed => &[],
            Self::Difference => {
                &const {
                    [
                        LIGHT,
                        slot("Dark B", "The dark or the background that is taken off."),
                    ]
                }
            }
            Self::Sum => &const { [LIGHT, slot("Light B", "The light that is added.")] },
            Self::Quotient | Self::Absorbance => &const { [SAMPLE, REFERENCE] },
            Self::QuotientLessDark => {
                &const {
                    [
                        SAMPLE,
                        REFERENCE,
                        slot("Dark C", "What the instrument counts without light."),
                    ]
                }
            }
            Self::Splice => {
                &const {
                    [
                        slot("Range A", "The range that keeps its level."),
                        slot("Range B", "The range that is brought to the level of A."),
                    ]
                }
            }
            Self::Slit | Self::Unslit => &const { [LIGHT] },
        }
    }
}

impl fmt::Display for Verb {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.title())
    }
}

/// What the page is set to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Desk {
    pub verb: Verb,
    /// Keys of A, B and C.
    pub slots: [Option<String>; 3],
    /// Keys of scans of one light.
    pub scans: Vec<String>,
    /// Keys of the scans that they are compared with.
    pub others: Vec<String>,
    /// Width of the slit, nm; for a slit taken off `None` where the light's lines tell it.
    pub fwhm_nm: f64,
    pub is_told: bool,
    pub shape: Kernel,
    pub keep_all: bool,
    /// True if the quotient of two lights is a reflectance.
    pub of_surface: bool,
    /// What lights are brought to one scale by first.
    pub equal: Option<Normalise>,
}

impl Default for Desk {
    fn default() -> Self {
        Self {
            verb: Verb::default(),
            slots: [const { None }; 3],
            scans: Vec::new(),
            others: Vec::new(),
            fwhm_nm: 10.0,
            is_told: false,
            shape: Kernel::Gauss,
            keep_all: false,
            of_surface: false,
            equal: None,
        }
    }
}

/// Why nothing is made yet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Waits {
    /// A place is empty.
    ForSpectra,
    /// It means nothing, in a sentence.
    Refused(String),
}

impl Desk {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        let fwhm_nm = match self.fwhm_nm.is_finite() {
            true => self.fwhm_nm.clamp(0.5, 30.0),
            false => Self::default().fwhm_nm,
        };
        Self { fwhm_nm, ..self }
    }

    /// Keys of what it is asked of, in the order of their letters; `None` while a place is empty.
    fn keys(&self) -> Option<Vec<&str>> {
        let slots = self.verb.slots();
        if slots.is_empty() {
            let is_ready = match self.verb {
                Verb::Changed => !self.scans.is_empty() && !self.others.is_empty(),
                _ => !self.scans.is_empty(),
            };
            return is_ready.then(|| self.scans.iter().map(String::as_str).collect());
        }
        let filled = self.slots.iter().take(slots.len());
        filled.map(Option::as_deref).collect()
    }

    /// What is done with them; `None` for a comparison, which makes no spectrum.
    fn act(&self) -> Option<Act> {
        let formula = |text: &str| Act::Formula {
            text: text.to_owned(),
            keep_all: self.keep_all,
            equal: self.equal,
            of_surface: self.of_surface,
        };
        let shape = self.shape;
        Some(match self.verb {
            Verb::Mean => Act::Mean {
                keep_all: self.keep_all,
            },
            Verb::Difference => formula("A - B"),
            Verb::Sum => formula("A + B"),
            Verb::Quotient => formula("A / B"),
            Verb::QuotientLessDark => formula("(A - C) / (B - C)"),
            Verb::Absorbance => formula("-log10(A / B)"),
            Verb::Splice => Act::Splice { is_sound: false },
            Verb::Slit => Act::Slit {
                fwhm_nm: self.fwhm_nm,
                shape,
            },
            Verb::Unslit => Act::Unslit {
                fwhm_nm: self.is_told.then_some(self.fwhm_nm),
                shape,
            },
            Verb::Changed => return None,
        })
    }

    /// How the library makes it, to follow its parts; `None` where it makes no spectrum.
    pub fn recipe(&self) -> Option<Recipe> {
        let parts = self.keys()?.into_iter().map(str::to_owned).collect();
        let act = self.act()?;
        Some(Recipe::Combined { act, parts })
    }

    /// What comes of it.
    ///
    /// # Errors
    /// [`Waits`] while a place is empty, and for what means nothing.
    pub fn found(&self, app: &App) -> Result<Found, Waits> {
        let keys = self.keys().ok_or(Waits::ForSpectra)?;
        let part = |key: &str| {
            let entry = app.entry(key).ok_or(Waits::ForSpectra)?;
            Part::of_entry(&entry, false).map_err(Waits::Refused)
        };
        let parts: Vec<Part> = keys.into_iter().map(part).collect::<Result<_, _>>()?;
        match self.act() {
            Some(act) => act.of(&parts).map_err(Waits::Refused),
            None => {
                let others = self.others.iter().map(|key| part(key));
                let others: Vec<Part> = others.collect::<Result<_, _>>()?;
                let of = |parts: &[Part]| -> Vec<Measurement> {
                    parts.iter().map(|part| part.of.clone()).collect()
                };
                of_change(&of(&parts), &of(&others), self.keep_all).map_err(Waits::Refused)
            }
        }
    }

    /// Puts a spectrum in the first empty place, or among the scans.
    pub fn add(&mut self, entry: &Entry) {
        let slots = self.verb.slots().len();
        let key = entry.key.clone();
        if slots == 0 {
            if !self.scans.contains(&key) {
                self.scans.push(key);
            }
            return;
        }
        let places = &mut self.slots[..slots];
        let place = places.iter().position(Option::is_none);
        places[place.unwrap_or(slots - 1)] = Some(key);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{Command, MadeFor};

    #[test]
    fn a_desk_makes_what_its_recipe_makes_and_says_what_it_waits_for() {
        let mut app = App::new();
        let mut desk = Desk {
            verb: Verb::Quotient,
            ..Desk::default()
        };
        assert!(matches!(desk.found(&app), Err(Waits::ForSpectra)));
        let fl2 = "cie_fluorescent_1nm/FL2";
        let a = "cie_illuminants/CIE A";
        desk.slots = [Some(fl2.to_owned()), Some(a.to_owned()), None];
        let found = desk.found(&app).expect("two lights");
        let recipe = desk.recipe().expect("a spectrum");
        let place = MadeFor::Shown;
        app.apply(Command::Make { recipe, place });
        let own = &app.document().own[0];
        assert_eq!(own.name(), "FL2 / CIE A");
        let made = own.measured.as_ref().expect("its doubt");
        assert_eq!(made.samples, found.result().samples);
        desk.verb = Verb::Mean;
        assert!(matches!(desk.found(&app), Err(Waits::ForSpectra)));
        desk.add(own);
        desk.add(own);
        assert_eq!(desk.scans.len(), 1);
        desk.verb = Verb::Absorbance;
        desk.slots[1] = Some("colorchecker_ohta/red".to_owned());
        let Err(Waits::Refused(why)) = desk.found(&app) else {
            panic!("an absorbance of a light over a surface");
        };
        assert!(why.contains("A light has no absorbance"), "{why}");
    }
}
