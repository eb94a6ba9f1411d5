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
    print, print_json,
    refusal::Refusal,
    repeats::without_figures,
};
use crate::{
    app::{
        comparison::{self, Compared, Side},
        quality_report::{Modeller, full_json, json},
        readings::Reading,
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
    let (first, reading_a) = one("INPUT", input, options, inputs)?;
    let (second, reading_b) = one("--against", &other.to_owned(), options, inputs)?;
    let lights = [first, second];
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
    let figures = [
        (&compared.sides[0], &a, &reading_a),
        (&compared.sides[1], &b, &reading_b),
    ]
    .map(|(side, sheet, reading)| {
        let told = of(&side.name, &sheet.measured, Some(&sheet.model));
        without_figures(told, reading)
    });
    print_json(out, &comparison::json(&compared, figures))
}

/// The one light that a word means, and what its values tell of themselves; counts are none.
fn one(
    what: &'static str,
    word: &OsString,
    options: &Light,
    inputs: &mut Inputs,
) -> Result<(AskedLight, Reading), Refusal> {
    let name = shown(Path::new(word));
    let refused = |found: &str, remedy: &str| {
        let words = format!("{what}: {name}: found {found}, expected one light{remedy}");
        Err(Refusal::File(words))
    };
    if Path::new(word).is_dir() {
        return refused("a folder", "");
    }
    let mut asked = Asked::of(what, slice::from_ref(word), options.model, inputs);
    inputs.tell_refused(asked.refused)?;
    match (asked.lights.pop(), asked.lights.len()) {
        (Some(light), 0) => {
            let reading = Reading::of(&light.of.light().spectrum, options.stated.as_light);
            if reading.has_no_figures() {
                return refused("counts", " (--as-light takes them for one)");
            }
            Ok((light, reading))
        }
        (_, before) => refused(
            &format!("{} lights", before + 1),
            &format!(" ({name}#2 is the second)"),
        ),
    }
}
