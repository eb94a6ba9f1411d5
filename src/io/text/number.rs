//! One cell of a table: a number, a gap, or text.

/// The content of a cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Cell {
    /// A finite number.
    Number(f64),
    /// A finite number with a per cent sign behind it.
    Percent(f64),
    /// A wavelength with its unit behind it: `380nm`, `Spectral Data 380[nm]`.
    Nanometres(f64),
    /// A finite number with a unit of light behind it: `58 W`, `0.2 mW/m2`.
    WithUnit(f64),
    /// A limit that the number lies below or above: `<0.6`.
    Limit(f64),
    /// Nothing at all.
    Empty,
    /// A word or number that stands for a missing value: `NaN`, `n/a`, `-1.23e34`.
    Gap,
    /// Anything else.
    Text,
}

impl Cell {
    /// The number, whatever stands behind it; NaN for a missing value, `None` for a word.
    pub(crate) fn value(self) -> Option<f64> {
        match self {
            Self::Number(value)
            | Self::Percent(value)
            | Self::Nanometres(value)
            | Self::Limit(value)
            | Self::WithUnit(value) => Some(value),
            Self::Empty | Self::Gap => Some(f64::NAN),
            Self::Text => None,
        }
    }

    /// The same where nothing may stand behind the number.
    pub(crate) fn plain_value(self) -> Option<f64> {
        match self {
            Self::Percent(_) | Self::Nanometres(_) | Self::WithUnit(_) | Self::Limit(_) => None,
            other => other.value(),
        }
    }
}

/// Numbers of this size and beyond stand for "not measured" (USGS writes -1.23e34), never for light.
pub const ABSURD: f64 = 1e30;

/// Words that instruments and programs write where a value is missing (lower case).
const GAP_WORDS: &str = "nan;n/a;na;#n/a;null;none;inf;-inf;+inf;infinity;-infinity;-;--;---;1.#ind;-1.#ind;\
     1.#qnan;1.#inf;#div/0!;#name?;#null!;#num!;#ref!;#value!;missing";

/// Reads a cell whose decimal mark is a comma (`decimal_comma`) or a point.
pub(crate) fn parse(cell: &str, decimal_comma: bool) -> Cell {
    let cell = cell.trim_ascii();
    if let Some(value) = number(cell, decimal_comma) {
        return sized(value, Cell::Number);
    }
    slow(cell, decimal_comma)
}

/// A number in its kind of cell, or a gap where it is of no size that anything has.
fn sized(value: f64, cell: fn(f64) -> Cell) -> Cell {
    if is_measured(value) {
        cell(value)
    } else {
        Cell::Gap
    }
}

/// True if a number can have been measured: neither NaN nor [`ABSURD`].
pub(crate) fn is_measured(value: f64) -> bool {
    value.abs() < ABSURD
}

/// The longest cell that may be anything but words, in bytes.
const LONGEST_CELL: usize = 256;

/// The cells that are not plain numbers; rare in a table, so not in the hot path.
fn slow(cell: &str, decimal_comma: bool) -> Cell {
    let cell = cell.trim_matches(|c: char| c.is_whitespace() || c == '"' || c == '\'');
    if cell.is_empty() {
        return Cell::Empty;
    }
    if cell.len() > LONGEST_CELL {
        return Cell::Text;
    }
    let plain = number(cell, decimal_comma).or_else(|| in_thousands(cell, decimal_comma));
    if let Some(value) = plain {
        return sized(value, Cell::Number);
    }
    if cell.len() <= 12
        && GAP_WORDS
            .split(';')
            .any(|word| cell.eq_ignore_ascii_case(word))
    {
        return Cell::Gap;
    }
    if let Some(body) = cell.strip_suffix('%') {
        return number(body.trim(), decimal_comma)
            .map_or(Cell::Text, |value| sized(value, Cell::Percent));
    }
    if !cell.bytes().any(|byte| byte.is_ascii_digit()) {
        return Cell::Text;
    }
    if let Some(limit) = cell.strip_prefix(['<', '>', '≤', '≥']) {
        let limit = number(limit.trim(), decimal_comma);
        return limit.map_or(Cell::Text, |value| sized(value, Cell::Limit));
    }
    if let Some(value) = in_brackets(cell, decimal_comma) {
        return sized(-value, Cell::Number);
    }
    // A typographic minus, and Fortran's double exponent.
    let is_odd = cell.len() <= 40 && cell.contains(['−', 'D', 'd']);
    let plain = is_odd.then(|| cell.replace('−', "-").replace(['D', 'd'], "e"));
    // "380: 58".
    let plain = plain
        .as_deref()
        .or_else(|| Some(cell.strip_suffix(':')?.trim_end()));
    if let Some(value) = plain.and_then(|plain| number(plain, decimal_comma)) {
        return sized(value, Cell::Number);
    }
    if let Some((value, true)) = label_nm(cell) {
        return sized(value, Cell::Nanometres);
    }
    let body = unit_behind(cell).map(|unit| cell[..cell.len() - unit.len()].trim_end());
    body.and_then(|body| number(body, decimal_comma))
        .map_or(Cell::Text, |value| sized(value, Cell::WithUnit))
}

