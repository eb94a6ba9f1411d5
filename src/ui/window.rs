//! The window: panels in their places, controls first, then what depends on them.

use std::{
    path::PathBuf,
    sync::{
        Arc,
        mpsc::{Receiver, Sender, channel},
    },
};

use eframe::egui;
use egui::{Context, Panel, Ui};

use super::{
    colour_view,
    dialogs::{self, Dialog, Outcome},
    files::{Ask, NO_DIALOG, Picked, Picker},
    keys::{self, Act},
    library_view::LibraryView,
    model_view, patches_view, picture,
    saver::Saver,
    spectrum_view::SpectrumView,
    spikes_view,
    theme::{self, Theme, Wake, waker},
    top_view::{self, Wish},
};
use crate::{
    app::{
        App, Command, Settings,
        export::{self, Export},
        open::{Loaded, Loader, load_bytes},
        plot_svg,
        spike_hand::SpikeAct,
        state::Tone,
        workspace::{Preferences, Restored, ZOOMS},
    },
    io::atomic::save_atomically,
};

/// What is waiting for a path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Saving {
    Text(Export),
    PlotPng,
    WindowPng,
}

/// A file dialog that is open on another thread.
struct Waiting {
    number: u64,
    saving: Option<Saving>,
}

/// The right panel's width: its tables fit, so that it does not jump with its content.
const RIGHT_WIDTH: f32 = 384.0;

/// A change is kept on disk this long after it was made, seconds.
const KEEP_AFTER: f64 = 0.7;

/// The program's window without the system's frame around it.
pub struct Window {
    /// The program.
    pub app: App,
    /// How the window looks.
    pub preferences: Preferences,
    /// Shows file dialogs; tests put their own here.
    pub picker: Picker,
    /// The plot and what is being dragged in it.
    pub spectrum: SpectrumView,
    library: LibraryView,
    loader: Loader,
    answers: (Sender<(u64, Picked)>, Receiver<(u64, Picked)>),
    said: (Sender<(Tone, String)>, Receiver<(Tone, String)>),
    waiting: Option<Waiting>,
    dialogs_shown: u64,
    dialog: Option<Dialog>,
    saving: Option<Saving>,
    saver: Option<Saver>,
    /// Revision and preferences on disk, and when something newer was first seen.
    kept: (u64, Preferences),
    changed_at: Option<f64>,
    /// Leaves out what changes from run to run (the time taken), for pictures in tests.
    pub quiet: bool,
    styled_for: Option<Preferences>,
    fonts_installed: bool,
    focus_search: bool,
}

impl Window {
    /// A window over a program. `saver` keeps the workspace; without one nothing is written.
    pub fn new(app: App, preferences: Preferences, picker: Picker, saver: Option<Saver>) -> Self {
        Self {
            kept: (app.revision(), preferences.clone()),
            app,
            preferences,
            picker,
            spectrum: SpectrumView::default(),
            library: LibraryView::default(),
            loader: Loader::default(),
            answers: channel(),
            said: channel(),
            waiting: None,
            dialogs_shown: 0,
            dialog: None,
            saving: None,
            saver,
            changed_at: None,
            quiet: false,
            styled_for: None,
            fonts_installed: false,
            focus_search: false,
        }
    }

    /// The program and preferences that a workspace brought back.
    pub fn restored(restored: Restored) -> (App, Preferences) {
        let mut app = App::with_document(restored.document);
        for loss in restored.losses {
            app.say(Tone::Problem, loss);
        }
        (app, restored.preferences.unwrap_or_default())
    }

    /// Opens files as if they had been chosen in the dialog.
    pub fn open_files(&mut self, paths: Vec<PathBuf>, wake: Wake) {
        if !paths.is_empty() {
            self.loader.open(paths, wake);
        }
    }

    /// Whether files are being read or a dialog is open.
    pub fn is_busy(&self) -> bool {
        self.loader.pending() > 0 || self.waiting.is_some()
    }

    /// The window's picture as it would be drawn at a size, without a display.
    pub fn picture(&self, size: [u32; 2]) -> Vec<u8> {
        picture::window_png(&self.app, &self.preferences, size)
    }

