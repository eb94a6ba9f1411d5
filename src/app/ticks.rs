//! Round numbers for axes, and short ways to write numbers.

use crate::languages::with_sign;

/// Significant digits of [`short`].
const SIGNIFICANT: i32 = 4;

/// Below this size numbers are written with an exponent.
const SMALLEST_PLAIN: f64 = 1e-4;

/// From this size on numbers are written with an exponent.
const LARGEST_PLAIN: f64 = 1e6;

/// Most ticks that an axis gets, whatever was asked for.
const MOST_TICKS: f64 = 200.0;

/// Multiples of 1, 2 or 5 times a power of ten from `min` to `max`, about `target` of them.
///
/// Empty when the range is empty, runs backwards or cannot be divided (not finite, or so narrow
/// that `f64` has no numbers in between).
pub fn nice_ticks(min: f64, max: f64, target: usize) -> Vec<f64> {
    let span = max - min;
    let rough = span / target.max(1) as f64;
    if !(span.is_finite() && rough >= f64::MIN_POSITIVE) {
        return Vec::new();
    }
    // The power of ten just below the rough step, and how far above it the step lies (1 to 10).
    let mut exponent = exponent(rough);
    let excess = rough / power_of_ten(exponent);
    // The borders are the geometric means of the neighbours: sqrt(2), sqrt(10) and sqrt(50).
    let digit = if excess < 2_f64.sqrt() {
        1.0
    } else if excess < 10_f64.sqrt() {
        2.0
    } else if excess < 50_f64.sqrt() {
        5.0
    } else {
        exponent += 1;
        1.0
    };
    let multiple = |count: f64| in_decade(count * digit, exponent);
    let step = multiple(1.0);
    // A tick that misses the end of the range by rounding alone still counts as inside.
    let first = (min / step - 1e-9).ceil();
    let last = (max / step + 1e-9).floor().min(first + MOST_TICKS);
    let mut ticks = Vec::new();
    let mut count = first;
    while count <= last {
        // Adding zero turns -0 into 0.
        ticks.push(multiple(count) + 0.0);
        if count + 1.0 == count {
            break;
        }
        count += 1.0;
    }
    ticks.dedup();
    ticks.retain(|tick| tick.is_finite());
    ticks
}

/// Ticks of a logarithmic axis from `min` to `max`, both above 0, about `target` of them.
///
/// Powers of ten, every one or every few; with 2 and 5 in between where there are only few; and
/// for less than a decade the ticks of a linear axis.
pub fn log_ticks(min: f64, max: f64, target: usize) -> Vec<f64> {
    if !(min > 0.0 && max > min && max.is_finite()) {
        return Vec::new();
    }
    let (first, last) = (exponent(min), exponent(max));
    let inside = |tick: &f64| (min * (1.0 - 1e-9)..=max * (1.0 + 1e-9)).contains(tick);
    let ticks = |every: usize, digits: &[f64]| -> Vec<f64> {
        let decades = (first..=last).filter(|decade| decade.rem_euclid(every as i32) == 0);
        let all =
            decades.flat_map(|decade| digits.iter().map(move |digit| in_decade(*digit, decade)));
        all.filter(inside).collect()
    };
    let decades = (last - first) as usize;
    if decades * 3 <= target {
        let fine = ticks(1, &[1.0, 2.0, 5.0]);
        if fine.len() >= 2 {
            return fine;
        }
    }
    // Where every few decades leave fewer than two, more of them.
    let most = decades.div_ceil(target.max(1)).max(1);
    let coarse = (1..=most).rev().map(|every| ticks(every, &[1.0]));
    coarse
        .chain([ticks(1, &[1.0, 2.0, 5.0])])
        .find(|ticks| ticks.len() >= 2)
        .unwrap_or_else(|| nice_ticks(min, max, target))
}

/// Round numbers from `min` to `max` that stand apart on an axis of square roots, about `target` of
/// them: 1, 2 or 5 times powers of ten.
pub fn root_ticks(min: f64, max: f64, target: usize) -> Vec<f64> {
    let size = min.abs().max(max.abs());
    if !(size.is_finite() && size > 0.0 && min < max) {
        return Vec::new();
    }
    let root = |v: f64| v.abs().sqrt().copysign(v);
    let apart = (root(max) - root(min)) / target.max(2) as f64;
    let mut sizes: Vec<f64> = Vec::new();
    let mut decade = 10_f64.powf(size.log10().floor());
    while sizes.len() < 24 {
        sizes.extend([5.0, 2.0, 1.0].map(|digit| digit * decade));
        decade /= 10.0;
    }
    // From the top down, so that the highest is kept, as 0 is.
    let mut ticks: Vec<f64> = vec![0.0];
    for sign in [1.0, -1.0] {
        let mut last = f64::INFINITY;
        for size in &sizes {
            let tick = sign * size;
            let place = root(*size);
            if (min..=max).contains(&tick) && last - place >= 0.7 * apart && place >= 0.7 * apart {
                ticks.push(tick);
                last = place;
            }
        }
    }
    ticks.retain(|tick| (min..=max).contains(tick));
    ticks.sort_by(f64::total_cmp);
    ticks
}

