//! One product formed in every way, and the factor at the light's spikes by Eq. 17.

use super::{Product, Step};
use crate::{
    color::{delta_e_of_xyz, xyz_of_parts},
    spectrum::{BasisTable, Factor, Line, Sampling, product::multiply},
    study::truth::{SpikeReading, cut, eq_17},
};

/// A light times one factor, formed in every way.
#[derive(Clone, Debug, PartialEq)]
pub struct Resampled {
    /// Way by way, as [`Sampling::ALL`].
    pub ways: Vec<Formed>,
    /// The smooth product of the two series on the grid, every order kept.
    pub series_product: Vec<f64>,
    /// Measured light times measured factor, on the grid.
    pub exact: Vec<f64>,
}

/// The product formed in one way.
#[derive(Clone, Debug, PartialEq)]
pub struct Formed {
    /// The way.
    pub sampling: Sampling,
    /// Points that are multiplied: those of the sample grid, or every nm; a convolution has none.
    pub points: Option<usize>,
    /// The resulting product.
    pub step: Step,
}

/// Forms `product` (whose own `sampling` is not looked at) with a factor in every way.
///
/// # Panics
/// When a curve does not have [`crate::spectrum::Band::points`] values.
pub fn resampled(product: Product<'_>, factor: &Factor, table: &BasisTable) -> Resampled {
    let numbers = product.model.smooth().coefficients.len();
    let ways = Sampling::ALL.into_iter().filter_map(|sampling| {
        let own = Product {
            sampling,
            ..product
        };
        let passage = own.through(std::slice::from_ref(factor));
        Some(Formed {
            sampling,
            points: match sampling {
                Sampling::Exact => Some(product.model.band().points()),
                other => other.points(numbers),
            },
            step: passage.steps.into_iter().next()?,
        })
    });
    let short = cut(factor.background(), table, product.model);
    Resampled {
        ways: ways.collect(),
        series_product: multiply(&product.model.smooth().on_band(), &short.on_band()),
        exact: multiply(product.measured, factor.values()),
    }
}

/// CIEDE2000 of a product whose spikes read the factor off something else than its measured
/// curve: off its series, off the straight line of Eq. 17 as corrected, and as printed.
pub(super) type ReadingCosts = [Option<f64>; 3];

/// Eq. 17 spike by spike.
#[derive(Clone, Debug, PartialEq)]
pub struct SpikeCosts {
    /// Reading at each spike, and the cost of that one reading.
    pub each: Vec<(SpikeReading, ReadingCosts)>,
    /// Cost of all readings together.
    pub all: ReadingCosts,
}

/// Reads a factor at every spike of the light by its series, by the corrected Eq. 17 and by Eq. 17
/// as printed, on the paper's points; the smooth product is the same in all.
///
/// # Panics
/// As `forming`.
pub(crate) fn spike_costs(product: Product<'_>, factor: &Factor, table: &BasisTable) -> SpikeCosts {
    let (band, seen, white) = (product.model.band(), product.seen, product.white());
    let found = eq_17(
        &product.model.idealised(),
        factor.values(),
        table,
        seen,
        white,
    );
    let series = cut(factor.values(), table, product.model);
    let smooth = multiply(&product.model.smooth().on_band(), &series.on_band());
    let colour = |value: &dyn Fn(usize, &SpikeReading) -> f64| {
        let readings = found.readings.iter().enumerate();
        let spikes: Vec<Line> = readings.map(|(i, r)| r.weighed(value(i, r))).collect();
        xyz_of_parts(band, &smooth, &spikes, seen)
    };
    let exact = colour(&|_, reading| reading.measured);
    let readers: [fn(&SpikeReading) -> f64; 3] = [|r| r.series, |r| r.linear, |r| r.printed];
    // Of the spikes that are told, the reader's value; of the others the measured one.
    let costs = |told: &dyn Fn(usize) -> bool| {
        readers.map(|read| {
            let value = |i: usize, reading: &SpikeReading| {
                if told(i) {
                    read(reading)
                } else {
                    reading.measured
                }
            };
            delta_e_of_xyz(exact, colour(&value), white)
        })
    };
    let readings = found.readings.iter().enumerate();
    SpikeCosts {
        each: readings
            .map(|(i, reading)| (*reading, costs(&|k| k == i)))
            .collect(),
        all: costs(&|_| true),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::Observer,
        spectrum::{Band, Basis, Composite, Series},
    };

    const BAND: Band = Band::VISIBLE;

    fn light(basis: Basis) -> Composite {
        Composite::of_lines_inside(
            Series::new(BAND, basis, vec![3.0, -1.0, 0.5, 0.25, 0.125]),
            vec![Line::ideal(435.8, 20.0), Line::ideal(546.1, 30.0)],
        )
    }

    fn with_product(basis: Basis, look: impl FnOnce(Product<'_>, &BasisTable)) {
        let model = light(basis);
        let measured = model.smooth().on_band();
        let seen = Observer::CIE_1931.table().on_band(BAND);
        let product = Product {
            measured: &measured,
            model: &model,
            sampling: Sampling::Double,
            seen: &seen,
            width_nm: 10.0,
        };
        look(product, &BasisTable::new(BAND, basis, 21));
    }

    #[test]
    fn enough_points_form_the_product_of_the_two_series() {
        let ramp = Factor::new(BAND.grid().map(|nm| (nm - 380.0) / 400.0).collect());
        for basis in Basis::ALL {
            with_product(basis, |product, table| {
                let found = resampled(product, &ramp, table);
                assert_eq!(found.ways.len(), Sampling::ALL.len());
                let double = found.ways.iter().find(|w| w.sampling == Sampling::Double);
                let double = double.expect("every way");
                assert_eq!(double.points, Some(10));
                for (a, b) in double.step.smooth.iter().zip(&found.series_product) {
                    // Sums of ten products of numbers below 5.
                    assert!((a - b).abs() < 1e-12, "{basis:?} {a} {b}");
                }
                assert!(double.step.added.is_some_and(|added| added < 1e-9));
            });
        }
    }

    #[test]
    fn a_factor_that_is_its_own_series_costs_nothing_where_spikes_read_the_series() {
        let wave = BAND
            .grid()
            .map(|nm| 0.5 + 0.3 * (std::f64::consts::TAU * (nm - 380.0) / 400.0).cos());
        let factor = Factor::new(wave.collect());
        with_product(Basis::Fourier, |product, table| {
            let found = spike_costs(product, &factor, table);
            assert_eq!(found.each.len(), 2);
            let [series, corrected, printed] = found.all.map(|cost| cost.expect("a colour"));
            // The measured curve is read off straight lines of 1 nm.
            assert!(series < 1e-3, "{series}");
            // Which straight line costs more hangs on how the errors of two lines add up.
            assert!(series < corrected && series < printed);
            // The first line lies 55.8 of 80 nm from the first point, where the cosine is 1, to
            // the second, at a fifth of a turn.
            let (fall, t) = (1.0 - (0.2 * std::f64::consts::TAU).cos(), 55.8 / 80.0);
            let (reading, _) = found.each[0];
            for (found, part) in [(reading.linear, t), (reading.printed, 1.0 - t)] {
                assert!((found - (0.8 - 0.3 * fall * part)).abs() < 1e-9, "{found}");
            }
            // One line alone cannot cost more than a colour could; and it costs something.
            for (_, [_, corrected, _]) in &found.each {
                assert!(corrected.is_some_and(|cost| cost > 0.0));
            }
        });
    }
}
