//! Lists of values beside a list of wavelengths, in the ways that JSON has for them.

use std::borrow::Cow;
use std::collections::HashMap;

use super::DEPTH;
use super::keys::{
    NAMES, is_axis, is_no_name, is_x, items, numbers, one_number, row_numbers, says_nm, spaced,
};
use super::range::Ends;
use crate::io::decode::json_tree::{Object, Tree};
use crate::io::interpret::kinds;
use crate::io::table::row_order::runs_one_way;
use crate::io::text::number;

/// Least and greatest number, nm, of a list identified as wavelengths only by its key's last word.
const BANDS_NM: std::ops::RangeInclusive<f64> = 100.0..=50_000.0;

/// Memory that a table of points may take for each key in the file: not every point has every key.
const CELLS_A_KEY: usize = 8;

/// Most lists of one object that are tried as wavelengths.
const MOST_AXES: usize = 8;

/// Wavelengths and the lists of values beside them.
#[derive(Default)]
pub(super) struct Lists<'a> {
    /// The key above the wavelengths, its words set apart.
    pub axis_title: String,
    /// True if a number has "nm" behind it.
    pub says_nm: bool,
    pub axis: Vec<f64>,
    pub columns: Vec<Column<'a>>,
}

/// A list of values.
pub(super) struct Column<'a> {
    /// The key above it: the quantity measured.
    pub title: &'a str,
    /// The name of its sample.
    pub name: Option<Cow<'a, str>>,
    /// As many as there are wavelengths; NaN where one is missing.
    pub values: Vec<f64>,
}

impl<'a> Column<'a> {
    fn new(title: &'a str, values: Vec<f64>) -> Self {
        Self {
            title,
            name: None,
            values,
        }
    }
}

/// Wavelengths, listed or given by their ends, and the lists as long beside and below.
pub(super) fn of_lists(object: &Object) -> Option<Lists<'_>> {
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
fn beside(object: &Object, at: usize) -> Option<Lists<'_>> {
    let (axis_key, value) = object.get(at)?;
    let axis = numbers(value)?;
    let others = object.iter().enumerate().filter(|(other, _)| *other != at);
    let columns = lists_beside(others.map(|(_, entry)| entry), axis.len());
    let table = Lists {
        axis_title: match is_axis(axis_key) {
            true => spaced(axis_key),
            false => "wavelength nm".to_owned(),
        },
        says_nm: items(value).is_some_and(|items| items.iter().any(|item| says_nm(item))),
        axis,
        columns,
    };
    (!table.columns.is_empty()).then_some(table)
}

/// Wavelengths given by their ends, and the lists of matching length.
fn of_range(object: &Object) -> Option<Lists<'_>> {
    let ends = Ends::of(object);
    let beside = object.iter().find_map(|(_, value)| numbers(value));
    let lengths = ends.lengths(beside.map(|list| list.len())).into_iter();
    let mut tables = lengths.map(|length| (length, lists_beside(object.iter(), length)));
    let (length, columns) = tables.find(|(_, columns)| !columns.is_empty())?;
    let (axis_title, axis) = ends.axis(length);
    Some(Lists {
        axis_title,
        axis,
        columns,
        ..Lists::default()
    })
}

/// True if the last word of a key implies that numbers under it may be wavelengths.
fn is_bands(key: &str) -> bool {
    let key = spaced(key).to_lowercase();
    let ends = |word: &&str| key.ends_with(*word);
    ["bands", "nm", "wavelengths"].iter().any(ends)
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
                name: name.map(Cow::from),
                ..Column::new(key, values)
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
            let is_named = !is_no_name(&spaced(key).to_lowercase());
            for (inner_key, inner) in object {
                // Keys over lists of their own are names, unless they name the quantity measured:
                // {"samples": {"A": [..]}}, {"A": {"reflectance": [..]}}.
                let plain = spaced(inner_key).to_lowercase();
                let says_what = is_no_name(&plain) || kinds::kind_of_title(&plain).is_some();
                let is_name = matches!(inner, Tree::List(_)) && !(says_what && is_named);
                let name = own.or(is_name.then_some(inner_key)).or(Some(key));
                gather(inner_key, inner, name, length, depth, columns);
            }
        }
        _ => {}
    }
}

fn get<'a>(object: &'a Object, key: &str) -> Option<&'a Tree> {
    let mut entries = object.iter();
    let (_, value) = entries.find(|(other, _)| other == key)?;
    Some(value)
}

/// Wavelengths as keys: `{"380": 0.1, "390": 0.2}`.
pub(super) fn of_keys(object: &Object) -> Option<Lists<'_>> {
    let point = |(key, value): &(String, Tree)| Some((wavelength_of(key)?, one_number(value)?));
    let mut points = object.iter().map(point).collect::<Option<Vec<_>>>()?;
    if points.len() < 2 || row_numbers(object) {
        return None;
    }
    // Keys may be in alphabetical order.
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (axis, values) = points.into_iter().unzip();
    Some(Lists {
        says_nm: object.iter().all(|(key, _)| key.trim_end().ends_with("nm")),
        axis,
        columns: vec![Column::new("", values)],
        ..Lists::default()
    })
}

