//! Where the document's own spectra and images came from, to read their files again.

use std::{
    path::PathBuf,
    sync::{Arc, Weak},
};

use super::Import;
use crate::{
    app::{
        document::{Document, Subject},
        entry::Entry,
        open::{Loaded, load_bytes_as, load_path_as},
        opened::{ImageEntry, Opened},
        state::App,
        studies::{Job, Stage, Wake},
    },
    io::{Choices, text},
};

/// Files up to this size are read again at once, larger ones on a thread of their own; bytes.
const AT_ONCE_BYTES: u64 = 4 * 1024 * 1024;

/// Bytes of a file that its first rows are looked for in.
const HEAD_BYTES: usize = 256 * 1024;

/// What was on screen before a file was opened.
#[derive(Clone, Debug)]
pub struct Before {
    pub(super) light: Arc<Entry>,
    pub(super) factor: Option<Arc<Entry>>,
    pub(super) subject: Subject,
    own: usize,
    images: usize,
}

impl Before {
    /// What is on screen now.
    pub fn of(app: &App) -> Self {
        let document = app.document();
        Self {
            light: document.light.clone(),
            factor: document.factor.clone(),
            subject: document.subject,
            own: document.own.len(),
            images: document.images.len(),
        }
    }

    /// Keys of the entries that joined since.
    pub fn joined(&self, app: &App) -> Vec<String> {
        let own = app.document().own.iter().skip(self.own);
        own.map(|entry| entry.key.clone()).collect()
    }

    /// What of a file joined since.
    pub(super) fn brought(&self, app: &App) -> Held {
        let images = app.document().images.iter().skip(self.images);
        Held {
            keys: self.joined(app),
            images: images.map(|image| image.key.clone()).collect(),
        }
    }
}

/// What the document holds of a file: keys of spectra and of images.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Held {
    pub keys: Vec<String>,
    pub images: Vec<String>,
}

impl Held {
    pub(super) fn is_empty(&self) -> bool {
        self.keys.is_empty() && self.images.is_empty()
    }

    fn has(&self, key: &str) -> bool {
        self.keys.iter().chain(&self.images).any(|k| k == key)
    }

    /// Whether they are of the same file.
    fn meets(&self, other: &Self) -> bool {
        let first = |keys: &[String], others: &[String]| {
            keys.first().is_some_and(|key| others.first() == Some(key))
        };
        first(&self.keys, &other.keys) || first(&self.images, &other.images)
    }

    /// The first spectrum or image, as the document has it: other places hold copies.
    pub(super) fn first(&self, document: &Document) -> First {
        let own = || {
            let key = self.keys.first()?;
            document.own.iter().find(|e| e.key == *key)
        };
        let image = || {
            let key = self.images.first()?;
            document.images.iter().find(|i| i.key == *key)
        };
        match (own(), image()) {
            (Some(entry), _) => First::Spectrum(Arc::downgrade(entry)),
            (None, Some(image)) => First::Image(Arc::downgrade(image)),
            (None, None) => First::None,
        }
    }
}

/// What tells one reading of a file from another: the very thing that the document holds of it.
#[derive(Clone, Debug)]
pub(super) enum First {
    None,
    Spectrum(Weak<Entry>),
    Image(Weak<ImageEntry>),
}

impl PartialEq for First {
    fn eq(&self, other: &Self) -> bool {
        match (self, other) {
            (Self::Spectrum(a), Self::Spectrum(b)) => a.ptr_eq(b),
            (Self::Image(a), Self::Image(b)) => a.ptr_eq(b),
            _ => false,
        }
    }
}

/// A file that was opened, to be read again.
#[derive(Clone, Debug)]
pub struct Source {
    path: Option<PathBuf>,
    bytes: Option<Arc<[u8]>>,
    file: String,
    /// Its spectra are of no interest: they are the user's own numbers since long.
    images_only: bool,
}

impl Source {
    /// Where a file that was opened came from.
    pub fn of(opened: &Opened) -> Self {
        Self {
            path: opened.path.clone(),
            bytes: opened.bytes.clone(),
            file: opened.file.clone(),
            images_only: false,
        }
    }

    /// The file of an image that was read again from a workspace.
    fn of_image(image: &ImageEntry) -> Self {
        Self {
            path: image.path.clone(),
            bytes: None,
            file: image.image.source.clone(),
            images_only: true,
        }
    }

