//! The coefficients of a spectrum beside those of what weighs it, and how X, Y, Z add up.
//!
//! A series and a weight in one basis meet order by order only (Eq. 7, corrected):
//!
//! ```text
//! fourier  integral S w = L/2 [ a0 A0 / 2 + sum (a_n A_n + b_n B_n) ]
//! cosine   integral S w = L/2 [ 2 c0 C0 + sum c_n C_n ]
//! ```
//!
//! so a sum cut at order N misses exactly the terms beyond N: either factor being small there is
//! enough. The weights are the colour-matching functions, or for a reflectance those functions
//! times the light. Spikes are weighed where they stand and are in every sum from the start.
//!
//! An **order** is what the order slider counts: order 0 is one number, every further order two,
//! in either basis. For Fourier they are `a_n` and `b_n`, one frequency. For the cosine basis
//! they are `c_(2n-1)` and `c_2n`, two frequencies half a period apart, which is why
//! [`Harmonics::numbers`] lists every number by itself as well.
//!
//! # What Eq. 12 claims
//!
//! For a Gaussian weight of width `w` the amplitude of order n is `A0 exp(-pi^2 n^2 w^2 / (4 ln2
//! L^2))` (Eq. 10). If the light's amplitudes obey
//!
//! ```text
//! sqrt(a_n^2 + b_n^2) <= |a0| / n        (Eq. 11: "falls like 1/n", with a0 as the constant)
//! ```
//!
//! then the term of order n is at most `2/n exp(...)` of the term of order 0. The 2 is that of
//! `a0/2` in Parseval's sum; the paper prints 4. The bound speaks of **one term over the first**,
//! not of all terms beyond N over the total, and of the smooth part only; it says nothing when the
//! light's amplitudes fall more slowly. [`Harmonics::slowest_fall`] tells whether they do. The
//! real colour-matching functions are no bells: from order 5 or so on their own coefficients are
//! larger than Eq. 10 has them, so a term may exceed its bound there, where both are tiny.

use crate::{
    color::{
        Weights,
        gaussian_cmf::{self, Gaussian},
    },
    spectrum::{Band, Basis, BasisTable, Line},
};

use super::error::{height, ratio, times};

/// A spectrum taken apart, and what weighs it.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The basis functions up to the highest order to look at.
    pub table: &'a BasisTable,
    /// Coefficients of the smooth part in prefix order, in the spectrum's own unit.
    pub coefficients: &'a [f64],
    /// Lines removed from the spectrum before the fit.
    pub spikes: &'a [Line],
    /// The spectrum as measured, on the grid of the table's band.
    pub measured: &'a [f64],
    /// Weights of the spectrum for X, Y and Z, on the same grid.
    pub weights: &'a Weights,
    /// True if the weights are the colour-matching functions and nothing else: only then is the
    /// Gaussian fit of Table 2 (made for CIE 1931) given beside them.
    pub plain_colour_matching: bool,
}

/// One coefficient and its share of X, Y and Z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number {
    /// Place in prefix order: `a0 a1 b1 a2 b2 ...` or `c0 c1 c2 ...`.
    pub index: usize,
    /// The order with which the number comes in.
    pub order: usize,
    /// The spectrum's coefficient, in the spectrum's own unit.
    pub light: f64,
    /// The coefficients of the three weights, in their own unit.
    pub weights: [f64; 3],
    /// Those of the Gaussian fit (Eq. 10); for plain colour-matching functions in the Fourier
    /// basis.
    pub gaussian: Option<[f64; 3]>,
    /// Contribution of the number to X, Y and Z, in value x nm.
    pub contribution: [f64; 3],
}

