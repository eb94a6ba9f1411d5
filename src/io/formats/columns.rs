//! Plain columns: CSV, TSV and whatever else writes wavelengths and values as text.
//!
//! Nothing about the table is taken from the extension. [`table::read`](crate::io::table::read)
//! determines the separator of its cells, the place of its wavelengths and the columns of spectra.

use super::{Confidence, Format};
use crate::io::table::read::read_tables;
use crate::io::text::dialect::Dialect;
use crate::io::{Input, ReadError, Reading};

pub(crate) const FORMAT: Format = Format::new(
    later!("plain columns"),
    &["csv", "tsv", "txt", "dat", "asc", "prn"],
    sniff,
    read,
);

fn sniff(input: &Input) -> Confidence {
    match input.text() {
        Some(_) => Confidence::Possible,
        None => Confidence::No,
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_long_text()?.text;
    let mut reading = read_tables(input, text, input.choices.dialect)?;
    let dialect = reading.table.as_ref().map(|table| table.dialect);
    reading.notes.extend(dialect.map(Dialect::words));
    Ok(reading)
}
