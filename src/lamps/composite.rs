//! A composite whose lines have a width: a smooth series and Gaussian lines, each as wide as it is.
//!
//! ```text
//! S(l) = series(l) + sum weight g(l; at_nm, width_nm)
//! ```
//!
//! `g` is a Gaussian of full width `width_nm` at half its height, of unit area on the 1 nm
//! trapezoid grid of the band; width 0 is the ideal spike of the paper, split linearly over its two
//! neighbouring nm. A line weighs a cosine of the band in closed form, damped by its width,
//!
//! ```text
//! int g cos(pi n x/L) = cos(pi n p/L) exp(-(pi n sigma/L)^2 / 2)      x, p nm above the band's start
//! ```
//!
//! as long as it does not reach over an end of the band, where it is summed on the grid instead.

use std::f64::consts::{LN_2, PI};

use crate::{
    color::Weights,
    spectrum::{Band, Basis, GAUSSIAN_AREA, Sampling, Series, Spike as IdealSpike, product},
};

/// A Gaussian's full width at half maximum in standard deviations.
pub(super) const FWHM_IN_SIGMAS: f64 = 2.354_820_045_030_949;

/// A Gaussian is below 1e-14 of its height this many widths from its centre.
const REACH_WIDTHS: f64 = 3.5;

/// Nearer to an end of the band than this many widths the closed form leaves out what the end cuts:
/// at it the height is 7e-9 of the top.
const CLEAR_OF_ENDS_WIDTHS: f64 = 2.6;

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

    /// Integral of the shape times values on the band's grid: their mean under the line.
    pub fn mean_of(&self, band: Band, values: &[f64]) -> f64 {
        let here = values[self.first..].iter().zip(&self.values).enumerate();
        here.map(|(i, (f, v))| band.weight(self.first + i) * f * v)
            .sum()
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

    /// Integral of the line times values on the band's grid.
    pub fn integrate(self, band: Band, values: &[f64]) -> f64 {
        if self.is_ideal() {
            return self.weight * band.interpolate(values, self.at_nm);
        }
        self.weight * self.shape(band).mean_of(band, values)
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
        let clear = CLEAR_OF_ENDS_WIDTHS * self.width_nm;
        if self.at_nm - band.min_nm() < clear || band.max_nm() - self.at_nm < clear {
            return self.integrate(band, &series.on_band());
        }
        let sigma = self.width_nm / FWHM_IN_SIGMAS;
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

/// What is left of a basis function's height when it is seen through a Gaussian.
fn damping(basis: Basis, index: usize, band: Band, sigma_nm: f64) -> f64 {
    let turns = match basis {
        Basis::Fourier => 2.0 * index.div_ceil(2) as f64,
        Basis::Cosine => index as f64,
    };
    let t = PI * turns * sigma_nm / band.length_nm();
    (-0.5 * t * t).exp()
}

/// A spectrum as a smooth series and lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Composite {
    /// The smooth part.
    pub smooth: Series,
    /// The lines, by rising wavelength.
    pub spikes: Vec<Spike>,
}

impl From<crate::spectrum::Composite> for Composite {
    fn from(ideal: crate::spectrum::Composite) -> Self {
        Self::with_widths(ideal, &[])
    }
}

impl Composite {
    /// A composite whose lines have these widths, nm; 0, or none given, is ideal.
    pub fn with_widths(centres: crate::spectrum::Composite, widths_nm: &[f64]) -> Self {
        let widths_nm = widths_nm.iter().copied().chain(std::iter::repeat(0.0));
        let line = |(s, width_nm): (&IdealSpike, f64)| Spike {
            at_nm: s.at_nm,
            weight: s.weight,
            width_nm,
        };
        Self {
            spikes: centres.spikes.iter().zip(widths_nm).map(line).collect(),
            smooth: centres.smooth,
        }
    }

    /// The band of the model.
    pub fn band(&self) -> Band {
        self.smooth.band
    }

    /// How many numbers the model takes: one each coefficient, two each line, whose place and width
    /// share one number (LINES.md section 2); one more, the label, as soon as a line has a width.
    pub fn numbers(&self) -> usize {
        let label = usize::from(self.spikes.iter().any(|s| !s.is_ideal()));
        self.smooth.coefficients.len() + 2 * self.spikes.len() + label
    }

    /// The same composite with every line at its centre and of no width.
    pub fn idealised(&self) -> crate::spectrum::Composite {
        let centre = |s: &Spike| IdealSpike {
            at_nm: s.at_nm,
            weight: s.weight,
        };
        crate::spectrum::Composite {
            smooth: self.smooth.clone(),
            spikes: self.spikes.iter().map(centre).collect(),
        }
    }

    /// Integral of the spectrum times a weight over the band, in value x nm: the smooth part and
    /// lines with a width are summed on the 1 nm trapezoid grid, an ideal spike weighs the function
    /// exactly where it stands.
    pub fn integrate(&self, weight: impl Fn(f64) -> f64) -> f64 {
        let band = self.band();
        let weights: Vec<f64> = band.grid().map(&weight).collect();
        let lines: f64 = self
            .spikes
            .iter()
            .filter(|s| band.contains(s.at_nm))
            .map(|s| {
                if s.is_ideal() {
                    s.weight * weight(s.at_nm)
                } else {
                    s.integrate(band, &weights)
                }
            })
            .sum();
        band.inner(&self.smooth.on_band(), &weights) + lines
    }

    /// Total power over the band: the exact integral of the series and the lines' weights.
    pub fn power(&self) -> f64 {
        let band = self.band();
        let lines = self.spikes.iter().filter(|s| band.contains(s.at_nm));
        self.smooth.integral() + lines.map(|s| s.weight).sum::<f64>()
    }

    /// Values on the band's grid.
    pub fn on_band(&self) -> Vec<f64> {
        let mut values = self.smooth.on_band();
        add_spikes(self.band(), &self.spikes, &mut values);
        values
    }

    /// X, Y, Z from grid weights (colour-matching functions, times a light for what it falls on),
    /// in value x nm.
    pub fn xyz(&self, weights: &Weights) -> [f64; 3] {
        let (band, smooth) = (self.band(), self.smooth.on_band());
        let own: [f64; 3] = weights.each_ref().map(|row| band.inner(&smooth, row));
        self.spikes.iter().fold(own, |sum, line| {
            let of_line = if line.is_ideal() {
                weights.at(line.at_nm).map(|v| v * line.weight)
            } else {
                weights.each_ref().map(|row| line.integrate(band, row))
            };
            std::array::from_fn(|k| sum[k] + of_line[k])
        })
    }

    /// The light times a factor on the grid: values (lines that have a width among them, so that a
    /// factor narrower than a line is seen as it is) and the ideal spikes, weighed.
    pub fn times_on_grid(&self, factor: &[f64]) -> (Vec<f64>, Vec<Spike>) {
        let band = self.band();
        let (ideal, wide): (Vec<Spike>, Vec<Spike>) =
            self.spikes.iter().partition(|s| s.is_ideal());
        let mut values = self.smooth.on_band();
        add_spikes(band, &wide, &mut values);
        for (value, factor) in values.iter_mut().zip(factor) {
            *value *= factor;
        }
        let weighed = ideal.into_iter().map(|s| Spike {
            weight: s.integrate(band, factor),
            ..s
        });
        (values, weighed.collect())
    }

    /// The light times a smooth factor of its own band and basis: the smooth parts as in
    /// [`crate::spectrum::product::resampled`], each line keeps place and width and is weighed in
    /// closed form (Eq. 17 with damping). Exact in power; a line's own skew is left out.
    pub fn times_series(&self, factor: &Series, sampling: Sampling) -> Self {
        let smooth_only = crate::spectrum::Composite {
            smooth: self.smooth.clone(),
            spikes: Vec::new(),
        };
        Self {
            smooth: product::resampled(&smooth_only, factor, sampling).smooth,
            spikes: weigh_spikes(&self.spikes, factor),
        }
    }
}

/// Lines weighed by a smooth factor, in closed form.
pub fn weigh_spikes(spikes: &[Spike], factor: &Series) -> Vec<Spike> {
    let weighed = |s: &Spike| Spike {
        weight: s.integrate_series(factor),
        ..*s
    };
    spikes.iter().map(weighed).collect()
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
    use crate::color::Observer;

    const BAND: Band = Band::VISIBLE;

    fn series(basis: Basis) -> Series {
        Series {
            band: BAND,
            basis,
            coefficients: (0..21)
                .map(|n| (0.7_f64).powi(n) * if n % 3 == 0 { 1.0 } else { -0.6 })
                .collect(),
        }
    }

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

    #[test]
    fn the_closed_form_is_the_sum_on_the_grid() {
        for basis in Basis::ALL {
            let series = series(basis);
            let values = series.on_band();
            for at_nm in [480.0, 546.07, 611.3] {
                for width_nm in [3.0, 8.0, 20.0, 38.0] {
                    let line = Spike {
                        at_nm,
                        weight: 2.0,
                        width_nm,
                    };
                    let (closed, summed) = (
                        line.integrate_series(&series),
                        line.integrate(BAND, &values),
                    );
                    // The end cuts off less than 3e-9 of the area; a Gaussian of 3 nm sampled each
                    // nm is off by exp(-2 pi^2 sigma^2) = 1e-14.
                    assert!(
                        (closed - summed).abs() < 2e-8,
                        "{basis:?} {at_nm} {width_nm}: {closed} {summed}"
                    );
                }
            }
        }
    }

    #[test]
    fn without_width_everything_is_as_in_the_ideal_composite() {
        let ideal = crate::spectrum::Composite {
            smooth: series(Basis::Cosine),
            spikes: vec![
                IdealSpike {
                    at_nm: 435.84,
                    weight: 0.4,
                },
                IdealSpike {
                    at_nm: 546.07,
                    weight: 1.5,
                },
            ],
        };
        let wide = Composite::from(ideal.clone());
        assert_eq!(wide.idealised(), ideal);
        assert_eq!(wide.on_band(), ideal.on_band());
        assert_eq!(wide.numbers(), ideal.numbers());
        assert_eq!(wide.power(), ideal.power());
        let factor = series(Basis::Cosine);
        let (ours, theirs) = (
            wide.times_series(&factor, Sampling::Double),
            product::resampled(&ideal, &factor, Sampling::Double),
        );
        assert_eq!(ours.idealised(), theirs);
        let seen = Observer::Cie1931.table().on_band(BAND);
        let weighed =
            crate::color::xyz_of_parts(BAND, &ideal.smooth.on_band(), &ideal.spikes, &seen);
        for (a, b) in wide.xyz(&seen).iter().zip(weighed.to_array()) {
            // The same products in another order.
            assert!((a - b).abs() < 1e-12 * b.abs().max(1.0));
        }
    }

    #[test]
    fn behind_a_filter_narrower_than_the_line_the_line_is_cut_to_the_filter() {
        let dark = Series {
            band: BAND,
            basis: Basis::Cosine,
            coefficients: vec![0.0],
        };
        let light = Composite {
            smooth: dark,
            spikes: vec![Spike {
                at_nm: 546.0,
                weight: 1.0,
                width_nm: 40.0,
            }],
        };
        let filter: Vec<f64> = BAND
            .grid()
            .map(|nm| (-4.0 * LN_2 * ((nm - 546.0) / 4.0).powi(2)).exp())
            .collect();
        let (values, ideal) = light.times_on_grid(&filter);
        assert!(ideal.is_empty());
        // Gaussian times Gaussian: widths add as 1/w^2, heights multiply.
        let width = 1.0 / (1.0_f64 / 1600.0 + 1.0 / 16.0).sqrt();
        let expected = width / 40.0;
        assert!((BAND.integral(&values) - expected).abs() < 1e-9 * expected);
    }

    #[test]
    fn the_integral_of_a_weight_is_that_of_the_values() {
        let light = Composite {
            smooth: series(Basis::Fourier),
            spikes: vec![
                Spike::ideal(436.0, 0.5),
                Spike {
                    at_nm: 590.0,
                    weight: 0.8,
                    width_nm: 12.0,
                },
            ],
        };
        let weight = |nm: f64| (nm / 50.0).sin();
        let weights: Vec<f64> = BAND.grid().map(weight).collect();
        // The ideal spike stands on a grid point.
        assert!((light.integrate(weight) - BAND.inner(&light.on_band(), &weights)).abs() < 1e-11);
    }
}
