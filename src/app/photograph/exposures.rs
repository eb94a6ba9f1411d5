//! Several exposures of one light: how the camera's values go with the light, and columns that are
//! over-exposed in one picture taken from a darker one.

use std::path::PathBuf;

use super::{
    Photograph,
    along::{Along, of_strip},
};
use crate::{languages::fixed, photographs::Profile};

/// A picture that was exposed for some time.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposure {
    pub path: PathBuf,
    pub seconds: f64,
}

/// Several exposures as they were used.
#[derive(Clone, Debug, PartialEq)]
pub struct Exposed {
    /// Values go with the light to this power; 1 where they are proportional to it.
    pub light_power: f64,
    /// Columns that are from another picture, and by how much their noise is larger.
    pub joined: Vec<(usize, f64)>,
    /// Bright and dark columns differ by other factors.
    pub is_uneven: bool,
}

/// A column counts above this share of the brightest, and above this many sigma.
const LEAST: (f64, f64) = (0.05, 8.0);
/// Fewer columns tell nothing.
const LEAST_COLUMNS: usize = 20;
/// A power nearer to 1 is 1.
const STRAIGHT: f64 = 0.02;
/// Powers beyond these are those of another light or another time.
const POWERS: (f64, f64) = (0.4, 2.5);
/// Times that differ by less than this factor tell no power.
const LEAST_FACTOR: f64 = 1.2;
/// Share by which powers of bright and dark columns may differ.
const UNEVEN: f64 = 0.1;

/// The middle of a list that is not empty.
fn middle(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Powers of the light that the values of two exposures go with, column by column, with their
/// brightness.
fn powers(longer: &Profile, shorter: &Profile, factor: f64) -> Vec<(f64, f64)> {
    let mut powers = Vec::new();
    for k in 0..3 {
        let top = |p: &Profile| p.channels[k].iter().copied().fold(0.0, f64::max);
        let tops = [top(longer), top(shorter)];
        for column in 0..longer.columns().min(shorter.columns()) {
            let both = [longer, shorter].map(|p| p.channels[k][column]);
            let is_seen = |i: usize, p: &Profile| {
                both[i] > LEAST.0 * tops[i] && both[i] > LEAST.1 * p.sigma[k] && !p.clipped[column]
            };
            if is_seen(0, longer) && is_seen(1, shorter) {
                powers.push((both[1], (both[0] / both[1]).ln() / factor.ln()));
            }
        }
    }
    powers
}

/// The power of the light, of the two exposures that are farthest apart and still share columns,
/// and whether dark columns have another one than bright ones.
fn power_of(sorted: &[(f64, Profile)]) -> Option<(f64, bool)> {
    let pairs = (0..sorted.len()).flat_map(|i| (i + 1..sorted.len()).map(move |j| (i, j)));
    let mut all = Vec::new();
    for (i, j) in pairs {
        let factor = sorted[j].0 / sorted[i].0;
        if factor >= LEAST_FACTOR {
            all.extend(powers(&sorted[j].1, &sorted[i].1, factor));
        }
    }
    if all.len() < LEAST_COLUMNS {
        return None;
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let third = all.len() / 3;
    let of = |part: &[(f64, f64)]| middle(part.iter().map(|p| p.1).collect());
    let (dark, bright) = (
        of(&all[..third.max(1)]),
        of(&all[all.len() - third.max(1)..]),
    );
    let power = of(&all);
    Some((power, (bright - dark).abs() > UNEVEN * power))
}

/// The exposures along a strip, the shortest first.
fn profiles(exposures: &[Exposure], along: Along<'_>) -> Result<Vec<(f64, Profile)>, String> {
    let mut profiles = Vec::new();
    for exposure in exposures {
        let name = crate::io::shown(&exposure.path);
        let (found, _) =
            of_strip(&exposure.path, along, &[]).map_err(|why| format!("{name}: {why}"))?;
        profiles.push((exposure.seconds, found.profile));
    }
    profiles.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(profiles)
}

impl Exposed {
    /// The power of the light along a strip of several exposures.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub(super) fn power(
        exposures: &[Exposure],
        mut along: Along<'_>,
    ) -> Result<(f64, bool), String> {
        let mut power = 1.0;
        let mut is_uneven = false;
        // Black is taken off values that are bent: once they are straight, the power is another.
        for _ in 0..4 {
            along.tones.light_power = power;
            let profiles = profiles(exposures, along)?;
            let (left, uneven) = power_of(&profiles).ok_or(said!(
                "found exposures with too few columns in common, or too near to each other, \
                 expected two of one light whose times differ by a fifth and more"
            ))?;
            power *= left;
            is_uneven = uneven;
            if !(POWERS.0..=POWERS.1).contains(&power) {
                return Err(tr!(
                    "found values that go with the light to the power {power}, expected about 1: \
                     are these exposures of one light, and their times right?",
                    power = fixed(power, 2)
                ));
            }
        }
        let is_straight = (power - 1.0).abs() <= STRAIGHT;
        Ok((if is_straight { 1.0 } else { power }, is_uneven))
    }
}

/// Columns of a picture that are over-exposed, taken from a darker exposure; the columns, and by how
/// much their noise is larger.
///
/// # Errors
/// What was found and what was expected.
pub(super) fn joined(
    profile: &mut Profile,
    own_seconds: f64,
    exposures: &[Exposure],
    along: Along<'_>,
) -> Result<Vec<(usize, f64)>, String> {
    let profiles = profiles(exposures, along)?;
    let mut joined = Vec::new();
    for column in 0..profile.columns() {
        if !profile.clipped[column] {
            continue;
        }
        let darker = profiles.iter().rev().find(|(seconds, other)| {
            *seconds < own_seconds && other.columns() > column && !other.clipped[column]
        });
        if let Some((seconds, other)) = darker {
            let factor = own_seconds / seconds;
            for k in 0..3 {
                profile.channels[k][column] = factor * other.channels[k][column];
            }
            profile.clipped[column] = false;
            joined.push((column, factor * other.sum_sigma() / profile.sum_sigma()));
        }
    }
    Ok(joined)
}

impl Photograph {
    /// By how much the noise of a column is larger than the picture's own.
    pub(super) fn noise_factor(&self, column: usize) -> f64 {
        let joined = self.exposed.iter().flat_map(|e| &e.joined);
        let mut of_column = joined.filter(|(at, _)| *at == column);
        of_column.next().map_or(1.0, |(_, factor)| factor.max(1.0))
    }
}
