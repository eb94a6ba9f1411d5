//! Lines that have a width: Gaussians beside a smooth series.
//!
//! ```text
//! S(l) = series(l) + sum weight g(l; at_nm, width_nm)
//! ```
//!
//! `g` is a Gaussian of full width `width_nm` at half its height, of unit area on the 1 nm
//! trapezoid grid of the band; width 0 is the ideal spike of the paper, split linearly over its two
//! neighbouring nm.

use std::f64::consts::LN_2;

use crate::spectrum::{Band, GAUSSIAN_AREA};

/// A Gaussian's full width at half maximum in standard deviations.
pub(super) const FWHM_IN_SIGMAS: f64 = 2.354_820_045_030_949;

/// A Gaussian is below 1e-14 of its height this many widths from its centre.
const REACH_WIDTHS: f64 = 3.5;

/// Narrowest Gaussian: a narrower one falls between the points of the 1 nm grid and is taken as
/// ideal.
pub(super) const NARROWEST_NM: f64 = 2.0;

/// A line: its place, its power and how wide it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spike {
    /// Centre, nm.
    pub at_nm: f64,
    /// Radiant power in the spectrum's own unit x nm; negative for absorption.
    pub weight: f64,
    /// Full width at half maximum, nm; 0 is the paper's ideal spike. Below [`NARROWEST_NM`] a
    /// line is treated as ideal.
    pub width_nm: f64,
}

/// A line of unit area on the grid of a band.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Index of the first grid point with a value.
    pub first: usize,
    /// Values per nm there and after; their trapezoid integral is 1.
    pub values: Vec<f64>,
}

impl Shape {
    /// The shape of a line at a place in the band; empty outside the band.
    ///
    /// A line that reaches over an end is normalised over what lies inside.
    pub fn new(band: Band, at_nm: f64, width_nm: f64) -> Self {
        if !band.contains(at_nm) {
            return Self {
                first: 0,
                values: Vec::new(),
            };
        }
        let x = at_nm - band.min_nm();
        if !(width_nm >= NARROWEST_NM && width_nm.is_finite()) {
            let first = (x as usize).min(band.steps() - 1);
            let t = x - first as f64;
            return Self {
                first,
                values: vec![(1.0 - t) / band.weight(first), t / band.weight(first + 1)],
            };
        }
        let reach = REACH_WIDTHS * width_nm;
        let first = (x - reach).ceil().max(0.0) as usize;
        let last = ((x + reach).floor() as usize).min(band.steps());
        let mut values = bell(x, width_nm, first, last);
        let cut_ends = |at: usize, value: f64| {
            let is_end = at == 0 || at == band.steps();
            if is_end { 0.5 * value } else { 0.0 }
        };
        let area = lanes_sum(&values)
            - cut_ends(first, values[0])
            - cut_ends(last, values[values.len() - 1]);
        let unit = 1.0 / area;
        values.iter_mut().for_each(|v| *v *= unit);
        Self { first, values }
    }

    /// Adds the shape times a weight to values on the band's grid.
    pub fn add_to(&self, weight: f64, values: &mut [f64]) {
        for (value, shape) in values[self.first..].iter_mut().zip(&self.values) {
            *value += weight * shape;
        }
    }
}

/// Values that are formed side by side, so that none waits for the one before it.
const LANES: usize = 8;

/// Sum in running sums side by side.
fn lanes_sum(values: &[f64]) -> f64 {
    let mut sums = [0.0; LANES];
    let chunks = values.chunks_exact(LANES);
    let rest: f64 = chunks.remainder().iter().sum();
    for chunk in chunks {
        for (sum, v) in sums.iter_mut().zip(chunk) {
            *sum += v;
        }
    }
    rest + sums.iter().sum::<f64>()
}

/// A Gaussian of height 1 on grid points `first..=last`, by the ratio of neighbours: a few
/// exponentials instead of one a point.
fn bell(x: f64, width_nm: f64, first: usize, last: usize) -> Vec<f64> {
    let a = 4.0 * LN_2 / (width_nm * width_nm);
    // From the centre outwards, so that rounding grows from the top, not from the foot.
    let middle = (x.round().max(0.0) as usize).clamp(first, last);
    let mut values = vec![0.0; last - first + 1];
    let d = middle as f64 - x;
    let (below, above) = values.split_at_mut(middle - first);
    flank(a, d, above.iter_mut());
    flank(a, 1.0 - d, below.iter_mut().rev());
    values
}

