//! The composite model as JSON, bit-exact there and back.
//!
//! ```text
//! {"format": "composite-spectrum", "version": 1 | 2, "range_nm": [min, max],
//!  "basis": the word of a `Basis`,
//!  "coefficients": {"a": [N+1], "b": [N]} | {"c": [2N+1]},
//!  "spikes": [{"at_nm", "weight", "fwhm_nm"}], "unit", "source", "name", "kind", "scale_in_force",
//!  "written_by"}
//! ```
//!
//! `name` and `kind` ("light", "reflectance", ...) may be missing: then the model is called as its
//! file and is a light. The last two are for humans; a model is always written in its file's own
//! numbers.
//!
//! `fwhm_nm`, the full width of a Gaussian line at half its height, is version 2's: without it a line
//! is an ideal spike. A model of ideal spikes is written as version 1.
//!
//! The Fourier `a0` is the paper's, halved in the series; the cosine `c0` is not. A Fourier series
//! whose last sine was dropped is written with a zero in its place.

use serde::{Deserialize, Serialize};

use crate::spectrum::{Band, BandError, Basis, Composite, Kind, Line, Series};

use super::{Confidence, Format};
use crate::io::decode::json::json_error;
use crate::io::error::WriteError;
use crate::io::many::numbers;
use crate::io::text::number::is_measured;
use crate::io::{CompositeFile, Input, ReadError, Reading};
use crate::languages::with_sign;

/// The word in `format`.
pub(crate) const FORMAT_WORD: &str = "composite-spectrum";

/// The versions written and read: of ideal spikes, and of lines that have a width.
pub(crate) const VERSIONS: [u32; 2] = [1, 2];

/// The composite model.
pub(crate) const FORMAT: Format = Format {
    name: later!("composite JSON"),
    extensions: &["json"],
    sniff,
    read,
};

#[derive(Serialize, Deserialize)]
struct File {
    format: String,
    version: u32,
    range_nm: [f64; 2],
    basis: Basis,
    coefficients: Coefficients,
    #[serde(default)]
    spikes: Vec<LineJson>,
    #[serde(default)]
    unit: String,
    #[serde(default)]
    source: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    name: String,
    kind: Option<Kind>,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    scale_in_force: String,
    #[serde(default, skip_serializing_if = "String::is_empty")]
    written_by: String,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Coefficients {
    #[serde(skip_serializing_if = "Option::is_none")]
    a: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    b: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    c: Option<Vec<f64>>,
}

#[derive(Serialize, Deserialize)]
struct LineJson {
    at_nm: f64,
    weight: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    fwhm_nm: Option<f64>,
}

fn sniff(input: &Input) -> Confidence {
    super::own_json(input, FORMAT_WORD)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let file: File = serde_json::from_str(text).map_err(|e| json_error(input, &e))?;
    let file = composite_of(file, input.stem()).map_err(|why| why.of(input))?;
    Ok(Reading {
        notes: vec![in_words(&file.composite)],
        composites: vec![file],
        ..Reading::default()
    })
}

/// One line about a composite: basis, order, range, spikes, and the count of its numbers.
pub(crate) fn in_words(composite: &Composite) -> String {
    let (band, smooth) = (composite.band(), composite.smooth());
    let order = smooth.order();
    let series = match smooth.basis {
        Basis::Fourier => tr!("fourier series of order {order}", order),
        Basis::Cosine => tr!("cosine series of order {order}", order),
    };
    let [min_nm, max_nm] = [band.min_nm(), band.max_nm()].map(|nm| with_sign(nm.to_string()));
    let lines = match composite.lines().len() {
        0 => said!("no spikes").to_owned(),
        n if !composite.has_widths() => tr!("{n} line" | "{n} lines" % n),
        n => tr!("{n} line with its width" | "{n} lines with their widths" % n),
    };
    let numbers = numbers(composite.numbers());
    format!("{series}, {min_nm}-{max_nm} nm, {lines}, {numbers}")
}

/// The reason why a text is not a valid composite.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", tr!("found {found}, expected {expected}", found, expected))]
pub struct CompositeTextError {
    /// The content found.
    pub found: String,
    /// The content expected instead.
    pub expected: String,
}

impl CompositeTextError {
    pub(super) fn new(found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self {
            found: found.into(),
            expected: expected.into(),
        }
    }

