//! `photo`: photographs of spectra, their axes and their spectra.

use std::{fmt::Write as _, io::Write, path::Path};

use serde_json::{Value, json};

use super::{
    arguments::Photo,
    inputs::Inputs,
    photo_words, print, print_json,
    refusal::Refusal,
    subject,
    target::{Replaces, Target},
};
use crate::{
    app::photograph::{self, Instrument, Kept, Known, Photograph, Said, Source},
    io::{name_of, shown, why_unopened},
    photographs::strip::ByHand,
};

/// Exit codes of an axis that is only suggested, and of none.
const SUGGESTED: u8 = 3;
const NOTHING: u8 = 4;

/// The longest file of an instrument.
const MOST_BYTES: u64 = 4 << 20;

/// Carries the command out, and gives its exit code.
///
/// # Errors
/// [`Refusal::Usage`] for a picture that cannot be read, a strip that is not there, pins that make
/// no axis; [`Refusal::File`] for what cannot be written.
pub(super) fn run(
    options: &Photo,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<u8, Refusal> {
    let table = target(options, "--out", options.out.as_deref())?;
    let keeps = target(
        options,
        "--save-instrument",
        options.save_instrument.as_deref(),
    )?;
    let said = said(options)?;
    let known = known(options, inputs)?;
    let mut told = String::new();
    let mut values = Vec::new();
    let mut code = 0;
    for file in &options.files {
        let one = one(options, &said, known.as_ref(), file);
        let (photograph, response) = match one {
            Ok(read) => read,
            // Of several pictures one that cannot be read hides no other.
            Err(why) if options.files.len() > 1 => {
                code = code.max(2);
                values.push(json!({ "file": shown(file), "refused": &why }));
                inputs.note(why);
                continue;
            }
            Err(why) => return Err(Refusal::Usage(why)),
        };
        code = code.max(code_of(&photograph));
        let mut written = Vec::new();
        if let (Some(target), Some(rows)) = (&table, photograph::table(&photograph)) {
            target.save(rows.csv().as_bytes())?;
            written.push(shown(target.path));
        }
        if let Some(target) = &keeps
            && let Some(kept) = Instrument::of(&photograph, &name_of(target.path), response)
        {
            target.save(kept.text().as_bytes())?;
            written.push(shown(target.path));
        }
        if options.json {
            values.push(photograph::json(&photograph, &options.at));
        } else {
            told += &words(&photograph, &options.at);
            for path in written {
                // Writing to a string cannot fail.
                let _ = writeln!(told, "Wrote {path}");
            }
        }
    }
    if code != 0 && (table.is_some() || keeps.is_some()) {
        inputs.note("nothing is written: no axis is known");
    }
    match (options.json, values.len()) {
        (true, 1) => print_json(out, &values[0])?,
        (true, _) => print_json(out, &Value::Array(values))?,
        _ => print(out, &told)?,
    }
    Ok(code)
}

/// One of the pictures, read through a response where there is one.
fn one(
    options: &Photo,
    said: &Said,
    known: Option<&Known>,
    file: &Path,
) -> Result<(Photograph, Option<Kept>), String> {
    let mut photograph = photograph::read(file, said)?;
    let response = response(options, known, said, &mut photograph, file)?;
    photograph.read_through(response.as_ref());
    Ok((photograph, response))
}

/// Where something is written to, which is about one picture.
fn target<'o>(
    options: &'o Photo,
    what: &'static str,
    path: Option<&'o Path>,
) -> Result<Option<Target<'o>>, Refusal> {
    let Some(path) = path else {
        return Ok(None);
    };
    if options.files.len() > 1 {
        return Err(Refusal::Usage(format!(
            "{what}: found {} pictures, expected one of them",
            options.files.len()
        )));
    }
    let mut target = Target {
        what,
        ..Target::out(path, Replaces::Nothing, options.force, &[])
    };
    let read = options
        .files
        .iter()
        .chain(&options.response_from)
        .chain(&options.instrument);
    read.for_each(|file| target.reads(file));
    target.path()?;
    Ok(Some(target))
}

