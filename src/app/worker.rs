//! A thread that tells what it finds, can be asked to stop, and wakes the window.

use std::{
    sync::{
        Arc,
        mpsc::{Receiver, Sender, TryRecvError, channel},
    },
    thread,
};

#[cfg(not(target_arch = "wasm32"))]
use crate::languages;
use crate::study::Progress;

#[cfg(not(target_arch = "wasm32"))]
type Hand = thread::JoinHandle<()>;

/// A thread that speaks as the one that asks for it.
#[cfg(not(target_arch = "wasm32"))]
fn spawn(work: impl FnOnce() + Send + 'static) -> Hand {
    let language = languages::spoken();
    thread::spawn(move || {
        languages::speak(language);
        work();
    })
}

#[cfg(target_arch = "wasm32")]
use super::hands::{Came, Hand, ask, spawn};

/// Called on another thread when there is something new to draw.
pub type Wake = Arc<dyn Fn() + Send + Sync>;

/// The thread's side: at its end, however it comes, the other side is woken and knows.
pub struct Tell<T> {
    sender: Option<Sender<T>>,
    pub(super) wake: Wake,
    pub progress: Arc<Progress>,
}

impl<T> Tell<T> {
    /// Hands over what is found; `false` where nobody listens any more.
    pub fn send(&self, found: T) -> bool {
        let sender = self.sender.as_ref();
        sender.is_some_and(|sender| sender.send(found).is_ok())
    }

    /// The same, and has it drawn at once.
    pub fn show(&self, found: T) -> bool {
        let is_heard = self.send(found);
        (self.wake)();
        is_heard
    }
}

impl<T> Drop for Tell<T> {
    fn drop(&mut self) {
        self.sender = None;
        (self.wake)();
    }
}

/// The watcher's side; dropped, it asks the thread to stop.
pub struct Worker<T> {
    news: Receiver<T>,
    unread: Vec<T>,
    ended: bool,
    thread: Option<Hand>,
    pub progress: Arc<Progress>,
}

impl<T: Send + 'static> Worker<T> {
    pub fn start(wake: &Wake, work: impl FnOnce(&Tell<T>) + Send + 'static) -> Self {
        Self::heard(wake, |tell| spawn(move || work(&tell)))
    }

    /// Listens to what a hand tells.
    fn heard(wake: &Wake, begin: impl FnOnce(Tell<T>) -> Hand) -> Self {
        let (sender, news) = channel();
        let tell = Tell {
            sender: Some(sender),
            wake: wake.clone(),
            progress: Arc::default(),
        };
        Self {
            news,
            unread: Vec::new(),
            ended: false,
            progress: tell.progress.clone(),
            thread: Some(begin(tell)),
        }
    }

    /// Has another instance of the program answer a question of a kind that it knows, where there
    /// are such; what it does not answer is worked on here.
    #[cfg(target_arch = "wasm32")]
    pub fn far(
        wake: &Wake,
        question: (&str, &[u8]),
        found: fn(&[u8]) -> Option<Option<T>>,
        work: impl FnOnce(&Tell<T>) + 'static,
    ) -> Self {
        Self::heard(wake, |tell| {
            let progress = tell.progress.clone();
            let take = move |came| {
                let answer = match came {
                    Came::Bytes(bytes) => found(&bytes),
                    Came::Nothing => None,
                    Came::Broken => return,
                };
                match answer {
                    Some(Some(found)) => {
                        tell.send(found);
                    }
                    Some(None) => {}
                    None => {
                        (tell.wake)();
                        spawn(move || work(&tell));
                    }
                }
            };
            ask(question, (&progress, wake), Box::new(take))
        })
    }

    /// Whether nothing is to come behind what [`news`](Self::news) brings next.
    pub fn is_ended(&mut self) -> bool {
        loop {
            match self.news.try_recv() {
                Ok(found) => self.unread.push(found),
                Err(TryRecvError::Empty) => return self.ended,
                Err(TryRecvError::Disconnected) => self.ended = true,
            }
            if self.ended {
                return true;
            }
        }
    }

    /// What was found since the last call.
    pub fn news(&mut self) -> Vec<T> {
        self.is_ended();
        std::mem::take(&mut self.unread)
    }

    /// Waits for the end; what was found since the last call.
    ///
    /// # Errors
    /// The thread broke down.
    pub fn join(mut self) -> thread::Result<Vec<T>> {
        self.thread.take().map_or(Ok(()), Hand::join)?;
        Ok(self.news())
    }
}

impl<T> Drop for Worker<T> {
    fn drop(&mut self) {
        self.progress.cancel();
    }
}

/// What several found since the last call; those that ended are let go.
pub fn news_of<T: Send + 'static>(workers: &mut Vec<Worker<T>>) -> Vec<T> {
    let mut all = Vec::new();
    workers.retain_mut(|worker| {
        let is_ended = worker.is_ended();
        all.extend(worker.news());
        !is_ended
    });
    all
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;

    fn counted() -> (Wake, Arc<AtomicUsize>) {
        let count = Arc::new(AtomicUsize::new(0));
        let counter = count.clone();
        let wake: Wake = Arc::new(move || {
            counter.fetch_add(1, Ordering::SeqCst);
        });
        (wake, count)
    }

    #[test]
    fn all_that_was_found_is_there_at_the_end_and_the_end_wakes() {
        let (wake, woken) = counted();
        let mut workers = vec![Worker::start(&wake, |tell| {
            assert!(tell.send(1) && tell.show(2));
        })];
        let mut found = Vec::new();
        while !workers.is_empty() {
            found.extend(news_of(&mut workers));
        }
        assert_eq!(found, [1, 2]);
        assert_eq!(woken.load(Ordering::SeqCst), 2, "shown, and ended");
    }

    #[test]
    fn one_that_breaks_down_ends_and_wakes_too() {
        let (wake, woken) = counted();
        let worker: Worker<u8> = Worker::start(&wake, |_| panic!("told on purpose"));
        assert!(worker.join().is_err());
        assert_eq!(woken.load(Ordering::SeqCst), 1);
    }

    #[test]
    fn who_is_dropped_is_asked_to_stop_and_hears_no_more() {
        let (go, wait) = channel::<()>();
        let (told, heard) = channel();
        let worker = Worker::start(&counted().0, move |tell| {
            let _ = wait.recv();
            let _ = told.send((tell.progress.is_cancelled(), tell.send(1)));
        });
        drop(worker);
        go.send(()).expect("it waits");
        assert_eq!(heard.recv(), Ok((true, false)));
    }
}
