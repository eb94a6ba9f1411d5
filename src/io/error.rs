//! Why a file was not read or not written: one line each, naming the file.

use std::path::Path;

/// Longest piece of a file that a message repeats, in characters.
const LONGEST_QUOTE: usize = 48;

/// Longest file name that a message repeats, in characters.
const LONGEST_NAME: usize = 120;

/// Longest path that a message repeats, in characters.
const LONGEST_PATH: usize = 300;

/// Longest part of a message, in characters: parsers of others quote whole elements.
const LONGEST_PART: usize = 300;

/// A file that could not be read: where, what was there and what should have been.
///
/// The message is always one line: `lamp.csv, line 12: found "abc", expected a number in column 2`.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{}", refusal_words(file, *line, found, expected))]
pub struct ReadError {
    /// Name of the file: without its folder, unless [`ReadError::at`] was told where it lies.
    pub file: String,
    /// Line in the file, counted from 1, where there is one to point at.
    pub line: Option<usize>,
    /// The actual content, in words or as a quotation.
    pub found: String,
    /// The content expected instead.
    pub expected: String,
}

impl ReadError {
    /// An error of the whole file.
    pub fn new(file: &str, found: impl Into<String>, expected: impl Into<String>) -> Self {
        Self {
            file: printable(file, LONGEST_NAME),
            line: None,
            found: part_of_message(&found.into()),
            expected: part_of_message(&expected.into()),
        }
    }

    /// The same error at a line of the file (counted from 1).
    #[must_use]
    pub(crate) fn at_line(mut self, line: usize) -> Self {
        self.line = Some(line);
        self
    }

    /// The same error with the file's whole path: two files may have one name. The other file of a
    /// pair keeps its own.
    #[must_use]
    pub fn at(mut self, path: &Path) -> Self {
        if self.file == printable(&name_of(path), LONGEST_NAME) {
            self.file = shown(path);
        }
        self
    }
}

fn refusal_words(file: &str, line: Option<usize>, found: &str, expected: &str) -> String {
    match line {
        Some(line) => tr!(
            "{file}, line {line}: found {found}, expected {expected}",
            file,
            line,
            found,
            expected
        ),
        None => tr!(
            "{file}: found {found}, expected {expected}",
            file,
            found,
            expected
        ),
    }
}

/// A file that could not be written, and why, in one line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{file}: {why}")]
pub struct WriteError {
    /// The file as the user named it.
    pub file: String,
    /// The obstacle and the remedy.
    pub why: String,
}

impl WriteError {
    /// An error of the whole file.
    pub(crate) fn new(file: &str, why: impl Into<String>) -> Self {
        Self {
            file: printable(file, LONGEST_NAME),
            why: printable_line(&why.into()),
        }
    }
}

/// A path as a person is shown it: in one line, control characters and bytes that are no text as
/// escapes, of a very long one the end.
pub fn shown(path: &Path) -> String {
    let mut out = String::new();
    for c in path.to_string_lossy().chars() {
        if is_printable(c) {
            out.push(c);
        } else {
            out.extend(c.escape_default());
        }
    }
    match out.char_indices().nth_back(LONGEST_PATH) {
        Some((start, _)) => format!("…{}", &out[start..]),
        None => out,
    }
}

/// A piece of a file as a quotation: in quotes, shortened, anything unprintable as a dot.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", printable(text, LONGEST_QUOTE))
}

/// Text of one line, at most `longest` characters, anything unprintable as a dot.
fn printable(text: &str, longest: usize) -> String {
    let text = shortened(text.trim(), longest);
    let shown = |c| if is_printable(c) { c } else { '·' };
    text.chars().map(shown).collect()
}

/// One part of a message: one line, and not for ever.
pub(crate) fn part_of_message(text: &str) -> String {
    shortened(&printable_line(text), LONGEST_PART)
}

/// A text, or its first `longest` characters and a sign that there were more.
pub(super) fn shortened(text: &str, longest: usize) -> String {
    match text.char_indices().nth(longest) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}

/// Most of a text that is kept with every spectrum of a file, in bytes: one long title in front of
/// many spectra must not be kept in full with each.
const LONGEST_KEPT: usize = 500;

/// The start of a text that is kept with every spectrum of a file.
pub(super) fn kept(text: &str) -> &str {
    &text[..text.floor_char_boundary(LONGEST_KEPT)]
}

/// Text of one line, anything unprintable as a blank.
pub(super) fn printable_line(text: &str) -> String {
    let shown = |c| if is_printable(c) { c } else { ' ' };
    text.chars().map(shown).collect()
}

/// Neither a control character nor one of Unicode's line and direction marks, which would let a
/// file name or a cell break the line or turn it round.
fn is_printable(c: char) -> bool {
    !c.is_control()
        && !matches!(c, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}' | '\u{fffd}')
}

/// The last part of a path, as messages show it.
pub(crate) fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or(path.as_os_str());
    name.to_string_lossy().into_owned()
}
