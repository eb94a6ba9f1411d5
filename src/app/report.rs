//! The report of one spectrum: what the command line prints, in words or as JSON.
//!
//! The JSON's keys are stable; docs/command_line.md tells them. A number that does not exist is
//! `null`, never NaN. Coefficients and weights are in the file's unit, whatever the scale switch
//! says.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{
    about::{self, About},
    absorption_names::{Curve, DarkFamily, dark_lines},
    derived::{Colour, Derived},
    makers::{Beside, beside},
    state::App,
};
use crate::{
    io::many::{many, numbers},
    spectrum::{Basis, Exactness},
};

/// The report as JSON.
pub fn json(app: &App) -> Value {
    let (document, derived) = (app.document(), app.derived());
    let subject = document.subject_entry();
    let spectrum = &subject.spectrum;
    let mut notes = spectrum.notes.clone();
    notes.extend(derived.warnings.iter().cloned());
    let light = app.identified();
    let family = about::family(subject, light);
    let curve = Curve::of(subject, derived.band, &derived.measured);
    json!({
        "program": { "name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION") },
        "input": {
            "name": spectrum.name,
            "kind": spectrum.kind.word(),
            "unit": spectrum.unit,
            "scale": spectrum.scale,
            "points": spectrum.samples.len(),
            "first_nm": spectrum.samples.first_nm(),
            "last_nm": spectrum.samples.last_nm(),
            "source": spectrum.source,
            "notes": notes,
        },
        "family": family.map(|family| &family.key),
        "family_title": family.map(|family| &family.title),
        "about": About::of(subject).sentence(),
        "elements": light.elements(),
        "dark_lines": dark_lines(curve).iter().map(dark_json).collect::<Vec<_>>(),
        "settings": settings_json(app),
        "model": model_json(app, derived),
        "error": {
            "relative_rms": derived.errors.map(|e| e.relative_rms),
            "relative_rms_10nm": derived.errors.map(|e| e.relative_rms_10nm),
            "max_abs": derived.errors.map(|e| e.max_abs),
            "energy": derived.errors.map(|e| e.energy),
            "lowest": derived.errors.map(|e| e.lowest),
        },
        "colour": {
            "exact": colour_json(derived.colour.exact),
            "model": colour_json(derived.colour.model),
            "full": colour_json(derived.colour.full),
            "delta_e_2000": derived.colour.delta_e_2000,
            "delta_uv": derived.colour.delta_uv,
        },
        "makers_results": beside(subject).iter().map(makers_json).collect::<Vec<_>>(),
        "patches": derived.patches.as_ref().map(|patches| json!({
            "set": document.patch_set,
            "delta_e_mean": patches.mean,
            "delta_e_max": patches.max,
            "items": patches.items.iter().map(|p| json!({
                "name": p.name,
                "delta_e": p.delta_e_2000,
                "exact_hex": p.exact_swatch.hex(),
                "model_hex": p.model_swatch.hex(),
            })).collect::<Vec<_>>(),
        })),
    })
}

fn dark_json(family: &DarkFamily) -> Value {
    json!({
        "family": family.title,
        "bands": family.are_bands,
        "lines": family.lines.iter().map(|line| json!({
            "name": line.name,
            "from_nm": line.nm[0],
            "to_nm": line.nm[1],
            "depth": line.depth,
            "seen": line.is_seen,
        })).collect::<Vec<_>>(),
    })
}

/// The settings in force.
pub(super) fn settings_json(app: &App) -> Value {
    let (document, derived) = (app.document(), app.derived());
    let settings = document.settings;
    json!({
        "basis": settings.basis.word(),
        "order": settings.order,
        "spikes": settings.spikes,
        "threshold_percent": settings.threshold_percent,
        "max_width_nm": settings.max_width_nm,
        "dips": settings.dips,
        "detector": settings.detector,
        "gradient_percent": settings.gradient_percent,
        "hand_edits": !document.subject_edits().is_empty(),
        "colour_exact": settings.colour_exact,
        "colour_exact_reached": derived.exactness.map(Exactness::is_exact),
        "range_nm": [settings.band.min_nm(), settings.band.max_nm()],
        "observer": settings.observer.word(),
        "sampling": settings.sampling.word(),
        "light": document.light.name(),
    })
}

