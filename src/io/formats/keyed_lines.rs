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

use super::rows::Rows;
use crate::io::error::quoted;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::reading::makers_results::{MakersResult, room_for};
use crate::io::text::dialect::{Delimiter, Dialect, used};
use crate::io::text::lines;
use crate::io::text::number::{self, label_nm};
use crate::io::{Input, ReadError, Reading};

/// Most settings kept; further ones are passed over.
const MOST_SETTINGS: usize = 5000;

/// Most columns of values, that is, measurements side by side in one file.
const MOST_COLUMNS: usize = 1000;

/// Beginnings of keys that are settings of an instrument and no results (lower case).
const SETTINGS: &str = "i-time integration model serial time date memo title name measuring \
     viewing firmware version average";

/// Separators allowed between a key and its values.
const MARKS: [(Delimiter, char); 3] = [
    (Delimiter::Tab, '\t'),
    (Delimiter::Semicolon, ';'),
    (Delimiter::Comma, ','),
];

/// A key and its values, quotes removed.
#[derive(Clone, Debug)]
struct Setting<'a> {
    key: &'a str,
    values: Vec<&'a str>,
    /// True if the key names a setting of the instrument rather than a result.
    of_instrument: bool,
}

/// The contents of a file of keys and values.
#[derive(Default)]
pub(crate) struct KeyedLines<'a> {
    /// Lines whose key is no wavelength.
    settings: Vec<Setting<'a>>,
    /// Wavelengths in nm and the values side by side behind them.
    points: Rows,
    decimal_comma: bool,
}

/// The wavelength given by a key, unit included; the unit of the value may follow it in
/// brackets (`380nm(umol/m2s)`).
fn point_nm(key: &str) -> Option<f64> {
    let nm = key.split_once('(').map_or(key, |(nm, _)| nm);
    let (nm, says_nm) = label_nm(nm.trim())?;
    says_nm.then_some(nm)
}

/// True if a line is a point: a wavelength with its unit, a separator, a number.
pub(crate) fn is_point(line: &str) -> bool {
    let parts = separator(line).and_then(|(_, mark)| Some((mark, line.split_once(mark)?)));
    parts.is_some_and(|(mark, (key, values))| {
        let value = values.trim().split(mark).next().unwrap_or("").trim();
        let is_number = value.starts_with(|c: char| c.is_ascii_digit() || "+-.\"".contains(c));
        is_number && point_nm(unquoted(key)).is_some()
    })
}

/// TAB where a line has one, else semicolon, else comma.
fn separator(line: &str) -> Option<(Delimiter, char)> {
    MARKS.into_iter().find(|(_, mark)| line.contains(*mark))
}

/// The cells of a line; a mark inside of quotes separates none, where the quotes come in pairs.
fn split<'a>(line: &'a str, (delimiter, mark): (Delimiter, char), cells: &mut Vec<&'a str>) {
    if line.matches('"').count() % 2 == 1 {
        cells.clear();
        cells.extend(line.split(mark).map(str::trim).take(MOST_COLUMNS + 1));
        return;
    }
    Dialect::new(delimiter, false).split(line, cells);
}

fn unquoted(cell: &str) -> &str {
    cell.trim().trim_matches('"').trim()
}

