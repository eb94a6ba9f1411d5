//! A file that grows or is written anew.
//!
//! It is looked at by its modification time and length, and read once it rests. Half of a file may
//! rest too, and may be a table: one that is shorter than the last good one, or ends within a line
//! where that did not, is waited for much longer. Lines of objects are taken as they come.

use std::{
    collections::VecDeque,
    fs::{self, File},
    io::{Read, Seek, SeekFrom},
    path::{Path, PathBuf},
    thread,
    time::{Duration, Instant, SystemTime},
};

use memchr::memchr;

use super::{
    Event, Source,
    frame::Frame,
    lines::{Broken, Lines, MOST_LINE_BYTES},
};
use crate::io::{
    Choices, Input, MOST_BYTES, exposure_ms, is_binary, name_of, part_of_message, read,
    why_unopened,
};
use crate::spectrum::{NamedSpectrum, Sampled};

/// Between two looks.
const EVERY: Duration = Duration::from_millis(100);

/// How long a file must have been left alone, s.
const REST: f64 = 0.1;

/// The same for the first reading, of which nobody knows how long the whole is, and for a text that
/// never ends its last line.
const FIRST_REST: f64 = 1.0;
const UNENDED_REST: f64 = 0.3;

/// The same for what looks like half of the file before, s.
const HALF_REST: f64 = 10.0;

/// Bytes in front of what is new in a growing file: they must be as they were.
const TAIL: usize = 4096;

/// Modification time and length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Mark {
    modified: Option<SystemTime>,
    length: u64,
}

impl Mark {
    fn of(path: &Path) -> std::io::Result<Self> {
        let about = fs::metadata(path)?;
        Ok(Self {
            modified: about.modified().ok(),
            length: about.len(),
        })
    }

    /// How long ago it was modified, s.
    fn age(self) -> f64 {
        let age = self.modified.and_then(|at| at.elapsed().ok());
        age.map_or(0.0, |age| age.as_secs_f64())
    }
}

/// The shape of the last good reading.
#[derive(Clone, Debug)]
pub(super) struct Good {
    last: Sampled,
    spectra: usize,
    /// True if its text ends with a line end, or is no text.
    is_ended: bool,
}

/// How far lines of objects were read.
#[derive(Debug)]
struct ReadTo {
    at: u64,
    mark: Mark,
    tail: Vec<u8>,
}

/// A file that is read again whenever it changed.
pub struct FileSource {
    path: PathBuf,
    name: String,
    choices: Choices,
    mark: Option<Mark>,
    /// When it got that mark, s since the source was opened.
    since: f64,
    /// The mark of what was read last, readable or not.
    done: Option<Mark>,
    pub(super) good: Option<Good>,
    lines: Lines,
    read_to: Option<ReadTo>,
    waiting: VecDeque<Event>,
    said: String,
    opened: Instant,
}

impl FileSource {
    /// A file, read with the decisions of a person.
    pub fn new(path: &Path, choices: &Choices) -> Self {
        let name = name_of(path);
        let stem = path
            .file_stem()
            .map_or(name.clone(), |stem| stem.to_string_lossy().into_owned());
        Self {
            path: path.to_owned(),
            lines: Lines::new(&stem),
            name,
            choices: choices.clone(),
            mark: None,
            since: 0.0,
            done: None,
            good: None,
            read_to: None,
            waiting: VecDeque::new(),
            said: String::new(),
            opened: Instant::now(),
        }
    }

    /// The same for lines that tell no wavelengths.
    #[must_use]
    pub fn with_lines(self, lines: Lines) -> Self {
        Self { lines, ..self }
    }

    /// One of a folder: its whole shape is that of the file before.
    pub(super) fn after(self, good: Option<Good>) -> Self {
        Self { good, ..self }
    }

    /// Leaves alone what the file holds now.
    pub(super) fn skip_present(&mut self) {
        self.mark = Mark::of(&self.path).ok();
        self.done = self.mark;
    }

    /// True if what the file holds was read, readable or not.
    pub(super) fn is_done(&self) -> bool {
        self.done.is_some() && self.done == self.mark
    }

    pub(super) fn pop(&mut self) -> Option<Event> {
        self.waiting.pop_front()
    }

