//! Numbers in words, for people: how many digits, which sign, what stands where there is none.
//!
//! Files have numbers in full, by `cells`.

use super::ticks::short;
use crate::languages::with_sign;

/// Stands where there is no number.
pub const DASH: &str = "–";

/// A number in words, or a dash where there is none or it is not finite.
pub fn or_dash(value: impl Into<Option<f64>>, words: impl FnOnce(f64) -> String) -> String {
    let value = value.into().filter(|value| value.is_finite());
    value.map_or_else(|| DASH.to_owned(), words)
}

pub use crate::languages::{fixed, signed};

/// Significant digits, noughts behind the point left out: `0.0123`, `12.3`.
pub fn significant(value: f64, digits: usize) -> String {
    let decimals = digits.saturating_sub(1);
    short(format!("{value:.decimals$e}").parse().unwrap_or(value))
}

/// Two significant digits.
pub fn two_digits(value: f64) -> String {
    significant(value, 2)
}

/// Three significant digits, as errors are good for; a dash for none.
pub fn figure(value: impl Into<Option<f64>>) -> String {
    or_dash(value, |v| significant(v, 3))
}

/// An error in few letters: less than a ten-thousandth is told as that.
pub fn error(value: f64) -> String {
    or_dash(value, |value| match value {
        v if v < 1e-4 => with_sign("< 0.0001".to_owned()),
        v if v < 0.01 => fixed(v, 4),
        v if v < 1.0 => fixed(v, 3),
        v if v < 100.0 => fixed(v, 2),
        v => fixed(v, 0),
    })
}

/// Decimals, or a dash.
pub fn decimals(value: impl Into<Option<f64>>, digits: usize) -> String {
    or_dash(value, |value| fixed(value, digits))
}

/// Shares below this are the rounding of sums, not of a model.
pub const ROUNDING: f64 = 1e-10;

/// A share in percent, two digits without the sign, three where two would make it all; a dash for
/// none, 0 for rounding.
pub fn percent(share: impl Into<Option<f64>>) -> String {
    or_dash(share, |share| match share {
        share if share.abs() < ROUNDING => "0".to_owned(),
        share if share.abs() < 1.0 && share.abs() >= 0.995 => figure(100.0 * share),
        share => two_digits(100.0 * share),
    })
}

/// A share with its sign of percent and two decimals, or a dash.
pub fn share_words(share: impl Into<Option<f64>>) -> String {
    // Rounded first, so that halves go away from zero.
    or_dash(share, |share| {
        format!("{} %", fixed((1e4 * share).round() / 1e2, 2))
    })
}

/// A small figure of a table: two decimals, so that points stand below each other; what rounds to
/// none of it but is more is "< 0.01", none is a dash.
pub fn hundredths(value: impl Into<Option<f64>>) -> String {
    or_dash(value, |value| match (100.0 * value).round() / 100.0 {
        0.0 if value > 0.0 => with_sign("< 0.01".to_owned()),
        0.0 if value < 0.0 => with_sign("> -0.01".to_owned()),
        rounded => fixed(rounded, 2),
    })
}

/// A colour difference.
pub use hundredths as delta_e;

/// Four decimals where they tell it, four digits elsewhere; a dash for none.
pub fn four_digits(value: impl Into<Option<f64>>) -> String {
    or_dash(value, |value| match value.abs() {
        size if size >= 1e4 || (size > 0.0 && size < 1e-3) => short(value),
        _ => fixed(value, 4),
    })
}

/// Nanoseconds, a decimal below 100.
pub fn nanoseconds(ns: f64) -> String {
    fixed(ns, usize::from(ns < 100.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_figures_have_two_decimals_and_what_is_less_is_said_to_be_less() {
        for (value, words) in [
            (0.0, "0.00"),
            (0.004, "< 0.01"),
            (-0.004, "> -0.01"),
            (0.005_1, "0.01"),
            (12.345, "12.35"),
            (-1.0, "-1.00"),
        ] {
            assert_eq!(hundredths(value), words);
        }
    }

    #[test]
    fn a_zero_has_no_sign() {
        assert_eq!(fixed(-0.000_01, 4), "0.0000");
        assert_eq!(fixed(-0.000_06, 4), "-0.0001");
        assert_eq!(fixed(-0.4, 0), "0");
        assert_eq!(fixed(583.46, 1), "583.5");
        assert_eq!(signed(-0.000_01, 3), "0.000");
        assert_eq!(signed(0.012, 2), "+0.01");
        assert_eq!(share_words(-0.123_45), "-12.35 %");
        assert_eq!(share_words(-1e-9), "0.00 %");
    }

    #[test]
    fn no_number_is_a_dash_and_small_ones_are_bounds() {
        assert_eq!(figure(None), DASH);
        assert_eq!(figure(f64::NAN), DASH);
        assert_eq!(figure(0.012_345), "0.0123");
        assert_eq!([percent(1e-12), percent(0.25)], ["0", "25"]);
        assert_eq!(
            [percent(0.154_6), percent(0.997), percent(1.0)],
            ["15", "99.7", "100"]
        );
        assert_eq!([delta_e(1e-9), delta_e(1.234_5)], ["< 0.01", "1.23"]);
        assert_eq!(error(1e-9), "< 0.0001");
        assert_eq!(error(0.012_34), "0.012");
        assert_eq!(nanoseconds(99.96), "100.0");
    }
}
