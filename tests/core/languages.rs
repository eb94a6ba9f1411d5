//! Every text that a person reads stands in every language, with the same figures in it.
//!
//! `UPDATE_LANGUAGES=true` puts new texts into the files, untranslated, and takes out those that are
//! said no more: then a person translates what is empty.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};

use rspolib::{POEntry, POFile, pofile};

use super::root::root;
use crate::languages::Language;

/// What is translated: what a word may stand for beside another meaning, the text, and that for
/// several things where it counts.
type Text = (Option<String>, String, Option<String>);

/// The macros whose literals are texts.
const MARKS: [&str; 3] = ["tr!(", "said!(", "later!("];

/// What of `presets/families.json` and `presets/everyday_surfaces.json` is read by a person.
const OF_PRESETS: [&str; 9] = [
    "title", "heading", "one", "question", "what", "about", "label", "of", "name",
];

fn sources(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("a folder that can be listed").path();
        match path.is_dir() {
            true => sources(&path, into),
            false if path.extension().is_some_and(|e| e == "rs") => into.push(path),
            false => {}
        }
    }
    into.sort();
}

/// The literal that begins here, as Rust reads it, and what comes behind.
fn literal(code: &str) -> Option<(String, &str)> {
    let mut text = String::new();
    let mut letters = code.strip_prefix('"')?.char_indices();
    while let Some((at, letter)) = letters.next() {
        match letter {
            '"' => return Some((text, &code[at + 2..])),
            '\\' => match letters.next()?.1 {
                'n' => text.push('\n'),
                't' => text.push('\t'),
                'u' => {
                    let digits: String = letters
                        .by_ref()
                        .map(|(_, c)| c)
                        .take_while(|c| *c != '}')
                        .collect();
                    let code = u32::from_str_radix(digits.trim_start_matches('{'), 16).ok()?;
                    text.push(char::from_u32(code)?);
                }
                '\n' => {
                    let rest = letters.as_str().trim_start();
                    let skipped = letters.as_str().len() - rest.len();
                    (0..letters.as_str()[..skipped].chars().count()).for_each(|_| {
                        letters.next();
                    });
                }
                other => text.push(other),
            },
            letter => text.push(letter),
        }
    }
    None
}

/// The texts that are marked in a file's code, in order.
fn marked(code: &str) -> Vec<Text> {
    let code: Vec<&str> = code
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"))
        .collect();
    let code = code.join("\n");
    let mut found: Vec<(usize, Text)> = Vec::new();
    for mark in MARKS {
        for (at, _) in code.match_indices(mark) {
            if code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_') {
                continue;
            }
            let Some((first, rest)) = literal(code[at + mark.len()..].trim_start()) else {
                continue;
            };
            let text = match rest.trim_start().strip_prefix("=>") {
                Some(rest) => {
                    literal(rest.trim_start()).map(|(text, rest)| (Some(first.clone()), text, rest))
                }
                None => None,
            };
            let (context, text, rest) = text.unwrap_or((None, first, rest));
            let several = rest.trim_start().strip_prefix('|');
            let several = several.and_then(|rest| literal(rest.trim_start()));
            found.push((at, (context, text, several.map(|(text, _)| text))));
        }
    }
    found.sort();
    found.into_iter().map(|(_, text)| text).collect()
}

fn of_preset(value: &serde_json::Value, into: &mut Vec<Text>) {
    match value {
        serde_json::Value::Object(fields) => {
            for (key, value) in fields {
                match value.as_str() {
                    Some(text) if OF_PRESETS.contains(&key.as_str()) => {
                        into.push((None, text.to_owned(), None));
                    }
                    _ => of_preset(value, into),
                }
            }
        }
        serde_json::Value::Array(items) => items.iter().for_each(|item| of_preset(item, into)),
        _ => {}
    }
}

