//! What is asked of a page.

use super::{Page, Place, ROWS, Row};
use crate::languages::said;

impl Page {
    /// Every page, place by place.
    pub fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| row.page)
    }

    fn row(self) -> &'static Row {
        let found = ROWS.iter().find(|row| row.page == self);
        found.unwrap_or(&ROWS[0])
    }

    /// Where it is.
    pub fn place(self) -> Place {
        self.row().place
    }

    /// The page whose tab it stands under.
    pub fn tab(self) -> Self {
        self.row().tab
    }

    /// The pages under the same tab: modes of one another.
    pub fn modes(self) -> impl Iterator<Item = Self> {
        let tab = self.tab();
        let under = move |row: &&Row| row.tab == tab;
        ROWS.iter().filter(under).map(|row| row.page)
    }

    pub fn title(self) -> &'static str {
        said(self.row().title)
    }

    /// What the page is for, a sentence.
    pub fn meaning(self) -> &'static str {
        said(self.row().meaning)
    }

    /// What it is called among the modes of its tab.
    pub fn mode(self) -> &'static str {
        said(self.row().mode)
    }

    /// What the tab is called whose first page it is.
    pub fn tab_title(self) -> &'static str {
        said(self.row().tab_title)
    }

    /// The name of the lesson that answers what it asks; none in Learn, where all of them are.
    pub fn lesson(self) -> Option<&'static str> {
        Some(self.row().lesson).filter(|name| !name.is_empty())
    }

    /// The word used on the command line.
    pub fn word(self) -> &'static str {
        self.row().word
    }

    /// The page of a word of this or an earlier version: `products/chain` was one.
    pub fn of_word(word: &str) -> Option<Self> {
        let word = word.strip_prefix("products/").unwrap_or(word);
        let is_it = |row: &&Row| row.word == word || row.old.contains(&word);
        ROWS.iter().find(is_it).map(|row| row.page)
    }

    /// Whether it asks about the model: then its verdict and its knobs stand beside it. Dark lines
    /// are asked for of a light, often of another than the window's.
    pub fn has_model(self) -> bool {
        match self.place() {
            Place::Look => self != Self::Absorption,
            place => place == Place::Numbers,
        }
    }

    /// Whether the model acts on what it shows, though it asks something else: then one line tells of
    /// it and leads to its knobs.
    pub fn has_model_line(self) -> bool {
        match self.place() {
            // What light does to surfaces is told of lights as measured.
            Place::Through => !matches!(self, Self::TwoLights | Self::Metamers),
            _ => self == Self::QualityOrder,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every page there is: serde names them all where it refuses one.
    fn every_page() -> Vec<Page> {
        let refused = serde_json::from_str::<Page>("\"?\"").expect_err("no page");
        let refused = refused.to_string();
        let names = refused.split('`').skip(3).step_by(2);
        names
            .map(|name| serde_json::from_str(&format!("\"{name}\"")).expect("a page"))
            .collect()
    }

    #[test]
    fn every_page_has_one_row_and_every_place_at_most_five_tabs() {
        let all = every_page();
        assert_eq!(
            all.len(),
            ROWS.len(),
            "a page without a row, or a row twice"
        );
        for page in all {
            assert_eq!(page.row().page, page);
            assert_eq!(Page::of_word(page.word()), Some(page));
            assert_eq!(page.tab().place(), page.place());
            assert!(page.modes().any(|mode| mode == page));
        }
        for place in Place::ALL {
            let tabs = place.tabs().count();
            assert!((1..=5).contains(&tabs), "{}", place.title());
            assert_eq!(place.first().place(), place);
        }
        let mut words: Vec<&str> = Page::all().map(Page::word).collect();
        words.sort_unstable();
        words.dedup();
        assert_eq!(words.len(), ROWS.len());
    }

    #[test]
    fn words_of_earlier_versions_lead_to_the_same_page() {
        for (old, page) in [
            ("spectrum", Page::Spectrum),
            ("coefficients", Page::Coefficients),
            ("products", Page::Chain),
            ("products/forming", Page::Resampling),
            ("products/lights", Page::TwoLights),
            ("products/check", Page::SameSurface),
            ("products/absorption", Page::Absorption),
        ] {
            assert_eq!(Page::of_word(old), Some(page), "{old}");
        }
        assert_eq!(Page::of_word("home"), None);
    }
}
