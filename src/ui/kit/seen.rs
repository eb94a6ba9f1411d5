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
        meaning: "It changes the colours on screen, not the errors. Adaptation after Bradford.",
        width: width.min(ui.available_width()),
    };
    choice.cut(ui, view.adaptation().words(), |ui| {
        for (way, seen) in [(true, Adaptation::ToLight), (false, Adaptation::None)] {
            ui.selectable_value(&mut adapt, way, seen.words());
        }
    });
    if adapt != view.adapt_patches {
        commands.push(Command::View(View {
            adapt_patches: adapt,
            ..view
        }));
    }
}
