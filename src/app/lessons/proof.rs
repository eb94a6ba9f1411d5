//! A lesson checked and played through without a window.

use std::sync::Arc;

use super::{
    advice::{self, Findings},
    condition::Condition,
    format::{Answer, Fault, Lesson, Step},
    languages,
    point::Point,
    run::Run,
    scene::Scene,
    sound::{of_lesson, of_step},
    stage::Stage,
    words::filled,
};
use crate::app::{App, pages::Page};

/// A step as it was played: its words with their figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Played<T> {
    pub page: Page,
    /// What is said.
    pub say: String,
    /// The question and its answers, each with why.
    pub ask: Option<(String, Vec<Answer>)>,
    pub task: Option<String>,
    /// What is said at the end of the step.
    pub explain: String,
    /// What was seen at the start of the step.
    pub seen: T,
}

/// Checks a lesson and plays it through; `see` looks at the state at the start of each step.
///
/// # Errors
/// [`Fault`]: the step, what was found and what was expected.
pub fn play<T>(lesson: &Lesson, see: impl FnMut(&App, Page) -> T) -> Result<Vec<Played<T>>, Fault> {
    walk(lesson, App::new(), see)?.collect()
}

/// Checks a lesson and gives its steps one by one as they are played, each as it was or with what is
/// wrong with it; `app` is what is there before.
///
/// # Errors
/// [`Fault`] where it is no lesson that can be played at all.
pub(super) fn walk<T>(
    lesson: &Lesson,
    mut app: App,
    mut see: impl FnMut(&App, Page) -> T,
) -> Result<impl Iterator<Item = Result<Played<T>, Fault>>, Fault> {
    let whole = lesson.clone();
    let own = app.document().own.clone();
    let own: Vec<&str> = own.iter().map(|own| own.name()).collect();
    is_sound(lesson, &own)?;
    let mut page = Page::Spectrum;
    let mut run = Run::start(Arc::new(lesson.clone()), &mut app, &mut page);
    let count = lesson.steps.len();
    Ok((0..count).map(move |index| {
        if index > 0 {
            run.go(index, &mut app, &mut page);
        }
        play_step(&mut run, (&mut app, &mut page), &mut see)
            .map_err(|what| fault(&whole, Some(index), what))
    }))
}

/// Whether what a lesson says can be understood at all; `own` are names of spectra that are there.
/// Nothing is played.
///
/// # Errors
/// [`Fault`]: the first one.
pub fn is_sound(lesson: &Lesson, own: &[&str]) -> Result<(), Fault> {
    unsound(lesson, own).into_iter().next().map_or(Ok(()), Err)
}

/// All that cannot be understood in what a lesson says.
fn unsound(lesson: &Lesson, own: &[&str]) -> Vec<Fault> {
    let made = names_made(lesson).into_iter();
    let known: Vec<&str> = made.chain(own.iter().copied()).collect();
    let whole = of_lesson(lesson).map_err(|what| fault(lesson, None, what));
    let steps = lesson.steps.iter().enumerate();
    let steps = steps.map(|(index, step)| {
        of_step(step, &known).map_err(|what| fault(lesson, Some(index), what))
    });
    let all = std::iter::once(whole).chain(steps);
    let found = all.filter_map(Result::err);
    found.chain(languages::faults(lesson).0).collect()
}

fn fault(lesson: &Lesson, index: Option<usize>, what: String) -> Fault {
    Fault {
        file: lesson.name.clone(),
        step: index.map(|index| index + 1),
        what,
    }
}

/// Names of all that a page shows, as screen readers are told them; `None` where there is no window
/// that could tell.
pub type Names<'a> = &'a dyn Fn(&App, Page) -> Option<Vec<String>>;

