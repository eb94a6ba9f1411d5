//! `rainbow`: where the bows of a light's spikes and of any wavelengths stand.

use std::io::Write;

use super::{
    arguments::Rainbow,
    inputs::Inputs,
    material::{clear_for, material},
    print, print_json,
    prism::{add_table, every_has_an_index, light_of, note_no_lines, sent},
    refusal::Refusal,
    subject,
};
use crate::optics::{Light, Material, rainbow_json};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a light or material that cannot be read, and nothing to tell of.
pub(super) fn run(
    options: &Rainbow,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Rainbow {
        input,
        files: _,
        at,
        material: word,
        model,
        as_modelled,
        json,
    } = options;
    let sent = sent(*as_modelled);
    let light = match input {
        Some(input) => {
            let light = subject::light("INPUT", input, inputs)?;
            inputs.note_centres(*model);
            Some(light_of(&subject::about_light(light, *model), sent)?)
        }
        None if at.is_empty() => {
            return Err(Refusal::Usage(
                "found no INPUT and no --at, expected one of them".to_owned(),
            ));
        }
        None => None,
    };
    let mut material = material(word, inputs)?;
    if let Some(light) = &light {
        material = clear_for(material, light)?;
    }
    if !*json {
        every_has_an_index(at, &material)?;
    }
    if let Some(light) = &light {
        note_no_lines(light, at, inputs);
    }
    if *json {
        let mut told = rainbow_json(&material, light.as_ref(), at);
        told["light_as"] = light.as_ref().map(|_| sent.word()).into();
        print_json(out, &told)
    } else {
        print(out, &words(&material, light.as_ref(), at))
    }
}

/// The angles in words, one line a wavelength.
fn words(material: &Material, light: Option<&Light>, at_nm: &[f64]) -> String {
    let whose = light.map_or_else(String::new, |light| format!("{}, ", light.name));
    let mut text = format!(
        "{whose}drops of {}: degrees from the point opposite the sun\n\n",
        material.name
    );
    let columns = [
        ("nm", "nm", 3),
        ("n", "n", 6),
        ("primary", "primary", 4),
        ("secondary", "secondary", 4),
    ];
    add_table(&mut text, &columns, &rainbow_json(material, light, at_nm));
    text
}
