//! The texts of a lesson in other languages, in the file of the lesson itself: the same shape, texts
//! alone. What lacks a text stays whole in the lesson's own language: the head, or a step.

use serde_json::{Map, Value};

use super::format::{Fault, Lesson};

/// Texts of a lesson as a whole.
const HEAD: [&str; 6] = [
    "title",
    "sentence",
    "teaches",
    "remember",
    "next",
    "notes_for_teachers",
];

/// Texts of a step, without lists.
const OF_STEP: [&str; 5] = [
    "/say",
    "/point/label",
    "/ask/question",
    "/task/words",
    "/explain",
];

/// Most words that a step says: other languages need more of them than English.
const MOST_WORDS: usize = 78;

/// Where texts stand in a step, by JSON pointers, with the texts.
fn texts_of(step: &Value) -> Vec<(String, &str)> {
    let mut pointers: Vec<String> = OF_STEP.map(str::to_owned).to_vec();
    let length = |list: &str| {
        step.pointer(list)
            .and_then(Value::as_array)
            .map_or(0, Vec::len)
    };
    for answer in 0..length("/ask/answers") {
        pointers.extend(["text", "because"].map(|key| format!("/ask/answers/{answer}/{key}")));
    }
    let until = 0..length("/task/until");
    pointers.extend(until.map(|one| format!("/task/until/{one}/called")));
    let text = |pointer: String| {
        let text = step.pointer(&pointer)?.as_str()?;
        (!text.is_empty()).then_some((pointer, text))
    };
    pointers.into_iter().filter_map(text).collect()
}

/// Every value of a translation that is no list and no object, by its pointer.
fn leaves<'a>(value: &'a Value, at: &str, into: &mut Vec<(String, &'a Value)>) {
    match value {
        Value::Object(fields) => {
            let each = fields.iter();
            each.for_each(|(key, value)| leaves(value, &format!("{at}/{key}"), into));
        }
        Value::Array(items) => {
            let each = items.iter().enumerate();
            each.for_each(|(index, value)| leaves(value, &format!("{at}/{index}"), into));
        }
        // Keeps a place in a list.
        Value::Null => {}
        _ => into.push((at.to_owned(), value)),
    }
}

/// What stands in braces, sorted.
fn braces(text: &str) -> Vec<&str> {
    let parts = text.split('{').skip(1);
    let mut found: Vec<&str> = parts.filter_map(|part| part.split('}').next()).collect();
    found.sort_unstable();
    found
}

/// What is wrong with a text in place of another one.
fn of_text(text: &Value, base: &str) -> Result<(), String> {
    let Some(text) = text.as_str().filter(|text| !text.trim().is_empty()) else {
        return Err(format!("found {text}, expected words"));
    };
    let (found, wanted) = (braces(text), braces(base));
    match found == wanted {
        true => Ok(()),
        false => Err(format!(
            "found the figures {{{}}}, expected {{{}}}",
            found.join("}, {"),
            wanted.join("}, {")
        )),
    }
}

/// A code such as `de` or `pt-BR`.
pub(super) fn is_code(code: &str) -> bool {
    let (language, region) = code.split_once('-').unwrap_or((code, "XX"));
    let is_language = (2..=3).contains(&language.len());
    is_language
        && language.chars().all(|c| c.is_ascii_lowercase())
        && region.len() == 2
        && region.chars().all(|c| c.is_ascii_uppercase())
}

impl Lesson {
    /// The languages that it has texts in, its own first.
    pub fn languages(&self) -> Vec<&str> {
        let own = std::iter::once(self.language.as_str());
        own.chain(self.texts.keys().map(String::as_str)).collect()
    }

    /// The same in another language: the head and each step that have all their texts in it.
    #[must_use]
    pub fn in_language(&self, code: &str) -> Self {
        let translated = || {
            let texts = self.texts.get(code)?;
            let mut whole: Value = serde_json::from_str(&self.text).ok()?;
            whole.as_object_mut()?.remove("texts");
            let head: Option<Vec<_>> = HEAD.into_iter().map(|key| texts.get(key)).collect();
            if let Some(head) = head {
                for (key, text) in HEAD.into_iter().zip(head) {
                    whole[key] = text.clone();
                }
                whole["language"] = code.into();
            }
            let steps = whole["steps"].as_array_mut()?;
            for (step, texts) in steps.iter_mut().zip(texts["steps"].as_array()?) {
                put(step, texts);
            }
            Self::read(&self.name, &whole.to_string()).ok()
        };
        translated().unwrap_or_else(|| self.clone())
    }
}