fn model_json(app: &App, derived: &Derived) -> Value {
    let model = &derived.model;
    let coefficients = match model.smooth.basis {
        Basis::Fourier => {
            let (a, b) = model.smooth.a_b();
            json!({ "a": a, "b": b })
        }
        Basis::Cosine => json!({ "c": model.smooth.coefficients }),
    };
    let spikes: Vec<Value> = model
        .spikes
        .iter()
        .zip(app.spike_names())
        .map(|(spike, name)| {
            json!({
                "at_nm": spike.at_nm,
                "weight": spike.weight,
                "share_of_power": derived.parts.share(spike.weight),
                "line": name.safe,
                "label": name.label,
            })
        })
        .collect();
    json!({
        "range_nm": [derived.band.min_nm(), derived.band.max_nm()],
        "basis": model.smooth.basis.word(),
        "order": model.smooth.order(),
        "coefficients": coefficients,
        "spikes": spikes,
        "numbers": model.numbers(),
    })
}

/// The instrument's number beside ours.
fn makers_json(row: &Beside) -> Value {
    let Beside {
        quantity,
        unit,
        theirs,
        ours,
        told_to: _,
    } = row;
    json!({
        "quantity": quantity.to_string(),
        "unit": unit,
        "theirs": theirs,
        "ours": ours.ok(),
    })
}

fn colour_json(colour: Option<Colour>) -> Value {
    let cct = colour.and_then(|c| c.cct);
    json!({
        "xyz": colour.map(|c| c.xyz.to_array()),
        "xy": colour.map(|c| c.xy),
        "uv": colour.map(|c| c.uv),
        "srgb_hex": colour.map(|c| c.swatch.hex()),
        "in_srgb_gamut": colour.map(|c| c.swatch.in_gamut),
        "cct": cct.and_then(Result::ok).map(|c| c.kelvin),
        "duv": cct.and_then(Result::ok).map(|c| c.duv),
        "no_cct_because": cct.and_then(Result::err).map(|why| why.to_string()),
    })
}

fn share_words(share: Option<f64>) -> String {
    share.map_or_else(String::new, |share| {
        format!("{:6.2} % of the power", 100.0 * share)
    })
}

/// Known dark lines at their places: those that are seen, those that are too weak here, and what is
/// to be said of bands.
fn dark_words(app: &App, family: &DarkFamily) -> Vec<String> {
    let derived = app.derived();
    let list = |seen: bool| -> String {
        let lines = family.lines.iter().filter(|line| line.is_seen == seen);
        let words = lines.map(|line| match seen {
            true => format!("{} {:.0} %", line.name, 100.0 * line.depth),
            false => line.name.to_owned(),
        });
        words.collect::<Vec<_>>().join(", ")
    };
    let mut words = vec![format!("Dark      {}: {}", family.title, list(true))];
    let weak = list(false);
    if !weak.is_empty() {
        words.push(format!("          known, too weak here: {weak}"));
    }
    let curve = Curve::of(
        app.document().subject_entry(),
        derived.band,
        &derived.measured,
    );
    let advice = family.advice(curve, app.document().settings.basis);
    words.extend(advice.map(|advice| format!("          {advice}")));
    words
}

