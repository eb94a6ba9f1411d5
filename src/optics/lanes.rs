//! Chains side by side: their numbers in arrays, a loop over the lanes for each step.

use super::real::Real;

/// Chains side by side.
pub(super) const LANES: usize = 32;

/// A number for each chain.
pub(super) type All<T> = [T; LANES];

/// A lamp with what each of its tests multiplies by.
#[derive(Clone, Copy, Debug)]
pub(super) struct Panel<T> {
    pub(super) normal: [T; 3],
    pub(super) distance: T,
    /// Edges over their squared half lengths: inside is from -1 to 1.
    pub(super) edges: [[T; 3]; 2],
    /// The middle's own place along them.
    pub(super) middle: [T; 2],
    pub(super) radiance: T,
}

/// A chain that begins: inside the body, after its first face.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Start<T> {
    pub(super) origin: [T; 3],
    pub(super) direction: [T; 3],
    pub(super) weight: T,
    pub(super) radiance: T,
    pub(super) index: T,
    pub(super) absorption: T,
    /// Chance, never 0.
    pub(super) state: u32,
    /// Whose result it is.
    pub(super) owner: u32,
}

/// The state of all lanes.
#[derive(Default)]
pub(super) struct Lanes<T> {
    pub(super) origin: [All<T>; 3],
    pub(super) direction: [All<T>; 3],
    pub(super) weight: All<T>,
    pub(super) radiance: All<T>,
    pub(super) index: All<T>,
    pub(super) absorption: All<T>,
    pub(super) state: [u32; LANES],
    pub(super) owner: [u32; LANES],
    pub(super) faces: [u32; LANES],
    pub(super) busy: [bool; LANES],
}

/// Light that leaves the body at a face.
pub(super) struct Leaving<T> {
    pub(super) direction: [All<T>; 3],
    pub(super) power: All<T>,
}

// The functions below are not inlined, so that each is one loop over the lanes which the compiler
// turns into vectors: in the midst of others it takes the loops apart into single numbers.

/// Keeps a plane where it is met before those tried so far: the larger of one over the way.
#[inline(never)]
pub(super) fn try_plane<T: Real>(
    [x, y, z, distance]: &[T; 4],
    number: T,
    lanes: &Lanes<T>,
    over: &mut All<T>,
    face: &mut All<T>,
) {
    let (o, d) = (&lanes.origin, &lanes.direction);
    for l in 0..LANES {
        let room = *distance - (*x * o[0][l] + *y * o[1][l] + *z * o[2][l]);
        let along = *x * d[0][l] + *y * d[1][l] + *z * d[2][l];
        let here = along / room.above(T::TINY);
        // Numbers rise, so the last that was nearer is the largest.
        let nearer = if here > over[l] { number } else { T::ZERO };
        face[l] = nearer.above(face[l]);
        over[l] = here.above(over[l]);
    }
}

/// To the next face.
#[inline(never)]
pub(super) fn move_on<T: Real>(lanes: &mut Lanes<T>, over: &All<T>) {
    let (o, d) = (&mut lanes.origin, &lanes.direction);
    for l in 0..LANES {
        let way = T::ONE / over[l];
        o[0][l] = o[0][l] + way * d[0][l];
        o[1][l] = o[1][l] + way * d[1][l];
        o[2][l] = o[2][l] + way * d[2][l];
    }
}

/// Parts what leaves at a face from what goes on.
#[inline(never)]
pub(super) fn split<T: Real>(lanes: &mut Lanes<T>, n: &[All<T>; 3], leaving: &mut Leaving<T>) {
    let (d, index, weight) = (&mut lanes.direction, &lanes.index, &mut lanes.weight);
    let out = &mut leaving.direction;
    for l in 0..LANES {
        let i = index[l];
        let along = n[0][l] * d[0][l] + n[1][l] * d[1][l] + n[2][l] * d[2][l];
        let cos = along.below(T::ONE);
        // Squared cosine outside; not positive where all is reflected.
        let left = T::ONE - i * i * (T::ONE - cos * cos);
        let cos_out = left.above(T::ZERO).root();
        let share = reflected_share(i, cos, T::ONE, cos_out);
        let share = if left > T::ZERO { share } else { T::ONE };
        let bend = cos_out - i * cos;
        out[0][l] = i * d[0][l] + bend * n[0][l];
        out[1][l] = i * d[1][l] + bend * n[1][l];
        out[2][l] = i * d[2][l] + bend * n[2][l];
        let stays = weight[l] * share;
        leaving.power[l] = weight[l] - stays;
        weight[l] = stays;
        let twice = cos + cos;
        d[0][l] = d[0][l] - twice * n[0][l];
        d[1][l] = d[1][l] - twice * n[1][l];
        d[2][l] = d[2][l] - twice * n[2][l];
    }
}

