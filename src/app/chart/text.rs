//! How wide text is, as far as one may guess: the font of who looks at a file is unknown, and the
//! window lays charts out by the same guess so that both look alike.

/// Line spacing as a multiple of the font size.
pub(super) const LEADING: f64 = 1.4;

/// Mean width of a letter as a multiple of the font size: that of a wide sans-serif face, because
/// too much room looks better than too little.
const LETTER_WIDTH: f64 = 0.58;

/// Estimated width of a text, px.
pub fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * LETTER_WIDTH
}

/// The widest of some texts, px.
pub(super) fn widest<'a>(texts: impl IntoIterator<Item = &'a String>, size: f64) -> f64 {
    let widths = texts.into_iter().map(|text| text_width(text, size));
    widths.fold(0.0, f64::max)
}

/// A text as lines that are no wider than `width` px, broken at spaces; words are left whole.
pub fn wrap(text: &str, width: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
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

/// A text that is cut where it would be longer than `most` letters.
pub fn elided(text: &str, most: usize) -> String {
    if text.chars().count() <= most {
        return text.to_owned();
    }
    let kept: String = text.chars().take(most.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}
