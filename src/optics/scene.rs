//! The surroundings of a gem: a dome, lamps, and a pinhole camera.

use serde::Serialize;

use crate::languages::with_sign;

use super::solid::{Solid, Vec3, cross, dot, is_near, minus, plus, unit};

/// A rectangle that shines on one side, black behind.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lamp {
    /// Its middle.
    pub centre: Vec3,
    /// Half of one edge.
    pub half_edge_u: Vec3,
    /// Half of the other edge; it shines on the side of `u x v`.
    pub half_edge_v: Vec3,
    /// Radiance.
    pub radiance: f64,
}

/// A pinhole camera with a square picture.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct View {
    /// Position of the camera.
    pub from: Vec3,
    /// Point at which it is aimed.
    pub towards: Vec3,
    /// Full angle of the picture, degrees.
    #[serde(rename = "angle")]
    pub angle_deg: f64,
}

/// Dome, lamps and camera.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Scene {
    /// Radiance from everywhere.
    pub dome: f64,
    /// Rectangles before the dome.
    pub lamps: Vec<Lamp>,
    /// The camera.
    #[serde(skip)]
    pub view: View,
}

/// A camera's axes, ready to make rays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    pub(super) origin: Vec3,
    forward: Vec3,
    right: Vec3,
    upward: Vec3,
}

/// Why a scene cannot be looked at.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SceneError {
    /// A place or direction that is not finite, or the same twice.
    #[error("{}", tr!("view: expected a camera and another place it looks at, found {what}", what))]
    View { what: &'static str },
    /// An invalid angle.
    #[error(
        "{}",
        tr!(
            "angle: expected an angle above 0 and below 180 degrees, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    Angle { found: f64 },
    /// The camera is inside the gem or on it.
    #[error("{}", said!("view: expected a camera outside the gem, found it inside"))]
    Inside,
    /// A lamp's back hides the gem.
    #[error(
        "{}",
        tr!("view: expected a free view of the gem, found the camera behind lamp {number}", number)
    )]
    BehindLamp { number: usize },
    /// A lamp that is no rectangle or shines with what is no radiance.
    #[error(
        "{}",
        tr!("lamp {number}: expected a rectangle and a radiance from 0, found none", number)
    )]
    Lamp { number: usize },
    /// A lamp reaches into the gem.
    #[error("{}", tr!("lamp {number}: expected it outside the gem, found it inside", number))]
    LampInGem { number: usize },
    /// A dome that shines with what is no radiance.
    #[error(
        "{}",
        tr!(
            "dome: expected a radiance from 0 to 1e6, found {found}",
            found = with_sign(found.to_string())
        )
    )]
    Dome { found: f64 },
}

impl View {
    /// View A of the definition: down on the crown from the front.
    pub const A: Self = Self {
        from: [0.0, -4.6, 7.2],
        towards: [0.0, 0.0, -0.2],
        angle_deg: 16.0,
    };
}

impl Default for Scene {
    /// Four soft boxes and two small lamps that make the fire, before a dim dome; view A.
    fn default() -> Self {
        let lamp = |centre, half_edge_u, half_edge_v, radiance| Lamp {
            centre,
            half_edge_u,
            half_edge_v,
            radiance,
        };
        Self {
            dome: 0.1,
            lamps: vec![
                lamp([-3.0, 1.0, 8.0], [0.0, 2.5, 0.0], [2.5, 0.0, 0.0], 1.0),
                lamp([7.0, -1.0, 3.0], [0.0, 0.0, 2.0], [0.0, 2.5, 0.0], 1.0),
                lamp([2.0, 7.0, 3.5], [3.0, 0.0, 0.0], [0.0, 0.0, 1.5], 1.0),
                lamp([-7.0, 2.0, 2.5], [0.0, 2.0, 0.0], [0.0, 0.0, 1.5], 1.0),
                lamp([3.0, -2.5, 8.0], [0.0, 0.3, 0.0], [0.3, 0.0, 0.0], 12.0),
                lamp([-6.0, -4.5, 5.0], [0.0, 0.0, 0.5], [0.3, -0.4, 0.0], 12.0),
            ],
            view: View::A,
        }
    }
}

