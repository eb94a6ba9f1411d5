//! The palette: lights, places and acts by a few letters.

use std::sync::Arc;

use eframe::egui;
use egui::{Align2, Context, Key, RichText, ScrollArea, vec2};

use super::{
    keys::{Act, SHORTCUTS},
    kit::{self, text_field},
};
use crate::{
    app::{
        App, Entry,
        pages::{Page, Place},
    },
    languages::{said, with_colon},
};

#[derive(Clone, Debug)]
pub(super) enum Chosen {
    /// A spectrum.
    Entry(Arc<Entry>),
    Page(Page),
    /// An act of a key.
    Act(Act),
}

/// The palette, if it is open.
#[derive(Default)]
pub(super) struct PaletteView {
    open: bool,
    text: String,
    at: usize,
}

/// Most that are shown.
const MOST: usize = 12;

/// Width of the list, points.
const WIDTH: f32 = 480.0;

/// The key that does the same.
fn key_of(ui: &egui::Ui, choice: &Chosen) -> Option<String> {
    let act = match choice {
        Chosen::Act(act) => *act,
        Chosen::Page(page) if *page == page.place().first() => {
            let number = Place::ALL.iter().position(|place| *place == page.place());
            Act::Place(number?)
        }
        _ => return None,
    };
    let shortcut = SHORTCUTS.iter().find(|(_, of, _)| *of == act);
    shortcut.map(|(keys, ..)| ui.ctx().format_shortcut(keys))
}

impl PaletteView {
    /// Opens it, empty.
    pub(super) fn open(&mut self) {
        *self = Self {
            open: true,
            ..Self::default()
        };
    }

    /// Whether it has the keys.
    pub(super) fn is_open(&self) -> bool {
        self.open
    }

    /// Draws it; gives what was chosen.
    pub(super) fn show(&mut self, context: &Context, app: &App) -> Option<Chosen> {
        if !self.open {
            return None;
        }
        let mut chosen = None;
        let found = found(context, app, &self.text);
        let (up, down, enter) = context.input(|i| {
            (
                i.key_pressed(Key::ArrowUp),
                i.key_pressed(Key::ArrowDown),
                i.key_pressed(Key::Enter),
            )
        });
        let last = found.len().saturating_sub(1);
        self.at = self.at.min(last);
        if down {
            self.at = (self.at + 1).min(last);
        }
        if up {
            self.at = self.at.saturating_sub(1);
        }
        let id = egui::Id::unique("palette");
        // Its top stays where it is, however many rows there are.
        let down = vec2(0.0, context.content_rect().height() / 8.0);
        let area = egui::Modal::default_area(id).anchor(Align2::CENTER_TOP, down);
        let modal = egui::Modal::new(id).area(area).show(context, |ui| {
            ui.set_width(WIDTH.min(ui.ctx().content_rect().width() - 64.0));
            let words = [
                said!("Find anything"),
                said!("Search lights, pages and commands"),
            ];
            let field = text_field(ui, &mut self.text, words, f32::INFINITY);
            field.request_focus();
            if field.changed() {
                self.at = 0;
            }
            let most = (ui.ctx().content_rect().height() - 96.0).clamp(80.0, 360.0);
            ScrollArea::vertical().max_height(most).show(ui, |ui| {
                ui.set_width(ui.available_width());
                for (row, (name, what, choice)) in found.iter().enumerate() {
                    let key = key_of(ui, choice).unwrap_or_else(|| (*what).to_owned());
                    let button = egui::Button::selectable(row == self.at, name)
                        .right_text(RichText::new(key).small().weak())
                        .truncate()
                        .min_size(vec2(ui.available_width(), 0.0));
                    if ui.add(button).clicked() {
                        chosen = Some(choice.clone());
                    }
                }
                if found.is_empty() {
                    ui.weak(said!("Nothing found. Try: LED, candle, quality, print."));
                }
            });
        });
        if enter && let Some((.., choice)) = found.into_iter().nth(self.at) {
            chosen = Some(choice);
        }
        if modal.should_close() || chosen.is_some() {
            self.open = false;
        }
        chosen
    }
}

/// Pages and commands that have all the words, and the spectra that the library's search finds; those
/// that begin with the text first.
fn found(context: &Context, app: &App, text: &str) -> Vec<(String, &'static str, Chosen)> {
    let wanted: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
    let pages = Page::all().map(|page| {
        let name = with_colon(page.place().title(), page.title());
        (name, said!("page"), Chosen::Page(page))
    });
    let acts = SHORTCUTS
        .iter()
        .filter(|(keys, act, _)| {
            // Redo has two keys.
            let first = SHORTCUTS.iter().find(|(_, of, _)| of == act);
            !matches!(act, Act::Place(_) | Act::Palette) && first.is_some_and(|f| f.0 == *keys)
        })
        .map(|(_, act, words)| (said(words).to_owned(), said!("command"), Chosen::Act(*act)));
    let mut all: Vec<_> = pages.chain(acts).collect();
    all.retain(|(name, ..)| {
        let name = name.to_lowercase();
        wanted.iter().all(|word| name.contains(word))
    });
    let begins = |name: &str| {
        let name = name.to_lowercase();
        wanted
            .first()
            .is_some_and(|word| name.starts_with(word.as_str()))
    };
    // Spectra come as the library's search has them: the best first.
    let entries = kit::found(context, app, text).into_iter().map(|entry| {
        let name = entry.name().to_owned();
        (name, said(entry.kind().word()), Chosen::Entry(entry))
    });
    all.extend(entries);
    all.sort_by_key(|(name, ..)| !begins(name));
    all.truncate(MOST);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spectra_are_found_as_in_the_library_and_pages_by_their_names() {
        let names = |text: &str| -> Vec<String> {
            let found = found(&Context::default(), &App::new(), text);
            found.into_iter().map(|(name, ..)| name).collect()
        };
        let candle = names("Kerze");
        assert!(
            candle.iter().any(|name| name.contains("andle")),
            "{candle:?}"
        );
        // Of a word that is mistyped too.
        assert!(names("flourescent").iter().any(|name| name.contains("FL")));
        assert!(names("metam")[0].contains("Metamers"));
    }
}
