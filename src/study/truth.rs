//! The paper's claims, measured again on the spectrum and range at hand.
//!
//! Source: Sun, Fracchia, Drew, "A Composite Spectral Model and Its Applications". Each claim has
//! the paper's own figure as a [`Stated`] and a function that measures the same thing here:
//!
//! ```text
//! five_percent   terms beyond N contribute under 5 %              Eq. 12
//! samples        400 samples against about 20 numbers             storage of spectral images
//! eq_17          the factor at a spike by a straight line         Eq. 17, its weights swapped
//! table_2        three colour-matching functions as four bells    Table 2, Eq. 9
//! resampling     a product takes 2N+2 multiplications             Eq. 16
//! ```
//!
//! Colour differences are CIEDE2000 against the white that the caller names (the exact light) and
//! `None` where there is no colour: no light in the visible part of the range.

use crate::{
    color::{
        ColourMatching, Observer, Xyz, delta_e_2000,
        gaussian_cmf::{self, Gaussian, NEGLIGIBLE_SHARE},
        lab_from_xyz, uv_1976_from_xyz,
    },
    spectrum::spikes::LineShape,
    spectrum::{
        Band, Basis, BasisTable, Composite, SampleGrid, Sampling, Series, Spike,
        basis::numbers_of_order,
        product::{folded_share, resampled},
    },
};

use super::{
    error::{Blur, height, spectrum_errors},
    harmonics::{Harmonics, Order},
};

/// A figure that the paper states, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stated {
    /// The figure, in the unit its constant names.
    pub figure: f64,
    /// Equation, table or section of the paper.
    pub place: &'static str,
}

/// Share of the first term below which a term is neglected, 0-1.
pub const STATED_SHARE: Stated = Stated {
    figure: NEGLIGIBLE_SHARE,
    place: "Eq. 12",
};

/// The order after which terms are negligible (11 numbers), for a range of 300 nm.
pub const STATED_ORDER: Stated = Stated {
    figure: 5.0,
    place: "Sufficiency of a Low-Dimensional Representation, after Eq. 12",
};

/// Samples from 380 to 780 nm "to avoid missing any spikes".
pub const STATED_SAMPLES: Stated = Stated {
    figure: 400.0,
    place: STORAGE,
};

/// Numbers that do the same: [`STATED_BACKGROUND`] and [`STATED_SPIKE_NUMBERS`].
pub const STATED_NUMBERS: Stated = Stated {
    figure: TOTAL_NUMBERS as f64,
    place: STORAGE,
};

/// Numbers for the smooth background.
pub const STATED_BACKGROUND: Stated = Stated {
    figure: (TOTAL_NUMBERS - 2 * MOST_SPIKES) as f64,
    place: STORAGE,
};

/// Numbers for the spikes, two each.
pub const STATED_SPIKE_NUMBERS: Stated = Stated {
    figure: (2 * MOST_SPIKES) as f64,
    place: STORAGE,
};

/// The green mercury line that Eq. 17 is tried on, in nm.
pub const STATED_LINE_NM: Stated = Stated {
    figure: 546.1,
    place: "Table 4",
};

const STORAGE: &str = "Storage and Communication of Spectral Images";
const TOTAL_NUMBERS: usize = 20;
const MOST_SPIKES: usize = 4;

/// Multiplications of a product of two smooth spectra of order N, as Eq. 16 counts them: one for
/// each of the 2N+2 points, of which the last equals the first.
pub fn stated_multiplications(order: usize) -> Stated {
    Stated {
        figure: (2 * order + 2) as f64,
        place: "Eq. 16",
    }
}

// ------------------------------------------------------------------------- terms beyond N

/// "Terms beyond N contribute under 5 %", for X, Y and Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FivePercent {
    /// The highest order looked at; every tail reaches beyond it, single terms do not.
    pub highest_order: usize,
    /// X, Y and Z.
    pub channels: [ChannelTerms; 3],
}

/// From where on the terms of one channel are negligible: below [`STATED_SHARE`] of its exact
/// total, spikes included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChannelTerms {
    /// The first order n >= 1 from which every single term is negligible. `None` when the highest
    /// order looked at is not, or the channel has no positive total.
    pub first_negligible: Option<usize>,
    /// The lowest N such that all that is neglected beyond N, and beyond every higher order, is
    /// negligible as a whole. `None` when no order looked at is enough.
    pub sufficient_order: Option<usize>,
    /// The first order n at which the corrected Eq. 12 falls below the share, for Fourier series
    /// on this range that meet Eq. 11; for X the later one of its two lobes.
    pub promised: usize,
    /// The same by Eq. 12 as printed.
    pub promised_as_printed: usize,
    /// What the paper's N = 5 leaves out; `None` when fewer orders were looked at or the channel
    /// has no positive total.
    pub at_stated_order: Option<Neglected>,
}

/// What is left out beyond an order, as shares of a channel's exact total.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Neglected {
    /// The first term left out, signed.
    pub next_term: f64,
    /// The largest single term left out, of those looked at; not negative.
    pub largest_term: f64,
    /// All terms left out together, signed: positive when the model shows too little.
    pub tail: f64,
}

/// Measures from which order on terms are negligible.
pub fn five_percent(harmonics: &Harmonics) -> FivePercent {
    FivePercent {
        highest_order: harmonics.orders.last().map_or(0, |o| o.order),
        channels: std::array::from_fn(|k| channel_terms(harmonics, k)),
    }
}

