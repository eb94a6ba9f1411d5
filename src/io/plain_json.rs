//! JSON of no program in particular: lists of numbers beside a list of wavelengths.
//!
//! ```text
//! {"name": "lamp", "unit": "W/m2/nm", "wavelengths": [380, 390, ..], "values": [..], "other": [..]}
//! {"wavelength_nm": [..], "samples": [{"name": "A", "reflectance": [..]}, ..]}
//! [{"wavelength": 380, "value": 0.1}, ..]      [[380, 0.1], [390, 0.2], ..]      {"380": 0.1, ..}
//! {"start": 380, "end": 730, "interval": 10, "values": [..]}      {"bands": [400, 410, ..], ..}
//! {"wavelength": {"0": 380, "1": 390, ..}, "value": {"0": 0.1, "1": 0.2, ..}}
//! ```
//!
//! What the words mean is decided as in a table of text: keys are the titles of columns, and other
//! words beside them are the lines above it. Keys above several tables are their names.

pub mod range;
pub mod tree;

use std::collections::HashMap;

use super::error::kept;
use super::heading::Heading;
use super::interpret::interpret;
use super::interpret::raw::{RawSpectrum, Scale};
use super::kinds;
use super::number::{self, Cell};
use super::units::names_wavelength;
use super::{Input, ReadError, Reading};
use range::Ends;
use tree::{Object, Tree};

/// How deep in a file spectra are looked for.
const DEPTH: usize = 8;

/// Most words beside a table that are kept, and most bytes of them: every table is read with all.
const MOST_WORDS: usize = 100;
const MOST_WORD_BYTES: usize = 4096;

/// Bytes of words that are read with the tables of one file altogether, besides twice its size;
/// with further tables only the start of the nearest line is.
const MOST_BYTES_READ: usize = 1 << 19;
const NEAREST_BYTES: usize = 60;

/// Keys under which a sample's name stands.
const NAMES: [&str; 6] = ["name", "title", "label", "id", "sample", "description"];

/// Keys that are no names of what stands under them.
const NO_NAMES: [&str; 22] = [
    "data",
    "spectrum",
    "spectra",
    "spectral data",
    "values",
    "value",
    "points",
    "samples",
    "sample",
    "measurements",
    "measurement",
    "results",
    "result",
    "spd",
    "series",
    "records",
    "rows",
    "items",
    "meta",
    "metadata",
    "info",
    "main",
];

/// Least and greatest number, nm, of a list that only its key's last word tells to be one of
/// wavelengths.
const BANDS_NM: std::ops::RangeInclusive<f64> = 100.0..=50_000.0;

/// Memory that a table of points may take for each key in the file: not every point has every key.
const CELLS_A_KEY: usize = 8;

/// Most lists of one object that are tried as wavelengths.
const MOST_AXES: usize = 8;

/// Wavelengths and the lists of values beside them.
struct Table<'a> {
    axis_title: String,
    says_nm: bool,
    axis: Vec<f64>,
    columns: Vec<Column<'a>>,
}

/// A list of values.
struct Column<'a> {
    /// The key above it: what is measured.
    title: &'a str,
    /// What its sample is called.
    name: Option<&'a str>,
    values: Vec<f64>,
}

/// Adds all spectra that a JSON value holds; none where it holds no wavelengths.
///
/// # Errors
/// [`ReadError`] when numbers beside wavelengths are no spectrum.
pub fn read(input: &Input, value: &Tree, reading: &mut Reading) -> Result<(), ReadError> {
    let mut finder = Finder {
        input,
        reading,
        words: Vec::new(),
        bytes: 0,
        bytes_read: 0,
    };
    finder.look(value, DEPTH)
}

/// Looks for tables and adds their spectra.
struct Finder<'i, 'f, 'r> {
    input: &'i Input<'f>,
    reading: &'r mut Reading,
    /// Words of the objects around, the innermost last.
    words: Vec<String>,
    /// Of those words.
    bytes: usize,
    /// Of words read with tables so far.
    bytes_read: usize,
}

