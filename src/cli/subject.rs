//! From an input and its options to the program's state.

use std::{fs::File, io::Read, io::Write, path::Path};

use super::{
    options::{ModelOptions, PickOptions},
    refusal::Refusal,
    remark,
};
use crate::{
    app::{
        App, Command, Document, Entry,
        document::Subject,
        open::{self, Loaded},
        opened::Opened,
        workspace::{self, Restored},
    },
    spectrum::Kind,
};

/// The light on a reflectance when none is named.
const USUAL_LIGHT: &str = "cie_illuminants/CIE D65";

/// The state about an input: a light, a reflectance under a light, or a saved project.
///
/// # Errors
/// [`Refusal::File`] for an input that cannot be found or read.
pub fn app(
    input: &str,
    pick: &PickOptions,
    model: ModelOptions,
    err: &mut dyn Write,
) -> Result<App, Refusal> {
    let named = |name| light("--light", name, None);
    let light = pick.light.as_deref().map(named).transpose()?;
    if let Some(restored) = project(Path::new(input))? {
        return of_project(input, restored, pick, light, model, err);
    }
    let entry = open::resolve_pixels(input, pick.spectrum.as_deref(), pick.pixels(), pick.kind)
        .map_err(Refusal::File)?;
    let is_light = entry.kind() == Kind::Light;
    if is_light && light.is_some() {
        remark(
            err,
            &format!("--light is not used: {} is a light itself", entry.name()),
        );
    }
    let light = match light {
        Some(light) => light,
        None => open::resolve(USUAL_LIGHT, None, None).map_err(Refusal::File)?,
    };
    let mut document = Document::about(light.clone().into());
    document.settings = model.over(document.settings).clamped();
    let mut app = App::with_document(document);
    if !is_light {
        show(&mut app, light);
    }
    show(&mut app, entry);
    Ok(app)
}

/// The state about a light and nothing else.
pub fn about_light(light: Entry, model: ModelOptions) -> App {
    let mut document = Document::about(light.into());
    document.settings = model.over(document.settings).clamped();
    App::with_document(document)
}

/// The state that the window starts with, under other settings.
///
/// # Errors
/// [`Refusal::Usage`] for options that say something about an input.
pub fn first_app(pick: &PickOptions, model: ModelOptions) -> Result<App, Refusal> {
    let PickOptions {
        spectrum,
        kind,
        light,
        pixel,
        region,
    } = pick;
    let about_input = [
        ("--spectrum", spectrum.is_some()),
        ("--kind", kind.is_some()),
        ("--light", light.is_some()),
        ("--pixel", pixel.is_some()),
        ("--region", region.is_some()),
    ];
    if let Some((option, _)) = about_input.iter().find(|(_, given)| *given) {
        return Err(Refusal::Usage(format!(
            "{option}: found no INPUT that it is about, expected one"
        )));
    }
    let mut app = App::new();
    let settings = model.over(app.document().settings);
    app.apply(Command::Edit(settings));
    Ok(app)
}

/// Shows an entry; one from a file becomes one of the user's own, as in the window.
fn show(app: &mut App, entry: Entry) {
    app.apply(match entry.shelf {
        Some(_) => Command::Show(entry.into()),
        None => Command::Open(vec![Opened::alone(entry.spectrum, entry.makers)]),
    });
}

/// A light by its name; a file's values are taken as a light whatever they look like.
/// `what` is the word of the command line that named it, `spectrum` which one of a file it is.
///
/// # Errors
/// [`Refusal::File`] for what cannot be found or read, or is no light.
pub fn light(what: &str, name: &str, spectrum: Option<&str>) -> Result<Entry, Refusal> {
    let kind = Path::new(name).is_file().then_some(Kind::Light);
    let entry = open::resolve(name, spectrum, kind)
        .map_err(|why| Refusal::File(format!("{what}: {why}")))?;
    if entry.kind() != Kind::Light {
        return Err(Refusal::File(format!(
            "{what}: {name}: found {} values, expected a light",
            entry.kind()
        )));
    }
    Ok(entry)
}

/// The project in a file; `None` when the file is none or is something else.
fn project(path: &Path) -> Result<Option<Restored>, Refusal> {
    let mut head = Vec::new();
    let is_project = path.is_file()
        && File::open(path)
            .and_then(|file| file.take(512).read_to_end(&mut head))
            .is_ok()
        && String::from_utf8_lossy(&head).contains(workspace::FORMAT);
    if !is_project {
        return Ok(None);
    }
    match open::load_path(path) {
        Loaded::Project { restored, .. } => Ok(Some(*restored)),
        Loaded::Refused(why) => Err(Refusal::File(why)),
        Loaded::File(_) => Ok(None),
    }
}

fn of_project(
    input: &str,
    restored: Restored,
    pick: &PickOptions,
    light: Option<Entry>,
    model: ModelOptions,
    err: &mut dyn Write,
) -> Result<App, Refusal> {
    for (option, given) in [
        ("--spectrum", pick.spectrum.is_some()),
        ("--kind", pick.kind.is_some()),
        ("--pixel", pick.pixel.is_some()),
        ("--region", pick.region.is_some()),
    ] {
        if given {
            return Err(Refusal::Usage(format!(
                "{option}: found the project {input}, expected a file of spectra"
            )));
        }
    }
    for loss in &restored.losses {
        remark(err, &format!("{input}: {loss}"));
    }
    let mut document = restored.document;
    document.settings = model.over(document.settings).clamped();
    let mut app = App::with_document(document);
    if let Some(light) = light {
        let subject = app.document().subject;
        if subject == Subject::Light {
            remark(err, "--light is not used: the project is about a light");
        } else {
            show(&mut app, light);
            app.apply(Command::About(subject));
        }
    }
    Ok(app)
}
