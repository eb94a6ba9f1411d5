//! Scans that do not belong to the others, and drift. They are proposed, never dropped.

use crate::languages::signed;

use super::{
    measurement::Measurement,
    repeats::{RepeatsError, Scans, running, slope},
    statistics::two_sided_p,
};

/// A level is another where it is so many median deviations away, and at least that share.
const LEVEL: [f64; 2] = [8.0, 0.04];
/// The same for the shift, at least so many nm.
const SHIFT: [f64; 2] = [8.0, 0.4];
/// Residuals are others where they are so many times the median.
const RESIDUAL: f64 = 3.0;
/// The mean of three samples is another from so many times the median on, at least so many sigmas.
const THREE: [f64; 2] = [3.5, 6.0];
/// The median of the square of a normal number.
const MEDIAN_SQUARE: f64 = 0.454_936;
/// Probability below which a drift is one.
const DRIFT_P: f64 = 0.01;

/// A scan that does not belong to the others.
#[derive(Clone, Debug, PartialEq)]
pub struct Misfit {
    /// Which, from 0.
    pub scan: usize,
    /// Why, in words.
    pub why: String,
}

/// A level that rises or falls from scan to scan.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// Change of the level a scan, a share of it.
    pub per_scan: f64,
    /// Probability of as much by chance.
    pub p: f64,
}

impl Drift {
    /// True if chance is an unlikely cause.
    pub fn is_there(self) -> bool {
        self.p < DRIFT_P
    }
}

/// Median of some numbers; 0 of none.
fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        n if n % 2 == 1 => values[n / 2],
        n => 0.5 * (values[n / 2 - 1] + values[n / 2]),
    }
}

/// Residual of a scan against the median scan, with its level and shift.
struct Against {
    level: f64,
    shift_nm: f64,
    left: Vec<f64>,
}

/// The scans that do not belong to the others; none where more than half of the others would go,
/// which the second value says.
///
/// # Errors
/// [`RepeatsError`] for fewer than three, or for scans of different things.
pub fn misfits(scans: &[Measurement]) -> Result<(Vec<Misfit>, bool), RepeatsError> {
    let n = scans.len();
    if n < 3 {
        return Err(RepeatsError::TooFew { scans: n });
    }
    let on_grid = Scans::of(scans)?;
    let points = on_grid.nm.len();
    let middle: Vec<f64> = (0..points)
        .map(|i| median(on_grid.values.iter().map(|v| v[i])))
        .collect();
    let all: Vec<Against> = on_grid
        .values
        .iter()
        .map(|v| against(&on_grid.nm, &middle, v))
        .collect();
    let squares = |i: usize| median(all.iter().map(|a| a.left[i] * a.left[i])) / MEDIAN_SQUARE;
    let sigma: Vec<f64> = running(&(0..points).map(squares).collect::<Vec<_>>());
    let sigma: Vec<f64> = sigma.into_iter().map(f64::sqrt).collect();
    let rms = |a: &Against| (a.left.iter().map(|e| e * e).sum::<f64>() / points as f64).sqrt();
    let highest = |a: &Against| {
        let threes = a.left.windows(3).zip(sigma[1..].iter());
        let sizes = threes.map(|(w, s)| {
            if *s > 0.0 {
                w.iter().sum::<f64>().abs() / (3.0_f64.sqrt() * s)
            } else {
                0.0
            }
        });
        sizes.fold(0.0, f64::max)
    };
    let (levels, shifts): (Vec<f64>, Vec<f64>) = all.iter().map(|a| (a.level, a.shift_nm)).unzip();
    let (rms, highest): (Vec<f64>, Vec<f64>) = all.iter().map(|a| (rms(a), highest(a))).unzip();
    let far = |values: &[f64], i: usize, [times, least]: [f64; 2]| {
        let middle = median(values.iter().copied());
        let mad = median(values.iter().map(|v| (v - middle).abs()));
        let away = values[i] - middle;
        (away.abs() > (times * mad).max(least)).then_some(away)
    };
    let why = |i: usize| {
        if let Some(off) = far(&levels, i, LEVEL) {
            return Some(tr!(
                "its level is {off} % from that of the others",
                off = signed(100.0 * off, 1)
            ));
        }
        if let Some(off) = far(&shifts, i, SHIFT) {
            return Some(tr!(
                "it is moved by {off} nm against the others",
                off = signed(off, 2)
            ));
        }
        if rms[i] > RESIDUAL * median(rms.iter().copied()) {
            return Some(said!("its shape is another than that of the others").to_owned());
        }
        let most = (THREE[0] * median(highest.iter().copied())).max(THREE[1]);
        (highest[i] > most).then(|| said!("it differs from the others in one place").to_owned())
    };
    let found = (0..n).filter_map(|scan| {
        Some(Misfit {
            scan,
            why: why(scan)?,
        })
    });
    let found: Vec<Misfit> = found.collect();
    match 2 * found.len() > n - 1 {
        true => Ok((Vec::new(), true)),
        false => Ok((found, false)),
    }
}

