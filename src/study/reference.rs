//! Reference for every model of one spectrum: its own colour, the patches, narrow filters and the
//! spectrum itself.
//!
//! **Behind narrow filters**: Gaussian band-passes of 10 nm full width centred at 420, 430 ... 670
//! nm, for what takes no part in a choice at 425, 435 ... 675 nm; the filter exact, both sides
//! scaled so that the exact product has Y = 50 (by at most 50), mean CIEDE2000. The white of every
//! difference is the exact light.

use std::sync::Arc;

use super::{
    error::{BLUR_NM, Blur, height, times},
    measure::{Measure, Verdict},
    projected_spectrum::ProjectedSpectrum,
    way::FitVariant,
};
use crate::{
    color::{
        Lab, Observer, Weights, Xyz, delta_e_2000, lab_from_xyz,
        patches::{PatchDifference, PatchSet, difference, labs_into},
        xyz_of_one, xyz_of_parts,
    },
    spectrum::{Band, Composite, Line, add_lines, gaussian},
};

/// Full width of the narrow filters at half their maximum, nm.
pub(crate) const FILTER_NM: f64 = 10.0;

/// Y that the exact light behind a narrow filter is brought to, of the light's 1.
const FILTER_Y: f64 = 0.5;

/// Least share of the light's Y that is still brought there; behind a darker filter nobody compares
/// colours, and noise would be brightened with it.
const LEAST_SHARE: f64 = 0.01;

/// The first of the narrow filters that choose, nm.
const FIRST_NM: f64 = 420.0;

/// The first of those that take no part in a choice, nm.
const FIRST_CHECK_NM: f64 = 425.0;

/// Gain for light behind a narrow filter; both Y in one unit.
pub(crate) fn brightened(behind_y: f64, white_y: f64) -> f64 {
    (FILTER_Y * white_y / behind_y.max(0.0)).min(FILTER_Y / LEAST_SHARE)
}

/// Centres of the narrow filters, nm.
pub(crate) fn filter_centres() -> impl Iterator<Item = f64> {
    centres_from(FIRST_NM)
}

/// 26 centres, one each 10 nm.
fn centres_from(first_nm: f64) -> impl Iterator<Item = f64> {
    (0..26).map(move |i| first_nm + 10.0 * f64::from(i))
}

/// A Gaussian band-pass of 10 nm on a band's grid.
pub(crate) fn bandpass(band: Band, centre_nm: f64) -> Vec<f64> {
    let bell = |nm: f64| gaussian((nm - centre_nm) / FILTER_NM);
    band.grid().map(bell).collect()
}

/// Narrow filters, one each 10 nm, as far as their centres lie in the band.
fn bandpasses(band: Band, observer: Observer, first_nm: f64) -> PatchSet {
    let inside = || centres_from(first_nm).filter(|nm| band.contains(*nm));
    let filters: Vec<Vec<f64>> = inside().map(|nm| bandpass(band, nm)).collect();
    let names = inside().map(|nm| format!("{nm} nm")).collect();
    PatchSet::new(&filters, names, band, observer)
}

/// Measures shared by all spectra that are judged on one band for one observer.
#[derive(Clone, Debug)]
pub struct Measures {
    /// The 10 nm blur.
    pub blur: Blur,
    /// The patches, exact.
    pub patches: PatchSet,
    /// The narrow filters.
    filters: PatchSet,
    /// Colour-matching functions on the grid.
    pub seen: Weights,
}

impl Measures {
    /// Measures that choose, with these patches (exact, on the band's grid).
    pub(crate) fn new(patches: PatchSet) -> Self {
        Self::with_filters(patches, FIRST_NM)
    }

    /// Measures that take no part in a choice: their filters stand between those that choose.
    pub(crate) fn judging(patches: PatchSet) -> Self {
        Self::with_filters(patches, FIRST_CHECK_NM)
    }