/// One order: its numbers, what they add, and how far the sum has come with them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Order {
    /// Order n.
    pub order: usize,
    /// `[a_n, b_n]` or `[c_(2n-1), c_2n]` of the spectrum; order 0 and a dropped last number
    /// leave the second one at zero.
    pub light: [f64; 2],
    /// The same of the three weights.
    pub weights: [[f64; 2]; 3],
    /// The same of the Gaussian fit (Eq. 10), where [`Number::gaussian`] is there.
    pub gaussian: Option<[[f64; 2]; 3]>,
    /// Contribution of the order to X, Y and Z, in value x nm.
    pub contribution: [f64; 3],
    /// X, Y and Z of the spikes and all orders up to this one, in value x nm.
    pub running: [f64; 3],
    /// Share actually neglected beyond this order, `(exact - running) / exact`; `None` where the
    /// exact value is not positive. Includes the cost of reducing lines of some width to spikes,
    /// which no order makes good.
    pub neglected: [Option<f64>; 3],
    /// The paper's measure, `|term n| / |term 0|` of the smooth part; `None` without a term 0.
    pub share_of_first: [Option<f64>; 3],
    /// Bound on that share by Eq. 12; from order 1 on, where the Gaussian fit applies.
    pub bound: Option<Bound>,
    /// `n sqrt(a_n^2 + b_n^2) / |a0|`: at most 1 where the light falls as Eq. 11 asks. From order
    /// 1 on, for the Fourier basis with a constant term.
    pub fall: Option<f64>,
}

/// Eq. 12 for one order: the largest share of the first term, given Eq. 11.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// `2/n exp(...)` for X, Y and Z; that of X is its small lobe's, which falls later.
    pub channels: [f64; 3],
    /// `4/n exp(...)`, as the paper prints it.
    pub channels_as_printed: [f64; 3],
}

/// The order at which a light falls most slowly.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlowestFall {
    /// The order.
    pub order: usize,
    /// The largest [`Order::fall`].
    pub fall: f64,
}

impl SlowestFall {
    /// True if the light satisfies Eq. 11, so that Eq. 12 holds for it.
    pub(crate) fn meets_eq_11(self) -> bool {
        self.fall <= 1.0
    }
}

/// The coefficients of a spectrum and of what weighs it, and how X, Y, Z add up.
#[derive(Clone, Debug, PartialEq)]
pub struct Harmonics {
    /// Band on which the series are defined.
    pub band: Band,
    /// Their functions.
    pub basis: Basis,
    /// Every coefficient by itself, in prefix order.
    pub numbers: Vec<Number>,
    /// Order by order from 0 on.
    pub orders: Vec<Order>,
    /// Contribution of the spikes to X, Y and Z, in value x nm; in every running sum.
    pub spikes: [f64; 3],
    /// X, Y and Z of the measured spectrum over the band, in value x nm.
    pub exact: [f64; 3],
    /// Order at which the light falls most slowly; `None` where no order has an [`Order::fall`].
    pub slowest_fall: Option<SlowestFall>,
}

impl Harmonics {
    /// All orders of a spectrum, as far as both its coefficients and the table reach.
    ///
    /// # Panics
    /// When the measured values or the weights are not on the grid of the table's band.
    pub fn of(question: Question<'_>) -> Self {
        let (table, band) = (question.table, question.table.band());
        // Both factors as shares of their largest value, so that no product overflows.
        let light_unit = height(question.measured).unwrap_or(1.0);
        let weight_unit = common_height(question.weights);
        let in_units = |sum: f64| sum / light_unit / weight_unit;
        let measured = times(question.measured, light_unit);
        let weights: [Vec<f64>; 3] =
            std::array::from_fn(|k| times(&question.weights[k], weight_unit));

        let spikes: [f64; 3] = std::array::from_fn(|k| {
            let weigh =
                |s: &Line| s.weight * light_unit * (question.weights.at(s.at_nm)[k] * weight_unit);
            question
                .spikes
                .iter()
                .map(weigh)
                .fold(0.0, |sum, w| sum + w)
        });
        let exact: [f64; 3] = std::array::from_fn(|k| band.inner(&measured, &weights[k]));
        let numbers = numbers(question, &weights, light_unit);
        let orders = orders(&numbers, table, spikes, exact);
        Self {
            band,
            basis: table.basis(),
            slowest_fall: slowest_fall(&orders),
            numbers: numbers
                .into_iter()
                .map(|number| Number {
                    light: number.light / light_unit,
                    weights: number.weights.map(|w| w / weight_unit),
                    contribution: number.contribution.map(in_units),
                    ..number
                })
                .collect(),
            orders: orders
                .into_iter()
                .map(|order| Order {
                    light: order.light.map(|c| c / light_unit),
                    weights: order.weights.map(|pair| pair.map(|w| w / weight_unit)),
                    contribution: order.contribution.map(in_units),
                    running: order.running.map(in_units),
                    ..order
                })
                .collect(),
            spikes: spikes.map(in_units),
            exact: exact.map(in_units),
        }
    }

