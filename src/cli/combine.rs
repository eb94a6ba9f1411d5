//! `combine`: sums, quotients, means of scans with their doubt, slits, spliced ranges, and what
//! changed between two sets.

use std::{
    ffi::{OsStr, OsString},
    io::Write,
};

use super::{
    arguments::Combine,
    combine_inputs::{Part, doubt_from, has_lines, measurements, read, with_noise},
    combine_instrument, combine_json,
    combine_result::{Found, LineRow},
    combine_scans, combine_slit, combine_words,
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    room_words::Grid,
    target::{Replaces, Target},
    words,
};
use crate::{
    app::{
        instruments,
        measured::{measurement_csv, spectrum},
        readings::Reading,
    },
    io::{Columns, CompositeFile, Provenance, composite_json, write_as},
    measurements::{
        Formula, Kernel, Measurement, Options, Slit, combine, letter, resampled, splice,
        sum_of_composites,
    },
    spectrum::Composite,
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
    /// A slit taken off: of this width, or as the light's own lines tell it.
    Unslit(Option<f64>, Kernel),
    Changed,
    Learn,
    /// The instrument's file is the first input.
    Use,
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
    let (act, mut files) = understood(options)?;
    let target = target(options, &files)?;
    let is_of_scans = matches!(act, Act::Mean | Act::Changed);
    let instrument = match act {
        Act::Use => Some(combine_instrument::read(&files.remove(0), inputs)?),
        _ => None,
    };
    let mut parts = Vec::new();
    for file in &files {
        parts.extend(read(file, is_of_scans, options.stated, inputs)?);
    }
    let mut found = match act {
        Act::Formula(formula, text) => of_formula(&formula, &text, &parts, options)?,
        Act::Mean => combine_scans::of_scans(&measurements(&parts), options.keep_all)?,
        Act::Splice => of_ranges(&measurements(&parts), options)?,
        Act::Slit(slit) => combine_slit::through(measurements(&parts), slit)?,
        Act::Unslit(fwhm, shape) => combine_slit::taken_off(measurements(&parts), fwhm, shape)?,
        Act::Learn => combine_instrument::learnt(&measurements(&parts), options, inputs)?,
        Act::Use => combine_instrument::used(instrument, &measurements(&parts))?,
        Act::Changed => {
            let mut others = Vec::new();
            for file in &options.others {
                others.extend(read(file, true, options.stated, inputs)?);
            }
            if options.out.is_some() || options.csv {
                inputs.note("--out and --csv are not used: changed makes no spectrum");
            }
            let [first, second] = [measurements(&parts), measurements(&others)];
            return told(options, &combine_scans::of_change(&first, &second)?, out);
        }
    };
    let readings: Vec<Reading> = parts.iter().map(|part| part.reading.clone()).collect();
    found.reading = Reading::of_parts(&readings, found.result().quantity);
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
        true => print_json(out, &combine_json::json(found)),
        false => print(out, &combine_words::text(found)),
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
            let Some(fwhm_nm) = width(files.first()) else {
                return Err(usage(
                    "found slit without a width, expected one in nm behind it".to_owned(),
                ));
            };
            files.remove(0);
            let shape = shape(&mut files).unwrap_or(Kernel::Triangle);
            Act::Slit(Slit { shape, fwhm_nm })
        }
        "unslit" => {
            let fwhm = width(files.first());
            let is_auto = files.first().is_some_and(|word| word == "auto");
            if fwhm.is_some() || is_auto {
                files.remove(0);
            }
            Act::Unslit(fwhm, shape(&mut files).unwrap_or(Kernel::Gauss))
        }
        "instrument" => {
            let act = match files.first().and_then(|word| word.to_str()) {
                Some("learn") => Act::Learn,
                Some("use") => Act::Use,
                _ => {
                    return Err(usage(
                        "found instrument alone, expected learn or use behind it".to_owned(),
                    ));
                }
            };
            files.remove(0);
            act
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
    expected(&act, &files, options).map(|()| (act, files))
}

/// A width in nm, with or without the unit.
fn width(word: Option<&OsString>) -> Option<f64> {
    let nm = word?.to_str()?.trim_end_matches("nm").parse::<f64>().ok();
    nm.filter(|nm| (1e-3..=1000.0).contains(nm))
}

/// Takes the shape of a slit off the words, if one stands first.
fn shape(files: &mut Vec<OsString>) -> Option<Kernel> {
    let shape = Kernel::from_word(files.first()?.to_str()?)?;
    files.remove(0);
    Some(shape)
}

