//! The workspace on disk: where it lies, how it is saved and loaded, what is kept aside.

use std::{
    path::{Path, PathBuf},
    time::Duration,
};

use super::{Restored, from_json, name_of};
use crate::io::{UNFINISHED, save_atomically};

/// Where the workspace lies on this computer; `None` when the system names no data folder.
pub fn default_path() -> Option<PathBuf> {
    let folders = directories::ProjectDirs::from("org", "", "spectral-explorer")?;
    Some(folders.data_dir().join("workspace.json"))
}

/// Why nothing can be kept at a path: there is something that is no file to be replaced, as
/// `/dev/null`, a pipe or a folder; `None` where a file is or may be.
pub fn no_file_at(path: &Path) -> Option<String> {
    let about = std::fs::metadata(path).ok()?;
    let path = path.display();
    if about.is_file() {
        None
    } else if about.is_dir() {
        Some(tr!(
            "The workspace {path} is a folder: nothing is kept.",
            path
        ))
    } else {
        Some(tr!(
            "The workspace {path} is a device or a pipe: nothing is kept.",
            path
        ))
    }
}

/// Saves a workspace so that a kill at any moment leaves either the old or the new one.
///
/// # Errors
/// One line for the status line.
pub fn save(path: &Path, text: &str) -> Result<(), String> {
    if let Some(why) = no_file_at(path) {
        return Err(why);
    }
    if let Some(folder) = path.parent() {
        make_folder(folder)?;
    }
    save_atomically(path, text.as_bytes()).map_err(|e| tr!("Workspace not saved: {why}.", why = e))
}

/// Makes the folder of a workspace.
///
/// # Errors
/// One line for the status line.
pub(super) fn make_folder(folder: &Path) -> Result<(), String> {
    std::fs::create_dir_all(folder)
        .map_err(|e| tr!("Workspace not saved: {why}.", why = no_folder(folder, &e)))
}

/// Why a folder for the workspace could not be made.
fn no_folder(folder: &Path, error: &std::io::Error) -> String {
    use std::io::ErrorKind;
    let folder = folder.display();
    match error.kind() {
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => {
            tr!(
                "found no permission to make the folder {folder}, expected one to write to",
                folder
            )
        }
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            tr!(
                "found the disk full at {folder}, expected room for the workspace",
                folder
            )
        }
        ErrorKind::NotADirectory | ErrorKind::AlreadyExists => {
            tr!(
                "found a file in the way of the folder {folder}, expected a folder",
                folder
            )
        }
        _ => tr!(
            "the folder {folder} cannot be made, expected one that can be written to",
            folder
        ),
    }
}

/// Takes away what a save left unfinished when the program was killed, if it is older than `age`:
/// what is younger may be another window's that is saving just now.
pub fn sweep_leftovers(path: &Path, age: Duration) {
    let Some(Ok(folder)) = path.parent().map(std::fs::read_dir) else {
        return;
    };
    for entry in folder.filter_map(Result::ok) {
        let is_ours = entry.file_name().to_string_lossy().starts_with(UNFINISHED);
        let about = entry.metadata().ok().filter(std::fs::Metadata::is_file);
        let modified = about.and_then(|about| about.modified().ok());
        let is_old = modified.is_some_and(|at| at.elapsed().is_ok_and(|passed| passed >= age));
        if is_ours && is_old {
            // Somebody else may have taken it away meanwhile.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// Loads the workspace; `Ok(None)` when there is none yet.
///
/// # Errors
/// One line. A workspace that cannot be read is set aside under another name, so that nothing
/// overwrites it; one of which something is lost is kept under another name as well.
pub fn load(path: &Path) -> Result<Option<Restored>, String> {
    if let Some(why) = no_file_at(path) {
        return Err(why);
    }
    let bytes = match std::fs::read(path) {
        Ok(bytes) => bytes,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
        Err(e) => return Err(set_aside(path, &[], &e.to_string())),
    };
    let text = std::str::from_utf8(&bytes).map_err(|why| why.to_string());
    match text.and_then(from_json) {
        Ok(mut restored) => {
            if !restored.losses.is_empty() {
                restored.losses.push(keep_copy(path, &bytes));
            }
            Ok(Some(restored))
        }
        Err(why) => Err(set_aside(path, &bytes, &why)),
    }
}

/// A name beside the workspace that nothing has yet, or that holds these very bytes.
fn name_beside(path: &Path, bytes: &[u8]) -> PathBuf {
    let first = path.with_extension("damaged.json");
    let others = (2..).map(|number| path.with_extension(format!("damaged-{number}.json")));
    let holds = |kept: &Path| {
        let about = std::fs::metadata(kept);
        about.is_ok_and(|about| about.is_file() && about.len() == bytes.len() as u64)
            && !bytes.is_empty()
            && std::fs::read(kept).is_ok_and(|kept| kept == bytes)
    };
    std::iter::once(first)
        .chain(others)
        .find(|kept| !kept.exists() || holds(kept))
        .unwrap_or_default()
}

/// Name and folder of a file, the name first: a narrow status line cuts the end, its tooltip has
/// all.
fn place_of(kept: &Path) -> String {
    tr!(
        "{file} in {folder}",
        file = name_of(kept),
        folder = kept.parent().unwrap_or(Path::new("")).display()
    )
}

/// Renames a workspace that cannot be read. Only files are ever renamed: whoever made a device or
/// a pipe means it.
fn set_aside(path: &Path, bytes: &[u8], why: &str) -> String {
    let kept = name_beside(path, bytes);
    match std::fs::rename(path, &kept) {
        Ok(()) => tr!(
            "The last workspace is damaged and kept as {place} ({why}).",
            place = place_of(&kept),
            why
        ),
        Err(e) => tr!(
            "The last workspace could not be read ({why}) nor set aside ({obstacle}).",
            why,
            obstacle = e
        ),
    }
}

/// Copies a workspace of which something is lost, before the next save replaces it.
fn keep_copy(path: &Path, bytes: &[u8]) -> String {
    let kept = name_beside(path, bytes);
    match save_atomically(&kept, bytes) {
        Ok(()) => tr!(
            "The workspace as it was found is kept as {place}.",
            place = place_of(&kept)
        ),
        Err(why) => tr!(
            "The workspace as it was found could not be kept: {why}.",
            why
        ),
    }
}