    /// The same as a refusal of a file.
    pub(super) fn of(self, input: &Input) -> ReadError {
        input.error(self.found, self.expected)
    }
}

/// The composite of a parsed file; `stem` is the name of one without a name.
fn composite_of(file: File, stem: &str) -> Result<CompositeFile, CompositeTextError> {
    if file.format != FORMAT_WORD {
        let found = format!("format \"{}\"", file.format);
        return Err(CompositeTextError::new(found, format!("\"{FORMAT_WORD}\"")));
    }
    let [first, last] = VERSIONS;
    if !VERSIONS.contains(&file.version) {
        let found = tr!("version {version}", version = file.version);
        let expected = tr!("version {first} or {last}", first, last);
        return Err(CompositeTextError::new(found, expected));
    }
    let [min, max] = file.range_nm;
    let off = |error: BandError| {
        CompositeTextError::new(format!("range_nm [{min}, {max}]"), error.to_string())
    };
    let band = Band::new(min, max).map_err(off)?;
    let smooth = smooth_of(band, file.basis, file.coefficients)?;
    let has_widths = file.version == last;
    let lines = file.spikes.into_iter().map(|line| Line {
        at_nm: line.at_nm,
        weight: line.weight,
        fwhm_nm: line.fwhm_nm.filter(|_| has_widths).unwrap_or(0.0),
    });
    Ok(CompositeFile {
        composite: checked(smooth, lines.collect())?,
        unit: file.unit,
        source: file.source,
        name: match file.name.is_empty() {
            true => stem.to_owned(),
            false => file.name,
        },
        kind: file.kind.unwrap_or(Kind::Light),
    })
}

fn smooth_of(
    band: Band,
    basis: Basis,
    coefficients: Coefficients,
) -> Result<Series, CompositeTextError> {
    let Coefficients { a, b, c } = coefficients;
    let found = [("a", a), ("b", b), ("c", c)];
    let found = found
        .into_iter()
        .filter_map(|(name, list)| Some((name, list?)));
    let found: Vec<(&str, Vec<f64>)> = found.collect();
    let own = basis.lists();
    let has_first = found.iter().any(|(name, _)| *name == own[0]);
    if !has_first || found.iter().any(|(name, _)| !own.contains(name)) {
        let lists: Vec<String> = own
            .iter()
            .map(|name| format!("\"{name}\": [...]"))
            .collect();
        let found = match basis {
            Basis::Fourier => said!("other coefficients with the fourier basis"),
            Basis::Cosine => said!("other coefficients with the cosine basis"),
        };
        return Err(CompositeTextError::new(
            found,
            format!("{{{}}}", lists.join(", ")),
        ));
    }
    let lists: Vec<(&str, &[f64])> = found.iter().map(|(name, l)| (*name, &l[..])).collect();
    // One number less in the last list is a series whose last number was dropped.
    Series::from_lists(band, basis, &lists).ok_or_else(|| {
        let counts = lists
            .iter()
            .map(|(name, list)| tr!("{count} in {name}", count = list.len(), name));
        let found = {
            let counts = counts.reduce(|one, other| tr!("{one} and {other}", one, other));
            tr!("numbers: {counts}", counts = counts.unwrap_or_default())
        };
        let expected = match &own[1..] {
            [] => said!("one at least").to_owned(),
            [other] => tr!("one more in {list} than in {other}", list = own[0], other),
            others => format!("one more in {} than in {}", own[0], others.join(" and in ")),
        };
        CompositeTextError::new(found, expected)
    })
}

/// The widest line that is believed, nm.
const WIDEST_NM: f64 = 1000.0;

/// A composite of numbers that make sense: at least one coefficient and no more than the band
/// carries, everything below 1e30 (so that derived values stay finite), lines on its range.
pub(super) fn checked(smooth: Series, lines: Vec<Line>) -> Result<Composite, CompositeTextError> {
    let (band, coefficients) = (smooth.band, &smooth.coefficients);
    let odd = |found: String, expected: String| Err(CompositeTextError::new(found, expected));
    let mut widths = lines.iter().map(|line| line.fwhm_nm);
    if let Some(width) = widths.find(|width| !(0.0..=WIDEST_NM).contains(width)) {
        let expected = tr!(
            "a width of 0 to {widest} nm",
            widest = with_sign(WIDEST_NM.to_string())
        );
        let width = with_sign(width.to_string());
        return odd(tr!("a line {width} nm wide", width), expected);
    }
    let most = 2 * Basis::highest_order(band) + 1;
    if !(1..=most).contains(&coefficients.len()) {
        let found = tr!("{n} coefficients" | "{n} coefficients" % coefficients.len());
        return odd(found, tr!("1 to {most} on this range", most));
    }
    if let Some(c) = coefficients.iter().find(|c| !is_measured(**c)) {
        return odd(
            tr!(
                "the coefficient {number}",
                number = with_sign(c.to_string())
            ),
            said!("a number below 1e30").to_owned(),
        );
    }
    for Line { at_nm, weight, .. } in &lines {
        if !is_measured(*at_nm) || *at_nm <= 0.0 || !is_measured(*weight) {
            let expected = said!("a wavelength above 0 and a weight below 1e30");
            return odd(
                tr!(
                    "a spike of {weight} at {at} nm",
                    weight = with_sign(weight.to_string()),
                    at = with_sign(at_nm.to_string())
                ),
                expected.to_owned(),
            );
        }
        if !band.contains(*at_nm) {
            let [from, to] = [band.min_nm(), band.max_nm()].map(|nm| with_sign(nm.to_string()));
            let expected = tr!(
                "lines on the composite's range, {from} to {to} nm",
                from,
                to
            );
            let found = tr!("a line at {at} nm", at = with_sign(at_nm.to_string()));
            return odd(found, expected);
        }
    }
    Ok(Composite::of_lines_inside(smooth, lines))
}

/// A composite as JSON.
///
/// # Errors
/// [`WriteError`] when a number is not finite, which JSON cannot hold.
pub fn write(file: &CompositeFile) -> Result<String, WriteError> {
    let (composite, name) = (&file.composite, &file.name);
    let (smooth, lines) = (composite.smooth(), composite.lines());
    let of_lines = lines
        .iter()
        .flat_map(|line| [line.at_nm, line.weight, line.fwhm_nm]);
    let numbers = smooth.coefficients.iter().copied();
    if !numbers.chain(of_lines).all(f64::is_finite) || smooth.coefficients.is_empty() {
        let why = said!("found a coefficient or spike that is not finite, expected numbers");
        return Err(WriteError::new(name, why));
    }
    let mut lists = smooth.lists();
    let mut list = |name: &str| {
        let place = lists.iter().position(|(own, _)| *own == name)?;
        Some(lists.swap_remove(place).1)
    };
    let [a, b, c] = ["a", "b", "c"].map(&mut list);
    let line = |line: &Line| LineJson {
        at_nm: line.at_nm,
        weight: line.weight,
        fwhm_nm: Some(line.fwhm_nm).filter(|width| *width > 0.0),
    };
    let file = File {
        format: FORMAT_WORD.to_owned(),
        version: VERSIONS[usize::from(composite.has_widths())],
        range_nm: [smooth.band.min_nm(), smooth.band.max_nm()],
        basis: smooth.basis,
        coefficients: Coefficients { a, b, c },
        spikes: lines.iter().map(line).collect(),
        unit: file.unit.clone(),
        source: file.source.clone(),
        name: name.clone(),
        kind: Some(file.kind),
        scale_in_force: "as measured".to_owned(),
        written_by: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
    };
    let text = serde_json::to_string_pretty(&file);
    text.map(|text| text + "\n")
        .map_err(|error| WriteError::new(name, error.to_string()))
}
