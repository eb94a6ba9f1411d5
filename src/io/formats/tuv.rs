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

use super::{Confidence, Format};
use crate::io::interpret::{RawSpectrum, interpret};
use crate::io::text::number::{self, Cell};
use crate::io::text::{kept_line, lines};
use crate::io::{Input, ReadError, Reading, quoted};

pub(crate) const FORMAT: Format = Format {
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
    Confidence::certain_if(input.head().lines().any(is_title))
}

/// What a report holds.
#[derive(Default)]
struct Report<'a> {
    /// Above the columns of values.
    titles: Vec<&'a str>,
    /// Of all values.
    unit: &'a str,
    /// The sun's distance from the zenith, degrees.
    sun: Option<&'a str>,
    /// The middles of the bands, nm.
    nm: Vec<f64>,
    /// Values, a column for each title.
    columns: Vec<Vec<f64>>,
    /// The line of each row, from 1.
    lines: Vec<u32>,
}

impl<'a> Report<'a> {
    /// Takes what a line in front of the table says; whether it is the table's titles.
    fn take_header(&mut self, content: &'a str) -> bool {
        if is_title(content) {
            let titles = content.split("  ").map(str::trim);
            let titles = titles.filter(|title| !title.is_empty());
            self.titles = titles.skip(2).take(20).collect();
            return true;
        }
        if content.to_uppercase().starts_with("SPECTRAL ")
            && let Some((_, inside)) = content.split_once('(')
        {
            self.unit = inside.split(')').next().unwrap_or(self.unit).trim();
        } else if content.starts_with("solar zenith angle") {
            self.sun = content.split_once('=').map(|(_, v)| v.trim());
        }
        false
    }

    /// Takes a row: a band's ends and its values.
    fn take_row(&mut self, input: &Input, content: &str, line: usize) -> Result<(), ReadError> {
        let mut row = Vec::new();
        for word in content.split_whitespace().take(22) {
            let value = number::parse(word, false).plain_value();
            row.push(value.ok_or_else(|| input.error_at(line, quoted(word), "a number"))?);
        }
        if self.columns.is_empty() {
            self.columns = vec![Vec::new(); row.len().saturating_sub(2)];
        }
        if row.len() != self.columns.len() + 2 || row.len() < 3 {
            let expected = "the band's ends and a value for each title";
            return Err(input.error_at(line, format!("{} numbers", row.len()), expected));
        }
        self.nm.push(0.5 * (row[0] + row[1]));
        for (column, value) in self.columns.iter_mut().zip(&row[2..]) {
            column.push(*value);
        }
        self.lines.push(kept_line(line));
        Ok(())
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let mut report = Report {
        unit: "W m-2 nm-1",
        ..Report::default()
    };
    let mut in_table = false;
    for (line, content) in lines(text) {
        let content = content.trim();
        if !in_table {
            in_table = report.take_header(content);
            continue;
        }
        // A blank line, a rule or words end the table.
        let first = content.split_whitespace().next().unwrap_or("");
        if matches!(number::parse(first, false), Cell::Number(_)) {
            report.take_row(input, content, line)?;
        } else if !report.nm.is_empty() {
            break;
        }
    }
    if report.nm.is_empty() {
        let found = "a TUV report with no rows in its table";
        return Err(input.error(found, "bands and their irradiance"));
    }
    let columns = std::mem::take(&mut report.columns).into_iter().enumerate();
    let mut columns: Vec<(String, Vec<f64>)> = columns
        .map(|(column, values)| match report.titles.get(column) {
            Some(title) => (title.to_lowercase(), values),
            None => (format!("column {}", column + 3), values),
        })
        .collect();
    columns.sort_by_key(|(title, _)| !title.to_uppercase().contains("TOTAL"));
    let mut reading = Reading::default();
    for (title, values) in columns {
        let name = format!("{}, {title}", input.stem());
        let sun = report.sun.iter();
        let spectrum = RawSpectrum {
            lines: &report.lines,
            how: vec!["middles of bands".to_owned()],
            notes: sun
                .map(|angle| format!("solar zenith angle {angle} degrees"))
                .collect(),
            ..RawSpectrum::light(name, &report.nm, values, report.unit)
        };
        interpret(spectrum, input, &mut reading)?;
    }
    Ok(reading)
}
