//! The page "Glossary": the words of the window, to look through and to search.

use eframe::egui;
use egui::{Align, Label, Layout, RichText, Ui};

use crate::{
    app::{
        glossary::{WORDS, Word},
        search::unaccented,
    },
    ui::{
        kit::{GROUP, headline, rolled, text_field},
        theme::Theme,
    },
};

/// What is searched for.
#[derive(Default)]
pub(super) struct GlossaryView {
    search: String,
}

/// Least and greatest width of a column of words, points.
const COLUMN: [f32; 2] = [480.0, 720.0];

fn explained(ui: &mut Ui, word: &Word) {
    let strong = ui.visuals().strong_text_color();
    ui.label(RichText::new(word.word()).color(strong));
    ui.add(Label::new(word.means()).wrap());
    ui.add_space(6.0);
}

impl GlossaryView {
    pub(super) fn show(&mut self, ui: &mut Ui, theme: Theme) {
        let count = WORDS.len();
        let words = tr!("{n} words of this window, in plain sentences."
            | "{n} words of this window, in plain sentences." % count);
        headline(ui, theme, words);
        let words = [said!("Search the glossary"), said!("Search words")];
        let width = ui.available_width().min(260.0);
        text_field(ui, &mut self.search, words, width);
        let wanted = unaccented(self.search.trim());
        let fits = |text: &str| wanted.is_empty() || unaccented(text).contains(&wanted);
        ui.add_space(6.0);
        rolled(ui, |ui| {
            let mut found: Vec<&Word> = WORDS
                .iter()
                .filter(|w| fits(w.word()) || fits(w.means()))
                .collect();
            found.sort_by_key(|word| unaccented(word.word()));
            if found.is_empty() {
                ui.weak(said!("No word has that in it."));
                return;
            }
            let [least, most] = COLUMN.map(|width| width * theme.scale);
            let columns = (ui.available_width() / least).floor().max(1.0);
            ui.set_max_width(ui.available_width().min(columns * most));
            let columns = columns as usize;
            ui.spacing_mut().item_spacing.x = GROUP;
            ui.columns(columns, |uis| {
                for (ui, words) in uis
                    .iter_mut()
                    .zip(found.chunks(found.len().div_ceil(columns)))
                {
                    // Columns would spread each line over their whole width.
                    ui.with_layout(Layout::top_down(Align::Min), |ui| {
                        words.iter().for_each(|word| explained(ui, word));
                    });
                }
            });
        });
    }
}
