//! Sekonic spectrometers (C-700, C-800, C-7000): CSV of one key and one value a line.
//!
//! ```text
//! Date Saved,15/03/2021 3:44:14 p.m.
//! Title,RANDOM_001
//! Tcp [K],3262                         the meter's own results
//! Spectral Data 380[nm],0.000000000000 W m-2 nm-1, 5 nm steps
//! ...
//! Spectral Data 380[nm],0.000000000000 the same keys again, 1 nm steps: the finer is taken
//! ```
//!
//! Films and digital sensors get summaries without a spectrum, refused as such. In the flash modes
//! the values are W s m-2 nm-1.

use std::ops::Range;

use super::keyed_lines::{KeyedLines, is_point, reading_of};
use super::{Confidence, Format};
use crate::io::interpret::RawSpectrum;
use crate::io::text::lines;
use crate::io::{Input, ReadError, Reading};

pub(crate) const FORMAT: Format = Format::new("Sekonic CSV", &["csv"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let starts = |line: &str, word: &str| {
        let line = line.trim_start_matches('"').trim_start();
        line.starts_with(word)
    };
    let begins = |word: &str| lines(head).any(|(_, line)| starts(line, word));
    let spectrum = lines(head).any(|(_, line)| starts(line, "Spectral Data") && is_point(line));
    let results = ["Date Saved", "Tcp", "CCT", "⊿uv", "Illuminance", "CRI Ra"];
    let given = results.iter().filter(|word| begins(word));
    Confidence::certain_if(spectrum || begins("Measuring Mode") && given.count() >= 2)
}

/// Runs of rising wavelengths: one block each.
fn blocks(nm: &[f64]) -> Vec<Range<usize>> {
    let mut end = 0;
    let runs = nm.chunk_by(|before, next| before < next).map(|run| {
        end += run.len();
        end - run.len()..end
    });
    runs.collect()
}

fn step(nm: &[f64]) -> f64 {
    match nm {
        [first, .., last] => (last - first) / (nm.len() - 1) as f64,
        _ => f64::INFINITY,
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let none = [
        "a Sekonic summary (CCT, CRI, filters) without a spectrum",
        "lines such as \"Spectral Data 380[nm],0.000012\": export with spectral data",
    ];
    let found = KeyedLines::of_meter(input, text, none)?;
    let all = blocks(&found.nm);
    // The finest step; of equally fine ones the first.
    let finest = all
        .iter()
        .filter(|b| b.len() >= 2)
        .min_by(|a, b| step(&found.nm[(*a).clone()]).total_cmp(&step(&found.nm[(*b).clone()])))
        .ok_or_else(|| {
            input.error(
                "wavelengths that fall or stand still",
                "blocks of rising wavelengths",
            )
        })?;
    let nm = &found.nm[finest.clone()];
    let flash = found
        .get("Measuring Mode")
        .is_some_and(|mode| mode.to_lowercase().contains("flash"));
    let unit = if flash { "W s m-2 nm-1" } else { "W m-2 nm-1" };
    reading_of(input, &found, finest.clone(), |column, values, _| {
        let name = found.get_of("Title", column).unwrap_or(input.stem());
        let mut spectrum = RawSpectrum::light(name, nm, values, unit);
        for block in all.iter().filter(|b| *b != finest).take(5) {
            spectrum.notes.push(format!(
                "a block of {} points every {:.4} nm, lines {} to {}, stands beside it and was left out",
                block.len(),
                step(&found.nm[block.clone()]),
                found.lines[block.start],
                found.lines[block.end - 1],
            ).replace(".0000 nm", " nm"));
        }
        if all.len() > 1 {
            spectrum.how.push("the finest block".to_owned());
        }
        spectrum
            .notes
            .push(format!("{unit} is the meter's unit; the file states none"));
        spectrum
    })
}