    /// Looks at the file, `now` s after the source was opened.
    pub(super) fn look(&mut self, now: f64) {
        let mark = match Mark::of(&self.path) {
            Ok(mark) => mark,
            Err(error) => {
                let found = why_unopened(&self.path, &error).0;
                return self.wait(&found);
            }
        };
        if self.mark != Some(mark) {
            // What was written long ago rests since then.
            let age = if self.mark.is_none() { mark.age() } else { 0.0 };
            self.mark = Some(mark);
            self.since = now - age;
        }
        let rested = now - self.since;
        let moves = rested < REST && self.read_to.is_none() && !self.begins_with_lines();
        if self.done == Some(mark) || moves {
            return;
        }
        match self.read(mark, rested, now) {
            Ok(true) => self.done = Some(mark),
            Ok(false) => {}
            // A file that another program keeps to itself is tried again.
            Err(error) => {
                let found = why_unopened(&self.path, &error).0;
                self.wait(&found);
            }
        }
    }

    /// True if a file that does not rest yet begins with a line that makes a frame.
    fn begins_with_lines(&self) -> bool {
        let mut bytes = Vec::new();
        let file = File::open(&self.path);
        let read = file.and_then(|file| file.take(MOST_LINE_BYTES as u64).read_to_end(&mut bytes));
        let end = memchr(b'\n', &bytes);
        read.is_ok() && end.is_some_and(|end| self.lines.understands(&bytes[..end]))
    }

    /// Reads the file; false where it is to be looked at again though it does not change.
    fn read(&mut self, mark: Mark, rested: f64, now: f64) -> std::io::Result<bool> {
        if self.read_more(mark, now)? {
            return Ok(self.take_object(rested, now));
        }
        self.read_to = None;
        let mut bytes = Vec::new();
        File::open(&self.path)?
            .take(MOST_BYTES + 1)
            .read_to_end(&mut bytes)?;
        let first = bytes.trim_ascii_start().split(|byte| *byte == b'\n').next();
        if first.is_some_and(|line| self.lines.understands(line)) {
            // What joined it meanwhile comes with the next mark.
            bytes.truncate(usize::try_from(mark.length).unwrap_or(usize::MAX));
            self.lines.restart();
            self.take_lines(&bytes, mark, now);
            return Ok(self.take_object(rested, now));
        }
        if rested < REST || Mark::of(&self.path)? != mark {
            return Ok(false);
        }
        Ok(self.take_file(&bytes, rested, now))
    }

    /// Reads the lines that a growing file has now and had not before; false where it is none.
    fn read_more(&mut self, mark: Mark, now: f64) -> std::io::Result<bool> {
        let Some(ReadTo {
            at,
            mark: own,
            tail,
        }) = &self.read_to
        else {
            return Ok(false);
        };
        if mark.length < *at || *own == mark {
            return Ok(*own == mark);
        }
        // A file that is as long as it was may have been written anew, or only touched.
        let start = at - tail.len() as u64;
        let mut file = File::open(&self.path)?;
        file.seek(SeekFrom::Start(start))?;
        let mut bytes = Vec::new();
        let most = MOST_BYTES.min(mark.length - start);
        file.take(most).read_to_end(&mut bytes)?;
        if !bytes.starts_with(tail) {
            return Ok(false);
        }
        let new = bytes.split_off(tail.len());
        self.take_lines(&new, mark, now);
        Ok(true)
    }

    fn take_lines(&mut self, bytes: &[u8], mark: Mark, now: f64) {
        let mut frames = Vec::new();
        self.lines
            .feed(bytes, 1e3 * now, |frame| frames.push(frame));
        frames.into_iter().for_each(|frame| self.take_frame(frame));
        let read_to = self.read_to.take();
        let (at, mut tail) = read_to.map_or((0, Vec::new()), |read| (read.at, read.tail));
        tail.extend_from_slice(&bytes[bytes.len().saturating_sub(TAIL)..]);
        tail.drain(..tail.len().saturating_sub(TAIL));
        let at = at + bytes.len() as u64;
        self.read_to = Some(ReadTo { at, mark, tail });
        self.said.clear();
    }

    /// The object behind the last line end, once it rests; false while half a line waits.
    fn take_object(&mut self, rested: f64, now: f64) -> bool {
        if !self.lines.is_waiting() {
            return true;
        }
        if rested < REST {
            return false;
        }
        match self.lines.whole_object(1e3 * now) {
            Some(frame) => self.take_frame(frame),
            None if !self.lines.is_waiting() => {}
            None => self.wait(said!("the last line is half written")),
        }
        true
    }