/// A number in brackets, as accountants write negative ones; a whole one may be a footnote's.
fn in_brackets(cell: &str, decimal_comma: bool) -> Option<f64> {
    let body = cell.strip_prefix('(')?.strip_suffix(')')?;
    let mark = if decimal_comma { ',' } else { '.' };
    number(body, decimal_comma).filter(|value| *value >= 0.0 && body.contains(mark))
}

/// The prefixes of units of light.
const UNITS: [&str; 8] = ["W", "mW", "uW", "µW", "μW", "kW", "counts", "a.u."];

/// The unit of light behind a number and a blank: `58 W/m2`.
pub(crate) fn unit_behind(cell: &str) -> Option<&str> {
    let cell = cell.trim_matches(|c: char| c.is_whitespace() || c == '"');
    let unit = cell.split_once(char::is_whitespace)?.1.trim_start();
    let behind = |start: &&str| unit.strip_prefix(*start);
    let ends = |rest: &str| rest.is_empty() || rest.starts_with(['/', ' ', '·', '*']);
    let is_unit = UNITS.iter().filter_map(behind).any(ends);
    (is_unit && unit.len() <= 40).then_some(unit)
}

/// A number whose thousands are set apart, as spreadsheets write it: `1.344,49` with a decimal comma,
/// `1,630.3` with a point, `1 630,3` or `1'630.3` with either. Without decimals only the apostrophe
/// and the blank tell: `1,630` may be a number below two.
fn in_thousands(cell: &str, decimal_comma: bool) -> Option<f64> {
    if cell.len() > 40 {
        return None;
    }
    let (mark, other) = if decimal_comma {
        (',', '.')
    } else {
        ('.', ',')
    };
    let separator = cell
        .chars()
        .find(|c| [other, ' ', '\u{a0}', '\u{202f}', '\'', '’'].contains(c))?;
    let (whole, decimals) = match cell.split_once(mark) {
        Some((whole, decimals)) => (whole, decimals),
        None if separator != other => (cell, ""),
        None => return None,
    };
    let fits = is_grouped(whole.trim_start_matches(['-', '+']), separator) && is_digits(decimals);
    let plain: String = whole.chars().filter(|c| *c != separator).collect();
    fits.then(|| format!("{plain}.{decimals}0").parse().ok())?
}

fn is_digits(text: &str) -> bool {
    text.bytes().all(|b| b.is_ascii_digit())
}

/// True if digits form groups of three, the first of which may be shorter.
pub(crate) fn is_grouped(digits: &str, separator: char) -> bool {
    let mut groups = digits.split(separator);
    let first = groups.next().unwrap_or("");
    (1..=3).contains(&first.len())
        && is_digits(first)
        && groups.all(|group| group.len() == 3 && is_digits(group))
}