/// Checks a lesson as an author wants it checked: it is played through, also with every other light
/// that it may be taken with, the controls that it points at are on their pages and move as its
/// words say, and no page gives an answer away. All that is found is told, step by step.
pub fn check(lesson: &Lesson, names: Names<'_>) -> Findings {
    let mut found = Findings {
        faults: unsound(lesson, &[]),
        advice: [advice::of_questions(lesson), languages::faults(lesson).1].concat(),
    };
    if !found.faults.is_empty() {
        return found;
    }
    let mut steps = lesson.steps.iter();
    let played = walk(lesson, App::new(), |app, page| {
        let (mut faults, mut hints) = (Vec::new(), None);
        if let Some(step) = steps.next() {
            faults.extend(advice::wrong_way(step, &app.document().settings));
            if let Some(names) = names(app, page) {
                let control = step.point.as_ref().and_then(Point::control);
                faults.extend(control.and_then(|name| absent(name, &names, page)));
                hints = advice::given_away(step, &names);
            }
        }
        (faults, hints)
    });
    match played {
        Err(why) => found.faults.push(why),
        Ok(played) => {
            for (index, step) in played.enumerate() {
                match step {
                    Err(why) => found.faults.push(why),
                    Ok(step) => {
                        let (faults, hint) = step.seen;
                        let faults = faults.into_iter();
                        found
                            .faults
                            .extend(faults.map(|what| fault(lesson, Some(index), what)));
                        let hint = hint.map(|what| fault(lesson, Some(index), what));
                        found.advice.extend(hint);
                    }
                }
            }
        }
    }
    if !found.faults.is_empty() {
        return found;
    }
    for light in &lesson.also {
        let other = lesson.about(light).and_then(|other| {
            walk(&other, App::new(), |_, _| ())
                .map(|steps| steps.filter_map(Result::err).collect::<Vec<_>>())
        });
        match other {
            Ok(faults) => found.faults.extend(faults),
            Err(why) => found.faults.push(why),
        }
    }
    found
}

/// A control that is not on its page, in words.
fn absent(control: &str, names: &[String], page: Page) -> Option<String> {
    const MOST: usize = 12;
    if names.iter().any(|name| name.starts_with(control.trim())) {
        return None;
    }
    let first: Vec<&str> = names.iter().take(MOST).map(String::as_str).collect();
    Some(tr!(
        "found the control \"{control}\" in point, expected the name of one on the page {page}, \
         such as {names}",
        control,
        page = page.word(),
        names = first.join(", ")
    ))
}

fn play_step<T>(
    run: &mut Run,
    (app, page): (&mut App, &mut Page),
    see: &mut impl FnMut(&App, Page) -> T,
) -> Result<Played<T>, String> {
    let step = run.step().clone();
    let trouble = |run: &Run| run.trouble().map(str::to_owned).map_or(Ok(()), Err);
    trouble(run)?;
    let in_it = |text: &str, app: &App, page: Page| filled(text, &Scene { app, page });
    let say = in_it(&step.say, app, *page)?;
    let seen = see(app, *page);
    let began_on = *page;
    if let Some(point) = &step.point {
        point.aim(app, *page)?;
    }
    let task = step.task.as_ref();
    let task = task
        .map(|task| in_it(&task.words, app, *page))
        .transpose()?;
    run.look(app, *page);
    if run.is_done() {
        return Err(
            said!("found a task that is done before it begins, expected one to do").to_owned(),
        );
    }
    let question = step.ask.as_ref();
    let question = question
        .map(|ask| in_it(&ask.question, app, *page))
        .transpose()?;
    if let Some(task) = &step.task {
        run.show_me();
        while run.show_next(app, page) {}
        trouble(run)?;
        run.look(app, *page);
        if !run.is_done() {
            let unmet = unmet(&task.until, &Scene { app, page: *page });
            return Err(tr!("its own show does not meet its task: {unmet}", unmet));
        }
    }
    run.tell(app, *page);
    let unmet = unmet(&step.claims, &Scene { app, page: *page });
    if !unmet.is_empty() {
        return Err(tr!("its claim does not hold: {unmet}", unmet));
    }
    goes_too_far(&step, (app, *page))?;
    comes_back(run, (app, *page), &say)?;
    let mut answers = Vec::new();
    for answer in step.ask.iter().flat_map(|ask| &ask.answers) {
        answers.push(Answer {
            text: in_it(&answer.text, app, *page)?,
            right: answer.right,
            because: in_it(&answer.because, app, *page)?,
        });
    }
    Ok(Played {
        page: began_on,
        say,
        ask: question.map(|question| (question, answers)),
        task,
        explain: in_it(&step.explain, app, *page)?,
        seen,
    })
}

