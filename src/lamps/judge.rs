//! The three errors that an encoding is chosen and judged by.
//!
//! ```text
//! patches   mean CIEDE2000 of reflectances, both factors approximated (reflectance: colour-exact
//!           cosine of as many numbers as the light has)
//! filters   mean CIEDE2000 behind 10 nm band-passes, the exact light behind each brought to Y = 50
//!           by at most fifty times
//! blurred   relative RMS behind a 10 nm blur
//! ```
//!
//! The white of every difference is the exact light. [`Panel::choosing`] and [`Panel::judging`]
//! share no patch and no band-pass.

use super::{shipped, window::Window};
use crate::{
    color::{
        Lab, Observer, PatchSet, Weights, Xyz, delta_e_2000, lab_from_xyz,
        patches::{difference, labs_into},
    },
    spectrum::{Band, Basis},
    study::{
        FitBasis, ProjectedSpectrum, bandpass,
        error::{BLUR_NM, Blur},
    },
};

/// Y that the exact light behind a band-pass is brought to, of the light's 1.
const FILTER_Y: f64 = 0.5;

/// Least share of the light's Y that is still brought there; behind a darker band-pass nobody compares
/// colours, and noise would be brightened with it.
const LEAST_SHARE: f64 = 0.01;

/// Most that it is brightened by.
pub(super) const MOST_GAIN: f64 = FILTER_Y / LEAST_SHARE;

/// What errors are measured by, on one band for one observer.
#[derive(Clone, Debug)]
pub struct Panel {
    band: Band,
    observer: Observer,
    names: Vec<String>,
    reflectances: Vec<Vec<f64>>,
    exact: PatchSet,
    filters: Vec<Window>,
    /// Colour-matching functions times trapezoid weights.
    weighted: [Vec<f64>; 3],
    blur: Blur,
    seen: Weights,
}

/// The three errors of one model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Errors {
    /// Mean CIEDE2000 of the patches.
    pub patches: f64,
    /// Mean CIEDE2000 behind the band-passes.
    pub filters: f64,
    /// Relative RMS behind the blur.
    pub blurred: f64,
}

impl Errors {
    /// Patches, filters, blurred.
    pub fn to_array(self) -> [f64; 3] {
        [self.patches, self.filters, self.blurred]
    }
}

/// The exact side for one light.
#[derive(Clone, Debug)]
pub struct Exact {
    white: Xyz,
    own: Lab,
    patches: Vec<Lab>,
    filters: Vec<Lab>,
    gains: Vec<f64>,
    blurred: Vec<f64>,
    square: f64,
}

impl Panel {
    /// What chooses: the ColorChecker and band-passes at 420, 430 ... 670 nm.
    pub fn choosing(band: Band, observer: Observer) -> Self {
        Self::new(band, observer, shipped::PATCHES, 420)
    }

    /// What judges and takes no part in any choice: CES99 and band-passes at 425, 435 ... 675 nm.
    pub fn judging(band: Band, observer: Observer) -> Self {
        Self::new(band, observer, shipped::JUDGES, 425)
    }

    fn new(band: Band, observer: Observer, group: &str, first_nm: u32) -> Self {
        let (names, reflectances) = shipped::reflectances(group, band);
        let centres = (0..26).map(|i| f64::from(first_nm + 10 * i));
        let inside = centres.filter(|nm| band.contains(*nm));
        Self {
            exact: PatchSet::new(&reflectances, names.clone(), band, observer),
            filters: inside.map(|nm| Window::of(&bandpass(band, nm))).collect(),
            weighted: observer.table().weighted_on_band(band),
            blur: Blur::new(band, BLUR_NM),
            seen: observer.table().on_band(band),
            band,
            observer,
            names,
            reflectances,
        }
    }

    /// The band.
    pub fn band(&self) -> Band {
        self.band
    }

    /// The observer.
    pub fn observer(&self) -> Observer {
        self.observer
    }

    /// Colour-matching functions on the grid.
    pub fn seen(&self) -> &Weights {
        &self.seen
    }

    /// The patches' reflectances on the grid.
    pub fn reflectances(&self) -> &[Vec<f64>] {
        &self.reflectances
    }

    /// The blur.
    pub fn blur(&self) -> &Blur {
        &self.blur
    }

    /// The patches as some representation has them.
    pub(crate) fn patches_as(&self, likeness: impl Fn(&[f64]) -> Vec<f64>) -> PatchSet {
        let likenesses: Vec<Vec<f64>> = self.reflectances.iter().map(|r| likeness(r)).collect();
        PatchSet::new(&likenesses, self.names.clone(), self.band, self.observer)
    }

