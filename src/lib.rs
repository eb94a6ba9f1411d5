//! Light spectra as a short series and a few lines: a library, a command line and a window.
//!
//! A spectrum of several hundred values is split into a smooth part (a Fourier or cosine series)
//! and a few lines, each a place, a weight and perhaps a width: a [`spectrum::Composite`]. Some
//! twenty numbers then keep the colour exactly, multiply with surfaces and filters in closed form,
//! and keep every line at its own wavelength.
//!
//! ```
//! use spectral_explorer::{
//!     color::{Observer, xy_from_xyz},
//!     lamps::FitOptions,
//!     preset,
//!     spectrum::Composite,
//! };
//!
//! let lamp = preset::table("cie_fluorescent_1nm", "FL2").expect("a shipped lamp");
//! let fit = Composite::fit(lamp, &FitOptions::default());
//! let [x, y] = xy_from_xyz(fit.composite.xyz(Observer::CIE_1931)).expect("it shines");
//! println!("{} numbers instead of {}", fit.composite.numbers(), lamp.nm().len());
//! assert!((x - 0.372).abs() < 0.001 && (y - 0.375).abs() < 0.001);
//! ```
//!
//! The verbs: [`spectrum::Composite::fit`], [`spectrum::Composite::times`],
//! [`spectrum::Composite::xyz`], [`spectrum::Composite::integrate`],
//! [`spectrum::Composite::on_band`]; files by [`io::read_path`]; light quality by
//! [`color::quality::FewFigures`]. Three short programs stand in `examples`.
//!
//! Limits: wavelengths are nm in air, models stand on whole nm of a band of at least 20 nm, values
//! are in the spectrum's own unit and never rescaled in silence, colours are of the observer that
//! is named.
//!
//! # Rooms
//!
//! ```text
//! languages  what a person reads, translated    catalogs numbers
//! spectrum   what a spectrum is                 band sampled basis spikes composite product chain
//! preset     the shipped spectra's file format, read once
//! color      from spectrum to colour            observer xyz lab ciede2000 srgb cct patches quality
//! rivals     the other representations          samples bins legendre principal moments wavelet
//! study      accuracy against numbers           error sweep auction race truth products quality
//! design     making lights and spectra          recover mixture solve scales
//! lamps      lights in few words                encoder decoder known lamps, wide lines, their race
//! optics     light through things               index prism rainbow gem film
//! measurements  one's own measurements          combine repeats doubt splice changed
//! photographs  a photograph of a spectrum       strip profile peaks axis
//! io         files <-> spectra, one format a file
//! streams    spectra that change             file folder lines serial replay
//! live       what is shown of a stream          hold average dark reference peak tracks
//! pictures   spectral pictures in few numbers   survey choose operator relight full compact fit
//! app        what the program is doing          document command derived state report export
//! ui         what it looks like                 one view a file; egui only here
//! cli        the same engine without a window   one command a file
//! ```
//!
//! Imports point one way: `main -> {ui, cli} -> app -> {design, lamps, optics, measurements, photographs,
//! pictures, live} -> study -> {rivals, color} -> {spectrum, preset}`, and
//! `{pictures, live, app} -> {io, streams} -> spectrum`, `streams -> io`; every room may
//! speak (`languages`).
//! docs/map.md tells of every folder. The feature `window`, on by default, builds `ui`.
//!
//! The composite model is that of Sun, Fracchia and Drew, "A Composite Spectral Model and Its
//! Applications" (2000); its misprints are corrected and each correction is tested.
//!
//! Out of scope: fluorescence and scattering. What light meets is one factor for each wavelength;
//! only `optics` bends it, in clear bodies, and knows of polarisation at single faces alone.

#![cfg_attr(
    not(feature = "window"),
    allow(dead_code, unused_imports, reason = "what the window alone calls")
)]

#[macro_use]
pub mod languages;

pub mod app;
pub mod cli;
pub mod color;
pub mod design;
pub mod io;
pub mod lamps;
pub mod live;
pub mod measurements;
pub mod optics;
pub mod photographs;
pub mod pictures;
pub mod preset;
pub mod rivals;
pub mod spectrum;
pub mod streams;
pub mod study;
#[cfg(feature = "window")]
pub mod ui;
#[cfg(all(target_arch = "wasm32", feature = "window"))]
pub mod web;

// Tests of the core that need its inside: as a program of their own they would make all of it public.
#[cfg(test)]
extern crate self as spectral_explorer;
#[cfg(test)]
#[path = "../tests/core/mod.rs"]
mod core_tests;