/// A key that is a wavelength: `380`, `380nm`.
fn wavelength_of(key: &str) -> Option<f64> {
    let bare = key.trim().trim_end_matches("nm").trim_end();
    number::number(bare, false).filter(|nm| number::is_measured(*nm) && *nm > 0.0)
}

/// Points as objects: `[{"wavelength": 380, "value": 0.1}, ...]`. Where wavelengths begin anew and
/// a key distinguishes samples, each has lists of its own.
pub(super) fn of_points(value: &Tree) -> Vec<Lists<'_>> {
    let points = items(value).into_iter().flatten().map(Tree::object);
    let Some(points) = points.collect::<Option<Vec<&Object>>>() else {
        return Vec::new();
    };
    let Some((key, samples)) = by_sample(&points) else {
        return of_objects(&points).into_iter().collect();
    };
    let named = samples.into_iter().filter_map(|(name, points)| {
        let mut lists = of_objects(&points)?;
        lists.columns.retain(|column| column.title != key);
        for column in &mut lists.columns {
            column.name = Some(name.clone());
        }
        Some(lists)
    });
    named.collect()
}

/// The keys of a point that hold numbers, and which of them has the wavelengths.
fn keys_of(point: &Object) -> Option<(Vec<&str>, usize)> {
    let is_number = |(_, value): &&(String, Tree)| one_number(value).is_some();
    let numbers = point.iter().filter(is_number);
    let keys: Vec<&str> = numbers.map(|(key, _)| key.as_str()).collect();
    let axis = keys.iter().position(|key| is_axis(key) && !is_x(key));
    let axis = axis.or_else(|| keys.iter().position(|key| is_axis(key)))?;
    Some((keys, axis))
}

/// The key whose words or numbers part points into samples, each with wavelengths that rise or fall
/// throughout, and the samples; `None` where all points do so together.
fn by_sample<'a>(points: &[&'a Object]) -> Option<(&'a str, Vec<Sample<'a>>)> {
    let first = points.first()?;
    let (keys, axis) = keys_of(first)?;
    let axis = keys[axis];
    let runs = |points: &[&Object]| {
        let nm = points.iter().map(|point| one_number(get(point, axis)?));
        let nm: Option<Vec<f64>> = nm.collect();
        nm.is_some_and(|nm| nm.len() > 1 && runs_one_way(&nm))
    };
    if runs(points) {
        return None;
    }
    let others = first.iter().map(|(key, _)| key.as_str());
    others.filter(|key| *key != axis).find_map(|key| {
        let mut samples: Vec<Sample> = Vec::new();
        let mut places: HashMap<String, usize> = HashMap::new();
        for point in points {
            let value = get(point, key)?;
            let name = match (value.text(), one_number(value)) {
                (Some(text), _) => Cow::from(text),
                (None, number) => Cow::from(format!("{} {}", spaced(key), number?)),
            };
            let place = *places.entry(name.to_string()).or_insert(samples.len());
            if place == samples.len() {
                samples.push((name, Vec::new()));
            }
            samples[place].1.push(*point);
        }
        let are_apart = samples.len() > 1 && samples.iter().all(|(_, points)| runs(points));
        are_apart.then_some((key, samples))
    })
}

/// A sample's name and its points.
type Sample<'a> = (Cow<'a, str>, Vec<&'a Object>);

fn of_objects<'a>(points: &[&'a Object]) -> Option<Lists<'a>> {
    let first = points.first().filter(|_| points.len() > 1)?;
    let (keys, axis_at) = keys_of(first)?;
    let entries: usize = points.iter().map(|point| point.len()).sum();
    if keys.len() < 2 || keys.len() * points.len() > CELLS_A_KEY * entries {
        return None;
    }
    let places: HashMap<&str, usize> = keys.iter().copied().zip(0..).collect();
    let new = |key| Column::new(key, vec![f64::NAN; points.len()]);
    let mut columns: Vec<Column> = keys.iter().copied().map(new).collect();
    let mut says_nm_too = false;
    for (row, point) in points.iter().enumerate() {
        for (key, value) in *point {
            if let (Some(at), Some(number)) = (places.get(&**key), one_number(value)) {
                columns[*at].values[row] = number;
                says_nm_too |= *at == axis_at && says_nm(value);
            }
        }
    }
    let axis = columns.remove(axis_at);
    Some(Lists {
        axis_title: spaced(axis.title),
        says_nm: says_nm_too,
        axis: axis.values,
        columns,
    })
}

/// Points as lists: `[[380, 0.1], [390, 0.2], ...]`.
pub(super) fn of_rows(list: &[Tree]) -> Option<Lists<'_>> {
    if list.len() < 2 {
        return None;
    }
    let rows: Vec<Vec<f64>> = list.iter().map(numbers).collect::<Option<_>>()?;
    let width = rows[0].len();
    let axis: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    if !runs_one_way(&axis)
        || axis.iter().any(|nm| *nm <= 0.0)
        || rows.iter().any(|row| row.len() != width)
    {
        return None;
    }
    let column = |at| Column::new("", rows.iter().map(|row| row[at]).collect());
    Some(Lists {
        axis,
        columns: (1..width).map(column).collect(),
        ..Lists::default()
    })
}
