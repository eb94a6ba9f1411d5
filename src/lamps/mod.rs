//! Known lamps and lines of their own width: the composite ahead of every representation.
//!
//! ```text
//! composite_fit  the verb: a composite fitted to a spectrum
//! detector     the house's lines, each as wide as it is
//! known        the lamps that an encoding may be made of
//! encoding     an encoded light and its decoder; words, makeup: the same as bits and for people
//! ask encoder  what is asked, and the encoder; choice: the way to an encoding, work: one light on it
//!              operators goals columns orthonormal search fit refine today: its parts
//! judge        the three errors, on what chooses and on what judges
//! race         how lights are encoded in the race; report: JSON
//! ```
//!
//! Wavelengths in nm, values in the spectrum's own unit, weights in that unit x nm. Not modelled:
//! lines that are no Gaussian, and what a smooth factor does to the shape of a wide line (its power
//! is exact).

mod ask;
mod choice;
mod columns;
mod composite_fit;
mod detector;
mod encoder;
mod encoding;
mod error;
mod fit;
mod goals;
mod judge;
mod known;
mod makeup;
mod operators;
mod orthonormal;
mod race;
mod refine;
mod report;
mod search;
mod today;
mod words;
mod work;

pub use ask::{Ask, NUMBERS};
pub(crate) use ask::{Count, LeaveOut};
pub use composite_fit::FitOptions;
#[cfg(test)]
pub(crate) use detector::decompose;
pub(crate) use detector::{as_wide_as_it_is, own_profile};
pub use encoder::Encoder;
pub(crate) use encoder::LONGEST_RANGE_NM;
pub(crate) use encoding::AtomWeight;
pub use encoding::Decoder;
#[cfg(test)]
pub(crate) use encoding::Encoding;
pub use error::EncodingError;
pub use judge::{Errors, EvaluationSet};
pub(crate) use known::namesakes;
#[cfg(test)]
pub(crate) use known::{atoms_on, known_lamps};
pub(crate) use makeup::{Ingredients, Part};
pub(crate) use race::Racing;
pub use report::{Encoded, judged};
pub(crate) use report::{decode_json, encode_json, encode_words, read_encoding};
#[cfg(test)]
pub(crate) use words::from_words;
pub(crate) use words::words_in_text;
