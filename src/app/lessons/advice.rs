//! Checks of a lesson's words: answers that give themselves away, and controls that move the other way.

use super::format::{Ask, Fault, Lesson, Step};
use crate::app::Settings;

/// Findings of a check: a lesson with faults is not taken, one with advice is.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Findings {
    pub faults: Vec<Fault>,
    pub advice: Vec<Fault>,
}

impl Findings {
    /// A line each.
    pub fn lines(of: &[Fault]) -> String {
        let lines: Vec<String> = of.iter().map(Fault::to_string).collect();
        lines.join("\n")
    }
}

/// A right answer that is longer than the longest wrong one by this factor is guessed by its length.
const TELLTALE: f64 = 1.3;
/// Shorter answers stand on many pages by chance, in letters.
const SHORTEST: usize = 5;

/// Advice on the questions of a lesson.
pub(super) fn of_questions(lesson: &Lesson) -> Vec<Fault> {
    let steps = lesson.steps.iter().enumerate();
    let asked = steps.filter_map(|(index, step)| Some((index, step.ask.as_ref()?)));
    asked
        .flat_map(|(index, ask)| {
            of_question(ask).map(move |what| Fault {
                file: lesson.name.clone(),
                step: Some(index + 1),
                what,
            })
        })
        .collect()
}

fn of_question(ask: &Ask) -> impl Iterator<Item = String> + use<> {
    let length = |text: &str| text.chars().count();
    let wrong = ask.answers.iter().filter(|answer| !answer.right);
    let longest = wrong.map(|answer| length(&answer.text)).max().unwrap_or(0);
    let right = ask.answers.iter().find(|answer| answer.right);
    let right = right
        .map(|answer| length(&answer.text))
        .filter(|_| !ask.open);
    let long = right.filter(|right| *right as f64 > TELLTALE * longest as f64);
    let long = long.map(|right| {
        format!(
            "found a right answer of {right} letters beside wrong ones of {longest} at most, expected \
             one that its length does not give away"
        )
    });
    let few = (ask.answers.len() < 3).then(|| {
        "found two answers, expected three or four: one of two is guessed by every second pupil"
            .to_owned()
    });
    long.into_iter().chain(few)
}

/// A right answer that the page shows before the question is answered, in words.
pub(super) fn given_away(step: &Step, names: &[String]) -> Option<String> {
    let ask = step.ask.as_ref().filter(|ask| !ask.open && !step.veil)?;
    let right = ask.answers.iter().find(|answer| answer.right)?;
    let wanted = right.text.to_lowercase();
    let is_long = wanted.chars().count() >= SHORTEST;
    let shown = names
        .iter()
        .find(|name| is_long && name.to_lowercase().contains(&wanted))?;
    Some(format!(
        "found the right answer on the page (\"{shown}\"), expected it to be seen after the choice: \
         \"veil\": true covers the page until then"
    ))
}

/// A task whose words send a control the other way than the task moves it, in words; `before` are
/// the settings at the step's beginning.
pub(super) fn wrong_way(step: &Step, before: &Settings) -> Option<String> {
    let task = step.task.as_ref()?;
    let label = step.point.as_ref().map_or("", |point| point.label.as_str());
    let says = |way: &str| [label, &task.words].iter().any(|text| text.contains(way));
    let said = ["to the left", "to the right"].map(says);
    let last = |key: &str| {
        task.show
            .iter()
            .rev()
            .find_map(|stage| stage.settings.get(key)?.as_f64())
    };
    let order = last("order").map(|order| order > before.order as f64);
    // The knob of lines keeps more of them to the right, by a lower threshold.
    let lines = last("threshold_percent").map(|percent| percent < before.threshold_percent);
    let goes_right = match (order, lines) {
        (Some(right), None) | (None, Some(right)) => right,
        _ => return None,
    };
    let (said, is) = match (said, goes_right) {
        ([true, false], true) => ("left", "right"),
        ([false, true], false) => ("right", "left"),
        _ => return None,
    };
    Some(format!(
        "found \"to the {said}\", expected \"to the {is}\": there the control goes"
    ))
}
