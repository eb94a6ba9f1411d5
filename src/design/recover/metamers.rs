//! The family of metamers: how different surfaces of the same colour can be.
//!
//! At each node the least and the greatest value that a reflectance of 0-1 with these colours can
//! have there, all others being free: two linear programmes a node, each started where the last
//! one ended. The band holds every reflectance of that colour which is straight between the nodes,
//! 5 nm apart: with finer nodes it is wider, without any it is 0-1 everywhere. A real surface,
//! being smooth, stays far inside it.

use super::viewing::{NODES, Nodes};
use crate::design::programme::Programme;

/// Least and greatest reflectance at each node.
#[derive(Clone, Debug, PartialEq)]
pub struct MetamerBand {
    /// Least value a node.
    pub least: Box<Nodes>,
    /// Greatest value a node.
    pub greatest: Box<Nodes>,
}

/// The band of all reflectances of 0-1 with these colours (white = 1); `None` where there is none.
pub(super) fn metamer_band<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: [f64; M],
) -> Option<MetamerBand> {
    let mut programme = Programme::new(&columns[..], &[1.0; NODES], target);
    let mut greatest_at = programme.corner().ok()?;
    let mut least_at = greatest_at.clone();
    let mut band = MetamerBand {
        least: Box::new([0.0; NODES]),
        greatest: Box::new([1.0; NODES]),
    };
    for node in 0..NODES {
        // A node that the light does not reach may have any value. Where rounding ends the search
        // the band is not narrowed.
        if let Ok(Some(value)) = programme.extreme(&mut greatest_at, node, 1.0) {
            band.greatest[node] = value.clamp(0.0, 1.0);
        }
        if let Ok(Some(value)) = programme.extreme(&mut least_at, node, -1.0) {
            band.least[node] = value.clamp(0.0, 1.0);
        }
    }
    Some(band)
}

/// Orders of the waves that examples differ by from the reflectance that they are made of.
const WAVES: std::ops::RangeInclusive<usize> = 3..=6;

/// Part of the way to 0 or 1 that an example goes.
const WAY: f64 = 0.9;

/// Reflectances of 0-1 with the same colours as one that is within 0 and 1, as different from it as
/// smooth waves can be: each wave added and taken away. What a wave adds to the colours is taken
/// out of it, weighted so that it vanishes where the reflectance reaches 0 or 1.
pub(super) fn metamer_examples<const M: usize>(
    columns: &[[f64; M]; NODES],
    of: &Nodes,
) -> Vec<Nodes> {
    let room = of.map(|value| (value * (1.0 - value)).max(0.0));
    // What adds to the colours, as orthonormal directions: Gram and Schmidt, twice.
    let mut seen: Vec<Nodes> = Vec::new();
    for column in (0..M).map(|k| columns.map(|node| node[k])) {
        let column = std::array::from_fn(|node| room[node] * column[node]);
        let rest = without(&seen, without(&seen, column));
        let length = inner(&rest, &rest).sqrt();
        if length > 0.0 {
            seen.push(rest.map(|value| value / length));
        }
    }
    let examples = WAVES.flat_map(|order| {
        let turn = |node: usize| (node as f64 + 0.5) * order as f64 / NODES as f64;
        let wave = std::array::from_fn(|node| (std::f64::consts::PI * turn(node)).cos());
        let hidden = without(&seen, without(&seen, wave));
        [1.0, -1.0].map(|sign| {
            let step: Nodes = std::array::from_fn(|node| sign * room[node] * hidden[node]);
            let limit = of.iter().zip(&step).map(|(value, step)| match *step {
                step if step > 0.0 => (1.0 - value) / step,
                step if step < 0.0 => -value / step,
                _ => f64::INFINITY,
            });
            let most = WAY * limit.fold(f64::INFINITY, f64::min);
            let most = if most.is_finite() { most } else { 0.0 };
            std::array::from_fn(|node| (of[node] + most * step[node]).clamp(0.0, 1.0))
        })
    });
    examples.collect()
}

fn inner(a: &Nodes, b: &Nodes) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A vector without its parts along others of length 1.
fn without(others: &[Nodes], mut vector: Nodes) -> Nodes {
    for other in others {
        let part = inner(&vector, other);
        vector
            .iter_mut()
            .zip(other)
            .for_each(|(v, o)| *v -= part * o);
    }
    vector
}
