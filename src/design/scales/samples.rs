//! The tables of test colours that rendering and fidelity are judged by.

use std::sync::LazyLock;

use super::{fits, sample_rows};
use crate::color::{
    Observer,
    quality::{GENERAL, fidelity_factors, rendering_factors},
};

/// Test colours, weighed by the colour-matching functions at each whole nm of 360-830.
#[derive(Clone, Debug, PartialEq)]
pub struct SampleTables {
    /// X, Y, Z (CIE 1931) of each sample and of the light itself, nm after nm.
    pub(super) rendering: Vec<f64>,
    /// The same of the samples of TM-30 (CIE 1964, 380-780 nm).
    pub(super) fidelity: Vec<f64>,
}

impl SampleTables {
    /// From reflectances on whole nm 360-830 (471 values of 0-1 each): the first eight test
    /// colours of CIE 13.3, and the samples of TM-30. `None` for other numbers of values, fewer
    /// than eight test colours or no sample.
    pub fn new(rendering: &[Vec<f64>], fidelity: &[Vec<f64>]) -> Option<Self> {
        let rendering = rendering.get(..GENERAL).filter(|tables| fits(tables))?;
        let fidelity = Some(fidelity).filter(|tables| !tables.is_empty() && fits(tables))?;
        Some(Self {
            rendering: sample_rows(rendering, Observer::CIE_1931, 360, 830),
            fidelity: sample_rows(fidelity, Observer::CIE_1964, 380, 780),
        })
    }

    /// The tables of the page Quality and the command `light`, so that the figures of a designed
    /// light are those of the same spectrum there; read at the first call.
    pub fn shipped() -> &'static Self {
        &SHIPPED_TABLES
    }
}

static SHIPPED_TABLES: LazyLock<SampleTables> = LazyLock::new(|| {
    let found = SampleTables::new(rendering_factors(), &fidelity_factors());
    found.expect("shipped files, read in a test of the presets")
});
