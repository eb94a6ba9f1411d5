//! The top bar: the light, undo, files in and out, how the window looks.

use std::path::Path;

use eframe::egui;
use egui::{Align, Button, Color32, Layout, RichText, Sense, Ui, vec2};

use super::{
    eyes,
    keys::Act,
    kit::{cut_words, named, named_choice},
    second_chip, swatch,
    theme::{Theme, grey},
};
use crate::app::{App, export::Export, workspace::Preferences};

/// What the bar can ask for beside commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// As a shortcut would.
    Act(Act),
    /// No second light.
    CompareNoMore,
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

/// How the drawer stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Drawer {
    /// Whether the library is open.
    pub open: bool,
    /// Whether a click in it lays a spectrum over the one that is shown.
    pub compares: bool,
}

pub(super) fn show(
    ui: &mut Ui,
    app: &App,
    preferences: &Preferences,
    drawer: &mut Drawer,
    menus: Menus<'_>,
    wishes: &mut Vec<Wish>,
) {
    let theme = Theme::of(preferences);
    let room = Room::of(ui.available_width());
    ui.horizontal_centered(|ui| {
        ui.spacing_mut().item_spacing.x = if room == Room::Little { 4.0 } else { 8.0 };
        // From the right: the light's name has what is left.
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            looks(ui, preferences, room, wishes);
            if room == Room::Much {
                ui.separator();
            }
            ui.menu_button("Save", |ui| {
                save_menu(ui, [menus.dialog_open, menus.is_page], wishes)
            })
            .response
            .on_hover_text("Save or copy spectrum, model, tables and pictures.");
            files(ui, preferences, menus, wishes);
            if room == Room::Much {
                ui.separator();
            }
            steps(ui, app, wishes);
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let gap = ui.spacing().item_spacing.x;
                let room_for_both = ui.available_width() - gap;
                match &app.document().second {
                    Some(second) => {
                        let most = (0.5 * room_for_both).min(MOST_NAME);
                        light(ui, app, drawer, most, theme);
                        let rest = ui.available_width();
                        let is_choosing = drawer.open && drawer.compares;
                        let most = rest.min(MOST_NAME);
                        match second_chip::show(ui, app, second, is_choosing, most, theme) {
                            Some(second_chip::Wish::Choose) => drawer.choose_second(),
                            Some(second_chip::Wish::NoMore) => wishes.push(Wish::CompareNoMore),
                            None => {}
                        }
                    }
                    None => {
                        let compare = if room == Room::Much { COMPARE } else { 30.0 };
                        let most = room_for_both - compare;
                        light(ui, app, drawer, most.min(MOST_NAME), theme);
                        compare_button(ui, drawer, room);
                    }
                }
            });
        });
    });
}

/// How much room the bar has for words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Room {
    Much,
    Some,
    Little,
}

impl Room {
    fn of(width: f32) -> Self {
        match width {
            w if w >= 640.0 => Self::Much,
            w if w >= 460.0 => Self::Some,
            _ => Self::Little,
        }
    }
}

/// Width of the button that lays another spectrum over, and most of the light's, points.
const COMPARE: f32 = 92.0;
const MOST_NAME: f32 = 420.0;

fn compare_button(ui: &mut Ui, drawer: &mut Drawer, room: Room) {
    let words = if room == Room::Much { "+ Compare" } else { "+" };
    let button = Button::selectable(drawer.open && drawer.compares, words);
    let compare = ui.add(button.frame_when_inactive(true));
    named(&compare, egui::Role::Button, "+ Compare");
    let compare = compare.on_hover_text(
        "A second light beside this one, on every page: choose it in the library. A surface \
         is compared with surfaces.",
    );
    if compare.clicked() {
        drawer.choose_second();
    }
}

impl Drawer {
    /// Opens the library for a second light; closes it where it is open for one.
    fn choose_second(&mut self) {
        let compares = !(self.open && self.compares);
        *self = Self {
            open: compares || self.open && !self.compares,
            compares,
        };
    }
}

