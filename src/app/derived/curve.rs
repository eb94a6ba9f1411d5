//! The errors at every order, from one projection.

use super::{
    Question,
    fitted::{Fitted, is_positive},
};
use crate::{
    app::tables::{CURVE_ORDER, Tables},
    color::{delta_e_2000, lab_from_xyz},
    spectrum::{Basis, add_lines},
    study::{
        Measure, Verdict,
        error::{height, spikes_times, times},
    },
};

/// The errors that the curve has, in the order of files.
pub const OF_CURVE: [Measure; 5] = [
    Measure::Own,
    Measure::Patches,
    Measure::PatchesWorst,
    Measure::Rms,
    Measure::RmsBlurred,
];

/// The errors at one order of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrderPoint {
    /// Order N.
    pub order: usize,
    /// Numbers of the whole model, spikes included.
    pub numbers: usize,
    /// Those of [`OF_CURVE`].
    pub figures: Verdict,
}

impl Fitted {
    /// The whole curve; products with patches at 1 nm whatever the settings say.
    pub(super) fn curve(&self, question: Question<'_>, tables: &Tables) -> Vec<OrderPoint> {
        let band = tables.band();
        // The curve always reaches the order in force.
        let highest = CURVE_ORDER
            .max(question.settings.effective_order())
            .min(Basis::highest_order(band));
        // Everything as a share of the largest value, so that no square overflows or vanishes.
        let unit = height(question.measured).unwrap_or(0.0);
        let measured = times(question.measured, unit);
        let spikes = spikes_times(&self.ideal, unit);
        let square = band.inner(&measured, &measured);
        let blurred_measured = tables.blur.values(&measured);
        let blurred_square = band.inner(&blurred_measured, &blurred_measured);
        // What is missing before any smooth part: spikes minus measured, plain and blurred.
        let mut rest: Vec<f64> = measured.iter().map(|m| -m).collect();
        let bells = times(&self.bells, unit);
        rest.iter_mut().zip(&bells).for_each(|(r, b)| *r += b);
        add_lines(band, &spikes, &mut rest);
        let mut blurred_rest: Vec<f64> = blurred_measured.iter().map(|m| -m).collect();
        if !self.bells.is_empty() {
            let bells = tables.blur.values(&bells);
            let rest = blurred_rest.iter_mut();
            rest.zip(bells).for_each(|(r, b)| *r += b);
        }
        tables.blur.add_lines(&spikes, &mut blurred_rest);
        // One more number tells that lines have a width.
        let label = usize::from(!self.bells.is_empty());

        let mut patch_work = self.patch_work(question, tables);
        let exact_lab = lab_from_xyz(self.exact_xyz, self.white);
        let has_colour = is_positive(self.white.y);
        let (mut plain, mut blurred) = (Running::new(rest), Running::new(blurred_rest));
        (0..=highest)
            .map(|order| {
                let (coefficients, _) = self.coefficients(order, tables);
                let own = has_colour.then(|| {
                    let xyz = self.model_xyz(tables, &coefficients);
                    delta_e_2000(exact_lab, lab_from_xyz(xyz, self.white))
                });
                let patches = patch_work.as_mut().map(|w| w.errors(&coefficients, tables));
                let share =
                    |sum: f64, whole: f64| (whole > 0.0).then(|| (sum.max(0.0) / whole).sqrt());
                let scaled = times(&coefficients, unit);
                let d = plain.with(&scaled, |k| tables.basis.row(k));
                let rms = share(band.inner(d, d), square);
                let d = blurred.with(&scaled, |k| &tables.blurred[k]);
                let rms_blurred = share(band.inner(d, d), blurred_square);
                OrderPoint {
                    order,
                    numbers: coefficients.len() + 2 * self.lines.len() + label,
                    figures: Verdict::from_fn(|measure| match measure {
                        Measure::Own => own,
                        Measure::Patches => patches.map(|p| p.0),
                        Measure::PatchesWorst => patches.map(|p| p.1),
                        Measure::Rms => rms,
                        Measure::RmsBlurred => rms_blurred,
                        _ => None,
                    }),
                }
            })
            .collect()
    }
}

/// A sum of functions on the grid that follows its coefficients: only what changed is added.
struct Running {
    coefficients: Vec<f64>,
    values: Vec<f64>,
}

impl Running {
    fn new(values: Vec<f64>) -> Self {
        Self {
            coefficients: Vec::new(),
            values,
        }
    }

    fn with<'a>(&mut self, coefficients: &[f64], row: impl Fn(usize) -> &'a [f64]) -> &[f64] {
        self.coefficients.resize(coefficients.len(), 0.0);
        for (k, (now, wanted)) in self.coefficients.iter_mut().zip(coefficients).enumerate() {
            let step = wanted - *now;
            if step != 0.0 {
                for (v, f) in self.values.iter_mut().zip(row(k)) {
                    *v += step * f;
                }
                *now = *wanted;
            }
        }
        &self.values
    }
}
