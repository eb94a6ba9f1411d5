//! The whole tree of rays in a convex body is one chain.
//!
//! Light that leaves a convex body never meets it again. So a ray is followed without branching:
//! at each face what is not reflected leaves and sees the surroundings, and the reflected rest goes
//! on. Thirty-two chains run side by side, in arrays that the compiler turns into vectors; a chain that
//! ends makes room for the next.

use super::{
    lanes::{
        LANES, Lanes, Leaving, Panel, Start, move_on, reflected_share, split, try_panel, try_plane,
    },
    real::Real,
    scene::{Camera, Scene},
    solid::{Solid, Vec3, cross, dot},
};

/// Planes side by side where a single ray looks for its first.
const WIDE: usize = 4;

/// When a chain ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ending {
    /// Below this weight a chain survives by chance, made heavier in return; 0 for never.
    pub roulette_below: f64,
    /// A chain is cut after so many faces, and the cut energy counted.
    pub most_faces: u32,
}

impl Default for Ending {
    fn default() -> Self {
        Self {
            roulette_below: 0.05,
            most_faces: 512,
        }
    }
}

/// Counts of a trace.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traced {
    /// Rays through the film.
    pub rays: u64,
    /// Those that met the gem.
    pub chains: u64,
    /// Faces that chains met from inside.
    pub segments: u64,
    /// Chains cut at the most faces.
    pub cut: u64,
    /// Sum of the weights that were cut.
    pub cut_weight: f64,
}

impl Traced {
    /// Counts another.
    pub(crate) fn add(&mut self, other: &Self) {
        self.rays += other.rays;
        self.chains += other.chains;
        self.segments += other.segments;
        self.cut += other.cut;
        self.cut_weight += other.cut_weight;
    }

    /// Segments inside the gem for each ray that met it.
    pub fn segments_per_ray(&self) -> f64 {
        if self.chains == 0 {
            0.0
        } else {
            self.segments as f64 / self.chains as f64
        }
    }
}

/// A number for each of some planes.
type Wide<T> = [T; WIDE];

/// Body and surroundings, ready for chains.
#[derive(Clone, Debug)]
pub(super) struct Stage<T> {
    /// Normal and distance of each plane.
    planes: Vec<[T; 4]>,
    /// Normals over the camera's room behind each plane, and its number: of those it is before.
    seen: Vec<[Wide<T>; 4]>,
    /// Of those it is behind.
    hidden: Vec<[Wide<T>; 4]>,
    camera: [T; 3],
    panels: Vec<Panel<T>>,
    /// The lamps that may stand in the picture.
    in_sight: Vec<Panel<T>>,
    /// Extent of the body on the film, from -1 to 1.
    covered: [[f64; 2]; 2],
    dome: T,
    ending: Ending,
}

/// Chains that are asked for, and where their results go.
pub(super) trait Work<T> {
    /// The next chain that met the body.
    fn next(&mut self) -> Option<Start<T>>;
    /// The radiance that a chain found, and its owner.
    fn done(&mut self, owner: u32, radiance: T);
}

fn cast<T: Real>(v: Vec3) -> [T; 3] {
    v.map(T::of)
}

/// Planes in groups; the last is repeated where a group is not full.
fn side_by_side<T: Real>(planes: &[[T; 4]]) -> Vec<[Wide<T>; 4]> {
    let group = |some: &[[T; 4]]| {
        let at = |l: usize| some[l.min(some.len() - 1)];
        std::array::from_fn(|k| std::array::from_fn(|l| at(l)[k]))
    };
    planes.chunks(WIDE).map(group).collect()
}

#[inline(always)]
fn product<T: Real>(a: [T; 3], b: [T; 3]) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

