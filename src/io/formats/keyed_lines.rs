//! Files of one key and one or more values a line, as light meters write them.
//!
//! ```text
//! CCT<TAB>5198.0                    a setting or a result
//! 380nm<TAB>0.030267                a point: the key is a wavelength with its unit
//! Spectral Data 380[nm],0.000012    the same in other words
//! ```
//!
//! The separator (TAB, semicolon or comma) is the one that the points use; decimals may be marked
//! by commas wherever the separator is another.

use std::ops::Range;

use crate::io::error::quoted;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::reading::makers_results::{MakersResult, room_for};
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::text::number::{self, label_nm};
use crate::io::text::{kept_line, lines};
use crate::io::{Input, ReadError, Reading};

/// Most settings kept; further ones are passed over.
const MOST_SETTINGS: usize = 5000;

/// Most columns of values, that is, measurements side by side in one file.
const MOST_COLUMNS: usize = 1000;

/// Beginnings of keys that are settings of an instrument and no results (lower case).
const SETTINGS: [&str; 14] = [
    "i-time",
    "integration",
    "model",
    "serial",
    "time",
    "date",
    "memo",
    "title",
    "name",
    "measuring",
    "viewing",
    "firmware",
    "version",
    "average",
];

/// A key and its values, quotes removed.
#[derive(Clone, Debug)]
struct Setting<'a> {
    key: &'a str,
    values: Vec<&'a str>,
    /// Whether the key names a setting of the instrument rather than a result.
    of_instrument: bool,
}

/// What a file of keys and values holds.
#[derive(Clone, Debug, Default)]
pub(crate) struct KeyedLines<'a> {
    /// Lines whose key is no wavelength.
    settings: Vec<Setting<'a>>,
    /// Wavelengths of the points, nm.
    pub nm: Vec<f64>,
    /// Line of each point.
    pub lines: Vec<u32>,
    /// Values side by side.
    pub columns: usize,
    /// `columns` values a point; NaN where one is missing.
    pub values: Vec<f64>,
    pub decimal_comma: bool,
}

/// The wavelength that a key tells, unit included; the unit of the value may stand behind it in
/// brackets (`380nm(umol/m2s)`).
fn point_nm(key: &str) -> Option<f64> {
    let nm = key.split_once('(').map_or(key, |(nm, _)| nm);
    label_nm(nm.trim())
        .filter(|(_, says_nm)| *says_nm)
        .map(|l| l.0)
}

/// Whether a line is a point: a wavelength with its unit, a separator, a number.
pub(crate) fn is_point(line: &str) -> bool {
    let Some((mark, at)) = separator(line) else {
        return false;
    };
    let value = line[at + 1..].trim();
    point_nm(unquoted(&line[..at])).is_some()
        && value.split(mark).next().is_some_and(|v| {
            v.trim()
                .starts_with(|c: char| c.is_ascii_digit() || "+-.\"".contains(c))
        })
}

/// The first TAB, else semicolon, else comma.
fn separator(line: &str) -> Option<(char, usize)> {
    ['\t', ';', ',']
        .into_iter()
        .find_map(|mark| line.find(mark).map(|at| (mark, at)))
}

/// The cells of a line; a mark inside of quotes separates none, where the quotes come in pairs.
fn split<'a>(line: &'a str, mark: char, cells: &mut Vec<&'a str>) {
    if line.matches('"').count() % 2 == 1 {
        cells.clear();
        cells.extend(line.split(mark).map(str::trim).take(MOST_COLUMNS + 1));
        return;
    }
    let delimiter = match mark {
        '\t' => Delimiter::Tab,
        ';' => Delimiter::Semicolon,
        _ => Delimiter::Comma,
    };
    let dialect = Dialect {
        delimiter,
        decimal_comma: false,
    };
    dialect.split(line, cells);
}

fn unquoted(cell: &str) -> &str {
    cell.trim().trim_matches('"').trim()
}

