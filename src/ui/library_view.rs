//! The library: shelves of spectra, each with a swatch, a name and a small curve.

use std::{
    collections::{HashMap, HashSet},
    sync::Arc,
};

use eframe::egui;
use egui::{Align2, Color32, FontId, Key, Rect, Sense, Shape, Stroke, Ui, Vec2, pos2, vec2};

use super::{
    swatch,
    theme::{Theme, ink},
};
use crate::{
    app::{
        App, Command, Entry,
        about::About,
        families::Families,
        recipe::Recipe,
        search::{Folded, Index, favourites, fold},
        workspace::Preferences,
    },
    color::{
        Adaptation, Observer, Swatch, Xyz,
        xyz::{xyz_from_light, xyz_from_reflectance},
    },
    preset::Shelf,
    spectrum::{Kind, Outside},
};

/// What the library remembers between frames.
#[derive(Default)]
pub struct LibraryView {
    /// What is searched for.
    pub search: String,
    /// The search field is to get the keyboard in the next frame.
    pub wants_search: bool,
    /// The own entry whose file is to be looked at.
    pub wants_reading: Option<String>,
    /// A click lays a spectrum over the one that is shown.
    compares: bool,
    /// The own entry being renamed, with the text so far.
    renaming: Option<(String, String)>,
    /// By key, with the entry it was made of: after an undo another file may have the key.
    art: HashMap<String, (Arc<Entry>, Art)>,
    /// The rows and what they were made for: thousands are not looked through in every frame.
    listed: Option<(RowsOf, Arc<Vec<Row>>)>,
    /// What can be searched, and the user's own spectra that it was made for.
    index: Option<(Vec<Arc<Entry>>, Index)>,
    /// The row that Enter takes, of those that a search found.
    at: usize,
}

/// What the rows are made of.
struct RowsOf {
    search: String,
    folded: Vec<String>,
    own: Vec<Arc<Entry>>,
    bundled: usize,
}

impl RowsOf {
    fn is_still(&self, search: &str, folded: &[String], app: &App) -> bool {
        let own = &app.document().own;
        self.search == search
            && self.folded == folded
            && self.bundled == app.bundled().len()
            && self.own.len() == own.len()
            && self.own.iter().zip(own).all(|(a, b)| Arc::ptr_eq(a, b))
    }
}

/// A row's swatch and curve, made once.
struct Art {
    colour: Color32,
    /// Heights 0-1 over 380-780 nm.
    curve: Vec<f32>,
    /// What it is, in a few words.
    what: String,
}

/// Points of a row's small curve.
const CURVE_POINTS: usize = 36;
/// Places between two of them at which it is looked for lines.
const STEPS_BETWEEN: usize = 10;

/// One line of the list.
enum Row {
    Heading {
        title: String,
        count: usize,
        folded: bool,
    },
    /// A file of the user's own with several spectra.
    File {
        name: String,
        count: usize,
        folded: bool,
    },
    Item {
        entry: Arc<Entry>,
        /// Letters at the beginning and the end that all names of its file have in common;
        /// `None` where it stands alone.
        in_file: Option<[usize; 2]>,
    },
}

/// What a file is called among the folds that are remembered: none of the shelves is called so.
fn fold_of(file: &str) -> String {
    format!("file: {file}")
}

/// Indent of a file's spectra, points.
const INDENT: f32 = 10.0;

/// What a row asked for.
enum Wish {
    Command(Command),
    Fold(String),
}

const OWN: &str = "My files";

