//! The model's knobs: one small value, each number of it a row.

use serde::{Deserialize, Serialize};

use super::{
    pages::knob::{Knob, Reach, keep_in_reach, knob},
    ticks::short,
};
use crate::{
    color::Observer,
    spectrum::{Band, Basis, Composite, Sampling, SpikeSettings, gradient::DEFAULT_GRADIENT},
};

/// What is said where another range is taken than the one that was asked for; `None` where it is
/// the same.
pub fn range_words(asked: [f64; 2], taken: Band) -> Option<String> {
    let refused = Band::try_from(asked).err()?;
    let [min_nm, max_nm] = <[f64; 2]>::from(taken);
    Some(tr!(
        "The model's {refused}; {min} to {max} nm is taken.",
        refused,
        min = short(min_nm),
        max = short(max_nm)
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
    pub const ORDER: Knob<Self> = knob!(order: later!("waves"), Reach::Within(0.0, 100.0), 0 "",
        later!("Waves of the smooth part."));
    pub const THRESHOLD: Knob<Self> = knob!(threshold_percent: later!("lines above"),
        Reach::Within(0.01, 50.0), 2 " %",
        later!("Least share of the total power that a line must carry, percent."));
    pub const WIDTH: Knob<Self> = knob!(max_width_nm: later!("widest line"),
        Reach::Within(1.0, 50.0), 2 " nm",
        later!("Full width at half maximum of the widest line, nm."));
    pub const GRADIENT: Knob<Self> = knob!(gradient_percent: later!("least slope of lines"),
        Reach::Within(0.1, 50.0), 2 " %/nm",
        later!("Least slope of a line's flanks, percent of the largest value per nm."));

    /// Its numbers, each with its option on the command line; "" where it has none.
    pub const KNOBS: [(&str, Knob<Self>); 4] = [
        ("order", Self::ORDER),
        ("threshold", Self::THRESHOLD),
        ("max-width", Self::WIDTH),
        ("", Self::GRADIENT),
    ];

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
    pub fn clamped(mut self) -> Self {
        for (_, knob) in Self::KNOBS {
            keep_in_reach(&[knob], &mut self);
        }
        self
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
