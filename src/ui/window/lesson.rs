//! The lesson that is being taken: its column, its keys, its beginning and its end.

use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{Context, Key, Margin, Modifiers, Panel, Rect, Ui};

use super::{
    super::{
        lesson_view::Wish,
        pages::LessonsView,
        pointing,
        theme::{Theme, Wake},
        top_view::Drawer,
    },
    Window,
    checks::Checked,
    panels::{Shape, fixed, in_its_size, plain},
};
use crate::app::{
    Command, Subject, Tone,
    lessons::{Aim, Lesson, Run, shelf},
    pages::{AskedLesson, Page, Place},
};

/// Width of the column, and what it is of the window: while presenting, and at most.
const WIDTH: f32 = 348.0;
const PRESENTED: f32 = 0.4;
const MOST_OF_WINDOW: f32 = 0.42;

/// How long each thing that the program shows stands, seconds.
const PACE: f64 = 0.9;

/// Half the width of a ring around a wavelength, points.
const AT_NM: f32 = 12.0;

impl Window {
    /// How much of the window's width the lesson takes.
    pub(super) fn lesson_width(&self, window: f32, theme: Theme) -> f32 {
        if self.lesson.is_none() {
            return 0.0;
        }
        // At a projector the words are larger, and the plot must not shrink to a strip.
        let width = match self.preferences.presents() {
            true => (PRESENTED * window).clamp(WIDTH, 2.0 * WIDTH),
            false => WIDTH * theme.scale,
        };
        width.min(MOST_OF_WINDOW * window)
    }

    /// Where the lesson's column ends, points.
    pub(in crate::ui) fn lesson_ends(&self) -> f32 {
        self.lesson_ends
    }

    /// Begins a lesson that was asked for, and shows the next thing where one is being shown.
    pub(super) fn lesson_goes_on(&mut self, context: &Context) {
        self.read_own_lessons();
        if let Some(asked) = self.preferences.lesson_asked.take()
            && let Some(lesson) = self.pages.of::<LessonsView>().find(&asked.name)
        {
            let language = &self.preferences.lesson_language;
            let lesson = Arc::new(lesson.in_language(language));
            self.begin(&lesson, asked.step, asked.done);
            context.request_repaint();
        }
        let Some(run) = &mut self.lesson else { return };
        let page = &mut self.preferences.page;
        if run.is_showing() {
            let now = context.input(|i| i.time);
            if now >= self.shows_next_at {
                run.show_next(&mut self.app, page);
                self.shows_next_at = now + PACE;
            }
            let left = std::time::Duration::from_secs_f64(PACE);
            context.request_repaint_after(left);
        }
        run.look(&self.app, *page);
    }

    /// Asks for a lesson from its beginning.
    pub(super) fn begin_lesson(&mut self, name: String, context: &Context) {
        self.preferences.lesson_asked = Some(AskedLesson {
            name,
            step: 0,
            done: false,
        });
        context.request_repaint();
    }

    /// Begins a lesson at a step, from 0, as it begins or as it ends.
    pub(in crate::ui) fn begin(&mut self, lesson: &Arc<Lesson>, step: usize, done: bool) {
        self.leave_lesson();
        let page = &mut self.preferences.page;
        let mut run = Run::start(lesson.clone(), &mut self.app, page);
        if step > 0 {
            run.go(step, &mut self.app, page);
        }
        if done {
            run.finish(&mut self.app, page);
        }
        self.lesson = Some(run);
        self.library.search.clear();
        self.drawer = Drawer::default();
    }

    /// Begins a lesson with another of the lights that it may be taken with; it is the same lesson.
    fn begin_with(&mut self, lesson: &Lesson, light: usize) {
        let light = lesson.also.get(light);
        if let Some(Ok(other)) = light.map(|light| lesson.about(light)) {
            let name = lesson.name.clone();
            self.begin(&Arc::new(Lesson { name, ..other }), 0, false);
        }
    }

