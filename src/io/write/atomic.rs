//! Saving a file in one step: write beside, bring to disk, rename over.
//!
//! Whoever looks sees the old file or the new one, also after a crash or a full disk.

use std::fs;
use std::io::{Error, ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::io::disk::Unfinished;
use crate::io::error::WriteError;
use crate::io::input::name_of;

/// The prefix of the name of a file not yet complete.
pub(crate) const UNFINISHED: &str = ".saving-";

/// Saves bytes as a file, replacing an old one in a single step.
///
/// A link is followed, and the permissions of a file that is replaced are kept. A pipe or device
/// is written into and not replaced.
///
/// # Errors
/// [`WriteError`] in words: no such folder, read-only folder, disk full, ...
pub fn save_atomically(path: &Path, bytes: &[u8]) -> Result<(), WriteError> {
    save_by(path, |file| {
        file.write_all(bytes).map_err(|error| refused(path, &error))
    })
}

/// Saves output written piece by piece, as [`save_atomically`] does. If the writing fails, nothing
/// is left behind, and an old file stays.
///
/// # Errors
/// Those of `write`, and [`WriteError`] in words.
pub(crate) fn save_by<T, E: From<WriteError>>(
    path: &Path,
    write: impl FnOnce(&mut Unfinished) -> Result<T, E>,
) -> Result<T, E> {
    #[cfg(target_arch = "wasm32")]
    return {
        let mut file = Unfinished::default();
        let written = write(&mut file)?;
        crate::io::disk::save(path, file.into_inner());
        Ok(written)
    };
    #[cfg(not(target_arch = "wasm32"))]
    {
        let refused = |error: Error| E::from(refused(path, &error));
        let place = Place::of(path).map_err(refused)?;
        let mut file = place.beside().map_err(refused)?;
        let written = write(file.as_file_mut())?;
        place.keep(file).map_err(refused)?;
        Ok(written)
    }
}

/// Saves several files: none of them where one has no room.
///
/// # Errors
/// As [`save_atomically`], of the first that cannot be written.
pub(crate) fn save_together(files: &[(PathBuf, &[u8])]) -> Result<(), WriteError> {
    let Some(((path, bytes), others)) = files.split_first() else {
        return Ok(());
    };
    save_by(path, |file| {
        let written = file.write_all(bytes);
        #[cfg(not(target_arch = "wasm32"))]
        let written = written.and_then(|()| file.sync_all());
        written.map_err(|error| refused(path, &error))?;
        save_together(others)
    })
}

fn refused(path: &Path, error: &Error) -> WriteError {
    WriteError::new(&name_of(path), words(path, error))
}

/// The destination of a file.
struct Place {
    target: PathBuf,
    /// Permissions of the file that is replaced.
    old: Option<fs::Permissions>,
    /// A pipe or device: it takes any output, and a file renamed over it would end it.
    is_taker: bool,
}

impl Place {
    fn of(path: &Path) -> Result<Self, Error> {
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if target.is_dir() {
            return Err(Error::from(ErrorKind::IsADirectory));
        }
        let about = fs::metadata(&target).ok();
        let is_taker = about.as_ref().is_some_and(|about| !about.is_file());
        let old = about.filter(|_| !is_taker).map(|about| about.permissions());
        if old.as_ref().is_some_and(fs::Permissions::readonly) {
            return Err(Error::new(
                ErrorKind::PermissionDenied,
                "the file is read-only",
            ));
        }
        Ok(Self {
            target,
            old,
            is_taker,
        })
    }

    /// A temporary file beside the target, named as incomplete.
    fn beside(&self) -> Result<NamedTempFile, Error> {
        let mut builder = tempfile::Builder::new();
        builder.prefix(UNFINISHED);
        #[cfg(unix)]
        let everyone = {
            use std::os::unix::fs::PermissionsExt;
            // As any new file: the user's mask restricts the permissions.
            fs::Permissions::from_mode(0o666)
        };
        #[cfg(unix)]
        builder.permissions(everyone);
        match self.is_taker {
            true => builder.tempfile(),
            false => builder.tempfile_in(folder_of(&self.target)),
        }
    }

    /// Puts a complete file into its place.
    fn keep(self, mut file: NamedTempFile) -> Result<(), Error> {
        if self.is_taker {
            let mut taker = fs::OpenOptions::new().write(true).open(&self.target)?;
            file.rewind()?;
            std::io::copy(file.as_file_mut(), &mut taker)?;
            return taker.flush();
        }
        if let Some(permissions) = self.old {
            file.as_file().set_permissions(permissions)?;
        }
        file.as_file().sync_all()?;
        file.persist(&self.target)
            .map_err(|refused| refused.error)?;
        sync_folder(&folder_of(&self.target));
        Ok(())
    }
}

fn folder_of(target: &Path) -> PathBuf {
    match target.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_owned(),
        _ => PathBuf::from("."),
    }
}

/// Brings the rename itself to disk. The file is complete either way, so a system that cannot
/// sync a folder is no error.
#[cfg(unix)]
fn sync_folder(folder: &Path) {
    if let Ok(folder) = fs::File::open(folder) {
        let _ = folder.sync_all();
    }
}

#[cfg(not(unix))]
fn sync_folder(_: &Path) {}

fn words(path: &Path, error: &Error) -> String {
    let folder = folder_of(path);
    let folder = folder.display();
    match error.kind() {
        ErrorKind::NotFound => tr!("found no folder {folder}, expected one that exists", folder),
        ErrorKind::NotADirectory => tr!("found a file at {folder}, expected a folder", folder),
        ErrorKind::IsADirectory => {
            said!("found a folder of this name, expected a file name").to_owned()
        }
        ErrorKind::PermissionDenied => {
            tr!(
                "found {folder} or the file read-only, expected permission to write there",
                folder
            )
        }
        ErrorKind::ReadOnlyFilesystem => {
            tr!(
                "found a read-only disk at {folder}, expected one to write to",
                folder
            )
        }
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            tr!(
                "found the disk full at {folder}, expected room for the file; nothing was changed",
                folder
            )
        }
        ErrorKind::InvalidFilename => {
            said!("found a file name this disk does not take, expected a shorter or plainer one")
                .to_owned()
        }
        _ => tr!("could not be saved in {folder}: {why}", folder, why = error),
    }
}