    fn with_filters(patches: PatchSet, first_nm: f64) -> Self {
        let (band, observer) = (patches.band(), patches.observer());
        Self {
            blur: Blur::new(band, BLUR_NM),
            filters: bandpasses(band, observer, first_nm),
            seen: observer.table().on_band(band),
            patches,
        }
    }

    /// The band of all of them.
    pub(crate) fn band(&self) -> Band {
        self.patches.band()
    }
}

/// Values over their largest, so that no square overflows or vanishes; `None` when all are zero.
pub(crate) fn scaled_to_one(values: &[f64]) -> Option<Vec<f64>> {
    Some(times(values, height(values)?))
}

/// The exact side of every comparison for one spectrum.
#[derive(Clone, Debug)]
pub struct Reference {
    measures: Arc<Measures>,
    measured: Vec<f64>,
    /// Weights of the spectrum for X, Y, Z.
    seen: Weights,
    white: Xyz,
    own: Option<Lab>,
    /// Labs of the patches; none where there are none to see.
    patches: Vec<Lab>,
    /// Labs behind the narrow filters, and what the light behind each is brightened by.
    filters: Vec<Lab>,
    gains: Vec<f64>,
    square: f64,
    blurred: Vec<f64>,
    blurred_square: f64,
    top: f64,
}

impl Reference {
    /// The reference of a light, given on the band's grid at an ordinary scale (`scaled_to_one`).
    pub fn of_light(measures: &Arc<Measures>, measured: &[f64]) -> Self {
        let mut reference = Self::of(measures, measured, measures.seen.clone(), None);
        if reference.own.is_none() {
            return reference;
        }
        let mut behind = seen_through(&measures.filters, measured, &[]);
        let gain = |xyz: &[f64; 3]| brightened(xyz[1], reference.white.y);
        reference.gains = behind.iter().map(gain).collect();
        reference.filters = reference.filtered(&mut behind);
        reference.patches = reference.labs(&seen_through(&measures.patches, measured, &[]));
        reference
    }

    /// The reference of a reflectance or transmittance under a light, both on the band's grid: no
    /// patches, no filters. `perfect` is what a perfect reflector has in the measured scale.
    pub(crate) fn of_factor(
        measures: &Arc<Measures>,
        measured: &[f64],
        light: &[f64],
        perfect: f64,
    ) -> Self {
        let seen = measures.seen.behind(light);
        let band = measures.band();
        let white = xyz_of_one(band, &seen) * perfect;
        Self::of(measures, measured, seen, Some(white))
    }

    fn of(measures: &Arc<Measures>, measured: &[f64], seen: Weights, white: Option<Xyz>) -> Self {
        let band = measures.band();
        let blurred = measures.blur.values(measured);
        let exact = xyz_of_parts(band, measured, &[], &seen);
        let white = white.unwrap_or(exact);
        let has_colour = white.y > 0.0 && white.is_finite() && exact.is_finite();
        Self {
            white,
            own: has_colour.then(|| lab_from_xyz(exact, white)),
            patches: Vec::new(),
            filters: Vec::new(),
            gains: Vec::new(),
            square: band.inner(measured, measured),
            blurred_square: band.inner(&blurred, &blurred),
            blurred,
            top: measured.iter().fold(0.0, |m: f64, v| m.max(v.abs())),
            measured: measured.to_vec(),
            seen,
            measures: measures.clone(),
        }
    }

    /// The measured values.
    pub fn measured(&self) -> &[f64] {
        &self.measured
    }

    /// Weights of the spectrum for X, Y, Z on the grid: the colour-matching functions, for a
    /// reflectance times the light.
    pub fn seen(&self) -> &Weights {
        &self.seen
    }

    /// True if any of the spectrum is visible.
    pub(crate) fn has_colour(&self) -> bool {
        self.own.is_some()
    }

    /// The shared measures.
    pub(crate) fn measures(&self) -> &Arc<Measures> {
        &self.measures
    }

    /// Every figure of a model: its smooth part on the grid and its spikes.
    pub fn verdict(&self, smooth: &[f64], spikes: &[Line]) -> Verdict {
        self.verdict_through(smooth, spikes, &self.measures.patches)
    }

