//! The wavelengths of a picture: how a spectrum goes on between them, and which are kept.

use crate::spectrum::{Kind, Line, Outside, Sampled};
use crate::{
    color::xyz::{FIRST_NM, LAST_NM},
    languages::with_sign,
};

use super::PictureError;

/// Bands closer than this are averaged, nm.
pub(super) const CLOSE_NM: f64 = 0.5;

/// Bands missing in more than this share of the pixels are dropped.
const MOST_MISSING: f64 = 0.5;

/// When more than this share of the bands' length lies outside 360-830 nm, only what is seen is
/// kept unless all bands are asked for.
const MOST_UNSEEN: f64 = 0.2;

/// The bands of a picture: strictly rising wavelengths (nm) and what the spectra stand for.
#[derive(Clone, Debug, PartialEq)]
pub struct Bands {
    nm: Vec<f64>,
    weights_nm: Vec<f64>,
    kind: Kind,
    bandwidth_nm: Option<f64>,
}

impl Bands {
    /// Bands from wavelengths in nm.
    ///
    /// # Errors
    /// [`PictureError`] when there are fewer than three or they do not rise.
    pub fn new(nm: Vec<f64>, kind: Kind) -> Result<Self, PictureError> {
        if nm.len() < 3 {
            return Err(PictureError::TooFewBands { found: nm.len() });
        }
        for (index, at) in nm.iter().enumerate() {
            let rises = index == 0 || *at > nm[index - 1];
            if !(at.is_finite() && *at > 0.0 && *at < 1e9 && rises) {
                return Err(PictureError::NotRising { index });
            }
        }
        let last = nm.len() - 1;
        let weights_nm = (0..nm.len())
            .map(|j| 0.5 * (nm[(j + 1).min(last)] - nm[j.saturating_sub(1)]))
            .collect();
        Ok(Self {
            nm,
            weights_nm,
            kind,
            bandwidth_nm: None,
        })
    }

    /// The same, of an instrument whose bands are as wide as this at half of their height, nm.
    #[must_use]
    pub(crate) fn with_bandwidth(mut self, nm: Option<f64>) -> Self {
        self.bandwidth_nm = nm.filter(|nm| nm.is_finite() && *nm > 0.0);
        self
    }

    /// Width of a band at half of its height, nm, where the file has one.
    pub(crate) fn bandwidth_nm(&self) -> Option<f64> {
        self.bandwidth_nm
    }

    /// Wavelengths, nm.
    pub fn nm(&self) -> &[f64] {
        &self.nm
    }

    /// Number of bands, at least three.
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.nm.len()
    }

    /// Quantity that the spectra represent.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// True if the pixels multiply a light.
    pub fn is_factor(&self) -> bool {
        self.kind.is_factor()
    }

    /// Trapezoid weight of each band, nm.
    pub fn weights_nm(&self) -> &[f64] {
        &self.weights_nm
    }

    /// From the first band to the last, nm.
    pub(crate) fn length_nm(&self) -> f64 {
        self.nm[self.nm.len() - 1] - self.nm[0]
    }

    /// The median distance between neighbours, nm.
    pub(crate) fn median_spacing_nm(&self) -> f64 {
        let mut steps: Vec<f64> = self.nm.windows(2).map(|w| w[1] - w[0]).collect();
        let middle = steps.len() / 2;
        *steps.select_nth_unstable_by(middle, f64::total_cmp).1
    }

    /// The two bands about a wavelength and the share of the right one; `None` where the spectrum
    /// is zero. A reflectance goes on with its end values.
    fn about(&self, at_nm: f64) -> Option<(usize, f64)> {
        let last = self.nm.len() - 1;
        let hold = self.is_factor();
        if at_nm < self.nm[0] {
            return hold.then_some((0, 0.0));
        }
        if at_nm > self.nm[last] {
            return hold.then_some((last - 1, 1.0));
        }
        let right = self.nm.partition_point(|w| *w < at_nm).clamp(1, last);
        let (a, b) = (self.nm[right - 1], self.nm[right]);
        Some((right - 1, (at_nm - a) / (b - a)))
    }

    /// Band weights for the sum of a spectrum, linear between bands, with weights for X, Y and Z at
    /// some places (nm).
    pub(super) fn fold(&self, places: &[(f64, [f64; 3])]) -> [Vec<f64>; 3] {
        let mut out = [0; 3].map(|_| vec![0.0; self.nm.len()]);
        for (nm, weights) in places {
            if let Some((left, t)) = self.about(*nm) {
                for (row, weight) in out.iter_mut().zip(weights) {
                    row[left] += weight * (1.0 - t);
                    row[left + 1] += weight * t;
                }
            }
        }
        out
    }

    /// A table as it falls on the bands: its mean under each band's hat (down to zero at both
    /// neighbours, half a hat at the ends), spikes by the share that the hat gives them.
    ///
    /// Each side of a hat is summed in even steps of at most one nm, onto which the table's area
    /// is shared out ([`Sampled::on_grid`]): a line finer than that keeps its power.
    pub(crate) fn under_hats(&self, table: &Sampled, spikes: &[Line]) -> Vec<f64> {
        let count = self.nm.len();
        let (mut sums, mut areas) = (vec![0.0; count], vec![0.0; count]);
        for (left, ends) in self.nm.windows(2).enumerate() {
            let width = ends[1] - ends[0];
            let steps = (width.ceil() as usize).clamp(1, 1000);
            let step = width / steps as f64;
            let values = table.on_grid(ends[0], step, steps + 1, Outside::Zero);
            for (band, value_at) in [(left, 0), (left + 1, steps)] {
                // The hat's top is its value there; of the two sides' it is the mean.
                let inner = band > 0 && band + 1 < count;
                let top = if inner { 0.5 * step } else { step };
                sums[band] += top * values[value_at];
                areas[band] += top;
            }
            for (k, value) in values.iter().enumerate().take(steps).skip(1) {
                let rising = k as f64 / steps as f64;
                for (band, share) in [(left, 1.0 - rising), (left + 1, rising)] {
                    sums[band] += step * share * value;
                    areas[band] += step * share;
                }
            }
            let last = left + 2 == count;
            for Line { at_nm, weight, .. } in spikes {
                let inside = *at_nm >= ends[0] && (*at_nm < ends[1] || last && *at_nm == ends[1]);
                if inside {
                    let rising = (at_nm - ends[0]) / width;
                    sums[left] += weight * (1.0 - rising);
                    sums[left + 1] += weight * rising;
                }
            }
        }
        sums.iter()
            .zip(&areas)
            .map(|(sum, area)| sum / area)
            .collect()
    }

    /// A curve on the bands: read off between two bands where it has no samples of its own, else
    /// its area shared out to them ([`Sampled::on_grid`]), so that peaks finer than the bands
    /// neither vanish between them nor are counted several times.
    pub(crate) fn by_area(&self, table: &Sampled, outside: Outside) -> Vec<f64> {
        let count = self.nm.len();
        let (mut sums, mut widths) = (vec![0.0; count], vec![0.0; count]);
        for (left, ends) in self.nm.windows(2).enumerate() {
            let width = ends[1] - ends[0];
            let values = table.on_grid(ends[0], width, 2, outside);
            for (band, value) in (left..).zip(values) {
                sums[band] += width * value;
                widths[band] += width;
            }
        }
        sums.iter()
            .zip(&widths)
            .map(|(sum, width)| sum / width)
            .collect()
    }
}

