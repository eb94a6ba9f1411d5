//! The words of the window, the command line, the documents and the lessons: some stand nowhere.

use std::{fs, path::Path};

use super::root::root;

/// What a reader stumbles over, and what is said instead.
const AVOIDED: [(&str, &str); 42] = [
    ("smoothness", "waves"),
    ("wished for", "target"),
    ("lay over", "compare with"),
    ("laid over", "compared with, drawn over"),
    ("lays it over", "compares it with"),
    ("as it were", "nothing"),
    ("it cannot be said", "undecided"),
    ("not looked for", "what to switch on"),
    ("that are so", "what they are"),
    ("back so;", "restore"),
    ("whoever ", "you, or the thing itself"),
    ("those that ", "the thing itself"),
    ("do again", "redo"),
    ("done again", "redone"),
    ("an act", "a command"),
    ("its inside only", "internal transmittance"),
    ("end values are held", "end values are used"),
    ("nothing is called", "nothing found"),
    ("cannot be told apart", "look alike, hard to tell"),
    ("what white", "white"),
    ("daylight camera", "beside daylight"),
    ("recomputed in", "nothing"),
    ("lay a spectrum", "compare with"),
    ("is among the lessons", "was added to the lessons"),
    ("patches' mean", "mean of the surfaces"),
    ("worst patch", "worst surface"),
    ("how patches", "how surfaces"),
    ("whatever happens to", "what stays"),
    ("is to be made small", "the error to make small"),
    ("spike threshold", "lines above"),
    ("spikes are switched off", "lines are switched off"),
    ("not read so", "that way it cannot be read"),
    ("against the order", "against waves"),
    ("against order", "against waves"),
    (
        "the factor as measured",
        "the filter or surface as measured",
    ),
    ("field of colours", "swatch"),
    ("onto the patches", "to the surfaces"),
    ("as a composite are off", "as waves and lines are off"),
    ("both bases", "every basis"),
    ("what to favour", "figure to favour"),
    (
        "what it passes or falls on",
        "filters and surfaces that it meets",
    ),
    ("what the wavelength axis", "unit of the wavelength axis"),
];

/// Words that the paper and the code have, and the window has others for: lines, surfaces, steps.
const OF_THE_CODE: [&str; 6] = ["spike", "spikes", "patch", "patches", "stage", "stages"];

/// Rooms that speak with the paper's words, or of keys in files.
const SPEAK_OF_KEYS: [&str; 4] = ["app/lessons", "app/workspace", "studies/paper", "app/open"];

/// Files below a folder with one of some endings.
fn files(folder: &Path, endings: &[&str], into: &mut Vec<(String, String)>) {
    let mut entries: Vec<_> = fs::read_dir(folder)
        .expect("a folder")
        .map(|entry| entry.expect("an entry").path())
        .collect();
    entries.sort();
    for path in entries {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
        if path.is_dir() {
            files(&path, endings, into);
        } else if endings.contains(&ending) && !path.ends_with("tests.rs") {
            let text = fs::read_to_string(&path).expect("UTF-8");
            into.push((path.display().to_string(), text));
        }
    }
}

/// The words between quotation marks in code, without comments and unit tests; lines that go on
/// are one.
fn quoted_in(code: &str) -> Vec<String> {
    let code = code.split("#[cfg(test)]\nmod").next().unwrap_or_default();
    let letters: Vec<char> = code.chars().collect();
    let (mut found, mut at) = (Vec::new(), 0);
    while at < letters.len() {
        match (letters[at], letters.get(at + 1)) {
            ('/', Some('/')) => {
                while at < letters.len() && letters[at] != '\n' {
                    at += 1;
                }
            }
            // A quotation mark as a letter of its own.
            ('\'', Some('"')) => at += 3,
            ('\'', Some('\\')) => at += 4,
            ('"', _) => {
                let mut words = String::new();
                at += 1;
                while at < letters.len() && letters[at] != '"' {
                    if letters[at] == '\\' {
                        at += 1;
                        match letters.get(at) {
                            Some('"') => words.push('"'),
                            // A line that goes on in the next.
                            Some('\n') => {
                                while letters.get(at + 1).is_some_and(|c| c.is_whitespace()) {
                                    at += 1;
                                }
                            }
                            _ => words.push(' '),
                        }
                        at += 1;
                        continue;
                    }
                    words.push(letters[at]);
                    at += 1;
                }
                found.push(words);
                at += 1;
            }
            _ => at += 1,
        }
    }
    found
}

