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

pub(crate) use ansi::{QUADRANGLES, WHITE_HALF_WIDTH_DUV, quadrangle_of, white_middle_duv};
pub(crate) use gamut::GAMUTS;
#[cfg(test)]
pub(crate) use locus::uv_1960_of_cct;
pub(crate) use locus::{TICKS_K, daylight_locus, planckian_locus, spectral_locus, tick};
pub(crate) use macadam::ELLIPSES;
#[cfg(test)]
pub(crate) use plane::xy_from_uv_1960;
pub(crate) use plane::{Plane, xy_from_uv_1976};
