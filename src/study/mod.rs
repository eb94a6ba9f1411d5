//! Accuracy against numbers: what a model costs, what it is off by, and what to buy next.

pub mod auction;
mod displacement;
pub mod error;
mod goal;
pub mod harmonics;
mod many;
mod measure;
mod parallel;
pub mod products;
mod progress;
mod projected_spectrum;
pub mod quality;
pub mod race;
mod race_cells;
mod race_result;
mod reference;
mod sweep;
mod training;
pub mod truth;
mod way;

pub use auction::Auction;
pub use error::Spread;
pub use goal::Goal;
pub(crate) use many::{ManyLights, SweptLight};
pub use measure::{Measure, Verdict};
pub(crate) use parallel::{in_parallel, processors, side_by_side};
pub use progress::Progress;
pub(crate) use projected_spectrum::{FitBasis, ProjectedSpectrum};
pub use race::Race;
pub use reference::Reference;
pub(crate) use reference::{Measures, bandpass, brightened, filter_centres, scaled_to_one};
pub use sweep::Examined;
#[cfg(test)]
pub(crate) use sweep::just_noticeable;
pub(crate) use sweep::{Subject, Sweep, SweepPoint};
pub(crate) use training::Training;
pub use way::FitVariant;
