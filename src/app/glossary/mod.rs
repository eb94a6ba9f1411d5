//! The words of the window, explained: plain, short, and right.

mod words;

use std::ops::Range;

use crate::languages::{Language, said, spoken};
pub use words::WORDS;

/// A word and what it means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// As it stands on screen.
    pub word: &'static str,
    /// Its forms in running text, singular; one with a large letter is meant as it is written.
    pub forms: &'static [&'static str],
    /// What it means, one to three sentences.
    pub means: &'static str,
}

impl Word {
    /// The word in the language spoken.
    pub fn word(&self) -> &'static str {
        said(self.word)
    }

    /// What it means, in the language spoken.
    pub fn means(&self) -> &'static str {
        said(self.means)
    }

    /// The word that this one only refers to, or itself.
    fn explained(&'static self) -> &'static Self {
        let other = self.means.strip_prefix("See ");
        let other = other.map(|rest| rest.trim_end_matches('.'));
        let other = other.and_then(|name| WORDS.iter().find(|one| one.word == name));
        other.unwrap_or(self)
    }
}

/// Where words of the glossary stand in a text, in bytes, in order and each word once: whole words,
/// the longest form that is there, also in the plural.
pub fn found_in(text: &str) -> Vec<(Range<usize>, &'static Word)> {
    let mut found: Vec<(Range<usize>, &'static Word)> = Vec::new();
    let mut at = 0;
    while let Some(letter) = text[at..].chars().next() {
        let next = at + letter.len_utf8();
        let begins = !text[..at].chars().next_back().is_some_and(is_of_word);
        let longest = WORDS
            .iter()
            .filter(|_| begins)
            .filter_map(|word| {
                let ends = word
                    .forms
                    .iter()
                    .filter_map(|form| end_of(&text[at..], said(form)));
                Some((at + ends.max()?, word.explained()))
            })
            .max_by_key(|(end, _)| *end);
        let Some((end, word)) = longest else {
            at = next;
            continue;
        };
        if found.iter().all(|(_, other)| other.word != word.word) {
            found.push((at..end, word));
        }
        at = end;
    }
    found
}

fn is_of_word(letter: char) -> bool {
    letter.is_alphanumeric() || letter == '-'
}

/// How much of a text's beginning a form is, with an ending of its language or without.
fn end_of(text: &str, form: &str) -> Option<usize> {
    let start = text.get(..form.len())?;
    let is_name = form.chars().any(char::is_uppercase);
    let fits = start == form || !is_name && start.to_lowercase() == form;
    let ends = |rest: &str| !rest.chars().next().is_some_and(is_of_word);
    let rest = &text[form.len()..];
    let mut endings = ENDINGS[usize::from(spoken() == Language::German)].iter();
    let ending = endings.find(|ending| rest.strip_prefix(**ending).is_some_and(ends));
    ending
        .filter(|_| fits)
        .map(|ending| form.len() + ending.len())
}

/// What may stand behind a word in a sentence, in German and elsewhere.
const ENDINGS: [&[&str]; 2] = [&["s", ""], &["ern", "en", "es", "er", "e", "n", "s", ""]];

/// What a word means, if it is one of them.
pub fn meaning(word: &str) -> Option<&'static str> {
    let found = WORDS.iter().find(|one| one.word.eq_ignore_ascii_case(word));
    found.map(|one| one.means)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_are_forty_words_or_more_by_the_alphabet_each_once_with_whole_sentences() {
        assert!(WORDS.len() >= 40);
        let names: Vec<String> = WORDS.iter().map(|w| w.word.to_lowercase()).collect();
        assert!(names.windows(2).all(|pair| pair[0] < pair[1]), "{names:?}");
        assert!(WORDS.iter().all(|w| w.means.ends_with('.')));
    }

    #[test]
    fn words_are_found_whole_and_once_in_their_longest_form() {
        let words = |text: &str| -> Vec<(String, &str)> {
            let found = found_in(text).into_iter();
            found
                .map(|(at, word)| (text[at].to_owned(), word.word))
                .collect()
        };
        let of = |found: &str, word| (found.to_owned(), word);
        assert_eq!(
            words("Cones add up the chromaticity diagram; a cone, Rf and LED-B3."),
            [
                of("Cones", "Cone"),
                of("chromaticity diagram", "Chromaticity"),
                of("Rf", "Rf")
            ]
        );
        // A lamp that led to it, a rayon and a slither are no words of the glossary.
        assert_eq!(words("It led to rayon and slither."), []);
        assert_eq!(
            words("ΔE₀₀ (fidelity)"),
            [of("ΔE₀₀", "Delta E (ΔE₀₀)"), of("fidelity", "Rf")]
        );
    }

    #[test]
    fn a_word_that_refers_to_another_refers_to_one_that_is_there() {
        for one in WORDS {
            let Some(others) = one.means.strip_prefix("See ") else {
                continue;
            };
            for other in others.trim_end_matches('.').split(" and ") {
                assert!(meaning(other).is_some(), "{}: {other}", one.word);
            }
        }
    }
}