    /// The smooth part up to an order, on the table's grid, in the spectrum's own unit.
    pub(crate) fn partial_sum(&self, table: &BasisTable, order: usize) -> Vec<f64> {
        self.curve(table, |number| number.order <= order)
    }

    /// The curve of a single order, on the table's grid, in the spectrum's own unit.
    pub fn single(&self, table: &BasisTable, order: usize) -> Vec<f64> {
        self.curve(table, |number| number.order == order)
    }

    fn curve(&self, table: &BasisTable, kept: impl Fn(&Number) -> bool) -> Vec<f64> {
        let coefficients: Vec<f64> = self
            .numbers
            .iter()
            .map(|number| if kept(number) { number.light } else { 0.0 })
            .collect();
        table.evaluate(&coefficients)
    }
}

/// One over the largest value of all three weights; 1 when they are all zero.
fn common_height(weights: &[Vec<f64>; 3]) -> f64 {
    let units = weights.iter().filter_map(|row| height(row));
    let unit = units.fold(f64::INFINITY, f64::min);
    if unit.is_finite() { unit } else { 1.0 }
}

/// The order with which a number comes in.
fn order_of(index: usize) -> usize {
    index.div_ceil(2)
}

fn numbers(question: Question<'_>, weights: &[Vec<f64>; 3], light_unit: f64) -> Vec<Number> {
    let table = question.table;
    let (band, basis) = (table.band(), table.basis());
    let count = question.coefficients.len().min(table.numbers());
    let of_weights = weights.each_ref().map(|row| table.project(row, count));
    let fitted = question.plain_colour_matching && basis == Basis::Fourier;
    (0..count)
        .map(|index| {
            let light = question.coefficients[index] * light_unit;
            let weights = of_weights.each_ref().map(|row| row[index]);
            // The functions are orthogonal: the product of two coefficients and their function's
            // squared norm is the whole integral.
            let norm_squared = basis.norm_squared(index, band);
            Number {
                index,
                order: order_of(index),
                light,
                weights,
                gaussian: fitted.then(|| gaussian_number(index, band)),
                contribution: weights.map(|w| light * w * norm_squared),
            }
        })
        .collect()
}

/// Eq. 10 for one number of the Fourier basis.
fn gaussian_number(index: usize, band: Band) -> [f64; 3] {
    let is_sine = index > 0 && index.is_multiple_of(2);
    gaussian_cmf::fitted_fourier(order_of(index), band).map(|[a, b]| if is_sine { b } else { a })
}

fn orders(numbers: &[Number], table: &BasisTable, spikes: [f64; 3], exact: [f64; 3]) -> Vec<Order> {
    let mut running = spikes;
    let mut orders: Vec<Order> = Vec::new();
    for pair in numbers.chunk_by(|a, b| a.order == b.order) {
        let order = pair[0].order;
        let both = |of: &dyn Fn(&Number) -> f64| [of(&pair[0]), pair.get(1).map_or(0.0, of)];
        let contribution =
            std::array::from_fn(|k| pair.iter().map(|number| number.contribution[k]).sum());
        for (sum, term) in running.iter_mut().zip(contribution) {
            *sum += term;
        }
        let light = both(&|number| number.light);
        let constant = orders.first().map_or(light[0], |first| first.light[0]);
        let first = orders.first().map_or(contribution, |o| o.contribution);
        let is_fourier = table.basis() == Basis::Fourier;
        let gaussian = pair[0].gaussian.is_some().then(|| {
            std::array::from_fn(|k| both(&|number| number.gaussian.map_or(0.0, |g| g[k])))
        });
        orders.push(Order {
            order,
            light,
            weights: std::array::from_fn(|k| both(&|number| number.weights[k])),
            gaussian,
            contribution,
            running,
            neglected: std::array::from_fn(|k| {
                (exact[k] > 0.0).then(|| (exact[k] - running[k]) / exact[k])
            }),
            share_of_first: std::array::from_fn(|k| ratio(contribution[k].abs(), first[k].abs())),
            bound: (order > 0 && gaussian.is_some())
                .then(|| Bound::of(order, table.band().length_nm())),
            fall: (order > 0 && is_fourier)
                .then(|| ratio(order as f64 * light[0].hypot(light[1]), constant.abs()))
                .flatten(),
        });
    }
    orders
}

