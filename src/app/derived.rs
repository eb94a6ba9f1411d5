//! All that is shown about one spectrum, from the document in one pure step.

use crate::{
    color::{
        Adaptation, Lab, NoCct, Srgb, Xyz,
        cct::{self, Cct},
        chromaticity::{uv_1976_from_xyz, xy_from_xyz},
        ciede2000::delta_e_2000,
        lab::lab_from_xyz,
        patches::labs_into,
        srgb::Swatch,
    },
    spectrum::{
        Band, Basis, Composite, Decomposed, Exactness, SampleGrid, Series, Spike, SpikeEdits,
        basis::numbers_of_order,
        composite::add_spikes,
        edits::{decompose, decompose_by},
        gradient,
    },
    study::error::{SpectrumErrors, spectrum_errors},
};

use super::{
    settings::{Detector, Settings},
    tables::{CURVE_ORDER, Tables},
};

/// A colour with everything that is said about it; XYZ has the exact light's Y at 100.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Colour {
    /// Tristimulus values; 100 is the Y of the exact light.
    pub xyz: Xyz,
    /// Chromaticity x, y.
    pub xy: [f64; 2],
    /// CIE 1976 u', v'.
    pub uv: [f64; 2],
    /// What the screen shows.
    pub swatch: Swatch,
    /// Correlated colour temperature of a light; `None` for a reflectance, which has none.
    pub cct: Option<Result<Cct, NoCct>>,
}

/// The subject's colour as measured and as modelled.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ColourComparison {
    /// The measured spectrum on the model's range and quadrature.
    pub exact: Option<Colour>,
    /// The model's.
    pub model: Option<Colour>,
    /// The measured spectrum by plain 1 nm sums over 360-830 nm.
    pub full: Option<Colour>,
    /// CIEDE2000 between exact and model; the white is the exact light.
    pub delta_e_2000: Option<f64>,
    /// Distance in CIE 1976 u'v' between exact and model.
    pub delta_uv: Option<f64>,
    /// Share of the light's Y (360-830 nm) that the model's range leaves out, 0-1.
    pub missing_luminance: f64,
}

/// One patch under the exact light and under the model.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchPair {
    /// The patch's name.
    pub name: String,
    /// CIEDE2000 between the two.
    pub delta_e_2000: f64,
    /// Under the exact light, Y of the light at 100.
    pub exact: Xyz,
    /// Under the model.
    pub model: Xyz,
    /// What the screen shows of the first.
    pub exact_swatch: Swatch,
    /// What the screen shows of the second.
    pub model_swatch: Swatch,
}

/// All patches.
#[derive(Clone, Debug, PartialEq)]
pub struct PatchComparison {
    /// One after the other.
    pub items: Vec<PatchPair>,
    /// Mean CIEDE2000.
    pub mean: f64,
    /// Largest CIEDE2000.
    pub max: f64,
    /// Index of the worst patch.
    pub worst: usize,
}

/// The errors at one order of the curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrderPoint {
    /// Order N.
    pub order: usize,
    /// Numbers of the whole model, spikes included.
    pub numbers: usize,
    /// CIEDE2000 of the subject's own colour.
    pub own: Option<f64>,
    /// Mean CIEDE2000 of the patches.
    pub patches_mean: Option<f64>,
    /// Largest CIEDE2000 of the patches.
    pub patches_max: Option<f64>,
    /// Relative RMS on the 1 nm grid.
    pub relative_rms: Option<f64>,
    /// Relative RMS behind a 10 nm blur.
    pub relative_rms_10nm: Option<f64>,
}

/// What a recomputation needs to know beside the shared tables.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The subject on the band's grid.
    pub measured: &'a [f64],
    /// Whether the subject is a light (it has patches and a CCT) or a reflectance.
    pub is_light: bool,
    /// The light on the band's grid: the subject itself, or what a reflectance is seen under.
    pub light: &'a [f64],
    /// XYZ of the subject by 1 nm sums over 360-830, Y of the light at 100; CIE 1931 beside it.
    pub full: Option<(Xyz, Xyz)>,
    /// Y of the light over 360-830, not scaled.
    pub full_luminance: f64,
    /// First and last wavelength of the subject's table, nm.
    pub table_nm: [f64; 2],
    /// The knobs.
    pub settings: Settings,
    /// The hand edits of the subject's spikes.
    pub edits: &'a SpikeEdits,
    /// Bring patches to the screen's white.
    pub adaptation: Adaptation,
}