    /// Every figure, the patches' reflectances approximated too: `patches` are the same patches
    /// as a representation has them.
    pub(crate) fn verdict_through(
        &self,
        smooth: &[f64],
        spikes: &[Line],
        patches: &PatchSet,
    ) -> Verdict {
        let found = self.patches(smooth, spikes, patches);
        Verdict::from_fn(|measure| match measure {
            Measure::Patches => found.map(|found| found.mean),
            Measure::PatchesWorst => found.map(|found| found.max),
            _ => self.figure(measure, smooth, spikes),
        })
    }

    /// One figure of a model. Those that no study compares by are the main page's alone, but for
    /// the lowest value.
    pub fn figure(&self, measure: Measure, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        let patches = || self.patches(smooth, spikes, &self.measures.patches);
        match measure {
            Measure::Own => self.own(smooth, spikes),
            Measure::Patches => patches().map(|found| found.mean),
            Measure::PatchesWorst => patches().map(|found| found.max),
            Measure::Filters => self.filters(smooth, spikes),
            Measure::Rms => self.rms(smooth, spikes),
            Measure::RmsBlurred => self.rms_blurred(smooth, spikes),
            Measure::Lowest => (self.top > 0.0)
                .then(|| smooth.iter().copied().fold(f64::INFINITY, f64::min) / self.top),
            Measure::MaxAbs | Measure::Energy | Measure::Displacement => None,
        }
    }

    fn own(&self, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        let exact = self.own?;
        let band = self.measures.band();
        let xyz = xyz_of_parts(band, smooth, spikes, &self.seen);
        Some(delta_e_2000(exact, lab_from_xyz(xyz, self.white)))
    }

    /// The exact patches against those of a model, as a representation has them.
    pub(super) fn patches(
        &self,
        smooth: &[f64],
        spikes: &[Line],
        patches: &PatchSet,
    ) -> Option<PatchDifference> {
        let found = || self.labs(&seen_through(patches, smooth, spikes));
        (!self.patches.is_empty()).then(|| difference(&self.patches, &found()))
    }

    /// Labs of X, Y, Z against this light as the white.
    fn labs(&self, xyz: &[[f64; 3]]) -> Vec<Lab> {
        let mut labs = vec![Lab::default(); xyz.len()];
        labs_into(xyz, self.white, &mut labs);
        labs
    }

    fn filters(&self, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        let found = || {
            let mut behind = seen_through(&self.measures.filters, smooth, spikes);
            self.filtered(&mut behind)
        };
        (!self.filters.is_empty()).then(|| difference(&self.filters, &found()).mean)
    }

    fn filtered(&self, behind: &mut [[f64; 3]]) -> Vec<Lab> {
        for (xyz, gain) in behind.iter_mut().zip(&self.gains) {
            xyz.iter_mut().for_each(|v| *v *= gain);
        }
        self.labs(behind)
    }

    /// The model of so many numbers, two of them a spike: as many of the heaviest lines are spikes
    /// as make the blurred error least.
    pub(crate) fn with_best_lines(
        &self,
        projected: &ProjectedSpectrum,
        way: FitVariant,
        numbers: usize,
    ) -> Composite {
        let model = |count: usize| {
            let lines: Vec<usize> = (0..count).collect();
            projected
                .model(numbers - 2 * count, &lines, way.colour_exact)
                .0
        };
        let most = match way.spikes {
            true => projected.most_lines(numbers),
            false => return model(0),
        };
        let error = |model: &Composite| {
            let error = self.rms_blurred(&projected.smooth(model), model.lines());
            error.unwrap_or(f64::INFINITY)
        };
        let models = (0..=most).map(|count| {
            let model = model(count);
            (error(&model), model)
        });
        let best = models.min_by(|a, b| a.0.total_cmp(&b.0));
        best.map_or_else(|| model(0), |(_, model)| model)
    }

