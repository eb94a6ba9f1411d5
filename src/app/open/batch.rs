//! Reading many files as one job: on threads of their own, with progress and cancel.
//!
//! Files are read two at a time where there are two processors: most of the time of a small file
//! is its opening. They come back in the order in which they were listed.

use std::{
    collections::VecDeque,
    path::PathBuf,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering},
        mpsc::{Receiver, Sender, channel},
    },
    thread,
};

use super::{
    Loaded,
    came::{Came, FileRead},
    folders::{self, Listed},
    load_path,
    summary::{FileRow, Summary},
    unshaken,
};
use crate::app::opened::Opened;

/// Files read at the same time.
const MOST_AT_ONCE: usize = 2;

/// What the spectra and images of one batch may take of memory, bytes; files behind that are not
/// read.
pub const MOST_KEPT: u64 = 2 << 30;

/// Said of a file that was not reached.
const CANCELLED: &str = "cancelled before its turn";

/// Called on another thread when there is something to fetch.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// A batch that has come to its end, or was cancelled.
#[derive(Debug)]
pub struct Finished {
    /// Its files, in the order in which they were listed.
    pub files: Vec<FileRead>,
    /// The files and folders that were named.
    pub named: Vec<PathBuf>,
    /// Whether a person stopped it before its end.
    pub cancelled: bool,
}

impl Finished {
    /// Files that came without a path and were read here and now.
    pub fn of_dropped(files: Vec<(String, Loaded)>) -> Self {
        let read = |(label, loaded)| FileRead {
            label,
            path: None,
            came: Came::Loaded(loaded),
        };
        Self {
            files: files.into_iter().map(read).collect(),
            named: Vec::new(),
            cancelled: false,
        }
    }

    /// What came of all files.
    pub fn summary(&self) -> Summary {
        Summary {
            rows: self.files.iter().map(FileRow::of).collect(),
            cancelled: self.cancelled,
        }
    }

    /// What was read, in order: files, and projects that were named.
    pub fn into_loaded(self) -> (Vec<Opened>, Vec<Loaded>) {
        let (mut opened, mut projects) = (Vec::new(), Vec::new());
        for file in self.files {
            match file.came {
                Came::Loaded(Loaded::File(file)) => opened.push(*file),
                Came::Loaded(project @ Loaded::Project { .. }) => projects.push(project),
                Came::Loaded(Loaded::Refused(_)) | Came::NotRead(_) => {}
            }
        }
        (opened, projects)
    }
}

/// How far a batch has come.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Files done.
    pub done: usize,
    /// Files to do; `None` while folders are looked through.
    pub total: Option<usize>,
    /// The file at work.
    pub at_work: String,
}

/// What both sides look at.
#[derive(Default)]
struct Watch {
    cancelled: AtomicBool,
    at_work: Mutex<String>,
}

impl Watch {
    fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    fn set_at_work(&self, label: &str) {
        let mut at_work = self.at_work.lock().unwrap_or_else(PoisonError::into_inner);
        label.clone_into(&mut at_work);
    }
}

enum Event {
    Listed(Vec<Listed>),
    Read(usize, Came),
    End,
}

struct Running {
    events: Receiver<Event>,
    watch: Arc<Watch>,
    named: Vec<PathBuf>,
    listed: Option<Vec<Listed>>,
    came: Vec<Option<Came>>,
    done: usize,
    ended: bool,
}

/// Reads files on threads of their own, so that no window waits for a disk. One batch runs at a
/// time; others wait for it.
#[derive(Default)]
pub struct Loader {
    running: Option<Running>,
    waiting: VecDeque<(Vec<PathBuf>, Wake)>,
}

impl Loader {
    /// Starts reading files and the files of folders as one batch; `wake` is called when it is
    /// done.
    pub fn open(&mut self, paths: Vec<PathBuf>, wake: Wake) {
        self.waiting.push_back((paths, wake));
        self.start_next();
    }

    fn start_next(&mut self) {
        if self.running.is_some() {
            return;
        }
        let Some((named, wake)) = self.waiting.pop_front() else {
            return;
        };
        let (sender, events) = channel();
        let watch = Arc::new(Watch::default());
        let (paths, shared) = (named.clone(), watch.clone());
        thread::spawn(move || {
            work(&paths, &shared, &sender);
            // Nobody listens any more after a cancel.
            let _ = sender.send(Event::End);
            wake();
        });
        self.running = Some(Running::new(events, watch, named));
    }

    /// Whether files are being read.
    pub fn is_busy(&self) -> bool {
        self.running.is_some()
    }

    /// How far the running batch has come, as of the last call of [`Self::finished`].
    pub fn progress(&self) -> Option<Progress> {
        let running = self.running.as_ref()?;
        let at_work = &running.watch.at_work;
        Some(Progress {
            done: running.done,
            total: running.listed.as_ref().map(Vec::len),
            at_work: at_work
                .lock()
                .unwrap_or_else(PoisonError::into_inner)
                .clone(),
        })
    }