    /// One frame.
    pub fn show(&mut self, ui: &mut Ui) {
        let context = ui.ctx().clone();
        self.dress(&context);
        let theme = Theme::of(&self.preferences);
        self.take_in(ui);
        self.keys(&context);

        let mut commands = Vec::new();
        let mut wishes = Vec::new();
        Panel::top("top").show(ui, |ui| {
            ui.add_space(2.0);
            top_view::show(
                ui,
                &self.app,
                &mut self.preferences,
                theme,
                self.waiting.is_some(),
                &mut commands,
                &mut wishes,
            );
            ui.add_space(1.0);
        });
        let status_height = 22.0 * theme.scale;
        Panel::bottom("status")
            .exact_size(status_height)
            .show(ui, |ui| self.status(ui, theme));
        Panel::left("library")
            .default_size(224.0)
            .size_range(150.0..=460.0)
            .show(ui, |ui| {
                if std::mem::take(&mut self.focus_search) {
                    ui.memory_mut(|m| m.move_focus(egui::FocusDirection::Next));
                }
                self.library
                    .show(ui, &self.app, &mut self.preferences, theme, &mut commands);
            });
        for wish in wishes {
            self.fulfil(wish, &context);
        }
        self.apply(&mut commands);

        Panel::right("model")
            .default_size(RIGHT_WIDTH * theme.scale)
            .size_range(RIGHT_WIDTH * theme.scale..=760.0)
            .show(ui, |ui| {
                egui::ScrollArea::vertical()
                    .auto_shrink(false)
                    .show(ui, |ui| self.right_panel(ui, theme));
            });
        Panel::bottom("below")
            .default_size(156.0 * theme.scale)
            .size_range(90.0..=420.0)
            .resizable(true)
            .show(ui, |ui| self.below(ui, theme));
        egui::CentralPanel::default_margins().show(ui, |ui| {
            let wishes = self.spectrum.show(ui, &self.app, theme);
            let mut commands = wishes.commands;
            self.apply(&mut commands);
            for act in wishes.acts {
                self.app.act_on_spikes(act);
                context.request_repaint();
            }
            if wishes.gesture_ended {
                self.app.end_gesture();
            }
        });
        self.dialog(&context);
        if !context.input(|i| i.pointer.any_down()) {
            self.app.end_gesture();
        }
        self.keep(&context);
    }

    /// Fonts once, style whenever the looks change.
    fn dress(&mut self, context: &Context) {
        if !self.fonts_installed {
            theme::install_fonts(context);
            self.fonts_installed = true;
        }
        if self.styled_for.as_ref() != Some(&self.preferences) {
            let zoom_changed = self
                .styled_for
                .as_ref()
                .is_none_or(|p| p.zoom != self.preferences.zoom);
            theme::apply(context, &self.preferences);
            if zoom_changed {
                context.set_zoom_factor(self.preferences.zoom);
            }
            self.styled_for = Some(self.preferences.clone());
        }
    }

    /// What came from outside: files read, dialogs answered, files dropped, words of threads.
    fn take_in(&mut self, ui: &Ui) {
        for loaded in self.loader.finished() {
            self.take(loaded);
        }
        let dropped = ui.input(|i| i.raw.dropped_files.clone());
        let mut paths = Vec::new();
        for file in dropped {
            let path = file.path().to_owned();
            if path.is_file() {
                paths.push(path);
                continue;
            }
            let name = path.file_name().map_or_else(
                || "dropped file".to_owned(),
                |name| name.to_string_lossy().into_owned(),
            );
            match file.bytes() {
                Ok(bytes) => self.take(load_bytes(&name, &bytes)),
                Err(why) => self.app.say(Tone::Problem, format!("{name}: {why}")),
            }
        }
        self.open_files(paths, waker(ui.ctx()));
        let answers: Vec<(u64, Picked)> = self.answers.1.try_iter().collect();
        for (number, picked) in answers {
            let Some(waiting) = self.waiting.take_if(|w| w.number == number) else {
                continue;
            };
            self.picked(picked, waiting.saving, ui.ctx());
        }
        let said: Vec<(Tone, String)> = self.said.1.try_iter().collect();
        for (tone, text) in said {
            self.app.say(tone, text);
        }
        if let Some(why) = self.saver.as_ref().and_then(Saver::trouble) {
            self.app.say(Tone::Problem, why);
        }
    }

