//! `recover`: a spectrum from a colour, and a spectral picture from a picture of colours.

use std::{ffi::OsStr, fmt::Write as _, io::Write};

use super::{
    arguments::Recover,
    inputs::Inputs,
    print, print_json, recover_image,
    refusal::Refusal,
    subject,
    viewing::{OBSERVER, light},
};
use crate::{
    app::{
        Entry, Library,
        design::colour::{MERCURY_NM, UNDER},
    },
    color::{Adaptation, Lab, Srgb, Xyz},
    design::recover::{
        Colour, LineLight, LitColour, Method, Nearest, Prediction, Recovered, Seen, Viewing, json,
        line_light_json, metamers, predictions,
    },
    spectrum::Sampled,
};

/// The lamp whose smooth part stands behind the lines where no background is told.
const USUAL_BACKGROUND: &str = "cie_fluorescent_1nm/FL2";

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a light that cannot be read or shows no colours, and colours that do not fit
/// the method.
pub(super) fn run(
    options: &Recover,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    if let (Some(image), Some(path)) = (&options.image, &options.out) {
        return recover_image::run(options, image, path, out, inputs);
    }
    let method = options.method.unwrap_or_default();
    let Some(colour) = colour(options.colour, options.xyz, options.lab) else {
        return Err(Refusal::Usage(
            "found no --colour, --xyz, --lab or --image, expected one of them".to_owned(),
        ));
    };
    if method == Method::Lines {
        return of_lines(options, colour, out, inputs);
    }
    for (option, given) in [
        ("--lines", !options.lines.is_empty()),
        ("--background", options.background.is_some()),
    ] {
        if given {
            inputs.note(format!("{option} is not used: the method is not lines"));
        }
    }
    let mut views = vec![view(options.light.as_deref(), "--light", colour, inputs)?];
    match (second(options), &options.second_light) {
        (None, None) => {}
        (Some(colour), Some(light)) => {
            views.push(view(Some(light), "--second-light", colour, inputs)?);
        }
        (Some(_), None) => return Err(half("colour", "--second-light")),
        (None, Some(_)) => return Err(half("light", "--second-colour")),
    }
    let seen: Vec<Seen> = views.iter().map(View::seen).collect();
    let recovered = Recovered::new(method, &seen).map_err(Refusal::usage)?;
    let lights: Vec<(&str, Xyz)> = views
        .iter()
        .map(|view| (view.light.name(), view.viewing.white()))
        .collect();
    let band = metamers(&seen);
    let under = predictions(&recovered.reflectance, &under(), Adaptation::ToLight);
    note_nearest(
        "no surface has this colour under this light",
        "\u{394}E*ab",
        recovered.nearest.as_ref(),
        inputs,
    );
    if options.json {
        return print_json(out, &json(&recovered, &lights, band.as_ref(), &under));
    }
    print(out, &words(&recovered, &lights, &under))
}

/// The colour that one of three options tells.
fn colour(srgb: Option<Srgb>, xyz: Option<[f64; 3]>, lab: Option<[f64; 3]>) -> Option<Colour> {
    let of_xyz = || Some(Colour::Xyz(Xyz::from_array(xyz?)));
    let of_lab = || lab.map(|[l, a, b]| Colour::Lab(Lab::new(l, a, b)));
    srgb.map(Colour::Srgb).or_else(of_xyz).or_else(of_lab)
}

fn second(options: &Recover) -> Option<Colour> {
    let Recover {
        second_colour,
        second_xyz,
        second_lab,
        ..
    } = options;
    colour(*second_colour, *second_xyz, *second_lab)
}

fn half(what: &str, missing: &str) -> Refusal {
    Refusal::Usage(format!(
        "found a second {what} and no {missing}, expected both or neither"
    ))
}

/// A colour under a light.
struct View {
    light: Entry,
    viewing: Viewing,
    xyz: Xyz,
}

impl View {
    fn seen(&self) -> Seen<'_> {
        Seen {
            under: &self.viewing,
            xyz: self.xyz,
        }
    }
}

fn view(
    name: Option<&OsStr>,
    what: &str,
    colour: Colour,
    inputs: &mut Inputs,
) -> Result<View, Refusal> {
    let (light, viewing) = light(name, what, inputs)?;
    let xyz = colour.under(&viewing).map_err(Refusal::usage)?;
    Ok(View {
        light,
        viewing,
        xyz,
    })
}

