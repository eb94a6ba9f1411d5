//! The lesson that is being taken: its column, its keys, its beginning and its end.

use std::{path::PathBuf, sync::Arc};

use eframe::egui;
use egui::{Context, Key, Margin, Modifiers, Panel, Ui};

use super::{
    super::{lesson_view::Wish, theme::Theme},
    Window,
    panels::{Shape, in_its_size, plain},
};
use crate::app::{
    lessons::{Lesson, Run, shelf},
    pages::Page,
    state::Tone,
};

/// Width of the column, and what it is of the window: while presenting, and at most.
const WIDTH: f32 = 348.0;
const PRESENTED: f32 = 0.272;
const MOST_OF_WINDOW: f32 = 0.42;

/// How long each thing that the program shows stands, seconds.
const PACE: f64 = 0.9;

/// A larger file is no lesson, bytes.
const MOST_BYTES: u64 = 4 << 20;

impl Window {
    /// How much of the window's width the lesson takes.
    pub(super) fn lesson_width(&self, window: f32, theme: Theme) -> f32 {
        if self.lesson.is_none() || self.plot_alone {
            return 0.0;
        }
        // At a projector the words are larger, and the plot must not shrink to a strip.
        let width = match theme.scale > 1.0 {
            true => (PRESENTED * window).clamp(WIDTH, 1.5 * WIDTH),
            false => WIDTH,
        };
        width.min(MOST_OF_WINDOW * window)
    }

    /// Begins a lesson that was asked for, and shows the next thing where one is being shown.
    pub(super) fn lesson_goes_on(&mut self, context: &Context) {
        if let Some(asked) = self.preferences.pages.lesson_asked.take()
            && let Some(lesson) = self.pages.lessons.find(&asked.name)
        {
            self.leave_lesson();
            let pages = &mut self.preferences.pages;
            let mut run = Run::start(lesson, &mut self.app, pages);
            if asked.step > 0 {
                run.go(asked.step, &mut self.app, pages);
            }
            self.lesson = Some(run);
            self.drawer.open = false;
            context.request_repaint();
        }
        let Some(run) = &mut self.lesson else { return };
        let pages = &mut self.preferences.pages;
        if run.is_showing() {
            let now = context.input(|i| i.time);
            if now >= self.shows_next_at {
                run.show_next(&mut self.app, pages);
                self.shows_next_at = now + PACE;
            }
            let left = std::time::Duration::from_secs_f64(PACE);
            context.request_repaint_after(left);
        }
        run.look(&self.app, pages);
    }

    /// The lesson's column.
    pub(super) fn lesson_panel(&mut self, ui: &mut Ui, theme: Theme) {
        let width = self.lesson_width(ui.ctx().content_rect().width(), theme);
        let Some(run) = self.lesson.as_ref().filter(|_| width > 0.0) else {
            return;
        };
        let scene = (&self.app, &self.preferences.pages);
        let view = &mut self.lesson_view;
        let mut wishes = Vec::new();
        let frame = plain(ui, Margin::same(12)).fill(ui.visuals().window_fill);
        Panel::left("lesson")
            .frame(frame)
            .resizable(false)
            .exact_size(width)
            .show(ui, |ui| {
                in_its_size(ui, |ui| wishes = view.show(ui, run, scene, theme));
            });
        for wish in wishes {
            self.fulfil_of_lesson(wish, ui.ctx());
        }
    }

    /// The keys of a lesson, which go before those of the pages.
    pub(super) fn lesson_keys(&mut self, context: &Context) {
        let Some(run) = &self.lesson else { return };
        let is_busy = context.memory(|m| m.focused().is_some())
            || self.palette.is_open()
            || self.drawer.open
            || self.menu_open;
        if is_busy {
            return;
        }
        let (index, has_task) = (run.index(), run.step().task.is_some());
        let last = run.lesson().steps.len() - 1;
        let mut wishes = Vec::new();
        context.input_mut(|input| {
            let mut pressed = |keys: &[Key]| {
                keys.iter()
                    .any(|key| input.consume_key(Modifiers::NONE, *key))
            };
            if pressed(&[Key::ArrowRight, Key::PageDown]) && index < last {
                wishes.push(Wish::Go(index + 1));
            }
            if pressed(&[Key::ArrowLeft, Key::PageUp]) && index > 0 {
                wishes.push(Wish::Go(index - 1));
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
        let (app, pages) = (&mut self.app, &mut self.preferences.pages);
        match wish {
            Wish::Go(step) => run.go(step, app, pages),
            Wish::Choose(answer) => run.choose(answer),
            Wish::Tell => run.tell(),
            Wish::ShowMe => {
                run.show_me();
                self.shows_next_at = 0.0;
            }
            Wish::Again => run.set_stage(app, pages),
            Wish::Leave => self.leave_lesson(),
        }
        // What stands above and beside was drawn before.
        context.request_repaint();
    }

    fn leave_lesson(&mut self) {
        if let Some(run) = self.lesson.take() {
            run.leave(&mut self.app, &mut self.preferences.pages);
            self.preferences.pages.page = Page::Lessons;
        }
    }

    /// Takes the lessons out of files that are to be opened; gives the others.
    pub(super) fn without_lessons(&mut self, paths: Vec<PathBuf>) -> Vec<PathBuf> {
        let is_lesson = |path: &PathBuf| {
            path.extension()
                .is_some_and(|e| e.eq_ignore_ascii_case("json"))
                && std::fs::metadata(path).is_ok_and(|meta| meta.len() <= MOST_BYTES)
                && std::fs::read_to_string(path).is_ok_and(|text| Lesson::is_one(&text))
        };
        let (lessons, others): (Vec<PathBuf>, _) = paths.into_iter().partition(is_lesson);
        for path in lessons {
            match shelf::read_file(&path) {
                Ok(lesson) => {
                    let words = format!("{} is among the lessons now.", lesson.title);
                    self.app.say(Tone::Info, words);
                    self.pages.lessons.take(Arc::new(lesson));
                    self.preferences.pages.page = Page::Lessons;
                }
                Err(why) => self.app.say(Tone::Problem, why.to_string()),
            }
        }
        others
    }

    /// Whether the shape of the window is that of a narrower one beside a lesson.
    pub(super) fn shape(&self, ui: &Ui, theme: Theme) -> Shape {
        let taken = self.lesson_width(ui.max_rect().width(), theme);
        Shape::of(ui, &self.preferences, theme, (self.plot_alone, taken))
    }
}
