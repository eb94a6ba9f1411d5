//! The workspace: what comes back after a restart or a kill, and the same as a named project.
//!
//! Shipped spectra are kept by name, the user's own with all their numbers. What no longer exists
//! (a preset of another version) or is not understood is left out and said, alone: the rest stays.

pub(super) mod earlier;
mod file;
mod gathering;
mod mending;
mod place;
mod preferences;
mod reading;
mod stored;

use super::document::Document;

pub use file::{default_path, load, no_file_at, save, sweep_leftovers};
pub use gathering::{Begun, begin};
pub use place::Place;
pub use preferences::{FOLDED_AT_FIRST, Preferences, ZOOMS};
pub use reading::from_json;
pub use stored::StoredImage;

/// The word that marks a workspace or project file.
pub const FORMAT: &str = "spectral-explorer-project";
/// The version written.
pub const VERSION: u32 = 1;

/// What came back from a workspace or project.
#[derive(Clone, Debug, PartialEq)]
pub struct Restored {
    pub document: Document,
    /// Images that are to be read again: a text holds no picture.
    pub images: Vec<StoredImage>,
    /// The window's preferences; `None` in a project.
    pub preferences: Option<Preferences>,
    /// What could not be brought back, a sentence each.
    pub losses: Vec<String>,
}

/// The name of a file without its folder.
fn name_of(path: &std::path::Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// The text of a workspace (with preferences) or a project (without).
///
/// # Errors
/// One line when it cannot be written as text; then nothing must be saved over what is there.
pub fn to_json(document: &Document, preferences: Option<&Preferences>) -> Result<String, String> {
    to_json_with(document, preferences, &[])
}

/// The same with images that are still being read again, or that were not found this time: what
/// is not there yet is not lost.
///
/// # Errors
/// As [`to_json`].
pub fn to_json_with(
    document: &Document,
    preferences: Option<&Preferences>,
    waiting: &[StoredImage],
) -> Result<String, String> {
    let stored = stored::Stored::of(document, preferences, waiting);
    serde_json::to_string_pretty(&stored)
        .map_err(|error| tr!("the document cannot be written as JSON: {why}", why = error))
}
