//! The pages "Lessons" and "For teachers".

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use eframe::egui;
use egui::{Align, Label, Layout, RichText, Ui, vec2};

use super::{
    PageContext, PageWish,
    lesson_cards::{Card, LessonPictures, Marks},
};
use crate::{
    app::{
        ByAddress, Memo,
        lessons::{Fault, Lesson, shelf},
    },
    languages::said,
    ui::{
        kit::{framed, headline, named, pressed, scrolled, segments, warning},
        theme::Theme,
        trial_view::TrialView,
    },
};

/// What the pages keep from frame to frame.
#[derive(Default)]
pub struct LessonsView {
    /// Lessons of a person's own files.
    own: Vec<Arc<Lesson>>,
    /// The folder that they are kept in, and what in it cannot be read and why.
    folder: Option<PathBuf>,
    faults: Vec<Fault>,
    /// The lesson that teachers look at.
    chosen: usize,
    trial: TrialView,
    /// The path that is shown, from 1; 0 for all.
    path: usize,
    pictures: LessonPictures,
    /// All lessons in a language that was chosen, by it and the own ones there are.
    translated: Memo<InLanguage, Vec<Arc<Lesson>>>,
    /// What became of a lesson that was removed.
    note: String,
}

/// What is saved of a lesson.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LessonFile {
    /// A sheet to write on.
    Pupil,
    /// A sheet with pictures, answers and notes.
    Teacher,
    /// Its file, to begin one's own with.
    Start,
}

/// A language, and the own lessons there are.
type InLanguage = (String, Vec<ByAddress<Lesson>>);

/// Least width of a card, points.
const CARD: f32 = 410.0;

/// The path of a person's own lessons.
const OWN: &str = later!("Your own");

/// A click on the list.
enum Act {
    /// Begins the lesson of this name.
    Begin(String),
    /// Takes it off the list.
    Remove(Arc<Lesson>),
}

/// A button in the corner of a card that takes it off the list; whether it was clicked.
fn removes(ui: &mut Ui, card: egui::Rect, title: &str) -> bool {
    let words = said!("Remove");
    let font = egui::TextStyle::Small.resolve(ui.style());
    let wide = ui
        .painter()
        .layout_no_wrap(words.to_owned(), font, egui::Color32::WHITE)
        .size()
        .x;
    let wide = wide + 2.0 * ui.spacing().button_padding.x;
    let size = vec2(wide.max(64.0), ui.spacing().interact_size.y);
    let place = egui::Rect::from_min_size(card.max - size - vec2(4.0, 4.0), size);
    let mut corner = ui.new_child(egui::UiBuilder::new().max_rect(place));
    let button = corner.add(egui::Button::new(words).small());
    named(
        &button,
        egui::Role::Button,
        &tr!("Remove the lesson {title}", title),
    );
    let meaning = said!("Takes it off the list. Its file stays in the folder, as .json.removed.");
    button.on_hover_text(meaning).clicked()
}

impl LessonsView {
    /// Every lesson in a language: the shipped ones, then the own ones.
    fn all(&mut self, language: &str) -> Vec<Arc<Lesson>> {
        let own: Vec<_> = self.own.iter().cloned().map(ByAddress).collect();
        let make = |(language, own): &InLanguage| {
            let all = shelf::shipped().iter().chain(own.iter().map(|one| &one.0));
            let in_it = |lesson: &Arc<Lesson>| match lesson.texts.contains_key(language) {
                true => Arc::new(Lesson {
                    // The file to begin one's own with has every language.
                    text: lesson.text.clone(),
                    texts: lesson.texts.clone(),
                    ..lesson.in_language(language)
                }),
                false => lesson.clone(),
            };
            all.map(in_it).collect()
        };
        let key = (language.to_owned(), own);
        self.translated.get(key, make).clone()
    }

    /// A lesson by its name, or of a file; own ones go first.
    pub fn find(&self, name: &str) -> Option<Arc<Lesson>> {
        let own = self.own.iter().rev().find(|lesson| lesson.name == name);
        own.cloned().or_else(|| shelf::named(name).ok())
    }

    /// Takes a lesson of a file in; one of the same name gives way.
    pub fn take(&mut self, lesson: Arc<Lesson>) {
        self.own.retain(|one| one.name != lesson.name);
        self.own.push(lesson);
    }

    /// Takes in the lessons of a folder.
    pub fn read_folder(&mut self, folder: &Path) {
        let (lessons, faults) = shelf::of_folder(folder);
        lessons.into_iter().map(Arc::new).for_each(|l| self.take(l));
        self.folder = Some(folder.to_owned());
        self.faults = faults;
    }

