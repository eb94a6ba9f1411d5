//! The patches under the measured light and under the model.

use super::{
    Question,
    fitted::{Fitted, is_positive},
};
use crate::{
    app::tables::Tables,
    color::{
        Lab, PatchSet, Xyz, delta_e_2000,
        patches::{difference, labs_into},
        srgb::Swatch,
        xyz_of_lines, xyz_of_parts,
    },
    spectrum::{Line, SampleGrid, Sampling, Series, product::convolve},
};

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

impl Fitted {
    /// All patches, by products as the settings want them; `None` where there are none to see.
    pub(super) fn patches(
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
        let sampling = question.settings.sampling;
        match (sampling, sampling.points(coefficients.len())) {
            (_, points @ Some(_)) | (Sampling::Convolution, points) => {
                self.multiplied_patches(question, tables, coefficients, points, &mut model);
            }
            (_, None) => {
                patches.matrix.xyz_into(coefficients, &mut model);
                self.add_to_patches(&patches.set, &mut model);
            }
        }
        let [exact_labs, model_labs] = [&exact, &model].map(|xyz| self.labs(xyz));
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

    /// Colours beside the exact light as the white.
    fn labs(&self, xyz: &[[f64; 3]]) -> Vec<Lab> {
        let mut labs = vec![Lab::new(0.0, 0.0, 0.0); xyz.len()];
        labs_into(xyz, self.white, &mut labs);
        labs
    }

    /// Patches by products of two series of the same count of numbers: on a few points, else by
    /// convolution of the coefficients, cut back to as many as the light has.
    fn multiplied_patches(
        &self,
        question: Question<'_>,
        tables: &Tables,
        coefficients: &[f64],
        points: Option<usize>,
        out: &mut [[f64; 3]],
    ) {
        let Some(patches) = tables.patches.as_ref() else {
            return;
        };
        let (band, basis) = (tables.band(), question.settings.basis);
        let numbers = coefficients.len();
        let series = |coefficients: &[f64]| Series {
            band,
            basis,
            coefficients: coefficients.to_vec(),
        };
        let light = series(coefficients);
        let on_points = points.map(|points| {
            let grid = SampleGrid {
                band,
                basis,
                points,
            };
            let to_xyz = grid.product_matrix(|k| function_xyz(tables, k));
            (grid.sample(&light), to_xyz, grid)
        });
        for (xyz, reflectance) in out.iter_mut().zip(&patches.coefficients) {
            let reflectance = series(&reflectance[..numbers]);
            if let Some((light, to_xyz, grid)) = &on_points {
                *xyz = [0.0; 3];
                for ((s, r), row) in light.iter().zip(grid.sample(&reflectance)).zip(to_xyz) {
                    for (x, m) in xyz.iter_mut().zip(row) {
                        *x += s * r * m;
                    }
                }
            } else {
                let product = convolve(&light, &reflectance).truncated(numbers);
                *xyz = tables.colour.of(&product.coefficients);
            }
            self.add_lines(&reflectance, tables, xyz);
        }
    }

    /// Adds the lines to what each patch sends back.
    fn add_to_patches(&self, patches: &PatchSet, out: &mut [[f64; 3]]) {
        for spike in &self.ideal {
            patches.add_line(spike.at_nm, spike.weight, out);
        }
        if !self.bells.is_empty() {
            let mut bells = patches.buffer();
            patches.xyz_into(&self.bells, &mut bells);
            for (o, b) in out.as_flattened_mut().iter_mut().zip(bells.as_flattened()) {
                *o += b;
            }
        }
    }

    /// Adds the lines, those of no width weighed by a reflectance where they stand.
    fn add_lines(&self, reflectance: &Series, tables: &Tables, xyz: &mut [f64; 3]) {
        let weighed: Vec<Line> = self
            .ideal
            .iter()
            .map(|spike| Line {
                weight: spike.weight * reflectance.at(spike.at_nm),
                ..*spike
            })
            .collect();
        let mut bells = self.bells.clone();
        if !self.bells.is_empty() {
            let reflectance = reflectance.on_band();
            bells.iter_mut().zip(reflectance).for_each(|(b, r)| *b *= r);
        }
        let weights = &tables.viewing.weights;
        let lines = if bells.is_empty() {
            xyz_of_lines(&weighed, weights)
        } else {
            xyz_of_parts(reflectance.band, &bells, &weighed, weights)
        };
        for (x, l) in xyz.iter_mut().zip(lines.to_array()) {
            *x += l;
        }
    }

    /// What the patches of many orders share.
    pub(super) fn patch_work(&self, question: Question<'_>, tables: &Tables) -> Option<PatchWork> {
        let patches = tables.patches.as_ref()?;
        if !is_positive(self.white.y) {
            return None;
        }
        let mut exact = patches.set.buffer();
        patches.set.xyz_into(question.measured, &mut exact);
        let exact_labs = self.labs(&exact);
        let mut lines = patches.set.buffer();
        self.add_to_patches(&patches.set, &mut lines);
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
pub(super) struct PatchWork {
    white: Xyz,
    exact_labs: Vec<Lab>,
    labs: Vec<Lab>,
    model: Vec<[f64; 3]>,
    /// What the spikes add to each patch, whatever the order.
    lines: Vec<[f64; 3]>,
}

impl PatchWork {
    /// Mean and largest CIEDE2000 with these coefficients, products at 1 nm.
    pub(super) fn errors(&mut self, coefficients: &[f64], tables: &Tables) -> (f64, f64) {
        let Some(patches) = tables.patches.as_ref() else {
            return (0.0, 0.0);
        };
        patches.matrix.xyz_into(coefficients, &mut self.model);
        let lines = self.lines.as_flattened();
        for (m, l) in self.model.as_flattened_mut().iter_mut().zip(lines) {
            *m += l;
        }
        labs_into(&self.model, self.white, &mut self.labs);
        let found = difference(&self.exact_labs, &self.labs);
        (found.mean, found.max)
    }
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
    xyz_of_parts(band, &function, &[], &tables.viewing.weights).to_array()
}