impl Finder<'_, '_, '_> {
    fn look(&mut self, value: &Tree, depth: usize) -> Result<(), ReadError> {
        let Some(depth) = depth.checked_sub(1) else {
            return Ok(());
        };
        match value {
            Tree::Object(object) => self.look_in_object(value, object, depth),
            Tree::List(list) => match of_points(value).or_else(|| of_rows(list)) {
                Some(table) => self.add(table),
                None => list.iter().try_for_each(|inner| self.look(inner, depth)),
            },
            _ => Ok(()),
        }
    }

    fn look_in_object(
        &mut self,
        value: &Tree,
        object: &Object,
        depth: usize,
    ) -> Result<(), ReadError> {
        let outside = (self.words.len(), self.bytes);
        for line in words_of(object) {
            self.push(line);
        }
        let table = of_lists(object)
            .or_else(|| of_points(value))
            .or_else(|| of_keys(object));
        let outcome = match table {
            Some(table) => self.add(table),
            None => self.look_below(object, depth),
        };
        self.forget(outside);
        outcome
    }

    /// Looks at what stands under the keys, which are names where there are several.
    fn look_below(&mut self, object: &Object, depth: usize) -> Result<(), ReadError> {
        let several = object
            .iter()
            .filter(|(_, inner)| inner.holds_values())
            .count()
            > 1;
        for (key, inner) in object.iter().filter(|(_, inner)| inner.holds_values()) {
            let outside = (self.words.len(), self.bytes);
            let plain = spaced(key).to_lowercase();
            if several && !NO_NAMES.contains(&plain.trim()) {
                let is_kind = kinds::kind_of_title(&plain).is_some();
                let is_number = number::number(key.trim(), false).is_some();
                self.push(if is_kind || is_number {
                    format!("name: {} {}", self.input.stem(), kept(key))
                } else {
                    format!("name: {}", kept(key))
                });
            }
            let outcome = self.look(inner, depth);
            self.forget(outside);
            outcome?;
        }
        Ok(())
    }

    /// Remembers a line, unless there are many already.
    fn push(&mut self, line: String) {
        if self.words.len() < MOST_WORDS && self.bytes + line.len() <= MOST_WORD_BYTES {
            self.bytes += line.len();
            self.words.push(line);
        }
    }

    fn forget(&mut self, (lines, bytes): (usize, usize)) {
        self.words.truncate(lines);
        self.bytes = bytes;
    }

    fn add(&mut self, table: Table) -> Result<(), ReadError> {
        self.bytes_read += self.bytes;
        let most_read = MOST_BYTES_READ + 2 * self.input.bytes.len();
        let lines: Vec<(usize, &str)> = if self.bytes_read <= most_read {
            self.words.iter().map(|line| (0, &**line)).collect()
        } else {
            let start = |line: &str| line.floor_char_boundary(NEAREST_BYTES);
            let nearest = self.words.last().map(|line| (0, &line[..start(line)]));
            nearest.into_iter().collect()
        };
        let heading = Heading::of(&lines).shared_by(table.columns.len());
        let scale = Scale::new(&table.axis);
        let several = table.columns.len() > 1;
        let are_channels = are_channels(&table.columns);
        let stem = heading.name.unwrap_or(self.input.stem());
        for column in table.columns {
            let name = match (column.name, several) {
                (Some(name), _) => name.to_owned(),
                (None, true) if !column.title.is_empty() => format!("{stem} {}", column.title),
                _ => stem.to_owned(),
            };
            let axis_title = &table.axis_title;
            let raw = RawSpectrum::written(name, &scale, axis_title, column.values, &heading);
            let raw = RawSpectrum {
                title: match are_channels {
                    true => title_of_channel(column.title).to_owned(),
                    false => spaced(column.title),
                },
                ..raw.saying_nm(table.says_nm)
            };
            interpret(raw, self.input, self.reading)?;
        }
        Ok(())
    }
}

/// Whether columns are a camera's or a display's red, green and blue: then R is no reflectance.
fn are_channels(columns: &[Column]) -> bool {
    [["r", "red"], ["g", "green"], ["b", "blue"]]
        .iter()
        .all(|names| {
            columns.iter().any(|column| {
                let title = spaced(column.title).to_lowercase();
                let first = title.split_whitespace().next().unwrap_or("");
                names.contains(&first)
            })
        })
}