/// Every text of the program, once, in the order of the files.
fn texts() -> Vec<Text> {
    let mut files = Vec::new();
    sources(&root().join("src"), &mut files);
    let mut found = Vec::new();
    for file in files {
        let code = fs::read_to_string(&file).expect("a source file is UTF-8");
        // What tests say is in English.
        let tests = code
            .find("\n#[cfg(test)]\nmod tests {")
            .unwrap_or(code.len());
        found.extend(marked(&code[..tests]));
    }
    for preset in ["families.json", "everyday_surfaces.json"] {
        let text = fs::read_to_string(root().join("presets").join(preset)).expect("a preset");
        let mut all = Vec::new();
        of_preset(&serde_json::from_str(&text).expect("JSON"), &mut all);
        // A surface's `of` is the name of a table's row.
        all.retain(|(_, text, _)| !text.contains('/'));
        found.extend(all);
    }
    // Of the first screen's chart the names of the surfaces.
    let chart = fs::read_to_string(root().join("presets/colorchecker_ohta.json"));
    let chart: serde_json::Value = serde_json::from_str(&chart.expect("a preset")).expect("JSON");
    let items = chart["items"].as_array().expect("surfaces").iter();
    found.extend(items.map(|item| {
        let name = item["name"].as_str().expect("a name");
        (None, name.to_owned(), None)
    }));
    let mut seen = BTreeSet::new();
    found.retain(|text| !text.1.trim().is_empty() && seen.insert(text.clone()));
    found
}

fn path(language: Language) -> PathBuf {
    root()
        .join("src/languages")
        .join(format!("{}.po", language.code()))
}

fn catalog(language: Language) -> POFile {
    let text = fs::read_to_string(path(language)).expect("a file of texts");
    let catalog = pofile(text.as_str()).unwrap_or_else(|why| panic!("{}: {why}", language.code()));
    assert!(!catalog.entries.is_empty(), "{} is read", language.code());
    catalog
}

fn key(entry: &POEntry) -> Text {
    (
        entry.msgctxt.clone(),
        entry.msgid.clone(),
        entry.msgid_plural.clone(),
    )
}

/// The texts of an entry: one, or one and several.
fn translations(entry: &POEntry) -> Vec<&str> {
    match entry.msgid_plural {
        Some(_) => entry.msgstr_plural.iter().map(String::as_str).collect(),
        None => entry.msgstr.iter().map(String::as_str).collect(),
    }
}

fn languages() -> impl Iterator<Item = Language> {
    Language::ALL
        .into_iter()
        .filter(|language| *language != Language::English)
}

/// The figures and names that a text has room for, each with how often.
fn rooms(text: &str) -> BTreeMap<&str, usize> {
    let mut found = BTreeMap::new();
    for part in text.split('{').skip(1) {
        let name = part.split('}').next().unwrap_or_default();
        *found.entry(name).or_insert(0) += 1;
    }
    found
}

/// The file of a language with these texts, those that it has translated.
fn renewed(language: Language, texts: &[Text]) -> String {
    let catalog = catalog(language);
    let known: BTreeMap<Text, &POEntry> = catalog.entries.iter().map(|e| (key(e), e)).collect();
    let plural = if language == Language::French {
        "n > 1"
    } else {
        "n != 1"
    };
    let quoted = |text: &str| {
        let text = text.replace('\\', "\\\\").replace('"', "\\\"");
        format!("\"{}\"", text.replace('\n', "\\n").replace('\t', "\\t"))
    };
    let mut file = format!(
        "msgid \"\"\nmsgstr \"\"\n\"Language: {}\\n\"\n\"MIME-Version: 1.0\\n\"\n\
         \"Content-Type: text/plain; charset=UTF-8\\n\"\n\"Content-Transfer-Encoding: 8bit\\n\"\n\
         \"Plural-Forms: nplurals=2;plural=({plural});\\n\"\n",
        language.code()
    );
    for text in texts {
        let said = known
            .get(text)
            .map(|entry| translations(entry))
            .unwrap_or_default();
        let said = |index: usize| quoted(said.get(index).copied().unwrap_or_default());
        let (context, one, several) = text;
        file.push('\n');
        if let Some(context) = context {
            file += &format!("msgctxt {}\n", quoted(context));
        }
        file += &format!("msgid {}\n", quoted(one));
        file += &match several {
            None => format!("msgstr {}\n", said(0)),
            Some(several) => format!(
                "msgid_plural {}\nmsgstr[0] {}\nmsgstr[1] {}\n",
                quoted(several),
                said(0),
                said(1)
            ),
        };
    }
    file
}

