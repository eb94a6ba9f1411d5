//! A line of a composite: a place, a weight and a full width at half maximum.
//!
//! ```text
//! weight g(l; at_nm, fwhm_nm)
//! ```
//!
//! `g` is a Gaussian of full width `fwhm_nm` at half its height, of unit area on the 1 nm
//! trapezoid grid of the band; width 0 is the ideal spike of the paper, split linearly over its two
//! neighbouring nm. A line weighs a cosine of the band in closed form, damped by its width,
//!
//! ```text
//! int g cos(pi n x/L) = cos(pi n p/L) exp(-(pi n sigma/L)^2 / 2)      x, p nm above the band's start
//! ```
//!
//! as long as it does not reach over an end of the band, where it is summed on the grid instead.

use std::f64::consts::{LN_2, PI};

use super::{band::Band, basis::Basis, series::Series};

/// A full width at half maximum times the peak height times this is a Gaussian's area:
/// `sqrt(pi / (4 ln 2))`.
pub(crate) const GAUSSIAN_AREA: f64 = 1.064_467_019_431_226_2;

/// A Gaussian's full width at half maximum in standard deviations.
const FWHM_IN_SIGMAS: f64 = 2.354_820_045_030_949;

/// A Gaussian is below 1e-14 of its height this many widths from its centre.
const REACH_WIDTHS: f64 = 3.5;

/// Nearer to an end of the band than this many widths the closed form leaves out what the end cuts:
/// at it the height is 7e-9 of the top.
const CLEAR_OF_ENDS_WIDTHS: f64 = 2.6;

/// Narrowest Gaussian: a narrower one falls between the points of the 1 nm grid and is taken as
/// ideal.
pub(crate) const NARROWEST_NM: f64 = 2.0;

/// A line: its place, its power and how wide it is.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Line {
    /// Centre, nm.
    pub at_nm: f64,
    /// Radiant power in the spectrum's own unit x nm; negative for absorption.
    pub weight: f64,
    /// Full width at half maximum, nm; 0 is the paper's ideal spike. Below `NARROWEST_NM` a
    /// line is treated as ideal.
    pub fwhm_nm: f64,
}

/// A line of unit area on the grid of a band.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LineProfile {
    /// Index of the first grid point with a value.
    pub first: usize,
    /// Values per nm there and after; their trapezoid integral is 1.
    pub values: Vec<f64>,
}

