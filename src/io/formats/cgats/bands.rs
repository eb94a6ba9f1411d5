//! The columns of a CGATS table that form a spectrum, and their wavelengths.

use std::collections::HashMap;

use crate::io::write::argyll::LABELS_NM;
use crate::languages::{fixed, with_sign};

/// Most kinds of columns considered, distinguished by the common part of their labels.
const MOST_GROUPS: usize = 1000;

/// Fewest columns of one kind that are a spectrum.
const FEWEST_BANDS: usize = 3;

/// Columns of values behind those of their wavelengths.
const VALUES: [&str; 3] = ["SPECTRAL_DEC", "SPECTRAL_PCT", "SPECTRAL_VAL"];

/// Largest difference of a rounded label from its wavelength, nm.
const ROUNDED_NM: f64 = 0.5 + 1e-6;

/// Columns that make one spectrum a set.
#[derive(Debug, Default)]
pub(super) struct Bands {
    /// The common part of their labels: `SPEC_`, `nm`.
    pub word: String,
    pub columns: Vec<usize>,
    /// Wavelengths given by the labels, nm.
    pub labels: Vec<f64>,
    /// Columns of wavelengths, where these are among the data.
    pub nm_columns: Vec<usize>,
}

/// A label's wavelength and the text around it: `SPECTRAL_NM380_M1` is 380, `SPECTRAL_NM` and
/// `_M1`.
fn label(field: &str) -> Option<(f64, String)> {
    let start = field.find(|c: char| c.is_ascii_digit())?;
    let rest = &field[start..];
    let end = rest
        .find(|c: char| !c.is_ascii_digit() && c != '.' && c != ',')
        .unwrap_or(rest.len());
    let nm: f64 = rest[..end].replace(',', ".").parse().ok()?;
    let before = field[..start].trim_end_matches(['_', '-', '.']);
    let after = rest[end..].trim_start_matches(['_', '-']);
    let after = after
        .strip_prefix("nm")
        .or(after.strip_prefix("NM"))
        .unwrap_or(after);
    let plausible = LABELS_NM.contains(&nm) && before.len() <= 32 && after.len() <= 16;
    plausible.then(|| (nm, format!("{before}|{after}")))
}

/// The spectra that the columns of a table hold.
///
/// Two columns are a spectrum where the header states two bands (`stated`).
pub(super) fn bands(fields: &[&str], stated: Option<f64>) -> Vec<Bands> {
    let mut places: HashMap<String, usize> = HashMap::new();
    let mut found: Vec<Bands> = Vec::new();
    let mut nm_column = None;
    for (column, field) in fields.iter().enumerate() {
        // CGATS.17: a column with the wavelength before each column with the value.
        if field.eq_ignore_ascii_case("SPECTRAL_NM") {
            nm_column = Some(column);
            continue;
        }
        let is = |word: &&&str| field.eq_ignore_ascii_case(word);
        let (word, nm) = match (VALUES.iter().find(is), nm_column.take(), label(field)) {
            (Some(word), Some(nm_column), _) => ((*word).to_owned(), Err(nm_column)),
            (_, _, Some((nm, word))) => (word, Ok(nm)),
            _ => continue,
        };
        let next = found.len();
        if next >= MOST_GROUPS && !places.contains_key(&word) {
            continue;
        }
        let at = *places.entry(word.clone()).or_insert(next);
        if at == next {
            found.push(Bands {
                word,
                ..Bands::default()
            });
        }
        let group = &mut found[at];
        group.columns.push(column);
        match nm {
            Ok(nm) => group.labels.push(nm),
            Err(nm_column) => group.nm_columns.push(nm_column),
        }
    }
    // Ink values are numbered too (`7CLR_1`), in hundreds never.
    found.retain(|group| {
        let pairs = !group.nm_columns.is_empty();
        let rising = group.labels.windows(2).all(|p| p[1] > p[0]);
        let falling = group.labels.windows(2).all(|p| p[1] < p[0]);
        let fewest = if stated == Some(2.0) { 2 } else { FEWEST_BANDS };
        pairs || group.columns.len() >= fewest && (rising || falling)
    });
    found
}

/// Keywords of the number of bands, and of the first and the last wavelength, nm.
pub(super) const GRID: [&str; 3] = ["SPECTRAL_BANDS", "SPECTRAL_START_NM", "SPECTRAL_END_NM"];

/// The wavelengths of bands by their labels and by the values of the keywords of [`GRID`], and a
/// note on them.
pub(super) fn grid(stated: [Option<f64>; 3], labels: &[f64]) -> (Vec<f64>, Option<String>) {
    let of_labels = |note| (labels.to_vec(), note);
    let stated = stated.map(|number| number.filter(|v| v.is_finite()));
    let [Some(bands), Some(start), Some(end)] = stated else {
        return of_labels(None);
    };
    let header = [bands, start, end].map(|number| with_sign(number.to_string()));
    let [stated, from, to] = &header;
    let (count, first, last) = (labels.len(), labels[0], labels[labels.len() - 1]);
    let [low, high] = [first, last].map(|nm| with_sign(nm.to_string()));
    if bands != count as f64 || count < 2 {
        return of_labels(Some(tr!(
            "the header says SPECTRAL_BANDS {bands} from {from} to {to} nm and there are {columns} \
             columns from {low} to {high} nm: the columns are believed",
            bands = stated,
            from,
            to,
            columns = count,
            low,
            high
        )));
    }
    let step = (end - start) / (bands - 1.0);
    let even: Vec<f64> = (0..count).map(|i| start + step * i as f64).collect();
    let off = labels.iter().zip(&even).map(|(a, b)| (a - b).abs());
    let largest = off.fold(0.0, f64::max);
    // Labels with decimals are rounded much finer.
    let are_whole = labels.iter().all(|nm| nm.fract() == 0.0);
    if largest > if are_whole { ROUNDED_NM } else { 0.06 } {
        return of_labels(Some(tr!(
            "the header says SPECTRAL_BANDS {bands} from {from} to {to} nm and the labels are \
             {columns} columns from {low} to {high} nm: the labels are believed",
            bands = stated,
            from,
            to,
            columns = count,
            low,
            high
        )));
    }
    if largest <= 1e-9 {
        return of_labels(None);
    }
    let note = tr!(
        "labels are rounded, by up to {largest} nm: the header's SPECTRAL_BANDS {bands} from \
             {from} to {to} nm is believed",
        largest = fixed(largest, 3),
        bands = stated,
        from,
        to
    );
    (even, Some(note))
}
