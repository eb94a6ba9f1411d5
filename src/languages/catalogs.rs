//! The translations: files of gettext, read when their language is first spoken.

use std::{
    borrow::Cow,
    sync::{LazyLock, Once},
};

use tr::{PoTranslator, Translator};

use super::{Language, spoken};

static GERMAN: LazyLock<PoTranslator> = LazyLock::new(|| read(include_str!("de.po")));
static SPANISH: LazyLock<PoTranslator> = LazyLock::new(|| read(include_str!("es.po")));
static FRENCH: LazyLock<PoTranslator> = LazyLock::new(|| read(include_str!("fr.po")));

fn read(file: &str) -> PoTranslator {
    PoTranslator::from_vec_u8(file.as_bytes().to_vec()).expect("a test reads every file")
}

/// The texts of a language; none for English, which stands in the code.
fn texts() -> Option<&'static PoTranslator> {
    match spoken() {
        Language::English => None,
        Language::German => Some(&GERMAN),
        Language::Spanish => Some(&SPANISH),
        Language::French => Some(&FRENCH),
    }
}

/// A text without figures in the language spoken.
pub fn said(english: &'static str) -> &'static str {
    // The empty text is the head of a file.
    let texts = texts().filter(|_| !english.is_empty());
    match texts.map(|texts| texts.translate(english, None)) {
        Some(Cow::Borrowed(text)) => text,
        _ => english,
    }
}

/// The same of a text that is known only as the program runs, such as a name in a file.
pub fn translated(english: &str) -> Cow<'_, str> {
    let texts = texts().filter(|_| !english.is_empty());
    texts.map_or(Cow::Borrowed(english), |texts| {
        texts.translate(english, None)
    })
}

/// Answers [`tr!`](tr::tr) on each thread in the language that it speaks.
struct Spoken;

impl Translator for Spoken {
    fn translate<'a>(&'a self, text: &'a str, context: Option<&'a str>) -> Cow<'a, str> {
        texts().map_or(Cow::Borrowed(text), |texts| texts.translate(text, context))
    }

    fn ntranslate<'a>(
        &'a self,
        n: u64,
        one: &'a str,
        many: &'a str,
        context: Option<&'a str>,
    ) -> Cow<'a, str> {
        match texts() {
            Some(texts) => texts.ntranslate(n, one, many, context),
            None => Cow::Borrowed(if n == 1 { one } else { many }),
        }
    }
}

/// Has the answers of this file be used.
pub(super) fn hear() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| set_translator!(Spoken));
}
