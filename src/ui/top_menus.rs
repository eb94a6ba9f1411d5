//! The menus of the top bar by which files come in and go out, and what the bar can ask for.

use std::path::Path;

use eframe::egui;
use egui::{Button, Ui};

use super::keys::Act;
use crate::app::{export::Export, workspace::Preferences};
use crate::languages::{Language, said};

/// What the bar can ask for beside commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// As a shortcut would.
    Act(Act),
    /// The window speaks a language from now on.
    Speak(Language),
    /// Tables that are saved or copied have decimal commas, or points.
    DecimalCommas(bool),
    /// No second light.
    CompareNoMore,
    /// The page where something is followed.
    Follow,
    /// Open a recent file, by its place in the list.
    Recent(usize),
    /// What came of the files opened last.
    Summary,
    /// Save something as text.
    Save(Export),
    SavePlotPng,
    /// One page about the light.
    SaveSheetPdf,
    /// Save the error against the order as PNG.
    SaveCurvePng,
    SaveWindowPng,
    /// Copy something as text.
    Copy(Export),
    /// Copies a link to the page with this light's model.
    CopyLink,
    /// Copies the path of the folder of own lessons.
    LessonsFolder,
    /// About, with the licences.
    About,
}

/// What the menus need to know.
#[derive(Clone, Copy, Debug)]
pub(super) struct Menus<'a> {
    /// Whether a file dialog is open: a second one cannot be.
    pub dialog_open: bool,
    /// Whether files were opened together.
    pub has_summary: bool,
    /// Where own lessons are kept.
    pub lessons: Option<&'a Path>,
    /// Whether this is a page, which a link leads to.
    pub is_page: bool,
}

/// Files in: chosen, typed, followed, opened before.
pub(super) fn open_menu(
    ui: &mut Ui,
    preferences: &Preferences,
    menus: Menus<'_>,
    wishes: &mut Vec<Wish>,
) {
    let Menus {
        dialog_open,
        has_summary,
        lessons,
        is_page,
    } = menus;
    ui.menu_button(said!("Open"), |ui| {
        let mut item = |ui: &mut Ui, is_on: bool, [words, meaning]: [&str; 2], wish: Wish| {
            let button = ui.add_enabled(is_on, Button::new(words));
            let button = button.on_disabled_hover_text(match wish {
                Wish::Summary => said!("There is something here once several files were opened."),
                _ => said!("A file dialog is open already; answer that one first."),
            });
            if button.on_hover_text(meaning).clicked() {
                wishes.push(wish);
                ui.close();
            }
        };
        let words = [
            said!("Open files…"),
            said!(
                "Spectra, spectral images or a project (Ctrl+O). Files and folders can also be \
                 dropped on the window."
            ),
        ];
        item(ui, !dialog_open, words, Wish::Act(Act::Open));
        let words = [
            said!("Open a folder…"),
            said!("Opens every file in a folder and the folders below it (Ctrl+Shift+F)."),
        ];
        item(ui, !dialog_open, words, Wish::Act(Act::OpenFolder));
        let words = [
            said!("Type a path…"),
            said!("Opens a file, or every file of a folder (Ctrl+Shift+O)."),
        ];
        if !is_page {
            item(ui, true, words, Wish::Act(Act::TypePath));
            let words = [
                said!("Follow…"),
                said!(
                    "A light that changes: a file or a folder that an instrument writes, lines \
                     over TCP or a serial port, a recording."
                ),
            ];
            item(ui, true, words, Wish::Follow);
        }
        ui.separator();
        let words = [
            said!("Files opened together…"),
            said!("The outcome for each file of the last folder or choice of files."),
        ];
        item(ui, has_summary, words, Wish::Summary);
        if let Some(folder) = lessons {
            let meaning = tr!(
                "{folder}: lessons in it are in the list of Learn. Click to copy the path.",
                folder = folder.display()
            );
            let words = [said!("Folder of your lessons"), &meaning];
            item(ui, true, words, Wish::LessonsFolder);
        }
        if !preferences.recent.is_empty() {
            ui.separator();
            ui.weak(said!("Opened last"));
        }
        for (index, path) in preferences.recent.iter().enumerate() {
            let name = path.file_name().unwrap_or(path.as_os_str());
            let words = [&*name.to_string_lossy(), &path.display().to_string()];
            item(ui, true, words, Wish::Recent(index));
        }
    })
    .response
    .on_hover_text(said!(
        "Open files, a folder, a typed path or a recent file."
    ));
}

