//! Errors of a stored picture, measured after decoding over every measured pixel.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Mutex;

use crate::color::{Xyz, delta_e_2000, lab_from_xyz};
use crate::spectrum::{dot, rank};
use crate::study::Progress;

use super::kernel::Kernel;
use super::light::{Rows, times};
use super::relight::Between;
use super::strips::{Strip, over_strips};
use super::survey::percentile;
use super::{Illuminant, Operator, PictureError, Pixels, Plan, ReferenceKind, Relit, STRIP_ROWS};

/// Mean, 95th percentile and largest of a colour difference.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// 95th percentile, linear between ranks.
    pub p95: f64,
    /// Largest.
    pub max: f64,
}

/// Errors of a stored picture.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Errors {
    /// Own colour.
    pub own: Spread,
    /// Under other lights, by name; empty where the picture cannot be relit.
    pub lights: BTreeMap<String, Spread>,
    /// Root of the squared difference over all pixels and bands, relative to the picture.
    pub relative_rms: f64,
    /// Decoded numbers below zero.
    pub negative: u64,
    /// Pixels that were not measured.
    pub no_data: u64,
}

/// Storage of numbers, with its effect on them on the way into a file and back.
pub trait Storage: Sync {
    /// Numbers `[number * pixels + i]` as they will be read back.
    fn kept(&self, numbers: &mut [f32], pixels: usize);
}

/// Single precision.
pub(crate) struct Exactly;

impl Storage for Exactly {
    fn kept(&self, _: &mut [f32], _: usize) {}
}

/// Most lower octaves than 1 that a difference is counted in; below, it counts as none.
const FIRST_BIN: u32 = (127 - 24) << 11;
/// Up to differences of 1024.
const BINS: usize = 34 << 11;

/// Differences counted in bins a 2000th of their size apart, so that a percentile of any number of
/// pixels needs no memory; the mean and the largest are exact.
#[derive(Clone, Debug)]
pub struct Tally {
    bins: Vec<u32>,
    count: u64,
    sum: f64,
    max: f64,
}

impl Default for Tally {
    fn default() -> Self {
        Self {
            bins: vec![0; BINS],
            count: 0,
            sum: 0.0,
            max: 0.0,
        }
    }
}

impl Tally {
    /// One more difference.
    pub fn add(&mut self, difference: f64) {
        let bits = (difference as f32).to_bits() >> 12;
        let bin = (bits.saturating_sub(FIRST_BIN) as usize).min(BINS - 1);
        self.bins[bin] += 1;
        self.count += 1;
        self.sum += difference;
        self.max = self.max.max(difference);
    }

    /// Those of another tally too.
    pub(crate) fn merge(&mut self, other: &Self) {
        self.add_bins(&other.bins);
        self.count += other.count;
        self.sum += other.sum;
        self.max = self.max.max(other.max);
    }

    fn add_bins(&mut self, bins: &[u32]) {
        let pairs = self.bins.iter_mut().zip(bins);
        pairs.for_each(|(all, part)| *all += part);
    }

    /// Spread of the counted differences.
    pub fn spread(&self) -> Spread {
        if self.count == 0 {
            return Spread::default();
        }
        let (below, t) = rank(self.count as usize, 0.95);
        let low = self.ranked(below as u64);
        let high = self.ranked((below as u64 + 1).min(self.count - 1));
        Spread {
            mean: self.sum / self.count as f64,
            p95: low + t * (high - low),
            max: self.max,
        }
    }

    /// The difference of a rank, to the middle of its bin.
    fn ranked(&self, rank: u64) -> f64 {
        let mut seen = 0;
        for (bin, count) in self.bins.iter().enumerate() {
            seen += u64::from(*count);
            if seen > rank {
                if bin == 0 {
                    return 0.0;
                }
                let bits = ((bin as u32 + FIRST_BIN) << 12) | (1 << 11);
                return f64::from(f32::from_bits(bits)).min(self.max);
            }
        }
        self.max
    }
}

/// Orders of the regularised division that stands for the truth of a lit picture.
const FINEST: usize = 40;

/// A light that a picture is judged under: exact weights of the bands, weights of the numbers.
#[derive(Clone, Debug)]
pub(crate) struct Judge {
    /// Its name.
    pub name: String,
    exact: Rows,
    numbers: Rows,
    white: Xyz,
}

impl Judge {
    /// Weights of the bands for the exact colour and for that of the decoded numbers, and white.
    pub(super) fn ends(&self, operator: &Operator) -> (&Rows, Rows, Xyz) {
        let found = times(&self.numbers, &operator.encode);
        (&self.exact, found, self.white)
    }

