//! Files in and out: what was dropped, chosen or typed, and what is saved, none of it in the way.

use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{Context, Ui};

use super::{
    super::{
        chart_view::{ChartForm, ChartWish},
        dialogs::{self, Dialog, Outcome},
        dropped,
        files::{Ask, NO_DIALOG, Picked},
        pages::{LessonFile, live_view::ToFollow},
        picture,
        saver::Saver,
        theme::{Wake, waker},
    },
    Window,
    printing::{CHART_SIZE, PrintedAs},
};
use crate::{
    app::{
        Command, Known, Tone,
        chart::Theme,
        charts::spectrum::spectrum_chart,
        dispersion::GemFile,
        export::{self, Export},
        known,
        lessons::{
            Lesson,
            handout::{Form, Reader, handout},
        },
        open::{Finished, Loaded},
        pages::Page,
        photograph::{Instrument, is_instrument, is_photograph},
        relit::PictureWish,
        sheet,
        worker::{Worker, news_of},
    },
    io::{name_of, save_atomically},
    languages::said,
};

/// What is waiting for a path.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Saving {
    Text(Export),
    PlotPng,
    /// One page about the light.
    SheetPdf,
    WindowPng,
    Chart(ChartWish),
    /// The instrument of photographs of spectra.
    Instrument(Box<Instrument>),
    Gem(Box<GemFile>),
    Picture(PictureWish),
    /// A stream over time.
    Tracks {
        stem: String,
        csv: String,
    },
    Lesson(Arc<Lesson>, LessonFile),
}

/// A file dialog that is open on another thread.
pub(super) struct Waiting {
    picked: Worker<Picked>,
    saving: Option<Saving>,
    /// What the path is followed as.
    follows: Option<ToFollow>,
}

impl Window {
    /// Opens files as if they had been chosen in the dialog.
    pub fn open_files(&mut self, paths: Vec<PathBuf>, wake: Wake) {
        self.speak();
        let paths = self.without_lessons(paths, &wake);
        let paths = self.without_photos(paths);
        let paths = self.without_photographs(paths);
        if !paths.is_empty() {
            // What is opened is to be seen.
            self.greets = false;
            self.images.tell_needs(&paths, &wake);
            self.loader.open(paths, wake);
        }
    }

    /// On the page "From a colour" a picture is one whose pixels are taken as colours.
    fn without_photos(&mut self, paths: Vec<PathBuf>) -> Vec<PathBuf> {
        if self.preferences.page != Page::FromColour {
            return paths;
        }
        let is_photo = |path: &PathBuf| {
            let name = name_of(path).to_lowercase();
            name.ends_with(".png") && !name.ends_with(".cspx.png")
        };
        let (photos, others): (Vec<PathBuf>, _) = paths.into_iter().partition(is_photo);
        if let Some(path) = photos.into_iter().next_back() {
            self.pages.take_photo(path);
        }
        others
    }

    /// A picture that is no spectral image is a photograph of a spectrum; the file of an instrument
    /// goes where those are read.
    fn without_photographs(&mut self, paths: Vec<PathBuf>) -> Vec<PathBuf> {
        let (pictures, others): (Vec<PathBuf>, _) = paths
            .into_iter()
            .partition(|path| is_photograph(path) || is_instrument(path));
        if !pictures.is_empty() {
            self.app.stage_photograph(None);
            self.preferences.photographs_asked = pictures;
            self.preferences.page = Page::Photograph;
        }
        others
    }

    /// What threads have read.
    pub(super) fn take_files(&mut self, context: &Context) {
        if let Some(finished) = self.loader.finished() {
            self.tell_refusals(&finished, context);
            self.take_batch(finished);
        }
        for checked in self.lesson_checks.take_in(&waker(context)) {
            self.take_lesson(checked);
        }
        self.take_images(context);
    }

    /// What came from outside: files read, dialogs answered, files dropped, words of threads.
    pub(super) fn take_in(&mut self, ui: &Ui) {
        self.take_files(ui.ctx());
        self.note_drop(ui.ctx());
        let (paths, read) = dropped(ui);
        if !read.is_empty() {
            let finished = Finished::of_dropped(read);
            self.tell_refusals(&finished, ui.ctx());
            self.take_batch(finished);
        }
        self.open_files(paths, waker(ui.ctx()));
        let answered = self.waiting.as_mut().and_then(|w| w.picked.news().pop());
        if let Some(picked) = answered
            && let Some(waiting) = self.waiting.take()
        {
            match waiting.follows {
                Some(what) => self.picked_to_follow(what, picked),
                None => self.picked(picked, waiting.saving, ui.ctx()),
            }
        }
        for (tone, text) in news_of(&mut self.writing) {
            self.app.say(tone, text);
        }
        if let Some(why) = self.saver.as_mut().and_then(Saver::trouble) {
            self.app.say(Tone::Problem, why);
        }
    }

