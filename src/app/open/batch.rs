//! Reading many files as one job: on threads of their own, with progress and cancel.
//!
//! Files are read two at a time where there are two processors: most of the time of a small file
//! is its opening. They come back in the order in which they were listed.

use std::{
    collections::VecDeque,
    path::PathBuf,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicU64, AtomicUsize, Ordering},
        mpsc::channel,
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
use crate::{
    app::{
        opened::Opened,
        worker::{Wake, Worker},
    },
    languages::said,
};

/// Files read at the same time.
const MOST_AT_ONCE: usize = 2;

/// What the spectra and images of one batch may take of memory, bytes; files behind that are not
/// read.
pub const MOST_KEPT: u64 = 2 << 30;

/// Said of a file that was not reached.
const CANCELLED: &str = later!("cancelled before its turn");

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

enum Event {
    Listed(Vec<Listed>),
    Read(usize, Came),
}

/// What has come of a batch so far.
struct Batch {
    named: Vec<PathBuf>,
    listed: Option<Vec<Listed>>,
    came: Vec<Option<Came>>,
    done: usize,
}

struct Running {
    worker: Worker<Event>,
    at_work: Arc<Mutex<String>>,
    batch: Batch,
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
        let at_work = Arc::new(Mutex::new(String::new()));
        let (paths, label) = (named.clone(), at_work.clone());
        let worker = Worker::start(&wake, move |tell| {
            let is_cancelled = || tell.progress.is_cancelled();
            work(&paths, (&is_cancelled, &label), &|event| tell.send(event));
        });
        self.running = Some(Running {
            worker,
            at_work,
            batch: Batch::new(named),
        });
    }

    /// Whether files are being read.
    pub fn is_busy(&self) -> bool {
        self.running.is_some()
    }

    /// How far the running batch has come, as of the last call of [`Self::finished`].
    pub fn progress(&self) -> Option<Progress> {
        let running = self.running.as_ref()?;
        let at_work = running.at_work.lock();
        Some(Progress {
            done: running.batch.done,
            total: running.batch.listed.as_ref().map(Vec::len),
            at_work: at_work.unwrap_or_else(PoisonError::into_inner).clone(),
        })
    }

    /// Stops the running batch: the next [`Self::finished`] brings what was read until now. The
    /// file at work is not waited for.
    pub fn cancel(&mut self) {
        if let Some(running) = &self.running {
            running.worker.progress.cancel();
        }
    }

    /// The batch that has come to its end since the last call.
    pub fn finished(&mut self) -> Option<Finished> {
        let running = self.running.as_mut()?;
        let is_ended = running.worker.is_ended();
        for event in running.worker.news() {
            running.batch.take(event);
        }
        let is_cancelled = running.worker.progress.is_cancelled();
        if !is_ended && !is_cancelled {
            return None;
        }
        let running = self.running.take()?;
        self.start_next();
        Some(running.batch.into_finished(is_cancelled))
    }
}

impl Batch {
    fn new(named: Vec<PathBuf>) -> Self {
        Self {
            named,
            listed: None,
            came: Vec::new(),
            done: 0,
        }
    }

    fn take(&mut self, event: Event) {
        match event {
            Event::Listed(listed) => {
                self.came = listed.iter().map(|_| None).collect();
                self.listed = Some(listed);
            }
            Event::Read(index, came) => {
                if let Some(place) = self.came.get_mut(index) {
                    *place = Some(came);
                    self.done += 1;
                }
            }
        }
    }

    fn into_finished(self, is_cancelled: bool) -> Finished {
        let is_whole = self.listed.is_some() && self.came.iter().all(Option::is_some);
        let cancelled = is_cancelled && !is_whole;
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
            came: came.unwrap_or_else(|| Came::NotRead(said(CANCELLED).to_owned())),
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
    let tell = |event| sender.send(event).is_ok();
    work(paths, (&|| false, &Mutex::default()), &tell);
    drop(sender);
    let mut batch = Batch::new(paths.to_vec());
    events.into_iter().for_each(|event| batch.take(event));
    batch.into_finished(false)
}

/// Tells what the paths list, then what comes of each file; the file at work is named.
fn work(
    paths: &[PathBuf],
    (is_cancelled, at_work): (&(dyn Fn() -> bool + Sync), &Mutex<String>),
    tell: &(dyn Fn(Event) -> bool + Sync),
) {
    let listed = folders::listed(paths, &is_cancelled);
    if !tell(Event::Listed(listed.clone())) {
        return;
    }
    let (next, kept) = (AtomicUsize::new(0), AtomicU64::new(0));
    let processors = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let hands = processors.min(MOST_AT_ONCE).min(listed.len());
    let hand = || {
        while !is_cancelled() {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(file) = listed.get(index) else {
                return;
            };
            let label = at_work.lock();
            file.label
                .clone_into(&mut label.unwrap_or_else(PoisonError::into_inner));
            if !tell(Event::Read(index, come(file, &kept))) {
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
        let words = said!("the files before it fill 2 GiB of memory; open it by itself");
        return Came::NotRead(words.to_owned());
    }
    let loaded = unshaken(file.path.display(), || load_path(&file.path));
    match &loaded {
        Loaded::File(opened) => {
            kept.fetch_add(memory_of(opened), Ordering::Relaxed);
        }
        // It would put everything else away.
        Loaded::Project { .. } if file.in_folder => {
            let words = said!("a project of this program; open it by itself");
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
