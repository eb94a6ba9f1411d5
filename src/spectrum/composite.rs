//! The composite model: a smooth series and a few lines (Eq. 2 and 3).
//!
//! ```text
//! S(l) = smooth(l) + sum over lines of weight g(l; at_nm, fwhm_nm)
//! ```
//!
//! A line of no width is the paper's ideal spike: it can only be weighed, never evaluated.

use crate::languages::with_sign;

use super::{
    band::Band,
    line::{Line, add_lines},
    series::Series,
};

/// A spectrum as a smooth series and lines.
#[derive(Clone, Debug, PartialEq)]
pub struct Composite {
    smooth: Series,
    lines: Vec<Line>,
}

/// Why a smooth part and lines are no composite.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CompositeError {
    /// The smooth part has no coefficient.
    #[error("{}", said!("the smooth part has no coefficient"))]
    NoCoefficient,
    /// A coefficient is no finite number.
    #[error(
        "{}",
        tr!(
            "coefficient {index} of the smooth part is {value}, no finite number",
            index,
            value = with_sign(value.to_string())
        )
    )]
    Coefficient {
        /// Its place in the series, from 0.
        index: usize,
        /// Its value.
        value: f64,
    },
    /// A line stands outside the band of the smooth part.
    #[error(
        "{}",
        tr!(
            "a line at {at_nm} nm stands outside {min_nm}-{max_nm} nm",
            at_nm = with_sign(at_nm.to_string()),
            min_nm = band.min_nm(),
            max_nm = band.max_nm()
        )
    )]
    OutsideBand {
        /// Its place, nm.
        at_nm: f64,
        /// The band.
        band: Band,
    },
    /// The weight of a line is no finite number.
    #[error(
        "{}",
        tr!(
            "the line at {at_nm} nm weighs {weight}, no finite number",
            at_nm = with_sign(at_nm.to_string()),
            weight = with_sign(weight.to_string())
        )
    )]
    Weight {
        /// Its place, nm.
        at_nm: f64,
        /// Its weight.
        weight: f64,
    },
    /// The width of a line is negative or no finite number.
    #[error(
        "{}",
        tr!(
            "the line at {at_nm} nm is {fwhm_nm} nm wide: a finite width from 0 on is expected",
            at_nm = with_sign(at_nm.to_string()),
            fwhm_nm = with_sign(fwhm_nm.to_string())
        )
    )]
    Width {
        /// Its place, nm.
        at_nm: f64,
        /// Its width, nm.
        fwhm_nm: f64,
    },
}

impl Composite {
    /// A composite of a smooth part and lines of its band, which are put in order of wavelength.
    ///
    /// # Errors
    /// [`CompositeError`] for a series without a coefficient, for numbers that are not finite, and
    /// for a line outside the band.
    pub fn new(smooth: Series, lines: Vec<Line>) -> Result<Self, CompositeError> {
        if smooth.coefficients.is_empty() {
            return Err(CompositeError::NoCoefficient);
        }
        if let Some((index, &value)) = (smooth.coefficients.iter().enumerate())
            .find(|(_, coefficient)| !coefficient.is_finite())
        {
            return Err(CompositeError::Coefficient { index, value });
        }
        let band = smooth.band;
        for &Line {
            at_nm,
            weight,
            fwhm_nm,
        } in &lines
        {
            if !band.contains(at_nm) {
                return Err(CompositeError::OutsideBand { at_nm, band });
            }
            if !weight.is_finite() {
                return Err(CompositeError::Weight { at_nm, weight });
            }
            if !(fwhm_nm >= 0.0 && fwhm_nm.is_finite()) {
                return Err(CompositeError::Width { at_nm, fwhm_nm });
            }
        }
        Ok(Self::of_lines_inside(smooth, lines))
    }

    /// A composite of a smooth part and those lines that stand in its band, in order of wavelength:
    /// nothing is known of the spectrum outside.
    pub fn of_lines_inside(smooth: Series, mut lines: Vec<Line>) -> Self {
        let band = smooth.band;
        lines.retain(|line| band.contains(line.at_nm));
        lines.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        Self { smooth, lines }
    }

    /// The smooth part.
    pub fn smooth(&self) -> &Series {
        &self.smooth
    }

    /// The lines, by rising wavelength; all of them in the band.
    pub fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// The smooth part and the lines.
    pub(crate) fn into_parts(self) -> (Series, Vec<Line>) {
        (self.smooth, self.lines)
    }

    /// The band of the model.
    pub fn band(&self) -> Band {
        self.smooth.band
    }

    /// True if any line has a width.
    pub fn has_widths(&self) -> bool {
        self.lines.iter().any(|line| line.fwhm_nm > 0.0)
    }

    /// Count of the model's numbers: one per coefficient and two per line, whose place and width
    /// share one number (LINES.md section 2); one more, the label, as soon as a line has a width.
    pub fn numbers(&self) -> usize {
        let label = usize::from(self.has_widths());
        self.smooth.coefficients.len() + 2 * self.lines.len() + label
    }

