//! From the numbers of a file to a spectrum: order, doubles and gaps.

use crate::io::text::number::is_measured;
use crate::languages::with_sign;
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
        let found = tr!("{n} point with a wavelength and a value"
            | "{n} points with a wavelength and a value" % points);
        let expected = match missing {
            0 => said!("at least 2"),
            _ => said!("at least 2 (numbers of 1e30 and more stand for missing values)"),
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
    let mut zeros = 0_usize;
    for (index, (w, v)) in nm.iter().zip(values).enumerate() {
        zeros += usize::from(*w == 0.0);
        if is_point(*w, *v) {
            if *w < 0.0 {
                let found = tr!("wavelength {nm} nm", nm = with_sign(w.to_string()));
                let expected = said!("a wavelength above 0");
                return Err(Trouble::new(found, expected, Some(index)));
            }
            points.push((*w, *v));
        }
    }
    let missing = given - points.len() - zeros;
    notes.extend((zeros > 0).then(|| {
        tr!("{n} point at a wavelength of 0 dropped"
            | "{n} points at a wavelength of 0 dropped" % zeros)
    }));
    notes.extend(
        (missing > 0)
            .then(|| tr!("{n} missing value dropped" | "{n} missing values dropped" % missing)),
    );
    match points.len() {
        few @ 0..2 => return Err(Trouble::too_few(few, missing)),
        many if many > MOST_SAMPLES => {
            let most = tr!("at most {most}", most = MOST_SAMPLES);
            let found = tr!("{n} point" | "{n} points" % many);
            return Err(Trouble::new(found, most, None));
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
        let found = tr!(
            "wavelength {back} nm after {before} nm",
            back = with_sign(back.to_string()),
            before = with_sign(before.to_string())
        );
        let expected = said!("wavelengths that rise or fall throughout");
        return Err(Trouble::new(found, expected, Some(at + 1)));
    }
    if falling {
        points.reverse();
        notes.push(said!("falling wavelengths turned round").to_owned());
    }
    if reversals > 0 {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        notes.push(tr!("wavelengths step back once: put in rising order"
            | "wavelengths step back {n} times: put in rising order"
                % reversals));
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
    notes.push(tr!(
        "{n} doubled wavelength averaged" | "{n} doubled wavelengths averaged" % doubles
    ));
}
