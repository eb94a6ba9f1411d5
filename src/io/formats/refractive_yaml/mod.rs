//! refractiveindex.info: YAML with the optical constants n and k over wavelengths in micrometres.
//!
//! `DATA` is a list of tables (`tabulated nk`, `tabulated n`, `tabulated k`, columns with blanks)
//! and dispersion formulas 1 to 9 ([`Formula`]), which are sampled at whole nanometres, and more
//! coarsely in the far infrared ([`grid`]); the spectrum keeps its formula. Every n and k becomes a spectrum, and the reflectance
//! at normal incidence from air, ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2), a further one that notes it
//! was computed. Where a file holds n as a table and by a formula, the table counts.

pub(crate) mod grid;
pub(crate) mod quoted_text;

use serde::Deserialize;

use crate::spectrum::{Formula, Kind, MOST_COEFFICIENTS, Outside, Sampled};

use super::{Confidence, Format};
use crate::io::decode::guarded::guarded;
use crate::io::error::quoted;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::interpret::{curve, interpret};
use crate::io::reading::decision::Decision;
use crate::io::text::{lines, number};
use crate::io::{Input, ReadError, Reading, budget};
use crate::languages::with_sign;

/// refractiveindex.info.
pub(crate) const FORMAT: Format = Format {
    name: "refractiveindex.info YAML",
    extensions: &["yml", "yaml"],
    sniff,
    read,
};

/// Most tables and formulas of one file.
const MOST_DATA: usize = 20;

fn sniff(input: &Input) -> Confidence {
    let is_ours = |text: &str| {
        (text.contains("type: tabulated") || text.contains("type: formula"))
            && text.lines().any(|line| line.trim_end() == "DATA:")
    };
    // Long references may precede the data.
    let is_named = || input.has_extension("yml") || input.has_extension("yaml");
    let is_whole = || input.text().is_some_and(|text| is_ours(&text.text));
    Confidence::certain_if(is_ours(input.head()) || is_named() && is_whole())
}

/// The file, as far as it is read.
#[derive(Deserialize)]
struct File {
    #[serde(rename = "REFERENCES", default)]
    references: String,
    #[serde(rename = "COMMENTS", default)]
    comments: String,
    #[serde(rename = "DATA")]
    data: Vec<Data>,
}

/// One table or formula.
#[derive(Deserialize)]
struct Data {
    r#type: String,
    #[serde(default)]
    data: String,
    #[serde(default)]
    wavelength_range: String,
    #[serde(default)]
    range: String,
    #[serde(default)]
    coefficients: String,
}

/// The file as YAML.
fn parse(input: &Input, text: &str) -> Result<File, ReadError> {
    parse_strictly(text).or_else(|first| {
        // The site's own reader is more lenient about text in quotes.
        let second = quoted_text::indented(text).filter(|_| first.is_some());
        let second = second.and_then(|text| parse_strictly(&text).ok());
        second.ok_or_else(|| match first {
            Some(why) => input.error(
                tr!("broken YAML ({why})", why),
                said!("REFERENCES, COMMENTS and DATA as refractiveindex.info writes them"),
            ),
            None => input.error(said!("broken YAML"), said!("YAML of refractiveindex.info")),
        })
    })
}

