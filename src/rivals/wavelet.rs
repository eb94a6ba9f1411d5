//! Wavelet: the largest coefficients of a CDF 9/7 transform, each kept as its place and value.
//!
//! The transform is the lifting of JPEG 2000 Part 1 (ISO/IEC 15444-1 annex F) with symmetric
//! extension, for any length, down to a single average. The nine- and seven-tap functions are
//! nearly but not quite orthogonal, so coefficients are compared after weighting each with the
//! exact L2 norm of its synthesis function on the band.

use std::sync::{Arc, OnceLock};

use super::Representation;
use crate::spectrum::Band;

/// The four lifting steps (odd, even, odd, even places) of ISO/IEC 15444-1 table F.4.
const STEPS: [f64; 4] = [
    -1.586_134_342_059_924,
    -0.052_980_118_572_961,
    0.882_911_075_530_934,
    0.443_506_852_043_971,
];

/// The same table's K: what the lifting steps make of a constant 1. Averages are divided by it,
/// so that a constant stays itself at every level; details are left as they come, for their
/// scale is in the norms.
const GAIN: f64 = 1.230_174_104_914_001;

/// Lengths of the averages, the band's own first, down to 1.
fn lengths(points: usize) -> impl Iterator<Item = usize> {
    std::iter::successors(Some(points), |n| (*n > 1).then(|| n.div_ceil(2)))
}

/// Transforms in place: averages first, then details from the coarsest to the finest.
fn analyse(values: &mut [f64]) {
    for n in lengths(values.len()).filter(|n| *n > 1) {
        let level = &mut values[..n];
        for (i, step) in STEPS.iter().enumerate() {
            lift(level, 1 - i % 2, *step);
        }
        let averages = level.iter().step_by(2).map(|v| v / GAIN);
        let sorted: Vec<f64> = averages
            .chain(level.iter().skip(1).step_by(2).copied())
            .collect();
        level.copy_from_slice(&sorted);
    }
}

/// Undoes [`analyse`].
fn synthesise(coefficients: &mut [f64]) {
    let levels: Vec<usize> = lengths(coefficients.len()).filter(|n| *n > 1).collect();
    for n in levels.into_iter().rev() {
        let level = &mut coefficients[..n];
        let sorted = level.to_vec();
        let (averages, details) = sorted.split_at(n.div_ceil(2));
        for (v, average) in level.iter_mut().step_by(2).zip(averages) {
            *v = average * GAIN;
        }
        for (v, detail) in level.iter_mut().skip(1).step_by(2).zip(details) {
            *v = *detail;
        }
        for (i, step) in STEPS.iter().enumerate().rev() {
            lift(level, 1 - i % 2, -step);
        }
    }
}

/// Adds `step` times both neighbours to every second value; an end mirrors its one neighbour.
fn lift(values: &mut [f64], first: usize, step: f64) {
    let last = values.len() - 1;
    for i in (first..=last).step_by(2) {
        let left = if i == 0 { 1 } else { i - 1 };
        let right = if i == last { last - 1 } else { i + 1 };
        values[i] += step * (values[left] + values[right]);
    }
}

/// The norms of a band's synthesis functions, worked out when first asked for.
#[derive(Debug)]
pub(super) struct WaveletTable {
    band: Band,
    norms: OnceLock<Vec<f64>>,
}

impl WaveletTable {
    pub(super) fn new(band: Band) -> Self {
        Self {
            band,
            norms: OnceLock::new(),
        }
    }

    /// Root of the integral of the square of each place's synthesis function, nm^1/2.
    fn norms(&self) -> &[f64] {
        self.norms.get_or_init(|| {
            let points = self.band.points();
            let mut function = vec![0.0; points];
            (0..points)
                .map(|place| {
                    function.fill(0.0);
                    function[place] = 1.0;
                    synthesise(&mut function);
                    self.band.inner(&function, &function).sqrt()
                })
                .collect()
        })
    }
}

/// One coefficient that was kept.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Kept {
    /// Its place in the transform, averages first; a band never has more than 20 001.
    pub place: u16,
    /// Its value, in the spectrum's own unit.
    pub value: f64,
}

/// The largest coefficients of a spectrum.
#[derive(Clone, Debug)]
pub(crate) struct Wavelet {
    table: Arc<WaveletTable>,
    /// The largest first, so that fewer are a prefix of more.
    kept: Vec<Kept>,
}

impl Wavelet {
    /// Keeps half as many coefficients as there may be numbers, at least one: a place and a value
    /// each. An odd number is left unused.
    pub(super) fn fit(table: &Arc<WaveletTable>, values: &[f64], numbers: usize) -> Self {
        let mut coefficients = values.to_vec();
        analyse(&mut coefficients);
        let pairs = coefficients.iter().zip(table.norms());
        let sizes: Vec<f64> = pairs.map(|(c, norm)| norm * c.abs()).collect();
        let mut order: Vec<u16> = (0..table.band.points() as u16).collect();
        // A stable sort: equal coefficients keep the order of their places.
        order.sort_by(|a, b| sizes[usize::from(*b)].total_cmp(&sizes[usize::from(*a)]));
        order.truncate((numbers / 2).max(1));
        let kept = order.into_iter().map(|place| Kept {
            place,
            value: coefficients[usize::from(place)],
        });
        Self {
            table: Arc::clone(table),
            kept: kept.collect(),
        }
    }

