//! Objective, floors and search effort for a mixture.

use serde::{Deserialize, Serialize};

use super::target::Target;
use crate::design::mixture::MixError;

/// The objective among the mixtures of the right colour.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Objective {
    /// Light for the power: greatest luminous efficacy of radiation.
    #[default]
    Ler,
    /// Greatest fidelity index.
    Rf,
    /// Greatest colour rendering index.
    Ra,
    /// Greatest melanopic daylight efficacy ratio.
    Melanopic,
    /// Fewest channels; among those, the greatest efficacy.
    Fewest,
}

impl Objective {
    /// Every objective, the default first.
    pub const ALL: [Self; 5] = [Self::Ler, Self::Rf, Self::Ra, Self::Melanopic, Self::Fewest];

    /// The word used on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Ler => "ler",
            Self::Rf => "rf",
            Self::Ra => "ra",
            Self::Melanopic => "melanopic",
            Self::Fewest => "fewest",
        }
    }
}

/// Effort of the search where a figure of samples is favoured, or is a floor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Care {
    /// From one start: for what is shown while something is dragged.
    Quick,
    /// From several, of which the best counts.
    #[default]
    Full,
}

/// Lower bounds on a mixture's figures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Floors {
    /// Luminous efficacy of radiation, lm/W.
    pub ler: Option<f64>,
    /// Fidelity index.
    pub rf: Option<f64>,
    /// Colour rendering index.
    pub ra: Option<f64>,
    /// Melanopic daylight efficacy ratio.
    pub melanopic: Option<f64>,
}

impl Floors {
    /// Adds a floor in words, `rf=80`.
    ///
    /// # Errors
    /// [`MixError::Word`] for another figure, no number and a figure that has its floor.
    pub fn with(mut self, words: &str) -> Result<Self, MixError> {
        let refused = || MixError::Word {
            found: words.to_owned(),
            expected: "a floor such as rf=80, ra=90, ler=300 or melanopic=0.5",
        };
        let (figure, value) = words.split_once('=').ok_or_else(refused)?;
        let value: f64 = value.trim().parse().map_err(|_| refused())?;
        if !value.is_finite() {
            return Err(refused());
        }
        let floor = match figure.trim() {
            "ler" => &mut self.ler,
            "rf" => &mut self.rf,
            "ra" => &mut self.ra,
            "melanopic" => &mut self.melanopic,
            _ => return Err(refused()),
        };
        match floor.replace(value) {
            None => Ok(self),
            Some(_) => Err(MixError::Word {
                found: words.to_owned(),
                expected: "one floor for each figure",
            }),
        }
    }

    /// True if a floor needs the samples.
    pub(super) fn of_samples(self) -> bool {
        self.rf.is_some() || self.ra.is_some()
    }
}

/// Requirements on a mixture.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Problem<'a> {
    /// Its colour; without one the weights are what is fixed, or one each.
    pub target: Option<Target>,
    /// Its objective.
    pub objective: Objective,
    /// Its lower bounds.
    pub floors: Floors,
    /// A light on whole nm 360-830 to come near to in the least squares, instead of an objective; the
    /// colour is met all the same.
    pub alike: Option<&'a [f64]>,
    /// Effort of the search.
    pub care: Care,
}
