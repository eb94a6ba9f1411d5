//! Series sampled on a few points, where a product is one multiplication a point.
//!
//! The product of two series of order N has order 2N. On the paper's 2N+1 independent points it
//! aliases; 3N+1 points (for an odd N 3N+2) keep orders up to N exact and 4N+1 keep all of them. The cosine basis
//! samples on midpoints, `min + (j + 1/2) L / M`.

#[cfg(test)]
use super::composite::Composite;
use super::{band::Band, basis::Basis, line::Line, series::Series};

/// Number of points on which a product is formed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Sampling {
    /// The paper's points: as many as there are numbers, 2N+1 independent ones.
    Paper,
    /// 3N+1 points (Fourier; the next odd count where that is even): orders up to N exact.
    #[serde(rename = "3n")]
    ThreeN,
    /// 4N+1 points (Fourier): every order of one product exact.
    #[serde(rename = "4n")]
    FourN,
    /// Twice as many points as there are numbers: the default for chains.
    Double,
    /// No points: the coefficients convolved and cut back to as many as there were.
    Convolution,
    /// No resampling: the product on the 1 nm grid with the factor as measured.
    Exact,
}

impl Sampling {
    /// Every way: those on few points, coarsest first, then those without.
    pub const ALL: [Self; 6] = [
        Self::Paper,
        Self::ThreeN,
        Self::FourN,
        Self::Double,
        Self::Convolution,
        Self::Exact,
    ];

    /// The word used on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Paper => "paper",
            Self::ThreeN => "3n",
            Self::FourN => "4n",
            Self::Double => "double",
            Self::Convolution => "convolution",
            Self::Exact => "exact",
        }
    }

    /// The ways on few points that make sense in a basis: 3N+1 and 4N+1 are for periodic series.
    pub(crate) fn on_points(basis: Basis) -> impl Iterator<Item = Self> {
        let fits = move |way: &Self| match way {
            Self::Paper | Self::Double => true,
            Self::ThreeN | Self::FourN => basis.is_periodic(),
            Self::Convolution | Self::Exact => false,
        };
        Self::ALL.into_iter().filter(fits)
    }

    /// Points for factors of `numbers` coefficients; `None` for the ways without: convolution and
    /// the 1 nm product.
    pub fn points(self, numbers: usize) -> Option<usize> {
        let order = numbers / 2;
        match self {
            Self::Paper => Some(numbers),
            // An even count would lose the sine of its highest order: the next odd one.
            Self::ThreeN => Some((3 * order + 1) | 1),
            Self::FourN => Some(4 * order + 1),
            Self::Double => Some(2 * numbers),
            Self::Convolution | Self::Exact => None,
        }
    }
}

/// The places where series of one basis are sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SampleGrid {
    /// The band sampled.
    pub band: Band,
    /// Periodic points for Fourier, midpoints for the cosine basis.
    pub basis: Basis,
    /// Number of independent points, at least one.
    pub points: usize,
}

impl SampleGrid {
    /// A grid of `points` independent points, at least one.
    pub fn new(band: Band, basis: Basis, points: usize) -> Self {
        Self {
            band,
            basis,
            points,
        }
    }

    /// Distance between neighbouring points, nm.
    pub fn step_nm(self) -> f64 {
        self.band.length_nm() / self.points as f64
    }

    /// Wavelength of sample `i`, nm. For Fourier `i = points` is the period's other end, whose
    /// value equals the first one's (Eq. 15 written with i = 0 ..= 2N+1).
    pub fn nm(self, i: usize) -> f64 {
        let offset = 0.5 * self.basis.halves_before_samples() as f64;
        self.band.min_nm() + (i as f64 + offset) * self.step_nm()
    }

    /// A series' values on the grid.
    pub fn sample(self, series: &Series) -> Vec<f64> {
        (0..self.points).map(|i| series.at(self.nm(i))).collect()
    }

    /// The series of lowest order through values on the grid: one number per point.
    pub fn series(self, values: &[f64]) -> Series {
        let m = self.points;
        let coefficients = (0..m)
            .map(|k| {
                let sum: f64 = values
                    .iter()
                    .enumerate()
                    .map(|(i, v)| v * self.basis.at_sample(k, i, self.points))
                    .sum();
                sum * self.basis.sample_scale(k, self.points)
            })
            .collect();
        Series::new(self.band, self.basis, coefficients)
    }

    /// One row per point that takes `numbers` coefficients to the value there, rows end to end.
    pub(crate) fn sampling_rows(self, numbers: usize) -> Vec<f64> {
        (0..self.points)
            .flat_map(|i| (0..numbers).map(move |k| self.basis.function(k, self.band, self.nm(i))))
            .collect()
    }