/// What the title of a channel says of its values: `red_ssf` is a camera's sensitivity.
fn title_of_channel(title: &str) -> &'static str {
    let title = title.to_lowercase();
    let is_sensitivity = ["ssf", "sensitiv", "respons", "qe"]
        .iter()
        .any(|w| title.contains(w));
    if is_sensitivity {
        "spectral sensitivity"
    } else {
        ""
    }
}

/// Wavelengths, listed or given by their ends, and the lists as long beside and below.
fn of_lists(object: &Object) -> Option<Table<'_>> {
    let ranked = object.iter().enumerate().filter_map(|(at, (key, value))| {
        let rank = match () {
            // Of colours too there is an x.
            () if is_x(key) && !rises(value) => return None,
            () if is_axis(key) => usize::from(is_x(key)),
            () if is_bands(key) && rises(value) => 2,
            () => return None,
        };
        numbers(value)?;
        Some((rank, at))
    });
    let mut ranked: Vec<(usize, usize)> = ranked.take(MOST_AXES).collect();
    ranked.sort_unstable();
    let mut tables = ranked.into_iter().filter_map(|(_, at)| beside(object, at));
    tables.next().or_else(|| of_range(object))
}

/// The lists beside and below that are as long as the one at a place, which has the wavelengths.
fn beside(object: &Object, at: usize) -> Option<Table<'_>> {
    let (axis_key, value) = object.get(at)?;
    let axis = numbers(value)?;
    let others = object.iter().enumerate().filter(|(other, _)| *other != at);
    let columns = lists_beside(others.map(|(_, entry)| entry), axis.len());
    let table = Table {
        axis_title: if is_axis(axis_key) {
            spaced(axis_key)
        } else {
            "wavelength nm".to_owned()
        },
        says_nm: items(value).is_some_and(|items| items.iter().any(|item| says_nm(item))),
        axis,
        columns,
    };
    (!table.columns.is_empty()).then_some(table)
}

/// Whether a key is "x", which is mostly something else where another says that it is an axis.
fn is_x(key: &str) -> bool {
    key.eq_ignore_ascii_case("x")
}

/// Wavelengths given by their ends, and the lists as long as they say.
fn of_range(object: &Object) -> Option<Table<'_>> {
    let ends = Ends::of(object);
    let beside = object.iter().find_map(|(_, value)| numbers(value));
    ends.lengths(beside.map(|list| list.len()))
        .into_iter()
        .find_map(|length| {
            let columns = lists_beside(object.iter(), length);
            let found = !columns.is_empty();
            found.then(|| {
                let (axis_title, axis) = ends.axis(length);
                Table {
                    axis_title,
                    says_nm: false,
                    axis,
                    columns,
                }
            })
        })
}

/// Whether the last word of a key says that numbers under it may be wavelengths.
fn is_bands(key: &str) -> bool {
    let key = spaced(key).to_lowercase();
    ["bands", "nm", "wavelengths"]
        .iter()
        .any(|word| key.ends_with(word))
}

fn rises(value: &Tree) -> bool {
    numbers(value).is_some_and(|list| {
        list.is_sorted_by(|a, b| a < b) && list.iter().all(|nm| BANDS_NM.contains(nm))
    })
}

/// Lists of a length below some keys.
fn lists_beside<'a>(
    entries: impl Iterator<Item = &'a (String, Tree)>,
    length: usize,
) -> Vec<Column<'a>> {
    let mut columns = Vec::new();
    for (key, value) in entries {
        gather(key, value, None, length, DEPTH, &mut columns);
    }
    columns
}

