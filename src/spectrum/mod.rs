//! What a spectrum is: numbers only, no files, no colour, no window.
//!
//! Wavelengths are `f64` nanometres in air as tabulated, values are in the spectrum's own unit,
//! and everything that models a spectrum works on the 1 nm grid of a [`Band`].

pub mod band;
pub mod basis;
pub mod composite;
pub mod kind;
pub mod named;
pub mod sampled;

pub use band::Band;
pub use basis::{Basis, BasisTable, Series};
pub use composite::{Composite, Spike};
pub use kind::Kind;
pub use named::NamedSpectrum;
pub use sampled::{Outside, Sampled};