/// Everything derived from one subject and one set of knobs.
#[derive(Clone, Debug, PartialEq)]
pub struct Derived {
    /// The model's range.
    pub band: Band,
    /// The measured spectrum on the grid.
    pub measured: Vec<f64>,
    /// Smooth target, spikes, total power.
    pub parts: Decomposed,
    /// The model.
    pub model: Composite,
    /// The smooth series on the grid.
    pub smooth: Vec<f64>,
    /// Smooth plus spikes (split over their neighbouring nm) minus measured, on the grid.
    pub residual: Vec<f64>,
    /// How the colour-exact fit went; `None` when it was not asked for.
    pub exactness: Option<Exactness>,
    /// Errors of the spectrum; `None` for an all-zero one.
    pub errors: Option<SpectrumErrors>,
    /// The subject's colour.
    pub colour: ColourComparison,
    /// The patches under a light.
    pub patches: Option<PatchComparison>,
    /// Errors against order, from 0 on.
    pub curve: Vec<OrderPoint>,
    /// What must be said about this result, a sentence each.
    pub warnings: Vec<String>,
}

impl Derived {
    /// Answers the question: fit, errors, colours, patches and the whole order curve.
    pub fn of(question: Question<'_>, tables: &Tables) -> Self {
        let settings = question.settings;
        let band = tables.band();
        let fitted = Fitted::of(question, tables);
        let order = settings.effective_order();
        let (coefficients, exactness) = fitted.coefficients(order, tables);
        let smooth = tables.basis.evaluate(&coefficients);
        let mut residual: Vec<f64> = smooth
            .iter()
            .zip(question.measured)
            .map(|(s, m)| s - m)
            .collect();
        add_spikes(band, &fitted.spikes, &mut residual);
        let colour = fitted.colour(question, tables, &coefficients);
        let patches = fitted.patches(question, tables, &coefficients);
        let mut derived = Self {
            band,
            measured: question.measured.to_vec(),
            errors: spectrum_errors(&tables.blur, question.measured, &smooth, &fitted.spikes),
            model: Composite {
                smooth: Series {
                    band,
                    basis: settings.basis,
                    coefficients,
                },
                spikes: fitted.spikes.clone(),
            },
            smooth,
            residual,
            exactness: settings.colour_exact.then_some(exactness),
            colour,
            patches,
            curve: fitted.curve(question, tables),
            parts: fitted.parts,
            warnings: Vec::new(),
        };
        derived.warnings = derived.warnings_for(question);
        derived
    }

    /// Numbers that the model takes.
    pub fn numbers(&self) -> usize {
        self.model.numbers()
    }

    /// The model with each spike split linearly over its two neighbouring nm, on the grid.
    pub fn model_values(&self) -> Vec<f64> {
        let mut values = self.smooth.clone();
        add_spikes(self.band, &self.model.spikes, &mut values);
        values
    }

    /// The parts of 380-780 nm that the range does not reach: "380-400 and 700-780".
    fn missing_visible(&self) -> Option<String> {
        let (min, max) = (self.band.min_nm(), self.band.max_nm());
        let (first, last) = (Band::VISIBLE.min_nm(), Band::VISIBLE.max_nm());
        let below = (min > first).then(|| format!("{first}-{}", min.min(last)));
        let above = (max < last).then(|| format!("{}-{last}", max.max(first)));
        match (below, above) {
            (Some(below), Some(above)) => Some(format!("{below} and {above}")),
            (below, above) => below.or(above),
        }
    }

    fn warnings_for(&self, question: Question<'_>) -> Vec<String> {
        let settings = question.settings;
        let mut warnings = Vec::new();
        if self.errors.is_none() {
            warnings.push("The spectrum is zero over the whole range.".to_owned());
        } else if self.colour.exact.is_none() {
            warnings.push("No visible light in this range: there is no colour.".to_owned());
        }
        if settings.order > settings.effective_order() {
            warnings.push(format!(
                "Order cut to {}: the range has one point per nm, which carries no more.",
                settings.effective_order()
            ));
        }
        match self.exactness {
            Some(Exactness::TooFewNumbers) => warnings
                .push("Colour-exact needs order 1 or more: plain least squares used.".to_owned()),
            Some(Exactness::IllConditioned { .. }) => warnings.push(
                "This range does not tell X, Y and Z apart: plain least squares used.".to_owned(),
            ),
            Some(Exactness::Exact { .. }) | None => {}
        }
        if let Some(missing) = self.missing_visible() {
            let share = 100.0 * self.colour.missing_luminance;
            warnings.push(if share > 100.0 * WORTH_SAYING {
                format!(
                    "The range leaves out {missing} nm of the visible, {share:.1} % of the \
                     light's luminance."
                )
            } else {
                format!("The range leaves out {missing} nm of the visible.")
            });
        }
        let [first_nm, last_nm] = question.table_nm;
        if first_nm > self.band.min_nm() || last_nm < self.band.max_nm() {
            let outside = if question.is_light {
                "it is zero"
            } else {
                "its end values are held"
            };
            warnings.push(format!(
                "The table covers {first_nm}-{last_nm} nm; outside {outside}."
            ));
        }
        if let Some(colour) = self.colour.exact
            && !colour.swatch.in_gamut
        {
            warnings.push(format!(
                "The colour is outside sRGB: {}.",
                colour.swatch.mapping.words()
            ));
        }
        if let Some(errors) = self.errors
            && errors.lowest < -WORTH_SAYING
        {
            warnings.push(format!(
                "The smooth part dips below zero, to {:.1} % of the peak.",
                100.0 * errors.lowest
            ));
        }
        warnings
    }
}

