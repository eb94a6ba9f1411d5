//! The page "Products" as charts, one part a file.

pub mod absorption;
pub mod bounces;
pub mod chain;
pub mod check;
pub mod forming;
pub mod lights;
pub mod narrow;
