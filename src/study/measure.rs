//! The figures by which a model is judged against what was measured, each by its name.

use std::ops::{Index, IndexMut};

use serde::{Deserialize, Serialize};

/// One figure of a model: CIEDE2000, or a share of the spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Measure {
    /// CIEDE2000 of the spectrum's own colour.
    Own,
    /// Mean CIEDE2000 of the patches.
    #[default]
    Patches,
    /// Largest CIEDE2000 of the patches.
    PatchesWorst,
    /// Mean CIEDE2000 behind narrow filters.
    Filters,
    /// Root mean square of the difference over that of the spectrum, at 1 nm.
    Rms,
    /// The same behind a 10 nm blur: what a spectrometer of that bandwidth would see.
    RmsBlurred,
    /// Largest difference over the largest value. Nothing is chosen by it: it has no stored word,
    /// nor have those after it.
    #[serde(skip)]
    MaxAbs,
    /// Power gained (positive) or lost over the spectrum's.
    #[serde(skip)]
    Energy,
    /// Lowest value of the smooth part over the largest value: negative when it dips below zero.
    #[serde(skip)]
    Lowest,
    /// Mean distance that power has to be moved to be where it was measured, nm.
    #[serde(skip)]
    Displacement,
}

impl Measure {
    /// Every figure, in the order of files.
    pub const ALL: [Self; 10] = [
        Self::Own,
        Self::Patches,
        Self::PatchesWorst,
        Self::Filters,
        Self::Rms,
        Self::RmsBlurred,
        Self::MaxAbs,
        Self::Energy,
        Self::Lowest,
        Self::Displacement,
    ];

    /// The errors that studies compare models by, in the order of menus; less is better.
    pub const COMPARED: [Self; 6] = [
        Self::Patches,
        Self::PatchesWorst,
        Self::Own,
        Self::Filters,
        Self::RmsBlurred,
        Self::Rms,
    ];

    /// [`COMPARED`](Self::COMPARED) in the order of files.
    pub(crate) fn in_files() -> impl Iterator<Item = Self> {
        let all = Self::ALL.into_iter();
        all.filter(|measure| Self::COMPARED.contains(measure))
    }

    /// True if it is a CIEDE2000; otherwise it is a share of the spectrum.
    pub(crate) const fn is_colour(self) -> bool {
        matches!(
            self,
            Self::Own | Self::Patches | Self::PatchesWorst | Self::Filters
        )
    }
}

/// Something of every figure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ByMeasure<T>([T; Measure::ALL.len()]);

/// Errors of one model; a figure that does not exist, or was not requested, is `None`.
pub type Verdict = ByMeasure<Option<f64>>;

impl<T> ByMeasure<T> {
    /// Made figure by figure.
    pub(crate) fn from_fn(mut of: impl FnMut(Measure) -> T) -> Self {
        Self(std::array::from_fn(|i| of(Measure::ALL[i])))
    }
}

impl<T> Index<Measure> for ByMeasure<T> {
    type Output = T;

    fn index(&self, measure: Measure) -> &T {
        &self.0[measure as usize]
    }
}

impl<T> IndexMut<Measure> for ByMeasure<T> {
    fn index_mut(&mut self, measure: Measure) -> &mut T {
        &mut self.0[measure as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_figure_has_a_place_and_those_that_models_are_compared_by_a_stored_word() {
        let found = ByMeasure::from_fn(|measure| measure);
        for measure in Measure::ALL {
            assert_eq!(found[measure], measure);
            let word = serde_json::to_value(measure).ok();
            assert_eq!(word.is_some(), Measure::COMPARED.contains(&measure));
            let read = word.and_then(|word| serde_json::from_value(word).ok());
            assert!(read.is_none_or(|read: Measure| read == measure));
        }
        assert!(serde_json::from_str::<Measure>("\"lowest\"").is_err());
    }
}
