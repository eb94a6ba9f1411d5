//! Light times reflectance: smooth parts multiplied, spikes weighed by the factor where they stand.
//!
//! ```text
//! (S1 + sum w d(l - lm)) S2 = S1 S2 + sum S2(lm) w d(l - lm)        (Eq. 14)
//! ```

#[cfg(test)]
use super::line::add_lines;
use super::{
    band::Band, basis::Basis, composite::Composite, line::Line, resampled::Resampled,
    resampled::SampleGrid, resampled::Sampling, series::Series,
};

/// A light as the model has it, times a factor as measured, on the 1 nm grid: values, with the lines
/// that have a width among them, so that a factor narrower than a line is seen as it is; and the
/// ideal lines, which read the factor off the straight line between its two neighbouring nm.
///
/// `factor` holds values on the light's band.
///
/// # Panics
/// When `factor` does not have one value per grid point of the light's band.
#[cfg(test)]
pub(crate) fn on_grid(light: &Composite, factor: &[f64]) -> (Vec<f64>, Vec<Line>) {
    let band = light.band();
    assert_eq!(factor.len(), band.points(), "one value per grid point");
    let (ideal, wide): (Vec<Line>, Vec<Line>) =
        light.lines().iter().partition(|line| line.is_ideal());
    let mut values = light.smooth().on_band();
    add_lines(band, &wide, &mut values);
    let lit = multiply(&values, factor);
    (lit, weigh_lines(&ideal, |nm| band.interpolate(factor, nm)))
}

/// Why a composite and a factor have no product.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ProductError {
    /// They stand on different bands.
    #[error(
        "{}",
        tr!(
            "a light on {light} nm and a factor on {factor} nm have no product: one band is \
             expected",
            light = ends(*light),
            factor = ends(*factor)
        )
    )]
    Bands {
        /// The light's.
        light: Band,
        /// The factor's.
        factor: Band,
    },
    /// They are series of different functions.
    #[error("{}", two_bases(*light, *factor))]
    Bases {
        /// The light's.
        light: Basis,
        /// The factor's.
        factor: Basis,
    },
    /// The factor has no coefficient.
    #[error("{}", said!("the factor has no coefficient"))]
    NoCoefficient,
}

fn ends(band: Band) -> String {
    format!("{}-{}", band.min_nm(), band.max_nm())
}

fn two_bases(light: Basis, factor: Basis) -> String {
    let words = match (light, factor) {
        (Basis::Fourier, Basis::Cosine) => {
            said!("a fourier series and a cosine series have no product: one basis is expected")
        }
        (Basis::Cosine, Basis::Fourier) => {
            said!("a cosine series and a fourier series have no product: one basis is expected")
        }
        (one, other) => {
            let (one, other) = (one.word(), other.word());
            return format!(
                "a {one} series and a {other} series have no product: one basis is expected"
            );
        }
    };
    words.to_owned()
}

impl Composite {
    /// The light behind a smooth factor (a filter, a surface), every order of the product kept and
    /// each line weighed by the factor over its own width.
    ///
    /// ```
    /// use spectral_explorer::spectrum::{Band, Basis, Composite, Line, Series};
    ///
    /// let series = |coefficients: Vec<f64>| Series {
    ///     band: Band::VISIBLE,
    ///     basis: Basis::Cosine,
    ///     coefficients,
    /// };
    /// let lamp = Composite::new(series(vec![2.0, 0.5]), vec![Line::ideal(546.1, 30.0)])?;
    /// let grey = lamp.times(&series(vec![0.5])).expect("one band and one basis");
    /// assert_eq!(grey.lines()[0].weight, 15.0);
    /// assert_eq!(grey.smooth().coefficients, [1.0, 0.25]);
    /// # Ok::<(), spectral_explorer::spectrum::CompositeError>(())
    /// ```
    ///
    /// # Errors
    /// [`ProductError`] where band or basis differ.
    pub fn times(&self, factor: &Series) -> Result<Self, ProductError> {
        let light = self.smooth();
        if light.band != factor.band {
            let (light, factor) = (light.band, factor.band);
            return Err(ProductError::Bands { light, factor });
        }
        if light.basis != factor.basis {
            let (light, factor) = (light.basis, factor.basis);
            return Err(ProductError::Bases { light, factor });
        }
        if factor.coefficients.is_empty() || light.coefficients.is_empty() {
            return Err(ProductError::NoCoefficient);
        }
        Ok(resampled(self, factor, Sampling::Exact))
    }
}

