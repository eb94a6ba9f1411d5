//! The shipped spectra and their file format: one JSON file a group, with source and licence.
//!
//! A file is an object with the group's provenance and an array `items`, one item a line. An item
//! is a table (`wavelengths` and `values`), a list of lines (`wavelengths` and `strengths`) or a
//! composite (`composite`). Wavelengths are nm in air; `wavelengths` is either
//! `{"first_nm", "step_nm", "count"}` or `{"list_nm": [...]}`. Numbers are written as the shortest
//! decimals that give the same `f64` back, so that reading loses nothing.

mod error;
mod group;
mod read;
mod shelf;
mod shipped;

pub use group::Composite;
#[cfg(test)]
pub(crate) use group::OpticalConstants;
pub(crate) use group::{AtomicLine, Body, Group, LineList, Preset, PrintedSpike, Terms};
pub(crate) use shelf::Shelf;
pub(crate) use shipped::{EVERYDAY, FAMILIES, groups, unlisted};
pub use shipped::{group, table};