impl LibraryView {
    /// Draws the library.
    pub fn show(
        &mut self,
        ui: &mut Ui,
        app: &App,
        preferences: &mut Preferences,
        (theme, compares): (Theme, bool),
        commands: &mut Vec<Command>,
    ) {
        self.compares = compares;
        ui.horizontal(|ui| {
            let words = if compares { "Lay over" } else { "Library" };
            ui.label(egui::RichText::new(words).heading());
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                ui.toggle_value(&mut preferences.pinned, "Pin")
                    .on_hover_text("The library stays open beside the page.");
            });
        });
        let search = ui
            .add(
                egui::TextEdit::singleline(&mut self.search)
                    .hint_text("Search spectra")
                    .desired_width(f32::INFINITY),
            )
            .on_hover_text(
                "A name, a family, an element, a use: \"street lamp\", neon, skin (Ctrl+F). Enter shows \
                 the first.",
            );
        search.widget_info(|| {
            egui::WidgetInfo::labeled(egui::Role::TextInput, true, "Search the library")
        });
        if std::mem::take(&mut self.wants_search) {
            search.request_focus();
        }
        let searches = !self.search.trim().is_empty();
        if !searches {
            favourites_row(ui, app, theme, self.compares, commands);
        }
        let rows = self.listed(app, preferences);
        if rows.is_empty() {
            ui.add_space(8.0);
            ui.weak("Nothing is called that.");
            return;
        }
        if search.changed() {
            self.at = 0;
        }
        let typing = search.has_focus() || search.lost_focus();
        let chosen = searches && self.keys(ui, typing, rows.len());
        if chosen && let Some(Row::Item { entry, .. }) = rows.get(self.at) {
            commands.push(if self.compares {
                Command::ToggleOverlay(entry.clone())
            } else {
                Command::Show(entry.clone())
            });
        }
        let height = (ROW * theme.scale).round();
        let mut wish = None;
        egui::ScrollArea::vertical().auto_shrink(false).show_rows(
            ui,
            height - ui.spacing().item_spacing.y,
            rows.len(),
            |ui, range| {
                for (row, place) in rows[range.clone()].iter().zip(range) {
                    let size = vec2(ui.available_width(), height - ui.spacing().item_spacing.y);
                    match row {
                        Row::Heading {
                            title,
                            count,
                            folded,
                        } => {
                            if heading(ui, size, title, *count, *folded) {
                                wish = Some(Wish::Fold(title.clone()));
                            }
                        }
                        Row::File {
                            name,
                            count,
                            folded,
                        } => {
                            if file_heading(ui, size, name, *count, *folded) {
                                wish = Some(Wish::Fold(fold_of(name)));
                            }
                        }
                        Row::Item { entry, in_file } => {
                            let row = (entry, *in_file);
                            let is_next = searches && place == self.at;
                            if let Some(command) = self.item(ui, size, row, is_next, (app, theme)) {
                                wish = Some(Wish::Command(command));
                            }
                        }
                    }
                }
            },
        );
        match wish {
            Some(Wish::Command(command)) => commands.push(command),
            Some(Wish::Fold(title)) => {
                let folded = &mut preferences.folded;
                match folded.iter().position(|f| *f == title) {
                    Some(index) => drop(folded.remove(index)),
                    None => folded.push(title),
                }
            }
            None => {}
        }
    }

    /// Escape gives up a new name, then the search; whether there was either.
    pub fn escaped(&mut self) -> bool {
        if self.renaming.is_some() {
            return true;
        }
        !std::mem::take(&mut self.search).is_empty()
    }

    /// Moves the chosen row by the arrows while a search is typed; whether Enter was pressed.
    fn keys(&mut self, ui: &Ui, typing: bool, count: usize) -> bool {
        if !typing {
            return false;
        }
        let [up, down, enter] =
            [Key::ArrowUp, Key::ArrowDown, Key::Enter].map(|key| ui.input(|i| i.key_pressed(key)));
        if down {
            self.at += 1;
        }
        if up {
            self.at = self.at.saturating_sub(1);
        }
        self.at = self.at.min(count.saturating_sub(1));
        enter
    }

    /// The rows, made anew when search, folds or spectra changed.
    fn listed(&mut self, app: &App, preferences: &Preferences) -> Arc<Vec<Row>> {
        if let Some((of, rows)) = &self.listed
            && of.is_still(&self.search, &preferences.folded, app)
        {
            return rows.clone();
        }
        let of = RowsOf {
            search: self.search.clone(),
            folded: preferences.folded.clone(),
            own: app.document().own.clone(),
            bundled: app.bundled().len(),
        };
        let rows = Arc::new(self.rows(app, preferences));
        self.listed = Some((of, rows.clone()));
        // What is not listed any more is not kept either.
        let own: HashSet<&str> = app.document().own.iter().map(|e| e.key.as_str()).collect();
        self.art
            .retain(|key, _| !key.starts_with("own/") || own.contains(key.as_str()));
        rows
    }

    fn rows(&mut self, app: &App, preferences: &Preferences) -> Vec<Row> {
        if !self.search.trim().is_empty() {
            return self.found(app);
        }
        let mut rows = Vec::new();
        let is_folded = |title: &str| preferences.folded.iter().any(|f| f == title);
        let heading = |rows: &mut Vec<Row>, title: &str, count: usize| {
            let folded = is_folded(title);
            if count > 0 {
                rows.push(Row::Heading {
                    title: title.to_owned(),
                    count,
                    folded,
                });
            }
            count > 0 && !folded
        };
        let own = &app.document().own;
        if heading(&mut rows, OWN, own.len()) {
            by_file(own.clone(), |file| is_folded(&fold_of(file)), &mut rows);
        }
        let item = |row: Folded| Row::Item {
            entry: row.entry,
            in_file: None,
        };
        let is_light = |entry: &&Arc<Entry>| entry.kind() == Kind::Light;
        let lights = fold(app.bundled().iter().filter(is_light));
        let families = Families::shipped();
        let mut headings: Vec<&str> = Vec::new();
        for family in families.all() {
            if !headings.contains(&family.heading.as_str()) {
                headings.push(&family.heading);
            }
        }
        for title in headings {
            let is_its = |row: &&Folded| {
                let family = families.family_of(&row.entry.key);
                family.is_some_and(|family| family.heading == title)
            };
            let under: Vec<Folded> = lights.iter().filter(is_its).cloned().collect();
            if heading(&mut rows, title, under.len()) {
                rows.extend(under.into_iter().map(item));
            }
        }
        for place in Shelf::ALL {
            let others = app.bundled().iter().filter(|entry| !is_light(entry));
            let under = fold(others.filter(|e| e.shelf() == Some(place)));
            if heading(&mut rows, place.heading(), under.len()) {
                rows.extend(under.into_iter().map(item));
            }
        }
        rows
    }

    /// What a search finds, the best first.
    fn found(&mut self, app: &App) -> Vec<Row> {
        let own = &app.document().own;
        let is_still = |(of, _): &(Vec<Arc<Entry>>, Index)| {
            of.len() == own.len() && of.iter().zip(own).all(|(a, b)| Arc::ptr_eq(a, b))
        };
        if !self.index.as_ref().is_some_and(is_still) {
            let index = Index::of(own.iter().chain(app.bundled()));
            self.index = Some((own.clone(), index));
        }
        let found = self
            .index
            .iter()
            .flat_map(|(_, index)| index.search(&self.search));
        found
            .map(|row| Row::Item {
                entry: row.entry,
                in_file: None,
            })
            .collect()
    }

    fn item(
        &mut self,
        ui: &mut Ui,
        size: Vec2,
        (entry, in_file): (&Arc<Entry>, Option<[usize; 2]>),
        is_next: bool,
        (app, theme): (&App, Theme),
    ) -> Option<Command> {
        let document = app.document();
        let is_light = document.light.key == entry.key;
        let is_factor = document.factor.as_ref().is_some_and(|f| f.key == entry.key);
        let selected = is_light || is_factor;
        let overlay = document.overlays.iter().position(|o| o.key == entry.key);
        let overlaid = overlay.is_some();
        if let Some((key, text)) = &mut self.renaming
            && *key == entry.key
        {
            let edit = ui.add_sized(size, egui::TextEdit::singleline(text));
            let id = edit.id;
            edit.widget_info(|| egui::WidgetInfo::labeled(egui::Role::TextInput, true, "New name"));
            if edit.lost_focus() {
                let (key, name) = self.renaming.take()?;
                let name = name.trim().to_owned();
                let refused = name.is_empty() || ui.input(|i| i.key_pressed(egui::Key::Escape));
                return (!refused).then_some(Command::Rename { key, name });
            }
            ui.memory_mut(|m| m.request_focus(id));
            return None;
        }
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        response.widget_info(|| {
            egui::WidgetInfo::selected(egui::Role::Button, true, selected, row_name(entry))
        });
        let visuals = ui.visuals();
        if selected {
            ui.painter()
                .rect_filled(rect, 3.0, visuals.selection.bg_fill);
        } else if response.hovered() || response.has_focus() || is_next {
            ui.painter()
                .rect_filled(rect, 3.0, visuals.widgets.hovered.bg_fill);
        }
        if !self
            .art
            .get(&entry.key)
            .is_some_and(|(made_of, _)| Arc::ptr_eq(made_of, entry))
        {
            self.art
                .insert(entry.key.clone(), (entry.clone(), Art::of(entry)));
        }
        let (_, art) = self.art.get(&entry.key)?;
        let side = rect.height() - 12.0;
        let indent = in_file.map_or(0.0, |_| INDENT * theme.scale);
        let field = Rect::from_min_size(
            pos2(rect.left() + 4.0 + indent, rect.center().y - side / 2.0),
            Vec2::splat(side),
        );
        ui.painter()
            .rect_filled(field.expand(3.0), 3.0, theme.swatch_ground);
        ui.painter().rect_filled(field, 2.0, art.colour);
        let curve_width = (0.24 * rect.width()).clamp(30.0, 64.0);
        let curve = Rect::from_min_max(
            pos2(rect.right() - curve_width - 4.0, rect.top() + 7.0),
            pos2(rect.right() - 4.0, rect.bottom() - 7.0),
        );
        let text_colour = if selected {
            visuals.selection.stroke.color
        } else {
            visuals.text_color()
        };
        draw_curve(ui, curve, &art.curve, theme, text_colour);
        let mut name_right = curve.left() - 4.0;
        if let Some(overlay) = overlay {
            let mark = pos2(name_right - 5.0, rect.center().y);
            let inks = theme.inks.overlays;
            let stroke = Stroke::new(2.0, ink(inks[overlay % inks.len()]));
            ui.painter().circle_stroke(mark, 4.0, stroke);
            name_right -= 14.0;
        }
        let name_rect = Rect::from_min_max(
            pos2(field.right() + 10.0, rect.top()),
            pos2(name_right, rect.bottom()),
        );
        let font = egui::TextStyle::Body.resolve(ui.style());
        let common = in_file.unwrap_or_default();
        let name = elided(ui, &row_name(entry), common, &font, name_rect.width());
        let painter = ui
            .painter()
            .with_clip_rect(name_rect.intersect(ui.clip_rect()));
        let small = egui::TextStyle::Small.resolve(ui.style());
        let middle = rect.center().y;
        let lift = if art.what.is_empty() {
            0.0
        } else {
            8.0 * theme.scale
        };
        let at = pos2(name_rect.left(), middle - lift);
        painter.text(at, Align2::LEFT_CENTER, name, font, text_colour);
        let what = elided(ui, &art.what, [0; 2], &small, name_rect.width());
        let below = pos2(name_rect.left(), middle + 9.0 * theme.scale);
        let faint = if selected { text_colour } else { theme.faint };
        painter.text(below, Align2::LEFT_CENTER, what, small, faint);
        let add = self.compares || ui.input(|i| i.modifiers.command || i.modifiers.shift);
        let mut command = None;
        if response.clicked() {
            command = Some(if add {
                Command::ToggleOverlay(entry.clone())
            } else {
                Command::Show(entry.clone())
            });
        }
        response.context_menu(|ui| {
            if let Some(chosen) = self.menu(ui, app, entry, overlaid) {
                command = Some(chosen);
            }
        });
        response.on_hover_ui(|ui| describe(ui, entry));
        command
    }

    fn menu(
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

impl Art {
    fn of(entry: &Entry) -> Self {
        let samples = &entry.spectrum.samples;
        let outside = entry.kind().outside();
        // The highest of what stands between two points, so that no line falls through.
        let step = 400.0 / (CURVE_POINTS - 1) as f64;
        let highest_near = |i: usize| {
            let nm = (0..=STEPS_BETWEEN).map(|k| {
                let part = k as f64 / STEPS_BETWEEN as f64 - 0.5;
                380.0 + step * (i as f64 + part)
            });
            nm.map(|nm| samples.at(nm, outside))
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let values: Vec<f64> = (0..CURVE_POINTS).map(highest_near).collect();
        let top = values.iter().copied().fold(0.0, f64::max);
        let swatch = match entry.kind() {
            Kind::Light => {
                xyz_from_light(samples, Outside::Zero, Observer::Cie1931).map(Swatch::of_light)
            }
            Kind::Reflectance | Kind::Transmittance => {
                let light = crate::app::library::Library::bundled()
                    .find("cie_illuminants/CIE D65")
                    .ok()
                    .and_then(|p| p.spectrum());
                light.and_then(|light| {
                    let white: Xyz =
                        xyz_from_light(&light.samples, Outside::Zero, Observer::Cie1931)?;
                    let xyz = xyz_from_reflectance(samples, &light.samples, Observer::Cie1931)?;
                    Some(Swatch::of_patch(xyz, white, Adaptation::None))
                })
            }
            Kind::Absorbance | Kind::Weighting | Kind::Lines | Kind::Other => None,
        };
        let about = About::of(entry);
        let kelvin = about
            .kelvin
            .map(|k| format!("{:.0} K", 10.0 * (k / 10.0).round()));
        let words = Some(about.what).filter(|what| !what.is_empty());
        let what: Vec<String> = words.into_iter().chain(kelvin).collect();
        Self {
            what: what.join(", "),
            colour: swatch.map_or(Color32::from_gray(110), |s| swatch::colour(s.rgb8)),
            curve: values
                .iter()
                .map(|v| {
                    if top > 0.0 {
                        (v / top).clamp(0.0, 1.0) as f32
                    } else {
                        0.0
                    }
                })
                .collect(),
        }
    }
}

/// The name in the list: the CIE's 5 nm tables have the names of its 1 nm tables.
fn row_name(entry: &Entry) -> String {
    let is_coarse = entry
        .key
        .split_once('/')
        .is_some_and(|(group, _)| group.ends_with("_5nm") && group.starts_with("cie_"));
    if is_coarse {
        format!("{}, 5 nm", entry.name())
    } else {
        entry.name().to_owned()
    }
}

/// Height of a row, points.
const ROW: f32 = 40.0;

/// The lights on top of the library, three in a row.
fn favourites_row(
    ui: &mut Ui,
    app: &App,
    theme: Theme,
    compares: bool,
    commands: &mut Vec<Command>,
) {
    let all = favourites(app.bundled());
    ui.add_space(4.0);
    ui.label(egui::RichText::new("Favourites").small().color(theme.faint));
    for row in all.chunks(3) {
        ui.columns(3, |columns| {
            for (ui, favourite) in columns.iter_mut().zip(row) {
                let size = vec2(ui.available_width(), 26.0 * theme.scale);
                let button = egui::Button::new(favourite.label).truncate();
                let response = ui.add_sized(size, button);
                if response.clicked() {
                    let entry = favourite.entry.clone();
                    commands.push(if compares {
                        Command::ToggleOverlay(entry)
                    } else {
                        Command::Show(entry)
                    });
                }
                response.on_hover_text(favourite.entry.name());
            }
        });
    }
    ui.add_space(4.0);
}

fn heading(ui: &mut Ui, size: Vec2, title: &str, count: usize, folded: bool) -> bool {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, !folded, title));
    let visuals = ui.style().interact(&response);
    let font = egui::TextStyle::Body.resolve(ui.style());
    let middle = rect.center().y;
    ui.painter().text(
        pos2(rect.left() + 3.0, middle),
        Align2::LEFT_CENTER,
        if folded { "▸" } else { "▾" },
        font.clone(),
        visuals.fg_stroke.color,
    );
    ui.painter().text(
        pos2(rect.left() + 17.0, middle),
        Align2::LEFT_CENTER,
        title,
        font,
        ui.visuals().strong_text_color(),
    );
    ui.painter().text(
        pos2(rect.right() - 4.0, middle),
        Align2::RIGHT_CENTER,
        count.to_string(),
        egui::TextStyle::Small.resolve(ui.style()),
        ui.visuals().weak_text_color(),
    );
    response.clicked()
}

