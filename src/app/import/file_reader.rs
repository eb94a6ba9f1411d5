//! Reads a file again: small ones at once, large ones on a thread of their own.

use std::sync::Arc;

use crate::{
    app::{
        open::{Loaded, load_bytes_as, load_path_as, unshaken},
        opened::Opened,
        origin::SourceFile,
        studies::{Job, Stage, Wake, Work},
    },
    io::{Choices, decode_text, disk, is_binary},
};

/// Files up to this size are read again at once, larger ones on a thread of their own; bytes.
const AT_ONCE_BYTES: u64 = 4 * 1024 * 1024;

/// Bytes of a file that its first rows are looked for in.
const HEAD_BYTES: usize = 256 * 1024;

fn is_small(file: &SourceFile) -> bool {
    let size = match (&file.bytes, &file.path) {
        (Some(bytes), _) => bytes.len() as u64,
        (None, Some(path)) => disk::len(path).unwrap_or(0),
        (None, None) => 0,
    };
    size <= AT_ONCE_BYTES
}

/// The file read again; a refusal is one line.
fn read(file: &SourceFile, choices: &Choices) -> Result<Opened, String> {
    let name = &file.name;
    let read = || match (&file.bytes, &file.path) {
        (Some(bytes), _) => load_bytes_as(name, bytes, choices),
        (None, Some(path)) => load_path_as(path, choices),
        (None, None) => Loaded::Refused(tr!("{name}: it cannot be read again", name)),
    };
    match unshaken(name, read) {
        Loaded::File(opened) if opened.spectra.is_empty() && opened.images.is_empty() => {
            Err(tr!("{name}: found no spectrum", name))
        }
        Loaded::File(mut opened) => {
            if file.images_only {
                opened.spectra.clear();
                opened.guesses.clear();
            }
            Ok(*opened)
        }
        Loaded::Refused(why) => Err(why),
        Loaded::Project { .. } => Err(tr!("{name}: it is a project now", name)),
    }
}

/// The beginning of a file's text; nothing for a binary file.
pub(super) fn head(file: &SourceFile) -> String {
    let mut bytes = match (&file.bytes, &file.path) {
        (Some(all), _) => all[..all.len().min(HEAD_BYTES)].to_vec(),
        (None, Some(path)) => disk::head(path, HEAD_BYTES as u64),
        (None, None) => Vec::new(),
    };
    if is_binary(&bytes) {
        return String::new();
    }
    if bytes.len() == HEAD_BYTES {
        // A letter cut in two would make the whole look like another encoding.
        let wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
        let end = bytes.iter().rposition(|b| *b == b'\n').unwrap_or(0);
        bytes.truncate(if wide { end & !1 } else { end });
    }
    decode_text(&bytes).text.into_owned()
}

/// Reads one file again and again.
pub(super) struct FileReader {
    file: Arc<SourceFile>,
    small: bool,
    turn: u64,
    /// What is being read, or was and is not taken yet.
    pub(super) asked: Option<Choices>,
    answer: Option<Result<Opened, String>>,
    job: Job<u64, Result<Opened, String>>,
}

impl FileReader {
    pub(super) fn new(file: Arc<SourceFile>) -> Self {
        Self {
            small: is_small(&file),
            file,
            turn: 0,
            asked: None,
            answer: None,
            job: Job::default(),
        }
    }

    pub(super) fn ask(&mut self, choices: Choices, wake: &Wake) {
        if self.asked.is_some() {
            return;
        }
        self.asked = Some(choices.clone());
        if self.small {
            self.answer = Some(read(&self.file, &choices));
            return;
        }
        self.turn += 1;
        let file = self.file.clone();
        self.job
            .ask(&self.turn, wake, || move |_| Some(read(&file, &choices)));
    }

    /// What was read, once.
    pub(super) fn take(&mut self) -> Option<Result<Opened, String>> {
        self.asked.as_ref()?;
        if self.answer.is_none() && !self.small {
            self.job.take_in();
            self.answer = match self.job.stage() {
                Stage::Running(_) => None,
                _ => self
                    .job
                    .result_for(&self.turn)
                    .map(|read| Result::clone(read))
                    .or_else(|| Some(Err(tr!("{file}: not read", file = self.file.name)))),
            };
        }
        let answer = self.answer.take()?;
        self.asked = None;
        Some(answer)
    }
}