    pub(super) fn take(&mut self, loaded: Loaded) {
        match loaded {
            Loaded::File(opened) => {
                if let Some(path) = &opened.path {
                    self.preferences.remember_file(path);
                }
                let how = opened.how.clone();
                let first = opened.spectra.first().map(|s| s.notes.clone());
                let first = first.unwrap_or_default();
                let count = opened.spectra.len();
                let images = opened.images.len();
                let known = known(self.app.document(), &opened);
                let is_beside = known == Known::OtherValues;
                if self.show_again(&opened, known) {
                    return;
                }
                self.open_and_ask(*opened);
                self.images_opened(images, count == 0);
                let more = match count {
                    0 | 1 => String::new(),
                    _ => tr!(" ({n} spectrum, all in My files)"
                        | " ({n} spectra, all in My files)" % count),
                };
                let odd = first.len().saturating_sub(1);
                let odd = match odd {
                    0 => String::new(),
                    _ => said!(" Its tooltip says more.").to_owned(),
                };
                let beside = if is_beside {
                    said!(" A file of this name with other values is open: both are there now.")
                } else {
                    ""
                };
                let words = format!("{how}{more}.{beside}{odd}");
                self.app.say(Tone::Info, words);
            }
            Loaded::Project { path, restored } => {
                let losses = restored.losses.clone();
                let images = restored.images.clone();
                self.app
                    .apply(Command::Replace(Box::new(restored.document)));
                self.app.say(Tone::Info, said!("Project opened."));
                self.images.forget();
                self.stored_images = images;
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

    /// Asks for a path in the system's dialog, on a thread of its own.
    pub(super) fn ask(&mut self, ask: Ask, saving: Option<Saving>, context: &Context) {
        self.ask_for(ask, (saving, None), context);
    }

    /// The same for a path that is to be followed.
    pub(super) fn ask_to_follow(&mut self, what: ToFollow, context: &Context) {
        let ask = match what {
            ToFollow::Folder => Ask::OpenFolder,
            ToFollow::File | ToFollow::Recording(_) | ToFollow::Instrument => Ask::Open,
        };
        self.ask_for(ask, (None, Some(what)), context);
    }

    fn ask_for(
        &mut self,
        ask: Ask,
        (saving, follows): (Option<Saving>, Option<ToFollow>),
        context: &Context,
    ) {
        if self.waiting.is_some() {
            return;
        }
        let picker = Arc::clone(&self.picker);
        let picked = Worker::start(&waker(context), move |tell| {
            tell.send(picker(&ask));
        });
        self.waiting = Some(Waiting {
            picked,
            saving,
            follows,
        });
    }

    pub(super) fn save(&mut self, saving: Saving, context: &Context) {
        let suggested = self.suggested_name(&saving);
        let extension = match &saving {
            Saving::Text(export) => export.extension(),
            Saving::PlotPng | Saving::WindowPng => "png",
            Saving::SheetPdf => "pdf",
            Saving::Chart(wish) => wish.form.extension(),
            Saving::Gem(gem) => gem.extension(),
            Saving::Picture(wish) => wish.form.ending(),
            Saving::Tracks { .. } => "csv",
            Saving::Lesson(_, LessonFile::Pupil | LessonFile::Teacher) => "pdf",
            Saving::Lesson(_, LessonFile::Start) | Saving::Instrument(_) => "json",
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

    /// Copies or saves a chart, as its menu asked for.
    pub fn save_chart(&mut self, wish: ChartWish, context: &Context) {
        if wish.form == ChartForm::CopyCsv {
            context.copy_text(wish.chart.to_csv().trim_end().to_owned());
            let words = tr!("Copied as CSV: {title}.", title = wish.chart.title);
            self.app.say(Tone::Info, words);
        } else if wish.form == ChartForm::Print {
            let [width, height] = CHART_SIZE;
            let svg = wish.chart.to_svg(width, height, Theme::Light);
            self.print(&wish.chart.title, PrintedAs::Svg(svg), context);
        } else if self.waiting.is_some() {
            let words = said!("A file dialog is open already; answer that one first.");
            self.app.say(Tone::Problem, words);
        } else {
            self.save(Saving::Chart(wish), context);
        }
    }

    pub(super) fn suggested_name(&self, saving: &Saving) -> String {
        match saving {
            Saving::Text(export) => export.suggested_name(&self.app),
            Saving::PlotPng => format!("{}.png", export::file_stem(&self.app)),
            Saving::SheetPdf => format!("{}-sheet.pdf", export::file_stem(&self.app)),
            Saving::WindowPng => format!("{}-window.png", export::file_stem(&self.app)),
            Saving::Chart(wish) => wish.file_name(),
            Saving::Gem(gem) => gem.file_name(),
            Saving::Instrument(instrument) => format!("{}.json", instrument.stem()),
            Saving::Picture(wish) => wish.file_name(),
            Saving::Tracks { stem, .. } => format!("{stem}-over-time.csv"),
            Saving::Lesson(lesson, LessonFile::Pupil) => format!("{}-pupil.pdf", lesson.name),
            Saving::Lesson(lesson, LessonFile::Teacher) => format!("{}-teacher.pdf", lesson.name),
            Saving::Lesson(lesson, LessonFile::Start) => format!("my-{}.json", lesson.name),
        }
    }

    pub(super) fn picked(&mut self, picked: Picked, saving: Option<Saving>, context: &Context) {
        match (picked, saving) {
            (Picked::Paths(paths), None) => self.open_files(paths, waker(context)),
            (Picked::Paths(paths), Some(saving)) => {
                if let Some(path) = paths.into_iter().next() {
                    self.write(saving, path, context);
                }
            }
            #[cfg(target_arch = "wasm32")]
            (Picked::Later, _) => {}
            (Picked::Cancelled, _) => self.app.say(Tone::Info, said!("No file chosen.")),
            (Picked::NoDialog, None) => {
                self.app.say(Tone::Problem, said(NO_DIALOG));
                self.dialog = Some(Dialog::OpenPath(String::new()));
            }
            (Picked::NoDialog, Some(saving)) => {
                self.app.say(Tone::Problem, said(NO_DIALOG));
                self.dialog = Some(Dialog::SavePath(self.suggested_name(&saving)));
                self.saving = Some(saving);
            }
        }
    }

    /// Writes on a thread of its own: a picture takes longer than a frame.
    pub(super) fn write(&mut self, saving: Saving, path: PathBuf, context: &Context) {
        let (app, preferences) = (self.app.clone(), self.preferences.clone());
        let (size, theme) = (context.content_rect().size(), self.file_theme());
        self.writing
            .push(Worker::start(&waker(context), move |tell| {
                let bytes = match &saving {
                    Saving::Text(export) => export.text(&app, theme).map(String::into_bytes),
                    Saving::PlotPng => {
                        let chart = spectrum_chart(&app);
                        Ok(picture::chart_png(&chart, CHART_SIZE, theme))
                    }
                    Saving::SheetPdf => sheet::to_pdf(&app),
                    Saving::WindowPng => Ok(picture::window_png(
                        &app,
                        &preferences,
                        [size.x as u32, size.y as u32],
                    )),
                    Saving::Chart(wish) => Ok(chart_bytes(wish, theme)),
                    Saving::Gem(gem) => gem.bytes(),
                    Saving::Instrument(instrument) => Ok(instrument.text().into_bytes()),
                    Saving::Tracks { csv, .. } => Ok(csv.clone().into_bytes()),
                    Saving::Picture(wish) => {
                        // It streams into its place: a large one is never whole in memory.
                        tell.send(match wish.save(&path) {
                            Ok(words) => (Tone::Info, words),
                            Err(why) => (Tone::Problem, why),
                        });
                        return;
                    }
                    Saving::Lesson(lesson, LessonFile::Start) => {
                        Ok(lesson.text.clone().into_bytes())
                    }
                    Saving::Lesson(lesson, LessonFile::Pupil) => {
                        lesson_sheet(lesson, Reader::Pupil)
                    }
                    Saving::Lesson(lesson, LessonFile::Teacher) => {
                        lesson_sheet(lesson, Reader::Teacher)
                    }
                };
                let written = bytes
                    .and_then(|bytes| save_atomically(&path, &bytes).map_err(|e| e.to_string()));
                tell.send(match (written, saving) {
                    // The axes of a chart name their own units, the others have none.
                    (
                        Ok(()),
                        Saving::Chart(_)
                        | Saving::Gem(_)
                        | Saving::Lesson(..)
                        | Saving::Tracks { .. }
                        | Saving::Instrument(_),
                    ) => (Tone::Info, tr!("Saved {file}.", file = path.display())),
                    (Ok(()), saving) => {
                        let scale = app.document().scale.words();
                        let mut words =
                            tr!("Saved {file} ({scale}).", file = path.display(), scale);
                        if let Saving::Text(export) = saving {
                            for loss in export.losses(&app) {
                                words += &format!(" {loss}");
                            }
                        }
                        (Tone::Info, words)
                    }
                    (Err(why), _) => (Tone::Problem, why),
                });
            }));
    }

    pub(super) fn dialog(&mut self, context: &Context) {
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
}

fn chart_bytes(wish: &ChartWish, theme: Theme) -> Vec<u8> {
    let [width, height] = CHART_SIZE;
    match wish.form {
        ChartForm::CopyCsv | ChartForm::Csv => wish.chart.to_csv().into_bytes(),
        ChartForm::Svg | ChartForm::Print => wish.chart.to_svg(width, height, theme).into_bytes(),
        ChartForm::Png => picture::chart_png(&wish.chart, CHART_SIZE, theme),
    }
}

/// A sheet of a lesson as PDF, with pictures of its pages.
fn lesson_sheet(lesson: &Arc<Lesson>, reader: Reader) -> Result<Vec<u8>, String> {
    let page = |step| Some(picture::step_png(lesson, step));
    handout(lesson, &[reader], Form::Pdf, &lesson.name, &page)
        .map(|sheet| sheet.bytes)
        .map_err(|why| why.to_string())
}
