//! A file as the formats see it: name, bytes and, if it is text, its text.

use std::cell::{Cell, OnceCell};
use std::path::{Path, PathBuf};

use crate::io::choices::Choices;
use crate::io::error::ReadError;
pub(crate) use crate::io::error::name_of;
use crate::io::text::{self, Text};

/// The amount of text examined by a sniffer, in bytes.
const HEAD_BYTES: usize = 8192;

/// A file in memory.
#[derive(Debug)]
pub struct Input<'a> {
    /// Name without the folder, as messages show it.
    pub name: String,
    /// The whole content.
    pub bytes: &'a [u8],
    /// Its location, for formats that are a pair of files; `None` when it came another way.
    pub path: Option<PathBuf>,
    /// The user's decisions about it.
    pub choices: Choices,
    text: OnceCell<Option<Text<'a>>>,
    /// Blanks in front of the text: every sniffer asks.
    blanks: OnceCell<usize>,
    is_read_as_text: Cell<bool>,
}

impl<'a> Input<'a> {
    /// A file from its name and content.
    pub fn new(name: &str, bytes: &'a [u8]) -> Self {
        Self {
            name: name.to_owned(),
            bytes,
            path: None,
            choices: Choices::default(),
            text: OnceCell::new(),
            blanks: OnceCell::new(),
            is_read_as_text: Cell::new(false),
        }
    }

    /// A file from its place and content.
    pub fn at(path: &Path, bytes: &'a [u8]) -> Self {
        Self {
            path: Some(path.to_owned()),
            ..Self::new(&name_of(path), bytes)
        }
    }

    /// The same file with decisions about it.
    #[must_use]
    pub(crate) fn deciding(self, choices: &Choices) -> Self {
        Self {
            choices: choices.clone(),
            ..self
        }
    }

    /// The decoded text, or `None` for a binary file. Decoded once, on first use.
    pub fn text(&self) -> Option<&Text<'a>> {
        self.text
            .get_or_init(|| (!text::is_binary(self.bytes)).then(|| text::decode(self.bytes)))
            .as_ref()
    }

    /// The first part of the text without blanks in front; empty for a binary file.
    pub fn head(&self) -> &str {
        let Some(text) = self.text() else { return "" };
        let blanks = || text.text.len() - text.text.trim_start().len();
        let text = &text.text[*self.blanks.get_or_init(blanks)..];
        &text[..text.floor_char_boundary(HEAD_BYTES)]
    }

    /// The first line of the text that is not empty; empty for a binary file.
    pub(crate) fn first_line(&self) -> &str {
        self.head().lines().next().unwrap_or("")
    }

    /// The text of an instrument's or a program's own format.
    ///
    /// # Errors
    /// [`ReadError`] for a binary file, and one larger than such formats are.
    pub(crate) fn needs_text(&self) -> Result<&Text<'a>, ReadError> {
        if self.bytes.len() > text::MOST_BYTES_OF_A_FORMAT {
            return Err(self.error(
                said!("more than 64 MiB"),
                said!("at most 64 MiB in an instrument's own format"),
            ));
        }
        self.needs_long_text()
    }

    /// The text of a table or of JSON, which may be as large as any file.
    ///
    /// # Errors
    /// [`ReadError`] for a binary file.
    pub(crate) fn needs_long_text(&self) -> Result<&Text<'a>, ReadError> {
        self.is_read_as_text.set(true);
        self.text()
            .ok_or_else(|| self.error(said!("binary data"), said!("a text file")))
    }

    /// The oddities of the text, a sentence each; empty where a format read the bytes themselves,
    /// whatever they look like.
    pub(crate) fn text_notes(&self) -> Vec<String> {
        self.text()
            .filter(|_| self.is_read_as_text.get())
            .map(Text::notes)
            .unwrap_or_default()
    }

    /// True if the name ends in an extension (lower case, without the dot).
    pub(crate) fn has_extension(&self, extension: &str) -> bool {
        self.name
            .rsplit_once('.')
            .is_some_and(|(_, end)| end.eq_ignore_ascii_case(extension))
    }

    /// The name without its last extension: what a spectrum is called that has no name.
    pub(crate) fn stem(&self) -> &str {
        match self.name.rsplit_once('.') {
            Some((stem, _)) if !stem.is_empty() => stem,
            _ => &self.name,
        }
    }

    /// A name that the file gives, or its own without the extension where that is empty.
    pub(crate) fn named<'n>(&'n self, name: &'n str) -> &'n str {
        match name {
            "" => self.stem(),
            name => name,
        }
    }

    /// An error of this file.
    pub fn error(&self, found: impl Into<String>, expected: impl Into<String>) -> ReadError {
        ReadError::new(&self.name, found, expected)
    }

    /// An error at a line of this file, from 1.
    pub(crate) fn error_at(
        &self,
        line: usize,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> ReadError {
        self.error(found, expected).at_line(line)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_odd_about_a_text_is_of_interest_where_it_was_read_as_one() {
        let input = Input::new("a.sli", b"k\xe4se\0");
        assert!(input.head().starts_with('k'));
        assert_eq!(input.text_notes(), Vec::<String>::new());
        assert!(input.needs_text().is_ok());
        assert_eq!(input.text_notes().len(), 2);
    }
}
