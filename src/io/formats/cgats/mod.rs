//! CGATS text: Argyll `.sp`, `.ccss`, `.ti3`, CGATS.17 and IT8.7 with spectral columns.
//!
//! ```text
//! SPECT                                   what the file is: SPECT, CCSS, CTI3, CGATS.17, IT8.7/2, ...
//! MEAS_TYPE "REFLECTIVE"                  EMISSION, AMBIENT, TRANSMISSIVE, SENSITIVITY, ..._FLASH
//! SPECTRAL_BANDS "36"                     the grid, once more; it may lie
//! SPECTRAL_START_NM "380.000000"
//! SPECTRAL_END_NM "730.000000"
//! SPECTRAL_NORM "100.000000"              the number that stands for 1
//! BEGIN_DATA_FORMAT
//! SAMPLE_ID SPEC_380 SPEC_390 ...         nm380, SPECTRAL_NM380, SPECTRAL_380, R_380, ... likewise
//! END_DATA_FORMAT
//! BEGIN_DATA
//! 1 3.823428 3.817302 ...                 one set, one spectrum
//! END_DATA                                further tables may follow
//! ```
//!
//! Header and labels are compared. Labels are whole nanometres even where the grid is finer
//! (SPEC_373 for 373.333), so that a header that agrees with every label to half a nanometre is
//! believed; otherwise the labels are, since they stand with the numbers. Argyll counts light in
//! mW (docs of spotread): radiance per m2, sr and nm, ambient light per m2 and nm. In the pairs
//! `SPECTRAL_NM SPECTRAL_DEC` of CGATS.17 the wavelengths stand among the data.

mod bands;
mod quantity;
mod tables;

use crate::spectrum::Kind;

use super::{Confidence, Format};
use crate::io::interpret::factor_scale::KnownScale;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::{Input, ReadError, Reading};
use bands::{Bands, bands, grid};
use quantity::quantity;
use tables::CgatsTable;

/// Argyll and CGATS text.
pub(crate) const FORMAT: Format = Format {
    name: "CGATS",
    extensions: &["sp", "ccss", "ti3", "cgats", "txt"],
    sniff,
    read,
};

/// Most spectra that one file may hold: each takes memory of its own beside its numbers.
const MOST_SPECTRA: usize = 20_000;

/// First words of files of the family.
const FIRST_WORDS: [&str; 9] = [
    "SPECT",
    "CCSS",
    "CCMX",
    "CTI1",
    "CTI2",
    "CTI3",
    "CAL",
    "ISO28178",
    "LGOROWLENGTH",
];

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let first = head.split_whitespace().next().unwrap_or("");
    let known =
        FIRST_WORDS.contains(&first) || first.starts_with("CGATS") || first.starts_with("IT8.7/");
    let begins = head
        .lines()
        .any(|line| line.trim_start().starts_with("BEGIN_DATA_FORMAT"));
    let has_word = || {
        ["BEGIN_DATA", "KEYWORD", "DESCRIPTOR"]
            .iter()
            .any(|w| head.contains(w))
    };
    Confidence::certain_if(begins || known && has_word())
}

/// Fields that name a set, the best first.
const NAMES: [&str; 8] = [
    "SAMPLE_NAME",
    "SAMPLENAME",
    "SAMPLE_ID",
    "SAMPLEID",
    "SAMPLE_LOC",
    "PATCH_NAME",
    "NAME",
    "STRING",
];

