//! Output of Argyll's `spotread`: results in words, and with `-S` or `-s` the spectrum.
//!
//! ```text
//! Spectrum from 380.000000 to 730.000000 nm in 36 steps
//! 0.012, 0.013, ...
//!  Result is XYZ: 42740.391921 44632.401250 41429.614830, D50 Lab: ...
//!  Ambient = 44632.4 Lux, CCT = 5528K (Duv 0.0031)
//! ```
//!
//! Without the spectrum it is refused by name.

use super::{Confidence, Format};
use crate::io::interpret::{RawSpectrum, interpret};
use crate::io::reading::makers_results::room_for;
use crate::io::text::number::{self, Cell};
use crate::io::text::{kept_line, lines};
use crate::io::{Decision, Input, MakersResult, ReadError, Reading, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format::new(later!("Argyll spotread output"), &[], sniff, read);

/// Most bands that one measurement may state.
const MOST_BANDS: usize = 100_000;

/// Most spectra in one log.
const MOST_SPECTRA: usize = 1000;

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let spectrum = head.contains("Spectrum from ") && head.contains(" nm in ");
    Confidence::certain_if(spectrum || head.contains("Result is XYZ:"))
}

/// First and last wavelength and number of bands of a "Spectrum from" line.
fn grid(line: &str) -> Option<(f64, f64, usize)> {
    let rest = line.trim().strip_prefix("Spectrum from ")?;
    let mut words = rest.split_whitespace();
    let first: f64 = words.next()?.parse().ok()?;
    let last: f64 = words.nth(1)?.parse().ok()?;
    let bands: usize = words.nth(2)?.parse().ok()?;
    (first > 0.0 && last > first && last < 1e6 && (2..=MOST_BANDS).contains(&bands))
        .then_some((first, last, bands))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let mut reading = Reading::default();
    let mut open = None;
    let mut values: Vec<f64> = Vec::new();
    for (line, content) in lines(text) {
        if let Some(grid) = grid(content) {
            open = Some((grid, line));
            values.clear();
        } else if let Some(((first, last, bands), at)) = open {
            let cells = content.split([',', ' ', '\t']);
            let cells = cells.filter(|c| !c.trim().is_empty());
            for cell in cells.take(bands - values.len()) {
                let Cell::Number(value) = number::parse(cell, false) else {
                    let expected = tr!(
                        "{n} values, {count} were there" | "{n} values, {count} were there" % bands,
                        count = values.len()
                    );
                    return Err(input.error_at(line, quoted(cell), expected));
                };
                values.push(value);
            }
            if values.len() < bands {
                continue;
            }
            let step = |band: usize| (last - first) * band as f64 / (bands - 1) as f64;
            let nm: Vec<f64> = (0..bands).map(|band| first + step(band)).collect();
            let because = said!("spotread does not print the kind");
            let kind = Decision::guessed(Kind::Light, false, because);
            let values = std::mem::take(&mut values);
            let spectrum = RawSpectrum {
                lines: &[kept_line(at)],
                ..RawSpectrum::known(input.stem(), &nm, values, kind, "")
            };
            interpret(spectrum, input, &mut reading)?;
            open = None;
            if reading.spectra.len() >= MOST_SPECTRA {
                break;
            }
        } else if let Some(spectrum) = reading.spectra.len().checked_sub(1) {
            let room = room_for(reading.results.len());
            let found = results(spectrum, content).into_iter();
            reading.results.extend(found.take(room));
        }
    }
    if reading.spectra.is_empty() {
        return Err(input.error(
            said!("what Argyll's spotread printed (XYZ, Lab, CCT, Ra) and no spectrum in it"),
            said!("the spectrum that spotread saves (its key S, or chartread's .ti3)"),
        ));
    }
    Ok(reading)
}

/// The results in a line: `CCT = 5528K (Duv 0.0031)`, `Color Rendering Index (Ra) = 99.0`.
fn results(spectrum: usize, line: &str) -> Vec<MakersResult> {
    let words: Vec<&str> = line
        .split(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | '[' | ']' | ',' | '='))
        .filter(|w| !w.is_empty())
        .take(64)
        .collect();
    let of_pair = |pair: &[&str]| {
        let key = match pair[0] {
            "Ambient" => "Illuminance [lx]",
            key @ ("CCT" | "Duv" | "Ra" | "Rf" | "Rg" | "R9") => key,
            _ => return None,
        };
        MakersResult::of(Some(spectrum), key, pair[1], false)
    };
    words.windows(2).filter_map(of_pair).collect()
}
