//! Spectral Explorer: light spectra as a short Fourier series and a few spikes.
//!
//! ```text
//! spectrum   what a spectrum is                 band sampled basis spikes composite product chain
//! preset     the shipped spectra's file format, read once
//! color      from spectrum to colour            observer xyz lab ciede2000 srgb cct patches quality
//! rivals     the other representations          samples bins legendre principal moments wavelet
//! study      accuracy against numbers           error sweep auction race truth products quality
//! io         files <-> spectra, one format a file
//! app        what the program is doing          document command derived state report export
//! ui         what it looks like                 one view a file; egui only here
//! cli        the same engine without a window   one command a file
//! ```
//!
//! Imports point one way: `main -> {ui, cli} -> app -> study -> {rivals, color} -> {spectrum,
//! preset}`, and `io -> spectrum`. docs/map.md tells of every folder. The feature `window`, on by
//! default, builds `ui`.
//!
//! The composite model is that of Sun, Fracchia and Drew, "A Composite Spectral Model and Its
//! Applications" (2000); its misprints are corrected and each correction is tested.
//!
//! Out of scope: fluorescence, polarisation and scattering. What light meets is one factor for each
//! wavelength.

pub mod app;
pub mod cli;
pub mod color;
pub mod io;
pub mod preset;
pub mod rivals;
pub mod spectrum;
pub mod study;
#[cfg(feature = "window")]
pub mod ui;
