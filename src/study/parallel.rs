//! The same work on many items on all processors.

use std::{
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use super::progress::Progress;

/// Number of processors.
pub(crate) fn processors() -> usize {
    thread::available_parallelism().map_or(1, usize::from)
}

/// Applies `work` to each item on `threads` threads, one step of progress per item; results are in
/// the order given. `None` when cancelled.
pub(crate) fn in_parallel<T: Sync, R: Send>(
    items: &[T],
    threads: usize,
    progress: &Progress,
    work: impl Fn(&T) -> R + Sync,
) -> Option<Vec<R>> {
    let next = AtomicUsize::new(0);
    let made: Vec<Mutex<Option<R>>> = items.iter().map(|_| Mutex::new(None)).collect();
    let hand = || {
        while !progress.is_cancelled() {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let Some(item) = items.get(index) else {
                return;
            };
            let result = work(item);
            *made[index].lock().unwrap_or_else(PoisonError::into_inner) = Some(result);
            progress.step();
        }
    };
    thread::scope(|scope| {
        for _ in 1..threads.min(items.len()) {
            scope.spawn(hand);
        }
        hand();
    });
    let made = made
        .into_iter()
        .map(|place| place.into_inner().unwrap_or_else(PoisonError::into_inner));
    made.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_stand_in_the_order_of_the_items_however_many_threads_work() {
        let items: Vec<usize> = (0..50).collect();
        for threads in [0, 1, 3, 99] {
            let progress = Progress::default();
            let found = in_parallel(&items, threads, &progress, |i| i * i);
            assert_eq!(found, Some(items.iter().map(|i| i * i).collect()));
        }
    }

    #[test]
    fn who_is_cancelled_half_way_has_no_result() {
        let progress = Progress::default();
        let found = in_parallel(&[0; 9], 1, &progress, |_| progress.cancel());
        assert_eq!(found, None);
    }
}