/// Shares below this go without a word.
const WORTH_SAYING: f64 = 0.001;

/// A subject taken apart and projected to the largest order: what every order is cut from.
struct Fitted {
    parts: Decomposed,
    spikes: Vec<Spike>,
    /// Plain coefficients to the largest order.
    projected: Vec<f64>,
    /// XYZ that the smooth part must have for the subject's colour to be exact.
    smooth_target: [f64; 3],
    colour_exact: bool,
    /// XYZ of the spikes alone.
    spikes_xyz: Xyz,
    /// XYZ of the subject, exact.
    exact_xyz: Xyz,
    /// XYZ of the light, exact: the white.
    white: Xyz,
}

impl Fitted {
    fn of(question: Question<'_>, tables: &Tables) -> Self {
        let settings = question.settings;
        let band = tables.band();
        let parts = take_apart(question, band);
        let spikes = parts.plain_spikes();
        let projected = tables.basis.project(&parts.smooth, tables.basis.numbers());
        let weights = &tables.viewing.weights;
        let exact_xyz = integral(band, question.measured, weights);
        let spikes_xyz = spikes_xyz(band, &spikes, weights);
        let white = if question.is_light {
            exact_xyz
        } else {
            // The weights are the light's already: a perfect reflector is their own integral.
            Xyz::from_array(std::array::from_fn(|k| band.integral(&weights[k])))
        };
        Self {
            smooth_target: (exact_xyz - spikes_xyz).to_array(),
            parts,
            spikes,
            projected,
            colour_exact: settings.colour_exact,
            spikes_xyz,
            exact_xyz,
            white,
        }
    }

