//! Words in titles and header lines: found whole or by how they begin, not inside of others.

/// True if a text contains a pattern; both in lower case. A bar at either end of the pattern
/// requires the edge of a word there, `^` and `$` the ends of the text: `reflect` is found
/// anywhere, `|std` where a word begins, `|r%` too, `|opic|` as a whole word and `^no$` as the
/// whole text only. Letters and digits make words, everything else separates them.
pub(crate) fn holds(text: &str, pattern: &str) -> bool {
    let core = pattern.trim_start_matches(['|', '^']);
    let core = core.trim_end_matches(['|', '$']);
    let fits = |mark: Option<char>, of_text: &str, beside: Option<char>| match mark {
        Some('|') => beside.is_none_or(|c| !c.is_alphanumeric()),
        Some('^' | '$') => of_text.is_empty(),
        _ => true,
    };
    text.match_indices(core).any(|(at, _)| {
        let (before, behind) = (&text[..at], &text[at + core.len()..]);
        fits(pattern.chars().next(), before, before.chars().next_back())
            && fits(pattern.chars().next_back(), behind, behind.chars().next())
    })
}

/// True if a text contains any of the patterns in one text, separated by semicolons.
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
