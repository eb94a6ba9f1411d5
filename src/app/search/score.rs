//! How well a row answers what is typed.

/// What a row is found by.
#[derive(Clone, Debug, Default)]
pub(super) struct Texts {
    /// What people call it, of a favourite.
    pub label: String,
    /// Words written for it.
    pub words: Vec<String>,
    pub name: String,
    /// `group/name` of it and of its twins.
    pub ids: Vec<String>,
    /// What it is in a few words, and a sentence.
    pub what: String,
    pub about: String,
    /// Words of its family and of its table.
    pub of_all: Vec<String>,
    /// The file of one of the user's own.
    pub source: String,
}

/// How well a row answers: the greater the better; of equals favourites, surfaces by everyday
/// names, lights, measured ones.
pub(super) type Score = (u32, Ties);

/// What decides among equals, the first that differs.
pub(super) type Ties = [bool; 4];

/// A row's texts, ready to be compared.
#[derive(Clone, Debug)]
pub(super) struct Doc {
    /// Whole phrases with what they are worth when they are what was typed.
    phrases: Vec<(String, u32)>,
    /// Single words with what they are worth.
    words: Vec<(String, u32)>,
    /// What is looked into for a part of a word.
    inside: String,
    ties: Ties,
}

/// What was typed is the favourite's label, a word written for it, its name.
const LABEL: u32 = 2000;
const OWN_PHRASE: u32 = 1900;
const NAME: u32 = 1800;
const FAMILY_PHRASE: u32 = 700;
/// Single words: of those written for it, its name, what it is, its family, its sentence.
const OWN_WORD: u32 = 60;
const NAME_WORD: u32 = 50;
const WHAT_WORD: u32 = 45;
const FAMILY_WORD: u32 = 30;
const ABOUT_WORD: u32 = 25;
/// What was typed begins a word, or is found inside one.
const BEGINS: u32 = 15;
const INSIDE: u32 = 5;
/// Shorter pieces are not looked for inside of words: "led" is in "called".
const LEAST_INSIDE: usize = 4;
/// Among others, shorter words are near too many to be mended.
const LEAST_MENDED: usize = 5;

impl Doc {
    pub(super) fn new(texts: Texts, ties: Ties) -> Self {
        let Texts {
            label,
            words: own,
            name,
            ids,
            what,
            about,
            of_all,
            source,
        } = texts;
        let mut phrases = vec![(plain(&label), LABEL), (plain(&name), NAME)];
        phrases.extend(own.iter().map(|phrase| (plain(phrase), OWN_PHRASE)));
        phrases.extend(ids.iter().map(|id| (plain(id), NAME)));
        phrases.extend(of_all.iter().map(|phrase| (plain(phrase), FAMILY_PHRASE)));
        // People leave out the CIE.
        if let Some(short) = plain(&name).strip_prefix("cie ") {
            phrases.push((short.to_owned(), NAME));
        }
        phrases.retain(|(phrase, _)| !phrase.is_empty());
        let mut words = Vec::new();
        let mut add = |text: &str, worth: u32| {
            let text = plain(text);
            words.extend(text.split(' ').map(|word| (stem(word).to_owned(), worth)));
        };
        for phrase in own.iter().chain([&label]) {
            add(phrase, OWN_WORD);
        }
        add(&name, NAME_WORD);
        add(&source, NAME_WORD);
        add(&what, WHAT_WORD);
        for phrase in &of_all {
            add(phrase, FAMILY_WORD);
        }
        add(&about, ABOUT_WORD);
        for id in &ids {
            add(id, INSIDE);
        }
        words.retain(|(word, _)| !word.is_empty());
        let inside = [name, source, ids.join(" ")]
            .map(|text| plain(&text))
            .join(" ");
        Self {
            phrases,
            words,
            inside,
            ties,
        }
    }

    /// How well it answers; `None` where a word is not found at all.
    pub(super) fn score(&self, typed: &str) -> Option<Score> {
        let whole = self
            .phrases
            .iter()
            .filter(|(phrase, _)| phrase == typed || stem(phrase) == stem(typed));
        let whole = whole.map(|(_, worth)| *worth).max().unwrap_or(0);
        let mut sum = whole;
        let mut is_found = true;
        for word in typed.split(' ') {
            match self.worth(word) {
                Some(worth) => sum += worth,
                None => is_found = false,
            }
        }
        (is_found || whole > 0).then_some((sum, self.ties))
    }

    /// Whether what was typed is one of its phrases, all of it.
    pub(super) fn is_called(&self, typed: &str) -> bool {
        self.phrases.iter().any(|(phrase, _)| phrase == typed)
    }

    /// Whether a word is found in it.
    pub(super) fn has(&self, word: &str) -> bool {
        self.worth(word).is_some()
    }

    /// The word of it that a word with a typing error is nearest to, and how many errors those are.
    pub(super) fn nearest(&self, word: &str) -> Option<(usize, &str)> {
        let letters = word.chars().count();
        let most = if letters < LEAST_MENDED {
            0
        } else {
            letters / 4
        };
        let all = self.words.iter().map(|(own, _)| own.as_str());
        let errors = all.map(|own| (strsim::osa_distance(word, own), own));
        errors
            .filter(|(errors, _)| (1..=most).contains(errors))
            .min_by_key(|(errors, _)| *errors)
    }

    /// How nearly it is called that: few letters differ, or two are exchanged.
    pub(super) fn nearly(&self, typed: &str) -> Option<Score> {
        let letters = typed.chars().count();
        let most = letters / 4;
        let texts = self.phrases.iter().chain(&self.words);
        let off = texts
            .filter(|(text, _)| text.chars().count().abs_diff(letters) <= most)
            .map(|(text, worth)| (strsim::osa_distance(typed, text), *worth))
            .filter(|(errors, _)| (1..=most).contains(errors));
        let best = off
            .map(|(errors, worth)| worth / (1 + errors as u32))
            .max()?;
        Some((best, self.ties))
    }

    fn worth(&self, word: &str) -> Option<u32> {
        let short = stem(word);
        let exact = self.words.iter().filter(|(own, _)| own == short);
        let begun = self.words.iter().filter(|(own, _)| own.starts_with(short));
        exact
            .map(|(_, worth)| *worth)
            .max()
            .or_else(|| begun.map(|(_, worth)| worth.min(&BEGINS)).copied().max())
            .or_else(|| {
                let is_inside =
                    word.chars().count() >= LEAST_INSIDE || word.contains(char::is_numeric);
                (is_inside && self.inside.contains(word)).then_some(INSIDE)
            })
    }
}

/// Lower case, signs as blanks, one blank at a time.
pub(super) fn plain(text: &str) -> String {
    let lower = text.to_lowercase();
    let signs = |c: char| !c.is_alphanumeric() && c != '.';
    let words: Vec<&str> = lower.split(signs).filter(|word| !word.is_empty()).collect();
    words.join(" ")
}

/// A word without the ending of many.
fn stem(word: &str) -> &str {
    let is_plural = word.len() > 3 && word.ends_with('s') && !word.ends_with("ss");
    if is_plural {
        &word[..word.len() - 1]
    } else {
        word
    }
}
