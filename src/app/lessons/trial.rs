//! A lesson's claims tried on another light: where do they fail?

use super::{
    format::{Fault, Lesson},
    proof::walk,
};
use crate::{
    app::{App, Command, Entry, memo::ByAddress, studies::Question},
    study::Progress,
};

/// Which lesson is tried on which light.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialAsk {
    pub lesson: ByAddress<Lesson>,
    /// The light: a shipped one or one of the person's own.
    pub light: ByAddress<Entry>,
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Trial {
    /// What holds for how many steps, a sentence.
    pub headline: String,
    /// Where a claim fails and why, a sentence a step.
    pub faults: Vec<String>,
}

impl Question for TrialAsk {
    type Answer = Trial;

    fn answer(&self, progress: &Progress) -> Option<Trial> {
        let (lesson, light) = (&*self.lesson.0, &self.light.0);
        let mut app = App::new();
        let name = if app.bundled().iter().any(|e| e.key == light.key) {
            &light.key
        } else {
            app.apply(Command::Adopt(vec![light.spectrum.clone()]));
            light.name()
        };
        if lesson.light().is_none() {
            return Some(Trial {
                headline: said!("The lesson names no light that another could stand for.")
                    .to_owned(),
                faults: Vec::new(),
            });
        }
        progress.expect(lesson.steps.len());
        let walked = match lesson.about(name) {
            Ok(lesson) => walked(&lesson, app, progress)?,
            Err(why) => Err(why),
        };
        Some(Trial::of(lesson, light.name(), walked))
    }
}

/// What is wrong with each step; `None` when it was cancelled.
fn walked(lesson: &Lesson, app: App, progress: &Progress) -> Option<Result<Vec<Fault>, Fault>> {
    let steps = match walk(lesson, app, |_, _| ()) {
        Ok(steps) => steps,
        Err(why) => return Some(Err(why)),
    };
    let mut faults = Vec::new();
    for step in steps {
        if progress.is_cancelled() {
            return None;
        }
        faults.extend(step.err());
        progress.step();
    }
    Some(Ok(faults))
}

impl Trial {
    fn of(lesson: &Lesson, light: &str, walked: Result<Vec<Fault>, Fault>) -> Self {
        let (steps, count) = (lesson.steps.len(), lesson.checks());
        let said = |fault: &Fault| match fault.step {
            Some(step) => tr!("Step {step}: {fault}.", step, fault = fault.what),
            None => format!("{}.", fault.what),
        };
        match walked {
            Err(why) => Self {
                headline: tr!("The lesson cannot be taken with {light}.", light),
                faults: vec![said(&why)],
            },
            Ok(faults) if faults.is_empty() => Self {
                headline: tr!(
                    "With {light} everything holds: {checks} in {n} step."
                        | "With {light} everything holds: {checks} in {n} steps." % steps,
                    light,
                    checks = tr!("{n} check" | "{n} checks" % count)
                ),
                faults: Vec::new(),
            },
            Ok(faults) => Self {
                headline: match steps {
                    1 => tr!("With {light}, 1 of 1 step fails.", light),
                    steps => tr!(
                        "With {light}, {n} of {steps} steps fails."
                            | "With {light}, {n} of {steps} steps fail." % faults.len(),
                        light,
                        steps
                    ),
                },
                faults: faults.iter().map(said).collect(),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::app::{
        assert_says,
        lessons::{names::entry, shelf},
    };

    fn tried(lesson: &str, light: &str) -> Trial {
        let ask = TrialAsk {
            lesson: ByAddress(shelf::named(lesson).expect("shipped")),
            light: ByAddress(entry(&App::new(), light).expect("shipped")),
        };
        ask.answer(&Progress::default()).expect("not cancelled")
    }

    #[test]
    fn a_lesson_about_lines_holds_for_a_tube_and_fails_on_daylight_where_the_lines_are() {
        let tube = tried("samples", "FL3");
        let words = &tube.headline;
        assert!(words.starts_with("With FL3 everything holds: "), "{words}");
        assert!(tube.faults.is_empty());
        let daylight = tried("samples", "CIE D65");
        assert_eq!(daylight.headline, "With CIE D65, 1 of 2 steps fails.");
        let fault = &daylight.faults[0];
        assert!(fault.starts_with("Step 1: "), "{fault}");
        assert_says(fault, "filter_delta_e_samples");
    }

    #[test]
    fn a_light_of_ones_own_is_tried_like_a_shipped_one() {
        let mut own = Entry::clone(&entry(&App::new(), "FL3").expect("shipped"));
        own.key = "file/mine".to_owned();
        own.spectrum.name = "My tube".to_owned();
        let ask = TrialAsk {
            lesson: ByAddress(shelf::named("samples").expect("shipped")),
            light: ByAddress(Arc::new(own)),
        };
        let trial = ask.answer(&Progress::default()).expect("not cancelled");
        let words = trial.headline;
        assert!(
            words.starts_with("With My tube everything holds"),
            "{words}"
        );
    }
}
