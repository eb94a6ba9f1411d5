//! A lesson that is being taken: its step, what was predicted, which tasks are done. No widgets.

use std::sync::Arc;

use super::{
    condition::{Meter, Wanted},
    format::{Lesson, Step, Task},
    point::Aim,
    scene::Scene,
    stage::Stage,
    words::filled,
};
use crate::{
    app::{App, Command, Document, pages::Page},
    languages::said,
};

/// What stands in place of an explanation that what is shown does not bear out any more.
pub(super) const SET_BACK: &str = later!(
    "What is shown has changed since, so the reason does not fit it. Reset begins the step again."
);

/// What happened at a step. Its words have the figures of the moment in which they were said: what
/// a person does afterwards makes none of them false.
#[derive(Clone, Debug, Default, PartialEq)]
struct Taken {
    /// The answer that was chosen.
    chosen: Option<usize>,
    /// Whether the right answer and the explanation are told.
    told: bool,
    /// Whether the task is done.
    done: bool,
    /// What was said when the step began.
    begun: Begun,
    /// How far the task's figures were from their aims then; `None` for what is no figure.
    distances: Vec<Option<f64>>,
    /// Why, as it was told.
    reasons: Option<Reasons>,
}

/// What is said when a step begins.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Begun {
    say: String,
    question: Option<String>,
    answers: Vec<String>,
    task: Option<String>,
}

/// What is told when a question is answered or a task done.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Reasons {
    /// Why each answer is right or not.
    because: Vec<String>,
    explain: String,
}

/// A text with its figures; as it stands in the file where one of them does not exist.
fn in_words(text: &str, scene: &Scene<'_>) -> String {
    filled(text, scene).unwrap_or_else(|_| text.to_owned())
}

impl Begun {
    fn of(step: &Step, scene: &Scene<'_>) -> Self {
        let answers = step.ask.iter().flat_map(|ask| &ask.answers);
        Self {
            say: in_words(&step.say, scene),
            question: step.ask.as_ref().map(|ask| in_words(&ask.question, scene)),
            answers: answers.map(|a| in_words(&a.text, scene)).collect(),
            task: step.task.as_ref().map(|task| in_words(&task.words, scene)),
        }
    }
}

impl Reasons {
    fn of(step: &Step, scene: &Scene<'_>) -> Self {
        let answers = step.ask.iter().flat_map(|ask| &ask.answers);
        Self {
            because: answers.map(|a| in_words(&a.because, scene)).collect(),
            explain: in_words(&step.explain, scene),
        }
    }
}

/// A lesson that is being taken.
#[derive(Clone, Debug)]
pub struct Run {
    lesson: Arc<Lesson>,
    step: usize,
    taken: Vec<Taken>,
    /// What was there before the lesson.
    before: Document,
    before_page: Page,
    /// Keys of the spectra that its stages made.
    made: Vec<String>,
    /// How many of the task's changes were shown, while they are being shown.
    showing: Option<usize>,
    /// The state that the task was last looked for in.
    looked_at: Option<(u64, Page)>,
    /// What could not be set, a sentence.
    trouble: Option<String>,
    /// Choices wait until the answer is told.
    waits: bool,
}

/// The words of a step with their figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Shown {
    /// What is said.
    pub say: String,
    /// What is asked.
    pub question: Option<String>,
    /// The answers, whether each is right, and why.
    pub answers: Vec<(String, bool, String)>,
    /// What is to be done.
    pub task: Option<String>,
    /// The figures that the task is about, and how near they are to its aim.
    pub meters: Vec<Meter>,
    /// What is said at the end.
    pub explain: String,
}

impl Run {
    /// Begins a lesson.
    pub fn start(lesson: Arc<Lesson>, app: &mut App, page: &mut Page) -> Self {
        let mut run = Self {
            taken: vec![Taken::default(); lesson.steps.len()],
            lesson,
            step: 0,
            before: app.document().clone(),
            before_page: *page,
            made: Vec::new(),
            showing: None,
            looked_at: None,
            trouble: None,
            waits: false,
        };
        run.set_stage(app, page);
        run
    }

    pub fn lesson(&self) -> &Arc<Lesson> {
        &self.lesson
    }

    /// The step's number, from 0.
    pub fn index(&self) -> usize {
        self.step
    }

    pub fn step(&self) -> &Step {
        &self.lesson.steps[self.step]
    }

    pub fn is_last(&self) -> bool {
        self.step + 1 == self.lesson.steps.len()
    }

    /// The answer that was chosen.
    pub fn chosen(&self) -> Option<usize> {
        self.taken[self.step].chosen
    }

