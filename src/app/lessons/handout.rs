//! Sheets for a class: what a pupil writes on, and what a teacher holds.

use base64::{Engine as _, prelude::BASE64_STANDARD};

use super::{
    format::{Fault, Lesson},
    handout_parts::{Block, Picture, axis_svg, bare, escaped},
    handout_pdf,
    proof::{Played, play},
};
use crate::{
    app::{chart::Theme, charts::spectrum::spectrum_chart, pages::Page},
    languages::{Language, in_language, with_colon},
};

/// Width and height of a drawn plot, px.
const PLOT: [u32; 2] = [900, 420];

/// Formats of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// Markdown, with the pictures in files beside it.
    Markdown,
    /// One page of HTML with the pictures in it.
    Html,
    /// A4 pages.
    Pdf,
}

/// Readers of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reader {
    /// Questions with boxes to tick, room to write, axes to sketch on; no answers, and no picture
    /// that answers a question before it.
    Pupil,
    /// Every picture, every answer with its reason, notes and sources.
    Teacher,
}

/// A sheet, and the files beside it: the end of each name and its bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Handout {
    pub bytes: Vec<u8>,
    /// Pictures: `-1.svg` or `-1.png` and so on, to be put behind the sheet's own name.
    pub pictures: Vec<(String, Vec<u8>)>,
}

/// The page of a step, from 0, as PNG; `None` where there is no window that could draw it.
pub type PagePicture<'a> = &'a dyn Fn(usize) -> Option<Vec<u8>>;

/// Writes the sheets of a lesson for some readers in its language, each from a page of its own; the
/// lesson is played for it. `stem` is the sheet's name without its ending.
///
/// # Errors
/// [`Fault`] where it cannot be played, or drawn.
pub fn handout(
    lesson: &Lesson,
    readers: &[Reader],
    form: Form,
    stem: &str,
    page: PagePicture<'_>,
) -> Result<Handout, Fault> {
    let language = Language::of_locale(&lesson.language).unwrap_or_default();
    in_language(language, || made(lesson, readers, form, stem, page))
}

fn made(
    lesson: &Lesson,
    readers: &[Reader],
    form: Form,
    stem: &str,
    page: PagePicture<'_>,
) -> Result<Handout, Fault> {
    let [width, height] = PLOT;
    let mut steps = 0..;
    let played = play(lesson, |app, on| {
        let plot = || spectrum_chart(app).to_svg(width, height, Theme::Light);
        let drawn = steps.next().and_then(page).map(Picture::Png);
        drawn.or_else(|| (on == Page::Spectrum).then(|| Picture::Svg(plot())))
    })?;
    let mut blocks = Vec::new();
    for reader in readers {
        if !blocks.is_empty() {
            blocks.push(Block::NewPage);
        }
        match reader {
            Reader::Pupil => of_pupil(&mut blocks, lesson, &played),
            Reader::Teacher => of_teacher(&mut blocks, lesson, &played),
        }
    }
    let mut pictures = Vec::new();
    let bytes = match form {
        Form::Html => html(lesson, &blocks).into_bytes(),
        Form::Markdown => markdown(&blocks, stem, &mut pictures).into_bytes(),
        Form::Pdf => handout_pdf::pdf(&blocks).map_err(|what| Fault {
            file: lesson.name.clone(),
            step: None,
            what,
        })?,
    };
    Ok(Handout { bytes, pictures })
}

fn head(blocks: &mut Vec<Block>, lesson: &Lesson) {
    blocks.push(Block::Title(lesson.title.clone()));
    blocks.push(Block::Words(lesson.sentence.clone()));
}

fn step_head(blocks: &mut Vec<Block>, number: usize, step: &Played<Option<Picture>>) {
    let page = step.page.title();
    let place = tr!("Step {number}: {page}", number, page);
    blocks.push(Block::Heading(place));
    blocks.push(Block::Words(step.say.clone()));
}

fn choices(blocks: &mut Vec<Block>, step: &Played<Option<Picture>>) {
    if let Some((question, answers)) = &step.ask {
        blocks.push(Block::Led(said!("Predict."), question.clone()));
        let answers = ('A'..).zip(answers);
        blocks.extend(answers.map(|(letter, one)| Block::Choice(letter, one.text.clone())));
    }
}

