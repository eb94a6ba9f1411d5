//! Spectra that change while one looks: a file that is written anew, a folder, lines that come over
//! standard input, TCP or a serial port, a recording that is played.
//!
//! No driver is needed: an instrument is whatever writes a file or a line.

mod file;
mod folder;
mod frame;
mod lines;
mod replay;
#[cfg(feature = "serial")]
mod serial;
mod stream;

use std::time::Duration;

pub use file::FileSource;
pub use folder::{FolderSource, Listed, MOST_KEPT};
pub use frame::{Frame, Recorder};
pub use lines::{Broken, Lines, MOST_LINE_BYTES};
pub use replay::{Pace, Replay};
#[cfg(feature = "serial")]
pub use serial::{Serial, ports};
pub use stream::{Heard, LineSource, Link, ListenError, Listener, Piped, Reach, listen, piped};

/// Bits a second of a serial port where nobody says another number.
pub const BAUD: u32 = 115_200;

/// An event of a source.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// A spectrum came.
    Frame(Box<Frame>),
    /// A sentence: a producer that came or went, a file that is waited for. The last frame stays.
    Said(String),
    /// Nothing more will come.
    End,
}

/// A source of frames.
pub trait Source: Send {
    /// The source as captures are called after it.
    fn name(&self) -> &str;

    /// The next event, if one comes within this time.
    fn next(&mut self, patience: Duration) -> Option<Event>;

    /// The lines that were skipped.
    fn broken(&self) -> &Broken;
}