/// Puts texts into a step where all of them are there.
fn put(step: &mut Value, texts: &Value) {
    let places = texts_of(step);
    let found = places.into_iter();
    let found = found.map(|(place, _)| Some((texts.pointer(&place)?.clone(), place)));
    let Some(found) = found.collect::<Option<Vec<_>>>() else {
        return;
    };
    for (text, place) in found {
        if let Some(old) = step.pointer_mut(&place) {
            *old = text;
        }
    }
}

/// What is wrong with a lesson's texts in other languages, and which steps stay in its own.
pub(super) fn faults(lesson: &Lesson) -> (Vec<Fault>, Vec<Fault>) {
    let (mut faults, mut advice) = (Vec::new(), Vec::new());
    let whole: Value = serde_json::from_str(&lesson.text).unwrap_or_default();
    let fault = |step: Option<usize>, what: String| Fault {
        file: lesson.name.clone(),
        step: step.map(|index| index + 1),
        what,
    };
    if !is_code(&lesson.language) {
        let what = format!(
            "found the language {}, expected a code such as en",
            lesson.language
        );
        faults.push(fault(None, what));
    }
    for (code, texts) in &lesson.texts {
        let of = |step, what: String| fault(step, format!("texts in {code}: {what}"));
        let Some(texts) = texts.as_object().filter(|_| is_code(code)) else {
            let what = "found no object under a code such as de, expected one".to_owned();
            faults.push(of(None, what));
            continue;
        };
        faults.extend(
            of_head(texts, &whole)
                .into_iter()
                .map(|what| of(None, what)),
        );
        let steps = texts.get("steps").and_then(Value::as_array);
        let steps = steps.map_or(&[][..], Vec::as_slice);
        let base = whole["steps"].as_array().map_or(&[][..], Vec::as_slice);
        if steps.len() > base.len() {
            let what = format!("found {} steps, expected {}", steps.len(), base.len());
            faults.push(of(None, what));
        }
        let nothing = Value::Null;
        for (index, step) in base.iter().enumerate() {
            let texts = steps.get(index).unwrap_or(&nothing);
            let (wrong, missing) = of_step(texts, step);
            faults.extend(wrong.into_iter().map(|what| of(Some(index), what)));
            if !missing.is_empty() {
                let what = format!("found no {}: the step stays in English", missing.join(", "));
                advice.push(of(Some(index), what.replace("English", &lesson.language)));
            }
        }
    }
    (faults, advice)
}

fn of_head(texts: &Map<String, Value>, whole: &Value) -> Vec<String> {
    let each = texts.iter().filter(|(key, _)| *key != "steps");
    let wrong = each.filter_map(|(key, text)| {
        if !HEAD.contains(&key.as_str()) {
            let known = HEAD.join(", ");
            return Some(format!("found {key}, expected one of {known} and steps"));
        }
        let why = of_text(text, whole[key].as_str().unwrap_or_default()).err()?;
        Some(format!("{key}: {why}"))
    });
    wrong.collect()
}

