//! Making lights and spectra.
//!
//! ```text
//! recover        spectra from colours
//! mixture        channels that are mixed to a light
//! solve          mixtures by an objective and constraints
//! scales         what a light is scored by, from linear sums
//! whole_nm       lights on whole nm
//! programme      linear programmes of a few equations
//! least_squares  weights that are not negative, with exact equations
//! gamut          the colours that mixtures can have
//! nearest_point  the nearest point of a sum of segments
//! small          systems of a few equations
//! ```

mod gamut;
mod least_squares;
pub mod mixture;
mod nearest_point;
mod programme;
pub mod recover;
mod scales;
mod small;
pub mod solve;
mod whole_nm;

pub use scales::SampleTables;
