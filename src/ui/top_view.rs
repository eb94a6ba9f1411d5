//! The top bar: files in and out, undo, the scale switch, how the window looks.

use eframe::egui;
use egui::{ComboBox, Ui};

use super::{
    fit::{Fit, Front},
    keys::Act,
    theme::Theme,
};
use crate::app::{App, Command, Scale, export::Export, workspace::Preferences};

/// What the bar can ask for beside commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wish {
    /// As a shortcut would.
    Act(Act),
    /// Open a recent file, by its place in the list.
    Recent(usize),
    /// What came of the files opened last.
    Summary,
    /// Save something as text.
    Save(Export),
    /// Save the plot as PNG.
    SavePlotPng,
    /// Save the error against the order as PNG.
    SaveCurvePng,
    /// Save the window as PNG.
    SaveWindowPng,
    /// Copy something as text.
    Copy(Export),
    /// About, with the licences.
    About,
}

/// Width that the bar takes in one row, points.
const ONE_ROW: f32 = 800.0;

/// Draws the bar, in several rows where one is too narrow.
pub fn show(
    ui: &mut Ui,
    app: &App,
    preferences: &mut Preferences,
    (fit, front): (Fit, &mut Front),
    (dialog_open, has_summary): (bool, bool),
    commands: &mut Vec<Command>,
    wishes: &mut Vec<Wish>,
) {
    let has_room = ui.available_width() >= ONE_ROW * Theme::of(preferences).scale;
    let row = |ui: &mut Ui| {
        panels(ui, preferences, fit, front);
        files(ui, preferences, (dialog_open, has_summary), wishes);
        ui.separator();
        steps(ui, app, wishes);
        ui.separator();
        scale_switch(ui, app, commands);
        if has_room {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                looks(ui, preferences, wishes);
            });
        } else {
            ui.separator();
            looks(ui, preferences, wishes);
        }
    };
    if has_room {
        ui.horizontal(row);
    } else {
        ui.horizontal_wrapped(row);
    }
}

/// What is shown beside the page, or in its place where there is no room.
fn panels(ui: &mut Ui, preferences: &mut Preferences, fit: Fit, front: &mut Front) {
    let has_library = match fit {
        Fit::All => !preferences.no_library,
        Fit::Two | Fit::One => *front == Front::Library,
    };
    if ui
        .selectable_label(has_library, "Library")
        .on_hover_text("Shows or hides the library, to make room for the plot.")
        .clicked()
    {
        match fit {
            Fit::All => preferences.no_library = has_library,
            Fit::Two | Fit::One => *front = front.toggled(Front::Library),
        }
    }
    if fit == Fit::One
        && ui
            .selectable_label(*front == Front::Model, "Model")
            .on_hover_text("Shows the model's knobs and numbers in the place of the page.")
            .clicked()
    {
        *front = front.toggled(Front::Model);
    }
}

fn files(
    ui: &mut Ui,
    preferences: &Preferences,
    (dialog_open, has_summary): (bool, bool),
    wishes: &mut Vec<Wish>,
) {
    ui.menu_button("Open", |ui| {
        if ui
            .add_enabled(!dialog_open, egui::Button::new("Open files…"))
            .on_hover_text(
                "Spectra, spectral images or a project (Ctrl+O). Files and folders can also \
                     be dropped on the window.",
            )
            .clicked()
        {
            wishes.push(Wish::Act(Act::Open));
            ui.close();
        }
        if ui
            .add_enabled(!dialog_open, egui::Button::new("Open a folder…"))
            .on_hover_text("Opens every file in a folder and the folders below it (Ctrl+Shift+F).")
            .clicked()
        {
            wishes.push(Wish::Act(Act::OpenFolder));
            ui.close();
        }
        if ui
            .button("Type a path…")
            .on_hover_text("Opens a file, or every file of a folder (Ctrl+Shift+O).")
            .clicked()
        {
            wishes.push(Wish::Act(Act::TypePath));
            ui.close();
        }
        ui.separator();
        if ui
            .add_enabled(has_summary, egui::Button::new("Files opened together…"))
            .on_hover_text("What came of each file of the last folder or choice of files.")
            .clicked()
        {
            wishes.push(Wish::Summary);
            ui.close();
        }
        if !preferences.recent.is_empty() {
            ui.separator();
            ui.weak("Opened last");
        }
        for (index, path) in preferences.recent.iter().enumerate() {
            let name = path.file_name().unwrap_or(path.as_os_str());
            if ui
                .button(name.to_string_lossy())
                .on_hover_text(path.display().to_string())
                .clicked()
            {
                wishes.push(Wish::Recent(index));
                ui.close();
            }
        }
    })
    .response
    .on_hover_text("Open files, a folder, a typed path or a recent file.");
    ui.menu_button("Save", |ui| save_menu(ui, dialog_open, wishes))
        .response
        .on_hover_text("Save or copy spectrum, model, tables and pictures.");
}

