//! Tristimulus values.
//!
//! Two ways lead to XYZ. Measured data go through CIE sums on whole nm, 360-830 (the
//! "full" colour; where a table is at hand, over the observer's whole range). Models are integrated against a weight, so that spikes are exact: on a band's
//! grid by `xyz_of_parts`, of anything that can be integrated by `xyz_from_integral`.

use std::ops::{Add, AddAssign, Mul, Sub};

use super::{
    observer::{ColourMatching, Observer},
    weights::Weights,
};
use crate::spectrum::{Band, Composite, Line, Outside, Sampled, dot};

/// First wavelength of the CIE sums, nm.
pub(crate) const FIRST_NM: u32 = 360;

/// Last wavelength of the CIE sums, nm.
pub(crate) const LAST_NM: u32 = 830;

/// Number of whole nm in the CIE sums.
pub const POINTS: usize = (LAST_NM - FIRST_NM + 1) as usize;

/// CIE tristimulus values; the scale is the caller's (most often Y = 100 for the light).
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Xyz {
    /// X.
    pub x: f64,
    /// Y.
    pub y: f64,
    /// Z.
    pub z: f64,
}

impl Xyz {
    /// No light.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// From three numbers.
    pub const fn new(x: f64, y: f64, z: f64) -> Self {
        Self { x, y, z }
    }

    /// From `[X, Y, Z]`.
    pub const fn from_array([x, y, z]: [f64; 3]) -> Self {
        Self { x, y, z }
    }

    /// As `[X, Y, Z]`.
    pub const fn to_array(self) -> [f64; 3] {
        [self.x, self.y, self.z]
    }

    /// All three multiplied by a factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }

    /// Scaled so that Y is `y`; `None` when there is no positive Y to scale.
    pub(crate) fn with_y(self, y: f64) -> Option<Self> {
        let scaled = Self::new(self.x / self.y * y, y, self.z / self.y * y);
        (self.y > 0.0 && scaled.is_finite()).then_some(scaled)
    }

    /// True if all three are finite numbers.
    pub fn is_finite(self) -> bool {
        self.x.is_finite() && self.y.is_finite() && self.z.is_finite()
    }
}

impl Add for Xyz {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl AddAssign for Xyz {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Xyz {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<f64> for Xyz {
    type Output = Self;
    fn mul(self, factor: f64) -> Self {
        self.scaled(factor)
    }
}

/// XYZ of anything that can be integrated against a weight, in value x nm (not normalised).
///
/// `integrate(w)` must return the integral of `spectrum(nm) * w(nm)` over nm; a line of weight
/// `s` at `l` contributes `s * w(l)`.
#[cfg(test)]
pub(crate) fn xyz_from_integral(
    integrate: impl Fn(&dyn Fn(f64) -> f64) -> f64,
    observer: Observer,
) -> Xyz {
    let table = observer.table();
    Xyz::from_array(std::array::from_fn(|k| integrate(&|nm| table.at(nm)[k])))
}

/// XYZ of a smooth part on a band's grid and lines, an ideal one weighed where it stands and a wide
/// one over its Gaussian; in value x nm (not normalised). `weights` are what counts for X, Y
/// and Z on the grid: colour-matching functions, times a light for what it falls on.
///
/// # Panics
/// When a slice does not have [`Band::points`] entries.
pub(crate) fn xyz_of_parts(band: Band, smooth: &[f64], spikes: &[Line], weights: &Weights) -> Xyz {
    let smooth = Xyz::from_array(weights.each_ref().map(|row| band.inner(smooth, row)));
    smooth + xyz_of_lines(spikes, weights)
}

/// XYZ of lines alone, as [`xyz_of_parts`].
pub(crate) fn xyz_of_lines(lines: &[Line], weights: &Weights) -> Xyz {
    let of_line = |line| Xyz::from_array(weights.of_line(line));
    lines
        .iter()
        .map(of_line)
        .fold(Xyz::ZERO, |sum, xyz| sum + xyz)
}

impl Composite {
    /// XYZ to an observer by the trapezoid rule on the band's grid, each ideal line weighed where
    /// it stands and each wide one over its Gaussian; in value x nm (not normalised).
    ///
    /// ```
    /// use spectral_explorer::{
    ///     color::{Observer, xy_from_xyz},
    ///     spectrum::{Band, Basis, Composite, Line, Series},
    /// };
    ///
    /// let smooth = Series { band: Band::VISIBLE, basis: Basis::Cosine, coefficients: vec![1.0] };
    /// let sodium = Line::ideal(589.3, 500.0);
    /// let lamp = Composite::new(smooth, vec![sodium]).expect("a line of the band");
    /// let [x, y] = xy_from_xyz(lamp.xyz(Observer::CIE_1931)).expect("a colour");
    /// assert!(x > 0.5 && y > 0.4);
    /// ```
    pub fn xyz(&self, observer: Observer) -> Xyz {
        let weights = observer.table().on_band(self.band());
        xyz_of_parts(
            self.band(),
            &self.smooth().on_band(),
            self.lines(),
            &weights,
        )
    }
}

/// XYZ of what is 1 at every nm, as [`xyz_of_parts`]: a perfect reflector where the weights are a
/// light's.
pub(crate) fn xyz_of_one(band: Band, weights: &[Vec<f64>; 3]) -> Xyz {
    Xyz::from_array(weights.each_ref().map(|row| band.integral(row)))
}

impl ColourMatching {
    /// XYZ of values on the whole nm of the table.
    fn sum_over_table(&self, values: &[f64]) -> Xyz {
        Xyz::from_array(self.xyz.each_ref().map(|row| dot(values, row)))
    }

