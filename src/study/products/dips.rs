//! Absorption lines of one spectrum: how deep its dips are.

use crate::spectrum::{Band, Line};

/// Share of the background that is missing at the deepest place of each spike of negative weight,
/// 0-1, in the spikes' order; `None` for one that stands up, and where the background has nothing
/// to miss.
///
/// `measured` is the curve and `background` the same with its dips filled and its lines taken
/// out, both on the band's grid. A dip reaches on both sides as far as the curve stays below.
pub(crate) fn depths(
    band: Band,
    measured: &[f64],
    background: &[f64],
    spikes: &[Line],
) -> Vec<Option<f64>> {
    let missing = |index: usize| background[index] - measured[index];
    let depth = |spike: &Line| {
        if spike.weight >= 0.0 || !band.contains(spike.at_nm) {
            return None;
        }
        let middle = ((spike.at_nm - band.min_nm()).round() as usize).min(band.steps());
        let below = |index: &usize| missing(*index) > 0.0;
        let left = (0..middle).rev().take_while(below);
        let right = (middle..band.points()).take_while(below);
        left.chain(right)
            .map(|index| missing(index) / background[index])
            .filter(|share| share.is_finite() && *share > 0.0)
            .max_by(f64::total_cmp)
            .map(|share| share.min(1.0))
    };
    spikes.iter().map(depth).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_dip_is_as_deep_as_what_is_missing_and_a_line_has_no_depth() {
        let band = Band::VISIBLE;
        let background = vec![2.0; band.points()];
        let measured: Vec<f64> = band
            .grid()
            .map(|nm| 2.0 - 1.5 * (-((nm - 500.0) / 3.0).powi(2)).exp())
            .collect();
        let spike = |at_nm, weight| Line::ideal(at_nm, weight);
        let spikes = [spike(500.4, -8.0), spike(600.0, 1.0), spike(900.0, -1.0)];
        let found = depths(band, &measured, &background, &spikes);
        assert_eq!(found, [Some(0.75), None, None]);
        let dark = vec![0.0; band.points()];
        let nothing = depths(band, &dark, &dark, &spikes[..1]);
        assert_eq!(nothing, [None]);
    }
}
