//! The round brilliant cut.
//!
//! Axis +z, girdle a regular 16-gon of circumradius 1 with z = 0 in its middle. A facet is a plane
//! that falls outward with a slope through a point of given radius and height at its azimuth.

use serde::{Deserialize, Serialize};

use crate::languages::{said, with_sign};

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
    /// Reach of the stars, as a share of the way from the table's edge to the girdle, 0-1.
    pub star: f64,
    /// Reach of the lower halves, as a share of the way from the girdle to the tip, 0-1.
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
    #[error(
        "{}",
        tr!(
            "{what}: expected {expected}, found {found}",
            what = said(what),
            expected = said(expected),
            found = with_sign(found.to_string())
        )
    )]
    Range {
        what: &'static str,
        expected: &'static str,
        found: f64,
    },
    /// Facets that others cut away.
    #[error("{}", lost(name, by))]
    Lost {
        name: &'static str,
        by: &'static str,
    },
    /// The planes make no body.
    #[error(transparent)]
    Solid(#[from] SolidError),
}

fn lost(name: &str, by: &str) -> String {
    let words = match name {
        "table" => said!("the table vanishes with this table and crown"),
        "crown mains" => said!("the crown mains vanish with this table and crown"),
        "stars" => said!("the stars vanish with this table and crown"),
        "upper halves" => said!("the upper halves vanish with this crown and stars"),
        "girdle facets" => said!("the girdle facets vanish with this table and crown"),
        "pavilion mains" => {
            said!("the pavilion mains vanish with this pavilion and lower halves")
        }
        "lower halves" => said!("the lower halves vanish with this pavilion and lower halves"),
        "culet" => said!("the culet vanishes with this culet and pavilion"),
        other => return format!("the {other} vanishes with this {by}"),
    };
    words.to_owned()
}

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
    pub(crate) fn facets(&self) -> usize {
        57 + usize::from(self.culet > 0.0)
    }

    fn in_range(&self) -> Result<(), CutError> {
        type Range = (&'static str, fn(f64) -> bool);
        const SHARE: Range = (later!("a number between 0 and 1, both left out"), |v| {
            v > 0.0 && v < 1.0
        });
        const SLOPE: Range = (
            later!("an angle between 0 and 89 degrees, 0 left out"),
            |v| v > 0.0 && v <= 89.0,
        );
        const GIRDLE: Range = (later!("a share of the diameter above 0, up to 0.5"), |v| {
            v > 0.0 && v <= 0.5
        });
        const CULET: Range = (later!("a number from 0, below 1"), |v| {
            (0.0..1.0).contains(&v)
        });
        for (what, found, (expected, fits)) in [
            (later!("table"), self.table, SHARE),
            (later!("crown"), self.crown_deg, SLOPE),
            (later!("pavilion"), self.pavilion_deg, SLOPE),
            (later!("star"), self.star, SHARE),
            (later!("lower"), self.lower, SHARE),
            (later!("girdle"), self.girdle, GIRDLE),
            (later!("culet"), self.culet, CULET),
        ] {
            if !fits(found) {
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
        // Facets all round: how many, azimuth of the first in degrees, slope, which way up, radius
        // and height of a point.
        let (half, quarter) = (SIXTEENTH_DEG, 0.5 * SIXTEENTH_DEG);
        let rings = [
            ("crown mains", 8, 0.0, crown, 1.0, [1.0, g]),
            ("stars", 8, half, star, 1.0, [t * c22, z_t]),
            ("upper halves", 16, quarter, upper, 1.0, [c11, g]),
            ("girdle facets", 16, quarter, 1.0, 0.0, [c11, 0.0]),
            ("pavilion mains", 8, 0.0, pavilion, -1.0, [1.0, -g]),
            ("lower halves", 16, quarter, lower, -1.0, [c11, -g]),
        ];
        let mut planes = Vec::with_capacity(74);
        let mut add = |normal: [f64; 3], point: [f64; 3], name: &'static str| {
            planes.extend(HalfSpace::through(normal, point, name));
        };
        add([0.0, 0.0, 1.0], [0.0, 0.0, z_t], "table");
        for (name, count, first_deg, slope, up, [r, z]) in rings {
            for k in 0..count {
                let azimuth_deg: f64 = first_deg + 360.0 / f64::from(count) * f64::from(k);
                let (sin, cos) = azimuth_deg.to_radians().sin_cos();
                add([slope * cos, slope * sin, up], [r * cos, r * sin, z], name);
            }
        }
        if self.culet > 0.0 {
            let tip = -(g + (1.0 - self.culet) * pavilion);
            add([0.0, 0.0, -1.0], [0.0, 0.0, tip], "culet");
        }
        planes
    }
}