/// Writes the ticks of a linear axis, all with the same number of decimals.
///
/// An axis that goes beyond a million or stays below 1/1000 is written with exponents.
pub fn tick_labels(ticks: &[f64]) -> Vec<String> {
    let largest = ticks
        .iter()
        .fold(0.0, |most: f64, tick| most.max(tick.abs()));
    let step = match ticks {
        [first, second, ..] => (second - first).abs(),
        _ => return ticks.iter().copied().map(short).collect(),
    };
    // A step of 0.2 reads back as 0.19999.. between large ticks; 1e-3 forgives that.
    let step_exponent = exponent(step * (1.0 + 1e-3));
    let plain = (1e-3..LARGEST_PLAIN).contains(&largest);
    let write = |&tick: &f64| {
        if plain {
            format!("{tick:.*}", (-step_exponent).max(0) as usize)
        } else if tick == 0.0 {
            "0".to_owned()
        } else {
            let decimals = (exponent(tick.abs() * (1.0 + 1e-12)) - step_exponent).clamp(0, 16);
            format!("{tick:.*e}", decimals as usize)
        }
    };
    ticks.iter().map(write).map(with_sign).collect()
}

/// A number in few characters: `0.0123`, `1.2e-7`, `12300`, `-5`.
///
/// Four significant digits, and never fewer than stand before the decimal point; trailing zeros
/// are left out. An exponent is used from a million up and below 1/10 000.
pub fn short(number: f64) -> String {
    if number == 0.0 {
        return "0".to_owned();
    }
    if !number.is_finite() {
        return number.to_string();
    }
    // Rounding comes first: 999999.7 must become 1e6 and not 1000000.
    let scientific = format!("{number:.*e}", (SIGNIFICANT - 1) as usize);
    let rounded: f64 = scientific.parse().unwrap_or(number);
    if (SMALLEST_PLAIN..LARGEST_PLAIN).contains(&rounded.abs()) {
        let decimals = (SIGNIFICANT - 1 - exponent(rounded.abs())).max(0);
        let digits = format!("{number:.*}", decimals as usize);
        with_sign(without_trailing_zeros(&digits).to_owned())
    } else {
        let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        with_sign(format!("{}e{exponent}", without_trailing_zeros(mantissa)))
    }
}

/// Smallest and largest of the finite numbers; `None` when there are none.
pub fn extent(numbers: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    let finite = numbers.into_iter().filter(|number| number.is_finite());
    finite.fold(None, |range, number| {
        let [low, high] = range.unwrap_or([number; 2]);
        Some([low.min(number), high.max(number)])
    })
}

/// `"1.50"` as `"1.5"`, `"2.00"` as `"2"`; whole numbers stay as they are.
pub(crate) fn without_trailing_zeros(digits: &str) -> &str {
    if digits.contains('.') {
        digits.trim_end_matches('0').trim_end_matches('.')
    } else {
        digits
    }
}

/// The power of ten of a positive number's first digit: 0 for 1 to 9.99, -2 for 0.05.
fn exponent(number: f64) -> i32 {
    if !(number > 0.0 && number.is_finite()) {
        return 0;
    }
    // The logarithm may land just beside a whole number; the comparison settles it.
    let guess = number.log10().floor() as i32;
    if power_of_ten(guess + 1) <= number {
        guess + 1
    } else if power_of_ten(guess) > number {
        guess - 1
    } else {
        guess
    }
}

/// A number times `10^exponent`. Dividing by a whole power of ten is exact to the last digit,
/// multiplying by 0.1 is not.
fn in_decade(number: f64, exponent: i32) -> f64 {
    if exponent < 0 {
        number / power_of_ten(-exponent)
    } else {
        number * power_of_ten(exponent)
    }
}

