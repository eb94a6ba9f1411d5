//! The same surfaces under two lights: colour shifts, metameric pairs, metameric blacks.

use crate::{
    color::{Lab, Weights, Xyz, delta_e_2000, lab_from_xyz, xyz_of_parts},
    spectrum::{Band, Basis, product::multiply},
    study::Progress,
};

/// Two surfaces with the same colour are one unless their curves differ by this much (root mean
/// square over the band): below it they are repeated measurements of the same paint.
pub(super) const DIFFERENT_RMS: f64 = 0.01;

/// Pairs this close under the first light match: side by side they are hard to tell apart. The one
/// bound of a colour that is hard to tell from another (CIEDE2000).
pub(crate) const MATCH_DELTA_E: f64 = 1.0;

/// A surface under two lights, each seen against its own white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnderBoth {
    /// XYZ under each light, Y of the light at 100.
    pub xyz: [Xyz; 2],
    /// L\*a\*b\* under each.
    pub labs: [Lab; 2],
    /// CIEDE2000 between the two: how far the colour moves when the light is changed.
    pub delta_e_2000: f64,
}

/// A set of surfaces under two lights.
#[derive(Clone, Debug, PartialEq)]
pub struct TwoLights {
    /// XYZ of each light, Y at 100.
    pub whites: [Xyz; 2],
    /// The surfaces in their order.
    pub patches: Vec<UnderBoth>,
}

/// Two surfaces that match under the first light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MetamericPair {
    /// Indices in the set, the lower one first.
    pub pair: [usize; 2],
    /// CIEDE2000 under the first light, and under the second once what is left under the first is
    /// corrected.
    pub delta_e_2000: [f64; 2],
    /// Root mean square difference of the two curves.
    pub rms: f64,
}

/// Metameric pairs of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct Metamers {
    /// Pairs that match under the first light, those that part most under the second first.
    pub pairs: Vec<MetamericPair>,
    /// Metamerism index: mean CIEDE2000 of these pairs under the second; `None` without a pair.
    pub index: Option<f64>,
}

/// Shows surfaces (on the band's grid) under two lights (on the same grid).
///
/// `None` when one of the lights has no positive Y.
pub(crate) fn two_lights(
    band: Band,
    surfaces: &[Vec<f64>],
    lights: [&[f64]; 2],
    seen: &Weights,
) -> Option<TwoLights> {
    let whites = lights.map(|light| xyz_of_parts(band, light, &[], seen));
    let scaled = [whites[0].with_y(100.0)?, whites[1].with_y(100.0)?];
    let patches = surfaces.iter().map(|surface| {
        let colours = [0, 1].map(|i| {
            let raw = xyz_of_parts(band, &multiply(lights[i], surface), &[], seen);
            raw * (100.0 / whites[i].y)
        });
        let labs = [0, 1].map(|i| lab_from_xyz(colours[i], scaled[i]));
        UnderBoth {
            xyz: colours,
            labs,
            delta_e_2000: delta_e_2000(labs[0], labs[1]),
        }
    });
    Some(TwoLights {
        whites: scaled,
        patches: patches.collect(),
    })
}

impl TwoLights {
    /// Mean CIEDE2000 of all surfaces; `None` without any.
    pub fn mean(&self) -> Option<f64> {
        let sum: f64 = self.patches.iter().map(|p| p.delta_e_2000).sum();
        (!self.patches.is_empty()).then(|| sum / self.patches.len() as f64)
    }
}

/// Pairs of different surfaces closer than `match_delta_e` under the first light, the farthest
/// apart under the second first. `surfaces` are those of `seen`, on the band's grid. A step of
/// progress each; `None` when it was cancelled.
pub(crate) fn metameric_pairs(
    band: Band,
    surfaces: &[Vec<f64>],
    both: &TwoLights,
    match_delta_e: f64,
    progress: &Progress,
) -> Option<Metamers> {
    let mut pairs = Vec::new();
    for (i, a) in both.patches.iter().enumerate() {
        if progress.is_cancelled() {
            return None;
        }
        progress.step();
        for (j, b) in both.patches.iter().enumerate().skip(i + 1) {
            // CIEDE2000 divides a difference of lightness by less than 2, so that this one alone
            // is beyond the match: no need for the whole formula.
            if (a.labs[0].l - b.labs[0].l).abs() > 4.0 * match_delta_e {
                continue;
            }
            let first = delta_e_2000(a.labs[0], b.labs[0]);
            if first >= match_delta_e {
                continue;
            }
            let rms = rms_difference(band, &surfaces[i], &surfaces[j]);
            let second = matched_first(a, b, both.whites[1]);
            if rms >= DIFFERENT_RMS {
                pairs.push(MetamericPair {
                    pair: [i, j],
                    delta_e_2000: [first, second],
                    rms,
                });
            }
        }
    }
    pairs.sort_by(|a, b| b.delta_e_2000[1].total_cmp(&a.delta_e_2000[1]));
    let sum: f64 = pairs.iter().map(|pair| pair.delta_e_2000[1]).sum();
    Some(Metamers {
        index: (!pairs.is_empty()).then(|| sum / pairs.len() as f64),
        pairs,
    })
}

