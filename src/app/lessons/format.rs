//! The file of a lesson, and how it is read.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value, json};

use super::{condition::Condition, parsed::parsed, point::Point, scene::Scene, stage::Stage};
use crate::languages::said;

/// The word that marks a file of a lesson.
pub(super) const FORMAT: &str = "spectral-explorer-lesson";
/// The version read.
pub(super) const VERSION: u64 = 1;
/// Most steps: a lesson of an hour has twenty.
const MOST_STEPS: usize = 200;

/// Whom a lesson is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Audience {
    /// From about fourteen years on.
    School,
    /// Students of physics, engineering or vision.
    University,
    /// Who plans or builds lighting.
    Lighting,
    /// Who renders pictures.
    Graphics,
}

impl Audience {
    pub fn word(self) -> &'static str {
        match self {
            Self::School => later!("school"),
            Self::University => later!("university"),
            Self::Lighting => later!("lighting"),
            Self::Graphics => later!("graphics"),
        }
    }
}

/// A lesson; its steps are read one by one, so that a refusal can tell which it is about.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lesson {
    /// Its name: that of its file without the ending.
    #[serde(skip)]
    pub name: String,
    /// Over it.
    pub title: String,
    /// What it is about, a sentence.
    pub sentence: String,
    /// How long it takes.
    pub minutes: u32,
    /// Whom it is for.
    pub audience: Vec<Audience>,
    /// Its language, a code such as `en`.
    pub language: String,
    /// What one can do or say afterwards.
    pub teaches: String,
    /// The one sentence worth remembering.
    pub remember: String,
    /// What to try next.
    pub next: String,
    /// What a teacher prepares, and watches for.
    pub notes_for_teachers: String,
    /// The light that may be exchanged for another; its first one where it names none.
    #[serde(default)]
    pub about: Option<String>,
    /// Other lights that it may be exchanged for: the lesson is played with each of them.
    #[serde(default)]
    pub also: Vec<String>,
    /// Where its claims come from.
    #[serde(default)]
    pub sources: Vec<String>,
    /// The step, from 1, whose end is its picture in the list.
    #[serde(default = "first")]
    pub picture: usize,
    /// Its texts in other languages, by their codes.
    #[serde(default)]
    pub texts: Map<String, Value>,
    /// The walk.
    #[serde(skip)]
    pub steps: Vec<Step>,
    /// The file as it was read.
    #[serde(skip)]
    pub text: String,
}

fn first() -> usize {
    1
}

/// A step of a lesson.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// What is said, at most 60 words.
    pub say: String,
    /// What is set before.
    #[serde(default)]
    pub stage: Option<Stage>,
    /// What has a ring around it.
    #[serde(default)]
    pub point: Option<Point>,
    #[serde(default)]
    pub ask: Option<Ask>,
    /// What is to be done.
    #[serde(default)]
    pub task: Option<Task>,
    /// What is said once it was answered or done.
    #[serde(default)]
    pub explain: String,
    /// What must hold at its end for its words to be true.
    #[serde(default)]
    pub claims: Vec<Condition>,
    /// The page is covered until an answer is chosen.
    #[serde(default)]
    pub veil: bool,
}

impl Step {
    /// Whether what it tells at its end is so: its task is done and its claims hold.
    pub fn holds(&self, scene: &Scene<'_>) -> bool {
        let until = self.task.iter().flat_map(|task| &task.until);
        until.chain(&self.claims).all(|one| one.holds(scene))
    }
}

/// A question that wants a prediction.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ask {
    /// What is asked.
    pub question: String,
    /// Two to four answers, in the order in which they are shown.
    pub answers: Vec<Answer>,
    /// No answer is right: it is about what one thinks.
    #[serde(default)]
    pub open: bool,
    /// The answers keep the file's order, as numbers that rise do.
    #[serde(default)]
    pub ordered: bool,
}

impl Ask {
    /// Moves the right answer to a place that goes round from question to question, so that no
    /// place gives it away; the others keep their order.
    fn arrange(&mut self, turn: usize) {
        let right = self.answers.iter().position(|answer| answer.right);
        if let Some(right) = right.filter(|_| !self.open && !self.ordered) {
            let answer = self.answers.remove(right);
            let place = turn % (self.answers.len() + 1);
            self.answers.insert(place, answer);
        }
    }
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Answer {
    /// Its words.
    pub text: String,
    #[serde(default)]
    pub right: bool,
    /// Why it is, or is not.
    pub because: String,
}

/// Something to do.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Task {
    pub words: String,
    /// It is done when all of these hold.
    pub until: Vec<Condition>,
    /// How the program does it, one change after the other.
    pub show: Vec<Stage>,
}

/// Why a lesson is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The lesson's file or name.
    pub file: String,
    /// The step, from 1; `None` for the lesson as a whole.
    pub step: Option<usize>,
    pub what: String,
}