    /// Whether answer and explanation are told.
    pub fn is_told(&self) -> bool {
        let step = self.step();
        let taken = &self.taken[self.step];
        match (&step.ask, &step.task) {
            (None, None) => true,
            (_, Some(_)) => taken.done,
            (Some(_), None) => taken.told,
        }
    }

    /// Whether the page is covered: a prediction comes before the look.
    pub fn is_veiled(&self) -> bool {
        let step = self.step();
        step.veil && step.ask.is_some() && self.chosen().is_none() && !self.is_told()
    }

    /// Whether the task is done.
    pub fn is_done(&self) -> bool {
        self.taken[self.step].done
    }

    /// Whether the program is doing the task.
    pub fn is_showing(&self) -> bool {
        self.showing.is_some()
    }

    /// Whether the step's task is done on its page, not with the library and the bar above.
    pub fn uses_page(&self) -> bool {
        let step = self.step();
        let names_lights = |task: &Task| {
            let mut until = task.until.iter();
            until.all(|one| matches!(one.wanted, Wanted::Light(_) | Wanted::Overlay(_)))
        };
        step.task.as_ref().is_some_and(|task| !names_lights(task))
    }

    /// What could not be set.
    pub fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// What the step points at, with the words beside it; nothing once its task is done or its
    /// question answered.
    pub fn aim(&self, app: &App, page: Page) -> Option<(Aim, &str)> {
        let step = self.step();
        let is_over = match (&step.ask, &step.task) {
            (None, None) => false,
            _ => self.is_told(),
        };
        let point = step.point.as_ref().filter(|_| !is_over)?;
        Some((point.aim(app, page).ok()?, &point.label))
    }

    /// The step's words; what is not told yet is empty, and so is an explanation while what is shown
    /// does not bear it out: then it is said how to come back.
    pub fn shown(&self, app: &App, page: Page) -> Shown {
        let scene = Scene { app, page };
        let (step, taken) = (self.step(), &self.taken[self.step]);
        let told = taken.reasons.as_ref().filter(|_| self.is_told());
        let because = |index: usize| {
            let why = told.and_then(|told| told.because.get(index));
            why.cloned().unwrap_or_default()
        };
        let answers = step.ask.iter().flat_map(|ask| &ask.answers);
        let answers = answers.zip(&taken.begun.answers).enumerate();
        let until = step.task.iter().flat_map(|task| &task.until);
        let begun = taken.distances.iter();
        let meters = until.zip(begun);
        let meters = meters.filter_map(|(one, begun)| one.meter(&scene, (*begun)?));
        let meters = meters.collect();
        let explain = match told {
            Some(told) if told.explain.is_empty() || step.holds(&scene) => told.explain.clone(),
            Some(_) => said(SET_BACK).to_owned(),
            None => String::new(),
        };
        Shown {
            say: taken.begun.say.clone(),
            question: taken.begun.question.clone(),
            answers: answers
                .map(|(index, (answer, text))| (text.clone(), answer.right, because(index)))
                .collect(),
            task: taken.begun.task.clone(),
            meters,
            explain,
        }
    }

    /// To another step, as it begins. One without a stage goes on with what the step before it
    /// reached.
    pub fn go(&mut self, step: usize, app: &mut App, page: &mut Page) {
        let step = step.min(self.lesson.steps.len() - 1);
        let goes_on = step == self.step + 1
            && self.lesson.steps[step].stage.is_none()
            && self.is_told()
            && self.step().holds(&Scene { app, page: *page });
        self.step = step;
        if goes_on {
            self.begin(app, *page);
        } else {
            self.set_stage(app, page);
        }
    }

    /// Begins the step again: its stage, or that of a step before it with what those between do,
    /// and nothing of it chosen, told or done.
    pub fn set_stage(&mut self, app: &mut App, page: &mut Page) {
        self.trouble = None;
        let lesson = self.lesson.clone();
        let steps = &lesson.steps[..=self.step];
        let from = steps.iter().rposition(|step| step.stage.is_some());
        if let Some((from, stage)) = from.and_then(|i| Some((i, steps[i].stage.as_ref()?))) {
            let mut set = stage.set(app, page, &mut self.made);
            let tasks = steps[from..self.step]
                .iter()
                .filter_map(|s| s.task.as_ref());
            for change in tasks.flat_map(|task| &task.show) {
                set = set.and_then(|()| change.change(app, page, &mut self.made));
            }
            self.trouble = set.err();
        }
        self.begin(app, *page);
    }

