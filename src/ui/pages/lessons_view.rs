//! The pages "Lessons" and "For teachers".

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use eframe::egui;
use egui::{Align, Label, Layout, RichText, Ui, vec2};

use super::{PageContext, PageWish};
use crate::{
    app::{
        lessons::{Fault, Lesson, shelf},
        pages::{AskedLesson, PageMemory},
    },
    ui::{
        kit::{framed, headline, pressed, scrolled, tile_button, warning},
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

/// Width of a page from which lessons stand two in a row.
const TWO: f32 = 720.0;

impl LessonsView {
    /// Every lesson: the shipped ones, then the own ones.
    fn all(&self) -> Vec<Arc<Lesson>> {
        let all = shelf::shipped().iter().chain(&self.own);
        all.cloned().collect()
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
        let all = self.all();
        let done = &context.memory.lessons_finished;
        let finished = all.iter().filter(|l| done.contains(&l.name)).count();
        let words = match finished {
            0 => format!(
                "{} short lessons on live data: predict, do it, see why. Click one to begin.",
                all.len()
            ),
            count => format!(
                "{count} of {} lessons finished. Click one to begin.",
                all.len()
            ),
        };
        headline(ui, context.theme, words);
        ui.add_space(6.0);
        let scale = context.theme.scale;
        let mut asked = None;
        scrolled(ui, "lessons", |ui| {
            let columns = if ui.available_width() >= TWO * scale {
                2
            } else {
                1
            };
            let gap = ui.spacing().item_spacing.x;
            let width = (ui.available_width() - gap * (columns - 1) as f32) / columns as f32;
            let paths = shelf::PATHS.into_iter();
            let own = ("Your own", self.own.len());
            let mut first = 0;
            for (title, count) in paths.chain([own]).filter(|(_, count)| *count > 0) {
                let begins = first;
                first += count;
                ui.label(RichText::new(title).color(ui.visuals().strong_text_color()));
                let lessons: Vec<_> = all[begins..first].iter().enumerate().collect();
                for row in lessons.chunks(columns) {
                    let heights = row.iter();
                    let heights =
                        heights.map(|(_, lesson)| Card::of(ui, lesson, 0, false, width).height());
                    let height = heights.fold(0.0, f32::max);
                    ui.horizontal_top(|ui| {
                        for (index, lesson) in row {
                            let tick = context.memory.lessons_finished.contains(&lesson.name);
                            let card = Card::of(ui, lesson, index + 1, tick, width);
                            if card.show(ui, height) {
                                asked = Some(lesson.name.clone());
                            }
                        }
                    });
                }
                ui.add_space(10.0);
            }
            ui.add_space(6.0);
            self.of_own_ones(ui, context.theme);
        });
        if let Some(name) = asked {
            begin(ui, context.memory, &name);
        }
    }

    /// How one's own come to the list, and which files cannot.
    fn of_own_ones(&self, ui: &mut Ui, theme: Theme) {
        for fault in &self.faults {
            warning(ui, theme, fault.to_string());
        }
        let mut words =
            "A lesson of your own: drop its file on the window, or choose it with Open.".to_owned();
        if let Some(folder) = &self.folder {
            words += &format!(" It is kept in {}.", folder.display());
        }
        ui.add(Label::new(RichText::new(words).weak()).wrap());
    }

    /// What each teaches, what to prepare, handouts, how to write one.
    pub fn teachers(&mut self, ui: &mut Ui, context: &mut PageContext<'_>) {
        let all = self.all();
        let minutes: u32 = all.iter().map(|lesson| lesson.minutes).sum();
        let words = format!(
            "{} lessons, {minutes} minutes in all. Choose one to see what it teaches and needs.",
            all.len()
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

/// Asks for a lesson from its beginning.
pub(in crate::ui) fn begin(ui: &Ui, memory: &mut PageMemory, name: &str) {
    let name = name.to_owned();
    memory.lesson_asked = Some(AskedLesson {
        name,
        step: 0,
        done: false,
    });
    ui.ctx().request_repaint();
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
        ui.weak(format!(
            "{minutes} minutes, {steps} steps, for {}",
            lesson.audience_words()
        ));
        ui.add_space(6.0);
        said(ui, "Afterwards a class can", &lesson.teaches);
        said(ui, "One sentence to remember", &lesson.remember);
        said(
            ui,
            "To prepare, and to watch for",
            &lesson.notes_for_teachers,
        );
        said(ui, "Sources", &lesson.sources.join("; "));
        ui.horizontal_wrapped(|ui| {
            if pressed(ui, "Begin", "Begins this lesson.") {
                begin(ui, context.memory, &lesson.name);
            }
            let pupil = ui.button("Pupil's sheet").on_hover_text(
                "Saves a PDF to print: words, questions with boxes, axes to sketch on, no answers.",
            );
            let teacher = ui.button("Teacher's sheet").on_hover_text(
                "Saves a PDF with the page of every step, the answers with their reasons, notes \
                 and sources.",
            );
            let start = ui.button("Copy as a start").on_hover_text(
                "Saves the lesson's own file under another name: change it, and drop it on this \
                 window.",
            );
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
        "To write one",
        "A lesson is one file of JSON: steps with what is said, what is set, what is asked and \
         what is to be done. docs/lessons.md builds one from nothing. The command \"lessons \
         check FILE\" plays it and says what is wrong, with the step; then drop the file on \
         this window.",
    );
    copy
}

/// A lesson of the list, laid out.
struct Card {
    title: Arc<egui::Galley>,
    sentence: Arc<egui::Galley>,
    small: Arc<egui::Galley>,
    name: String,
    width: f32,
}

/// Around a card's words, points.
const MARGIN: f32 = 10.0;

impl Card {
    fn of(ui: &Ui, lesson: &Lesson, number: usize, tick: bool, width: f32) -> Self {
        let style = |style: egui::TextStyle| style.resolve(ui.style());
        let lay =
            |text: String, font, ink| ui.painter().layout(text, font, ink, width - 2.0 * MARGIN);
        let visuals = ui.visuals();
        let sign = if tick { "✔ " } else { "" };
        let small = format!(
            "{sign}{} minutes, {}",
            lesson.minutes,
            lesson.audience_words()
        );
        Self {
            title: lay(
                format!("{number}. {}", lesson.title),
                style(egui::TextStyle::Heading),
                visuals.strong_text_color(),
            ),
            sentence: lay(
                lesson.sentence.clone(),
                style(egui::TextStyle::Body),
                visuals.text_color(),
            ),
            small: lay(
                small,
                style(egui::TextStyle::Small),
                visuals.weak_text_color(),
            ),
            name: format!("Lesson: {}", lesson.title),
            width,
        }
    }

    fn height(&self) -> f32 {
        let words = [&self.title, &self.sentence, &self.small];
        words
            .map(|galley| galley.size().y + 4.0)
            .iter()
            .sum::<f32>()
            + 2.0 * MARGIN
    }

    /// Draws it as a button; whether it was clicked.
    fn show(self, ui: &mut Ui, height: f32) -> bool {
        let (rect, response) = tile_button(ui, vec2(self.width, height), &self.name);
        let painter = ui.painter();
        let mut at = rect.min + vec2(MARGIN, MARGIN);
        for galley in [self.title, self.sentence, self.small] {
            let height = galley.size().y;
            painter.galley(at, galley, ui.visuals().text_color());
            at.y += height + 4.0;
        }
        response.clicked()
    }
}
