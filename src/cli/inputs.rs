//! What a command reads, and what it has to say beside its result.

use std::{
    collections::HashMap,
    ffi::{OsStr, OsString},
    fs::File,
    io::{Read, Write},
    path::Path,
    sync::Arc,
};

use super::{
    factor::split_at_sign,
    options::{FileOptions, ModelOptions},
    refusal::Refusal,
    remark,
};
use crate::{
    app::{
        Library,
        open::{
            self, Found, Loaded, Wanted, few_numbers,
            named::{self, Several},
        },
    },
    io::{
        self, Choices, ReadError, Reading, name_of, shown,
        stream::{self, ITS_NAME, is_standard_input, is_stream},
        why_unopened,
    },
};

/// The files of one command. A stream is read once, however often it is asked for.
pub(super) struct Inputs<'e> {
    err: &'e mut dyn Write,
    streams: HashMap<OsString, Arc<[u8]>>,
    notes: Vec<String>,
    /// What the command line says of every file's table.
    files: FileOptions,
    /// Whether a file was read that could be a table.
    has_read: bool,
}

impl<'e> Inputs<'e> {
    /// Nothing read yet; `err` takes what is said beside the result.
    pub(super) fn new(err: &'e mut dyn Write) -> Self {
        Self {
            err,
            streams: HashMap::new(),
            notes: Vec::new(),
            files: FileOptions::default(),
            has_read: false,
        }
    }

    /// Reads all files as the command line says.
    pub(super) fn read_as(&mut self, files: FileOptions) {
        self.files = files;
    }

    /// Says something now.
    pub(super) fn remark(&mut self, text: &str) {
        remark(self.err, text);
    }

    /// Says something about the result, if it comes to one: a refusal is one line.
    pub(super) fn note(&mut self, text: impl Into<String>) {
        self.notes.push(text.into());
    }

    /// Says that `--sampling` was given where it turns out that no product is formed.
    pub(super) fn note_sampling(&mut self, model: ModelOptions) {
        if model.sampling.is_some() {
            self.note("--sampling is not used: nothing is multiplied here");
        }
    }

    /// Says that lines stand at their centres where `--wide-lines` was given.
    pub(super) fn note_centres(&mut self, model: ModelOptions) {
        if model.wide_lines {
            self.note("--wide-lines: here each line stands at its centre, without its width");
        }
    }

    /// Says what is to be known of the result.
    pub(super) fn tell_notes(&mut self) {
        let of_tables = std::mem::take(&mut self.files).given();
        for option in of_tables.filter(|_| !self.has_read) {
            self.notes
                .push(format!("{option} is not used: no table is read"));
        }
        for note in std::mem::take(&mut self.notes) {
            self.remark(&note);
        }
    }

    /// Says why some inputs were refused: the last of them is the command's own refusal.
    ///
    /// # Errors
    /// [`Refusal::File`] where there is one.
    pub(super) fn tell_refused(&mut self, mut refused: Vec<String>) -> Result<(), Refusal> {
        let Some(last) = refused.pop() else {
            return Ok(());
        };
        for line in refused {
            self.remark(&line);
        }
        Err(Refusal::File(last))
    }

    /// What a word means, which may name one of a file's spectra: `lamps.csv#2`. Where a file has
    /// several and none is named, a line tells that the first was taken.
    ///
    /// # Errors
    /// One line that says what was found and what was expected.
    pub(super) fn find(&mut self, word: &OsStr, wanted: &Wanted) -> Result<Found, String> {
        let (name, named) = match wanted.spectrum {
            Some(_) => (word, None),
            None => named_spectrum(word),
        };
        let wanted = &Wanted {
            spectrum: wanted.spectrum.or(named),
            ..wanted.clone()
        };
        let found = named::find(name, wanted, |path, choices| self.load(path, choices))?;
        let is_first = found.among > 1 && wanted.spectrum.is_none();
        if is_first && wanted.several == Several::First {
            let file = shown(Path::new(name));
            let line = format!(
                "{file}: found {} spectra and none of them named, took the first, {} ({file}#2 is \
                 the second)",
                found.among,
                found.entry.name()
            );
            if !self.notes.contains(&line) {
                self.note(line);
            }
        }
        Ok(found)
    }