fn channel_terms(harmonics: &Harmonics, k: usize) -> ChannelTerms {
    let (orders, length_nm) = (&harmonics.orders, harmonics.band.length_nm());
    let exact = harmonics.exact[k];
    let share = |order: &Order| {
        Some(order.contribution[k] / exact).filter(|s| exact > 0.0 && s.is_finite())
    };
    let is_negligible = |share: Option<f64>| share.is_some_and(|s| s.abs() < NEGLIGIBLE_SHARE);
    let lobes = gaussian_cmf::FIT[k];
    ChannelTerms {
        first_negligible: start_of_end_run(orders.get(1..).unwrap_or_default(), |o| {
            is_negligible(share(o))
        }),
        sufficient_order: start_of_end_run(orders, |o| is_negligible(o.neglected[k])),
        promised: latest(lobes, |lobe, n| lobe.bound(n, length_nm)),
        promised_as_printed: latest(lobes, |lobe, n| lobe.bound_as_printed(n, length_nm)),
        at_stated_order: neglected_beyond(STATED_ORDER.figure as usize, orders, k, share),
    }
}

/// The order at which the unbroken run of orders that pass, up to the highest, begins.
fn start_of_end_run(orders: &[Order], passes: impl Fn(&Order) -> bool) -> Option<usize> {
    let run = orders.iter().rev().take_while(|o| passes(o));
    run.last().map(|o| o.order)
}

/// The first order at which the bounds of all lobes are below the share.
fn latest(lobes: &[Gaussian], bound: impl Fn(&Gaussian, usize) -> f64) -> usize {
    // 4/n alone is below the share from here on.
    let surely = (4.0 / NEGLIGIBLE_SHARE) as usize + 1;
    let first = |lobe| (1..surely).find(|n| bound(lobe, *n) < NEGLIGIBLE_SHARE);
    let firsts = lobes.iter().map(|lobe| first(lobe).unwrap_or(surely));
    firsts.max().unwrap_or(surely)
}

fn neglected_beyond(
    order: usize,
    orders: &[Order],
    k: usize,
    share: impl Fn(&Order) -> Option<f64>,
) -> Option<Neglected> {
    let beyond = orders.get(order + 1..)?;
    let sizes = beyond.iter().filter_map(&share).map(f64::abs);
    Some(Neglected {
        next_term: share(beyond.first()?)?,
        largest_term: sizes.fold(0.0, f64::max),
        tail: orders[order].neglected[k]?,
    })
}

// ------------------------------------------------------------------- samples against numbers

/// A spectrum with its lines, and how it is looked at.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// Basis functions, at least the first 20.
    pub table: &'a BasisTable,
    /// The blur of 10 nm on the same band.
    pub blur: &'a Blur,
    /// The spectrum as measured, on the band's grid.
    pub measured: &'a [f64],
    /// Its lines, each with what it takes out of the spectrum.
    pub lines: &'a [LineShape],
    /// What X, Y and Z weigh the spectrum with, on the same grid.
    pub weights: &'a [Vec<f64>; 3],
    /// XYZ of the exact light in the same unit: the white.
    pub white: Xyz,
}

/// "400 samples or about 20 numbers": what each comes to on this spectrum.
#[derive(Clone, Debug, PartialEq)]
pub struct SamplesAgainstNumbers {
    /// Numbers for the smooth part of the composite.
    pub background: usize,
    /// Spikes of the composite, two numbers each.
    pub spikes: usize,
    /// How far the composite is off.
    pub composite: Errors,
    /// The spectrum sampled every [`STEPS_NM`], as far as the range holds such a step.
    pub sampled: Vec<SampledErrors>,
    /// Every step that was tried, from 1 nm on: the curve to draw.
    pub tried: Vec<SampledErrors>,
    /// How finely one must sample to do as well as the composite.
    pub needed: Needed,
}

impl SamplesAgainstNumbers {
    /// Numbers that the composite takes.
    pub fn numbers(&self) -> usize {
        self.background + 2 * self.spikes
    }
}

/// How far a representation is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// CIEDE2000 of the spectrum's own colour.
    pub own: Option<f64>,
    /// Relative root mean square on the 1 nm grid, which has a spike in its two neighbouring nm: a
    /// line of some width counts as missed there, however well it is weighed.
    pub relative_rms: f64,
    /// The same behind a blur of 10 nm.
    pub relative_rms_10nm: f64,
}

/// Samples at even steps, joined by straight lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampledErrors {
    /// Distance between samples in nm, counted from the range's first; the last sample stands at
    /// the range's end, however near.
    pub step_nm: usize,
    /// How many samples that makes.
    pub samples: usize,
    /// How far the straight lines are off.
    pub errors: Errors,
}

/// How finely one must sample to be off by no more than the composite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Needed {
    /// For the spectrum's own colour; `None` when there is no colour.
    pub own: Option<Match>,
    /// For the relative root mean square on the 1 nm grid.
    pub relative_rms: Match,
    /// For the same behind a blur of 10 nm.
    pub relative_rms_10nm: Match,
}

/// Samplings that are off by no more than the composite.
///
/// Which step does depends on where the samples happen to fall, so there are two answers. A step
/// of 1 nm loses nothing on the grid and is always one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Match {
    /// The coarsest step that does as well and so does every finer one tried.
    pub surely: SampledErrors,
    /// The coarsest step tried that does as well, be it by good fortune.
    pub at_best: SampledErrors,
}

