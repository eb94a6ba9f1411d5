//! Guarded calls of third-party parsers: a panic becomes a refusal and not the program's end.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe, catch_unwind};
use std::sync::Once;

thread_local! {
    /// True while panics of this thread are caught and reported in other words.
    static IS_GUARDED: Cell<bool> = const { Cell::new(false) };
}

/// The result of a call, or `None` if it panics. Partial results are dropped then, so nothing
/// half-done is ever seen, and the panic's own message is not printed: the refusal replaces it.
/// Panics of other threads, and of this one before and after, are printed as ever.
pub(crate) fn guarded<T>(call: impl FnOnce() -> T) -> Option<T> {
    static HUSHED: Once = Once::new();
    HUSHED.call_once(|| {
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |about| {
            if !IS_GUARDED.get() {
                before(about);
            }
        }));
    });
    let outside = IS_GUARDED.replace(true);
    let outcome = catch_unwind(AssertUnwindSafe(call));
    IS_GUARDED.set(outside);
    outcome.ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_nothing_and_the_next_call_is_guarded_too() {
        assert_eq!(guarded(|| 7), Some(7));
        assert_eq!(guarded(|| -> i32 { panic!("of a parser") }), None);
        let inside = guarded(|| (guarded(|| panic!("within")).is_none(), IS_GUARDED.get()));
        assert_eq!(inside, Some((true, true)));
        assert!(!IS_GUARDED.get());
    }
}
