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
