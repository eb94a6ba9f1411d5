//! Files by their paths: the system's; in a browser, which has none, those that were handed over and
//! those that are to be saved.

use std::{
    io::{Read, Result, Seek, SeekFrom},
    path::Path,
};

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use std::fs::read;

#[cfg(target_arch = "wasm32")]
pub(crate) use browser::{Saved, hand_over, take_saved};
#[cfg(target_arch = "wasm32")]
pub(crate) use browser::{open, read};

/// Opens a file for reading.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) fn open(path: &Path) -> Result<std::fs::File> {
    std::fs::File::open(path)
}

/// Whether there is a file at a path: neither a folder nor a pipe.
pub(crate) fn is_file(path: &Path) -> bool {
    #[cfg(not(target_arch = "wasm32"))]
    return path.is_file();
    #[cfg(target_arch = "wasm32")]
    return open(path).is_ok();
}

/// Bytes of a file.
pub(crate) fn len(path: &Path) -> Result<u64> {
    open(path)?.seek(SeekFrom::End(0))
}

/// The first bytes of a file, so many at most; of none where it is no file, as looking into a pipe
/// would eat its beginning.
pub(crate) fn head(path: &Path, most: u64) -> Vec<u8> {
    let mut head = Vec::new();
    let file = Some(path).filter(|path| is_file(path)).map(open);
    if let Some(Ok(file)) = file
        && file.take(most).read_to_end(&mut head).is_err()
    {
        head.clear();
    }
    head
}

/// A file that is being written.
#[cfg(not(target_arch = "wasm32"))]
pub(crate) type Unfinished = std::fs::File;
#[cfg(target_arch = "wasm32")]
pub(crate) type Unfinished = std::io::Cursor<Vec<u8>>;

#[cfg(target_arch = "wasm32")]
mod browser {
    use std::{
        collections::BTreeMap,
        io::{Cursor, Error, ErrorKind, Result},
        path::{Path, PathBuf},
        sync::{Arc, Mutex, PoisonError},
    };

    /// A file to be saved.
    pub(crate) struct Saved {
        pub(crate) path: PathBuf,
        pub(crate) bytes: Vec<u8>,
    }

    pub(crate) type File = Cursor<Arc<[u8]>>;

    static HANDED: Mutex<BTreeMap<PathBuf, Arc<[u8]>>> = Mutex::new(BTreeMap::new());
    static SAVED: Mutex<Vec<Saved>> = Mutex::new(Vec::new());

    /// Keeps a file that a person chose or dropped, for as long as the page is open; where it is
    /// found.
    pub(crate) fn hand_over(name: &str, bytes: Vec<u8>) -> PathBuf {
        let path = PathBuf::from(name);
        let mut handed = HANDED.lock().unwrap_or_else(PoisonError::into_inner);
        handed.insert(path.clone(), bytes.into());
        path
    }

    /// Puts a file among those to be saved.
    pub(in crate::io) fn save(path: &Path, bytes: Vec<u8>) {
        let mut saved = SAVED.lock().unwrap_or_else(PoisonError::into_inner);
        saved.push(Saved {
            path: path.to_owned(),
            bytes,
        });
    }

    /// Files to be saved since the last call.
    pub(crate) fn take_saved() -> Vec<Saved> {
        std::mem::take(&mut SAVED.lock().unwrap_or_else(PoisonError::into_inner))
    }

    pub(crate) fn open(path: &Path) -> Result<File> {
        let handed = HANDED.lock().unwrap_or_else(PoisonError::into_inner);
        let file = handed.get(path).cloned().map(Cursor::new);
        file.ok_or_else(|| Error::from(ErrorKind::NotFound))
    }

    pub(crate) fn read(path: &Path) -> Result<Vec<u8>> {
        open(path).map(|file| file.into_inner().to_vec())
    }
}

#[cfg(target_arch = "wasm32")]
pub(super) use browser::save;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_is_as_long_as_the_file_and_a_folder_has_none() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("three");
        std::fs::write(&file, b"abc").unwrap();
        assert_eq!(head(&file, 2), b"ab");
        assert_eq!(head(&file, 9), b"abc");
        assert_eq!(len(&file).unwrap(), 3);
        assert_eq!(head(folder.path(), 9), b"");
        assert_eq!(head(&folder.path().join("none"), 9), b"");
    }
}
