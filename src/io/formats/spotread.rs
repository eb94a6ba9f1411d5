//! What Argyll's `spotread` prints: results in words, and with `-S` or `-s` the spectrum.
//!
//! ```text
//! Spectrum from 380.000000 to 730.000000 nm in 36 steps
//! 0.012, 0.013, ...
//!  Result is XYZ: 42740.391921 44632.401250 41429.614830, D50 Lab: ...
//!  Ambient = 44632.4 Lux, CCT = 5528K (Duv 0.0031)
//! ```
//!
//! Without the spectrum it is refused, by what it is.

use crate::spectrum::Kind;

use super::{Confidence, Format};
use crate::io::error::quoted;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::RawSpectrum;
use crate::io::reading::decision::Decision;
use crate::io::reading::makers_results::{MakersResult, room_for};
use crate::io::text::lines;
use crate::io::text::number::{self, Cell};
use crate::io::{Input, ReadError, Reading};

/// Argyll spotread's printed words.
pub(crate) const FORMAT: Format = Format {
    name: "Argyll spotread output",
    extensions: &[],
    sniff,
    read,
};

/// Most bands that one measurement may state.
const MOST_BANDS: usize = 100_000;

/// Most spectra in one log.
const MOST_SPECTRA: usize = 1000;

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    if head.contains("Result is XYZ:")
        || head.contains("Spectrum from ") && head.contains(" nm in ")
    {
        Confidence::Certain
    } else {
        Confidence::No
    }
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
    let mut open: Option<(f64, f64, usize, usize)> = None;
    let mut values: Vec<f64> = Vec::new();
    for (line, content) in lines(text) {
        if let Some((first, last, bands)) = grid(content) {
            open = Some((first, last, bands, line));
            values.clear();
            continue;
        }
        if let Some((first, last, bands, at)) = open {
            for cell in content
                .split([',', ' ', '\t'])
                .filter(|c| !c.trim().is_empty())
            {
                let Cell::Number(value) = number::parse(cell, false) else {
                    return Err(input
                        .error(
                            quoted(cell),
                            format!("{bands} values, {} were there", values.len()),
                        )
                        .at_line(line));
                };
                values.push(value);
                if values.len() == bands {
                    break;
                }
            }
            if values.len() == bands {
                let nm: Vec<f64> = (0..bands)
                    .map(|i| first + (last - first) * i as f64 / (bands - 1) as f64)
                    .collect();
                let name = input.stem().to_owned();
                let mut spectrum = RawSpectrum::light(name, &nm, std::mem::take(&mut values), "");
                let because = "spotread does not print the kind";
                spectrum.known.kind = Some(Decision::guessed(Kind::Light, false, because));
                let lines = [u32::try_from(at).unwrap_or(u32::MAX)];
                spectrum.lines = &lines;
                interpret(spectrum, input, &mut reading)?;
                open = None;
                if reading.spectra.len() >= MOST_SPECTRA {
                    break;
                }
            }
            continue;
        }
        if !reading.spectra.is_empty() {
            let spectrum = Some(reading.spectra.len() - 1);
            let room = room_for(reading.results.len());
            reading
                .results
                .extend(results(spectrum, content).take(room));
        }
    }
    if reading.spectra.is_empty() {
        return Err(input.error(
            "what Argyll's spotread printed (XYZ, Lab, CCT, Ra) and no spectrum in it",
            "the spectrum that spotread saves (its key S, or chartread's .ti3)",
        ));
    }
    Ok(reading)
}

/// The results in a line: `CCT = 5528K (Duv 0.0031)`, `Color Rendering Index (Ra) = 99.0`.
fn results(spectrum: Option<usize>, line: &str) -> impl Iterator<Item = MakersResult> {
    let mut found = Vec::new();
    let words: Vec<&str> = line
        .split(|c: char| c.is_whitespace() || matches!(c, '(' | ')' | '[' | ']' | ',' | '='))
        .filter(|w| !w.is_empty())
        .take(64)
        .collect();
    for pair in words.windows(2) {
        let key = match pair[0] {
            "Ambient" => "Illuminance [lx]",
            key @ ("CCT" | "Duv" | "Ra" | "Rf" | "Rg" | "R9") => key,
            _ => continue,
        };
        found.extend(MakersResult::of(spectrum, key, pair[1], false));
    }
    found.into_iter()
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;
    use crate::io::reading::makers_results::Quantity;

    const RESULTS: &str = " Result is XYZ: 1.0 2.0 3.0, D50 Lab: 1 2 3\n Ambient = 44632.4 Lux, CCT = 5528K (Duv 0.0031)\n Color Rendering Index (Ra) = 99.0 [ R9 = 95.4 ]\n";

    #[test]
    fn results_alone_are_refused_by_what_they_are() {
        let why = read_bytes("a.txt", RESULTS.as_bytes())
            .unwrap_err()
            .to_string();
        assert!(
            why.starts_with("a.txt: found what Argyll's spotread printed"),
            "{why}"
        );
    }

    #[test]
    fn a_printed_spectrum_is_read_with_its_results() {
        let text = format!(
            "Spectrum from 380.000000 to 400.000000 nm in 3 steps\n 0.5, 1.5,\n 2.5\n{RESULTS}"
        );
        let reading = read_bytes("a.txt", text.as_bytes()).unwrap();
        assert_eq!(reading.spectra[0].samples.nm(), [380.0, 390.0, 400.0]);
        assert_eq!(reading.spectra[0].samples.values(), [0.5, 1.5, 2.5]);
        let found: Vec<_> = reading
            .results
            .iter()
            .map(|r| (r.quantity.clone(), r.value))
            .collect();
        assert_eq!(
            found,
            [
                (Quantity::Illuminance, 44632.4),
                (Quantity::Cct, 5528.0),
                (Quantity::Duv, 0.0031),
                (Quantity::Ra, 99.0),
                (Quantity::R(9), 95.4)
            ]
        );
    }
}