/// Steps that tables of spectra have, in nm: 401, 81, 41 and 21 samples from 380 to 780.
pub const STEPS_NM: [usize; 4] = [1, 5, 10, 20];

/// Sets the paper's 20 numbers (12 for the background and 8 for the four heaviest lines; what
/// fewer lines leave goes to the background) against samples; `None` for an all-zero spectrum.
///
/// The fit is the paper's plain one: made colour-exact, its own colour would have no error to
/// match.
///
/// # Panics
/// When the measured values or the weights are not on the grid of the table's band.
pub fn samples(question: Question<'_>) -> Option<SamplesAgainstNumbers> {
    let heaviest = heaviest(question.lines, MOST_SPIKES);
    let numbers = TOTAL_NUMBERS - 2 * heaviest.len();
    let (smooth, background) = background(question, &heaviest, numbers);
    let spikes: Vec<Spike> = heaviest.iter().map(|line| line.spike).collect();
    let composite = question.errors(&smooth, &spikes)?;
    let steps = question.table.band().steps();
    let sampled = STEPS_NM.into_iter().filter(|step| *step <= steps);
    let tried: Vec<SampledErrors> = ladder(steps)
        .map(|step| question.sampled_every(step))
        .collect::<Option<_>>()?;
    Some(SamplesAgainstNumbers {
        background,
        spikes: spikes.len(),
        composite,
        sampled: sampled
            .map(|step| question.sampled_every(step))
            .collect::<Option<_>>()?,
        needed: needed(&tried, composite)?,
        tried,
    })
}

/// The lines of largest weight, at most `most`.
fn heaviest(lines: &[LineShape], most: usize) -> Vec<&LineShape> {
    let mut by_weight: Vec<&LineShape> = lines.iter().collect();
    by_weight.sort_by(|a, b| b.spike.weight.abs().total_cmp(&a.spike.weight.abs()));
    by_weight.truncate(most);
    by_weight
}

/// The fitted smooth part without some lines on the grid, and how many numbers it took.
fn background(question: Question<'_>, without: &[&LineShape], numbers: usize) -> (Vec<f64>, usize) {
    let mut target = question.measured.to_vec();
    for line in without {
        for (v, r) in target.iter_mut().skip(line.first).zip(&line.residue) {
            *v -= r;
        }
    }
    let coefficients = question.table.project(&target, numbers);
    (question.table.evaluate(&coefficients), coefficients.len())
}

fn needed(tried: &[SampledErrors], composite: Errors) -> Option<Needed> {
    let own = |errors: Errors| errors.own;
    let relative_rms = |errors: Errors| Some(errors.relative_rms);
    let relative_rms_10nm = |errors: Errors| Some(errors.relative_rms_10nm);
    Some(Needed {
        own: Match::of(tried, composite, own),
        relative_rms: Match::of(tried, composite, relative_rms)?,
        relative_rms_10nm: Match::of(tried, composite, relative_rms_10nm)?,
    })
}

/// Steps to try, in nm: every whole one to 20, then a tenth more each time, so that a long range
/// stays quick; none longer than the range.
fn ladder(longest: usize) -> impl Iterator<Item = usize> {
    let next = |step: &usize| Some(step + (step / 10).max(1));
    std::iter::successors(Some(1), next).take_while(move |step| *step <= longest)
}

impl Match {
    /// The matches among samplings of rising step; `None` when there is nothing to match.
    fn of(
        tried: &[SampledErrors],
        composite: Errors,
        measure: impl Fn(Errors) -> Option<f64>,
    ) -> Option<Self> {
        let limit = measure(composite)?;
        let does = |s: &&SampledErrors| measure(s.errors).is_some_and(|off| off <= limit);
        Some(Self {
            surely: *tried.iter().take_while(does).last()?,
            at_best: *tried.iter().rfind(does)?,
        })
    }
}

impl Question<'_> {
    /// Errors of a smooth part on the grid and spikes; `None` for an all-zero spectrum.
    fn errors(self, smooth: &[f64], spikes: &[Spike]) -> Option<Errors> {
        let band = self.table.band();
        let errors = spectrum_errors(self.blur, self.measured, smooth, spikes)?;
        let exact = xyz(band, self.measured, &[], self.weights);
        let found = xyz(band, smooth, spikes, self.weights);
        Some(Errors {
            own: difference(exact, found, self.white),
            relative_rms: errors.relative_rms,
            relative_rms_10nm: errors.relative_rms_10nm,
        })
    }

    /// Samples every `step_nm` whole nm, joined by straight lines.
    fn sampled_every(self, step_nm: usize) -> Option<SampledErrors> {
        let (lines, samples) = straight_lines(self.measured, step_nm);
        Some(SampledErrors {
            step_nm,
            samples,
            errors: self.errors(&lines, &[])?,
        })
    }
}

/// Values on a grid read at every `step`-th point and the last one, and the straight lines
/// between; with the number of points read.
fn straight_lines(values: &[f64], step: usize) -> (Vec<f64>, usize) {
    let last = values.len() - 1;
    let samples = last.div_ceil(step) + 1;
    let lines = (0..=last)
        .map(|i| {
            let left = i / step * step;
            let right = (left + step).min(last);
            if left == right {
                return values[left];
            }
            let t = (i - left) as f64 / (right - left) as f64;
            values[left] * (1.0 - t) + values[right] * t
        })
        .collect();
    (lines, samples)
}

