//! The facts about a table's spectra in the lines above it, worked out once for all of them: a
//! table may have thousands of columns under hundreds of lines.

use super::{axis, factor_scale, kinds, value_unit};
use crate::io::provenance::ORIGINATOR;
use crate::io::text::NumberedLines;
use crate::io::text::units::WavelengthUnit;

/// The facts stated by a table's header.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Heading<'a> {
    /// True if this program wrote the file: its names are names, and every number was measured.
    pub is_own: bool,
    /// The name of the spectrum.
    pub name: Option<&'a str>,
    /// The stated origin of the numbers.
    pub source: Option<&'a str>,
    /// The notes in a file of this program on how the numbers were read before.
    pub notes: Option<&'a str>,
    /// Units of the wavelength axis, the nearest line first.
    pub axis_units: Vec<WavelengthUnit>,
    /// True if they are wavelengths in vacuum.
    pub in_vacuum: bool,
    /// The stated kind of the values.
    pub kind: kinds::FromHeader,
    /// True if values of a factor are per cent.
    pub percent: Option<bool>,
    /// Unit of the values; empty when it names none.
    pub unit: String,
}

impl<'a> Heading<'a> {
    /// Parses the lines above a table.
    pub(crate) fn of(lines: &NumberedLines<'a>) -> Self {
        if field(lines, "written by:").is_some_and(|program| program.starts_with(ORIGINATOR)) {
            return Self::own(lines);
        }
        Self {
            is_own: false,
            name: field(lines, "name:"),
            source: field(lines, "source:"),
            notes: None,
            axis_units: axis::units_of_header(lines),
            in_vacuum: lines.iter().any(|(_, line)| axis::says_vacuum(line)),
            kind: kinds::FromHeader::of(lines),
            percent: factor_scale::percent_of_header(lines),
            unit: value_unit::unit_of_header(lines),
        }
    }

    /// Parses the lines of a file that this program wrote: each key counts, and nothing else.
    pub(crate) fn own(lines: &NumberedLines<'a>) -> Self {
        let unit = field(lines, "unit:").unwrap_or("");
        Self {
            is_own: true,
            name: field(lines, "name:"),
            source: field(lines, "source:"),
            notes: field(lines, "notes:"),
            axis_units: vec![WavelengthUnit::Nanometre],
            in_vacuum: false,
            kind: kinds::FromHeader::of(lines),
            percent: Some(["%", "percent"].contains(&unit)),
            unit: unit.to_owned(),
        }
    }

    /// The same for a number of spectra: each has name, source and unit for itself, so that long
    /// ones under thousands of columns are cut.
    #[must_use]
    pub(crate) fn shared_by(mut self, spectra: usize) -> Self {
        let most = (MOST_SHARED / spectra.max(1)).max(LEAST_SHARED);
        let cut = |text: &'a str| &text[..text.floor_char_boundary(most)];
        self.name = self.name.map(cut);
        self.source = self.source.map(cut);
        self.notes = self.notes.map(cut);
        self.unit.truncate(self.unit.floor_char_boundary(most));
        self
    }
}

const MOST_SHARED: usize = 3 << 20;

/// Bytes of such a text that are kept in any case.
const LEAST_SHARED: usize = 60;

/// The text after a word ("name:", "source:") in a header line; upper or lower case.
pub(crate) fn field<'a>(lines: &NumberedLines<'a>, word: &str) -> Option<&'a str> {
    lines.iter().rev().find_map(|(_, line)| {
        let start = line.trim_start().get(..word.len())?;
        let value = line.trim_start()[word.len()..].trim();
        (start.eq_ignore_ascii_case(word) && !value.is_empty()).then_some(value)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_of_spectra_share_a_long_source_cut_short() {
        let source = format!("source: {}", "ä".repeat(10_000));
        let heading = Heading::of(&[(1, &source)]);
        assert_eq!(heading.clone().shared_by(1), heading);
        let cut = heading.shared_by(40_000);
        assert_eq!(cut.source.map(str::len), Some(78));
    }
}
