//! Lines and areas cut to their panel.

use super::primitive::{Field, Place};

/// The part of a segment inside a field (Liang and Barsky's method).
pub(super) fn cut_segment(ends: [Place; 2], field: Field) -> Option<[Place; 2]> {
    let [from, to] = ends;
    let [low, high] = field.corners();
    let is_inside = |at: Place| (0..2).all(|k| (low[k]..=high[k]).contains(&at[k]));
    if is_inside(from) && is_inside(to) {
        return Some(ends);
    }
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let step = to[axis] - from[axis];
        let (to_low, to_high) = (low[axis] - from[axis], high[axis] - from[axis]);
        if step == 0.0 {
            if to_low > 0.0 || to_high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (to_low / step, to_high / step);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    if enter > leave {
        return None;
    }
    let at = |part: f64, end: Place| {
        let along = |axis: usize| {
            // The ends themselves, unchanged, so that consecutive segments meet exactly.
            let value = if part == 0.0 || part == 1.0 {
                end[axis]
            } else {
                from[axis] + (to[axis] - from[axis]) * part
            };
            value.clamp(low[axis], high[axis])
        };
        [along(0), along(1)]
    };
    let cut = [at(enter, from), at(leave, to)];
    cut.iter().flatten().all(|c| c.is_finite()).then_some(cut)
}

/// Two borders over the same places, `[x, one, other]`, cut to a field.
///
/// Where a border or both leave the field a corner is put in, so that every piece in between is
/// wholly inside or lies along an edge.
pub(super) fn cut_band(band: &[[f64; 3]], field: Field) -> Vec<[f64; 3]> {
    let [low, high] = field.corners();
    let limits = [[low[0], high[0]], [low[1], high[1]], [low[1], high[1]]];
    let mut kept: Vec<[f64; 3]> = Vec::with_capacity(band.len());
    for pair in band.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        let mut parts = vec![0.0, 1.0];
        for k in 0..3 {
            let crossings = limits[k].map(|limit| (limit - from[k]) / (to[k] - from[k]));
            parts.extend(
                crossings
                    .into_iter()
                    .filter(|part| 0.0 < *part && *part < 1.0),
            );
        }
        parts.sort_by(f64::total_cmp);
        for part in parts {
            // Weighed, not stepped: the difference of huge numbers would be infinite.
            let mut at = [0, 1, 2].map(|k| from[k] * (1.0 - part) + to[k] * part);
            let rounding = 1e-9 * (high[0] - low[0]);
            if !(low[0] - rounding..=high[0] + rounding).contains(&at[0]) {
                continue;
            }
            for k in 0..3 {
                at[k] = at[k].clamp(limits[k][0], limits[k][1]);
            }
            if at.iter().all(|c| c.is_finite()) && kept.last() != Some(&at) {
                kept.push(at);
            }
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    const FIELD: Field = Field {
        left: 0.0,
        top: 0.0,
        width: 10.0,
        height: 10.0,
    };

    #[test]
    fn lines_are_cut_where_they_leave_the_panel() {
        let cut = cut_segment([[-5.0, 5.0], [15.0, 5.0]], FIELD);
        assert_eq!(cut, Some([[0.0, 5.0], [10.0, 5.0]]));
        assert_eq!(cut_segment([[-5.0, -1.0], [15.0, -1.0]], FIELD), None);
        assert_eq!(
            cut_segment([[-4.0, 5.0], [5.0, -4.0]], FIELD).map(|c| c[0]),
            Some([0.0, 1.0])
        );
        let inside = [[1.0, 2.0], [3.0, 4.0]];
        assert_eq!(cut_segment(inside, FIELD), Some(inside));
    }

    #[test]
    fn areas_keep_their_part_inside_the_panel() {
        // A triangle whose tip is above the panel becomes a trapezium of known area.
        let band = cut_band(
            &[[0.0, 10.0, 10.0], [5.0, -10.0, 10.0], [10.0, 10.0, 10.0]],
            FIELD,
        );
        let area: f64 = band
            .windows(2)
            .map(|w| (w[1][0] - w[0][0]) * (w[0][2] - w[0][1] + w[1][2] - w[1][1]) / 2.0)
            .sum();
        // Bases 10 and 5, height 10; all in short binary fractions, so equality holds.
        assert_eq!(area, 75.0);
        assert!(cut_band(&[[-9.0, 0.0, 5.0], [-1.0, 0.0, 5.0]], FIELD).is_empty());
    }
}