    /// Stops the running batch: the next [`Self::finished`] brings what was read until now. The
    /// file at work is not waited for.
    pub fn cancel(&mut self) {
        if let Some(running) = &mut self.running {
            running.watch.cancelled.store(true, Ordering::Relaxed);
        }
    }

    /// The batch that has come to its end since the last call.
    pub fn finished(&mut self) -> Option<Finished> {
        let running = self.running.as_mut()?;
        running.take_in();
        if !running.ended && !running.watch.is_cancelled() {
            return None;
        }
        let finished = self.running.take().map(Running::into_finished);
        self.start_next();
        finished
    }
}

impl Drop for Loader {
    fn drop(&mut self) {
        self.cancel();
    }
}

impl Running {
    fn new(events: Receiver<Event>, watch: Arc<Watch>, named: Vec<PathBuf>) -> Self {
        Self {
            events,
            watch,
            named,
            listed: None,
            came: Vec::new(),
            done: 0,
            ended: false,
        }
    }

    fn take_in(&mut self) {
        loop {
            match self.events.try_recv() {
                Ok(Event::Listed(listed)) => {
                    self.came = listed.iter().map(|_| None).collect();
                    self.listed = Some(listed);
                }
                Ok(Event::Read(index, came)) => {
                    if let Some(place) = self.came.get_mut(index) {
                        *place = Some(came);
                        self.done += 1;
                    }
                }
                Ok(Event::End) => self.ended = true,
                Err(std::sync::mpsc::TryRecvError::Empty) => return,
                // The thread is gone, whatever became of it.
                Err(std::sync::mpsc::TryRecvError::Disconnected) => {
                    self.ended = true;
                    return;
                }
            }
        }
    }

    fn into_finished(self) -> Finished {
        let is_whole = self.listed.is_some() && self.came.iter().all(Option::is_some);
        let cancelled = self.watch.is_cancelled() && !is_whole;
        // Cancelled while folders were looked through: what was named stands for what was in it.
        let listed = self.listed.unwrap_or_else(|| {
            let all = self.named.iter();
            all.map(|path| Listed::named(path.display().to_string(), path))
                .collect()
        });
        let came = self.came.into_iter().chain(std::iter::repeat_with(|| None));
        let files = listed.into_iter().zip(came).map(|(listed, came)| FileRead {
            label: listed.label,
            path: Some(listed.path),
            came: came.unwrap_or_else(|| Came::NotRead(CANCELLED.to_owned())),
        });
        Finished {
            files: files.collect(),
            named: self.named,
            cancelled,
        }
    }
}

/// Reads files and the files of folders here and now.
pub fn read_all(paths: &[PathBuf]) -> Finished {
    let (sender, events) = channel();
    work(paths, &Watch::default(), &sender);
    drop(sender);
    let mut running = Running::new(events, Arc::default(), paths.to_vec());
    running.take_in();
    running.into_finished()
}

fn work(paths: &[PathBuf], watch: &Watch, sender: &Sender<Event>) {
    let listed = folders::listed(paths, &|| watch.is_cancelled());
    if sender.send(Event::Listed(listed.clone())).is_err() {
        return;
    }
    let (next, kept) = (AtomicUsize::new(0), AtomicU64::new(0));
    let processors = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let hands = processors.min(MOST_AT_ONCE).min(listed.len());
    let hand = || {
        while !watch.is_cancelled() {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(file) = listed.get(index) else {
                return;
            };
            watch.set_at_work(&file.label);
            let came = come(file, &kept);
            if sender.send(Event::Read(index, came)).is_err() {
                return;
            }
        }
    };
    thread::scope(|scope| {
        for _ in 1..hands {
            scope.spawn(hand);
        }
        hand();
    });
}

/// What comes of a file; `kept` counts the memory of all.
fn come(file: &Listed, kept: &AtomicU64) -> Came {
    if let Some(why) = &file.refused {
        return Came::Loaded(Loaded::Refused(why.clone()));
    }
    if kept.load(Ordering::Relaxed) > MOST_KEPT {
        let words = "the files before it fill 2 GiB of memory; open it by itself";
        return Came::NotRead(words.to_owned());
    }
    let loaded = unshaken(file.path.display(), || load_path(&file.path));
    match &loaded {
        Loaded::File(opened) => {
            kept.fetch_add(memory_of(opened), Ordering::Relaxed);
        }
        // It would put everything else away.
        Loaded::Project { .. } if file.in_folder => {
            let words = "a project of this program; open it by itself";
            return Came::NotRead(words.to_owned());
        }
        Loaded::Project { .. } | Loaded::Refused(_) => {}
    }
    Came::Loaded(loaded)
}

/// About what a file takes of memory once it is read, bytes.
fn memory_of(opened: &Opened) -> u64 {
    let spectra = opened.spectra.iter().map(|s| 16 * s.samples.len() as u64);
    let images = opened.images.iter().map(|i| i.cube.memory() as u64);
    spectra.chain(images).sum()
}
