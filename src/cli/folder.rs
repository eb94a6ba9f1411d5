//! Every spectrum of a folder's files.

use std::{
    fs,
    path::{Path, PathBuf},
};

use super::{inputs::Inputs, refusal::Refusal};
use crate::{
    app::open::Loaded,
    io::{Choices, shown},
    spectrum::NamedSpectrum,
};

/// The files in a folder, but not those of the folders below it.
///
/// # Errors
/// [`Refusal::File`] when the folder cannot be read.
pub(super) fn files_in(folder: &Path) -> Result<Vec<PathBuf>, Refusal> {
    let unreadable = |why: std::io::Error| {
        let name = shown(folder);
        Refusal::File(format!(
            "{name}: found {}, expected a folder to read",
            why.kind()
        ))
    };
    let items = fs::read_dir(folder).map_err(unreadable)?;
    let paths: Result<Vec<PathBuf>, _> = items.map(|item| Ok(item?.path())).collect();
    let mut paths = paths.map_err(unreadable)?;
    // A pipe in the folder would be waited for without end.
    paths.retain(|path| path.is_file());
    paths.sort();
    Ok(paths)
}

/// The spectra of some files, each with its file; those that are none are said to be skipped.
pub(super) fn spectra_of(paths: &[PathBuf], inputs: &mut Inputs) -> Vec<(PathBuf, NamedSpectrum)> {
    let mut all = Vec::new();
    for path in paths {
        match inputs.load(path, &Choices::default()) {
            Loaded::File(opened) => {
                let spectra = opened.into_spectra().into_iter();
                all.extend(spectra.map(|spectrum| (path.clone(), spectrum)));
            }
            Loaded::Refused(why) => inputs.remark(&format!("skipped: {why}")),
            Loaded::Project { .. } => {
                inputs.remark(&format!("skipped: {}: a project", shown(path)));
            }
        }
    }
    all
}