    /// Says what the step says, with the figures of now.
    fn begin(&mut self, app: &App, page: Page) {
        self.showing = None;
        self.looked_at = None;
        let scene = Scene { app, page };
        let begun = Begun::of(self.step(), &scene);
        let until = self.step().task.iter().flat_map(|task| &task.until);
        let distances = until.map(|one| one.distance(&scene)).collect();
        self.taken[self.step] = Taken {
            begun,
            distances,
            ..Taken::default()
        };
        self.give_reasons(app, page);
    }

    /// Keeps why, with the figures of now, once it may be told.
    fn give_reasons(&mut self, app: &App, page: Page) {
        if self.is_told() && self.taken[self.step].reasons.is_none() {
            let reasons = Reasons::of(self.step(), &Scene { app, page });
            self.taken[self.step].reasons = Some(reasons);
        }
    }

    /// Chooses an answer, which is told at once, unless a task comes after it or a class votes; one
    /// that is told is not changed any more.
    pub fn choose(&mut self, answer: usize, app: &App, page: Page) {
        let count = self.step().ask.as_ref().map_or(0, |ask| ask.answers.len());
        if answer < count && !self.is_told() {
            self.taken[self.step].chosen = Some(answer);
            if !self.waits {
                self.tell(app, page);
            }
        }
    }

    /// Lets choices wait until the answer is told: a class votes.
    pub fn hands_up(&mut self) {
        self.waits = true;
    }

    /// Whether choices wait.
    pub fn waits(&self) -> bool {
        self.waits
    }

    /// Whether there is nothing to be told: neither a question nor a task.
    pub fn begins_told(&self) -> bool {
        let step = self.step();
        step.ask.is_none() && step.task.is_none()
    }

    /// Tells which answer is right: whoever predicted, and a class that raised its hands.
    pub fn tell(&mut self, app: &App, page: Page) {
        self.taken[self.step].told = true;
        self.waits = false;
        self.give_reasons(app, page);
    }

    /// Looks whether the task is done; a task stays done.
    pub fn look(&mut self, app: &App, page: Page) {
        let Some(task) = &self.lesson.steps[self.step].task else {
            return;
        };
        let state = (app.changes(), page);
        if self.taken[self.step].done || self.looked_at.as_ref() == Some(&state) {
            return;
        }
        let scene = Scene { app, page };
        self.taken[self.step].done = task.until.iter().all(|c| c.holds(&scene));
        self.looked_at = Some(state);
        self.give_reasons(app, page);
    }

    /// Begins to do the task for the person.
    pub fn show_me(&mut self) {
        if self.step().task.is_some() && self.showing.is_none() {
            self.showing = Some(0);
        }
    }

    /// Does the next thing of the task; whether there is more to come.
    pub fn show_next(&mut self, app: &mut App, page: &mut Page) -> bool {
        let (Some(shown), Some(task)) = (self.showing, &self.lesson.steps[self.step].task) else {
            return false;
        };
        let change: Option<&Stage> = task.show.get(shown);
        if let Some(change) = change {
            self.trouble = change.change(app, page, &mut self.made).err();
        }
        let more = shown + 1 < task.show.len() && self.trouble.is_none();
        self.showing = more.then_some(shown + 1);
        more
    }

    /// Does the task and tells the answer, at once.
    pub fn finish(&mut self, app: &mut App, page: &mut Page) {
        self.show_me();
        while self.show_next(app, page) {}
        self.look(app, *page);
        self.tell(app, *page);
    }

