//! From an input and its options to the program's state.

use std::{ffi::OsStr, path::Path};

use super::{
    inputs::Inputs,
    options::{ModelOptions, PickOptions},
    refusal::Refusal,
};
use crate::{
    app::{
        App, Command, Document, Entry, Opened, Subject,
        open::{self, Loaded, Wanted},
        ticks::short,
        workspace::Restored,
    },
    io::shown,
    spectrum::Kind,
};

/// The light on a reflectance when none is named.
pub(super) const USUAL_LIGHT: &str = "cie_illuminants/CIE D65";

/// The state about an input: a light, a reflectance under a light, or a saved project.
///
/// # Errors
/// [`Refusal::File`] for an input that cannot be found or read.
pub(super) fn app(
    input: &OsStr,
    pick: &PickOptions,
    model: ModelOptions,
    inputs: &mut Inputs,
) -> Result<App, Refusal> {
    app_of(input, pick, &pick.wanted(), model, inputs)
}

/// The same with more said about what is meant by the input.
///
/// # Errors
/// As [`app`].
pub(super) fn app_of(
    input: &OsStr,
    pick: &PickOptions,
    wanted: &Wanted,
    model: ModelOptions,
    inputs: &mut Inputs,
) -> Result<App, Refusal> {
    let light = match &pick.light {
        Some(name) => Some(light("--light", name, inputs)?),
        None => None,
    };
    if let Some(restored) = project(Path::new(input), inputs)? {
        let input = shown(Path::new(input));
        return of_project(&input, restored, pick, light, model, inputs);
    }
    let found = inputs.find(input, wanted);
    let entry = found
        .and_then(|found| found.usable(input))
        .map_err(Refusal::File)?;
    let is_light = entry.kind() == Kind::Light;
    if is_light && light.is_some() {
        let line = format!("--light is not used: {} is a light itself", entry.name());
        inputs.note(line);
    }
    let light = match light {
        Some(light) => light,
        None => open::resolve(USUAL_LIGHT, None, None).map_err(Refusal::File)?,
    };
    let mut document = Document::about(light.clone().into());
    document.settings = model.settings().clamped();
    let mut app = App::with_document(document);
    if !is_light {
        show(&mut app, light);
    }
    show(&mut app, entry);
    if model.is_given() {
        // Who turns a knob wants a composite taken apart with it.
        app.apply(Command::Analyse);
    }
    Ok(app)
}

/// The state about a light and nothing else.
pub(super) fn about_light(light: Entry, model: ModelOptions) -> App {
    let mut document = Document::about(light.into());
    document.settings = model.settings().clamped();
    if !model.is_given() {
        document.show_as_given();
    }
    App::with_document(document)
}

/// Refuses what has no value above zero in the model's range: it shines on nothing.
///
/// # Errors
/// [`Refusal::File`], as [`no_power`] has it.
pub(super) fn with_power(app: &App) -> Result<(), Refusal> {
    match app.derived().measured.iter().any(|value| *value > 0.0) {
        true => Ok(()),
        false => Err(no_power(app)),
    }
}

/// The refusal of what there is nothing to compute with in the model's range.
pub(super) fn no_power(app: &App) -> Refusal {
    let derived = app.derived();
    let has = |is: fn(&f64) -> bool| derived.measured.iter().any(is);
    let found = match (has(|v| *v > 0.0), has(|v| *v < 0.0)) {
        (false, false) => "nothing but zeros",
        (false, true) => "nothing above zero",
        (true, _) => "no value that is large enough to compute with",
    };
    Refusal::File(format!(
        "{}: found {found} from {} to {} nm, expected values above zero",
        app.document().subject_entry().name(),
        short(derived.band.min_nm()),
        short(derived.band.max_nm()),
    ))
}