    /// The own colour first, then the six lights where the picture can be relit. `white_y` is the
    /// Y of a picture of an unknown lamp that counts as white (its 99th percentile).
    ///
    /// # Errors
    /// [`PictureError`] where a light does not shine on the bands.
    pub(crate) fn all(
        operator: &Operator,
        white_y: f64,
        known: Option<&Illuminant>,
    ) -> Result<Vec<Self>, PictureError> {
        let own = operator.own_colour();
        let plan = operator.plan();
        let factor = operator.bands().is_factor();
        let lit = plan.reference.kind == ReferenceKind::Light;
        let is_unknown = !factor && !lit && white_y > 0.0;
        let scale = if is_unknown { white_y } else { 1.0 };
        let mut judges = vec![Self {
            name: own.light.clone(),
            exact: operator.own_weights().clone(),
            numbers: own.rows,
            white: own.white * scale,
        }];
        let known = known.filter(|_| !factor && !lit);
        let finest = match known {
            _ if factor => None,
            _ if lit => Some(finest(operator)?),
            Some(light) => {
                let series = (operator.bands().len() - 1).min(FINEST);
                let plan = Plan::lit(operator.bands(), series, light, plan.noise)?;
                Some(Operator::new(operator.bands(), &plan)?)
            }
            None => return Ok(judges),
        };
        for light in Illuminant::judges() {
            let Ok(relit) = operator.relit(light, known, Between::Bands) else {
                continue;
            };
            let exact = match &finest {
                Some(finest) => {
                    let of_numbers = finest.relit(light, None, Between::Bands)?;
                    finest.of_bands(&of_numbers)
                }
                None => light.weights(operator.bands(), plan.observer)?,
            };
            judges.push(Self {
                name: relit.light,
                exact,
                numbers: relit.rows,
                white: relit.white,
            });
        }
        Ok(judges)
    }
}

/// The operator of most numbers that the same division allows: what a lit picture's bands say
/// about its surfaces.
fn finest(operator: &Operator) -> Result<Operator, PictureError> {
    let plan = operator.plan();
    let plan = Plan {
        series: (operator.bands().len() - 1).min(FINEST) - plan.lines.len().min(2),
        lines: Vec::new(),
        ..plan.clone()
    };
    Operator::new(operator.bands(), &plan)
}

impl Operator {
    /// Weights of the bands for something that is a weighted sum of the numbers.
    pub(crate) fn of_bands(&self, relit: &Relit) -> Rows {
        times(&relit.rows, &self.encode)
    }
}

/// The machinery of a measurement: exact and decoded colours, decoded bands.
pub(crate) struct Meter {
    judges: Vec<Judge>,
    exact: Kernel,
    numbers: Kernel,
    decode: Kernel,
    encode: Kernel,
    weights_nm: Vec<f64>,
}

/// Error counts over some rows.
#[derive(Clone, Debug, Default)]
pub(crate) struct Counted {
    tallies: Vec<Tally>,
    off: f64,
    all: f64,
    negative: u64,
    no_data: u64,
}

impl Counted {
    /// Nothing yet, for so many judges.
    fn none(judges: usize) -> Self {
        Self {
            tallies: vec![Tally::default(); judges],
            ..Self::default()
        }
    }

    fn merge(&mut self, other: &Self) {
        let tallies = self.tallies.iter_mut().zip(&other.tallies);
        tallies.for_each(|(all, part)| all.merge(part));
        self.off += other.off;
        self.all += other.all;
        self.negative += other.negative;
        self.no_data += other.no_data;
    }
}

impl Meter {
    /// A meter for an operator.
    pub(crate) fn new(operator: &Operator, judges: Vec<Judge>) -> Self {
        let kernel = |rows: fn(&Judge) -> &Rows| {
            let rows = judges.iter().flat_map(|judge| rows(judge).iter());
            Kernel::of_rows(&rows.map(Vec::as_slice).collect::<Vec<_>>())
        };
        Self {
            exact: kernel(|judge| &judge.exact),
            numbers: kernel(|judge| &judge.numbers),
            decode: operator.decoder(),
            encode: operator.encoder(),
            weights_nm: operator.bands().weights_nm().to_vec(),
            judges,
        }
    }

    /// Counts the errors of some rows after storage.
    pub(crate) fn count(&self, strip: &Strip, storage: &dyn Storage) -> Counted {
        let pixels = strip.pixels;
        let mut numbers = vec![0.0; self.encode.rows() * pixels];
        self.encode.apply(strip.values, pixels, &mut numbers);
        storage.kept(&mut numbers, pixels);
        self.compare(strip.values, &numbers, pixels)
    }

