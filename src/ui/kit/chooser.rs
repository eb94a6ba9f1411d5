//! A list of spectra to choose one from: the library's rows under its headings, and its search.

use std::sync::Arc;

use eframe::egui;
use egui::{Align2, ComboBox, Key, PopupCloseBehavior, ScrollArea, Sense, Ui, Vec2, vec2};

use super::{kept, named, text_field};
use crate::{
    app::{App, Entry, Families, search::Index},
    languages::said,
    preset::Shelf,
    spectrum::Kind,
    ui::entry_row::Painted,
};

/// Rows that the open list shows at a time.
const ROWS: f32 = 8.0;

/// Height of a row with what stands between two, points.
const ROW: f32 = 40.0;

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
        named(&combo.response, egui::Role::ComboBox, self.name);
        combo.response.on_hover_text(self.meaning);
        chosen
    }

    fn list(&self, ui: &mut Ui, app: &App, search: &mut String) -> Option<Arc<Entry>> {
        ui.set_min_width(320.0_f32.max(self.width));
        let name = tr!("Search: {what}", what = self.name);
        let hint = said!("Name, element, use; Enter takes the first");
        let edit = text_field(ui, search, [&name, hint], f32::INFINITY);
        let entered = edit.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
        if ui.memory(|m| m.focused().is_none()) {
            edit.request_focus();
        }
        let rows = match search.trim().is_empty() {
            true => shelves(app, self.offers),
            false => {
                let found = found(ui.ctx(), app, search).into_iter();
                let found = found.filter(|entry| (self.offers)(entry));
                found.map(Line::Entry).collect()
            }
        };
        let first = rows.iter().find_map(|row| match row {
            Line::Entry(entry) => Some(entry.clone()),
            Line::Heading(_) => None,
        });
        if first.is_none() {
            ui.weak(said!("Nothing found. Try: LED, candle, 4000 K, sodium."));
        }
        if entered {
            return first;
        }
        let mut chosen = None;
        ScrollArea::vertical()
            .max_height(ROWS * ROW)
            .auto_shrink([false, true])
            .show_rows(
                ui,
                ROW - ui.spacing().item_spacing.y,
                rows.len(),
                |ui, range| {
                    for line in &rows[range] {
                        let size = vec2(ui.available_width(), ROW - ui.spacing().item_spacing.y);
                        match line {
                            Line::Heading(title) => heading(ui, size, said(title)),
                            Line::Entry(entry) if row(ui, size, entry) => {
                                chosen = Some(entry.clone())
                            }
                            Line::Entry(_) => {}
                        }
                    }
                },
            );
        chosen
    }
}

/// One line of the open list.
enum Line {
    Heading(&'static str),
    Entry(Arc<Entry>),
}

/// All that is offered under the library's headings: the user's own first, then filters before
/// surfaces, as they are fewer, by their families: gels, then glasses.
fn shelves(app: &App, offers: fn(&Entry) -> bool) -> Vec<Line> {
    let own = app.document().own.iter().rev();
    let mut offered: Vec<&Arc<Entry>> = own
        .chain(app.bundled())
        .filter(|entry| offers(entry))
        .collect();
    let place = |entry: &Arc<Entry>| {
        let shelf = entry.shelf()?;
        let place = Shelf::ALL.iter().position(|s| *s == shelf)?;
        Some(if shelf == Shelf::Filters {
            (0, Families::shipped().place_of(&entry.key))
        } else {
            (place + 1, None)
        })
    };
    offered.sort_by_cached_key(|entry| place(entry));
    let mut lines = Vec::new();
    let mut before = None;
    for entry in offered {
        let title = entry.shelf().map_or(later!("Your own"), Shelf::heading);
        if before.replace(title) != Some(title) {
            lines.push(Line::Heading(title));
        }
        lines.push(Line::Entry(entry.clone()));
    }
    lines
}

/// Spectra that are told apart by their places in memory, not by their values.
#[derive(Clone)]
struct Very(Vec<Arc<Entry>>);

impl PartialEq for Very {
    fn eq(&self, other: &Self) -> bool {
        are_same(&self.0, &other.0)
    }
}

/// Whether two lists hold the very same spectra.
pub fn are_same(some: &[Arc<Entry>], others: &[Arc<Entry>]) -> bool {
    some.len() == others.len() && some.iter().zip(others).all(|(a, b)| Arc::ptr_eq(a, b))
}

/// What the library's search finds, the best first.
pub fn found(context: &egui::Context, app: &App, search: &str) -> Vec<Arc<Entry>> {
    let own = &app.document().own;
    let id = egui::Id::unique("what is searched");
    let index = kept(context, id, Very(own.clone()), || {
        Arc::new(Index::of(own.iter().chain(app.bundled())))
    });
    let found = index.search(search).into_iter();
    found.map(|row| row.entry).collect()
}

fn heading(ui: &mut Ui, size: Vec2, title: &str) {
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let font = egui::TextStyle::Small.resolve(ui.style());
    let at = rect.left_bottom() - vec2(-4.0, 6.0);
    let colour = ui.visuals().weak_text_color();
    ui.painter()
        .text(at, Align2::LEFT_BOTTOM, title, font, colour);
}

/// A spectrum as in the library; whether it was clicked.
fn row(ui: &mut Ui, size: Vec2, entry: &Arc<Entry>) -> bool {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    named(&response, egui::Role::Button, entry.name());
    let visuals = ui.visuals();
    if response.hovered() || response.has_focus() {
        let fill = visuals.widgets.hovered.bg_fill;
        ui.painter().rect_filled(rect, 3.0, fill);
    }
    let painted = Painted {
        indent: 0.0,
        common: [0; 2],
        marked: None,
        ink: visuals.text_color(),
        faint: visuals.weak_text_color(),
        scale: 1.0,
    };
    painted.show(ui, rect, entry);
    response.on_hover_text(&entry.key).clicked()
}

/// Reflectances and transmittances.
pub fn factors(entry: &Entry) -> bool {
    entry.kind().is_factor()
}

pub fn lights(entry: &Entry) -> bool {
    entry.kind() == Kind::Light
}

/// What light comes off.
pub fn reflectances(entry: &Entry) -> bool {
    entry.kind() == Kind::Reflectance
}

/// What light passes through.
pub fn transmittances(entry: &Entry) -> bool {
    entry.kind() == Kind::Transmittance
}
