//! Is this light that one off this surface? The paper's verification equation S3 = S1 S2.
//!
//! Everything is as the model has it: the light S1 and what comes from the surface S3 as
//! composites, the reflectance S2 as a series of as many numbers. The product is formed on twice
//! the numbers, where it is exact, and cut to the numbers of S3, which could hold no more. A line
//! that is a spike on one side and was too weak for one on the other is given to the smooth part
//! on both. Both are compared behind a 10 nm blur up to a factor: how much of the light goes which
//! way is geometry and says nothing about the surface.

use crate::{
    spectrum::{
        Band, BasisTable, Composite, Line, Sampling, Series,
        product::{multiply, resampled},
    },
    study::error::{BLUR_NM, Blur, height, spikes_times, times},
};

/// Largest residual that still counts as the same light.
///
/// Chosen on shipped lights of all kinds off 15 of the 99 colour evaluation samples, N = 7: up to
/// here the right surface passes in 95 cases of 100 and a wrong one in 2, nearly all of these
/// under sodium lamps, whose one line looks alike off every surface. `tests/core/products_chain.rs`
/// prints the figures.
pub const SAME_RESIDUAL: f64 = 0.1;

/// Goodness of fit of a spectrum as a light off a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reflection {
    /// Relative RMS behind a 10 nm blur of what the best factor leaves.
    pub residual: f64,
    /// That factor.
    pub factor: f64,
}

impl Reflection {
    /// The verdict: the residual is at most [`SAME_RESIDUAL`], and no light has turned negative.
    pub(crate) fn holds(self) -> bool {
        self.residual <= SAME_RESIDUAL && self.factor > 0.0
    }
}

/// Verdict of the check.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sameness {
    /// The spectrum is the light off the surface.
    Holds,
    /// It is not.
    DoesNotHold,
    /// The models are too short to tell, or there is no light to compare.
    Unknown,
}

impl Sameness {
    /// The verdict on a check, or on none.
    ///
    /// `left_out` is what the models of light and outgoing spectrum leave out themselves: the sum
    /// of their relative RMS errors behind the same blur, 0 for measured curves. A residual that
    /// is above the threshold by no more than that may come from the models alone.
    pub fn of(check: Option<Reflection>, left_out: f64) -> Self {
        match check {
            Some(check) if check.holds() => Self::Holds,
            Some(check) if check.factor > 0.0 && check.residual - left_out <= SAME_RESIDUAL => {
                Self::Unknown
            }
            Some(_) => Self::DoesNotHold,
            None => Self::Unknown,
        }
    }

    /// In words, as they also stand in JSON.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => later!("holds"),
            Self::DoesNotHold => later!("does not hold"),
            Self::Unknown => later!("cannot be said"),
        }
    }

    /// In words for people.
    pub fn told(self) -> &'static str {
        match self {
            Self::Unknown => later!("undecided"),
            Self::Holds | Self::DoesNotHold => self.words(),
        }
    }

    /// A sign that goes before the words.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Holds => "✔",
            Self::DoesNotHold => "✘",
            Self::Unknown => "?",
        }
    }
}

/// The two curves that were compared and what came of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// Residual and factor.
    pub reflection: Reflection,
    /// Light times surface behind the blur, times the factor, on the grid. Both curves are in
    /// shares of the largest value of the outgoing spectrum.
    pub expected: Vec<f64>,
    /// The outgoing spectrum behind the blur.
    pub found: Vec<f64>,
}

/// A light and an outgoing spectrum in the model's numbers, ready for any surface.
#[derive(Clone, Debug)]
pub(crate) struct Checker<'a> {
    light: &'a Composite,
    outgoing: &'a Composite,
    table: BasisTable,
    blur: Blur,
}

impl<'a> Checker<'a> {
    /// Both composites share band and basis.
    pub(crate) fn new(light: &'a Composite, outgoing: &'a Composite) -> Self {
        let (band, numbers) = (light.band(), light.smooth().coefficients.len());
        Self {
            light,
            outgoing,
            table: BasisTable::new(band, light.smooth().basis, numbers),
            blur: Blur::new(band, BLUR_NM),
        }
    }

