//! `convert`: a spectrum, or its model, in another format.
//!
//! A composite that is written as a composite, with no option that changes it, keeps every bit.

use std::{io::Write, path::Path};

use super::{
    arguments::{Convert, Form},
    print,
    refusal::Refusal,
    subject, words,
};
use crate::{
    app::{entry::composite_from_preset, export, library::Library, open},
    io::{
        self, CompositeFile, Provenance,
        atomic::save_atomically,
        composite_json,
        write::{Columns, WRITABLE},
        write_as,
    },
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read or a form that cannot be written.
pub fn run(options: &Convert, out: &mut dyn Write, err: &mut dyn Write) -> Result<(), Refusal> {
    let path = &options.out;
    let extension = words::extension(path);
    if !WRITABLE.iter().any(|(known, _)| *known == extension) {
        let known: Vec<String> = WRITABLE.iter().map(|(e, _)| format!(".{e}")).collect();
        return Err(Refusal::Usage(format!(
            "OUT: found {}, expected a file that ends in {}",
            io::error::quoted(&path.to_string_lossy()),
            known.join(" or ")
        )));
    }
    let pick = options.pick.spectrum.as_deref();
    let kept = if extension == "json" {
        composite(&options.input, pick)
    } else {
        None
    };
    let what = match form(options, &extension, kept.is_some())? {
        Form::Spectrum => spectrum(options)?,
        Form::Composite => model(options, kept, err)?,
    };
    print(out, &format!("Wrote {}: {what}\n", path.display()))
}

fn form(options: &Convert, extension: &str, is_composite: bool) -> Result<Form, Refusal> {
    let name = options.out.to_string_lossy().to_lowercase();
    let form = options.form.unwrap_or_else(|| {
        let wanted = name.ends_with(".composite.json");
        if extension == "json" && (wanted || is_composite) {
            Form::Composite
        } else {
            Form::Spectrum
        }
    });
    if form == Form::Composite && extension != "json" {
        return Err(Refusal::Usage(format!(
            "--as composite: found .{extension}, expected OUT to end in .json"
        )));
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

fn spectrum(options: &Convert) -> Result<String, Refusal> {
    let pick = &options.pick;
    let entry = open::resolve_pixels(
        &options.input,
        pick.spectrum.as_deref(),
        pick.pixels(),
        pick.kind,
    )
    .map_err(Refusal::File)?;
    let spectrum = &entry.spectrum;
    let provenance = Provenance {
        program: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
        source: String::new(),
        scale_words: "as measured".to_owned(),
        settings: String::new(),
    };
    write_as(
        &options.out,
        spectrum,
        &Columns::measured(spectrum),
        &provenance,
    )
    .map_err(|why| Refusal::File(why.to_string()))?;
    let mut what = format!(
        "{} ({}, {} points)",
        spectrum.name,
        spectrum.kind,
        spectrum.samples.len()
    );
    // How it was read belongs to it: a guessed unit, or further spectra that were not written.
    for note in &spectrum.notes {
        what += "\nNote      ";
        what += note;
    }
    Ok(what)
}

fn model(
    options: &Convert,
    kept: Option<CompositeFile>,
    err: &mut dyn Write,
) -> Result<String, Refusal> {
    let file = match kept {
        Some(file) if !options.model.is_given() => file,
        _ => {
            let app = subject::app(&options.input, &options.pick, options.model, err)?;
            export::composite_file(&app)
        }
    };
    composite_json::write(&file)
        .and_then(|text| save_atomically(&options.out, text.as_bytes()))
        .map_err(|why| Refusal::File(why.to_string()))?;
    Ok(format!(
        "the model of {}, {}",
        file.name,
        composite_json::in_words(&file.composite)
    ))
}

/// The composite that an input is, if it is one: a file's or a preset's.
fn composite(input: &str, pick: Option<&str>) -> Option<CompositeFile> {
    let path = Path::new(input);
    if path.is_file() {
        let reading = io::read_path(path).ok()?;
        if !reading.spectra.is_empty() {
            return None;
        }
        let mut all = reading.composites;
        let index = match pick {
            None => 0,
            Some(pick) => all
                .iter()
                .position(|file| file.name == pick)
                .or_else(|| pick.parse::<usize>().ok()?.checked_sub(1))?,
        };
        return (index < all.len()).then(|| all.swap_remove(index));
    }
    let preset = Library::bundled().find(input).ok()?;
    Some(CompositeFile {
        composite: composite_from_preset(preset.composite()?)?,
        unit: preset.unit.clone(),
        source: preset.source.clone(),
        name: preset.name.clone(),
    })
}
