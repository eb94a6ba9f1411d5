//! The colours of columns: they depend on the instrument alone and not on the light, and tell by how
//! much it has moved.

use super::{
    profile::Profile,
    smooth::{gaussian, largest},
};

/// Logarithms of ratios of channels, column by column; none where there is too little light.
#[derive(Clone, Debug, PartialEq)]
pub struct Hues {
    /// Columns from one value to the next.
    pub step_px: usize,
    /// Green over blue.
    pub ln_g_b: Vec<Option<f64>>,
    /// Red over green.
    pub ln_r_g: Vec<Option<f64>>,
}

/// By how much a picture has moved against another.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shift {
    /// Columns to the right.
    pub px: f64,
    /// The mean difference of logarithms that is left.
    pub difference: f64,
}

/// A channel counts above this many sigma, and above this share of the brightest.
const LEAST: (f64, f64) = (8.0, 0.006);
/// Farther ratios say too little.
const FARTHEST: f64 = 2.5;
/// A difference counts no more than this.
const MOST_DIFFERENCE: f64 = 0.5;
/// Shifts that are tried: so many quarters of a column to both sides.
const QUARTERS: i32 = 100;
/// Share of a channel's noise left after smoothing.
const CALM: f64 = 0.38;
/// Fewer columns in common say nothing.
const LEAST_COLUMNS: usize = 25;
/// Hues that differ by more at any shift are those of another instrument.
pub const MOST_ALIKE: f64 = 0.25;
/// Another minimum, so many columns away, must be worse by this factor.
const OTHER: (f64, f64) = (3.0, 1.25);

impl Hues {
    /// The hues of a profile; `None` of a grey one.
    pub fn of(profile: &Profile, step_px: usize) -> Option<Self> {
        if profile.is_grey || step_px == 0 {
            return None;
        }
        let calm = profile.channels.each_ref().map(|c| gaussian(c, 2.0));
        let top = calm.iter().map(|c| largest(c)).fold(0.0, f64::max);
        let seen = |k: usize, column: usize| {
            let value = calm[k][column];
            let is_lit = value > LEAST.0 * CALM * profile.sigma[k] && value > LEAST.1 * top;
            (is_lit && !profile.clipped[column]).then_some(value)
        };
        let ratio = |over: usize, under: usize| {
            let columns = (0..profile.columns()).step_by(step_px);
            columns
                .map(|c| {
                    Some((seen(over, c)? / seen(under, c)?).ln()).filter(|l| l.abs() < FARTHEST)
                })
                .collect()
        };
        Some(Self {
            step_px,
            ln_g_b: ratio(1, 2),
            ln_r_g: ratio(0, 1),
        })
    }

    /// By how much another picture of the instrument lies to the right of this one; `None` where
    /// they have too little in common, or fit in several ways.
    pub fn shift(&self, other: &Self) -> Option<Shift> {
        let tried: Vec<(f64, Option<f64>)> = (-QUARTERS..=QUARTERS)
            .map(|i| f64::from(i) / 4.0)
            .map(|px| (px, self.difference(other, px)))
            .collect();
        let known: Vec<(f64, f64)> = tried
            .iter()
            .filter_map(|(px, d)| Some((*px, (*d)?)))
            .collect();
        let best = known.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
        // A minimum at the end may lie beyond it.
        if best.0.abs() >= f64::from(QUARTERS) / 4.0 && best.1 <= MOST_ALIKE {
            return None;
        }
        let is_minimum = |i: usize| {
            i > 0
                && i + 1 < known.len()
                && known[i].1 <= known[i - 1].1
                && known[i].1 <= known[i + 1].1
        };
        let others = (0..known.len())
            .filter(|i| is_minimum(*i))
            .map(|i| known[i]);
        let rival = others
            .filter(|(px, _)| (px - best.0).abs() > OTHER.0)
            .map(|(_, d)| d)
            .fold(f64::MAX, f64::min);
        let is_told = rival > OTHER.1 * best.1 || best.1 > MOST_ALIKE;
        is_told.then_some(Shift {
            px: best.0,
            difference: best.1,
        })
    }

    /// The mean difference where the other lies so far to the right.
    fn difference(&self, other: &Self, px: f64) -> Option<f64> {
        let (mut sum, mut count) = (0.0, 0_usize);
        for (mine, theirs) in [(&self.ln_g_b, &other.ln_g_b), (&self.ln_r_g, &other.ln_r_g)] {
            for (i, theirs) in theirs.iter().enumerate() {
                let at = ((i * other.step_px) as f64 - px) / self.step_px as f64;
                if let (Some(theirs), Some(mine)) = (theirs, between(mine, at)) {
                    sum += (theirs - mine).abs().min(MOST_DIFFERENCE);
                    count += 1;
                }
            }
        }
        (count * other.step_px >= LEAST_COLUMNS).then(|| sum / count as f64)
    }
}

/// A value between two of a list, where both are known.
fn between(values: &[Option<f64>], at: f64) -> Option<f64> {
    if at < 0.0 {
        return None;
    }
    let left = at as usize;
    let part = at - left as f64;
    let low = (*values.get(left)?)?;
    if part < 1e-9 {
        return Some(low);
    }
    let high = (*values.get(left + 1)?)?;
    Some(low + (high - low) * part)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A camera of three Gaussians, moved by some columns, before a light.
    fn profile(moved: f64, light: impl Fn(f64) -> f64) -> Profile {
        let channel = |centre: f64, width: f64| -> Vec<f64> {
            (0..400)
                .map(|i| f64::from(i) - moved)
                .map(|at| light(at) * (-0.5 * ((at - centre) / width).powi(2)).exp())
                .collect()
        };
        Profile {
            channels: [
                channel(290.0, 40.0),
                channel(200.0, 45.0),
                channel(110.0, 38.0),
            ],
            sigma: [1e-5; 3],
            clipped: vec![false; 400],
            is_grey: false,
            black_seen: true,
            rows: 40,
        }
    }

    #[test]
    fn a_shift_is_found_under_another_light() {
        let bulb = profile(0.0, |at| 0.2 + at / 400.0);
        let sky = profile(6.5, |at| 1.0 - at / 800.0);
        let (bulb, sky) = (
            Hues::of(&bulb, 2).expect("hues"),
            Hues::of(&sky, 1).expect("hues"),
        );
        let shift = bulb.shift(&sky).expect("a shift");
        assert!((shift.px - 6.5).abs() <= 0.25, "{shift:?}");
        assert!(shift.difference < 0.05, "{shift:?}");
    }

    #[test]
    fn grey_pictures_and_dark_ones_tell_nothing() {
        let grey = Profile {
            is_grey: true,
            ..profile(0.0, |_| 1.0)
        };
        assert_eq!(Hues::of(&grey, 2), None);
        let dark = Hues::of(&profile(0.0, |_| 1e-6), 2).expect("no grey");
        let bright = Hues::of(&profile(0.0, |_| 1.0), 2).expect("hues");
        assert_eq!(bright.shift(&dark), None);
    }
}
