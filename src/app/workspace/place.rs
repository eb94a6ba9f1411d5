//! Several windows, one workspace: each writes a file of its own.
//!
//! The first window has the workspace itself, a second one `workspace.window-2.json` beside it,
//! and so on. Who has a file holds a lock on an empty file beside it, which the system lets go of
//! however the window ends: a workspace without a lock is one that nobody writes to. The next
//! window takes the first file that is free, and brings the spectra of all other free ones in.

use std::{
    fs::{File, OpenOptions, TryLockError},
    path::{Path, PathBuf},
};

use super::file::make_folder;

/// Most windows that keep a workspace at the same time.
const MOST_WINDOWS: usize = 32;

/// A workspace that no other window writes to for as long as this lives.
#[derive(Debug)]
pub struct Place {
    /// The workspace itself, which the first window has.
    first: PathBuf,
    number: usize,
    path: PathBuf,
    lock: Option<File>,
}

impl Place {
    /// The workspace at `first`, or where another window has it the next one beside it.
    ///
    /// # Errors
    /// One line: no folder for it, or more windows than anybody opens.
    pub fn claim(first: &Path) -> Result<Self, String> {
        // Two names of one file are one workspace.
        let first = std::fs::canonicalize(first).unwrap_or_else(|_| first.to_owned());
        if let Some(folder) = first.parent() {
            make_folder(folder)?;
        }
        let place = (1..=MOST_WINDOWS).find_map(|number| Self::try_number(&first, number));
        place.ok_or_else(|| {
            tr!(
                "{count} windows use the workspace {path}: nothing is kept of this one.",
                count = MOST_WINDOWS,
                path = first.display()
            )
        })
    }

    /// The file that this window writes.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether another window has the workspace itself.
    pub fn is_beside(&self) -> bool {
        self.number > 1
    }

    /// Whether other windows are kept away. Some disks know no locks.
    pub fn is_locked(&self) -> bool {
        self.lock.is_some()
    }

    /// Those with higher numbers than this one's that no window writes to any more.
    pub fn left_behind(&self) -> Vec<Self> {
        (self.number + 1..=MOST_WINDOWS)
            .filter(|number| numbered(&self.first, *number).is_file())
            .filter_map(|number| Self::try_number(&self.first, number))
            // Without a lock nobody knows whether its window is still there.
            .filter(Self::is_locked)
            .collect()
    }

    /// Where it is kept once its spectra are in another workspace.
    pub fn retired(&self) -> PathBuf {
        self.path.with_extension("brought.json")
    }

    /// The file of a number; `None` where another window has it.
    fn try_number(first: &Path, number: usize) -> Option<Self> {
        let path = numbered(first, number);
        let free = |lock| {
            Some(Self {
                first: first.to_owned(),
                number,
                path: path.clone(),
                lock,
            })
        };
        let mut name = path.clone().into_os_string();
        name.push(".lock");
        let file = OpenOptions::new()
            .create(true)
            .truncate(false)
            .write(true)
            .open(name);
        // Where no file can be made, saving tells what is wrong.
        let Ok(file) = file else { return free(None) };
        match file.try_lock() {
            Ok(()) => free(Some(file)),
            Err(TryLockError::WouldBlock) => None,
            Err(TryLockError::Error(_)) => free(None),
        }
    }
}

/// The file of the window of that number, from 1.
fn numbered(first: &Path, number: usize) -> PathBuf {
    match number {
        1 => first.to_owned(),
        _ => first.with_extension(format!("window-{number}.json")),
    }
}
