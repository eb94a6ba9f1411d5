//! The page "Glossary": the words of the window, to look through and to search.

use eframe::egui;
use egui::{Label, RichText, Ui};

use crate::{
    app::glossary::WORDS,
    ui::{
        kit::{headline, rolled, text_field},
        theme::Theme,
    },
};

/// What is searched for.
#[derive(Default)]
pub(super) struct GlossaryView {
    search: String,
}

impl GlossaryView {
    pub(super) fn show(&mut self, ui: &mut Ui, theme: Theme) {
        let count = WORDS.len();
        let words = format!("{count} words of this window, in plain sentences.");
        headline(ui, theme, words);
        let words = ["Search the glossary", "Search words"];
        let width = ui.available_width().min(260.0);
        text_field(ui, &mut self.search, words, width);
        let wanted = self.search.trim().to_lowercase();
        let fits = |text: &str| text.to_lowercase().contains(&wanted);
        ui.add_space(6.0);
        rolled(ui, |ui| {
            ui.set_max_width(ui.available_width().min(720.0));
            let mut found = false;
            for one in WORDS.iter().filter(|w| fits(w.word) || fits(w.means)) {
                found = true;
                let strong = ui.visuals().strong_text_color();
                ui.label(RichText::new(one.word).color(strong));
                ui.add(Label::new(one.means).wrap());
                ui.add_space(6.0);
            }
            if !found {
                ui.weak("No word has that in it.");
            }
        });
    }
}
