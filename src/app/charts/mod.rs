//! The studies' results as charts: data, no widgets.

pub mod auction;
pub mod tradeoff;
