//! Text and numbers as SVG has them: escaped, wrapped, and as wide as one may guess.

use std::fmt::Write as _;

use super::{super::ticks::without_trailing_zeros, Rgb, cut::Place, palette::hex};

pub(super) const TITLE_SIZE: f64 = 17.0;
pub(super) const TEXT_SIZE: f64 = 12.0;
pub(super) const NOTE_SIZE: f64 = 10.5;

/// Line spacing as a multiple of the font size.
pub(super) const LEADING: f64 = 1.4;

/// Mean width of a letter as a multiple of the font size: that of a wide sans-serif face, because
/// the reader's font is unknown and too much room looks better than too little.
const LETTER_WIDTH: f64 = 0.58;

/// Which part of a text stands at its place.
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text is written.
pub(super) struct Text {
    pub(super) size: f64,
    pub(super) colour: Rgb,
    pub(super) anchor: Anchor,
}

impl Text {
    /// Writes a line of text with its baseline at a place.
    pub(super) fn write(&self, out: &mut String, at: Place, text: &str) {
        let anchor = match self.anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let _ = writeln!(
            out,
            r#"<text x="{}" y="{}" font-size="{}"{anchor} fill="{}">{}</text>"#,
            px(at[0]),
            px(at[1]),
            px(self.size),
            hex(self.colour),
            escaped(text)
        );
    }
}

/// A length or coordinate with at most two decimals.
pub(super) fn px(length: f64) -> String {
    let digits = format!("{length:.2}");
    let digits = without_trailing_zeros(&digits);
    if digits == "-0" { "0" } else { digits }.to_owned()
}

/// Estimated width of a text, px.
pub(super) fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * LETTER_WIDTH
}

/// A text as lines that are no wider than `width` px, broken at spaces; words are left whole.
pub(super) fn wrap(text: &str, width: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in clean(text).split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(line, size) + text_width(word, size) + size < width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A text on one line, without the characters that XML 1.0 forbids.
pub(super) fn clean(text: &str) -> String {
    let sound = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => char::REPLACEMENT_CHARACTER,
        c => c,
    };
    text.chars().map(sound).collect()
}

/// A text as it stands between tags.
pub(super) fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in clean(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            c => out.push(c),
        }
    }
    out
}
