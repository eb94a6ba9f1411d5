//! A slit, a prism and a screen.
//!
//! The apex is at (0, 0), the faces run from it at plus and minus half the apex angle about -y. A
//! parallel beam of the slit's width has its chief ray at a distance from the apex on the first
//! face; the place where it leaves the second moves with wavelength. The screen is a line across
//! the ray of the reference wavelength at a distance from where that leaves; x is positive towards
//! larger deviation. Lengths are mm.

use serde::Serialize;

use crate::languages::{fixed, said, with_sign};

use super::{
    absorption::Absorption,
    index::Material,
    index_error::IndexError,
    prism::{Angles, Incidence, Limits, Prism, PrismError, limits, minimum_deviation},
};

/// The bench as a person sets it.
#[derive(Clone, Debug, PartialEq)]
pub struct BenchSettings {
    /// Apex angle, degrees.
    pub apex_deg: f64,
    /// Incidence of the light on the first face.
    pub incidence: Incidence,
    /// From the apex to where the chief ray meets the first face, mm.
    pub entry_mm: f64,
    /// From where the reference ray leaves to the screen, mm.
    pub screen_mm: f64,
    /// Width of the slit, mm.
    pub slit_mm: f64,
    /// The wavelength in whose ray's way the screen stands, nm.
    pub reference_nm: f64,
    /// Absorption of the prism, per mm.
    pub absorption: Absorption,
}

impl Default for BenchSettings {
    fn default() -> Self {
        Self {
            apex_deg: 60.0,
            incidence: Incidence::MinimumFor(546.075),
            entry_mm: 30.0,
            screen_mm: 500.0,
            slit_mm: 0.2,
            reference_nm: 546.075,
            absorption: Absorption::None,
        }
    }
}

/// A bench whose settings are in range.
#[derive(Clone, Debug, PartialEq)]
pub struct Bench {
    material: Material,
    prism: Prism,
    settings: BenchSettings,
    reference: Reference,
}

/// The ray that the screen stands across.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Reference {
    nm: f64,
    /// Its exit point, mm.
    exit: [f64; 2],
    /// Its direction.
    direction: [f64; 2],
}

/// Figures of one wavelength on its way to the screen.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Landing {
    /// Wavelength, nm.
    #[serde(rename = "nm")]
    pub at_nm: f64,
    /// Index of refraction.
    pub n: f64,
    /// Deviation, degrees.
    #[serde(rename = "deviation")]
    pub deviation_deg: f64,
    /// Least deviation that the prism can have for it, degrees; `None` where every ray that could
    /// have it is totally reflected.
    #[serde(rename = "minimum_deviation")]
    pub minimum_deviation_deg: Option<f64>,
    /// Change of the deviation with wavelength at this incidence, degrees a nm.
    pub d_deviation_d_nm: f64,
    /// Share let through, inner absorption included.
    pub transmittance: f64,
    /// Exit from the second face, mm from the apex.
    pub exit_mm: f64,
    /// Way in the glass, mm.
    pub path_mm: f64,
    /// Place on the screen, mm.
    pub x_mm: f64,
    /// Width of the slit's image, mm.
    pub width_mm: f64,
    /// Change of the place with wavelength, mm a nm.
    #[serde(rename = "dx_dnm")]
    pub d_x_d_nm: f64,
    /// Resolving power.
    #[serde(skip)]
    pub resolving: Resolving,
}

/// Resolving power: wavelength over the least difference that can be resolved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resolving {
    /// By the base of glass that the beam could fill.
    pub by_glass: f64,
    /// By the image of the slit.
    pub by_slit: f64,
}

impl Resolving {
    /// The smaller of the two.
    pub(crate) fn power(&self) -> f64 {
        self.by_glass.min(self.by_slit)
    }

    /// The limiting factor, in a word: "glass" or "slit".
    pub(crate) fn limit(&self) -> &'static str {
        if self.by_glass < self.by_slit {
            "glass"
        } else {
            "slit"
        }
    }
}

/// The chief ray on its way, for the drawing; mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct RayPath {
    /// Entry point on the first face, offset on that face for a ray of the slit's edge.
    pub entry: [f64; 2],
    /// Exit point on the second face.
    pub exit: [f64; 2],
    /// Point on the screen.
    pub screen: [f64; 2],
    /// Direction of the incoming light.
    pub incoming: [f64; 2],
}

/// Why there is no bench.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BenchError {
    /// The prism is invalid.
    #[error(transparent)]
    Prism(#[from] PrismError),
    /// An invalid length.
    #[error(
        "{}",
        tr!(
            "{what}: expected a length above 0 and up to 1e6 mm, found {found}",
            what = said(what),
            found = with_sign(found.to_string())
        )
    )]
    Length { what: &'static str, found: f64 },
    /// All light is totally reflected.
    #[error("{}", tr!("no light leaves: {why}", why = why_dark(.0)))]
    NoLight(Limits),
}