    /// One row per number that takes values on the grid to a coefficient of
    /// [`SampleGrid::series`], rows end to end.
    pub(crate) fn series_rows(self) -> Vec<f64> {
        (0..self.points)
            .flat_map(|k| {
                let scale = self.basis.sample_scale(k, self.points);
                (0..self.points).map(move |i| scale * self.basis.at_sample(k, i, self.points))
            })
            .collect()
    }

    /// Row that maps values on the grid to the value at a place of the series through them, so that
    /// weighting a spike is one sum of products.
    pub fn row_at(self, at_nm: f64) -> Vec<f64> {
        (0..self.points)
            .map(|i| {
                (0..self.points)
                    .map(|k| {
                        self.basis.function(k, self.band, at_nm)
                            * self.basis.sample_scale(k, self.points)
                            * self.basis.at_sample(k, i, self.points)
                    })
                    .sum()
            })
            .collect()
    }

    /// The matrix that takes values on the grid straight to inner products with three weights
    /// (rows by rows: point, then weight), by way of the interpolating series.
    ///
    /// `weight_products` gives the three inner products of basis function `k` (value x nm).
    pub(crate) fn product_matrix(
        self,
        weight_products: impl Fn(usize) -> [f64; 3],
    ) -> Vec<[f64; 3]> {
        let per_number: Vec<[f64; 3]> = (0..self.points).map(weight_products).collect();
        (0..self.points)
            .map(|i| {
                let mut row = [0.0; 3];
                for (k, g) in per_number.iter().enumerate() {
                    let share = self.basis.at_sample(k, i, self.points)
                        * self.basis.sample_scale(k, self.points);
                    for (r, g) in row.iter_mut().zip(g) {
                        *r += share * g;
                    }
                }
                row
            })
            .collect()
    }

    /// Eq. 17, corrected: straight line between the two samples around a place.
    pub(crate) fn linear_at(self, values: &[f64], at_nm: f64) -> f64 {
        let (left, right, t) = self.around(at_nm);
        values[left] * (1.0 - t) + values[right] * t
    }

    /// Eq. 17 as the paper prints it, with the two weights swapped.
    pub(crate) fn linear_at_as_printed(self, values: &[f64], at_nm: f64) -> f64 {
        let (left, right, t) = self.around(at_nm);
        values[left] * t + values[right] * (1.0 - t)
    }

    /// The samples on both sides of a place and how far it is from the left one (0-1).
    fn around(self, at_nm: f64) -> (usize, usize, f64) {
        let x = (at_nm - self.nm(0)) / self.step_nm();
        if self.basis.is_periodic() {
            let left = (x.max(0.0) as usize).min(self.points - 1);
            (left, (left + 1) % self.points, x - left as f64)
        } else {
            let left = (x.max(0.0) as usize).min(self.points.saturating_sub(2));
            let right = (left + 1).min(self.points - 1);
            (left, right, (x - left as f64).clamp(0.0, 1.0))
        }
    }
}

/// A spiky spectrum on a sample grid: values and spikes side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Resampled {
    /// Sample grid of the values.
    pub grid: SampleGrid,
    /// One value per point.
    pub values: Vec<f64>,
    /// Spikes, carried exactly.
    pub spikes: Vec<Line>,
}

impl Resampled {
    /// Integral of the spectrum times a weight over the band, in value x nm.
    ///
    /// The values stand for the series of lowest order through them, which is summed on the 1 nm
    /// trapezoid grid; each spike weighs the function exactly where it stands.
    #[cfg(test)]
    pub(crate) fn integrate(&self, weight: impl Fn(f64) -> f64) -> f64 {
        let composite =
            Composite::of_lines_inside(self.grid.series(&self.values), self.spikes.clone());
        composite.integrate(weight)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_resampled_composite_weighs_as_the_composite_did() {
        for basis in Basis::ALL {
            let composite = Composite::of_lines_inside(
                Series::new(Band::VISIBLE, basis, vec![3.0, -1.0, 0.5, 0.25, 0.125]),
                vec![Line::ideal(546.1, 20.0)],
            );
            let grid = SampleGrid::new(Band::VISIBLE, basis, 9);
            let resampled = Resampled {
                grid,
                values: grid.sample(composite.smooth()),
                spikes: composite.lines().to_vec().clone(),
            };
            let weight = |nm: f64| 1.0 + 1e-3 * nm;
            // 401 products of numbers near 5, through a transform of nine points.
            let (found, expected) = (resampled.integrate(weight), composite.integrate(weight));
            assert!((found - expected).abs() < 1e-10, "{found} {expected}");
        }
    }
}