/// `exp(-a (d + k)^2)` for k = 0, 1, 2, ...
///
/// `exp(-a (d + k + n)^2)` is the value `n` before times `exp(-a n (2 (d + k) + n))`, and that ratio
/// falls by `exp(-2 a n^2)` from one to the next.
fn flank<'a>(a: f64, d: f64, mut out: impl Iterator<Item = &'a mut f64>) {
    let n = LANES as f64;
    let lane = |k: usize| d + k as f64;
    let mut values: [f64; LANES] = std::array::from_fn(|k| (-a * lane(k) * lane(k)).exp());
    let mut ratios: [f64; LANES] = std::array::from_fn(|k| (-a * n * (2.0 * lane(k) + n)).exp());
    let fall = (-2.0 * a * n * n).exp();
    loop {
        for value in values {
            match out.next() {
                Some(out) => *out = value,
                None => return,
            }
        }
        for (value, ratio) in values.iter_mut().zip(&mut ratios) {
            *value *= *ratio;
            *ratio *= fall;
        }
    }
}

impl Spike {
    /// A line of no width.
    pub const fn ideal(at_nm: f64, weight: f64) -> Self {
        Self {
            at_nm,
            weight,
            width_nm: 0.0,
        }
    }

    /// Whether it counts as a line of no width.
    pub fn is_ideal(self) -> bool {
        !(self.width_nm >= NARROWEST_NM && self.width_nm.is_finite())
    }

    /// What is drawn above the smooth curve at the centre: the peak of the line's own Gaussian, of
    /// one of `drawn_nm` for an ideal spike.
    pub fn stem_height(self, drawn_nm: f64) -> f64 {
        let width_nm = if self.is_ideal() {
            drawn_nm
        } else {
            self.width_nm
        };
        self.weight / (GAUSSIAN_AREA * width_nm)
    }

    /// Its shape on the grid of a band.
    pub fn shape(self, band: Band) -> Shape {
        Shape::new(band, self.at_nm, self.width_nm)
    }
}

/// Adds lines to values on a band's grid so that the trapezoid integral grows by their weights;
/// lines outside the band are left out.
pub fn add_spikes(band: Band, spikes: &[Spike], values: &mut [f64]) {
    for spike in spikes {
        spike.shape(band).add_to(spike.weight, values);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    #[test]
    fn every_line_has_its_weight_as_area_even_at_the_ends() {
        for at_nm in [380.0, 380.3, 436.0, 546.07, 779.9, 780.0] {
            for width_nm in [0.0, 1.9, 2.0, 7.3, 55.0, 90.0] {
                let mut values = vec![0.0; BAND.points()];
                Spike {
                    at_nm,
                    weight: 3.0,
                    width_nm,
                }
                .shape(BAND)
                .add_to(3.0, &mut values);
                // At most 630 products of numbers below 1.
                assert!(
                    (BAND.integral(&values) - 3.0).abs() < 1e-13,
                    "{at_nm} {width_nm}"
                );
            }
        }
        assert!(Spike::ideal(900.0, 1.0).shape(BAND).values.is_empty());
        assert!(
            Spike {
                at_nm: f64::NAN,
                weight: 1.0,
                width_nm: 5.0
            }
            .shape(BAND)
            .values
            .is_empty()
        );
    }

    #[test]
    fn a_bell_by_ratios_is_the_bell_by_exponentials() {
        for (x, width_nm) in [(100.37, 2.0), (0.0, 90.0), (400.0, 55.0), (17.5, 9.1)] {
            let values = bell(x, width_nm, 0, 400);
            for (i, v) in values.iter().enumerate() {
                let d = (i as f64 - x) / width_nm;
                let exact = (-4.0 * LN_2 * d * d).exp();
                // 400 products, each rounded twice.
                assert!((v - exact).abs() < 1e-12, "{x} {width_nm} {i}");
            }
        }
    }
}
