//! `rainbow`: where the bows of a light's spikes and of any wavelengths stand.

use std::io::Write;

use super::{
    arguments::Rainbow,
    inputs::Inputs,
    material::material,
    print, print_json,
    prism::{add_table, every_has_an_index, light_of, note_no_lines},
    refusal::Refusal,
    subject::{self, named_light},
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
        json,
    } = options;
    let light = match input {
        Some(input) => {
            let light = named_light("INPUT", input, inputs)?;
            inputs.note_centres(*model);
            Some(light_of(&subject::about_light(light, *model))?)
        }
        None if at.is_empty() => {
            return Err(Refusal::Usage(
                "found no INPUT and no --at, expected one of them".to_owned(),
            ));
        }
        None => None,
    };
    let material = material(word, inputs)?;
    if !*json {
        every_has_an_index(at, &material)?;
    }
    if let Some(light) = &light {
        note_no_lines(light, at, inputs);
    }
    if *json {
        print_json(out, &rainbow_json(&material, light.as_ref(), at))
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