    /// The list, to begin one.
    pub fn list(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let all = self.all(context.language);
        let done = context.finished;
        let finished = all.iter().filter(|l| done.contains(&l.name)).count();
        let words = match finished {
            0 => tr!(
                "{n} short lessons on live data: predict, do it, see why. Click one to begin."
                    | "{n} short lessons on live data: predict, do it, see why. Click one to begin."
                        % all.len()
            ),
            count => tr!(
                "{count} of {all} lessons finished. Click one to begin.",
                count,
                all = all.len()
            ),
        };
        headline(ui, context.theme, words);
        ui.add_space(6.0);
        let paths = self.paths(&all);
        self.choices(ui, context, &all);
        ui.add_space(6.0);
        let (mut asked, mut gone) = (None, None);
        scrolled(ui, "lessons", |ui| {
            let chosen = self.path;
            for (place, (title, lessons)) in paths.iter().enumerate() {
                if lessons.is_empty() || chosen > 0 && chosen != place + 1 {
                    continue;
                }
                ui.label(RichText::new(said(title)).color(ui.visuals().strong_text_color()));
                let is_own = place == shelf::PATHS.len();
                match self.cards(ui, context, lessons, is_own) {
                    Some(Act::Begin(name)) => asked = Some(name),
                    Some(Act::Remove(lesson)) => gone = Some(lesson),
                    None => {}
                }
                ui.add_space(10.0);
            }
            ui.add_space(6.0);
            self.of_own_ones(ui, context.theme);
        });
        self.pictures.draw(ui, context);
        if let Some(name) = asked {
            context.wishes.push(PageWish::Begin(name));
        }
        if let Some(lesson) = gone {
            self.remove(&lesson);
        }
    }

    /// The paths with their lessons, the person's own at the end.
    fn paths(&self, all: &[Arc<Lesson>]) -> Vec<(&'static str, Vec<Arc<Lesson>>)> {
        let own = (OWN, self.own.len());
        let mut rest = all;
        let paths = shelf::PATHS.into_iter().chain([own]);
        let paths = paths.map(|(title, count)| {
            let (lessons, others) = rest.split_at(count.min(rest.len()));
            rest = others;
            (title, lessons.to_vec())
        });
        paths.collect()
    }

    /// Which path is shown, and in which language where there are several.
    fn choices(&mut self, ui: &mut Ui, context: &mut PageContext<'_>, all: &[Arc<Lesson>]) {
        ui.horizontal_wrapped(|ui| {
            let count = shelf::PATHS.len() + usize::from(!self.own.is_empty());
            self.path = self.path.min(count);
            let title = |path: usize| match path.checked_sub(1) {
                None => (said!("All"), said!("All lessons, path after path.")),
                Some(path) => {
                    let title = shelf::PATHS.get(path).map_or(OWN, |(title, _)| *title);
                    (said(title), "")
                }
            };
            segments(ui, &mut self.path, 0..=count, title);
            let codes = all.iter().flat_map(|lesson| lesson.texts.keys());
            let mut codes: Vec<&str> = codes.map(String::as_str).chain(["en"]).collect();
            codes.sort_unstable();
            codes.dedup();
            let language = &mut *context.language;
            if codes.len() > 1 {
                ui.label(said!("Language"));
                for code in codes {
                    let is_chosen = code == language;
                    if ui.selectable_label(is_chosen, code).clicked() {
                        *language = code.to_owned();
                    }
                }
            }
        });
    }

    /// The cards of a path in rows, all of one height; what was clicked.
    fn cards(
        &mut self,
        ui: &mut Ui,
        context: &PageContext<'_>,
        lessons: &[Arc<Lesson>],
        is_own: bool,
    ) -> Option<Act> {
        let theme = context.theme;
        let done = context.finished;
        let columns = (ui.available_width() / (CARD * theme.scale))
            .floor()
            .max(1.0);
        let gap = ui.spacing().item_spacing.x;
        let width = (ui.available_width() - gap * (columns - 1.0)) / columns;
        let cards = lessons.iter().enumerate().map(|(index, lesson)| {
            let marks = Marks {
                number: index + 1,
                finished: done.contains(&lesson.name),
                first: index == 0 && !is_own,
            };
            (Card::of(ui, lesson, &marks, width, theme), lesson)
        });
        let cards: Vec<_> = cards.collect();
        let heights = cards.iter().map(|(card, _)| card.height());
        let height = heights.fold(0.0, f32::max);
        let mut act = None;
        for row in cards.chunks(columns as usize) {
            ui.horizontal_top(|ui| {
                for (card, lesson) in row {
                    let pictures = (&mut self.pictures, theme);
                    let (rect, clicked) = card.show(ui, lesson, height, pictures);
                    if clicked {
                        act = Some(Act::Begin(lesson.name.clone()));
                    }
                    if is_own && removes(ui, rect, &lesson.title) {
                        act = Some(Act::Remove((*lesson).clone()));
                    }
                }
            });
        }
        act
    }

    /// Takes one of a person's own off the list; its file is kept under another ending.
    fn remove(&mut self, lesson: &Lesson) {
        let gone = self
            .folder
            .as_ref()
            .map(|folder| shelf::put_away(folder, lesson));
        self.note = match gone {
            Some(Err(why)) => {
                self.note = why;
                return;
            }
            Some(Ok(away)) => tr!(
                "{title} was removed; its file is now {away}.",
                title = lesson.title,
                away
            ),
            None => tr!("{title} was removed.", title = lesson.title),
        };
        self.own.retain(|one| one.name != lesson.name);
    }