// ----------------------------------------------------------------------------------- Eq. 17

/// A factor read at every spike of a light in four ways, and what that does to the colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Eq17 {
    /// The points that the straight lines run between.
    pub grid: SampleGrid,
    /// Spike by spike.
    pub readings: Vec<SpikeReading>,
    /// CIEDE2000 of the product when spikes are weighed by the corrected straight line instead of
    /// the series.
    pub linear_cost: Option<f64>,
    /// The same by Eq. 17 as printed.
    pub printed_cost: Option<f64>,
    /// The green mercury line on this range, off a straight line through the wavelengths
    /// themselves; `None` where the range does not hold the line.
    pub straight_line: Option<StraightLine>,
}

/// A factor at the place of one spike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpikeReading {
    /// The light's spike.
    pub spike: Spike,
    /// The factor as measured.
    pub measured: f64,
    /// Its series, evaluated exactly.
    pub series: f64,
    /// Eq. 17, corrected: the straight line between the two points around.
    pub linear: f64,
    /// Eq. 17 as printed, its two weights swapped.
    pub printed: f64,
}

/// Where a straight line `S(l) = l` is read by Eq. 17, all in nm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StraightLine {
    /// The place asked for.
    pub at_nm: f64,
    /// The point on its left.
    pub left_nm: f64,
    /// The point on its right.
    pub right_nm: f64,
    /// What the corrected weights read: the place asked for.
    pub corrected_nm: f64,
    /// What the printed weights read: its mirror image between the two points.
    pub printed_nm: f64,
}

/// Reads a factor (values on the grid) at the spikes of a light on the paper's points.
///
/// The factor is cut to as many numbers as the light has, or as the table holds. `weights` and
/// `white` are those of [`Question`].
///
/// # Panics
/// When the factor or the weights are not on the grid of the table's band, or the light is not on
/// that band.
pub fn eq_17(
    light: &Composite,
    factor: &[f64],
    table: &BasisTable,
    weights: &[Vec<f64>; 3],
    white: Xyz,
) -> Eq17 {
    let band = table.band();
    let series = cut(factor, table, light);
    let grid = paper_grid(&series);
    let samples = grid.sample(&series);
    let readings: Vec<SpikeReading> = light
        .spikes
        .iter()
        .map(|spike| SpikeReading {
            spike: *spike,
            measured: band.interpolate(factor, spike.at_nm),
            series: series.at(spike.at_nm),
            linear: grid.linear_at(&samples, spike.at_nm),
            printed: grid.linear_at_as_printed(&samples, spike.at_nm),
        })
        .collect();
    let smooth: Vec<f64> = light
        .smooth
        .on_band()
        .iter()
        .zip(series.on_band())
        .map(|(s, f)| s * f)
        .collect();
    let weighed_by = |value: fn(&SpikeReading) -> f64| {
        let spikes: Vec<Spike> = readings
            .iter()
            .map(|reading| Spike {
                weight: reading.spike.weight * value(reading),
                ..reading.spike
            })
            .collect();
        xyz(band, &smooth, &spikes, weights)
    };
    let exact = weighed_by(|reading| reading.series);
    Eq17 {
        grid,
        linear_cost: difference(exact, weighed_by(|reading| reading.linear), white),
        printed_cost: difference(exact, weighed_by(|reading| reading.printed), white),
        straight_line: straight_line(band, series.order(), STATED_LINE_NM.figure),
        readings,
    }
}

/// Reads `S(l) = l` at a place by Eq. 17 on the paper's 2N+2 points of a range; `None` outside it.
pub fn straight_line(band: Band, order: usize, at_nm: f64) -> Option<StraightLine> {
    if !band.contains(at_nm) {
        return None;
    }
    let grid = SampleGrid {
        band,
        basis: Basis::Fourier,
        points: numbers_of_order(order),
    };
    let x = (at_nm - band.min_nm()) / grid.step_nm();
    let left = (x as usize).min(grid.points - 1);
    let (left_nm, right_nm) = (grid.nm(left), grid.nm(left + 1));
    let t = x - left as f64;
    Some(StraightLine {
        at_nm,
        left_nm,
        right_nm,
        corrected_nm: left_nm * (1.0 - t) + right_nm * t,
        printed_nm: left_nm * t + right_nm * (1.0 - t),
    })
}

fn paper_grid(series: &Series) -> SampleGrid {
    SampleGrid {
        band: series.band,
        basis: series.basis,
        points: series.coefficients.len(),
    }
}

/// A factor fitted with as many numbers as the light has, or as the table holds.
fn cut(factor: &[f64], table: &BasisTable, light: &Composite) -> Series {
    Series {
        band: table.band(),
        basis: table.basis(),
        coefficients: table.project(factor, light.smooth.coefficients.len()),
    }
}

// ----------------------------------------------------------------------------------- Table 2

/// How well Table 2 stands for the colour-matching functions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Table2 {
    /// The largest deviation of x-bar, y-bar and z-bar on the range.
    pub worst: [Deviation; 3],
    /// The light's XYZ by the table, in value x nm over the range.
    pub by_table: Xyz,
    /// The light's XYZ by the fit, in the same unit.
    pub by_fit: Xyz,
    /// Distance in CIE 1976 u'v' between the two.
    pub delta_uv: Option<f64>,
    /// CIEDE2000 between the two; the white is the light by the table.
    pub delta_e_2000: Option<f64>,
}

