//! A light through any number of filters and off any number of surfaces, stage by stage.
//!
//! Every way of forming a product ([`Sampling`]) is carried through the whole chain:
//!
//! ```text
//! exact          the 1 nm grid, the factors as measured
//! paper 3n 4n    the factors as short series, all on one sample grid, never cut in between
//! double         the same on twice the numbers, four times from the fifth factor on
//! convolution    the factors as short series, coefficients cut back to N at each stage
//! ```
//!
//! The light's spikes are carried exactly in all of them: weight times the factor where they
//! stand (Eq. 14). A factor's own absorption lines are part of its curve unless they are asked to
//! be kept ([`Factor::keeping_dips`]): then the light's smooth part gets a negative spike there,
//! and a line of the light within [`SAME_PLACE_NM`] of a dip, a product that has no finite value,
//! is multiplied by what the dip lets through. [`Stage::met`] says so. A Gaussian line of full width
//! `l` loses to a Gaussian dip of width `d` and depth `h` at the same place
//!
//! ```text
//! h d / sqrt(d^2 + l^2)
//! ```
//!
//! of its area: all of the depth if it is ideal (`l` = 0), hardly anything if it is much the wider.

use super::{
    band::{Band, dot},
    basis::Basis,
    composite::Composite,
    factor::{Dip, Factor},
    line::{GAUSSIAN_AREA, Line},
    product::{chain_points, convolve, folded_shares, weigh_lines},
    resampled::{SampleGrid, Sampling},
    series::{BasisTable, Series},
};

/// A line of the light this close to a factor's dip meets it, nm.
const SAME_PLACE_NM: f64 = 0.5;

/// A line of the light that stood on a dip of a factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineInDip {
    /// Wavelength of the line, nm.
    pub line_nm: f64,
    /// Wavelength of the dip, nm.
    pub dip_nm: f64,
    /// Share of the line's weight lost to the dip on top of the factor's smooth part: the dip's
    /// depth for an ideal line, less for one that has a width.
    pub depth: f64,
}

/// The light behind one factor of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// The smooth part on the band's 1 nm grid.
    pub smooth: Vec<f64>,
    /// The smooth part if nothing had been folded or cut: the product of the very same factors.
    pub unfolded: Vec<f64>,
    /// The spikes, by rising wavelength.
    pub spikes: Vec<Line>,
    /// Lines that stood on a dip.
    pub met: Vec<LineInDip>,
    /// Share of the product's power so far, 0-1, in orders that the points fold back (of a
    /// convolution: that are cut off).
    pub folded_share: f64,
    /// Multiplications of this stage: one a point (a convolution: one a pair of numbers) and one
    /// a spike. Reading the factor where a spike stands is not counted.
    pub multiplications: usize,
}

/// Tables shared by all chains with the same way, basis, and counts of numbers and factors.
#[derive(Clone, Debug)]
pub(crate) struct ChainTables {
    band: Band,
    basis: Basis,
    numbers: usize,
    sampling: Sampling,
    /// Points of the sample grid; zero for the ways without.
    points: usize,
    /// Basis functions on the 1 nm grid.
    table: BasisTable,
    /// `points` rows that take coefficients to the value at a point.
    to_points: Vec<f64>,
    /// `points` rows that take values at the points to a coefficient.
    to_numbers: Vec<f64>,
}

impl ChainTables {
    /// Tables for lights of `numbers` coefficients through up to `factors` factors.
    pub(crate) fn new(
        band: Band,
        basis: Basis,
        numbers: usize,
        sampling: Sampling,
        factors: usize,
    ) -> Self {
        let numbers = numbers.max(1);
        let points = match sampling {
            Sampling::Double => chain_points(numbers, factors),
            other => other.points(numbers).unwrap_or(0),
        };
        let grid = SampleGrid::new(band, basis, points);
        let table = BasisTable::beyond_the_grid(band, basis, points.max(numbers));
        Self {
            band,
            basis,
            numbers,
            sampling,
            points,
            table,
            to_points: grid.sampling_rows(numbers),
            to_numbers: grid.series_rows(),
        }
    }

