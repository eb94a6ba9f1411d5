//! Many reflectances under one light, fast enough for a slider.
//!
//! XYZ of a patch is linear in the light. [`PatchSet`] holds, per patch, reflectance times
//! colour-matching functions times trapezoid weights, so a light on the band's grid costs three
//! sums of products per patch. `PatchSet::contract` goes one step further: when the light is a
//! sum of basis functions, those sums are done once per basis function, and a light given by its
//! coefficients costs three products per patch and coefficient. Lines are added exactly.

use super::{
    ciede2000::delta_e_2000,
    lab::{Lab, lab_from_xyz},
    observer::Observer,
    xyz::Xyz,
};
use crate::spectrum::{Band, dot};

/// Reflectances on a band's grid, prepared for one observer.
#[derive(Clone, Debug)]
pub struct PatchSet {
    names: Vec<String>,
    band: Band,
    observer: Observer,
    /// `points x patches`: all patches' reflectances at a grid point lie together, for lines.
    reflectances: Vec<f64>,
    /// `(3 patches) x points`, then three rows of a perfect reflector: the light's own XYZ.
    weights: Vec<f64>,
}

/// The patches of a [`PatchSet`] in terms of a basis: XYZ from coefficients.
#[derive(Clone, Debug)]
pub struct PatchMatrix {
    patches: usize,
    /// `numbers x (3 patches)`: per basis function the XYZ of every patch, so that fewer
    /// coefficients simply use fewer rows.
    rows: Vec<f64>,
    /// The light's own XYZ per basis function.
    white: Vec<[f64; 3]>,
}

/// Colour difference of a set of patches between two lights.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PatchDifference {
    /// Mean CIEDE2000.
    pub mean: f64,
    /// Largest CIEDE2000.
    pub max: f64,
    /// Index of the patch with the largest.
    pub worst: usize,
}

impl PatchSet {
    /// Prepares reflectances (each on the band's grid, 0-1) for an observer.
    ///
    /// # Panics
    /// When names and reflectances differ in number, or a reflectance does not have
    /// [`Band::points`] values.
    pub fn new(
        reflectances: &[Vec<f64>],
        names: Vec<String>,
        band: Band,
        observer: Observer,
    ) -> Self {
        assert_eq!(names.len(), reflectances.len(), "one name per reflectance");
        let points = band.points();
        assert!(
            reflectances.iter().all(|r| r.len() == points),
            "one value per grid point"
        );
        let seen = observer.table().weighted_on_band(band);
        let mut weights = Vec::with_capacity(3 * (reflectances.len() + 1) * points);
        for reflectance in reflectances {
            for row in &seen {
                weights.extend(reflectance.iter().zip(row).map(|(r, w)| r * w));
            }
        }
        seen.iter().for_each(|row| weights.extend(row));
        let by_point = (0..points)
            .flat_map(|i| reflectances.iter().map(move |r| r[i]))
            .collect();
        Self {
            names,
            band,
            observer,
            reflectances: by_point,
            weights,
        }
    }

    /// Number of patches.
    pub fn len(&self) -> usize {
        self.names.len()
    }

    /// True if there are no patches.
    pub fn is_empty(&self) -> bool {
        self.names.is_empty()
    }

    /// Names, in patch order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// The band whose grid the reflectances are on.
    pub fn band(&self) -> Band {
        self.band
    }

    /// The observer.
    pub fn observer(&self) -> Observer {
        self.observer
    }

    /// A zeroed buffer for the functions below: `[X, Y, Z]` per patch.
    pub fn buffer(&self) -> Vec<[f64; 3]> {
        vec![[0.0; 3]; self.len()]
    }

    /// XYZ of every patch under a light on the band's grid, in value x nm, into `out`.
    ///
    /// # Panics
    /// When `light` or `out` has the wrong length.
    pub fn xyz_into(&self, light: &[f64], out: &mut [[f64; 3]]) {
        assert_eq!(out.len(), self.len(), "one XYZ per patch");
        assert_eq!(light.len(), self.band.points(), "one value per grid point");
        let rows = self.weights.chunks_exact(light.len());
        for (value, row) in out.as_flattened_mut().iter_mut().zip(rows) {
            *value = dot(light, row);
        }
    }

    /// XYZ of the light itself on the band's grid, in value x nm: the white of the patches.
    ///
    /// # Panics
    /// When `light` has the wrong length.
    pub fn white_xyz(&self, light: &[f64]) -> Xyz {
        assert_eq!(light.len(), self.band.points(), "one value per grid point");
        let rows = &self.weights[3 * self.len() * light.len()..];
        Xyz::from_array(std::array::from_fn(|k| {
            dot(light, &rows[k * light.len()..][..light.len()])
        }))
    }