impl std::fmt::Display for Fault {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { file, step, what } = self;
        match step {
            Some(step) => f.write_str(&tr!("{file}: step {step}: {what}", file, step, what)),
            None => write!(f, "{file}: {what}"),
        }
    }
}

impl Lesson {
    /// Reads a lesson; `file` is what it is called in refusals, its name without the ending.
    ///
    /// # Errors
    /// [`Fault`]: file, step, what was found and what was expected; the first one.
    pub fn read(file: &str, text: &str) -> Result<Self, Fault> {
        Self::read_whole(file, text).map_err(|mut faults| faults.swap_remove(0))
    }

    /// The same with all that is wrong: of the lesson as a whole, then step by step.
    ///
    /// # Errors
    /// [`Fault`]s, at least one.
    pub fn read_whole(file: &str, text: &str) -> Result<Self, Vec<Fault>> {
        let fault = |step: Option<usize>, what: String| Fault {
            file: file.to_owned(),
            step,
            what,
        };
        let text = text.trim_start_matches('\u{feff}');
        let value: Value = serde_json::from_str(text).map_err(|why| {
            vec![fault(
                None,
                tr!("found no JSON ({why}), expected a lesson", why),
            )]
        })?;
        let Value::Object(mut object) = value else {
            let what = format!("found {}, expected an object", short(&value));
            return Err(vec![fault(None, what)]);
        };
        marks(&mut object).map_err(|what| vec![fault(None, what)])?;
        let steps = match object.remove("steps") {
            Some(Value::Array(steps)) if steps.len() > MOST_STEPS => {
                let what = format!("found {} steps, expected at most {MOST_STEPS}", steps.len());
                return Err(vec![fault(None, what)]);
            }
            Some(Value::Array(steps)) if !steps.is_empty() => steps,
            Some(other) => {
                let what = format!("found steps {}, expected a list of steps", short(&other));
                return Err(vec![fault(None, what)]);
            }
            None => {
                let what = "found no steps, expected a list".to_owned();
                return Err(vec![fault(None, what)]);
            }
        };
        let lesson = parsed::<Self>(Value::Object(object)).map_err(|what| fault(None, what));
        let steps = steps.into_iter().enumerate();
        let steps = steps
            .map(|(index, step)| parsed::<Step>(step).map_err(|what| fault(Some(index + 1), what)));
        let (mut read, mut faults) = (Vec::new(), Vec::new());
        for step in steps {
            match step {
                Ok(step) => read.push(step),
                Err(why) => faults.push(why),
            }
        }
        let (lesson, mut steps) = match lesson {
            Ok(lesson) if faults.is_empty() => (lesson, read),
            Ok(_) => return Err(faults),
            Err(why) => return Err(std::iter::once(why).chain(faults).collect()),
        };
        let questions = steps.iter_mut().filter_map(|step| step.ask.as_mut());
        for (turn, ask) in (lesson.minutes as usize..).zip(questions) {
            ask.arrange(turn);
        }
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        Ok(Self {
            name: name.strip_suffix(".json").unwrap_or(name).to_owned(),
            steps,
            text: text.to_owned(),
            ..lesson
        })
    }

    /// Whether a text claims to be a lesson.
    pub fn is_one(text: &str) -> bool {
        text.contains(&format!("\"{FORMAT}\""))
    }

    /// Whom it is for, in words.
    pub fn audience_words(&self) -> String {
        let words: Vec<&str> = self.audience.iter().map(|a| said(a.word())).collect();
        words.join(", ")
    }

    /// How many things its tasks and claims ask for.
    pub fn checks(&self) -> usize {
        let of = |step: &Step| step.claims.len() + step.task.as_ref().map_or(0, |t| t.until.len());
        self.steps.iter().map(of).sum()
    }

    /// The light that may be exchanged for another.
    pub fn light(&self) -> Option<&str> {
        let stages = self.steps.iter().filter_map(|step| step.stage.as_ref());
        let first = || stages.clone().find_map(|stage| stage.light.as_deref());
        self.about.as_deref().or_else(first)
    }

    /// The same with its light exchanged for another one, wherever the steps name it: in stages, in
    /// what they make, in tasks and in the figures of sentences.
    ///
    /// # Errors
    /// [`Fault`] where it is no lesson any more.
    pub fn about(&self, other: &str) -> Result<Self, Fault> {
        let name = format!("{} with {other}", self.name);
        let mut value: Value = serde_json::from_str(&self.text).unwrap_or_default();
        for key in ["steps", "texts"] {
            if let (Some(light), Some(part)) = (self.light(), value.get_mut(key)) {
                exchange(part, light, other);
            }
        }
        let lesson = Self::read(&name, &value.to_string())?;
        Ok(Self { name, ..lesson })
    }
}