fn name(input: &Input, table: &CgatsTable, set: usize, several: bool) -> String {
    let given = NAMES.iter().find_map(|field| {
        let mut fields = table.fields.iter();
        let at = fields.position(|f| f.eq_ignore_ascii_case(field))?;
        let at = table.word_columns.iter().position(|c| *c == at)?;
        let word = table.words.get(set * table.word_columns.len() + at)?.trim();
        (!word.is_empty()).then_some(word)
    });
    match given {
        Some(word) if word.contains(|c: char| c.is_alphabetic()) => word.to_owned(),
        Some(number) if several => format!("{}, {number}", input.stem()),
        None if several => format!("{}, set {}", input.stem(), set + 1),
        None if table.is_own() => table.key("DESCRIPTOR").unwrap_or(input.stem()).to_owned(),
        _ => input.stem().to_owned(),
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let stated = text.lines().find_map(|line| {
        let bands = line.trim_start().strip_prefix("SPECTRAL_BANDS")?;
        bands.trim_matches([' ', '\t', '"']).parse().ok()
    });
    let wanted = |fields: &[&str]| -> (Vec<usize>, Vec<usize>) {
        let mut numbers: Vec<usize> = bands(fields, stated)
            .iter()
            .flat_map(|g| g.columns.iter().chain(&g.nm_columns))
            .copied()
            .collect();
        numbers.sort_unstable();
        let is_name = |at: &usize| NAMES.iter().any(|n| fields[*at].eq_ignore_ascii_case(n));
        let words = (0..fields.len()).filter(is_name).take(NAMES.len());
        (numbers, words.collect())
    };
    let tables = tables::tables(input, text, &wanted)?;
    let mut reading = Reading::default();
    let has_spectra = |table: &&CgatsTable| !table.number_columns.is_empty();
    let several_tables = tables.iter().filter(has_spectra).count() > 1;
    for (index, table) in tables.iter().enumerate() {
        let groups = bands(&table.fields, stated);
        let several_groups = groups.len() > 1;
        if reading.spectra.len() + groups.len() * table.sets() > MOST_SPECTRA {
            let found = format!("more than {MOST_SPECTRA} spectra");
            return Err(input.error(found, "a smaller file"));
        }
        for group in &groups {
            read_group(input, table, group, several_groups, &mut reading)?;
        }
        reading.notes.extend(table.notes.iter().cloned());
        if several_tables && !groups.is_empty() {
            let note = format!("table {}: {} sets", index + 1, table.sets());
            reading.notes.push(note);
        }
    }
    if reading.spectra.is_empty() {
        return Err(nothing_in(input, &tables));
    }
    Ok(reading)
}

/// The spectra of a group of columns.
struct Sets {
    /// Of each spectrum.
    values: Vec<Vec<f64>>,
    /// Wavelengths of each spectrum, or of all.
    axes: Vec<Vec<f64>>,
    /// Lines of the spectra, from 1.
    lines: Vec<u32>,
    /// What is to be said of the wavelengths.
    note: Option<String>,
}

impl Sets {
    /// Those of a table; `None` where it holds none.
    fn of(table: &CgatsTable, group: &Bands) -> Option<Self> {
        let at = |columns: &[usize]| -> Vec<usize> {
            columns
                .iter()
                .filter_map(|c| table.number_columns.binary_search(c).ok())
                .collect()
        };
        let (columns, nm_columns) = (at(&group.columns), at(&group.nm_columns));
        let row = |set: usize, columns: &[usize]| -> Vec<f64> {
            let row = &table.numbers[set * table.number_columns.len()..];
            columns.iter().map(|c| row[*c]).collect()
        };
        let rows = |columns: &[usize]| -> Vec<Vec<f64>> {
            (0..table.sets()).map(|set| row(set, columns)).collect()
        };
        let mut sets = Self {
            values: rows(&columns),
            axes: Vec::new(),
            lines: table.lines.clone(),
            note: None,
        };
        if nm_columns.is_empty() {
            if sets.values.is_empty() {
                return None;
            }
            let (axis, note) = grid(table, &group.labels);
            (sets.axes, sets.note) = (vec![axis], note);
        } else if nm_columns.len() == 1 {
            // One wavelength and one value a set: the sets are the points.
            let points =
                |rows: Vec<Vec<f64>>| -> Vec<f64> { rows.iter().map(|row| row[0]).collect() };
            sets.axes = vec![points(rows(&nm_columns))];
            sets.values = vec![points(sets.values)];
            sets.lines.truncate(1);
        } else {
            sets.axes = rows(&nm_columns);
        }
        Some(sets)
    }
}

/// Sizes of `SPECTRAL_NORM` that make sense.
const SENSIBLE_NORMS: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// The factor to the values.
fn scale(norm: Option<f64>, table: &CgatsTable, group: &Bands) -> KnownScale {
    match norm.filter(|norm| SENSIBLE_NORMS.contains(norm)) {
        Some(norm) if norm != 1.0 => KnownScale::Stated(1.0 / norm),
        Some(_) if table.is_own() => KnownScale::Stated(1.0),
        _ if group.word.to_uppercase().starts_with("SPECTRAL_PCT") => KnownScale::Stated(0.01),
        _ => KnownScale::Open,
    }
}

/// Words about the norm for the line of provenance, and a note, where there are any: per cent of a
/// factor are worth a note of their own.
fn norm_in_words(norm: Option<f64>, kind: Kind) -> (Option<String>, Option<String>) {
    let Some(norm) = norm.filter(|norm| *norm != 1.0) else {
        return (None, None);
    };
    let divided = format!("divided by SPECTRAL_NORM {norm}");
    match () {
        () if !SENSIBLE_NORMS.contains(&norm) => {
            let note = format!("SPECTRAL_NORM {norm} makes no sense and was passed over");
            (None, Some(note))
        }
        () if kind.is_factor() && norm == 100.0 => (None, Some(divided)),
        () => (Some(divided), None),
    }
}

fn read_group(
    input: &Input,
    table: &CgatsTable,
    group: &Bands,
    several_groups: bool,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let Some(sets) = Sets::of(table, group) else {
        return Ok(());
    };
    let found = quantity(input, table, group, &sets.values);
    let norm = table.number("SPECTRAL_NORM");
    let scale = scale(norm, table, group);
    let (divided, of_norm) = norm_in_words(norm, found.kind.value);
    let unit = match (found.kind.value, found.unit) {
        (Kind::Light, "") if divided.is_some() => "relative",
        (_, unit) => unit,
    };
    let several = sets.values.len() > 1;
    for (set, values) in sets.values.into_iter().enumerate() {
        let mut name = name(input, table, set, several);
        if several_groups {
            name = format!("{name}, {}", group.word.replace('|', "_").trim_matches('_'));
        }
        let nm = sets.axes.get(set).unwrap_or(&sets.axes[0]);
        let kind = found.kind.clone();
        let mut spectrum = RawSpectrum::known(name, nm, values, kind, unit);
        spectrum.known.scale = scale.clone();
        spectrum.lines = sets.lines.get(set..=set).unwrap_or(&[]);
        spectrum.how.extend(divided.clone());
        let notes = [&sets.note, &found.note, &of_norm].into_iter().flatten();
        spectrum.notes = notes.cloned().collect();
        if let Some(source) = table.key("SOURCE").filter(|_| table.is_own()) {
            spectrum.source = Some(source.to_owned());
            spectrum.before = table.key("NOTES").unwrap_or("");
        }
        interpret(spectrum.with_comma(table.decimal_comma), input, reading)?;
    }
    reading.notes.extend(sets.note);
    Ok(())
}

/// The refusal of a file without spectra.
fn nothing_in(input: &Input, tables: &[CgatsTable]) -> ReadError {
    const EXPECTED: &str = "columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380";
    let measured = tables.iter().find(|t| t.kind != "CAL");
    let table = measured.or(tables.first());
    let first = || input.head().split_whitespace().next().unwrap_or("");
    let what = match table.map_or_else(first, |table| table.kind) {
        "CCMX" => "an Argyll colorimeter matrix (.ccmx)",
        "CAL" => "an Argyll calibration",
        _ if table.is_none() => "a CGATS header without a table",
        _ => "a CGATS table",
    };
    let Some(table) = table else {
        return input.error(format!("{what} and no spectral columns"), EXPECTED);
    };
    let refusal = if table.number_columns.is_empty() {
        let mut fields: Vec<&str> = table.fields.iter().take(8).copied().collect();
        if table.fields.len() > fields.len() {
            fields.push("...");
        }
        let fields: String = fields.join(" ").chars().take(120).collect();
        let sets = table.sets();
        let found = format!("{what} of {sets} sets with no spectral columns ({fields})");
        input.error(found, EXPECTED)
    } else {
        let found = format!("{what} with spectral columns and no sets in it");
        input.error(found, "at least one set of data")
    };
    refusal.at_line(table.format_line)
}