/// A light times a smooth factor by resampling: the composite through the products of the points.
///
/// Both series share band and basis; the result has one number per point. With
/// [`Sampling::Convolution`] it has as many numbers as the longer factor, with
/// [`Sampling::Exact`] every order of the product is kept, both by coefficient convolution.
///
/// # Panics
/// When the two differ in band or basis, or one has no coefficient.
pub fn resampled(light: &Composite, factor: &Series, sampling: Sampling) -> Composite {
    let light_series = light.smooth();
    assert_alike(light_series, factor);
    let numbers = (light_series.coefficients.len()).max(factor.coefficients.len());
    let whole = || convolve(light_series, factor);
    let smooth = match (sampling, sampling.points(numbers)) {
        (_, Some(points)) => {
            let grid = SampleGrid::new(light.band(), light_series.basis, points);
            let product = multiply(&grid.sample(light_series), &grid.sample(factor));
            grid.series(&product)
        }
        (Sampling::Convolution, None) => whole().truncated(numbers),
        (_, None) => whole(),
    };
    Composite::of_lines_inside(smooth, weighed_by_series(light.lines(), factor))
}

/// A chain of factors on one grid, never truncated in between.
///
/// # Panics
/// When a factor differs from the light in band or basis, one of them has no coefficient, or
/// `points` is 0.
pub fn chain(light: &Composite, factors: &[Series], points: usize) -> Resampled {
    assert!(points > 0, "a point at least");
    factors
        .iter()
        .for_each(|factor| assert_alike(light.smooth(), factor));
    let grid = SampleGrid::new(light.band(), light.smooth().basis, points);
    let mut values = grid.sample(light.smooth());
    let mut spikes = light.lines().to_vec();
    for factor in factors {
        values = multiply(&values, &grid.sample(factor));
        spikes = weighed_by_series(&spikes, factor);
    }
    Resampled {
        grid,
        values,
        spikes,
    }
}

/// Points for a chain: twice the numbers, four times from the fifth factor on when there are few
/// numbers: measured on chains of up to eight reflections.
pub(crate) fn chain_points(numbers: usize, factors: usize) -> usize {
    if factors >= 5 && numbers <= 15 {
        4 * numbers
    } else {
        2 * numbers
    }
}

/// Every order of the product of two series, by convolution of their coefficients, O(N^2).
///
/// The result has order 2N (`4N + 1` numbers).
///
/// # Panics
/// When the two differ in band or basis, or one has no coefficient.
pub(crate) fn convolve(a: &Series, b: &Series) -> Series {
    assert_alike(a, b);
    let coefficients = a.basis.product(&a.coefficients, &b.coefficients);
    Series::new(a.band, a.basis, coefficients)
}

/// Coefficients of another band or basis mean other functions: their product would be a number
/// without a meaning.
fn assert_alike(a: &Series, b: &Series) {
    assert_eq!(a.band, b.band, "two series of one band");
    assert_eq!(a.basis, b.basis, "two series of one basis");
    let is_empty = a.coefficients.is_empty() || b.coefficients.is_empty();
    assert!(!is_empty, "a coefficient at least");
}

/// Two curves on the same grid, multiplied.
pub(crate) fn multiply(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| a * b).collect()
}

/// Eq. 16 for a count of points that is known when the program is built: no allocation, no test
/// of a length, so that the compiler writes it out in vector registers.
#[inline]
pub fn multiply_points<const POINTS: usize>(
    a: &[f64; POINTS],
    b: &[f64; POINTS],
    out: &mut [f64; POINTS],
) {
    for i in 0..POINTS {
        out[i] = a[i] * b[i];
    }
}

/// Lines weighed by a factor at their centres (Eq. 14).
pub(crate) fn weigh_lines(lines: &[Line], factor_at: impl Fn(f64) -> f64) -> Vec<Line> {
    let weighed = |line: &Line| line.weighing(line.weight * factor_at(line.at_nm));
    lines.iter().map(weighed).collect()
}