fn why_dark(limits: &Limits) -> String {
    match limits.smallest_incidence_deg {
        Some(smallest) => tr!(
            "incidence below the smallest that passes ({smallest})",
            smallest = fixed(smallest, 1)
        ),
        None => {
            let largest = limits.largest_apex_deg;
            tr!(
                "apex above twice the critical angle ({largest})",
                largest = fixed(largest, 1)
            )
        }
    }
}

impl BenchError {
    /// The limits that total reflection sets, where it is what keeps all light in.
    pub(crate) fn reflected_beyond(&self) -> Option<Limits> {
        match self {
            Self::NoLight(limits) => Some(*limits),
            Self::Prism(PrismError::NoMinimum {
                largest_apex_deg, ..
            }) => Some(Limits {
                critical_deg: 0.5 * largest_apex_deg,
                largest_apex_deg: *largest_apex_deg,
                smallest_incidence_deg: None,
            }),
            Self::Prism(_) | Self::Length { .. } => None,
        }
    }
}

impl From<IndexError> for BenchError {
    fn from(error: IndexError) -> Self {
        Self::Prism(error.into())
    }
}

/// Position, width and transmittance of a wavelength on the screen, without display-only figures.
#[derive(Clone, Copy, Debug)]
pub(super) struct Spot {
    pub(super) x: f64,
    pub(super) width: f64,
    pub(super) transmittance: f64,
}

/// Half the step of the derivative of the place, nm.
const HALF_STEP_NM: f64 = 0.01;

/// Longest length of a bench, mm.
const LONGEST_MM: f64 = 1e6;

impl Bench {
    /// Sets a bench up.
    ///
    /// # Errors
    /// [`BenchError`] for angles and lengths out of range, and when nothing of 380-780 nm leaves.
    pub fn new(settings: BenchSettings, material: Material) -> Result<Self, BenchError> {
        for (what, length) in [
            (later!("distance from the apex"), settings.entry_mm),
            (later!("distance of the screen"), settings.screen_mm),
            (later!("slit"), settings.slit_mm),
        ] {
            if !(length > 0.0 && length <= LONGEST_MM) {
                return Err(BenchError::Length {
                    what,
                    found: length,
                });
            }
        }
        let prism = Prism::new(settings.apex_deg, settings.incidence, &material)?;
        let n = material.index(settings.reference_nm)?;
        let mut bench = Self {
            reference: Reference {
                nm: settings.reference_nm,
                exit: [0.0; 2],
                direction: [1.0, 0.0],
            },
            material,
            prism,
            settings,
        };
        // Where the reference is totally reflected the screen goes to the longest wavelength that
        // leaves: of those red is bent least.
        let longest = || (380..=780).rev().map(f64::from);
        let wanted = std::iter::once(bench.settings.reference_nm).chain(longest());
        let found = wanted.into_iter().find_map(|nm| {
            let n = bench.material.index(nm).ok()?;
            Some((nm, bench.prism.angles(n)?))
        });
        let Some((nm, angles)) = found else {
            return Err(BenchError::NoLight(limits(n, bench.settings.apex_deg)));
        };
        bench.reference = Reference {
            nm,
            exit: bench.exit(bench.settings.entry_mm, &angles).1,
            direction: bench.direction(&angles),
        };
        Ok(bench)
    }

    /// The settings it was built from.
    pub(crate) fn settings(&self) -> &BenchSettings {
        &self.settings
    }

    /// The prism.
    pub fn prism(&self) -> &Prism {
        &self.prism
    }

    /// The glass.
    pub fn material(&self) -> &Material {
        &self.material
    }

    /// The wavelength in whose way the screen stands: that asked for, or where it is totally
    /// reflected the longest that leaves, nm.
    pub(crate) fn reference_nm(&self) -> f64 {
        self.reference.nm
    }

    /// Exit of a ray that enters at a distance from the apex: its own distance, mm, and the point.
    fn exit(&self, entry_mm: f64, angles: &Angles) -> (f64, [f64; 2]) {
        let [sin, cos] = self.prism.of_half_apex;
        let q = entry_mm * angles.cos_r1 / angles.cos_r2;
        (q, [q * sin, -q * cos])
    }

    /// Direction at half the apex less the angle of leaving above x.
    fn direction(&self, angles: &Angles) -> [f64; 2] {
        let [sin, cos] = self.prism.of_half_apex;
        [
            cos * angles.cos_i2 + sin * angles.sin_i2,
            sin * angles.cos_i2 - cos * angles.sin_i2,
        ]
    }

    fn path(&self, angles: &Angles) -> f64 {
        self.settings.entry_mm * self.prism.sin_apex() / angles.cos_r2
    }

