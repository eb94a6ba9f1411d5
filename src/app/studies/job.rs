//! A long computation on a thread of its own, keyed by what was asked.

use std::{any::Any, sync::Arc};

use crate::{
    app::worker::{Tell, Wake, Worker},
    study::Progress,
};

use super::crossing::Crossing;

/// What takes long to answer, with all that its answer depends on.
pub trait Question {
    /// What is found.
    type Answer;

    /// The answer; `None` when there is none or it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<Self::Answer>;

    /// How it crosses to where there are no threads but other instances of the program; `None`
    /// where it is answered between two frames there.
    fn crossing() -> Option<Crossing<Self, Self::Answer>>
    where
        Self: Sized,
    {
        None
    }
}

/// Where a computation stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stage {
    /// Nothing was asked yet.
    Idle,
    /// Under way: the share that is done, 0-1.
    Running(f32),
    /// The result is what was asked last.
    Done,
    /// The last one was cancelled; an older result may be there.
    Cancelled,
    /// There is no answer to what was asked last.
    Impossible,
    /// The computation broke down: a fault of the program, told on standard error.
    Broken,
}

/// One kind of computation: the last good result stays while the next is computed.
pub struct Job<K, T> {
    asked: Option<K>,
    running: Option<Running<K, T>>,
    result: Option<(K, Arc<T>)>,
    stage: Stage,
    /// What is computed is finished, whatever is asked meanwhile: questions come faster than answers.
    pub patient: bool,
}

struct Running<K, T> {
    key: K,
    worker: Worker<T>,
    /// Told to stop because something else was asked, not by a person.
    superseded: bool,
}

impl<K, T> Default for Job<K, T> {
    fn default() -> Self {
        Self {
            asked: None,
            running: None,
            result: None,
            stage: Stage::Idle,
            patient: false,
        }
    }
}

impl<K: Clone + PartialEq + 'static, T: Send + 'static> Job<K, T> {
    /// Asks for a result; does nothing when it was asked already. What is still computed for
    /// another key is told to stop, and the new computation starts once it has.
    pub fn ask<F>(&mut self, key: &K, wake: &Wake, work: impl FnOnce() -> F)
    where
        F: FnOnce(&Progress) -> Option<T> + Send + 'static,
    {
        self.begin(key, || {
            let work = work();
            Worker::start(wake, move |tell| tell_all(tell, work(&tell.progress)))
        });
    }

    fn begin(&mut self, key: &K, start: impl FnOnce() -> Worker<T>) {
        self.take_in();
        if let Some(running) = &mut self.running {
            let progress = &running.worker.progress;
            if running.key != *key && !progress.is_cancelled() && !self.patient {
                progress.cancel();
                running.superseded = true;
            }
            return;
        }
        if self.asked.as_ref() == Some(key) {
            return;
        }
        self.asked = Some(key.clone());
        if self.result.as_ref().is_some_and(|(known, _)| known == key) {
            self.stage = Stage::Done;
            return;
        }
        self.stage = Stage::Running(0.0);
        self.running = Some(Running {
            key: key.clone(),
            worker: start(),
            superseded: false,
        });
    }

    /// Puts a question that holds all that its answer depends on.
    pub fn put(&mut self, question: &K, wake: &Wake)
    where
        K: Question<Answer = T> + Send,
    {
        self.begin(question, || {
            let own = question.clone();
            let work = move |tell: &Tell<T>| tell_all(tell, own.answer(&tell.progress));
            #[cfg(target_arch = "wasm32")]
            if let Some(crossing) = K::crossing()
                && let Some(bytes) = (crossing.asked)(question)
            {
                return Worker::far(wake, (crossing.kind, &bytes), crossing.found, work);
            }
            Worker::start(wake, work)
        });
    }

    fn join(&mut self) {
        let Some(running) = self.running.take() else {
            return;
        };
        let cancelled = running.worker.progress.is_cancelled();
        self.stage = match running.worker.join().map(|mut found| found.pop()) {
            Ok(Some(found)) => {
                self.result = Some((running.key, Arc::new(found)));
                Stage::Done
            }
            Ok(None) if running.superseded => {
                // Whoever asks for it again gets it.
                self.asked = None;
                Stage::Idle
            }
            Ok(None) if cancelled => Stage::Cancelled,
            Ok(None) => Stage::Impossible,
            // The panic itself was printed.
            Err(_) => Stage::Broken,
        };
    }

    /// Stops the computation; the last good result stays.
    pub fn cancel(&mut self) {
        if let Some(running) = &self.running {
            running.worker.progress.cancel();
        }
    }

    /// Asks again for what was cancelled.
    pub fn retry(&mut self) {
        if self.running.is_none() {
            self.asked = None;
        }
    }

    /// The last good result.
    pub fn result(&self) -> Option<&Arc<T>> {
        self.result.as_ref().map(|(_, result)| result)
    }

    /// The last good result with what it answers.
    pub fn answer(&self) -> Option<(&K, &Arc<T>)> {
        self.result.as_ref().map(|(key, result)| (key, result))
    }

    /// The result for a key, if it is the last good one.
    pub fn result_for(&self, key: &K) -> Option<&Arc<T>> {
        self.answer()
            .filter(|(known, _)| *known == key)
            .map(|(_, result)| result)
    }

    /// Where the computation stands.
    pub fn stage(&self) -> Stage {
        self.stage
    }
}

fn tell_all<T>(tell: &Tell<T>, found: Option<T>) {
    if let Some(found) = found {
        tell.send(found);
    }
}

/// Any job, whatever it computes.
pub trait Work: Any {
    /// Takes in what is finished.
    fn take_in(&mut self);