    /// The patches as colour-exact cosine series of `numbers` numbers (X, Y, Z of the equal-energy
    /// light, since it is not known under which light they will be seen).
    pub fn patches_as_cosines(&self, numbers: usize) -> PatchSet {
        let fit_basis = FitBasis::new(self.band, Basis::Cosine, numbers, &self.seen);
        self.patches_as(|values| {
            let projected = ProjectedSpectrum::new(&fit_basis, values, &[], &self.seen);
            projected.smooth(&projected.model(numbers, &[], true).0)
        })
    }

    /// The exact side of a light on the grid; `None` when it has no colour on this band.
    pub fn exact(&self, light: &[f64]) -> Option<Exact> {
        let white = self.exact.white_xyz(light);
        if !(white.y > 0.0 && white.is_finite()) {
            return None;
        }
        let mut behind = self.behind_filters(light);
        let brought = |xyz: &[f64; 3]| (FILTER_Y * white.y / xyz[1].max(0.0)).min(MOST_GAIN);
        let gains: Vec<f64> = behind.iter().map(brought).collect();
        let blurred = self.blur.values(light);
        Some(Exact {
            white,
            own: lab_from_xyz(white, white),
            patches: labs(&self.exact, light, white),
            filters: filtered(&mut behind, &gains, white),
            square: self.band.inner(&blurred, &blurred),
            gains,
            blurred,
        })
    }

    /// The three errors of a model's values on the grid; `patches` are the patches as its
    /// representation has them.
    pub fn errors(&self, exact: &Exact, values: &[f64], patches: &PatchSet) -> Errors {
        let mut behind = self.behind_filters(values);
        let filters = filtered(&mut behind, &exact.gains, exact.white);
        let mut rest = self.blur.values(values);
        rest.iter_mut()
            .zip(&exact.blurred)
            .for_each(|(r, b)| *r -= b);
        Errors {
            patches: difference(&exact.patches, &labs(patches, values, exact.white)).mean,
            filters: difference(&exact.filters, &filters).mean,
            blurred: (self.band.inner(&rest, &rest) / exact.square).sqrt(),
        }
    }

    /// X, Y, Z behind each band-pass, in value x nm.
    fn behind_filters(&self, values: &[f64]) -> Vec<[f64; 3]> {
        let seen = self.weighted.each_ref().map(|row| -> Vec<f64> {
            let weighed = row.iter().zip(values);
            weighed.map(|(w, v)| w * v).collect()
        });
        let behind = |filter: &Window| seen.each_ref().map(|seen| filter.dot(0, seen));
        self.filters.iter().map(behind).collect()
    }

    /// CIEDE2000 of a model's own colour.
    pub fn own(&self, exact: &Exact, values: &[f64]) -> f64 {
        let xyz = self.exact.white_xyz(values);
        delta_e_2000(exact.own, lab_from_xyz(xyz, exact.white))
    }
}

fn labs(patches: &PatchSet, light: &[f64], white: Xyz) -> Vec<Lab> {
    let mut xyz = patches.buffer();
    patches.xyz_into(light, &mut xyz);
    let mut labs = vec![Lab::default(); xyz.len()];
    labs_into(&xyz, white, &mut labs);
    labs
}

fn filtered(behind: &mut [[f64; 3]], gains: &[f64], white: Xyz) -> Vec<Lab> {
    for (xyz, gain) in behind.iter_mut().zip(gains) {
        xyz.iter_mut().for_each(|v| *v *= gain);
    }
    let mut labs = vec![Lab::default(); behind.len()];
    labs_into(behind, white, &mut labs);
    labs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_model_that_is_the_light_is_off_by_its_patches_only() {
        let band = Band::VISIBLE;
        let panel = Panel::judging(band, Observer::CIE_1931);
        let light: Vec<f64> = band.grid().map(|nm| 1.0 + (nm / 70.0).cos()).collect();
        let exact = panel.exact(&light).expect("a light");
        let errors = panel.errors(&exact, &light, &panel.exact);
        assert_eq!(errors, Errors::default());
        let approximated = panel.errors(&exact, &light, &panel.patches_as_cosines(11));
        assert!(approximated.patches > 0.0);
        assert_eq!((approximated.filters, approximated.blurred), (0.0, 0.0));
        assert_eq!(panel.own(&exact, &light), 0.0);
    }

    #[test]
    fn darkness_and_the_unseen_have_no_exact_side() {
        let panel = Panel::choosing(Band::VISIBLE, Observer::CIE_1931);
        assert!(panel.exact(&vec![0.0; 401]).is_none());
        let infrared = Band::new(900.0, 1000.0).expect("100 nm");
        let panel = Panel::choosing(infrared, Observer::CIE_1931);
        assert!(panel.exact(&vec![1.0; 101]).is_none());
    }
}