    fn rms(&self, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        let band = self.measures.band();
        let mut rest: Vec<f64> = smooth
            .iter()
            .zip(&self.measured)
            .map(|(s, m)| s - m)
            .collect();
        add_lines(band, spikes, &mut rest);
        share(band.inner(&rest, &rest), self.square)
    }

    /// Spikes are blurred analytically.
    fn rms_blurred(&self, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        let band = self.measures.band();
        let mut rest = self.measures.blur.values(smooth);
        for (r, m) in rest.iter_mut().zip(&self.blurred) {
            *r -= m;
        }
        self.measures.blur.add_lines(spikes, &mut rest);
        share(band.inner(&rest, &rest), self.blurred_square)
    }
}

/// X, Y, Z of what a light's smooth part and spikes leave of each patch or filter.
fn seen_through(patches: &PatchSet, smooth: &[f64], spikes: &[Line]) -> Vec<[f64; 3]> {
    let mut xyz = patches.buffer();
    patches.xyz_into(smooth, &mut xyz);
    for spike in spikes {
        patches.add_line(spike.at_nm, spike.weight, &mut xyz);
    }
    xyz
}

fn share(square: f64, whole: f64) -> Option<f64> {
    Some((square / whole).sqrt()).filter(|share| whole > 0.0 && share.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::error::spectrum_errors;

    const BAND: Band = Band::VISIBLE;

    fn measures() -> Arc<Measures> {
        let ramp: Vec<f64> = BAND.grid().map(|nm| (nm - 380.0) / 400.0).collect();
        let grey = vec![0.2; BAND.points()];
        let names = ["ramp", "grey"].map(String::from).to_vec();
        let set = PatchSet::new(&[ramp, grey], names, BAND, Observer::CIE_1931);
        Arc::new(Measures::new(set))
    }

    /// A smooth light of ordinary height.
    fn light() -> Vec<f64> {
        BAND.grid()
            .map(|nm| 0.7 + 0.3 * (nm / 60.0).cos())
            .collect()
    }

    #[test]
    fn a_model_that_is_the_spectrum_is_off_by_nothing() {
        let reference = Reference::of_light(&measures(), &light());
        let verdict = reference.verdict(&light(), &[]);
        for measure in Measure::COMPARED {
            assert_eq!(verdict[measure], Some(0.0), "{measure:?}");
        }
        assert!(verdict[Measure::Lowest].is_some_and(|lowest| lowest > 0.3));
    }

    #[test]
    fn a_line_on_a_grid_point_is_one_nm_of_light_there() {
        let reference = Reference::of_light(&measures(), &light());
        let mut nm_of_light = light();
        nm_of_light[166] += 3.0;
        let spike = Line::ideal(546.0, 3.0);
        let (a, b) = (
            reference.verdict(&nm_of_light, &[]),
            reference.verdict(&light(), &[spike]),
        );
        for measure in Measure::COMPARED {
            let (a, b) = (a[measure], b[measure]);
            let (a, b) = (a.expect("a light"), b.expect("a light"));
            // The blur adds spikes by the formula that its taps are values of; everything else
            // sums the same products in another order.
            assert!((a - b).abs() < 1e-9 * a, "{measure:?}: {a} {b}");
        }
    }

    #[test]
    fn the_errors_of_the_spectrum_are_those_of_the_main_page() {
        let reference = Reference::of_light(&measures(), &light());
        let smooth: Vec<f64> = light().iter().map(|v| 0.9 * v + 0.02).collect();
        let spikes = [Line::ideal(500.3, 0.8)];
        let blur = &reference.measures().blur;
        let shown = spectrum_errors(blur, &light(), &smooth, &spikes).expect("it shines");
        let verdict = reference.verdict(&smooth, &spikes);
        for measure in [Measure::Rms, Measure::RmsBlurred, Measure::Lowest] {
            // The main page scales by the largest value first.
            let [found, shown] = [verdict, shown].map(|v| v[measure].expect("it shines"));
            assert!((found - shown).abs() < 1e-12, "{found} {shown}");
        }
    }

    #[test]
    fn behind_a_filter_the_exact_light_has_y_50_or_is_brightened_fifty_times() {
        let reference = Reference::of_light(&measures(), &light());
        let (labs, gains) = (&reference.filters, &reference.gains);
        assert_eq!(labs.len(), filter_centres().count());
        let fifty = lab_from_xyz(reference.white * 0.5, reference.white).l;
        for ((lab, gain), at_nm) in labs.iter().zip(gains).zip(filter_centres()) {
            let reached = (lab.l - fifty).abs() < 1e-9;
            assert_eq!(reached, *gain < 50.0, "{at_nm} nm");
            assert!(lab.l <= fifty + 1e-9);
        }
        // Green is bright enough, the far red is not.
        assert!(gains[13] < 10.0 && gains[25] == 50.0);
    }

    #[test]
    fn what_a_filter_hides_does_not_count_behind_it() {
        let reference = Reference::of_light(&measures(), &light());
        let mut outside = light();
        outside[..20].iter_mut().for_each(|v| *v += 0.5);
        let filters = reference.filters(&outside, &[]).expect("a light");
        // 400 nm is two widths from the first filter's centre: exp(-4 ln2 4) is 1e-5.
        assert!(filters < 1e-3, "{filters}");
        assert!(reference.rms(&outside, &[]).expect("a light") > 0.05);
    }

    #[test]
    fn approximated_patches_are_judged_against_exact_ones() {
        let reference = Reference::of_light(&measures(), &light());
        let darker = PatchSet::new(
            &[
                BAND.grid().map(|nm| 0.9 * (nm - 380.0) / 400.0).collect(),
                vec![0.18; BAND.points()],
            ],
            vec![String::new(); 2],
            BAND,
            Observer::CIE_1931,
        );
        let verdict = reference.verdict_through(&light(), &[], &darker);
        assert_eq!(verdict[Measure::Own], Some(0.0));
        assert!(verdict[Measure::Patches].expect("a light") > 0.5);
    }

    #[test]
    fn a_reflectance_is_seen_under_its_light_at_any_scale() {
        let (all, light) = (measures(), light());
        let red: Vec<f64> = BAND.grid().map(|nm| (nm - 380.0) / 400.0).collect();
        let model: Vec<f64> = red.iter().map(|r| 0.8 * r + 0.1).collect();
        let own = |scale: f64| {
            let scaled =
                |values: &[f64]| -> Vec<f64> { values.iter().map(|v| v * scale).collect() };
            let reference = Reference::of_factor(&all, &scaled(&red), &light, scale);
            reference.own(&scaled(&model), &[]).expect("a colour")
        };
        // Products by a power of two are exact.
        assert_eq!(own(1.0), own(4.0));
        assert!(own(1.0) > 1.0);
        let reference = Reference::of_factor(&all, &red, &light, 1.0);
        assert_eq!(reference.figure(Measure::Patches, &model, &[]), None);
        assert_eq!(reference.filters(&model, &[]), None);
    }

    #[test]
    fn light_that_nobody_sees_is_judged_as_a_spectrum_only() {
        let band = Band::new(900.0, 1000.0).expect("100 nm");
        let white = vec![1.0; band.points()];
        let set = PatchSet::new(
            std::slice::from_ref(&white),
            vec![String::new()],
            band,
            Observer::CIE_1931,
        );
        let reference = Reference::of_light(&Arc::new(Measures::new(set)), &white);
        let verdict = reference.verdict(&vec![0.5; band.points()], &[]);
        let mut seen = Measure::ALL.into_iter().filter(|m| m.is_colour());
        assert!(seen.all(|measure| verdict[measure].is_none()));
        // Half the light is off by half.
        assert!(verdict[Measure::Rms].is_some_and(|e| (e - 0.5).abs() < 1e-12));
        assert_eq!(scaled_to_one(&[0.0, 0.0]), None);
        assert_eq!(scaled_to_one(&[1e300, -2e300]), Some(vec![0.5, -1.0]));
    }
}