/// What can be saved, by what it is of.
const GROUPS: [(&str, &[Export]); 3] = [
    (
        later!("Spectrum"),
        &[Export::Spdx, Export::ArgyllSp, Export::SpectrumJson],
    ),
    (
        later!("Model"),
        &[
            Export::CompositeJson,
            Export::CompositeLine,
            Export::Spd,
            Export::SpikesCsv,
            Export::PatchesCsv,
            Export::CurveCsv,
        ],
    ),
    (
        later!("Figure"),
        &[Export::PlotSvg, Export::CurveSvg, Export::SheetSvg],
    ),
];

/// What is saved most.
const FIRST: [(&str, &str, Wish); 4] = [
    (
        later!("Spectrum and model (CSV)"),
        later!("Its numbers as a table."),
        Wish::Save(Export::Csv),
    ),
    (
        later!("Plot (PNG)"),
        later!("The picture of the spectrum."),
        Wish::SavePlotPng,
    ),
    (
        later!("Sheet about the light (PDF)"),
        later!("One page: what it is, how good it is, its colours, its numbers."),
        Wish::SaveSheetPdf,
    ),
    (
        later!("Project"),
        later!("Everything that is open, to go on later (Ctrl+S)."),
        Wish::Save(Export::Project),
    ),
];

/// Files out, and what is copied.
pub(super) fn save_menu(
    ui: &mut Ui,
    mut commas: bool,
    [dialog_open, is_page]: [bool; 2],
    wishes: &mut Vec<Wish>,
) {
    ui.add_enabled_ui(!dialog_open, |ui| {
        for (words, meaning, asked) in FIRST {
            if ui
                .button(said(words))
                .on_hover_text(said(meaning))
                .clicked()
            {
                wishes.push(asked);
                ui.close();
            }
        }
        ui.menu_button(said!("More formats"), |ui| {
            let most = (ui.ctx().content_rect().height() - 120.0).max(120.0);
            egui::ScrollArea::vertical()
                .max_height(most)
                .min_scrolled_height(most.min(480.0))
                .show(ui, |ui| more_formats(ui, wishes));
        });
    });
    ui.separator();
    let words = said!("Decimal commas in tables");
    let meaning = said!(
        "Tables that are saved or copied have decimal commas and semicolons between their columns, \
         as many spreadsheets expect."
    );
    if ui
        .checkbox(&mut commas, words)
        .on_hover_text(meaning)
        .changed()
    {
        wishes.push(Wish::DecimalCommas(commas));
    }
    ui.separator();
    let mut item = |ui: &mut Ui, words: &str, act: Act| {
        if ui.button(words).clicked() {
            wishes.push(Wish::Act(act));
            ui.close();
        }
    };
    item(ui, said!("Print this page (Ctrl+P)"), Act::Print);
    item(ui, said!("Copy a picture of the window"), Act::CopyPicture);
    item(
        ui,
        said!("Copy the command line for this view"),
        Act::CopyCommand,
    );
    if is_page && ui.button(said!("Copy a link to this view")).clicked() {
        wishes.push(Wish::CopyLink);
        ui.close();
    }
    ui.menu_button(said!("Copy as text"), |ui| {
        for export in [
            Export::CompositeLine,
            Export::Csv,
            Export::PatchesCsv,
            Export::SpikesCsv,
            Export::CurveCsv,
        ] {
            if ui
                .button(tr!("Copy: {what}", what = export.title()))
                .clicked()
            {
                wishes.push(Wish::Copy(export));
                ui.close();
            }
        }
    });
}

fn more_formats(ui: &mut Ui, wishes: &mut Vec<Wish>) {
    let mut wish = |ui: &mut Ui, words: &str, wish: Wish| {
        if ui.button(words).clicked() {
            wishes.push(wish);
            ui.close();
        }
    };
    for (title, exports) in GROUPS {
        ui.weak(said(title));
        for export in exports {
            wish(ui, export.title(), Wish::Save(*export));
            // A picture stands beside the same picture in another form.
            if *export == Export::CurveSvg {
                wish(ui, said!("Error against waves (PNG)"), Wish::SaveCurvePng);
            }
        }
    }
    wish(ui, said!("Window (PNG)"), Wish::SaveWindowPng);
}
