//! `decode`: the spectrum that the words of `encode` stand for.

use std::{io::Write, path::Path};

use super::{
    arguments::Decode,
    convert::write_samples,
    inputs::Inputs,
    print,
    refusal::Refusal,
    target::{Replaces, Target},
    words::{extension, with_extension},
};
use crate::{
    io::{WRITABLE, losses, shown},
    lamps::{Decoder, EncodingError, Ingredients, decode_json, read_encoding},
    spectrum::{Band, Kind, NamedSpectrum, Sampled},
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for words that are no encoding, and a file that cannot be written.
pub(super) fn run(
    options: &Decode,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Decode {
        words,
        range,
        out: path,
        force,
        json,
    } = options;
    if path.is_none() && !json {
        return Err(Refusal::Usage(
            "found neither --out nor --json, expected a file to write the spectrum to".to_owned(),
        ));
    }
    let target = match path {
        Some(path) => Some(target(options, path, *force)?),
        None => None,
    };
    let text = text(options, inputs)?;
    let refused = |why: EncodingError| match why {
        EncodingError::Band { .. } => Refusal::Usage(format!(
            "--range: {why}, but {} says what was encoded",
            called(words)
        )),
        why => Refusal::File(format!("{}: {why}", called(words))),
    };
    let (encoding, read) = read_encoding(&text, *range).map_err(refused)?;
    let band = encoding.band();
    let values = Decoder::new(band).decode(&encoding).map_err(refused)?;
    let makeup = Ingredients::of(&encoding).in_words();
    let mut told = if *json {
        format!("{:#}\n", decode_json(&encoding, &read))
    } else {
        String::new()
    };
    if let Some(target) = target {
        let spectrum = spectrum(band, values, &makeup)?;
        write_samples(&target, &spectrum, "as encoded")?;
        let mut lines = vec![format!("Wrote {}: {makeup}", shown(target.path))];
        lines.extend(losses(&extension(target.path), &spectrum));
        if *json {
            lines.into_iter().for_each(|line| inputs.note(line));
        } else {
            told = lines.join("\nNote      ") + "\n";
        }
    }
    print(out, &told)
}

/// What messages call the words: the file, or the words themselves.
fn called(words: &[std::ffi::OsString]) -> String {
    match words {
        [one] if Path::new(one).exists() => shown(Path::new(one)),
        _ => "WORDS".to_owned(),
    }
}

fn target<'a>(options: &'a Decode, path: &'a Path, force: bool) -> Result<Target<'a>, Refusal> {
    with_extension(path.into(), &WRITABLE.map(|(extension, _)| extension))
        .map_err(|why| Refusal::Usage(format!("--out: {why}")))?;
    let words = options.words.iter();
    let read: Vec<_> = words.map(|word| Some(word.as_os_str())).collect();
    let target = Target::out(path, Replaces::Nothing, force, &read);
    target.path()?;
    Ok(target)
}

/// The text of the file, or the words as they were given.
fn text(options: &Decode, inputs: &mut Inputs) -> Result<String, Refusal> {
    if let [one] = &options.words[..]
        && (Path::new(one).exists() || one == "-")
    {
        return inputs.text(Path::new(one)).map_err(Refusal::File);
    }
    let words: Vec<_> = options.words.iter().map(|w| w.to_string_lossy()).collect();
    Ok(words.join(" "))
}

fn spectrum(band: Band, values: Vec<f64>, makeup: &str) -> Result<NamedSpectrum, Refusal> {
    let samples = Sampled::new(band.grid().collect(), values)
        .map_err(|why| Refusal::File(format!("WORDS: {why}")))?;
    Ok(NamedSpectrum {
        name: "decoded".to_owned(),
        kind: Kind::Light,
        unit: String::new(),
        scale: 1.0,
        samples,
        notes: vec![format!("decoded from {makeup}")],
        source: String::new(),
    })
}