/// The light's name with its colour: it opens the library.
fn light(ui: &mut Ui, app: &App, drawer: &mut Drawer, width: f32, theme: Theme) {
    let document = app.document();
    let name = document.subject_entry().name();
    let colour = app.derived().colour.exact.or(app.derived().colour.full);
    let colour = colour.map_or(grey(128), |colour| swatch::colour(colour.swatch.rgb8));
    let font = egui::TextStyle::Button.resolve(ui.style());
    let ink = ui.visuals().strong_text_color();
    let galley = cut_words(ui, name, font, ink, width - 76.0);
    let height = 32.0 * theme.scale;
    let size = vec2((galley.size().x + 76.0).min(width.max(60.0)), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let open = drawer.open && !drawer.compares;
    let name = format!("Library: {name}");
    named_choice(&response, egui::Role::Button, open, &name);
    let visuals = ui.visuals();
    let fill = match (open, response.hovered() || response.has_focus()) {
        (true, _) => visuals.selection.bg_fill,
        (false, true) => visuals.widgets.hovered.bg_fill,
        (false, false) => visuals.widgets.inactive.bg_fill,
    };
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, fill);
    let y = rect.center().y;
    for row in [-5.0, 0.0, 5.0] {
        painter.hline(rect.left() + 12.0..=rect.left() + 28.0, y + row, (1.5, ink));
    }
    let field = egui::Rect::from_center_size(
        egui::pos2(rect.left() + 43.0, y),
        vec2(14.0, 14.0) * theme.scale.min(1.5),
    );
    let edge = egui::Stroke::new(1.0, grey(128));
    painter.rect(field, 2.0, colour, edge, egui::StrokeKind::Outside);
    let at = egui::pos2(rect.left() + 58.0, y - galley.size().y / 2.0);
    painter.galley(at, galley, Color32::WHITE);
    if response.clicked() {
        *drawer = Drawer {
            open: !open,
            compares: false,
        };
    }
    response.on_hover_text("Opens the library (Ctrl+L).");
}

fn steps(ui: &mut Ui, app: &App, wishes: &mut Vec<Wish>) {
    for (name, sign, act, words, key) in [
        ("Redo", "⟳", Act::Redo, app.redo_words(), "Ctrl+Shift+Z"),
        ("Undo", "⟲", Act::Undo, app.undo_words(), "Ctrl+Z"),
    ] {
        let button = ui.add_enabled(words.is_some(), Button::new(sign).frame(false));
        named(&button, egui::Role::Button, name);
        let words = words.unwrap_or_else(|| "nothing".to_owned());
        let button = button.on_hover_text(format!("{name}: {words} ({key})"));
        if button.clicked() {
            wishes.push(Wish::Act(act));
        }
    }
}

fn files(ui: &mut Ui, preferences: &Preferences, menus: Menus<'_>, wishes: &mut Vec<Wish>) {
    let Menus {
        dialog_open,
        has_summary,
        lessons,
        is_page,
    } = menus;
    ui.menu_button("Open", |ui| {
        let mut item = |ui: &mut Ui, is_on: bool, [words, meaning]: [&str; 2], wish: Wish| {
            let button = ui.add_enabled(is_on, Button::new(words));
            let button = button.on_disabled_hover_text(match wish {
                Wish::Summary => "There is something here once several files were opened.",
                _ => "A file dialog is open already; answer that one first.",
            });
            if button.on_hover_text(meaning).clicked() {
                wishes.push(wish);
                ui.close();
            }
        };
        let words = [
            "Open files…",
            "Spectra, spectral images or a project (Ctrl+O). Files and folders can also \
                  be dropped on the window.",
        ];
        item(ui, !dialog_open, words, Wish::Act(Act::Open));
        let words = [
            "Open a folder…",
            "Opens every file in a folder and the folders below it (Ctrl+Shift+F).",
        ];
        item(ui, !dialog_open, words, Wish::Act(Act::OpenFolder));
        let words = [
            "Type a path…",
            "Opens a file, or every file of a folder (Ctrl+Shift+O).",
        ];
        if !is_page {
            item(ui, true, words, Wish::Act(Act::TypePath));
        }
        ui.separator();
        let words = [
            "Files opened together…",
            "The outcome for each file of the last folder or choice of files.",
        ];
        item(ui, has_summary, words, Wish::Summary);
        if let Some(folder) = lessons {
            let meaning = format!(
                "{}: lessons in it are in the list of Learn. Click to copy the path.",
                folder.display()
            );
            let words = ["Folder of your lessons", &meaning];
            item(ui, true, words, Wish::LessonsFolder);
        }
        if !preferences.recent.is_empty() {
            ui.separator();
            ui.weak("Opened last");
        }
        for (index, path) in preferences.recent.iter().enumerate() {
            let name = path.file_name().unwrap_or(path.as_os_str());
            let words = [&*name.to_string_lossy(), &path.display().to_string()];
            item(ui, true, words, Wish::Recent(index));
        }
    })
    .response
    .on_hover_text("Open files, a folder, a typed path or a recent file.");
}

/// What can be saved, by what it is of.
const GROUPS: [(&str, &[Export]); 3] = [
    (
        "Spectrum",
        &[Export::Spdx, Export::ArgyllSp, Export::SpectrumJson],
    ),
    (
        "Model",
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
        "Figure",
        &[Export::PlotSvg, Export::CurveSvg, Export::SheetSvg],
    ),
];

