//! The window: panels in their places, controls first, then what depends on them.

mod acts;
mod filing;
mod images;
mod importing;

use std::sync::mpsc::{Receiver, Sender, channel};

use eframe::egui;
use egui::{Context, Panel, Ui};

use super::{
    batch_view::{self, BatchView},
    colour_view, curve_view,
    dialogs::Dialog,
    files::{Picked, Picker},
    import_view::ImportView,
    library_view::LibraryView,
    makers_view::MakersView,
    model_view,
    pages::{self, PageContext, Pages},
    patches_view, picture,
    saver::Saver,
    spectrum_view::SpectrumView,
    spend_view::SpendView,
    spikes_view,
    theme::{self, Theme},
    top_view,
};
use crate::app::{
    App, Command,
    already_open::Places,
    import::Origins,
    open::Loader,
    pages::Page,
    picture::{reload::ReloadJob, shown},
    plot_svg,
    spike_hand::SpikeAct,
    state::Tone,
    studies::Studies,
    workspace::{Preferences, Restored, StoredImage},
};
use filing::{Saving, Waiting};

/// Messages that the status line's tooltip tells.
const MESSAGES_SHOWN: usize = 12;

/// Both ends of a queue that other threads write to.
type Channel<T> = (Sender<T>, Receiver<T>);

/// The right panel's width: its tables fit, so that it does not jump with its content.
const RIGHT_WIDTH: f32 = 392.0;

