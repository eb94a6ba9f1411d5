//! The round brilliant cut.
//!
//! Axis +z, girdle a regular 16-gon of circumradius 1 with z = 0 in its middle. A facet is a plane
//! that falls outward with a slope through a point of given radius and height at its azimuth.

use serde::{Deserialize, Serialize};

use super::solid::{HalfSpace, Solid, SolidError};

/// Parameters of a round brilliant; lengths are shares of the girdle's radius or diameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Brilliant {
    /// Width of the table from corner to corner, of the diameter.
    pub table: f64,
    /// Slope of the crown's main facets, degrees.
    pub crown_deg: f64,
    /// Slope of the pavilion's main facets, degrees.
    pub pavilion_deg: f64,
    /// How far the stars reach from the table's edge to the girdle, 0-1.
    pub star: f64,
    /// How far the lower halves reach from the girdle to the tip, 0-1.
    pub lower: f64,
    /// Height of the girdle, of the diameter.
    pub girdle: f64,
    /// Width of the culet, of the diameter; 0 for a tip.
    pub culet: f64,
}

impl Default for Brilliant {
    fn default() -> Self {
        Self {
            table: 0.57,
            crown_deg: 34.5,
            pavilion_deg: 40.75,
            star: 0.5,
            lower: 0.77,
            girdle: 0.03,
            culet: 0.0,
        }
    }
}

/// Why there is no such gem.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CutError {
    /// A parameter out of its range.
    #[error("{what}: expected {expected}, found {found}")]
    Range {
        what: &'static str,
        expected: &'static str,
        found: f64,
    },
    /// Facets that others cut away.
    #[error("the {name} {} with this {by}", if .name.ends_with('s') { "vanish" } else { "vanishes" })]
    Lost {
        name: &'static str,
        by: &'static str,
    },
    /// The planes make no body.
    #[error(transparent)]
    Solid(#[from] SolidError),
}

const EIGHTH_DEG: f64 = 45.0;
const SIXTEENTH_DEG: f64 = 22.5;

impl Brilliant {
    /// The gem as a body: table, 8 crown mains, 8 stars, 16 upper halves, 16 of the girdle, 8
    /// pavilion mains, 16 lower halves and a culet if there is one.
    ///
    /// # Errors
    /// [`CutError`] for a parameter out of range and for facets that vanish.
    pub fn solid(&self) -> Result<Solid, CutError> {
        self.in_range()?;
        Solid::new(self.planes()).map_err(|error| match error {
            SolidError::LostFacet { name } => CutError::Lost {
                name,
                by: match name {
                    "pavilion mains" | "lower halves" => "pavilion and lower halves",
                    "culet" => "culet and pavilion",
                    "upper halves" => "crown and stars",
                    _ => "table and crown",
                },
            },
            error => CutError::Solid(error),
        })
    }

    /// Facets without those of the girdle: 57, or 58 with a culet.
    pub fn facets(&self) -> usize {
        57 + usize::from(self.culet > 0.0)
    }

    fn in_range(&self) -> Result<(), CutError> {
        let Self {
            table,
            crown_deg,
            pavilion_deg,
            star,
            lower,
            girdle,
            culet,
        } = *self;
        let between = "a number between 0 and 1, both left out";
        let degrees = "an angle between 0 and 89 degrees, 0 left out";
        for (what, expected, found, fits) in [
            ("table", between, table, table > 0.0 && table < 1.0),
            (
                "crown",
                degrees,
                crown_deg,
                crown_deg > 0.0 && crown_deg <= 89.0,
            ),
            (
                "pavilion",
                degrees,
                pavilion_deg,
                pavilion_deg > 0.0 && pavilion_deg <= 89.0,
            ),
            ("star", between, star, star > 0.0 && star < 1.0),
            ("lower", between, lower, lower > 0.0 && lower < 1.0),
            (
                "girdle",
                "a share of the diameter above 0, up to 0.5",
                girdle,
                girdle > 0.0 && girdle <= 0.5,
            ),
            (
                "culet",
                "a number from 0, below 1",
                culet,
                (0.0..1.0).contains(&culet),
            ),
        ] {
            if !fits {
                return Err(CutError::Range {
                    what,
                    expected,
                    found,
                });
            }
        }
        Ok(())
    }

