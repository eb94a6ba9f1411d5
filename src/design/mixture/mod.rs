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

pub use channel::{Channel, MOST_CHANNELS, composite, mixed};
pub use error::MixError;
pub use spec::{Source, Spec};
