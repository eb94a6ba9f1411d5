//! The shipped reflectances that an encoding is chosen and judged by, and its three errors.
//!
//! [`EvaluationSet::choosing`] and [`EvaluationSet::judging`] share no patch and no band-pass.

use std::sync::Arc;

use serde::Serialize;

use crate::{
    color::{Observer, PatchSet},
    preset,
    spectrum::{Band, Basis},
    study::{FitBasis, Measure, Measures, ProjectedSpectrum, Reference, Verdict},
};

/// The reflectances that choose.
const PATCHES: &str = "colorchecker_ohta";

/// The reflectances that judge.
const JUDGES: &str = "tm30_ces99_5nm";

/// Error measures on one band for one observer.
#[derive(Clone, Debug)]
pub struct EvaluationSet {
    measures: Arc<Measures>,
    reflectances: Vec<Vec<f64>>,
}

/// The three errors of one model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Errors {
    /// Mean CIEDE2000 of the patches, both factors approximated.
    #[serde(rename = "patches_check")]
    pub patches: f64,
    /// Mean CIEDE2000 behind the band-passes.
    pub filters: f64,
    /// Relative RMS behind a 10 nm blur.
    #[serde(rename = "relative_rms_10nm")]
    pub blurred: f64,
}

impl Errors {
    /// Patches, filters, blurred.
    pub(crate) fn to_array(self) -> [f64; 3] {
        [self.patches, self.filters, self.blurred]
    }
}

impl From<&Verdict> for Errors {
    /// Colours that do not exist are not off: no centre of a band-pass lies in a range that ends
    /// below 420 nm. An error of the curve that does not exist is infinite.
    fn from(verdict: &Verdict) -> Self {
        Self {
            patches: verdict[Measure::Patches].unwrap_or(0.0),
            filters: verdict[Measure::Filters].unwrap_or(0.0),
            blurred: verdict[Measure::RmsBlurred].unwrap_or(f64::INFINITY),
        }
    }
}

impl EvaluationSet {
    /// The set for choosing: the ColorChecker and band-passes at 420, 430 ... 670 nm.
    pub fn choosing(band: Band, observer: Observer) -> Self {
        Self::new(band, observer, PATCHES, Measures::new)
    }

    /// The set for judging, not used in any choice: CES99 and band-passes at 425, 435 ... 675 nm.
    pub(crate) fn judging(band: Band, observer: Observer) -> Self {
        Self::new(band, observer, JUDGES, Measures::judging)
    }

    fn new(
        band: Band,
        observer: Observer,
        group: &str,
        measures: fn(PatchSet) -> Measures,
    ) -> Self {
        let tables = preset::group(group).into_iter().flat_map(|g| &g.items);
        let (names, reflectances): (_, Vec<Vec<f64>>) = tables
            .filter_map(|item| item.spectrum())
            .map(|s| (s.name.clone(), s.samples.on_band(band, s.kind.outside())))
            .unzip();
        let patches = PatchSet::new(&reflectances, names, band, observer);
        Self {
            measures: Arc::new(measures(patches)),
            reflectances,
        }
    }

    /// The exact patches, the band-passes, the blur and the observer.
    pub(crate) fn measures(&self) -> &Measures {
        &self.measures
    }

    /// The band.
    pub fn band(&self) -> Band {
        self.measures.band()
    }

    /// The patches' reflectances on the grid.
    pub(crate) fn reflectances(&self) -> &[Vec<f64>] {
        &self.reflectances
    }

    /// The patches as colour-exact cosine series of `numbers` numbers (X, Y, Z of the equal-energy
    /// light, since it is not known under which light they will be seen).
    pub(crate) fn patches_as_cosines(&self, numbers: usize) -> PatchSet {
        let Measures { patches, seen, .. } = &*self.measures;
        let fit_basis = FitBasis::new(self.band(), Basis::Cosine, numbers, seen);
        let as_cosines = |values: &Vec<f64>| {
            let projected = ProjectedSpectrum::new(&fit_basis, values, &[], seen);
            projected.smooth(&projected.model(numbers, &[], true).0)
        };
        let series: Vec<Vec<f64>> = self.reflectances.iter().map(as_cosines).collect();
        let names = patches.names().to_vec();
        PatchSet::new(&series, names, self.band(), patches.observer())
    }

    /// The exact side of a light on the grid; `None` when it has no colour on this band.
    pub fn exact(&self, light: &[f64]) -> Option<Reference> {
        let exact = Reference::of_light(&self.measures, light);
        exact.has_colour().then_some(exact)
    }

    /// The three errors of a model's values on the grid; `patches` are the patches as its
    /// representation has them.
    pub(crate) fn errors(&self, exact: &Reference, values: &[f64], patches: &PatchSet) -> Errors {
        (&exact.verdict_through(values, &[], patches)).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_surfaces_choose_and_judge_as_are_named() {
        let [choosing, judging] = [EvaluationSet::choosing, EvaluationSet::judging]
            .map(|panel| panel(Band::VISIBLE, Observer::CIE_1931).reflectances.len());
        assert_eq!([choosing, judging], [24, 99]);
    }

    #[test]
    fn a_model_that_is_the_light_is_off_by_its_patches_only() {
        let band = Band::VISIBLE;
        let panel = EvaluationSet::judging(band, Observer::CIE_1931);
        let light: Vec<f64> = band.grid().map(|nm| 1.0 + (nm / 70.0).cos()).collect();
        let exact = panel.exact(&light).expect("a light");
        let errors = panel.errors(&exact, &light, &panel.measures.patches);
        assert_eq!(errors, Errors::default());
        let approximated = panel.errors(&exact, &light, &panel.patches_as_cosines(11));
        assert!(approximated.patches > 0.0);
        assert_eq!((approximated.filters, approximated.blurred), (0.0, 0.0));
        assert_eq!(exact.figure(Measure::Own, &light, &[]), Some(0.0));
    }

    #[test]
    fn darkness_and_the_unseen_have_no_exact_side() {
        let panel = EvaluationSet::choosing(Band::VISIBLE, Observer::CIE_1931);
        assert!(panel.exact(&vec![0.0; 401]).is_none());
        let infrared = Band::new(900.0, 1000.0).expect("100 nm");
        let panel = EvaluationSet::choosing(infrared, Observer::CIE_1931);
        assert!(panel.exact(&vec![1.0; 101]).is_none());
    }
}
