//! From the numbers of a file to a spectrum: order, doubles and gaps.

use crate::io::many::many;
use crate::io::text::number::is_measured;
use crate::spectrum::Sampled;

/// Most samples of one spectrum.
pub(crate) const MOST_SAMPLES: usize = 10_000_000;

/// More steps backwards than this share of all steps is not a table of wavelengths.
pub(crate) const MOST_REVERSALS: f64 = 0.1;

/// The same where a title says that they are wavelengths: a curve traced by hand from a printed
/// plot goes back and forth, and may be traced in two pieces.
pub(crate) const TRACED_REVERSALS: f64 = 0.5;

/// A spectrum and what was done to get it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cleaned {
    /// The table.
    pub samples: Sampled,
    /// The changes made, a sentence each.
    pub notes: Vec<String>,
}

/// Why numbers are no spectrum.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Trouble {
    /// The actual state of the numbers.
    pub found: String,
    /// The required state of the numbers.
    pub expected: String,
    /// The point at fault among those given, from 0, where there is one.
    pub index: Option<usize>,
}

impl Trouble {
    fn new(found: String, expected: impl Into<String>, index: Option<usize>) -> Self {
        Self {
            found,
            expected: expected.into(),
            index,
        }
    }

    fn too_few(points: usize, missing: usize) -> Self {
        let points = many(points, "point", "points");
        let found = format!("{points} with a wavelength and a value");
        let expected = match missing {
            0 => "at least 2",
            _ => "at least 2 (numbers of 1e30 and more stand for missing values)",
        };
        Self::new(found, expected, None)
    }
}

/// As [`clean`], for values on wavelengths that are in order already and are kept in memory once.
///
/// # Errors
/// The values, when something needs to be done to them.
pub(crate) fn beside(other: &Sampled, values: Vec<f64>) -> Result<Cleaned, Vec<f64>> {
    // Without a way out in the middle, which is much faster on long columns.
    if values.iter().fold(false, |odd, v| odd | !is_measured(*v)) {
        return Err(values);
    }
    let samples = other.sharing(values).map_err(|(_, values)| values)?;
    let notes = Vec::new();
    Ok(Cleaned { samples, notes })
}

/// Makes a spectrum of wavelengths (nm) and values: gaps (anything that is not finite or of a size
/// that nothing has, [`crate::io::text::number::ABSURD`]) are dropped,
/// falling wavelengths turned round, a few out of order put in order, equal ones averaged, and
/// each of these is noted. Values are never changed otherwise.
///
/// # Errors
/// [`Trouble`] when that leaves no spectrum.
pub(crate) fn clean(nm: &[f64], values: &[f64]) -> Result<Cleaned, Trouble> {
    clean_within(nm, values, MOST_REVERSALS)
}

/// As [`clean`]; at most `most_reversals` of the steps may go backwards.
pub(crate) fn clean_within(
    nm: &[f64],
    values: &[f64],
    most_reversals: f64,
) -> Result<Cleaned, Trouble> {
    let mut notes = Vec::new();
    let given = nm.len().min(values.len());
    let mut points: Vec<(f64, f64)> = Vec::with_capacity(given);
    let is_point = |w: f64, v: f64| w != 0.0 && is_measured(w) && is_measured(v);
    let mut zeros = 0;
    for (index, (w, v)) in nm.iter().zip(values).enumerate() {
        zeros += usize::from(*w == 0.0);
        if is_point(*w, *v) {
            if *w < 0.0 {
                let found = format!("wavelength {w} nm");
                return Err(Trouble::new(found, "a wavelength above 0", Some(index)));
            }
            points.push((*w, *v));
        }
    }
    let missing = given - points.len() - zeros;
    let points_at = many(zeros, "point at", "points at");
    notes.extend((zeros > 0).then(|| format!("{points_at} a wavelength of 0 dropped")));
    let missed = many(missing, "missing value", "missing values");
    notes.extend((missing > 0).then(|| format!("{missed} dropped")));
    match points.len() {
        few @ 0..2 => return Err(Trouble::too_few(few, missing)),
        many if many > MOST_SAMPLES => {
            let most = format!("at most {MOST_SAMPLES}");
            return Err(Trouble::new(format!("{many} points"), most, None));
        }
        _ => {}
    }
    put_in_order(&mut points, most_reversals, &mut notes).map_err(|trouble| {
        let mut places = (0..given).filter(|at| is_point(nm[*at], values[*at]));
        let index = trouble.index.and_then(|at| places.nth(at));
        Trouble { index, ..trouble }
    })?;
    average_doubles(&mut points, &mut notes);
    let (nm, values) = points.iter().copied().unzip();
    let samples = Sampled::new(nm, values).map_err(|_| Trouble::too_few(points.len(), missing))?;
    Ok(Cleaned { samples, notes })
}

fn put_in_order(
    points: &mut [(f64, f64)],
    most_reversals: f64,
    notes: &mut Vec<String>,
) -> Result<(), Trouble> {
    let steps = points.len() - 1;
    let (mut up, mut down) = (0, 0);
    for pair in points.windows(2) {
        up += usize::from(pair[1].0 > pair[0].0);
        down += usize::from(pair[1].0 < pair[0].0);
    }
    let falling = down > up;
    let reversals = up.min(down);
    if reversals > 0 && reversals as f64 > most_reversals * steps as f64 {
        let against = |pair: &[(f64, f64)]| match falling {
            true => pair[1].0 > pair[0].0,
            false => pair[1].0 < pair[0].0,
        };
        let at = points.windows(2).position(against).unwrap_or(0);
        let (before, back) = (points[at].0, points[at + 1].0);
        let found = format!("wavelength {back} nm after {before} nm");
        let expected = "wavelengths that rise or fall throughout";
        return Err(Trouble::new(found, expected, Some(at + 1)));
    }
    if falling {
        points.reverse();
        notes.push("falling wavelengths turned round".to_owned());
    }
    if reversals > 0 {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let often = match reversals {
            1 => "once".to_owned(),
            times => format!("{times} times"),
        };
        notes.push(format!(
            "wavelengths step back {often}: put in rising order"
        ));
    }
    Ok(())
}

fn average_doubles(points: &mut Vec<(f64, f64)>, notes: &mut Vec<String>) {
    let is_double = |pair: &[(f64, f64)]| pair[0].0 == pair[1].0;
    let doubles = points.windows(2).filter(|pair| is_double(pair)).count();
    if doubles == 0 {
        return;
    }
    // Divided first, so that the sum of two huge values stays finite.
    let value = |same: &[(f64, f64)]| match same {
        [(_, alone)] => *alone,
        several => several.iter().map(|p| p.1 / several.len() as f64).sum(),
    };
    let same = points.chunk_by(|a, b| a.0 == b.0);
    *points = same.map(|same| (same[0].0, value(same))).collect();
    notes.push(many(doubles, "doubled wavelength", "doubled wavelengths") + " averaged");
}