impl Scene {
    /// As jewellers show gems: soft boxes low all around and small ones above them, many lamps as
    /// small as points that make the fire, all before a dark room. All stand further away than the
    /// camera of view A, so that it looks past them from everywhere.
    pub fn jeweller() -> Self {
        let around = |count: u32, from_deg: f64| {
            (0..count).map(move |k| f64::from(k) * 360.0 / f64::from(count) + from_deg)
        };
        let low = around(5, 30.0).map(|turn| Lamp::towards_gem([turn, 36.0], [3.0, 1.25], 1.0));
        let high = around(5, 66.0).map(|turn| Lamp::towards_gem([turn, 62.0], [1.1, 1.1], 1.2));
        let points = around(9, 11.0).zip([40.0, 53.0, 66.0].into_iter().cycle());
        let points =
            points.map(|(turn, height)| Lamp::towards_gem([turn, height], [0.22, 0.22], 30.0));
        Self {
            dome: 0.02,
            lamps: low.chain(high).chain(points).collect(),
            view: View::A,
        }
    }
}

/// Distance of a jeweller's lamps from the gem.
const LAMPS_AWAY: f64 = 10.0;

impl Lamp {
    /// A lamp that faces the gem, by its turn from the front and its height above the girdle in
    /// degrees, half its width and half its height.
    fn towards_gem([turn, height]: [f64; 2], [wide, high]: [f64; 2], radiance: f64) -> Self {
        let (turn, height) = (turn.to_radians(), height.to_radians());
        let away = [
            height.cos() * turn.sin(),
            -height.cos() * turn.cos(),
            height.sin(),
        ];
        let level = [turn.cos(), turn.sin(), 0.0];
        Self {
            centre: away.map(|v| LAMPS_AWAY * v),
            half_edge_u: level.map(|v| wide * v),
            half_edge_v: cross(level, away).map(|v| high * v),
            radiance,
        }
    }

    /// Its normal on the bright side; `None` when it is no rectangle.
    pub(super) fn normal(&self) -> Option<Vec3> {
        unit(cross(self.half_edge_u, self.half_edge_v))
    }

    pub(super) fn corners(&self) -> [Vec3; 4] {
        [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]]
            .map(|[a, b]| plus(plus(self.centre, self.half_edge_u, a), self.half_edge_v, b))
    }

    /// Distance along a ray at which it is met, in lengths of the direction.
    fn met(&self, origin: Vec3, direction: Vec3) -> Option<f64> {
        let normal = self.normal()?;
        let way = dot(normal, minus(self.centre, origin)) / dot(normal, direction);
        let place = minus(plus(origin, direction, way), self.centre);
        let within = |edge: Vec3| dot(place, edge).abs() <= dot(edge, edge);
        (way > 0.0 && within(self.half_edge_u) && within(self.half_edge_v)).then_some(way)
    }
}

impl Scene {
    /// The camera, once all is seen to be in order around a gem.
    ///
    /// # Errors
    /// [`SceneError`] for a view, lamps or dome that are none, a camera in the gem or behind a
    /// lamp, a lamp in the gem.
    pub fn camera(&self, gem: &Solid) -> Result<Camera, SceneError> {
        if !(0.0..=1e6).contains(&self.dome) {
            return Err(SceneError::Dome { found: self.dome });
        }
        let camera = self.view.camera()?;
        if gem.contains(self.view.from) {
            return Err(SceneError::Inside);
        }
        for (index, lamp) in self.lamps.iter().enumerate() {
            let number = index + 1;
            let (u, v) = (lamp.half_edge_u, lamp.half_edge_v);
            let is_square = dot(u, v).abs() < 1e-6 * (dot(u, u) + dot(v, v));
            let Some(normal) = lamp.normal().filter(|_| {
                [lamp.centre, u, v].into_iter().all(is_near)
                    && is_square
                    && (0.0..=1e6).contains(&lamp.radiance)
            }) else {
                return Err(SceneError::Lamp { number });
            };
            let mut places = lamp.corners().into_iter().chain([lamp.centre]);
            if places.any(|place| gem.contains(place)) {
                return Err(SceneError::LampInGem { number });
            }
            let to_gem = minus(self.view.towards, self.view.from);
            let way = lamp.met(self.view.from, to_gem);
            if dot(normal, to_gem) > 0.0 && way.is_some_and(|way| way < 1.0) {
                return Err(SceneError::BehindLamp { number });
            }
        }
        Ok(camera)
    }
}