fn of_pupil(blocks: &mut Vec<Block>, lesson: &Lesson, played: &[Played<Option<Picture>>]) {
    head(blocks, lesson);
    blocks.push(Block::Words(
        said!("Name: ______________________________   Date: ______________").to_owned(),
    ));
    for (index, step) in played.iter().enumerate() {
        step_head(blocks, index + 1, step);
        let has_picture = lesson.steps[index].stage.is_some();
        match &step.seen {
            // Later pictures answer the questions before them.
            Some(picture) if index == 0 && !lesson.steps[0].veil => {
                blocks.push(Block::Picture(picture.clone()));
            }
            _ if has_picture && step.page == Page::Spectrum => {
                let words = said!("Sketch the curve that you see, or that you expect.");
                blocks.push(Block::Words(words.to_owned()));
                blocks.push(Block::Axis);
            }
            _ => {}
        }
        choices(blocks, step);
        if step.ask.is_some() {
            blocks.push(Block::Led(said!("Because"), String::new()));
            blocks.push(Block::Lines(2));
        }
        if let Some(task) = &step.task {
            blocks.push(Block::Led(said!("Do."), task.clone()));
            blocks.push(Block::Led(said!("What I saw"), String::new()));
            blocks.push(Block::Lines(2));
        }
    }
    blocks.push(Block::Led(said!("One sentence to remember"), String::new()));
    blocks.push(Block::Lines(2));
}

fn of_teacher(blocks: &mut Vec<Block>, lesson: &Lesson, played: &[Played<Option<Picture>>]) {
    head(blocks, lesson);
    blocks.push(Block::Words(tr!(
        "Teacher's sheet. {minutes} minutes, for {audience}.",
        minutes = lesson.minutes,
        audience = lesson.audience_words()
    )));
    blocks.push(Block::Led(said!("Aim."), lesson.teaches.clone()));
    blocks.push(Block::Led(
        said!("Notes."),
        lesson.notes_for_teachers.clone(),
    ));
    for (index, step) in played.iter().enumerate() {
        step_head(blocks, index + 1, step);
        blocks.extend(step.seen.clone().map(Block::Picture));
        choices(blocks, step);
        let answers = step.ask.iter().flat_map(|(_, answers)| answers);
        for (letter, answer) in ('A'..).zip(answers) {
            let reason = &answer.because;
            let words = match answer.right {
                true => tr!("{letter}, right: {reason}", letter, reason),
                false => with_colon(letter, reason),
            };
            blocks.push(Block::Words(words));
        }
        if let Some(task) = &step.task {
            blocks.push(Block::Led(said!("Do."), task.clone()));
        }
        if !step.explain.is_empty() {
            blocks.push(Block::Led(said!("Why."), step.explain.clone()));
        }
    }
    blocks.push(Block::Led(said!("Remember."), lesson.remember.clone()));
    blocks.push(Block::Led(said!("Try next."), lesson.next.clone()));
    blocks.push(Block::Led(said!("Sources."), lesson.sources.join("; ")));
}

/// A PNG as an address that holds it.
pub fn data_url(png: &[u8]) -> String {
    format!("data:image/png;base64,{}", BASE64_STANDARD.encode(png))
}

fn html(lesson: &Lesson, blocks: &[Block]) -> String {
    let (title, language) = (escaped(&lesson.title), escaped(&lesson.language));
    let mut text = format!(
        "<!DOCTYPE html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>{title}</title>\n<style>body{{font:12pt/1.45 sans-serif;max-width:46em;\
         margin:2em auto;padding:0 1em}}svg,img{{width:100%;height:auto}}\
         .new{{break-before:page}}.line{{border-bottom:1px solid #888;height:2em}}\
         h2,.picture{{break-inside:avoid}}</style>\n</head>\n<body>\n"
    );
    for block in blocks {
        let part = match block {
            Block::Title(words) => format!("<h1>{}</h1>", escaped(words)),
            Block::Heading(words) => format!("<h2>{}</h2>", escaped(words)),
            Block::Words(words) => format!("<p>{}</p>", escaped(words)),
            Block::Led(lead, words) => format!("<p><b>{lead}</b> {}</p>", escaped(words)),
            Block::Choice(letter, words) => format!("<p>☐ {letter}. {}</p>", escaped(words)),
            Block::Picture(Picture::Svg(svg)) => {
                format!("<div class=\"picture\">{}</div>", bare(svg))
            }
            Block::Picture(Picture::Png(png)) => format!(
                "<div class=\"picture\"><img alt=\"{}\" src=\"{}\"></div>",
                said!("The page of this step"),
                data_url(png)
            ),
            Block::Axis => format!("<div class=\"picture\">{}</div>", axis_svg()),
            Block::Lines(count) => "<div class=\"line\"></div>".repeat(*count),
            Block::NewPage => "<div class=\"new\"></div>".to_owned(),
        };
        text += &part;
        text.push('\n');
    }
    text + "</body>\n</html>\n"
}

