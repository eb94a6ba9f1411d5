//! A closed list of a few things to choose from.

use eframe::egui;
use egui::{ComboBox, Ui, WidgetText};

use super::named;

/// A closed list with its name for screen readers and what it is for on hover.
#[derive(Clone, Copy, Debug)]
pub struct Choice<'a> {
    /// What screen readers call it; also its place in the window, so a name once a page.
    pub name: &'a str,
    /// What it is for, a sentence.
    pub meaning: &'a str,
    /// Width of the closed list, points.
    pub width: f32,
}

impl Choice<'_> {
    /// Draws the list with what is chosen on it; `list` draws its items while it is open.
    pub fn show(self, ui: &mut Ui, chosen: impl Into<WidgetText>, list: impl FnOnce(&mut Ui)) {
        self.draw(ui, chosen, false, list);
    }

    /// Draws the list of all that can be chosen, each by title and meaning, which may be empty.
    pub fn pick<T: Copy + PartialEq>(
        self,
        ui: &mut Ui,
        now: &mut T,
        all: impl IntoIterator<Item = T>,
        words: impl Fn(T) -> (&'static str, &'static str),
    ) {
        self.show(ui, words(*now).0, |ui| {
            for one in all {
                let (title, meaning) = words(one);
                let item = ui.selectable_value(now, one, title);
                if !meaning.is_empty() {
                    item.on_hover_text(meaning);
                }
            }
        });
    }

    /// The same for names of any length, cut to the width.
    pub fn cut(self, ui: &mut Ui, chosen: impl Into<WidgetText>, list: impl FnOnce(&mut Ui)) {
        self.draw(ui, chosen, true, list);
    }

    fn draw(
        self,
        ui: &mut Ui,
        chosen: impl Into<WidgetText>,
        cut: bool,
        list: impl FnOnce(&mut Ui),
    ) {
        let combo = ComboBox::from_id_salt(self.name)
            .selected_text(chosen)
            .width(self.width);
        let combo = if cut { combo.truncate() } else { combo };
        let response = combo.show_ui(ui, list).response;
        named(&response, egui::Role::ComboBox, self.name);
        response.on_hover_text(self.meaning);
    }
}
