//! `fit`: tables of many spectra in few numbers each; lines of JSON one by one.

use std::{
    io::{BufRead, BufReader, Write},
    path::{Path, PathBuf},
};

use super::{
    arguments::Fit,
    folder::{files_in, spectra_of},
    inputs::Inputs,
    print, print_json,
    refusal::Refusal,
    target::{Replaces, Target},
    words::extension,
};
use crate::{
    app::{open::Loaded, ticks::short},
    io::{Choices, many::many, shown, stream::is_standard_input},
    pictures::{FitAsk, PictureError, ReferenceKind, fit_line, fit_spectra},
    spectrum::NamedSpectrum,
    study::Progress,
};

/// Most bytes of a line of JSON.
const MOST_LINE: u64 = 16 << 20;

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for spectra that cannot be read or do not go together, and a file that cannot be
/// written.
pub(super) fn run(options: &Fit, out: &mut dyn Write, inputs: &mut Inputs) -> Result<(), Refusal> {
    let ask = FitAsk {
        numbers: options.numbers,
        reference: options.reference,
        lines: options.lines,
    };
    let input = Path::new(&options.input);
    if is_standard_input(input) && options.out.is_none() {
        if options.reference != ReferenceKind::One {
            return Err(Refusal::Usage(format!(
                "--reference: found {}, which needs all spectra, expected one with lines of JSON, \
                 which are fitted one by one",
                options.reference.word()
            )));
        }
        return of_lines(ask, &mut std::io::stdin().lock(), out);
    }
    let Some(path) = &options.out else {
        return Err(Refusal::Usage(
            "found no --out, expected a file to write the numbers to".to_owned(),
        ));
    };
    let read = [Some(options.input.as_os_str())];
    let mut target = Target::out(path, Replaces::Nothing, options.force, &read);
    if input.is_dir() {
        files_in(input)?.iter().for_each(|file| target.reads(file));
    }
    target.path()?;
    let spectra = spectra(input, inputs)?;
    let first = &spectra[0].1;
    let kind = first.kind;
    if let Some((path, other)) = spectra.iter().find(|(_, spectrum)| spectrum.kind != kind) {
        return Err(Refusal::File(format!(
            "{}: {}: found {} values beside {kind} values, expected spectra of one kind",
            shown(path),
            other.name,
            other.kind
        )));
    }
    let tables: Vec<_> = spectra
        .iter()
        .map(|(_, s)| (s.name.clone(), &s.samples))
        .collect();
    let fitted = fit_spectra(&tables, kind, ask, &Progress::default());
    let fitted = fitted.map_err(|why| match why {
        PictureError::Numbers { .. } => Refusal::Usage(format!("--numbers: {why}")),
        why => Refusal::File(format!("{}: {why}", shown(input))),
    })?;
    note_cut(&spectra, inputs);
    let text = match extension(path).as_str() {
        "csv" => fitted.csv(),
        _ => format!("{:#}\n", fitted.json()),
    };
    target.save(text.as_bytes())?;
    let worst = fitted
        .relative_rms
        .iter()
        .flatten()
        .copied()
        .fold(0.0, f64::max);
    if options.json {
        let json = serde_json::json!({
            "spectra": spectra.len(),
            "numbers": fitted.operator.numbers(),
            "relative_rms": worst,
        });
        return print_json(out, &json);
    }
    print(
        out,
        &format!(
            "Wrote {}: {} in {} numbers each, relative rms at most {:.2} %\n",
            shown(path),
            many(spectra.len(), "spectrum", "spectra"),
            fitted.operator.numbers(),
            100.0 * worst
        ),
    )
}

/// A line out for each line in; one that is no spectrum is answered by why.
fn of_lines(ask: FitAsk, lines: &mut dyn BufRead, out: &mut dyn Write) -> Result<(), Refusal> {
    let mut lines = BufReader::new(lines);
    let mut line = Vec::new();
    loop {
        line.clear();
        let mut some = std::io::Read::take(&mut lines, MOST_LINE);
        let read = some.read_until(b'\n', &mut line);
        let read = read.map_err(|why| Refusal::File(format!("standard input: {why}")))?;
        if read == 0 {
            return out.flush().map_err(Refusal::Output);
        }
        let text = String::from_utf8_lossy(&line);
        if text.trim().is_empty() {
            // The lines out stand where those in stood.
            writeln!(out).map_err(Refusal::Output)?;
            continue;
        }
        let answer = fit_line(text.trim(), ask)
            .unwrap_or_else(|why| serde_json::json!({ "error": why.to_string() }).to_string());
        writeln!(out, "{answer}").map_err(Refusal::Output)?;
    }
}

/// Says how many spectra reach beyond the first, whose range is kept.
fn note_cut(spectra: &[(PathBuf, NamedSpectrum)], inputs: &mut Inputs) {
    let first = &spectra[0].1;
    let [least, most] = [first.samples.first_nm(), first.samples.last_nm()];
    let is_cut = |(_, s): &&(PathBuf, NamedSpectrum)| {
        s.samples.first_nm() < least || s.samples.last_nm() > most
    };
    let cut = spectra.iter().filter(is_cut).count();
    if cut > 0 {
        inputs.note(format!(
            "{} cut to {} to {} nm, the range of {}",
            many(cut, "spectrum is", "spectra are"),
            short(least),
            short(most),
            first.name
        ));
    }
}

/// The spectra of a file, or of all files of a folder, each with its file.
fn spectra(input: &Path, inputs: &mut Inputs) -> Result<Vec<(PathBuf, NamedSpectrum)>, Refusal> {
    let all = match input.is_dir() {
        true => spectra_of(&files_in(input)?, inputs),
        false => match inputs.load(input, &Choices::default()) {
            Loaded::File(opened) => {
                let spectra = opened.into_spectra().into_iter();
                spectra.map(|one| (input.to_owned(), one)).collect()
            }
            Loaded::Refused(why) => return Err(Refusal::File(why)),
            Loaded::Project { .. } => Vec::new(),
        },
    };
    if all.is_empty() {
        return Err(Refusal::File(format!(
            "{}: found no spectrum, expected at least one",
            shown(input)
        )));
    }
    Ok(all)
}