    /// Ends the lesson: everything is as it was before, in one step of undo. The lesson's name where
    /// it was gone through to its end.
    pub fn leave(self, app: &mut App, page: &mut Page) -> Option<String> {
        let is_done = self.is_last() && self.is_told();
        app.apply(Command::Replace(Box::new(self.before)));
        app.stage_photograph(None);
        app.end_gesture();
        *page = self.before_page;
        is_done.then(|| self.lesson.name.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{lessons::shelf, pages::Page};

    fn start(name: &str) -> (Run, App, Page) {
        let (mut app, mut page) = (App::new(), Page::Spectrum);
        let lesson = shelf::named(name).expect("shipped");
        let run = Run::start(lesson, &mut app, &mut page);
        (run, app, page)
    }

    #[test]
    fn a_prediction_is_kept_until_the_answer_is_told_and_not_changed_after() {
        let (mut run, app, page) = start("light");
        run.hands_up();
        run.choose(0, &app, page);
        run.choose(7, &app, page);
        assert_eq!((run.chosen(), run.is_told()), (Some(0), false));
        let shown = run.shown(&app, page);
        assert!(shown.explain.is_empty() && shown.answers.iter().all(|a| a.2.is_empty()));
        run.tell(&app, page);
        run.choose(1, &app, page);
        assert_eq!((run.chosen(), run.is_told()), (Some(0), true));
        let shown = run.shown(&app, page);
        assert!(!shown.explain.is_empty() && shown.answers.iter().all(|a| !a.2.is_empty()));
    }

    #[test]
    fn a_choice_is_told_at_once_unless_a_class_votes() {
        let (mut run, app, page) = start("light");
        run.choose(0, &app, page);
        assert!(run.is_told() && !run.shown(&app, page).explain.is_empty());
        // A task is still to be done: its question is answered by what it shows.
        let (mut run, app, page) = start("colour");
        run.choose(0, &app, page);
        assert!(!run.is_told());
        let meters = run.shown(&app, page).meters;
        assert_eq!(meters.len(), 1);
        assert!(meters[0].share == 0.0 && meters[0].words.contains("aim: below 1"));
    }

    #[test]
    fn a_task_is_ticked_by_what_a_person_does_and_stays_so() {
        let (mut run, mut app, page) = start("waves");
        run.look(&app, page);
        assert!(!run.is_done() && !run.is_told());
        let settings = |order| crate::app::Settings {
            order,
            ..app.document().settings
        };
        let (far, back) = (settings(40), settings(1));
        app.apply(Command::Edit(far));
        run.look(&app, page);
        assert!(run.is_done() && run.is_told());
        app.apply(Command::Edit(back));
        run.look(&app, page);
        assert!(run.is_done());
    }

    #[test]
    fn what_was_said_stays_true_after_the_task_after_going_too_far_and_after_reset() {
        let (mut run, mut app, mut page) = start("filters");
        run.go(1, &mut app, &mut page);
        let said = run.shown(&app, page).say;
        assert!(
            said.contains("It lets 28.8 % of the brightness through"),
            "{said}"
        );
        run.show_me();
        while run.show_next(&mut app, &mut page) {}
        run.look(&app, page);
        let told = run.shown(&app, page);
        assert_eq!(
            told.say, said,
            "the glass alone lets through what it let through"
        );
        assert!(
            told.explain.starts_with("11.2 % is left."),
            "{}",
            told.explain
        );
        // Four times as thick it is another share: the reason waits until it fits.
        let mut products = app.document().products.clone();
        products.chain[0].thickness = 4.0;
        app.apply(Command::Products(products));
        run.look(&app, page);
        let shown = run.shown(&app, page);
        assert_eq!(
            (shown.say, shown.explain),
            (said.clone(), SET_BACK.to_owned())
        );
        assert!(run.is_done(), "what was done was done");
        run.set_stage(&mut app, &mut page);
        let shown = run.shown(&app, page);
        assert_eq!((shown.say, shown.explain), (said, String::new()));
        assert!(!run.is_done() && !run.is_told());
    }

    #[test]
    fn a_step_that_goes_on_begins_with_what_the_one_before_it_is_to_reach() {
        let (mut run, mut app, mut page) = start("waves");
        // The fourth step has no stage; nobody did the task of the third.
        run.go(2, &mut app, &mut page);
        run.go(3, &mut app, &mut page);
        assert_eq!(app.document().settings.threshold_percent, 0.5);
        run.go(2, &mut app, &mut page);
        assert_eq!(app.document().settings.threshold_percent, 30.0);
    }

    #[test]
    fn who_goes_back_finds_the_step_as_it_began() {
        let (mut run, mut app, _) = start("filters");
        let before = app.document().clone();
        app.apply(Command::Undo);
        let mut page = Page::Glossary;
        run.set_stage(&mut app, &mut page);
        assert!(*app.document() == before && page == Page::Chain);
        run.go(1, &mut app, &mut page);
        assert_eq!(app.document().products.chain.len(), 1);
        run.go(0, &mut app, &mut page);
        assert!(*app.document() == before && run.trouble().is_none());
    }

    #[test]
    fn leaving_is_one_step_of_undo_and_only_an_end_that_was_reached_counts_as_finished() {
        for to_the_end in [false, true] {
            let first = App::new().document().clone();
            let (mut run, mut app, mut page) = start("recover");
            let last = run.lesson().steps.len() - 1;
            if to_the_end {
                run.go(last, &mut app, &mut page);
                run.tell(&app, page);
            }
            let taken = app.document().clone();
            let finished = run.leave(&mut app, &mut page);
            assert!(app.document().settings == first.settings && app.document().own.is_empty());
            assert_eq!(app.document().light.key, first.light.key);
            assert_eq!(page, Page::Spectrum);
            assert_eq!(finished.is_some(), to_the_end);
            app.apply(Command::Undo);
            assert!(*app.document() == taken);
        }
    }
}