/// Tries what a hand does that does not stop where the task is done: is it done there too, the
/// claims must hold.
fn goes_too_far(step: &Step, (app, page): (&App, Page)) -> Result<(), String> {
    let Some(task) = &step.task else {
        return Ok(());
    };
    let set = |key: &str| {
        let stages = task.show.iter().rev();
        stages
            .filter_map(|stage| stage.settings.get(key)?.as_f64())
            .next()
    };
    let mut tried: Vec<(&str, f64)> = Vec::new();
    if let Some(order) = set("order") {
        let further = [order + 1.0, order + 3.0, 2.0 * order, 40.0, 100.0];
        tried.extend(further.map(|order| ("order", order)));
    }
    if let Some(percent) = set("threshold_percent") {
        let further = [0.8 * percent, 0.5 * percent, 0.1];
        tried.extend(further.map(|percent| ("threshold_percent", percent)));
    }
    for (key, value) in tried {
        let whole = serde_json::Number::from_f64(value);
        let value = match key {
            "order" => serde_json::json!(value as u64),
            _ => serde_json::json!(whole),
        };
        let words = format!("{key} {value}");
        let further = Stage {
            settings: std::iter::once((key.to_owned(), value)).collect(),
            ..Stage::default()
        };
        let (mut app, mut page) = (app.clone(), page);
        // What cannot be set cannot be reached by hand either.
        if further
            .change(&mut app, &mut page, &mut Vec::new())
            .is_err()
        {
            continue;
        }
        let scene = Scene { app: &app, page };
        let unmet = unmet(&step.claims, &scene);
        if task.until.iter().all(|one| one.holds(&scene)) && !unmet.is_empty() {
            return Err(tr!(
                "found a task that is done with {words}, too, where its claim does not hold: \
                 {unmet}",
                words,
                unmet
            ));
        }
    }
    Ok(())
}

/// Plays what a class does: Reset, and a step back and on again. The step must say what it said at
/// first, and none of it may be done.
fn comes_back(run: &Run, (app, page): (&App, Page), say: &str) -> Result<(), String> {
    let (mut run, mut app, mut page) = (run.clone(), app.clone(), page);
    let index = run.index();
    for back in [None, index.checked_sub(1)] {
        let after = match back {
            None => said!("Reset"),
            Some(step) => {
                run.go(step, &mut app, &mut page);
                run.go(index, &mut app, &mut page);
                said!("Back and Next")
            }
        };
        if back.is_none() {
            run.set_stage(&mut app, &mut page);
        }
        if let Some(trouble) = run.trouble() {
            return Err(tr!("after {after}: {trouble}", after, trouble));
        }
        run.look(&app, page);
        if run.is_done() {
            return Err(tr!(
                "found a task that is done by {after}, expected one to do",
                after
            ));
        }
        let said = run.shown(&app, page).say;
        if said != say {
            return Err(tr!(
                "found \"{said}\" after {after}, expected \"{say}\"",
                said,
                after,
                say
            ));
        }
        let step = run.step();
        if step.task.is_none() {
            let unmet = unmet(&step.claims, &Scene { app: &app, page });
            if !unmet.is_empty() {
                return Err(tr!(
                    "its claim does not hold after {after}: {unmet}",
                    after,
                    unmet
                ));
            }
        }
    }
    Ok(())
}

/// What does not hold, in words; empty where everything does.
fn unmet(conditions: &[Condition], scene: &Scene<'_>) -> String {
    let unmet = conditions
        .iter()
        .filter(|condition| !condition.holds(scene));
    let unmet: Vec<String> = unmet.map(|condition| condition.unmet(scene)).collect();
    unmet.join("; ")
}

