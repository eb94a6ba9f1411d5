//! Small windows over the window: a path to type, the shortcuts, About.

use std::path::{Path, PathBuf};

use eframe::egui;
use egui::{Context, Ui};

use super::keys::{GROUPS, SHORTCUTS};
use crate::{
    app::{
        Library,
        licences::{self, Licence},
    },
    languages::said,
};

/// The small window that is open.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Dialog {
    OpenPath(String),
    /// A path to save to, and what is waiting to be saved there.
    SavePath(String),
    /// The list of shortcuts.
    Shortcuts,
    /// About; the licence being read, if one is.
    About(Option<usize>),
}

/// What a small window came to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Outcome {
    /// Still open.
    Open,
    /// Closed without a word.
    Closed,
    OpenPath(PathBuf),
    SavePath(PathBuf),
}

/// What a small window leaves free of the large one: its own edges, its title and its buttons.
const AROUND: egui::Vec2 = egui::vec2(40.0, 110.0);

pub(super) fn show(context: &Context, dialog: &mut Dialog) -> Outcome {
    let title = match dialog {
        Dialog::OpenPath(_) => said!("Open a file or a folder"),
        Dialog::SavePath(_) => said!("Save to a file"),
        Dialog::Shortcuts => said!("Shortcuts"),
        Dialog::About(_) => said!("About Spectral Explorer"),
    };
    let mut outcome = Outcome::Open;
    let modal = egui::Modal::new(egui::Id::unique("dialog")).show(context, |ui| {
        let room = context.content_rect().size() - AROUND;
        let most = match dialog {
            Dialog::Shortcuts => 760.0,
            _ => 620.0,
        };
        ui.set_max_width(room.x.min(most));
        ui.heading(title);
        ui.add_space(4.0);
        match dialog {
            Dialog::OpenPath(text) => path_field(
                ui,
                text,
                (said!("Open it"), false),
                &mut outcome,
                Outcome::OpenPath,
            ),
            Dialog::SavePath(text) => path_field(
                ui,
                text,
                (said!("Save"), true),
                &mut outcome,
                Outcome::SavePath,
            ),
            Dialog::Shortcuts => {
                egui::ScrollArea::both()
                    .max_height(room.y)
                    .show(ui, shortcuts);
            }
            Dialog::About(reading) => {
                egui::ScrollArea::vertical()
                    .max_height(room.y)
                    .show(ui, |ui| about(ui, reading));
            }
        }
        if matches!(dialog, Dialog::Shortcuts | Dialog::About(_)) {
            ui.add_space(6.0);
            if ui.button(said!("Close")).clicked() {
                outcome = Outcome::Closed;
            }
        }
    });
    if modal.should_close() && outcome == Outcome::Open {
        outcome = Outcome::Closed;
    }
    outcome
}

fn path_field(
    ui: &mut Ui,
    text: &mut String,
    (verb, writes): (&str, bool),
    outcome: &mut Outcome,
    chosen: impl Fn(PathBuf) -> Outcome,
) {
    let label = ui.label(said!("Path of the file"));
    let field = ui
        .add(egui::TextEdit::singleline(text).desired_width(480.0_f32.min(ui.available_width())))
        .labelled_by(label.id);
    // Elsewhere the system asks before a file is lost; here a button that says so is pressed.
    let is_there = writes && Path::new(text.trim()).is_file();
    if is_there {
        ui.label(said!("A file of this name is there already."));
    }
    // Nothing that was typed is lost.
    let is_missing = !writes && !text.trim().is_empty() && !Path::new(text.trim()).exists();
    if is_missing {
        ui.label(said!("No file or folder is called that."));
    }
    let verb = if is_there { said!("Replace it") } else { verb };
    let entered = !is_there && field.lost_focus() && ui.input(|i| i.key_pressed(egui::Key::Enter));
    if !field.has_focus() && !entered {
        field.request_focus();
    }
    ui.horizontal(|ui| {
        let ready = !text.trim().is_empty() && !is_missing;
        let pressed = ui.add_enabled(ready, egui::Button::new(verb)).clicked();
        if ready && (pressed || entered) {
            *outcome = chosen(PathBuf::from(text.trim()));
        }
        if ui.button(said!("Cancel")).clicked() {
            *outcome = Outcome::Closed;
        }
    });
}

