//! Scans of one light: their mean, those that do not belong, what differs between two sets.

use super::{
    formula::{of_composite, of_summands},
    parts::{Part, doubt_from, with_noise},
    result::{Found, LineRow, ScanRow},
    said,
    words::{part_name, sentence},
};
use crate::{
    app::readings::names_of_lines,
    languages::signed,
    measurements::{
        ChangeError, Changed, Feature, Measurement, Misfit, Repeats, RepeatsError, changed, drift,
        has_memory, lines_of_scans, mean_of, misfits,
    },
};

/// Fewest scans that tell a spread.
const LEAST_SCANS: usize = 3;

/// A line of the mean's table is that of the composite up to this distance, nm.
const SAME_NM: f64 = 1.0;

/// The mean of scans; those that do not belong are left out and said, unless all are to be kept.
///
/// # Errors
/// A sentence where they cannot be taken together, or nobody can say which of them is wrong.
pub(super) fn of_scans(parts: &[Measurement], keep_all: bool) -> Result<Found, String> {
    let made_by = match parts.len() {
        1 => parts[0].name.clone(),
        n => format!("mean of {n} scans"),
    };
    if parts.len() < LEAST_SCANS {
        return of_few(parts, made_by);
    }
    let Belonging {
        kept,
        odd,
        drops,
        mut notes,
    } = Belonging::of(parts, keep_all)?;
    let mut repeats = Repeats::of(&kept).map_err(said)?;
    repeats.mean.name.clone_from(&made_by);
    let all = match kept.len() == parts.len() {
        true => repeats.clone(),
        false => Repeats::of(parts).map_err(said)?,
    };
    let is_out = |scan: usize| odd.iter().any(|m| m.scan == scan);
    let rows = (0..parts.len()).map(|scan| ScanRow {
        name: parts[scan].name.clone(),
        level: all.levels[scan],
        shift_nm: all.shifts_nm[scan],
        residual: all.residuals[scan],
        is_kept: !drops || !is_out(scan),
        why: odd.iter().find(|m| m.scan == scan).map(|m| m.why.clone()),
    });
    let rows: Vec<ScanRow> = rows.collect();
    let drift = drift(&repeats.levels);
    if let Some(drift) = drift.filter(|drift| drift.is_there()) {
        let percent = 100.0 * drift.per_scan;
        notes.push(tr!(
            "The level changes by {share} % from scan to scan.",
            share = signed(percent, 2)
        ));
    }
    if kept.len() == LEAST_SCANS {
        notes.push(said!("The uncertainty is that of 3 scans only.").to_owned());
    }
    let lines = lines_of_scans(&repeats.mean, &kept).map_err(said)?;
    Ok(Found {
        scans: rows,
        drift,
        notes,
        lines: lines.into_iter().map(LineRow::of_light).collect(),
        first_nm: vec![parts[0].samples.nm().to_vec()],
        ..Found::of(repeats.mean, made_by, "repeats")
    })
}

/// The mean of composites is one itself: the mean of their coefficients and of their lines, by name
/// and place. The spread of the scans stays, where they share their wavelengths with it.
///
/// # Errors
/// A sentence where the composite has no table.
pub(super) fn of_composites(found: Found, parts: &[Part]) -> Result<Found, String> {
    let is_kept = |scan: usize| found.scans.get(scan).is_none_or(|scan| scan.is_kept);
    let kept = || (0..parts.len()).filter(|scan| is_kept(*scan));
    let by = 1.0 / kept().count() as f64;
    let Some(sum) = of_summands(kept().map(|scan| (by, &parts[scan]))) else {
        return Ok(found);
    };
    let (known, rows) = (found.result().clone(), found.lines.clone());
    let mut made = of_composite(found, sum)?;
    let result = made.result_mut();
    if result.samples.nm() == known.samples.nm() {
        result.sigma = known.sigma;
    }
    for line in &mut made.lines {
        let away = |row: &&LineRow| (row.at_nm - line.at_nm).abs();
        let near = rows.iter().filter(|row| away(row) <= SAME_NM);
        if let Some(row) = near.min_by(|a, b| away(a).total_cmp(&away(b))) {
            (line.u, line.is_certain) = (row.u, row.is_certain);
        }
    }
    Ok(made)
}

/// Scans with those that do not belong left out, unless all are to be kept or too few would stay.
struct Belonging {
    kept: Vec<Measurement>,
    odd: Vec<Misfit>,
    /// True if those are left out.
    drops: bool,
    /// A sentence for each of them.
    notes: Vec<String>,
}

