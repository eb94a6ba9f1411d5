//! Progress and cancellation of a long computation.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Shared between the thread that computes and the one that watches.
///
/// The counts are for a progress bar only, so no ordering between them is needed.
#[derive(Debug, Default)]
pub struct Progress {
    done: AtomicUsize,
    total: AtomicUsize,
    cancelled: AtomicBool,
    told: Option<fn(usize, usize)>,
}

impl Progress {
    /// One whose watcher is told of every step: how many are done, and of how many.
    pub fn telling(told: fn(usize, usize)) -> Self {
        Self {
            told: Some(told),
            ..Self::default()
        }
    }

    /// Says how many steps there will be from now on: what follows one another with the same
    /// watcher counts anew each time.
    pub fn expect(&self, total: usize) {
        self.done.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    /// One step is done.
    pub fn step(&self) {
        let before = self.done.fetch_add(1, Ordering::Relaxed);
        if let Some(told) = self.told {
            told(before + 1, self.total.load(Ordering::Relaxed));
        }
    }

    /// Stands where another one does, of which this was told.
    pub fn follow(&self, done: usize, total: usize) {
        self.expect(total);
        self.done.store(done, Ordering::Relaxed);
    }

    /// Share of the steps done, 0-1; 0 before their number is known.
    pub fn share(&self) -> f32 {
        let total = self.total.load(Ordering::Relaxed);
        let done = self.done.load(Ordering::Relaxed);
        if total == 0 {
            0.0
        } else {
            (done as f32 / total as f32).min(1.0)
        }
    }

    /// Asks the computation to stop at its next step.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// True if cancellation was requested.
    pub(crate) fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_share_goes_from_nothing_to_all() {
        let progress = Progress::default();
        assert_eq!(progress.share(), 0.0);
        progress.expect(4);
        progress.step();
        assert_eq!(progress.share(), 0.25);
        (0..9).for_each(|_| progress.step());
        assert_eq!(progress.share(), 1.0);
        progress.expect(2);
        assert_eq!(progress.share(), 0.0, "the next part of the work");
        assert!(!progress.is_cancelled());
        progress.cancel();
        assert!(progress.is_cancelled());
    }

    #[test]
    fn who_is_told_of_the_steps_can_have_another_stand_where_they_are() {
        thread_local!(static TOLD: std::cell::RefCell<Vec<f32>> = const { std::cell::RefCell::new(Vec::new()) });
        let progress = Progress::telling(|done, total| {
            let mirror = Progress::default();
            mirror.follow(done, total);
            TOLD.with_borrow_mut(|told| told.push(mirror.share()));
        });
        progress.expect(2);
        progress.step();
        progress.step();
        assert_eq!(TOLD.take(), [0.5, 1.0]);
    }
}
