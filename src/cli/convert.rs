//! `convert`: a spectrum, or its model, in another format.
//!
//! A composite that is written as a composite, with no option that changes it, keeps every bit.

use std::{io::Write, path::Path};

use super::{
    arguments::Convert,
    inputs::Inputs,
    print,
    refusal::Refusal,
    subject,
    target::{Replaces, Target},
    words::{self, Form},
};
use crate::{
    app::{
        Library, composite_from_preset, export,
        measured::{has_doubt, lost_of_measurement, measurement_as},
        open::{Loaded, Wanted, named::Several},
        ticks::short,
    },
    io::{
        self, Choices, Columns, CompositeFile, Provenance, WRITABLE, composite_in_words,
        composite_json, composite_line, losses, many::many, save_atomically, shown,
        stream::is_stream, write_as,
    },
    spectrum::NamedSpectrum,
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a form that cannot be written.
pub(super) fn run(
    options: &Convert,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let path = &options.out;
    let extension = words::extension(path);
    let known = WRITABLE.iter().map(|(known, _)| *known).chain([LINE]);
    words::with_extension(path.into(), &known.collect::<Vec<_>>())
        .map_err(|why| Refusal::Usage(format!("OUT: {why}")))?;
    let read = [Some(options.input.as_os_str())];
    let target = Target {
        what: "OUT",
        ..Target::out(path, Replaces::Nothing, options.force, &read)
    };
    target.path()?;
    let what = if options.all {
        all_spectra(options, &extension, &target, inputs)?
    } else {
        let kept = if is_of_models(&extension) {
            composite(options, inputs)
        } else {
            None
        };
        match form(options, &extension, kept.is_some())? {
            Form::Spectrum => spectrum(options, &target, inputs)?,
            Form::Composite => model(options, kept, &target, inputs)?,
        }
    };
    print(out, &format!("Wrote {}: {what}\n", shown(path)))
}

/// Extension of a model in one line of text.
const LINE: &str = "txt";

fn is_of_models(extension: &str) -> bool {
    ["json", LINE].contains(&extension)
}

/// What a file of samples says about itself.
fn provenance(scale_words: &str) -> Provenance {
    Provenance {
        program: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
        scale_words: scale_words.to_owned(),
        ..Provenance::default()
    }
}

/// Writes the samples of one spectrum.
///
/// # Errors
/// [`Refusal::File`] for what cannot be written.
pub(super) fn write_samples(
    target: &Target,
    spectrum: &NamedSpectrum,
    scale_words: &str,
) -> Result<(), Refusal> {
    let columns = Columns::measured(spectrum);
    write_as(target.path()?, spectrum, &columns, &provenance(scale_words)).map_err(Refusal::file)
}

/// Most notes told of a file of many spectra.
const MOST_NOTES: usize = 12;

/// What is meant by the input, whose file holds one spectrum or is told which.
fn wanted(options: &Convert) -> Wanted<'_> {
    Wanted {
        several: Several::Refused,
        ..options.pick.wanted()
    }
}

/// Decisions about a file whose numbers go into another file as they are.
fn as_they_are(options: &Convert) -> Choices {
    Choices {
        keep_photons: true,
        ..options.pick.wanted().choices
    }
}

/// Every spectrum of a file, side by side.
fn all_spectra(
    options: &Convert,
    extension: &str,
    target: &Target,
    inputs: &mut Inputs,
) -> Result<String, Refusal> {
    let usage = |words: String| Err(Refusal::Usage(words));
    if extension != "csv" {
        return usage(format!(
            "--all: found .{extension}, which holds one spectrum, expected OUT to end in .csv"
        ));
    }
    let pick = &options.pick;
    if pick.spectrum.is_some() || options.form.is_some() || options.model.is_given() {
        return usage(
            "--all: found an option that names one spectrum or a model, expected --all without it"
                .to_owned(),
        );
    }
    let input = Path::new(&options.input);
    let file = |why: String| Refusal::File(format!("{}: {why}", shown(input)));
    let spectra = match inputs.load(input, &as_they_are(options)) {
        Loaded::File(opened) => opened.into_spectra(),
        Loaded::Refused(why) => return Err(Refusal::File(why)),
        Loaded::Project { .. } => {
            return Err(file(
                "found a project, expected a file of spectra".to_owned(),
            ));
        }
    };
    let columns = Columns::together(&spectra).map_err(file)?;
    let mut about = spectra[0].clone();
    if spectra.len() > 1 {
        about.name = io::name_of(input);
        // Those of one spectrum are not those of all.
        about.notes.clear();
    }
    let provenance = provenance("as measured");
    write_as(target.path()?, &about, &columns, &provenance).map_err(Refusal::file)?;
    let what = format!(
        "{} ({}, {} wavelengths)",
        many(spectra.len(), "spectrum", "spectra"),
        about.kind,
        columns.nm.len()
    );
    let mut notes: Vec<String> = Vec::new();
    for note in spectra.iter().flat_map(|spectrum| &spectrum.notes) {
        if !notes.contains(note) && notes.len() < MOST_NOTES {
            notes.push(note.clone());
        }
    }
    if columns
        .columns
        .iter()
        .any(|c| c.values.iter().any(|v| v.is_nan()))
    {
        notes
            .push("their wavelengths differ: a cell is empty where a spectrum has none".to_owned());
    }
    Ok(with_notes(what, &notes))
}

