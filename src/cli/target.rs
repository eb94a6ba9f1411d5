//! Where a command writes to: never onto what it reads, and over another file only when asked.

use std::{
    ffi::OsStr,
    fs,
    io::{Read, Seek, SeekFrom},
    path::{Path, PathBuf},
};

use super::{inputs::named_spectrum, refusal::Refusal};
use crate::{
    app::{chart::SVG_HEAD, sheet::PDF_TAIL},
    io::{envi, png_chunks, save_atomically, shown, stream::is_standard_input},
};

/// What may be replaced without a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Replaces {
    /// No file: what is written is data.
    Nothing,
    /// Another picture that this program drew: they are drawn anew.
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
            target.reads(Path::new(named_spectrum(word).0));
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
        if path.is_symlink() && !path.exists() {
            let link = shown(path);
            return Err(Refusal::File(format!(
                "{what}: found {link}, a link to something that is not there, expected a new name \
                 or a file"
            )));
        }
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
        let is_free = *force || *replaces == Replaces::Pictures && is_own_picture(path);
        match replaces {
            _ if is_free => Ok(path),
            Replaces::Nothing => refused(
                "which exists already",
                "a new name (or --force to replace it)",
            ),
            Replaces::Pictures => refused(
                "which exists already and is no picture that this program drew",
                "a new name or such a picture to replace (or --force)",
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

/// How much of a file is looked at on both ends to tell a picture.
const LOOK_BYTES: usize = 4096;

/// Whether a file is a plot or a page that this program drew: its mark stands in the head of a PNG or
/// SVG and behind the end of a PDF, where whoever edits one leaves none. Spectral pictures are data
/// and have no mark.
fn is_own_picture(path: &Path) -> bool {
    let ends = || {
        let mut file = fs::File::open(path)?;
        let mut head = Vec::new();
        file.by_ref()
            .take(LOOK_BYTES as u64)
            .read_to_end(&mut head)?;
        let length = file.metadata()?.len();
        file.seek(SeekFrom::Start(length.saturating_sub(LOOK_BYTES as u64)))?;
        let mut tail = Vec::new();
        file.take(LOOK_BYTES as u64).read_to_end(&mut tail)?;
        std::io::Result::Ok([head, tail])
    };
    ends().is_ok_and(|[head, tail]| {
        head.starts_with(SVG_HEAD.as_bytes())
            || head.starts_with(b"%PDF-") && tail.ends_with(PDF_TAIL.as_bytes())
            || is_marked_png(&head)
    })
}

/// Whether the chunks that a PNG begins with tell this program as what wrote it.
fn is_marked_png(head: &[u8]) -> bool {
    let mark = concat!("Software\0", env!("CARGO_PKG_NAME")).as_bytes();
    let whole = png_chunks(head).into_iter().flatten().map_while(Result::ok);
    let mut before = whole.take_while(|(kind, _)| kind != b"IDAT");
    before.any(|(kind, data)| kind == *b"tEXt" && head[data] == *mark)
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
    use crate::{app::chart::Chart, io};

    #[test]
    fn only_a_picture_that_bears_the_programs_mark_is_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        let chart = Chart::default().to_svg(160, 120, crate::app::chart::Theme::Light);
        let pdf = |tail: &str| format!("%PDF-1.4\n{}%%EOF{tail}", "a thesis\n".repeat(1000));
        let png = io::png([2, 1], &[1, 2, 3, 1, 2, 3]).unwrap();
        let at = png.windows(8).position(|w| w == b"Software").unwrap();
        let mut of_others = png.clone();
        of_others[at] = b's';
        for (content, is) in [
            (&png[..], true),
            (&png[..60], false),
            (&of_others, false),
            (b"\x89PNG\r\n\x1a\n...", false),
            (b"\x89PNG\r\n\x1a\n\xff\xff\xff\xfftEXt", false),
            (chart.as_bytes(), true),
            (format!("<!-- mine -->{chart}").as_bytes(), false),
            (b"<?xml version='1.0'?>\n<!-- a plot > -->\n<svg/>", false),
            (pdf(PDF_TAIL).as_bytes(), true),
            (pdf("\n").as_bytes(), false),
            (format!("{}% a note", pdf(PDF_TAIL)).as_bytes(), false),
            (PDF_TAIL.as_bytes(), false),
            (b"380,1\n390,2\n", false),
            (b"", false),
        ] {
            fs::write(&path, content).unwrap();
            let shown = String::from_utf8_lossy(&content[..content.len().min(60)]);
            assert_eq!(is_own_picture(&path), is, "{shown}");
        }
    }
}
