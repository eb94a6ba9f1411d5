//! A measured spectrum: the table as it was read, never splined.

use std::sync::{Arc, OnceLock};

use crate::languages::with_sign;

use super::{band::Band, formula::Formula};

/// Extrapolation of a table beyond its first and last wavelength.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Outside {
    /// Zero: a light emits nothing where nothing was measured.
    Zero,
    /// The end value is held: a reflectance goes on as it was.
    Hold,
}

/// Strictly rising wavelengths (nm) with one finite value each; at least two points.
///
/// Between two samples the spectrum is a straight line (CIE 15 recommends linear interpolation
/// for 1-5 nm tables of light sources).
///
/// Spectra of one table share their wavelengths in memory (`Sampled::sharing`).
#[derive(Clone, Debug, PartialEq)]
pub struct Sampled {
    axis: Arc<Axis>,
    values: Vec<f64>,
    formula: Option<Arc<Formula>>,
}

/// Wavelengths, and their median step once somebody asked for it.
#[derive(Debug)]
struct Axis {
    nm: Vec<f64>,
    step_nm: OnceLock<f64>,
    is_even: OnceLock<bool>,
}

impl PartialEq for Axis {
    fn eq(&self, other: &Self) -> bool {
        self.nm == other.nm
    }
}

/// Why a table is not a spectrum.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SampledError {
    /// Wavelengths and values differ in number.
    #[error(
        "{}",
        tr!(
            "expected one value per wavelength, found {wavelengths} wavelengths and {values} \
             values",
            wavelengths,
            values
        )
    )]
    Lengths { wavelengths: usize, values: usize },
    /// Fewer than two points.
    #[error("{}", tr!("expected at least 2 points, found {found}", found))]
    TooFew { found: usize },
    /// A wavelength or a value is not a finite number (`index` counts from 0).
    #[error("{}", tr!("point {number}: expected finite numbers", number = index + 1))]
    NotFinite { index: usize },
    /// A wavelength does not exceed the one before it (`index` counts from 0).
    #[error(
        "{}",
        tr!(
            "point {number}: expected a wavelength above {after} nm, found {found} nm",
            number = index + 1,
            after = with_sign(after_nm.to_string()),
            found = with_sign(found_nm.to_string())
        )
    )]
    NotRising {
        index: usize,
        found_nm: f64,
        after_nm: f64,
    },
}

impl Sampled {
    /// A spectrum from wavelengths in nm and values in the spectrum's own unit.
    ///
    /// # Errors
    /// [`SampledError`] when the lengths differ, there are fewer than two points, a number is not
    /// finite, or the wavelengths do not rise strictly.
    pub fn new(nm: Vec<f64>, values: Vec<f64>) -> Result<Self, SampledError> {
        if nm.len() != values.len() {
            return Err(SampledError::Lengths {
                wavelengths: nm.len(),
                values: values.len(),
            });
        }
        if nm.len() < 2 {
            return Err(SampledError::TooFew { found: nm.len() });
        }
        for (index, (w, v)) in nm.iter().zip(&values).enumerate() {
            if !w.is_finite() || !v.is_finite() {
                return Err(SampledError::NotFinite { index });
            }
            if index > 0 && *w <= nm[index - 1] {
                return Err(SampledError::NotRising {
                    index,
                    found_nm: *w,
                    after_nm: nm[index - 1],
                });
            }
        }
        let axis = Arc::new(Axis {
            nm,
            step_nm: OnceLock::new(),
            is_even: OnceLock::new(),
        });
        Ok(Self {
            axis,
            values,
            formula: None,
        })
    }

    /// A spectrum of other values on the same wavelengths, which are kept in memory once.
    ///
    /// # Errors
    /// As [`Sampled::new`], with the values.
    pub(crate) fn sharing(&self, values: Vec<f64>) -> Result<Self, (SampledError, Vec<f64>)> {
        if self.axis.nm.len() != values.len() {
            let error = SampledError::Lengths {
                wavelengths: self.axis.nm.len(),
                values: values.len(),
            };
            return Err((error, values));
        }
        // Looked through without a way out in the middle, which is much faster on long columns.
        if values.iter().fold(false, |odd, v| odd | !v.is_finite())
            && let Some(index) = values.iter().position(|v| !v.is_finite())
        {
            return Err((SampledError::NotFinite { index }, values));
        }
        Ok(Self {
            axis: self.axis.clone(),
            values,
            formula: None,
        })
    }