/// Exchanges a light's name wherever a value names it.
fn exchange(value: &mut Value, light: &str, other: &str) {
    match value {
        Value::String(text) if text == light => other.clone_into(text),
        Value::String(text) => {
            *text = text.replace(&format!(" of {light}}}"), &format!(" of {other}}}"));
        }
        Value::Array(items) => items.iter_mut().for_each(|v| exchange(v, light, other)),
        Value::Object(fields) => fields.values_mut().for_each(|v| exchange(v, light, other)),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

/// Takes the marks of the format out of a file.
fn marks(object: &mut Map<String, Value>) -> Result<(), String> {
    for (key, wanted) in [("format", json!(FORMAT)), ("version", json!(VERSION))] {
        let found = match object.remove(key) {
            Some(value) if value == wanted => continue,
            Some(other) => format!("{key} {}", short(&other)),
            None => format!("no {key}"),
        };
        return Err(format!("found {found}, expected {wanted}"));
    }
    Ok(())
}

/// A value as a refusal quotes it.
fn short(value: &Value) -> String {
    const MOST: usize = 40;
    let words = value.to_string();
    if words.chars().count() <= MOST {
        return words;
    }
    let start: String = words.chars().take(MOST).collect();
    format!("{start}...")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::assert_says;

    const SMALL: &str = r#"{"format":"spectral-explorer-lesson","version":1,"title":"T",
        "sentence":"S.","minutes":5,"audience":["school"],"language":"en","teaches":"A.",
        "remember":"R.","next":"N.","notes_for_teachers":"P.",
        "steps":[{"say":"One."},{"say":"Two."}]}"#;

    fn refusal(from: &str, to: &str) -> String {
        assert!(SMALL.contains(from), "{from}");
        let text = SMALL.replace(from, to);
        Lesson::read("a.json", &text)
            .expect_err("not a lesson")
            .to_string()
    }

    #[test]
    fn a_small_file_is_read_and_takes_its_name_from_its_path() {
        let lesson = Lesson::read("lessons/my first.json", SMALL).expect("a lesson");
        assert_eq!((lesson.name.as_str(), lesson.steps.len()), ("my first", 2));
        assert!(Lesson::is_one(SMALL) && !Lesson::is_one("{}"));
    }

    #[test]
    fn another_light_stands_wherever_the_first_one_was_named() {
        let steps = r#"[{"say":"{ra of CIE D65} and {ra of CIE A}","stage":{"light":"Mine",
            "make":[{"mix":{"name":"Mine","channels":[],"like":"CIE D65"}}],
            "overlays":["CIE D65","CIE A"]}}]"#;
        let whole = SMALL.replace(r#"[{"say":"One."},{"say":"Two."}]"#, steps);
        let first = Lesson::read("a", &whole).expect("a lesson");
        assert_eq!(first.light(), Some("Mine"));
        let about = whole.replace(r#""minutes""#, r#""about":"CIE D65","minutes""#);
        let lesson = Lesson::read("a", &about).expect("a lesson");
        let other = lesson.about("FL2").expect("a lesson");
        assert_eq!(other.name, "a with FL2");
        let step = &other.steps[0];
        assert_eq!(step.say, "{ra of FL2} and {ra of CIE A}");
        let stage = step.stage.as_ref().expect("a stage");
        assert_eq!(stage.light.as_deref(), Some("Mine"));
        let overlays = stage.overlays.iter().flatten();
        assert!(overlays.eq(["FL2", "CIE A"]));
        assert!(format!("{:?}", stage.make).contains("like: \"FL2\""));
        assert!(other.text.contains("FL2") && lesson.text == about);
    }

    #[test]
    fn a_refusal_says_file_step_what_was_found_and_what_was_expected() {
        let words = refusal(r#"{"say":"Two."}"#, r#"{"sya":"Two."}"#);
        assert!(
            words.starts_with("a.json: step 2: found the field `sya`, expected"),
            "{words}"
        );
        let words = refusal(r#"{"say":"Two."}"#, r#"{"say":2}"#);
        assert_eq!(
            words,
            "a.json: step 2: found integer `2`, expected a string"
        );
        let words = refusal(r#""version":1"#, r#""version":7"#);
        assert_eq!(words, "a.json: found version 7, expected 1");
        let steps = vec![r#"{"say":"One."}"#; MOST_STEPS + 1].join(",");
        let words = refusal(r#"{"say":"One."},{"say":"Two."}"#, &steps);
        assert_eq!(words, "a.json: found 201 steps, expected at most 200");
        let words = refusal(r#""title":"T","#, "");
        assert_eq!(words, "a.json: found no `title`, expected it");
        let words = refusal(r#"["school"]"#, r#"["scool"]"#);
        assert_says(&words, "found the word `scool`, expected one of");
        assert!(refusal("\"steps\":[", "\"steps\":[}").contains("found no JSON"));
    }
}
