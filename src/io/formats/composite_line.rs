//! The composite model as one line of text, to paste into a message; bit-exact there and back.
//!
//! ```text
//! cs1;fourier;380:780;a0 a1 b1 a2 b2 ...;404.87*2.39 435.84*5.94
//! cs1;cosine;380:780;c0 c1 c2 ...;
//! cs2;cosine;380:780;c0 c1 c2 ...;404.87*2.39*3.1 435.84*5.94
//! ```
//!
//! Five fields: mark and version, basis, range in nm, coefficients in prefix order, spikes as
//! `nm*weight`. In a line of mark `cs2` a spike may have a third number, the full width at half
//! maximum of a Gaussian line in nm; it is written where a line has a width. Numbers are the shortest decimals that read back to the same bits. Unit, source, name
//! and kind are not in the line: it is taken as a light unless chosen otherwise.

use crate::spectrum::{Band, Basis, Composite, Kind, Line, Series};

use super::composite_json::{CompositeTextError, checked, in_words};
use super::{Confidence, Format};
use crate::io::error::quoted;
use crate::io::provenance::shortest;
use crate::io::text::number::number;
use crate::io::{CompositeFile, Guessed, Input, OpenQuestion, ReadError, Reading};
use crate::languages::said;

/// First field of the line: the format and its version, of ideal spikes and of lines that have a
/// width.
pub(crate) const MARKS: [&str; 2] = ["cs1", "cs2"];

/// The one-line composite.
pub(crate) const FORMAT: Format = Format {
    name: later!("composite line"),
    extensions: &["txt"],
    sniff,
    read,
};

fn sniff(input: &Input) -> Confidence {
    let starts = |mark: &&str| input.head().starts_with(&format!("{mark};"));
    Confidence::certain_if(MARKS.iter().any(starts))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &input.needs_text()?.text;
    let composite = parse(text).map_err(|why| why.of(input).at_line(1))?;
    Ok(Reading {
        notes: vec![in_words(&composite)],
        composites: vec![CompositeFile {
            composite,
            unit: String::new(),
            source: String::new(),
            name: input.stem().to_owned(),
            kind: Kind::Light,
        }],
        guesses: vec![OpenQuestion {
            spectrum: 0,
            what: Guessed::Kind,
            chosen: said(Kind::Light.word()).to_owned(),
            because: said!("the line does not say").to_owned(),
            plain: false,
        }],
        ..Reading::default()
    })
}

/// A composite as one line without a line end.
pub fn write(composite: &Composite) -> String {
    let mark = MARKS[usize::from(composite.has_widths())];
    let smooth = composite.smooth();
    let coefficients: Vec<String> = smooth.coefficients.iter().map(|c| shortest(*c)).collect();
    let spikes: Vec<String> = composite
        .lines()
        .iter()
        .map(|line| {
            let spike = format!("{}*{}", shortest(line.at_nm), shortest(line.weight));
            if line.fwhm_nm > 0.0 {
                format!("{spike}*{}", shortest(line.fwhm_nm))
            } else {
                spike
            }
        })
        .collect();
    format!(
        "{mark};{};{}:{};{};{}",
        smooth.basis.word(),
        shortest(smooth.band.min_nm()),
        shortest(smooth.band.max_nm()),
        coefficients.join(" "),
        spikes.join(" ")
    )
}

/// The composite of a line; blanks and line breaks that a message put in are no matter.
///
/// # Errors
/// [`CompositeTextError`] with the part that is wrong.
pub fn parse(text: &str) -> Result<Composite, CompositeTextError> {
    let fields: Vec<&str> = text.trim().split(';').map(str::trim).collect();
    let has_widths = fields[0] == MARKS[1];
    if !MARKS.contains(&fields[0]) {
        let expected = said!("a line that begins with \"cs1;\"");
        return Err(CompositeTextError::new(quoted(fields[0]), expected));
    }
    let (basis, range, coefficients, spikes) = match fields[..] {
        [_, basis, range, coefficients, spikes] => (basis, range, coefficients, spikes),
        [_, basis, range, coefficients] => (basis, range, coefficients, ""),
        _ => {
            let expected = said!("5: cs1;basis;range;coefficients;spikes");
            let found = tr!("{n} fields" | "{n} fields" % fields.len());
            return Err(CompositeTextError::new(found, expected));
        }
    };
    let basis = Basis::from_word(basis).ok_or_else(|| {
        let words = Basis::ALL.map(|basis| basis.word().to_owned()).into_iter();
        let words = words.reduce(|one, other| tr!("{one} or {other}", one, other));
        odd("basis", basis, words.unwrap_or_default())
    })?;
    let band = parse_range(range)?;
    let coefficients = coefficients
        .split_whitespace()
        .map(|word| finite(word, said!("a number as coefficient")))
        .collect::<Result<_, _>>()?;
    let spikes = spikes
        .split_whitespace()
        .map(|word| parse_spike(word, has_widths))
        .collect::<Result<_, _>>()?;
    checked(Series::new(band, basis, coefficients), spikes)
}

fn finite(word: &str, expected: &str) -> Result<f64, CompositeTextError> {
    number(word, false)
        .filter(|v| v.is_finite())
        .ok_or_else(|| CompositeTextError::new(quoted(word), expected))
}

/// The refusal of a part of the line.
fn odd(what: &str, part: &str, expected: impl Into<String>) -> CompositeTextError {
    let part = quoted(part);
    let found = match what {
        "basis" => tr!("basis {word}", word = part),
        "range" => tr!("range {word}", word = part),
        _ => tr!("spike {word}", word = part),
    };
    CompositeTextError::new(found, expected)
}

fn parse_range(range: &str) -> Result<Band, CompositeTextError> {
    let (min, max) = range
        .split_once(':')
        .ok_or_else(|| odd("range", range, said!("MIN:MAX in nm")))?;
    let end = |word: &str| finite(word.trim(), said!("a range in whole nm"));
    Band::new(end(min)?, end(max)?).map_err(|error| odd("range", range, error.to_string()))
}

/// A spike with its width, 0 where it has none.
fn parse_spike(word: &str, has_widths: bool) -> Result<Line, CompositeTextError> {
    let (at_nm, rest) = word
        .split_once('*')
        .ok_or_else(|| odd("spike", word, said!("nm*weight")))?;
    let (weight, width) = match rest.split_once('*').filter(|_| has_widths) {
        Some((weight, width)) => (weight, finite(width, said!("a line's width in nm"))?),
        None => (rest, 0.0),
    };
    Ok(Line {
        at_nm: finite(at_nm, said!("a spike's wavelength in nm"))?,
        weight: finite(weight, said!("a spike's weight"))?,
        fwhm_nm: width,
    })
}
