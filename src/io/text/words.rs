//! Words in titles and header lines: found whole or by how they begin, not inside of others.

/// Whether a text holds a pattern; both in lower case. A bar at either end of the pattern asks for
/// the edge of a word there: `reflect` is found anywhere, `|std` where a word begins, `|r%` too,
/// and `|opic|` as a whole word only. Letters and digits make words, everything else parts them.
pub(crate) fn holds(text: &str, pattern: &str) -> bool {
    let core = pattern.trim_matches('|');
    let is_edge = |c: Option<char>| c.is_none_or(|c| !c.is_alphanumeric());
    text.match_indices(core).any(|(at, _)| {
        (!pattern.starts_with('|') || is_edge(text[..at].chars().next_back()))
            && (!pattern.ends_with('|') || is_edge(text[at + core.len()..].chars().next()))
    })
}

/// Whether a text holds any of some patterns, as [`holds`] has it.
pub(crate) fn holds_any(text: &str, patterns: &[&str]) -> bool {
    patterns.iter().any(|pattern| holds(text, pattern))
}

/// The same of patterns in one text, semicolons between them.
pub(crate) fn holds_one(text: &str, patterns: &str) -> bool {
    patterns.split(';').any(|pattern| holds(text, pattern))
}

/// A title without what stands in brackets at its end: `S(lambda)` is `S`, `T [%]` is `T`.
pub(crate) fn without_brackets(title: &str) -> &str {
    let title = title.trim();
    match title.find(['(', '[']) {
        Some(open) if open > 0 => title[..open].trim_end(),
        _ => title,
    }
}
