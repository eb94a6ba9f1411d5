//! The library: shelves of spectra, each with a swatch, a name and a small curve.

use std::{collections::HashMap, sync::Arc};

use eframe::egui;
use egui::{Align2, Key, Sense, Ui, Vec2, pos2, vec2};

use super::{
    entry_row::{Painted, elided, row_name},
    theme::{Theme, ink},
};
use crate::{
    app::{
        App, Command, Entry,
        families::Families,
        recipe::Recipe,
        search::{Folded, Index, favourites, fold},
        workspace::Preferences,
    },
    preset::Shelf,
    spectrum::Kind,
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
        let text_colour = if selected {
            visuals.selection.stroke.color
        } else {
            visuals.text_color()
        };
        let marked = overlay.map(|overlay| {
            let inks = theme.inks.overlays;
            ink(inks[overlay % inks.len()])
        });
        let painted = Painted {
            indent: in_file.map_or(0.0, |_| INDENT * theme.scale),
            common: in_file.unwrap_or_default(),
            marked,
            ink: text_colour,
            faint: if selected { text_colour } else { theme.faint },
            scale: theme.scale,
        };
        painted.show(ui, rect, entry);
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