    fn is_small(&self) -> bool {
        let size = match (&self.bytes, &self.path) {
            (Some(bytes), _) => bytes.len() as u64,
            (None, Some(path)) => std::fs::metadata(path).map_or(0, |about| about.len()),
            (None, None) => 0,
        };
        size <= AT_ONCE_BYTES
    }

    /// The file read again; a refusal is one line.
    fn read(&self, choices: &Choices) -> Result<Opened, String> {
        let read = || match (&self.bytes, &self.path) {
            (Some(bytes), _) => load_bytes_as(&self.file, bytes, choices),
            (None, Some(path)) => load_path_as(path, choices),
            (None, None) => Loaded::Refused(format!("{}: it cannot be read again", self.file)),
        };
        // A panic in a reader must not take the window along.
        let loaded = std::panic::catch_unwind(std::panic::AssertUnwindSafe(read));
        match loaded {
            Ok(Loaded::File(opened)) if opened.spectra.is_empty() && opened.images.is_empty() => {
                Err(format!("{}: found no spectrum", self.file))
            }
            Ok(Loaded::File(mut opened)) => {
                if self.images_only {
                    opened.spectra.clear();
                    opened.guesses.clear();
                }
                Ok(*opened)
            }
            Ok(Loaded::Refused(why)) => Err(why),
            Ok(Loaded::Project { .. }) => Err(format!("{}: it is a project now", self.file)),
            Err(_) => Err(format!("{}: the reader failed on this file", self.file)),
        }
    }

    /// The beginning of the file's text; nothing for a binary file.
    pub(super) fn head(&self) -> String {
        use std::io::Read;
        let mut bytes = Vec::new();
        match (&self.bytes, &self.path) {
            (Some(all), _) => bytes.extend(&all[..all.len().min(HEAD_BYTES)]),
            (None, Some(path)) => {
                let read = std::fs::File::open(path)
                    .and_then(|file| file.take(HEAD_BYTES as u64).read_to_end(&mut bytes));
                if read.is_err() {
                    return String::new();
                }
            }
            (None, None) => {}
        }
        if text::is_binary(&bytes) {
            return String::new();
        }
        if bytes.len() == HEAD_BYTES {
            // A letter cut in two would make the whole look like another encoding.
            let wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
            let end = bytes.iter().rposition(|b| *b == b'\n').unwrap_or(0);
            bytes.truncate(if wide { end & !1 } else { end });
        }
        text::decode(&bytes).text.into_owned()
    }
}

/// One reading of a file that the document has or had.
#[derive(Clone, Debug)]
struct Mark {
    held: Held,
    first: First,
    choices: Choices,
}

impl Mark {
    fn of(app: &App, held: Held, choices: Choices) -> Self {
        Self {
            first: held.first(app.document()),
            held,
            choices,
        }
    }
}

/// Where own entries came from, in this session: newest last.
#[derive(Clone, Debug, Default)]
pub struct Origins {
    all: Vec<Origin>,
}

#[derive(Clone, Debug)]
struct Origin {
    source: Source,
    before: Before,
    marks: Vec<Mark>,
}

impl Origins {
    /// Remembers a file whose spectra the document has.
    pub fn remember(&mut self, app: &App, source: Source, choices: Choices, before: Before) {
        let held = before.brought(app);
        if !held.is_empty() {
            self.all.push(Origin {
                marks: vec![Mark::of(app, held, choices)],
                source,
                before,
            });
        }
    }

    /// Remembers files that came in together: each with how many spectra and images it brought, in
    /// the order in which they joined the document.
    pub fn remember_each(
        &mut self,
        app: &App,
        files: Vec<(Source, Choices, [usize; 2])>,
        before: &Before,
    ) {
        let joined = before.brought(app);
        let mut keys = joined.keys.into_iter();
        let mut images = joined.images.into_iter();
        for (source, choices, [spectra, pictures]) in files {
            let held = Held {
                keys: keys.by_ref().take(spectra).collect(),
                images: images.by_ref().take(pictures).collect(),
            };
            if !held.is_empty() {
                self.all.push(Origin {
                    marks: vec![Mark::of(app, held, choices)],
                    source,
                    before: before.clone(),
                });
            }
        }
    }