impl<'a> KeyedLines<'a> {
    /// Splits the text of a meter's file.
    ///
    /// # Errors
    /// [`ReadError`] for a point whose value is a word, and without two points: `none` is then the
    /// finding and the expectation in words.
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
        for (line, content) in lines(text).filter(|(_, content)| !content.trim().is_empty()) {
            let content = content.trim_matches(' ');
            split(content, mark, &mut cells);
            let key = unquoted(cells[0]);
            let Some(nm) = point_nm(key).filter(|_| cells.len() > 1) else {
                let values = cells[1..].iter().take(MOST_COLUMNS);
                out.setting(key, values.map(|cell| unquoted(cell)).collect());
                continue;
            };
            // Comma between key and value and in the value: 0,000012 is one number.
            let behind = [content.split_once(mark.1).map_or("", |(_, behind)| behind)];
            let values = match decimal_comma && mark.1 == ',' && !content.contains('"') {
                true => &behind[..],
                false => &cells[1..],
            };
            let expected = said!("a number behind the wavelength");
            out.point(line, nm, values)
                .map_err(|word| input.error_at(line, quoted(word), expected))?;
        }
        if out.nm().len() < 2 {
            return Err(input.error(none[0], none[1]));
        }
        Ok(out)
    }

    fn setting(&mut self, key: &'a str, mut values: Vec<&'a str>) {
        values.truncate(used(&values));
        if self.settings.len() < MOST_SETTINGS {
            let lower: String = key.chars().take(16).collect::<String>().to_lowercase();
            self.settings.push(Setting {
                key,
                values,
                of_instrument: SETTINGS.split(' ').any(|word| lower.starts_with(word)),
            });
        }
    }

    /// Takes a point; the value that is a word where one is.
    fn point<'c>(&mut self, line: usize, nm: f64, cells: &[&'c str]) -> Result<(), &'c str> {
        let columns = match self.columns() {
            0 => used(cells).clamp(1, MOST_COLUMNS),
            columns => columns,
        };
        let mut row = vec![nm];
        for cell in cells.iter().take(columns) {
            let value = number::parse(unquoted(cell), self.decimal_comma).value();
            row.push(value.ok_or(*cell)?);
        }
        row.resize(1 + columns, f64::NAN);
        self.points.add(line, &row);
        Ok(())
    }

    /// The number of values of each point.
    pub(crate) fn columns(&self) -> usize {
        self.points.columns.len().saturating_sub(1)
    }

    /// Wavelengths of the points.
    pub(crate) fn nm(&self) -> &[f64] {
        self.points.columns.first().map_or(&[], Vec::as_slice)
    }

    /// Line of each point.
    pub(crate) fn lines(&self) -> &[u32] {
        &self.points.lines
    }

    /// The results of the maker's software for one column: every key with a number that is no
    /// setting of the instrument; at most `room` of them.
    pub(crate) fn results(
        &self,
        spectrum: Option<usize>,
        column: usize,
        room: usize,
    ) -> Vec<MakersResult> {
        let results = self.settings.iter().filter(|s| !s.of_instrument);
        let results = results.filter_map(|setting| {
            let value = match setting.values.as_slice() {
                [value] => value,
                several if several.len() == self.columns() => &several[column],
                _ => return None,
            };
            MakersResult::of(spectrum, setting.key, value, self.decimal_comma)
        });
        results.take(room).collect()
    }

    /// The first filled value of a key, upper or lower case.
    pub(crate) fn get(&self, key: &str) -> Option<&'a str> {
        self.get_of(key, 0)
    }

    /// A column's value of a key; the first column's where there is one only.
    pub(crate) fn get_of(&self, key: &str, column: usize) -> Option<&'a str> {
        let mut named = self
            .settings
            .iter()
            .filter(|s| s.key.eq_ignore_ascii_case(key));
        let value = named.find_map(|s| s.values.get(column).or(s.values.first()));
        value.copied().filter(|v| !v.is_empty())
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
    for column in 0..found.columns() {
        let values = found.points.columns[column + 1][points.clone()].to_vec();
        if found.columns() > 1 && values.iter().filter(|v| v.is_finite()).count() < 2 {
            continue;
        }
        let index = reading.spectra.len();
        let results = found.results(Some(index), column, room_for(reading.results.len()));
        let mut spectrum = of(column, values, &results);
        spectrum.lines = &found.lines()[points.clone()];
        let spectrum = spectrum.with_comma(found.decimal_comma);
        interpret(spectrum, input, &mut reading)?;
        reading.results.extend(results);
    }
    if reading.spectra.is_empty() {
        let expected = said!("a value behind each wavelength");
        return Err(input.error(said!("wavelengths and no values"), expected));
    }
    let results = reading.results.len();
    if results > 0 {
        let note = tr!("{n} results of the instrument kept beside the spectrum"
            | "{n} results of the instrument kept beside the spectrum" % results);
        reading.notes.push(note);
    }
    Ok(reading)
}

