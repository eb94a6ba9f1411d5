//! The window: panels in their places, controls first, then what depends on them.

mod acts;
mod batch;
mod checks;
mod column;
mod filing;
mod following;
mod images;
mod importing;
mod lesson;
mod notices;
mod page;
mod panels;
mod printing;
mod status;

use std::path::PathBuf;

use eframe::egui;
use egui::{Context, Ui};

use super::{
    batch_view::BatchView,
    dialogs::Dialog,
    eyes,
    files::{Picker, Printer},
    import_view::ImportView,
    lesson_view::LessonView,
    library_view::LibraryView,
    lights_quality_view::LightsQualityView,
    look_view::LookView,
    makers_view::MakersView,
    pages::Pages,
    palette_view::PaletteView,
    saver::Saver,
    system_printer,
    theme::{self, Theme},
    top_view::Drawer,
    verdict_view::Side,
};
use crate::app::{
    App, Command, Memo, Pair, Tone, chart,
    following::Following,
    lessons::Run,
    open::Loader,
    pages::Page,
    picture::reload::ReloadJob,
    studies::Studies,
    worker::Worker,
    workspace::{Preferences, Restored, StoredImage},
};
use crate::languages::{self, Language};
use checks::LessonChecks;
use filing::{Saving, Waiting};

/// How often the progress of a computation is looked at.
const WATCH_EVERY: std::time::Duration = std::time::Duration::from_millis(80);

/// The program's window without the system's frame around it.
pub struct Window {
    /// The program.
    pub app: App,
    /// How the window looks.
    pub preferences: Preferences,
    /// Shows file dialogs; tests put their own here.
    pub picker: Picker,
    /// The first screen: plot, knobs and patches.
    pub look: LookView,
    library: LibraryView,
    /// The library.
    pub drawer: Drawer,
    /// What of the model's column is shown.
    pub side: Side,
    /// Whether the column is open: by itself where there is room, else as a hand left it.
    side_open: Option<bool>,
    /// A menu or list was open when the frame began: Escape is for it.
    menu_open: bool,
    palette: PaletteView,
    loader: Loader,
    batch: BatchView,
    /// How good the lights of a batch are.
    lights_quality: LightsQualityView,
    images: ReloadJob,
    /// Images of a workspace or project that are to be read again.
    stored_images: Vec<StoredImage>,
    /// Files that are being written, each with what is to be said of it.
    writing: Vec<Worker<(Tone, String)>>,
    waiting: Option<Waiting>,
    dialog: Option<Dialog>,
    saving: Option<Saving>,
    saver: Option<Saver>,
    /// Revision and preferences that the saver has.
    kept: (u64, Preferences),
    /// The ways to begin stand over the first screen.
    greets: bool,
    /// What was said last was said in this language.
    spoken: Language,
    /// Leaves out what changes from run to run (the time taken), for pictures in tests.
    pub quiet: bool,
    styled_for: Option<Preferences>,
    fonts_installed: bool,
    /// Long computations; pictures wait for them.
    pub studies: Studies,
    pages: Pages,
    /// The light that is followed.
    pub(super) following: Option<Following>,
    /// How a file was read, while it is looked at.
    import: ImportView,
    makers: MakersView,
    /// The lesson that is being taken, and when it shows the next thing.
    lesson: Option<Run>,
    lesson_view: LessonView,
    /// Where its column ended in the last frame, points.
    lesson_ends: f32,
    shows_next_at: f64,
    /// Where own lessons are kept; `None` keeps none.
    lessons_folder: Option<PathBuf>,
    /// Whether the list of lessons was in sight in the last frame.
    lists_lessons: bool,
    /// Lessons of files that are being checked.
    lesson_checks: LessonChecks,
    /// What is to be noticed on a page, and a question to try.
    foot_words: Memo<(u64, Page), (String, String)>,
    /// Whether there was a second light in the last frame.
    had_second: bool,
    /// Two surfaces side by side.
    pair_shown: Memo<u64, Option<Pair>>,
    /// Where files were dropped that are being read, and what of them was refused.
    dropped_at: Option<egui::Pos2>,
    refusal: Option<notices::Refusal>,
    /// Opens a page that prints itself; tests put their own here.
    pub printer: Printer,
    /// Where the program is a page: its address, without what a link opens.
    pub address: Option<String>,
}

