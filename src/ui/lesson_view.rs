//! A lesson that is being taken, as a column that leads over the ordinary pages.

use eframe::egui;
use egui::{Align, Button, Label, Layout, ProgressBar, Rect, RichText, ScrollArea, Ui, vec2};

use super::{
    kit::{framed, pressed, pressed_if, sign_button, warning},
    linked::Linked,
    theme::Theme,
};
use crate::app::{
    App, Memo,
    lessons::{Lesson, Run, Shown, shelf},
    pages::Page,
};

/// What the column asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wish {
    /// To another step.
    Go(usize),
    /// This answer is the prediction.
    Choose(usize),
    /// A choice waits until the answer is told.
    HandsUp,
    /// Which answer is right.
    Tell,
    /// The program does the task.
    ShowMe,
    /// The stage again.
    Again,
    /// The lesson from its beginning with another of the lights that it may be taken with.
    With(usize),
    /// The lesson that follows in the list.
    Onward(&'static str),
    /// Out of the lesson.
    Leave,
}

/// Size of what is read, points: on a desk and at a projector.
const TYPE: [f32; 2] = [18.0, 28.0];

/// Height of the faded edge of what is scrolled, points.
const FADE: f32 = 28.0;

/// What the column keeps from frame to frame.
#[derive(Default)]
pub(super) struct LessonView {
    shown: Memo<(u64, Page, usize, bool), Shown>,
    /// The step whose reasons were brought into view, once.
    brought: Option<usize>,
    /// The step whose question was brought into view before a class, once.
    asked: Option<usize>,
    /// Whether the control that the step points at is not on the page, as where it is presented.
    pub(super) is_out_of_sight: bool,
    linked: Linked,
}

impl LessonView {
    /// Closes the word of the glossary that is open; whether there was one.
    pub(super) fn close_word(&mut self) -> bool {
        let was_open = self.linked.is_open();
        self.linked.close();
        was_open
    }

    /// Draws the word of the glossary that is open beside the column, which ends at `column`.
    pub(super) fn word(&mut self, context: &egui::Context, column: f32, theme: Theme) {
        self.linked.show(context, column, theme);
    }

    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        run: &Run,
        (app, page): (&App, Page),
        theme: Theme,
    ) -> Vec<Wish> {
        let key = (app.changes(), page, run.index(), run.is_told());
        let linked = &mut self.linked;
        linked.begin();
        let shown = &*self.shown.get(key, |_| run.shown(app, page));
        let mut wishes = Vec::new();
        let size = TYPE[usize::from(theme.scale > 1.0)];
        for style in [egui::TextStyle::Body, egui::TextStyle::Button] {
            let font = egui::FontId::proportional(size);
            ui.style_mut().text_styles.insert(style, font);
        }
        head(ui, run, &mut wishes);
        let foot = size + 26.0;
        ScrollArea::vertical()
            .id_salt(("lesson", run.index()))
            .auto_shrink(false)
            .max_height((ui.available_height() - foot).max(80.0))
            .show(ui, |ui| {
                ui.set_max_width(ui.available_width() - 10.0);
                let is_out_of_sight = self.is_out_of_sight && theme.presents;
                let step = (run, shown, is_out_of_sight);
                let [asked, end] = body(ui, step, linked, theme, &mut wishes);
                if theme.presents && self.asked != Some(run.index()) {
                    // A class votes on answers that it can read.
                    ui.scroll_to_rect(asked.with_max_y(asked.bottom() + FADE), None);
                    self.asked = Some(run.index());
                }
                let tells = run.is_told() && !run.begins_told();
                // What lies at the lower edge is faded.
                ui.add_space(FADE);
                if tells && self.brought != Some(run.index()) {
                    // The one sentence that matters must not stay below the fold.
                    ui.scroll_to_rect(end.with_max_y(end.bottom() + FADE), None);
                }
                self.brought = tells.then(|| run.index());
                if run.is_last() && run.is_told() {
                    with_another(ui, run.lesson(), &mut wishes);
                }
            });
        ui.add_space(6.0);
        foot_line(ui, run, &mut wishes);
        wishes
    }
}

