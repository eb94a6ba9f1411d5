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
use crate::languages::with_sign;

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

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let none = [
        said!("a Sekonic summary (CCT, CRI, filters) without a spectrum"),
        said!("lines such as \"Spectral Data 380[nm],0.000012\": export with spectral data"),
    ];
    let found = KeyedLines::of_meter(input, text, none)?;
    let nm = found.nm();
    let all = blocks(nm);
    let step = |block: &Range<usize>| match block.len() {
        0 | 1 => f64::INFINITY,
        points => (nm[block.end - 1] - nm[block.start]) / (points - 1) as f64,
    };
    // The finest step; of equally fine ones the first.
    let long = all.iter().filter(|block| block.len() >= 2);
    let finest = long.min_by(|a, b| step(a).total_cmp(&step(b)));
    let finest = finest.ok_or_else(|| {
        let found = said!("wavelengths that fall or stand still");
        input.error(found, said!("blocks of rising wavelengths"))
    })?;
    let flash = found
        .get("Measuring Mode")
        .is_some_and(|mode| mode.to_lowercase().contains("flash"));
    let unit = if flash { "W s m-2 nm-1" } else { "W m-2 nm-1" };
    reading_of(input, &found, finest.clone(), |column, values, _| {
        let name = found.get_of("Title", column).unwrap_or(input.stem());
        let mut spectrum = RawSpectrum::light(name, &nm[finest.clone()], values, unit);
        for block in all.iter().filter(|b| *b != finest).take(5) {
            let lines = &found.lines()[block.clone()];
            let (points, first, last) = (block.len(), lines[0], lines[block.len() - 1]);
            let step = format!("{:.4}", step(block));
            let step = step.strip_suffix(".0000").unwrap_or(&step);
            spectrum.notes.push(tr!(
                "a block of {n} points every {step} nm, lines {first} to {last}, stands beside it \
                 and was left out"
                    | "a block of {n} points every {step} nm, lines {first} to {last}, stands \
                       beside it and was left out"
                        % points,
                step = with_sign(step.to_owned()),
                first,
                last
            ));
        }
        if all.len() > 1 {
            spectrum.how.push(said!("the finest block").to_owned());
        }
        let note = tr!("{unit} is the meter's unit; the file states none", unit);
        spectrum.notes.push(note);
        spectrum
    })
}
