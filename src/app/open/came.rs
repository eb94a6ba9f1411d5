//! What came of each file that was opened.

use std::path::PathBuf;

use super::Loaded;

/// What came of one file.
#[derive(Debug)]
pub enum Came {
    /// It was looked at.
    Loaded(Loaded),
    /// It was not, and why.
    NotRead(String),
}

/// One file of a batch.
#[derive(Debug)]
pub struct FileRead {
    /// Its path below what was opened, or its name.
    pub label: String,
    /// Where it is; `None` when it came without a path.
    pub path: Option<PathBuf>,
    pub came: Came,
}
