//! What every model of one spectrum is measured by: its own colour, the patches, narrow filters
//! and the spectrum itself.
//!
//! **Behind narrow filters**: Gaussian band-passes of 10 nm full width centred at 420, 430 ... 670
//! nm, the filter exact, both sides scaled so that the exact product has Y = 50 (by at most 50),
//! mean CIEDE2000. The white of every difference is the exact light.

use std::sync::Arc;

use super::{
    error::{BLUR_NM, Blur, height},
    measure::{Measure, Verdict},
};
use crate::{
    color::{
        Lab, Observer, Weights, Xyz, delta_e_2000, lab_from_xyz,
        patches::{PatchSet, difference, labs_into},
        xyz_of_one, xyz_of_parts,
    },
    spectrum::{Band, Line, add_lines, gaussian},
};

/// Full width of the narrow filters at half their maximum, nm.
pub(crate) const FILTER_NM: f64 = 10.0;

/// Y that the exact light behind a narrow filter is brought to.
const FILTER_Y: f64 = 50.0;

/// Most that light behind a narrow filter is brightened by, against Y = 100 for the light.
const MOST_GAIN: f64 = 50.0;

/// The first of the narrow filters that choose, nm.
const FIRST_NM: f64 = 420.0;

/// The first of those that take no part in a choice, nm.
pub(super) const FIRST_CHECK_NM: f64 = 425.0;

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
pub(super) fn bandpasses(band: Band, observer: Observer, first_nm: f64) -> PatchSet {
    let narrow = |centre_nm: f64| bandpass(band, centre_nm);
    let inside = || centres_from(first_nm).filter(|nm| band.contains(*nm));
    let filters: Vec<Vec<f64>> = inside().map(narrow).collect();
    let names = inside().map(|nm| format!("{nm} nm")).collect();
    PatchSet::new(&filters, names, band, observer)
}

/// The exact light behind narrow filters.
#[derive(Clone, Debug)]
pub struct Behind {
    labs: Vec<Lab>,
    /// What the light behind each is brightened by.
    gains: Vec<f64>,
}

/// What is shared by all spectra that are judged on one band for one observer.
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
    /// Measures with these patches (exact, on the band's grid).
    pub fn new(patches: PatchSet) -> Self {
        let (band, observer): (Band, Observer) = (patches.band(), patches.observer());
        Self {
            blur: Blur::new(band, BLUR_NM),
            filters: bandpasses(band, observer, FIRST_NM),
            seen: observer.table().on_band(band),
            patches,
        }
    }

    /// The band of all of them.
    pub fn band(&self) -> Band {
        self.patches.band()
    }
}

/// Values over their largest, so that no square overflows or vanishes; `None` when all are zero.
pub(crate) fn scaled_to_one(values: &[f64]) -> Option<Vec<f64>> {
    let unit = height(values)?;
    Some(values.iter().map(|v| v * unit).collect())
}

/// The exact side of every comparison for one spectrum.
#[derive(Clone, Debug)]
pub struct Reference {
    measures: Arc<Measures>,
    measured: Vec<f64>,
    /// What weighs the spectrum to X, Y, Z.
    seen: Weights,
    white: Xyz,
    own: Option<Lab>,
    /// Labs of the patches; `None` when there are none to see.
    patches: Option<Vec<Lab>>,
    filters: Option<Behind>,
    square: f64,
    blurred: Vec<f64>,
    blurred_square: f64,
    top: f64,
}

const BLACK: Lab = Lab::new(0.0, 0.0, 0.0);

