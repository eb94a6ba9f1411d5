//! A ray of sunlight in a drop of water, and the bows of many.
//!
//! With impact b (in radii): `sin i = b`, `sin r = b / n`; after k reflections inside a ray is turned
//! by `D_k = k 180 + 2 i - 2 (k + 1) r`. Geometric optics: no supernumerary bows, drops above
//! .5 mm.

use super::{fresnel::reflectances, index::Material, index_error::IndexError};

/// A ray in a drop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct DropRay {
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
pub(crate) struct Bow {
    /// Reflections inside: 1 for the primary, 2 for the secondary bow.
    pub order: u32,
    /// Its ray.
    pub ray: DropRay,
    /// Deviation of the light, degrees.
    pub deviation_deg: f64,
    /// Angle from the antisolar point, degrees.
    pub from_antisolar_deg: f64,
    /// Share of the ray's energy that goes there, s and p.
    pub weights_s_p: [f64; 2],
}

impl Bow {
    /// Degree of polarisation, 0-1.
    pub(crate) fn polarisation(&self) -> f64 {
        let [s, p] = self.weights_s_p;
        (s - p) / (s + p)
    }
}

/// Both bows of a wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bows {
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
    pub(crate) fn new(impact: f64, n: f64) -> Self {
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

    /// Deviation of the ray after reflections inside, degrees.
    pub(crate) fn deviation_deg(&self, reflections: u32) -> f64 {
        let k = f64::from(reflections);
        k * 180.0 + 2.0 * self.incidence_deg - 2.0 * (k + 1.0) * self.refraction_deg
    }

    /// Share of the energy that leaves after reflections inside, s and p.
    pub(crate) fn weights_s_p(&self, reflections: u32) -> [f64; 2] {
        let power = i32::try_from(reflections).unwrap_or(i32::MAX);
        self.reflectance_s_p
            .map(|r| (1.0 - r) * (1.0 - r) * r.powi(power))
    }
}

/// The bow after one or more reflections in a drop of an index; `None` where there is none.
pub(crate) fn bow(n: f64, reflections: u32) -> Option<Bow> {
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
    pub(crate) fn new(material: &Material, at_nm: f64) -> Result<Self, IndexError> {
        let n = material.index(at_nm)?;
        Ok(Self {
            at_nm,
            n,
            primary: bow(n, 1),
            secondary: bow(n, 2),
        })
    }
}
