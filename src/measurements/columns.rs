//! Measurements on a grid, and columns of values with their slopes against each of them.

use super::{measurement::Measurement, union::Union};

/// The inputs on a grid.
pub(super) struct Grid<'m> {
    pub nm: &'m [f64],
    pub inputs: Vec<Option<OnGrid<'m>>>,
}

/// One input on a grid.
pub(super) struct OnGrid<'m> {
    pub of: &'m Measurement,
    pub values: Vec<f64>,
    pub sigma: Vec<f64>,
    /// Points that lie at or beside a sample without a value.
    pub masked: Vec<bool>,
    /// Grid points to a sample.
    pub points_a_sample: f64,
}

impl<'m> Grid<'m> {
    pub(super) fn new(union: &'m Union, inputs: &'m [Measurement], letters: &[usize]) -> Self {
        let on = |of: &'m Measurement| {
            let places = union.places(of.samples.nm());
            let own = of.samples.values();
            let value =
                |(left, share): &(usize, f64)| own[*left] * (1.0 - share) + own[left + 1] * share;
            let is_masked = |(left, share): &(usize, f64)| {
                *share < 1.0 && !of.is_kept(*left) || *share > 0.0 && !of.is_kept(left + 1)
            };
            let samples = match (places.first(), places.last()) {
                (Some(a), Some(b)) => (b.0 as f64 + b.1) - (a.0 as f64 + a.1),
                _ => 1.0,
            };
            OnGrid {
                of,
                values: places.iter().map(value).collect(),
                sigma: places
                    .iter()
                    .map(|(left, share)| of.sigma_at(*left, *share))
                    .collect(),
                masked: places.iter().map(is_masked).collect(),
                points_a_sample: (union.nm.len() - 1) as f64 / samples,
            }
        };
        let is_used = |index: &usize| letters.contains(index);
        Self {
            nm: &union.nm,
            inputs: (0..inputs.len())
                .map(|index| is_used(&index).then(|| on(&inputs[index])))
                .collect(),
        }
    }

    pub(super) fn used(&self) -> impl Iterator<Item = (usize, &OnGrid<'m>)> {
        let all = self.inputs.iter().enumerate();
        all.filter_map(|(index, input)| Some((index, input.as_ref()?)))
    }
}

/// Values on a grid, and their slopes against each input.
#[derive(Clone)]
pub(super) struct Column {
    pub values: Vec<f64>,
    pub slopes: Vec<Option<Vec<f64>>>,
}

impl Column {
    /// Covariance of every value with those of another column by the white noise of the inputs.
    pub(super) fn covariance(&self, other: &Self, grid: &Grid) -> Vec<f64> {
        let mut found = vec![0.0; self.values.len()];
        for (index, input) in grid.used() {
            if let (Some(a), Some(b)) = (&self.slopes[index], &other.slopes[index]) {
                for (i, sum) in found.iter_mut().enumerate() {
                    *sum += a[i] * b[i] * input.sigma[i].powi(2);
                }
            }
        }
        found
    }

    /// Standard deviation of every value by the white noise of the inputs.
    pub(super) fn sigma(&self, grid: &Grid) -> Vec<f64> {
        let mut variance = vec![0.0; self.values.len()];
        for (index, input) in grid.used() {
            let Some(slopes) = &self.slopes[index] else {
                continue;
            };
            for ((v, slope), sigma) in variance.iter_mut().zip(slopes).zip(&input.sigma) {
                *v += (slope * sigma).powi(2);
            }
        }
        variance.into_iter().map(f64::sqrt).collect()
    }

    /// The same function of these values, by its slope at each.
    pub(super) fn through(self, of: impl Fn(f64) -> [f64; 2]) -> Self {
        let both: Vec<[f64; 2]> = self.values.iter().map(|v| of(*v)).collect();
        let chain = |slopes: Vec<f64>| slopes.iter().zip(&both).map(|(s, b)| s * b[1]).collect();
        Self {
            values: both.iter().map(|b| b[0]).collect(),
            slopes: self.slopes.into_iter().map(|s| s.map(chain)).collect(),
        }
    }

    /// A function of two values, by its slopes against either.
    pub(super) fn with(self, other: Self, of: impl Fn(f64, f64) -> [f64; 3]) -> Self {
        let pairs = self.values.iter().zip(&other.values);
        let all: Vec<[f64; 3]> = pairs.map(|(a, b)| of(*a, *b)).collect();
        let chain = |slopes: &Option<Vec<f64>>, k: usize| -> Option<Vec<f64>> {
            let slopes = slopes.as_ref()?.iter();
            Some(slopes.zip(&all).map(|(s, f)| s * f[k]).collect())
        };
        let both = self.slopes.iter().zip(&other.slopes);
        let slopes = both.map(|(a, b)| match (chain(a, 1), chain(b, 2)) {
            (Some(a), Some(b)) => Some(a.iter().zip(b).map(|(a, b)| a + b).collect()),
            (a, b) => a.or(b),
        });
        Self {
            slopes: slopes.collect(),
            values: all.iter().map(|f| f[0]).collect(),
        }
    }
}
