//! The same work on many items on all processors, and the figures of many lights by it.

use std::{
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use crate::{
    color::quality::{Figures, Light, Measured},
    study::Progress,
};

/// The figures of many lights with what their values measure, in the order given, on `threads`
/// threads; the same bits whatever their number. `None` when cancelled.
pub fn figures_of_many(
    lights: &[(Light, Option<Measured>)],
    threads: usize,
    progress: &Progress,
) -> Option<Vec<Figures>> {
    in_parallel(lights, threads, progress, |(light, measured)| {
        Figures::of(light, *measured)
    })
}

/// What `work` makes of each item, in the order given, on `threads` threads. `None` when
/// cancelled.
pub fn in_parallel<T: Sync, R: Send>(
    items: &[T],
    threads: usize,
    progress: &Progress,
    work: impl Fn(&T) -> R + Sync,
) -> Option<Vec<R>> {
    progress.expect(items.len());
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
