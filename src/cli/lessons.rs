//! `lessons`: the list, one lesson checked, or a sheet for a class.

use std::{fmt::Write as _, io::Write, path::Path, sync::Arc};

use serde_json::{Value, json};

use super::{
    Pictures,
    arguments::{LessonAct, Lessons},
    print, print_json,
    refusal::Refusal,
    target::{Replaces, Target},
    words,
};
use crate::{
    app::{
        App,
        lessons::{
            self, Fault, Findings, Lesson,
            handout::{Form, Reader, handout},
            shelf,
        },
        pages::Page,
        workspace::Preferences,
    },
    io::{many::many, one_line, save_together, shown},
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a lesson that cannot be read or played, and a sheet that cannot be written.
pub(super) fn run(
    options: &Lessons,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
) -> Result<(), Refusal> {
    let Lessons {
        act,
        lesson,
        json,
        pupil,
        teacher,
        language,
        out: path,
        force,
    } = options;
    let readers: &[Reader] = match (pupil, teacher) {
        (true, _) => &[Reader::Pupil],
        (_, true) => &[Reader::Teacher],
        _ => &[Reader::Pupil, Reader::Teacher],
    };
    match (act, lesson, path) {
        (None, None, None) => list(*json, out),
        (Some(LessonAct::Check), Some(word), None) => check(word, pictures, out),
        (Some(LessonAct::Handout), Some(word), Some(path)) => {
            let lesson = in_language(word, language.as_deref())?;
            sheet((word, &lesson), (path, *force), readers, pictures, out)
        }
        (Some(LessonAct::Handout), _, None) => Err(Refusal::Usage(
            "lessons handout: found no --out, expected a file that ends in .md, .html or .pdf"
                .to_owned(),
        )),
        _ => Err(Refusal::Usage(
            "lessons: found --out without handout, expected lessons handout NAME --out FILE"
                .to_owned(),
        )),
    }
}

fn list(as_json: bool, out: &mut dyn Write) -> Result<(), Refusal> {
    let all = shelf::shipped();
    if as_json {
        let all: Vec<Value> = all.iter().map(|lesson| of_lesson(lesson)).collect();
        return print_json(out, &Value::Array(all));
    }
    let widest = all.iter().map(|lesson| lesson.name.len()).max();
    let width = widest.unwrap_or(0);
    let mut text = String::new();
    for lesson in all {
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "{:<width$}  {:>2} min  {} ({})",
            lesson.name,
            lesson.minutes,
            lesson.title,
            lesson.audience_words()
        );
    }
    print(out, &text)
}

fn of_lesson(lesson: &Lesson) -> Value {
    json!({
        "name": lesson.name,
        "title": lesson.title,
        "sentence": lesson.sentence,
        "minutes": lesson.minutes,
        "audience": lesson.audience,
        "steps": lesson.steps.len(),
    })
}

fn check(word: &str, pictures: Option<&dyn Pictures>, out: &mut dyn Write) -> Result<(), Refusal> {
    let lesson = match shelf::read_named(word) {
        Ok(lesson) => lesson,
        Err(faults) => return refuse(word, &faults, out),
    };
    let names = |app: &App, page: Page| {
        let preferences = Preferences {
            page,
            ..Preferences::default()
        };
        pictures?.names(app, &preferences)
    };
    let found = lessons::check(&lesson, &names);
    refuse(&lesson.name, &found.faults, out)?;
    let (title, steps) = (one_line(&lesson.title), lesson.steps.len());
    let with = match lesson.also.len() {
        0 => String::new(),
        count => format!(", also with {}", many(count, "other light", "other lights")),
    };
    let advice = found.advice.iter().map(|one| format!("Advice: {one}\n"));
    let advice: String = advice.collect();
    print(
        out,
        &format!("{title}: {steps} steps, played through{with}.\n{advice}"),
    )
}

/// Tells all faults there are.
fn refuse(name: &str, faults: &[Fault], out: &mut dyn Write) -> Result<(), Refusal> {
    match faults {
        [] => Ok(()),
        [only] => Err(Refusal::file(only)),
        all => {
            print(out, &(Findings::lines(all) + "\n"))?;
            let count = all.len();
            let words = format!("{name}: found {count} faults, expected none");
            Err(Refusal::file(words))
        }
    }
}

/// A lesson in one of the languages that it has texts in.
fn in_language(word: &str, code: Option<&str>) -> Result<Lesson, Refusal> {
    let lesson = shelf::named(word).map_err(Refusal::file)?;
    match code {
        Some(code) if !lesson.languages().contains(&code) => Err(Refusal::Usage(format!(
            "--language: found {code}, expected one of {}",
            lesson.languages().join(", ")
        ))),
        Some(code) => Ok(lesson.in_language(code)),
        None => Ok(Lesson::clone(&lesson)),
    }
}

fn sheet(
    (word, lesson): (&str, &Lesson),
    (path, force): (&Path, bool),
    readers: &[Reader],
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
) -> Result<(), Refusal> {
    let form = match words::extension(path).as_str() {
        "html" => Form::Html,
        "pdf" => Form::Pdf,
        _ => Form::Markdown,
    };
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let whole = Arc::new(lesson.clone());
    let page = |step| pictures?.step(&whole, step);
    let sheet = handout(lesson, readers, form, &stem, &page).map_err(Refusal::file)?;
    let beside = sheet.pictures.iter();
    let beside = beside.map(|(end, picture)| {
        let file = path.with_file_name(format!("{stem}{end}"));
        (file, picture.as_slice())
    });
    let first = (path.to_owned(), sheet.bytes.as_slice());
    let files: Vec<_> = std::iter::once(first).chain(beside).collect();
    let target = |path, replaces| Target {
        what: "--out",
        path,
        replaces,
        force,
        read: vec![word.into()],
    };
    // Nothing is written where one of them may not be.
    target(path, Replaces::Nothing).path()?;
    for (file, _) in &files[1..] {
        target(file, Replaces::Pictures).path()?;
    }
    save_together(&files).map_err(Refusal::file)?;
    let pictures = match files.len() - 1 {
        0 => String::new(),
        count => format!(" and {count} pictures beside it"),
    };
    print(out, &format!("Wrote {}{pictures}.\n", shown(path)))
}