/// Refuses too few or too many inputs.
fn expected(act: &Act, files: &[OsString], options: &Combine) -> Result<(), Refusal> {
    if !matches!(act, Act::Changed) && !options.others.is_empty() {
        return Err(Refusal::Usage(
            "--: found inputs behind it, expected them behind changed only".to_owned(),
        ));
    }
    if options.known.is_some() != matches!(act, Act::Learn) {
        return Err(Refusal::Usage(match options.known {
            Some(_) => "--known: expected instrument learn with it".to_owned(),
            None => "instrument learn: expected --known with the light that was read".to_owned(),
        }));
    }
    let (least, most) = match act {
        Act::Formula(formula, _) => (formula.inputs().max(1), MOST_INPUTS),
        Act::Splice => (2, 2),
        Act::Slit(_) | Act::Unslit(..) => (1, 1),
        Act::Learn => (1, 2),
        Act::Use => (2, 3),
        Act::Changed if options.others.is_empty() => (usize::MAX, usize::MAX),
        Act::Mean | Act::Changed => (1, usize::MAX),
    };
    if (least..=most).contains(&files.len()) {
        return Ok(());
    }
    Err(Refusal::Usage(format!(
        "INPUT: found {} of them, expected {}",
        files.len(),
        match act {
            Act::Changed => "a set, -- and another set".to_owned(),
            Act::Learn => "a reading, and its dark where one was taken".to_owned(),
            Act::Use => "an instrument, a reading, and its dark where one was taken".to_owned(),
            Act::Splice | Act::Slit(_) | Act::Unslit(..) => least.to_string(),
            _ => format!("one for each letter up to {}", letter(least - 1)),
        }
    )))
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
    parts: &[Part],
    options: &Combine,
) -> Result<Found, Refusal> {
    let from = doubt_from(&measurements(parts));
    let inputs = with_noise(measurements(parts));
    let divisors = formula.divisors();
    let has_lines = divisors
        .iter()
        .filter_map(|index| inputs.get(*index))
        .any(has_lines);
    // Between lines a quotient is as good as the axes are known; of the noise alone the mask tells.
    let has_axis = inputs.iter().any(|input| input.axis_nm > 0.0);
    let settings = Options {
        keep_all: options.keep_all,
        most_doubt: (has_lines && has_axis).then_some(MOST_DOUBT),
        tells_lines: has_lines,
    };
    let mut found = combine(formula, &inputs, settings).map_err(Refusal::file)?;
    if has_lines && found.kept < 0.25 {
        found.notes.push(format!(
            "The reference is almost dark between its lines: T is told at {} lines only.",
            found.points.len()
        ));
    }
    let names: Vec<String> = inputs
        .iter()
        .enumerate()
        .map(|(index, part)| format!("{} = {}", letter(index), part.name))
        .collect();
    let made_by = format!("{text}; {}", names.join("; "));
    let mut made = Found {
        notes: found.notes,
        step_nm: found.step_nm,
        first_nm: inputs
            .iter()
            .map(|part| part.samples.nm().to_vec())
            .collect(),
        lines: found.points.into_iter().map(LineRow::of_quotient).collect(),
        intervals: found.intervals,
        ..Found::of(found.result, made_by, from)
    };
    if let Some((composite, is_brought)) = sum_of(formula, parts) {
        if is_brought {
            let why = "Cosine and Fourier series are added through the 1 nm grid.";
            made.notes.push(why.to_owned());
        }
        made = of_composite(made, composite)?;
    }
    made.tell_lines();
    Ok(made)
}

/// The sum of composites on their own numbers, where the formula is one and all inputs are.
fn sum_of(formula: &Formula, parts: &[Part]) -> Option<(Composite, bool)> {
    let factors = formula.factors()?;
    let used = factors.iter().zip(parts).filter(|(by, _)| **by != 0.0);
    let used = used.map(|(by, part)| Some((*by, part.composite.as_deref()?)));
    sum_of_composites(&used.collect::<Option<Vec<_>>>()?)
}

/// A result that is a composite: its table and its lines are that one's.
fn of_composite(mut made: Found, composite: Composite) -> Result<Found, Refusal> {
    let band = composite.band();
    let samples = crate::spectrum::Sampled::new(band.grid().collect(), composite.on_band());
    let mut result = made.result().clone();
    result.samples = samples.map_err(Refusal::file)?;
    (result.sigma, result.mask) = (None, Vec::new());
    made.lines = composite
        .lines()
        .iter()
        .map(|line| LineRow::of_composite(line, composite.power()))
        .collect();
    made.step_nm = 1.0;
    made.result = Some(result);
    made.composite = Some(composite);
    Ok(made)
}

fn of_ranges(parts: &[Measurement], options: &Combine) -> Result<Found, Refusal> {
    let [first, second] = parts else {
        return Err(Refusal::Usage(
            "INPUT: expected 2 ranges of one light".to_owned(),
        ));
    };
    let is_sound = options.stated.axis == Some(0.0);
    let spliced = splice(first, second, is_sound).map_err(Refusal::file)?;
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
    found.tell_lines();
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
    if let Some(instrument) = found.instrument.as_ref().filter(|_| found.is_learnt) {
        if extension != "json" {
            return Err(Refusal::Usage(format!(
                "--out: found .{extension}, expected .json for an instrument"
            )));
        }
        return target.save(instruments::text(instrument).as_bytes());
    }
    if let Some(composite) = found.composite.clone().filter(|_| extension == "json") {
        let file = CompositeFile {
            composite,
            unit: result.unit.clone(),
            source: found.made_by.clone(),
            name: result.name.clone(),
            kind: result.quantity.kind(),
        };
        let text = composite_json(&file).map_err(Refusal::file)?;
        return target.save(text.as_bytes());
    }
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