/// What the pointer does, behind the keys.
const POINTER: [(&str, &str); 7] = [
    (
        later!("Wheel"),
        later!("Zoom the wavelengths around the pointer"),
    ),
    (
        later!("Drag, right drag"),
        later!("Move the view, zoom into a box"),
    ),
    (later!("Double click"), later!("Fit the view")),
    (later!("Right click"), later!("Save, copy or print a plot")),
    (later!("Drag a line"), later!("Move it, change its height")),
    (later!("Shift + double click"), later!("Add a line")),
    (
        later!("Ctrl or Shift + click"),
        later!("Compare with a spectrum of the library"),
    ),
];

/// Width of a window from which the groups stand in two columns, points.
const TWO_COLUMNS: f32 = 640.0;

fn shortcuts(ui: &mut Ui) {
    let (left, right) = GROUPS.split_at(3);
    if ui.available_width() >= TWO_COLUMNS {
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| keys(ui, left));
            ui.add_space(24.0);
            ui.vertical(|ui| {
                keys(ui, right);
                pointer(ui);
            });
        });
    } else {
        keys(ui, &GROUPS);
        pointer(ui);
    }
}

fn group(ui: &mut Ui, title: &str, rows: impl Iterator<Item = (String, &'static str)>) {
    ui.label(egui::RichText::new(title).strong());
    egui::Grid::new(("shortcuts", title))
        .striped(true)
        .min_col_width(112.0)
        .show(ui, |ui| {
            for (keys, words) in rows {
                ui.monospace(keys);
                ui.label(words);
                ui.end_row();
            }
        });
    ui.add_space(8.0);
}

fn keys(ui: &mut Ui, groups: &[&'static str]) {
    for &title in groups {
        let of_it = SHORTCUTS.iter().filter(|(_, act, _)| act.group() == title);
        let context = ui.ctx().clone();
        let rows = of_it.map(|&(keys, _, words)| (context.format_shortcut(&keys), said(words)));
        group(ui, said(title), rows);
    }
}

fn pointer(ui: &mut Ui) {
    let rows = POINTER
        .iter()
        .map(|&(keys, words)| (said(keys).to_owned(), said(words)));
    let rows =
        std::iter::once((said!("Tab").to_owned(), said!("From control to control"))).chain(rows);
    group(ui, said!("Pointer and Tab"), rows);
}

fn about(ui: &mut Ui, reading: &mut Option<usize>) {
    ui.label(tr!(
        "Version {version}. It opens light spectra and shows their parts: a smooth part and a few \
         lines, the composite model of Sun, Fracchia and Drew (2000).",
        version = env!("CARGO_PKG_VERSION")
    ));
    ui.add_space(4.0);
    let all: &[Licence] = licences::all();
    ui.horizontal_wrapped(|ui| {
        ui.selectable_value(reading, None, said!("Licences of all parts"));
        for (index, licence) in all.iter().enumerate() {
            ui.selectable_value(reading, Some(index), licence.id)
                .on_hover_text(said(licence.title));
        }
    });
    let overview;
    let text = match reading.and_then(|i| all.get(i)) {
        Some(licence) => licence.text,
        None => {
            overview = licences::overview(Library::bundled());
            &overview
        }
    };
    egui::ScrollArea::vertical()
        .max_height(380.0)
        .show(ui, |ui| {
            ui.small(printable(text));
        });
}

/// Tabs and form feeds as spaces: fonts have no glyph for them.
fn printable(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '\n' => '\n',
            c if c.is_control() => ' ',
            c => c,
        })
        .collect()
}
