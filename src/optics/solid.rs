//! A convex body as the half-spaces `n . x <= d` that it is the intersection of.

use crate::languages::said;

/// A point or direction.
pub(crate) type Vec3 = [f64; 3];

pub(super) fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn minus(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|k| a[k] - b[k])
}

pub(super) fn plus(a: Vec3, b: Vec3, factor: f64) -> Vec3 {
    std::array::from_fn(|k| a[k] + factor * b[k])
}

/// A vector of length 1; `None` for nothing and for what is not finite.
pub(super) fn unit(a: Vec3) -> Option<Vec3> {
    let length = dot(a, a).sqrt();
    (length > 0.0 && length.is_finite()).then(|| a.map(|v| v / length))
}

/// True if all components are numbers of magnitude at most 1e6.
pub(super) fn is_near(a: Vec3) -> bool {
    a.iter().all(|v| v.abs() <= 1e6)
}

/// A half-space: outward normal of length 1, distance from the origin, and what its facet is.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HalfSpace {
    /// Outward normal of length 1.
    pub normal: Vec3,
    /// `n . x <= distance` inside.
    pub distance: f64,
    /// The kind of facet: "table", "stars", "side".
    pub name: &'static str,
}

impl HalfSpace {
    /// Of a normal of any length, through a point; `None` without a direction.
    pub(crate) fn through(normal: Vec3, point: Vec3, name: &'static str) -> Option<Self> {
        let normal = unit(normal)?;
        let distance = dot(normal, point);
        distance.is_finite().then_some(Self {
            normal,
            distance,
            name,
        })
    }
}

/// A convex body with its corners.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    planes: Vec<HalfSpace>,
    corners: Vec<Vec3>,
    facets: Vec<Vec<usize>>,
}

/// Why half-spaces are no body.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SolidError {
    /// A half-space that has fewer than three corners.
    #[error(
        "{}",
        tr!("expected a facet for each plane, found none for the {name}", name = said(name))
    )]
    LostFacet { name: &'static str },
    /// The half-spaces do not close, or close beyond a thousand units.
    #[error("{}", tr!("expected a closed body, found the {name} open", name = said(name)))]
    Open { name: &'static str },
    /// Corners or edges so near to one another that they cannot be told apart.
    #[error(
        "{}",
        said!("expected facets that can be told apart, found some that all but coincide")
    )]
    Degenerate,
    /// Too few or too many half-spaces, or one that is no plane.
    #[error(
        "{}",
        tr!("expected 4 to {most} planes, found {found}", most = MOST_PLANES, found)
    )]
    Planes { found: usize },
}

/// Most half-spaces of a body.
pub(super) const MOST_PLANES: usize = 512;

/// Half the side of the square that a plane is cut from.
const FAR: f64 = 1e4;

/// Corners nearer than this share of the body's size are one.
const SAME: f64 = 1e-9;

impl Solid {
    /// The body that half-spaces enclose.
    ///
    /// # Errors
    /// [`SolidError`] when a half-space has no facet or the body is open.
    pub(crate) fn new(planes: Vec<HalfSpace>) -> Result<Self, SolidError> {
        let is_plane =
            |p: &HalfSpace| (dot(p.normal, p.normal) - 1.0).abs() < 1e-9 && p.distance.is_finite();
        if !(4..=MOST_PLANES).contains(&planes.len()) || !planes.iter().all(is_plane) {
            return Err(SolidError::Planes {
                found: planes.len(),
            });
        }
        let polygons: Vec<Vec<Vec3>> = (0..planes.len()).map(|own| polygon(&planes, own)).collect();
        let reach_of = |polygon: &Vec<Vec3>| {
            let all = polygon.iter().flatten();
            all.fold(0.0_f64, |reach, v| reach.max(v.abs()))
        };
        let reaches: Vec<f64> = polygons.iter().map(reach_of).collect();
        if let Some(open) = reaches.iter().position(|reach| *reach > 0.1 * FAR) {
            let name = planes[open].name;
            return Err(SolidError::Open { name });
        }
        let same = SAME * reaches.into_iter().fold(0.0, f64::max);
        let mut corners: Vec<Vec3> = Vec::new();
        let mut facets = Vec::new();
        for (polygon, plane) in polygons.iter().zip(&planes) {
            let mut facet: Vec<usize> = Vec::new();
            for point in polygon {
                let near = |c: &Vec3| {
                    let off = minus(*c, *point);
                    dot(off, off) <= same * same
                };
                let corner = corners.iter().position(near).unwrap_or_else(|| {
                    corners.push(*point);
                    corners.len() - 1
                });
                if !facet.contains(&corner) {
                    facet.push(corner);
                }
            }
            if facet.len() < 3 {
                return Err(SolidError::LostFacet { name: plane.name });
            }
            facets.push(facet);
        }
        let solid = Self {
            planes,
            corners,
            facets,
        };
        // Euler's formula: what merged or split by rounding no longer closes.
        let is_closed = solid.corners.len() + solid.facets.len() == solid.edges() + 2;
        if is_closed {
            Ok(solid)
        } else {
            Err(SolidError::Degenerate)
        }
    }

