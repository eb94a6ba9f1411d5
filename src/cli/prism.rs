//! `prism`: where a light's spikes and any wavelengths land behind a prism.

use std::{fmt::Write as _, io::Write};

use serde_json::Value;

use super::{
    arguments::Prism,
    inputs::Inputs,
    material::{absorption_of, clear_for, material, note_extrapolated},
    print,
    refusal::Refusal,
    subject::{self, with_power},
};
use crate::{
    app::{App, dispersion::Sent, ticks::short},
    optics::{Bench, BenchSettings, Incidence, Light, Material, Strip, prism_csv, prism_json},
};

/// Columns of the screen that the light is put on to see what falls beside it.
const COLUMNS: usize = 1000;

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for a light or material that cannot be read, and a bench that lets no light leave.
pub(super) fn run(
    options: &Prism,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let light = subject::light("INPUT", &options.input, inputs)?;
    let app = subject::about_light(light, options.model);
    inputs.note_centres(options.model);
    let sent = sent(options.as_modelled);
    let light = light_of(&app, sent)?;
    let material = clear_for(material(&options.material, inputs)?, &light)?;
    if !options.json {
        every_has_an_index(&options.at, &material)?;
    }
    note_no_lines(&light, &options.at, inputs);
    let absorption = absorption_of(options.filter.as_ref(), options.thickness, inputs)?;
    let settings = BenchSettings {
        apex_deg: options.apex,
        incidence: match options.incidence {
            Some(degrees) => Incidence::Degrees(degrees),
            None => Incidence::MinimumFor(options.minimum),
        },
        entry_mm: options.entry,
        screen_mm: options.screen,
        slit_mm: options.slit,
        reference_nm: options.reference,
        absorption,
    };
    let bench = Bench::new(settings, material).map_err(Refusal::usage)?;
    let observer = app.document().settings.observer;
    let strip = bench
        .whole_screen(&light, COLUMNS)
        .map(|screen| bench.strip(&light, screen, observer));
    if strip.as_ref().is_some_and(|strip| strip.extrapolated) {
        note_extrapolated(bench.material(), inputs);
    }
    let text = match (options.json, options.csv) {
        (true, _) => {
            let mut json = prism_json(&bench, &light, &options.at, strip.as_ref());
            json["light_as"] = sent.word().into();
            format!("{json:#}\n")
        }
        (_, true) => prism_csv(&bench, &light, &options.at),
        _ => words(&bench, &light, &options.at, strip.as_ref()),
    };
    print(out, &text)
}

/// What `--as-modelled` asks to send through.
pub(super) fn sent(as_modelled: bool) -> Sent {
    if as_modelled {
        Sent::Model
    } else {
        Sent::Measured
    }
}

/// The document's light as the rooms of optics take it.
///
/// # Errors
/// [`Refusal::File`] for a light that nothing is seen of.
pub(super) fn light_of(app: &App, sent: Sent) -> Result<Light, Refusal> {
    with_power(app)?;
    let light = sent.light(app.document().light.name(), app.derived());
    light.map_err(Refusal::file)
}

/// Refuses the first wavelength of `--at` that a material has no index for.
///
/// # Errors
/// [`Refusal::Usage`] with the wavelength, and the range that was expected.
pub(super) fn every_has_an_index(at_nm: &[f64], material: &Material) -> Result<(), Refusal> {
    let mut refused = at_nm.iter().filter_map(|nm| material.index(*nm).err());
    match refused.next() {
        Some(why) => Err(Refusal::Usage(format!("--at: {why}"))),
        None => Ok(()),
    }
}

/// Says why there is nothing to tell of.
pub(super) fn note_no_lines(light: &Light, at_nm: &[f64], inputs: &mut Inputs) {
    if light.spikes().is_empty() && at_nm.is_empty() {
        inputs.note(format!(
            "{}: its model has no lines, only a smooth band; --at NM tells of any wavelength",
            light.name
        ));
    }
}

/// The figures in words: the bench, one line a wavelength, what does not leave.
fn words(bench: &Bench, light: &Light, at_nm: &[f64], strip: Option<&Strip>) -> String {
    let json = prism_json(bench, light, at_nm, strip);
    let (prism, settings) = (bench.prism(), bench.settings());
    let mut text = format!(
        "{} through {}, apex {}\u{b0}, met at {:.3}\u{b0}\n\
         slit {} mm, screen {} mm behind, across the way of {} nm\n\n",
        light.name,
        bench.material().name,
        short(prism.apex_deg()),
        prism.incidence_deg(),
        short(settings.slit_mm),
        short(settings.screen_mm),
        bench.reference_nm(),
    );
    let columns = [
        ("nm", "nm", 3),
        ("n", "n", 6),
        ("deviation", "deviation", 5),
        ("least", "minimum_deviation", 5),
        ("x mm", "x_mm", 4),
        ("width mm", "width_mm", 4),
        ("through", "transmittance", 4),
        ("resolving", "resolving_power", 0),
    ];
    add_table(&mut text, &columns, &json);
    if let Some(words) = bench.reflected_words() {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{words}");
    }
    text
}

/// The rows of a JSON's `at` under titles, each with its key and digits, and why others are none.
pub(super) fn add_table(text: &mut String, columns: &[(&str, &str, usize)], json: &Value) {
    let mut line = |cells: Vec<String>| {
        let cells: Vec<String> = cells.iter().map(|cell| format!("{cell:>11}")).collect();
        // Writing to a string cannot fail.
        let _ = writeln!(text, "{}", cells.concat());
    };
    line(columns.iter().map(|column| column.0.to_owned()).collect());
    for row in json["at"].as_array().into_iter().flatten() {
        let cell = |&(_, key, digits): &(&str, &str, usize)| match row[key].as_f64() {
            Some(value) => format!("{value:.digits$}"),
            None => "-".to_owned(),
        };
        line(columns.iter().map(cell).collect());
    }
    for row in json["refused"].as_array().into_iter().flatten() {
        let _ = writeln!(text, "{}", row["why"].as_str().unwrap_or_default());
    }
}