#[test]
fn every_language_says_every_text_and_nothing_else() {
    let texts = texts();
    assert!(texts.len() > 1000, "found only {} texts", texts.len());
    for language in languages() {
        if std::env::var_os("UPDATE_LANGUAGES").is_some() {
            fs::write(path(language), renewed(language, &texts)).expect("written");
        }
        let catalog = catalog(language);
        let known: BTreeSet<Text> = catalog.entries.iter().map(key).collect();
        let said: BTreeSet<Text> = texts.iter().cloned().collect();
        let missing: Vec<&Text> = said.difference(&known).collect();
        let stale: Vec<&Text> = known.difference(&said).collect();
        assert!(
            missing.is_empty() && stale.is_empty(),
            "{}: missing {missing:#?}, said no more {stale:#?}",
            language.code()
        );
        let empty: Vec<&str> = catalog
            .entries
            .iter()
            .filter(|entry| {
                let all = translations(entry);
                all.len() != 1 + usize::from(entry.msgid_plural.is_some()) || all.contains(&"")
            })
            .map(|entry| entry.msgid.as_str())
            .collect();
        assert!(
            empty.is_empty(),
            "{}: untranslated {empty:#?}",
            language.code()
        );
    }
}

#[test]
fn a_translation_has_the_figures_of_its_text() {
    for language in languages() {
        for entry in &catalog(language).entries {
            let mut wanted = rooms(&entry.msgid);
            let one = wanted.clone();
            if let Some(several) = &entry.msgid_plural {
                wanted = rooms(several);
            }
            for (form, text) in translations(entry).into_iter().enumerate() {
                let found = rooms(text);
                // One thing may be told with its figure or in words.
                let fits = found == wanted || form == 0 && found == one;
                assert!(
                    fits,
                    "{}: {:?} is said {text:?}",
                    language.code(),
                    entry.msgid
                );
            }
        }
    }
}

#[test]
fn a_translation_begins_and_ends_as_its_text_does() {
    let ends = |text: &str| {
        let last = text.trim_end().chars().last();
        (
            last.filter(|c| ".:…?!".contains(*c)),
            text.starts_with(' '),
            text.ends_with(' '),
        )
    };
    for language in languages() {
        for entry in &catalog(language).entries {
            for text in translations(entry) {
                assert_eq!(
                    ends(text),
                    ends(&entry.msgid),
                    "{}: {:?} is said {text:?}",
                    language.code(),
                    entry.msgid
                );
            }
        }
    }
}

#[test]
fn the_reader_of_this_test_sees_what_is_marked() {
    let code = r#"
        // tr!("a comment")
        tr!("The peak of {name} is at {at} nm.", name, at = short(at));
        said!(
            "two \
             lines: \u{b0}"
        );
        tr!("menu" => "Open"); tr!("{n} line" | "{n} lines" % count, name);
        other_tr!("no"); tr!(dynamic);
        const A: &str = later!("quoted \"so\"");
    "#;
    let one = |text: &str| (None, text.to_owned(), None);
    assert_eq!(
        marked(code),
        [
            one("The peak of {name} is at {at} nm."),
            one("two lines: \u{b0}"),
            (Some("menu".to_owned()), "Open".to_owned(), None),
            (None, "{n} line".to_owned(), Some("{n} lines".to_owned())),
            one("quoted \"so\""),
        ]
    );
}
