//! Light quality: every figure a lighting person asks for, of measured light and of models.
//!
//! ```text
//! light        a light on whole nm 360-830, and lines without width beside them
//! weight       what a light is weighed by: tables on whole nm, read once from the presets
//! no_figure    why a figure does not exist, in words
//! reference    blackbodies and daylight: the reference lights of CRI, TM-30 and SSI
//! rendering    CRI: Ra and R1 to R15 (CIE 13.3)
//! appearance   CIECAM02 and its uniform space, as far as TM-30 needs them
//! fidelity     TM-30: Rf, Rg, hue bins, vector graphic (ANSI/IES TM-30-20, CIE 224)
//! hue_bin      one of the 16 hue bins
//! photometry   luminous efficacy, S/P ratio
//! absolute     what absolute values mean: lux and the like
//! alpha_opic   the five alpha-opic quantities (CIE S 026)
//! photons      PPFD and ePPFD per 100 lx
//! blue_share   power of 415-455 nm over that of all
//! dominant     dominant and complementary wavelength, purity
//! similarity   SSI (SMPTE ST 2122)
//! single       figures that are one number, each in the file of its quantity
//! sprague      the interpolation of CRI's test colours
//! test_colours test colours under a light
//! shape        peak, centroid, width at half height
//! figures      all of them of one light
//! diagram      the geometry of chromaticity diagrams as plain data
//! ```
//!
//! A light is weighed, never sampled: a line of no width counts with what a weighting function is
//! at its exact place. A figure that does not exist is a [`NoFigure`] that says why. TLCI is left
//! out: it needs camera and patch tables that are not openly licensed.

mod absolute;
mod alpha_opic;
mod appearance;
mod blue_share;
pub mod diagram;
mod dominant;
mod fidelity;
mod figures;
mod hue_bin;
mod light;
mod no_figure;
mod photometry;
mod photons;
mod reference;
mod rendering;
mod shape;
mod similarity;
mod single;
mod sprague;
mod test_colours;
mod weight;

pub(crate) use fidelity::{Fidelity, FidelityScale, fidelity_factors, sample_names};
pub(crate) use hue_bin::{HUE_NAMES, HueBin, difference_of, hue_of, index_of};
pub(crate) use rendering::{
    GENERAL, RENDERING_NAMES, Rendering, RenderingScale, rendering_difference, rendering_factors,
    rendering_index,
};

pub(crate) use absolute::Radiometric;
pub use absolute::{Measured, absolute};
pub use fidelity::fidelity;
pub(crate) use figures::Parts;
pub use figures::{FewFigures, Figures};
pub use light::{Light, POINTS};
pub use no_figure::{Dark, NoFigure};
pub(crate) use photometry::{
    EFFICACY, LUMENS_PER_WATT, LUMENS_PER_WATT_ROUNDED, SP_RATIO, luminous_efficacy,
};
pub(crate) use photons::{JOULE_NM_PER_MICROMOLE, photons_per_100_lx};
#[cfg(test)]
pub(crate) use reference::daylight_xy;
pub use reference::{Reference, fidelity_reference};
pub(crate) use reference::{daylight, daylight_factors, planck, rendering_reference};
pub use rendering::rendering;
pub use shape::shape;
pub(crate) use single::Single;

/// Every figure that is one number, in the order of reports.
pub(crate) const SINGLES: [Single; 3] = [EFFICACY, SP_RATIO, blue_share::BLUE_SHARE];