impl<T: Real> Stage<T> {
    /// A body in a scene whose camera was found in order.
    pub(super) fn new(solid: &Solid, scene: &Scene, camera: &Camera, ending: Ending) -> Self {
        let origin = scene.view.from;
        let (mut seen, mut hidden) = (Vec::new(), Vec::new());
        let mut stage = Self {
            planes: Vec::new(),
            seen: Vec::new(),
            hidden: Vec::new(),
            camera: cast(origin),
            panels: Vec::new(),
            in_sight: Vec::new(),
            covered: covered(camera, solid.corners()),
            dome: T::of(scene.dome),
            ending,
        };
        for (number, plane) in solid.planes().iter().enumerate() {
            let [x, y, z] = cast::<T>(plane.normal);
            stage.planes.push([x, y, z, T::of(plane.distance)]);
            let room = plane.distance - dot(plane.normal, origin);
            // In a plane it is just behind it.
            let room = if room == 0.0 { 1e-12 } else { room };
            let [x, y, z] = cast(plane.normal.map(|v| v / room));
            let side = if room < 0.0 { &mut seen } else { &mut hidden };
            side.push([x, y, z, T::of(number as f64)]);
        }
        stage.seen = side_by_side(&seen);
        stage.hidden = side_by_side(&hidden);
        for lamp in &scene.lamps {
            let Some(normal) = lamp.normal() else {
                continue;
            };
            let edges = [lamp.half_edge_u, lamp.half_edge_v].map(|e| e.map(|v| v / dot(e, e)));
            debug_assert!(dot(normal, cross(lamp.half_edge_u, lamp.half_edge_v)) > 0.0);
            let panel = Panel {
                normal: cast(normal),
                distance: T::of(dot(normal, lamp.centre)),
                edges: edges.map(cast),
                middle: edges.map(|e| T::of(dot(e, lamp.centre))),
                radiance: T::of(lamp.radiance),
            };
            stage.panels.push(panel);
            let [x, y] = covered(camera, &lamp.corners());
            if x[0] <= 1.0 && x[1] >= -1.0 && y[0] <= 1.0 && y[1] >= -1.0 {
                stage.in_sight.push(panel);
            }
        }
        stage
    }

    /// The plane that a ray from the camera enters by, and how far off; `None` where it misses.
    fn entry(&self, direction: [T; 3]) -> Option<(usize, T)> {
        // One over the way to each plane: the farthest of those entered, the nearest of those left.
        let mut enters = [T::FAR; WIDE];
        let mut numbers = [T::ZERO; WIDE];
        let [x, y, z] = direction;
        for [n_x, n_y, n_z, number] in &self.seen {
            for l in 0..WIDE {
                let over = n_x[l] * x + n_y[l] * y + n_z[l] * z;
                let is_nearer = over < enters[l];
                numbers[l] = if is_nearer { number[l] } else { numbers[l] };
                enters[l] = over.below(enters[l]);
            }
        }
        let mut leaves = [T::ZERO; WIDE];
        for [n_x, n_y, n_z, _] in &self.hidden {
            for l in 0..WIDE {
                let over = n_x[l] * x + n_y[l] * y + n_z[l] * z;
                leaves[l] = leaves[l].above(over);
            }
        }
        let leaves = leaves.into_iter().fold(T::ZERO, T::above);
        let farthest = |best: usize, l: usize| if enters[l] < enters[best] { l } else { best };
        let best = (1..WIDE).fold(0, farthest);
        let over = enters[best];
        (over < T::FAR && over > T::TINY && over > leaves)
            .then(|| (numbers[best].double() as usize, T::ONE / over))
    }

    /// True if a ray from the camera meets the body.
    pub(super) fn meets(&self, direction: Vec3) -> bool {
        self.entry(cast(direction)).is_some()
    }

    /// A ray from the camera: either what it sees beside the body, or the chain that begins.
    pub(super) fn begin(
        &self,
        film: [f64; 2],
        direction: Vec3,
        [index, absorption]: [f64; 2],
        state: u32,
        owner: u32,
    ) -> Result<Start<T>, T> {
        let d = cast::<T>(direction);
        let [x, y] = self.covered;
        let near = (x[0]..=x[1]).contains(&film[0]) && (y[0]..=y[1]).contains(&film[1]);
        let entry = if near { self.entry(d) } else { None };
        let Some((number, way)) = entry else {
            return Err(self.around(&self.in_sight, self.camera, d, T::FAR).0);
        };
        // A lamp before the body hides it.
        let (seen, met) = self.around(&self.in_sight, self.camera, d, way);
        if met {
            return Err(seen);
        }
        let origin: [T; 3] = std::array::from_fn(|k| self.camera[k] + way * d[k]);
        let [x, y, z, _] = self.planes[number];
        let normal = [x, y, z];
        let index = T::of(index);
        let cos = -product(normal, d);
        let sine = (T::ONE - cos * cos).above(T::ZERO) / (index * index);
        let cos_inside = (T::ONE - sine).above(T::ZERO).root();
        let reflected = reflected_share(T::ONE, cos, index, cos_inside);
        let twice = cos + cos;
        let away: [T; 3] = std::array::from_fn(|k| d[k] + twice * normal[k]);
        let outside = if reflected > T::ZERO {
            self.around(&self.panels, origin, away, T::FAR).0
        } else {
            T::ZERO
        };
        let bend = cos / index - cos_inside;
        Ok(Start {
            origin,
            direction: std::array::from_fn(|k| d[k] / index + bend * normal[k]),
            weight: T::ONE - reflected,
            radiance: reflected * outside,
            index,
            absorption: T::of(absorption),
            state: state | 1,
            owner,
        })
    }

