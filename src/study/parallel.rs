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

/// Does `work` on each part, the last one on this thread and every other one on its own.
pub(crate) fn side_by_side<P: Send>(parts: impl IntoIterator<Item = P>, work: impl Fn(P) + Sync) {
    let (mut parts, work) = (parts.into_iter().peekable(), &work);
    thread::scope(|scope| {
        while let Some(part) = parts.next() {
            if parts.peek().is_some() {
                scope.spawn(move || work(part));
            } else {
                work(part);
            }
        }
    });
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
    fn every_part_is_worked_on_and_the_last_one_here() {
        let mut values = [0; 7];
        let here = thread::current().id();
        side_by_side(values.chunks_mut(3).enumerate(), |(part, values)| {
            values.fill(part + 1);
            assert_eq!(thread::current().id() == here, part == 2);
        });
        assert_eq!(values, [1, 1, 1, 2, 2, 2, 3]);
    }

    #[test]
    fn who_is_cancelled_half_way_has_no_result() {
        let progress = Progress::default();
        let found = in_parallel(&[0; 9], 1, &progress, |_| progress.cancel());
        assert_eq!(found, None);
    }
}
