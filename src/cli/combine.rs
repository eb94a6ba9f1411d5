//! `combine`: sums, quotients, means of scans with their doubt, slits, spliced ranges, and what
//! changed between two sets.

use std::{
    ffi::{OsStr, OsString},
    io::Write,
};

use super::{
    arguments::Combine,
    combine_inputs::{doubt_from, has_lines, read, stated, with_noise},
    combine_result::{Found, ScanRow, json, text},
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    room_words::Grid,
    target::{Replaces, Target},
    words,
};
use crate::{
    app::measured::{measurement_csv, spectrum},
    io::{Columns, Provenance, write_as},
    measurements::{
        Formula, Kernel, Measurement, Options, Repeats, Slit, changed, combine, drift, letter,
        misfits, resampled, smoothed, splice,
    },
};

/// Most that a quotient over a reference with lines may be off by.
const MOST_DOUBT: f64 = 0.03;

/// Most inputs: as many as there are letters.
const MOST_INPUTS: usize = 26;

/// What is done with the inputs.
enum Act {
    Formula(Formula, String),
    Mean,
    Splice,
    Slit(Slit),
    Changed,
}

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a formula that is none, inputs that cannot be read and combinations that mean
/// nothing.
pub(super) fn run(
    options: &Combine,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let (act, files) = understood(options)?;
    let target = target(options, &files)?;
    let is_of_scans = matches!(act, Act::Mean | Act::Changed);
    let mut parts = Vec::new();
    for file in &files {
        let found = read(file, is_of_scans, inputs)?;
        parts.extend(found.into_iter().map(|part| stated(part, options)));
    }
    let found = match act {
        Act::Formula(formula, text) => of_formula(&formula, &text, parts, options)?,
        Act::Mean => of_scans(&parts)?,
        Act::Splice => of_ranges(&parts, options)?,
        Act::Slit(slit) => through(parts, slit)?,
        Act::Changed => {
            let mut others = Vec::new();
            for file in &options.others {
                others.extend(read(file, true, inputs)?);
            }
            if options.out.is_some() || options.csv {
                inputs.note("--out and --csv are not used: changed makes no spectrum");
            }
            let changed = changed(&parts, &others).map_err(Refusal::file)?;
            let found = Found::of_change(changed);
            return told(options, &found, out);
        }
    };
    let found = on_grid(found, options.grid)?;
    if let Some(target) = target {
        save(&target, &found, inputs)?;
    }
    if options.csv {
        return print(out, &measurement_csv(found.result(), &found.made_by));
    }
    told(options, &found, out)
}

/// Prints what was found; notes stand in JSON and in the words.
fn told(options: &Combine, found: &Found, out: &mut dyn Write) -> Result<(), Refusal> {
    match options.json {
        true => print_json(out, &json(found)),
        false => print(out, &text(found)),
    }
}

/// What is to be done, and the words that name inputs.
fn understood(options: &Combine) -> Result<(Act, Vec<OsString>), Refusal> {
    let usage = |why: String| Refusal::Usage(format!("FORMULA: {why}"));
    let word = options.formula.to_str().unwrap_or_default().trim();
    let mut files = options.inputs.clone();
    let act = match word {
        "mean" => Act::Mean,
        "splice" => Act::Splice,
        "changed" => Act::Changed,
        "slit" => {
            let fwhm = files
                .first()
                .and_then(|w| w.to_str()?.trim_end_matches("nm").parse::<f64>().ok());
            let Some(fwhm_nm) = fwhm.filter(|nm| (1e-3..=1000.0).contains(nm)) else {
                return Err(usage(
                    "found slit without a width, expected one in nm behind it".to_owned(),
                ));
            };
            files.remove(0);
            let shape = files.first().and_then(|w| Kernel::from_word(w.to_str()?));
            if shape.is_some() {
                files.remove(0);
            }
            Act::Slit(Slit {
                shape: shape.unwrap_or(Kernel::Triangle),
                fwhm_nm,
            })
        }
        _ => {
            let mut text = word.to_owned();
            let goes_on = |text: &str, file: Option<&OsString>| {
                let word = file?.to_str()?;
                Formula::goes_on(text, word).then(|| word.to_owned())
            };
            while let Some(word) = goes_on(&text, files.first()) {
                text = format!("{text} {word}");
                files.remove(0);
            }
            let formula = Formula::parse(&text).map_err(|why| usage(why.to_string()))?;
            Act::Formula(formula, text)
        }
    };
    if !matches!(act, Act::Changed) && !options.others.is_empty() {
        return Err(Refusal::Usage(
            "--: found inputs behind it, expected them behind changed only".to_owned(),
        ));
    }
    let least = match &act {
        Act::Formula(formula, _) => formula.inputs(),
        Act::Splice => 2,
        Act::Mean | Act::Slit(_) | Act::Changed => 1,
    };
    let is_right = match &act {
        Act::Splice | Act::Slit(_) => files.len() == least,
        Act::Changed => !files.is_empty() && !options.others.is_empty(),
        Act::Formula(..) | Act::Mean => {
            (least.max(1)..=MOST_INPUTS).contains(&files.len())
                || matches!(act, Act::Mean) && !files.is_empty()
        }
    };
    match is_right {
        true => Ok((act, files)),
        false => Err(Refusal::Usage(format!(
            "INPUT: found {} of them, expected {}",
            files.len(),
            match &act {
                Act::Changed => "a set, -- and another set".to_owned(),
                Act::Splice | Act::Slit(_) => least.to_string(),
                _ => format!("one for each letter up to {}", letter(least.max(1) - 1)),
            }
        ))),
    }
}