/// The light that `--as` names.
fn known(options: &Photo, inputs: &mut Inputs) -> Result<Option<Known>, Refusal> {
    let Some(word) = &options.known else {
        return Ok(None);
    };
    if let Some(known) = word.to_str().and_then(photo_words::of_kelvin) {
        return known
            .map(Some)
            .map_err(|why| Refusal::Usage(format!("--as: {why}")));
    }
    let entry = subject::light("--as", word, inputs)?;
    let samples = entry.spectrum.samples.clone();
    Ok(Some(Known::Spectrum(entry.name().to_owned(), samples)))
}

/// The response that a picture is read through: learnt now, or that of the instrument.
fn response(
    options: &Photo,
    known: Option<&Known>,
    said: &Said,
    photograph: &mut Photograph,
    file: &Path,
) -> Result<Option<Kept>, String> {
    match (&options.response_from, known) {
        (Some(path), Some(known)) if photograph.used_curve().is_some() => {
            Kept::learn(path, known, photograph, Some(file)).map(Some)
        }
        (Some(_), _) => Ok(None),
        _ => Ok(said.instrument.as_ref().and_then(|i| i.response.clone())),
    }
}

fn said(options: &Photo) -> Result<Said, Refusal> {
    let instrument = options.instrument.as_deref().map(|path| {
        let refused = |why: String| Refusal::Usage(format!("{}: {why}", shown(path)));
        let about = std::fs::metadata(path).map_err(|why| refused(why_unopened(path, &why).0))?;
        if about.len() > MOST_BYTES {
            return Err(refused(
                "found more than 4 MiB, expected an instrument".to_owned(),
            ));
        }
        let text =
            std::fs::read_to_string(path).map_err(|why| refused(why_unopened(path, &why).0))?;
        Instrument::read(&text).map_err(refused)
    });
    Ok(Said {
        strip: ByHand {
            is_vertical: match (options.vertical, options.horizontal) {
                (true, _) => Some(true),
                (_, true) => Some(false),
                _ => None,
            },
            area: options.area,
            turn_deg: options.turn,
            shear: options.shear,
            smile: options.smile,
            is_one_row: options.one_row,
            strip: options.strip,
        },
        falls: match (options.flip, options.no_flip) {
            (true, _) => Some(true),
            (_, true) => Some(false),
            _ => None,
        },
        is_linear: options.linear,
        exposures: options.exposures.clone(),
        lamp: options.lamp,
        pins: options.pin.clone(),
        yes: options.yes,
        instrument: instrument.transpose()?,
    })
}

fn code_of(photograph: &Photograph) -> u8 {
    match photograph.source() {
        Source::Nothing => NOTHING,
        _ if photograph.is_open() => SUGGESTED,
        _ => 0,
    }
}

/// The figures in words.
fn words(photograph: &Photograph, at: &[[f64; 2]]) -> String {
    let strip = photograph.found.strip;
    let [width, height] = photograph.size;
    let way = if strip.is_vertical {
        "from top to bottom"
    } else {
        "from left to right"
    };
    let mut text = format!(
        "{}: {width} x {height} px, {} columns {way}, turned by {:.2}\u{b0}\n{}\n",
        photograph.file,
        strip.columns,
        strip.turn_deg,
        photograph::sentence(photograph),
    );
    if let Some((low, high)) = photograph.valid_nm() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "The axis holds from {low:.0} to {high:.0} nm.");
    }
    if let Some((fwhm, nm)) = photograph.resolution() {
        let _ = writeln!(text, "Resolution {fwhm:.1} nm at {nm:.0}.");
    }
    let json = photograph::json(photograph, at);
    for place in json["at"].as_array().into_iter().flatten() {
        let nm = match (place["nm"].as_f64(), place["sigma_nm"].as_f64()) {
            (Some(nm), Some(sigma)) => format!("{nm:.2} nm, {sigma:.2} nm sure"),
            _ => "no wavelength is known there".to_owned(),
        };
        let _ = writeln!(text, "at {},{}: {nm}", place["x"], place["y"]);
    }
    if let Some(figures) = photograph::colour_words(photograph) {
        let _ = writeln!(text, "{figures}");
    }
    for warning in photograph::warnings(photograph) {
        let _ = writeln!(text, "{warning}");
    }
    text
}
