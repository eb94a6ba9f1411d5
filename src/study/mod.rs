//! Accuracy against numbers: what a model costs, what it is off by, and what to buy next.

pub mod auction;
pub mod error;
pub mod harmonics;
pub mod judge;
pub mod prepared;
pub mod products;
pub mod progress;
pub mod race;
pub mod race_reference;
pub mod sweep;
pub mod training;
pub mod truth;
pub mod way;

pub use auction::{Auction, Goal};
pub use error::Spread;
pub use judge::{Judge, Measure, Verdict, Yardsticks};
pub use prepared::{Kit, Prepared};
pub use progress::Progress;
pub use race::Race;
pub use sweep::Sweep;
pub use way::Way;
