//! A sheet for a class: words, questions, a picture of each step, and the answers on a page of
//! their own.

use std::fmt::Write as _;

use super::{
    format::{Fault, Lesson},
    proof::{Played, play},
};
use crate::app::{chart::Theme, charts::spectrum::spectrum_chart};

/// Width and height of a picture, px.
const PICTURE: [u32; 2] = [900, 420];

/// What a sheet is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Markdown, with the pictures in files beside it.
    Markdown,
    /// One page of HTML with the pictures in it.
    Html,
}

/// A sheet, and the files beside it: the end of each name and its text.
#[derive(Clone, Debug, PartialEq)]
pub struct Handout {
    /// The sheet.
    pub text: String,
    /// Pictures: `-1.svg` and so on, to be put behind the sheet's own name.
    pub pictures: Vec<(String, String)>,
}

/// Writes the sheet of a lesson, which is played for it; `stem` is the sheet's name without its
/// ending.
///
/// # Errors
/// [`Fault`] where it cannot be played.
pub fn handout(lesson: &Lesson, form: Form, stem: &str) -> Result<Handout, Fault> {
    let [width, height] = PICTURE;
    let played = play(lesson, |app, _| {
        spectrum_chart(app).to_svg(width, height, Theme::Light)
    })?;
    let mut sheet = Sheet {
        form,
        stem,
        text: String::new(),
        pictures: Vec::new(),
        last: "",
    };
    sheet.head(lesson);
    for (index, step) in played.iter().enumerate() {
        sheet.step(index + 1, step);
    }
    sheet.answers(lesson, &played);
    Ok(Handout {
        text: sheet.text,
        pictures: sheet.pictures,
    })
}

/// A sheet that is being written.
struct Sheet<'a> {
    form: Form,
    stem: &'a str,
    text: String,
    pictures: Vec<(String, String)>,
    /// The picture that was drawn last: one that did not change is not drawn again.
    last: &'a str,
}

impl<'a> Sheet<'a> {
    fn line(&mut self, html: &str, markdown: &str, words: &str) {
        // Writing to a string cannot fail.
        let _ = match self.form {
            Form::Html => writeln!(self.text, "<{html}>{}</{html}>", escaped(words)),
            Form::Markdown => writeln!(self.text, "{markdown}{}\n", unmarked(words)),
        };
    }

    /// A paragraph with a word in bold before it.
    fn led(&mut self, lead: &str, words: &str) {
        let html = format!("<p><b>{lead}</b> {}</p>\n", escaped(words));
        self.raw(&html, &format!("**{lead}** {}\n\n", unmarked(words)));
    }

    fn raw(&mut self, html: &str, markdown: &str) {
        let raw = match self.form {
            Form::Html => html,
            Form::Markdown => markdown,
        };
        self.text.push_str(raw);
    }

    fn head(&mut self, lesson: &Lesson) {
        let (title, language) = (escaped(&lesson.title), escaped(&lesson.language));
        self.raw(
            &format!(
                "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
                 <title>{title}</title>\n<style>body{{font:12pt/1.45 sans-serif;max-width:46em;\
                 margin:2em auto;padding:0 1em}}svg{{width:100%;height:auto}}\
                 .answers{{break-before:page}}</style>\n</head>\n<body>\n"
            ),
            "",
        );
        self.line("h1", "# ", &lesson.title);
        self.line("p", "", &lesson.sentence);
        let minutes = format!(
            "{} minutes, for {}.",
            lesson.minutes,
            lesson.audience_words()
        );
        self.line("p", "", &minutes);
    }

    fn step(&mut self, number: usize, step: &'a Played<String>) {
        let title = format!(
            "{number}. {}: {}",
            step.page.place().title(),
            step.page.title()
        );
        self.line("h2", "## ", &title);
        self.line("p", "", &step.say);
        if self.last != step.seen {
            let svg = step.seen.find("<svg").map_or("", |at| &step.seen[at..]);
            let name = format!("-{number}.svg");
            self.raw(
                svg,
                &format!(
                    "![What the plot shows at step {number}]({}{name})\n\n",
                    self.stem
                ),
            );
            if self.form == Form::Markdown {
                self.pictures.push((name, step.seen.clone()));
            }
            self.last = &step.seen;
        }
        if let Some((question, answers)) = &step.ask {
            self.led("Predict.", question);
            self.raw("<ol type=\"a\">\n", "");
            for (letter, answer) in ('a'..).zip(answers) {
                self.line("li", &format!("- {letter}) "), &answer.text);
            }
            self.raw("</ol>\n", "");
        }
        if let Some(task) = &step.task {
            self.led("Do.", task);
        }
    }

    fn answers(&mut self, lesson: &Lesson, played: &[Played<String>]) {
        self.raw(
            "<div class=\"answers\">\n",
            "<div style=\"page-break-before: always\"></div>\n\n",
        );
        self.line("h1", "# ", "Answers");
        for (number, step) in (1..).zip(played) {
            let answers = step.ask.iter().flat_map(|(_, answers)| answers);
            for (letter, answer) in ('a'..).zip(answers) {
                let mark = if answer.right { " (right)" } else { "" };
                let words = format!("{number} {letter}{mark}: {}", answer.because);
                self.line("p", "", &words);
            }
            if !step.explain.is_empty() {
                self.line("p", "", &format!("{number}: {}", step.explain));
            }
        }
        self.led("Remember.", &lesson.remember);
        self.led("Try next.", &lesson.next);
        self.raw("</div>\n</body>\n</html>\n", "");
    }
}

/// Words in Markdown, where an element of HTML would be one.
fn unmarked(text: &str) -> String {
    text.replace('<', "&lt;")
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::lessons::shelf;

    #[test]
    fn no_words_of_a_lesson_are_elements_of_a_sheet() {
        let mut lesson = Lesson::clone(&shelf::shipped()[0]);
        lesson.title = "<script>alert(1)</script>".to_owned();
        lesson.next = "<img src=x onerror=alert(1)>".to_owned();
        for form in [Form::Markdown, Form::Html] {
            let sheet = handout(&lesson, form, "sheet").expect("it plays").text;
            assert!(
                !sheet.contains("<script") && !sheet.contains("<img"),
                "{form:?}"
            );
            assert!(sheet.contains("&lt;script"), "{form:?}");
        }
    }

    #[test]
    fn a_sheet_has_every_question_and_its_answers_on_a_page_of_their_own() {
        let lesson = &shelf::shipped()[0];
        for form in [Form::Markdown, Form::Html] {
            let sheet = handout(lesson, form, "sheet").expect("it plays");
            let (questions, answers) = sheet.text.split_once("Answers").expect("two pages");
            for ask in lesson.steps.iter().filter_map(|step| step.ask.as_ref()) {
                assert!(questions.contains(&ask.answers[0].text));
                assert!(!questions.contains(&ask.answers[0].because));
            }
            assert!(answers.contains("(right)") && answers.contains(&lesson.remember));
            assert_eq!(sheet.text.contains("<svg"), form == Form::Html);
            for (name, svg) in &sheet.pictures {
                assert!(sheet.text.contains(&format!("](sheet{name})")) && svg.contains("<svg"));
            }
            assert_ne!(sheet.pictures.is_empty(), form == Form::Markdown);
        }
    }
}
