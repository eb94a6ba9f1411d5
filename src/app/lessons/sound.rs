//! What can be told of a lesson's words, names and figures without playing it.

use super::{
    format::{Lesson, Step},
    names::find,
    words,
};

/// Most words of a text of a step, and of those beside a ring.
const MOST_WORDS: usize = 60;
const MOST_BESIDE: usize = 10;

/// What is wrong with a lesson as a whole.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn of_lesson(lesson: &Lesson) -> Result<(), String> {
    let texts = [
        ("title", &lesson.title),
        ("sentence", &lesson.sentence),
        ("language", &lesson.language),
        ("teaches", &lesson.teaches),
        ("remember", &lesson.remember),
        ("next", &lesson.next),
    ];
    if let Some((what, _)) = texts.iter().find(|(_, text)| text.trim().is_empty()) {
        return Err(format!("found an empty {what}, expected words"));
    }
    if !(1..=90).contains(&lesson.minutes) {
        return Err(format!(
            "found {} minutes, expected 1 to 90",
            lesson.minutes
        ));
    }
    if !(1..=lesson.steps.len()).contains(&lesson.picture) {
        return Err(format!(
            "found picture {}, expected the number of a step",
            lesson.picture
        ));
    }
    if lesson.audience.is_empty() {
        return Err(
            "found no audience, expected school, university, lighting or graphics".to_owned(),
        );
    }
    if lesson.steps[0].stage.is_none() {
        return Err("found a first step without a stage, expected one to begin with".to_owned());
    }
    let about = lesson.about.iter();
    let mut lights = about.chain(&lesson.also);
    lights.try_for_each(|light| find(light, &[]))
}

/// What is wrong with a step; `made` are the names of spectra that the lesson makes.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn of_step(step: &Step, made: &[&str]) -> Result<(), String> {
    let ask = step.ask.as_ref();
    let answers = ask.iter().flat_map(|ask| &ask.answers);
    let reasons = answers.flat_map(|one| [("text", 0, &one.text), ("because", 0, &one.because)]);
    let point = step.point.as_ref().map(|point| ("label", 0, &point.label));
    let texts = [("say", 1, &step.say), ("explain", 0, &step.explain)];
    let question = ask.map(|ask| ("question", 1, &ask.question));
    let task = step.task.as_ref().map(|task| ("words", 1, &task.words));
    let texts = texts
        .into_iter()
        .chain(reasons)
        .chain(point)
        .chain(question)
        .chain(task);
    for (what, least, text) in texts {
        let count = text.split_whitespace().count();
        let most = if what == "label" {
            MOST_BESIDE
        } else {
            MOST_WORDS
        };
        if !(least..=most).contains(&count) {
            return Err(format!(
                "found {count} words in {what}, expected {least} to {most}"
            ));
        }
    }
    for text in [&step.say, &step.explain] {
        words::fault(text, made)?;
    }
    if let Some(ask) = &step.ask {
        let (count, right) = (
            ask.answers.len(),
            ask.answers.iter().filter(|a| a.right).count(),
        );
        if !(2..=4).contains(&count) {
            return Err(format!("found {count} answers, expected two to four"));
        }
        if right != usize::from(!ask.open) {
            return Err(format!(
                "found {right} right answers, expected one, or open and none"
            ));
        }
        if ask
            .answers
            .iter()
            .any(|answer| answer.because.trim().is_empty())
        {
            return Err(
                "found an answer without because, expected why it is right or not".to_owned(),
            );
        }
    }
    let mut claims = step.claims.iter();
    claims.try_for_each(|claim| claim.fault(made))?;
    let Some(task) = &step.task else {
        return Ok(());
    };
    if task.until.is_empty() || task.show.is_empty() {
        return Err("found a task without until or without show, expected both".to_owned());
    }
    task.until
        .iter()
        .try_for_each(|condition| condition.fault(made))
}
