//! A ray through a prism, in its principal section.
//!
//! With apex angle A and incidence i1 (from the normal, towards the base): `sin r1 = sin i1 / n`,
//! `r2 = A - r1`, `sin i2 = n sin r2`, deviation `D = i1 + i2 - A`. Polarisations go through both
//! faces apart. Angles are degrees in what is public.

use crate::languages::{fixed, with_sign};

use super::{fresnel::reflectances, index::Material, index_error::IndexError};

/// Incidence of the light on the first face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Incidence {
    /// At an angle from the normal, degrees, positive towards the base.
    Degrees(f64),
    /// At that of least deviation for a wavelength, nm.
    MinimumFor(f64),
}

/// Apex and incidence of a prism; both in range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Prism {
    apex: f64,
    incidence: f64,
    apex_deg: f64,
    incidence_deg: f64,
    /// Sine and cosine of the apex, of half of it, and of the incidence.
    of_apex: [f64; 2],
    pub(super) of_half_apex: [f64; 2],
    pub(super) of_incidence: [f64; 2],
}

/// Passage of a ray of one wavelength.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Passage {
    /// Index of refraction.
    pub n: f64,
    /// Angle of leaving the second face, from its normal towards the base.
    pub exit_deg: f64,
    /// Deviation of the ray.
    pub deviation_deg: f64,
    /// Share let through by both faces, polarised across the plane of incidence (s) and in it (p).
    pub transmittance_s_p: [f64; 2],
    pub(super) sin_cos: Angles,
}

/// Sines and cosines of a passage, for what is computed many times.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Angles {
    pub(super) sin_r1: f64,
    pub(super) cos_r1: f64,
    pub(super) cos_r2: f64,
    pub(super) sin_i2: f64,
    pub(super) cos_i2: f64,
}

/// Limits of a prism at an index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Angle of total reflection.
    pub critical_deg: f64,
    /// No ray passes a prism with a larger apex.
    pub largest_apex_deg: f64,
    /// Smallest incidence that passes; `None` where no ray does.
    pub smallest_incidence_deg: Option<f64>,
}

/// Why there is no prism.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PrismError {
    /// An invalid apex.
    #[error(
        "{}",
        tr!(
            "apex: expected an angle above 0 and below 180 degrees, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    Apex { found: f64 },
    /// An incidence from behind.
    #[error(
        "{}",
        tr!(
            "incidence: expected an angle above -90 and below 90 degrees, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    Incidence { found: f64 },
    /// No ray of the wavelength has a least deviation: it is totally reflected.
    #[error(
        "{}",
        tr!(
            "no light of {at_nm} nm leaves: apex above twice the critical angle \
             ({largest_apex_deg})",
            at_nm = with_sign(at_nm.to_string()),
            largest_apex_deg = fixed(largest_apex_deg, 1)
        )
    )]
    NoMinimum { at_nm: f64, largest_apex_deg: f64 },
    /// The index is not known.
    #[error(transparent)]
    Index(#[from] IndexError),
}

impl Prism {
    /// A prism of an apex angle in degrees, met by light at an angle.
    ///
    /// # Errors
    /// [`PrismError`] for an apex outside (0, 180), an incidence outside (-90, 90), a minimum that
    /// does not exist and a wavelength without an index.
    pub fn new(
        apex_deg: f64,
        incidence: Incidence,
        material: &Material,
    ) -> Result<Self, PrismError> {
        if !(apex_deg > 0.0 && apex_deg < 180.0) {
            return Err(PrismError::Apex { found: apex_deg });
        }
        let incidence_deg = match incidence {
            Incidence::Degrees(degrees) => degrees,
            Incidence::MinimumFor(at_nm) => {
                let n = material.index(at_nm)?;
                minimum_deviation(n, apex_deg)
                    .map(|(_, incidence)| incidence)
                    .ok_or_else(|| PrismError::NoMinimum {
                        at_nm,
                        largest_apex_deg: limits(n, apex_deg).largest_apex_deg,
                    })?
            }
        };
        if !(incidence_deg > -90.0 && incidence_deg < 90.0) {
            return Err(PrismError::Incidence {
                found: incidence_deg,
            });
        }
        let (apex, incidence) = (apex_deg.to_radians(), incidence_deg.to_radians());
        let sine_and_cosine = |angle: f64| <[f64; 2]>::from(angle.sin_cos());
        Ok(Self {
            apex,
            incidence,
            apex_deg,
            incidence_deg,
            of_apex: sine_and_cosine(apex),
            of_half_apex: sine_and_cosine(0.5 * apex),
            of_incidence: sine_and_cosine(incidence),
        })
    }

