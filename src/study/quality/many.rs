//! The figures of many lights, on all processors.

use crate::{
    color::quality::{Figures, Light, Measured},
    study::{Progress, in_parallel},
};

/// The figures of many lights with what their values measure, in the order given, on `threads`
/// threads; the same bits whatever their number. `None` when cancelled.
pub fn figures_of_many(
    lights: &[(Light, Option<Measured>)],
    threads: usize,
    progress: &Progress,
) -> Option<Vec<Figures>> {
    progress.expect(lights.len());
    in_parallel(lights, threads, progress, |(light, measured)| {
        Figures::of(light, *measured)
    })
}
