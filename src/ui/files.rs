//! The system's file dialogs, behind a seam that tests can fill.
//!
//! A dialog may be missing, may be cancelled, or may hang for ever; so it runs on a thread of its
//! own, its absence is told apart from a cancel by what the dialog library logs, and there is
//! always a second way in: a path that is typed, a file that is dropped, a command-line argument.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};
#[cfg(not(target_arch = "wasm32"))]
use std::{
    process::Command,
    sync::atomic::{AtomicBool, Ordering},
};

#[cfg(not(target_arch = "wasm32"))]
use eframe::egui;

#[cfg(not(target_arch = "wasm32"))]
use crate::app::open::{Loaded, load_bytes};

/// What the window asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Ask {
    /// One or more files to open.
    Open,
    /// A folder whose files are to be opened.
    OpenFolder,
    /// A place for a new file.
    Save {
        /// The name offered.
        suggested: String,
        /// The extension of what is written.
        extension: &'static str,
    },
}

/// What came of it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Picked {
    /// At least one path.
    Paths(Vec<PathBuf>),
    /// The person changed their mind.
    Cancelled,
    /// This system shows no dialog.
    NoDialog,
    /// They come later, as if they were dropped.
    #[cfg(target_arch = "wasm32")]
    Later,
}

/// Shows a dialog and waits for it; called on a thread of its own.
pub type Picker = Arc<dyn Fn(&Ask) -> Picked + Send + Sync>;

/// Set when the dialog library logged an error.
#[cfg(not(target_arch = "wasm32"))]
static DIALOG_FAILED: AtomicBool = AtomicBool::new(false);

/// The desktop's own dialogs.
#[cfg(not(target_arch = "wasm32"))]
pub fn system_picker() -> Picker {
    Arc::new(|ask| {
        DIALOG_FAILED.store(false, Ordering::SeqCst);
        let dialog = rfd::FileDialog::new();
        let paths = match ask {
            Ask::Open => dialog
                .set_title(said!("Open spectra"))
                .pick_files()
                .unwrap_or_default(),
            Ask::OpenFolder => dialog
                .set_title(said!("Open all files of a folder"))
                .pick_folders()
                .unwrap_or_default(),
            Ask::Save {
                suggested,
                extension,
            } => dialog
                .set_title(said!("Save"))
                .set_file_name(suggested)
                .add_filter(*extension, &[*extension])
                .save_file()
                .into_iter()
                .collect(),
        };
        match paths {
            paths if !paths.is_empty() => Picked::Paths(paths),
            _ if DIALOG_FAILED.load(Ordering::SeqCst) => Picked::NoDialog,
            _ => Picked::Cancelled,
        }
    })
}

/// What the status line says when there is no dialog.
pub const NO_DIALOG: &str = later!(
    "This system shows no file dialog (xdg-desktop-portal-gtk or zenity would). Type the path \
     instead, or drop the file on the window."
);

#[cfg(not(target_arch = "wasm32"))]
struct DialogWatch;

#[cfg(not(target_arch = "wasm32"))]
impl log::Log for DialogWatch {
    fn enabled(&self, metadata: &log::Metadata<'_>) -> bool {
        metadata.level() == log::Level::Error
    }

    fn log(&self, record: &log::Record<'_>) {
        if record.level() == log::Level::Error && record.target().starts_with("rfd") {
            DIALOG_FAILED.store(true, Ordering::SeqCst);
        }
    }

    fn flush(&self) {}
}

/// Listens to the dialog library's log; call once at start. A second logger is left in place.
#[cfg(not(target_arch = "wasm32"))]
pub fn watch_dialogs() {
    if log::set_logger(&DialogWatch).is_ok() {
        log::set_max_level(log::LevelFilter::Error);
    }
}

/// Opens a page in the browser; why it did not.
pub type Printer = Arc<dyn Fn(&Path) -> Result<(), String> + Send + Sync>;

/// The system's way to open a page.
#[cfg(not(target_arch = "wasm32"))]
pub(super) fn system_printer() -> Printer {
    Arc::new(|path| {
        let mut command = if cfg!(target_os = "windows") {
            let mut command = Command::new("cmd");
            command.args(["/C", "start", ""]);
            command
        } else if cfg!(target_os = "macos") {
            Command::new("open")
        } else {
            Command::new("xdg-open")
        };
        let ended = command.arg(path).status().map_err(|why| why.to_string())?;
        match ended.success() {
            true => Ok(()),
            false => Err(said!("the system knows none").to_owned()),
        }
    })
}

/// Files that were dropped: those with a path, and the others as they were read.
#[cfg(not(target_arch = "wasm32"))]
pub(super) fn dropped(ui: &egui::Ui) -> (Vec<PathBuf>, Vec<(String, Loaded)>) {
    let (mut paths, mut read) = (Vec::new(), Vec::new());
    for file in ui.input(|i| i.raw.dropped_files.clone()) {
        let path = file.path().to_owned();
        if path.is_file() || path.is_dir() {
            paths.push(path);
            continue;
        }
        let name = path.file_name().map_or_else(
            || said!("dropped file").to_owned(),
            |name| name.to_string_lossy().into_owned(),
        );
        let loaded = match file.bytes() {
            Ok(bytes) => load_bytes(&name, &bytes),
            Err(why) => Loaded::Refused(format!("{name}: {why}")),
        };
        read.push((name, loaded));
    }
    (paths, read)
}
