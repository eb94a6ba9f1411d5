//! The place "Design": lights that are mixed, solved for, and made from colours.
//!
//! ```text
//! mix      the mixing desk as it is in the document
//! light    the desk's channels as lights, a mixture as a spectrum
//! desk     what the desk shows: figures, sentence, channel table
//! surfaces surfaces under the mixture, beside the same under its reference
//! named_lines  lines to put channels on
//! wish     what is wished of a mixture, and the faders for it
//! front    the trade between efficacy and colour rendering, as a job
//! recovered  from a colour to a spectrum
//! colour   a colour and the spectra that have it
//! colour_words  the same in words
//! telling  the ways to tell a colour by numbers
//! photo    a picture whose pixels are taken as colours
//! ```

pub mod colour;
mod colour_words;
mod desk;
pub mod front;
pub(super) mod light;
pub mod mix;
pub mod named_lines;
pub mod photo;
pub(super) mod recovered;
mod surfaces;
mod telling;
pub mod wish;

pub use colour_words::method_name;
pub use desk::{Desk, MainFigure, Strip};
pub use surfaces::{Beside, DeskSurfaces, beside};
pub use telling::Telling;
