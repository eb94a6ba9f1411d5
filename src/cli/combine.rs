//! `combine`: sums, quotients, means of scans with their doubt, slits, spliced ranges, and what
//! changed between two sets.

use std::{
    ffi::{OsStr, OsString},
    io::Write,
};

use super::{
    arguments::Combine,
    combine_inputs::read,
    combine_instrument, combine_json,
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    room_words::Grid,
    target::{Replaces, Target},
    words,
};
use crate::{
    app::{
        combining::{self, Found, Part, measurements, of_change, words as combined_words},
        instruments,
        measured::{lost_of_measurement, measurement_as, measurement_csv, spectrum},
    },
    io::{Columns, CompositeFile, Provenance, composite_json, write_as},
    measurements::{Formula, Kernel, letter, resampled},
};

/// Most inputs: as many as there are letters.
const MOST_INPUTS: usize = 26;

/// The words that stand in place of a formula.
const WORDS: &str = "mean, splice, slit, unslit, changed, instrument";

/// What is done with the inputs.
enum Act {
    /// A spectrum is made; of a formula with as many inputs.
    Made(combining::Act, usize),
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
    let is_of_scans = matches!(
        act,
        Act::Changed | Act::Made(combining::Act::Mean { .. }, _)
    );
    let made = match &act {
        Act::Use => Some(combine_instrument::read(&files.remove(0), inputs)?),
        Act::Made(act, _) => Some(act.clone()),
        Act::Changed | Act::Learn => None,
    };
    let parts = of_files(&files, is_of_scans, options, inputs)?;
    let found = match made {
        Some(act) => act.of(&parts).map_err(Refusal::File)?,
        None if matches!(act, Act::Learn) => combine_instrument::learnt(&parts, options, inputs)?,
        None => {
            let others = of_files(&options.others, true, options, inputs)?;
            if options.out.is_some() || options.csv {
                inputs.note("--out and --csv are not used: changed makes no spectrum");
            }
            let [first, second] = [measurements(&parts), measurements(&others)];
            let found = of_change(&first, &second, options.keep_all).map_err(Refusal::File)?;
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

/// The inputs that words mean.
fn of_files(
    files: &[OsString],
    is_of_scans: bool,
    options: &Combine,
    inputs: &mut Inputs,
) -> Result<Vec<Part>, Refusal> {
    let mut parts = Vec::new();
    for file in files {
        parts.extend(read(file, is_of_scans, options.stated, inputs)?);
    }
    Ok(parts)
}

/// Prints what was found; notes stand in JSON and in the words.
fn told(options: &Combine, found: &Found, out: &mut dyn Write) -> Result<(), Refusal> {
    match options.json {
        true => print_json(out, &combine_json::json(found)),
        false => print(out, &combined_words::text(found)),
    }
}

/// What is to be done, and the words that name inputs.
fn understood(options: &Combine) -> Result<(Act, Vec<OsString>), Refusal> {
    let usage = |why: String| Refusal::Usage(format!("FORMULA: {why}"));
    let word = options.formula.to_str().unwrap_or_default().trim();
    let mut files = options.inputs.clone();
    let keep_all = options.keep_all;
    let act = match word {
        "mean" => Act::Made(combining::Act::Mean { keep_all }, 1),
        "splice" => {
            let is_sound = options.stated.axis == Some(0.0);
            Act::Made(combining::Act::Splice { is_sound }, 2)
        }
        "changed" => Act::Changed,
        "slit" => {
            let Some(fwhm_nm) = width(files.first()) else {
                return Err(usage(
                    "found slit without a width, expected one in nm behind it".to_owned(),
                ));
            };
            files.remove(0);
            let shape = shape(&mut files).unwrap_or(Kernel::Triangle);
            Act::Made(combining::Act::Slit { fwhm_nm, shape }, 1)
        }
        "unslit" => {
            let fwhm_nm = width(files.first());
            let is_auto = files.first().is_some_and(|word| word == "auto");
            if fwhm_nm.is_some() || is_auto {
                files.remove(0);
            }
            let shape = shape(&mut files).unwrap_or(Kernel::Gauss);
            Act::Made(combining::Act::Unslit { fwhm_nm, shape }, 1)
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
            let formula = Formula::parse(&text).map_err(|why| {
                usage(
                    match word.starts_with(|c: char| "ABC(-0123456789".contains(c)) {
                        true => why.to_string(),
                        false => format!("{why}, or alone one of the words {WORDS}"),
                    },
                )
            })?;
            let least = formula.inputs().max(1);
            let formula = combining::Act::Formula {
                text,
                keep_all,
                equal: options.equal,
                of_surface: options.reflectance,
            };
            Act::Made(formula, least)
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
    use combining::Act as Made;
    let (least, most) = match act {
        Act::Made(Made::Formula { .. }, least) => (*least, MOST_INPUTS),
        Act::Made(Made::Mean { .. }, _) => (1, usize::MAX),
        Act::Made(_, number) => (*number, *number),
        Act::Learn => (1, 2),
        Act::Use => (2, 3),
        Act::Changed if options.others.is_empty() => (usize::MAX, usize::MAX),
        Act::Changed => (1, usize::MAX),
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
            Act::Made(Made::Formula { .. } | Made::Mean { .. }, _) =>
                format!("one for each letter up to {}", letter(least - 1)),
            Act::Made(..) => least.to_string(),
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
    if let Some(text) = measurement_as(&extension, result, &found.made_by) {
        return target.save(text.map_err(Refusal::File)?.as_bytes());
    }
    let named = spectrum(result, &found.made_by);
    if let Some(lost) = lost_of_measurement(&extension, result) {
        inputs.note(lost);
    }
    let provenance = Provenance {
        program: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
        scale_words: "as measured".to_owned(),
        ..Provenance::default()
    };
    let columns = Columns::measured(&named);
    write_as(target.path()?, &named, &columns, &provenance).map_err(Refusal::file)
}
