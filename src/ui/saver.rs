//! Keeps the workspace on disk, on a thread of its own: the window never waits for it.

use std::{
    path::{Path, PathBuf},
    sync::{
        Arc,
        mpsc::{Sender, channel},
    },
    time::{Duration, Instant},
};

use crate::app::{
    Document,
    worker::Worker,
    workspace::{self, Preferences, StoredImage},
};

/// A change is kept on disk at most this long after it was made.
const AFTER: Duration = Duration::from_millis(700);

/// What is kept, and when it must be on its way to the disk.
struct Kept {
    document: Document,
    preferences: Preferences,
    waiting: Vec<StoredImage>,
    due: Instant,
    /// Dropped once it is written.
    _written: Option<Sender<()>>,
}

/// Writes the newest workspace it was given; what came in between is skipped.
pub struct Saver {
    sender: Option<Sender<Kept>>,
    /// It tells what went wrong.
    worker: Option<Worker<String>>,
    path: PathBuf,
}

impl Saver {
    /// A saver for one file.
    pub fn new(path: PathBuf) -> Self {
        let kept_at = path.clone();
        let (sender, jobs) = channel::<Kept>();
        let worker = Worker::start(&(Arc::new(|| {}) as _), move |tell| {
            while let Ok(mut job) = jobs.recv() {
                // The clock is this thread's: a window that is covered draws no further frame.
                while let Ok(newer) =
                    jobs.recv_timeout(job.due.saturating_duration_since(Instant::now()))
                {
                    let due = job.due.min(newer.due);
                    job = Kept { due, ..newer };
                }
                let Kept {
                    document,
                    preferences,
                    waiting,
                    ..
                } = &job;
                let text = workspace::to_json_with(document, Some(preferences), waiting);
                let text = text.map_err(|why| tr!("Workspace not saved: {reason}.", reason = why));
                if let Err(why) = text.and_then(|text| workspace::save(&path, &text)) {
                    // The window may be gone already; then nobody is left to be told.
                    tell.send(why);
                }
            }
        });
        Self {
            sender: Some(sender),
            worker: Some(worker),
            path: kept_at,
        }
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Hands over what is to be written at once.
    pub fn keep(&self, document: &Document, preferences: &Preferences) {
        self.keep_with(document, preferences, &[]);
    }

    /// The same with images that are still being read again.
    pub fn keep_with(
        &self,
        document: &Document,
        preferences: &Preferences,
        waiting: &[StoredImage],
    ) {
        self.keep_by(Instant::now(), (document, preferences, waiting), None);
    }

    /// The same, and waits until it is on disk: what was told to be kept is kept, whatever comes.
    pub fn keep_and_wait(
        &self,
        document: &Document,
        preferences: &Preferences,
        waiting: &[StoredImage],
    ) {
        let (sender, written) = channel();
        let of = (document, preferences, waiting);
        self.keep_by(Instant::now(), of, Some(sender));
        // Nothing is ever sent: it ends when the other side is dropped.
        let _ = written.recv();
    }

    /// Hands over what is to be written soon: what follows within a moment is written with it.
    pub fn keep_soon(
        &self,
        document: &Document,
        preferences: &Preferences,
        waiting: &[StoredImage],
    ) {
        self.keep_by(
            Instant::now() + AFTER,
            (document, preferences, waiting),
            None,
        );
    }

    fn keep_by(
        &self,
        due: Instant,
        (document, preferences, waiting): (&Document, &Preferences, &[StoredImage]),
        written: Option<Sender<()>>,
    ) {
        if let Some(sender) = &self.sender {
            // Fails only when the thread is gone, which it is only when the program ends.
            let _ = sender.send(Kept {
                document: document.clone(),
                preferences: preferences.clone(),
                waiting: waiting.to_vec(),
                due,
                _written: written,
            });
        }
    }

    /// What went wrong since the last call.
    pub fn trouble(&mut self) -> Option<String> {
        self.worker.as_mut()?.news().pop()
    }
}

impl Drop for Saver {
    /// Waits until the last workspace is on disk.
    fn drop(&mut self) {
        self.sender = None;
        if let Some(worker) = self.worker.take() {
            let _ = worker.join();
        }
    }
}
