//! The header of an ENVI file.

use std::collections::HashMap;
use std::ops::Deref;

use crate::io::error::quoted;
use crate::io::text::{MOST_BYTES, lines, number};
use crate::io::{ReadError, budget};
use crate::spectrum::cube::{Interleave, Layout, Number, bytes_of};

/// A header's fields.
#[derive(Debug)]
pub struct Fields {
    /// Name of the header's file, for messages.
    pub file: String,
    /// Values and the lines on which they start.
    fields: HashMap<String, (usize, String)>,
}

/// A header: the description of the data, and its fields.
#[derive(Debug)]
pub struct Header {
    fields: Fields,
    /// True if the data are consecutive spectra rather than an image.
    pub is_library: bool,
    /// Columns, 1 in a library.
    pub width: usize,
    /// Rows of a cube, spectra of a library.
    pub height: usize,
    /// Channels.
    pub channels: usize,
    layout: Layout,
}

impl Deref for Header {
    type Target = Fields;

    fn deref(&self) -> &Fields {
        &self.fields
    }
}

impl Header {
    /// The layout of the numbers in the data.
    ///
    /// # Errors
    /// [`ReadError`] if the value that marks missing data is not a number.
    pub fn layout(&self) -> Result<Layout, ReadError> {
        let missing = self.number("data ignore value")?;
        Ok(Layout {
            missing,
            ..self.layout
        })
    }

    /// Bytes that the data file must have, header offset included; `None` beyond counting.
    pub fn bytes(&self) -> Option<usize> {
        let numbers = bytes_of(self.width, self.height, self.channels, self.layout.number)?;
        numbers.checked_add(self.layout.first_byte)
    }

    /// The same where they are few enough to be read whole.
    ///
    /// # Errors
    /// [`ReadError`] with the size of the data in words.
    pub(super) fn few_bytes(&self) -> Result<usize, ReadError> {
        let few = self.bytes().filter(|bytes| *bytes as u64 <= MOST_BYTES);
        few.ok_or_else(|| self.error("samples", self.in_words(), said!("at most 512 MiB of data")))
    }

    /// The refusal of data that end after `found` bytes, too early.
    pub(super) fn short(&self, found: usize, data_name: &str) -> ReadError {
        let (numbers, offset) = (self.in_words(), self.layout.first_byte);
        let expected = tr!(
            "{numbers} after {n} bytes, as {file} says"
                | "{numbers} after {n} bytes, as {file} says" % offset,
            numbers,
            file = self.file
        );
        ReadError::new(data_name, tr!("{n} bytes" | "{n} bytes" % found), expected)
    }

    /// The expected contents of the data file, in words.
    fn in_words(&self) -> String {
        let (bytes, lines) = (self.layout.number.bytes(), self.height);
        let (samples, bands) = match self.is_library {
            true => (self.channels, self.width),
            false => (self.width, self.channels),
        };
        tr!(
            "{samples} x {lines} x {bands} numbers of {n} bytes"
                | "{samples} x {lines} x {bands} numbers of {n} bytes" % bytes,
            samples,
            lines,
            bands
        )
    }
}

impl Fields {
    /// A field's text, without braces; keys are lower case.
    pub(crate) fn text(&self, key: &str) -> Option<&str> {
        let value = self.fields.get(key)?.1.trim();
        (!value.is_empty()).then_some(value)
    }

    /// The items of a field in braces.
    pub(crate) fn list(&self, key: &str) -> Vec<&str> {
        let mut items = self.text(key).map(split).unwrap_or_default();
        // Some writers leave a comma behind the last item.
        if items.last() == Some(&"") {
            items.pop();
        }
        items
    }

    /// The numbers of a field in braces.
    ///
    /// # Errors
    /// [`ReadError`] at the field when an item is no number.
    pub(crate) fn numbers(&self, key: &str) -> Result<Vec<f64>, ReadError> {
        let number = |item: &str| {
            number::number(item, false)
                .filter(|x| x.is_finite())
                .ok_or_else(|| self.error(key, quoted(item), tr!("numbers in \"{key}\"", key)))
        };
        self.list(key).into_iter().map(number).collect()
    }

