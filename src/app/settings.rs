//! The model's knobs: one small value, clamped in one place.

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use crate::{
    color::Observer,
    spectrum::{Band, Basis, Composite, Sampling, SpikeSettings, gradient::DEFAULT_GRADIENT},
};

/// Orders that may be asked for.
pub const ORDERS: RangeInclusive<usize> = 0..=100;
/// Spike thresholds in percent of the total power.
pub const THRESHOLDS_PERCENT: RangeInclusive<f64> = 0.01..=50.0;
/// Widest lines in nm.
pub const WIDTHS_NM: RangeInclusive<f64> = 1.0..=50.0;
/// Slopes of the gradient detector, in percent of the maximum per nm.
pub const GRADIENTS_PERCENT: RangeInclusive<f64> = 0.1..=50.0;

/// The nearest value that a range allows; the usual one for what is not a number.
pub(super) fn within(value: f64, range: RangeInclusive<f64>, usual: f64) -> f64 {
    if value.is_nan() {
        usual
    } else {
        value.clamp(*range.start(), *range.end())
    }
}

/// What is said where another range is taken than the one that was asked for; `None` where it is
/// the same.
pub fn range_words(asked: [f64; 2], taken: Band) -> Option<String> {
    let refused = Band::try_from(asked).err()?;
    let [min_nm, max_nm] = <[f64; 2]>::from(taken);
    Some(format!(
        "The model's {refused}; {min_nm} to {max_nm} nm is taken."
    ))
}

/// Which spike detector runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Detector {
    /// Prominence proposes, energy decides: the program's own.
    Energy,
    /// The paper's: steep on both sides.
    Gradient,
}

/// Everything that decides what the model of a spectrum is.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Settings {
    /// Functions of the smooth part.
    pub basis: Basis,
    /// Order `N`; the smooth part takes `2N + 1` numbers.
    pub order: usize,
    /// Whether lines are taken out as spikes at all.
    pub spikes: bool,
    /// Each line as wide as it is, instead of the paper's ideal spike.
    pub wide_lines: bool,
    /// Least share of the power a spike must carry, percent.
    pub threshold_percent: f64,
    /// Widest line, full width at half maximum, nm.
    pub max_width_nm: f64,
    /// Look for absorption lines too.
    pub dips: bool,
    /// Which detector runs.
    pub detector: Detector,
    /// The gradient detector's slope, percent of the maximum per nm.
    pub gradient_percent: f64,
    /// Make the light's own X, Y, Z exact.
    pub colour_exact: bool,
    /// Range of the model.
    pub band: Band,
    /// Whose colour-matching functions.
    pub observer: Observer,
    /// How products with reflectances are formed.
    pub sampling: Sampling,
}

/// What the window starts with and what every command takes without a word about it: the one place
/// that says so.
impl Default for Settings {
    fn default() -> Self {
        Self {
            basis: Basis::Cosine,
            order: 7,
            spikes: true,
            wide_lines: false,
            threshold_percent: 0.5,
            max_width_nm: 10.0,
            dips: false,
            detector: Detector::Energy,
            gradient_percent: 100.0 * DEFAULT_GRADIENT,
            colour_exact: true,
            band: Band::VISIBLE,
            observer: Observer::CIE_1931,
            sampling: Sampling::Exact,
        }
    }
}

impl Settings {
    /// The default with the paper's plain series.
    pub fn plain() -> Self {
        Self::default().as_in_paper()
    }

    /// These with the paper's series: Fourier, by plain least squares.
    #[must_use]
    pub fn as_in_paper(self) -> Self {
        Self {
            basis: Basis::Fourier,
            colour_exact: false,
            ..self
        }
    }

    /// Every value moved to the nearest one that is allowed; what is not a number becomes the
    /// default.
    #[must_use]
    pub fn clamped(self) -> Self {
        let default = Self::default();
        Self {
            order: self.order.clamp(*ORDERS.start(), *ORDERS.end()),
            threshold_percent: within(
                self.threshold_percent,
                THRESHOLDS_PERCENT,
                default.threshold_percent,
            ),
            max_width_nm: within(self.max_width_nm, WIDTHS_NM, default.max_width_nm),
            gradient_percent: within(
                self.gradient_percent,
                GRADIENTS_PERCENT,
                default.gradient_percent,
            ),
            ..self
        }
    }

    /// These with series, range and lines as a composite has them: it is shown as it is.
    #[must_use]
    pub fn of_composite(self, composite: &Composite) -> Self {
        Self {
            basis: composite.smooth().basis,
            order: composite.smooth().order(),
            band: composite.band(),
            spikes: true,
            wide_lines: composite.lines().iter().any(|line| !line.is_ideal()),
            colour_exact: false,
            ..self
        }
    }

    /// These with what [`of_composite`](Self::of_composite) replaced as others have it.
    #[must_use]
    pub fn with_model_of(self, other: Self) -> Self {
        Self {
            basis: other.basis,
            order: other.order,
            band: other.band,
            spikes: other.spikes,
            wide_lines: other.wide_lines,
            colour_exact: other.colour_exact,
            ..self
        }
    }

    /// These with every part of the model that differs between `was` and `moved` as moved.
    #[must_use]
    pub fn with_moves(self, was: Self, moved: Self) -> Self {
        fn either<T: PartialEq>(own: T, was: T, moved: T) -> T {
            if moved == was { own } else { moved }
        }
        Self {
            basis: either(self.basis, was.basis, moved.basis),
            order: either(self.order, was.order, moved.order),
            band: either(self.band, was.band, moved.band),
            spikes: either(self.spikes, was.spikes, moved.spikes),
            wide_lines: either(self.wide_lines, was.wide_lines, moved.wide_lines),
            colour_exact: either(self.colour_exact, was.colour_exact, moved.colour_exact),
            ..self
        }
    }

    /// Whether nothing is looked for otherwise: the same range, series and lines. The order only
    /// cuts a series, and colour-exact moves what is there.
    pub fn takes_apart_as(self, other: Self) -> bool {
        let rest = Self {
            order: other.order,
            colour_exact: other.colour_exact,
            observer: other.observer,
            sampling: other.sampling,
            ..self
        };
        rest == other
    }

    /// The order that the band's grid can carry.
    pub fn effective_order(self) -> usize {
        self.order.min(Basis::highest_order(self.band))
    }

    /// What the default detector is asked for.
    pub fn spike_settings(self) -> SpikeSettings {
        SpikeSettings {
            threshold: self.threshold_percent / 100.0,
            max_width_nm: self.max_width_nm,
            dips: self.dips,
        }
    }
}
