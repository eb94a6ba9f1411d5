//! A folder that an instrument writes into: the newest file that can be read is shown.

use std::{
    collections::{BTreeMap, BTreeSet, VecDeque},
    fs, io,
    path::{Path, PathBuf},
    thread,
    time::{Duration, Instant, SystemTime},
};

use super::{
    Event, Source,
    file::{FileSource, Good},
    frame::Frame,
    lines::{Broken, Lines},
};
use crate::io::{Choices, name_of};

/// Between two looks.
const EVERY: Duration = Duration::from_millis(250);

/// Spectra that are kept, the newest; of older ones the names stay.
pub const MOST_KEPT: usize = 200;

/// A file of the list.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    pub path: PathBuf,
    /// Its spectrum; `None` for an older file, and one that was there before.
    pub frame: Option<Frame>,
}

/// The files of a folder as they come.
pub struct FolderSource {
    path: PathBuf,
    name: String,
    choices: Choices,
    /// What each file's lines begin with.
    lines: Lines,
    files: BTreeMap<PathBuf, FileSource>,
    /// By time, the newest last.
    list: Vec<Listed>,
    /// Files that were there at first, the newest last, until one of them was read.
    present: Option<Vec<PathBuf>>,
    good: Option<Good>,
    waiting: VecDeque<Event>,
    broken: Broken,
    looked: Option<Instant>,
    opened: Instant,
}

impl FolderSource {
    /// A folder, whose files are read with the decisions of a person.
    pub fn new(path: &Path, choices: &Choices) -> Self {
        Self {
            path: path.to_owned(),
            name: name_of(path),
            choices: choices.clone(),
            lines: Lines::new(""),
            files: BTreeMap::new(),
            list: Vec::new(),
            present: None,
            good: None,
            waiting: VecDeque::new(),
            broken: Broken::default(),
            looked: None,
            opened: Instant::now(),
        }
    }

    /// The same for lines that tell no wavelengths.
    #[must_use]
    pub fn with_lines(self, lines: Lines) -> Self {
        Self { lines, ..self }
    }

    /// Every file that came or was there, the newest last; each is one step back.
    pub fn list(&self) -> &[Listed] {
        &self.list
    }

    /// The files, by time.
    fn paths(&self) -> io::Result<Vec<PathBuf>> {
        let mut found: Vec<(SystemTime, PathBuf)> = Vec::new();
        for entry in fs::read_dir(&self.path)? {
            let entry = entry?;
            let is_hidden = entry.file_name().to_string_lossy().starts_with('.');
            // One that is gone by now is none.
            let about = fs::metadata(entry.path());
            if let Some(about) = about.ok().filter(|about| about.is_file() && !is_hidden) {
                let modified = about.modified().unwrap_or(SystemTime::UNIX_EPOCH);
                found.push((modified, entry.path()));
            }
        }
        found.sort();
        Ok(found.into_iter().map(|(_, path)| path).collect())
    }

    fn source(&self, path: &Path) -> FileSource {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        FileSource::new(path, &self.choices)
            .with_lines(self.lines.anew(&name))
            .after(self.good.clone())
    }

    /// Looks at the folder, `now` s after it was opened.
    pub(super) fn look(&mut self, now: f64) {
        let paths = match self.paths() {
            Ok(paths) => paths,
            Err(why) => {
                let words = tr!("{name}: waiting ({why}).", name = self.name, why);
                if self.broken.last != words {
                    self.broken.last.clone_from(&words);
                    self.waiting.push_back(Event::Said(words));
                }
                return;
            }
        };
        if self.present.is_none() {
            for path in &paths {
                let mut source = self.source(path);
                source.skip_present();
                self.files.insert(path.clone(), source);
                self.list.push(Listed {
                    path: path.clone(),
                    frame: None,
                });
            }
            self.present = Some(paths.clone());
        }
        self.look_at_present(now);
        for path in &paths {
            let mut source = match self.files.remove(path) {
                Some(source) => source,
                None => self.source(path),
            };
            source.look(now);
            self.take(path, &mut source);
            self.files.insert(path.clone(), source);
        }
        let there: BTreeSet<PathBuf> = paths.into_iter().collect();
        self.files.retain(|path, _| there.contains(path));
    }

    /// The newest file that was there at first and can be read.
    fn look_at_present(&mut self, now: f64) {
        while let Some(path) = self.present.as_ref().and_then(|all| all.last().cloned()) {
            let mut source = self.source(&path);
            source.look(now);
            if self.take(&path, &mut source) {
                self.files.insert(path, source);
                self.present = Some(Vec::new());
                return;
            }
            if !source.is_done() {
                // It rests soon.
                return;
            }
            if let Some(present) = &mut self.present {
                present.pop();
            }
        }
    }

    /// Takes what a file has to say: its last frame. False where it has none.
    fn take(&mut self, path: &Path, source: &mut FileSource) -> bool {
        let mut last = None;
        while let Some(event) = source.pop() {
            match event {
                Event::Frame(frame) => last = Some(*frame),
                Event::Said(words) => {
                    self.broken.count += 1;
                    self.broken.last = words;
                }
                Event::End => {}
            }
        }
        let Some(frame) = last else {
            return false;
        };
        self.good = source.good.clone();
        self.list.retain(|listed| listed.path != path);
        self.list.push(Listed {
            path: path.to_owned(),
            frame: Some(frame.clone()),
        });
        let old = self.list.len().saturating_sub(MOST_KEPT);
        self.list[..old].iter_mut().for_each(|old| old.frame = None);
        let name = name_of(path);
        let frame = Frame { name, ..frame };
        self.waiting.push_back(Event::Frame(Box::new(frame)));
        true
    }
}

impl Source for FolderSource {
    fn name(&self) -> &str {
        &self.name
    }

    fn next(&mut self, patience: Duration) -> Option<Event> {
        let until = Instant::now() + patience;
        loop {
            if let Some(event) = self.waiting.pop_front() {
                return Some(event);
            }
            if self.looked.is_none_or(|looked| looked.elapsed() >= EVERY) {
                self.look(self.opened.elapsed().as_secs_f64());
                self.looked = Some(Instant::now());
                continue;
            }
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return None;
            }
            thread::sleep(left.min(EVERY));
        }
    }

    fn broken(&self) -> &Broken {
        &self.broken
    }
}

#[cfg(test)]
#[path = "../../tests/core/live/folder.rs"]
mod tests;
