//! The grid on which a combination of tables is exact.

use crate::languages::with_sign;

use super::{
    error::MeasurementError,
    measurement::{Measurement, letter},
};

/// Points nearer than this are one, nm.
const SAME_NM: f64 = 1e-6;

/// Longest piece of a product or quotient, nm.
pub const PIECE_NM: f64 = 0.25;

/// Most points of a result.
pub const MOST_POINTS: usize = 65_536;

/// The sorted wavelengths of some tables inside their overlap, with its ends.
#[derive(Clone, Debug, PartialEq)]
pub struct Union {
    /// Wavelengths, nm.
    pub nm: Vec<f64>,
}

impl Union {
    /// The union of the grids of measurements; with `pieces` cut to at most [`PIECE_NM`].
    ///
    /// # Errors
    /// [`MeasurementError`] where they share no wavelengths or there are too many points.
    pub fn of(parts: &[&Measurement], pieces: bool) -> Result<Self, MeasurementError> {
        let from = highest(parts.iter().map(|m| m.samples.first_nm()));
        let to = -highest(parts.iter().map(|m| -m.samples.last_nm()));
        if from >= to {
            return Err(apart(parts));
        }
        let inside = parts.iter().flat_map(|m| m.samples.nm());
        let mut nm: Vec<f64> = inside
            .copied()
            .filter(|nm| *nm > from && *nm < to)
            .collect();
        nm.extend([from, to]);
        nm.sort_by(f64::total_cmp);
        // The later of two equal points goes, but for the end itself.
        nm.dedup_by(|later, earlier| *later - *earlier < SAME_NM);
        if let Some(last) = nm.last_mut() {
            *last = to;
        }
        if nm.len() < 2 {
            return Err(apart(parts));
        }
        if pieces {
            nm = cut(&nm)?;
        }
        if nm.len() > MOST_POINTS {
            return Err(too_many(nm.len()));
        }
        Ok(Self { nm })
    }

    /// For each point the sample to its left in a table, and how far it is to the next one, 0-1.
    pub(super) fn places(&self, own_nm: &[f64]) -> Vec<(usize, f64)> {
        let last = own_nm.len() - 2;
        let mut left = 0;
        let place = |at: &f64| {
            while left < last && own_nm[left + 1] <= *at {
                left += 1;
            }
            let share = (at - own_nm[left]) / (own_nm[left + 1] - own_nm[left]);
            // Points that are one with a sample are that sample.
            let snap = SAME_NM / (own_nm[left + 1] - own_nm[left]);
            let share = match share {
                share if share < snap => 0.0,
                share if share > 1.0 - snap => 1.0,
                share => share,
            };
            (left, share)
        };
        self.nm.iter().map(place).collect()
    }
}

fn highest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(f64::NEG_INFINITY, f64::max)
}

fn too_many(points: usize) -> MeasurementError {
    MeasurementError::TooMany {
        points,
        most: MOST_POINTS,
    }
}

/// The same points with each step cut into equal pieces of at most [`PIECE_NM`].
fn cut(nm: &[f64]) -> Result<Vec<f64>, MeasurementError> {
    let pieces = |w: &[f64]| ((w[1] - w[0]) / PIECE_NM - 1e-9).ceil().max(1.0);
    let all: f64 = nm.windows(2).map(pieces).sum();
    if all >= MOST_POINTS as f64 {
        return Err(too_many(all.min(1e15) as usize + 1));
    }
    let mut fine = Vec::with_capacity(all as usize + 1);
    for w in nm.windows(2) {
        let count = pieces(w);
        let steps = (0..count as usize).map(|k| w[0] + (w[1] - w[0]) * k as f64 / count);
        fine.extend(steps);
    }
    fine.extend(nm.last());
    Ok(fine)
}

/// Two tables that share nothing, in words.
fn apart(parts: &[&Measurement]) -> MeasurementError {
    for (first, a) in parts.iter().enumerate() {
        for (second, b) in parts.iter().enumerate() {
            if a.samples.last_nm() <= b.samples.first_nm() && first != second {
                return MeasurementError::Apart(tr!(
                    "{first} ends at {end} nm and {second} begins at {begin} nm: they share no \
                     wavelengths.",
                    first = letter(first),
                    end = with_sign(a.samples.last_nm().to_string()),
                    second = letter(second),
                    begin = with_sign(b.samples.first_nm().to_string())
                ));
            }
        }
    }
    MeasurementError::Apart(said!("They share no wavelengths.").to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{measurements::Quantity, spectrum::Sampled};

    fn table(nm: &[f64]) -> Measurement {
        let values = vec![1.0; nm.len()];
        let samples = Sampled::new(nm.to_vec(), values).expect("rising");
        Measurement::new("table", Quantity::Light, "", samples)
    }

    #[test]
    fn the_union_is_of_both_grids_inside_the_overlap_with_its_ends() {
        let (a, b) = (
            table(&[400.0, 410.0, 420.0]),
            table(&[405.0, 410.0 + 5e-7, 430.0]),
        );
        let union = Union::of(&[&a, &b], false).expect("they overlap");
        assert_eq!(union.nm, [405.0, 410.0, 420.0]);
        // 2 x 10 nm in pieces of a quarter.
        let union = Union::of(&[&a, &b], true).expect("they overlap");
        assert_eq!(union.nm.len(), 61);
        assert!(union.nm.windows(2).all(|w| w[1] - w[0] <= PIECE_NM + 1e-12));
        assert_eq!(union.places(a.samples.nm())[0], (0, 0.5));
        let (left, share) = union.places(b.samples.nm())[60];
        let expected = (20.0 - 10.0 - 5e-7) / (20.0 - 5e-7);
        assert!(left == 1 && (share - expected).abs() < 1e-12, "{share}");
    }

    #[test]
    fn tables_that_share_nothing_or_have_too_many_points_are_refused() {
        let (a, b) = (table(&[400.0, 700.0]), table(&[720.0, 780.0]));
        let why = Union::of(&[&a, &b], false).expect_err("apart").to_string();
        let expected = "A ends at 700 nm and B begins at 720 nm: they share no wavelengths.";
        assert_eq!(why, expected);
        let long = table(&[400.0, 400.0 + PIECE_NM * MOST_POINTS as f64]);
        let why = Union::of(&[&long, &long], true)
            .expect_err("too many")
            .to_string();
        assert_eq!(why, "found 65537 points, expected at most 65536");
    }
}