/// Size of the smallest layout that stands at its own scale, points before any zoom. A zoom leaves
/// fewer: who asked for larger type gets it.
const LEAST_LAYOUT: egui::Vec2 = egui::vec2(900.0, 600.0);
/// Scaled by less, no word could be read.
const LEAST_SCALE: f32 = 0.25;

/// The scale at which the smallest layout fits into the window; 1 in a larger one.
fn fitting(context: &Context) -> f32 {
    let size = context.viewport_rect().size() * context.zoom_factor();
    match size.min_elem() > 1.0 {
        true => (size / LEAST_LAYOUT).min_elem().clamp(LEAST_SCALE, 1.0),
        // A minimised window has no size.
        false => 1.0,
    }
}

impl Window {
    /// A window over a program. `saver` keeps the workspace; without one nothing is written.
    pub fn new(
        app: App,
        mut preferences: Preferences,
        picker: Picker,
        saver: Option<Saver>,
    ) -> Self {
        preferences.note_page();
        Self {
            kept: (app.changes(), preferences.clone()),
            had_second: app.document().second.is_some(),
            lessons_folder: saver
                .as_ref()
                .filter(|_| !cfg!(target_arch = "wasm32"))
                .map(|s| s.path().with_file_name("lessons")),
            lists_lessons: false,
            app,
            preferences,
            picker,
            look: LookView::default(),
            library: LibraryView::default(),
            drawer: Drawer::default(),
            side: Side::default(),
            side_open: None,
            menu_open: false,
            palette: PaletteView::default(),
            loader: Loader::default(),
            batch: BatchView::default(),
            lights_quality: LightsQualityView::default(),
            images: ReloadJob::default(),
            stored_images: Vec::new(),
            writing: Vec::new(),
            waiting: None,
            dialog: None,
            saving: None,
            saver,
            greets: false,
            quiet: false,
            spoken: languages::spoken(),
            styled_for: None,
            fonts_installed: false,
            studies: Studies::default(),
            pages: Pages::default(),
            following: None,
            import: ImportView::default(),
            makers: MakersView::default(),
            lesson: None,
            lesson_view: LessonView::default(),
            lesson_ends: 0.0,
            shows_next_at: 0.0,
            lesson_checks: LessonChecks::default(),
            foot_words: Memo::default(),
            pair_shown: Memo::default(),
            dropped_at: None,
            refusal: None,
            printer: system_printer(),
            address: None,
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
        self.loader.is_busy()
            || self.lesson_checks.is_busy()
            || self.waiting.is_some()
            || !self.images.waiting().is_empty()
    }

    /// The theme of files that are written now.
    pub fn file_theme(&self) -> chart::Theme {
        Theme::of(&self.preferences).of_charts()
    }

    /// One frame.
    pub fn show(&mut self, ui: &mut Ui) {
        let context = ui.ctx().clone();
        self.speak();
        self.preferences.grown = theme::grown(ui.max_rect().size());
        self.note_touch(&context);
        self.dress(&context);
        let theme = Theme::of(&self.preferences);
        self.menu_open = egui::Popup::is_any_open(&context);
        self.take_in(ui);
        self.follow_on(&context);
        self.lesson_goes_on(&context);
        self.keys(&context);
        self.follow_second();

        let shape = self.shape(ui, theme);
        let mut centre = ui.available_rect_before_wrap();
        if !shape.present {
            self.bar(ui, shape, &context);
            self.following_bar(ui, theme);
            self.foot(ui, shape, theme);
            self.rail(ui, shape, theme);
        }
        self.lesson_panel(ui, theme);
        self.drawer(ui, shape, theme);
        let column = self.side_panel(ui, shape, theme);
        self.studies.take_in();
        if self.studies.is_running() || self.lesson_checks.is_busy() {
            context.request_repaint_after(WATCH_EVERY);
        }
        if !self.side_alone(shape) {
            centre = self.page_panel(ui, shape, theme);
        }
        if let Some(mut column) = column {
            self.column(&mut column, theme);
        }
        self.lesson_ring(&context, theme);
        self.take_colour(&context);
        self.palette(&context);
        self.greeting(&context, theme);
        self.show_refusal(&context, theme);
        // What lies above the summary has the keys first.
        let keys_are_free =
            self.dialog.is_none() && self.import.now.is_none() && !self.palette.is_open();
        if let Some(wish) = self.batch.window(&context, theme, keys_are_free) {
            self.fulfil_of_batch(wish, &context);
        }
        self.quality_of_lights(&context, theme, keys_are_free);
        self.importing(&context, theme, centre);
        self.dialog(&context);
        // A number typed key by key is one gesture, as a drag is.
        if !context.input(|i| i.pointer.any_down()) && !context.text_edit_focused() {
            self.app.end_gesture();
        }
        self.preferences.note_page();
        self.keep();
        if let Some(eyes) = self.preferences.without_cones {
            eyes::apply(&context, eyes);
        }
    }

    /// The language that was chosen; in another one than before what has words in it is made anew.
    fn speak(&mut self) {
        let language = self.preferences.language;
        languages::speak(language);
        languages::write_decimal_commas(self.preferences.decimal_commas);
        if self.spoken != language {
            self.spoken = language;
            self.app.say_anew();
        }
    }

    /// Pages that remember what stands beside the light take a second light that was chosen.
    fn follow_second(&mut self) {
        let is_there = self.app.document().second.is_some();
        if is_there != self.had_second {
            self.had_second = is_there;
            self.app.pages_follow(|pages| pages.follow_second(is_there));
        }
    }

    /// What goes on where no frame is drawn, since the window is wholly covered or minimised: what
    /// was read comes in, and is kept.
    pub fn unseen(&mut self, context: &Context) {
        self.speak();
        self.take_files(context);
        self.keep();
    }

    /// The first touch makes targets large, unless a person chose.
    fn note_touch(&mut self, context: &Context) {
        let is_touch = |event: &egui::Event| matches!(event, egui::Event::Touch { .. });
        if self.preferences.touch.is_none() && context.input(|i| i.events.iter().any(is_touch)) {
            self.preferences.touch = Some(true);
        }
    }

    /// Fonts once, style whenever the looks change; a window that is smaller than the smallest layout
    /// is scaled.
    fn dress(&mut self, context: &Context) {
        if !self.fonts_installed {
            theme::install_fonts(context);
            self.fonts_installed = true;
        }
        context.set_zoom_factor(self.preferences.zoom * fitting(context));
        if self.styled_for.as_ref() != Some(&self.preferences) {
            theme::apply(context, &self.preferences);
            self.styled_for = Some(self.preferences.clone());
        }
    }

    fn apply(&mut self, commands: &mut Vec<Command>) {
        for command in commands.drain(..) {
            self.app.apply(command);
        }
    }

    /// Hands the workspace to the saver, which keeps it on disk a moment after it changed.
    fn keep(&mut self) {
        let Some(saver) = &self.saver else { return };
        let is_kept = self.kept.0 == self.app.changes() && self.kept.1 == self.preferences;
        if !is_kept {
            saver.keep_soon(
                self.app.document(),
                &self.preferences,
                &self.images.absent(),
            );
            self.kept = (self.app.changes(), self.preferences.clone());
        }
    }

    /// Waits until every file that is being saved is on disk; called when the window closes.
    pub fn finish_writing(&mut self) {
        for worker in self.writing.drain(..) {
            // One that failed has nothing left to wait for.
            let _ = worker.join();
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
            self.kept = (self.app.changes(), self.preferences.clone());
        }
    }
}
