//! The library: shelves of spectra, each with a swatch, a name and a small curve.

mod headings;
mod menu;
mod rows;

use std::sync::Arc;

use eframe::egui;
use egui::{Key, Response, Sense, Ui, Vec2, vec2};

use self::{
    headings::{describe, favourites_row, file_heading, heading},
    rows::{Listed, Row, fold_of},
};
use super::{
    entry_row::{Painted, row_name},
    kit::{named, named_choice, pressed_small, sign_button, text_field},
    theme::Theme,
};
use crate::{
    app::{App, Command, Entry, chart::Ink, workspace::Preferences},
    languages::translated,
    spectrum::Kind,
};

/// What the library remembers between frames.
#[derive(Default)]
pub(super) struct LibraryView {
    pub search: String,
    /// The search field is to get the keyboard in the next frame.
    pub wants_search: bool,
    /// The own entry whose file is to be looked at.
    pub wants_reading: Option<String>,
    /// Keys of the lights whose quality is to be compared.
    pub wants_quality: Vec<String>,
    /// The own entry whose file is to be followed.
    pub wants_following: Option<String>,
    /// A click lays a spectrum over the one that is shown.
    compares: bool,
    /// The own entry being renamed, with the text so far.
    renaming: Option<(String, String)>,
    listed: Listed,
    /// The row that Enter takes, of those that a search found.
    at: usize,
    /// The button that closes it was clicked.
    pub closes: bool,
}

/// Indent of a file's spectra, points.
const INDENT: f32 = 10.0;

/// What a row asked for.
enum Wish {
    Command(Command),
    Fold(String),
}