/// The name of a file of the user's own; whether it was clicked.
fn file_heading(ui: &mut Ui, size: Vec2, name: &str, count: usize, folded: bool) -> bool {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let words = format!("{name}, {count} spectra");
    response.widget_info(|| egui::WidgetInfo::selected(egui::Role::Button, true, !folded, &words));
    let colour = ui.style().interact(&response).fg_stroke.color;
    let small = egui::TextStyle::Small.resolve(ui.style());
    let (painter, middle) = (ui.painter(), rect.center().y);
    let mark = if folded { "▸" } else { "▾" };
    let left = pos2(rect.left() + 4.0, middle);
    painter.text(left, Align2::LEFT_CENTER, mark, small.clone(), colour);
    let right = pos2(rect.right() - 4.0, middle);
    let weak = ui.visuals().weak_text_color();
    let count = count.to_string();
    let counted = painter.text(right, Align2::RIGHT_CENTER, count, small.clone(), weak);
    let room = counted.left() - 6.0 - (rect.left() + 17.0);
    let name = elided(ui, name, [0; 2], &small, room);
    let left = pos2(rect.left() + 17.0, middle);
    painter.text(left, Align2::LEFT_CENTER, name, small, colour);
    response.on_hover_text(words).clicked()
}

fn draw_curve(ui: &Ui, rect: Rect, heights: &[f32], theme: Theme, colour: Color32) {
    let step = rect.width() / (heights.len().max(2) - 1) as f32;
    let points: Vec<_> = heights
        .iter()
        .enumerate()
        .map(|(i, h)| {
            pos2(
                rect.left() + i as f32 * step,
                rect.bottom() - h * rect.height(),
            )
        })
        .collect();
    let stroke = Stroke::new(
        if theme.scale > 1.0 { 1.6 } else { 1.0 },
        colour.gamma_multiply(0.75),
    );
    ui.painter().add(Shape::line(points, stroke));
}

