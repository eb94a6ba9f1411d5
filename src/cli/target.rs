//! Where a command writes to: never onto what it reads, and over another file only when asked.

use std::{
    ffi::OsStr,
    fs,
    io::Read,
    path::{Path, PathBuf},
};

use super::refusal::Refusal;
use crate::io::{envi, save_atomically, shown, stream::is_standard_input};

/// What may be replaced without a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Replaces {
    /// No file: what is written is data.
    Nothing,
    /// Another picture: they are drawn anew.
    Pictures,
}

/// A place to write to.
#[derive(Clone, Debug)]
pub(super) struct Target<'a> {
    /// The word of the command line that named it.
    pub what: &'static str,
    /// Where it is.
    pub path: &'a Path,
    /// What may be replaced.
    pub replaces: Replaces,
    /// Whether any other file may be.
    pub force: bool,
    /// What the command reads, and must be there afterwards.
    pub read: Vec<PathBuf>,
}

impl<'a> Target<'a> {
    /// What `--out` names, beside words that the command reads; names of presets mean no file and
    /// do no harm.
    pub(super) fn out(
        path: &'a Path,
        replaces: Replaces,
        force: bool,
        words: &[Option<&OsStr>],
    ) -> Self {
        let mut target = Self {
            what: "--out",
            path,
            replaces,
            force,
            read: Vec::new(),
        };
        for word in words.iter().flatten() {
            target.reads(Path::new(word));
        }
        target
    }

    /// Saves a file there.
    ///
    /// # Errors
    /// [`Refusal::File`] as [`Self::path`] has it, and for what cannot be written.
    pub(super) fn save(&self, bytes: &[u8]) -> Result<(), Refusal> {
        save_atomically(self.path()?, bytes).map_err(Refusal::file)
    }

    /// A file that the command reads.
    pub(super) fn reads(&mut self, path: &Path) {
        if is_standard_input(path) {
            // Where there is such a place, a file may have been put there.
            self.read.push(PathBuf::from("/dev/stdin"));
            return;
        }
        self.read.push(path.to_owned());
        self.read.extend(envi::pair_of(path));
    }

    /// The path, once nothing speaks against writing there. Pipes and devices are written into and
    /// stay what they are.
    ///
    /// # Errors
    /// [`Refusal::File`] for what is read, and for a file that would be lost.
    pub(super) fn path(&self) -> Result<&'a Path, Refusal> {
        let Self {
            what,
            path,
            replaces,
            force,
            read,
        } = self;
        if !path.is_file() {
            // Said before the work, not behind it.
            let folder = path
                .parent()
                .filter(|folder| !folder.as_os_str().is_empty());
            return match folder {
                Some(folder) if !folder.is_dir() => Err(Refusal::File(format!(
                    "{what}: found no folder {}, expected one that exists",
                    shown(folder)
                ))),
                _ => Ok(path),
            };
        }
        let name = shown(path);
        let refused = |found: &str, expected: &str| {
            let line = format!("{what}: found {name}, {found}, expected {expected}");
            Err(Refusal::File(line))
        };
        if read.iter().any(|input| is_same(input, path)) {
            return refused("which is what is read", "another file");
        }
        let is_free = *force || *replaces == Replaces::Pictures && is_picture(path);
        match replaces {
            _ if is_free => Ok(path),
            Replaces::Nothing => refused(
                "which exists already",
                "a new name (or --force to replace it)",
            ),
            Replaces::Pictures => refused(
                "which exists already and is no picture",
                "a new name or a picture to replace (or --force)",
            ),
        }
    }
}

/// Whether two paths lead to one file, by whatever links.
fn is_same(one: &Path, other: &Path) -> bool {
    let canonical = |path| fs::canonicalize(path).ok();
    is_one_node(one, other) || canonical(one).is_some_and(|one| canonical(other) == Some(one))
}

#[cfg(unix)]
fn is_one_node(one: &Path, other: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let node = |path| {
        fs::metadata(path)
            .ok()
            .map(|about| (about.dev(), about.ino()))
    };
    node(one).is_some_and(|one| node(other) == Some(one))
}

#[cfg(not(unix))]
fn is_one_node(_: &Path, _: &Path) -> bool {
    false
}

/// How much of a file is looked at to tell a picture.
const HEAD_BYTES: u64 = 4096;

/// Whether a file is a PNG or SVG picture by its content.
fn is_picture(path: &Path) -> bool {
    let mut head = Vec::new();
    let read = fs::File::open(path).and_then(|file| file.take(HEAD_BYTES).read_to_end(&mut head));
    read.is_ok()
        && (head.starts_with(b"\x89PNG\r\n\x1a\n")
            || head.starts_with(b"%PDF-")
            || is_svg(&String::from_utf8_lossy(&head)))
}

/// Whether a text begins as SVG does: its first element, behind declarations and comments, is one.
fn is_svg(text: &str) -> bool {
    let mut rest = text.trim_start_matches('\u{feff}').trim_start();
    loop {
        let end = match rest {
            _ if rest.starts_with("<!--") => "-->",
            _ if rest.starts_with("<?") => "?>",
            _ if rest.starts_with("<!") => ">",
            _ => return rest.starts_with("<svg"),
        };
        match rest.split_once(end) {
            Some((_, behind)) => rest = behind.trim_start(),
            None => return false,
        }
    }
}

/// A picture's name in a folder that nothing there has yet, not even a link.
pub(super) fn new_picture(folder: &Path) -> PathBuf {
    let first = folder.join(format!("{}.png", super::PROGRAM));
    let others = (2..).map(|number| folder.join(format!("{}-{number}.png", super::PROGRAM)));
    std::iter::once(first)
        .chain(others)
        .find(|path| fs::symlink_metadata(path).is_err())
        .unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_picture_is_told_by_its_content() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        for (content, is) in [
            (&b"\x89PNG\r\n\x1a\n..."[..], true),
            (b"<svg xmlns=''/>", true),
            (b"<?xml version='1.0'?>\n<!-- a plot > -->\n<svg/>", true),
            (b"<!DOCTYPE svg>\n<svg/>", true),
            (b"<html><svg/></html>", false),
            (b"<!-- <svg/>", false),
            (b"380,1\n390,2\n", false),
            (b"", false),
        ] {
            fs::write(&path, content).unwrap();
            assert_eq!(
                is_picture(&path),
                is,
                "{}",
                String::from_utf8_lossy(content)
            );
        }
    }
}