    /// The same composite with every line at its centre and of no width.
    pub(crate) fn idealised(&self) -> Self {
        let ideal = |line: &Line| Line::ideal(line.at_nm, line.weight);
        Self {
            smooth: self.smooth.clone(),
            lines: self.lines.iter().map(ideal).collect(),
        }
    }

    /// The same lines over the first `numbers` coefficients of the smooth part.
    pub fn truncated(self, numbers: usize) -> Self {
        Self {
            smooth: self.smooth.truncated(numbers),
            ..self
        }
    }

    /// Integral of the spectrum times a weight over the band, in value x nm: the smooth part and
    /// lines with a width are summed on the 1 nm trapezoid grid, an ideal line weighs the function
    /// exactly where it stands.
    pub fn integrate(&self, weight: impl Fn(f64) -> f64) -> f64 {
        let band = self.band();
        let weights: Vec<f64> = band.grid().map(&weight).collect();
        let of_line = |line: &Line| {
            if line.is_ideal() {
                line.weight * weight(line.at_nm)
            } else {
                line.integrate(band, &weights)
            }
        };
        let lines: f64 = self.lines.iter().map(of_line).sum();
        band.inner(&self.smooth.on_band(), &weights) + lines
    }

    /// Total power over the band: the exact integral of the series and the lines' weights.
    pub fn power(&self) -> f64 {
        self.smooth.integral() + self.lines.iter().map(|line| line.weight).sum::<f64>()
    }

    /// Values on the band's grid, an ideal line split linearly over its two neighbouring nm.
    pub fn on_band(&self) -> Vec<f64> {
        let mut values = self.smooth.on_band();
        add_lines(self.band(), &self.lines, &mut values);
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Basis;

    const BAND: Band = Band::VISIBLE;

    fn series(basis: Basis) -> Series {
        Series::new(
            BAND,
            basis,
            (0..21)
                .map(|n| (0.7_f64).powi(n) * if n % 3 == 0 { 1.0 } else { -0.6 })
                .collect(),
        )
    }

    fn wide(at_nm: f64, weight: f64, fwhm_nm: f64) -> Line {
        Line::new(at_nm, weight, fwhm_nm)
    }

    #[test]
    fn a_line_outside_the_band_cannot_be_made() {
        let smooth = || series(Basis::Cosine);
        for at_nm in [379.9, 780.1, f64::NAN] {
            let outside = Composite::new(smooth(), vec![Line::ideal(at_nm, 1.0)]);
            assert!(matches!(outside, Err(CompositeError::OutsideBand { .. })));
            let kept = Composite::of_lines_inside(smooth(), vec![Line::ideal(at_nm, 1.0)]);
            assert!(kept.lines().is_empty());
        }
        let is_refused = |line: Line| Composite::new(smooth(), vec![line]).is_err();
        assert!(is_refused(Line::ideal(500.0, f64::NAN)));
        assert!(is_refused(wide(500.0, 1.0, -1.0)));
        assert!(is_refused(wide(500.0, 1.0, f64::INFINITY)));
        let no_smooth = Series {
            coefficients: Vec::new(),
            ..smooth()
        };
        let error = Composite::new(no_smooth, Vec::new()).expect_err("no coefficient");
        assert_eq!(error.to_string(), "the smooth part has no coefficient");
        let ends = vec![Line::ideal(780.0, 1.0), wide(380.0, 1.0, 5.0)];
        let kept = Composite::new(smooth(), ends).expect("the ends belong to the band");
        assert_eq!(
            kept.lines().iter().map(|l| l.at_nm).collect::<Vec<_>>(),
            [380.0, 780.0]
        );
    }

    #[test]
    fn a_label_is_one_number_as_soon_as_a_line_has_a_width() {
        let of = |lines| Composite::of_lines_inside(series(Basis::Cosine), lines);
        let ideal = of(vec![Line::ideal(436.0, 1.0)]);
        let with_width = of(vec![wide(436.0, 1.0, 4.0)]);
        assert_eq!((ideal.numbers(), with_width.numbers()), (23, 24));
        assert!(with_width.has_widths());
        assert_eq!(with_width.idealised(), ideal);
        assert_eq!(with_width.power(), ideal.power());
    }

    #[test]
    fn the_integral_of_a_weight_is_that_of_the_values() {
        let light = Composite {
            smooth: series(Basis::Fourier),
            lines: vec![Line::ideal(436.0, 0.5), Line::new(590.0, 0.8, 12.0)],
        };
        let weight = |nm: f64| (nm / 50.0).sin();
        let weights: Vec<f64> = BAND.grid().map(weight).collect();
        // The ideal spike stands on a grid point.
        assert!((light.integrate(weight) - BAND.inner(&light.on_band(), &weights)).abs() < 1e-11);
    }
}