    /// Tables for a light and a count of factors.
    pub(crate) fn for_light(light: &Composite, sampling: Sampling, factors: usize) -> Self {
        let smooth = light.smooth();
        let numbers = smooth.coefficients.len();
        Self::new(smooth.band, smooth.basis, numbers, sampling, factors)
    }

    /// Points of the sample grid; `None` for the ways without.
    #[cfg(test)]
    pub(crate) fn points(&self) -> Option<usize> {
        (self.points > 0).then_some(self.points)
    }

    /// The light behind each factor in turn. A line weighs a factor at its centre; its width counts
    /// where it meets a dip, nowhere else, and the stages' lines are ideal.
    ///
    /// # Panics
    /// When light and tables differ in band, basis or count of numbers, or a factor does not have
    /// [`Band::points`] values.
    pub(crate) fn pass(&self, light: &Composite, factors: &[Factor]) -> Vec<Stage> {
        let smooth = light.smooth();
        assert!(
            (smooth.band, smooth.basis, smooth.coefficients.len())
                == (self.band, self.basis, self.numbers),
            "tables of the light's own band, basis and numbers"
        );
        let points = self.band.points();
        assert!(
            factors.iter().all(|f| f.values().len() == points),
            "one value per grid point"
        );
        match self.sampling {
            Sampling::Exact => self.pass_measured(light, factors),
            _ => self.pass_series(light, factors),
        }
    }

    fn pass_measured(&self, light: &Composite, factors: &[Factor]) -> Vec<Stage> {
        let mut smooth = self.table.evaluate(&light.smooth().coefficients);
        let mut spikes = light.lines().to_vec();
        let mut stages = Vec::with_capacity(factors.len());
        for factor in factors {
            multiply_by(&mut smooth, factor.values());
            spikes = weigh_lines(&spikes, |nm| self.band.interpolate(factor.values(), nm));
            stages.push(Stage {
                smooth: smooth.clone(),
                unfolded: smooth.clone(),
                met: Vec::new(),
                folded_share: 0.0,
                multiplications: self.band.points() + spikes.len(),
                spikes: centres(&spikes),
            });
        }
        stages
    }

    fn pass_series(&self, light: &Composite, factors: &[Factor]) -> Vec<Stage> {
        let series: Vec<Series> = factors.iter().map(|factor| self.series(factor)).collect();
        let (kept, multiplications) = match self.points {
            0 => (self.numbers, self.numbers * self.numbers),
            points => (points, points),
        };
        let folded = folded_shares(light.smooth(), &series, kept);
        let mut unfolded = self.table.evaluate(&light.smooth().coefficients);
        let mut values = self.sample(&light.smooth().coefficients);
        let mut product = light.smooth().clone();
        let mut spikes = light.lines().to_vec();
        let mut stages = Vec::with_capacity(factors.len());
        for ((factor, short), folded_share) in factors.iter().zip(&series).zip(folded) {
            let multiplied = spikes.len() + factor.dips().len();
            let (weighed, met) = through_dips(&spikes, &product, factor, short);
            spikes = weighed;
            if self.points > 0 {
                multiply_by(&mut values, &self.sample(&short.coefficients));
                let rows = self.to_numbers.chunks_exact(self.points);
                product.coefficients = rows.map(|row| dot(row, &values)).collect();
            } else {
                product = convolve(&product, short).truncated(self.numbers);
            }
            multiply_by(&mut unfolded, &self.table.evaluate(&short.coefficients));
            stages.push(Stage {
                smooth: self.table.evaluate(&product.coefficients),
                unfolded: unfolded.clone(),
                spikes: centres(&spikes),
                met,
                folded_share,
                multiplications: multiplied + multiplications,
            });
        }
        stages
    }