/// Lists of as many numbers as there are wavelengths.
fn gather<'a>(
    key: &'a str,
    value: &'a Tree,
    name: Option<&'a str>,
    length: usize,
    depth: usize,
    columns: &mut Vec<Column<'a>>,
) {
    let Some(depth) = depth.checked_sub(1) else {
        return;
    };
    if let Some(values) = numbers(value) {
        // The same axis again, or counted otherwise.
        let is_axis_too = is_axis(key) && !is_x(key);
        if values.len() == length && !is_axis_too {
            columns.push(Column {
                title: key,
                name,
                values,
            });
        }
        return;
    }
    match value {
        Tree::List(list) => list
            .iter()
            .for_each(|inner| gather(key, inner, name, length, depth, columns)),
        Tree::Object(object) => {
            let own = NAMES.iter().find_map(|name| get(object, name)?.text());
            let is_named = !NO_NAMES.contains(&&*spaced(key).to_lowercase());
            for (inner_key, inner) in object {
                // Keys over lists of their own are names, unless they say what is measured:
                // {"samples": {"A": [..]}}, {"A": {"reflectance": [..]}}.
                let plain = spaced(inner_key).to_lowercase();
                let says_what =
                    NO_NAMES.contains(&&*plain) || kinds::kind_of_title(&plain).is_some();
                let is_name = matches!(inner, Tree::List(_)) && !(says_what && is_named);
                let name = own.or(is_name.then_some(inner_key)).or(Some(key));
                gather(inner_key, inner, name, length, depth, columns);
            }
        }
        _ => {}
    }
}

fn get<'a>(object: &'a Object, key: &str) -> Option<&'a Tree> {
    object
        .iter()
        .find(|(other, _)| other == key)
        .map(|(_, value)| value)
}

/// Wavelengths as keys: `{"380": 0.1, "390": 0.2}`.
fn of_keys(object: &Object) -> Option<Table<'_>> {
    let mut points = Vec::new();
    for (key, value) in object {
        points.push((wavelength_of(key)?, one_number(value)?));
    }
    if points.len() < 2 || row_numbers(object) {
        return None;
    }
    // Keys may stand in the order of their letters.
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (axis, values) = points.into_iter().unzip();
    let column = Column {
        title: "",
        name: None,
        values,
    };
    Some(Table {
        axis_title: String::new(),
        says_nm: object.iter().all(|(key, _)| key.trim_end().ends_with("nm")),
        axis,
        columns: vec![column],
    })
}

/// A key that is a wavelength: `380`, `380nm`.
fn wavelength_of(key: &str) -> Option<f64> {
    let bare = key.trim().trim_end_matches("nm").trim_end();
    number::number(bare, false).filter(|nm| number::is_measured(*nm) && *nm > 0.0)
}

/// Whether keys count rows from 0 or 1, as tables are written that have columns for objects.
fn row_numbers(object: &Object) -> bool {
    let first = object
        .first()
        .and_then(|(key, _)| key.parse::<usize>().ok());
    let Some(first @ 0..=1) = first else {
        return false;
    };
    let mut rows = object.iter().enumerate();
    rows.all(|(row, (key, _))| key.parse() == Ok(row + first))
}

/// The values of a list, or of an object whose keys count rows.
fn items(value: &Tree) -> Option<Vec<&Tree>> {
    match value {
        Tree::List(list) => Some(list.iter().collect()),
        Tree::Object(object) if row_numbers(object) => {
            Some(object.iter().map(|(_, item)| item).collect())
        }
        _ => None,
    }
}

/// Points as objects: `[{"wavelength": 380, "value": 0.1}, ...]`.
fn of_points(value: &Tree) -> Option<Table<'_>> {
    let points: Vec<&Object> = items(value)?
        .into_iter()
        .map(Tree::object)
        .collect::<Option<_>>()?;
    let first = points.first().filter(|_| points.len() > 1)?;
    let numbers = first
        .iter()
        .filter(|(_, value)| one_number(value).is_some());
    let keys: Vec<&str> = numbers.map(|(key, _)| key.as_str()).collect();
    let axis_at = keys.iter().position(|key| is_axis(key) && !is_x(key));
    let axis_at = axis_at.or_else(|| keys.iter().position(|key| is_axis(key)))?;
    let entries: usize = points.iter().map(|point| point.len()).sum();
    if keys.len() < 2 || keys.len() * points.len() > CELLS_A_KEY * entries {
        return None;
    }
    let places: HashMap<&str, usize> = keys
        .iter()
        .enumerate()
        .map(|(at, key)| (*key, at))
        .collect();
    let mut columns = vec![vec![f64::NAN; points.len()]; keys.len()];
    let mut says_nm_too = false;
    for (row, point) in points.iter().enumerate() {
        for (key, value) in *point {
            if let (Some(at), Some(number)) = (places.get(&**key), one_number(value)) {
                columns[*at][row] = number;
                says_nm_too |= *at == axis_at && says_nm(value);
            }
        }
    }
    let axis = std::mem::take(&mut columns[axis_at]);
    let others = keys
        .iter()
        .zip(columns)
        .enumerate()
        .filter(|(at, _)| *at != axis_at);
    let columns = others.map(|(_, (key, values))| Column {
        title: key,
        name: None,
        values,
    });
    Some(Table {
        axis_title: spaced(keys[axis_at]),
        says_nm: says_nm_too,
        axis,
        columns: columns.collect(),
    })
}