/// CIEDE2000 of two surfaces under the second light once they match under the first: the second
/// surface's X, Y and Z are multiplied by what brings them to the first one's there (the
/// multiplicative correction of CIE 15). Without it a pair's small difference under the first
/// light would count as metamerism under the second.
fn matched_first(a: &UnderBoth, b: &UnderBoth, white: Xyz) -> f64 {
    let ([a_first, _], [b_first, b_second]) = (a.xyz, b.xyz);
    let corrected = Xyz {
        x: b_second.x * a_first.x / b_first.x,
        y: b_second.y * a_first.y / b_first.y,
        z: b_second.z * a_first.z / b_first.z,
    };
    // A channel without any light has nothing to be corrected by.
    let corrected = if corrected.is_finite() {
        corrected
    } else {
        b_second
    };
    delta_e_2000(a.labs[1], lab_from_xyz(corrected, white))
}

fn rms_difference(band: Band, a: &[f64], b: &[f64]) -> f64 {
    let rest: Vec<f64> = a.iter().zip(b).map(|(a, b)| a - b).collect();
    (band.inner(&rest, &rest) / band.length_nm()).sqrt()
}

/// A curve that a light shows as nothing, and how much of it a surface has room for.
#[derive(Clone, Debug, PartialEq)]
pub struct Black {
    /// The curve on the grid.
    pub curve: Vec<f64>,
    /// Largest multiples of it that may be added before the sum leaves 0 to 1: down (not above 0)
    /// and up (not below 0).
    pub room: [f64; 2],
}

impl Black {
    /// A surface with a share of the room used: -1 all the way down, 0 the surface itself, 1 all
    /// the way up.
    pub(crate) fn added(&self, surface: &[f64], share: f64) -> Vec<f64> {
        let share = share.clamp(-1.0, 1.0);
        let scale = if share < 0.0 {
            -share * self.room[0]
        } else {
            share * self.room[1]
        };
        let sum = surface.iter().zip(&self.curve).map(|(r, b)| r + scale * b);
        // Where it touches 0 or 1 the last bit may be on the other side.
        sum.map(|v| v.clamp(0.0, 1.0)).collect()
    }
}

/// The metameric black of a light, with its room on a surface.
///
/// The black is the one combination of the first four half-range cosines (the lowest order that
/// leaves any freedom) that the light shows as nothing: orthogonal to the three colour-matching
/// functions times the light. `None` when there is no room (a surface that touches 0 or 1 where
/// the black would leave), or the light is not seen on this band.
pub(crate) fn metameric_black(
    band: Band,
    surface: &[f64],
    light: &[f64],
    seen: &Weights,
) -> Option<Black> {
    let cosines: [Vec<f64>; 4] = std::array::from_fn(|k| {
        let function = |nm| Basis::Cosine.function(k, band, nm);
        band.grid().map(function).collect()
    });
    let mut rows: [[f64; 4]; 3] = [[0.0; 4]; 3];
    for (row, seen) in rows.iter_mut().zip(seen.iter()) {
        let weight = multiply(seen, light);
        *row = std::array::from_fn(|k| band.inner(&weight, &cosines[k]));
        let length = row.iter().map(|v| v * v).sum::<f64>().sqrt();
        if !(length > 0.0 && length.is_finite()) {
            return None;
        }
        row.iter_mut().for_each(|v| *v /= length);
    }
    let shares = orthogonal_to(rows)?;
    let mut curve = vec![0.0; band.points()];
    for (share, cosine) in shares.iter().zip(&cosines) {
        for (b, c) in curve.iter_mut().zip(cosine) {
            *b += share * c;
        }
    }
    // How far the sum can go up and down the black before it leaves 0 to 1.
    let (mut down, mut up) = (f64::NEG_INFINITY, f64::INFINITY);
    for (r, b) in surface.iter().zip(&curve).filter(|(_, b)| **b != 0.0) {
        let (to_0, to_1) = (-r / b, (1.0 - r) / b);
        down = down.max(to_0.min(to_1));
        up = up.min(to_0.max(to_1));
    }
    let is_sound = down <= 0.0 && up >= 0.0 && down.is_finite() && up.is_finite();
    (is_sound && up > down).then_some(Black {
        curve,
        room: [down, up],
    })
}

/// Least size of the vector that three unit rows leave free, below which they do not tell four
/// functions apart.
const INDEPENDENT: f64 = 1e-9;

/// The unit vector orthogonal to three others, by their 3 x 3 minors.
fn orthogonal_to(rows: [[f64; 4]; 3]) -> Option<[f64; 4]> {
    let minor = |skip: usize| {
        let columns: Vec<usize> = (0..4).filter(|k| *k != skip).collect();
        let at = |i: usize, j: usize| rows[i][columns[j]];
        at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1))
            - at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0))
            + at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0))
    };
    let vector = [minor(0), -minor(1), minor(2), -minor(3)];
    let length = vector.iter().map(|v| v * v).sum::<f64>().sqrt();
    (length > INDEPENDENT).then(|| vector.map(|v| v / length))
}
