//! What bodies are made of and what they absorb, by the words of the command line.

use std::{
    ffi::{OsStr, OsString},
    path::Path,
};

use super::{inputs::Inputs, refusal::Refusal, words};
use crate::{
    app::{
        dispersion::{is_index, material_of},
        open::Wanted,
        ticks::short,
    },
    io::{Choices, quoted, shown},
    optics::{Absorption, BuiltinMaterial, Light, Material},
    spectrum::Kind,
};

/// The material of `--material`: a word, `n_d,V_d`, or a file with a curve of n.
///
/// # Errors
/// [`Refusal`] for another word, a file without such a curve and numbers that are no material.
pub(super) fn material(word: &OsStr, inputs: &mut Inputs) -> Result<Material, Refusal> {
    let text = word.to_string_lossy();
    if let Some(stuff) = BuiltinMaterial::from_word(&text) {
        return Ok(stuff.material());
    }
    let path = Path::new(word);
    if let ("yml" | "yaml", true) = (words::extension(path).as_str(), path.exists()) {
        return of_file(path, inputs);
    }
    if let Some([n_d, v_d]) = words::numbers_with_commas(&text).as_deref() {
        let material = Material::from_two_numbers(*n_d, *v_d);
        return material.map_err(|why| Refusal::Usage(format!("--material: {why}")));
    }
    let known: Vec<&str> = BuiltinMaterial::ALL
        .into_iter()
        .map(BuiltinMaterial::word)
        .collect();
    Err(Refusal::Usage(format!(
        "--material: found {}, expected {}, n_d,V_d or a .yml file",
        quoted(&text),
        known.join(", ")
    )))
}

fn of_file(path: &Path, inputs: &mut Inputs) -> Result<Material, Refusal> {
    let reading = inputs.reading(path, &Choices::default());
    let reading = reading.map_err(|why| Refusal::File(format!("--material: {why}")))?;
    let Some(curve) = reading.spectra.iter().find(|s| is_index(s)) else {
        return Err(Refusal::File(format!(
            "--material: {}: found no curve of n, expected one",
            shown(path)
        )));
    };
    let material = material_of(curve, reading.spectra.iter());
    material.map_err(|why| Refusal::File(format!("--material: {}: {why}", shown(path))))
}

/// Refuses a material that is not transparent for a light: metals, dyes, what absorbs there.
///
/// # Errors
/// [`Refusal::File`] with the wavelength, n and k.
pub(super) fn clear_for(material: Material, light: &Light) -> Result<Material, Refusal> {
    match material.not_transparent_for(light) {
        Some(why) => Err(Refusal::File(format!("--material: {why}"))),
        None => Ok(material),
    }
}

/// Says beyond which wavelengths a material's index is extrapolated.
pub(super) fn note_extrapolated(material: &Material, inputs: &mut Inputs) {
    if let Some([from, to]) = material.published_nm {
        inputs.note(format!(
            "{}: the index was published for {} to {} nm, beyond them it is extrapolated",
            material.name,
            short(from),
            short(to)
        ));
    }
}

/// What a filter of a thickness absorbs a unit of length; nothing without a filter.
///
/// # Errors
/// [`Refusal`] for what cannot be read or is no transmittance, and a thickness that is none.
pub(super) fn absorption_of(
    filter: Option<&OsString>,
    thickness: Option<f64>,
    inputs: &mut Inputs,
) -> Result<Absorption, Refusal> {
    let (Some(name), Some(thickness)) = (filter, thickness) else {
        return Ok(Absorption::None);
    };
    let refused = |why: String| Refusal::File(format!("--filter: {why}"));
    let mut wanted = Wanted::default();
    let mut found = inputs.find(name, &wanted).map_err(refused)?;
    let named = shown(Path::new(name));
    if found.is_kind_open && found.entry.kind() != Kind::Transmittance {
        wanted.choices.kind = Some(Kind::Transmittance);
        found = inputs.find(name, &wanted).map_err(refused)?;
        inputs.note(format!(
            "--filter: {named}: found nothing that says what its values are, taken as \
             transmittance"
        ));
    }
    if found.entry.kind() != Kind::Transmittance {
        return Err(refused(format!(
            "{named}: found {} values, expected a transmittance",
            found.entry.kind()
        )));
    }
    let absorption = Absorption::of_filter(&found.entry.spectrum.samples, thickness)
        .map_err(|why| Refusal::Usage(format!("--{why}")))?;
    if absorption.is_floored() {
        inputs.note(format!(
            "--filter: {named}: found transmittances below 1e-6, taken as 1e-6"
        ));
    }
    Ok(absorption)
}
