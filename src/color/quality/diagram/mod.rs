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

pub use ansi::{QUADRANGLES, Quadrangle, WHITE_HALF_WIDTH_DUV, quadrangle_of, white_middle_duv};
pub use gamut::{GAMUTS, Gamut};
pub use locus::{
    LocusPoint, TICKS_K, Tick, daylight_locus, planckian_locus, spectral_locus, tick,
    uv_1960_of_cct,
};
pub use macadam::{ELLIPSES, Ellipse};
pub use plane::{Plane, uv_1976_from_xy, xy_from_uv_1960, xy_from_uv_1976};