/// Keeps a lamp where it is met before those tried so far.
#[inline(never)]
pub(super) fn try_panel<T: Real>(
    panel: &Panel<T>,
    o: &[All<T>; 3],
    d: &[All<T>; 3],
    best: &mut All<T>,
    value: &mut All<T>,
) {
    let Panel {
        normal: n,
        distance,
        edges: [u, v],
        middle,
        radiance,
    } = *panel;
    for l in 0..LANES {
        let facing = n[0] * d[0][l] + n[1] * d[1][l] + n[2] * d[2][l];
        let room = distance - (n[0] * o[0][l] + n[1] * o[1][l] + n[2] * o[2][l]);
        let way = room / facing;
        let x = o[0][l] + way * d[0][l];
        let y = o[1][l] + way * d[1][l];
        let z = o[2][l] + way * d[2][l];
        let off_u = (u[0] * x + u[1] * y + u[2] * z - middle[0]).size();
        let off_v = (v[0] * x + v[1] * y + v[2] * z - middle[1]).size();
        let shine = if facing < T::ZERO { radiance } else { T::ZERO };
        let met = (way > T::ZERO) & (way < best[l]) & (off_u <= T::ONE) & (off_v <= T::ONE);
        // Both are written whatever is met: a store under a condition is no vector.
        let nearest = if met { way } else { T::FAR };
        best[l] = nearest.below(best[l]);
        value[l] = value[l] + if met { shine - value[l] } else { T::ZERO };
    }
}

/// Share of unpolarised light that a face reflects.
#[inline(always)]
pub(super) fn reflected_share<T: Real>(n1: T, cos1: T, n2: T, cos2: T) -> T {
    // Along the face all is 0 over 0 between equal indices: nothing is reflected.
    let share = |a: T, b: T| (a - b) / (a + b + T::TINY);
    let (s, p) = (share(n1 * cos1, n2 * cos2), share(n2 * cos1, n1 * cos2));
    T::HALF * (s * s + p * p)
}

impl<T: Real> Lanes<T> {
    pub(super) fn idle() -> Self {
        let mut lanes = Self::default();
        (0..LANES).for_each(|lane| lanes.rest(lane));
        lanes
    }

    /// An idle lane weighs nothing and stays in the body.
    pub(super) fn rest(&mut self, lane: usize) {
        let resting = Start {
            direction: [T::ZERO, T::ZERO, T::ONE],
            index: T::ONE,
            state: 1,
            ..Start::default()
        };
        self.put(lane, &resting);
        self.busy[lane] = false;
    }

    pub(super) fn put(&mut self, lane: usize, start: &Start<T>) {
        for k in 0..3 {
            self.origin[k][lane] = start.origin[k];
            self.direction[k][lane] = start.direction[k];
        }
        self.weight[lane] = start.weight;
        self.radiance[lane] = start.radiance;
        self.index[lane] = start.index;
        self.absorption[lane] = start.absorption;
        self.state[lane] = start.state;
        self.owner[lane] = start.owner;
        self.faces[lane] = 0;
        self.busy[lane] = true;
    }

    /// Russian roulette: survives with weight / below, and then weighs that.
    pub(super) fn survives(&mut self, lane: usize, weight: T, below: T) -> bool {
        // xorshift (Marsaglia 2003).
        let mut x = self.state[lane];
        x ^= x << 13;
        x ^= x >> 17;
        x ^= x << 5;
        self.state[lane] = x;
        let chance = T::of(f64::from(x) / 4_294_967_296.0);
        let lives = chance * below < weight;
        if lives {
            self.weight[lane] = below;
        }
        lives
    }
}
