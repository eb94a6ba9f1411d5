//! Bytes to text: which encoding, which line ends, what had to be dropped.

pub(super) mod dialect;
mod encoding;
pub(super) mod exposure;
pub(super) mod number;
pub(super) mod units;
pub(super) mod words;

use std::borrow::Cow;

use encoding_rs::Encoding;

/// Most bytes of one text file that the program opens: 512 MiB.
pub(crate) const MOST_BYTES: u64 = 512 * 1024 * 1024;

/// Most bytes of a text that only one instrument's or program's format tells how to read, 64 MiB:
/// far more than any of them writes.
pub const MOST_BYTES_OF_A_FORMAT: usize = 64 * 1024 * 1024;

/// The amount of a file that decides whether it is text.
const PROBE_BYTES: usize = 64 * 1024;

/// Lines of a text with their numbers in the file.
pub(super) type NumberedLines<'a> = [(usize, &'a str)];

/// A file's text.
#[derive(Clone, Debug)]
pub struct Text<'a> {
    /// The decoded text, without byte order mark and without NUL characters.
    pub text: Cow<'a, str>,
    /// The encoding of the source: "UTF-8", "UTF-16LE", "windows-1252", ...
    pub encoding: &'static str,
    /// The number of NUL characters that some instrument left in the text and were dropped.
    pub nuls_dropped: usize,
}

impl Text<'_> {
    /// The oddities of the text, a sentence each; empty for plain UTF-8.
    pub fn notes(&self) -> Vec<String> {
        let mut notes = Vec::new();
        if self.encoding != "UTF-8" {
            notes.push(tr!("text read as {encoding}", encoding = self.encoding));
        }
        match self.nuls_dropped {
            0 => {}
            nuls => notes
                .push(tr!("{n} NUL byte dropped from the text"
                    | "{n} NUL bytes dropped from the text" % nuls)),
        }
        notes
    }
}

/// True if bytes are numbers or an image rather than text.
///
/// Text holds no control characters beyond TAB and line ends, instruments leave a few in headers;
/// bytes of floating-point numbers hold some ten per cent. NUL bytes alone do not decide: they
/// pad headers, and UTF-16 is half NUL.
pub fn is_binary(bytes: &[u8]) -> bool {
    if Encoding::for_bom(bytes).is_some() {
        return false;
    }
    let probe = &bytes[..bytes.len().min(PROBE_BYTES)];
    let nuls = probe.iter().filter(|b| **b == 0).count();
    let controls = probe
        .iter()
        .filter(|b| matches!(**b, 1..=8 | 11 | 14..=25 | 27..=31 | 127))
        .count();
    controls * 50 > probe.len() || nuls * 5 > probe.len() * 3
}

/// Decodes a text file: a byte order mark decides, then valid UTF-8, else the encoding whose words
/// or letters it holds, and Windows-1252 (which holds Latin-1) where none tells.
pub fn decode(bytes: &[u8]) -> Text<'_> {
    let read = |encoding: &'static Encoding, bytes| {
        let (text, _) = encoding.decode_without_bom_handling(bytes);
        (text, encoding.name())
    };
    let (text, encoding) = match Encoding::for_bom(bytes) {
        Some((encoding, mark)) => read(encoding, &bytes[mark..]),
        None => match std::str::from_utf8(bytes) {
            Ok(text) => (Cow::Borrowed(text), "UTF-8"),
            Err(_) => read(encoding::of(bytes), bytes),
        },
    };
    let nuls_dropped = memchr::memchr_iter(0, text.as_bytes()).count();
    let text = if nuls_dropped == 0 {
        text
    } else {
        Cow::Owned(text.chars().filter(|c| *c != '\0').collect())
    };
    Text {
        text,
        encoding,
        nuls_dropped,
    }
}

/// A line's number as it is kept with every point, in half the memory.
pub(super) fn kept_line(line: usize) -> u32 {
    u32::try_from(line).unwrap_or(u32::MAX)
}

/// Lines with their numbers from 1, whatever ends them: LF, CR LF or CR alone.
pub fn lines(text: &str) -> Lines<'_> {
    Lines {
        rest: text,
        number: 0,
    }
}

/// Iterator of [`lines`].
#[derive(Clone, Debug)]
pub struct Lines<'a> {
    rest: &'a str,
    number: usize,
}

impl<'a> Lines<'a> {
    /// The text that is left.
    pub fn rest(&self) -> &'a str {
        self.rest
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = (usize, &'a str);

    fn next(&mut self) -> Option<Self::Item> {
        let (line, rest) = first_line(self.rest)?;
        self.rest = rest;
        self.number += 1;
        Some((self.number, line))
    }
}

/// The first line without its end, and the text behind it; `None` at the end of the text.
pub(super) fn first_line(text: &str) -> Option<(&str, &str)> {
    // Most short lines are empty ones.
    let Some(end) = (match text.bytes().next()? {
        b'\n' | b'\r' => Some(0),
        _ => memchr::memchr2(b'\n', b'\r', text.as_bytes()),
    }) else {
        return Some((text, ""));
    };
    let past = end + 1 + usize::from(text[end..].starts_with("\r\n"));
    Some((&text[..end], &text[past..]))
}

/// The byte offset of a part of a text within it.
pub(crate) fn place_in(text: &str, part: &str) -> usize {
    part.as_ptr() as usize - text.as_ptr() as usize
}

/// True if a line kept of a text is not a comment, whose mark would precede it: a row that was
/// commented out is not a row.
pub(crate) fn is_no_comment(text: &str, content: &str) -> bool {
    let before = text[..place_in(text, content)].bytes().rev();
    let mut before = before.take_while(|byte| !matches!(byte, b'\n' | b'\r'));
    before.all(|byte| byte.is_ascii_whitespace())
}
