//! TUV (Tropospheric Ultraviolet and Visible model) reports with a table of spectral irradiance.
//!
//! ```text
//!  solar zenith angle =     23.18721
//!  SPECTRAL IRRADIANCE (W m-2 nm-1):
//!  LOWER WVL  UPPER WVL  DIRECT     DIFFUSE DOWN  DIFFUSE UP  TOTAL DOWNWELLING
//!  280.00     281.00     9.839E-17  8.887E-17     1.873E-17   1.873E-16
//! ```
//!
//! Each row is a band; its spectrum is placed at the band's middle. The total comes first.

use super::rows::{Rows, numbers};
use super::{Confidence, Format};
use crate::io::interpret::{RawSpectrum, interpret};
use crate::io::text::lines;
use crate::io::text::number::{self, Cell};
use crate::io::{Input, ReadError, Reading, quoted};

pub(crate) const FORMAT: Format = Format::new(later!("TUV report"), &["txt"], sniff, read);

fn is_title(line: &str) -> bool {
    let upper = line.to_uppercase();
    upper.contains("LOWER WVL") && upper.contains("UPPER WVL")
}

fn sniff(input: &Input) -> Confidence {
    Confidence::certain_if(input.head().lines().any(is_title))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut titles, mut unit, mut sun) = (Vec::new(), "W m-2 nm-1", None);
    let mut content = lines(text).map(|(line, content)| (line, content.trim()));
    for (_, line) in content.by_ref() {
        if is_title(line) {
            let all = line.split("  ").map(str::trim);
            let all = all.filter(|title| !title.is_empty());
            titles = all.skip(2).take(20).collect();
            break;
        }
        if line.to_uppercase().starts_with("SPECTRAL ")
            && let Some((_, inside)) = line.split_once('(')
        {
            unit = inside.split(')').next().unwrap_or(unit).trim();
        } else if line.starts_with("solar zenith angle") {
            sun = line.split_once('=').map(|(_, angle)| angle.trim());
        }
    }
    let mut rows = Rows::default();
    for (line, row) in content {
        // A blank line, a rule or words end the table.
        let first = row.split_whitespace().next().unwrap_or("");
        if !matches!(number::parse(first, false), Cell::Number(_)) {
            match rows.lines.is_empty() {
                true => continue,
                false => break,
            }
        }
        let number = |word: &str| number::parse(word, false).plain_value();
        let row = numbers(row.split_whitespace(), 22, number)
            .map_err(|(_, word)| input.error_at(line, quoted(word), said!("a number")))?;
        if !rows.add(line, &row) || row.len() < 3 {
            let expected = said!("the band's ends and a value for each title");
            let found = tr!("{n} numbers" | "{n} numbers" % row.len());
            return Err(input.error_at(line, found, expected));
        }
    }
    if rows.lines.is_empty() {
        let found = said!("a TUV report with no rows in its table");
        return Err(input.error(found, said!("bands and their irradiance")));
    }
    let bands = rows.columns[0].iter().zip(&rows.columns[1]);
    let nm: Vec<f64> = bands.map(|(from, to)| 0.5 * (from + to)).collect();
    let mut columns: Vec<(String, usize)> = (2..rows.columns.len())
        .map(|column| match titles.get(column - 2) {
            Some(title) => (title.to_lowercase(), column),
            None => (format!("column {}", column + 1), column),
        })
        .collect();
    columns.sort_by_key(|(title, _)| !title.to_uppercase().contains("TOTAL"));
    let mut reading = Reading::default();
    for (title, column) in columns {
        let name = format!("{}, {title}", input.stem());
        let values = rows.take(column);
        let angle = sun.map(|angle| tr!("solar zenith angle {angle} degrees", angle));
        let spectrum = RawSpectrum {
            lines: &rows.lines,
            how: vec![said!("middles of bands").to_owned()],
            notes: angle.into_iter().collect(),
            ..RawSpectrum::light(name, &nm, values, unit)
        };
        interpret(spectrum, input, &mut reading)?;
    }
    Ok(reading)
}
