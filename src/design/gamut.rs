//! The colours that mixtures of channels can have.

/// The mixture nearest to a chromaticity.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct NearestMix {
    /// CIE 1976 u'v' of the mixture.
    pub(super) uv: [f64; 2],
    /// Distance to what was asked for.
    pub(super) distance: f64,
    /// Weights of the channels, at most two of them not zero.
    pub(super) weights: Vec<f64>,
}

/// A place on the edge between two channels, and their weights.
struct OnEdge {
    distance: f64,
    uv: [f64; 2],
    weights: [(usize, f64); 2],
}

/// CIE 1976 u'v' of `[X, Y, Z]` and the sum `X + 15 Y + 3 Z` that it is weighed by in mixtures.
fn uv_and_sum([x, y, z]: [f64; 3]) -> Option<([f64; 2], f64)> {
    let sum = x + 15.0 * y + 3.0 * z;
    let uv = [4.0 * x / sum, 9.0 * y / sum];
    (sum > 0.0 && uv.iter().all(|v| v.is_finite())).then_some((uv, sum))
}

/// The mixture of channels (XYZ of each at weight one) nearest in u'v' to a chromaticity outside
/// their gamut, of the same Y as `y`; `None` where no channel has a colour.
///
/// The nearest point lies on an edge of the gamut, which joins two channels: all pairs are tried,
/// so no hull is needed and ties go to the first.
pub(super) fn nearest_mix(channels: &[[f64; 3]], asked: [f64; 2], y: f64) -> Option<NearestMix> {
    let points: Vec<(usize, [f64; 2], f64)> = channels
        .iter()
        .enumerate()
        .filter_map(|(i, xyz)| uv_and_sum(*xyz).map(|(uv, sum)| (i, uv, sum)))
        .collect();
    let mut best: Option<OnEdge> = None;
    for (first, (i, from, sum_i)) in points.iter().enumerate() {
        for (j, to, sum_j) in &points[first..] {
            let along = [to[0] - from[0], to[1] - from[1]];
            let length = along[0] * along[0] + along[1] * along[1];
            let offset = [asked[0] - from[0], asked[1] - from[1]];
            let share = (offset[0] * along[0] + offset[1] * along[1]) / length;
            let share = if share.is_finite() {
                share.clamp(0.0, 1.0)
            } else {
                0.0
            };
            let uv = [from[0] + share * along[0], from[1] + share * along[1]];
            let distance = (asked[0] - uv[0]).hypot(asked[1] - uv[1]);
            if best.as_ref().is_none_or(|best| distance < best.distance) {
                let weights = [(*i, (1.0 - share) / sum_i), (*j, share / sum_j)];
                best = Some(OnEdge {
                    distance,
                    uv,
                    weights,
                });
            }
        }
    }
    let best = best?;
    let mut weights = vec![0.0; channels.len()];
    best.weights.iter().for_each(|(i, w)| weights[*i] += w);
    let luminance: f64 = weights.iter().zip(channels).map(|(w, c)| w * c[1]).sum();
    let scale = y / luminance;
    if scale.is_finite() && scale > 0.0 {
        weights.iter_mut().for_each(|w| *w *= scale);
    }
    Some(NearestMix {
        uv: best.uv,
        distance: best.distance,
        weights,
    })
}

/// The corners of what mixtures of channels can show in CIE 1976 u'v', against the clock from the
/// least u'; one or two points where the channels do not span an area (Andrew's chain, 1979).
pub(super) fn reach(channels: &[[f64; 3]]) -> Vec<[f64; 2]> {
    let found = channels.iter().filter_map(|xyz| uv_and_sum(*xyz));
    let mut points: Vec<[f64; 2]> = found.map(|(uv, _)| uv).collect();
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let turns_left = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0
    };
    let half = |points: &mut dyn Iterator<Item = [f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..]
                && !turns_left(a, b, point)
            {
                chain.pop();
            }
            chain.push(point);
        }
        // The last point begins the other half.
        chain.pop();
        chain
    };
    let mut corners = half(&mut points.iter().copied());
    corners.extend(half(&mut points.iter().rev().copied()));
    corners
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_reach_has_every_channel_inside_or_at_its_corners() {
        let channels = [
            [0.2, 1.0, 0.1],
            [1.0, 0.5, 0.05],
            [0.3, 0.1, 1.5],
            [0.5, 0.5, 0.5],
        ];
        let corners = reach(&channels);
        assert_eq!(corners.len(), 3, "white lies inside");
        for xyz in channels {
            let (point, _) = uv_and_sum(xyz).unwrap();
            for (i, a) in corners.iter().enumerate() {
                let b = corners[(i + 1) % corners.len()];
                let area = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
                // Corners lie on two edges, to rounding.
                assert!(area > -1e-15);
            }
        }
        assert_eq!(reach(&channels[..2]).len(), 2);
        assert!(reach(&[]).is_empty());
    }

    #[test]
    fn the_nearest_mixture_has_the_chromaticity_it_claims_and_is_square_to_the_edge() {
        let channels = [[0.2, 1.0, 0.1], [1.0, 0.5, 0.05], [0.3, 0.1, 1.5]];
        let asked = [0.1, 0.7];
        let found = nearest_mix(&channels, asked, 30.0).unwrap();
        let mut xyz = [0.0; 3];
        for (w, c) in found.weights.iter().zip(&channels) {
            (0..3).for_each(|k| xyz[k] += w * c[k]);
        }
        let (uv, _) = uv_and_sum(xyz).unwrap();
        // A handful of operations on numbers below a hundred.
        assert!((uv[0] - found.uv[0]).hypot(uv[1] - found.uv[1]) < 1e-14);
        assert!((xyz[1] - 30.0).abs() < 1e-12);
        // No other mixture of a fine net comes nearer.
        for a in 0..=40 {
            for b in 0..=40 - a {
                let w = [f64::from(a), f64::from(b), f64::from(40 - a - b)];
                let mix: [f64; 3] =
                    std::array::from_fn(|k| (0..3).map(|i| w[i] * channels[i][k]).sum());
                let (uv, _) = uv_and_sum(mix).unwrap();
                let distance = (uv[0] - asked[0]).hypot(uv[1] - asked[1]);
                assert!(distance >= found.distance - 1e-12);
            }
        }
    }

    #[test]
    fn channels_without_colour_have_no_nearest_mixture() {
        assert_eq!(nearest_mix(&[[0.0; 3]], [0.3, 0.3], 1.0), None);
        assert_eq!(nearest_mix(&[], [0.3, 0.3], 1.0), None);
    }
}
