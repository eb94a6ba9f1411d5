//! `light --against`: which of two lights is better for what.

use std::{
    ffi::{OsStr, OsString},
    io::Write,
    path::Path,
    slice,
};

use super::{
    arguments::Light,
    asked_lights::{Asked, AskedLight},
    inputs::Inputs,
    options::ModelOptions,
    print, print_json,
    refusal::Refusal,
};
use crate::{
    app::{
        comparison::{self, Compared, Side},
        quality_report::{Modeller, full_json, json},
    },
    io::shown,
};

/// Compares the one INPUT of the command with another light.
///
/// # Errors
/// [`Refusal`] where either is refused or is not one light.
pub(super) fn run(
    options: &Light,
    other: &OsStr,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let [input] = &options.lights[..] else {
        let count = options.lights.len();
        return Err(Refusal::Usage(format!(
            "--against: found {count} INPUTs, expected one"
        )));
    };
    let lights = [
        one("INPUT", input, options.model, inputs)?,
        one("--against", &other.to_owned(), options.model, inputs)?,
    ];
    for light in &lights {
        light.note_coarse(inputs);
    }
    // Two tables of one lamp have one name; their words tell them apart.
    let is_one_name = lights[0].names[0] == lights[1].names[0];
    let names = lights
        .each_ref()
        .map(|light| light.names[usize::from(is_one_name)].clone());
    let [name_a, name_b] = names;
    let spectra = lights.each_ref().map(|light| &light.of.light().spectrum);
    if !options.json {
        let sides = [Side::of(name_a, spectra[0]), Side::of(name_b, spectra[1])];
        return print(out, &comparison::text(&Compared::of(sides)));
    }
    let modeller = Modeller::new(lights[0].of.light().clone(), options.model.settings());
    let [a, b] = [
        lights[0].sheet(name_a, &modeller),
        lights[1].sheet(name_b, &modeller),
    ];
    let compared = Compared::of([
        Side::new(a.name.clone(), spectra[0], a.measured.clone()),
        Side::new(b.name.clone(), spectra[1], b.measured.clone()),
    ]);
    let of = if options.full { full_json } else { json };
    let figures = [(&compared.sides[0], &a), (&compared.sides[1], &b)]
        .map(|(side, sheet)| of(&side.name, &sheet.measured, Some(&sheet.model)));
    print_json(out, &comparison::json(&compared, figures))
}

/// The one light that a word means.
fn one(
    what: &'static str,
    word: &OsString,
    model: ModelOptions,
    inputs: &mut Inputs,
) -> Result<AskedLight, Refusal> {
    let name = shown(Path::new(word));
    let refused = |found: &str, remedy: &str| {
        let words = format!("{what}: {name}: found {found}, expected one light{remedy}");
        Err(Refusal::File(words))
    };
    if Path::new(word).is_dir() {
        return refused("a folder", "");
    }
    let mut asked = Asked::of(what, slice::from_ref(word), model, inputs);
    inputs.tell_refused(asked.refused)?;
    match (asked.lights.pop(), asked.lights.len()) {
        (Some(light), 0) => Ok(light),
        (_, before) => refused(
            &format!("{} lights", before + 1),
            &format!(" ({name}#2 is the second)"),
        ),
    }
}