impl<'a> KeyedLines<'a> {
    /// Splits the text of a meter's file.
    ///
    /// # Errors
    /// [`ReadError`] for a point whose value is a word, and without two points: `none` says what
    /// was found then and what was expected.
    pub(crate) fn of_meter(
        input: &Input,
        text: &'a str,
        none: [&str; 2],
    ) -> Result<Self, ReadError> {
        let (mark, decimal_comma) = mark_of_points(text);
        let mut out = Self {
            decimal_comma,
            ..Self::default()
        };
        let mut cells = Vec::new();
        for (line, content) in lines(text) {
            let content = content.trim_matches(' ');
            if content.trim().is_empty() {
                continue;
            }
            split(content, mark, &mut cells);
            let key = unquoted(cells[0]);
            if cells.len() == 1 {
                out.setting(key, Vec::new());
                continue;
            }
            let Some(nm) = point_nm(key) else {
                let values = cells[1..].iter().take(MOST_COLUMNS);
                out.setting(key, values.map(|cell| unquoted(cell)).collect());
                continue;
            };
            // Comma between key and value and in the value: 0,000012 is one number.
            let behind = [content.split_once(mark).map_or("", |(_, behind)| behind)];
            let values = match decimal_comma && mark == ',' && !content.contains('"') {
                true => &behind[..],
                false => &cells[1..],
            };
            out.point(line, nm, values).map_err(|word| {
                let expected = "a number behind the wavelength";
                input.error(quoted(word), expected).at_line(line)
            })?;
        }
        if out.nm.len() < 2 {
            return Err(input.error(none[0], none[1]));
        }
        Ok(out)
    }

    fn setting(&mut self, key: &'a str, mut values: Vec<&'a str>) {
        while values.last().is_some_and(|v| v.is_empty()) {
            values.pop();
        }
        if self.settings.len() < MOST_SETTINGS {
            let lower: String = key.chars().take(16).collect::<String>().to_lowercase();
            self.settings.push(Setting {
                key,
                values,
                of_instrument: SETTINGS.iter().any(|word| lower.starts_with(word)),
            });
        }
    }

    /// Takes a point; the value that is a word where one is.
    fn point<'c>(&mut self, line: usize, nm: f64, cells: &[&'c str]) -> Result<(), &'c str> {
        if self.nm.is_empty() {
            self.columns = used(cells).clamp(1, MOST_COLUMNS);
        }
        self.nm.push(nm);
        self.lines.push(kept_line(line));
        let before = self.values.len();
        for cell in cells.iter().take(self.columns) {
            let value = number::parse(unquoted(cell), self.decimal_comma).value();
            self.values.push(value.ok_or(*cell)?);
        }
        self.values.resize(before + self.columns, f64::NAN);
        Ok(())
    }

    pub(crate) fn column(&self, column: usize) -> Vec<f64> {
        self.values
            .iter()
            .skip(column)
            .step_by(self.columns.max(1))
            .copied()
            .collect()
    }

    /// What the maker's software computed for one column: every key with a number that is no
    /// setting of the instrument; at most `room` of them.
    pub(crate) fn results(
        &self,
        spectrum: Option<usize>,
        column: usize,
        room: usize,
    ) -> Vec<MakersResult> {
        if room == 0 {
            return Vec::new();
        }
        self.settings
            .iter()
            .filter(|setting| !setting.of_instrument)
            .filter_map(|setting| {
                let value = match setting.values.as_slice() {
                    [value] => value,
                    several if several.len() == self.columns => &several[column],
                    _ => return None,
                };
                MakersResult::of(spectrum, setting.key, value, self.decimal_comma)
            })
            .take(room)
            .collect()
    }

    /// The first filled value of a key, upper or lower case.
    pub(crate) fn get(&self, key: &str) -> Option<&'a str> {
        self.get_of(key, 0)
    }

    /// A column's value of a key; the first column's where there is one only.
    pub(crate) fn get_of(&self, key: &str, column: usize) -> Option<&'a str> {
        self.settings
            .iter()
            .filter(|s| s.key.eq_ignore_ascii_case(key))
            .find_map(|s| s.values.get(column).or(s.values.first()))
            .copied()
            .filter(|v| !v.is_empty())
    }
}

/// The columns of a meter's file as spectra, its results beside them. `of` makes a spectrum of a
/// column, of its values in `points` and of the results.
///
/// # Errors
/// [`ReadError`] when a column's numbers are no spectrum, or no column has any.
pub(crate) fn reading_of<'k>(
    input: &Input,
    found: &'k KeyedLines<'_>,
    points: Range<usize>,
    of: impl Fn(usize, Vec<f64>, &[MakersResult]) -> RawSpectrum<'k>,
) -> Result<Reading, ReadError> {
    let mut reading = Reading::default();
    for column in 0..found.columns {
        let values = found.column(column)[points.clone()].to_vec();
        if found.columns > 1 && values.iter().filter(|v| v.is_finite()).count() < 2 {
            continue;
        }
        let index = reading.spectra.len();
        let results = found.results(Some(index), column, room_for(reading.results.len()));
        let mut spectrum = of(column, values, &results);
        spectrum.lines = &found.lines[points.clone()];
        interpret(
            spectrum.with_comma(found.decimal_comma),
            input,
            &mut reading,
        )?;
        reading.results.extend(results);
    }
    if reading.spectra.is_empty() {
        return Err(input.error(
            "wavelengths and no values",
            "a value behind each wavelength",
        ));
    }
    if !reading.results.is_empty() {
        reading.notes.push(format!(
            "{} results of the instrument kept beside the spectrum",
            reading.results.len()
        ));
    }
    Ok(reading)
}

