//! Links: what stands behind `#` in the address of the page opens a place, a light or a lesson.
//!
//! `lesson=light`, `page=quality`, `light=FL2`, `cs1=cosine;380:780;1 0 -0.5;` (a composite line,
//! whose mark stands before the `=`); several with `&` between them.

use std::sync::Arc;

use super::{
    App, Entry,
    lessons::shelf,
    open::{Loaded, load_bytes_as, resolve},
    pages::Page,
    share::short_line,
};
use crate::{io::Choices, spectrum::Kind};

/// What a part of a link opens.
pub enum Target {
    Page(Page),
    /// A shipped light or another spectrum that is known.
    Light(Arc<Entry>),
    /// A light that the link itself holds.
    File(Loaded),
    /// A lesson, by its name.
    Lesson(String),
}

/// What a link opens, part by part; an empty one opens nothing.
/// For a part that is not understood one line says what was found and what was expected.
pub fn targets(link: &str) -> Vec<Result<Target, String>> {
    let parts = link.split('&').filter(|part| !part.is_empty());
    parts.map(target).collect()
}

fn target(part: &str) -> Result<Target, String> {
    let (key, value) = part.split_once('=').unwrap_or((part, ""));
    let why = match key {
        "page" => match Page::of_word(value) {
            Some(page) => return Ok(Target::Page(page)),
            None => tr!(
                "found the page {page}, expected the word of a page",
                page = format!("{value:?}")
            ),
        },
        "light" => match resolve(value, None, None) {
            Ok(entry) => return Ok(Target::Light(Arc::new(entry))),
            Err(why) => why,
        },
        "lesson" => match shelf::named(value) {
            Ok(lesson) => return Ok(Target::Lesson(lesson.name.clone())),
            Err(why) => why.to_string(),
        },
        "cs1" | "cs2" => {
            let choices = Choices {
                kind: Some(Kind::Light),
                ..Choices::default()
            };
            let line = format!("{key};{value}").into_bytes().into();
            match load_bytes_as("a link", &line, &choices) {
                Loaded::Refused(why) => why,
                loaded => return Ok(Target::File(loaded)),
            }
        }
        _ => tr!(
            "found {part}, expected page, light, lesson, cs1 or cs2",
            part = format!("{key:?}")
        ),
    };
    Err(tr!("The link: {why}.", why))
}

/// The link that opens a page with the model of the light that is shown, in few digits; of what is
/// no light the page alone.
pub fn of_view(app: &App, page: Page) -> String {
    if !app.document().is_about_light() {
        return format!("page={}", page.word());
    }
    let line = short_line(&app.derived().model, app.document().settings.observer).text;
    // What may not stand in an address: a space.
    let line = line.replacen(';', "=", 1).replace(' ', "%20");
    format!("page={}&{line}", page.word())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{app::showing, io::parse_composite_line};

    #[test]
    fn a_link_opens_page_light_and_lesson_and_names_what_it_does_not_know() {
        let found = targets("page=quality&light=FL2&lesson=light&");
        assert!(matches!(found[0], Ok(Target::Page(page)) if page.word() == "quality"));
        assert!(matches!(&found[1], Ok(Target::Light(entry)) if entry.key.ends_with("/FL2")));
        assert!(matches!(&found[2], Ok(Target::Lesson(name)) if name == "light"));
        assert_eq!(found.len(), 3);
        assert!(targets("").is_empty());
        for wrong in ["page=nowhere", "light=", "lesson=none", "cs1=what", "word"] {
            let found = targets(wrong).pop().expect("one part");
            assert!(
                found.is_err_and(|why| why.starts_with("The link: ")),
                "{wrong}"
            );
        }
    }

    #[test]
    fn the_link_of_a_view_brings_its_model_and_page_back() {
        let app = showing("cie_fluorescent_1nm/FL2");
        let link = of_view(&app, Page::of_word("quality").expect("a page"));
        assert!(link.chars().all(|c| c.is_ascii_graphic()), "{link}");
        let found = targets(&link.replace("%20", " "));
        assert!(matches!(found[0], Ok(Target::Page(page)) if page.word() == "quality"));
        let Ok(Target::File(Loaded::File(opened))) = &found[1] else {
            panic!("no file")
        };
        let line = short_line(&app.derived().model, app.document().settings.observer).text;
        let model = parse_composite_line(&line).expect("a line");
        assert_eq!(opened.composite_of(0).as_deref(), Some(&model));
        assert!(opened.guesses.is_empty(), "nothing is asked");
        let red = of_view(&showing("colorchecker_ohta/red"), Page::Spectrum);
        assert_eq!(red, "page=look");
    }
}