impl LineProfile {
    /// The profile of a line at a place in the band; empty outside the band.
    ///
    /// A line that reaches over an end is normalised over what lies inside.
    pub(crate) fn new(band: Band, at_nm: f64, fwhm_nm: f64) -> Self {
        if !band.contains(at_nm) {
            return Self {
                first: 0,
                values: Vec::new(),
            };
        }
        let x = at_nm - band.min_nm();
        if !(fwhm_nm >= NARROWEST_NM && fwhm_nm.is_finite()) {
            let first = (x as usize).min(band.steps() - 1);
            let t = x - first as f64;
            return Self {
                first,
                values: vec![(1.0 - t) / band.weight(first), t / band.weight(first + 1)],
            };
        }
        let reach = REACH_WIDTHS * fwhm_nm;
        let first = (x - reach).ceil().max(0.0) as usize;
        let last = ((x + reach).floor() as usize).min(band.steps());
        let mut values = bell(x, fwhm_nm, first, last);
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

    /// Integral of the profile times values on the band's grid: their mean under the line.
    pub(crate) fn mean_of(&self, band: Band, values: &[f64]) -> f64 {
        let here = values[self.first..].iter().zip(&self.values).enumerate();
        here.map(|(i, (f, v))| band.weight(self.first + i) * f * v)
            .sum()
    }

    /// Adds the profile times a weight to values on the band's grid.
    pub(crate) fn add_to(&self, weight: f64, values: &mut [f64]) {
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
fn bell(x: f64, fwhm_nm: f64, first: usize, last: usize) -> Vec<f64> {
    let a = 4.0 * LN_2 / (fwhm_nm * fwhm_nm);
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

impl Line {
    /// A line at a place (nm) of a weight (unit x nm) and a full width at half maximum (nm).
    pub const fn new(at_nm: f64, weight: f64, fwhm_nm: f64) -> Self {
        Self {
            at_nm,
            weight,
            fwhm_nm,
        }
    }

    /// A line of no width.
    pub const fn ideal(at_nm: f64, weight: f64) -> Self {
        Self::new(at_nm, weight, 0.0)
    }

    /// True if it counts as a line of no width.
    pub(crate) fn is_ideal(self) -> bool {
        !(self.fwhm_nm >= NARROWEST_NM && self.fwhm_nm.is_finite())
    }

    /// Height drawn above the smooth curve at the centre: the peak of the line's own Gaussian, or
    /// of one `drawn_nm` wide for an ideal spike.
    pub fn stem_height(self, drawn_nm: f64) -> f64 {
        let fwhm_nm = if self.is_ideal() {
            drawn_nm
        } else {
            self.fwhm_nm
        };
        self.weight / (GAUSSIAN_AREA * fwhm_nm)
    }

    /// The weight of a line whose stem, drawn `drawn_nm` wide, has a height; dragging a stem's tip
    /// uses it.
    pub(crate) fn weight_from_stem(height: f64, drawn_nm: f64) -> f64 {
        height * GAUSSIAN_AREA * drawn_nm
    }

    /// The same line with another weight.
    pub(crate) fn weighing(self, weight: f64) -> Self {
        Self { weight, ..self }
    }

    /// Its profile on the grid of a band.
    pub(crate) fn profile(self, band: Band) -> LineProfile {
        LineProfile::new(band, self.at_nm, self.fwhm_nm)
    }

    /// Integral of the line times values on the band's grid.
    pub(crate) fn integrate(self, band: Band, values: &[f64]) -> f64 {
        if self.is_ideal() {
            return self.weight * band.interpolate(values, self.at_nm);
        }
        self.weight * self.profile(band).mean_of(band, values)
    }

    /// Integral of the line times a series over its band: in closed form, or on the grid where the
    /// line reaches over an end of the band. Zero outside the band.
    pub fn integrate_series(self, series: &Series) -> f64 {
        let band = series.band;
        if !band.contains(self.at_nm) {
            return 0.0;
        }
        if self.is_ideal() {
            return self.weight * series.at(self.at_nm);
        }
        let clear = CLEAR_OF_ENDS_WIDTHS * self.fwhm_nm;
        if self.at_nm - band.min_nm() < clear || band.max_nm() - self.at_nm < clear {
            return self.integrate(band, &series.on_band());
        }
        let sigma = self.fwhm_nm / FWHM_IN_SIGMAS;
        let damped: Vec<f64> = series
            .coefficients
            .iter()
            .enumerate()
            .map(|(index, c)| c * damping(series.basis, index, band, sigma))
            .collect();
        let damped = Series {
            coefficients: damped,
            ..*series
        };
        self.weight * damped.at(self.at_nm)
    }
}

/// Share of a basis function's height that remains after convolution with a Gaussian.
fn damping(basis: Basis, index: usize, band: Band, sigma_nm: f64) -> f64 {
    let t = PI * basis.half_turns_of(index) as f64 * sigma_nm / band.length_nm();
    (-0.5 * t * t).exp()
}

/// Height of a Gaussian of height 1 so many full widths at half maximum from its centre.
pub(crate) fn gaussian(widths: f64) -> f64 {
    (-4.0 * LN_2 * widths * widths).exp()
}

/// Adds lines to values on a band's grid so that the trapezoid integral grows by their weights;
/// lines outside the band are left out.
pub(crate) fn add_lines(band: Band, lines: &[Line], values: &mut [f64]) {
    for line in lines {
        line.profile(band).add_to(line.weight, values);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    fn series(basis: Basis) -> Series {
        Series::new(
            BAND,
            basis,
            (0..21)
                .map(|n| (0.7_f64).powi(n) * if n % 3 == 0 { 1.0 } else { -0.6 })
                .collect(),
        )
    }

    #[test]
    fn every_line_has_its_weight_as_area_even_at_the_ends() {
        for at_nm in [380.0, 380.3, 436.0, 546.07, 779.9, 780.0] {
            for fwhm_nm in [0.0, 1.9, 2.0, 7.3, 55.0, 90.0] {
                let mut values = vec![0.0; BAND.points()];
                Line::new(at_nm, 3.0, fwhm_nm)
                    .profile(BAND)
                    .add_to(3.0, &mut values);
                // At most 630 products of numbers below 1.
                assert!(
                    (BAND.integral(&values) - 3.0).abs() < 1e-13,
                    "{at_nm} {fwhm_nm}"
                );
            }
        }
        assert!(Line::ideal(900.0, 1.0).profile(BAND).values.is_empty());
        assert!(
            Line::new(f64::NAN, 1.0, 5.0)
                .profile(BAND)
                .values
                .is_empty()
        );
    }

    #[test]
    fn a_bell_by_ratios_is_the_bell_by_exponentials() {
        for (x, fwhm_nm) in [(100.37, 2.0), (0.0, 90.0), (400.0, 55.0), (17.5, 9.1)] {
            let values = bell(x, fwhm_nm, 0, 400);
            for (i, v) in values.iter().enumerate() {
                let d = (i as f64 - x) / fwhm_nm;
                let exact = (-4.0 * LN_2 * d * d).exp();
                // 400 products, each rounded twice.
                assert!((v - exact).abs() < 1e-12, "{x} {fwhm_nm} {i}");
            }
        }
    }

    #[test]
    fn the_closed_form_is_the_sum_on_the_grid() {
        for basis in Basis::ALL {
            let series = series(basis);
            let values = series.on_band();
            for at_nm in [480.0, 546.07, 611.3] {
                for fwhm_nm in [3.0, 8.0, 20.0, 38.0] {
                    let line = Line::new(at_nm, 2.0, fwhm_nm);
                    let (closed, summed) = (
                        line.integrate_series(&series),
                        line.integrate(BAND, &values),
                    );
                    // The end cuts off less than 3e-9 of the area; a Gaussian of 3 nm sampled each
                    // nm is off by exp(-2 pi^2 sigma^2) = 1e-14.
                    assert!(
                        (closed - summed).abs() < 2e-8,
                        "{basis:?} {at_nm} {fwhm_nm}: {closed} {summed}"
                    );
                }
            }
        }
    }
}
