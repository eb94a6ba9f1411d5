//! Keeps the workspace on disk, on a thread of its own: the window never waits for it.

use std::{
    path::{Path, PathBuf},
    sync::mpsc::{Receiver, Sender, channel},
    thread::JoinHandle,
};

use crate::app::{
    Document,
    workspace::{self, Preferences, StoredImage},
};

/// What is kept.
type Kept = (Document, Preferences, Vec<StoredImage>);

/// Writes the newest workspace it was given; what came in between is skipped.
pub struct Saver {
    sender: Option<Sender<Kept>>,
    troubles: Receiver<String>,
    thread: Option<JoinHandle<()>>,
    path: PathBuf,
}

impl Saver {
    /// A saver for one file.
    pub fn new(path: PathBuf) -> Self {
        let kept_at = path.clone();
        let (sender, jobs) = channel::<Kept>();
        let (trouble, troubles) = channel();
        let thread = std::thread::spawn(move || {
            while let Ok(mut job) = jobs.recv() {
                while let Ok(newer) = jobs.try_recv() {
                    job = newer;
                }
                let (document, preferences, waiting) = job;
                let text = workspace::to_json_with(&document, Some(&preferences), &waiting);
                let text = text.map_err(|why| format!("Workspace not saved: {why}."));
                if let Err(why) = text.and_then(|text| workspace::save(&path, &text)) {
                    // The window may be gone already; then nobody is left to be told.
                    let _ = trouble.send(why);
                }
            }
        });
        Self {
            sender: Some(sender),
            troubles,
            thread: Some(thread),
            path: kept_at,
        }
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Hands over what is to be kept.
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
        if let Some(sender) = &self.sender {
            // Fails only when the thread is gone, which it is only when the program ends.
            let _ = sender.send((document.clone(), preferences.clone(), waiting.to_vec()));
        }
    }

    /// What went wrong since the last call.
    pub fn trouble(&self) -> Option<String> {
        self.troubles.try_iter().last()
    }
}

impl Drop for Saver {
    /// Waits until the last workspace is on disk.
    fn drop(&mut self) {
        self.sender = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