    /// Waits for what is being computed.
    fn finish(&mut self);

    /// Whether something is being computed.
    fn is_running(&self) -> bool;
}

impl<K: Clone + PartialEq + 'static, T: Send + 'static> Work for Job<K, T> {
    fn take_in(&mut self) {
        let Some(Running { worker, .. }) = &mut self.running else {
            return;
        };
        if worker.is_ended() {
            self.join();
        } else {
            self.stage = Stage::Running(worker.progress.share());
        }
    }

    fn finish(&mut self) {
        self.join();
    }

    fn is_running(&self) -> bool {
        self.running.is_some()
    }
}

#[cfg(test)]
mod tests {
    use std::{
        sync::atomic::{AtomicUsize, Ordering},
        sync::mpsc::{Sender, channel},
    };

    use super::*;

    fn asleep() -> Wake {
        Arc::new(|| {})
    }

    /// Asks for a key; the answer, the key itself, waits for a word and is none when cancelled.
    fn ask_and_wait(job: &mut Job<u8, u8>, key: u8) -> Sender<()> {
        let (go, wait) = channel::<()>();
        job.ask(&key, &asleep(), || {
            move |progress: &Progress| {
                let _ = wait.recv();
                (!progress.is_cancelled()).then_some(key)
            }
        });
        go
    }

    #[test]
    fn a_question_is_answered_once_however_often_it_is_asked() {
        let (mut job, count) = (Job::default(), Arc::new(AtomicUsize::new(0)));
        for _ in 0..3 {
            let count = count.clone();
            job.ask(&7, &asleep(), || {
                move |_: &Progress| {
                    count.fetch_add(1, Ordering::SeqCst);
                    Some(49)
                }
            });
            job.finish();
        }
        assert_eq!(count.load(Ordering::SeqCst), 1);
        assert_eq!(job.result_for(&7).map(|r| **r), Some(49));
        assert_eq!(job.stage(), Stage::Done);
    }

    #[test]
    fn the_old_result_stays_while_the_next_is_computed_and_when_it_is_cancelled() {
        let mut job = Job::default();
        job.ask(&1, &asleep(), || |_: &Progress| Some("one"));
        job.finish();
        let (go, wait) = channel::<()>();
        job.ask(&2, &asleep(), || {
            move |progress: &Progress| {
                let _ = wait.recv();
                (!progress.is_cancelled()).then_some("two")
            }
        });
        assert!(job.is_running());
        assert_eq!(job.result().map(|r| **r), Some("one"));
        assert_eq!(job.result_for(&2), None);
        job.cancel();
        go.send(()).expect("the worker waits");
        job.finish();
        assert_eq!(job.stage(), Stage::Cancelled);
        assert_eq!(job.result().map(|r| **r), Some("one"));
        // The same question is not asked again by itself.
        job.ask(&2, &asleep(), || |_: &Progress| Some("two"));
        assert!(!job.is_running());
        job.retry();
        job.ask(&2, &asleep(), || |_: &Progress| Some("two"));
        job.finish();
        assert_eq!(job.result_for(&2).map(|r| **r), Some("two"));
    }

    #[test]
    fn another_question_stops_the_one_before() {
        let mut job: Job<u8, u8> = Job::default();
        let go = ask_and_wait(&mut job, 1);
        job.ask(&2, &asleep(), || |_: &Progress| Some(2));
        go.send(()).expect("the worker waits");
        job.finish();
        assert_eq!(job.result(), None);
        job.ask(&2, &asleep(), || |_: &Progress| Some(2));
        job.finish();
        assert_eq!(job.result_for(&2).map(|r| **r), Some(2));
    }

    #[test]
    fn a_patient_job_answers_what_it_was_asked_first_and_then_what_was_asked_last() {
        let mut job: Job<u8, u8> = Job {
            patient: true,
            ..Job::default()
        };
        let go = ask_and_wait(&mut job, 1);
        for later in [2, 3] {
            job.ask(&later, &asleep(), || move |_: &Progress| Some(later));
        }
        go.send(()).expect("the worker waits");
        job.finish();
        assert_eq!(job.result_for(&1).map(|r| **r), Some(1));
        job.ask(&3, &asleep(), || |_: &Progress| Some(3));
        job.finish();
        assert_eq!(job.result_for(&3).map(|r| **r), Some(3));
    }

    #[test]
    fn a_question_that_comes_back_while_it_is_being_stopped_is_answered() {
        let mut job: Job<u8, u8> = Job::default();
        let go = ask_and_wait(&mut job, 1);
        job.ask(&2, &asleep(), || |_: &Progress| Some(2));
        job.ask(&1, &asleep(), || |_: &Progress| Some(1));
        go.send(()).expect("the worker waits");
        job.finish();
        assert_eq!(job.stage(), Stage::Idle, "nobody cancelled it");
        job.ask(&1, &asleep(), || |_: &Progress| Some(1));
        job.finish();
        assert_eq!(job.result_for(&1).map(|r| **r), Some(1));
    }

    #[test]
    fn a_computation_that_breaks_down_is_not_an_answer() {
        let mut job: Job<u8, u8> = Job::default();
        job.ask(&1, &asleep(), || |_: &Progress| panic!("told on purpose"));
        job.finish();
        assert_eq!(job.stage(), Stage::Broken);
        assert_eq!(job.result(), None);
    }

    #[test]
    fn no_answer_is_an_answer() {
        let mut job: Job<u8, u8> = Job::default();
        job.ask(&1, &asleep(), || |_: &Progress| None);
        job.finish();
        assert_eq!(job.stage(), Stage::Impossible);
    }
}