/// The largest deviation of a fitted function.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Deviation {
    /// Where, in nm.
    pub at_nm: f64,
    /// The function there.
    pub table: f64,
    /// The fit there.
    pub fit: f64,
}

impl Deviation {
    /// Fit minus function.
    pub fn off(self) -> f64 {
        self.fit - self.table
    }
}

/// Sets Table 2 against an observer's functions (it was made for CIE 1931), and a light's own
/// colour by the one against that by the other.
///
/// # Panics
/// When `light` does not have one value per grid point of the band.
pub fn table_2(band: Band, observer: Observer, light: &[f64]) -> Table2 {
    let table = observer.table();
    let mut fit: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(band.points()));
    for nm in band.grid() {
        for (row, value) in fit.iter_mut().zip(gaussian_cmf::fitted_at(nm)) {
            row.push(value);
        }
    }
    let by_table = xyz(band, light, &[], &table.on_band(band));
    let by_fit = xyz(band, light, &[], &fit);
    let uv = uv_1976_from_xyz(by_table).zip(uv_1976_from_xyz(by_fit));
    Table2 {
        worst: std::array::from_fn(|k| worst_deviation(band, table, k)),
        by_table,
        by_fit,
        delta_uv: uv.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])),
        delta_e_2000: difference(by_table, by_fit, by_table),
    }
}

fn worst_deviation(band: Band, table: &ColourMatching, k: usize) -> Deviation {
    let at = |at_nm| Deviation {
        at_nm,
        table: table.at(at_nm)[k],
        fit: gaussian_cmf::fitted_at(at_nm)[k],
    };
    band.grid().map(at).fold(at(band.min_nm()), |worst, found| {
        if found.off().abs() > worst.off().abs() {
            found
        } else {
            worst
        }
    })
}

// -------------------------------------------------------------------------------- resampling

/// A product of a light and a factor, each cut to N, formed on a few points.
#[derive(Clone, Debug, PartialEq)]
pub struct Resampling {
    /// Order N of both factors.
    pub order: usize,
    /// Way by way, the paper's first.
    pub ways: Vec<ResamplingWay>,
}

/// What forming a product on a number of points costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResamplingWay {
    /// The way.
    pub sampling: Sampling,
    /// Independent points: one multiplication each.
    pub points: usize,
    /// Share of the product's power that these points fold back into lower orders, 0-1 and more.
    pub folded_share: f64,
    /// CIEDE2000 of the product against the exact product of the same two series.
    pub delta_e_2000: Option<f64>,
}

/// Forms light times factor (values on the grid) in every way that the basis offers.
///
/// Arguments as for [`eq_17`]. Spikes are weighed by the factor's series in every way, so that
/// only the smooth product differs.
///
/// # Panics
/// As [`eq_17`].
pub fn resampling(
    light: &Composite,
    factor: &[f64],
    table: &BasisTable,
    weights: &[Vec<f64>; 3],
    white: Xyz,
) -> Resampling {
    let band = table.band();
    let factor = cut(factor, table, light);
    let product = |sampling| {
        let Composite { smooth, spikes } = resampled(light, &factor, sampling);
        xyz(band, &smooth.on_band(), &spikes, weights)
    };
    let exact = product(Sampling::Exact);
    let numbers = light.smooth.coefficients.len();
    let (light_unit, factor_unit) = (in_units(&light.smooth), in_units(&factor));
    Resampling {
        order: light.smooth.order(),
        ways: ways(table.basis())
            .iter()
            .filter_map(|sampling| {
                let points = sampling.points(numbers)?;
                Some(ResamplingWay {
                    sampling: *sampling,
                    points,
                    // An empty sum is minus zero.
                    folded_share: 0.0 + folded_share(&light_unit, &factor_unit, points),
                    delta_e_2000: difference(exact, product(*sampling), white),
                })
            })
            .collect(),
    }
}

/// The ways that make sense in a basis: 3N+1 and 4N+1 points are for Fourier series.
fn ways(basis: Basis) -> &'static [Sampling] {
    match basis {
        Basis::Fourier => &[
            Sampling::Paper,
            Sampling::ThreeN,
            Sampling::FourN,
            Sampling::Double,
        ],
        Basis::Cosine => &[Sampling::Paper, Sampling::Double],
    }
}

/// A series as shares of its largest coefficient, so that no square overflows.
fn in_units(series: &Series) -> Series {
    let unit = height(&series.coefficients).unwrap_or(1.0);
    Series {
        coefficients: series.coefficients.iter().map(|c| c * unit).collect(),
        ..*series
    }
}

// ------------------------------------------------------------------------------------ shared

/// What values on the grid and spikes weigh of three weights, in value x nm.
fn xyz(band: Band, smooth: &[f64], spikes: &[Spike], weights: &[Vec<f64>; 3]) -> Xyz {
    Xyz::from_array(std::array::from_fn(|k| {
        let lines = spikes
            .iter()
            .map(|s| s.weight * band.interpolate(&weights[k], s.at_nm));
        band.inner(smooth, &weights[k]) + lines.sum::<f64>()
    }))
}