    /// Remembers another reading of a file.
    pub(super) fn reread(&mut self, app: &App, before: &Held, held: Held, choices: Choices) {
        let found = self.all.iter_mut().rev().find(|origin| {
            let mut marks = origin.marks.iter();
            marks.any(|mark| mark.held.meets(before))
        });
        if let Some(origin) = found {
            origin.marks.push(Mark::of(app, held, choices));
        }
    }

    /// Whether it is known where an own entry came from.
    pub fn knows(&self, key: &str) -> bool {
        self.find(key).is_some()
    }

    fn find(&self, key: &str) -> Option<&Origin> {
        let has = |origin: &&Origin| {
            let mut marks = origin.marks.iter();
            marks.any(|mark| mark.held.has(key))
        };
        self.all.iter().rev().find(has)
    }

    /// Starts to read the file of an own entry again, as it was read for it.
    pub fn again(&self, app: &App, key: &str, wake: &Wake) -> Option<Again> {
        let origin = self.find(key)?;
        let of_now = |mark: &&Mark| mark.held.first(app.document()) == mark.first;
        let with_key = |mark: &&Mark| mark.held.has(key);
        let mark = origin
            .marks
            .iter()
            .rev()
            .find(of_now)
            .or_else(|| origin.marks.iter().rev().find(with_key))?;
        let mut reader = Reader::new(origin.source.clone());
        reader.ask(mark.choices.clone(), wake);
        Some(Again {
            reader,
            held: mark.held.clone(),
            before: origin.before.clone(),
        })
    }

    /// Starts to read the file of an image again, as it was read for it: one that came back from
    /// a workspace is none that was opened in this session.
    pub fn image_again(&mut self, app: &App, key: &str, wake: &Wake) -> Option<Again> {
        if !self.knows(key) {
            let images = &app.document().images;
            let image = images.iter().find(|image| image.key == key)?;
            image.path.as_ref()?;
            let of_file = |other: &&Arc<ImageEntry>| {
                (&other.path, &other.choices) == (&image.path, &image.choices)
            };
            let held = Held {
                keys: Vec::new(),
                images: images
                    .iter()
                    .filter(of_file)
                    .map(|i| i.key.clone())
                    .collect(),
            };
            self.all.push(Origin {
                marks: vec![Mark::of(app, held, image.choices.clone())],
                source: Source::of_image(image),
                before: Before::of(app),
            });
        }
        self.again(app, key, wake)
    }
}

/// Reads one file again and again.
pub(super) struct Reader {
    source: Source,
    small: bool,
    turn: u64,
    /// What is being read, or was and is not taken yet.
    pub(super) asked: Option<Choices>,
    answer: Option<Result<Opened, String>>,
    job: Job<u64, Result<Opened, String>>,
}

impl Reader {
    pub(super) fn new(source: Source) -> Self {
        Self {
            small: source.is_small(),
            source,
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
            self.answer = Some(self.source.read(&choices));
            return;
        }
        self.turn += 1;
        let source = self.source.clone();
        self.job
            .ask(&self.turn, wake, || move |_| Some(source.read(&choices)));
    }

    /// What was read, once.
    pub(super) fn take(&mut self) -> Option<(Choices, Result<Opened, String>)> {
        self.asked.as_ref()?;
        if self.answer.is_none() && !self.small {
            self.job.take_in();
            self.answer = match self.job.stage() {
                Stage::Running(_) => None,
                _ => self
                    .job
                    .result_for(&self.turn)
                    .map(|read| Result::clone(read))
                    .or_else(|| Some(Err(format!("{}: not read", self.source.file)))),
            };
        }
        let answer = self.answer.take()?;
        Some((self.asked.take()?, answer))
    }
}

/// A file that is read again to be looked at.
pub struct Again {
    reader: Reader,
    held: Held,
    before: Before,
}

impl Again {
    /// What came of it: `None` while it is being read.
    ///
    /// # Errors
    /// Why it cannot be read any more, in one line.
    pub fn finished(&mut self, app: &App) -> Option<Result<Import, String>> {
        let (_, read) = self.reader.take()?;
        Some(
            read.map(|opened| Import::holding(app, opened, self.held.clone(), self.before.clone())),
        )
    }
}
