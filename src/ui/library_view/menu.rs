//! What a spectrum of the library offers on a click of the other button.

use std::sync::Arc;

use eframe::egui::Ui;

use super::LibraryView;
use crate::{
    app::{App, Command, Entry, Recipe},
    spectrum::Kind,
    ui::{kit::pressed, pages::combine_view::is_measurement},
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
        let mut item = |ui: &mut Ui, [words, meaning]: [&str; 2], asked: Command| {
            let mut button = ui.button(words);
            if !meaning.is_empty() {
                button = button.on_hover_text(meaning);
            }
            if button.clicked() {
                command = Some(asked);
                ui.close();
            }
        };
        let key = || entry.key.clone();
        item(ui, [said!("Show"), ""], Command::Show(entry.clone()));
        if entry.kind() == Kind::Light {
            let (words, compared) = as_second(app, entry);
            item(ui, words, compared);
        }
        let words = match overlaid {
            true => said!("Stop comparing"),
            false => said!("Compare with this"),
        };
        item(ui, [words, ""], Command::ToggleOverlay(entry.clone()));
        if is_measurement(entry) {
            let mut pages = app.document().pages.clone();
            pages.combine.add(entry);
            let meaning = said!("The next free place of the page Combine.");
            item(
                ui,
                [said!("Put on Combine"), meaning],
                Command::Page(Box::new(pages)),
            );
        }
        if entry.shelf().is_some() {
            return command;
        }
        ui.separator();
        let meaning = said!(
            "The first rows of its file, what was decided about them, and the other choices."
        );
        if entry.origin.file().is_some() && pressed(ui, said!("How it was read…"), meaning) {
            self.wants_reading = Some(entry.key.clone());
            ui.close();
        }
        let path = entry
            .origin
            .file()
            .and_then(|from| from.reading.file.path.as_ref());
        let meaning = said!("Reads the file again whenever it changes, with the same choices.");
        if path.is_some() && pressed(ui, said!("Follow"), meaning) {
            self.wants_following = Some(entry.key.clone());
            ui.close();
        }
        if let Some(recipe) = entry.origin.recipe() {
            made_menu(ui, app, entry, recipe, &mut item);
        }
        if entry.kind().is_factor() {
            let is_patch = app.document().own_patches.contains(&entry.key);
            let words = match is_patch {
                true => said!("Remove from the surfaces"),
                false => said!("Add to the surfaces"),
            };
            item(ui, [words, ""], Command::ToggleOwnPatch { key: key() });
        }
        if ui.button(said!("Rename")).clicked() {
            self.renaming = Some((entry.key.clone(), entry.name().to_owned()));
            ui.close();
        }
        for (kind, words) in [
            (Kind::Light, said!("This is a light")),
            (Kind::Reflectance, said!("This is a reflectance")),
            (Kind::Transmittance, said!("This is a transmittance")),
        ] {
            if kind != entry.kind() {
                item(ui, [words, ""], Command::SetKind { key: key(), kind });
            }
        }
        item(ui, [said!("Remove"), ""], Command::Remove { key: key() });
        command
    }
}

/// Has a light be the second one, or no longer: title and meaning, and what is asked for.
fn as_second(app: &App, entry: &Arc<Entry>) -> ([&'static str; 2], Command) {
    let now = app.document().second.as_ref();
    let is_second = now.is_some_and(|second| second.key == entry.key);
    let words = match is_second {
        true => [said!("Compare no more"), ""],
        false => [
            said!("Compare with it"),
            said!("The second light of every page."),
        ],
    };
    let compared = Command::Compare((!is_second).then(|| entry.clone()));
    (words, compared)
}

/// What can be done with something that is made: it follows what it is made of until it is frozen.
fn made_menu(
    ui: &mut Ui,
    app: &App,
    entry: &Arc<Entry>,
    recipe: &Recipe,
    item: &mut dyn FnMut(&mut Ui, [&str; 2], Command),
) {
    let light = &app.document().light;
    let is_other = recipe.light().is_some_and(|key| key != light.key) && light.key != entry.key;
    let key = || entry.key.clone();
    if is_other {
        let words = tr!("Make it with {light}", light = light.name());
        let meaning = said!("The same recipe with the light that is shown.");
        let recipe = recipe.clone().with_light(&light.key);
        let asked = Command::MakeOtherwise { key: key(), recipe };
        item(ui, [&words, meaning], asked);
    }
    let meaning = said!("Keeps its numbers as they are now.");
    item(
        ui,
        [said!("Freeze"), meaning],
        Command::Freeze { key: key() },
    );
}