    fn coefficients(&self, order: usize, tables: &Tables) -> (Vec<f64>, Exactness) {
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

    /// XYZ of the model by its coefficients (Eq. 7, corrected), not scaled.
    fn model_xyz(&self, tables: &Tables, coefficients: &[f64]) -> Xyz {
        Xyz::from_array(tables.colour.of(coefficients)) + self.spikes_xyz
    }

    fn colour(
        &self,
        question: Question<'_>,
        tables: &Tables,
        coefficients: &[f64],
    ) -> ColourComparison {
        let band = tables.band();
        let weights_1931 = &tables.viewing.weights_1931;
        let is_light = question.is_light;
        let exact_1931 = integral(band, question.measured, weights_1931);
        let model_1931 = Xyz::from_array(tables.colour_1931.of(coefficients))
            + spikes_xyz(band, &self.spikes, weights_1931);
        let scale = 100.0 / self.white.y;
        let white = self.white * scale;
        let colour = |xyz: Xyz, xyz_1931: Xyz| Colour::of(xyz, xyz_1931, white, is_light);
        let exact = colour(self.exact_xyz * scale, exact_1931);
        let model = colour(self.model_xyz(tables, coefficients) * scale, model_1931);
        let full = question
            .full
            .and_then(|(xyz, xyz_1931)| Colour::of(xyz, xyz_1931, xyz, is_light));
        let both = exact.zip(model);
        ColourComparison {
            exact,
            model,
            full: match (is_light, question.full) {
                (true, _) => full,
                (false, Some((xyz, xyz_1931))) => Colour::of(xyz, xyz_1931, white, false),
                (false, None) => None,
            },
            delta_e_2000: both
                .map(|(e, m)| delta_e_2000(lab_from_xyz(e.xyz, white), lab_from_xyz(m.xyz, white))),
            delta_uv: both.map(|(e, m)| (e.uv[0] - m.uv[0]).hypot(e.uv[1] - m.uv[1])),
            missing_luminance: if question.full_luminance > 0.0 {
                let seen = band.inner(
                    question.light,
                    &question.settings.observer.table().on_band(band)[1],
                );
                (1.0 - seen / question.full_luminance).max(0.0)
            } else {
                0.0
            },
        }
    }

    fn patches(
        &self,
        question: Question<'_>,
        tables: &Tables,
        coefficients: &[f64],
    ) -> Option<PatchComparison> {
        let patches = tables.patches.as_ref()?;
        if !is_positive(self.white.y) {
            return None;
        }
        let scale = 100.0 / self.white.y;
        let (mut exact, mut model) = (patches.set.buffer(), patches.set.buffer());
        patches.set.xyz_into(question.measured, &mut exact);
        match question.settings.sampling.points(coefficients.len()) {
            None => {
                patches.matrix.xyz_into(coefficients, &mut model);
                for spike in &self.spikes {
                    patches.set.add_line(spike.at_nm, spike.weight, &mut model);
                }
            }
            Some(points) => {
                self.resampled_patches(question, tables, coefficients, points, &mut model)
            }
        }
        let (mut exact_labs, mut model_labs) = (
            vec![Lab::new(0.0, 0.0, 0.0); exact.len()],
            vec![Lab::new(0.0, 0.0, 0.0); exact.len()],
        );
        labs_into(&exact, self.white, &mut exact_labs);
        labs_into(&model, self.white, &mut model_labs);
        let white = self.white * scale;
        let items: Vec<PatchPair> = patches
            .set
            .names()
            .iter()
            .enumerate()
            .map(|(i, name)| {
                let (e, m) = (
                    Xyz::from_array(exact[i]) * scale,
                    Xyz::from_array(model[i]) * scale,
                );
                PatchPair {
                    name: name.clone(),
                    delta_e_2000: delta_e_2000(exact_labs[i], model_labs[i]),
                    exact: e,
                    model: m,
                    exact_swatch: Swatch::of_patch(e, white, question.adaptation),
                    model_swatch: Swatch::of_patch(m, white, question.adaptation),
                }
            })
            .collect();
        let worst = (0..items.len())
            .max_by(|a, b| items[*a].delta_e_2000.total_cmp(&items[*b].delta_e_2000))?;
        Some(PatchComparison {
            mean: items.iter().map(|p| p.delta_e_2000).sum::<f64>() / items.len() as f64,
            max: items[worst].delta_e_2000,
            worst,
            items,
        })
    }

    /// Patches by products on a few points, both factors modelled with the same count of numbers.
    fn resampled_patches(
        &self,
        question: Question<'_>,
        tables: &Tables,
        coefficients: &[f64],
        points: usize,
        out: &mut [[f64; 3]],
    ) {
        let Some(patches) = tables.patches.as_ref() else {
            return;
        };
        let grid = SampleGrid {
            band: tables.band(),
            basis: question.settings.basis,
            points,
        };
        let series = |coefficients: &[f64]| Series {
            band: grid.band,
            basis: grid.basis,
            coefficients: coefficients.to_vec(),
        };
        let to_xyz = grid.product_matrix(|k| function_xyz(tables, k));
        let light = grid.sample(&series(coefficients));
        for (xyz, reflectance) in out.iter_mut().zip(&patches.coefficients) {
            let reflectance = series(&reflectance[..coefficients.len()]);
            *xyz = [0.0; 3];
            for ((s, r), row) in light.iter().zip(grid.sample(&reflectance)).zip(&to_xyz) {
                for (x, m) in xyz.iter_mut().zip(row) {
                    *x += s * r * m;
                }
            }
            for spike in &self.spikes {
                let weight = spike.weight * reflectance.at(spike.at_nm);
                let line = spikes_xyz(
                    grid.band,
                    &[Spike { weight, ..*spike }],
                    &tables.viewing.weights,
                );
                for (x, l) in xyz.iter_mut().zip(line.to_array()) {
                    *x += l;
                }
            }
        }
    }

    fn curve(&self, question: Question<'_>, tables: &Tables) -> Vec<OrderPoint> {
        let band = tables.band();
        let highest = CURVE_ORDER.min(Basis::highest_order(band));
        let square = band.inner(question.measured, question.measured);
        let blurred_measured = tables.blur.values(question.measured);
        let blurred_square = band.inner(&blurred_measured, &blurred_measured);
        // What is missing before any smooth part: spikes minus measured, plain and blurred.
        let mut rest: Vec<f64> = question.measured.iter().map(|m| -m).collect();
        add_spikes(band, &self.spikes, &mut rest);
        let mut blurred_rest: Vec<f64> = blurred_measured.iter().map(|m| -m).collect();
        tables.blur.add_spikes(&self.spikes, &mut blurred_rest);

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
                let d = plain.with(&coefficients, |k| tables.basis.row(k));
                let relative_rms = share(band.inner(d, d), square);
                let d = blurred.with(&coefficients, |k| &tables.blurred[k]);
                let relative_rms_10nm = share(band.inner(d, d), blurred_square);
                OrderPoint {
                    order,
                    numbers: coefficients.len() + 2 * self.spikes.len(),
                    own,
                    patches_mean: patches.map(|p| p.0),
                    patches_max: patches.map(|p| p.1),
                    relative_rms,
                    relative_rms_10nm,
                }
            })
            .collect()
    }

    fn patch_work(&self, question: Question<'_>, tables: &Tables) -> Option<PatchWork> {
        let patches = tables.patches.as_ref()?;
        if !is_positive(self.white.y) {
            return None;
        }
        let zero = Lab::new(0.0, 0.0, 0.0);
        let mut exact = patches.set.buffer();
        patches.set.xyz_into(question.measured, &mut exact);
        let mut exact_labs = vec![zero; exact.len()];
        labs_into(&exact, self.white, &mut exact_labs);
        let mut lines = patches.set.buffer();
        for spike in &self.spikes {
            patches.set.add_line(spike.at_nm, spike.weight, &mut lines);
        }
        Some(PatchWork {
            white: self.white,
            labs: exact_labs.clone(),
            exact_labs,
            model: patches.set.buffer(),
            lines,
        })
    }
}

