//! Spectra as numbers only: no files, no colour, no window.
//!
//! Wavelengths are `f64` nanometres in air as tabulated, values are in the spectrum's own unit,
//! and everything that models a spectrum works on the 1 nm grid of a [`Band`].

mod air;
mod band;
mod basis;
mod chain;
mod composite;
mod condition;
pub mod cube;
mod edits;
mod factor;
mod fit;
mod formula;
pub mod gradient;
mod image;
mod kind;
mod line;
mod named;
mod noise;
mod on_grid;
pub mod product;
mod quantile;
mod rect;
mod region;
mod resampled;
mod sampled;
mod series;
mod spikes;

pub use air::in_air;
pub(crate) use air::{SHORTEST_IN_AIR_NM, index_of_air, slope_of_air};
pub use band::{Band, BandError};
pub(crate) use band::{LONGEST_NM, MOST_STEPS, SHORTEST_NM, dot};
pub use basis::{Basis, PerBasis, numbers_of_order};
pub use chain::Stage;
pub(crate) use chain::{ChainTables, LineInDip, below_zero};
pub use composite::{Composite, CompositeError};
pub use condition::ThreeSums;
pub(crate) use condition::{WORST_CONDITION, condition_number};
pub use cube::Cube;
pub(crate) use edits::{Decomposed, ModelSpike, decompose, decompose_by};
pub use edits::{HandSpike, SpikeEdits};
pub(crate) use factor::bounces;
pub use factor::{Factor, glass};
pub use fit::Exactness;
pub(crate) use fit::InnerProducts;
pub use formula::Formula;
pub(crate) use formula::MOST_COEFFICIENTS;
pub use image::SpectralImage;
pub use kind::Kind;
pub use line::Line;
#[cfg(test)]
pub(crate) use line::LineProfile;
pub(crate) use line::{GAUSSIAN_AREA, NARROWEST_NM, add_lines, gaussian};
pub use named::NamedSpectrum;
pub(crate) use quantile::{quantile, rank};
pub use rect::Rect;
pub(crate) use region::Region;
#[cfg(test)]
pub(crate) use resampled::Resampled;
pub use resampled::{SampleGrid, Sampling};
pub use sampled::{Outside, Sampled, SampledError};
pub use series::{BasisTable, Series};
pub use spikes::{Constraints, SpikeSettings, detect, detect_shapes, narrow_dips};
pub(crate) use spikes::{Decomposition, FoundSpike, LineShape, absolute_power, window_near};