/// Spectra of the user's own with a heading over those of a file that brought several.
fn by_file(entries: Vec<Arc<Entry>>, is_folded: impl Fn(&str) -> bool, rows: &mut Vec<Row>) {
    let mut places: HashMap<String, usize> = HashMap::new();
    let mut files: Vec<Vec<Arc<Entry>>> = Vec::new();
    for entry in entries {
        let file = entry.spectrum.source.clone();
        match places.get(&file) {
            Some(place) if !file.is_empty() => files[*place].push(entry),
            _ => {
                places.insert(file, files.len());
                files.push(vec![entry]);
            }
        }
    }
    for file in files {
        if file.len() == 1 {
            rows.extend(file.into_iter().map(|entry| Row::Item {
                entry,
                in_file: None,
            }));
            continue;
        }
        let name = file[0].spectrum.source.clone();
        let folded = is_folded(&name);
        rows.push(Row::File {
            count: file.len(),
            folded,
            name,
        });
        if folded {
            continue;
        }
        let in_file = Some(common(&file));
        rows.extend(file.into_iter().map(|entry| Row::Item { entry, in_file }));
    }
}

/// How many letters all names have in common at their beginning and, behind those, at their end.
fn common(entries: &[Arc<Entry>]) -> [usize; 2] {
    let mut names = entries.iter().map(|e| e.name().chars().collect::<Vec<_>>());
    let Some(first) = names.next() else {
        return [0; 2];
    };
    let same = |a: &mut dyn Iterator<Item = (char, char)>| a.take_while(|(a, b)| a == b).count();
    let (mut head, mut tail, mut least) = (first.len(), first.len(), first.len());
    for name in names {
        let forth = &mut first.iter().copied().zip(name.iter().copied());
        head = head.min(same(forth));
        let back = &mut first.iter().rev().copied().zip(name.iter().rev().copied());
        tail = tail.min(same(back));
        least = least.min(name.len());
    }
    let head = head.min(least);
    let tail = tail.min(least - head);
    // Whole words: "…column 1" tells more than "…1".
    let is_gap = |c: &char| !c.is_alphanumeric();
    let begun = first[..head].iter().rposition(|c| !is_gap(c)).unwrap_or(0);
    let head = first[..begun]
        .iter()
        .rposition(is_gap)
        .map_or(0, |at| at + 1);
    let behind = &first[first.len() - tail..];
    let tail = behind.iter().position(is_gap).map_or(0, |at| tail - at);
    [head, tail]
}

