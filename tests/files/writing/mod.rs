//! What is written, format by format.

mod argyll;
mod atomic;
mod colour_png;
mod csv;
mod every;
mod spdx;
mod spectral_exr;