fn markdown(blocks: &[Block], stem: &str, pictures: &mut Vec<(String, Vec<u8>)>) -> String {
    let mut text = String::new();
    for block in blocks {
        let mut picture = |end: &str, bytes: Vec<u8>| {
            let known = pictures.iter().find(|(_, known)| *known == bytes);
            let name = known.map(|(name, _)| name.clone());
            let name = name.unwrap_or_else(|| {
                let name = format!("-{}.{end}", pictures.len() + 1);
                pictures.push((name.clone(), bytes));
                name
            });
            format!("![{}]({stem}{name})", said!("The page of this step"))
        };
        let part = match block {
            Block::Title(words) => format!("# {}", unmarked(words)),
            Block::Heading(words) => format!("## {}", unmarked(words)),
            Block::Words(words) => unmarked(words),
            Block::Led(lead, words) => format!("**{lead}** {}", unmarked(words)),
            Block::Choice(letter, words) => format!("☐ {letter}. {}", unmarked(words)),
            Block::Picture(Picture::Svg(svg)) => picture("svg", svg.clone().into_bytes()),
            Block::Picture(Picture::Png(png)) => picture("png", png.clone()),
            Block::Axis => picture("svg", axis_svg().into_bytes()),
            Block::Lines(count) => ["_".repeat(60).as_str()].repeat(*count).join("\n\n"),
            Block::NewPage => "<div style=\"page-break-before: always\"></div>".to_owned(),
        };
        text += part.trim_end();
        text += "\n\n";
    }
    text
}

/// Words in Markdown, where an element of HTML would be one.
fn unmarked(text: &str) -> String {
    text.replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::lessons::shelf;

    fn sheet(lesson: &Lesson, readers: &[Reader], form: Form) -> Handout {
        handout(lesson, readers, form, "sheet", &|_| None).expect("it plays")
    }

    fn words(lesson: &Lesson, reader: Reader, form: Form) -> String {
        String::from_utf8(sheet(lesson, &[reader], form).bytes).expect("text")
    }

    #[test]
    fn no_words_of_a_lesson_are_elements_of_a_sheet() {
        let mut lesson = Lesson::clone(&shelf::shipped()[0]);
        lesson.title = "<script>alert(1)</script>".to_owned();
        lesson.sentence = "<img src=x onerror=alert(1)>".to_owned();
        for form in [Form::Markdown, Form::Html] {
            let sheet = words(&lesson, Reader::Teacher, form);
            assert!(
                !sheet.contains("<script") && !sheet.contains("<img src=x"),
                "{form:?}"
            );
            assert!(sheet.contains("&lt;script"), "{form:?}");
        }
    }

    #[test]
    fn a_pupils_sheet_asks_and_a_teachers_answers() {
        let lesson = shelf::named("light").expect("shipped");
        for form in [Form::Markdown, Form::Html] {
            let pupil = words(&lesson, Reader::Pupil, form);
            let teacher = words(&lesson, Reader::Teacher, form);
            for ask in lesson.steps.iter().filter_map(|step| step.ask.as_ref()) {
                for answer in &ask.answers {
                    assert!(pupil.contains(&answer.text) && teacher.contains(&answer.text));
                    assert!(!pupil.contains(&answer.because), "{}", answer.because);
                    assert!(teacher.contains(&answer.because), "{}", answer.because);
                }
            }
            assert!(!pupil.contains(", right:") && teacher.contains(", right:"));
            assert!(!pupil.contains(&lesson.remember) && teacher.contains(&lesson.remember));
        }
    }

    #[test]
    fn pictures_of_markdown_stand_beside_it_once_each() {
        let lesson = shelf::named("light").expect("shipped");
        let sheet = sheet(&lesson, &[Reader::Pupil, Reader::Teacher], Form::Markdown);
        let text = String::from_utf8(sheet.bytes).expect("text");
        assert!(sheet.pictures.len() > 1);
        for (index, (name, bytes)) in sheet.pictures.iter().enumerate() {
            assert!(text.contains(&format!("](sheet{name})")), "{name}");
            assert!(
                sheet.pictures[..index]
                    .iter()
                    .all(|(_, other)| other != bytes)
            );
        }
    }

    #[test]
    fn a_sheet_as_pdf_has_pages() {
        let lesson = shelf::named("light").expect("shipped");
        let sheet = sheet(&lesson, &[Reader::Pupil, Reader::Teacher], Form::Pdf);
        assert!(sheet.bytes.starts_with(b"%PDF-") && sheet.pictures.is_empty());
        let text = String::from_utf8_lossy(&sheet.bytes);
        let pages = text.matches("/Type /Page\n").count();
        assert!((4..20).contains(&pages), "{pages}");
    }
}