    /// A spectrum on an even grid: `first_nm`, `first_nm + step_nm`, ...
    ///
    /// # Errors
    /// As [`Sampled::new`].
    pub fn even(first_nm: f64, step_nm: f64, values: Vec<f64>) -> Result<Self, SampledError> {
        let nm = (0..values.len())
            .map(|i| first_nm + i as f64 * step_nm)
            .collect();
        Self::new(nm, values)
    }

    /// The same table, which is a refractive index computed from this formula.
    #[must_use]
    pub(crate) fn of_formula(self, formula: Formula) -> Self {
        Self {
            formula: Some(Arc::new(formula)),
            ..self
        }
    }

    /// The formula of a refractive index that the table was computed from: exact between the
    /// samples too.
    pub fn formula(&self) -> Option<&Formula> {
        self.formula.as_deref()
    }

    /// Wavelengths, nm, strictly rising.
    pub fn nm(&self) -> &[f64] {
        &self.axis.nm
    }

    /// Values, one per wavelength.
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Number of points (at least 2, so there is no `is_empty`).
    #[allow(clippy::len_without_is_empty)]
    pub fn len(&self) -> usize {
        self.nm().len()
    }

    /// First wavelength, nm.
    pub fn first_nm(&self) -> f64 {
        self.nm()[0]
    }

    /// Last wavelength, nm.
    pub fn last_nm(&self) -> f64 {
        self.nm()[self.nm().len() - 1]
    }

    /// The median step between neighbouring wavelengths, nm.
    pub fn step_nm(&self) -> f64 {
        *self.axis.step_nm.get_or_init(|| {
            let mut steps: Vec<f64> = self.nm().windows(2).map(|w| w[1] - w[0]).collect();
            let middle = steps.len() / 2;
            *steps.select_nth_unstable_by(middle, f64::total_cmp).1
        })
    }

    /// True if all steps are uniform to the rounding of a table (3.333 nm written 373, 377, 380):
    /// within a thousandth of a nm, or a millionth of the step.
    pub(crate) fn has_even_steps(&self) -> bool {
        *self.axis.is_even.get_or_init(|| {
            let step = self.step_nm();
            let rounding = 1e-3_f64.max(1e-6 * step);
            let mut steps = self.nm().windows(2).map(|w| w[1] - w[0]);
            steps.all(|s| (s - step).abs() <= rounding)
        })
    }

    /// Stretches without samples among others that have them, each with its ends, nm: steps of more
    /// than three median steps, and of more than three of the middle ones around. Where steps grow
    /// all along, as in tables of optical constants, none is a hole.
    pub(crate) fn holes(&self) -> Vec<[f64; 2]> {
        const MOST_STEPS: f64 = 3.0;
        const AROUND: usize = 4;
        if self.has_even_steps() {
            return Vec::new();
        }
        let nm = self.nm();
        let most = MOST_STEPS * self.step_nm();
        let wide = (1..nm.len()).filter(|i| nm[*i] - nm[i - 1] > most);
        let stands_out = |i: &usize| {
            let near = i.saturating_sub(AROUND).max(1)..(i + AROUND + 1).min(nm.len());
            let others = near.filter(|other| other != i);
            let mut steps: Vec<f64> = others.map(|i| nm[i] - nm[i - 1]).collect();
            steps.sort_by(f64::total_cmp);
            let middle = steps.get(steps.len() / 2);
            middle.is_some_and(|middle| nm[*i] - nm[i - 1] > MOST_STEPS * middle)
        };
        wide.filter(stands_out)
            .map(|i| [nm[i - 1], nm[i]])
            .collect()
    }

    /// Value at a wavelength by straight lines between samples.
    pub fn at(&self, at_nm: f64, outside: Outside) -> f64 {
        let last = self.nm().len() - 1;
        if at_nm < self.nm()[0] || at_nm > self.nm()[last] {
            return match outside {
                Outside::Zero => 0.0,
                Outside::Hold if at_nm < self.nm()[0] => self.values[0],
                Outside::Hold => self.values[last],
            };
        }
        let right = self.nm().partition_point(|w| *w < at_nm).clamp(1, last);
        self.on_segment(right - 1, at_nm)
    }