    /// Reads the folder of own lessons whenever their list comes into sight.
    fn read_own_lessons(&mut self) {
        let in_sight = self.preferences.page.place() == Place::Learn;
        let was = std::mem::replace(&mut self.lists_lessons, in_sight);
        let comes = in_sight && !was;
        if let Some(folder) = self.lessons_folder.as_ref().filter(|_| comes) {
            self.pages.of::<LessonsView>().read_folder(folder);
        }
    }

    /// The lesson's column.
    pub(super) fn lesson_panel(&mut self, ui: &mut Ui, theme: Theme) {
        let width = self.lesson_width(ui.ctx().content_rect().width(), theme);
        let Some(run) = self.lesson.as_ref().filter(|_| width > 0.0) else {
            return;
        };
        let scene = (&self.app, self.preferences.page);
        let view = &mut self.lesson_view;
        let mut wishes = Vec::new();
        let frame = plain(ui, Margin::same(12)).fill(ui.visuals().window_fill);
        let panel = fixed(Panel::left("lesson"), frame, width).show(ui, |ui| {
            in_its_size(ui, |ui| wishes = view.show(ui, run, scene, theme));
        });
        self.lesson_ends = panel.response.rect.right();
        for wish in wishes {
            self.fulfil_of_lesson(wish, ui.ctx());
        }
    }

    /// The ring around what the step points at, and over all the word of the glossary that is open.
    pub(super) fn lesson_ring(&mut self, context: &Context, theme: Theme) {
        self.lesson_view.word(context, self.lesson_ends, theme);
        // A page that is covered has nothing to point at.
        let aim = self.lesson.as_ref().filter(|run| !run.is_veiled());
        let aim = aim.and_then(|run| run.aim(&self.app, self.preferences.page));
        let name = match &aim {
            Some((Aim::Named(name), _)) => Some(name.as_str()),
            _ => None,
        };
        let (named, busy) = pointing::find(context, name);
        self.lesson_view.is_out_of_sight = name.is_some() && named.is_none();
        let Some((aim, label)) = aim else { return };
        let around = match aim {
            Aim::Named(_) => named,
            Aim::Nm(nm) => self.look.spectrum.transform.and_then(|plot| {
                let x = plot.position_from_point_x(nm);
                let strip = Rect::from_x_y_ranges(x - AT_NM..=x + AT_NM, plot.frame().y_range());
                plot.frame().x_range().contains(x).then_some(strip)
            }),
        };
        if let Some(around) = around {
            pointing::ring(context, (around, &busy), (label, self.lesson_ends), theme);
        }
    }

    /// The keys of a lesson, which go before those of the pages.
    pub(super) fn lesson_keys(&mut self, context: &Context) {
        let Some(run) = &self.lesson else { return };
        let is_over = self.palette.is_open() || self.drawer.open || self.menu_open;
        if is_over || context.text_edit_focused() {
            return;
        }
        // A slider that was just moved has the arrows and the digits, never a clicker's keys.
        let is_free = context.memory(|m| m.focused().is_none());
        let (index, has_task) = (run.index(), run.step().task.is_some());
        // A clicker has two buttons: the one that goes on reveals first.
        let reveals = !run.is_told() && !run.is_showing();
        let ends = run.is_last() && run.is_told();
        let last = run.lesson().steps.len() - 1;
        let mut wishes = Vec::new();
        context.input_mut(|input| {
            let mut pressed = |keys: &[Key]| {
                keys.iter()
                    .any(|key| input.consume_key(Modifiers::NONE, *key))
            };
            let both = |arrow: Key, page: Key| match is_free {
                true => vec![arrow, page],
                false => vec![page],
            };
            if reveals && pressed(&[Key::PageDown]) {
                wishes.push(if has_task { Wish::ShowMe } else { Wish::Tell });
            } else if pressed(&both(Key::ArrowRight, Key::PageDown)) {
                if index < last {
                    wishes.push(Wish::Go(index + 1));
                } else if ends {
                    wishes.push(Wish::Leave);
                }
            }
            if pressed(&both(Key::ArrowLeft, Key::PageUp)) && index > 0 {
                wishes.push(Wish::Go(index - 1));
            }
            if !is_free {
                return;
            }
            if pressed(&[Key::Space]) {
                wishes.push(if has_task { Wish::ShowMe } else { Wish::Tell });
            }
            let digits = [Key::Num1, Key::Num2, Key::Num3, Key::Num4];
            for (answer, key) in digits.into_iter().enumerate() {
                if pressed(&[key]) {
                    wishes.push(Wish::Choose(answer));
                }
            }
        });
        for wish in wishes {
            self.fulfil_of_lesson(wish, context);
        }
    }