/// `10^exponent`, rounded correctly (which `powi` does not promise).
fn power_of_ten(exponent: i32) -> f64 {
    format!("1e{exponent}").parse().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_inside() {
        assert_eq!(nice_ticks(0.0, 1.0, 5), [0.0, 0.2, 0.4, 0.6, 0.8, 1.0]);
        assert_eq!(nice_ticks(380.0, 780.0, 8)[..2], [400.0, 450.0]);
        assert_eq!(nice_ticks(-0.3, 0.31, 6)[0], -0.3);
        assert_eq!(nice_ticks(-1.0, 1.0, 4), [-1.0, -0.5, 0.0, 0.5, 1.0]);
    }

    #[test]
    fn no_range_however_odd_makes_many_or_broken_ticks() {
        let numbers = [
            0.0,
            -0.0,
            1.0,
            -1.0,
            1e-320,
            1e-300,
            1e300,
            -1e308,
            1e308,
            1e16,
            1e16 + 2.0,
            0.1,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MIN_POSITIVE,
            1.0 + f64::EPSILON,
        ];
        for min in numbers {
            for max in numbers {
                for target in [0, 1, 5, 10] {
                    for ticks in [nice_ticks(min, max, target), log_ticks(min, max, target)] {
                        assert!(ticks.len() < 250, "{min} to {max}");
                        assert!(ticks.iter().all(|tick| tick.is_finite()));
                        assert!(ticks.is_sorted_by(|a, b| a < b), "{min} to {max}");
                        assert_eq!(tick_labels(&ticks).len(), ticks.len());
                    }
                }
            }
        }
    }

    #[test]
    fn several_decades_have_powers_of_ten_however_few_ticks_are_wanted() {
        for (min, max) in [(0.01, 600.0), (3e-4, 25.0), (0.3, 40.0)] {
            for target in 1..8 {
                let ticks = log_ticks(min, max, target);
                assert!(ticks.len() >= 2, "{min} to {max}: {ticks:?}");
                let ratios = ticks.windows(2).map(|pair| pair[1] / pair[0]);
                // Of 1, 2 and 5, or whole decades: the ticks never crowd at the upper end.
                assert!(ratios.fold(f64::INFINITY, f64::min) > 1.9, "{ticks:?}");
            }
        }
    }

    #[test]
    fn the_number_of_ticks_is_near_the_target() {
        for k in 0..400 {
            let span = 1.07_f64.powi(k - 200);
            let count = nice_ticks(0.0, span, 6).len();
            assert!((4..=10).contains(&count), "{count} ticks for {span}");
        }
    }

    #[test]
    fn labels_of_an_axis_have_the_decimals_of_its_step() {
        let labels = |min, max| tick_labels(&nice_ticks(min, max, 5));
        assert_eq!(labels(0.0, 1.0), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(0.0, 0.1)[1], "0.02");
        assert_eq!(labels(400.0, 700.0)[0], "400");
        assert_eq!(labels(0.0, 4e7), ["0", "1e7", "2e7", "3e7", "4e7"]);
        assert_eq!(labels(0.0, 3e-5)[1], "5e-6");
        assert_eq!(labels(0.0, 3e-5)[3], "1.5e-5");
        assert_eq!(labels(-1.0, 1.0)[2], "0.0");
    }

    #[test]
    fn log_axes_have_decades_and_a_few_steps_between() {
        assert_eq!(log_ticks(1e-3, 1e3, 8).len(), 7);
        assert_eq!(log_ticks(1.0, 100.0, 8), [1., 2., 5., 10., 20., 50., 100.]);
        assert_eq!(
            log_ticks(1e-30, 1e30, 6)[1] / log_ticks(1e-30, 1e30, 6)[0],
            1e10
        );
        assert!(log_ticks(3.1, 3.9, 5).len() > 3);
        assert!(log_ticks(0.0, 1.0, 5).is_empty());
    }

    #[test]
    fn numbers_are_written_short() {
        for (number, expected) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.0123, "0.0123"),
            (1.2e-7, "1.2e-7"),
            (12300.0, "12300"),
            (12345.6, "12346"),
            (-5.0, "-5"),
            (0.1 + 0.2, "0.3"),
            (999_999.7, "1e6"),
            (999_949.0, "999949"),
            (0.000_099_999_9, "0.0001"),
            (2.5e8, "2.5e8"),
            (99.996, "100"),
            (1e-320, "1e-320"),
            (f64::MAX, "1.798e308"),
            (f64::NAN, "NaN"),
        ] {
            assert_eq!(short(number), expected);
        }
    }

    #[test]
    fn the_extent_leaves_broken_numbers_out() {
        assert_eq!(
            extent([2.0, f64::NAN, -1.0, f64::INFINITY]),
            Some([-1.0, 2.0])
        );
        assert_eq!(extent([f64::NAN]), None);
    }
}