fn target<'o>(options: &'o Combine, files: &[OsString]) -> Result<Option<Target<'o>>, Refusal> {
    let Some(path) = &options.out else {
        return Ok(None);
    };
    let words: Vec<Option<&OsStr>> = files.iter().map(|file| Some(file.as_os_str())).collect();
    let target = Target::out(path, Replaces::Nothing, options.force, &words);
    target.path()?;
    Ok(Some(target))
}

fn of_formula(
    formula: &Formula,
    text: &str,
    parts: Vec<Measurement>,
    options: &Combine,
) -> Result<Found, Refusal> {
    let from = doubt_from(&parts);
    let parts = with_noise(parts);
    let divisors = formula.divisors();
    let has_lines = divisors
        .iter()
        .filter_map(|index| parts.get(*index))
        .any(has_lines);
    let settings = Options {
        keep_all: options.keep_all,
        most_doubt: has_lines.then_some(MOST_DOUBT),
    };
    let mut found = combine(formula, &parts, settings).map_err(Refusal::file)?;
    if has_lines && found.kept < 0.25 {
        found.notes.push(format!(
            "The reference is almost dark between its lines: only {:.0} % of the range is told.",
            100.0 * found.kept
        ));
    }
    let names: Vec<String> = parts
        .iter()
        .enumerate()
        .map(|(index, part)| format!("{} = {}", letter(index), part.name))
        .collect();
    let made_by = format!("{text}; {}", names.join("; "));
    Ok(Found {
        scans: Vec::new(),
        notes: found.notes,
        step_nm: found.step_nm,
        first_nm: parts
            .iter()
            .map(|part| part.samples.nm().to_vec())
            .collect(),
        ..Found::of(found.result, made_by, from)
    })
}

fn of_scans(parts: &[Measurement]) -> Result<Found, Refusal> {
    let made_by = match parts.len() {
        1 => parts[0].name.clone(),
        n => format!("mean of {n} scans"),
    };
    if let [one] = parts {
        let mut found = Found::of(one.clone(), made_by, doubt_from(parts));
        let why = "One scan has no spread. Add two more, or state the instrument's noise.";
        found.notes.push(why.to_owned());
        return Ok(found);
    }
    let repeats = Repeats::of(parts).map_err(Refusal::file)?;
    let (odd, is_open) = misfits(parts).map_err(Refusal::file)?;
    let mut notes = Vec::new();
    if is_open {
        notes.push(
            "So many scans differ from the others and each other: which is wrong cannot be said."
                .to_owned(),
        );
    }
    let why = |scan: usize| odd.iter().find(|m| m.scan == scan).map(|m| m.why.clone());
    let drift = drift(&repeats.levels);
    let rows = (0..parts.len()).map(|scan| ScanRow {
        name: parts[scan].name.clone(),
        level: repeats.levels[scan],
        shift_nm: repeats.shifts_nm[scan],
        residual: repeats.residuals[scan],
        why: why(scan),
    });
    let rows: Vec<ScanRow> = rows.collect();
    notes.extend(rows.iter().filter_map(|row| {
        let why = row.why.as_ref()?;
        Some(format!(
            "{} does not seem to belong: {why}. It is kept; leave it out to drop it.",
            row.name
        ))
    }));
    if let Some(drift) = drift.filter(|drift| drift.is_there()) {
        let percent = 100.0 * drift.per_scan;
        notes.push(format!(
            "The level changes by {percent:+.2} % from scan to scan."
        ));
    }
    let first_nm = vec![parts[0].samples.nm().to_vec()];
    Ok(Found {
        scans: rows,
        drift,
        notes,
        first_nm,
        ..Found::of(repeats.mean, made_by, "repeats")
    })
}

