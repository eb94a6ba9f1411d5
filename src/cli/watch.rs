//! How far a long command is, told on a terminal while it works.

use std::{
    io::{IsTerminal, Write},
    panic::{AssertUnwindSafe, catch_unwind, resume_unwind},
    sync::atomic::{AtomicBool, Ordering},
    thread,
    time::Duration,
};

use crate::study::Progress;

/// Between two looks at how far it is; work of less says nothing.
const PAUSE: Duration = Duration::from_millis(500);

/// Work that tells how far it is in one line of standard error, which is wiped in the end. Where
/// nobody looks (a file, a pipe) nothing is told.
pub(super) fn watched<T>(work: impl FnOnce(&Progress) -> T) -> T {
    let progress = Progress::default();
    if !std::io::stderr().is_terminal() {
        return work(&progress);
    }
    let is_done = AtomicBool::new(false);
    thread::scope(|scope| {
        let watcher = scope.spawn(|| {
            let mut told = false;
            loop {
                thread::park_timeout(PAUSE);
                // What cannot be told is not missed.
                let mut out = std::io::stderr().lock();
                if is_done.load(Ordering::Acquire) {
                    if told {
                        let _ = write!(out, "\r\x1b[K");
                    }
                    return;
                }
                let _ = write!(out, "\r{:3.0} %", 100.0 * progress.share());
                told = true;
            }
        });
        let answer = catch_unwind(AssertUnwindSafe(|| work(&progress)));
        is_done.store(true, Ordering::Release);
        watcher.thread().unpark();
        answer.unwrap_or_else(|panic| resume_unwind(panic))
    })
}
