//! Time of one product on this machine, by every way of forming it.
//!
//! Measured is the multiplication alone, as in a chain that runs: values already stand on the
//! points, the factor is already read where the spikes are, all numbers are in the cache, and one
//! thread works. A convolution is the program's own, the new coefficients' memory included. The
//! values do not matter to the time, so made-up ones do. After a warm-up each way is run in
//! `BATCHES` batches of at least `BATCH`; the figure is the median batch.

use std::{hint::black_box, time::Duration};

use web_time::Instant;

use crate::{
    spectrum::{Band, Basis, Sampling, Series, product::convolve},
    study::Progress,
};

/// Batches of which the median is told.
pub(crate) const BATCHES: usize = 21;

/// A batch takes at least this long.
pub(crate) const BATCH: Duration = Duration::from_micros(200);

/// Warm-up of each way.
pub(crate) const WARM_UP: Duration = Duration::from_millis(5);

/// All that the time of a product depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// The range: its nm are the points of the 1 nm product.
    pub band: Band,
    /// The basis.
    pub basis: Basis,
    /// Numbers of each series.
    pub numbers: usize,
    /// Spikes of the light.
    pub spikes: usize,
}

/// Time of one product.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ProductTime {
    /// The way.
    pub sampling: Sampling,
    /// The median batch, nanoseconds a product.
    pub ns: f64,
    /// The quickest and the slowest batch, nanoseconds a product.
    pub range_ns: [f64; 2],
}

/// Measures every way, as [`Sampling::ALL`]; `None` when it was cancelled.
///
/// The batches of the ways take turns, so that whatever else the machine does meets all of them.
pub(crate) fn product_times(sizes: Sizes, progress: &Progress) -> Option<Vec<ProductTime>> {
    progress.expect(Sampling::ALL.len() + BATCHES);
    let mut ways = Vec::new();
    for sampling in Sampling::ALL {
        if progress.is_cancelled() {
            return None;
        }
        ways.push(Watched::new(sizes, sampling));
        progress.step();
    }
    for _ in 0..BATCHES {
        if progress.is_cancelled() {
            return None;
        }
        ways.iter_mut().for_each(Watched::run);
        progress.step();
    }
    Some(ways.into_iter().map(Watched::into_time).collect())
}

/// A way with its stop watch.
struct Watched {
    sampling: Sampling,
    product: Box<dyn FnMut(usize)>,
    /// Products in a batch.
    runs: usize,
    /// Each batch, nanoseconds a product.
    ns: Vec<f64>,
}

impl Watched {
    /// A way that is warmed up, its batches long enough.
    fn new(sizes: Sizes, sampling: Sampling) -> Self {
        let mut way = Self {
            sampling,
            product: products(sizes, sampling),
            runs: 1,
            ns: Vec::with_capacity(BATCHES),
        };
        let begun = Instant::now();
        while way.batch() < BATCH || begun.elapsed() < WARM_UP {
            if way.batch() < BATCH {
                way.runs *= 2;
            }
        }
        way
    }

    fn batch(&mut self) -> Duration {
        let begun = Instant::now();
        (self.product)(self.runs);
        begun.elapsed()
    }

    fn run(&mut self) {
        let took = self.batch();
        self.ns.push(1e9 * took.as_secs_f64() / self.runs as f64);
    }

    fn into_time(mut self) -> ProductTime {
        self.ns.sort_by(f64::total_cmp);
        let ns = |index: usize| self.ns.get(index).copied().unwrap_or(f64::NAN);
        ProductTime {
            sampling: self.sampling,
            ns: ns(BATCHES / 2),
            range_ns: [ns(0), ns(BATCHES - 1)],
        }
    }
}

/// Returns a closure that forms a given number of products, one after the other.
fn products(sizes: Sizes, sampling: Sampling) -> Box<dyn FnMut(usize)> {
    let numbers = sizes.numbers.max(1);
    let weights = made_up(sizes.spikes, 0.3);
    let factor_there = made_up(sizes.spikes, 0.7);
    let mut behind = vec![0.0; sizes.spikes];
    let mut spikes = move || multiply(&weights, &factor_there, &mut behind);
    if sampling == Sampling::Convolution {
        let series = |seed| Series::new(sizes.band, sizes.basis, made_up(numbers, seed));
        let (a, b) = (series(0.1), series(0.2));
        return Box::new(move |count| {
            for _ in 0..count {
                black_box(convolve(black_box(&a), black_box(&b)).truncated(numbers));
                spikes();
            }
        });
    }
    let points = sampling.points(numbers).unwrap_or(sizes.band.points());
    let (a, b) = (made_up(points, 0.1), made_up(points, 0.2));
    let mut out = vec![0.0; points];
    Box::new(move |count| {
        for _ in 0..count {
            multiply(&a, &b, &mut out);
            spikes();
        }
    })
}

/// Numbers between 0.5 and 1.5, no two neighbours alike.
fn made_up(count: usize, seed: f64) -> Vec<f64> {
    let golden = 0.618_033_988_749_895;
    (0..count)
        .map(|i| 0.5 + (seed + golden * i as f64).fract())
        .collect()
}

fn multiply(a: &[f64], b: &[f64], out: &mut [f64]) {
    let (a, b) = (black_box(a), black_box(b));
    for ((o, a), b) in out.iter_mut().zip(a).zip(b) {
        *o = a * b;
    }
    black_box(out);
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: Sizes = Sizes {
        band: Band::VISIBLE,
        basis: Basis::Fourier,
        numbers: 15,
        spikes: 4,
    };

    #[test]
    fn every_way_takes_some_time_and_few_points_less_than_all() {
        let times = product_times(SIZES, &Progress::default()).expect("nobody cancels");
        assert_eq!(times.len(), Sampling::ALL.len());
        for time in &times {
            assert!(
                time.range_ns[0] > 0.0 && time.range_ns[0] <= time.ns,
                "{time:?}"
            );
            assert!(time.ns <= time.range_ns[1], "{time:?}");
        }
        let ns = |wanted| times.iter().find(|t| t.sampling == wanted).map(|t| t.ns);
        // 19 multiplications against 405, and against 225 and more: far apart on any machine.
        assert!(ns(Sampling::Paper) < ns(Sampling::Exact));
        assert!(ns(Sampling::Paper) < ns(Sampling::Convolution));
    }

    #[test]
    fn what_nobody_wants_any_more_is_not_measured() {
        let progress = Progress::default();
        progress.cancel();
        assert_eq!(product_times(SIZES, &progress), None);
    }
}
