//! A spectrum projected so that any choice of lines and numbers is a subtraction.
//!
//! Projection is linear: the coefficients of what is left when some lines are taken out are the
//! spectrum's own minus those of the lines. So a spectrum is projected once, each line once, and
//! every model that a study looks at is a prefix and a few subtractions.

use std::sync::Arc;

use crate::{
    color::Weights,
    spectrum::{
        Band, Basis, BasisTable, Composite, Exactness, InnerProducts, Line, LineShape, Series,
    },
};

/// Basis functions and their inner products with what makes the colour, for one basis.
#[derive(Clone, Debug)]
pub struct FitBasis {
    /// The functions on the grid.
    pub table: Arc<BasisTable>,
    /// Their inner products with the three weights that make the subject's colour.
    pub colour: Arc<InnerProducts>,
}

impl FitBasis {
    /// Up to `numbers` functions of a basis, for colours made by `seen` (three weights on the
    /// band's grid).
    pub(crate) fn new(band: Band, basis: Basis, numbers: usize, seen: &Weights) -> Self {
        let table = BasisTable::new(band, basis, numbers);
        Self {
            colour: Arc::new(InnerProducts::new(&table, seen)),
            table: Arc::new(table),
        }
    }
}

/// A line that may become a spike, with all that taking it out changes.
#[derive(Clone, Debug)]
struct ProjectedLine {
    spike: Line,
    /// Coefficients of what it takes out.
    coefficients: Vec<f64>,
    /// X, Y, Z of its spike.
    xyz: [f64; 3],
}

/// A spectrum and its lines in terms of one basis.
#[derive(Clone, Debug)]
pub struct ProjectedSpectrum {
    fit_basis: FitBasis,
    /// Coefficients of the whole spectrum.
    whole: Vec<f64>,
    /// X, Y, Z of the whole spectrum.
    xyz: [f64; 3],
    lines: Vec<ProjectedLine>,
}

impl ProjectedSpectrum {
    /// Projects a spectrum (values on the band's grid) and what each of its lines takes out.
    ///
    /// `seen` are the weights the basis was made with.
    pub(crate) fn new(
        fit_basis: &FitBasis,
        values: &[f64],
        shapes: &[LineShape],
        seen: &Weights,
    ) -> Self {
        Self::with_profiles(fit_basis, values, shapes, &[], seen)
    }

    /// The same where lines have profiles: such a line takes its profile out of the spectrum, and its
    /// colour is that of the profile. It is for who asked to add the profile where the model has its
    /// spike.
    pub(crate) fn with_profiles(
        fit_basis: &FitBasis,
        values: &[f64],
        shapes: &[LineShape],
        profiles: &[Option<LineShape>],
        seen: &Weights,
    ) -> Self {
        let (table, band) = (&fit_basis.table, fit_basis.table.band());
        let numbers = table.numbers();
        let lines = shapes
            .iter()
            .enumerate()
            .map(|(i, shape)| {
                let profile = profiles.get(i).and_then(Option::as_ref);
                let mut taken = vec![0.0; band.points()];
                profile.unwrap_or(shape).give_back_to(&mut taken);
                ProjectedLine {
                    spike: shape.spike,
                    coefficients: table.project(&taken, numbers),
                    xyz: match profile {
                        Some(_) => seen.each_ref().map(|row| band.inner(&taken, row)),
                        None => seen.at(shape.spike.at_nm).map(|v| v * shape.spike.weight),
                    },
                }
            })
            .collect();
        Self {
            whole: table.project(values, numbers),
            xyz: std::array::from_fn(|k| band.inner(values, &seen[k])),
            lines,
            fit_basis: fit_basis.clone(),
        }
    }

    /// Number of lines that may become spikes.
    pub fn lines(&self) -> usize {
        self.lines.len()
    }

    /// Most of them among so many numbers: a spike costs two, and three carry the colour.
    pub(crate) fn most_lines(&self, numbers: usize) -> usize {
        self.lines.len().min(numbers.saturating_sub(3) / 2)
    }

    /// The spike that line `index` would become.
    pub(crate) fn spike(&self, index: usize) -> Line {
        self.lines[index].spike
    }

