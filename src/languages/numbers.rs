//! Numbers as the language spoken writes them.

use std::borrow::Borrow;

use super::spoken;

/// Decimals, and no minus before a zero.
pub fn fixed(value: impl Borrow<f64>, digits: usize) -> String {
    let words = format!("{:.digits$}", value.borrow());
    with_sign(match words.strip_prefix('-') {
        Some(rest) if is_zero(rest) => rest.to_owned(),
        _ => words,
    })
}

/// Decimals with a sign; a zero has none.
pub fn signed(value: impl Borrow<f64>, digits: usize) -> String {
    let words = format!("{:+.digits$}", value.borrow());
    with_sign(if is_zero(&words[1..]) {
        words[1..].to_owned()
    } else {
        words
    })
}

fn is_zero(digits: &str) -> bool {
    digits.chars().all(|c| matches!(c, '0' | '.'))
}

/// A number that is written with a point, with the decimal sign of the language.
pub fn with_sign(number: String) -> String {
    match spoken().decimal_sign() {
        '.' => number,
        sign => number.replace('.', sign.encode_utf8(&mut [0; 4])),
    }
}
