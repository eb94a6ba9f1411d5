//! What the window is asked to open: files and presets, checked before it comes up.

use std::{
    ffi::OsString,
    path::{Path, PathBuf},
    sync::Arc,
};

use super::refusal::Refusal;
use crate::{
    app::{
        App, Command, Entry,
        library::Library,
        open::{self, Loaded},
    },
    io::error::quoted,
};

/// Something to open.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// A file that exists; whether it can be read is found out on opening.
    File(PathBuf),
    /// A shipped spectrum.
    Preset(Arc<Entry>),
}

impl Input {
    /// The path of a file.
    pub fn file(&self) -> Option<PathBuf> {
        match self {
            Self::File(path) => Some(path.clone()),
            Self::Preset(_) => None,
        }
    }

    /// A shipped spectrum.
    pub fn preset(&self) -> Option<Arc<Entry>> {
        match self {
            Self::File(_) => None,
            Self::Preset(entry) => Some(entry.clone()),
        }
    }
}

/// The words as files and presets.
///
/// # Errors
/// [`Refusal::File`] for the first word that is neither.
pub fn inputs(words: &[OsString]) -> Result<Vec<Input>, Refusal> {
    words.iter().map(input).collect()
}

fn input(word: &OsString) -> Result<Input, Refusal> {
    let path = Path::new(word);
    if path.exists() && !path.is_dir() {
        return Ok(Input::File(path.to_owned()));
    }
    let name = word.to_string_lossy();
    match Library::bundled().find(&name) {
        Ok(preset) => Entry::of_preset(preset)
            .map(|entry| Input::Preset(Arc::new(entry)))
            .ok_or_else(|| {
                Refusal::File(format!(
                    "{}: found numbers that are no spectrum, expected a spectrum",
                    quoted(&name)
                ))
            }),
        Err(why) if path.is_dir() => Err(Refusal::File(format!(
            "{}: found a folder, expected a file or a preset ({why})",
            quoted(&name)
        ))),
        Err(why) => Err(Refusal::File(format!(
            "{}: found no such file, expected a file, a preset or a command ({why})",
            quoted(&name)
        ))),
    }
}

/// A fresh state with these opened in it, the first one shown, and a line for each that was
/// refused.
pub fn app_with(files: &[Input]) -> (App, Vec<String>) {
    let mut app = App::new();
    let mut refused = Vec::new();
    // The last one opened is shown, so the first comes last.
    for input in files.iter().rev() {
        match input {
            Input::Preset(entry) => app.apply(Command::Show(entry.clone())),
            Input::File(path) => match open::load_path(path) {
                Loaded::File(opened) => app.apply(Command::Open(vec![*opened])),
                Loaded::Project { restored, .. } => {
                    app.apply(Command::Replace(Box::new(restored.document)));
                }
                Loaded::Refused(why) => refused.insert(0, why),
            },
        }
    }
    (app, refused)
}