impl Belonging {
    fn of(parts: &[Measurement], keep_all: bool) -> Result<Self, String> {
        let (mut odd, is_open) = misfits(parts).map_err(said)?;
        if is_open && !keep_all {
            return Err(match parts.len() {
                3 => said!(
                    "Two of three scans differ from the third and each other: which is wrong \
                     cannot be said."
                )
                .to_owned(),
                n => tr!(
                    "More than half of {n} scans differ from the others and each other: which is \
                     wrong cannot be said.",
                    n
                ),
            });
        }
        let drops = !keep_all && parts.len() - odd.len() >= LEAST_SCANS;
        odd.sort_by_key(|m| m.scan);
        let is_out = |scan: usize| drops && odd.iter().any(|m| m.scan == scan);
        let kept = (0..parts.len()).filter(|scan| !is_out(*scan));
        let kept = kept.map(|scan| parts[scan].clone()).collect();
        let note = |Misfit { scan, why }: &Misfit| {
            let name = &parts[*scan].name;
            match drops {
                true => tr!(
                    "{name} does not seem to belong: {why}. It is left out, unless everything is \
                     kept.",
                    name,
                    why
                ),
                false => tr!(
                    "{name} does not seem to belong: {why}. It is kept all the same.",
                    name,
                    why
                ),
            }
        };
        Ok(Self {
            notes: odd.iter().map(note).collect(),
            kept,
            odd,
            drops,
        })
    }
}

/// One scan or two: their noise is what they state, or what their second differences tell.
fn of_few(parts: &[Measurement], made_by: String) -> Result<Found, String> {
    let from = doubt_from(parts);
    let is_stated = parts
        .iter()
        .all(|part| part.sigma.is_some() || part.level > 0.0 || part.axis_nm > 0.0);
    let noisy = with_noise(parts.to_vec());
    let root = (parts.len() as f64).sqrt();
    let mut mean = mean_of(&noisy).map_err(said)?;
    mean.name.clone_from(&made_by);
    if parts.len() > 1 {
        let first = &noisy[0];
        mean.sigma = first
            .sigma
            .clone()
            .filter(|s| s.len() == mean.samples.len());
        if let Some(sigma) = &mut mean.sigma {
            sigma.iter_mut().for_each(|s| *s /= root);
        }
        (mean.level, mean.axis_nm) = (first.level / root, first.axis_nm / root);
        // Two scans tell no spread: the noise is each one's own.
        mean.scans = None;
    }
    let mut found = Found::of(mean, made_by, from);
    found.first_nm = vec![parts[0].samples.nm().to_vec()];
    if !is_stated {
        let scans = RepeatsError::TooFew { scans: parts.len() };
        found.notes.push(scans.to_string());
    }
    if parts[0].sigma.is_none() && has_memory(&parts[0].samples) {
        found.notes.push(
            said!(
                "Neighbours share their noise, which one scan does not tell: \u{b1} is at least \
                 as told."
            )
            .to_owned(),
        );
    }
    let scans = found.result_mut().scans.get_or_insert(parts.len());
    *scans = (*scans).max(parts.len());
    found.tell_lines();
    Ok(found)
}

/// What differs between two sets; scans that do not belong to theirs are left out and said.
///
/// # Errors
/// A sentence where they cannot be compared.
pub fn of_change(
    first: &[Measurement],
    second: &[Measurement],
    keep_all: bool,
) -> Result<Found, String> {
    let belonging = |set: &[Measurement]| match set.len() < LEAST_SCANS {
        true => Ok((set.to_vec(), Vec::new())),
        false => Belonging::of(set, keep_all).map(|set| (set.kept, set.notes)),
    };
    let ((first, mut notes), (second, more)) = (belonging(first)?, belonging(second)?);
    notes.extend(more);
    match changed(&first, &second) {
        Ok(changed) => {
            let places: Vec<f64> = changed
                .parts
                .iter()
                .filter_map(|part| match part.feature {
                    Feature::Line(at) => Some(at),
                    _ => None,
                })
                .collect();
            let mut names = names_of_lines(&first[0].samples, &places).into_iter();
            let words: Vec<String> = changed
                .parts
                .iter()
                .map(|part| {
                    let name = match part.feature {
                        Feature::Line(_) => names.next().flatten(),
                        _ => None,
                    };
                    part_name(part, name.as_deref())
                })
                .collect();
            let sentence = sentence(&changed, &words);
            let mut found = Found::of_change(changed, words, sentence);
            found.notes.extend(notes);
            Ok(found)
        }
        Err(ChangeError::CannotSay(why @ RepeatsError::TooFew { .. })) => {
            let is_stated = |set: &[Measurement]| set.len() == 1 && set[0].sigma.is_some();
            let is_few = |set: &[Measurement]| set.len() < LEAST_SCANS && !is_stated(set);
            let sentence = match [is_few(&first), is_few(&second)] {
                [true, true] => tr!("Cannot say: {why} Both sets have too few.", why),
                [true, false] => tr!("Cannot say: {why} The first set has too few.", why),
                _ => tr!("Cannot say: {why} The second set has too few.", why),
            };
            Ok(Found::of_change(Changed::unsaid(), Vec::new(), sentence))
        }
        Err(why) => Err(why.to_string()),
    }
}