    /// The coefficients kept, the largest first.
    #[cfg(test)]
    pub(crate) fn kept(&self) -> &[Kept] {
        &self.kept
    }
}

impl Representation for Wavelet {
    fn band(&self) -> Band {
        self.table.band
    }

    fn stored(&self) -> Vec<f64> {
        let pairs = self.kept.iter().map(|k| [f64::from(k.place), k.value]);
        pairs.flatten().collect()
    }

    fn scale(&mut self, factor: f64) {
        self.kept.iter_mut().for_each(|k| k.value *= factor);
    }

    fn bytes(&self) -> usize {
        self.kept.len() * (size_of::<u16>() + size_of::<f64>())
    }

    /// Straight lines between the reconstructed grid points; one value costs the whole synthesis.
    fn inside(&self, at_nm: f64) -> f64 {
        self.table.band.interpolate(&self.on_band(), at_nm)
    }

    fn on_band(&self) -> Vec<f64> {
        let mut values = vec![0.0; self.table.band.points()];
        for kept in &self.kept {
            values[usize::from(kept.place)] = kept.value;
        }
        synthesise(&mut values);
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rivals::example_spectra::{fluorescent, thermal};

    fn table(band: Band) -> Arc<WaveletTable> {
        Arc::new(WaveletTable::new(band))
    }

    fn root_mean_square(band: Band, values: &[f64], numbers: usize) -> f64 {
        let read = Wavelet::fit(&table(band), values, numbers).on_band();
        let difference: Vec<f64> = read.iter().zip(values).map(|(a, b)| a - b).collect();
        (band.inner(&difference, &difference) / band.length_nm()).sqrt()
    }

    #[test]
    fn all_coefficients_give_the_spectrum_itself_at_any_length() {
        for last_nm in [400, 401, 402, 403, 411, 443, 444, 780] {
            let band = Band::new(380.0, f64::from(last_nm)).unwrap();
            let values = fluorescent(band);
            let read = Wavelet::fit(&table(band), &values, 2 * band.points()).on_band();
            for (a, b) in read.iter().zip(&values) {
                // Four lifting steps on each of up to nine levels, on values up to 6.
                assert!((a - b).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_constant_is_one_coefficient_its_own_value() {
        let wavelet = Wavelet::fit(&table(Band::VISIBLE), &[0.7; 401], 2);
        assert_eq!(wavelet.kept()[0].place, 0);
        // The standard prints its constants to 15 digits; nine levels of them.
        assert!((wavelet.kept()[0].value - 0.7).abs() < 1e-13);
        assert!(wavelet.on_band().iter().all(|v| (v - 0.7).abs() < 1e-13));
    }

    #[test]
    fn a_cubic_has_no_detail_away_from_the_ends() {
        // Four vanishing moments: what the 9/7 filters are made for.
        let mut values: Vec<f64> = (0..401).map(|i| (f64::from(i) / 400.0).powi(3)).collect();
        analyse(&mut values);
        let finest = &values[201..];
        // The constants' 15 digits.
        assert!(finest[4..196].iter().all(|d| d.abs() < 1e-13));
    }

    #[test]
    fn coefficients_are_kept_by_what_they_do_to_the_spectrum() {
        // Leaving out one coefficient errs by its value times its norm: so the first of two kept
        // matters most, whatever its place.
        let band = Band::VISIBLE;
        let table = table(band);
        let wavelet = Wavelet::fit(&table, &fluorescent(band), 40);
        let sizes: Vec<f64> = wavelet
            .kept()
            .iter()
            .map(|k| table.norms()[usize::from(k.place)] * k.value.abs())
            .collect();
        assert!(sizes.windows(2).all(|pair| pair[0] >= pair[1]));
    }

    #[test]
    fn norms_are_near_the_root_of_what_a_coefficient_covers() {
        // With averages that keep a constant, a function of level k covers 2^k nm; exact norms
        // stray from its root by the filters not being orthogonal, by the ends, and for details
        // by their unscaled lifting.
        let table = table(Band::VISIBLE);
        let level_of_four = 401_usize.div_ceil(4)..401_usize.div_ceil(2);
        for place in level_of_four {
            let norm = table.norms()[place];
            assert!((0.7..3.0).contains(&norm), "{place} {norm}");
        }
    }

    #[test]
    fn more_coefficients_come_closer() {
        let values = fluorescent(Band::VISIBLE);
        let errors = [10, 20, 40, 80, 160].map(|p| root_mean_square(Band::VISIBLE, &values, p));
        assert!(
            errors.windows(2).all(|pair| pair[1] < 0.8 * pair[0]),
            "{errors:?}"
        );
    }

    #[test]
    fn a_smooth_light_needs_few() {
        let values = thermal(Band::VISIBLE, 5000.0);
        // Ten coefficients: a thousandth of its mean, which is near 1.
        assert!(root_mean_square(Band::VISIBLE, &values, 20) < 2e-3);
    }
}
