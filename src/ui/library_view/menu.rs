//! What a spectrum of the library offers on a click of the other button.

use std::sync::Arc;

use eframe::egui::Ui;

use super::LibraryView;
use crate::{
    app::{App, Command, Entry, Recipe},
    spectrum::Kind,
};

impl LibraryView {
    /// Draws the menu of a spectrum; what was chosen.
    pub(super) fn menu(
        &mut self,
        ui: &mut Ui,
        app: &App,
        entry: &Arc<Entry>,
        overlaid: bool,
    ) -> Option<Command> {
        let mut command = None;
        if ui.button("Show").clicked() {
            command = Some(Command::Show(entry.clone()));
            ui.close();
        }
        let words = if overlaid {
            "Take from the overlays"
        } else {
            "Add to the overlays"
        };
        if ui.button(words).clicked() {
            command = Some(Command::ToggleOverlay(entry.clone()));
            ui.close();
        }
        if entry.shelf().is_some() {
            return command;
        }
        ui.separator();
        if entry.origin.file().is_some()
            && ui
                .button("How it was read…")
                .on_hover_text(
                    "The first rows of its file, what was decided about them, and the other \
                     choices.",
                )
                .clicked()
        {
            self.wants_reading = Some(entry.key.clone());
            ui.close();
        }
        if let Some(recipe) = entry.origin.recipe() {
            made_menu(ui, app, entry, recipe, &mut command);
        }
        if entry.kind().is_factor() {
            let is_patch = app.document().own_patches.contains(&entry.key);
            let words = match is_patch {
                true => "Take from the patches",
                false => "Add to the patches",
            };
            if ui.button(words).clicked() {
                let key = entry.key.clone();
                command = Some(Command::ToggleOwnPatch { key });
                ui.close();
            }
        }
        if ui.button("Rename").clicked() {
            self.renaming = Some((entry.key.clone(), entry.name().to_owned()));
            ui.close();
        }
        for kind in [Kind::Light, Kind::Reflectance, Kind::Transmittance] {
            if kind != entry.kind() && ui.button(format!("This is a {kind}")).clicked() {
                command = Some(Command::SetKind {
                    key: entry.key.clone(),
                    kind,
                });
                ui.close();
            }
        }
        if ui.button("Remove").clicked() {
            command = Some(Command::Remove {
                key: entry.key.clone(),
            });
            ui.close();
        }
        command
    }
}

/// What can be done with something that is made: it follows what it is made of until it is frozen.
fn made_menu(
    ui: &mut Ui,
    app: &App,
    entry: &Arc<Entry>,
    recipe: &Recipe,
    command: &mut Option<Command>,
) {
    let light = &app.document().light;
    let is_other = recipe.light().is_some_and(|key| key != light.key) && light.key != entry.key;
    if is_other
        && ui
            .button(format!("Make it with {}", light.name()))
            .on_hover_text("The same recipe with the light that is shown.")
            .clicked()
    {
        *command = Some(Command::MakeOtherwise {
            key: entry.key.clone(),
            recipe: recipe.clone().with_light(&light.key),
        });
        ui.close();
    }
    if ui
        .button("Freeze")
        .on_hover_text("Its numbers stay as they are, whatever happens to what it is made of.")
        .clicked()
    {
        *command = Some(Command::Freeze {
            key: entry.key.clone(),
        });
        ui.close();
    }
}