    fn fulfil_of_lesson(&mut self, wish: Wish, context: &Context) {
        let Some(run) = &mut self.lesson else { return };
        let (app, page) = (&mut self.app, &mut self.preferences.page);
        match wish {
            Wish::Go(step) => run.go(step, app, page),
            Wish::Choose(answer) => run.choose(answer, app, *page),
            Wish::HandsUp => run.hands_up(),
            Wish::Tell => run.tell(app, *page),
            Wish::ShowMe => {
                run.show_me();
                self.shows_next_at = 0.0;
            }
            Wish::Again => run.set_stage(app, page),
            Wish::With(light) => {
                let lesson = run.lesson().clone();
                self.begin_with(&lesson, light);
            }
            Wish::Onward(next) => self.begin_lesson(next.to_owned(), context),
            Wish::Leave => self.leave_lesson(),
        }
        if !matches!(wish, Wish::Choose(_) | Wish::ShowMe) {
            self.lesson_view.close_word();
            // The next step's lamp is looked for anew.
            self.library.search.clear();
            self.drawer = Drawer::default();
        }
        // What stands above and beside was drawn before.
        context.request_repaint();
    }

    /// In a lesson a lamp that is chosen shines on the surface that is looked at.
    pub(super) fn keep_surface(&self, commands: &mut Vec<Command>) {
        let is_lamp = |command: &Command| match command {
            Command::Show(entry) => entry.kind() == crate::spectrum::Kind::Light,
            _ => false,
        };
        let of_surface = self.lesson.is_some() && !self.app.document().is_about_light();
        if of_surface && commands.iter().any(is_lamp) {
            commands.push(Command::About(Subject::Factor));
        }
    }

    fn leave_lesson(&mut self) {
        if let Some(run) = self.lesson.take() {
            let finished = &mut self.preferences.lessons_finished;
            let name = run.leave(&mut self.app, &mut self.preferences.page);
            finished.extend(name.filter(|name| !finished.contains(name)));
        }
    }

    /// Takes the lessons out of files that are to be opened and has them checked; gives the others.
    pub(super) fn without_lessons(&mut self, paths: Vec<PathBuf>, wake: &Wake) -> Vec<PathBuf> {
        let is_lesson = |path: &PathBuf| shelf::is_lesson(path);
        let (lessons, others): (Vec<PathBuf>, _) = paths.into_iter().partition(is_lesson);
        self.lesson_checks.ask(lessons, wake);
        others
    }

    /// Takes in a lesson of a file that was checked, or says what is wrong with it.
    pub(super) fn take_lesson(&mut self, checked: Checked) {
        match checked {
            Ok(lesson) => {
                let words = tr!("{title} was added to the lessons.", title = lesson.title);
                self.app.say(Tone::Info, words);
                if let Some(folder) = &self.lessons_folder
                    && let Err(why) = shelf::keep(folder, &lesson)
                {
                    self.app.say(Tone::Problem, why);
                }
                self.pages.of::<LessonsView>().take(lesson);
                self.preferences.page = Page::Lessons;
            }
            Err(why) => self.app.say(Tone::Problem, why),
        }
    }

    /// Whether the shape of the window is that of a narrower one beside a lesson.
    pub(super) fn shape(&self, ui: &Ui, theme: Theme) -> Shape {
        let taken = self.lesson_width(ui.max_rect().width(), theme);
        Shape::of(ui, &self.preferences, theme, taken)
    }
}