    /// Radiance along a ray up to the way `nearer`, and true if a lamp is met on it.
    fn around(
        &self,
        panels: &[Panel<T>],
        origin: [T; 3],
        direction: [T; 3],
        nearer: T,
    ) -> (T, bool) {
        let (mut best, mut value) = (nearer, self.dome);
        let mut met = false;
        for panel in panels {
            let facing = product(panel.normal, direction);
            let way = (panel.distance - product(panel.normal, origin)) / facing;
            if !(way > T::ZERO && way < best) {
                continue;
            }
            let place: [T; 3] = std::array::from_fn(|k| origin[k] + way * direction[k]);
            let off = |e: usize| (product(panel.edges[e], place) - panel.middle[e]).size();
            if off(0) <= T::ONE && off(1) <= T::ONE {
                best = way;
                met = true;
                value = if facing < T::ZERO {
                    panel.radiance
                } else {
                    T::ZERO
                };
            }
        }
        (value, met)
    }

    /// Follows chains to their ends.
    pub(super) fn follow(&self, work: &mut impl Work<T>, traced: &mut Traced) {
        let mut lanes = Lanes::idle();
        let mut busy = 0;
        for lane in 0..LANES {
            if let Some(start) = work.next() {
                lanes.put(lane, &start);
                busy += 1;
            }
        }
        let absorbs = |lanes: &Lanes<T>| lanes.absorption.iter().any(|a| *a > T::ZERO);
        let below = T::of(self.ending.roulette_below);
        while busy > 0 {
            let absorbing = absorbs(&lanes);
            self.step(&mut lanes, absorbing);
            for lane in 0..LANES {
                if !lanes.busy[lane] {
                    continue;
                }
                lanes.faces[lane] += 1;
                let weight = lanes.weight[lane];
                let is_cut = lanes.faces[lane] >= self.ending.most_faces;
                if weight >= below && weight > T::ZERO && !is_cut {
                    continue;
                }
                if weight > T::ZERO && !is_cut && lanes.survives(lane, weight, below) {
                    continue;
                }
                if is_cut && weight > T::ZERO {
                    traced.cut += 1;
                    traced.cut_weight += weight.double();
                }
                traced.chains += 1;
                traced.segments += u64::from(lanes.faces[lane]);
                work.done(lanes.owner[lane], lanes.radiance[lane]);
                if let Some(start) = work.next() {
                    lanes.put(lane, &start);
                } else {
                    lanes.rest(lane);
                    busy -= 1;
                }
            }
        }
    }

    /// All lanes to their next face.
    fn step(&self, lanes: &mut Lanes<T>, absorbs: bool) {
        let mut over = [T::TINY; LANES];
        let mut face = [T::ZERO; LANES];
        let mut number = T::ZERO;
        for plane in &self.planes {
            try_plane(plane, number, lanes, &mut over, &mut face);
            number = number + T::ONE;
        }
        let mut normal = [[T::ZERO; LANES]; 3];
        for lane in 0..LANES {
            let plane = &self.planes[face[lane].double() as usize];
            for k in 0..3 {
                normal[k][lane] = plane[k];
            }
        }
        move_on(lanes, &over);
        if absorbs {
            let depths = lanes.absorption.iter().zip(&over);
            for (weight, (a, over)) in lanes.weight.iter_mut().zip(depths) {
                *weight = *weight * (-(*a / *over)).exponential();
            }
        }
        let mut leaving = Leaving {
            direction: [[T::ZERO; LANES]; 3],
            power: [T::ZERO; LANES],
        };
        split(lanes, &normal, &mut leaving);
        let mut best = [T::FAR; LANES];
        let mut value = [self.dome; LANES];
        for panel in &self.panels {
            try_panel(
                panel,
                &lanes.origin,
                &leaving.direction,
                &mut best,
                &mut value,
            );
        }
        let gone = leaving.power.iter().zip(&value);
        for (radiance, (power, value)) in lanes.radiance.iter_mut().zip(gone) {
            *radiance = *radiance + *power * *value;
        }
    }
}

/// Extent of corners on the film, x and y; all of it when one is behind the camera.
fn covered(camera: &Camera, corners: &[Vec3]) -> [[f64; 2]; 2] {
    /// Rounding of single precision, of the whole film.
    const MARGIN: f64 = 1e-5;
    let mut covered = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for corner in corners {
        let Some(place) = camera.film_point(*corner) else {
            return [[f64::NEG_INFINITY, f64::INFINITY]; 2];
        };
        for (range, place) in covered.iter_mut().zip(place) {
            *range = [range[0].min(place - MARGIN), range[1].max(place + MARGIN)];
        }
    }
    covered
}
