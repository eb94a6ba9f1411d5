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
    /// What was done, a sentence each.
    pub notes: Vec<String>,
}

/// Why numbers are no spectrum.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Trouble {
    /// What was found.
    pub found: String,
    /// What would have been right.
    pub expected: String,
    /// The point at fault among those given, from 0, where there is one.
    pub index: Option<usize>,
}

impl Trouble {
    fn too_few(points: usize) -> Self {
        let points = many(points, "point", "points");
        Self {
            found: format!("{points} with a wavelength and a value"),
            expected: "at least 2".to_owned(),
            index: None,
        }
    }

    fn too_many(points: usize) -> Self {
        Self {
            found: format!("{points} points"),
            expected: format!("at most {MOST_SAMPLES}"),
            index: None,
        }
    }

    fn at(index: usize, found: String, expected: &str) -> Self {
        Self {
            found,
            expected: expected.to_owned(),
            index: Some(index),
        }
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
    let mut whence: Vec<u32> = Vec::new();
    let mut zeros = 0;
    for (index, (w, v)) in nm.iter().zip(values).enumerate() {
        if *w == 0.0 {
            zeros += 1;
        } else if is_measured(*w) && is_measured(*v) {
            if *w < 0.0 {
                let found = format!("wavelength {w} nm");
                return Err(Trouble::at(index, found, "a wavelength above 0"));
            }
            if points.len() < index && whence.is_empty() {
                whence.extend(0..points.len() as u32);
            }
            if points.len() < index {
                whence.push(index as u32);
            }
            points.push((*w, *v));
        }
    }
    let missing = given - points.len() - zeros;
    let points_at = many(zeros, "point at", "points at");
    notes.extend((zeros > 0).then(|| format!("{points_at} a wavelength of 0 dropped")));
    let values = many(missing, "missing value", "missing values");
    notes.extend((missing > 0).then(|| format!("{values} dropped")));
    match points.len() {
        few @ 0..2 => return Err(Trouble::too_few(few)),
        many if many > MOST_SAMPLES => return Err(Trouble::too_many(many)),
        _ => {}
    }
    put_in_order(&mut points, &whence, most_reversals, &mut notes)?;
    average_doubles(&mut points, &mut notes);
    let (nm, values) = points.iter().copied().unzip();
    let samples = Sampled::new(nm, values).map_err(|_| Trouble::too_few(points.len()))?;
    Ok(Cleaned { samples, notes })
}

fn put_in_order(
    points: &mut [(f64, f64)],
    whence: &[u32],
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
        return Err(Trouble::at(
            whence.get(at + 1).map_or(at + 1, |i| *i as usize),
            format!("wavelength {back} nm after {before} nm"),
            "wavelengths that rise or fall throughout",
        ));
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
    let before = points.len();
    let mut kept = 0;
    let mut from = 0;
    while from < before {
        let nm = points[from].0;
        let count = points[from..].iter().take_while(|p| p.0 == nm).count();
        let value = if count == 1 {
            points[from].1
        } else {
            // Divided first, so that the sum of two huge values stays finite.
            points[from..from + count]
                .iter()
                .map(|p| p.1 / count as f64)
                .sum()
        };
        points[kept] = (nm, value);
        kept += 1;
        from += count;
    }
    points.truncate(kept);
    let doubles = before - kept;
    let said = || many(doubles, "doubled wavelength", "doubled wavelengths") + " averaged";
    notes.extend((doubles > 0).then(said));
}