impl LibraryView {
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        app: &App,
        preferences: &mut Preferences,
        (theme, compares): (Theme, bool),
        commands: &mut Vec<Command>,
    ) {
        self.compares = compares;
        ui.horizontal(|ui| {
            let words = if compares {
                said!("Compare with")
            } else {
                said!("Library")
            };
            ui.label(egui::RichText::new(words).heading());
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let meaning = said!("Closes the library (Esc, Ctrl+L).");
                self.closes = sign_button(ui, "✕", said!("Close the library"), meaning);
                ui.toggle_value(&mut preferences.pinned, said!("Pin"))
                    .on_hover_text(said!("The library stays open beside the page."));
            });
        });
        let search = self.search_field(ui);
        let searches = !self.search.trim().is_empty();
        if !searches {
            favourites_row(ui, app, theme, self.compares, commands);
        }
        let rows = self.listed.rows(ui, &self.search, app, preferences);
        if rows.is_empty() {
            ui.add_space(8.0);
            ui.weak(said!("Nothing found. Try: LED, candle, 4000 K, sodium."));
            return;
        }
        if search.changed() {
            self.at = 0;
        }
        let lights = lights_together(if searches { &rows } else { &[] }, app);
        if lights.len() > 1 {
            let words = tr!("Compare the quality of {n} light"
                | "Compare the quality of {n} lights" % lights.len());
            let meaning = said!(
                "White, colour rendering and efficacy of each, sorted as you like. Search for \
                 lights, or choose some by Ctrl and click."
            );
            if pressed_small(ui, &words, meaning) {
                self.wants_quality = lights.iter().map(|light| light.key.clone()).collect();
            }
        }
        let typing = search.has_focus() || search.lost_focus();
        let chosen = searches && self.keys(ui, typing, rows.len());
        if chosen && let Some(Row::Item { entry, .. }) = rows.get(self.at) {
            commands.push(taken(app, entry, self.compares));
        }
        let height = (ROW * theme.scale).round() - ui.spacing().item_spacing.y;
        let mut wish = None;
        let list = egui::ScrollArea::vertical().auto_shrink(false);
        list.show_rows(ui, height, rows.len(), |ui, range| {
            for place in range {
                let size = vec2(ui.available_width(), height);
                let is_next = searches && place == self.at;
                let asked = self.row(ui, size, &rows[place], is_next, (app, theme));
                wish = asked.or(wish.take());
            }
        });
        match wish {
            Some(Wish::Command(command)) => commands.push(command),
            Some(Wish::Fold(title)) => {
                let folded = &mut preferences.folded;
                match folded.iter().position(|f| *f == title) {
                    Some(index) => drop(folded.remove(index)),
                    None => folded.push(title),
                }
            }
            None => {}
        }
    }

    fn search_field(&mut self, ui: &mut Ui) -> Response {
        let words = [said!("Search the library"), said!("Search spectra")];
        let mut search = text_field(ui, &mut self.search, words, f32::INFINITY);
        // While one types it would lie over the first that is found.
        if !search.has_focus() {
            search = search.on_hover_text(said!(
                "A name, a family, an element, a use: \"street lamp\", neon, skin (Ctrl+F). Enter \
                 shows the first."
            ));
        }
        if std::mem::take(&mut self.wants_search) {
            search.request_focus();
        }
        search
    }

    /// Draws a row; what it asks for.
    fn row(
        &mut self,
        ui: &mut Ui,
        size: Vec2,
        row: &Row,
        is_next: bool,
        looks: (&App, Theme),
    ) -> Option<Wish> {
        match row {
            Row::Heading {
                title,
                count,
                folded,
            } => heading(ui, size, translated(title), *count, *folded)
                .then(|| Wish::Fold(title.clone())),
            Row::File {
                name,
                count,
                folded,
            } => file_heading(ui, size, name, *count, *folded).then(|| Wish::Fold(fold_of(name))),
            Row::Item { entry, in_file } => self
                .item(ui, size, (entry, *in_file), is_next, looks)
                .map(Wish::Command),
        }
    }

    /// Escape gives up a new name, then the search; whether there was either.
    pub(super) fn escaped(&mut self) -> bool {
        if self.renaming.is_some() {
            return true;
        }
        !std::mem::take(&mut self.search).is_empty()
    }

    /// Moves the chosen row by the arrows while a search is typed; whether Enter was pressed.
    fn keys(&mut self, ui: &Ui, typing: bool, count: usize) -> bool {
        if !typing {
            return false;
        }
        let [up, down, enter] =
            [Key::ArrowUp, Key::ArrowDown, Key::Enter].map(|key| ui.input(|i| i.key_pressed(key)));
        if down {
            self.at += 1;
        }
        if up {
            self.at = self.at.saturating_sub(1);
        }
        self.at = self.at.min(count.saturating_sub(1));
        enter
    }

    fn item(
        &mut self,
        ui: &mut Ui,
        size: Vec2,
        (entry, in_file): (&Arc<Entry>, Option<[usize; 2]>),
        is_next: bool,
        (app, theme): (&App, Theme),
    ) -> Option<Command> {
        let document = app.document();
        let is_light = document.light.key == entry.key;
        let is_factor = document.factor.as_ref().is_some_and(|f| f.key == entry.key);
        let selected = is_light || is_factor;
        let overlay = document.overlays.iter().position(|o| o.key == entry.key);
        let overlaid = overlay.is_some();
        if let Some((key, text)) = &mut self.renaming
            && *key == entry.key
        {
            let edit = ui.add_sized(size, egui::TextEdit::singleline(text));
            let id = edit.id;
            named(&edit, egui::Role::TextInput, said!("New name"));
            if edit.lost_focus() {
                let (key, name) = self.renaming.take()?;
                let name = name.trim().to_owned();
                let refused = name.is_empty() || ui.input(|i| i.key_pressed(egui::Key::Escape));
                return (!refused).then_some(Command::Rename { key, name });
            }
            ui.memory_mut(|m| m.request_focus(id));
            return None;
        }
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        named_choice(&response, egui::Role::Button, selected, &row_name(entry));
        let visuals = ui.visuals();
        if selected {
            ui.painter()
                .rect_filled(rect, 3.0, visuals.selection.bg_fill);
        } else if response.hovered() || response.has_focus() || is_next {
            ui.painter()
                .rect_filled(rect, 3.0, visuals.widgets.hovered.bg_fill);
        }
        let text_colour = if selected {
            visuals.selection.stroke.color
        } else {
            visuals.text_color()
        };
        let is_second = document.second.as_ref().is_some_and(|s| s.key == entry.key);
        let mark = overlay.map(Ink::Overlay);
        let mark = is_second.then_some(Ink::Second).or(mark);
        let marked = mark.map(|mark| theme.ink(mark));
        let painted = Painted {
            indent: in_file.map_or(0.0, |_| INDENT * theme.scale),
            common: in_file.unwrap_or_default(),
            marked,
            ink: text_colour,
            faint: if selected { text_colour } else { theme.faint },
            scale: theme.scale,
        };
        painted.show(ui, rect, entry);
        let over = ui.input(|i| i.modifiers.command || i.modifiers.shift);
        let mut command = None;
        if response.clicked() {
            command = Some(match over && !self.compares {
                true => Command::ToggleOverlay(entry.clone()),
                false => taken(app, entry, self.compares),
            });
        }
        response.context_menu(|ui| {
            if let Some(chosen) = self.menu(ui, app, entry, overlaid) {
                command = Some(chosen);
            }
        });
        response.on_hover_ui(|ui| describe(ui, entry));
        command
    }
}

/// The lights that were found; where nothing was searched, those that are shown.
fn lights_together<'a>(found: &'a [Row], app: &'a App) -> Vec<&'a Arc<Entry>> {
    let document = app.document();
    let items = found.iter().filter_map(|row| match row {
        Row::Item { entry, .. } => Some(entry),
        _ => None,
    });
    let shown = std::iter::once(&document.light).chain(document.laid_over());
    let shown = shown.filter(|_| found.is_empty() && document.is_about_light());
    let all = items.chain(shown);
    all.filter(|entry| entry.kind() == Kind::Light).collect()
}

/// What a spectrum that was chosen does: it is shown, or compared with what is shown. A light that
/// is compared already is let go of.
fn taken(app: &App, entry: &Arc<Entry>, compares: bool) -> Command {
    let document = app.document();
    let is_light = entry.kind() == Kind::Light && document.is_about_light();
    match compares {
        true if is_light => {
            let now = document.second.as_ref();
            let is_second = now.is_some_and(|second| second.key == entry.key);
            Command::Compare((!is_second).then(|| entry.clone()))
        }
        true => Command::ToggleOverlay(entry.clone()),
        false => Command::Show(entry.clone()),
    }
}

/// Height of a row, points.
const ROW: f32 = 40.0;
