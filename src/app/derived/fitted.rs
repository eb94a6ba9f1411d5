//! The fit: a subject taken apart and projected once, from which every order is cut.

use super::{Question, wide};
use crate::{
    app::{settings::Detector, tables::Tables},
    color::{Xyz, xyz_of_lines, xyz_of_one, xyz_of_parts},
    spectrum::{
        Band, Decomposed, Exactness, Line, absolute_power, decompose, decompose_by, gradient,
        numbers_of_order,
    },
    study::{
        Measure, Verdict,
        error::{height, spectrum_errors},
    },
};

/// A subject taken apart and projected to the largest order: what every order is cut from.
pub(super) struct Fitted {
    pub parts: Decomposed,
    pub lines: Vec<Line>,
    /// Those that have a width, on the grid; empty where there are none.
    pub bells: Vec<f64>,
    /// Those of no width: all of them, unless widths were asked for.
    pub ideal: Vec<Line>,
    /// Plain coefficients to the largest order.
    pub projected: Vec<f64>,
    /// XYZ that the smooth part must have for the subject's colour to be exact.
    pub smooth_target: [f64; 3],
    pub colour_exact: bool,
    /// XYZ of the spikes alone.
    pub spikes_xyz: Xyz,
    /// XYZ of the subject, exact.
    pub exact_xyz: Xyz,
    /// XYZ of the light, exact: the white.
    pub white: Xyz,
}

impl Fitted {
    /// Takes the subject apart and projects what is left to the largest order.
    pub(super) fn of(question: Question<'_>, tables: &Tables) -> Self {
        let settings = question.settings;
        let band = tables.band();
        let (parts, lines) = match question.given {
            Some(given) => wide::of_composite(given, question.measured, settings.wide_lines),
            None => {
                let mut parts = take_apart(question, band);
                let lines = if settings.wide_lines {
                    wide::widened(band, question.measured, &mut parts, settings.max_width_nm)
                } else {
                    parts.plain_spikes()
                };
                (parts, lines)
            }
        };
        let bells = wide::bells(band, &lines);
        let ideal: Vec<Line> = lines.iter().copied().filter(|l| l.is_ideal()).collect();
        let projected = tables.basis.project(&parts.smooth, tables.basis.numbers());
        let weights = &tables.viewing.weights;
        let exact_xyz = xyz_of_parts(band, question.measured, &[], weights);
        let spikes_xyz = xyz_of_lines(&lines, weights);
        let white = if question.is_light {
            exact_xyz
        } else {
            // The weights are the light's already: a perfect reflector is their own integral.
            xyz_of_one(band, weights)
        };
        Self {
            smooth_target: (exact_xyz - spikes_xyz).to_array(),
            parts,
            lines,
            bells,
            ideal,
            projected,
            colour_exact: settings.colour_exact,
            spikes_xyz,
            exact_xyz,
            white,
        }
    }

    /// The coefficients of an order, made colour-exact where that was asked for.
    pub(super) fn coefficients(&self, order: usize, tables: &Tables) -> (Vec<f64>, Exactness) {
        let numbers = numbers_of_order(order).min(self.projected.len());
        let mut coefficients = self.projected[..numbers].to_vec();
        let exactness = if self.colour_exact {
            tables
                .colour
                .make_exact(&mut coefficients, self.smooth_target)
        } else {
            Exactness::TooFewNumbers
        };
        (coefficients, exactness)
    }

    /// What the model is off by in the spectrum itself.
    pub(super) fn spectrum_errors(
        &self,
        measured: &[f64],
        smooth: &[f64],
        tables: &Tables,
    ) -> Verdict {
        if self.bells.is_empty() {
            return spectrum_errors(&tables.blur, measured, smooth, &self.ideal)
                .unwrap_or_default();
        }
        let outline = wide::with_bells(smooth.to_vec(), &self.bells);
        let errors = spectrum_errors(&tables.blur, measured, &outline, &self.ideal);
        let mut errors = errors.unwrap_or_default();
        // A line over a dip does not hide that the smooth part dips.
        errors[Measure::Lowest] = height(measured)
            .map(|unit| unit * smooth.iter().copied().fold(f64::INFINITY, f64::min));
        errors
    }

    /// XYZ of the model by its coefficients (Eq. 7, corrected), not scaled.
    pub(super) fn model_xyz(&self, tables: &Tables, coefficients: &[f64]) -> Xyz {
        Xyz::from_array(tables.colour.of(coefficients)) + self.spikes_xyz
    }
}

fn take_apart(question: Question<'_>, band: Band) -> Decomposed {
    let (settings, values) = (question.settings, question.measured);
    if !settings.spikes {
        // Spikes set by hand are kept too: only their being used is switched off.
        return Decomposed {
            smooth: values.to_vec(),
            spikes: Vec::new(),
            power: absolute_power(band, values),
        };
    }
    match settings.detector {
        Detector::Energy => decompose(band, values, settings.spike_settings(), question.edits),
        Detector::Gradient => decompose_by(
            band,
            values,
            settings.max_width_nm,
            question.edits,
            |values, wishes| {
                gradient::detect(
                    band,
                    values,
                    settings.gradient_percent / 100.0,
                    settings.max_width_nm,
                    wishes,
                )
            },
        ),
    }
}

/// Whether a number is finite and above zero.
pub(super) fn is_positive(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}