    /// Takes the frame of a line.
    fn take_frame(&mut self, frame: Frame) {
        self.good = Some(Good {
            last: frame.samples.clone(),
            spectra: 1,
            is_ended: true,
        });
        self.waiting.push_back(Event::Frame(Box::new(frame)));
    }

    /// Takes a file of any format; false while it looks like half of one.
    fn take_file(&mut self, bytes: &[u8], rested: f64, now: f64) -> bool {
        let reading = match read(&Input::at(&self.path, bytes).deciding(&self.choices)) {
            Ok(reading) => reading,
            Err(why) => {
                self.wait(&tr!("found {found}", found = why.found));
                return true;
            }
        };
        let spectra = reading.spectra;
        let Some(last) = spectra.last() else {
            self.wait(said!("it holds no spectrum"));
            return true;
        };
        let is_ended = is_ended(bytes);
        let good = Good {
            last: last.samples.clone(),
            spectra: spectra.len(),
            is_ended,
        };
        let is_half = |before: &Good| is_half(&good, before);
        let wanted = match &self.good {
            None => FIRST_REST,
            Some(before) if is_half(before) => {
                self.wait(said!("it looks half written"));
                HALF_REST
            }
            Some(_) if !is_ended => UNENDED_REST,
            Some(_) => REST,
        };
        if rested < wanted {
            return false;
        }
        let integration_ms = std::str::from_utf8(bytes).ok().and_then(exposure_ms);
        let from = self.first_new(&spectra);
        for spectrum in spectra.into_iter().skip(from) {
            let frame = Frame {
                time_ms: 1e3 * now,
                name: spectrum.name,
                kind: spectrum.kind,
                samples: spectrum.samples,
                integration_ms,
                unit: spectrum.unit,
                instrument: String::new(),
            };
            self.waiting.push_back(Event::Frame(Box::new(frame)));
        }
        self.good = Some(good);
        self.said.clear();
        true
    }

    /// The first spectrum that is new: of a table that got more rows the first of those, else the
    /// last of the file.
    fn first_new(&self, spectra: &[NamedSpectrum]) -> usize {
        let last = spectra.len() - 1;
        let grown = self
            .good
            .as_ref()
            .filter(|good| good.spectra <= last && spectra[good.spectra - 1].samples == good.last);
        grown.map_or(last, |good| good.spectra)
    }

    /// Says once why the last spectrum stays.
    fn wait(&mut self, why: &str) {
        if self.said != why {
            why.clone_into(&mut self.said);
            let (name, why) = (&self.name, part_of_message(why));
            let words = match self.good.is_some() || self.read_to.is_some() {
                true => tr!(
                    "{name}: waiting ({why}); the last spectrum stays.",
                    name,
                    why
                ),
                false => tr!("{name}: waiting ({why}).", name, why),
            };
            self.waiting.push_back(Event::Said(words));
        }
    }
}

/// True if a text ends with a line end or a bracket that closes it; what is no text has an end of its
/// own.
fn is_ended(bytes: &[u8]) -> bool {
    let is_closed = matches!(bytes.trim_ascii_end().last(), Some(b'}' | b']' | b'>'));
    is_closed || matches!(bytes.last(), Some(b'\n' | b'\r')) || is_binary(bytes)
}

/// True if a reading looks like half of the one before: fewer spectra or points, or an end within a
/// line.
fn is_half(found: &Good, before: &Good) -> bool {
    found.last.len() < before.last.len()
        || found.spectra < before.spectra
        || !found.is_ended && before.is_ended
}

impl Source for FileSource {
    fn name(&self) -> &str {
        &self.name
    }

    fn next(&mut self, patience: Duration) -> Option<Event> {
        let until = Instant::now() + patience;
        loop {
            if let Some(event) = self.pop() {
                return Some(event);
            }
            self.look(self.opened.elapsed().as_secs_f64());
            if let Some(event) = self.pop() {
                return Some(event);
            }
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return None;
            }
            thread::sleep(left.min(EVERY));
        }
    }

    fn broken(&self) -> &Broken {
        &self.lines.broken
    }
}

#[cfg(test)]
#[path = "../../tests/core/live/file.rs"]
mod tests;