    fn take(&mut self, loaded: Loaded) {
        match loaded {
            Loaded::Spectra { path, spectra, how } => {
                if let Some(path) = path {
                    self.preferences.remember_file(&path);
                }
                let first = spectra.first().map(|s| s.notes.clone()).unwrap_or_default();
                let count = spectra.len();
                self.app.apply(Command::Adopt(spectra));
                let more = match count {
                    1 => String::new(),
                    _ => format!(" ({count} spectra, all in My files)"),
                };
                let odd = first.len().saturating_sub(1);
                let odd = match odd {
                    0 => String::new(),
                    _ => " More in its tooltip.".to_owned(),
                };
                self.app.say(Tone::Info, format!("{how}{more}.{odd}"));
            }
            Loaded::Project { path, restored } => {
                let losses = restored.losses.clone();
                self.app
                    .apply(Command::Replace(Box::new(restored.document)));
                self.app.say(Tone::Info, "Project opened.");
                for loss in losses {
                    self.app.say(Tone::Problem, loss);
                }
                if let Some(path) = path {
                    self.preferences.remember_file(&path);
                }
            }
            Loaded::Refused(why) => self.app.say(Tone::Problem, why),
        }
    }

    fn apply(&mut self, commands: &mut Vec<Command>) {
        for command in commands.drain(..) {
            self.app.apply(command);
        }
    }

    fn keys(&mut self, context: &Context) {
        if self.dialog.is_some() {
            return;
        }
        for act in keys::pressed(context) {
            self.act(act, context);
        }
    }

    fn act(&mut self, act: Act, context: &Context) {
        let settings = self.app.document().settings;
        let edit = |app: &mut App, settings: Settings| {
            app.apply(Command::Edit(settings));
            app.end_gesture();
        };
        const FINER: f64 = 1.25;
        match act {
            Act::Open => self.ask(Ask::Open, None, context),
            Act::TypePath => self.dialog = Some(Dialog::OpenPath(String::new())),
            Act::SaveProject => self.save(Saving::Text(Export::Project), context),
            Act::Undo => self.app.apply(Command::Undo),
            Act::Redo => self.app.apply(Command::Redo),
            Act::OrderDown => edit(
                &mut self.app,
                Settings {
                    order: settings.order.saturating_sub(1),
                    ..settings
                },
            ),
            Act::OrderUp => edit(
                &mut self.app,
                Settings {
                    order: settings.order + 1,
                    ..settings
                },
            ),
            Act::ThresholdDown => edit(
                &mut self.app,
                Settings {
                    threshold_percent: settings.threshold_percent / FINER,
                    ..settings
                },
            ),
            Act::ThresholdUp => edit(
                &mut self.app,
                Settings {
                    threshold_percent: settings.threshold_percent * FINER,
                    ..settings
                },
            ),
            Act::ResetView => self.spectrum.reset(),
            Act::Theme => self.preferences.dark = !self.preferences.dark,
            Act::Projector => self.preferences.projector = !self.preferences.projector,
            Act::Search => self.focus_search = true,
            Act::ZoomIn => self.zoom(self.preferences.zoom + 0.1),
            Act::ZoomOut => self.zoom(self.preferences.zoom - 0.1),
            Act::ZoomReset => self.zoom(1.0),
            Act::Shortcuts => self.dialog = Some(Dialog::Shortcuts),
            Act::CopyPicture => {
                let size = context.content_rect().size();
                let image = picture::window_image(
                    &self.app,
                    &self.preferences,
                    [size.x as u32, size.y as u32],
                );
                context.copy_image(image);
                self.app
                    .say(Tone::Info, "A picture of the window was copied.");
            }
        }
    }

    fn zoom(&mut self, zoom: f32) {
        self.preferences.zoom = ((zoom * 10.0).round() / 10.0).clamp(ZOOMS[0], ZOOMS[1]);
    }

