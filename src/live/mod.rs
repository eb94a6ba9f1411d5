//! Live work on a stream of spectra: numbers only, no clock and no files.
//!
//! ```text
//! state    hold, average, dark and reference, peak hold, clipped columns, rate, captures
//! tracks   lines, glow, CCT and Y over time, as composites in little memory
//! jumps    moments at which lines, glow or level jump
//! words    rate, age and time in words
//! ```
//!
//! Frames come from a [`Source`](crate::streams::Source); whoever asks it hands them on with the time that
//! it is.

mod jumps;
mod state;
mod tracks;
mod words;

pub use jumps::{Course, Jump};
pub use state::{Live, MOST_AVERAGED, Reference, Shown};
pub use tracks::{MOST_LINES, Point, Track, Tracks, sums};
pub use words::{age, clock, rate};
