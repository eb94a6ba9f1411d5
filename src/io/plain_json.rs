//! JSON of no program in particular: lists of numbers beside a list of wavelengths.
//!
//! ```text
//! {"name": "lamp", "unit": "W/m2/nm", "wavelengths": [380, 390, ..], "values": [..], "other": [..]}
//! {"wavelength_nm": [..], "samples": [{"name": "A", "reflectance": [..]}, ..]}
//! [{"wavelength": 380, "value": 0.1}, ..]      [[380, 0.1], [390, 0.2], ..]      {"380": 0.1, ..}
//! ```
//!
//! What the words mean is decided as in a table of text: keys are the titles of columns, and other
//! words beside them are the lines above it.

use serde_json::{Map, Value};

use super::draft::{Draft, Scale};
use super::error::kept;
use super::heading::Heading;
use super::number;
use super::units::names_wavelength;
use super::{Input, ReadError, Reading};

/// How deep in a file spectra are looked for.
const DEPTH: usize = 8;

/// Most words beside a table that are kept.
const MOST_WORDS: usize = 100;

/// Keys under which a sample's name stands.
const NAMES: [&str; 6] = ["name", "title", "label", "id", "sample", "description"];

/// Wavelengths and the lists of values beside them.
struct Table<'a> {
    axis_title: String,
    axis: Vec<f64>,
    columns: Vec<Column<'a>>,
    words: Vec<String>,
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
pub fn read(input: &Input, value: &Value, reading: &mut Reading) -> Result<(), ReadError> {
    let mut tables = Vec::new();
    look(value, &mut Vec::new(), DEPTH, &mut tables);
    for table in tables {
        let lines: Vec<(usize, &str)> = table.words.iter().map(|words| (0, &**words)).collect();
        let heading = Heading::of(&lines).shared_by(table.columns.len());
        let scale = Scale::new(&table.axis);
        let several = table.columns.len() > 1;
        for column in table.columns {
            let stem = heading.name.unwrap_or(input.stem());
            Draft {
                name: match (column.name, several) {
                    (Some(name), _) => name.to_owned(),
                    (None, true) if !column.title.is_empty() => format!("{stem} {}", column.title),
                    _ => stem.to_owned(),
                },
                title: spaced(column.title),
                axis_title: table.axis_title.clone(),
                says_nm: false,
                heading: &heading,
                axis: &scale,
                values: column.values,
                lines: &[],
                percent_signs: false,
                decimal_comma: false,
            }
            .finish(input, reading)?;
        }
    }
    Ok(())
}

/// Looks for tables; `words` are those of the objects around.
fn look<'a>(value: &'a Value, words: &mut Vec<String>, depth: usize, tables: &mut Vec<Table<'a>>) {
    let Some(depth) = depth.checked_sub(1) else {
        return;
    };
    match value {
        Value::Object(object) => {
            let outside = words.len();
            words.extend(words_of(object).take(MOST_WORDS.saturating_sub(outside)));
            match of_lists(object).or_else(|| of_keys(object)) {
                Some((axis_title, axis, columns)) => tables.push(Table {
                    axis_title,
                    axis,
                    columns,
                    words: words.clone(),
                }),
                None => object
                    .values()
                    .for_each(|inner| look(inner, words, depth, tables)),
            }
            words.truncate(outside);
        }
        Value::Array(list) => match of_points(list).or_else(|| of_rows(list)) {
            Some((axis_title, axis, columns)) => tables.push(Table {
                axis_title,
                axis,
                columns,
                words: words.clone(),
            }),
            None => list
                .iter()
                .for_each(|inner| look(inner, words, depth, tables)),
        },
        _ => {}
    }
}

type Found<'a> = Option<(String, Vec<f64>, Vec<Column<'a>>)>;

/// A list of wavelengths under a key that says so, and the lists as long beside and below it.
fn of_lists(object: &Map<String, Value>) -> Found<'_> {
    let mut lists = object.iter().filter(|(key, _)| is_axis(key));
    let (axis_key, axis) = lists.find_map(|(key, value)| Some((key, numbers(value)?)))?;
    let mut columns = Vec::new();
    for (key, value) in object.iter().filter(|(key, _)| *key != axis_key) {
        gather(key, value, None, axis.len(), DEPTH, &mut columns);
    }
    (!columns.is_empty()).then(|| (spaced(axis_key), axis, columns))
}