/// Bands of a file that make up those of a picture, and notes on those left out.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct KeptBands {
    /// Wavelength of each kept band, nm: the mean of those that are averaged.
    pub nm: Vec<f64>,
    /// The file's bands that each kept one is the mean of.
    pub of: Vec<Vec<usize>>,
    /// Notes on merged or dropped bands, one sentence each.
    pub notes: Vec<String>,
}

impl KeptBands {
    /// The kept bands.
    ///
    /// # Errors
    /// [`PictureError::NothingMeasured`] where none is left, and those of [`Bands::new`].
    pub(crate) fn bands(&self, kind: Kind) -> Result<Bands, PictureError> {
        if self.nm.is_empty() {
            return Err(PictureError::NothingMeasured);
        }
        Bands::new(self.nm.clone(), kind)
    }

    /// Decides about a file's bands (nm, rising). `missing` is each band's share of pixels without
    /// a value (1 for one flagged bad); `all` keeps what nobody sees.
    pub(crate) fn of_file(nm: &[f64], missing: &[f64], all: bool) -> Self {
        let mut notes = Vec::new();
        let is_missing = |band: &usize| missing.get(*band).is_some_and(|m| *m > MOST_MISSING);
        let (gone, mut kept): (Vec<usize>, Vec<usize>) = (0..nm.len()).partition(is_missing);
        if !gone.is_empty() {
            notes.push(tr!(
                "{out} of {all} bands left out: bad, or missing in more than half of the pixels",
                out = gone.len(),
                all = nm.len()
            ));
        }
        let (low, high) = (f64::from(FIRST_NM), f64::from(LAST_NM));
        if let (Some(first), Some(last), false) = (kept.first(), kept.last(), all) {
            let (first, last) = (nm[*first], nm[*last]);
            let unseen = (low - first).max(0.0) + (last - high).max(0.0);
            let seen = |band: &usize| (low..=high).contains(&nm[*band]);
            let count = kept.iter().filter(|band| seen(band)).count();
            if unseen > MOST_UNSEEN * (last - first) && count >= 3 {
                notes.push(tr!(
                    "only what is seen: {count} bands outside 360-830 nm left out",
                    count = kept.len() - count
                ));
                kept.retain(seen);
            }
        }
        let mut of: Vec<Vec<usize>> = Vec::new();
        for band in kept {
            match of.last_mut() {
                Some(group) if nm[band] - nm[group[0]] < CLOSE_NM => group.push(band),
                _ => of.push(vec![band]),
            }
        }
        let merged = of.iter().filter(|group| group.len() > 1).count();
        if merged > 0 {
            notes.push(tr!(
                "bands within {near} nm of one another averaged, {merged} times",
                near = with_sign(CLOSE_NM.to_string()),
                merged
            ));
        }
        let mean =
            |group: &Vec<usize>| group.iter().map(|b| nm[*b]).sum::<f64>() / group.len() as f64;
        Self {
            nm: of.iter().map(mean).collect(),
            of,
            notes,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bands(kind: Kind) -> Bands {
        Bands::new((0..81).map(|i| 380.0 + 5.0 * f64::from(i)).collect(), kind).unwrap()
    }

    #[test]
    fn folded_weights_of_one_are_the_nm_a_spectrum_covers() {
        let whole = (FIRST_NM..=LAST_NM).map(|nm| (f64::from(nm), [1.0; 3]));
        let mut places: Vec<_> = whole.collect();
        let sum = |kind: Kind, places: &[_]| bands(kind).fold(places)[2].iter().sum::<f64>();
        // A reflectance covers all 471 nm, a light the 401 from its first band to its last.
        assert!((sum(Kind::Reflectance, &places) - 471.0).abs() < 1e-10);
        places.extend([(546.1, [2.0; 3]), (900.0, [5.0; 3])]);
        assert!((sum(Kind::Light, &places) - 403.0).abs() < 1e-10);
    }

    #[test]
    fn a_straight_table_falls_on_even_bands_as_itself() {
        let table = Sampled::new(vec![300.0, 900.0], vec![300.0, 900.0]).unwrap();
        let bands = bands(Kind::Light);
        let found = bands.under_hats(&table, &[]);
        for (value, nm) in found.iter().zip(bands.nm()).take(80).skip(1) {
            // Symmetric sums about the band.
            assert!((value - nm).abs() < 1e-9);
        }
    }

    #[test]
    fn a_line_finer_than_the_bands_keeps_its_power_wherever_it_stands() {
        // A light in steps of .1 nm that is dark but for a triangle of .2 nm and power 3 (height
        // 30, half of .2 wide).
        let bands = bands(Kind::Light);
        for peak in [5320, 5324, 5325, 5350, 5371] {
            let nm: Vec<f64> = (3800..=7800).map(|i| f64::from(i) / 10.0).collect();
            let values = (3800..=7800).map(|i| if i == peak { 30.0 } else { 0.0 });
            let table = Sampled::new(nm, values.collect()).unwrap();
            let power = |values: &[f64]| -> f64 {
                let weights = values.iter().zip(bands.weights_nm());
                weights.map(|(v, q)| v * q).sum()
            };
            // Sums of 400 numbers up to 30.
            let found = power(&bands.under_hats(&table, &[]));
            assert!((found - 3.0).abs() < 1e-10, "{peak}: {found}");
            let found = power(&bands.by_area(&table, Outside::Zero));
            assert!((found - 3.0).abs() < 1e-10, "{peak}: {found}");
        }
    }

    #[test]
    fn a_table_no_finer_than_the_bands_is_read_off() {
        let table = Sampled::new(vec![300.0, 500.0, 900.0], vec![1.0, 3.0, 0.0]).unwrap();
        let bands = bands(Kind::Reflectance);
        let found = bands.by_area(&table, Outside::Hold);
        for (value, nm) in found.iter().zip(bands.nm()) {
            assert!((value - table.at(*nm, Outside::Hold)).abs() < 1e-13, "{nm}");
        }
    }

    #[test]
    fn a_spike_keeps_its_power_on_even_bands() {
        let dark = Sampled::new(vec![300.0, 900.0], vec![0.0, 0.0]).unwrap();
        let bands = bands(Kind::Light);
        let spike = Line::ideal(546.1, 3.0);
        let found = bands.under_hats(&dark, &[spike]);
        let power: f64 = found
            .iter()
            .zip(bands.weights_nm())
            .map(|(v, q)| v * q)
            .sum();
        // The hats of two neighbours add to one everywhere between them.
        assert!((power - 3.0).abs() < 1e-12, "{power}");
    }

    #[test]
    fn bands_that_do_not_rise_and_too_few_are_refused() {
        let refused = |nm: &[f64]| Bands::new(nm.to_vec(), Kind::Light).unwrap_err();
        assert_eq!(
            refused(&[400.0, 500.0]),
            PictureError::TooFewBands { found: 2 }
        );
        assert_eq!(
            refused(&[400.0, 500.0, 500.0]),
            PictureError::NotRising { index: 2 }
        );
        assert_eq!(
            refused(&[400.0, f64::NAN, 500.0]),
            PictureError::NotRising { index: 1 }
        );
    }

    #[test]
    fn close_bad_and_unseen_bands_are_left_out_and_said() {
        let nm: Vec<f64> = (0..220).map(|i| 400.0 + 10.0 * f64::from(i)).collect();
        let seen = KeptBands::of_file(&nm, &[], false);
        assert_eq!((seen.nm.len(), seen.notes.len()), (44, 1));
        assert_eq!(KeptBands::of_file(&nm, &[], true).nm.len(), 220);
        let close = KeptBands::of_file(&[400.0, 400.4, 410.0, 420.0], &[0.0, 0.0, 0.6, 0.5], false);
        assert_eq!(close.nm, [400.2, 420.0]);
        assert_eq!(close.notes.len(), 2);
    }
}