/// The state that the window starts with, under other settings.
///
/// # Errors
/// [`Refusal::Usage`] for options that say something about an input.
pub(super) fn first_app(pick: &PickOptions, model: ModelOptions) -> Result<App, Refusal> {
    // How files are read is not among them: a set of files may be meant instead.
    if let Some(option) = pick.about_input(true) {
        return Err(Refusal::Usage(format!(
            "{option}: found no INPUT that it is about, expected one"
        )));
    }
    let mut app = App::new();
    let settings = model.settings();
    app.apply(Command::Edit(settings));
    Ok(app)
}

/// Compares the light with another one, where one is asked for.
///
/// # Errors
/// [`Refusal::File`] for what cannot be read or is no light.
pub(super) fn compare(
    app: &mut App,
    against: Option<&OsStr>,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    if let Some(against) = against {
        let second = light("--against", against, inputs)?;
        app.apply(Command::Compare(Some(second.into())));
    }
    Ok(())
}

/// Shows an entry; one from a file becomes one of the user's own, as in the window.
fn show(app: &mut App, entry: Entry) {
    app.apply(match entry.shelf() {
        Some(_) => Command::Show(entry.into()),
        None => {
            let composites = entry.composite.into_iter().map(|given| (0, given));
            let measured = entry.measured.into_iter().map(|known| (0, known));
            Command::Open(vec![Opened {
                composites: composites.collect(),
                measured: measured.collect(),
                ..Opened::alone(entry.spectrum, entry.makers)
            }])
        }
    });
}

/// A light by a word that may tell which of a file's spectra it is; `what` is the word of the
/// command line that named it. A file that does not say what its values are is taken as a light, with a word;
/// one that is sure of something else is none.
///
/// # Errors
/// [`Refusal::File`] for what cannot be found or read, or is no light.
pub(super) fn light(what: &str, name: &OsStr, inputs: &mut Inputs) -> Result<Entry, Refusal> {
    let refused = |why| Refusal::File(format!("{what}: {why}"));
    let mut wanted = Wanted::default();
    let mut found = inputs.find(name, &wanted).map_err(refused)?;
    let shown = shown(Path::new(name));
    if found.is_kind_open {
        inputs.note(format!(
            "{what}: {shown}: found nothing that says what its values are, taken as a light"
        ));
        if found.entry.kind() != Kind::Light {
            // Its numbers may have been taken for per cent.
            wanted.choices.kind = Some(Kind::Light);
            found = inputs.find(name, &wanted).map_err(refused)?;
        }
    }
    let entry = found.entry;
    if entry.kind() == Kind::Light {
        return Ok(entry);
    }
    let remedy = match entry.shelf() {
        Some(_) => "",
        None => " (convert it with --kind light if it is one)",
    };
    Err(refused(format!(
        "{shown}: found {} values, expected a light{remedy}",
        entry.kind()
    )))
}

/// The project in a file; `None` when the file is none or is something else.
fn project(path: &Path, inputs: &mut Inputs) -> Result<Option<Restored>, Refusal> {
    match inputs.project(path) {
        Some(Loaded::Project { restored, .. }) => Ok(Some(*restored)),
        Some(Loaded::Refused(why)) => Err(Refusal::File(why)),
        Some(Loaded::File(_)) | None => Ok(None),
    }
}

fn of_project(
    input: &str,
    restored: Restored,
    pick: &PickOptions,
    light: Option<Entry>,
    model: ModelOptions,
    inputs: &mut Inputs,
) -> Result<App, Refusal> {
    if let Some(option) = pick.about_input(false) {
        return Err(Refusal::Usage(format!(
            "{option}: found the project {input}, expected a file of spectra"
        )));
    }
    for loss in &restored.losses {
        inputs.note(format!("{input}: {loss}"));
    }
    let document = restored.document;
    let mut app = App::with_document(document);
    if model.is_given() {
        app.apply(Command::Analyse);
        let settings = model.over(app.document().settings);
        app.apply(Command::Edit(settings));
    }
    if let Some(light) = light {
        let subject = app.document().subject;
        if subject == Subject::Light {
            inputs.note("--light is not used: the project is about a light");
        } else {
            show(&mut app, light);
            app.apply(Command::About(subject));
        }
    }
    Ok(app)
}
