//! `render`: a picture of the window, with no display needed.

use std::{
    ffi::{OsStr, OsString},
    io::Write,
    path::{Path, PathBuf},
    sync::Arc,
};

use super::{
    Pictures,
    arguments::Render,
    inputs::Inputs,
    options::PickOptions,
    painter, print,
    refusal::Refusal,
    subject,
    target::{Replaces, Target},
};
use crate::{
    app::{
        App, Command, Document, Opened, Settings,
        chart::Theme,
        following::{Asked, FollowAsked},
        lessons::shelf,
        open::Loaded,
        pages::{AskedLesson, Page, Place},
        photograph::is_photograph,
        picture::reload,
        workspace::Preferences,
    },
    io::{Choices, shown},
    streams::Pace,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a picture that cannot be written.
pub(super) fn run(
    options: &Render,
    pictures: Option<&dyn Pictures>,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Render {
        input,
        pick,
        model,
        against,
        out: path,
        force,
        size,
        theme,
        language,
        page,
        lesson,
        done,
        present,
        follow,
    } = options;
    let pictures = painter(pictures, "render")?;
    // A lesson brings its own light.
    let nothing = PickOptions::default();
    let (input, pick) = match lesson {
        Some(_) => (&None, &nothing),
        None => (input, pick),
    };
    let read = [input.as_deref(), pick.light.as_deref(), against.as_deref()];
    let mut target = Target::out(path, Replaces::Pictures, *force, &read);
    target.path()?;
    // A light's name is no photograph.
    let is_one = |input: &&OsString| *page == Page::Photograph && is_photograph(Path::new(input));
    let photograph = input.as_ref().filter(is_one);
    let mut app = match input.as_ref().filter(|_| photograph.is_none()) {
        Some(input) => subject::app(input, pick, *model, inputs)?,
        None => subject::first_app(pick, *model)?,
    };
    if lesson.is_none() {
        subject::compare(&mut app, against.as_deref(), inputs)?;
    }
    app.pages_follow(|pages| pages.image.selection = pick.pixels());
    if let (Page::Image | Page::Relit, Some(input)) = (page, input) {
        open_images(&mut app, input, inputs);
        let images = app.document().images.iter();
        let files = images.filter_map(|image| image.path());
        files.for_each(|file| target.reads(file));
    }
    let mut preferences = Preferences {
        dark: *theme == Theme::Dark,
        present: *present,
        page: *page,
        photographs_asked: photograph.map(PathBuf::from).into_iter().collect(),
        lesson_asked: lesson
            .as_deref()
            .map(|words| asked_lesson(words, *done))
            .transpose()?,
        follow_asked: follow.as_deref().map(recording),
        ..Preferences::default()
    };
    preferences.speak(*language);
    if app.document().second.is_some() {
        app.pages_follow(|pages| pages.follow_second(true));
    }
    let picture = pictures.window(&app, &preferences, *size);
    target.save(&picture)?;
    let is_learnt = page.place() == Place::Learn && lesson.is_none();
    if is_learnt && model.is_given() && !shows_the_model(&app, pictures, &preferences, *size) {
        inputs.note("no option of the model is used: the page does not show it");
    }
    let [width, height] = size;
    print(
        out,
        &format!("Wrote {}, {width} x {height} px.\n", shown(path)),
    )
}

/// A recording that is played to its end.
fn recording(path: &Path) -> FollowAsked {
    FollowAsked::new(Asked::Replay(path.to_owned(), Pace::Stepped))
}

/// Whether other settings of the model give another picture.
fn shows_the_model(
    app: &App,
    pictures: &dyn Pictures,
    preferences: &Preferences,
    size: [u32; 2],
) -> bool {
    let drawn = |settings| {
        let document = Document {
            settings,
            ..app.document().clone()
        };
        pictures.window(&App::with_document(document), preferences, size)
    };
    drawn(app.document().settings) != drawn(Settings::default())
}

/// A lesson and its step: `waves:2`, `mine.json:2`.
fn asked_lesson(words: &str, done: bool) -> Result<AskedLesson, Refusal> {
    let cut = words.rsplit_once(':');
    let cut = cut.and_then(|(name, step)| Some((name, step.parse::<usize>().ok()?)));
    let (name, step) = cut.unwrap_or((words, 1));
    let lesson = shelf::named(name).map_err(|why| Refusal::Usage(format!("--lesson: {why}")))?;
    let count = lesson.steps.len();
    match step.checked_sub(1).filter(|step| *step < count) {
        Some(step) => Ok(AskedLesson {
            name: name.to_owned(),
            step,
            done,
        }),
        None => Err(Refusal::Usage(format!(
            "--lesson: found step {step} of {}, expected 1 to {count}",
            lesson.name
        ))),
    }
}

/// The images of a file or a project, for the page that shows them.
fn open_images(app: &mut App, input: &OsStr, inputs: &mut Inputs) {
    match inputs.load(Path::new(input), &Choices::default()) {
        Loaded::File(opened) => {
            let images_alone = Opened {
                spectra: Vec::new(),
                ..*opened
            };
            app.apply(Command::Open(vec![images_alone]));
        }
        Loaded::Project { restored, .. } => {
            // What cannot be read again is not on the page, which says that nothing is open.
            let images = restored
                .images
                .iter()
                .filter_map(|i| reload::read_again(i).ok());
            images.for_each(|image| app.apply(Command::ImageIsBack(Arc::new(image))));
        }
        // A preset, or what was refused before.
        Loaded::Refused(_) => {}
    }
}