/// A name cut to a width, with an ellipsis in its middle: what tells names apart is often at the
/// end. Of letters that the names of a file have in common `[at the beginning, at the end]` only
/// what there is room for is left.
fn elided(ui: &Ui, text: &str, [head, tail]: [usize; 2], font: &FontId, width: f32) -> String {
    let fits = |text: &str| {
        let galley = ui
            .painter()
            .layout_no_wrap(text.to_owned(), font.clone(), Color32::WHITE);
        galley.size().x <= width
    };
    if fits(text) {
        return text.to_owned();
    }
    let mut letters: Vec<char> = text.chars().collect();
    if head + tail > 0 && head + tail < letters.len() {
        let own = &letters[head..letters.len() - tail];
        let dots = |count: usize| if count > 0 { "…" } else { "" };
        let own: String = own.iter().collect();
        let own = format!("{}{own}{}", dots(head), dots(tail));
        if fits(&own) {
            return own;
        }
        letters = own.chars().collect();
    }
    let cut = |kept: usize| -> String {
        let (head, tail) = (kept.div_ceil(2), kept / 2);
        letters[..head]
            .iter()
            .chain(['…'].iter())
            .chain(&letters[letters.len() - tail..])
            .collect()
    };
    let (mut good, mut too_many) = (0, letters.len());
    while too_many - good > 1 {
        let middle = usize::midpoint(good, too_many);
        if fits(&cut(middle)) {
            good = middle;
        } else {
            too_many = middle;
        }
    }
    cut(good)
}

fn describe(ui: &mut Ui, entry: &Entry) {
    let spectrum = &entry.spectrum;
    ui.set_max_width(380.0);
    ui.strong(entry.name());
    ui.label(format!(
        "{}, {} points, {} to {} nm{}",
        spectrum.kind,
        spectrum.samples.len(),
        spectrum.samples.first_nm(),
        spectrum.samples.last_nm(),
        if spectrum.unit.is_empty() {
            String::new()
        } else {
            format!(", {}", spectrum.unit)
        }
    ));
    if !spectrum.source.is_empty() {
        ui.weak(&spectrum.source);
    }
    if !entry.licence.is_empty() {
        ui.weak(format!("Licence: {}", entry.licence));
    }
    ui.weak("Click to show it. Ctrl or Shift and click to lay it over.");
}