/// The lights that a surface is looked at under.
fn under() -> Vec<(String, Viewing)> {
    let one = |id: &&str| {
        let preset = Library::bundled().find(id).ok()?;
        let samples = &preset.spectrum()?.samples;
        let viewing = Viewing::to_look(samples, OBSERVER).ok()?;
        Some((preset.name.clone(), viewing))
    };
    // Shipped lights are all there, which a test holds.
    UNDER.iter().filter_map(one).collect()
}

/// A light of lines over a background.
fn of_lines(
    options: &Recover,
    colour: Colour,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    if second(options).is_some() || options.second_light.is_some() {
        return Err(Refusal::Usage(
            "lines: found a second colour or light, expected one colour".to_owned(),
        ));
    }
    if options.light.is_some() {
        inputs.note("--light is not used: the method lines makes a light");
    }
    // A light's own colour is against no other white than the equal-energy one.
    // Rising places and finite values cannot be refused.
    let equal = Sampled::even(360.0, 1.0, vec![1.0; 471]).map_err(Refusal::usage)?;
    let viewing = Viewing::new(&equal, OBSERVER).map_err(Refusal::usage)?;
    let asked = LitColour {
        surface: None,
        xyz: colour.under(&viewing).map_err(Refusal::usage)?,
    };
    let places = match &options.lines[..] {
        [] => &MERCURY_NM[..],
        places => places,
    };
    let background = background(options, inputs)?;
    let light = LineLight::new(places, &background, &[asked], OBSERVER).map_err(Refusal::usage)?;
    note_nearest(
        "no mixture of these lines has this colour",
        "u'v'",
        light.nearest.as_ref(),
        inputs,
    );
    if options.json {
        return print_json(out, &line_light_json(&light, &[]));
    }
    let mut text = format!(
        "lines over a background; round trip {:.1e} \u{394}E\u{2080}\u{2080}, condition number {:.1e}\n\n",
        light.round_trip_delta_e, light.condition_number
    );
    for line in &light.lines {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{:>9.3} nm {:>12.6}", line.at_nm, line.weight);
    }
    let power: f64 = light.background.iter().sum();
    let _ = writeln!(text, "{:>12} {power:>12.6}", "background");
    print(out, &text)
}

/// Says why the nearest colour was taken, and how far off it is.
fn note_nearest(why: &str, measure: &str, nearest: Option<&Nearest>, inputs: &mut Inputs) {
    if let Some(nearest) = nearest {
        let worst = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
        inputs.note(format!(
            "{why}: the nearest by {measure} is {:.2} \u{394}E*ab off, which is {:.2} \
             \u{394}E\u{2080}\u{2080}",
            worst(&nearest.delta_e_ab),
            worst(&nearest.delta_e)
        ));
    }
}

/// The shape behind the lines.
fn background(options: &Recover, inputs: &mut Inputs) -> Result<Sampled, Refusal> {
    if let Some(word) = &options.background {
        return Ok(subject::light("--background", word, inputs)?
            .spectrum
            .samples);
    }
    let lamp = subject::light("--background", USUAL_BACKGROUND.as_ref(), inputs)?;
    let app = subject::about_light(lamp, super::options::ModelOptions::default());
    let derived = app.derived();
    // What a series takes below zero is no light.
    let values = derived.smooth.iter().map(|v| v.max(0.0)).collect();
    Sampled::even(derived.band.min_nm(), 1.0, values).map_err(Refusal::file)
}

/// The reflectance in words: what to trust it by, how it looks, its values every 20 nm.
fn words(recovered: &Recovered, lights: &[(&str, Xyz)], under: &[Prediction]) -> String {
    let names: Vec<&str> = lights.iter().map(|(name, _)| *name).collect();
    let [lowest, highest] = recovered.reflectance.extent();
    let inside = if recovered.is_inside_0_1() {
        "within 0-1"
    } else {
        "not within 0-1: no surface is so"
    };
    let mut text = format!(
        "{}, under {}\nround trip {:.1e} \u{394}E\u{2080}\u{2080}; from {lowest:.4} to {highest:.4}, {inside}\n",
        recovered.method,
        names.join(" and "),
        recovered.round_trip_delta_e,
    );
    // Writing to a string cannot fail.
    if let Some(condition) = recovered.condition_number {
        let _ = writeln!(text, "condition number {condition:.1e}");
    }
    for seen in under {
        let _ = writeln!(text, "{:>10}  {}", seen.light, seen.swatch.hex());
    }
    text.push('\n');
    let table = recovered.reflectance.sampled();
    for (nm, value) in table.nm().iter().zip(table.values()) {
        if nm % 20.0 == 0.0 {
            let _ = writeln!(text, "{nm:>6} nm {value:>9.5}");
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_light_to_look_under_is_shipped() {
        assert_eq!(under().len(), UNDER.len());
    }
}
