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

use std::collections::HashMap;

use crate::spectrum::Kind;

use super::argyll_write::LABELS_NM;
use super::cgats_tables::{self, CgatsTable};
use super::error::quoted;
use super::interpret::decision::Decision;
use super::interpret::interpret;
use super::interpret::raw::{KnownScale, RawSpectrum};
use super::kinds::{is_plain_name, kind_of_name, kind_of_words};
use super::provenance::ORIGINATOR;
use super::{Confidence, Format, Input, ReadError, Reading};

/// Argyll and CGATS text.
pub const FORMAT: Format = Format {
    name: "CGATS",
    extensions: &["sp", "ccss", "ti3", "cgats", "txt"],
    sniff,
    read,
};

/// Most spectra that one file may hold: each takes memory of its own beside its numbers.
pub const MOST_SPECTRA: usize = 20_000;

/// Most kinds of columns, told by what their labels have in common, that are looked at.
const MOST_GROUPS: usize = 1000;

/// Fewest columns of one kind that are a spectrum.
const FEWEST_BANDS: usize = 3;

/// Largest difference of a rounded label from its wavelength, nm.
const ROUNDED_NM: f64 = 0.5 + 1e-6;

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
    if begins
        || known
            && (head.contains("BEGIN_DATA")
                || head.contains("KEYWORD")
                || head.contains("DESCRIPTOR"))
    {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

/// Columns that make one spectrum a set.
#[derive(Debug)]
struct Bands {
    /// What their labels have in common: `SPEC_`, `nm`.
    word: String,
    /// Column of each band.
    columns: Vec<usize>,
    /// Wavelengths that the labels tell, nm.
    labels: Vec<f64>,
    /// Columns of wavelengths, where they stand among the data.
    nm_columns: Vec<usize>,
}

/// A label's wavelength and what stands around it: `SPECTRAL_NM380_M1` is 380, `SPECTRAL_NM` and
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
fn bands(fields: &[&str]) -> Vec<Bands> {
    let mut groups: HashMap<String, usize> = HashMap::new();
    let mut found: Vec<Bands> = Vec::new();
    let mut last_nm_column = None;
    for (column, field) in fields.iter().enumerate() {
        let upper = if field.len() <= 64 {
            field.to_uppercase()
        } else {
            String::new()
        };
        // CGATS.17: a column with the wavelength before each column with the value.
        if upper == "SPECTRAL_NM" {
            last_nm_column = Some(column);
            continue;
        }
        let pair = matches!(
            upper.as_str(),
            "SPECTRAL_DEC" | "SPECTRAL_PCT" | "SPECTRAL_VAL"
        );
        let (word, nm) = match (pair, last_nm_column.take(), label(field)) {
            (true, Some(nm_column), _) => (upper, Err(nm_column)),
            (_, _, Some((nm, word))) => (word, Ok(nm)),
            _ => continue,
        };
        let next = found.len();
        if next >= MOST_GROUPS && !groups.contains_key(&word) {
            continue;
        }
        let at = *groups.entry(word.clone()).or_insert(next);
        if at == next {
            found.push(Bands {
                word,
                columns: Vec::new(),
                labels: Vec::new(),
                nm_columns: Vec::new(),
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
        pairs || group.columns.len() >= FEWEST_BANDS && (rising || falling)
    });
    found
}

/// The wavelengths of a table's bands, and what is to be said about them.
fn grid(table: &CgatsTable, labels: &[f64]) -> (Vec<f64>, Option<String>) {
    let number = |key: &str| table.number(key).filter(|v| v.is_finite());
    let stated = (
        number("SPECTRAL_BANDS"),
        number("SPECTRAL_START_NM"),
        number("SPECTRAL_END_NM"),
    );
    let (Some(bands), Some(start), Some(end)) = stated else {
        return (labels.to_vec(), None);
    };
    let header = format!("SPECTRAL_BANDS {bands} from {start} to {end} nm");
    let (first, last) = (labels[0], labels[labels.len() - 1]);
    let columns = format!("{} columns from {first} to {last} nm", labels.len());
    if bands != labels.len() as f64 || labels.len() < 2 {
        let note =
            format!("the header says {header} and there are {columns}: the columns are believed");
        return (labels.to_vec(), Some(note));
    }
    let step = (end - start) / (bands - 1.0);
    let even: Vec<f64> = (0..labels.len()).map(|i| start + step * i as f64).collect();
    let largest = labels
        .iter()
        .zip(&even)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    let whole = labels.iter().all(|nm| nm.fract() == 0.0);
    // Labels with decimals are rounded much finer.
    let most = if whole { ROUNDED_NM } else { 0.06 };
    if largest > most {
        let note = format!(
            "the header says {header} and the labels are {columns}: the labels are believed"
        );
        (labels.to_vec(), Some(note))
    } else if largest > 1e-9 {
        let note = format!(
            "labels are rounded, by up to {largest:.3} nm: the header's {header} is believed"
        );
        (even, Some(note))
    } else {
        (labels.to_vec(), None)
    }
}

/// A kind, the unit of a light, and what is to be said of it.
struct Quantity {
    kind: Decision<Kind>,
    unit: String,
    note: Option<String>,
}

impl From<Decision<Kind>> for Quantity {
    fn from(kind: Decision<Kind>) -> Self {
        Self {
            kind,
            unit: String::new(),
            note: None,
        }
    }
}

/// What Argyll's `MEAS_TYPE` and the words of others say.
fn stated_kind(value: &str) -> Option<(Kind, &'static str)> {
    let value = value.to_uppercase();
    let has = |word: &str| value.contains(word);
    Some(if has("AMBIENT") && has("FLASH") {
        (Kind::Light, "mW s m-2 nm-1")
    } else if has("AMBIENT") || has("IRRADIAN") {
        (Kind::Light, "mW m-2 nm-1")
    } else if has("FLASH") {
        (Kind::Light, "mW s m-2 sr-1 nm-1")
    } else if has("EMISS") || has("RADIANCE") {
        (Kind::Light, "mW m-2 sr-1 nm-1")
    } else if has("REFLECT") {
        (Kind::Reflectance, "")
    } else if has("TRANSMI") {
        (Kind::Transmittance, "")
    } else if has("SENSITIV") {
        (Kind::Weighting, "")
    } else {
        return None;
    })
}

/// Words of a description that name a light although no kind is stated.
const LIGHTS: [&str; 12] = [
    "illum", "light", "lamp", "daylight", "tungsten", "led", "d50", "d55", "d65", "d75", "power",
    "emission",
];

/// Words of a description that name samples.
const SAMPLES: [&str; 7] = [
    "sample", "chart", "checker", "paint", "paper", "target", "munsell",
];

/// Whether this program wrote it: its keywords tell name, kind, unit and source.
fn is_own(table: &CgatsTable) -> bool {
    table
        .key("ORIGINATOR")
        .is_some_and(|v| v.starts_with(ORIGINATOR))
}

/// What the values of a table are: as its keywords state, else as labels, descriptions or the
/// file's name tell, else by their size.
fn quantity(input: &Input, table: &CgatsTable, group: &Bands, values: &[Vec<f64>]) -> Quantity {
    stated_quantity(table)
        .or_else(|| kind_of_labels(group).map(Quantity::from))
        .or_else(|| kind_of_measurement(table).map(Quantity::from))
        .or_else(|| kind_of_description(table).map(Quantity::from))
        .unwrap_or_else(|| kind_of_rest(input, table, values).into())
}

/// What keywords state.
fn stated_quantity(table: &CgatsTable) -> Option<Quantity> {
    let own = table.key("KIND").filter(|_| is_own(table));
    if let Some(kind) = own.and_then(|word| Kind::ALL.into_iter().find(|k| k.word() == word)) {
        return Some(Quantity {
            unit: table.key("UNIT").unwrap_or_default().to_owned(),
            ..Decision::of_format(kind).into()
        });
    }
    let argyll = table.number("SPECTRAL_NORM").is_none_or(|norm| norm == 1.0)
        && table
            .key("ORIGINATOR")
            .is_some_and(|v| v.contains("Argyll"));
    for key in ["MEAS_TYPE", "MEASUREMENT_TYPE", "MEASUREMENT_MODE", "TYPE"] {
        if let Some(value) = table.key(key)
            && let Some((kind, unit)) = stated_kind(value)
        {
            let unit = if argyll { unit } else { "" };
            let note = (!unit.is_empty())
                .then(|| format!("{unit} is Argyll's unit; the file states none"));
            return Some(Quantity {
                kind: Decision::of_format(kind),
                unit: unit.to_owned(),
                note,
            });
        }
    }
    if table.kind == "CCSS" {
        return Some(Quantity {
            unit: "relative".to_owned(),
            ..Decision::of_format(Kind::Light).into()
        });
    }
    let kind = match table.key("DEVICE_CLASS")? {
        "DISPLAY" => Kind::Light,
        "OUTPUT" | "INPUT" => Kind::Reflectance,
        _ => return None,
    };
    Some(Decision::of_format(kind).into())
}

/// What the labels of the columns tell.
fn kind_of_labels(group: &Bands) -> Option<Decision<Kind>> {
    let word = group.word.to_uppercase();
    let starts = |starts: &[&str]| starts.iter().any(|start| word.starts_with(start));
    let kind = if starts(&["SPECTRAL_DEC", "SPECTRAL_PCT", "R|"]) {
        Kind::Reflectance
    } else if starts(&["T|"]) {
        Kind::Transmittance
    } else {
        return None;
    };
    Some(Decision::guessed(kind, true, "the columns' labels"))
}

/// What the way of measuring tells.
fn kind_of_measurement(table: &CgatsTable) -> Option<Decision<Kind>> {
    const KEYS: [&str; 3] = [
        "MEASUREMENT_SOURCE",
        "MEASUREMENT_GEOMETRY",
        "MEASUREMENT_CONDITIONS",
    ];
    KEYS.iter().find_map(|key| {
        let value = table.key(key).unwrap_or("");
        let kind = stated_kind(value).map(|s| s.0);
        let lower = value.to_lowercase();
        // A white that values are counted from makes them factors.
        let white = lower.contains("whitebase") || lower.contains("45/0") || lower.contains("d/8");
        let kind = kind.or(white.then_some(Kind::Reflectance))?;
        Some(Decision::guessed(kind, true, says(key, value)))
    })
}

/// What descriptions tell.
fn kind_of_description(table: &CgatsTable) -> Option<Decision<Kind>> {
    const KEYS: [&str; 4] = ["DESCRIPTOR", "DISPLAY", "FILE_DESCRIPTOR", "TARGET_NAME"];
    KEYS.iter().find_map(|key| {
        let value = table.key(key).unwrap_or("");
        let whole = value.to_lowercase();
        // Argyll writes it over lights and samples alike.
        let words = whole.replace("spectral power/reflectance information", "");
        let light = LIGHTS.iter().any(|w| words.contains(w));
        let sample = SAMPLES.iter().any(|w| words.contains(w));
        let kind = if light {
            Some(Kind::Light)
        } else if sample {
            Some(Kind::Reflectance)
        } else {
            kind_of_words(&words)
        };
        let is_evident = !(light && sample || words != whole);
        kind.map(|kind| Decision::guessed(kind, is_evident, says(key, value)))
    })
}

/// What the file's name tells, else the size of the values.
fn kind_of_rest(input: &Input, table: &CgatsTable, values: &[Vec<f64>]) -> Decision<Kind> {
    if let Some(kind) = kind_of_name(&input.name) {
        return Decision::guessed(kind, is_plain_name(&input.name), "the file's name");
    }
    let all_in = |low: f64, high: f64| {
        let mut known = values.iter().flatten().filter(|v| !v.is_nan());
        known.all(|v| (low..=high).contains(v))
    };
    // Several patches of a chart with per cent, by a program that is not Argyll.
    let is_chart = values.len() > 1 && table.kind.starts_with("CGATS") && all_in(-1.0, 130.0);
    let (kind, because) = if is_chart && !all_in(-0.05, 1.3) {
        let because = "nothing states it; several sets with values of 0..100";
        (Kind::Reflectance, because)
    } else if all_in(-0.05, 1.3) {
        let because = "nothing states it; all values lie in 0..1";
        (Kind::Reflectance, because)
    } else {
        (Kind::Light, "nothing states it")
    };
    Decision::guessed(kind, false, because)
}

/// What a field says, in its own words.
fn says(key: &str, value: &str) -> String {
    format!("{key} says {}", quoted(value.trim()))
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
        let at = table
            .fields
            .iter()
            .position(|f| f.eq_ignore_ascii_case(field))?;
        let at = table.word_columns.iter().position(|c| *c == at)?;
        table
            .words
            .get(set * table.word_columns.len() + at)
            .map(|w| w.trim())
            .filter(|w| !w.is_empty())
    });
    match given {
        Some(word) if word.contains(|c: char| c.is_alphabetic()) => word.to_owned(),
        Some(number) if several => format!("{}, {number}", input.stem()),
        None if several => format!("{}, set {}", input.stem(), set + 1),
        None if is_own(table) => table.key("DESCRIPTOR").unwrap_or(input.stem()).to_owned(),
        _ => input.stem().to_owned(),
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let wanted = |fields: &[&str]| -> (Vec<usize>, Vec<usize>) {
        let mut numbers: Vec<usize> = bands(fields)
            .iter()
            .flat_map(|g| g.columns.iter().chain(&g.nm_columns))
            .copied()
            .collect();
        numbers.sort_unstable();
        let words = fields
            .iter()
            .enumerate()
            .filter(|(_, f)| NAMES.iter().any(|n| f.eq_ignore_ascii_case(n)))
            .map(|(i, _)| i)
            .take(NAMES.len())
            .collect();
        (numbers, words)
    };
    let tables = cgats_tables::tables(input, text, &wanted)?;
    let mut reading = Reading::default();
    let several_tables = tables
        .iter()
        .filter(|t| !t.number_columns.is_empty())
        .count()
        > 1;
    for (index, table) in tables.iter().enumerate() {
        let groups = bands(&table.fields);
        let several_groups = groups.len() > 1;
        if reading.spectra.len() + groups.len() * table.sets() > MOST_SPECTRA {
            return Err(input.error(
                format!("more than {MOST_SPECTRA} spectra"),
                "a smaller file",
            ));
        }
        for group in &groups {
            read_group(input, table, group, several_groups, &mut reading)?;
        }
        reading.notes.extend(table.notes.iter().cloned());
        if several_tables && !groups.is_empty() {
            reading
                .notes
                .push(format!("table {}: {} sets", index + 1, table.sets()));
        }
    }
    if reading.spectra.is_empty() {
        return Err(nothing_in(input, &tables));
    }
    Ok(reading)
}

fn read_group(
    input: &Input,
    table: &CgatsTable,
    group: &Bands,
    several_groups: bool,
    reading: &mut Reading,
) -> Result<(), ReadError> {
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
    let mut values: Vec<Vec<f64>> = (0..table.sets()).map(|set| row(set, &columns)).collect();
    let mut axes: Vec<Vec<f64>> = Vec::new();
    let mut grid_note = None;
    let mut lines = table.lines.clone();
    if nm_columns.is_empty() {
        if values.is_empty() {
            return Ok(());
        }
        let (axis, note) = grid(table, &group.labels);
        axes.push(axis);
        grid_note = note;
    } else if nm_columns.len() == 1 {
        // One wavelength and one value a set: the sets are the points.
        axes.push(
            (0..table.sets())
                .map(|set| row(set, &nm_columns)[0])
                .collect(),
        );
        values = vec![values.iter().map(|v| v[0]).collect()];
        lines.truncate(1);
    } else {
        axes.extend((0..table.sets()).map(|set| row(set, &nm_columns)));
    }
    let found = quantity(input, table, group, &values);
    let norm = table.number("SPECTRAL_NORM");
    let good_norm = norm.filter(|n| (1e-9..=1e9).contains(n));
    let scale = match good_norm {
        Some(norm) if norm != 1.0 => KnownScale::Stated(1.0 / norm),
        Some(_) if is_own(table) => KnownScale::Stated(1.0),
        _ if group.word.to_uppercase().starts_with("SPECTRAL_PCT") => KnownScale::Stated(0.01),
        _ => KnownScale::Open,
    };
    let several = values.len() > 1;
    for (set, values) in values.into_iter().enumerate() {
        let mut name = name(input, table, set, several);
        if several_groups {
            name = format!("{name}, {}", group.word.replace('|', "_").trim_matches('_'));
        }
        let mut notes = Vec::new();
        notes.extend(grid_note.clone());
        notes.extend(found.note.clone());
        match (good_norm, norm) {
            (Some(1.0), _) | (None, None) => {}
            (Some(norm), _) if found.kind.value.is_factor() && norm == 100.0 => {
                notes.push("divided by SPECTRAL_NORM 100".to_owned());
            }
            (Some(_), _) => {}
            (None, Some(bad)) => notes.push(format!(
                "SPECTRAL_NORM {bad} makes no sense and was passed over"
            )),
        }
        let unit = match (found.kind.value, found.unit.as_str()) {
            (Kind::Light, "") if good_norm.is_some_and(|n| n != 1.0) => "relative",
            (_, unit) => unit,
        };
        let mut how = Vec::new();
        if let Some(norm) =
            good_norm.filter(|n| *n != 1.0 && (*n != 100.0 || !found.kind.value.is_factor()))
        {
            how.push(format!("divided by SPECTRAL_NORM {norm}"));
        }
        if table.decimal_comma {
            how.push("decimal comma".to_owned());
        }
        let nm = axes.get(set).unwrap_or(&axes[0]);
        let kind = found.kind.clone();
        let mut spectrum = RawSpectrum::known(name, nm, values, kind, unit);
        spectrum.known.scale = scale.clone();
        spectrum.lines = lines.get(set..=set).unwrap_or(&[]);
        (spectrum.how, spectrum.notes) = (how, notes);
        if let Some(source) = table.key("SOURCE").filter(|_| is_own(table)) {
            spectrum.source = Some(source.to_owned());
            spectrum.before = table.key("NOTES").unwrap_or("");
        }
        interpret(spectrum, input, reading)?;
    }
    if let Some(note) = grid_note {
        reading.notes.push(note);
    }
    Ok(())
}

/// The refusal of a file without spectra.
fn nothing_in(input: &Input, tables: &[CgatsTable]) -> ReadError {
    const EXPECTED: &str = "columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380";
    let measured = tables.iter().find(|t| t.kind != "CAL");
    let Some(table) = measured.or(tables.first()) else {
        let what = match input.head().split_whitespace().next() {
            Some("CCMX") => "an Argyll colorimeter matrix (.ccmx) and no spectral columns",
            Some("CAL") => "an Argyll calibration and no spectral columns",
            _ => "a CGATS header without a table and no spectral columns",
        };
        return input.error(what, EXPECTED);
    };
    let mut fields: Vec<&str> = table.fields.iter().take(8).copied().collect();
    if table.fields.len() > fields.len() {
        fields.push("...");
    }
    let what = match table.kind {
        "CCMX" => "an Argyll colorimeter matrix (.ccmx)",
        "CAL" => "an Argyll calibration",
        _ => "a CGATS table",
    };
    let joined: String = fields.join(" ").chars().take(120).collect();
    let has_columns = !table.number_columns.is_empty();
    let found = if has_columns {
        format!("{what} with spectral columns and no sets in it")
    } else {
        format!(
            "{what} of {} sets with no spectral columns ({joined})",
            table.sets()
        )
    };
    input
        .error(
            found,
            if has_columns {
                "at least one set of data"
            } else {
                EXPECTED
            },
        )
        .at_line(table.format_line)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::read_bytes;

    fn sp(header: &str, fields: &str, data: &str) -> String {
        format!(
            "SPECT   \n\nORIGINATOR \"Argyll CMS\"\n{header}\nBEGIN_DATA_FORMAT\n{fields}\nEND_DATA_FORMAT\n\nBEGIN_DATA\n{data}\nEND_DATA\n"
        )
    }

    fn reading(text: &str) -> Reading {
        read_bytes("x.sp", text.as_bytes()).unwrap()
    }

    fn refusal(text: &str) -> String {
        read_bytes("x.sp", text.as_bytes()).unwrap_err().to_string()
    }

    const GRID: &str =
        "SPECTRAL_BANDS \"3\"\nSPECTRAL_START_NM \"380.0\"\nSPECTRAL_END_NM \"400.0\"";

    #[test]
    fn a_norm_is_the_scale_and_the_type_is_the_kind() {
        let text = sp(
            &format!("MEAS_TYPE \"REFLECTIVE\"\nSPECTRAL_NORM \"100.0\"\n{GRID}"),
            "SPEC_380 SPEC_390 SPEC_400",
            "3.5 4.5 5.5",
        );
        let found = reading(&text);
        let spectrum = &found.spectra[0];
        assert_eq!((spectrum.kind, spectrum.scale), (Kind::Reflectance, 0.01));
        assert_eq!(spectrum.samples.nm(), [380.0, 390.0, 400.0]);
        assert!(found.guesses.is_empty());
        for text in [
            text.replace('\n', "\r\n"),
            text.replace('"', ""),
            text.replace(' ', "\t"),
            text.replace("3.5 4.5 5.5", "3,5 4,5 5,5"),
            text.replace("3.5 4.5 5.5", "3.5\n4.5 5.5"),
            format!("\u{feff}{text}"),
            text.replace("SPEC_", "nm"),
            text.replace("SPEC_", "SPECTRAL_NM"),
            text.replace("SPEC_", "SPECTRAL_NM_"),
            text.replace("SPEC_", "SPECTRAL_"),
            text.replace("SPECT   ", "CGATS.17"),
        ] {
            assert_eq!(
                reading(&text).spectra[0].samples,
                spectrum.samples,
                "{text}"
            );
        }
    }

    #[test]
    fn light_has_argylls_unit() {
        for (kind, unit) in [("EMISSION", "mW m-2 sr-1 nm-1"), ("AMBIENT", "mW m-2 nm-1")] {
            let text = sp(
                &format!("MEAS_TYPE \"{kind}\"\nSPECTRAL_NORM \"1.0\""),
                "SPEC_380 SPEC_390 SPEC_400",
                "3 4 5",
            );
            assert_eq!(reading(&text).spectra[0].unit, unit);
        }
    }

    #[test]
    fn rounded_labels_yield_to_the_header_and_a_wrong_header_to_the_labels() {
        let header = "SPECTRAL_BANDS \"4\"\nSPECTRAL_START_NM \"370.0\"\nSPECTRAL_END_NM \"380.0\"";
        let rounded = reading(&sp(
            header,
            "SPEC_370 SPEC_373 SPEC_377 SPEC_380",
            "1 2 3 4",
        ));
        assert_eq!(rounded.spectra[0].samples.nm()[1], 370.0 + 10.0 / 3.0);
        assert!(
            rounded
                .notes
                .iter()
                .any(|n| n.contains("header's") && n.contains("believed"))
        );
        let lies = reading(&sp(
            header,
            "SPEC_355 SPEC_360 SPEC_365 SPEC_370",
            "1 2 3 4",
        ));
        assert_eq!(lies.spectra[0].samples.first_nm(), 355.0);
        assert!(
            lies.notes.iter().any(|n| n.contains("labels are believed")),
            "{:?}",
            lies.notes
        );
        let fewer = reading(&sp(header, "SPEC_370 SPEC_375 SPEC_380", "1 2 3"));
        assert_eq!(fewer.spectra[0].samples.nm(), [370.0, 375.0, 380.0]);
        assert!(
            fewer
                .notes
                .iter()
                .any(|n| n.contains("columns are believed"))
        );
    }

    #[test]
    fn sets_are_spectra_named_by_their_fields() {
        let text = sp(
            "DESCRIPTOR \"Test Color Samples\"",
            "SAMPLE_ID\tSAMPLE_NAME\tRGB_R\tnm380\tnm390\tnm400",
            "1\tDark skin\t5\t0.1\t0.2\t0.3\n2\t\"Light skin\"\t5\t0.2\t0.3\t0.4\n3\tNone\t5\t\t0.3\t0.4",
        );
        let found = reading(&text);
        let names: Vec<_> = found.spectra.iter().map(|s| s.name.as_str()).collect();
        assert_eq!(names, ["Dark skin", "Light skin", "None"]);
        assert_eq!(found.spectra[2].samples.len(), 2, "the empty cell is a gap");
        assert_eq!(found.spectra[0].kind, Kind::Reflectance);
    }

    #[test]
    fn several_tables_and_several_spectra_a_set_are_read() {
        let one = sp("", "SAMPLE_ID SPEC_380 SPEC_390 SPEC_400", "A1 0.1 0.2 0.3");
        let two = sp(
            "",
            "SAMPLE_ID SPEC_380_M0 SPEC_390_M0 SPEC_400_M0 SPEC_380_M1 SPEC_390_M1 SPEC_400_M1",
            "B1 1 2 3 4 5 6",
        );
        let names: Vec<String> = reading(&(one + &two))
            .spectra
            .into_iter()
            .map(|s| s.name)
            .collect();
        assert_eq!(names, ["A1", "B1, SPEC_M0", "B1, SPEC_M1"]);
    }

    #[test]
    fn wavelengths_among_the_data_are_read() {
        let text = sp(
            "",
            "SAMPLE_ID SPECTRAL_NM SPECTRAL_PCT SPECTRAL_NM SPECTRAL_PCT",
            "A 380 10 390 20\nB 380 30 390 40",
        );
        let found = reading(&text);
        assert_eq!(found.spectra.len(), 2);
        assert_eq!(found.spectra[1].scale, 0.01);
        assert_eq!(found.spectra[1].samples.nm(), [380.0, 390.0]);
        let text = sp("", "SPECTRAL_NM SPECTRAL_DEC", "380 0.1\n390 0.2\n400 0.3");
        assert_eq!(reading(&text).spectra[0].samples.values(), [0.1, 0.2, 0.3]);
    }

    #[test]
    fn what_is_wrong_is_told_with_its_line() {
        assert_eq!(
            refusal(&sp("", "SAMPLE_ID RGB_R RGB_G", "1 2 3")),
            "x.sp, line 5: found a CGATS table of 1 sets with no spectral columns (SAMPLE_ID RGB_R RGB_G), expected columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380"
        );
        let fields = "SPEC_380 SPEC_390 SPEC_400";
        assert_eq!(
            refusal(&sp("", fields, "1 2 3\n1 abc 3")),
            "x.sp, line 11: found \"abc\", expected a number for SPEC_390"
        );
        assert_eq!(
            refusal(&sp("", fields, "1 2 3\n1 2\n1 2 3")),
            "x.sp, line 11: found 2 cells, expected 3, one for each field"
        );
        assert_eq!(
            refusal("SPECT\nDESCRIPTOR \"x\"\n"),
            "x.sp: found a CGATS header without a table and no spectral columns, expected columns of a spectrum such as SPEC_380, nm380 or SPECTRAL_NM380"
        );
        assert!(refusal("CGATS.17\nBEGIN_DATA\n1 2 3\nEND_DATA\n").contains("BEGIN_DATA_FORMAT"));
    }

    #[test]
    fn a_file_cut_off_behind_a_whole_row_is_read_and_it_is_said() {
        let text = sp(
            "NUMBER_OF_SETS 3",
            "SPEC_380 SPEC_390 SPEC_400",
            "1 2 3\n4 5 6",
        );
        let found = reading(text.split("END_DATA\n").next().unwrap_or(""));
        assert!(!found.spectra.is_empty() || found.notes.is_empty());
        let cut = text.trim_end().strip_suffix("END_DATA").unwrap();
        let found = reading(cut);
        assert_eq!(found.spectra.len(), 2);
        assert!(found.notes.iter().any(|n| n.contains("END_DATA")));
        assert!(
            found
                .notes
                .iter()
                .any(|n| n.contains("NUMBER_OF_SETS says 3"))
        );
    }
}
