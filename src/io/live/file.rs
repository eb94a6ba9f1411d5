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
    Choices, Input, error::part_of_message, input::name_of, read, text::MOST_BYTES,
    text::exposure::exposure_ms, text::is_binary, unopened,
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
    good: Option<Good>,
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

    pub(super) fn good(&self) -> Option<&Good> {
        self.good.as_ref()
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
                let found = unopened::words(&self.path, &error).0;
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
                let found = unopened::words(&self.path, &error).0;
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
            None => self.wait("the last line is half written"),
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
                self.wait(&format!("found {}", why.found));
                return true;
            }
        };
        let spectra = reading.spectra;
        let Some(last) = spectra.last() else {
            self.wait("it holds no spectrum");
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
                self.wait("it looks half written");
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
            let stays = match self.good.is_some() || self.read_to.is_some() {
                true => "; the last spectrum stays",
                false => "",
            };
            let (name, why) = (&self.name, part_of_message(why));
            let words = format!("{name}: waiting ({why}){stays}.");
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
mod tests {
    use super::*;

    const POINTS: usize = 81;

    fn values(version: u64) -> Vec<f64> {
        let value = |i: usize| 0.5 + ((i as u64 * 7 + version * 13) % 101) as f64 / 128.0;
        (0..POINTS).map(value).collect()
    }

    fn csv(version: u64) -> String {
        let rows = values(version).into_iter().enumerate();
        let rows = rows.map(|(i, value)| format!("{},{value}\n", 380 + 5 * i));
        "nm,relative\n".to_owned() + &rows.collect::<String>()
    }

    fn object(version: u64) -> String {
        let nm: Vec<usize> = (0..POINTS).map(|i| 380 + 5 * i).collect();
        format!(
            "{{\"wavelength_nm\":{nm:?},\"values\":{:?}}}",
            values(version)
        )
    }

    /// Writes as if it were so many ms after the beginning.
    fn put(path: &Path, text: &str, at_ms: u64) {
        fs::write(path, text).expect("written");
        let file = File::options().write(true).open(path).expect("there");
        let time = SystemTime::UNIX_EPOCH + Duration::from_millis(at_ms);
        file.set_modified(time).expect("set");
    }

    fn frames(source: &mut FileSource) -> Vec<Vec<f64>> {
        let mut found = Vec::new();
        while let Some(event) = source.pop() {
            if let Event::Frame(frame) = event {
                found.push(frame.samples.values().to_vec());
            }
        }
        found
    }

    /// Whole numbers below a bound, from a linear congruence.
    fn numbers() -> impl FnMut(u64) -> u64 {
        let mut state = 1_u64;
        move |below| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % below
        }
    }

    /// Rewrites a file at random moments, empty, half or whole, and looks at it every 100 ms.
    fn rewritten(name: &str, text: fn(u64) -> String) {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join(name);
        let mut source = FileSource::new(&path, &Choices::default());
        let mut random = numbers();
        put(&path, &text(0), 0);
        let (mut now_ms, mut shown) = (0, Vec::new());
        for version in 1..=1000_u64 {
            let until_ms = now_ms + random(1500);
            while now_ms < until_ms {
                source.look(1e-3 * now_ms as f64);
                shown.extend(
                    frames(&mut source)
                        .into_iter()
                        .map(|found| (version, found)),
                );
                now_ms += 100;
            }
            let whole = text(version);
            let written = match random(4) {
                0 => "",
                1 => &whole[..random(whole.len() as u64) as usize],
                _ => &whole,
            };
            put(&path, written, now_ms);
        }
        put(&path, &text(1001), now_ms);
        for step in 1..=3 {
            source.look(1e-3 * (now_ms + 100 * step) as f64);
        }
        let last = frames(&mut source).pop();
        assert_eq!(last, Some(values(1001)), "{name}");
        // Half of them are whole, and most of these rest for long enough.
        assert!(shown.len() > 300, "{name}: {}", shown.len());
        for (version, found) in shown {
            // The last whole one: it was written in one of the steps before.
            assert!(
                (0..version).rev().take(20).any(|v| values(v) == found),
                "{name} {version}"
            );
        }
        assert_eq!(source.broken().count, 0, "{name}");
    }

    #[test]
    fn a_file_that_is_rewritten_a_thousand_times_never_shows_a_wrong_spectrum() {
        rewritten("meter.csv", csv);
    }

    #[test]
    fn neither_does_one_of_objects_in_a_line() {
        rewritten("meter.json", object);
    }

    #[test]
    fn a_file_that_grows_tells_each_line_once_and_in_its_order() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("log.jsonl");
        let lines: Vec<String> = (0..40).map(|version| object(version) + "\n").collect();
        let text = lines.concat();
        let mut source = FileSource::new(&path, &Choices::default());
        let (mut random, mut at, mut shown) = (numbers(), 0, Vec::new());
        let mut step = 0;
        while at < text.len() {
            at = (at + random(3000) as usize).min(text.len());
            put(&path, &text[..at], 100 * step);
            source.look(0.1 * step as f64);
            source.look(0.1 * step as f64 + 0.15);
            shown.extend(frames(&mut source));
            step += 2;
        }
        source.look(0.1 * step as f64 + 1.0);
        shown.extend(frames(&mut source));
        let all: Vec<Vec<f64>> = (0..40).map(values).collect();
        assert_eq!(shown, all);
        assert_eq!(source.broken().count, 0);
    }

    #[test]
    fn rows_that_join_a_table_are_frames_and_the_choices_stay() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("wide.csv");
        let row = |cells: &[f64]| {
            let cells: Vec<String> = cells.iter().map(f64::to_string).collect();
            cells.join(";") + "\n"
        };
        let columns = |versions: std::ops::Range<u64>| {
            let all: Vec<Vec<f64>> = versions.clone().map(values).collect();
            let head: Vec<String> = versions.map(|v| format!("scan {v}")).collect();
            let rows = (0..POINTS).map(|i| {
                let own = all.iter().map(|values| values[i]);
                let cells: Vec<f64> = std::iter::once((380 + 5 * i) as f64).chain(own).collect();
                row(&cells)
            });
            format!("nm;{}\n{}", head.join(";"), rows.collect::<String>())
        };
        let mut source = FileSource::new(&path, &Choices::default());
        put(&path, &columns(0..2), 0);
        source.look(0.0);
        assert_eq!(frames(&mut source), [values(1)]);
        put(&path, &columns(0..4), 1000);
        source.look(1.0);
        source.look(1.2);
        assert_eq!(frames(&mut source), [values(2), values(3)]);
        // Nothing more is said of a file that rests.
        source.look(9.0);
        assert_eq!(source.pop(), None);
        // The wavelengths counted in another unit, as a person has decided, at each reading.
        let choices = Choices {
            wavelengths: Some(crate::io::WavelengthUnit::PerCentimetre),
            ..Choices::default()
        };
        let mut source = FileSource::new(&path, &choices);
        for step in 0..2 {
            put(&path, &columns(0..1), 1000 * step);
            source.look(step as f64);
            source.look(step as f64 + 0.2);
            let Some(Event::Frame(frame)) = source.pop() else {
                panic!("no frame");
            };
            assert!((frame.samples.last_nm() / (1e7 / 380.0) - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_file_that_goes_away_is_told_once_and_its_spectrum_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("meter.csv");
        let mut source = FileSource::new(&path, &Choices::default());
        put(&path, &csv(1), 0);
        source.look(0.0);
        assert_eq!(frames(&mut source), [values(1)]);
        fs::remove_file(&path).expect("gone");
        source.look(0.1);
        source.look(0.2);
        let Some(Event::Said(words)) = source.pop() else {
            panic!("nothing said");
        };
        assert!(
            words.contains("waiting") && words.contains("stays"),
            "{words}"
        );
        assert_eq!(source.pop(), None);
    }
}
