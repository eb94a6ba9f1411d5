//! `product`: a light through filters and off surfaces, in words or as JSON.

use std::{ffi::OsStr, io::Write, path::Path, sync::Arc};

use super::{
    arguments::Product,
    factor::FactorWord,
    inputs::Inputs,
    options::ModelOptions,
    print,
    refusal::Refusal,
    subject::{self, no_power, with_power},
};
use crate::{
    app::{
        App, Entry, Library,
        open::Wanted,
        pages::same_surface::{SameSurfaceSheet, check_json, check_text},
        product_report::{self, Told},
        products::{Link, ModelledLight},
        studies::reflectances,
    },
    io::{quoted, shown},
    spectrum::{Factor, Kind},
};

/// Carries the command out.
///
/// # Errors
/// [`Refusal`] for an input that cannot be read, a factor that is no share of light, and a group
/// without one.
pub(super) fn run(
    options: &Product,
    out: &mut dyn Write,
    inputs: &mut Inputs,
) -> Result<(), Refusal> {
    let Product {
        files: _,
        light: light_name,
        factors,
        set,
        check,
        kind,
        model,
        json,
    } = options;
    if set.is_some() && check.is_some() {
        return Err(Refusal::Usage(
            "--check: found --set too, expected FACTORs".to_owned(),
        ));
    }
    let text = match (&factors[..], set) {
        ([], None) => {
            return Err(Refusal::Usage(
                "found no FACTOR, expected at least one (or --set GROUP)".to_owned(),
            ));
        }
        ([_, ..], Some(_)) => {
            return Err(Refusal::Usage(
                "--set: found a FACTOR too, expected one of them".to_owned(),
            ));
        }
        ([], Some(_)) if kind.is_some() => {
            return Err(Refusal::Usage(
                "--kind: found --set too, expected files as FACTOR".to_owned(),
            ));
        }
        (factors, None) => {
            let chain: Vec<Link> = factors
                .iter()
                .map(|word| link(word, *kind, inputs))
                .collect::<Result<_, _>>()?;
            if kind.is_some() && chain.iter().all(|link| link.entry.shelf().is_some()) {
                inputs.note("--kind is not used: no FACTOR is a file");
            }
            let app = about(light_name, *model, inputs)?;
            if let Some(outgoing) = check {
                let outgoing = subject::light("--check", outgoing, inputs)?;
                return print(out, &of_check(&app, &chain, outgoing, *json));
            }
            let told = Told::of(&app, &ModelledLight::of(&app), &chain);
            if *json {
                let json = product_report::chain_json(&app, &told);
                format!("{json:#}\n")
            } else {
                product_report::chain_text(&app, &told)
            }
        }
        ([], Some(set)) => {
            let group = set.trim().to_lowercase();
            check_group(&group, set)?;
            let app = about(light_name, *model, inputs)?;
            of_set(&app, &group, *json)
        }
    };
    print(out, &text)
}

/// The reflection check; several factors are one surface after the other.
fn of_check(app: &App, chain: &[Link], found: Entry, json: bool) -> String {
    let band = app.document().settings.band;
    let names: Vec<String> = chain.iter().map(Link::words).collect();
    let mut surface = vec![1.0; band.points()];
    for link in chain {
        for (s, f) in surface.iter_mut().zip(link.on_band(band)) {
            *s *= f;
        }
    }
    let mut sheet = SameSurfaceSheet::against(app, &surface, &found.into());
    sheet.names[1] = names.join(", ");
    if json {
        format!("{:#}\n", check_json(app, &names, &sheet))
    } else {
        check_text(&sheet)
    }
}

fn of_set(app: &App, group: &str, json: bool) -> String {
    let (names, values) = reflectances(group, app.document().settings.band);
    let lit = ModelledLight::of(app);
    let factors: Vec<Factor> = values.into_iter().map(|v| lit.factor(v)).collect();
    let errors = lit.product().over(&factors);
    if json {
        let json = product_report::set_json(app, group, &names, &errors);
        format!("{json:#}\n")
    } else {
        product_report::set_text(app, group, &errors)
    }
}