    /// Series of a factor without its dips, by Eq. 5 with the trapezoid rule.
    fn series(&self, factor: &Factor) -> Series {
        let coefficients = self.table.project(factor.background(), self.numbers);
        Series::new(self.band, self.basis, coefficients)
    }

    /// A series on the sample grid.
    fn sample(&self, coefficients: &[f64]) -> Vec<f64> {
        let rows = self.to_points.chunks_exact(self.numbers);
        rows.map(|row| dot(row, coefficients)).collect()
    }
}

/// The lines without their widths.
fn centres(lines: &[Line]) -> Vec<Line> {
    let centre = |line: &Line| Line::ideal(line.at_nm, line.weight);
    lines.iter().map(centre).collect()
}

/// Lines behind a factor: weighed by its series, and new ones where its dips stand.
fn through_dips(
    spikes: &[Line],
    before: &Series,
    factor: &Factor,
    short: &Series,
) -> (Vec<Line>, Vec<LineInDip>) {
    let mut behind = weigh_lines(spikes, |nm| short.at(nm));
    let mut met = Vec::new();
    for spike in &mut behind {
        let distance = |dip: &&Dip| (dip.at_nm - spike.at_nm).abs();
        let nearest = factor
            .dips()
            .iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .filter(|dip| distance(dip) <= SAME_PLACE_NM);
        let Some(dip) = nearest else { continue };
        let depth = dip.depth * share_lost(spike.fwhm_nm, dip.width_nm);
        // A dip of an earlier factor is a line that hangs down.
        let is_line = spike.weight > 0.0;
        spike.weight *= 1.0 - depth;
        if is_line {
            met.push(LineInDip {
                line_nm: spike.at_nm,
                dip_nm: dip.at_nm,
                depth,
            });
        }
    }
    for dip in factor.dips() {
        let weight = before.at(dip.at_nm) * dip.weight;
        // The second pane of the same glass deepens the line of the first.
        match behind.iter_mut().find(|spike| spike.at_nm == dip.at_nm) {
            Some(spike) => spike.weight += weight,
            None => behind.push(Line::new(dip.at_nm, weight, dip.width_nm)),
        }
    }
    behind.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
    (behind, met)
}

/// Share of its depth that a Gaussian dip takes from a Gaussian line at the same place: the area of
/// their product, by the full width of each. All of it from an ideal line.
fn share_lost(line_nm: f64, dip_nm: f64) -> f64 {
    let both = line_nm.hypot(dip_nm);
    if both > 0.0 { dip_nm / both } else { 1.0 }
}

/// Places (nm) where a negative spike, drawn as a Gaussian of full width `width_nm`, takes the
/// total below zero.
///
/// `smooth` is on the band's grid. A spectrum cannot be negative, so such a dip says that the
/// model is not to be believed there.
pub(crate) fn below_zero(band: Band, smooth: &[f64], spikes: &[Line], width_nm: f64) -> Vec<f64> {
    spikes
        .iter()
        .filter(|spike| spike.weight < 0.0)
        .filter(|spike| {
            let room = band.interpolate(smooth, spike.at_nm) * GAUSSIAN_AREA * width_nm;
            spike.weight + room < 0.0
        })
        .map(|spike| spike.at_nm)
        .collect()
}