/// What is wrong with the texts of a step, and which it lacks.
fn of_step(texts: &Value, step: &Value) -> (Vec<String>, Vec<String>) {
    let base = texts_of(step);
    let mut found = Vec::new();
    leaves(texts, "", &mut found);
    let mut wrong = Vec::new();
    for (place, text) in &found {
        let name = place.trim_start_matches('/');
        let Some((_, base)) = base.iter().find(|(known, _)| known == place) else {
            wrong.push(format!("found {name}, expected a text that the step has"));
            continue;
        };
        wrong.extend(
            of_text(text, base)
                .err()
                .map(|why| format!("{name}: {why}")),
        );
    }
    let say = texts["say"].as_str().unwrap_or_default();
    let count = say.split_whitespace().count();
    if count > MOST_WORDS {
        wrong.push(format!(
            "found {count} words in say, expected at most {MOST_WORDS}"
        ));
    }
    let missing = base.into_iter().map(|(place, _)| place);
    let missing = missing.filter(|place| found.iter().all(|(known, _)| known != place));
    let missing = missing.map(|place| place.trim_start_matches('/').to_owned());
    (wrong, missing.collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::lessons::shelf;

    /// The shipped lesson on samples with German texts.
    fn german(change: impl Fn(&mut Value)) -> Lesson {
        let samples = shelf::named("samples").expect("shipped");
        let mut whole: Value = serde_json::from_str(&samples.text).expect("JSON");
        let mut texts = Map::new();
        for key in HEAD {
            texts.insert(key.to_owned(), Value::from(format!("Auf Deutsch: {key}")));
        }
        let steps = whole["steps"].as_array().expect("steps").clone();
        let translated = steps.iter().map(|step| {
            let mut empty = step.clone();
            for (place, text) in texts_of(step) {
                let german = format!("Deutsch, {place}: {{{}}}", braces(text).join("} {"));
                let german = german.replace("{}", "nichts");
                *empty.pointer_mut(&place).expect("there") = Value::from(german);
            }
            let mut only = Value::Object(Map::new());
            for key in ["say", "ask", "explain", "point", "task"] {
                if let Some(part) = empty.get(key) {
                    only[key] = part.clone();
                }
            }
            for (list, keys) in [
                ("/ask/answers", &["right"][..]),
                ("/task/until", &["figure", "between"]),
            ] {
                for item in only
                    .pointer_mut(list)
                    .and_then(Value::as_array_mut)
                    .into_iter()
                    .flatten()
                {
                    keys.iter()
                        .for_each(|key| drop(item.as_object_mut().expect("an item").remove(*key)));
                }
            }
            for (part, key) in [("task", "show"), ("point", "control")] {
                if let Some(part) = only.get_mut(part).and_then(Value::as_object_mut) {
                    part.remove(key);
                }
            }
            only
        });
        let translated: Vec<Value> = translated.collect();
        texts.insert("steps".to_owned(), Value::from(translated));
        let mut texts = Value::from(texts);
        change(&mut texts);
        whole["texts"] = serde_json::json!({"de": texts});
        Lesson::read("samples", &whole.to_string()).expect("a lesson")
    }

    fn wrong(change: impl Fn(&mut Value)) -> String {
        let (faults, _) = faults(&german(change));
        let words: Vec<String> = faults.iter().map(Fault::to_string).collect();
        words.join("; ")
    }

    #[test]
    fn a_lesson_speaks_another_language_whole() {
        let lesson = german(|_| {});
        assert_eq!(faults(&lesson), (Vec::new(), Vec::new()));
        assert_eq!(lesson.languages(), ["en", "de"]);
        let german = lesson.in_language("de");
        assert_eq!(
            (german.title.as_str(), german.language.as_str()),
            ("Auf Deutsch: title", "de")
        );
        for (step, base) in german.steps.iter().zip(&lesson.steps) {
            assert!(step.say.starts_with("Deutsch, /say"), "{}", step.say);
            let ask = step.ask.as_ref().expect("a question");
            let right = |step: &crate::app::lessons::Step| {
                let answers = &step.ask.as_ref().expect("a question").answers;
                answers.iter().position(|answer| answer.right)
            };
            assert!(
                ask.answers
                    .iter()
                    .all(|answer| answer.because.starts_with("Deutsch"))
            );
            assert_eq!(right(step), right(base));
            assert_eq!(step.stage, base.stage);
        }
        // What it has no texts in stays as it is.
        assert_eq!(lesson.in_language("fr"), lesson);
    }

    #[test]
    fn a_step_that_lacks_a_text_stays_whole_in_the_lessons_own_language() {
        let lesson = german(|texts| {
            texts["steps"][0]
                .as_object_mut()
                .expect("a step")
                .remove("explain");
            texts.as_object_mut().expect("texts").remove("next");
        });
        let (faults, advice) = faults(&lesson);
        assert_eq!((faults.len(), advice.len()), (0, 1));
        assert!(advice[0].what.contains("found no explain"), "{}", advice[0]);
        let german = lesson.in_language("de");
        assert_eq!(german.steps[0], lesson.steps[0]);
        assert!(german.steps[1].say.starts_with("Deutsch"));
        assert_eq!(
            (&german.title, &german.language),
            (&lesson.title, &lesson.language)
        );
    }

    #[test]
    fn unknown_keys_and_missing_figures_are_refused_with_their_place() {
        let words = wrong(|texts| texts["steps"][0]["sya"] = "?".into());
        assert!(
            words.contains("step 1: texts in de: found sya, expected a text"),
            "{words}"
        );
        let words = wrong(|texts| texts["steps"][0]["say"] = "Ohne Zahl.".into());
        assert!(
            words.contains("say: found the figures {}, expected {numbers}"),
            "{words}"
        );
        let words = wrong(|texts| texts["titel"] = "?".into());
        assert!(
            words.contains("found titel, expected one of title"),
            "{words}"
        );
        let words = wrong(|texts| texts["steps"][1]["explain"] = 7.into());
        assert!(
            words.contains("explain: found 7, expected words"),
            "{words}"
        );
    }
}