/// Points as lists: `[[380, 0.1], [390, 0.2], ...]`.
fn of_rows(list: &[Tree]) -> Option<Table<'_>> {
    if list.len() < 2 {
        return None;
    }
    let rows: Vec<Vec<f64>> = list.iter().map(numbers).collect::<Option<_>>()?;
    let width = rows[0].len();
    let axis: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    let rises = axis.is_sorted_by(|a, b| a < b) || axis.is_sorted_by(|a, b| a > b);
    if !rises || axis.iter().any(|nm| *nm <= 0.0) || rows.iter().any(|row| row.len() != width) {
        return None;
    }
    let columns = (1..width).map(|at| Column {
        title: "",
        name: None,
        values: rows.iter().map(|row| row[at]).collect(),
    });
    Some(Table {
        axis_title: String::new(),
        says_nm: false,
        axis,
        columns: columns.collect(),
    })
}

/// At least two numbers; `null` and words for a gap stand for missing ones.
fn numbers(value: &Tree) -> Option<Vec<f64>> {
    let list = items(value).filter(|list| list.len() > 1)?;
    let list: Vec<f64> = list.into_iter().map(one_number).collect::<Option<_>>()?;
    list.iter().any(|number| !number.is_nan()).then_some(list)
}

fn one_number(value: &Tree) -> Option<f64> {
    match value {
        Tree::Nothing => Some(f64::NAN),
        Tree::Number(number) => Some(*number),
        Tree::Text(text) => match number::parse(text, false) {
            Cell::Number(number) | Cell::Nanometres(number) | Cell::WithUnit(number) => {
                Some(number)
            }
            Cell::Gap => Some(f64::NAN),
            Cell::Percent(_) | Cell::Empty | Cell::Text => None,
        },
        Tree::List(_) | Tree::Object(_) => None,
    }
}

/// Whether a number has "nm" behind it.
fn says_nm(value: &Tree) -> bool {
    value
        .text()
        .is_some_and(|text| text.trim_end().ends_with("nm"))
}

/// Whether a key says that wavelengths stand under it.
fn is_axis(key: &str) -> bool {
    names_wavelength(&spaced(key))
}