    /// A cube about the origin, of half a side.
    ///
    /// # Errors
    /// When the length is none.
    #[cfg(test)]
    pub(crate) fn cube(half: f64) -> Result<Self, SolidError> {
        let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let side = |normal: Vec3| HalfSpace {
            normal,
            distance: half,
            name: "side",
        };
        let planes = axes.into_iter().flat_map(|a| [a, a.map(|v| -v)]).map(side);
        Self::new(planes.collect())
    }

    /// An octahedron about the origin, its corners on the axes.
    ///
    /// # Errors
    /// When the length is none.
    #[cfg(test)]
    pub(crate) fn octahedron(radius: f64) -> Result<Self, SolidError> {
        let third = (1.0_f64 / 3.0).sqrt();
        let side = |i: usize| HalfSpace {
            normal: [1, 2, 4].map(|bit| if i & bit == 0 { third } else { -third }),
            distance: radius * third,
            name: "side",
        };
        Self::new((0..8).map(side).collect())
    }

    /// The half-spaces.
    pub(crate) fn planes(&self) -> &[HalfSpace] {
        &self.planes
    }

    /// All corners.
    pub(crate) fn corners(&self) -> &[Vec3] {
        &self.corners
    }

    /// Corners of each half-space's facet, in order round it.
    #[cfg(test)]
    pub(crate) fn facets(&self) -> &[Vec<usize>] {
        &self.facets
    }

    /// Number of edges.
    pub(crate) fn edges(&self) -> usize {
        self.facets.iter().map(Vec::len).sum::<usize>() / 2
    }

    /// Area of a facet.
    #[cfg(test)]
    pub(crate) fn facet_area(&self, facet: usize) -> f64 {
        let Some(corners) = self.facets.get(facet) else {
            return 0.0;
        };
        let at = |i: usize| self.corners[corners[i]];
        let doubled = (1..corners.len() - 1).fold([0.0; 3], |sum, i| {
            plus(
                sum,
                cross(minus(at(i), at(0)), minus(at(i + 1), at(0))),
                1.0,
            )
        });
        0.5 * dot(doubled, doubled).sqrt()
    }

    /// Area of the surface.
    #[cfg(test)]
    pub(crate) fn area(&self) -> f64 {
        (0..self.facets.len()).map(|i| self.facet_area(i)).sum()
    }

    /// Volume.
    #[cfg(test)]
    pub(crate) fn volume(&self) -> f64 {
        let pyramid = |(i, plane): (usize, &HalfSpace)| plane.distance * self.facet_area(i) / 3.0;
        self.planes.iter().enumerate().map(pyramid).sum()
    }

    /// True if a point is inside or on the surface.
    pub(crate) fn contains(&self, point: Vec3) -> bool {
        self.planes
            .iter()
            .all(|p| dot(p.normal, point) <= p.distance)
    }
}

/// The polygon that the other half-spaces leave of a plane.
fn polygon(planes: &[HalfSpace], own: usize) -> Vec<Vec3> {
    let HalfSpace {
        normal, distance, ..
    } = &planes[own];
    // Any direction that is not the normal's.
    let least = (0..3).min_by(|a, b| normal[*a].abs().total_cmp(&normal[*b].abs()));
    let mut axis = [0.0; 3];
    axis[least.unwrap_or(0)] = 1.0;
    let u = unit(cross(*normal, axis)).unwrap_or(axis);
    let v = cross(*normal, u);
    let centre = normal.map(|n| n * distance);
    let mut polygon: Vec<Vec3> = [[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]]
        .iter()
        .map(|[a, b]| plus(plus(centre, u, a * FAR), v, b * FAR))
        .collect();
    for (index, other) in planes.iter().enumerate() {
        if index == own {
            continue;
        }
        polygon = cut(&polygon, other);
        if polygon.len() < 3 {
            return Vec::new();
        }
    }
    polygon
}

/// The part of a polygon inside a half-space.
fn cut(polygon: &[Vec3], plane: &HalfSpace) -> Vec<Vec3> {
    let height = |p: &Vec3| dot(plane.normal, *p) - plane.distance;
    let mut left = Vec::with_capacity(polygon.len() + 1);
    for (index, point) in polygon.iter().enumerate() {
        let next = &polygon[(index + 1) % polygon.len()];
        let (here, there) = (height(point), height(next));
        if here <= 0.0 {
            left.push(*point);
        }
        if (here < 0.0 && there > 0.0) || (here > 0.0 && there < 0.0) {
            left.push(plus(*point, minus(*next, *point), here / (here - there)));
        }
    }
    left
}