    /// Every value multiplied by a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        Self {
            axis: self.axis.clone(),
            values: self.values.iter().map(|v| v * factor).collect(),
            formula: None,
        }
    }

    /// Integral of the spectrum times a weight over the band, in value x nm.
    ///
    /// The trapezoid sum on the 1 nm grid that a model of the spectrum is compared on; `outside`
    /// says what the spectrum is where the band reaches beyond the table.
    pub fn integrate(&self, band: Band, outside: Outside, weight: impl Fn(f64) -> f64) -> f64 {
        self.on_band(band, outside)
            .iter()
            .enumerate()
            .map(|(i, v)| band.weight(i) * v * weight(band.nm(i)))
            .sum()
    }

    /// Integral of `|S|` between two wavelengths (nm) by straight lines between samples, in value
    /// x nm; nothing outside the table.
    pub fn power_between(&self, from_nm: f64, to_nm: f64) -> f64 {
        let first = self.nm().partition_point(|nm| *nm <= from_nm).max(1) - 1;
        let pieces = self.nm().windows(2).enumerate().skip(first);
        pieces
            .take_while(|(_, w)| w[0] < to_nm)
            .map(|(left, w)| {
                let (a, b) = (w[0].max(from_nm), w[1].min(to_nm));
                let [p, q] = [a, b].map(|nm| self.on_segment(left, nm));
                // A line that crosses zero leaves a triangle on either side.
                let mean = if p * q < 0.0 {
                    0.5 * (p * p + q * q) / (p.abs() + q.abs())
                } else {
                    0.5 * (p.abs() + q.abs())
                };
                (b - a).max(0.0) * mean
            })
            .sum()
    }

    pub(super) fn on_segment(&self, left: usize, at_nm: f64) -> f64 {
        let (a, b) = (self.nm()[left], self.nm()[left + 1]);
        let t = (at_nm - a) / (b - a);
        self.values[left] * (1.0 - t) + self.values[left + 1] * t
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn power_is_the_area_without_its_sign_where_a_line_crosses_zero() {
        let of =
            |values: Vec<f64>| Sampled::new(vec![400.0, 401.0, 402.0], values).expect("rising");
        // Two triangles of half a nm and height 1; then of a quarter and three quarters.
        assert_eq!(of(vec![-1.0, 1.0, 1.0]).power_between(400.0, 401.0), 0.5);
        let uneven = of(vec![-1.0, 3.0, 3.0]);
        assert_eq!(uneven.power_between(400.0, 401.0), 0.125 + 1.125);
        assert_eq!(uneven.power_between(400.25, 401.5), 1.125 + 1.5);
        assert_eq!(uneven.power_between(300.0, 900.0), 1.25 + 3.0);
        assert_eq!(uneven.power_between(402.0, 900.0), 0.0);
    }

    #[test]
    fn a_stretch_without_samples_is_a_hole_and_steps_that_grow_are_none() {
        let of = |nm: Vec<f64>| {
            let values = vec![1.0; nm.len()];
            Sampled::new(nm, values).expect("rising").holes()
        };
        let near = (380..=420).chain(680..=780).map(f64::from);
        assert_eq!(of(near.clone().collect()), [[420.0, 680.0]]);
        // A lone sample in between parts the hole in two.
        let mut lone: Vec<f64> = near.chain([550.0]).collect();
        lone.sort_by(f64::total_cmp);
        assert_eq!(of(lone), [[420.0, 550.0], [550.0, 680.0]]);
        assert!(of((0..30).map(|i| 300.0 * 1.2_f64.powi(i)).collect()).is_empty());
        assert!(of(vec![400.0, 401.0, 402.0, 405.0, 406.0, 407.0]).is_empty());
        assert!(of(vec![400.0, 700.0]).is_empty());
    }

    #[test]
    fn the_integral_counts_what_lies_in_the_band_and_what_the_table_is_outside() {
        let flat = Sampled::new(vec![420.0, 480.0], vec![2.0, 2.0]).unwrap();
        let band = Band::new(400.0, 500.0).unwrap();
        // 61 whole nm of the table on a 1 nm grid; held, the whole 100 nm of the band.
        assert_eq!(flat.integrate(band, Outside::Zero, |_| 1.0), 122.0);
        assert_eq!(flat.integrate(band, Outside::Hold, |_| 1.0), 200.0);
        // A weight of wavelength makes it the first moment: 450 nm by symmetry.
        assert_eq!(flat.integrate(band, Outside::Hold, |nm| nm), 90_000.0);
    }
}