/// What covers a page until an answer is chosen.
pub(super) fn veil(ui: &mut Ui) {
    ui.centered_and_justified(|ui| {
        let words = RichText::new(said!("Choose an answer first. Then the page is shown."));
        ui.add(Label::new(words.size(20.0)).wrap());
    });
}

fn head(ui: &mut Ui, run: &Run, wishes: &mut Vec<Wish>) {
    let lesson = run.lesson();
    let strong = ui.visuals().strong_text_color();
    let title = RichText::new(&lesson.title).color(strong);
    ui.add(Label::new(title).wrap());
    ui.horizontal(|ui| {
        ui.weak(tr!(
            "Step {step} of {steps}",
            step = run.index() + 1,
            steps = lesson.steps.len()
        ));
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let meaning = said!(
                "Ends the lesson; everything is as it was before. Undo brings its last state back."
            );
            if sign_button(ui, said!("Leave"), said!("Leave the lesson"), meaning) {
                wishes.push(Wish::Leave);
            }
            let meaning = said!("Sets light, settings and page as the step began.");
            if sign_button(ui, said!("Reset"), said!("Back to the step"), meaning) {
                wishes.push(Wish::Again);
            }
        });
    });
    ui.separator();
}

/// The lights that the lesson may be taken with as well: its sentences hold for each of them.
fn with_another(ui: &mut Ui, lesson: &Lesson, wishes: &mut Vec<Wish>) {
    if lesson.also.is_empty() {
        return;
    }
    ui.add_space(8.0);
    ui.label(said!("Take the lesson again with"));
    ui.horizontal_wrapped(|ui| {
        for (index, light) in lesson.also.iter().enumerate() {
            let name = light.split_once('/').map_or(&light[..], |(_, name)| name);
            let meaning =
                said!("The lesson from its beginning, with this light in place of its own.");
            if pressed(ui, name, meaning) {
                wishes.push(Wish::With(index));
            }
        }
    });
}

/// The step's words; gives where its question and its task stand, and its reasons.
fn body(
    ui: &mut Ui,
    (run, shown, is_out_of_sight): (&Run, &Shown, bool),
    linked: &mut Linked,
    theme: Theme,
    wishes: &mut Vec<Wish>,
) -> [Rect; 2] {
    let [ink, strong] = [ui.visuals().text_color(), ui.visuals().strong_text_color()];
    linked.text(ui, &shown.say, ink);
    if let Some(trouble) = run.trouble() {
        warning(
            ui,
            theme,
            tr!("This step could not be set: {trouble}.", trouble),
        );
    }
    let mut asked = Rect::from_pos(ui.cursor().min);
    if let Some(question) = &shown.question {
        ui.add_space(8.0);
        framed(ui, |ui| {
            linked.text(ui, question, strong);
            ui.add_space(4.0);
            for (index, answer) in shown.answers.iter().enumerate() {
                // Once it is told, a class reads the right one and the one that it chose.
                let is_read = answer.1 || run.chosen() == Some(index) || is_open(run);
                if theme.presents && run.is_told() && !is_read {
                    continue;
                }
                self::answer(ui, run, (index, answer), theme, wishes);
            }
            if !run.is_told() && shown.task.is_none() {
                ui.add_space(4.0);
                vote(ui, run, wishes);
            }
        });
    }
    if let Some(task) = &shown.task {
        ui.add_space(8.0);
        framed(ui, |ui| {
            let sign = if run.is_done() { "✔" } else { "▶" };
            linked.text(ui, &format!("{sign} {task}"), strong);
            if !run.is_done() {
                for meter in &shown.meters {
                    ui.weak(&meter.words);
                    let bar = ProgressBar::new(meter.share).desired_height(6.0);
                    ui.add(bar.fill(theme.accent));
                }
                let show = Button::new(if run.is_showing() {
                    said!("Watch")
                } else {
                    said!("Show me")
                });
                let meaning = said!("The program does it, step by step (Space).");
                if pressed_if(ui, !run.is_showing(), show, meaning) {
                    wishes.push(Wish::ShowMe);
                }
                if is_out_of_sight {
                    let words = said!(
                        "Its control is not on the presented page: press Show me, or F5 for the \
                         whole window."
                    );
                    ui.add(Label::new(RichText::new(words).color(theme.faint)).wrap());
                }
            }
        });
    }
    asked = asked.with_max_y(ui.cursor().top());
    let mut end = Rect::from_pos(ui.cursor().min);
    if !shown.explain.is_empty() {
        ui.add_space(8.0);
        end = linked.text(ui, &shown.explain, ink);
    }
    if run.is_last() && run.is_told() {
        let lesson = run.lesson();
        ui.add_space(8.0);
        framed(ui, |ui| {
            linked.text(ui, &lesson.remember, strong);
            ui.add_space(4.0);
            ui.add(Label::new(tr!("Try next: {next}", next = lesson.next)).wrap());
        });
        end = end.union(ui.min_rect().with_min_y(end.top()));
    }
    [asked, end]
}

