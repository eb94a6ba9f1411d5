//! The geometry of chromaticity diagrams as plain data.
//!
//! ```text
//! plane       xy and u'v', and the ways between them and CIE 1960 uv
//! locus       the spectral locus, blackbodies with their ticks, daylight
//! ansi        quadrangles of ANSI C78.377 for white light
//! macadam     MacAdam's 25 ellipses
//! gamut       sRGB, P3, Rec. 2020
//! ```
//!
//! Everything is of the CIE 1931 observer but the locus, which every observer has.

mod ansi;
mod gamut;
mod locus;
mod macadam;
mod plane;

pub use ansi::{QUADRANGLES, Quadrangle};
pub(crate) use ansi::{WHITE_HALF_WIDTH_DUV, quadrangle_of, white_middle_duv};
pub use gamut::{GAMUTS, Gamut};
pub(crate) use locus::TICKS_K;
pub use locus::{
    LocusPoint, Tick, daylight_locus, planckian_locus, spectral_locus, tick, uv_1960_of_cct,
};
pub use macadam::{ELLIPSES, Ellipse};
pub use plane::{Plane, xy_from_uv_1960};
