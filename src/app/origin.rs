//! Where a spectrum or an image came from: plain data in the document, so that undo and projects
//! know it too.

use std::{path::PathBuf, sync::Arc};

use serde::{Deserialize, Serialize};

use super::{memo::ByAddress, recipe::Recipe};
use crate::{io::Choices, preset::Shelf};

/// What stands in a spectrum's source before the name of what it was followed and captured from.
pub(super) const FOLLOWED: &str = "followed from ";
pub(super) const CAPTURED: &str = "captured from ";

/// Where the numbers of an entry came from.
#[derive(Clone, Debug)]
pub enum Origin {
    /// It is shipped and stands under this heading.
    Preset(Shelf),
    /// A file that was opened in this session.
    File(FromFile),
    /// It is made, and made again when what it stands on changes.
    Made(MadeBy),
    /// The numbers are all that is known.
    Numbers,
}

/// Numbers are numbers, whether their file is known still (in this session) or not.
impl PartialEq for Origin {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Preset(a), Self::Preset(b)) => a == b,
            (Self::Made(a), Self::Made(b)) => a == b,
            (Self::File(_) | Self::Numbers, Self::File(_) | Self::Numbers) => true,
            _ => false,
        }
    }
}

/// One of the things that a file brought.
#[derive(Clone, Debug)]
pub struct FromFile {
    pub reading: Arc<FileReading>,
    /// Which of the file's spectra, or of its images, from 0.
    pub index: usize,
}

#[derive(Debug)]
pub struct FileReading {
    pub file: Arc<SourceFile>,
    /// What a person decided about it.
    pub choices: Choices,
    /// How many spectra it brought.
    pub spectra: usize,
}

/// A file that was opened. Two are the same only when they are the same in memory: a file that is
/// opened twice stands in the library twice.
#[derive(Debug, Default)]
pub struct SourceFile {
    /// Where it lies; `None` for bytes that were dropped without a path.
    pub path: Option<PathBuf>,
    /// Its content where there is no path to read it from again.
    pub bytes: Option<Arc<[u8]>>,
    /// Its name without the folder.
    pub name: String,
    /// Its spectra are of no interest: only its images came back from a workspace.
    pub images_only: bool,
    /// What was on screen before it was opened.
    pub before: Before,
}

/// What was on screen before a file was opened: it stands there again when the file is taken out.
#[derive(Clone, Debug, Default)]
pub struct Before {
    /// Key of the light.
    pub light: String,
    /// Key of the reflectance or transmittance.
    pub factor: Option<String>,
    /// Whether the model was of the latter.
    pub about_factor: bool,
}

/// A recipe with what a person changed of its result.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MadeBy {
    /// How it is made.
    pub recipe: Recipe,
    /// The name that a person gave it; `None` for the recipe's own.
    #[serde(default)]
    pub name: Option<String>,
}

impl Origin {
    /// The file, where it is known.
    pub fn file(&self) -> Option<&FromFile> {
        match self {
            Self::File(file) => Some(file),
            Self::Preset(_) | Self::Made(_) | Self::Numbers => None,
        }
    }

    /// How it was made, where it was.
    pub fn made(&self) -> Option<&MadeBy> {
        match self {
            Self::Made(made) => Some(made),
            Self::Preset(_) | Self::File(_) | Self::Numbers => None,
        }
    }

    /// The recipe, where there is one.
    pub fn recipe(&self) -> Option<&Recipe> {
        self.made().map(|made| &made.recipe)
    }
}

impl FromFile {
    /// Whether it is of a file as it was opened once.
    pub fn is_of(&self, file: &ByAddress<SourceFile>) -> bool {
        Arc::ptr_eq(&self.reading.file, &file.0)
    }
}