impl View {
    fn camera(&self) -> Result<Camera, SceneError> {
        if !is_near(self.from) || !is_near(self.towards) {
            return Err(SceneError::View {
                what: said!("numbers that are not finite or above 1e6"),
            });
        }
        if !(self.angle_deg > 0.0 && self.angle_deg < 180.0) {
            return Err(SceneError::Angle {
                found: self.angle_deg,
            });
        }
        let forward = unit(minus(self.towards, self.from));
        let forward = forward.ok_or(SceneError::View {
            what: said!("both at one place"),
        })?;
        // Straight from above or below any side may be up: y.
        let up = match forward[2].abs() > 1.0 - 1e-9 {
            true => [0.0, 1.0, 0.0],
            false => [0.0, 0.0, 1.0],
        };
        let right = unit(cross(forward, up)).ok_or(SceneError::View {
            what: said!("no direction"),
        })?;
        let tangent = (0.5 * self.angle_deg).to_radians().tan();
        Ok(Camera {
            origin: self.from,
            forward,
            right: right.map(|v| v * tangent),
            upward: cross(right, forward).map(|v| v * tangent),
        })
    }
}

impl Camera {
    /// Direction, of length 1, through a film point from -1 to 1 to the right and upward.
    pub(crate) fn direction(&self, [x, y]: [f64; 2]) -> Vec3 {
        let d = plus(plus(self.forward, self.right, x), self.upward, y);
        let over = 1.0 / dot(d, d).sqrt();
        d.map(|v| v * over)
    }

    /// Film point of a place; `None` behind the camera.
    pub(crate) fn film_point(&self, place: Vec3) -> Option<[f64; 2]> {
        let off = minus(place, self.origin);
        let depth = dot(off, self.forward);
        let along = |axis: Vec3| dot(off, axis) / (depth * dot(axis, axis));
        (depth > 1e-9).then(|| [along(self.right), along(self.upward)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cube() -> Solid {
        Solid::cube(0.5).unwrap()
    }

    #[test]
    fn a_film_point_and_its_ray_lead_to_one_another() {
        let camera = Scene::default().camera(&cube()).unwrap();
        for point in [[0.0, 0.0], [-0.7, 0.3], [1.0, -1.0]] {
            let place = plus(camera.origin, camera.direction(point), 5.0);
            let back = camera.film_point(place).unwrap();
            assert!((0..2).all(|k| (back[k] - point[k]).abs() < 1e-12));
        }
        let [x, y] = camera.film_point([0.0, 0.0, 1.0]).unwrap();
        assert!(x.abs() < 1e-12 && y > 0.0, "up is up");
        assert!(
            camera.film_point([1.0, 0.0, 0.0]).unwrap()[0] > 0.0,
            "right is right"
        );
    }

    #[test]
    fn a_jewellers_lamps_face_the_gem_and_hide_it_from_nowhere() {
        let scene = Scene::jeweller();
        for lamp in &scene.lamps {
            let normal = lamp.normal().unwrap();
            let towards = unit(lamp.centre.map(|v| -v)).unwrap();
            assert!((dot(normal, towards) - 1.0).abs() < 1e-12, "{lamp:?}");
        }
        let usual = View::A;
        let off = minus(usual.from, usual.towards);
        let distance = dot(off, off).sqrt();
        for turn in 0..36 {
            for height in [15.0, 30.0, 45.0, 60.0, 75.0, 89.0_f64] {
                let (turn, height) = (f64::from(10 * turn).to_radians(), height.to_radians());
                let way = [
                    height.cos() * turn.sin(),
                    -height.cos() * turn.cos(),
                    height.sin(),
                ];
                let from = plus(usual.towards, way, distance);
                let view = View { from, ..usual };
                let scene = Scene {
                    view,
                    ..scene.clone()
                };
                assert!(scene.camera(&cube()).is_ok(), "{from:?}");
            }
        }
    }
}
