//! The translations: files of gettext, read when their language is first spoken.

use std::{collections::HashMap, sync::LazyLock};

use super::{Language, spoken};

static GERMAN: LazyLock<Texts> = LazyLock::new(|| Texts::read(include_str!("de.po")));
static SPANISH: LazyLock<Texts> = LazyLock::new(|| Texts::read(include_str!("es.po")));
static FRENCH: LazyLock<Texts> = LazyLock::new(|| Texts::read(include_str!("fr.po")));

/// The texts of a language, by the English ones.
struct Texts {
    /// Of one thing, and of several where a text counts.
    all: HashMap<String, [String; 2]>,
    /// The same of texts that say which meaning is meant.
    by_meaning: HashMap<String, HashMap<String, [String; 2]>>,
}

impl Texts {
    fn read(file: &str) -> Self {
        let file = rspolib::pofile(file).expect("a test reads every file");
        let mut all = HashMap::new();
        let mut by_meaning: HashMap<String, HashMap<_, _>> = HashMap::new();
        for entry in file.entries {
            let mut several = entry.msgstr_plural.into_iter();
            let one = entry.msgstr.or_else(|| several.next()).unwrap_or_default();
            // What nobody has translated yet is said in English.
            if one.is_empty() {
                continue;
            }
            let both = [one, several.next().unwrap_or_default()];
            match entry.msgctxt {
                None => drop(all.insert(entry.msgid, both)),
                Some(meaning) => {
                    by_meaning
                        .entry(meaning)
                        .or_default()
                        .insert(entry.msgid, both);
                }
            }
        }
        Self { all, by_meaning }
    }

    fn find(&self, english: &str, meaning: Option<&str>) -> Option<&[String; 2]> {
        match meaning {
            None => self.all.get(english),
            Some(meaning) => self.by_meaning.get(meaning)?.get(english),
        }
    }
}

/// The texts of the language spoken; none for English, which stands in the code.
fn texts() -> Option<&'static Texts> {
    match spoken() {
        Language::English => None,
        Language::German => Some(&GERMAN),
        Language::Spanish => Some(&SPANISH),
        Language::French => Some(&FRENCH),
    }
}

fn found(english: &str, meaning: Option<&str>) -> Option<&'static [String; 2]> {
    texts()?.find(english, meaning)
}

/// A text that is known only as the program runs, such as a name in a file, in the language spoken.
pub fn translated(english: &str) -> &str {
    found(english, None).map_or(english, |[text, _]| text)
}

/// A text without figures in the language spoken.
pub fn said(english: &'static str) -> &'static str {
    translated(english)
}

/// A text of a meaning, to be filled in.
pub fn text(english: &'static str, meaning: Option<&str>) -> &'static str {
    found(english, meaning).map_or(english, |[text, _]| text)
}

/// The text for so many, to be filled in.
pub fn counted(n: u64, one: &'static str, several: &'static str) -> &'static str {
    let is_one = n == 1 || n == 0 && spoken() == Language::French;
    match found(one, None) {
        Some([text, _]) if is_one => text,
        Some([_, text]) => text,
        None if n == 1 => one,
        None => several,
    }
}

#[cfg(test)]
mod tests {
    use crate::languages::{Language, in_language, said, translated};

    #[test]
    fn a_text_is_said_in_each_language_and_counts_as_it_does() {
        let lines = |count: usize| crate::tr!("{n} light" | "{n} lights" % count);
        for (language, open, counts) in [
            (
                Language::English,
                "Open",
                ["0 lights", "1 light", "2 lights"],
            ),
            (
                Language::German,
                "Öffnen",
                ["0 Lichter", "1 Licht", "2 Lichter"],
            ),
            (Language::Spanish, "Abrir", ["0 luces", "1 luz", "2 luces"]),
            (
                Language::French,
                "Ouvrir",
                ["0 lumière", "1 lumière", "2 lumières"],
            ),
        ] {
            in_language(language, || {
                assert_eq!((said("Open"), translated("Open")), (open, open));
                assert_eq!([0, 1, 2].map(lines), counts);
                // What nobody translated, and nothing, stay as they are.
                assert_eq!((said("FL3.1"), said("")), ("FL3.1", ""));
            });
        }
    }
}