/// Lines weighed by a smooth factor, each over its own width, in closed form (Eq. 17 with damping).
/// Exact in power; a line's own skew is left out.
pub(crate) fn weighed_by_series(lines: &[Line], factor: &Series) -> Vec<Line> {
    let weighed = |line: &Line| line.weighing(line.integrate_series(factor));
    lines.iter().map(weighed).collect()
}

/// Power of a product that the sample grid folds back, as a share of the product's power.
///
/// Zero when the grid has room for every order.
pub fn folded_share(a: &Series, b: &Series, points: usize) -> f64 {
    share_above(&convolve(a, b), points)
}

/// The same for a chain: behind each factor in turn, the share of the power of the whole product
/// so far that `points` points fold back.
pub(crate) fn folded_shares(light: &Series, factors: &[Series], points: usize) -> Vec<f64> {
    let mut product = in_units(light);
    factors
        .iter()
        .map(|factor| {
            product = in_units(&convolve(&product, &in_units(factor)));
            share_above(&product, points)
        })
        .collect()
}

/// A series as shares of its largest coefficient, so that no square overflows or vanishes.
pub(crate) fn in_units(series: &Series) -> Series {
    let top = series
        .coefficients
        .iter()
        .fold(0.0_f64, |m, c| m.max(c.abs()));
    let unit = Some(1.0 / top)
        .filter(|unit| unit.is_finite())
        .unwrap_or(1.0);
    Series {
        coefficients: series.coefficients.iter().map(|c| c * unit).collect(),
        ..*series
    }
}

/// Share of a series' power beyond its first `kept` numbers.
fn share_above(series: &Series, kept: usize) -> f64 {
    let band: Band = series.band;
    let power = |from: usize| -> f64 {
        series
            .coefficients
            .iter()
            .enumerate()
            .skip(from)
            .map(|(k, c)| c * c * series.basis.norm_squared(k, band))
            .sum()
    };
    let all = power(0);
    // An empty sum is minus zero.
    let above = 0.0 + power(kept.min(series.coefficients.len()));
    if all > 0.0 { above / all } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    #[test]
    fn behind_a_filter_narrower_than_the_line_the_line_is_cut_to_the_filter() {
        let dark = Series::new(BAND, Basis::Cosine, vec![0.0]);
        let line = Line::new(546.0, 1.0, 40.0);
        let light = Composite::of_lines_inside(dark, vec![line]);
        let filter: Vec<f64> = BAND
            .grid()
            .map(|nm| (-4.0 * std::f64::consts::LN_2 * ((nm - 546.0) / 4.0).powi(2)).exp())
            .collect();
        let (values, ideal) = on_grid(&light, &filter);
        assert!(ideal.is_empty());
        // Gaussian times Gaussian: widths add as 1/w^2, heights multiply.
        let width = 1.0 / (1.0_f64 / 1600.0 + 1.0 / 16.0).sqrt();
        let expected = width / 40.0;
        assert!((BAND.integral(&values) - expected).abs() < 1e-9 * expected);
    }

    #[test]
    fn times_one_is_the_light_itself() {
        for basis in Basis::ALL {
            let one = Series::new(BAND, basis, vec![1.0 / basis.mean(1.0)]);
            let smooth = Series::new(BAND, basis, vec![1.5, -0.3, 0.2]);
            let lines = [(436.0, 0.0), (546.07, 3.0), (779.5, 8.0)]
                .map(|(at_nm, fwhm_nm)| Line::new(at_nm, 2.0, fwhm_nm));
            let light = Composite::of_lines_inside(smooth, lines.to_vec());
            let product = resampled(&light, &one, Sampling::Exact);
            for (a, b) in product.lines().iter().zip(light.lines()) {
                // Sums of at most 401 products.
                assert!((a.weight - b.weight).abs() < 1e-12, "{a:?} {b:?}");
                assert_eq!((a.at_nm, a.fwhm_nm), (b.at_nm, b.fwhm_nm));
            }
            for (a, b) in product.on_band().iter().zip(light.on_band()) {
                assert!((a - b).abs() < 1e-12);
            }
        }
    }
}
