//! TUV (Tropospheric Ultraviolet and Visible model) reports with a table of spectral irradiance.
//!
//! ```text
//!  solar zenith angle =     23.18721
//!  SPECTRAL IRRADIANCE (W m-2 nm-1):
//!  LOWER WVL  UPPER WVL  DIRECT     DIFFUSE DOWN  DIFFUSE UP  TOTAL DOWNWELLING
//!  280.00     281.00     9.839E-17  8.887E-17     1.873E-17   1.873E-16
//! ```
//!
//! Each row is a band; its spectrum stands at the band's middle. The total comes first.

use super::error::quoted;
use super::interpret::interpret;
use super::interpret::raw::RawSpectrum;
use super::number::{self, Cell};
use super::text::{kept_line, lines};
use super::{Confidence, Format, Input, ReadError, Reading};

/// TUV reports.
pub const FORMAT: Format = Format {
    name: "TUV report",
    extensions: &["txt"],
    sniff,
    read,
};

fn is_title(line: &str) -> bool {
    let upper = line.to_uppercase();
    upper.contains("LOWER WVL") && upper.contains("UPPER WVL")
}

fn sniff(input: &Input) -> Confidence {
    if input.head().lines().any(is_title) {
        Confidence::Certain
    } else {
        Confidence::No
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut titles, mut unit) = (Vec::new(), "W m-2 nm-1");
    let (mut nm, mut at) = (Vec::new(), Vec::new());
    let mut columns: Vec<Vec<f64>> = Vec::new();
    let mut sun = None;
    let mut in_table = false;
    for (line, content) in lines(text) {
        let content = content.trim();
        if !in_table {
            if is_title(content) {
                in_table = true;
                titles = content
                    .split("  ")
                    .map(str::trim)
                    .filter(|t| !t.is_empty())
                    .skip(2)
                    .take(20)
                    .collect();
            } else if content.to_uppercase().starts_with("SPECTRAL ")
                && let Some((_, inside)) = content.split_once('(')
            {
                unit = inside.split(')').next().unwrap_or(unit).trim();
            } else if content.starts_with("solar zenith angle") {
                sun = content.split_once('=').map(|(_, v)| v.trim());
            }
            continue;
        }
        let mut words = content.split_whitespace();
        let Some(first) = words.next() else {
            if nm.is_empty() { continue } else { break }
        };
        // A rule or words end the table.
        if !matches!(number::parse(first, false), Cell::Number(_)) {
            if nm.is_empty() { continue } else { break }
        }
        let mut row = Vec::new();
        for word in std::iter::once(first).chain(words).take(22) {
            let value = number::parse(word, false).plain_value();
            row.push(value.ok_or_else(|| input.error(quoted(word), "a number").at_line(line))?);
        }
        if columns.is_empty() {
            columns = vec![Vec::new(); row.len().saturating_sub(2)];
        }
        if row.len() != columns.len() + 2 || row.len() < 3 {
            return Err(input
                .error(
                    format!("{} numbers", row.len()),
                    "the band's ends and a value for each title",
                )
                .at_line(line));
        }
        nm.push(0.5 * (row[0] + row[1]));
        for (column, value) in columns.iter_mut().zip(&row[2..]) {
            column.push(*value);
        }
        at.push(kept_line(line));
    }
    if nm.is_empty() {
        return Err(input.error(
            "a TUV report with no rows in its table",
            "bands and their irradiance",
        ));
    }
    let mut order: Vec<usize> = (0..columns.len()).collect();
    order.sort_by_key(|c| {
        !titles
            .get(*c)
            .is_some_and(|t| t.to_uppercase().contains("TOTAL"))
    });
    let mut reading = Reading::default();
    for column in order {
        let title = titles.get(column).map_or_else(
            || format!("column {}", column + 3),
            |title| title.to_lowercase(),
        );
        let name = format!("{}, {title}", input.stem());
        let mut spectrum =
            RawSpectrum::light(name, &nm, std::mem::take(&mut columns[column]), unit);
        spectrum.lines = &at;
        spectrum.how.push("middles of bands".to_owned());
        spectrum
            .notes
            .extend(sun.map(|angle| format!("solar zenith angle {angle} degrees")));
        interpret(spectrum, input, &mut reading)?;
    }
    Ok(reading)
}

#[cfg(test)]
mod tests {
    use crate::io::read_bytes;

    #[test]
    fn the_total_comes_first_at_the_middles_of_bands() {
        let text = "\n solar zenith angle =  23.2\n SPECTRAL IRRADIANCE (W m-2 nm-1):\n\n LOWER WVL  UPPER WVL  DIRECT     DIFFUSE DOWN  TOTAL DOWNWELLING\n 280.00     281.00     1E-17  2E-17     3E-17\n 281.00     282.00     1  2     3\n\n rest 1 2\n";
        let reading = read_bytes("q.txt", text.as_bytes()).unwrap();
        assert_eq!(reading.format, "TUV report");
        let names: Vec<_> = reading.spectra.iter().map(|s| s.name.as_str()).collect();
        assert_eq!(
            names,
            ["q, total downwelling", "q, direct", "q, diffuse down"]
        );
        assert_eq!(reading.spectra[0].samples.nm(), [280.5, 281.5]);
        assert_eq!(reading.spectra[0].samples.values(), [3e-17, 3.0]);
        assert_eq!(reading.spectra[0].unit, "W m-2 nm-1");
    }
}