    fn planes(&self) -> Vec<HalfSpace> {
        let (crown, pavilion) = (
            self.crown_deg.to_radians().tan(),
            self.pavilion_deg.to_radians().tan(),
        );
        let c22 = SIXTEENTH_DEG.to_radians().cos();
        let c11 = (0.5 * SIXTEENTH_DEG).to_radians().cos();
        let (t, g) = (self.table, self.girdle);
        let z_t = g + (1.0 - t) * crown;
        let r_s = t * c22 + self.star * (1.0 - t * c22);
        let z_s = g + (1.0 - r_s * c22) * crown;
        let star = (z_t - z_s) / (r_s - t * c22);
        let upper = (z_s - g) / ((1.0 - r_s) * c11);
        let r_l = 1.0 - self.lower;
        let deep = g + (1.0 - r_l * c22) * pavilion;
        let lower = (deep - g) / ((1.0 - r_l) * c11);
        let mut planes = Vec::with_capacity(74);
        let mut add = |normal: [f64; 3], point: [f64; 3], name: &'static str| {
            planes.extend(HalfSpace::through(normal, point, name));
        };
        // A facet at an azimuth, on the upper or lower side.
        let tilted = |azimuth_deg: f64, slope: f64, up: f64, [r, z]: [f64; 2]| {
            let (sin, cos) = azimuth_deg.to_radians().sin_cos();
            ([slope * cos, slope * sin, up], [r * cos, r * sin, z])
        };
        let at = |step: f64, first: f64, count: u32| {
            (0..count).map(move |k| first + step * f64::from(k))
        };
        add([0.0, 0.0, 1.0], [0.0, 0.0, z_t], "table");
        for azimuth in at(EIGHTH_DEG, 0.0, 8) {
            let (normal, point) = tilted(azimuth, crown, 1.0, [1.0, g]);
            add(normal, point, "crown mains");
        }
        for azimuth in at(EIGHTH_DEG, SIXTEENTH_DEG, 8) {
            let (normal, point) = tilted(azimuth, star, 1.0, [t * c22, z_t]);
            add(normal, point, "stars");
        }
        for azimuth in at(SIXTEENTH_DEG, 0.5 * SIXTEENTH_DEG, 16) {
            let (normal, point) = tilted(azimuth, upper, 1.0, [c11, g]);
            add(normal, point, "upper halves");
        }
        for azimuth in at(SIXTEENTH_DEG, 0.5 * SIXTEENTH_DEG, 16) {
            let (normal, point) = tilted(azimuth, 1.0, 0.0, [c11, 0.0]);
            add(normal, point, "girdle facets");
        }
        for azimuth in at(EIGHTH_DEG, 0.0, 8) {
            let (normal, point) = tilted(azimuth, pavilion, -1.0, [1.0, -g]);
            add(normal, point, "pavilion mains");
        }
        for azimuth in at(SIXTEENTH_DEG, 0.5 * SIXTEENTH_DEG, 16) {
            let (normal, point) = tilted(azimuth, lower, -1.0, [c11, -g]);
            add(normal, point, "lower halves");
        }
        if self.culet > 0.0 {
            let tip = -(g + (1.0 - self.culet) * pavilion);
            add([0.0, 0.0, -1.0], [0.0, 0.0, tip], "culet");
        }
        planes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_cut_has_the_facets_and_measures_of_its_definition() {
        let solid = Brilliant::default().solid().unwrap();
        assert_eq!(solid.planes().len(), 73);
        assert_eq!((solid.corners().len(), solid.edges()), (57, 128));
        for (plane, facet) in solid.planes().iter().zip(solid.facets()) {
            let sides = match plane.name {
                "table" => 8,
                "stars" | "upper halves" | "lower halves" => 3,
                _ => 4,
            };
            assert_eq!(facet.len(), sides, "{}", plane.name);
        }
        // Six digits are given.
        assert!(
            (solid.volume() - 1.675_034).abs() < 5e-7,
            "{}",
            solid.volume()
        );
        assert!((solid.area() - 8.016_930).abs() < 5e-7, "{}", solid.area());
        let heights = solid.corners().iter().map(|c| c[2]);
        let (low, high) = heights.fold((0.0_f64, 0.0_f64), |(a, b), z| (a.min(z), b.max(z)));
        assert!((high - 0.325_531).abs() < 5e-7 && (low + 0.891_655).abs() < 5e-7);
        for (name, degrees) in [
            ("stars", 21.4341),
            ("upper halves", 41.1133),
            ("lower halves", 41.9401),
        ] {
            let plane = solid.planes().iter().find(|p| p.name == name).unwrap();
            let slope = plane.normal[2].abs().acos().to_degrees();
            assert!((slope - degrees).abs() < 5e-5, "{name} {slope}");
        }
    }

    #[test]
    fn a_culet_is_a_facet_more() {
        let cut = Brilliant {
            culet: 0.05,
            ..Brilliant::default()
        };
        let solid = cut.solid().unwrap();
        assert_eq!((cut.facets(), solid.planes().len()), (58, 74));
        assert!(solid.facets().last().unwrap().len() >= 8);
    }

    #[test]
    fn cuts_that_are_none_are_refused_in_words() {
        let cut = Brilliant::default();
        for bad in [
            Brilliant { table: 0.0, ..cut },
            Brilliant { table: 1.0, ..cut },
            Brilliant {
                table: f64::NAN,
                ..cut
            },
            Brilliant {
                crown_deg: 90.0,
                ..cut
            },
            Brilliant {
                pavilion_deg: -1.0,
                ..cut
            },
            Brilliant { girdle: 0.0, ..cut },
            Brilliant { culet: -0.1, ..cut },
            Brilliant { star: 1.0, ..cut },
            Brilliant { lower: 0.0, ..cut },
        ] {
            assert!(bad.solid().is_err(), "{bad:?}");
        }
        let said = Brilliant { table: 1.5, ..cut }.solid().unwrap_err();
        assert_eq!(
            said.to_string(),
            "table: expected a number between 0 and 1, both left out, found 1.5"
        );
    }
}