    fn fulfil(&mut self, wish: Wish, context: &Context) {
        match wish {
            Wish::Act(act) => self.act(act, context),
            Wish::Recent(index) => {
                let path = self.preferences.recent.get(index).cloned();
                self.open_files(path.into_iter().collect(), waker(context));
            }
            Wish::Save(export) => self.save(Saving::Text(export), context),
            Wish::SavePlotPng => self.save(Saving::PlotPng, context),
            Wish::SaveWindowPng => self.save(Saving::WindowPng, context),
            Wish::Copy(export) => {
                let theme = plot_svg::Theme::Light;
                match export.text(&self.app, theme) {
                    Ok(text) => {
                        context.copy_text(text.trim_end().to_owned());
                        self.app
                            .say(Tone::Info, format!("Copied: {}.", export.title()));
                    }
                    Err(why) => self.app.say(Tone::Problem, why),
                }
            }
            Wish::About => self.dialog = Some(Dialog::About(None)),
        }
    }

    /// Asks for a path in the system's dialog, on a thread of its own.
    fn ask(&mut self, ask: Ask, saving: Option<Saving>, context: &Context) {
        if self.waiting.is_some() {
            return;
        }
        self.dialogs_shown += 1;
        let number = self.dialogs_shown;
        self.waiting = Some(Waiting { number, saving });
        let (picker, answers, wake) = (
            Arc::clone(&self.picker),
            self.answers.0.clone(),
            waker(context),
        );
        std::thread::spawn(move || {
            let picked = picker(&ask);
            // Nobody listens any more once the window is closed.
            let _ = answers.send((number, picked));
            wake();
        });
    }

    fn save(&mut self, saving: Saving, context: &Context) {
        let suggested = self.suggested_name(saving);
        let extension = match saving {
            Saving::Text(export) => export.extension(),
            Saving::PlotPng | Saving::WindowPng => "png",
        };
        self.ask(
            Ask::Save {
                suggested,
                extension,
            },
            Some(saving),
            context,
        );
    }

    fn suggested_name(&self, saving: Saving) -> String {
        match saving {
            Saving::Text(export) => export.suggested_name(&self.app),
            Saving::PlotPng => format!("{}.png", export::file_stem(&self.app)),
            Saving::WindowPng => format!("{}-window.png", export::file_stem(&self.app)),
        }
    }

    fn picked(&mut self, picked: Picked, saving: Option<Saving>, context: &Context) {
        match (picked, saving) {
            (Picked::Paths(paths), None) => self.open_files(paths, waker(context)),
            (Picked::Paths(paths), Some(saving)) => {
                if let Some(path) = paths.into_iter().next() {
                    self.write(saving, path, context);
                }
            }
            (Picked::Cancelled, _) => self.app.say(Tone::Info, "No file chosen."),
            (Picked::NoDialog, None) => {
                self.app.say(Tone::Problem, NO_DIALOG);
                self.dialog = Some(Dialog::OpenPath(String::new()));
            }
            (Picked::NoDialog, Some(saving)) => {
                self.app.say(Tone::Problem, NO_DIALOG);
                self.dialog = Some(Dialog::SavePath(self.suggested_name(saving)));
                self.saving = Some(saving);
            }
        }
    }

    /// Writes on a thread of its own: a picture takes longer than a frame.
    fn write(&mut self, saving: Saving, path: PathBuf, context: &Context) {
        let (app, preferences) = (self.app.clone(), self.preferences.clone());
        let (said, wake) = (self.said.0.clone(), waker(context));
        let size = context.content_rect().size();
        std::thread::spawn(move || {
            let theme = if preferences.dark {
                plot_svg::Theme::Dark
            } else {
                plot_svg::Theme::Light
            };
            let bytes = match saving {
                Saving::Text(export) => export.text(&app, theme).map(String::into_bytes),
                Saving::PlotPng => Ok(picture::plot_png(&app, theme, [1200, 760])),
                Saving::WindowPng => Ok(picture::window_png(
                    &app,
                    &preferences,
                    [size.x as u32, size.y as u32],
                )),
            };
            let written =
                bytes.and_then(|bytes| save_atomically(&path, &bytes).map_err(|e| e.to_string()));
            let message = match written {
                Ok(()) => (
                    Tone::Info,
                    format!(
                        "Saved {} ({}).",
                        path.display(),
                        app.document().scale.words()
                    ),
                ),
                Err(why) => (Tone::Problem, why),
            };
            // Nobody listens any more once the window is closed.
            let _ = said.send(message);
            wake();
        });
    }

