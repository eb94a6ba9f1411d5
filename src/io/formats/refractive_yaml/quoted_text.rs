//! Quoted text that continues at the start of a line, which the site's files have and YAML forbids.

/// The same text with such lines indented by a blank, so that line numbers stay; `None` if there
/// are none. Only quotes that open behind a key at the start of a line count.
pub(crate) fn indented(text: &str) -> Option<String> {
    let mut changed = String::with_capacity(text.len() + text.len() / 8);
    let mut inside: Option<char> = None;
    let mut has_changed = false;
    for line in text.split_inclusive('\n') {
        match inside {
            Some(quote) => {
                if !line.trim().is_empty() && !line.starts_with([' ', '\t']) {
                    changed.push(' ');
                    has_changed = true;
                }
                if closes(line, quote) {
                    inside = None;
                }
            }
            None => {
                let opened = opens(line);
                inside = opened.and_then(|(quote, rest)| (!closes(rest, quote)).then_some(quote));
            }
        }
        changed.push_str(line);
    }
    has_changed.then_some(changed)
}

/// The quote behind a key at the start of a line, and the text after it.
fn opens(line: &str) -> Option<(char, &str)> {
    if line.starts_with([' ', '\t', '#', '-', '"', '\'']) {
        return None;
    }
    let value = line.split_once(": ")?.1.trim_start();
    let quote = value.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    Some((quote, &value[1..]))
}

/// True if a quoted text ends on this line: in double quotes a backslash escapes the next
/// character, and a doubled single quote is a literal one.
fn closes(line: &str, quote: char) -> bool {
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        if letter == '\\' && quote == '"' {
            letters.next();
        } else if letter == quote {
            if quote == '\'' && letters.peek() == Some(&quote) {
                letters.next();
            } else {
                return true;
            }
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use super::indented;

    #[test]
    fn only_lines_within_quotes_are_set_in() {
        let text = "A: \"one\ntwo \\\" \\\\\"\nB: 'it''s\n\nfine'\nC:\n  - type: \"x\ny\"\n";
        let want = "A: \"one\n two \\\" \\\\\"\nB: 'it''s\n\n fine'\nC:\n  - type: \"x\ny\"\n";
        assert_eq!(indented(text).as_deref(), Some(want));
        assert_eq!(indented("A: \"one\"\nB: two\n"), None);
    }
}
