//! An instrument's axis against lines whose places are known: an atom's own, or daylight's dark ones.

use super::{
    kernel::{Kernel, Slit},
    measurement::Measurement,
    slit_width::{SlitFound, slit_of},
};
use crate::spectrum::Outside;

/// Dark lines of daylight: place, and the window whose chord they hang below, nm. The places are
/// centroids of the depth in the standard sun (ASTM G173), which hardly change with the slit.
const DARK: [(f64, [f64; 2]); 3] = [
    (430.3, [424.0, 437.0]),
    (517.3, [511.0, 523.0]),
    (762.9, [748.0, 776.0]),
];
/// Greatest error of an axis that is looked for, nm.
const MOST_OFF_NM: f64 = 5.0;
/// Share of the depth that stays when the window is halved: a dip's, not a bent curve's (a
/// parabola keeps a quarter).
const NARROW: f64 = 0.45;
/// Least depth, a share of the chord.
const LEAST_DEPTH: f64 = 0.01;
/// Least depth of oxygen's band in daylight, a share of the chord: a slit of 10 nm leaves a quarter.
const LEAST_OXYGEN: f64 = 0.1;
/// Most that features may differ from their straight line, nm.
const AGREE_NM: f64 = 1.0;

/// What an axis is off by: a straight line in the wavelength.
#[derive(Clone, Debug, PartialEq)]
pub struct AxisFound {
    /// So much too high at 550 nm, nm.
    pub at_550_nm: f64,
    /// Change of that a nm.
    pub slope: f64,
    /// The features: true place and what is read too high there, nm.
    pub features: Vec<(f64, f64)>,
}

impl AxisFound {
    /// A place as it is read, put right.
    pub fn corrected(&self, nm: f64) -> f64 {
        nm - self.at_550_nm - self.slope * (nm - 550.0)
    }

    /// A straight line through what features tell; a common shift where they are near each other.
    fn through(features: Vec<(f64, f64)>) -> Option<Self> {
        if features.len() < 2 {
            return None;
        }
        let n = features.len() as f64;
        let mean = |of: &dyn Fn(&(f64, f64)) -> f64| features.iter().map(of).sum::<f64>() / n;
        let (x, y) = (mean(&|f| f.0), mean(&|f| f.1));
        let across: f64 = features.iter().map(|f| (f.0 - x).powi(2)).sum();
        let along: f64 = features.iter().map(|f| (f.0 - x) * (f.1 - y)).sum();
        let slope = if across > 1000.0 { along / across } else { 0.0 };
        let at = |nm: f64| y + slope * (nm - x);
        let agree = features.iter().all(|f| (f.1 - at(f.0)).abs() <= AGREE_NM);
        agree.then(|| Self {
            at_550_nm: at(550.0),
            slope,
            features: features.clone(),
        })
    }
}

/// What an axis is off by, by an atom's lines, else by daylight's dark ones; `None` where fewer than
/// two features agree.
pub fn axis_of(of: &Measurement) -> Option<AxisFound> {
    if let Ok(slit) = slit_of(of, Kernel::Gauss) {
        let lines = slit.lines.iter();
        return AxisFound::through(lines.map(|line| (line.nm, line.shift_nm)).collect());
    }
    let dark = DARK
        .iter()
        .filter_map(|(place, window)| dip(of, *place, *window));
    AxisFound::through(dark.collect())
}

/// A dark line: its place, and what it is read too high. The window follows the line once, so that
/// an axis that is off does not cut it.
fn dip(of: &Measurement, place: f64, window: [f64; 2]) -> Option<(f64, f64)> {
    let mut off = 0.0;
    for _ in 0..4 {
        let moved = window.map(|nm| nm + off);
        let (depth, centroid) = below_chord(of, moved)?;
        let middle = 0.5 * (moved[0] + moved[1]);
        let half = 0.25 * (moved[1] - moved[0]);
        let (inner, _) = below_chord(of, [middle - half, middle + half])?;
        let next = centroid - place;
        if depth < LEAST_DEPTH || next.abs() > MOST_OFF_NM {
            return None;
        }
        if (next - off).abs() < 0.01 || inner < NARROW * depth {
            off = next;
            return (inner >= NARROW * depth).then_some((place, off));
        }
        off = next;
    }
    Some((place, off))
}