fn steps(ui: &mut Ui, app: &App, wishes: &mut Vec<Wish>) {
    for (words, act, possible, key) in [
        ("Undo", Act::Undo, app.can_undo(), "Ctrl+Z"),
        ("Redo", Act::Redo, app.can_redo(), "Ctrl+Shift+Z"),
    ] {
        if ui
            .add_enabled(possible, egui::Button::new(words))
            .on_hover_text(key)
            .clicked()
        {
            wishes.push(Wish::Act(act));
        }
    }
}

fn save_menu(ui: &mut Ui, dialog_open: bool, wishes: &mut Vec<Wish>) {
    ui.add_enabled_ui(!dialog_open, |ui| {
        let mut wish = |ui: &mut Ui, words: &str, wish: Wish| {
            if ui.button(words).clicked() {
                wishes.push(wish);
                ui.close();
            }
        };
        for export in Export::ALL {
            wish(ui, export.title(), Wish::Save(export));
            // A picture stands beside the same picture in another form.
            match export {
                Export::PlotSvg => wish(ui, "Plot (PNG)", Wish::SavePlotPng),
                Export::CurveSvg => wish(ui, "Error against order (PNG)", Wish::SaveCurvePng),
                _ => {}
            }
        }
        wish(ui, "Window (PNG)", Wish::SaveWindowPng);
        ui.separator();
        for export in [
            Export::CompositeLine,
            Export::Csv,
            Export::PatchesCsv,
            Export::SpikesCsv,
            Export::CurveCsv,
        ] {
            let words = format!("Copy: {}", export.title());
            wish(ui, &words, Wish::Copy(export));
        }
        wish(
            ui,
            "Copy a picture of the window",
            Wish::Act(Act::CopyPicture),
        );
    });
}

fn scale_switch(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let document = app.document();
    ui.label("Scale");
    let combo = ComboBox::from_id_salt("scale")
        .selected_text(document.scale.words())
        .width(ui.spacing().combo_width)
        .show_ui(ui, |ui| {
            for scale in Scale::ALL {
                if ui
                    .selectable_label(document.scale == scale, scale.words())
                    .on_hover_text(scale.meaning())
                    .clicked()
                {
                    commands.push(Command::Scale(scale));
                }
            }
        });
    combo
        .response
        .widget_info(|| egui::WidgetInfo::labeled(egui::Role::ComboBox, true, "Scale"));
    combo.response.on_hover_text(document.scale.meaning());
}

fn looks(ui: &mut Ui, preferences: &mut Preferences, wishes: &mut Vec<Wish>) {
    ui.menu_button("Help", |ui| {
        if ui.button("Shortcuts (F1)").clicked() {
            wishes.push(Wish::Act(Act::Shortcuts));
            ui.close();
        }
        if ui.button("About and licences").clicked() {
            wishes.push(Wish::About);
            ui.close();
        }
    });
    let other = if preferences.dark { "Light" } else { "Dark" };
    if ui
        .button(other)
        .on_hover_text("Dark or light surroundings (Ctrl+D).")
        .clicked()
    {
        wishes.push(Wish::Act(Act::Theme));
    }
    if ui
        .selectable_label(preferences.projector, "Projector")
        .on_hover_text("Large type and thick lines, for a class (Ctrl+P).")
        .clicked()
    {
        wishes.push(Wish::Act(Act::Projector));
    }
    let mut zooms = [
        ("−", "Smaller", Act::ZoomOut),
        ("", "", Act::ZoomReset),
        ("+", "Larger", Act::ZoomIn),
    ];
    if ui.layout().prefer_right_to_left() {
        zooms.reverse();
    }
    for (words, name, act) in zooms {
        let percent = format!("{:.0} %", 100.0 * preferences.zoom);
        let (words, name) = if words.is_empty() {
            (percent.as_str(), "Zoom 100 %")
        } else {
            (words, name)
        };
        let button = ui.button(words).on_hover_text(name);
        button.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, name));
        if button.clicked() {
            wishes.push(Wish::Act(act));
        }
    }
}
