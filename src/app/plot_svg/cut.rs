//! Lines and areas cut to their panel.

/// A place in a panel, px from its top left corner.
pub type Place = [f64; 2];

/// The part of a segment inside the box from the origin to `size` (Liang and Barsky's method).
pub fn cut_segment(ends: [Place; 2], size: [f64; 2]) -> Option<[Place; 2]> {
    let [from, to] = ends;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let step = to[axis] - from[axis];
        let (to_low, to_high) = (-from[axis], size[axis] - from[axis]);
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
            value.clamp(0.0, size[axis])
        };
        [along(0), along(1)]
    };
    let cut = [at(enter, from), at(leave, to)];
    cut.iter().flatten().all(|c| c.is_finite()).then_some(cut)
}

/// The part of a closed ring inside the box from the origin to `size` (Sutherland and Hodgman).
pub(super) fn cut_ring(ring: &[Place], size: [f64; 2]) -> Vec<Place> {
    let mut ring = ring.to_vec();
    for axis in 0..2 {
        for (limit, sign) in [(0.0, 1.0), (size[axis], -1.0)] {
            // How far inside this side of the box, negative outside.
            let depth = |place: Place| (place[axis] - limit) * sign;
            let mut kept = Vec::with_capacity(ring.len() + 4);
            for (i, &to) in ring.iter().enumerate() {
                let from = ring[(i + ring.len() - 1) % ring.len()];
                let (a, b) = (depth(from), depth(to));
                if (a < 0.0) != (b < 0.0) {
                    let part = a / (a - b);
                    let mut crossing = [0, 1].map(|k| from[k] + (to[k] - from[k]) * part);
                    crossing[axis] = limit;
                    if crossing.iter().all(|c| c.is_finite()) {
                        kept.push(crossing);
                    }
                }
                if b >= 0.0 {
                    kept.push(to);
                }
            }
            ring = kept;
        }
    }
    ring
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_where_they_leave_the_panel() {
        let size = [10.0, 10.0];
        let cut = cut_segment([[-5.0, 5.0], [15.0, 5.0]], size);
        assert_eq!(cut, Some([[0.0, 5.0], [10.0, 5.0]]));
        assert_eq!(cut_segment([[-5.0, -1.0], [15.0, -1.0]], size), None);
        assert_eq!(
            cut_segment([[-4.0, 5.0], [5.0, -4.0]], size).map(|c| c[0]),
            Some([0.0, 1.0])
        );
        let inside = [[1.0, 2.0], [3.0, 4.0]];
        assert_eq!(cut_segment(inside, size), Some(inside));
    }

    #[test]
    fn areas_keep_their_part_inside_the_panel() {
        // A triangle whose tip is above the panel becomes a trapezium of known area.
        let ring = cut_ring(&[[0.0, 10.0], [5.0, -10.0], [10.0, 10.0]], [10.0, 10.0]);
        let next = |i: usize| ring[(i + 1) % ring.len()];
        let doubled: f64 = (0..ring.len())
            .map(|i| ring[i][0] * next(i)[1] - next(i)[0] * ring[i][1])
            .sum();
        // Bases 10 and 5, height 10; all in short binary fractions, so equality holds.
        assert_eq!(doubled.abs() / 2.0, 75.0);
    }
}