/// What is saved most.
const FIRST: [(&str, &str, Wish); 4] = [
    (
        "Spectrum and model (CSV)",
        "Its numbers as a table.",
        Wish::Save(Export::Csv),
    ),
    (
        "Plot (PNG)",
        "The picture of the spectrum.",
        Wish::SavePlotPng,
    ),
    (
        "Sheet about the light (PDF)",
        "One page: what it is, how good it is, its colours, its numbers.",
        Wish::SaveSheetPdf,
    ),
    (
        "Project",
        "Everything that is open, to go on later (Ctrl+S).",
        Wish::Save(Export::Project),
    ),
];

fn save_menu(ui: &mut Ui, [dialog_open, is_page]: [bool; 2], wishes: &mut Vec<Wish>) {
    ui.add_enabled_ui(!dialog_open, |ui| {
        for (words, meaning, asked) in FIRST {
            if ui.button(words).on_hover_text(meaning).clicked() {
                wishes.push(asked);
                ui.close();
            }
        }
        ui.menu_button("More formats", |ui| {
            let most = (ui.ctx().content_rect().height() - 120.0).max(120.0);
            egui::ScrollArea::vertical()
                .max_height(most)
                .min_scrolled_height(most.min(480.0))
                .show(ui, |ui| more_formats(ui, wishes));
        });
    });
    ui.separator();
    let mut item = |ui: &mut Ui, words: &str, act: Act| {
        if ui.button(words).clicked() {
            wishes.push(Wish::Act(act));
            ui.close();
        }
    };
    item(ui, "Print this page (Ctrl+P)", Act::Print);
    item(ui, "Copy a picture of the window", Act::CopyPicture);
    item(ui, "Copy the command line for this view", Act::CopyCommand);
    if is_page && ui.button("Copy a link to this view").clicked() {
        wishes.push(Wish::CopyLink);
        ui.close();
    }
    ui.menu_button("Copy as text", |ui| {
        for export in [
            Export::CompositeLine,
            Export::Csv,
            Export::PatchesCsv,
            Export::SpikesCsv,
            Export::CurveCsv,
        ] {
            if ui.button(format!("Copy: {}", export.title())).clicked() {
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
        ui.weak(title);
        for export in exports {
            wish(ui, export.title(), Wish::Save(*export));
            // A picture stands beside the same picture in another form.
            if *export == Export::CurveSvg {
                wish(ui, "Error against waves (PNG)", Wish::SaveCurvePng);
            }
        }
    }
    wish(ui, "Window (PNG)", Wish::SaveWindowPng);
}

fn looks(ui: &mut Ui, preferences: &Preferences, room: Room, wishes: &mut Vec<Wish>) {
    let help = ui.menu_button("?", |ui| {
        let mut wish = |ui: &mut Ui, words: &str, wish: Wish| {
            if ui.button(words).clicked() {
                wishes.push(wish);
                ui.close();
            }
        };
        wish(ui, "Shortcuts (Shift+F1)", Wish::Act(Act::Shortcuts));
        wish(ui, "Find anything… (Ctrl+K)", Wish::Act(Act::Palette));
        wish(ui, "The ways to begin", Wish::Act(Act::Greeting));
        wish(ui, "About and licences", Wish::About);
        ui.separator();
        wish(ui, "Larger (Ctrl++)", Wish::Act(Act::ZoomIn));
        wish(ui, "Smaller (Ctrl+-)", Wish::Act(Act::ZoomOut));
        let words = match preferences.touch {
            Some(true) => "Targets for a pointer",
            _ => "Targets for fingers",
        };
        wish(ui, words, Wish::Act(Act::Touch));
        let percent = format!("Zoom 100 %, now {:.0} % (Ctrl+0)", 100.0 * preferences.zoom);
        wish(ui, &percent, Wish::Act(Act::ZoomReset));
        ui.separator();
        let (_, words) = eyes::next(preferences.without_cones);
        let words = format!("{words} (Ctrl+Shift+D)");
        wish(ui, &words, Wish::Act(Act::Eyes));
    });
    named(&help.response, egui::Role::Button, "Help");
    help.response.on_hover_text("Shortcuts, licences, zoom.");
    let words = if room == Room::Little {
        "▶"
    } else {
        "Present"
    };
    let present = ui.add(Button::selectable(preferences.present, words).frame_when_inactive(true));
    named(&present, egui::Role::Button, "Present");
    let present = present
        .on_hover_text("This page for a class: its picture and its main controls, large (F5).");
    if present.clicked() {
        wishes.push(Wish::Act(Act::Present));
    }
    let (sign, words) = if preferences.dark {
        ("☀", "Light surroundings (Ctrl+D).")
    } else {
        ("☾", "Dark surroundings (Ctrl+D).")
    };
    let theme = ui.add(Button::new(RichText::new(sign)));
    named(&theme, egui::Role::Button, "Surroundings");
    if theme.on_hover_text(words).clicked() {
        wishes.push(Wish::Act(Act::Theme));
    }
}
