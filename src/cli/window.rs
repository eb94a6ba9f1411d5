//! What the window is asked to open: files and presets, checked before it comes up.

use std::{
    ffi::OsString,
    path::{Path, PathBuf},
    sync::Arc,
};

use super::{arguments::Followed, refusal::Refusal};
use crate::{
    app::{
        App, Command, Entry, Library, Tone,
        following::{Asked, FollowAsked},
        open::{FileRow, Loaded, batch::read_all, names_a_file},
    },
    io::{quoted, stream::is_standard_input},
    streams::Reach,
};

/// Something to open.
#[derive(Clone, Debug, PartialEq)]
pub enum Input {
    /// A file or folder that exists; whether it can be read is found out on opening.
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

/// The words as files and presets. A file that is not there does not stop the others: it is told
/// among what was refused.
///
/// # Errors
/// [`Refusal::File`] for the first word that means no file, or when nothing is there.
pub(super) fn inputs(words: &[OsString]) -> Result<Vec<Input>, Refusal> {
    let found: Vec<_> = words.iter().map(input).collect();
    if found.iter().all(Result::is_err) {
        return found.into_iter().collect();
    }
    let or_missing = |(input, word): (Result<Input, Refusal>, &OsString)| match input {
        Err(_) if names_a_file(Path::new(word)) => Ok(Input::File(word.into())),
        input => input,
    };
    found.into_iter().zip(words).map(or_missing).collect()
}

/// What is to be followed in the window.
///
/// # Errors
/// [`Refusal::Usage`] for an instrument of nothing, and an address that others reach.
pub(super) fn followed(asked: &Followed) -> Result<Option<FollowAsked>, Refusal> {
    let source = match (&asked.follow, asked.listen) {
        (Some(path), _) => Some(match asked.replay {
            Some(pace) => Asked::Replay(path.clone(), pace),
            None => Asked::Path(path.clone()),
        }),
        (None, Some(address)) if address.ip().is_loopback() || asked.listen_all => {
            let reach = match asked.listen_all {
                true => Reach::All,
                false => Reach::Loopback,
            };
            Some(Asked::Tcp(address, reach))
        }
        (None, Some(address)) => {
            return Err(Refusal::Usage(format!(
                "--listen: {}, or --listen-all",
                crate::streams::ListenError::NotLoopback(address)
            )));
        }
        (None, None) if asked.instrument.is_some() => {
            return Err(Refusal::Usage(
                "--instrument: found nothing to follow, expected --follow or --listen".to_owned(),
            ));
        }
        (None, None) => None,
    };
    Ok(source.map(|source| FollowAsked {
        instrument: asked.instrument.clone(),
        ..FollowAsked::new(source)
    }))
}

fn input(word: &OsString) -> Result<Input, Refusal> {
    let path = Path::new(word);
    if path.exists() && !path.is_dir() {
        return Ok(Input::File(path.to_owned()));
    }
    let name = word.to_string_lossy();
    if is_standard_input(path) {
        return Err(Refusal::File(
            "\"-\": found standard input, expected a file, a folder, a preset or a command (report \
             and the other commands read it)"
                .to_owned(),
        ));
    }
    match Library::bundled().find_or_make(&name) {
        Ok(preset) => Entry::of_preset(&preset)
            .map(|entry| Input::Preset(Arc::new(entry)))
            .ok_or_else(|| {
                Refusal::File(format!(
                    "{}: found numbers that are no spectrum, expected a spectrum",
                    quoted(&name)
                ))
            }),
        Err(_) if path.is_dir() => Ok(Input::File(path.to_owned())),
        Err(why) => Err(Refusal::File(format!(
            "{}: found no such file, expected a file, a folder, a preset or a command ({why})",
            quoted(&name)
        ))),
    }
}

/// A fresh state with these opened in it, the first one shown, and a line for each that was
/// refused.
pub fn app_with(files: &[Input]) -> (App, Vec<String>) {
    let mut app = App::new();
    let paths: Vec<PathBuf> = files.iter().filter_map(Input::file).collect();
    let preset_first = files.first().is_some_and(|first| first.preset().is_some());
    let mut refused = Vec::new();
    if preset_first {
        open_all(&mut app, &paths, &mut refused);
    }
    // The last one opened is shown, so the first comes last.
    for preset in files.iter().rev().filter_map(Input::preset) {
        app.apply(Command::Show(preset));
    }
    if !preset_first {
        open_all(&mut app, &paths, &mut refused);
    }
    (app, refused)
}

/// Opens files and folders in one step.
fn open_all(app: &mut App, paths: &[PathBuf], refused: &mut Vec<String>) {
    if paths.is_empty() {
        return;
    }
    let finished = read_all(paths);
    let summary = finished.summary();
    refused.extend(summary.rows.iter().filter_map(FileRow::trouble));
    let (opened, projects) = finished.into_loaded();
    for project in projects {
        if let Loaded::Project { restored, .. } = project {
            app.apply(Command::Replace(Box::new(restored.document)));
        }
    }
    if !opened.is_empty() {
        app.apply(Command::Open(opened));
    }
    if summary.rows.len() > 1 {
        app.say(Tone::Info, format!("{}.", summary.headline()));
    }
}