/// A scan against the median scan: level, shift and half the second derivative are fitted.
fn against(nm: &[f64], middle: &[f64], values: &[f64]) -> Against {
    let down: Vec<f64> = slope(nm, middle).iter().map(|s| -s).collect();
    let bend: Vec<f64> = slope(nm, &down).iter().map(|s| -0.5 * s).collect();
    let columns = [middle, &down, &bend];
    let off: Vec<f64> = values.iter().zip(middle).map(|(v, m)| v - m).collect();
    // Gram and Schmidt: what each column adds to those before.
    let dot = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
    let mut basis: Vec<(Vec<f64>, [f64; 3])> = Vec::new();
    for (k, column) in columns.iter().enumerate() {
        let mut rest = column.to_vec();
        let mut of_columns = [0.0; 3];
        of_columns[k] = 1.0;
        for (other, made_of) in &basis {
            let share = dot(&rest, other);
            rest.iter_mut()
                .zip(other)
                .for_each(|(r, o)| *r -= share * o);
            of_columns
                .iter_mut()
                .zip(made_of)
                .for_each(|(c, m)| *c -= share * m);
        }
        let size = dot(&rest, &rest).sqrt();
        if size > 1e-9 * dot(column, column).sqrt() && size > 0.0 {
            rest.iter_mut().for_each(|r| *r /= size);
            basis.push((rest, of_columns.map(|c| c / size)));
        }
    }
    let mut weights = [0.0; 3];
    let mut left = off.clone();
    for (direction, made_of) in &basis {
        let share = dot(&off, direction);
        left.iter_mut()
            .zip(direction)
            .for_each(|(l, d)| *l -= share * d);
        weights
            .iter_mut()
            .zip(made_of)
            .for_each(|(w, m)| *w += share * m);
    }
    Against {
        level: weights[0],
        shift_nm: weights[1],
        left,
    }
}

/// Drift of the levels from one scan to the next; `None` for fewer than three.
pub fn drift(levels: &[f64]) -> Option<Drift> {
    let n = levels.len();
    if n < 3 {
        return None;
    }
    let middle = 0.5 * (n - 1) as f64;
    let mean = levels.iter().sum::<f64>() / n as f64;
    let at = |i: usize| i as f64 - middle;
    let across: f64 = (0..n).map(|i| at(i).powi(2)).sum();
    let per_scan = (0..n).map(|i| at(i) * (levels[i] - mean)).sum::<f64>() / across;
    let left: f64 = (0..n)
        .map(|i| (levels[i] - mean - per_scan * at(i)).powi(2))
        .sum();
    let error = (left / (n - 2) as f64 / across).sqrt();
    let p = match (error > 0.0, per_scan == 0.0) {
        (true, _) => two_sided_p(per_scan / error, (n - 2) as f64),
        (false, true) => 1.0,
        (false, false) => 0.0,
    };
    Some(Drift { per_scan, p })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        measurements::{Quantity, draws::normal},
        spectrum::Sampled,
    };

    /// Five scans of one lamp, of level and shift as told.
    fn scans(of: [(f64, f64); 5], seed: u64) -> Vec<Measurement> {
        let lamp = |nm: f64| {
            100.0 * (-((nm - 550.0) / 60.0).powi(2)).exp()
                + 80.0 * (-((nm - 620.0) / 6.0).powi(2)).exp()
        };
        let mut noise = normal(seed);
        let scan = |(level, shift): (f64, f64)| {
            let values = (380..=780).map(|nm| level * lamp(f64::from(nm) - shift));
            let values: Vec<f64> = values.zip(noise.by_ref()).map(|(v, e)| v + e).collect();
            let samples = Sampled::even(380.0, 1.0, values).expect("finite");
            Measurement::new("scan", Quantity::Light, "", samples)
        };
        of.into_iter().map(scan).collect()
    }

    #[test]
    fn a_scan_of_another_level_or_place_is_proposed_and_good_ones_are_not() {
        let good = [
            (1.0, 0.0),
            (1.01, 0.1),
            (0.99, -0.1),
            (1.005, 0.05),
            (0.995, 0.0),
        ];
        for seed in 1..20 {
            assert_eq!(
                misfits(&scans(good, seed)),
                Ok((Vec::new(), false)),
                "{seed}"
            );
        }
        let mut dim = good;
        dim[3].0 = 0.7;
        let (found, _) = misfits(&scans(dim, 5)).expect("five");
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].scan, 3);
        let told: Option<f64> = found[0]
            .why
            .split_whitespace()
            .find_map(|word| word.parse().ok());
        assert!(
            told.is_some_and(|percent| (percent + 30.0).abs() < 1.0),
            "{}",
            found[0].why
        );
        let mut moved = good;
        moved[1].1 = 1.2;
        let (found, _) = misfits(&scans(moved, 6)).expect("five");
        assert_eq!(found.iter().map(|m| m.scan).collect::<Vec<_>>(), [1]);
        assert!(
            found[0].why.starts_with("it is moved by +1."),
            "{}",
            found[0].why
        );
    }

    #[test]
    fn where_most_would_go_none_does() {
        let mut half = scans(
            [(1.0, 0.0), (1.002, 0.0), (0.7, 0.0), (1.0, 2.0), (1.0, 0.0)],
            3,
        );
        assert_eq!(misfits(&half).map(|(found, _)| found.len()), Ok(2));
        half.pop();
        assert_eq!(misfits(&half), Ok((Vec::new(), true)));
        half.truncate(2);
        assert_eq!(misfits(&half), Err(RepeatsError::TooFew { scans: 2 }));
    }

    #[test]
    fn a_steady_rise_is_a_drift_and_scatter_is_none() {
        let found = drift(&[0.0, 0.0101, 0.0199, 0.0302, 0.04]).expect("five");
        assert!((found.per_scan - 0.01).abs() < 1e-3 && found.is_there());
        let scatter = drift(&[0.01, -0.012, 0.008, -0.009, 0.003]).expect("five");
        assert!(!scatter.is_there());
        assert_eq!(drift(&[0.0, 0.1]), None);
    }
}