    /// Counts the errors of the numbers of some pixels.
    pub(crate) fn compare(&self, values: &[f32], numbers: &[f32], pixels: usize) -> Counted {
        let rows = 3 * self.judges.len();
        let [mut exact, mut found] = [0; 2].map(|_| vec![0.0; rows * pixels]);
        self.exact.apply(values, pixels, &mut exact);
        self.numbers.apply(numbers, pixels, &mut found);
        let mut counted = Counted::none(self.judges.len());
        let good: Vec<bool> = (0..pixels)
            .map(|i| numbers[i].is_finite() && exact[i].is_finite())
            .collect();
        counted.no_data = good.iter().filter(|good| !**good).count() as u64;
        for (k, (judge, tally)) in self.judges.iter().zip(&mut counted.tallies).enumerate() {
            let xyz = |from: &[f32], i: usize| {
                Xyz::from_array(std::array::from_fn(|c| {
                    f64::from(from[(3 * k + c) * pixels + i])
                }))
            };
            for i in (0..pixels).filter(|i| good[*i]) {
                let (a, b) = (xyz(&exact, i), xyz(&found, i));
                let difference =
                    delta_e_2000(lab_from_xyz(a, judge.white), lab_from_xyz(b, judge.white));
                tally.add(if difference.is_finite() {
                    difference
                } else {
                    1e3
                });
            }
        }
        let mut back = vec![0.0; self.decode.rows() * pixels];
        self.decode.apply(numbers, pixels, &mut back);
        for (j, weight) in self.weights_nm.iter().enumerate() {
            let (one, two) = (
                &values[j * pixels..][..pixels],
                &back[j * pixels..][..pixels],
            );
            let (mut off, mut all) = (0.0, 0.0);
            for i in (0..pixels).filter(|i| good[*i]) {
                off += f64::from(two[i] - one[i]).powi(2);
                all += f64::from(one[i]).powi(2);
                counted.negative += u64::from(two[i] < 0.0);
            }
            counted.off += weight * off;
            counted.all += weight * all;
        }
        counted
    }

    /// The errors of all that was counted.
    pub(crate) fn errors(&self, parts: &[Counted]) -> Errors {
        let mut all = Counted::none(self.judges.len());
        parts.iter().for_each(|part| all.merge(part));
        let share = all.off / all.all;
        let mut spreads = all.tallies.iter().map(Tally::spread);
        let own = spreads.next().unwrap_or_default();
        let names = self.judges.iter().skip(1).map(|judge| judge.name.clone());
        Errors {
            own,
            lights: names.zip(spreads).collect(),
            relative_rms: if all.all > 0.0 { share.sqrt() } else { 0.0 },
            negative: all.negative,
            no_data: all.no_data,
        }
    }
}

/// Measures the errors of a picture kept in some storage, over every measured pixel.
///
/// # Errors
/// Those of the source, and [`PictureError::Cancelled`].
pub fn measure(
    pixels: &dyn Pixels,
    operator: &Operator,
    storage: &dyn Storage,
    white_y: f64,
    progress: &Progress,
) -> Result<Errors, PictureError> {
    let meter = Meter::new(operator, Judge::all(operator, white_y, None)?);
    let rows = STRIP_ROWS.min(8);
    progress.expect(pixels.size().1.div_ceil(rows));
    // Bins are whole numbers and may be summed in any order as they come, so that a large picture
    // keeps one set of them; sums of floating point wait for the order of the strips.
    let bins = Mutex::new(Counted::none(meter.judges.len()));
    let mut parts = over_strips(pixels, rows, progress, |strip| {
        let mut counted = meter.count(strip, storage);
        let mut all = bins.lock().unwrap_or_else(|broken| broken.into_inner());
        for (all, part) in all.tallies.iter_mut().zip(&mut counted.tallies) {
            all.add_bins(&std::mem::take(&mut part.bins));
        }
        Ok(counted)
    })?;
    parts.push(
        bins.into_inner()
            .unwrap_or_else(|broken| broken.into_inner()),
    );
    Ok(meter.errors(&parts))
}

/// The Y (of what is equal everywhere on the bands) that counts as white in a picture of an
/// unknown lamp: the 99th percentile of a sample.
pub(crate) fn white_y_of(operator: &Operator, sample: &[Vec<f64>]) -> f64 {
    if operator.bands().is_factor() || operator.plan().reference.kind == ReferenceKind::Light {
        return 1.0;
    }
    let row = &operator.own_weights()[1];
    let y = sample.iter().map(|pixel| dot(pixel, row));
    let mut y: Vec<f64> = y.filter(|y| y.is_finite()).collect();
    let white = percentile(&mut y, 0.99);
    if white > 0.0 { white } else { 1.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tally_is_the_percentile_of_its_numbers() {
        let mut tally = Tally::default();
        let mut values: Vec<f64> = (0..1001)
            .map(|i| (f64::from(i) * 0.37).sin().powi(2) * 3.0)
            .collect();
        values.iter().for_each(|v| tally.add(*v));
        values.sort_by(f64::total_cmp);
        let spread = tally.spread();
        // Bins are 1/2048 of their octave's start wide, and the middle is taken.
        assert!((spread.p95 / values[950] - 1.0).abs() < 3e-4);
        assert_eq!(spread.max, values[1000]);
        assert!((spread.mean - values.iter().sum::<f64>() / 1001.0).abs() < 1e-12);
        assert_eq!(Tally::default().spread(), Spread::default());
    }

    #[test]
    fn tallies_of_parts_are_the_tally_of_the_whole() {
        let [mut one, mut two, mut all] = [0; 3].map(|_| Tally::default());
        for i in 0..100 {
            let part = if i % 3 == 0 { &mut one } else { &mut two };
            part.add(f64::from(i) * 0.01);
            all.add(f64::from(i) * 0.01);
        }
        one.merge(&two);
        assert_eq!((one.bins, one.max), (all.bins, all.max));
    }
}