fn form(options: &Convert, extension: &str, is_composite: bool) -> Result<Form, Refusal> {
    let name = options.out.to_string_lossy().to_lowercase();
    let form = options.form.unwrap_or_else(|| {
        let wanted = name.ends_with(".composite.json");
        if extension == LINE || extension == "json" && (wanted || is_composite) {
            Form::Composite
        } else {
            Form::Spectrum
        }
    });
    if form == Form::Composite && !is_of_models(extension) {
        return Err(Refusal::Usage(format!(
            "--as composite: found .{extension}, expected OUT to end in .json or .txt"
        )));
    }
    if form == Form::Spectrum && extension == LINE {
        return Err(Refusal::Usage(
            "--as spectrum: found .txt, which holds a model in one line, expected OUT to end in \
             .csv or another of the formats of spectra"
                .to_owned(),
        ));
    }
    if form == Form::Spectrum && options.model.is_given() {
        return Err(Refusal::Usage(
            "found options of a model and none to write, expected --as composite with them"
                .to_owned(),
        ));
    }
    if options.pick.light.is_some() {
        return Err(Refusal::Usage(
            "--light: found convert, which needs no light, expected another command".to_owned(),
        ));
    }
    Ok(form)
}

fn spectrum(options: &Convert, target: &Target, inputs: &mut Inputs) -> Result<String, Refusal> {
    let wanted = Wanted {
        choices: as_they_are(options),
        ..wanted(options)
    };
    let found = inputs.find(&options.input, &wanted);
    let entry = found.map_err(Refusal::File)?.entry;
    let spectrum = &entry.spectrum;
    let extension = words::extension(&options.out);
    let measured = entry.measured.as_deref().filter(|of| has_doubt(of));
    let kept = measured.and_then(|of| measurement_as(&extension, of, &spectrum.source));
    match kept {
        Some(text) => target.save(text.map_err(Refusal::File)?.as_bytes())?,
        None => write_samples(target, spectrum, "as measured")?,
    }
    let what = format!(
        "{} ({}, {} points)",
        spectrum.name,
        spectrum.kind,
        spectrum.samples.len()
    );
    // How it was read belongs to it: a guessed unit, or further spectra that were not written.
    let mut notes = losses(&extension, spectrum);
    notes.extend(measured.and_then(|of| lost_of_measurement(&extension, of)));
    notes.extend(spectrum.notes.iter().cloned());
    Ok(with_notes(what, &notes))
}

/// What was written, and what a person should know about it, a line each.
fn with_notes(mut what: String, notes: &[String]) -> String {
    for note in notes {
        what += "\nNote      ";
        what += note;
    }
    what
}

fn model(
    options: &Convert,
    kept: Option<CompositeFile>,
    target: &Target,
    inputs: &mut Inputs,
) -> Result<String, Refusal> {
    let (file, notes) = match kept {
        Some(file) if !options.model.is_given() => (file, Vec::new()),
        _ => {
            let (input, pick) = (&options.input, &options.pick);
            let app = subject::app_of(input, pick, &wanted(options), options.model, inputs)?;
            inputs.note_sampling(options.model);
            if !app.is_measured_in_range() {
                let spectrum = &app.document().subject_entry().spectrum;
                let band = app.derived().band;
                return Err(Refusal::File(format!(
                    "{}: found values of {}-{} nm, expected some in the model's range, {}-{} nm \
                     (say --range)",
                    spectrum.name,
                    short(spectrum.samples.first_nm()),
                    short(spectrum.samples.last_nm()),
                    band.min_nm(),
                    band.max_nm()
                )));
            }
            let spectrum = &app.document().subject_entry().spectrum;
            let notes = spectrum.notes.iter().chain(&app.derived().warnings);
            (export::composite_file(&app), notes.cloned().collect())
        }
    };
    let text = if words::extension(&options.out) == LINE {
        Ok(composite_line(&file.composite) + "\n")
    } else {
        composite_json(&file)
    };
    let path = target.path()?;
    text.and_then(|text| save_atomically(path, text.as_bytes()))
        .map_err(Refusal::file)?;
    let what = format!(
        "the model of {}, {}",
        file.name,
        composite_in_words(&file.composite)
    );
    Ok(with_notes(what, &notes))
}

/// The composite that an input is, if it is one: a file's or a preset's, of the kind that a person
/// may have told.
fn composite(options: &Convert, inputs: &mut Inputs) -> Option<CompositeFile> {
    let (path, pick) = (Path::new(&options.input), &options.pick);
    if pick.pixels().is_some() {
        return None;
    }
    if path.is_file() || is_stream(path) {
        let reading = inputs.reading(path, &as_they_are(options)).ok()?;
        let mut all = reading.composites;
        let index = match &pick.spectrum {
            _ if !reading.spectra.is_empty() => return None,
            None if all.len() == 1 => 0,
            None => return None,
            Some(pick) => all
                .iter()
                .position(|file| file.name == *pick)
                .or_else(|| pick.parse::<usize>().ok()?.checked_sub(1))?,
        };
        return (index < all.len()).then(|| all.swap_remove(index));
    }
    let preset = Library::bundled().find(options.input.to_str()?).ok()?;
    Some(CompositeFile {
        composite: composite_from_preset(preset.composite()?)?,
        unit: preset.unit.clone(),
        source: preset.source.clone(),
        name: preset.name.clone(),
        kind: pick.kind.unwrap_or(preset.kind),
    })
}
