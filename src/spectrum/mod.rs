//! What a spectrum is: numbers only, no files, no colour, no window.
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
mod spikes;

pub use air::in_air;
pub use air::in_vacuum;
pub(crate) use air::{SHORTEST_IN_AIR_NM, index_of_air, slope_of_air};
pub use band::{Band, BandError, LONGEST_NM, MOST_STEPS, SHORTEST_NM, dot};
pub use basis::{Basis, BasisTable, Series, numbers_of_order};
pub use chain::{ChainTables, LineInDip, SAME_PLACE_NM, Stage, below_zero};
pub use composite::{Composite, CompositeError};
pub(crate) use condition::WORST_CONDITION;
pub use condition::{ThreeSums, condition_number};
pub use cube::Cube;
pub use edits::{Decomposed, HandSpike, ModelSpike, SpikeEdits};
pub(crate) use edits::{decompose, decompose_by};
pub use factor::{Factor, bounces, glass};
pub use fit::{Exactness, InnerProducts};
pub use formula::{Formula, MOST_COEFFICIENTS};
pub use image::SpectralImage;
pub use kind::Kind;
pub use line::{GAUSSIAN_AREA, Line, LineProfile, add_lines};
pub(crate) use line::{NARROWEST_NM, gaussian};
pub use named::NamedSpectrum;
pub(crate) use quantile::quantile;
pub use quantile::rank;
pub use rect::Rect;
pub use region::Region;
pub use resampled::{Resampled, SampleGrid, Sampling};
pub use sampled::{Outside, Sampled, SampledError};
pub use spikes::{
    Decomposition, FoundSpike, LineShape, SpikeSettings, Wishes, detect, detect_shapes,
};
pub(crate) use spikes::{absolute_power, window_near};