/// CIEDE2000 of two colours against a white; `None` without light.
fn difference(first: Xyz, second: Xyz, white: Xyz) -> Option<f64> {
    let is_light = white.y > 0.0 && white.is_finite();
    let found = delta_e_2000(lab_from_xyz(first, white), lab_from_xyz(second, white));
    Some(found).filter(|found| is_light && found.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::{
        error::{BLUR_NM, times},
        harmonics,
    };

    const BAND: Band = Band::VISIBLE;

    fn weights(band: Band) -> [Vec<f64>; 3] {
        Observer::Cie1931.table().on_band(band)
    }

    fn white(band: Band, light: &[f64]) -> Xyz {
        xyz(band, light, &[], &weights(band))
    }

    /// A smooth light that a series of 12 numbers holds exactly.
    fn background(table: &BasisTable) -> Vec<f64> {
        table.evaluate(&[
            8.0, 1.0, -0.5, 0.3, 0.4, -0.2, 0.1, 0.1, 0.05, -0.1, 0.02, 0.03,
        ])
    }

    /// A line that is one nm wide.
    fn line(at_nm: f64, weight: f64) -> LineShape {
        LineShape {
            spike: Spike { at_nm, weight },
            first: (at_nm - BAND.min_nm()) as usize,
            residue: vec![weight],
        }
    }

    fn with_lines(smooth: &[f64], lines: &[LineShape]) -> Vec<f64> {
        let mut values = smooth.to_vec();
        for line in lines {
            values[line.first] += line.spike.weight;
        }
        values
    }

    fn harmonics_of(band: Band, light: &[f64]) -> Harmonics {
        let table = BasisTable::new(band, Basis::Fourier, 41);
        Harmonics::of(harmonics::Question {
            table: &table,
            coefficients: &table.project(light, 41),
            spikes: &[],
            measured: light,
            weights: &weights(band),
            plain_colour_matching: true,
        })
    }

    fn samples_of(
        table: &BasisTable,
        measured: &[f64],
        lines: &[LineShape],
    ) -> SamplesAgainstNumbers {
        samples(Question {
            table,
            blur: &Blur::new(BAND, BLUR_NM),
            measured,
            lines,
            weights: &weights(BAND),
            white: white(BAND, measured),
        })
        .unwrap()
    }

    #[test]
    fn the_paper_keeps_one_order_too_few_on_the_wide_range() {
        let promised = |band: Band| {
            let flat = harmonics_of(band, &vec![1.0; band.points()]);
            let channels = five_percent(&flat).channels;
            channels.map(|c| (c.promised, c.promised_as_printed))
        };
        assert_eq!(promised(Band::PAPER), [(6, 6), (3, 3), (5, 5)]);
        assert_eq!(promised(Band::VISIBLE), [(7, 8), (4, 4), (6, 7)]);
    }

    #[test]
    fn a_flat_light_needs_nothing_but_its_mean() {
        let flat = harmonics_of(BAND, &vec![3.0; BAND.points()]);
        for channel in five_percent(&flat).channels {
            assert_eq!(channel.first_negligible, Some(1));
            assert_eq!(channel.sufficient_order, Some(0));
            let left_out = channel.at_stated_order.unwrap();
            // Coefficients that are zero but for the rounding of 401 additions.
            assert!(left_out.largest_term < 1e-13 && left_out.tail.abs() < 1e-13);
        }
    }

    #[test]
    fn from_the_orders_found_on_everything_is_negligible_and_just_before_it_is_not() {
        let mut light = vec![0.0; BAND.points()];
        light[50] = 1.0;
        light[210] = 2.0;
        let harmonics = harmonics_of(BAND, &light);
        let found = five_percent(&harmonics);
        assert_eq!(found.highest_order, 20);
        for (k, channel) in found.channels.iter().enumerate() {
            let (term, order) = (channel.first_negligible, channel.sufficient_order);
            let (term, order) = (term.unwrap(), order.unwrap());
            let of = |n: usize| harmonics.orders[n].contribution[k].abs() / harmonics.exact[k];
            let tail = |n: usize| harmonics.orders[n].neglected[k].unwrap().abs();
            assert!((term..=20).all(|n| of(n) < 0.05) && of(term - 1) >= 0.05);
            assert!((order..=20).all(|n| tail(n) < 0.05) && tail(order - 1) >= 0.05);
        }
    }

    #[test]
    fn a_range_without_visible_light_has_no_shares_and_no_colour() {
        let band = Band::new(900.0, 1000.0).unwrap();
        let light = vec![1.0; band.points()];
        for channel in five_percent(&harmonics_of(band, &light)).channels {
            assert_eq!(channel.first_negligible, None);
            assert_eq!(channel.sufficient_order, None);
            assert_eq!(channel.at_stated_order, None);
        }
        let fit = table_2(band, Observer::Cie1931, &light);
        assert_eq!((fit.delta_uv, fit.delta_e_2000), (None, None));
        let found = samples(Question {
            table: &BasisTable::new(band, Basis::Cosine, 20),
            blur: &Blur::new(band, BLUR_NM),
            measured: &light,
            lines: &[],
            weights: &weights(band),
            white: white(band, &light),
        });
        assert_eq!(found.unwrap().needed.own, None);
    }

    #[test]
    fn twenty_numbers_go_to_four_lines_and_what_lines_leave_to_the_background() {
        let table = BasisTable::new(BAND, Basis::Fourier, 41);
        let all = [410.0, 436.0, 546.0, 578.0, 611.0].map(|nm| line(nm, nm / 10.0));
        let smooth = background(&table);
        for (lines, spikes) in [(0, 0), (2, 2), (4, 4), (5, 4)] {
            let measured = with_lines(&smooth, &all[..lines]);
            let found = samples_of(&table, &measured, &all[..lines]);
            assert_eq!((found.numbers(), found.spikes), (20, spikes));
            assert_eq!(found.background, 20 - 2 * spikes);
            let off = found.composite.relative_rms;
            // Exact where every line has its spike; the fifth, the lightest left, is missed.
            assert_eq!(off < 1e-12, lines <= 4, "{off}");
        }
        assert_eq!(STATED_BACKGROUND.figure, 12.0);
        assert_eq!(STATED_SPIKE_NUMBERS.figure, 8.0);
    }

    #[test]
    fn lines_of_one_nm_need_a_sample_every_nm() {
        let table = BasisTable::new(BAND, Basis::Cosine, 41);
        let lines = [436.0, 545.0].map(|nm| line(nm, 30.0));
        let found = samples_of(&table, &with_lines(&background(&table), &lines), &lines);
        let counts: Vec<usize> = found.sampled.iter().map(|s| s.samples).collect();
        assert_eq!(counts, [401, 81, 41, 21]);
        assert_eq!(found.sampled[0].errors.relative_rms, 0.0);
        assert!(found.sampled[1].errors.own.unwrap() > 5.0);
        for needed in [found.needed.relative_rms, found.needed.own.unwrap()] {
            assert_eq!(needed.surely.samples, 401);
            assert_eq!(needed.at_best.samples, 401);
        }
    }

    #[test]
    fn a_lucky_step_is_told_from_one_that_surely_does() {
        let errors = |relative_rms| Errors {
            own: None,
            relative_rms,
            relative_rms_10nm: 0.0,
        };
        let tried: Vec<SampledErrors> = [0.0, 0.1, 0.3, 0.2, 0.4]
            .into_iter()
            .zip(ladder(400))
            .map(|(off, step_nm)| SampledErrors {
                step_nm,
                samples: 400 / step_nm + 1,
                errors: errors(off),
            })
            .collect();
        let found = Match::of(&tried, errors(0.2), |e| Some(e.relative_rms)).unwrap();
        assert_eq!((found.surely.step_nm, found.at_best.step_nm), (2, 4));
        assert_eq!(Match::of(&tried, errors(0.2), |e| e.own), None);
    }

    #[test]
    fn every_whole_step_to_20_nm_is_tried_and_none_beyond_the_range() {
        let steps: Vec<usize> = ladder(30).collect();
        assert_eq!(steps[..20], (1..=20).collect::<Vec<_>>());
        assert_eq!(steps[20..], [22, 24, 26, 28, 30]);
        assert!(ladder(20_000).count() < 120);
    }

    #[test]
    fn the_last_sample_stands_at_the_end_however_near() {
        let values = [0.0, 1.0, 4.0, 9.0, 16.0, 25.0];
        assert_eq!(straight_lines(&values, 1), (values.to_vec(), 6));
        let (lines, samples) = straight_lines(&values, 3);
        assert_eq!(samples, 3);
        assert_eq!(
            [lines[0], lines[3], lines[4], lines[5]],
            [0.0, 9.0, 17.0, 25.0]
        );
        let (lines, samples) = straight_lines(&values, 99);
        assert_eq!((samples, lines[5]), (2, 25.0));
    }

    #[test]
    fn no_spectrum_has_no_contest() {
        let table = BasisTable::new(BAND, Basis::Fourier, 20);
        let dark = vec![0.0; BAND.points()];
        let found = samples(Question {
            table: &table,
            blur: &Blur::new(BAND, BLUR_NM),
            measured: &dark,
            lines: &[],
            weights: &weights(BAND),
            white: Xyz::ZERO,
        });
        assert_eq!(found, None);
    }

    /// MODEL: "at 546.1 nm a straight line would give 553.9". The swapped weights mirror a place
    /// about the middle of its interval, and 2N+1 intervals have one in the middle of the range.
    #[test]
    fn the_printed_weights_read_a_straight_line_at_553_9_on_the_papers_range() {
        let line_nm = STATED_LINE_NM.figure;
        for order in 0..=18 {
            let read = straight_line(Band::PAPER, order, line_nm).unwrap();
            // Sums of wavelengths near 1000 nm.
            assert!((read.printed_nm - 553.9).abs() < 1e-9, "N = {order}");
            assert!((read.corrected_nm - line_nm).abs() < 1e-9);
            let grid = SampleGrid {
                band: Band::PAPER,
                basis: Basis::Fourier,
                points: numbers_of_order(order),
            };
            // Order 0 has one point, which is its own right neighbour.
            if order > 0 {
                let values: Vec<f64> = (0..grid.points).map(|i| grid.nm(i)).collect();
                let printed = grid.linear_at_as_printed(&values, line_nm);
                assert!((printed - 553.9).abs() < 1e-9);
                assert!((grid.linear_at(&values, line_nm) - line_nm).abs() < 1e-9);
            }
        }
        // From order 19 on the middle interval is too short to hold the line.
        let read = straight_line(Band::PAPER, 19, line_nm).unwrap();
        assert!((read.printed_nm - 553.9).abs() > 1.0);
        // On 380-780 nm the middle is 580 nm: no order reads 553.9 there.
        for order in 0..=40 {
            let read = straight_line(Band::VISIBLE, order, line_nm).unwrap();
            assert!((read.printed_nm - 553.9).abs() > 0.05, "N = {order}");
        }
        assert_eq!(straight_line(Band::PAPER, 5, 800.0), None);
    }

    #[test]
    fn a_flat_factor_reads_the_same_in_every_way_and_costs_nothing() {
        for basis in Basis::ALL {
            let table = BasisTable::new(BAND, basis, 11);
            let light = Composite {
                smooth: Series {
                    band: BAND,
                    basis,
                    coefficients: vec![2.0, 0.3, -0.1, 0.2, 0.0],
                },
                spikes: vec![line(546.0, 20.0).spike, line(700.5, 5.0).spike],
            };
            let half = vec![0.5; BAND.points()];
            let weights = weights(BAND);
            let white = xyz(BAND, &light.smooth.on_band(), &light.spikes, &weights);
            let read = eq_17(&light, &half, &table, &weights, white);
            assert_eq!(read.grid.points, 5);
            for r in &read.readings {
                for value in [r.measured, r.series, r.linear, r.printed] {
                    // Means of a constant.
                    assert!((value - 0.5).abs() < 1e-14);
                }
            }
            // Roundings of numbers near 70 through a cube root.
            assert!(read.linear_cost.unwrap() < 1e-11 && read.printed_cost.unwrap() < 1e-11);
            for way in resampling(&light, &half, &table, &weights, white).ways {
                assert!(way.folded_share < 1e-28 && way.delta_e_2000.unwrap() < 1e-11);
            }
        }
    }

    #[test]
    fn on_a_point_the_line_is_exact_and_the_printed_weights_read_its_neighbour() {
        let table = BasisTable::new(BAND, Basis::Fourier, 5);
        let factor = table.evaluate(&[1.0, 0.2, 0.1, -0.1, 0.05]);
        let light = Composite {
            smooth: Series {
                band: BAND,
                basis: Basis::Fourier,
                coefficients: vec![2.0, 0.0, 0.0, 0.0, 0.0],
            },
            spikes: vec![line(540.0, 10.0).spike],
        };
        // Five points 80 nm apart: 540 is the third, 620 the fourth.
        let read = eq_17(
            &light,
            &factor,
            &table,
            &weights(BAND),
            white(BAND, &factor),
        );
        let [reading] = read.readings[..] else {
            panic!("one spike");
        };
        // A series of five numbers near 1 by its recurrence.
        assert!((reading.linear - reading.series).abs() < 1e-14);
        assert!((reading.printed - factor[240]).abs() < 1e-14);
        assert!(read.printed_cost.unwrap() > read.linear_cost.unwrap());
    }

    #[test]
    fn the_papers_points_fold_and_four_times_the_order_does_not() {
        let table = BasisTable::new(BAND, Basis::Fourier, 41);
        let coefficients = table.project(&background(&table), 11);
        let light = Composite {
            smooth: Series {
                band: BAND,
                basis: Basis::Fourier,
                coefficients,
            },
            spikes: Vec::new(),
        };
        let factor: Vec<f64> = BAND.grid().map(|nm| (nm - 380.0) / 400.0).collect();
        let white = white(BAND, &light.smooth.on_band());
        let found = resampling(&light, &factor, &table, &weights(BAND), white);
        assert_eq!(found.order, 5);
        let points: Vec<usize> = found.ways.iter().map(|way| way.points).collect();
        assert_eq!(points, [11, 17, 21, 22]);
        // The paper counts the period's end once more.
        assert_eq!(stated_multiplications(5).figure, points[0] as f64 + 1.0);
        assert!(found.ways[0].folded_share > 0.0 && found.ways[0].delta_e_2000.unwrap() > 0.0);
        for exact in &found.ways[2..] {
            assert_eq!(exact.folded_share, 0.0);
            // Roundings of numbers near 100 through a cube root.
            assert!(exact.delta_e_2000.unwrap() < 1e-11);
        }
    }

    #[test]
    fn table_2_misses_the_functions_by_this_much() {
        let fit = table_2(BAND, Observer::Cie1931, &vec![1.0; BAND.points()]);
        let worst = fit.worst.map(|w| (w.at_nm, (1e3 * w.off()).round()));
        assert_eq!(worst, [(575.0, 49.0), (528.0, -83.0), (433.0, -205.0)]);
        // Equal energy: the table's three areas agree, those of the bells do not quite.
        assert!((3.0..6.0).contains(&fit.delta_e_2000.unwrap()));
        assert!((0.003..0.006).contains(&fit.delta_uv.unwrap()));
    }

    #[test]
    fn enormous_and_tiny_spectra_give_no_nan() {
        let table = BasisTable::new(BAND, Basis::Fourier, 20);
        for scale in [1e-300, 1e150, 1e300] {
            let measured = times(&background(&table), scale);
            let fit = table_2(BAND, Observer::Cie1931, &measured);
            assert!(fit.delta_e_2000.is_none_or(f64::is_finite));
            let found = samples_of(&table, &measured, &[]);
            assert!(found.composite.relative_rms.is_finite());
            let light = Composite {
                smooth: Series {
                    band: BAND,
                    basis: Basis::Fourier,
                    coefficients: table.project(&measured, 11),
                },
                spikes: Vec::new(),
            };
            let white = white(BAND, &measured);
            for way in resampling(&light, &measured, &table, &weights(BAND), white).ways {
                assert!(way.folded_share.is_finite());
                assert!(way.delta_e_2000.is_none_or(f64::is_finite));
            }
        }
    }
}