    /// The model of `numbers` smooth numbers (at least one, at most what the basis has) with those
    /// lines as spikes, and how the colour-exact fit went.
    pub fn model(
        &self,
        numbers: usize,
        lines: &[usize],
        colour_exact: bool,
    ) -> (Composite, Exactness) {
        let numbers = numbers.clamp(1, self.whole.len());
        let mut coefficients = self.whole[..numbers].to_vec();
        let mut target = self.xyz;
        let mut spikes = Vec::with_capacity(lines.len());
        for line in lines.iter().map(|index| &self.lines[*index]) {
            for (c, taken) in coefficients.iter_mut().zip(&line.coefficients) {
                *c -= taken;
            }
            for (t, xyz) in target.iter_mut().zip(line.xyz) {
                *t -= xyz;
            }
            spikes.push(line.spike);
        }
        spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
        let exactness = if colour_exact {
            self.fit_basis.colour.make_exact(&mut coefficients, target)
        } else {
            Exactness::TooFewNumbers
        };
        let smooth = Series::new(
            self.fit_basis.table.band(),
            self.fit_basis.table.basis(),
            coefficients,
        );
        (Composite::of_lines_inside(smooth, spikes), exactness)
    }

    /// A model's smooth part on the grid.
    pub fn smooth(&self, model: &Composite) -> Vec<f64> {
        self.fit_basis.table.evaluate(&model.smooth().coefficients)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        color::Observer,
        spectrum::{SpikeSettings, detect, detect_shapes},
    };

    const BAND: Band = Band::VISIBLE;

    /// A bulge with two lines.
    fn lamp() -> Vec<f64> {
        let profile = |nm: f64, at: f64, w: f64| (-((nm - at) / w).powi(2)).exp();
        BAND.grid()
            .map(|nm| {
                profile(nm, 560.0, 80.0)
                    + 4.0 * profile(nm, 546.0, 2.0)
                    + 3.0 * profile(nm, 436.0, 2.0)
            })
            .collect()
    }

    #[test]
    fn the_shapes_of_all_lines_and_the_smooth_part_are_the_spectrum() {
        let values = lamp();
        let (parts, shapes) = detect_shapes(BAND, &values, SpikeSettings::default());
        assert_eq!(shapes.len(), 2);
        assert!(shapes[0].spike.weight >= shapes[1].spike.weight);
        assert_eq!(parts, detect(BAND, &values, SpikeSettings::default()));
        let mut sum = parts.smooth;
        shapes.iter().for_each(|shape| shape.give_back_to(&mut sum));
        // One subtraction and one addition of numbers up to 5.
        assert!(sum.iter().zip(&values).all(|(s, v)| (s - v).abs() < 1e-14));
    }

    #[test]
    fn subtracting_a_lines_coefficients_is_fitting_what_is_left() {
        let values = lamp();
        let (_, shapes) = detect_shapes(BAND, &values, SpikeSettings::default());
        let seen = Observer::CIE_1931.table().on_band(BAND);
        for basis in Basis::ALL {
            let fit_basis = FitBasis::new(BAND, basis, 31, &seen);
            let projected = ProjectedSpectrum::new(&fit_basis, &values, &shapes, &seen);
            assert_eq!(projected.lines(), 2);
            let mut left = values.clone();
            shapes[1].take_from(&mut left);
            let (model, _) = projected.model(15, &[1], false);
            for (c, direct) in model
                .smooth()
                .coefficients
                .iter()
                .zip(fit_basis.table.project(&left, 15))
            {
                // Sums of 401 products near 1, in another order.
                assert!((c - direct).abs() < 1e-13);
            }
            assert_eq!(model.lines(), [projected.spike(1)]);
            assert_eq!(model.numbers(), 17);
        }
    }

    #[test]
    fn the_colour_exact_model_has_the_spectrums_own_colour_with_any_lines() {
        let values = lamp();
        let (_, shapes) = detect_shapes(BAND, &values, SpikeSettings::default());
        let seen = Observer::CIE_1931.table().on_band(BAND);
        let fit_basis = FitBasis::new(BAND, Basis::Cosine, 31, &seen);
        let projected = ProjectedSpectrum::new(&fit_basis, &values, &shapes, &seen);
        for lines in [&[][..], &[0], &[1], &[0, 1]] {
            let (model, exactness) = projected.model(7, lines, true);
            assert!(exactness.is_exact());
            for row in seen.iter() {
                let found = model.integrate(|nm| BAND.interpolate(row, nm));
                let exact = BAND.inner(&values, row);
                // A 3 x 3 solve of condition about 10 on sums near 100.
                assert!((found / exact - 1.0).abs() < 1e-10, "{found} {exact}");
            }
        }
    }
}