    /// A project, or any other file with decisions about it.
    pub(super) fn load(&mut self, path: &Path, choices: &Choices) -> Loaded {
        let choices = &self.choices(choices);
        match self.stream(path) {
            None => open::load_named(path, choices),
            Some(Ok(bytes)) => open::load_bytes_with(&name_at(path), &bytes, choices),
            Some(Err(why)) => Loaded::Refused(why.to_string()),
        }
    }

    /// The project that a file is, if it is one.
    pub(super) fn project(&mut self, path: &Path) -> Option<Loaded> {
        match self.stream(path) {
            None => open::project_at(path),
            Some(Ok(bytes)) => open::project_in(&name_at(path), &bytes),
            Some(Err(why)) => Some(Loaded::Refused(why.to_string())),
        }
    }

    /// What a file holds.
    ///
    /// # Errors
    /// [`ReadError`] with the file's path.
    pub(super) fn reading(&mut self, path: &Path, choices: &Choices) -> Result<Reading, ReadError> {
        let choices = &self.choices(choices);
        let reading = match self.stream(path) {
            None => {
                few_numbers::reading_at(path).unwrap_or_else(|| io::read_path_as(path, choices))
            }
            Some(bytes) => {
                let (name, bytes) = (name_at(path), bytes?);
                few_numbers::reading_in(&name, &bytes)
                    .unwrap_or_else(|| io::read_bytes_as(&name, &bytes, choices))
            }
        };
        reading.map_err(|why| why.at(path))
    }

    /// Decisions about a file that is read now, with those of the command line.
    pub(super) fn choices(&mut self, choices: &Choices) -> Choices {
        self.has_read = true;
        choices.or_table_of(&self.files.choices())
    }

    /// The text in a short file or stream.
    ///
    /// # Errors
    /// One line that says what was found and what was expected.
    pub(super) fn text(&mut self, path: &Path) -> Result<String, String> {
        let named = shown(path);
        let bytes = match self.stream(path) {
            Some(bytes) => bytes.map_err(|why| why.to_string())?.to_vec(),
            None => short_file(path).map_err(|error| {
                let (found, expected) = why_unopened(path, &error);
                format!("{named}: found {found}, expected {expected}")
            })?,
        };
        if bytes.len() > MOST_TEXT_BYTES {
            return Err(format!(
                "{named}: found more than {MOST_TEXT_BYTES} bytes, expected a short text"
            ));
        }
        if io::is_binary(&bytes) {
            return Err(format!("{named}: found no text, expected one"));
        }
        Ok(io::decode_text(&bytes).text.into_owned())
    }

    /// All of a stream; `None` for what can be read again.
    fn stream(&mut self, path: &Path) -> Option<Result<Arc<[u8]>, ReadError>> {
        if let Some(bytes) = self.streams.get(path.as_os_str()) {
            return Some(Ok(bytes.clone()));
        }
        if !is_stream(path) {
            return None;
        }
        let name = name_at(path);
        let waits = || {
            let line = format!(
                "{}: waiting for something to write into this pipe",
                shown(path)
            );
            remark(self.err, &line);
        };
        let bytes: Arc<[u8]> = match stream::drained(path, waits) {
            Ok(bytes) => bytes.into(),
            Err(error) => {
                let (found, expected) = why_unopened(path, &error);
                return Some(Err(ReadError::new(&name, found, expected)));
            }
        };
        self.streams.insert(path.into(), bytes.clone());
        Some(Ok(bytes))
    }
}

/// A file and which of its spectra (`lamps.csv#2`); a name that is there is taken as it stands.
pub(super) fn named_spectrum(word: &OsStr) -> (&OsStr, Option<&str>) {
    let is_shipped = || {
        word.to_str()
            .is_some_and(|name| Library::bundled().knows(name))
    };
    if Path::new(word).exists() || is_shipped() {
        return (word, None);
    }
    match split_at_sign(word, "#") {
        Some((name, _, spectrum)) => (name, Some(spectrum)),
        None => (word, None),
    }
}

/// Most bytes of a short text.
const MOST_TEXT_BYTES: usize = 1 << 20;

/// The bytes of a file, one more than a short text may have at most.
fn short_file(path: &Path) -> std::io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let most = MOST_TEXT_BYTES as u64 + 1;
    File::open(path)?.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// What messages and spectra call a file or a stream.
fn name_at(path: &Path) -> String {
    if is_standard_input(path) {
        ITS_NAME.to_owned()
    } else {
        name_of(path)
    }
}