/// Lists of as many numbers as there are wavelengths.
fn gather<'a>(
    key: &'a str,
    value: &'a Value,
    name: Option<&'a str>,
    length: usize,
    depth: usize,
    columns: &mut Vec<Column<'a>>,
) {
    let Some(depth) = depth.checked_sub(1) else {
        return;
    };
    if let Some(values) = numbers(value) {
        if values.len() == length {
            columns.push(Column {
                title: key,
                name,
                values,
            });
        }
        return;
    }
    match value {
        Value::Array(list) => list
            .iter()
            .for_each(|inner| gather(key, inner, name, length, depth, columns)),
        Value::Object(object) => {
            let own = NAMES.iter().find_map(|n| object.get(*n)?.as_str());
            // Keys over lists of their own are names: {"samples": {"A": [..], "B": [..]}}.
            for (inner_key, inner) in object {
                let is_list = inner.is_array() && own.is_none();
                let name = own.or(if is_list { Some(inner_key) } else { None });
                gather(inner_key, inner, name.or(Some(key)), length, depth, columns);
            }
        }
        _ => {}
    }
}

/// Wavelengths as keys: `{"380": 0.1, "390": 0.2}`.
fn of_keys(object: &Map<String, Value>) -> Found<'_> {
    let mut points = Vec::new();
    for (key, value) in object {
        points.push((wavelength_of(key)?, one_number(value)?));
    }
    if points.len() < 2 {
        return None;
    }
    // Keys are in the order of the parser, which need not be that of the numbers.
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (axis, values) = points.into_iter().unzip();
    let column = Column {
        title: "",
        name: None,
        values,
    };
    Some((String::new(), axis, vec![column]))
}

/// A key that is a wavelength: `380`, `380nm`.
fn wavelength_of(key: &str) -> Option<f64> {
    let bare = key.trim().trim_end_matches("nm").trim_end();
    number::number(bare, false).filter(|nm| number::is_measured(*nm))
}

/// Points as objects: `[{"wavelength": 380, "value": 0.1}, ...]`.
fn of_points(list: &[Value]) -> Found<'_> {
    let first = list.first()?.as_object().filter(|_| list.len() > 1)?;
    let axis_key = first
        .iter()
        .find(|(key, value)| is_axis(key) && one_number(value).is_some())
        .map(|(key, _)| key)?;
    let column = |key: &str| -> Vec<f64> {
        list.iter()
            .map(|point| point.get(key).and_then(one_number).unwrap_or(f64::NAN))
            .collect()
    };
    let others = first
        .iter()
        .filter(|(key, value)| *key != axis_key && one_number(value).is_some());
    let columns: Vec<Column> = others
        .map(|(key, _)| Column {
            title: key,
            name: None,
            values: column(key),
        })
        .collect();
    (!columns.is_empty()).then(|| (spaced(axis_key), column(axis_key), columns))
}

/// Points as lists: `[[380, 0.1], [390, 0.2], ...]`.
fn of_rows(list: &[Value]) -> Found<'_> {
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
    Some((String::new(), axis, columns.collect()))
}

/// At least two numbers; `null` stands for a missing one.
fn numbers(value: &Value) -> Option<Vec<f64>> {
    let list = value.as_array().filter(|list| list.len() > 1)?;
    list.iter().map(one_number).collect()
}

fn one_number(value: &Value) -> Option<f64> {
    match value {
        Value::Null => Some(f64::NAN),
        Value::Number(number) => number.as_f64(),
        Value::String(text) => number::number(text.trim(), false),
        _ => None,
    }
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
fn words_of(object: &Map<String, Value>) -> impl Iterator<Item = String> {
    object.iter().filter_map(|(key, value)| {
        let key = if NAMES[..2].contains(&&*key.to_lowercase()) {
            "name".to_owned()
        } else {
            spaced(&kept(key).to_lowercase())
        };
        match value {
            Value::String(text) if !text.trim().is_empty() => {
                Some(format!("{key}: {}", kept(text)))
            }
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
    fn lists_of_other_things_are_no_spectra() {
        for text in [
            r#"{"prices":[1,2,3],"items":[4,5,6]}"#,
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