/// Names of the spectra that a lesson makes.
fn names_made(lesson: &Lesson) -> Vec<&str> {
    let stages = lesson.steps.iter().flat_map(|step| {
        let show = step.task.iter().flat_map(|task| &task.show);
        step.stage.iter().chain(show)
    });
    let made = stages.flat_map(|stage| &stage.make);
    made.map(|making| making.name()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::{assert_says, lessons::shelf};

    fn small(steps: &str) -> Result<Vec<Played<()>>, String> {
        let text = format!(
            r#"{{"format":"spectral-explorer-lesson","version":1,"title":"T","sentence":"S.",
            "minutes":5,"audience":["school"],"language":"en","teaches":"A.","remember":"R.",
            "next":"N.","notes_for_teachers":"","steps":[{steps}]}}"#
        );
        let lesson = Lesson::read("small", &text).map_err(|why| why.to_string())?;
        play(&lesson, |_, _| ()).map_err(|why| why.to_string())
    }

    #[test]
    fn every_shipped_lesson_plays_through_also_with_other_lights() {
        assert_eq!(shelf::shipped().len(), shelf::FILES.len());
        for lesson in shelf::shipped() {
            // Three tables of the sun are fine enough for its dark lines, three of tubes for their
            // lines in a photograph; the lesson has one.
            let others = if ["missing", "room"].contains(&lesson.name.as_str()) {
                2
            } else {
                3
            };
            assert!(lesson.also.len() >= others, "{}", lesson.name);
            let others = lesson.also.iter().map(|light| lesson.about(light));
            let others = others.map(|other| other.expect("a lesson"));
            for lesson in std::iter::once(Lesson::clone(lesson)).chain(others) {
                let played = play(&lesson, |_, _| ()).unwrap_or_else(|why| panic!("{why}"));
                assert_eq!(played.len(), lesson.steps.len());
                let name = &lesson.name;
                assert!(played.iter().any(|step| step.ask.is_some()), "{name}");
                assert!(played.iter().any(|step| step.task.is_some()), "{name}");
                for step in &played {
                    let words = [&step.say, &step.explain].map(String::as_str).join(" ");
                    assert!(!words.contains(['!', '{', '–']), "{name}: {words}");
                }
            }
        }
    }

    #[test]
    fn a_task_may_wait_for_a_figure_of_the_light_that_is_followed() {
        let start = r#"{"say":"A.","stage":{"light":"FL2"}}"#;
        let task = |below: u32, replayed: &str| {
            format!(
                r#"{start},{{"say":"B.","task":{{"words":"Bring a lamp.","until":[
                {{"figure":"cct","of":"live","below":{below}}}],"show":[{{"replay":[{replayed}]}}]}},
                "explain":"It has {{cct of live}}."}}"#
            )
        };
        let played = small(&task(3000, r#""CIE D65","CIE A""#)).expect("a lesson");
        assert_eq!(played[1].explain, "It has 2860 K.");
        let why = small(&task(3000, r#""CIE D65""#)).expect_err("too cold");
        assert_says(&why, "6500 K, expected below 3000 K");
        let why = small(&task(3000, "")).expect_err("nothing came");
        assert_says(&why, "no light is followed yet");
    }

    #[test]
    fn what_cannot_be_played_is_told_with_its_step() {
        let start = r#"{"say":"A.","stage":{"light":"FL2"}}"#;
        let task = |until: &str, show: &str| {
            format!(
                r#"{start},{{"say":"B.","task":{{"words":"Do.","until":[{until}],"show":[{show}]}}}}"#
            )
        };
        let order = r#"{"settings":{"order":20}}"#;
        assert!(small(&task(r#"{"figure":"order","equals":20}"#, order)).is_ok());
        for (until, words) in [
            (r#"{"figure":"order","equals":7}"#, "done before it begins"),
            (
                r#"{"figure":"order","above":30}"#,
                "its own show does not meet its task: found order N of the smooth part (order) 20, \
                 expected above 30",
            ),
            (
                r#"{"figure":"ordr","above":30}"#,
                "found the figure ordr, expected one of order",
            ),
            (r#"{"figure":"order"}"#, "without bounds"),
            (r#"{"light":"FL99"}"#, "FL99"),
            ("", "without until"),
        ] {
            let why = small(&task(until, order)).expect_err(until);
            assert!(why.starts_with("small: step 2: "), "{why}");
            assert_says(&why, words);
        }
        // Order 40 is a task done as well, with more numbers than the claim allows.
        let far = task(r#"{"figure":"order","above":19}"#, order);
        assert!(small(&far).is_ok());
        let claims = r#""claims":[{"figure":"numbers","below":60}],"task""#;
        let why = small(&far.replacen(r#""task""#, claims, 1)).expect_err("too far");
        assert_says(
            &why,
            "done with order 40, too, where its claim does not hold: found numbers",
        );
        for (until, words) in [
            (
                r#"{"above":30}"#,
                "found none of figure, light, surface, overlay, chain or page",
            ),
            (
                r#"{"figure":"order","equals":20,"bellow":3}"#,
                "found the field `bellow` in until, expected one of figure, light,",
            ),
            (
                r#"{"light":"FL2","page":"look"}"#,
                "found the field `page` in until",
            ),
            (
                r#"{"figure":3,"above":30}"#,
                "found integer `3`, expected a string",
            ),
            (
                r#"{"page":"lok"}"#,
                "found the page lok, expected one of lessons,",
            ),
        ] {
            let why = small(&task(until, order)).expect_err(until);
            assert!(why.starts_with("small: step 2: "), "{why}");
            assert_says(&why, words);
        }
        let long = |text: &str| text.replace("Why.", &"word ".repeat(61));
        let explained = r#"{"say":"A.","stage":{},"explain":"Why."}"#;
        assert!(small(explained).is_ok());
        let why = small(&long(explained)).expect_err("long");
        assert_says(&why, "found 61 words in explain, expected 0 to 60");
        let ask = r#"{"say":"A.","stage":{},"ask":{"question":"Q?","answers":[
            {"text":"x","because":"y"},{"text":"z","because":"y"}]}}"#;
        let why = small(ask).expect_err("no right one");
        assert_says(&why, "found 0 right answers");
        assert!(small(&ask.replace("\"Q?\",", "\"Q?\",\"open\":true,")).is_ok());
    }
}