/// The separator of the points, and whether their decimals are marked by commas.
fn mark_of_points(text: &str) -> (char, bool) {
    let mut points = lines(text).filter(|(_, line)| is_point(line)).take(50);
    let Some((_, first)) = points.next() else {
        let mark = ['\t', ';', ','].into_iter().find(|mark| {
            lines(text)
                .take(50)
                .filter(|(_, l)| l.contains(*mark))
                .count()
                >= 2
        });
        return (
            mark.unwrap_or(','),
            mark == Some(';') && !text.contains('.'),
        );
    };
    let mark = separator(first).map_or(',', |s| s.0);
    let (mut points_seen, mut commas_seen, mut in_two) = (0, 0, 0);
    for (_, line) in std::iter::once((0, first)).chain(points) {
        let value = line.split_once(mark).map_or("", |(_, v)| v);
        points_seen += usize::from(value.contains('.'));
        commas_seen += usize::from(value.contains(','));
        in_two += usize::from(value.matches(',').count() == 1);
    }
    let comma = match mark {
        ',' => points_seen == 0 && commas_seen > 0 && commas_seen == in_two,
        _ => commas_seen > points_seen,
    };
    (mark, comma)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn split_up(text: &str) -> Result<KeyedLines<'_>, ReadError> {
        KeyedLines::of_meter(&Input::new("a.csv", b""), text, ["nothing", "points"])
    }

    #[test]
    fn settings_and_points_are_told_apart() {
        let found =
            split_up("Model Name\tX\nCCT\t5198.5\n380nm\t0.5\n381nm\t0.25\nR1\t9\n").unwrap();
        assert_eq!(found.nm, [380.0, 381.0]);
        assert_eq!(found.values, [0.5, 0.25]);
        assert_eq!(found.get("cct"), Some("5198.5"));
        assert_eq!(found.settings.len(), 3);
    }

    #[test]
    fn decimal_commas_and_columns_side_by_side_are_read() {
        for (text, columns, values) in [
            ("380nm;0,5\n381nm;0,25\n", 1, vec![0.5, 0.25]),
            (
                "380nm\t0,5\t1,5\n381nm\t0,25\t\n",
                2,
                vec![0.5, 1.5, 0.25, f64::NAN],
            ),
            ("A 380[nm],0,5\nA 381[nm],0,25\n", 1, vec![0.5, 0.25]),
            (
                "380nm,0.5,1.5\n381nm,0.25,2.5\n",
                2,
                vec![0.5, 1.5, 0.25, 2.5],
            ),
            (
                "\"380 nm\",\"0.5\"\n\"381 nm\",\"0.25\"\n",
                1,
                vec![0.5, 0.25],
            ),
        ] {
            let found = split_up(text).unwrap();
            assert_eq!(found.columns, columns, "{text}");
            // A gap is equal to nothing, and its words are.
            let (found, values) = (format!("{:?}", found.values), format!("{values:?}"));
            assert_eq!(found, values, "{text}");
        }
    }

    #[test]
    fn a_comma_inside_of_quotes_belongs_to_the_value() {
        let text = "Title,\"A, B\"\nIlluminance [lx],\"1,234.5\"\nMemo,5\" lamp, old\n\
                    Spectral Data 380[nm],0.5\nSpectral Data 381[nm],\"0.25\"\n";
        let found = split_up(text).unwrap();
        assert_eq!(found.get("Title"), Some("A, B"));
        assert_eq!(found.get("Memo"), Some("5\" lamp"));
        assert_eq!(found.values, [0.5, 0.25]);
        let results = found.results(None, 0, 10);
        assert_eq!(results[0].value, 1234.5);
    }

    #[test]
    fn a_word_in_a_point_is_an_error_with_its_line() {
        let bad = split_up("380nm\t1\n381nm\tabc\n").unwrap_err();
        assert_eq!((bad.line, bad.found.as_str()), (Some(2), "\"abc\""));
    }
}
