//! The paper's claims, measured again on the spectrum and range at hand.
//!
//! Source: Sun, Fracchia, Drew, "A Composite Spectral Model and Its Applications". Each claim has
//! the paper's own figure as a `Stated` and a function that measures the same thing here:
//!
//! ```text
//! five_percent   terms beyond N contribute under 5 %              Eq. 12
//! samples        400 samples against about 20 numbers             storage of spectral images
//! eq_17          the factor at a spike by a straight line         Eq. 17, its weights swapped
//! table_2        three colour-matching functions as four bells    Table 2, Eq. 9
//! resampling     a product takes 2N+2 multiplications             Eq. 16
//! ```
//!
//! Colour differences are CIEDE2000 against the white that the caller names (the exact light) and
//! `None` where there is no colour: no light in the visible part of the range.

mod eq_17;
mod five_percent;
mod resampling;
mod samples;
mod table_2;
#[cfg(test)]
mod tests;

pub(in crate::study) use eq_17::cut;
pub(crate) use eq_17::{Eq17, SpikeReading, StraightLine, eq_17, straight_line};
pub(crate) use five_percent::{FivePercent, Neglected, five_percent};
pub(crate) use resampling::{Resampling, ResamplingWay, resampling};
pub use samples::samples;
pub(crate) use samples::{Match, Question, SampledErrors, SamplesAgainstNumbers};
pub(crate) use table_2::{Table2, table_2};

use crate::color::gaussian_cmf::NEGLIGIBLE_SHARE;

/// A figure that the paper states, and where.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stated {
    /// The figure, in the unit its constant names.
    pub figure: f64,
    /// Equation, table or section of the paper.
    pub place: &'static str,
}

const fn stated(figure: f64, place: &'static str) -> Stated {
    Stated { figure, place }
}

/// Share of the first term below which a term is neglected, 0-1.
pub(crate) const STATED_SHARE: Stated = stated(NEGLIGIBLE_SHARE, "Eq. 12");

/// The order after which terms are negligible (11 numbers), for a range of 300 nm.
pub(crate) const STATED_ORDER: Stated = stated(
    5.0,
    "Sufficiency of a Low-Dimensional Representation, after Eq. 12",
);

/// Samples from 380 to 780 nm "to avoid missing any spikes".
pub(crate) const STATED_SAMPLES: Stated = stated(400.0, STORAGE);

/// Numbers that do the same: [`STATED_BACKGROUND`] and [`STATED_SPIKE_NUMBERS`].
pub(crate) const STATED_NUMBERS: Stated = stated(TOTAL_NUMBERS as f64, STORAGE);

/// Numbers for the smooth background.
pub(crate) const STATED_BACKGROUND: Stated =
    stated((TOTAL_NUMBERS - 2 * MOST_SPIKES) as f64, STORAGE);

/// Numbers for the spikes, two each.
pub(crate) const STATED_SPIKE_NUMBERS: Stated = stated((2 * MOST_SPIKES) as f64, STORAGE);

/// The green mercury line that Eq. 17 is tried on, in nm.
pub(crate) const STATED_LINE_NM: Stated = stated(546.1, "Table 4");

const STORAGE: &str = "Storage and Communication of Spectral Images";
const TOTAL_NUMBERS: usize = 20;
const MOST_SPIKES: usize = 4;

/// Multiplications of a product of two smooth spectra of order N, as Eq. 16 counts them: one for
/// each of the 2N+2 points, of which the last equals the first.
pub(crate) fn stated_multiplications(order: usize) -> Stated {
    stated((2 * order + 2) as f64, "Eq. 16")
}