    /// The apex angle.
    pub(crate) fn apex_deg(&self) -> f64 {
        self.apex_deg
    }

    /// The angle of incidence.
    pub(crate) fn incidence_deg(&self) -> f64 {
        self.incidence_deg
    }

    /// Sine of the apex.
    pub(super) fn sin_apex(&self) -> f64 {
        self.of_apex[0]
    }

    /// The way of a ray in glass of an index; `None` where it is totally reflected.
    pub fn passage(&self, n: f64) -> Option<Passage> {
        let angles = self.angles(n)?;
        let exit = angles.sin_i2.atan2(angles.cos_i2);
        Some(Passage {
            n,
            exit_deg: exit.to_degrees(),
            deviation_deg: (self.incidence + exit - self.apex).to_degrees(),
            transmittance_s_p: self.transmittance_s_p(n, &angles),
            sin_cos: angles,
        })
    }

    /// Sines and cosines on the way, without a single arc function.
    pub(super) fn angles(&self, n: f64) -> Option<Angles> {
        let [sin_a, cos_a] = self.of_apex;
        let sin_r1 = self.of_incidence[0] / n;
        let cos_r1 = (1.0 - sin_r1 * sin_r1).sqrt();
        let sin_r2 = sin_a * cos_r1 - cos_a * sin_r1;
        let cos_r2 = cos_a * cos_r1 + sin_a * sin_r1;
        let sin_i2 = n * sin_r2;
        let left = (1.0 - sin_i2) * (1.0 + sin_i2);
        // A ray that runs away from the second face never meets it.
        (left > 0.0 && cos_r2 > 0.0).then(|| Angles {
            sin_r1,
            cos_r1,
            cos_r2,
            sin_i2,
            cos_i2: left.sqrt(),
        })
    }

    pub(super) fn transmittance_s_p(&self, n: f64, angles: &Angles) -> [f64; 2] {
        let first = reflectances(1.0, self.of_incidence[1], n, angles.cos_r1);
        let second = reflectances(n, angles.cos_r2, 1.0, angles.cos_i2);
        std::array::from_fn(|k| (1.0 - first[k]) * (1.0 - second[k]))
    }

    /// Change of the deviation with the index, radians.
    pub(super) fn d_deviation_d_index(&self, angles: &Angles) -> f64 {
        self.sin_apex() / (angles.cos_r1 * angles.cos_i2)
    }
}

impl Passage {
    /// Share let through by both faces for unpolarised light.
    pub fn transmittance(&self) -> f64 {
        let [s, p] = self.transmittance_s_p;
        0.5 * (s + p)
    }
}

/// Least deviation and the incidence that has it, degrees; `None` where every ray is totally
/// reflected.
pub(crate) fn minimum_deviation(n: f64, apex_deg: f64) -> Option<(f64, f64)> {
    let sine = n * (0.5 * apex_deg).to_radians().sin();
    (sine < 1.0).then(|| {
        let incidence = sine.asin().to_degrees();
        (2.0 * incidence - apex_deg, incidence)
    })
}

/// Limits of a prism of an apex angle at an index above 1.
pub(crate) fn limits(n: f64, apex_deg: f64) -> Limits {
    let critical = (1.0 / n).min(1.0).asin();
    let largest_apex_deg = 2.0 * critical.to_degrees();
    let smallest = n * (apex_deg.to_radians() - critical).sin();
    let passes = apex_deg <= largest_apex_deg && smallest.abs() <= 1.0;
    Limits {
        critical_deg: critical.to_degrees(),
        largest_apex_deg,
        smallest_incidence_deg: passes.then(|| smallest.asin().to_degrees()),
    }
}
