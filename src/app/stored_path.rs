//! Paths in JSON to the last byte: a file's name may be bytes that are no text, and must neither
//! be lost nor keep everything else from being saved.
//!
//! A path that is text is written as text; another one, on systems whose names are bytes, as the
//! list of its bytes.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Deserializer, Serialize, Serializer};

#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Written {
    Text(String),
    Bytes(Vec<u8>),
}

impl Written {
    fn of(path: &Path) -> Self {
        match path.to_str() {
            Some(text) => Self::Text(text.to_owned()),
            None => Self::bytes(path),
        }
    }

    #[cfg(unix)]
    fn bytes(path: &Path) -> Self {
        use std::os::unix::ffi::OsStrExt;
        Self::Bytes(path.as_os_str().as_bytes().to_vec())
    }

    #[cfg(not(unix))]
    fn bytes(path: &Path) -> Self {
        Self::Text(path.to_string_lossy().into_owned())
    }

    fn path(self) -> PathBuf {
        match self {
            Self::Text(text) => text.into(),
            Self::Bytes(bytes) => from_bytes(bytes),
        }
    }
}

#[cfg(unix)]
fn from_bytes(bytes: Vec<u8>) -> PathBuf {
    use std::os::unix::ffi::OsStringExt;
    std::ffi::OsString::from_vec(bytes).into()
}

#[cfg(not(unix))]
fn from_bytes(bytes: Vec<u8>) -> PathBuf {
    String::from_utf8_lossy(&bytes).into_owned().into()
}

/// Writes one path: `#[serde(with = "stored_path")]`.
///
/// # Errors
/// Those of the serializer.
pub(super) fn serialize<S: Serializer>(path: &Path, serializer: S) -> Result<S::Ok, S::Error> {
    Written::of(path).serialize(serializer)
}

/// Reads one path.
///
/// # Errors
/// Those of the deserializer, and anything that is neither a text nor a list of bytes.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<PathBuf, D::Error> {
    Written::deserialize(deserializer).map(Written::path)
}

/// The same for a list of paths: `#[serde(with = "stored_path::list")]`.
pub(super) mod list {
    use std::path::PathBuf;

    use serde::{Deserialize, Deserializer, Serializer};

    use super::Written;

    /// Writes the paths.
    ///
    /// # Errors
    /// Those of the serializer.
    pub(crate) fn serialize<S: Serializer>(
        paths: &[PathBuf],
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(paths.iter().map(|path| Written::of(path)))
    }

    /// Reads them.
    ///
    /// # Errors
    /// As for one path.
    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(
        deserializer: D,
    ) -> Result<Vec<PathBuf>, D::Error> {
        let written = Vec::<Written>::deserialize(deserializer)?;
        Ok(written.into_iter().map(Written::path).collect())
    }
}