    /// Adds a line of the light: `weight` (value x nm) at `at_nm`, reflectance and
    /// colour-matching functions linear between whole nm. Outside the band nothing is known of
    /// the patches and nothing is added.
    ///
    /// # Panics
    /// When `out` has the wrong length.
    pub fn add_line(&self, at_nm: f64, weight: f64, out: &mut [[f64; 3]]) {
        assert_eq!(out.len(), self.len(), "one XYZ per patch");
        if !self.band.contains(at_nm) {
            return;
        }
        let seen = self.observer.table().at(at_nm).map(|v| v * weight);
        let x = at_nm - self.band.min_nm();
        let left = (x as usize).min(self.band.steps() - 1);
        let t = x - left as f64;
        let (here, next) =
            self.reflectances[left * self.len()..][..2 * self.len()].split_at(self.len());
        for ((xyz, a), b) in out.iter_mut().zip(here).zip(next) {
            let reflectance = a * (1.0 - t) + b * t;
            for (value, s) in xyz.iter_mut().zip(seen) {
                *value += reflectance * s;
            }
        }
    }

    /// XYZ that a line adds to the light itself; zero outside the band, as [`PatchSet::add_line`].
    pub fn line_white_xyz(&self, at_nm: f64, weight: f64) -> Xyz {
        if !self.band.contains(at_nm) {
            return Xyz::ZERO;
        }
        Xyz::from_array(self.observer.table().at(at_nm)) * weight
    }

    /// The patches in terms of basis functions, each given by its values on the band's grid.
    ///
    /// A flat table of `numbers` rows is passed as `table.chunks_exact(band.points())`.
    ///
    /// # Panics
    /// When a basis function does not have [`Band::points`] values.
    pub(crate) fn contract<'a>(&self, basis: impl IntoIterator<Item = &'a [f64]>) -> PatchMatrix {
        let mut buffer = self.buffer();
        let (mut rows, mut white) = (Vec::new(), Vec::new());
        for function in basis {
            self.xyz_into(function, &mut buffer);
            rows.extend_from_slice(buffer.as_flattened());
            white.push(self.white_xyz(function).to_array());
        }
        PatchMatrix {
            patches: self.len(),
            rows,
            white,
        }
    }
}

impl PatchMatrix {
    /// Number of coefficients it takes.
    pub(crate) fn numbers(&self) -> usize {
        self.white.len()
    }

    /// XYZ of every patch under the light of these coefficients, into `out`. Fewer coefficients
    /// than `PatchMatrix::numbers` mean a shorter series.
    ///
    /// # Panics
    /// When there are more coefficients than numbers, or `out` has the wrong length.
    pub fn xyz_into(&self, coefficients: &[f64], out: &mut [[f64; 3]]) {
        assert_eq!(out.len(), self.patches, "one XYZ per patch");
        assert!(
            coefficients.len() <= self.numbers(),
            "too many coefficients"
        );
        let out = out.as_flattened_mut();
        out.fill(0.0);
        if out.is_empty() {
            return;
        }
        for (c, row) in coefficients.iter().zip(self.rows.chunks_exact(out.len())) {
            for (value, r) in out.iter_mut().zip(row) {
                *value += c * r;
            }
        }
    }

    /// XYZ of the light of these coefficients itself, in value x nm.
    ///
    /// # Panics
    /// When there are more coefficients than numbers.
    pub fn white_xyz(&self, coefficients: &[f64]) -> Xyz {
        assert!(
            coefficients.len() <= self.numbers(),
            "too many coefficients"
        );
        coefficients
            .iter()
            .zip(&self.white)
            .fold(Xyz::ZERO, |sum, (c, xyz)| sum + Xyz::from_array(*xyz) * *c)
    }
}

/// L\*a\*b\* of every patch against a white in the same scale, into `out`.
///
/// # Panics
/// When the lengths differ.
pub fn labs_into(patches: &[[f64; 3]], white: Xyz, out: &mut [Lab]) {
    assert_eq!(patches.len(), out.len(), "one Lab per patch");
    for (lab, xyz) in out.iter_mut().zip(patches) {
        *lab = lab_from_xyz(Xyz::from_array(*xyz), white);
    }
}

