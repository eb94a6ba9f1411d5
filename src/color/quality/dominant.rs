//! Dominant and complementary wavelength, and excitation purity.
//!
//! From the equal-energy white E through the light's colour to the border of the CIE 1931 diagram:
//! the locus of whole nm 360-830 as a polyline, or the purple line between its ends. Where the ray
//! meets the purple line, the complementary wavelength (on the other side of E) is given negative.

use std::sync::LazyLock;

use crate::color::{Observer, Xyz, xy_from_xyz};

use super::{light::FIRST_NM, no_figure::NoFigure};

/// The white, E.
const WHITE: [f64; 2] = [1.0 / 3.0, 1.0 / 3.0];

/// Nearer to the white than this there is no hue: whole nm sums of the tables themselves are off
/// by some 1e-4.
const NEAREST: f64 = 3e-4;

/// Below this wavelength the locus hardly moves, nm.
const VIOLET_END_NM: f64 = 400.0;

/// Above this wavelength the locus hardly moves, nm.
const RED_END_NM: f64 = 690.0;

/// Rounding tolerance for a ray that meets a segment beyond its ends, as a share of the segment.
const SLACK: f64 = 1e-9;

/// The hue of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Dominant {
    /// Dominant wavelength, nm; complementary ones negative. An end of the locus is said in words.
    pub nm: Result<f64, NoFigure>,
    /// Excitation purity: 0 at the white, 1 at the border. More than 1 only by negative samples.
    pub purity: f64,
    /// Intersection of the ray with the border, xy.
    pub border_xy: [f64; 2],
}

/// Hue and purity of a chromaticity (CIE 1931).
///
/// # Errors
/// [`NoFigure::NearWhite`] within 3e-4 of E; [`NoFigure::OutOfRange`] where no ray meets the border.
pub(crate) fn dominant(xy: [f64; 2]) -> Result<Dominant, NoFigure> {
    let away = [xy[0] - WHITE[0], xy[1] - WHITE[1]];
    let distance = away[0].hypot(away[1]);
    if distance.is_nan() || distance < NEAREST {
        return Err(NoFigure::NearWhite { distance });
    }
    let no_border = || NoFigure::OutOfRange {
        what: later!("the ray from the white does not meet the locus"),
    };
    if let Some((nm, reach)) = on_locus(away) {
        let nm = if nm < VIOLET_END_NM {
            Err(NoFigure::VioletEnd)
        } else if nm > RED_END_NM {
            Err(NoFigure::RedEnd)
        } else {
            Ok(nm)
        };
        return Ok(of_reach(nm, reach, away));
    }
    let locus = &*LOCUS;
    let purple = meets(away, locus[locus.len() - 1], locus[0]);
    let (_, reach) = purple.ok_or_else(no_border)?;
    let (nm, _) = on_locus(away.map(|v| -v)).ok_or_else(no_border)?;
    Ok(of_reach(Ok(-nm), reach, away))
}

/// `reach` is how many times the colour's distance from the white the border is away.
fn of_reach(nm: Result<f64, NoFigure>, reach: f64, away: [f64; 2]) -> Dominant {
    Dominant {
        nm,
        purity: 1.0 / reach,
        border_xy: std::array::from_fn(|k| WHITE[k] + reach * away[k]),
    }
}

/// Wavelength and reach of the outermost point of the locus in a direction.
fn on_locus(away: [f64; 2]) -> Option<(f64, f64)> {
    let segments = LOCUS.windows(2).zip(FIRST_NM..);
    let hits = segments.filter_map(|(pair, nm)| {
        let (along, reach) = meets(away, pair[0], pair[1])?;
        Some((f64::from(nm) + along, reach))
    });
    hits.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Intersects the ray from the white with a segment: share of the segment and reach of the ray.
fn meets(away: [f64; 2], from: [f64; 2], to: [f64; 2]) -> Option<(f64, f64)> {
    let [px, py] = [from[0] - WHITE[0], from[1] - WHITE[1]];
    let [qx, qy] = [to[0] - from[0], to[1] - from[1]];
    let cross = away[0] * qy - away[1] * qx;
    let along = (away[1] * px - away[0] * py) / cross;
    let reach = (px * qy - py * qx) / cross;
    let is_met = (-SLACK..=1.0 + SLACK).contains(&along) && reach > 0.0 && reach.is_finite();
    is_met.then_some((along.clamp(0.0, 1.0), reach))
}

/// The CIE 1931 locus on whole nm 360-830.
static LOCUS: LazyLock<Vec<[f64; 2]>> = LazyLock::new(|| {
    let [x, y, z] = &Observer::CIE_1931.table().xyz;
    let points = x.iter().zip(y).zip(z);
    points
        .map(|((x, y), z)| xy_from_xyz(Xyz::new(*x, *y, *z)).expect("a line has a colour"))
        .collect()
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn halfway_to_a_wavelength_is_that_wavelength_at_half_purity() {
        for nm in [410_u32, 460, 500, 530, 580, 640, 680] {
            let locus = LOCUS[(nm - FIRST_NM) as usize];
            let half = [0, 1].map(|k| 0.5 * (WHITE[k] + locus[k]));
            let found = dominant(half).unwrap();
            // Intersections of lines that meet under no small angle; at the red end the locus is
            // slow: 1e-16 in xy is 1e-11 nm there.
            assert!((found.nm.unwrap() - f64::from(nm)).abs() < 1e-9);
            assert!((found.purity - 0.5).abs() < 1e-12);
        }
    }

    #[test]
    fn purple_has_the_complement_of_green_and_white_has_no_hue() {
        let found = dominant([0.35, 0.15]).unwrap();
        let nm = found.nm.unwrap();
        assert!((-567.0..-493.0).contains(&nm), "{nm}");
        assert!((0.0..1.0).contains(&found.purity));
        assert!(matches!(
            dominant([0.3334, 0.3332]),
            Err(NoFigure::NearWhite { .. })
        ));
        assert!(dominant([f64::NAN, 0.3]).is_err());
    }
}
