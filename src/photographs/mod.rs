//! A photograph of a spectrum becomes a calibrated spectrum: numbers and pixels only.
//!
//! ```text
//! picture -> strip (found, turned, straightened) -> profile -> peaks -> axis
//! ```
//!
//! The lines of a lamp fix the axis. It may be found, suggested, or nothing can be said of it.

pub mod axis;
pub mod colours;
pub mod hue;
pub mod landmarks;
pub mod peaks;
pub mod picture;
pub mod profile;
pub mod response;
mod smooth;
pub mod strip;

pub use landmarks::Lamp;
pub use profile::Profile;

#[cfg(test)]
mod tests;