/// CIEDE2000 between two renderings of the same patches; all zero when there is no patch.
///
/// # Panics
/// When the lengths differ.
pub fn difference(reference: &[Lab], other: &[Lab]) -> PatchDifference {
    assert_eq!(reference.len(), other.len(), "the same patches twice");
    let mut found = PatchDifference::default();
    let mut sum = 0.0;
    for (index, (a, b)) in reference.iter().zip(other).enumerate() {
        let delta = delta_e_2000(*a, *b);
        sum += delta;
        if delta > found.max {
            (found.max, found.worst) = (delta, index);
        }
    }
    found.mean = sum / reference.len().max(1) as f64;
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    fn set() -> PatchSet {
        let ramp: Vec<f64> = BAND.grid().map(|nm| (nm - 300.0) / 600.0).collect();
        let wave: Vec<f64> = BAND
            .grid()
            .map(|nm| 0.5 + 0.4 * (nm / 40.0).sin())
            .collect();
        let names = ["ramp", "wave", "white"].map(String::from).to_vec();
        let white = vec![1.0; BAND.points()];
        PatchSet::new(&[ramp, wave, white], names, BAND, Observer::CIE_1931)
    }

    fn light() -> Vec<f64> {
        BAND.grid().map(|nm| 1.0 + (nm / 90.0).cos()).collect()
    }

    fn nearly(a: &[[f64; 3]], b: &[[f64; 3]]) -> bool {
        // Sums of about 400 products near 1, in different orders.
        a.as_flattened()
            .iter()
            .zip(b.as_flattened())
            .all(|(x, y)| (x - y).abs() < 1e-11)
    }

    #[test]
    fn a_patch_is_the_trapezoid_integral_of_light_reflectance_and_observer() {
        let (set, light) = (set(), light());
        let mut out = set.buffer();
        set.xyz_into(&light, &mut out);
        let cmf = Observer::CIE_1931.table().on_band(BAND);
        let seen: Vec<f64> = (0..BAND.points())
            .map(|i| light[i] * (BAND.nm(i) - 300.0) / 600.0)
            .collect();
        let expected = std::array::from_fn(|k| BAND.inner(&seen, &cmf[k]));
        assert!(nearly(&out[..1], &[expected]));
    }

    #[test]
    fn a_perfect_reflector_is_the_white() {
        let (set, light) = (set(), light());
        let mut out = set.buffer();
        set.xyz_into(&light, &mut out);
        assert_eq!(out[2], set.white_xyz(&light).to_array());
        set.add_line(546.1, 3.0, &mut out);
        let white = set.white_xyz(&light) + set.line_white_xyz(546.1, 3.0);
        assert!(nearly(&out[2..], &[white.to_array()]));
    }

    #[test]
    fn coefficients_give_the_same_as_the_light_they_stand_for() {
        let set = set();
        let basis: Vec<Vec<f64>> = (0..5)
            .map(|n| {
                BAND.grid()
                    .map(|nm| (f64::from(n) * (nm - 380.0) / 400.0).cos())
                    .collect()
            })
            .collect();
        let matrix = set.contract(basis.iter().map(Vec::as_slice));
        assert_eq!(matrix.numbers(), 5);
        let flat = basis.concat();
        let again = set.contract(flat.chunks_exact(BAND.points()));
        let coefficients = [1.0, -0.3, 0.2, 0.05];
        let light: Vec<f64> = (0..BAND.points())
            .map(|i| coefficients.iter().zip(&basis).map(|(c, f)| c * f[i]).sum())
            .collect();
        let (mut direct, mut short, mut same) = (set.buffer(), set.buffer(), set.buffer());
        set.xyz_into(&light, &mut direct);
        matrix.xyz_into(&coefficients, &mut short);
        again.xyz_into(&coefficients, &mut same);
        assert!(nearly(&direct, &short));
        assert_eq!(short, same);
        let white = matrix.white_xyz(&coefficients).to_array();
        assert!(nearly(&[white], &[set.white_xyz(&light).to_array()]));
    }

    #[test]
    fn a_line_on_a_grid_point_is_one_nm_of_light_there() {
        let set = set();
        let mut spike = set.buffer();
        set.add_line(550.0, 2.0, &mut spike);
        let mut light = vec![0.0; BAND.points()];
        light[170] = 2.0;
        let mut nm = set.buffer();
        set.xyz_into(&light, &mut nm);
        assert!(nearly(&spike, &nm));
        for edge_nm in [380.0, 780.0] {
            let mut at_edge = set.buffer();
            set.add_line(edge_nm, 1.0, &mut at_edge);
            assert_eq!(at_edge[2], Observer::CIE_1931.table().at(edge_nm));
        }
        let mut outside = set.buffer();
        set.add_line(900.0, 1.0, &mut outside);
        assert_eq!(outside, set.buffer());
    }

    #[test]
    fn equal_patches_do_not_differ_and_the_worst_one_is_named() {
        let labs = [Lab::new(50.0, 10.0, 0.0), Lab::new(40.0, 0.0, 5.0)];
        assert_eq!(difference(&labs, &labs), PatchDifference::default());
        let other = [labs[0], Lab::new(42.0, 0.0, 5.0)];
        let found = difference(&labs, &other);
        assert_eq!(found.worst, 1);
        assert_eq!(found.mean, found.max / 2.0);
        assert_eq!(difference(&[], &[]), PatchDifference::default());
    }
}
