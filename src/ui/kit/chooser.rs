//! A list of spectra to choose one from, searched by typing: shipped ones and the user's own.

use std::sync::Arc;

use eframe::egui;
use egui::{ComboBox, PopupCloseBehavior, ScrollArea, TextEdit, Ui};

use crate::app::{App, Entry};

/// Rows that the open list shows at a time.
const ROWS: f32 = 12.0;

/// A list of spectra to choose one from.
#[derive(Clone, Copy)]
pub struct Chooser<'a> {
    /// What screen readers call it; also its place in the window, so a name once a part.
    pub name: &'a str,
    /// What it is for, a sentence.
    pub meaning: &'a str,
    /// What it says when nothing is chosen, or always for a list that only adds.
    pub says: &'a str,
    /// Which spectra it offers.
    pub offers: fn(&Entry) -> bool,
    /// Width of the closed list, points.
    pub width: f32,
}

impl Chooser<'_> {
    /// Draws the list; the spectrum that was chosen in this frame.
    pub fn show(self, ui: &mut Ui, app: &App) -> Option<Arc<Entry>> {
        let search_id = ui.make_persistent_id((self.name, "search"));
        let mut search: String = ui.data_mut(|d| d.get_temp(search_id)).unwrap_or_default();
        let mut chosen = None;
        let combo = ComboBox::from_id_salt(self.name)
            .selected_text(self.says)
            .width(self.width)
            .truncate()
            .height(f32::INFINITY)
            .close_behavior(PopupCloseBehavior::CloseOnClickOutside)
            .show_ui(ui, |ui| {
                chosen = self.list(ui, app, &mut search);
                if chosen.is_some() {
                    ui.close();
                }
            });
        let open = combo.inner.is_some();
        // A list that was closed starts anew.
        if !open || chosen.is_some() {
            search.clear();
        }
        ui.data_mut(|d| d.insert_temp(search_id, search));
        combo
            .response
            .widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, self.name));
        combo.response.on_hover_text(self.meaning);
        chosen
    }

    fn list(&self, ui: &mut Ui, app: &App, search: &mut String) -> Option<Arc<Entry>> {
        ui.set_min_width(280.0_f32.max(self.width));
        let box_name = format!("Search: {}", self.name);
        let edit = ui.add(
            TextEdit::singleline(search)
                .hint_text("Search; files that you open join the list")
                .desired_width(f32::INFINITY),
        );
        edit.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::TextInput, true, box_name.clone())
        });
        if ui.memory(|m| m.focused().is_none()) {
            edit.request_focus();
        }
        let words: Vec<String> = search.split_whitespace().map(str::to_lowercase).collect();
        let matches = |entry: &Entry| {
            let text = format!("{} {}", entry.key, entry.name()).to_lowercase();
            words.iter().all(|word| text.contains(word))
        };
        let own = app.document().own.iter().rev();
        let found: Vec<&Arc<Entry>> = own
            .chain(app.bundled())
            .filter(|entry| (self.offers)(entry) && matches(entry))
            .collect();
        if found.is_empty() {
            ui.weak("Nothing is called that.");
            return None;
        }
        let height = ui.spacing().interact_size.y;
        let mut chosen = None;
        ScrollArea::vertical()
            .max_height(ROWS * (height + ui.spacing().item_spacing.y))
            .auto_shrink([false, true])
            .show_rows(ui, height, found.len(), |ui, range| {
                for entry in &found[range] {
                    let response = ui.add(
                        egui::Button::selectable(false, entry.name())
                            .truncate()
                            .min_size(egui::vec2(ui.available_width(), height)),
                    );
                    if response.on_hover_text(&entry.key).clicked() {
                        chosen = Some((*entry).clone());
                    }
                }
            });
        chosen
    }
}

/// Reflectances and transmittances.
pub fn factors(entry: &Entry) -> bool {
    entry.kind().is_factor()
}

/// Lights.
pub fn lights(entry: &Entry) -> bool {
    entry.kind() == crate::spectrum::Kind::Light
}