    fn right_panel(&mut self, ui: &mut Ui, theme: Theme) {
        let mut commands = Vec::new();
        model_view::controls(ui, &self.app, theme, &mut commands);
        self.apply(&mut commands);
        model_view::curve(ui, &self.app, &mut self.preferences, theme, &mut commands);
        let moved = !commands.is_empty();
        self.apply(&mut commands);
        if moved {
            // The curve was drawn before its own click: show the new order at once.
            ui.ctx().request_discard("the order curve was clicked");
        }
        ui.add_space(2.0);
        ui.separator();
        colour_view::show(ui, &self.app, theme);
    }

    fn below(&mut self, ui: &mut Ui, theme: Theme) {
        let mut commands = Vec::new();
        let mut acts: Vec<SpikeAct> = Vec::new();
        ui.horizontal_wrapped(|ui| {
            let spikes = self.app.derived().parts.spikes.len();
            let below = &mut self.preferences.spikes_below;
            if ui
                .selectable_label(!*below, "Through reflectances")
                .on_hover_text("Patches under the measured light and under the model.")
                .clicked()
            {
                *below = false;
            }
            if ui
                .selectable_label(*below, format!("Spikes ({spikes})"))
                .on_hover_text("The spikes as a table to edit.")
                .clicked()
            {
                *below = true;
            }
            ui.separator();
            if self.preferences.spikes_below {
                spikes_view::head(ui, &self.app, &mut acts);
            } else {
                patches_view::head(ui, &self.app, &mut commands);
            }
        });
        self.apply(&mut commands);
        if self.preferences.spikes_below {
            spikes_view::table(ui, &self.app, theme, &mut acts);
        } else {
            patches_view::patches(ui, &self.app, theme, &mut commands);
        }
        self.apply(&mut commands);
        for act in acts {
            self.app.act_on_spikes(act);
        }
    }

    fn status(&mut self, ui: &mut Ui, theme: Theme) {
        ui.horizontal_centered(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if !self.quiet {
                    let ms = 1e3 * self.app.took().as_secs_f64();
                    ui.weak(format!("recomputed in {ms:.2} ms")).on_hover_text(
                        "Time for fit, errors, colours, patches and the order curve.",
                    );
                }
                if self.loader.pending() > 0 {
                    ui.spinner();
                    ui.label(format!("reading {} files", self.loader.pending()));
                }
                if self.waiting.is_some() {
                    if ui
                        .small_button("stop waiting")
                        .on_hover_text("Gives up on the file dialog; a late answer is ignored.")
                        .clicked()
                    {
                        self.waiting = None;
                    }
                    ui.label("file dialog open");
                }
                ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
                    let Some(message) = self.app.message() else {
                        ui.weak("Move N and the threshold; click a patch; drag a spike.");
                        return;
                    };
                    if message.tone == Tone::Problem {
                        ui.colored_label(theme.warning, "▲");
                    }
                    ui.add(egui::Label::new(&message.text).truncate());
                });
            });
        });
    }

    fn dialog(&mut self, context: &Context) {
        let Some(dialog) = &mut self.dialog else {
            return;
        };
        match dialogs::show(context, dialog) {
            Outcome::Open => return,
            Outcome::Closed => {}
            Outcome::OpenPath(path) => self.open_files(vec![path], waker(context)),
            Outcome::SavePath(path) => {
                if let Some(saving) = self.saving.take() {
                    self.write(saving, path, context);
                }
            }
        }
        self.dialog = None;
    }

    /// Keeps the workspace on disk, a moment after it changed.
    fn keep(&mut self, context: &Context) {
        let now = context.input(|i| i.time);
        let present = (self.app.revision(), self.preferences.clone());
        if self.saver.is_none() || present == self.kept {
            self.changed_at = None;
            return;
        }
        let since = *self.changed_at.get_or_insert(now);
        if now - since >= KEEP_AFTER {
            self.keep_now();
        } else {
            let left = std::time::Duration::from_secs_f64(KEEP_AFTER - (now - since) + 0.01);
            context.request_repaint_after(left);
        }
    }

    /// Hands the workspace to the saver at once.
    pub fn keep_now(&mut self) {
        if let Some(saver) = &self.saver {
            saver.keep(self.app.document(), &self.preferences);
            self.kept = (self.app.revision(), self.preferences.clone());
            self.changed_at = None;
        }
    }
}