/// Oxygen's band in daylight as slits of a width show it: width at half its depth, and the slit's, nm;
/// Gaussians over the standard sun (ASTM G173).
const OXYGEN: [(f64, f64); 5] = [(6.1, 1.5), (6.8, 3.0), (7.7, 5.0), (9.0, 7.0), (11.3, 10.0)];

/// The slit that daylight was seen through, by the width of oxygen's band at 763 nm: about so wide.
/// `None` for lights that do not have it. Wide slits leave no other dark line of the sun to see.
pub fn slit_of_daylight(of: &Measurement) -> Option<SlitFound> {
    let (place, window) = DARK[2];
    let (_, off) = dip(of, place, window)?;
    let [from, to] = window.map(|nm| nm + off);
    if below_chord(of, [from, to])?.0 < LEAST_OXYGEN {
        return None;
    }
    let at = |nm: f64| of.samples.at(nm, Outside::Hold);
    let (left, right) = (at(from), at(to));
    let points = 280;
    let depth = |i: i32| {
        let share = f64::from(i) / f64::from(points);
        let chord = left * (1.0 - share) + right * share;
        (chord - at(from + (to - from) * share)) / chord
    };
    let deepest = (0..=points).max_by(|a, b| depth(*a).total_cmp(&depth(*b)))?;
    let half = 0.5 * depth(deepest);
    let is_deep = |i: &i32| depth(*i) > half;
    let first = (0..deepest).rev().take_while(is_deep).last()?;
    let last = (deepest..points).take_while(is_deep).last()?;
    let seen = (to - from) * f64::from(last - first) / f64::from(points);
    let above = OXYGEN.iter().position(|(width, _)| *width >= seen)?;
    let fwhm_nm = match above {
        0 => OXYGEN[0].1,
        k => {
            let ((a, from), (b, to)) = (OXYGEN[k - 1], OXYGEN[k]);
            from + (to - from) * (seen - a) / (b - a)
        }
    };
    Some(SlitFound {
        slit: Slit {
            shape: Kernel::Gauss,
            fwhm_nm,
        },
        u: 0.0,
        shift_nm: off,
        lines: Vec::new(),
        is_sure: false,
    })
}

/// Greatest depth below the chord of a window, as a share of the chord, and the centroid of what is
/// below it.
fn below_chord(of: &Measurement, [from, to]: [f64; 2]) -> Option<(f64, f64)> {
    let samples = &of.samples;
    if from < samples.first_nm() || to > samples.last_nm() {
        return None;
    }
    let at = |nm: f64| samples.at(nm, Outside::Hold);
    let (left, right) = (at(from), at(to));
    let points = 200;
    let (mut area, mut moment, mut deepest) = (0.0, 0.0, 0.0_f64);
    for i in 0..=points {
        let share = f64::from(i) / f64::from(points);
        let nm = from + (to - from) * share;
        let chord = left * (1.0 - share) + right * share;
        let below = (chord - at(nm)).max(0.0);
        area += below;
        moment += below * nm;
        if chord > 0.0 {
            deepest = deepest.max(below / chord);
        }
    }
    (area > 0.0).then_some((deepest, moment / area))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        measurements::{Quantity, smoothed},
        preset,
    };

    #[test]
    fn oxygen_tells_the_slit_of_daylight_to_a_nm_and_of_a_bulb_nothing() {
        let of = |group: &str, name: &str| {
            let table = preset::table(group, name).expect("a shipped light");
            Measurement::new(name, Quantity::Light, "", table.clone())
        };
        let sun = of("solar_astm_g173", "ASTM G173-03 global tilt AM1.5G");
        for fwhm_nm in [3.0, 5.0, 7.0, 10.0] {
            let slit = Slit {
                shape: Kernel::Gauss,
                fwhm_nm,
            };
            let seen = smoothed(&sun, slit).expect("a slit");
            let found = slit_of_daylight(&seen).expect("oxygen").slit.fwhm_nm;
            assert!((found - fwhm_nm).abs() < 1.0, "{fwhm_nm}: {found}");
        }
        assert_eq!(slit_of_daylight(&of("cie_illuminants", "CIE A")), None);
    }
}
