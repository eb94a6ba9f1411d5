//! What is written, format by format.

mod argyll;
mod csv;
mod every;
mod spdx;
mod spectral_exr;
