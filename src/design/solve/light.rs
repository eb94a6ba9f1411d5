//! Lights of a few lines of one colour: how one that is nearly of the colour becomes one, and what
//! it is worth.

use crate::design::{
    scales::{Against, LUMENS_PER_WATT, SampleTables, Scales},
    small::{dot, solved},
};

/// Tolerance on a sum against its target, Y = 1: lines that nearly coincide do not reach it.
const ROUNDING: f64 = 1e-11;

/// Turns of Newton's method; powers alone take one, and one more for each that reaches zero.
const MOST_TURNS: usize = 8;

/// A change of place that counts as much as all of a line's power, nm.
pub(super) const PLACE_NM: f64 = 12.0;

/// Worth of what has no figure: below every figure.
pub(super) const WORTHLESS: f64 = -1e6;

/// A line with its power, Y = 1 for the whole light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Line {
    pub(super) at_nm: f64,
    pub(super) power: f64,
}

/// A light of lines by rising place.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Light {
    pub(super) lines: Vec<Line>,
    /// Luminous efficacy of radiation, lm/W.
    pub(super) ler: f64,
    /// The figure, or [`WORTHLESS`].
    pub(super) worth: f64,
}

impl Light {
    pub(super) fn power(lines: &[Line]) -> f64 {
        lines.iter().map(|line| line.power).sum()
    }
}

/// Lines of unit power at whole nm, straight in between, with the sums of one figure.
pub(super) struct LineSearch<'a> {
    pub(super) first_nm: f64,
    /// X, Y, Z and power of a line.
    basic: Vec<[f64; 4]>,
    /// Sums of samples, `numbers` a place.
    samples: Vec<f64>,
    numbers: usize,
    /// X, Y, Z, Y = 1.
    target: [f64; 3],
    scales: &'a Scales,
    against: Against,
}

impl<'a> LineSearch<'a> {
    pub(super) fn new(
        [first_nm, last_nm]: [f64; 2],
        target: [f64; 3],
        against: Against,
        tables: &SampleTables,
        scales: &'a Scales,
    ) -> Self {
        let (mut basic, mut samples, mut numbers) = (Vec::new(), Vec::new(), 0);
        for place in 0..=(last_nm - first_nm) as usize {
            let sums = tables.line_sums(first_nm + place as f64);
            let [x, y, z, _, power] = sums.basic;
            basic.push([x, y, z, power]);
            let of_samples = against.sums_of(&sums);
            numbers = of_samples.len();
            samples.extend_from_slice(of_samples);
        }
        Self {
            first_nm,
            basic,
            samples,
            numbers,
            target,
            scales,
            against,
        }
    }

    pub(super) fn last_nm(&self) -> f64 {
        self.first_nm + (self.basic.len() - 1) as f64
    }

    /// The whole nm left of a place, and the share of the next.
    fn split(&self, at_nm: f64) -> (usize, f64) {
        let x = at_nm - self.first_nm;
        let left = (x.max(0.0) as usize).min(self.basic.len() - 2);
        (left, x - left as f64)
    }

    /// The first sums of a line of unit power, and their slopes a nm.
    fn column<const M: usize>(&self, at_nm: f64) -> [[f64; M]; 2] {
        let (left, share) = self.split(at_nm);
        let (a, b) = (&self.basic[left], &self.basic[left + 1]);
        let slope: [f64; M] = std::array::from_fn(|k| b[k] - a[k]);
        [std::array::from_fn(|k| a[k] + share * slope[k]), slope]
    }

    /// The figure of lines, or [`WORTHLESS`].
    fn figure(&self, lines: &[Line]) -> f64 {
        let mut sums = vec![0.0; self.numbers];
        for line in lines {
            let (left, share) = self.split(line.at_nm);
            let rows = &self.samples[left * self.numbers..(left + 2) * self.numbers];
            let (here, next) = rows.split_at(self.numbers);
            let (a, b) = (line.power * (1.0 - share), line.power * share);
            let all = sums.iter_mut().zip(here).zip(next);
            all.for_each(|((s, x), y)| *s += a * x + b * y);
        }
        let found = self.scales.figure_of(self.against, &sums);
        found.unwrap_or(WORTHLESS)
    }

    /// The light near to these lines that has the colour and at least the floor of efficacy, lm/W,
    /// by other powers and, where they may move, other places; `None` where that leads nowhere.
    pub(super) fn judged(&self, lines: &[Line], floor: f64, may_move: bool) -> Option<Light> {
        let most = match floor > 0.0 {
            true => LUMENS_PER_WATT / floor,
            false => f64::INFINITY,
        };
        let place_nm = if may_move { PLACE_NM } else { 0.0 };
        let [x, y, z] = self.target;
        let mut lines = self.brought_to(lines, [x, y, z], place_nm)?;
        if Light::power(&lines) > most {
            lines = self.brought_to(&lines, [x, y, z, most], place_nm)?;
        }
        Some(Light {
            ler: LUMENS_PER_WATT / Light::power(&lines),
            worth: self.figure(&lines),
            lines,
        })
    }

    /// The smallest change of powers, each weighed by itself, and of places, `place_nm` being as
    /// much as all of a power, that brings the first sums to a target (Newton's method).
    fn brought_to<const M: usize>(
        &self,
        lines: &[Line],
        target: [f64; M],
        place_nm: f64,
    ) -> Option<Vec<Line>> {
        let mut lines = lines.to_vec();
        let weight = place_nm * place_nm;
        for _ in 0..MOST_TURNS {
            let (mut matrix, mut missing) = ([[0.0; M]; M], target);
            for line in &lines {
                let [column, slope] = self.column::<M>(line.at_nm);
                for row in 0..M {
                    missing[row] -= line.power * column[row];
                    let (by_power, by_place) = (column[row], weight * slope[row]);
                    (0..M).for_each(|k| {
                        let both = by_power * column[k] + by_place * slope[k];
                        matrix[row][k] += line.power * both;
                    });
                }
            }
            if missing.iter().all(|v| v.abs() < ROUNDING) {
                return Some(lines);
            }
            let towards = solved(matrix, missing)?;
            for line in &mut lines {
                let [column, slope] = self.column(line.at_nm);
                line.power *= (1.0 + dot(&column, &towards)).max(0.0);
                line.at_nm += weight * dot(&slope, &towards);
            }
            let within = self.first_nm..=self.last_nm();
            let is_sound = lines
                .iter()
                .all(|l| l.power.is_finite() && within.contains(&l.at_nm));
            if !is_sound || !lines.is_sorted_by(|a, b| a.at_nm <= b.at_nm) {
                return None;
            }
        }
        None
    }
}