    /// How one's own come to the list, and which files cannot.
    fn of_own_ones(&self, ui: &mut Ui, theme: Theme) {
        for fault in &self.faults {
            warning(ui, theme, fault.to_string());
        }
        if !self.note.is_empty() {
            ui.add(Label::new(&self.note).wrap());
        }
        let mut words =
            said!("A lesson of your own: drop its file on the window, or choose it with Open.")
                .to_owned();
        if let Some(folder) = &self.folder {
            words += " ";
            words += &tr!("It is kept in {folder}.", folder = folder.display());
        }
        ui.add(Label::new(RichText::new(words).weak()).wrap());
    }

    /// What each teaches, what to prepare, handouts, how to write one.
    pub fn teachers(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let all = self.all(context.language);
        let minutes: u32 = all.iter().map(|lesson| lesson.minutes).sum();
        let words = tr!(
            "{lessons} lessons, {minutes} minutes in all. Choose one to see what it teaches and \
             needs.",
            lessons = all.len(),
            minutes
        );
        headline(ui, context.theme, words);
        ui.add_space(6.0);
        self.chosen = self.chosen.min(all.len() - 1);
        let (chosen, trial) = (&mut self.chosen, &mut self.trial);
        scrolled(ui, "teachers", |ui| {
            ui.horizontal_top(|ui| {
                let width = (0.36 * ui.available_width()).min(320.0 * context.theme.scale);
                ui.vertical(|ui| {
                    ui.set_width(width);
                    ui.spacing_mut().button_padding.y = 4.0;
                    for (index, lesson) in all.iter().enumerate() {
                        let words = format!("{}. {}", index + 1, lesson.title);
                        let row = egui::Button::selectable(*chosen == index, words).truncate();
                        let whole = Layout::top_down_justified(Align::Min);
                        let clicked = ui.with_layout(whole, |ui| ui.add(row).clicked()).inner;
                        if clicked {
                            *chosen = index;
                        }
                    }
                });
                ui.vertical(|ui| {
                    let lesson = &all[*chosen];
                    if let Some(copy) = of_teachers(ui, lesson, trial, context) {
                        let wish = PageWish::Lesson(lesson.clone(), copy);
                        context.wishes.push(wish);
                    }
                });
            });
        });
    }
}

/// One lesson, for who teaches it; what of it is to be saved.
fn of_teachers(
    ui: &mut Ui,
    lesson: &Arc<Lesson>,
    trial: &mut TrialView,
    context: &mut PageContext<'_>,
) -> Option<LessonFile> {
    let mut copy = None;
    let strong = ui.visuals().strong_text_color();
    let said = |ui: &mut Ui, head: &str, words: &str| {
        if !words.is_empty() {
            ui.label(RichText::new(head).color(strong));
            ui.add(Label::new(words).wrap());
            ui.add_space(6.0);
        }
    };
    framed(ui, |ui| {
        ui.label(RichText::new(&lesson.title).color(strong).heading());
        let (minutes, steps) = (lesson.minutes, lesson.steps.len());
        ui.weak(tr!(
            "{minutes} minutes, {steps} steps, for {audience}",
            minutes,
            steps,
            audience = lesson.audience_words()
        ));
        ui.add_space(6.0);
        said(ui, said!("After this lesson pupils can"), &lesson.teaches);
        said(ui, said!("One sentence to remember"), &lesson.remember);
        said(
            ui,
            said!("To prepare, and to watch for"),
            &lesson.notes_for_teachers,
        );
        said(ui, said!("Sources"), &lesson.sources.join("; "));
        ui.horizontal_wrapped(|ui| {
            if pressed(ui, said!("Begin"), said!("Begins this lesson.")) {
                context.wishes.push(PageWish::Begin(lesson.name.clone()));
            }
            let pupil = ui.button(said!("Pupil's sheet")).on_hover_text(said!(
                "Saves a PDF to print: words, questions with boxes, axes to sketch on, no answers."
            ));
            let teacher = ui.button(said!("Teacher's sheet")).on_hover_text(said!(
                "Saves a PDF with the page of every step, the answers with their reasons, notes \
                 and sources."
            ));
            let start = ui.button(said!("Copy as a start")).on_hover_text(said!(
                "Saves the lesson's own file under another name: change it, and drop it on this \
                 window."
            ));
            copy = pupil.clicked().then_some(LessonFile::Pupil);
            copy = teacher.clicked().then_some(LessonFile::Teacher).or(copy);
            copy = start.clicked().then_some(LessonFile::Start).or(copy);
        });
        ui.add_space(6.0);
        let parts = (context.app, &mut *context.studies, context.wake);
        trial.show(ui, lesson, parts, context.theme);
    });
    ui.add_space(6.0);
    said(
        ui,
        said!("To write one"),
        said!(
            "A lesson is one file of JSON: steps with what is said, what is set, what is asked and \
             what is to be done. docs/lessons.md builds one from nothing. The command \"lessons \
             check FILE\" plays it and says what is wrong, with the step; then drop the file on \
             this window."
        ),
    );
    copy
}