/// The state about a light that has something to multiply.
fn about(word: &OsStr, model: ModelOptions, inputs: &mut Inputs) -> Result<App, Refusal> {
    let app = subject::about_light(subject::light("LIGHT", word, inputs)?, model);
    inputs.note_centres(model);
    with_power(&app)?;
    match app.derived().has_errors() {
        true => Ok(app),
        false => Err(no_power(&app)),
    }
}

/// A factor with its thickness and times.
fn link(word: &OsStr, kind: Option<Kind>, inputs: &mut Inputs) -> Result<Link, Refusal> {
    let parts = FactorWord::of(word)?;
    let entry = factor(parts.name, parts.spectrum, kind, inputs)?;
    parts.over(Link::once(Arc::new(entry)))
}

/// A reflectance or transmittance by its name. Only a file may be told what it is: a shipped
/// spectrum knows, and so does a file whose unit is one of power.
fn factor(
    name: &OsStr,
    spectrum: Option<&str>,
    kind: Option<Kind>,
    inputs: &mut Inputs,
) -> Result<Entry, Refusal> {
    let refused = |why: String| Refusal::File(format!("FACTOR: {why}"));
    let mut wanted = Wanted {
        spectrum,
        ..Wanted::default()
    };
    let found = inputs.find(name, &wanted).map_err(refused)?;
    let (named, is) = (shown(Path::new(name)), found.entry.kind());
    let Some(told) = kind.filter(|_| found.entry.shelf().is_none()) else {
        if !is.is_factor() {
            return Err(refused(format!("{named}: {}", no_factor(&found.entry))));
        }
        if found.is_kind_open {
            inputs.note(format!(
                "FACTOR: {named}: found nothing that says what its values are, taken as {is}"
            ));
        }
        return Ok(found.entry);
    };
    wanted.choices.kind = Some(told);
    let entry = inputs.find(name, &wanted).map_err(refused)?.entry;
    let unit = &entry.spectrum.unit;
    if !is_a_share(unit) {
        return Err(refused(format!(
            "{named}: found values in {}, expected shares of light (a light times a light has no \
             meaning)",
            quoted(unit)
        )));
    }
    if !found.is_kind_open && is != told {
        inputs.note(format!(
            "FACTOR: {named}: found {is} values, taken as {told} as --kind says"
        ));
    }
    Ok(entry)
}

/// Why a spectrum multiplies no light, and what would.
fn no_factor(entry: &Entry) -> String {
    let found = match entry.kind() {
        Kind::Light => "a light".to_owned(),
        kind => format!("{kind} values"),
    };
    let remedy = match entry.shelf() {
        Some(_) => "",
        None => " (say --kind if it is one)",
    };
    format!("found {found}, expected a reflectance or a transmittance{remedy}")
}

/// Whether a unit leaves room for shares: power has watts, lumens, photons or joules in it.
fn is_a_share(unit: &str) -> bool {
    const POWER: [&str; 8] = ["w", "mw", "uw", "µw", "kw", "lm", "photons", "j"];
    let unit = unit.to_lowercase();
    let mut words = unit.split(|c: char| !c.is_alphabetic());
    !words.any(|word| POWER.contains(&word) || word.starts_with("watt"))
}

/// Only reflectances and transmittances can be multiplied with a light.
fn check_group(group: &str, as_given: &str) -> Result<(), Refusal> {
    let Some(found) = Library::bundled().group(group) else {
        return Err(Refusal::File(format!(
            "--set: found {}, expected a group of reflectances or transmittances (see list)",
            quoted(as_given)
        )));
    };
    let mut spectra = found.items.iter().filter_map(|preset| preset.spectrum());
    if spectra.any(|spectrum| spectrum.kind.is_factor()) {
        return Ok(());
    }
    Err(Refusal::File(format!(
        "--set: found the group {group} without a reflectance or transmittance, expected a group \
         with one"
    )))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_of_power_is_told_from_a_share() {
        for share in ["", "1", "fraction", "relative", "%", "fraction, 2 mm"] {
            assert!(is_a_share(share), "{share}");
        }
        for power in [
            "W/m²/nm",
            "W m-2 nm-1",
            "mW/nm",
            "µW cm^-2",
            "lm/nm",
            "Watts",
        ] {
            assert!(!is_a_share(power), "{power}");
        }
    }
}