/// Buffers for the patches of many orders.
struct PatchWork {
    white: Xyz,
    exact_labs: Vec<Lab>,
    labs: Vec<Lab>,
    model: Vec<[f64; 3]>,
    /// What the spikes add to each patch, whatever the order.
    lines: Vec<[f64; 3]>,
}

impl PatchWork {
    /// Mean and largest CIEDE2000 with these coefficients, products at 1 nm.
    fn errors(&mut self, coefficients: &[f64], tables: &Tables) -> (f64, f64) {
        let Some(patches) = tables.patches.as_ref() else {
            return (0.0, 0.0);
        };
        patches.matrix.xyz_into(coefficients, &mut self.model);
        let lines = self.lines.as_flattened();
        for (m, l) in self.model.as_flattened_mut().iter_mut().zip(lines) {
            *m += l;
        }
        labs_into(&self.model, self.white, &mut self.labs);
        let found = crate::color::patches::difference(&self.exact_labs, &self.labs);
        (found.mean, found.max)
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

impl Colour {
    /// `None` when there is no colour to speak of. `white` is the light in the same scale.
    fn of(xyz: Xyz, xyz_1931: Xyz, white: Xyz, is_light: bool) -> Option<Self> {
        if !xyz.is_finite() || !is_positive(white.y) {
            return None;
        }
        Some(Self {
            xyz,
            xy: xy_from_xyz(xyz)?,
            uv: uv_1976_from_xyz(xyz)?,
            swatch: if is_light {
                Swatch::of_light(xyz)
            } else {
                Swatch::of_patch(xyz, white, Adaptation::None)
            },
            cct: is_light.then(|| cct::cct_from_xyz(xyz_1931)),
        })
    }

    /// The screen colour.
    pub fn srgb(&self) -> Srgb {
        self.swatch.rgb8
    }
}

fn take_apart(question: Question<'_>, band: Band) -> Decomposed {
    let (settings, values) = (question.settings, question.measured);
    if !settings.spikes {
        // Spikes set by hand are kept too: only their being used is switched off.
        return Decomposed {
            smooth: values.to_vec(),
            spikes: Vec::new(),
            power: crate::spectrum::spikes::absolute_power(band, values),
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

fn integral(band: Band, values: &[f64], weights: &[Vec<f64>; 3]) -> Xyz {
    Xyz::from_array(std::array::from_fn(|k| band.inner(values, &weights[k])))
}

fn spikes_xyz(band: Band, spikes: &[Spike], weights: &[Vec<f64>; 3]) -> Xyz {
    Xyz::from_array(std::array::from_fn(|k| {
        spikes
            .iter()
            .map(|s| s.weight * band.interpolate(&weights[k], s.at_nm))
            .sum()
    }))
}

/// Inner products of basis function `k` with the viewing's weights, beyond the table as well.
fn function_xyz(tables: &Tables, k: usize) -> [f64; 3] {
    if k < tables.basis.numbers() {
        return tables.colour.row(k);
    }
    let band = tables.band();
    let function: Vec<f64> = band
        .grid()
        .map(|nm| tables.basis.basis().function(k, band, nm))
        .collect();
    integral(band, &function, &tables.viewing.weights).to_array()
}

fn is_positive(value: f64) -> bool {
    value > 0.0 && value.is_finite()
}