    /// Place along the screen and distance on the way; `None` where the ray runs away from it.
    fn meets(&self, exit: [f64; 2], direction: [f64; 2]) -> Option<(f64, f64)> {
        let Reference {
            exit: from,
            direction: [ahead_x, ahead_y],
            ..
        } = self.reference;
        let off = [exit[0] - from[0], exit[1] - from[1]];
        // The cosine between the rays, which is that of the difference of deviations.
        let along = direction[0] * ahead_x + direction[1] * ahead_y;
        let way = (self.settings.screen_mm - (off[0] * ahead_x + off[1] * ahead_y)) / along;
        // Towards larger deviation: the direction turned by -90 degrees.
        let across = |v: [f64; 2]| v[0] * ahead_y - v[1] * ahead_x;
        let x = across(off) + way * across(direction);
        (along > 1e-9 && way > 0.0).then_some((x, way))
    }

    /// Spot of a wavelength; `None` where it has no index, is totally reflected or never meets the
    /// screen.
    pub(super) fn spot(&self, at_nm: f64) -> Option<Spot> {
        let n = self.material.index(at_nm).ok()?;
        let angles = self.prism.angles(n)?;
        let direction = self.direction(&angles);
        let (_, exit) = self.exit(self.settings.entry_mm, &angles);
        let (x, _) = self.meets(exit, direction)?;
        let ahead = self.reference.direction;
        let along = direction[0] * ahead[0] + direction[1] * ahead[1];
        let width = self.settings.slit_mm * angles.cos_r1 * angles.cos_i2
            / (self.prism.of_incidence[1] * angles.cos_r2 * along);
        Some(Spot {
            x,
            width,
            transmittance: self.transmittance(at_nm, n, &angles),
        })
    }

    fn transmittance(&self, at_nm: f64, n: f64, angles: &Angles) -> f64 {
        let [s, p] = self.prism.transmittance_s_p(n, angles);
        let inner = match &self.settings.absorption {
            Absorption::None => 1.0,
            absorption => (-absorption.at(at_nm) * self.path(angles)).exp(),
        };
        0.5 * (s + p) * inner
    }

    /// True if a wavelength has an index but is totally reflected.
    pub(crate) fn is_reflected(&self, at_nm: f64) -> bool {
        let n = self.material.index(at_nm);
        n.is_ok_and(|n| self.prism.angles(n).is_none())
    }

    /// The figures of a wavelength; `None` where it is totally reflected or never meets the
    /// screen.
    ///
    /// # Errors
    /// [`IndexError`] where the glass has no index.
    pub fn landing(&self, at_nm: f64) -> Result<Option<Landing>, IndexError> {
        let n = self.material.index(at_nm)?;
        let slope = self.material.d_index_d_nm(at_nm)?;
        let (Some(passage), Some(spot)) = (self.prism.passage(n), self.spot(at_nm)) else {
            return Ok(None);
        };
        let angles = passage.sin_cos;
        // One-sided beside total reflection.
        let place = |nm: f64| self.spot(nm).map(|spot| (nm, spot.x));
        let low = place(at_nm - HALF_STEP_NM).unwrap_or((at_nm, spot.x));
        let high = place(at_nm + HALF_STEP_NM).unwrap_or((at_nm, spot.x));
        let step = high.0 - low.0;
        let rise = high.1 - low.1;
        let d_x_d_nm = if step > 0.0 { rise / step } else { 0.0 };
        let base = 2.0 * self.settings.entry_mm * self.prism.of_half_apex[0];
        Ok(Some(Landing {
            at_nm,
            n,
            deviation_deg: passage.deviation_deg,
            minimum_deviation_deg: minimum_deviation(n, self.prism.apex_deg()).map(|(d, _)| d),
            d_deviation_d_nm: (self.prism.d_deviation_d_index(&angles) * slope).to_degrees(),
            transmittance: spot.transmittance,
            exit_mm: self.exit(self.settings.entry_mm, &angles).0,
            path_mm: self.path(&angles),
            x_mm: spot.x,
            width_mm: spot.width,
            d_x_d_nm,
            resolving: Resolving {
                by_glass: base * 1e6 * slope.abs(),
                by_slit: at_nm * d_x_d_nm.abs() / spot.width,
            },
        }))
    }

    /// The way of a wavelength's ray; `edge` from -1 to 1 goes over the slit's width, 0 is the
    /// chief ray.
    pub(crate) fn ray(&self, at_nm: f64, edge: f64) -> Option<RayPath> {
        let n = self.material.index(at_nm).ok()?;
        let angles = self.prism.angles(n)?;
        let direction = self.direction(&angles);
        let [sin, cos] = self.prism.of_half_apex;
        // The slit's half width lies longer on the first face.
        let off = 0.5 * edge.clamp(-1.0, 1.0) * self.settings.slit_mm / self.prism.of_incidence[1];
        let p = self.settings.entry_mm + off;
        let (_, exit) = self.exit(p, &angles);
        let (_, way) = self.meets(exit, direction)?;
        let [sin_i, cos_i] = self.prism.of_incidence;
        Some(RayPath {
            entry: [-p * sin, -p * cos],
            exit,
            screen: [exit[0] + way * direction[0], exit[1] + way * direction[1]],
            // The inward normal of the first face, turned up by the incidence.
            incoming: [cos * cos_i + sin * sin_i, cos * sin_i - sin * cos_i],
        })
    }
}