/// The report for people.
pub fn text(app: &App) -> String {
    let (document, derived) = (app.document(), app.derived());
    let subject = document.subject_entry();
    let spectrum = &subject.spectrum;
    let settings = document.settings;
    let model = &derived.model;
    let mut out = String::new();
    // Writing to a String cannot fail.
    let mut line = |text: String| {
        let _ = writeln!(out, "{text}");
    };
    line(format!(
        "{} ({}, {} points, {}-{} nm{})",
        spectrum.name,
        spectrum.kind,
        spectrum.samples.len(),
        super::ticks::short(spectrum.samples.first_nm()),
        super::ticks::short(spectrum.samples.last_nm()),
        if spectrum.unit.is_empty() {
            String::new()
        } else {
            format!(", {}", spectrum.unit)
        }
    ));
    if let Some(family) = about::family(subject, app.identified()) {
        line(format!("Family    {}", family.title));
        line(format!("About     {}", About::of(subject).sentence()));
    }
    line(format!(
        "Model     {} order {} on {}-{} nm, {}: {}{}",
        model.smooth.basis.word(),
        model.smooth.order(),
        derived.band.min_nm(),
        derived.band.max_nm(),
        many(model.spikes.len(), "spike", "spikes"),
        numbers(model.numbers()),
        match derived.exactness {
            Some(Exactness::Exact { .. }) => ", colour-exact",
            _ => "",
        }
    ));
    for (spike, name) in model.spikes.iter().zip(app.spike_names()) {
        line(format!(
            "  spike   {:7.2} nm  {:>11}  {}  {}",
            spike.at_nm,
            super::ticks::short(spike.weight),
            share_words(derived.parts.share(spike.weight)),
            name.safe
                .as_deref()
                .or(name.near.as_deref())
                .unwrap_or_default()
        ));
    }
    for family in dark_lines(Curve::of(subject, derived.band, &derived.measured)) {
        dark_words(app, &family).into_iter().for_each(&mut line);
    }
    match derived.errors {
        Some(e) => line(format!(
            "Error     {:.2} % rms at 1 nm, {:.2} % behind a 10 nm blur, {:.2} % at most, energy {:+.3} %, lowest {:.2} %",
            100.0 * e.relative_rms,
            100.0 * e.relative_rms_10nm,
            100.0 * e.max_abs,
            // Adding zero turns -0 into 0.
            (1e5 * e.energy).round() / 1e3 + 0.0,
            100.0 * e.lowest
        )),
        None => line("Error     none to speak of: there is nothing in the range".to_owned()),
    }
    let mut colour_line = |what: &str, colour: Option<Colour>| {
        let Some(c) = colour else {
            return;
        };
        let cct = match c.cct {
            Some(Ok(cct)) => format!("{:.0} K, Duv {:+.4}", cct.kelvin, cct.duv),
            Some(Err(why)) => why.to_string(),
            None => format!("under {}", document.light.name()),
        };
        line(format!(
            "{what}XYZ {:.3} {:.3} {:.3}, xy {:.4} {:.4}, {}{}, {cct}",
            c.xyz.x,
            c.xyz.y,
            c.xyz.z,
            c.xy[0],
            c.xy[1],
            c.swatch.hex(),
            if c.swatch.in_gamut {
                ""
            } else {
                " (out of sRGB)"
            },
        ));
    };
    colour_line("Measured  ", derived.colour.exact);
    colour_line("Model     ", derived.colour.model);
    colour_line("360-830   ", derived.colour.full);
    if let (Some(de), Some(duv)) = (derived.colour.delta_e_2000, derived.colour.delta_uv) {
        line(format!(
            "Colour    CIEDE2000 {de:.3}, u'v' {duv:.5} ({}, Y of the light 100)",
            settings.observer.title()
        ));
    }
    if let Some(patches) = &derived.patches
        && let Some(worst) = patches.items.get(patches.worst)
    {
        line(format!(
            "Patches   {} ({}): CIEDE2000 mean {:.3}, worst {:.3} ({})",
            document.patch_set,
            patches.items.len(),
            patches.mean,
            patches.max,
            worst.name
        ));
    }
    let rows = beside(subject);
    for row in rows.iter().filter(|row| row.ours.is_ok()) {
        let Ok(ours) = row.ours else { continue };
        line(format!(
            "Maker's   {:<18} {:>11}, ours {:>11} {}",
            row.quantity.to_string(),
            super::ticks::short(row.theirs),
            super::ticks::short(ours),
            row.unit
        ));
    }
    let alone = rows.iter().filter(|row| row.ours.is_err());
    let alone: Vec<String> = alone
        .map(|row| format!("{} {}", row.quantity, super::ticks::short(row.theirs)))
        .collect();
    if !alone.is_empty() {
        line(format!("Maker's   alone: {}", alone.join(", ")));
    }
    for note in spectrum.notes.iter().chain(&derived.warnings) {
        line(format!("Note      {note}"));
    }
    out
}
