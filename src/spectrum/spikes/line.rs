//! Extraction of one line from a spectrum.
//!
//! A window is rounded outward to whole nm: its first grid point is the last one at or before its
//! computed beginning, its last one the first at or after its computed end. Both stay within the
//! lowest points towards the neighbours and within what was measured.
//!
//! At an end of the range one foot may be missing. A window that reaches the end has its ground there
//! at the height of its other foot if the curve only falls from the peak to the end and still stands
//! a tenth of the line's height above that foot; else its ground is the curve at the end, as
//! everywhere. A line whose highest point is the end itself is none to the detector; one that is
//! taken by hand has a level ground.

use super::{FoundSpike, LineShape, peaks::Peak};
use crate::spectrum::{
    band::Band,
    line::{GAUSSIAN_AREA, Line},
};

/// A line's window reaches this many of its widths beyond its peak: a Gaussian has 0.04 % left.
const WINDOW_WIDTHS: f64 = 1.5;
/// One more nm on each side, so that a line of one sample still has a foot.
const WINDOW_MARGIN_NM: f64 = 1.0;
/// Narrowest width used for a window: a line between two samples looks this wide.
const NARROWEST_NM: f64 = 2.0;
/// Share of a line's height by which the curve at an end of the range must exceed the line's other
/// foot for that end to cut its flank.
const CUT_FLANK: f64 = 0.1;

/// The part that one group would remove.
pub(super) struct Taken {
    pub(super) first: usize,
    pub(super) residue: Vec<f64>,
    pub(super) energy: f64,
    at_nm: f64,
    pub(super) width_nm: f64,
}

impl Taken {
    pub(super) fn take_from(&self, values: &mut [f64]) {
        for (v, r) in values[self.first..].iter_mut().zip(&self.residue) {
            *v -= r;
        }
    }

    pub(super) fn shape(&self, band: Band, sign: f64) -> LineShape {
        LineShape {
            spike: self.found(band, 1, sign).spike,
            first: self.first,
            residue: self.residue.iter().map(|r| sign * r).collect(),
        }
    }

    pub(super) fn found(&self, band: Band, peaks: usize, sign: f64) -> FoundSpike {
        FoundSpike {
            spike: Line::ideal(self.at_nm, sign * self.energy),
            width_nm: self.width_nm,
            peaks,
            window_nm: [
                band.nm(self.first),
                band.nm(self.first + self.residue.len() - 1),
            ],
        }
    }
}

/// Computes the part that a group would remove; `ends` are the first measured index and one past
/// the last.
pub(super) fn weigh(
    band: Band,
    values: &[f64],
    members: &[Peak],
    limits: (usize, usize),
    ends: (usize, usize),
) -> Option<Taken> {
    let (first, last) = window_of(members, limits)?;
    let mut ground = values[first..=last].to_vec();
    // A flank that an end cuts has no foot on that side: the other foot is the ground there.
    let (head, tail) = (ground[0], ground[last - first]);
    let is_flank = |values: &mut dyn Iterator<Item = &f64>, foot: f64| {
        let falling: Vec<f64> = values.copied().collect();
        let (top, end) = (falling[0], falling[falling.len() - 1]);
        falling.is_sorted_by(|a, b| a >= b) && end - foot > CUT_FLANK * (top - foot)
    };
    if first == ends.0 && is_flank(&mut values[first..=members.first()?.at].iter().rev(), tail) {
        ground[0] = tail;
    }
    if last + 1 == ends.1 && is_flank(&mut values[members.last()?.at..=last].iter(), head) {
        ground[last - first] = head;
    }
    weigh_window(band, values, (first, last), &lower_hull(&ground))
}

/// First and last index of a group's window, within its limits.
pub(super) fn window_of(members: &[Peak], limits: (usize, usize)) -> Option<(usize, usize)> {
    let (head, tail) = (members.first()?, members.last()?);
    // The widest member decides: a shoulder's own width says nothing about the line it sits on.
    let widest = members.iter().map(|p| p.width).fold(NARROWEST_NM, f64::max);
    let reach = WINDOW_WIDTHS * widest + WINDOW_MARGIN_NM;
    let first = ((head.at as f64 - reach).floor().max(0.0) as usize).max(limits.0);
    let last = ((tail.at as f64 + reach).ceil() as usize).min(limits.1);
    (last > first).then_some((first, last))
}

/// Computes the part above a baseline in a window.
pub(super) fn weigh_window(
    band: Band,
    values: &[f64],
    (first, last): (usize, usize),
    baseline: &[f64],
) -> Option<Taken> {
    let window = &values[first..=last];
    let residue: Vec<f64> = window
        .iter()
        .zip(baseline)
        .map(|(v, b)| (v - b).max(0.0))
        .collect();
    // Heights as shares of the highest: no sum overflows, and nothing tiny is lost.
    let top = residue.iter().copied().fold(0.0, f64::max);
    let (mut area, mut moment) = (0.0, 0.0);
    for (i, r) in residue.iter().enumerate() {
        let share = band.weight(first + i) * (r / top);
        area += share;
        moment += share * band.nm(first + i);
    }
    (top > 0.0).then(|| Taken {
        first,
        energy: area * top,
        // Rounding must not carry a line at the end of the range out of it.
        at_nm: (moment / area).clamp(band.nm(first), band.nm(last)),
        width_nm: area / GAUSSIAN_AREA,
        residue,
    })
}

/// The lower convex hull of equally spaced values, read off at every point (Andrew's scan).
pub(super) fn lower_hull(values: &[f64]) -> Vec<f64> {
    let mut corners: Vec<usize> = Vec::with_capacity(values.len());
    for i in 0..values.len() {
        while let [.., a, b] = corners[..] {
            let rise_ab = (values[b] - values[a]) * (i - a) as f64;
            let rise_ai = (values[i] - values[a]) * (b - a) as f64;
            if rise_ab >= rise_ai {
                corners.pop();
            } else {
                break;
            }
        }
        corners.push(i);
    }
    let mut hull = Vec::with_capacity(values.len());
    for pair in corners.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let slope = (values[b] - values[a]) / (b - a) as f64;
        hull.extend((a..b).map(|i| values[a] + slope * (i - a) as f64));
    }
    hull.push(values[values.len() - 1]);
    hull
}