fn of_ranges(parts: &[Measurement], options: &Combine) -> Result<Found, Refusal> {
    let [first, second] = parts else {
        return Err(Refusal::Usage(
            "INPUT: expected 2 ranges of one light".to_owned(),
        ));
    };
    let spliced = splice(first, second, options.axis == Some(0.0)).map_err(Refusal::file)?;
    let made_by = format!("splice of {} and {}", first.name, second.name);
    let note = format!(
        "From {} to {} nm both are there: the second is multiplied by {} ± {:.2} %.",
        spliced.overlap_nm[0],
        spliced.overlap_nm[1],
        spliced.factor,
        196.0 * spliced.u
    );
    let mut found = Found::of(spliced.result.clone(), made_by, doubt_from(parts));
    found.first_nm = parts
        .iter()
        .map(|part| part.samples.nm().to_vec())
        .collect();
    found.notes.push(note);
    found.splice = Some(spliced);
    Ok(found)
}

fn through(parts: Vec<Measurement>, slit: Slit) -> Result<Found, Refusal> {
    let from = doubt_from(&parts);
    let parts = with_noise(parts);
    let Some(part) = parts.first() else {
        return Err(Refusal::Usage("INPUT: expected a light".to_owned()));
    };
    let seen = smoothed(part, slit).map_err(Refusal::file)?;
    let made_by = format!(
        "{} through {} nm ({})",
        part.name,
        slit.fwhm_nm,
        slit.shape.word()
    );
    let mut found = Found::of(seen, made_by, from);
    found.first_nm = vec![part.samples.nm().to_vec()];
    Ok(found)
}

/// The result on the wavelengths that are asked for.
fn on_grid(mut found: Found, grid: Grid) -> Result<Found, Refusal> {
    let result = found.result();
    let nm: Vec<f64> = match grid {
        Grid::Union => return Ok(found),
        Grid::Input(index) => match found.first_nm.get(index) {
            Some(nm) => nm.clone(),
            None => {
                return Err(Refusal::Usage(format!(
                    "--grid: found {}, expected union, the letter of an input or a step in nm",
                    letter(index)
                )));
            }
        },
        Grid::Step(step) => {
            let (first, last) = (result.samples.first_nm(), result.samples.last_nm());
            let from = (first / step - 1e-9).ceil() as i64;
            let to = (last / step + 1e-9).floor() as i64;
            if to - from > 1 << 20 {
                return Err(Refusal::Usage(format!(
                    "--grid: found a step of {step} nm, expected a larger one"
                )));
            }
            (from..=to).map(|k| k as f64 * step).collect()
        }
    };
    found.result = Some(resampled(result, &nm, found.step_nm).map_err(Refusal::file)?);
    Ok(found)
}

/// Writes the result; what the format does not keep is said.
fn save(target: &Target, found: &Found, inputs: &mut Inputs) -> Result<(), Refusal> {
    let result = found.result();
    let extension = words::extension(target.path);
    if extension == "csv" {
        let text = measurement_csv(result, &found.made_by);
        return target.save(text.as_bytes());
    }
    let named = spectrum(result, &found.made_by);
    if result.sigma.is_some() || !result.mask.is_empty() {
        inputs.note(format!(
            ".{extension} keeps neither sigma nor what is masked: .csv keeps both"
        ));
    }
    let provenance = Provenance {
        program: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
        scale_words: "as measured".to_owned(),
        ..Provenance::default()
    };
    let columns = Columns::measured(&named);
    write_as(target.path()?, &named, &columns, &provenance).map_err(Refusal::file)
}
