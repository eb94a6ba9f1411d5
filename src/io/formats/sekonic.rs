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

pub(crate) const FORMAT: Format = Format {
    name: "Sekonic CSV",
    extensions: &["csv"],
    sniff,
    read,
};

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

#[cfg(test)]
mod tests {
    use crate::io::Quantity;
    use crate::io::tests::{assert_told, first, read, refusal};

    fn text() -> String {
        let mut text =
            "Date Saved,1/1/2020\nTitle,Desk 2°\n\nMeasuring Mode,Ambient\nTcp [K],3262\n\
                        Illuminance [lx],30.1\nCRI Ra,87.5\nTM-30 Rf,87\nSSI1,---\n\n"
                .to_owned();
        for step in [5, 1] {
            for nm in (380..=400).step_by(step) {
                text += &format!("Spectral Data {nm}[nm],{}.25\n", nm - 380);
            }
            text.push('\n');
        }
        text + "bin1,0.1,0.2,0.3,0.4\n"
    }

    #[test]
    fn the_finer_of_two_blocks_is_taken_and_said() {
        let reading = read("a.csv", text());
        assert_eq!(reading.format, "Sekonic CSV");
        let spectrum = &reading.spectra[0];
        assert_eq!((spectrum.samples.len(), &*spectrum.name), (21, "Desk 2°"));
        assert_eq!(spectrum.samples.values()[20], 20.25);
        assert_eq!(spectrum.unit, "W m-2 nm-1");
        assert_told(&spectrum.notes, "5 points every 5 nm");
        let ra = reading.results.iter().find(|r| r.quantity == Quantity::Ra);
        assert_eq!(ra.map(|r| r.value), Some(87.5));
    }

    #[test]
    fn the_order_of_the_blocks_and_the_marks_do_not_matter() {
        let text = text();
        let want = first("a", &text).samples;
        let head = text.find("\n\nSpectral").unwrap();
        let (head, blocks) = (&text[..head], &text[head + 2..]);
        let (five, one) = blocks.split_once("\n\n").unwrap();
        for text in [
            format!("{head}\n{one}\n{five}\n"),
            text.replace('\n', "\r\n"),
            format!("\u{feff}{text}"),
            text.replace(',', ";").replace('.', ","),
            text.replace(".25", ",25"),
            format!("{head}\n{one}"),
        ] {
            assert_eq!(first("a", &text).samples, want, "{text}");
        }
    }

    #[test]
    fn a_summary_is_refused_as_one() {
        let text = "\u{feff}Date Saved,1/1/2020\r\nTitle,X\r\n\r\nMeasuring Mode,Ambient\r\n\
                    CCT [K],5392\r\nCRI Ra,99.3\r\n";
        let why = refusal("a.csv", text);
        let found = "a.csv: found a Sekonic summary (CCT, CRI, filters) without a spectrum";
        assert!(why.starts_with(found), "{why}");
    }
}
