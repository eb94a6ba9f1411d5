//! Meanings of keys, and values that are numbers.

use crate::io::decode::json_tree::{Object, Tree};
use crate::io::text::number::{self, Cell};
use crate::io::text::units::names_wavelength;

/// Keys of a sample's name.
pub(super) const NAMES: [&str; 6] = ["name", "title", "label", "id", "sample", "description"];

/// True if a key, its words separated and in lower case, is no name of the content under it.
pub(super) fn is_no_name(plain: &str) -> bool {
    const NO_NAMES: &str = "data;spectrum;spectra;spectral data;values;value;points;samples;sample;\
         measurements;measurement;results;result;spd;series;records;rows;items;meta;metadata;info;\
         main";
    NO_NAMES.split(';').any(|word| word == plain)
}

/// True if a key is "x", which is mostly something else where another key names an axis.
pub(super) fn is_x(key: &str) -> bool {
    key.eq_ignore_ascii_case("x")
}

/// True if keys count rows from 0 or 1, as in tables written with columns as objects.
pub(super) fn row_numbers(object: &Object) -> bool {
    let number = |(key, _): &(String, Tree)| key.parse::<usize>().ok();
    let Some(first @ 0..=1) = object.first().and_then(number) else {
        return false;
    };
    let rows = (first..first + object.len()).map(Some);
    object.iter().map(number).eq(rows)
}

/// The values of a list, or of an object whose keys count rows.
pub(super) fn items(value: &Tree) -> Option<Vec<&Tree>> {
    match value {
        Tree::List(list) => Some(list.iter().collect()),
        Tree::Object(object) if row_numbers(object) => {
            Some(object.iter().map(|(_, item)| item).collect())
        }
        _ => None,
    }
}

/// At least two numbers; `null` and words for a gap mark missing ones.
pub(super) fn numbers(value: &Tree) -> Option<Vec<f64>> {
    let list = items(value).filter(|list| list.len() > 1)?.into_iter();
    let list: Vec<f64> = list.map(one_number).collect::<Option<_>>()?;
    list.iter().any(|number| !number.is_nan()).then_some(list)
}

/// A number, or a word that represents one; NaN for a gap.
pub(super) fn one_number(value: &Tree) -> Option<f64> {
    match value {
        Tree::Nothing => Some(f64::NAN),
        Tree::Number(number) => Some(*number),
        Tree::Text(text) => match number::parse(text, false) {
            Cell::Percent(_) | Cell::Limit(_) | Cell::Empty => None,
            cell => cell.value(),
        },
        Tree::List(_) | Tree::Object(_) => None,
    }
}

/// True if a number has "nm" behind it.
pub(super) fn says_nm(value: &Tree) -> bool {
    let ends = |text: &str| text.trim_end().ends_with("nm");
    value.text().is_some_and(ends)
}

/// True if a key names wavelengths.
pub(super) fn is_axis(key: &str) -> bool {
    names_wavelength(&spaced(key))
}

/// A key as a title: `wavelength_nm` and `wavelengthNm` are "wavelength nm".
pub(super) fn spaced(key: &str) -> String {
    let mut title = String::with_capacity(key.len() + 4);
    let mut before = ' ';
    for letter in key.chars() {
        if letter.is_uppercase() && before.is_lowercase() {
            title.push(' ');
        }
        title.push(if letter == '_' { ' ' } else { letter });
        before = letter;
    }
    title
}