    /// XYZ of a light from its values on whole nm 360-830: plain sums over what the table and that
    /// range share, not normalised.
    ///
    /// # Panics
    /// When `light` does not have [`POINTS`] values.
    pub(crate) fn xyz_of_nm_values(&self, light: &[f64]) -> Xyz {
        assert_eq!(light.len(), POINTS, "one value per nm of 360-830");
        let first_nm = self.first_nm.max(FIRST_NM);
        let count = (self.last_nm.min(LAST_NM) + 1).saturating_sub(first_nm) as usize;
        Xyz::from_array(std::array::from_fn(|k| {
            if count == 0 {
                return 0.0;
            }
            let row = &self.xyz[k][(first_nm - self.first_nm) as usize..][..count];
            dot(&light[(first_nm - FIRST_NM) as usize..][..count], row)
        }))
    }
}

/// XYZ of a light from its values on whole nm 360-830: plain sums, not normalised.
///
/// # Panics
/// When `light` does not have [`POINTS`] values.
pub(crate) fn xyz_from_nm_values(light: &[f64], observer: Observer) -> Xyz {
    observer.table().xyz_of_nm_values(light)
}

/// XYZ of a light with Y = 100: linear to whole nm, plain sums over the observer's whole table.
///
/// `None` when Y is not positive: no light, light outside the visible, or negative samples that
/// outweigh the rest.
pub fn xyz_from_light(light: &Sampled, outside: Outside, observer: Observer) -> Option<Xyz> {
    let table = observer.table();
    let values = light.on_whole_nm(table.first_nm, table.last_nm, outside);
    table.sum_over_table(&values).with_y(100.0)
}

/// XYZ of a reflectance (or transmittance) under a light, Y = 100 for the light itself.
///
/// The light is zero outside its table, the reflectance goes on with its end values. `None` when
/// the light's Y is not positive.
pub fn xyz_from_reflectance(
    reflectance: &Sampled,
    light: &Sampled,
    observer: Observer,
) -> Option<Xyz> {
    let table = observer.table();
    let on_table =
        |sampled: &Sampled, outside| sampled.on_whole_nm(table.first_nm, table.last_nm, outside);
    let light = on_table(light, Outside::Zero);
    let white = table.sum_over_table(&light);
    let shares = on_table(reflectance, Outside::Hold);
    let product: Vec<f64> = shares.iter().zip(&light).map(|(r, s)| r * s).collect();
    let raw = table.sum_over_table(&product);
    let scaled = Xyz::new(raw.x / white.y, raw.y / white.y, raw.z / white.y) * 100.0;
    (white.y > 0.0 && scaled.is_finite()).then_some(scaled)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(value: f64) -> Sampled {
        Sampled::new(vec![360.0, 830.0], vec![value, value]).unwrap()
    }

    #[test]
    fn a_table_of_any_range_is_summed_over_what_it_shares_with_the_light() {
        let whole = Observer::CIE_1931.table();
        let light: Vec<f64> = (0..POINTS).map(|i| 1.0 + (i as f64 / 40.0).sin()).collect();
        for (first_nm, last_nm) in [(300, 830), (390, 780), (300, 900), (700, 1000), (200, 300)] {
            let row = |k: usize| {
                let value = |nm: u32| whole.at(f64::from(nm))[k];
                (first_nm..=last_nm).map(value).collect()
            };
            let table = ColourMatching {
                first_nm,
                last_nm,
                xyz: [row(0), row(1), row(2)],
            };
            let by_hand = |k: usize| -> f64 {
                let values = light.iter().zip(FIRST_NM..);
                let inside = values.filter(|(_, nm)| (first_nm..=last_nm).contains(nm));
                inside.map(|(v, nm)| v * whole.at(f64::from(nm))[k]).sum()
            };
            let found = table.xyz_of_nm_values(&light).to_array();
            for (k, found) in found.into_iter().enumerate() {
                // The same products summed in another order.
                assert!(
                    (found - by_hand(k)).abs() < 1e-10,
                    "{first_nm}-{last_nm} nm"
                );
            }
        }
    }

    #[test]
    fn a_flat_light_gives_the_sums_of_the_table() {
        for observer in Observer::CIE {
            let xyz = xyz_from_light(&flat(3.0), Outside::Zero, observer).unwrap();
            let [x, y, z] = observer.table().sums();
            assert_eq!(xyz.y, 100.0);
            // The same 471 products summed in another order.
            assert!((xyz.x - 100.0 * x / y).abs() < 1e-11);
            assert!((xyz.z - 100.0 * z / y).abs() < 1e-11);
        }
    }

    #[test]
    fn a_perfect_reflector_has_the_colour_of_the_light() {
        let light = Sampled::new(vec![400.0, 550.0, 700.0], vec![0.2, 1.0, 0.7]).unwrap();
        let seen = xyz_from_reflectance(&flat(1.0), &light, Observer::CIE_1964).unwrap();
        let own = xyz_from_light(&light, Outside::Zero, Observer::CIE_1964).unwrap();
        // Identical products; only the order of scaling differs.
        assert!((seen.x - own.x).abs() < 1e-12 && (seen.z - own.z).abs() < 1e-12);
    }

    #[test]
    fn no_light_no_visible_light_and_negative_light_have_no_colour() {
        let infrared = Sampled::new(vec![900.0, 1000.0], vec![1.0, 1.0]).unwrap();
        let huge = flat(f64::MAX);
        for light in [flat(0.0), flat(-1.0), infrared, huge] {
            assert_eq!(
                xyz_from_light(&light, Outside::Zero, Observer::CIE_1931),
                None
            );
            assert_eq!(
                xyz_from_reflectance(&flat(0.5), &light, Observer::CIE_1931),
                None
            );
        }
    }

    #[test]
    fn a_line_is_weighed_exactly_through_the_integral() {
        let xyz = xyz_from_integral(|weight| 2.5 * weight(546.1), Observer::CIE_1931);
        let [x, y, z] = Observer::CIE_1931.table().at(546.1);
        assert_eq!(xyz, Xyz::new(2.5 * x, 2.5 * y, 2.5 * z));
    }

    #[test]
    fn arithmetic_is_by_component() {
        let (a, b) = (Xyz::new(1.0, 2.0, 3.0), Xyz::new(0.5, 0.25, -1.0));
        assert_eq!(a + b - b, a);
        assert_eq!(a * 2.0, Xyz::from_array([2.0, 4.0, 6.0]));
        let mut sum = a;
        sum += b;
        assert_eq!(sum.to_array(), [1.5, 2.25, 2.0]);
        assert_eq!(Xyz::ZERO.with_y(100.0), None);
    }
}