/// A finite or overflowing decimal number and nothing else; `inf` and `nan` are words, not numbers.
pub(crate) fn number(cell: &str, decimal_comma: bool) -> Option<f64> {
    let bytes = cell.as_bytes();
    let (first, last) = (*bytes.first()?, *bytes.last()?);
    let starts = matches!(first, b'0'..=b'9' | b'+' | b'-' | b'.' | b',');
    if !starts || !matches!(last, b'0'..=b'9' | b'.') {
        return None;
    }
    if !decimal_comma {
        return cell.parse().ok();
    }
    let Some(comma) = bytes.iter().position(|b| *b == b',') else {
        return cell.parse().ok().filter(|_| !bytes.contains(&b'.'));
    };
    let mut buffer = [0u8; 64];
    let copy = buffer.get_mut(..bytes.len())?;
    copy.copy_from_slice(bytes);
    copy[comma] = b'.';
    // A second mark of either kind makes two points, which no number has.
    std::str::from_utf8(copy).ok()?.parse().ok()
}

/// The wavelength in a label, and whether "nm" follows it: `380nm`, `Spectral Data 380[nm]`,
/// `SPEC_380`, `nm380`, `R 400.5 nm`. Letters may stand before the number, digits may not.
pub(crate) fn label_nm(label: &str) -> Option<(f64, bool)> {
    let label = label.trim();
    let start = label.find(|c: char| c.is_ascii_digit())?;
    let rest = &label[start..];
    let end = rest
        .find(|c: char| !c.is_ascii_digit() && c != '.')
        .unwrap_or(rest.len());
    let unit = rest[end..].trim();
    let has_unit = ["nm", "[nm]", "(nm)"]
        .iter()
        .any(|known| unit.eq_ignore_ascii_case(known));
    if !has_unit && !unit.is_empty() {
        return None;
    }
    let before = label[..start].trim_end();
    if before.ends_with(['-', '+', '.', ',', '(', '~', '/']) {
        return None;
    }
    Some((rest[..end].parse().ok()?, has_unit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_read_as_what_it_stands_for_in_every_spelling_met() {
        let number = Cell::Number;
        for (cells, comma, kind) in [
            ("380|380:", false, number(380.0)),
            ("4.770109669322E2", false, number(477.010_966_932_2)),
            ("7.935132e-011", false, number(7.935_132e-11)),
            ("7,464650E+000", true, number(7.464_65)),
            (",5", true, number(0.5)),
            ("-0,25", true, number(-0.25)),
            ("2.5D+02", false, number(250.0)),
            ("−3", false, number(-3.0)),
            ("\"1.5\"", false, number(1.5)),
            // Thousands set apart, where decimals follow.
            ("1.344,49", true, number(1344.49)),
            ("\"1,630.3\"", false, number(1630.3)),
            ("-1 630,3", true, number(-1630.3)),
            ("1'234'567.5", false, number(1_234_567.5)),
            ("1'630", false, number(1630.0)),
            ("38 500", true, number(38_500.0)),
            ("(0.503)", false, number(-0.503)),
            ("45.5 %", false, Cell::Percent(45.5)),
            ("58 W", false, Cell::WithUnit(58.0)),
            ("0,2 mW/m2", true, Cell::WithUnit(0.2)),
            ("<0.6", false, Cell::Limit(0.6)),
            // The other decimal mark, or a word.
            ("1,630|1,63.5|0,5", false, Cell::Text),
            ("1.63.5,0|38 50|0.5|(5)|300,", true, Cell::Text),
            ("5 Wide|W|12:30|60 Watch", false, Cell::Text),
            ("Custom1(655~665nm)|R14", false, Cell::Text),
            // Gaps are known by word and by absurd size.
            ("NaN|n/a|-1.23e34|inf|-|1.#QNAN|1e999", false, Cell::Gap),
            ("  ", false, Cell::Empty),
            (
                "380nm|Spectral Data 380[nm]",
                false,
                Cell::Nanometres(380.0),
            ),
        ] {
            for cell in cells.split('|') {
                assert_eq!(parse(cell, comma), kind, "{cell}");
            }
        }
        assert_eq!(unit_behind("0,2 mW/m2"), Some("mW/m2"));
    }

    #[test]
    fn a_wavelength_may_stand_in_a_label() {
        assert_eq!(label_nm("SPEC_380"), Some((380.0, false)));
        assert_eq!(label_nm("nm380"), Some((380.0, false)));
        assert_eq!(label_nm("TL-01"), None);
    }
}
