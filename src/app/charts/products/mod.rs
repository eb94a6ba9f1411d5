//! The page "Products" as charts, one part a file.

pub mod absorption;
pub mod bounces;
pub mod chain;
pub mod narrow;
pub mod resampling;
pub mod two_lights;
