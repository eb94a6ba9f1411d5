//! Two lights compared: which is better for what, by which figure.
//!
//! ```text
//! side      one of the two lights, and the figures that are compared
//! rule      from two values to the better one, or that they are about the same
//! purpose   what lights are for: the figure, its rule and its words, a row each
//! better    one purpose of two lights: the values, which is better, a sentence
//! compared  all purposes, the sentence that sums them up, notes
//! words     a comparison as the command `light --against` prints it
//! json      a comparison with the keys of that command
//! ```

mod better;
mod compared;
mod json;
mod purpose;
mod rule;
mod side;
mod words;

pub use better::Better;
pub use compared::Compared;
pub use json::json;
pub use purpose::{PURPOSES, Purpose};
pub use rule::Which;
pub use side::Side;
pub use words::text;