/// The separator of the points, and true if their decimals are marked by commas.
fn mark_of_points(text: &str) -> ((Delimiter, char), bool) {
    let all = lines(text).map(|(_, line)| line);
    let points: Vec<&str> = all.filter(|line| is_point(line)).take(50).collect();
    let Some(mark) = points.first().and_then(|first| separator(first)) else {
        let with = |mark| lines(text).take(50).filter(move |(_, l)| l.contains(mark));
        let twice = |(_, mark): &(Delimiter, char)| with(*mark).nth(1).is_some();
        let mark = MARKS.into_iter().find(twice).unwrap_or(MARKS[2]);
        return (mark, mark.1 == ';' && !text.contains('.'));
    };
    let values = points
        .iter()
        .map(|line| line.split_once(mark.1).map_or("", |(_, v)| v));
    let with = |sign: char| values.clone().filter(|value| value.contains(sign)).count();
    let (with_point, with_comma) = (with('.'), with(','));
    let comma = match mark.1 {
        ',' => {
            let once = |value: &str| value.matches(',').count() < 2;
            with_point == 0 && with_comma > 0 && values.clone().all(once)
        }
        _ => with_comma > with_point,
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
        assert_eq!(found.points.columns, [[380.0, 381.0], [0.5, 0.25]]);
        assert_eq!(found.get("cct"), Some("5198.5"));
        assert_eq!(found.settings.len(), 3);
    }

    #[test]
    fn decimal_commas_and_columns_side_by_side_are_read() {
        for (text, columns) in [
            ("380nm;0,5\n381nm;0,25\n", vec![[0.5, 0.25]]),
            (
                "380nm\t0,5\t1,5\n381nm\t0,25\t\n",
                vec![[0.5, 0.25], [1.5, f64::NAN]],
            ),
            ("A 380[nm],0,5\nA 381[nm],0,25\n", vec![[0.5, 0.25]]),
            (
                "380nm,0.5,1.5\n381nm,0.25,2.5\n",
                vec![[0.5, 0.25], [1.5, 2.5]],
            ),
            (
                "\"380 nm\",\"0.5\"\n\"381 nm\",\"0.25\"\n",
                vec![[0.5, 0.25]],
            ),
        ] {
            let found = split_up(text).unwrap();
            // A gap is equal to nothing, and its words are.
            let (found, columns) = (&found.points.columns[1..], format!("{columns:?}"));
            assert_eq!(format!("{found:?}"), columns, "{text}");
        }
    }

    #[test]
    fn a_comma_inside_of_quotes_belongs_to_the_value() {
        let text = "Title,\"A, B\"\nIlluminance [lx],\"1,234.5\"\nMemo,5\" lamp, old\n\
                    Spectral Data 380[nm],0.5\nSpectral Data 381[nm],\"0.25\"\n";
        let found = split_up(text).unwrap();
        assert_eq!(found.get("Title"), Some("A, B"));
        assert_eq!(found.get("Memo"), Some("5\" lamp"));
        assert_eq!(found.points.columns[1], [0.5, 0.25]);
        let results = found.results(None, 0, 10);
        assert_eq!(results[0].value, 1234.5);
    }

    #[test]
    fn a_word_in_a_point_is_an_error_with_its_line() {
        let bad = split_up("380nm\t1\n381nm\tabc\n").err().unwrap();
        assert_eq!((bad.line, bad.found.as_str()), (Some(2), "\"abc\""));
    }
}