/// The button by which a class votes, or is told.
fn vote(ui: &mut Ui, run: &Run, wishes: &mut Vec<Wish>) {
    let (words, meaning, wish) = match run.waits() {
        false => (
            said!("Hands up"),
            said!("A class votes by show of hands: a choice waits until you tell."),
            Wish::HandsUp,
        ),
        true => (
            said!("Tell"),
            said!("Says which answer is right, and why (Space, Page Down)."),
            Wish::Tell,
        ),
    };
    if pressed(ui, words, meaning) {
        wishes.push(wish);
    }
}

/// Whether a question has no right answer.
fn is_open(run: &Run) -> bool {
    run.step().ask.as_ref().is_some_and(|ask| ask.open)
}

/// One answer: to be chosen, and once told with a sign, never by colour alone.
fn answer(
    ui: &mut Ui,
    run: &Run,
    (index, (text, right, because)): (usize, &(String, bool, String)),
    theme: Theme,
    wishes: &mut Vec<Wish>,
) {
    let is_chosen = run.chosen() == Some(index);
    let is_open = is_open(run);
    let sign = match (run.is_told() && !is_open, right) {
        (true, true) => "✔ ",
        (true, false) if is_chosen => "✘ ",
        _ => "",
    };
    let words = format!("{}  {sign}{text}", index + 1);
    let button = Button::new(RichText::new(words)).wrap().selected(is_chosen);
    let width = ui.available_width();
    let button = button.min_size(vec2(width, 0.0));
    if pressed_if(
        ui,
        true,
        button,
        said!("Your answer; a digit chooses it, too."),
    ) {
        wishes.push(Wish::Choose(index));
    }
    if !because.is_empty() && (is_chosen || *right || is_open) {
        let faint = RichText::new(because).color(theme.faint);
        ui.add(Label::new(faint).wrap());
    }
    ui.add_space(2.0);
}

fn foot_line(ui: &mut Ui, run: &Run, wishes: &mut Vec<Wish>) {
    ui.horizontal(|ui| {
        let meaning = said!("The step before (arrow to the left, Page Up).");
        if pressed_if(ui, run.index() > 0, Button::new(said!("Back")), meaning) {
            wishes.push(Wish::Go(run.index() - 1));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if run.is_last() {
                let meaning = match run.is_told() {
                    true => said!("Ends the lesson; everything is as it was before."),
                    false => said!("Ends the lesson. It has a tick once its last answer is told."),
                };
                if pressed(ui, said!("Finish"), meaning) {
                    wishes.push(Wish::Leave);
                }
                let next = shelf::after(&run.lesson().name).filter(|_| run.is_told());
                if let Some(next) = next {
                    let button = Button::new(said!("Next lesson")).selected(true);
                    let meaning =
                        said!("Ends this lesson and begins the one that follows in the list.");
                    if pressed_if(ui, true, button, meaning) {
                        wishes.push(Wish::Onward(next));
                    }
                }
                return;
            }
            let next = Button::new(said!("Next")).selected(run.is_told());
            let meaning = said!("The next step (arrow to the right, Page Down).");
            if pressed_if(ui, true, next, meaning) {
                wishes.push(Wish::Go(run.index() + 1));
            }
        });
    });
}
