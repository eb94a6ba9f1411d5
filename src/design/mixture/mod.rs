//! Channels that are mixed to a light.
//!
//! ```text
//! spec     a channel in words
//! channel  its light, mixtures, the mixture as a composite
//! error    why channels make no light
//! ```

mod channel;
mod error;
mod spec;

pub(crate) use channel::left_out;
pub use channel::{Channel, composite, mixed};
pub(crate) use error::MOST_CHANNELS;
pub use error::MixError;
pub use spec::Source;
pub(crate) use spec::Spec;