/// The parsed file, or the first line of the parser's error; `None` if the parser panics.
fn parse_strictly(text: &str) -> Result<File, Option<String>> {
    let mut limits = serde_saphyr::Budget::default();
    limits.max_recorded_anchor_bytes = 1 << 20;
    limits.max_total_scalar_bytes = budget::of_text(text.len()) / 4;
    limits.max_nodes = 20_000;
    let mut options = serde_saphyr::Options::default();
    options.budget = Some(limits);
    let parsed = guarded(|| serde_saphyr::from_str_with_options::<File>(text, options));
    parsed.ok_or(None)?.map_err(|error| {
        let why = error.to_string();
        Some(why.lines().next().unwrap_or("").to_owned())
    })
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let file = parse(input, text)?;
    if file.data.len() > MOST_DATA {
        let found = tr!("{n} tables and formulas" | "{n} tables and formulas" % file.data.len());
        return Err(input.error(found, tr!("at most {most}", most = MOST_DATA)));
    }
    let source = plain(&file.references);
    let mut about = Vec::new();
    if !file.comments.trim().is_empty() {
        about.push(tr!(
            "comment in the file: {comment}",
            comment = plain(&file.comments)
        ));
    }
    let mut reading = Reading::default();
    let mut push = |(name, kind): (String, Kind), samples: &Sampled, notes| {
        let (kind, values) = (Decision::of_format(kind), samples.values().to_vec());
        let mut raw = RawSpectrum::known(name, samples.nm(), values, kind, "");
        raw.notes = notes;
        raw.source = Some(source.clone());
        interpret(raw, input, &mut reading)?;
        if let (Some(formula), Some(read)) = (samples.formula(), reading.spectra.last_mut()) {
            read.samples = read.samples.clone().of_formula(formula.clone());
        }
        Ok::<(), ReadError>(())
    };
    let (mut n, mut k): (Option<Sampled>, Option<Sampled>) = (None, None);
    // A formula beside a table of n comes last.
    let tabulates_n = |data: &Data| matches!(data.r#type.trim(), "tabulated n" | "tabulated nk");
    let has_table_of_n = file.data.iter().any(tabulates_n);
    let is_beside = |data: &Data| has_table_of_n && data.r#type.trim().starts_with("formula");
    let mut all: Vec<(bool, &Data)> = file.data.iter().map(|d| (is_beside(d), d)).collect();
    all.sort_by_key(|(is_beside, _)| *is_beside);
    for (is_beside, data) in all {
        for (letter, samples, mut notes) in read_data(input, text, data)? {
            notes.extend(about.iter().cloned());
            let kept = if letter == 'n' { &mut n } else { &mut k };
            let mut name = format!("{} {letter}", input.stem());
            if is_beside {
                name += &format!(" by {}", data.r#type.trim());
                let note =
                    said!("the file holds n as a table too, from which the rest is computed");
                notes.push(note.to_owned());
            } else {
                kept.get_or_insert_with(|| samples.clone());
            }
            push((name, Kind::Other), &samples, notes)?;
        }
    }
    if let Some((samples, how)) = n.and_then(|n| reflectance(&n, k.as_ref())) {
        let mut notes = vec![how.to_owned()];
        notes.extend(about);
        let name = format!("{} reflectance", input.stem());
        push((name, Kind::Reflectance), &samples, notes)?;
    }
    if reading.spectra.is_empty() {
        let expected = said!("tabulated nk, tabulated n, tabulated k or a formula");
        return Err(input.error(said!("no data"), expected));
    }
    Ok(reading)
}

/// Spectra of one table or formula: 'n' or 'k', and notes on the processing.
fn read_data(
    input: &Input,
    text: &str,
    data: &Data,
) -> Result<Vec<(char, Sampled, Vec<String>)>, ReadError> {
    let kind = data.r#type.trim();
    let formula = kind.strip_prefix("formula ");
    let letters = match (kind, formula.and_then(|number| number.trim().parse().ok())) {
        ("tabulated nk", _) => "nk",
        ("tabulated n", _) => "n",
        ("tabulated k", _) => "k",
        (_, Some(number @ 1..=9)) => {
            let (samples, notes) = read_formula(input, data, number)?;
            return Ok(vec![('n', samples, notes)]);
        }
        _ => {
            let expected = said!("tabulated nk, tabulated n, tabulated k or formula 1 to 9");
            let found = tr!("data of the type {kind}", kind = quoted(kind));
            return Err(input.error(found, expected));
        }
    };
    let mut columns = columns(input, text, &data.data, letters.len() + 1)?;
    let nm: Vec<f64> = columns.remove(0).iter().map(|um| um * 1000.0).collect();
    let of_letter = |(letter, values): (char, Vec<f64>)| {
        let how = said!("wavelengths converted from um").to_owned();
        let (samples, notes) = clean(input, &nm, &values, how)?;
        Ok((letter, samples, notes))
    };
    letters.chars().zip(columns).map(of_letter).collect()
}

/// The columns of a table.
fn columns(
    input: &Input,
    text: &str,
    table: &str,
    width: usize,
) -> Result<Vec<Vec<f64>>, ReadError> {
    let mut columns = vec![Vec::new(); width];
    for (_, row) in lines(table) {
        let row = row.trim();
        if row.is_empty() || row.starts_with('#') {
            continue;
        }
        let cells = row.split_whitespace().take(width + 1);
        let numbers: Option<Vec<f64>> = cells.map(|cell| number::number(cell, false)).collect();
        let Some(numbers) = numbers.filter(|numbers| numbers.len() == width) else {
            let error = input.error(quoted(row), tr!("{n} numbers" | "{n} numbers" % width));
            return Err(match lines(text).find(|(_, line)| line.trim() == row) {
                Some((line, _)) => error.at_line(line),
                None => error,
            });
        };
        columns.iter_mut().zip(numbers).for_each(|(c, n)| c.push(n));
    }
    Ok(columns)
}

fn read_formula(
    input: &Input,
    data: &Data,
    number: u8,
) -> Result<(Sampled, Vec<String>), ReadError> {
    let numbers = |text: &str, what: &str| -> Result<Vec<f64>, ReadError> {
        let number = |word: &str| {
            number::number(word, false)
                .filter(|x| x.is_finite())
                .ok_or_else(|| input.error(quoted(word), tr!("numbers as {key}", key = what)))
        };
        text.split_whitespace().map(number).collect()
    };
    let coefficients = numbers(&data.coefficients, "coefficients")?;
    if coefficients.len() > MOST_COEFFICIENTS {
        let found = tr!("{n} coefficients" | "{n} coefficients" % coefficients.len());
        return Err(input.error(found, tr!("at most {most}", most = MOST_COEFFICIENTS)));
    }
    let range = match data.wavelength_range.trim() {
        "" => &data.range,
        range => range,
    };
    let range = numbers(range, "wavelength_range")?;
    let [from_um, to_um] = range[..] else {
        let found =
            tr!("a wavelength range of {n} numbers"
                | "a wavelength range of {n} numbers" % range.len());
        return Err(input.error(found, said!("first and last wavelength in um")));
    };
    let range_nm = [from_um * 1000.0, to_um * 1000.0];
    let (nm, how) = grid::of(range_nm[0], range_nm[1]);
    let formula = Formula::new(number, coefficients, range_nm).ok_or_else(|| {
        input.error(
            tr!(
                "a wavelength range from {from} to {to}",
                from = with_sign(from_um.to_string()),
                to = with_sign(to_um.to_string())
            ),
            said!("first and last wavelength in um, rising"),
        )
    })?;
    let values: Vec<f64> = nm.iter().map(|nm| formula.index(nm / 1000.0)).collect();
    let how = tr!(
        "n computed from dispersion formula {number} {how}",
        number,
        how
    );
    let (samples, notes) = clean(input, &nm, &values, how)?;
    Ok((samples.of_formula(formula), notes))
}

/// The curve of some points, and notes on the processing.
fn clean(
    input: &Input,
    nm: &[f64],
    values: &[f64],
    how: String,
) -> Result<(Sampled, Vec<String>), ReadError> {
    let cleaned =
        curve::clean(nm, values).map_err(|trouble| input.error(trouble.found, trouble.expected))?;
    let notes = cleaned.notes.into_iter().chain([how]).collect();
    Ok((cleaned.samples, notes))
}

/// Reflectance at normal incidence from air, and its derivation in words; `None` if n and k have
/// too few wavelengths in common.
fn reflectance(n: &Sampled, k: Option<&Sampled>) -> Option<(Sampled, &'static str)> {
    let inside = |nm: f64| k.is_none_or(|k| nm >= k.first_nm() && nm <= k.last_nm());
    let points = n.nm().iter().zip(n.values());
    let points = points.filter(|(nm, _)| inside(**nm)).map(|(nm, n)| {
        let k = k.map_or(0.0, |k| k.at(*nm, Outside::Hold));
        let squared = |real: f64| real * real + k * k;
        (*nm, squared(n - 1.0) / squared(n + 1.0))
    });
    let (nm, values) = points.filter(|(_, r)| r.is_finite()).unzip();
    let how = if k.is_some() {
        said!("computed from n and k: ((n-1)^2+k^2)/((n+1)^2+k^2), normal incidence from air")
    } else {
        said!(
            "computed from n alone (no k in the file): ((n-1)/(n+1))^2, one face, normal incidence"
        )
    };
    Some((Sampled::new(nm, values).ok()?, how))
}

/// Text without tags and line ends.
fn plain(html: &str) -> String {
    let mut text = String::new();
    let mut in_tag = false;
    for c in html.chars().take(2000) {
        match c {
            '<' => in_tag = true,
            '>' if in_tag => in_tag = false,
            c if !in_tag => text.push(c),
            _ => {}
        }
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
