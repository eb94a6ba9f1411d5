//! The wavelength range of a model and its 1 nm trapezoid grid.

use serde::{Deserialize, Serialize};

use crate::languages::with_sign;

/// Shortest range that a model may have, in nm.
pub(crate) const SHORTEST_NM: u32 = 20;

/// Longest wavelength that a range may reach, in nm.
///
/// Far beyond any light source a person would load; it bounds memory when a range is typed.
pub(crate) const LONGEST_NM: u32 = 100_000;

/// Most 1 nm steps in one range: 20 000 nm, so that no typed range can fill the memory.
pub(crate) const MOST_STEPS: u32 = 20_000;

/// A closed range of whole nanometres, `[min, max]`, with one grid point each nm.
///
/// Fits and comparisons all use this grid with trapezoid weights, so that a comparison measures
/// the model and not the quadrature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(try_from = "[f64; 2]", into = "[f64; 2]")]
pub struct Band {
    min_nm: u32,
    max_nm: u32,
}

/// Why a range was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BandError {
    /// A bound is not a whole, non-negative number of nm.
    #[error(
        "{}",
        tr!("range: expected whole nm, found {found}", found = with_sign(found.to_string()))
    )]
    NotWhole { found: f64 },
    /// The range is shorter than `SHORTEST_NM` (or runs backwards).
    #[error(
        "{}",
        tr!(
            "range: expected MIN:MAX, MAX at least {shortest} nm above MIN, found \
             {min_nm}:{max_nm}",
            shortest = SHORTEST_NM,
            min_nm = with_sign(min_nm.to_string()),
            max_nm = with_sign(max_nm.to_string())
        )
    )]
    TooShort { min_nm: f64, max_nm: f64 },
    /// The range is longer than `MOST_STEPS` or ends beyond `LONGEST_NM`.
    #[error(
        "{}",
        tr!(
            "range: expected at most {most} nm below {longest} nm, found {min_nm}:{max_nm}",
            most = MOST_STEPS,
            longest = LONGEST_NM,
            min_nm = with_sign(min_nm.to_string()),
            max_nm = with_sign(max_nm.to_string())
        )
    )]
    TooLong { min_nm: f64, max_nm: f64 },
}

impl TryFrom<[f64; 2]> for Band {
    type Error = BandError;

    fn try_from([min_nm, max_nm]: [f64; 2]) -> Result<Self, BandError> {
        Self::new(min_nm, max_nm)
    }
}

impl From<Band> for [f64; 2] {
    fn from(band: Band) -> Self {
        [band.min_nm(), band.max_nm()]
    }
}

impl Band {
    /// The program's default range, 380-780 nm.
    pub const VISIBLE: Self = Self {
        min_nm: 380,
        max_nm: 780,
    };

    /// The range of the paper's own tables, 400-700 nm.
    pub const PAPER: Self = Self {
        min_nm: 400,
        max_nm: 700,
    };

    /// A range from whole nanometres.
    ///
    /// # Errors
    /// [`BandError`] when a bound is not whole or the range is too short or too long.
    pub fn new(min_nm: f64, max_nm: f64) -> Result<Self, BandError> {
        for found in [min_nm, max_nm] {
            if !found.is_finite() || found.fract() != 0.0 || found < 0.0 {
                return Err(BandError::NotWhole { found });
            }
        }
        if max_nm - min_nm < f64::from(SHORTEST_NM) {
            return Err(BandError::TooShort { min_nm, max_nm });
        }
        if max_nm > f64::from(LONGEST_NM) || max_nm - min_nm > f64::from(MOST_STEPS) {
            return Err(BandError::TooLong { min_nm, max_nm });
        }
        Ok(Self {
            min_nm: min_nm as u32,
            max_nm: max_nm as u32,
        })
    }

    /// The allowed range nearest to one that was asked for, its beginning kept where it can be;
    /// `None` when an end is not a number.
    pub fn nearest([one_nm, other_nm]: [f64; 2]) -> Option<Self> {
        if !(one_nm.is_finite() && other_nm.is_finite()) {
            return None;
        }
        let (shortest, most) = (f64::from(SHORTEST_NM), f64::from(MOST_STEPS));
        let longest = f64::from(LONGEST_NM);
        let min_nm = one_nm.min(other_nm).round().clamp(0.0, longest - shortest);
        let max_nm = one_nm.max(other_nm).round();
        let max_nm = max_nm.clamp(min_nm + shortest, (min_nm + most).min(longest));
        Self::new(min_nm, max_nm).ok()
    }

