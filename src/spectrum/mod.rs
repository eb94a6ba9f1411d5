//! What a spectrum is: numbers only, no files, no colour, no window.
//!
//! Wavelengths are `f64` nanometres in air as tabulated, values are in the spectrum's own unit,
//! and everything that models a spectrum works on the 1 nm grid of a [`Band`].

pub mod band;
pub mod basis;
pub mod chain;
pub mod composite;
pub mod cube;
pub mod edits;
pub mod factor;
pub mod fit;
pub mod gradient;
mod image;
mod kind;
mod named;
mod noise;
mod on_grid;
pub mod product;
mod rect;
mod region;
mod resampled;
pub mod sampled;
pub mod spikes;

pub use band::Band;
pub use basis::{Basis, BasisTable, Series};
pub use chain::{ChainTables, Stage};
pub use composite::{Composite, Spike};
pub use cube::Cube;
pub use edits::{Decomposed, HandSpike, ModelSpike, SpikeEdits};
pub use factor::Factor;
pub use fit::{Exactness, InnerProducts};
pub use image::SpectralImage;
pub use kind::Kind;
pub use named::NamedSpectrum;
pub use rect::Rect;
pub use region::Region;
pub use resampled::{Resampled, SampleGrid, Sampling};
pub use sampled::{Outside, Sampled};
pub use spikes::SpikeSettings;
