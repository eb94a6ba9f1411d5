//! The edge of what a surface can do: how far a colour may go from grey.

use super::viewing::NODES;
use crate::design::{programme::Programme, small::combined};

/// The colours of a surface that reflects everything.
pub(super) fn white<const M: usize>(columns: &[[f64; M]; NODES]) -> [f64; M] {
    combined(columns, &[1.0; NODES])
}

/// Distance from grey to the edge of possible surface colours, as a multiple of `away`, and the
/// reflectance there.
pub(super) fn edge_behind<const M: usize>(
    columns: &[[f64; M]; NODES],
    grey: [f64; M],
    away: [f64; M],
) -> Option<(f64, [f64; NODES])> {
    // sum r_j c_j - t away = grey, greatest t.
    let mut wide: Vec<[f64; M]> = columns.to_vec();
    wide.push(away.map(|v| -v));
    let mut upper = vec![1.0; NODES];
    upper.push(f64::INFINITY);
    let mut gain = vec![0.0; NODES];
    gain.push(1.0);
    let mut programme = Programme::new(&wide, &upper, grey);
    let mut corner = programme.corner().ok()?;
    let edge = programme.maximise(&mut corner, &gain).ok()?;
    let found = programme.solution(&corner);
    Some((edge, std::array::from_fn(|j| found[j])))
}

/// A reflectance for a colour that no surface has: where the way to it from the grey of its
/// luminance leaves the body of what a surface can do. Not the nearest, but found at once.
pub(super) fn towards_grey<const M: usize>(
    columns: &[[f64; M]; NODES],
    target: [f64; M],
) -> [f64; NODES] {
    let greys = white(columns);
    let level = target[1].clamp(0.02, 0.98);
    let grey = greys.map(|v| v * level);
    let away: [f64; M] = std::array::from_fn(|k| target[k] - grey[k]);
    let edge = edge_behind(columns, grey, away);
    edge.map_or([level; NODES], |(_, found)| {
        found.map(|v| v.clamp(0.0, 1.0))
    })
}
