//! CGATS text: Argyll `.sp`, `.ccss`, `.ti3`, CGATS.17 and IT8.7 with spectral columns.
//!
//! ```text
//! SPECT                                   type of file: SPECT, CCSS, CTI3, CGATS.17, IT8.7/2, ...
//! MEAS_TYPE "REFLECTIVE"                  EMISSION, AMBIENT, TRANSMISSIVE, SENSITIVITY, ..._FLASH
//! SPECTRAL_BANDS "36"                     the grid, once more; it may lie
//! SPECTRAL_START_NM "380.000000"
//! SPECTRAL_END_NM "730.000000"
//! SPECTRAL_NORM "100.000000"              the number that represents 1
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
//! believed; otherwise the labels are, being next to the numbers. Argyll counts light in
//! mW (docs of spotread): radiance per m2, sr and nm, ambient light per m2 and nm. In the pairs
//! `SPECTRAL_NM SPECTRAL_DEC` of CGATS.17 the wavelengths are among the data.

mod bands;
mod quantity;
mod tables;

use crate::spectrum::Kind;

use super::{Confidence, Format};
use crate::io::interpret::factor_scale::KnownScale;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::{Input, ReadError, Reading};
use crate::languages::with_sign;
use bands::{Bands, GRID, grid};
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
const FIRST_WORDS: &str = "SPECT;CCSS;CCMX;CTI1;CTI2;CTI3;CAL;ISO28178;LGOROWLENGTH";

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let first = head.split_whitespace().next().unwrap_or("");
    let known = FIRST_WORDS.split(';').any(|word| word == first)
        || first.starts_with("CGATS")
        || first.starts_with("IT8.7/");
    let begins = |line: &str| line.trim_start().starts_with("BEGIN_DATA_FORMAT");
    let holds = |word| head.contains(word);
    let has_word = || holds("BEGIN_DATA") || holds("KEYWORD") || holds("DESCRIPTOR");
    Confidence::certain_if(head.lines().any(begins) || known && has_word())
}

fn name(input: &Input, table: &CgatsTable, set: usize, several: bool) -> String {
    match table.names.get(set).copied().unwrap_or("") {
        word if word.contains(char::is_alphabetic) => word.to_owned(),
        "" if several => format!("{}, set {}", input.stem(), set + 1),
        "" if table.is_own() => table.key("DESCRIPTOR").unwrap_or(input.stem()).to_owned(),
        number if several => format!("{}, {number}", input.stem()),
        _ => input.stem().to_owned(),
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let tables = tables::tables(input, text)?;
    let mut reading = Reading::default();
    let has_spectra = |table: &&CgatsTable| !table.fields.bands.is_empty();
    let several_tables = tables.iter().filter(has_spectra).count() > 1;
    for (index, table) in tables.iter().enumerate() {
        let groups = &table.fields.bands;
        if reading.spectra.len() + groups.len() * table.sets() > MOST_SPECTRA {
            let found = tr!("more than {most} spectra", most = MOST_SPECTRA);
            return Err(input.error(found, said!("a smaller file")));
        }
        for group in groups {
            read_group(input, table, group, &mut reading)?;
        }
        reading.notes.extend(table.notes.iter().cloned());
        if several_tables && has_spectra(&table) {
            let note = tr!(
                "table {table}: {n} sets" | "table {table}: {n} sets" % table.sets(),
                table = index + 1
            );
            reading.notes.push(note);
        }
    }
    if reading.spectra.is_empty() {
        return Err(nothing_in(input, &tables));
    }
    Ok(reading)
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
    let number = with_sign(norm.to_string());
    let divided = tr!("divided by SPECTRAL_NORM {norm}", norm = number);
    match () {
        () if !SENSIBLE_NORMS.contains(&norm) => {
            let note = tr!(
                "SPECTRAL_NORM {norm} makes no sense and was passed over",
                norm = number
            );
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
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let mut values = table.rows(&group.columns);
    // Wavelengths of each spectrum, or of all.
    let mut axes = table.rows(&group.nm_columns);
    let mut note = None;
    if group.nm_columns.len() == 1 {
        // One wavelength and one value a set: the sets are the points.
        (values, axes) = (vec![values.concat()], vec![axes.concat()]);
    } else if values.is_empty() {
        return Ok(());
    } else if group.nm_columns.is_empty() {
        let (axis, about) = grid(GRID.map(|key| table.number(key)), &group.labels);
        (axes, note) = (vec![axis], about);
    }
    let found = quantity(input, table, group, &values);
    let norm = table.number("SPECTRAL_NORM");
    let scale = scale(norm, table, group);
    let (divided, of_norm) = norm_in_words(norm, found.kind.value);
    let unit = match (found.kind.value, found.unit) {
        (Kind::Light, "") if divided.is_some() => "relative",
        (_, unit) => unit,
    };
    let (several, several_groups) = (values.len() > 1, table.fields.bands.len() > 1);
    for (set, values) in values.into_iter().enumerate() {
        let mut name = name(input, table, set, several);
        if several_groups {
            name = format!("{name}, {}", group.word.replace('|', "_").trim_matches('_'));
        }
        let nm = axes.get(set).unwrap_or(&axes[0]);
        let kind = found.kind.clone();
        let mut spectrum = RawSpectrum::known(name, nm, values, kind, unit);
        spectrum.known.scale = scale.clone();
        spectrum.lines = table.lines.get(set..=set).unwrap_or(&[]);
        spectrum.how.extend(divided.clone());
        let notes = [&note, &found.note, &of_norm].into_iter().flatten();
        spectrum.notes = notes.cloned().collect();
        if let Some(source) = table.key("SOURCE").filter(|_| table.is_own()) {
            spectrum.source = Some(source.to_owned());
            spectrum.before = table.key("NOTES").unwrap_or("");
        }
        interpret(spectrum.with_comma(table.decimal_comma), input, reading)?;
    }
    reading.notes.extend(note);
    Ok(())
}

/// The refusal of a file without spectra.
fn nothing_in(input: &Input, tables: &[CgatsTable]) -> ReadError {
    let expected = said!("columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380");
    let measured = tables.iter().find(|t| t.kind != "CAL");
    let table = measured.or(tables.first());
    let first = || input.head().split_whitespace().next().unwrap_or("");
    let what = match table.map_or_else(first, |table| table.kind) {
        "CCMX" => said!("an Argyll colorimeter matrix (.ccmx)"),
        "CAL" => said!("an Argyll calibration"),
        _ if table.is_none() => said!("a CGATS header without a table"),
        _ => said!("a CGATS table"),
    };
    let Some(table) = table else {
        return input.error(tr!("{what} and no spectral columns", what), expected);
    };
    let line = table.fields.line;
    if !table.fields.bands.is_empty() {
        let found = tr!("{what} with spectral columns and no sets in it", what);
        return input.error_at(line, found, said!("at least one set of data"));
    }
    let titles = &table.fields.titles;
    let more = ["..."].into_iter().filter(|_| titles.len() > 8);
    let fields: Vec<&str> = titles.iter().copied().take(8).chain(more).collect();
    let fields: String = fields.join(" ").chars().take(120).collect();
    let sets = table.sets();
    let found = tr!(
        "{what} of {n} sets with no spectral columns ({fields})"
            | "{what} of {n} sets with no spectral columns ({fields})" % sets,
        what,
        fields
    );
    input.error_at(line, found, expected)
}