impl Reference {
    /// The reference of a light, given on the band's grid at an ordinary scale (`scaled_to_one`).
    pub fn of_light(measures: &Arc<Measures>, measured: &[f64]) -> Self {
        let mut reference = Self::of(measures, measured, measures.seen.clone(), None);
        if reference.own.is_none() {
            return reference;
        }
        reference.patches = Some(reference.labs_of(&measures.patches, measured, &[]));
        reference.filters = Some(reference.exact_behind(&measures.filters));
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
            patches: None,
            filters: None,
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

    /// What weighs the spectrum to X, Y, Z on the grid: the colour-matching functions, for a
    /// reflectance times the light.
    pub fn seen(&self) -> &Weights {
        &self.seen
    }

    /// The shared measures.
    pub fn measures(&self) -> &Arc<Measures> {
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
        let (mean, worst) = self.patches_with(smooth, spikes, patches).unzip();
        Verdict::from_fn(|measure| match measure {
            Measure::Patches => mean,
            Measure::PatchesWorst => worst,
            _ => self.figure(measure, smooth, spikes),
        })
    }

    /// One figure of a model. Those that no study compares by are the main page's alone, but for
    /// the lowest value.
    pub fn figure(&self, measure: Measure, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        match measure {
            Measure::Own => self.own(smooth, spikes),
            Measure::Patches => self.patches(smooth, spikes).map(|found| found.0),
            Measure::PatchesWorst => self.patches(smooth, spikes).map(|found| found.1),
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

    fn patches(&self, smooth: &[f64], spikes: &[Line]) -> Option<(f64, f64)> {
        self.patches_with(smooth, spikes, &self.measures.patches)
    }

    fn patches_with(
        &self,
        smooth: &[f64],
        spikes: &[Line],
        patches: &PatchSet,
    ) -> Option<(f64, f64)> {
        let exact = self.patches.as_ref().filter(|p| !p.is_empty())?;
        let found = difference(exact, &self.labs_of(patches, smooth, spikes));
        Some((found.mean, found.max))
    }

    /// Labs of any patches under a model, against this light as the white.
    pub(crate) fn labs_of(&self, patches: &PatchSet, smooth: &[f64], spikes: &[Line]) -> Vec<Lab> {
        self.labs(&seen_through(patches, smooth, spikes))
    }

    /// Labs of X, Y, Z against this light as the white.
    fn labs(&self, xyz: &[[f64; 3]]) -> Vec<Lab> {
        let mut labs = vec![BLACK; xyz.len()];
        labs_into(xyz, self.white, &mut labs);
        labs
    }

    fn filters(&self, smooth: &[f64], spikes: &[Line]) -> Option<f64> {
        let exact = self.filters.as_ref()?;
        self.behind(exact, &self.measures.filters, smooth, spikes)
    }

    /// The light itself behind any narrow filters.
    pub(crate) fn exact_behind(&self, filters: &PatchSet) -> Behind {
        let mut exact = seen_through(filters, &self.measured, &[]);
        let gain =
            |xyz: &[f64; 3]| (FILTER_Y * self.white.y / (100.0 * xyz[1].max(0.0))).min(MOST_GAIN);
        let gains: Vec<f64> = exact.iter().map(gain).collect();
        Behind {
            labs: self.filtered(&mut exact, &gains),
            gains,
        }
    }

    /// Mean CIEDE2000 of a model behind narrow filters; `None` without one, or where the light has
    /// no colour.
    pub fn behind(
        &self,
        exact: &Behind,
        filters: &PatchSet,
        smooth: &[f64],
        spikes: &[Line],
    ) -> Option<f64> {
        if exact.labs.is_empty() || self.own.is_none() {
            return None;
        }
        let mut xyz = seen_through(filters, smooth, spikes);
        Some(difference(&exact.labs, &self.filtered(&mut xyz, &exact.gains)).mean)
    }

    fn filtered(&self, xyz: &mut [[f64; 3]], gains: &[f64]) -> Vec<Lab> {
        for (xyz, gain) in xyz.iter_mut().zip(gains) {
            xyz.iter_mut().for_each(|v| *v *= gain);
        }
        self.labs(xyz)
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
        let Behind { labs, gains } = reference.filters.as_ref().expect("a light");
        assert_eq!(labs.len(), filter_centres().count());
        let fifty = lab_from_xyz(reference.white * 0.5, reference.white).l;
        for ((lab, gain), at_nm) in labs.iter().zip(gains).zip(filter_centres()) {
            let reached = (lab.l - fifty).abs() < 1e-9;
            assert_eq!(reached, *gain < MOST_GAIN, "{at_nm} nm");
            assert!(lab.l <= fifty + 1e-9);
        }
        // Green is bright enough, the far red is not.
        assert!(gains[13] < 10.0 && gains[25] == MOST_GAIN);
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
        assert_eq!(reference.patches(&model, &[]), None);
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