/// A key as a title: `wavelength_nm` and `wavelengthNm` are "wavelength nm".
fn spaced(key: &str) -> String {
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

/// Words and numbers beside lists, as the lines above a table.
fn words_of(object: &Object) -> impl Iterator<Item = String> {
    object.iter().filter_map(|(key, value)| {
        let key = if NAMES[..2].contains(&&*key.to_lowercase()) {
            "name".to_owned()
        } else {
            spaced(&kept(key).to_lowercase())
        };
        match value {
            Tree::Text(text) if !text.trim().is_empty() => Some(format!("{key}: {}", kept(text))),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use crate::io::{Reading, read_bytes};
    use crate::spectrum::Kind;

    fn read(text: &str) -> Reading {
        read_bytes("a.json", text.as_bytes()).expect("spectra")
    }

    fn names(reading: &Reading) -> Vec<&str> {
        reading.spectra.iter().map(|s| s.name.as_str()).collect()
    }

    #[test]
    fn lists_beside_wavelengths_are_spectra_of_the_kind_that_their_key_names() {
        let one = read(
            r#"{"name":"Lamp A","unit":"W/m2/nm","wavelengths":[380,390,400],"values":[1,null,3]}"#,
        );
        let spectrum = &one.spectra[0];
        assert_eq!(
            (spectrum.name.as_str(), spectrum.kind),
            ("Lamp A", Kind::Light)
        );
        assert_eq!(spectrum.unit, "W/m2/nm");
        assert_eq!(spectrum.samples.nm(), [380.0, 400.0]);
        let two = read(r#"{"data":{"wavelength_um":[0.4,0.5],"reflectance":[0.1,0.2],"n":7}}"#);
        assert_eq!(two.spectra[0].kind, Kind::Reflectance);
        assert_eq!(two.spectra[0].samples.nm(), [400.0, 500.0]);
    }

    #[test]
    fn samples_below_shared_wavelengths_keep_their_names() {
        let list = read(
            r#"{"wavelengthsNm":[400,410],"samples":[{"name":"A","reflectance":[0.1,0.2]},
                {"name":"B","reflectance":[0.3,0.4]}]}"#,
        );
        assert_eq!(names(&list), ["A", "B"]);
        assert!(list.spectra.iter().all(|s| s.kind == Kind::Reflectance));
        let keyed = read(r#"{"lambda":[400,410],"spectra":{"A":[1,2],"B":[3,4]}}"#);
        assert_eq!(names(&keyed), ["A", "B"]);
        assert_eq!(keyed.spectra[1].samples.values(), [3.0, 4.0]);
    }

    #[test]
    fn points_as_objects_lists_or_keys_are_spectra_too() {
        for text in [
            r#"[{"wavelength":380,"power":1},{"wavelength":390,"power":"2.5"}]"#,
            "[[380,1],[390,2.5]]",
            r#"{"390":2.5,"380":1}"#,
            r#"{"lamp":{"390nm":2.5,"380nm":1}}"#,
            r#"{"points":[{"nm":390,"v":2.5},{"nm":380,"v":1}]}"#,
        ] {
            let reading = read(text);
            assert_eq!(reading.spectra.len(), 1, "{text}");
            let samples = &reading.spectra[0].samples;
            assert_eq!(samples.nm(), [380.0, 390.0], "{text}");
            assert_eq!(samples.values(), [1.0, 2.5], "{text}");
        }
    }

    #[test]
    fn ends_and_a_step_are_wavelengths_where_they_fit_the_lists() {
        for axis in [
            r#""start":380,"end":420,"interval":10"#,
            r#""domain":[380,420],"interval":10"#,
            r#""span":[380,420],"step":10"#,
            r#""bands":[380,420,10]"#,
            r#""lambda_min":380,"lambda_max":420,"n":5"#,
            r#""wavelength_min_nm":380,"wavelength_max_nm":420"#,
            r#""range":{"start":380,"end":420,"increment":10}"#,
        ] {
            let reading = read(&format!(r#"{{"name":"L","values":[1,2,3,4,5],{axis}}}"#));
            assert_eq!(names(&reading), ["L"], "{axis}");
            let samples = &reading.spectra[0].samples;
            assert_eq!(samples.nm(), [380.0, 390.0, 400.0, 410.0, 420.0], "{axis}");
        }
        for axis in [
            r#""start":380,"end":430,"interval":10"#,
            r#""start":1,"end":5,"interval":1"#,
            r#""start":380,"end":420"#,
            r#""bands":[380,420,11]"#,
            r#""domain":[380,420]"#,
        ] {
            let text = format!(r#"{{"values":[1,2,3,4,5],{axis}}}"#);
            assert!(read_bytes("a.json", text.as_bytes()).is_err(), "{axis}");
        }
        let several = read(
            r#"{"spectra":[{"name":"A","bands":[400,430,10],"values":[1,2,3,4]},
                {"name":"B","bands":[400,430,10],"values":[4,3,2,1]}]}"#,
        );
        assert_eq!(names(&several), ["A", "B"]);
    }

    #[test]
    fn the_list_that_fits_others_has_the_wavelengths() {
        for text in [
            r#"{"wavelength_range":[400,420],"wavelengths":[400,410,420],"v":[1,2,3]}"#,
            r#"{"x":[1,2,3],"wavelength":[400,410,420],"wavenumber":[25000,24390,23810]}"#,
            r#"{"wavelengths":[400,430,10],"v":[1,2,3,4]}"#,
        ] {
            let reading = read(text);
            assert_eq!(reading.spectra.len(), 1, "{text}");
            let samples = &reading.spectra[0].samples;
            assert_eq!(samples.nm()[..3], [400.0, 410.0, 420.0], "{text}");
            assert_eq!(samples.values()[..3], [1.0, 2.0, 3.0], "{text}");
        }
    }

    #[test]
    fn bands_and_three_channels_are_a_cameras() {
        let camera = read(
            r#"{"camera":"C","ssf_bands":[400,410,420,430],"red_ssf":[0.1,0.2,0.3,0.2],
                "green_ssf":[0.1,0.3,0.3,0.2],"blue_ssf":[0.3,0.2,0.1,0.1]}"#,
        );
        assert_eq!(names(&camera), ["a red_ssf", "a green_ssf", "a blue_ssf"]);
        assert!(camera.spectra.iter().all(|s| s.kind == Kind::Weighting));
        let points =
            read(r#"[{"nm":400,"R":0.1,"G":0.2,"B":0.3},{"nm":410,"R":0.2,"G":0.2,"B":0.2}]"#);
        assert_eq!(names(&points), ["a R", "a G", "a B"]);
        assert!(points.spectra.iter().all(|s| s.kind == Kind::Light));
    }

    #[test]
    fn keys_that_count_rows_are_no_wavelengths() {
        for text in [
            r#"{"wavelength":{"0":380,"1":390},"value":{"0":1,"1":2.5}}"#,
            r#"{"0":{"wavelength":380,"value":1},"1":{"wavelength":390,"value":2.5}}"#,
        ] {
            let samples = &read(text).spectra[0].samples;
            assert_eq!(samples.nm(), [380.0, 390.0], "{text}");
            assert_eq!(samples.values(), [1.0, 2.5], "{text}");
        }
        let counted = br#"{"value":{"0":1,"1":2.5,"2":3}}"#;
        assert!(read_bytes("a.json", counted).is_err());
    }

    #[test]
    fn one_object_a_line_and_numbers_with_their_unit_are_read() {
        let lines = "{\"wavelength\":\"380 nm\",\"v\":1}\n{\"wavelength\":\"390 nm\",\"v\":2.5}\n";
        let reading = read(lines);
        assert_eq!(reading.spectra[0].samples.nm(), [380.0, 390.0]);
        let spectra = "{\"name\":\"A\",\"nm\":[380,390],\"v\":[1,2]}\n{\"name\":\"B\",\"nm\":[400,410],\"v\":[3,4]}";
        assert_eq!(names(&read(spectra)), ["A", "B"]);
        let broken = read_bytes("a.json", format!("{lines}{{\"x\" 5}}").as_bytes()).unwrap_err();
        assert!(broken.to_string().contains("line 3"), "{broken}");
    }

    #[test]
    fn keys_above_tables_are_names_in_the_order_of_the_file() {
        for text in [
            r#"{"D65":{"wavelength":[400,410],"values":[1,2]},"A":{"wavelength":[400,410],"values":[3,4]}}"#,
            r#"{"D65":{"400":1,"410":2},"A":{"400":3,"410":4}}"#,
            r#"{"name":"set","spectra":{"D65":[{"nm":400,"v":1},{"nm":410,"v":2}],"A":[[400,3],[410,4]]}}"#,
            r#"{"nm":[400,410],"D65":{"values":[1,2]},"A":{"values":[3,4]}}"#,
        ] {
            assert_eq!(names(&read(text)), ["D65", "A"], "{text}");
        }
        let kinds =
            read(r#"{"reflectance":{"400":0.5,"410":0.4},"transmittance":{"400":0.1,"410":0.2}}"#);
        assert_eq!(names(&kinds), ["a reflectance", "a transmittance"]);
        assert_eq!(kinds.spectra[1].kind, Kind::Transmittance);
    }

    #[test]
    fn lists_of_other_things_are_no_spectra() {
        for text in [
            r#"{"prices":[1,2,3],"items":[4,5,6]}"#,
            r#"{"x":[0.31,0.32,0.33],"y":[0.33,0.34,0.35]}"#,
            r#"{"wavelengths":[380,390],"values":[1,2,3]}"#,
            "[1,2,3]",
            "[[5,1],[3,2],[4,4]]",
        ] {
            assert!(read_bytes("a.json", text.as_bytes()).is_err(), "{text}");
        }
        let trouble = read_bytes("a.json", br#"{"wl":[-380,370],"v":[1,2]}"#).unwrap_err();
        assert!(trouble.to_string().contains("-380 nm"), "{trouble}");
    }
}
