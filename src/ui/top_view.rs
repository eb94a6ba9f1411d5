//! The top bar: the light, undo, files in and out, how the window looks.

use eframe::egui;
use egui::{Align, Button, Color32, Layout, RichText, Sense, Ui, vec2};

pub(super) use super::top_menus::{Menus, Wish};
use super::{
    eyes,
    keys::Act,
    kit::{cut_words, named, named_choice},
    second_chip, swatch,
    theme::{FINGER, Theme, grey},
    top_menus::{open_menu, save_menu},
};
use crate::{
    app::{App, answers::judged, readings::COUNTS, workspace::Preferences},
    languages::{Language, fixed, with_colon},
};

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
        if preferences.touch == Some(true) {
            ui.spacing_mut().interact_size.y = FINGER;
            ui.spacing_mut().button_padding.x = 16.0;
        }
        // From the right: the light's name has what is left.
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            looks(ui, preferences, room, wishes);
            if room == Room::Much {
                ui.separator();
            }
            ui.menu_button(said!("Save"), |ui| {
                save_menu(
                    ui,
                    preferences.decimal_commas,
                    [menus.dialog_open, menus.is_page],
                    wishes,
                )
            })
            .response
            .on_hover_text(said!("Save or copy spectrum, model, tables and pictures."));
            open_menu(ui, preferences, menus, wishes);
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
                        let compare = compare_width(ui, room);
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

/// Room for the button that lays another spectrum over: wider where its words are longer than in
/// English.
fn compare_width(ui: &Ui, room: Room) -> f32 {
    if room != Room::Much {
        return 30.0;
    }
    let font = egui::TextStyle::Button.resolve(ui.style());
    let wide = |words: &str| {
        let words = words.to_owned();
        let galley = ui
            .painter()
            .layout_no_wrap(words, font.clone(), Color32::WHITE);
        galley.size().x
    };
    COMPARE * (wide(said!("+ Compare")) / wide("+ Compare")).max(1.0)
}

fn compare_button(ui: &mut Ui, drawer: &mut Drawer, room: Room) {
    let words = if room == Room::Much {
        said!("+ Compare")
    } else {
        "+"
    };
    let button = Button::selectable(drawer.open && drawer.compares, words);
    let compare = ui.add(button.frame_when_inactive(true));
    named(&compare, egui::Role::Button, said!("+ Compare"));
    let compare = compare.on_hover_text(said!(
        "A second light beside this one, on every page: choose it in the library. A surface is \
         compared with surfaces."
    ));
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
    let colour = colour.filter(|_| judged(app) != Err(COUNTS));
    let colour = colour.map_or(grey(128), |colour| swatch::colour(colour.swatch.rgb8));
    let font = egui::TextStyle::Button.resolve(ui.style());
    let ink = ui.visuals().strong_text_color();
    let galley = cut_words(ui, name, font, ink, width - 76.0);
    let height = 32.0 * theme.scale;
    let size = vec2((galley.size().x + 76.0).min(width.max(60.0)), height);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let open = drawer.open && !drawer.compares;
    let name = tr!("Library: {name}", name);
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
    response.on_hover_text(said!("Opens the library (Ctrl+L)."));
}

fn steps(ui: &mut Ui, app: &App, wishes: &mut Vec<Wish>) {
    for (name, sign, act, words, key) in [
        (
            said!("Redo"),
            "⟳",
            Act::Redo,
            app.redo_words(),
            "Ctrl+Shift+Z",
        ),
        (said!("Undo"), "⟲", Act::Undo, app.undo_words(), "Ctrl+Z"),
    ] {
        let button = ui.add_enabled(words.is_some(), Button::new(sign).frame(false));
        named(&button, egui::Role::Button, name);
        let words = words.unwrap_or_else(|| said!("nothing").to_owned());
        let button = button.on_hover_text(with_colon(name, format!("{words} ({key})")));
        if button.clicked() {
            wishes.push(Wish::Act(act));
        }
    }
}

fn looks(ui: &mut Ui, preferences: &Preferences, room: Room, wishes: &mut Vec<Wish>) {
    let help = ui.menu_button("?", |ui| {
        let mut wish = |ui: &mut Ui, words: &str, wish: Wish| {
            if ui.button(words).clicked() {
                wishes.push(wish);
                ui.close();
            }
        };
        wish(ui, said!("Shortcuts (Shift+F1)"), Wish::Act(Act::Shortcuts));
        wish(
            ui,
            said!("Find anything… (Ctrl+K)"),
            Wish::Act(Act::Palette),
        );
        wish(ui, said!("The ways to begin"), Wish::Act(Act::Greeting));
        wish(ui, said!("About and licences"), Wish::About);
        ui.separator();
        wish(ui, said!("Larger (Ctrl++)"), Wish::Act(Act::ZoomIn));
        wish(ui, said!("Smaller (Ctrl+-)"), Wish::Act(Act::ZoomOut));
        let words = match preferences.touch {
            Some(true) => said!("Targets for a pointer"),
            _ => said!("Targets for fingers"),
        };
        wish(ui, words, Wish::Act(Act::Touch));
        let percent = tr!(
            "Zoom 100 %, now {share} % (Ctrl+0)",
            share = fixed(f64::from(100.0 * preferences.zoom), 0)
        );
        wish(ui, &percent, Wish::Act(Act::ZoomReset));
        ui.separator();
        let (_, words) = eyes::next(preferences.without_cones);
        let words = tr!("{words} (Ctrl+Shift+D)", words);
        wish(ui, &words, Wish::Act(Act::Eyes));
    });
    named(&help.response, egui::Role::Button, said!("Help"));
    help.response
        .on_hover_text(said!("Shortcuts, licences, zoom."));
    let words = if room == Room::Little {
        "▶"
    } else {
        said!("Present")
    };
    let present = ui.add(Button::selectable(preferences.present, words).frame_when_inactive(true));
    named(&present, egui::Role::Button, said!("Present"));
    let present = present.on_hover_text(said!(
        "This page for a class: its picture and its main controls, large (F5)."
    ));
    if present.clicked() {
        wishes.push(Wish::Act(Act::Present));
    }
    speaks(ui, preferences.language, wishes);
    let (sign, words) = if preferences.dark {
        ("☀", said!("Light surroundings (Ctrl+D)."))
    } else {
        ("☾", said!("Dark surroundings (Ctrl+D)."))
    };
    let theme = ui.add(Button::new(RichText::new(sign)));
    named(&theme, egui::Role::Button, said!("Surroundings"));
    if theme.on_hover_text(words).clicked() {
        wishes.push(Wish::Act(Act::Theme));
    }
}

/// The language of the window, by its code: whoever cannot read what is shown still finds it.
fn speaks(ui: &mut Ui, language: Language, wishes: &mut Vec<Wish>) {
    let menu = ui.menu_button(language.code().to_uppercase(), |ui| {
        for other in Language::ALL {
            let button = Button::selectable(other == language, other.name());
            if ui.add(button).clicked() {
                wishes.push(Wish::Speak(other));
                ui.close();
            }
        }
    });
    named(&menu.response, egui::Role::Button, said!("Language"));
    menu.response.on_hover_text(said!(
        "The language of the window, its lessons and its sheets."
    ));
}
