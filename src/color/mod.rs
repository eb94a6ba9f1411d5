//! From spectrum to colour: numbers only, no files, no window.
//!
//! ```text
//! observer      colour-matching functions and other weighting tables
//! weights       what weighs a spectrum to X, Y, Z on a grid, and a line exactly where it stands
//! xyz           tristimulus values: CIE sums over 360-830 nm, or through any `integrate`
//! chromaticity  xy, CIE 1976 u'v', CIE 1960 uv
//! lab           CIE 1976 L*a*b* against a white
//! ciede2000     colour difference
//! srgb          what a screen shows: IEC 61966-2-1, and how colours outside it are mapped
//! dichromat     colours as a colour-blind eye sees them
//! adaptation    Bradford chromatic adaptation, for "adapt to the light"
//! cct           correlated colour temperature and Duv (Ohno)
//! blackbody     Planck's law
//! gaussian_cmf  the paper's Gaussian fit of the colour-matching functions: why few terms suffice
//! patches       many reflectances under one light, fast enough for a slider
//! wavelength_rgb  the colours under a wavelength axis
//! matrix        3x3 arithmetic that works in constants
//! quality       every figure a lighting person asks for
//! ```
//!
//! Units: wavelengths in nm, temperatures in kelvin, XYZ in whatever scale the caller states
//! (the CIE sums return Y = 100). Nothing here returns NaN: where a quantity does not exist the
//! answer is `None` or an error that says why in words.

mod adaptation;
pub mod blackbody;
mod cct;
mod chromaticity;
mod ciede2000;
mod dichromat;
pub(crate) mod gaussian_cmf;
mod lab;
mod matrix;
mod observer;
pub mod patches;
pub mod quality;
pub(crate) mod srgb;
mod wavelength_rgb;
mod weights;
pub mod xyz;

pub use adaptation::Adaptation;
pub(crate) use adaptation::{Adapter, adapted};
pub use cct::Cct;
pub(crate) use cct::{NoCct, cct_from_xyz, uv_1960_from_kelvin};
pub use chromaticity::xy_from_xyz;
pub(crate) use chromaticity::{uv_1960_from_xyz, uv_1976_from_xyz, xyz_from_xy};
pub use ciede2000::{delta_e_2000, delta_e_of_xyz};
pub use dichromat::MissingCones;
pub(crate) use lab::{LAB_EPSILON, LAB_KAPPA, xyz_from_lab};
pub use lab::{Lab, lab_from_xyz};
pub use observer::{ColourMatching, Observer, ObserverError, weighting};
pub use patches::PatchSet;
#[cfg(test)]
pub(crate) use srgb::Mapping;
pub use srgb::Srgb;
pub(crate) use srgb::Swatch;
pub(crate) use wavelength_rgb::{srgb_from_wavelength, srgb_from_wavelength_over, srgb_of_fill};
pub(crate) use weights::Weights;
#[cfg(test)]
pub(crate) use xyz::xyz_from_integral;
pub use xyz::{Xyz, xyz_from_light, xyz_from_reflectance};
pub(crate) use xyz::{xyz_of_lines, xyz_of_one, xyz_of_parts};
