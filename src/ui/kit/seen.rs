//! How colours under a light are seen: by an eye that is used to it, or by a camera.

use eframe::egui;
use egui::Ui;

use super::Choice;
use crate::{
    app::{App, Command, View},
    color::Adaptation,
};

/// The choice; it holds for patches and pictures everywhere. `name` is what people and tests call
/// it, once a page.
pub fn seen_choice(
    ui: &mut Ui,
    app: &App,
    (name, width): (&str, f32),
    commands: &mut Vec<Command>,
) {
    let view = app.document().view;
    let mut adapt = view.adapt_patches;
    let choice = Choice {
        name,
        meaning: said!(
            "It changes the colours on screen, not the errors. Adaptation after Bradford."
        ),
        width: width.min(ui.available_width()),
    };
    choice.cut(ui, view.adaptation().words(), |ui| {
        for (way, seen) in [(true, Adaptation::ToLight), (false, Adaptation::None)] {
            ui.selectable_value(&mut adapt, way, seen.words());
        }
    });
    if adapt != view.adapt_patches {
        see(app, adapt, commands);
    }
}

/// The same as a switch.
pub fn adapt_box(
    ui: &mut Ui,
    app: &App,
    (name, meaning): (&str, &str),
    commands: &mut Vec<Command>,
) {
    let mut adapt = app.document().view.adapt_patches;
    let switch = ui.checkbox(&mut adapt, name).on_hover_text(meaning);
    if switch.changed() {
        see(app, adapt, commands);
    }
}

fn see(app: &App, adapt_patches: bool, commands: &mut Vec<Command>) {
    commands.push(Command::View(View {
        adapt_patches,
        ..app.document().view
    }));
}