/// Every text that a person may read, with where it is from.
fn texts() -> Vec<(String, String)> {
    let (mut code, mut texts) = (Vec::new(), Vec::new());
    for room in ["app", "ui", "cli"] {
        files(&root().join("src").join(room), &["rs"], &mut code);
    }
    for (file, code) in code {
        let quoted = quoted_in(&code).into_iter();
        texts.extend(quoted.map(|words| (file.clone(), words)));
    }
    files(&root().join("lessons"), &["json"], &mut texts);
    for file in [
        "README.md",
        "docs/command_line.md",
        "docs/lessons.md",
        "docs/window.md",
        "presets/families.json",
    ] {
        let text = fs::read_to_string(root().join(file)).expect(file);
        texts.push((file.to_owned(), text));
    }
    texts
}

/// The avoided words in a text: whole ones, in small letters or capitals.
fn avoided_in(text: &str) -> Vec<&'static str> {
    let words = AVOIDED.iter().map(|(word, _)| *word);
    whole_in(text, words)
}

/// The words that stand in a text as whole ones.
fn whole_in(text: &str, words: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    let lower = text.to_lowercase();
    let is_letter = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || c == '_');
    let stands = |word: &str| {
        lower.match_indices(word).any(|(at, _)| {
            let before = lower[..at].chars().next_back();
            let behind = lower[at + word.len()..].chars().next();
            let ends_open = word.ends_with(' ');
            !is_letter(before) && (ends_open || !is_letter(behind))
        })
    };
    words.filter(|word| stands(word)).collect()
}

/// The words of the code in a sentence that the window shows: not in keys, heads of tables that
/// are copied, options and what is filled in.
fn of_the_code_in(sentence: &str) -> Vec<&'static str> {
    // Sentences that go on in the next line were drawn together; code has line ends.
    let is_one = !sentence.contains('\n') && !sentence.starts_with('#');
    let is_sentence = is_one && sentence.trim().contains(' ');
    if !is_sentence {
        return Vec::new();
    }
    let mut told = sentence
        .replace("--no-spikes", "")
        .replace("=2,filters=1", "");
    while let Some((before, rest)) = told.split_once('{') {
        let after = rest.split_once('}').map_or("", |(_, after)| after);
        told = format!("{before}_{after}");
    }
    whole_in(&told, OF_THE_CODE.into_iter())
}

#[test]
fn the_window_says_lines_surfaces_and_steps() {
    let mut code = Vec::new();
    for room in ["app", "ui"] {
        files(&root().join("src").join(room), &["rs"], &mut code);
    }
    code.retain(|(file, _)| !SPEAK_OF_KEYS.iter().any(|room| file.contains(room)));
    assert!(code.len() > 300, "only {} files", code.len());
    let mut wrong = Vec::new();
    for (file, code) in &code {
        for sentence in quoted_in(code) {
            for word in of_the_code_in(&sentence) {
                wrong.push(format!("{file}: {word:?} in: {sentence}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let found = of_the_code_in("Each {spike} is a spike, by --no-spikes");
    assert_eq!(found, ["spike"]);
    assert_eq!(of_the_code_in("stage,name,spikes"), [""; 0]);
}

#[test]
fn no_text_has_words_that_readers_stumble_over() {
    let texts = texts();
    assert!(texts.len() > 5000, "only {} texts", texts.len());
    let mut wrong = Vec::new();
    for (file, text) in &texts {
        for word in avoided_in(text) {
            let instead = AVOIDED.iter().find(|(avoided, _)| *avoided == word);
            let instead = instead.map_or("", |(_, instead)| instead);
            let text: String = text.chars().take(90).collect();
            wrong.push(format!("{file}: \"{word}\" (say: {instead}) in: {text}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn the_search_for_such_words_finds_them_in_sentences_and_nowhere_else() {
    let code = r#"
        // wished for, in a comment
        let letter = '"';
        let shown = "Light whose colour is \
                     wished for";
        let said = "He said:\nDone again, \"twice\"";
        let other = "an action; disdone again";
        #[cfg(test)]
mod tests { const NEVER: &str = "as it were"; }
    "#;
    let quoted = quoted_in(code);
    let found: Vec<&str> = quoted.iter().flat_map(|words| avoided_in(words)).collect();
    assert_eq!(found, ["wished for", "done again"], "{quoted:?}");
    assert_eq!(quoted.len(), 3, "{quoted:?}");
}
