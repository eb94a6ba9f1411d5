//! What a person reads, in the language that they chose.
//!
//! English stands in the code: `tr!` fills in a sentence, `said!` is a text without figures,
//! `later!` marks one of a table, which [`said`] translates where it is shown. The other languages
//! are files of gettext beside this one; docs/languages.md tells how they are kept.
//!
//! A thread speaks English until it is told otherwise, so the command line, files and whatever is
//! computed apart from the window do. What the window writes for programs is made by
//! [`in_language`] with [`Language::English`].

mod catalogs;
mod numbers;

use std::cell::Cell;

use serde::{Deserialize, Serialize};

#[doc(hidden)]
pub use catalogs::{counted, text};
pub use catalogs::{said, translated};
pub use numbers::{fixed, signed, with_sign};

/// A language of the window.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Language {
    #[default]
    #[serde(rename = "en")]
    English,
    #[serde(rename = "de")]
    German,
    #[serde(rename = "es")]
    Spanish,
    #[serde(rename = "fr")]
    French,
}

impl Language {
    pub const ALL: [Self; 4] = [Self::English, Self::German, Self::Spanish, Self::French];

    /// Its code of ISO 639-1.
    pub fn code(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::German => "de",
            Self::Spanish => "es",
            Self::French => "fr",
        }
    }

    /// Its name as its speakers write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::English => "English",
            Self::German => "Deutsch",
            Self::Spanish => "Español",
            Self::French => "Français",
        }
    }

    /// The language of a system's locale, such as `de_AT.UTF-8` or `fr-CA`.
    pub fn of_locale(locale: &str) -> Option<Self> {
        let code = locale.split(['_', '-', '.', '@']).next()?;
        let is_it = |language: &Self| language.code().eq_ignore_ascii_case(code);
        Self::ALL.into_iter().find(is_it)
    }

    /// The language that the system, or the browser, is set to; English for every other one.
    pub fn of_system() -> Self {
        let locale = sys_locale::get_locale();
        locale
            .as_deref()
            .and_then(Self::of_locale)
            .unwrap_or_default()
    }

    /// Stands between a number's whole part and its decimals.
    pub fn decimal_sign(self) -> char {
        match self {
            Self::English => '.',
            _ => ',',
        }
    }
}

thread_local! {
    static SPOKEN: Cell<Language> = const { Cell::new(Language::English) };
    static DECIMAL_COMMAS: Cell<bool> = const { Cell::new(false) };
}

/// Whether tables that this thread writes have decimal commas.
pub fn has_decimal_commas() -> bool {
    DECIMAL_COMMAS.get()
}

/// Has tables that this thread writes have decimal commas, or points again.
pub fn write_decimal_commas(are_wanted: bool) {
    DECIMAL_COMMAS.set(are_wanted);
}

/// The language that this thread speaks.
pub fn spoken() -> Language {
    SPOKEN.get()
}

/// Has this thread speak a language from now on.
pub fn speak(language: Language) {
    SPOKEN.set(language);
}

/// What is made while this thread speaks a language; then it speaks its own again.
pub fn in_language<T>(language: Language, make: impl FnOnce() -> T) -> T {
    struct Back(Language, bool);
    impl Drop for Back {
        fn drop(&mut self) {
            SPOKEN.set(self.0);
            DECIMAL_COMMAS.set(self.1);
        }
    }
    let _back = Back(spoken(), has_decimal_commas());
    speak(language);
    make()
}

/// A sentence in the language spoken, filled in: as `tr!` of the crate of that name, whose formatting
/// it has, but without a copy of how a text is found at each of its thousands of uses.
#[macro_export]
macro_rules! tr {
    ($english:tt) => {
        ::tr::runtime_format!($crate::languages::text($english, None))
    };
    ($english:tt, $($filled:tt)*) => {
        ::tr::runtime_format!($crate::languages::text($english, None), $($filled)*)
    };
    ($meaning:tt => $english:tt) => {
        ::tr::runtime_format!($crate::languages::text($english, Some($meaning)))
    };
    ($one:tt | $several:tt % $n:expr) => {{
        let n = $n;
        ::tr::runtime_format!($crate::languages::counted(n as u64, $one, $several), n)
    }};
    ($one:tt | $several:tt % $n:expr, $($filled:tt)*) => {{
        let n = $n;
        ::tr::runtime_format!($crate::languages::counted(n as u64, $one, $several), $($filled)*, n = n)
    }};
}

/// A text without figures in the language spoken, as a `&'static str`.
#[macro_export]
macro_rules! said {
    ($english:literal) => {
        $crate::languages::said($english)
    };
}

/// Marks a text in a table that is made once: it stays English, and is translated by
/// [`languages::said`](crate::languages::said) where it is shown.
#[macro_export]
macro_rules! later {
    ($english:literal) => {
        $english
    };
}

/// A name and what is told of it: "FL2: 4220 K", with the language's own colon.
pub fn with_colon(name: impl std::fmt::Display, what: impl std::fmt::Display) -> String {
    tr!("{name}: {what}", name, what)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_system_in_one_of_the_languages_is_understood() {
        for (locale, language) in [
            ("de_AT.UTF-8", Some(Language::German)),
            ("fr-CA", Some(Language::French)),
            ("es", Some(Language::Spanish)),
            ("en_GB", Some(Language::English)),
            ("C", None),
            ("", None),
            ("dense", None),
        ] {
            assert_eq!(Language::of_locale(locale), language, "{locale}");
        }
    }

    #[test]
    fn a_language_is_spoken_for_as_long_as_it_is_asked_for() {
        assert_eq!(spoken(), Language::English);
        let sign = in_language(Language::German, || spoken().decimal_sign());
        assert_eq!((sign, spoken()), (',', Language::English));
        let apart = in_language(Language::French, || std::thread::spawn(spoken).join());
        assert_eq!(apart.expect("no panic"), Language::English);
    }
}