    /// Tests `outgoing = light x reflectance` (reflectance on the band's grid); `None` when one
    /// of them is dark.
    ///
    /// # Panics
    /// When `reflectance` does not have [`Band::points`] values.
    pub(crate) fn against(&self, reflectance: &[f64]) -> Option<Compared> {
        let (light, outgoing) = (self.light, self.outgoing);
        let surface = Series {
            coefficients: self.table.project(reflectance, self.table.numbers()),
            ..light.smooth().clone()
        };
        let product = resampled(light, &surface, Sampling::Double);
        let product = product.truncated(outgoing.smooth().coefficients.len());
        let expected = blurred(&self.blur, &shared_lines(&product, outgoing))?;
        let found = blurred(&self.blur, &shared_lines(outgoing, &product))?;
        compared(light.band(), expected, found)
    }
}

/// Tests `outgoing = light x reflectance` on measured curves on the band's grid, behind the blur of
/// [`Checker`].
///
/// `None` when one of them is dark.
pub(crate) fn measured_check(
    band: Band,
    light: &[f64],
    reflectance: &[f64],
    outgoing: &[f64],
) -> Option<Compared> {
    let blur = Blur::new(band, BLUR_NM);
    let one = |values: &[f64]| {
        let unit = height(values)?;
        Some((blur.values(&times(values, unit)), unit))
    };
    compared(band, one(&multiply(light, reflectance))?, one(outgoing)?)
}

/// Finds the best factor between two curves, each given with what it was multiplied by.
fn compared(
    band: Band,
    (expected, expected_unit): (Vec<f64>, f64),
    (found, found_unit): (Vec<f64>, f64),
) -> Option<Compared> {
    let (own, whole) = (band.inner(&expected, &expected), band.inner(&found, &found));
    let scale = band.inner(&expected, &found) / own;
    let expected = times(&expected, scale);
    let rest: Vec<f64> = found.iter().zip(&expected).map(|(f, e)| f - e).collect();
    let reflection = Reflection {
        residual: (band.inner(&rest, &rest) / whole).sqrt(),
        // Both were brought to 1 at their highest.
        factor: scale * expected_unit / found_unit,
    };
    let is_sound = reflection.residual.is_finite() && reflection.factor.is_finite();
    is_sound.then_some(Compared {
        reflection,
        expected,
        found,
    })
}

/// Two spikes closer than this stand for the same line, nm: the detector's centroid moves with
/// the slope of what multiplies the line.
const SAME_LINE_NM: f64 = 4.0;

/// A composite with the spikes that the other one lacks projected into its smooth part, whose
/// coefficients gain what a delta has of each function.
fn shared_lines(composite: &Composite, other: &Composite) -> Composite {
    let (band, basis) = (composite.band(), composite.smooth().basis);
    let is_shared = |spike: &Line| {
        let close = |twin: &Line| (twin.at_nm - spike.at_nm).abs() <= SAME_LINE_NM;
        other.lines().iter().any(close)
    };
    let (spikes, lone): (Vec<Line>, Vec<Line>) =
        composite.lines().iter().copied().partition(is_shared);
    let mut smooth = composite.smooth().clone();
    for (k, c) in smooth.coefficients.iter_mut().enumerate() {
        let norm = basis.norm_squared(k, band);
        for spike in &lone {
            *c += spike.weight * basis.function(k, band, spike.at_nm) / norm;
        }
    }
    Composite::of_lines_inside(smooth, spikes)
}

/// A composite behind a blur, on the grid, as shares of its largest value, and what it was
/// multiplied by for that; `None` in the dark.
fn blurred(blur: &Blur, composite: &Composite) -> Option<(Vec<f64>, f64)> {
    let unit = height(&composite.on_band())?;
    let mut values = blur.values(&times(&composite.smooth().on_band(), unit));
    blur.add_lines(&spikes_times(composite.lines(), unit), &mut values);
    Some((values, unit))
}
