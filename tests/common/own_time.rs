//! Time that a thread itself has worked: what other programs take of a busy machine is not in it.

/// What comes out of work on this thread, and the seconds of the processor that it took.
pub(crate) fn own_seconds<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let before = now();
    let made = work();
    (made, now() - before)
}

#[cfg(unix)]
fn now() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ThreadCPUTime);
    time.tv_sec as f64 + 1e-9 * time.tv_nsec as f64
}

/// Systems that do not tell it: nothing is asked of them.
#[cfg(not(unix))]
fn now() -> f64 {
    0.0
}