fn multiply_by(values: &mut [f64], factor: &[f64]) {
    for (v, f) in values.iter_mut().zip(factor) {
        *v *= f;
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{LN_2, PI};

    use super::*;
    use crate::spectrum::{
        factor::{bounces, glass},
        spikes::SpikeSettings,
    };

    const BAND: Band = Band::VISIBLE;

    /// A grey that lets half through but for a Gaussian dip.
    fn dented(at_nm: f64, depth: f64) -> Vec<f64> {
        BAND.grid()
            .map(|nm| 0.5 * (1.0 - depth * (-((nm - at_nm) / 2.0).powi(2)).exp()))
            .collect()
    }

    fn flat_light(spikes: Vec<Line>, basis: Basis) -> Composite {
        let one = 1.0 / basis.mean(1.0);
        Composite::of_lines_inside(
            Series::new(BAND, basis, vec![one, 0.0, 0.0, 0.0, 0.0]),
            spikes,
        )
    }

    #[test]
    fn twice_half_a_thickness_is_the_whole_thickness_and_none_is_nothing() {
        let pane = [0.0, 1e-30, 0.25, 0.9, 1.0, -0.01];
        let half = glass(&pane, 0.5);
        let twice: Vec<f64> = half.iter().map(|v| v * v).collect();
        for (found, expected) in twice.iter().zip(glass(&pane, 1.0)) {
            // A square root and a square.
            assert!((found - expected).abs() <= 1e-15 * expected.abs());
        }
        assert_eq!(glass(&pane, 1.0)[..5], pane[..5]);
        assert_eq!(glass(&pane, 1.0)[5], 0.0);
        for ratio in [0.0, -3.0, f64::NAN] {
            assert_eq!(glass(&pane, ratio), [1.0; 6]);
        }
        assert!(glass(&[3.0], 1e9)[0].is_finite());
        assert_eq!(bounces(&pane, 0), [1.0; 6]);
        assert_eq!(bounces(&[0.5, -0.1], 2)[0], 0.25);
        assert!(bounces(&[3.0], u32::MAX)[0].is_finite());
    }

    #[test]
    fn a_dip_is_part_of_the_curve_unless_it_is_to_be_kept() {
        let values = dented(500.0, 0.8);
        assert_eq!(Factor::new(values.clone()).dips(), []);
        let settings = SpikeSettings::default();
        let kept = Factor::keeping_dips(BAND, values.clone(), settings);
        let [dip] = kept.dips() else {
            panic!("one dip: {:?}", kept.dips());
        };
        assert!((dip.at_nm - 500.0).abs() < 1e-6, "{dip:?}");
        // 0.5 x 0.8 x 2 nm x sqrt(pi); the hull baseline cuts the foot off at under a percent.
        let area = 0.8 * PI.sqrt();
        assert!((dip.weight + area).abs() < 0.01 * area, "{dip:?}");
        assert!((dip.depth - 0.8).abs() < 0.01, "{dip:?}");
        assert_eq!(kept.values(), values);
        assert!(kept.background().iter().all(|v| (v - 0.5).abs() < 0.01));
        let flat = Factor::keeping_dips(BAND, vec![0.5; BAND.points()], settings);
        assert_eq!(flat, Factor::new(vec![0.5; BAND.points()]));
    }

    #[test]
    fn a_dip_takes_the_same_power_as_a_spike_and_in_the_curve() {
        let values = dented(500.0, 0.8);
        let exact = BAND.integral(&values);
        let kept = Factor::keeping_dips(BAND, values, SpikeSettings::default());
        for basis in Basis::ALL {
            let light = flat_light(Vec::new(), basis);
            let stages = ChainTables::for_light(&light, Sampling::Double, 1)
                .pass(&light, std::slice::from_ref(&kept));
            let [stage] = &stages[..] else {
                panic!("one stage")
            };
            let power = BAND.integral(&stage.smooth) + stage.spikes[0].weight;
            // The mean of a projection is exact; the rest is rounding.
            assert!((power / exact - 1.0).abs() < 1e-12, "{basis:?} {power}");
            assert_eq!(stage.spikes[0].at_nm, kept.dips()[0].at_nm);
            // 8 nm of a light of 0.5 are 4; the dip takes 1.4.
            let wide = below_zero(BAND, &stage.smooth, &stage.spikes, 10.0);
            assert!(wide.is_empty());
            let narrow = below_zero(BAND, &stage.smooth, &stage.spikes, 2.0);
            assert_eq!(narrow, [stage.spikes[0].at_nm]);
        }
    }

    #[test]
    fn a_line_on_a_dip_keeps_what_the_dip_lets_through_and_the_stage_says_so() {
        let kept = Factor::keeping_dips(BAND, dented(500.0, 0.8), SpikeSettings::default());
        let depth = kept.dips()[0].depth;
        let line = |at_nm| Line::ideal(at_nm, 3.0);
        let light = flat_light(vec![line(500.4), line(500.6)], Basis::Cosine);
        let tables = ChainTables::for_light(&light, Sampling::Double, 1);
        let stages = tables.pass(&light, std::slice::from_ref(&kept));
        let short = tables.series(&kept);
        let weight = |at_nm: f64| {
            let found = stages[0].spikes.iter().find(|s| s.at_nm == at_nm);
            found.expect("the line is still there").weight
        };
        assert_eq!(weight(500.4), 3.0 * short.at(500.4) * (1.0 - depth));
        assert_eq!(weight(500.6), 3.0 * short.at(500.6));
        assert_eq!(stages[0].met.len(), 1);
        assert_eq!(stages[0].met[0].line_nm, 500.4);
        assert_eq!(stages[0].spikes.len(), 3);
        // As measured, the line reads the dip off the curve itself.
        let exact = ChainTables::for_light(&light, Sampling::Exact, 1).pass(&light, &[kept]);
        assert_eq!(exact[0].met, []);
        assert_eq!(exact[0].spikes.len(), 2);
    }

    #[test]
    fn a_line_loses_to_a_dip_what_the_product_of_both_lacks() {
        let kept = Factor::keeping_dips(BAND, dented(500.0, 0.8), SpikeSettings::default());
        let dip = kept.dips()[0];
        // 2 nm to 1/e to either side.
        let width = 4.0 * LN_2.sqrt();
        assert!((dip.width_nm / width - 1.0).abs() < 0.02, "{dip:?}");
        for line_nm in [0.5, 2.0, width, 10.0] {
            let line = Line::new(dip.at_nm, 3.0, line_nm);
            let light = flat_light(vec![line], Basis::Cosine);
            let tables = ChainTables::for_light(&light, Sampling::Double, 1);
            let stages = tables.pass(&light, std::slice::from_ref(&kept));
            let [met] = stages[0].met[..] else {
                panic!("{:?}", stages[0].met)
            };
            // The product summed in steps of 1/100 nm, over the line's own sum.
            let bell = |nm: f64, width: f64| (-4.0 * LN_2 * (nm / width).powi(2)).exp();
            let places = || (-4000..=4000).map(|i| 0.01 * f64::from(i));
            let all: f64 = places().map(|nm| bell(nm, line_nm)).sum();
            let lost: f64 = places()
                .map(|nm| bell(nm, line_nm) * dip.depth * bell(nm, dip.width_nm))
                .sum();
            // The line's tail beyond 40 nm is nothing, the sum of a smooth bell exact.
            assert!((met.depth - lost / all).abs() < 1e-9, "{line_nm} {met:?}");
        }
    }

    #[test]
    fn two_panes_deepen_the_same_dip() {
        let kept = Factor::keeping_dips(BAND, dented(500.0, 0.8), SpikeSettings::default());
        let light = flat_light(Vec::new(), Basis::Cosine);
        let tables = ChainTables::for_light(&light, Sampling::Double, 2);
        let stages = tables.pass(&light, &[kept.clone(), kept]);
        assert_eq!(stages[1].spikes.len(), 1);
        // Half of the first pane's dip times what the dip lets through, and half a dip more.
        let (one, two) = (stages[0].spikes[0].weight, stages[1].spikes[0].weight);
        let kept = 0.5 * (1.0 + 1.0 - 0.8 * 0.5_f64.sqrt());
        assert!((two / one - kept).abs() < 0.02, "{one} {two}");
        // No line of the light stands there.
        assert_eq!(stages[1].met.len(), 0);
    }
}