    /// One number; `None` where the field is not there.
    ///
    /// # Errors
    /// [`ReadError`] at the field when it is no number.
    pub(crate) fn number(&self, key: &str) -> Result<Option<f64>, ReadError> {
        let Some(text) = self.text(key) else {
            return Ok(None);
        };
        // "-nan" and the like mark missing numbers in any case.
        match number::number(text, false) {
            Some(x) => Ok(Some(x)),
            None if text.to_lowercase().contains("nan") => Ok(None),
            None => Err(self.error(key, quoted(text), tr!("a number as \"{key}\"", key))),
        }
    }

    /// A whole number; `otherwise` where the field may be missing and is.
    fn count(&self, key: &str, otherwise: Option<usize>) -> Result<usize, ReadError> {
        let Some(text) = self.text(key) else {
            let expected = tr!("a line \"{key} = number\"", key);
            let missing = || ReadError::new(&self.file, tr!("no \"{key}\"", key), expected);
            return otherwise.ok_or_else(missing);
        };
        let expected = tr!("a whole number as \"{key}\"", key);
        text.parse()
            .map_err(|_| self.error(key, quoted(text), expected))
    }

    /// An error at a field, or at the first line if the field is absent.
    pub(crate) fn error(
        &self,
        key: &str,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> ReadError {
        let line = self.fields.get(key).map_or(1, |(line, _)| *line);
        ReadError::new(&self.file, found, expected).at_line(line)
    }
}

/// The items between commas; one that begins with a quote extends to the quote before a comma, so
/// that names may have commas of their own.
pub(super) fn split(text: &str) -> Vec<&str> {
    let mut items = Vec::new();
    let mut rest = text;
    loop {
        let item = rest.trim_start();
        let quote = item.chars().next().filter(|c| matches!(c, '"' | '\''));
        let quoted = quote.and_then(|quote| closed(&item[1..], quote));
        let (one, after) = quoted.unwrap_or_else(|| match item.split_once(',') {
            Some((one, after)) => (one, Some(after)),
            None => (item, None),
        });
        items.push(one.trim());
        match after {
            Some(after) => rest = after,
            None => return items,
        }
    }
}

/// The quoted text, and the rest behind the comma after it; `None` if no quote is followed by a
/// comma or the end, as in `'t Hooft`.
fn closed(text: &str, quote: char) -> Option<(&str, Option<&str>)> {
    // As far as a header's longest name goes: an open quote must not be searched for repeatedly.
    let end = text
        .char_indices()
        .nth(200)
        .map_or(text.len(), |(at, _)| at);
    text[..end].match_indices(quote).find_map(|(at, _)| {
        let after = text[at + 1..].trim_start();
        if after.is_empty() {
            return Some((&text[..at], None));
        }
        let behind = after.strip_prefix(',')?;
        Some((&text[..at], Some(behind)))
    })
}

/// The kind of number behind a `data type`.
fn number_of(data_type: usize) -> Option<Number> {
    Some(match data_type {
        1 => Number::U8,
        2 => Number::I16,
        3 => Number::I32,
        4 => Number::F32,
        5 => Number::F64,
        12 => Number::U16,
        13 => Number::U32,
        14 => Number::I64,
        15 => Number::U64,
        _ => return None,
    })
}

/// Reads a header.
pub(super) fn parse(file: &str, text: &str) -> Result<Header, ReadError> {
    let header = Fields {
        file: file.to_owned(),
        fields: fields(file, text)?,
    };
    let samples = header.count("samples", None)?;
    let lines = header.count("lines", None)?;
    let bands = header.count("bands", Some(1))?;
    let first_byte = header.count("header offset", Some(0))?;
    let data_type = header.count("data type", None)?;
    let byte_order = header.count("byte order", Some(0))?;
    let number = number_of(data_type).ok_or_else(|| {
        let found = match data_type {
            6 | 9 => said!("complex numbers (data type 6 or 9)").to_owned(),
            other => format!("data type {other}"),
        };
        let expected = said!("data type 1, 2, 3, 4, 5, 12, 13, 14 or 15");
        header.error("data type", found, expected)
    })?;
    let word = header.text("interleave").unwrap_or("bsq").to_lowercase();
    let interleave = match &*word {
        "bsq" => Interleave::Bands,
        "bil" => Interleave::Lines,
        "bip" => Interleave::Pixels,
        _ => return Err(header.error("interleave", quoted(&word), said!("bsq, bil or bip"))),
    };
    for (key, value) in [("samples", samples), ("lines", lines), ("bands", bands)] {
        if value == 0 {
            return Err(header.error(key, format!("{key} = 0"), said!("1 or more")));
        }
    }
    if byte_order > 1 {
        let found = format!("byte order = {byte_order}");
        return Err(header.error("byte order", found, said!("0 or 1")));
    }
    let compression = "file compression";
    if header.text(compression).is_some_and(|word| word != "0") {
        let expected = said!("data that are not compressed; unpack them with ENVI or GDAL first");
        return Err(header.error(compression, said!("compressed data"), expected));
    }
    let kind = header.text("file type").unwrap_or("").to_lowercase();
    let names_spectra = header.fields.contains_key("spectra names");
    let has_one_band = bands == 1 && samples > 1;
    let is_library = kind.contains("spectral library")
        || has_one_band && (names_spectra || header.list("wavelength").len() == samples);
    let (width, channels, interleave) = match is_library {
        true => (bands, samples, Interleave::Pixels),
        false => (samples, bands, interleave),
    };
    Ok(Header {
        fields: header,
        is_library,
        width,
        height: lines,
        channels,
        layout: Layout {
            first_byte,
            number,
            big_endian: byte_order == 1,
            interleave,
            stored_bands: channels,
            missing: None,
        },
    })
}

fn fields(file: &str, text: &str) -> Result<HashMap<String, (usize, String)>, ReadError> {
    let mut fields = HashMap::new();
    // A field costs its text and about 200 bytes of book-keeping.
    let most = budget::of_text(text.len()) / 400;
    let refusal = |line: usize, found: &str, expected: &str| {
        ReadError::new(file, found, expected).at_line(line)
    };
    let mut rows = lines(text).skip(1);
    while let Some((line, row)) = rows.next() {
        let trimmed = row.trim();
        if trimmed.is_empty() || trimmed.starts_with(';') {
            continue;
        }
        let Some((key, value)) = trimmed.split_once('=') else {
            return Err(refusal(line, &quoted(trimmed), said!("\"key = value\"")));
        };
        let mut value = value.trim().to_owned();
        if let Some(inside) = value.strip_prefix('{') {
            let (mut inside, mut rest) = (String::new(), inside);
            let end = loop {
                if let Some((last, _)) = rest.split_once('}') {
                    break last;
                }
                inside.push_str(rest);
                inside.push(' ');
                let open = || tr!("{key} with no closing brace", key = quoted(key.trim()));
                let next = rows.next();
                (_, rest) = next.ok_or_else(|| refusal(line, &open(), said!("a closing brace")))?;
            };
            value = inside + end;
        }
        if fields.len() >= most {
            return Err(refusal(
                line,
                said!("too many fields"),
                said!("an ENVI header"),
            ));
        }
        let key = key.split_whitespace().collect::<Vec<_>>().join(" ");
        // The first of two fields of one name counts.
        fields.entry(key.to_lowercase()).or_insert((line, value));
    }
    Ok(fields)
}

#[cfg(test)]
mod tests {
    use super::split;

    #[test]
    fn a_name_that_begins_with_an_apostrophe_is_one_and_nothing_behind_a_comma_is_an_item() {
        assert_eq!(split("'t Hooft, b,"), ["'t Hooft", "b", ""]);
        assert_eq!(split("\"brick, red\", 'tile'"), ["brick, red", "tile"]);
    }
}
