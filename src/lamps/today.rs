//! Today's ways at a count of numbers, as candidates beside known lamps and wide lines.
//!
//! A spike costs two numbers and there is no label: `P = B + 2M`.

use super::{encoder::Counted, encoding::Encoding};
use crate::{
    spectrum::{Basis, Line, SpikeSettings, detect_shapes},
    study::{FitVariant, ProjectedSpectrum, Reference},
};

/// A light in the ways whose basis words hold; without a line to be found, in those that have no
/// spikes.
pub(super) fn ways(exact: &Reference, counted: &Counted, spikes: SpikeSettings) -> Vec<Encoding> {
    let Counted { numbers, bases, .. } = counted;
    let values = exact.measured();
    let (_, shapes) = detect_shapes(exact.measures().band(), values, spikes);
    let mut found = Vec::with_capacity(FitVariant::ALL.len());
    let written = |basis: &Basis| basis.bit_in_words().is_some();
    for basis in Basis::ALL.into_iter().filter(written) {
        let projected = ProjectedSpectrum::new(&bases[basis], values, &shapes, exact.seen());
        for way in FitVariant::ALL.iter().filter(|way| way.basis == basis) {
            if way.spikes && projected.most_lines(*numbers) == 0 {
                // The same as without.
                continue;
            }
            let model = exact.with_best_lines(&projected, *way, *numbers);
            let ideal = |s: &Line| Line::ideal(s.at_nm, s.weight);
            found.push(Encoding {
                atoms: Vec::new(),
                lines: model.lines().iter().map(ideal).collect(),
                smooth: model.smooth().clone(),
                way: Some(*way),
            });
        }
    }
    found
}