    /// First wavelength, nm.
    pub fn min_nm(self) -> f64 {
        f64::from(self.min_nm)
    }

    /// Last wavelength, nm.
    pub fn max_nm(self) -> f64 {
        f64::from(self.max_nm)
    }

    /// `L = max - min`, nm.
    pub(crate) fn length_nm(self) -> f64 {
        f64::from(self.max_nm - self.min_nm)
    }

    /// Number of 1 nm steps, which is `L`.
    pub fn steps(self) -> usize {
        (self.max_nm - self.min_nm) as usize
    }

    /// Number of grid points, `L + 1`.
    pub fn points(self) -> usize {
        self.steps() + 1
    }

    /// Wavelength of grid point `index`, nm.
    pub fn nm(self, index: usize) -> f64 {
        self.min_nm() + index as f64
    }

    /// All grid wavelengths in rising order, nm.
    pub fn grid(self) -> impl ExactSizeIterator<Item = f64> + Clone {
        (0..self.points()).map(move |i| self.nm(i))
    }

    /// True if a wavelength lies in the closed range.
    pub fn contains(self, at_nm: f64) -> bool {
        (self.min_nm()..=self.max_nm()).contains(&at_nm)
    }

    /// Trapezoid weight of grid point `index` in nm: 1 inside, 1/2 at both ends.
    pub fn weight(self, index: usize) -> f64 {
        if index == 0 || index == self.steps() {
            0.5
        } else {
            1.0
        }
    }

    /// Trapezoid integral of values on this grid, in value x nm.
    ///
    /// # Panics
    /// When `values` does not have [`Band::points`] entries.
    pub fn integral(self, values: &[f64]) -> f64 {
        assert_eq!(values.len(), self.points(), "one value per grid point");
        values.iter().sum::<f64>() - 0.5 * (values[0] + values[values.len() - 1])
    }

    /// Trapezoid integral of the product of two functions on this grid.
    ///
    /// # Panics
    /// When a slice does not have [`Band::points`] entries.
    pub fn inner(self, a: &[f64], b: &[f64]) -> f64 {
        assert!(a.len() == self.points() && b.len() == self.points());
        let last = a.len() - 1;
        dot(a, b) - 0.5 * (a[0] * b[0] + a[last] * b[last])
    }

    /// Value between grid points by straight lines; zero outside the range.
    pub fn interpolate(self, values: &[f64], at_nm: f64) -> f64 {
        if !self.contains(at_nm) {
            return 0.0;
        }
        let x = at_nm - self.min_nm();
        let i = (x as usize).min(self.steps() - 1);
        let t = x - i as f64;
        values[i] * (1.0 - t) + values[i + 1] * t
    }
}

/// Sum of products, in eight running sums so that the compiler can use vector registers.
pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    const LANES: usize = 8;
    let mut sums = [0.0; LANES];
    let (a_chunks, b_chunks) = (a.chunks_exact(LANES), b.chunks_exact(LANES));
    let rest: f64 = a_chunks
        .remainder()
        .iter()
        .zip(b_chunks.remainder())
        .map(|(x, y)| x * y)
        .sum();
    for (x, y) in a_chunks.zip(b_chunks) {
        for lane in 0..LANES {
            sums[lane] += x[lane] * y[lane];
        }
    }
    rest + sums.iter().sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_range_is_one_that_is_allowed_and_an_allowed_one_is_itself() {
        for (asked, nearest) in [
            ([380.0, 780.0], [380.0, 780.0]),
            ([380.4, 780.5], [380.0, 781.0]),
            ([780.0, 380.0], [380.0, 780.0]),
            ([0.0, 1e9], [0.0, 20_000.0]),
            ([-5.0, 400.0], [0.0, 400.0]),
            ([400.0, 410.0], [400.0, 420.0]),
            ([1e300, 1e301], [99_980.0, 100_000.0]),
            ([-1e300, 1e300], [0.0, 20_000.0]),
        ] {
            let band = Band::nearest(asked).expect("numbers");
            assert_eq!(<[f64; 2]>::from(band), nearest, "asked for {asked:?}");
        }
        for nothing in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(Band::nearest([nothing, 780.0]), None);
            assert_eq!(Band::nearest([380.0, nothing]), None);
        }
    }
}
