//! A parser of others is called so that a fault in it is a refusal and not the program's end.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// What a call gives, or `None` when it panics. What the call was building is dropped then, so
/// nothing half-done is ever seen.
pub fn guarded<T>(call: impl FnOnce() -> T) -> Option<T> {
    catch_unwind(AssertUnwindSafe(call)).ok()
}
