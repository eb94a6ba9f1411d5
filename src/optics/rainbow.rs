//! A ray of sunlight in a drop of water, and the bows of many.
//!
//! With impact b (in radii): `sin i = b`, `sin r = b / n`; after k reflections inside a ray is turned
//! by `D_k = k 180 + 2 i - 2 (k + 1) r`. Geometric optics: no supernumerary bows, drops above
//! .5 mm.

use super::{fresnel::reflectances, index::Material, index_error::IndexError};

/// A ray in a drop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DropRay {
    /// Distance from the axis, radii, 0-1.
    pub impact: f64,
    /// Angle of incidence, degrees.
    pub incidence_deg: f64,
    /// Angle inside, degrees.
    pub refraction_deg: f64,
    /// Reflected shares at each face, across the plane of incidence (s) and in it (p).
    pub reflectance_s_p: [f64; 2],
}

/// A bow: where the deviation stands still.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bow {
    /// Reflections inside: 1 for the primary, 2 for the secondary bow.
    pub order: u32,
    /// Its ray.
    pub ray: DropRay,
    /// How far light is turned, degrees.
    pub deviation_deg: f64,
    /// Angle from the antisolar point, degrees.
    pub from_antisolar_deg: f64,
    /// Share of the ray's energy that goes there, s and p.
    pub weights_s_p: [f64; 2],
}

impl Bow {
    /// Degree of polarisation, 0-1.
    pub fn polarisation(&self) -> f64 {
        let [s, p] = self.weights_s_p;
        (s - p) / (s + p)
    }
}

/// Both bows of a wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bows {
    /// Wavelength, nm.
    pub at_nm: f64,
    /// Index of refraction.
    pub n: f64,
    /// The inner, brighter bow; `None` above an index of 2.
    pub primary: Option<Bow>,
    /// The outer bow; `None` above an index of 3.
    pub secondary: Option<Bow>,
}

impl DropRay {
    /// A ray by its impact, which is cut to 0-1, in a drop of an index above 1.
    pub fn new(impact: f64, n: f64) -> Self {
        let impact = impact.clamp(0.0, 1.0);
        let (sin_r, cos_i) = (impact / n, (1.0 - impact * impact).sqrt());
        let cos_r = (1.0 - sin_r * sin_r).sqrt();
        Self {
            impact,
            incidence_deg: impact.atan2(cos_i).to_degrees(),
            refraction_deg: sin_r.atan2(cos_r).to_degrees(),
            reflectance_s_p: reflectances(1.0, cos_i, n, cos_r),
        }
    }

    /// How far the ray is turned after reflections inside, degrees.
    pub fn deviation_deg(&self, reflections: u32) -> f64 {
        let k = f64::from(reflections);
        k * 180.0 + 2.0 * self.incidence_deg - 2.0 * (k + 1.0) * self.refraction_deg
    }

    /// Share of the energy that leaves after reflections inside, s and p.
    pub fn weights_s_p(&self, reflections: u32) -> [f64; 2] {
        let power = i32::try_from(reflections).unwrap_or(i32::MAX);
        self.reflectance_s_p
            .map(|r| (1.0 - r) * (1.0 - r) * r.powi(power))
    }
}

/// The bow after one or more reflections in a drop of an index; `None` where there is none.
pub fn bow(n: f64, reflections: u32) -> Option<Bow> {
    let k = f64::from(reflections);
    let cos_squared = (n * n - 1.0) / (k * (k + 2.0));
    if !(reflections >= 1 && cos_squared > 0.0 && cos_squared < 1.0) {
        return None;
    }
    let ray = DropRay::new((1.0 - cos_squared).sqrt(), n);
    let deviation_deg = ray.deviation_deg(reflections);
    Some(Bow {
        order: reflections,
        ray,
        deviation_deg,
        from_antisolar_deg: from_antisolar(deviation_deg),
        weights_s_p: ray.weights_s_p(reflections),
    })
}

/// Angle from the antisolar point, 0-180 degrees, of light that was turned by an angle.
pub(crate) fn from_antisolar(deviation_deg: f64) -> f64 {
    (deviation_deg.rem_euclid(360.0) - 180.0).abs()
}

impl Bows {
    /// The bows of a wavelength.
    ///
    /// # Errors
    /// [`IndexError`] where the material has no index.
    pub fn new(material: &Material, at_nm: f64) -> Result<Self, IndexError> {
        let n = material.index(at_nm)?;
        Ok(Self {
            at_nm,
            n,
            primary: bow(n, 1),
            secondary: bow(n, 2),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reflection_at_the_bows_does_not_depend_on_the_index() {
        for n in [1.1, 1.333, 1.5, 1.9] {
            for (order, r, weight) in [
                (1, 1.0 / 9.0, (8.0_f64 / 9.0).powi(2) / 9.0),
                (2, 1.0 / 4.0, 0.75_f64.powi(2) / 16.0),
            ] {
                let bow = bow(n, order).unwrap();
                // tan i = (k + 1) tan r; a few operations on numbers below 1.
                assert!((bow.ray.reflectance_s_p[0] - r).abs() < 1e-14);
                assert!((bow.weights_s_p[0] - weight).abs() < 1e-14);
            }
        }
    }

    #[test]
    fn at_a_bow_the_deviation_stands_still() {
        for order in [1, 2] {
            let bow = bow(1.333, order).unwrap();
            let at = |off: f64| DropRay::new(bow.ray.impact + off, 1.333).deviation_deg(order);
            assert!(at(1e-3) > bow.deviation_deg && at(-1e-3) > bow.deviation_deg);
            // Quadratic: a hundredth of the way, a ten thousandth of the rise.
            let ratio = (at(1e-4) - bow.deviation_deg) / (at(1e-2) - bow.deviation_deg);
            assert!(ratio < 2e-4, "{ratio}");
        }
    }

    #[test]
    fn all_ways_out_of_a_drop_make_the_whole() {
        for impact in [0.0, 0.3, 0.86, 0.99, 1.0] {
            let ray = DropRay::new(impact, 1.333);
            for polarisation in 0..2 {
                let outside = ray.reflectance_s_p[polarisation];
                let inside: f64 = (0..4000).map(|k| ray.weights_s_p(k)[polarisation]).sum();
                // 4000 terms; at b = .99 R = .58, so nothing is left after 100.
                assert!((outside + inside - 1.0).abs() < 1e-12, "{impact}");
            }
        }
    }

    #[test]
    fn bows_end_where_the_index_is_too_high() {
        assert!(bow(2.1, 1).is_none() && bow(2.1, 2).is_some());
        assert!(bow(1.333, 0).is_none() && bow(1.0, 1).is_none());
        assert!(bow(f64::NAN, 1).is_none());
    }
}