fn slowest_fall(orders: &[Order]) -> Option<SlowestFall> {
    orders
        .iter()
        .filter_map(|o| {
            o.fall.map(|fall| SlowestFall {
                order: o.order,
                fall,
            })
        })
        .max_by(|a, b| a.fall.total_cmp(&b.fall))
}

impl Bound {
    /// Eq. 12, corrected and as printed, for an order from 1 on and a range of `length_nm`.
    pub fn of(order: usize, length_nm: f64) -> Self {
        let largest = |bound: &dyn Fn(&Gaussian) -> f64| {
            gaussian_cmf::FIT.map(|lobes| lobes.iter().map(bound).fold(0.0, f64::max))
        };
        Self {
            channels: largest(&|lobe| lobe.bound(order, length_nm)),
            channels_as_printed: largest(&|lobe| lobe.bound_as_printed(order, length_nm)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::gaussian_cmf::{X_SMALL, Y, Z},
        color::{Observer, blackbody, xyz_from_integral},
        spectrum::{Composite, Outside, Resampled, SampleGrid, Sampled, Series},
    };

    const BAND: Band = Band::VISIBLE;
    const LINE: Line = Line::ideal(546.0, 8.0);

    fn background() -> Vec<f64> {
        BAND.grid()
            .map(|nm| blackbody::relative(nm, 4000.0))
            .collect()
    }

    /// A blackbody with one green line of a single nm.
    fn measured() -> Vec<f64> {
        let mut values = background();
        values[166] += LINE.weight;
        values
    }

    fn table(basis: Basis, numbers: usize) -> BasisTable {
        BasisTable::new(BAND, basis, numbers)
    }

    fn harmonics(table: &BasisTable, measured: &[f64], spikes: &[Line]) -> Harmonics {
        let weights = Observer::CIE_1931.table().on_band(BAND);
        let mut smooth = measured.to_vec();
        for spike in spikes {
            smooth[(spike.at_nm - BAND.min_nm()) as usize] -= spike.weight;
        }
        Harmonics::of(Question {
            table,
            coefficients: &table.project(&smooth, table.numbers()),
            spikes,
            measured,
            weights: &weights,
            plain_colour_matching: true,
        })
    }

    #[test]
    fn the_terms_of_every_order_add_up_to_the_integral_of_the_cut_series() {
        for basis in Basis::ALL {
            let table = table(basis, 41);
            let found = harmonics(&table, &measured(), &[LINE]);
            assert_eq!(found.orders.len(), 21);
            let weights = Observer::CIE_1931.table().on_band(BAND);
            for order in &found.orders {
                let curve = found.partial_sum(&table, order.order);
                for (k, weight) in weights.iter().enumerate() {
                    let sum = BAND.inner(&curve, weight) + found.spikes[k];
                    // Sums of 401 products near 1, in another order.
                    assert!((order.running[k] - sum).abs() < 1e-10);
                }
            }
        }
    }

    #[test]
    fn with_every_order_of_the_grid_nothing_is_neglected() {
        let band = Band::new(500.0, 561.0).unwrap();
        let values: Vec<f64> = band.grid().map(|nm| 1.0 + (nm * nm).sin()).collect();
        for basis in Basis::ALL {
            let table = BasisTable::new(band, basis, usize::MAX);
            // A series itself: 62 points hold one number more than its 61.
            let coefficients = table.project(&values, table.numbers());
            let series = table.evaluate(&coefficients);
            let found = Harmonics::of(Question {
                table: &table,
                coefficients: &coefficients,
                spikes: &[],
                measured: &series,
                weights: &Observer::CIE_1931.table().on_band(band),
                plain_colour_matching: true,
            });
            for neglected in found.orders.last().unwrap().neglected {
                // 61 terms of a sum near its whole.
                assert!(neglected.unwrap().abs() < 1e-12);
            }
        }
    }

    #[test]
    fn single_orders_add_up_to_the_partial_sum() {
        for basis in Basis::ALL {
            let table = table(basis, 11);
            let found = harmonics(&table, &measured(), &[LINE]);
            let mut sum = vec![0.0; BAND.points()];
            for order in 0..=3 {
                for (s, v) in sum.iter_mut().zip(found.single(&table, order)) {
                    *s += v;
                }
            }
            for (i, expected) in found.partial_sum(&table, 3).iter().enumerate() {
                // Seven numbers near 1 in another order.
                assert!((sum[i] - expected).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn an_order_is_two_numbers_in_either_basis() {
        for basis in Basis::ALL {
            let found = harmonics(&table(basis, 10), &measured(), &[]);
            assert_eq!(found.numbers.len(), 10);
            assert_eq!(found.orders.len(), 6);
            assert_eq!(found.orders[0].light, [found.numbers[0].light, 0.0]);
            let pair = [found.numbers[5].light, found.numbers[6].light];
            assert_eq!(found.orders[3].light, pair);
            // An even count of numbers drops the last one of the highest order.
            assert_eq!(found.orders[5].light, [found.numbers[9].light, 0.0]);
        }
    }

    #[test]
    fn spikes_are_in_the_sum_from_the_start() {
        let table = table(Basis::Fourier, 11);
        let found = harmonics(&table, &measured(), &[LINE]);
        let xyz = xyz_from_integral(|w| LINE.weight * w(LINE.at_nm), Observer::CIE_1931);
        for k in 0..3 {
            // One product, scaled there and back.
            assert!((found.spikes[k] - xyz.to_array()[k]).abs() < 1e-14);
            let first = found.orders[0];
            let sum = found.spikes[k] + first.contribution[k];
            assert!((first.running[k] - sum).abs() < 1e-13 * sum);
        }
    }

    #[test]
    fn the_gaussian_coefficients_are_near_those_of_the_table() {
        let found = harmonics(&table(Basis::Fourier, 15), &background(), &[]);
        let largest = found.numbers[0].weights;
        for number in &found.numbers {
            let gaussian = number.gaussian.unwrap();
            for k in 0..3 {
                // The fit misses most at order 5 of z-bar, which is no bell: 6 % of the first.
                let off = (gaussian[k] - number.weights[k]).abs();
                assert!(off < 0.065 * largest[k], "{number:?}");
            }
        }
        let cosine = harmonics(&table(Basis::Cosine, 15), &background(), &[]);
        assert!(
            cosine
                .numbers
                .iter()
                .all(|number| number.gaussian.is_none())
        );
        assert!(
            cosine
                .orders
                .iter()
                .all(|o| o.bound.is_none() && o.fall.is_none())
        );
        assert_eq!(cosine.slowest_fall, None);
    }

    /// The theorem behind Eq. 12, on lights that fall as slowly as Eq. 11 allows.
    #[test]
    fn no_term_of_a_gaussian_weight_exceeds_the_corrected_bound() {
        let table = table(Basis::Fourier, 31);
        let fitted = |k: usize| {
            BAND.grid()
                .map(|nm| gaussian_cmf::fitted_at(nm)[k])
                .collect()
        };
        let weights = Weights::new(BAND, [0, 1, 2].map(fitted));
        for shift in 0..8 {
            // Every amplitude a0/n, the phases somewhere.
            let mut coefficients = vec![1.0];
            for n in 1..=15 {
                let (sin, cos) = f64::from(shift * n * n).sin_cos();
                coefficients.extend([cos / f64::from(n), sin / f64::from(n)]);
            }
            let found = Harmonics::of(Question {
                table: &table,
                coefficients: &coefficients,
                spikes: &[],
                measured: &table.evaluate(&coefficients),
                weights: &weights,
                plain_colour_matching: true,
            });
            let slowest = found.slowest_fall.unwrap();
            // A sine and a cosine squared are 1 to rounding.
            assert!((slowest.fall - 1.0).abs() < 1e-14);
            for order in &found.orders[1..] {
                let bound = order.bound.unwrap();
                for k in 0..3 {
                    let share = order.share_of_first[k].unwrap();
                    // The band cuts 1e-4 off the tails of the bells.
                    assert!(share < bound.channels[k] + 1e-3, "{order:?}");
                }
            }
        }
    }

    #[test]
    fn the_printed_bound_is_twice_the_corrected_one() {
        for order in 1..12 {
            let bound = Bound::of(order, 400.0);
            assert_eq!(bound.channels.map(|b| 2.0 * b), bound.channels_as_printed);
            // The narrower a lobe, the later its terms fall.
            let later = [X_SMALL, Y, Z].map(|lobe| lobe.bound(order, 400.0));
            assert_eq!(bound.channels, later);
        }
    }

    #[test]
    fn a_sloping_line_falls_like_one_over_n_and_a_lone_spike_does_not_fall() {
        let slope: Vec<f64> = BAND.grid().map(|nm| nm - BAND.min_nm()).collect();
        let found = harmonics(&table(Basis::Fourier, 21), &slope, &[]);
        for order in &found.orders[1..] {
            // b_n = -L/(pi n) and a0 = L; the grid's corners cost (n/L)^2 of it.
            assert!((order.fall.unwrap() - 1.0 / std::f64::consts::PI).abs() < 2e-3);
        }
        assert!(found.slowest_fall.unwrap().meets_eq_11());

        let mut spike = vec![0.0; BAND.points()];
        spike[100] = 1.0;
        let found = harmonics(&table(Basis::Fourier, 21), &spike, &[]);
        // All amplitudes equal: the highest order looked at falls behind most.
        assert_eq!(found.slowest_fall.unwrap().order, 10);
        assert!(!found.slowest_fall.unwrap().meets_eq_11());
    }

    #[test]
    fn dark_and_enormous_spectra_give_no_nan() {
        let weights = Observer::CIE_1931.table().on_band(BAND);
        let table = table(Basis::Fourier, 11);
        for value in [0.0, 1e-320, 1e300, -1e300] {
            let measured = vec![value; BAND.points()];
            let found = Harmonics::of(Question {
                table: &table,
                coefficients: &[2.0 * value, value, -value],
                spikes: &[Line::ideal(500.0, -value)],
                measured: &measured,
                weights: &Weights::new(BAND, weights.each_ref().map(|row| times(row, 1e200))),
                plain_colour_matching: false,
            });
            let is_number = |v: f64| !v.is_nan();
            for order in &found.orders {
                assert!(order.running.into_iter().all(is_number), "{order:?}");
                assert!(order.neglected.into_iter().flatten().all(is_number));
                assert!(order.share_of_first.into_iter().flatten().all(is_number));
            }
        }
    }

    #[test]
    fn every_representation_weighs_alike_through_its_integral() {
        let sampled = Sampled::even(380.0, 1.0, background()).unwrap();
        let grid = |series: &Series| SampleGrid::new(BAND, series.basis, series.coefficients.len());
        for basis in Basis::ALL {
            let table = table(basis, 41);
            let smooth = Series::new(BAND, basis, table.project(&background(), 41));
            let resampled = Resampled {
                grid: grid(&smooth),
                values: grid(&smooth).sample(&smooth),
                spikes: vec![LINE],
            };
            let composite = Composite::of_lines_inside(smooth, vec![LINE]);
            let observer = Observer::CIE_1931;
            let by_coefficients = harmonics(&table, &measured(), &[LINE]);
            let of_model = xyz_from_integral(|w| composite.integrate(w), observer);
            let of_samples = xyz_from_integral(|w| resampled.integrate(w), observer);
            let of_table = xyz_from_integral(
                |w| sampled.integrate(BAND, Outside::Zero, w) + LINE.weight * w(LINE.at_nm),
                observer,
            );
            let running = by_coefficients.orders.last().unwrap().running;
            for (k, model) in of_model.to_array().into_iter().enumerate() {
                // 401 products near 1 in another order, and a transform of 41 points.
                assert!((running[k] - model).abs() < 1e-10);
                assert!((of_samples.to_array()[k] - model).abs() < 1e-10);
                let exact = by_coefficients.exact[k];
                assert!((of_table.to_array()[k] - exact).abs() < 1e-10);
            }
        }
    }
}