/// How often the progress of a computation is looked at.
const WATCH_EVERY: std::time::Duration = std::time::Duration::from_millis(80);

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
    batch: BatchView,
    images: ReloadJob,
    /// Images of a workspace or project that are to be read again.
    stored_images: Vec<StoredImage>,
    answers: Channel<(u64, Picked)>,
    said: Channel<(Tone, String)>,
    /// Threads that are writing a file.
    writing: Vec<std::thread::JoinHandle<()>>,
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
    /// Long computations; pictures wait for them.
    pub studies: Studies,
    pages: Pages,
    spend: SpendView,
    /// How a file was read, while it is looked at.
    import: ImportView,
    makers: MakersView,
    origins: Origins,
    places: Places,
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
            batch: BatchView::default(),
            images: ReloadJob::default(),
            stored_images: Vec::new(),
            answers: channel(),
            said: channel(),
            writing: Vec::new(),
            waiting: None,
            dialogs_shown: 0,
            dialog: None,
            saving: None,
            saver,
            changed_at: None,
            quiet: false,
            styled_for: None,
            fonts_installed: false,
            studies: Studies::default(),
            pages: Pages::default(),
            spend: SpendView::default(),
            import: ImportView::default(),
            makers: MakersView::default(),
            origins: Origins::default(),
            places: Places::default(),
        }
    }

    /// The program and preferences that a workspace brought back, and the images that are to be
    /// read again ([`Window::bring_back`]).
    pub fn restored(restored: Restored) -> (App, Preferences, Vec<StoredImage>) {
        let mut app = App::with_document(restored.document);
        for loss in restored.losses {
            app.say(Tone::Problem, loss);
        }
        let preferences = restored.preferences.unwrap_or_default();
        (app, preferences, restored.images)
    }

    /// Whether files are being read or a dialog is open.
    pub fn is_busy(&self) -> bool {
        self.loader.is_busy() || self.waiting.is_some() || !self.images.waiting().is_empty()
    }

    /// The window's picture as it would be drawn at a size, without a display.
    pub fn picture(&self, size: [u32; 2]) -> Vec<u8> {
        picture::window_png(&self.app, &self.preferences, size)
    }

    /// The theme of files that are written now.
    pub fn file_theme(&self) -> plot_svg::Theme {
        if self.preferences.dark {
            plot_svg::Theme::Dark
        } else {
            plot_svg::Theme::Light
        }
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
                (self.waiting.is_some(), self.batch.has_summary()),
                &mut commands,
                &mut wishes,
            );
            ui.add_space(1.0);
        });
        let status_height = 22.0 * theme.scale;
        Panel::bottom("status")
            .exact_size(status_height)
            .show(ui, |ui| in_its_size(ui, |ui| self.status(ui, theme)));
        if !self.preferences.no_library {
            Panel::left("library")
                .default_size(224.0)
                .size_range(150.0..=460.0)
                .show(ui, |ui| {
                    self.library
                        .show(ui, &self.app, &mut self.preferences, theme, &mut commands);
                });
        }
        for wish in wishes {
            self.fulfil(wish, &context);
        }
        self.apply(&mut commands);

        // Large type needs another width: each keeps its own.
        let right = if self.preferences.projector {
            "model, projector"
        } else {
            "model"
        };
        Panel::right(right)
            .default_size(RIGHT_WIDTH * theme.scale)
            .size_range(RIGHT_WIDTH * theme.scale..=760.0)
            .show(ui, |ui| {
                in_its_size(ui, |ui| {
                    egui::ScrollArea::vertical()
                        .auto_shrink(false)
                        .show(ui, |ui| self.right_panel(ui, theme));
                });
            });
        let on_spectrum = self.preferences.pages.page == Page::Spectrum;
        if on_spectrum {
            Panel::bottom("below")
                .default_size(156.0 * theme.scale)
                .size_range(90.0..=420.0)
                .resizable(true)
                .show(ui, |ui| in_its_size(ui, |ui| self.below(ui, theme)));
        }
        self.studies.take_in();
        if self.studies.is_running() {
            context.request_repaint_after(WATCH_EVERY);
        }
        let mut centre = ui.max_rect();
        egui::CentralPanel::default_margins().show(ui, |ui| {
            centre = ui.max_rect();
            pages::tabs(ui, &mut self.preferences.pages.page);
            if !on_spectrum {
                self.page(ui, theme);
                return;
            }
            let wishes = self.spectrum.show(ui, &self.app, theme);
            let mut commands = wishes.commands;
            self.apply(&mut commands);
            let before = self.app.revision();
            for act in wishes.acts {
                self.app.act_on_spikes(act);
            }
            if self.app.revision() != before {
                // The plot was drawn before the drag moved the spike.
                context.request_repaint();
            }
            if wishes.gesture_ended {
                self.app.end_gesture();
            }
        });
        // What lies above the summary has the keys first.
        let keys_are_free = self.dialog.is_none() && self.import.now.is_none();
        if let Some(wish) = self.batch.window(&context, theme, keys_are_free) {
            self.fulfil_of_batch(wish, &context);
        }
        self.importing(&context, theme, centre);
        self.dialog(&context);
        // A number typed key by key is one gesture, as a drag is.
        if !context.input(|i| i.pointer.any_down()) && !context.text_edit_focused() {
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

    fn apply(&mut self, commands: &mut Vec<Command>) {
        for command in commands.drain(..) {
            self.app.apply(command);
        }
    }

    /// A page beside the spectrum.
    fn page(&mut self, ui: &mut Ui, theme: Theme) {
        let context = ui.ctx().clone();
        let (mut commands, mut wishes) = (Vec::new(), Vec::new());
        // Every page keeps its own place in its scroll area.
        let salt = self.preferences.pages.page.word();
        let (pages, page_ui) = (
            &mut self.pages,
            &mut ui.new_child(egui::UiBuilder::new().id_salt(salt)),
        );
        pages.show(
            page_ui,
            &mut PageContext {
                app: &self.app,
                studies: &mut self.studies,
                memory: &mut self.preferences.pages,
                theme,
                wake: &theme::waker(&context),
                commands: &mut commands,
                wishes: &mut wishes,
                quiet: self.quiet,
            },
        );
        for wish in wishes {
            self.save_chart(wish, &context);
        }
        if !commands.is_empty() {
            // The right panel was drawn before the page's click.
            context.request_repaint();
        }
        self.apply(&mut commands);
    }

    fn right_panel(&mut self, ui: &mut Ui, theme: Theme) {
        let mut commands = Vec::new();
        self.tell_whose_model(ui);
        model_view::controls(ui, &self.app, &mut commands);
        self.apply(&mut commands);
        curve_view::show(ui, &self.app, &mut self.preferences, theme, &mut commands);
        let moved = !commands.is_empty();
        self.apply(&mut commands);
        if moved {
            // The curve was drawn before its own click: show the new order at once.
            ui.ctx().request_discard("the order curve was clicked");
        }
        self.spend(ui);
        ui.add_space(2.0);
        ui.separator();
        if !self.makers.tabs(ui, &self.app) {
            let is_titled = !self.app.document().subject_entry().makers.is_empty();
            colour_view::show(ui, &self.app, theme, is_titled);
        } else if let Some(words) = self.makers.show(ui, &self.app) {
            self.app.say(Tone::Info, words);
        }
    }

    /// On the page of images the panel may be of another spectrum than the picture's frame.
    fn tell_whose_model(&self, ui: &mut Ui) {
        let pages = &self.preferences.pages;
        let document = self.app.document();
        let Some(image) = shown(document, &pages.image).filter(|_| pages.page == Page::Image)
        else {
            return;
        };
        let chosen = image.image.name_of(pages.image.rect(&image.image.cube));
        let subject = document.subject_entry().name();
        if subject != chosen {
            let words = format!(
                "This panel is of {subject}, not of the pixels chosen in the picture; \"{}\" brings \
                 those here.",
                pages::image_view::names::TAKE
            );
            ui.add(egui::Label::new(egui::RichText::new(words).small().weak()).wrap());
        }
    }

    /// "Spend 21 numbers for me."
    fn spend(&mut self, ui: &mut Ui) {
        let mut commands = Vec::new();
        let wake = theme::waker(ui.ctx());
        let outcome = self.spend.show(
            ui,
            &self.app,
            &mut self.studies,
            &mut self.preferences.pages,
            &wake,
            &mut commands,
        );
        if !commands.is_empty() {
            // The model's knobs stand above and were drawn before.
            ui.ctx().request_repaint();
        }
        self.apply(&mut commands);
        if let Some((tone, words)) = outcome {
            self.app.say(tone, words);
        }
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
        let mut wants_summary = false;
        ui.horizontal_centered(|ui| {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                if !self.quiet {
                    let ms = 1e3 * self.app.took().as_secs_f64();
                    ui.weak(format!("recomputed in {ms:.2} ms")).on_hover_text(
                        "Time for fit, errors, colours, patches and the order curve.",
                    );
                }
                if let Some(progress) = self.loader.progress() {
                    // What was read is fetched in the next frame; until then it goes on.
                    ui.ctx().request_repaint_after(WATCH_EVERY);
                    if batch_view::progress(ui, &progress) {
                        self.loader.cancel();
                        ui.ctx().request_repaint();
                    }
                }
                let images = self.images.waiting().len();
                if images > 0 {
                    ui.spinner();
                    ui.label(format!("reading {images} images again"));
                }
                self.offer_to_forget(ui);
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
                    let Some(message) = self.app.current_message() else {
                        let page = self.preferences.pages.page;
                        ui.weak(match page {
                            Page::Spectrum => {
                                "Move N and the threshold; click a patch; drag a spike."
                            }
                            page => page.meaning(),
                        });
                        return;
                    };
                    if message.tone == Tone::Problem {
                        ui.colored_label(theme.warning, "▲");
                    }
                    if self.batch.is_told_by(&message.text) {
                        wants_summary = ui
                            .small_button("Each file…")
                            .on_hover_text("How each file was read, or why it was refused.")
                            .clicked();
                    }
                    ui.add(egui::Label::new(&message.text).truncate())
                        .on_hover_ui(|ui| {
                            let messages = self.app.messages();
                            let last = messages.len().saturating_sub(MESSAGES_SHOWN);
                            for message in &messages[last..] {
                                ui.label(&message.text);
                            }
                        });
                });
            });
        });
        if wants_summary {
            self.batch.show();
        }
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

    /// Waits until every file that is being saved is on disk; called when the window closes.
    pub fn finish_writing(&mut self) {
        for thread in self.writing.drain(..) {
            // A thread that failed has nothing left to wait for.
            let _ = thread.join();
        }
    }

    /// A button that gives up the images of the last time that were not found.
    fn offer_to_forget(&mut self, ui: &mut Ui) {
        let lost = self.images.lost();
        if lost.is_empty() {
            return;
        }
        let words = match lost.len() {
            1 => "forget 1 missing image".to_owned(),
            count => format!("forget {count} missing images"),
        };
        let names: Vec<String> = lost.iter().map(|l| l.path.display().to_string()).collect();
        let forgets = ui.small_button(words).on_hover_text(format!(
            "Not found this time: {}. They are looked for again at every start until you forget \
             them.",
            names.join(", ")
        ));
        if forgets.clicked() {
            self.images.give_up();
            self.keep_now();
        }
    }

    /// Hands the workspace to the saver at once.
    pub fn keep_now(&mut self) {
        if let Some(saver) = &self.saver {
            saver.keep_with(
                self.app.document(),
                &self.preferences,
                &self.images.absent(),
            );
            self.kept = (self.app.revision(), self.preferences.clone());
            self.changed_at = None;
        }
    }
}

/// Contents in a panel that neither grows nor shrinks with them.
fn in_its_size(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    let room = ui.available_rect_before_wrap();
    let mut inner = ui.new_child(egui::UiBuilder::new().max_rect(room));
    // Frames of what has the keyboard's focus reach a little beyond.
    inner.shrink_clip_rect(room.expand(3.0));
    add(&mut inner);
    ui.advance_cursor_after_rect(room);
}
