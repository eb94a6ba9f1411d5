//! The report of one spectrum: what the command line prints, in words or as JSON.
//!
//! The JSON's keys are stable; docs/command_line.md tells them. A number that does not exist is
//! `null`, never NaN. Coefficients and weights are in the file's unit, whatever the scale switch
//! says.

use serde_json::{Map, Value, json};

use super::{
    absorption_names::{Curve, DarkFamily, dark_lines},
    answers::{Worst, verdict},
    derived::{Colour, Derived},
    figures::{ColourFigure, OF_COLOUR, OF_LIGHT, by_key},
    makers::{Beside, beside},
    state::App,
    surfaces::Surfaces,
    ticks::short,
    verdicts::Seen,
};
use crate::{
    io::many::{many, numbers},
    spectrum::{Basis, Exactness},
    study::Measure,
};

/// The report as JSON.
pub fn json(app: &App) -> Value {
    let (document, derived) = (app.document(), app.derived());
    let subject = document.subject_entry();
    let spectrum = &subject.spectrum;
    let mut notes = spectrum.notes.clone();
    notes.extend(derived.warnings.iter().cloned());
    let told = app.told();
    let family = told.and_then(|told| told.family);
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
        "about": told.map(|told| told.about.sentence()),
        "elements": told.map(|told| told.light.elements()),
        "dark_lines": dark_lines(curve).iter().map(dark_json).collect::<Vec<_>>(),
        "settings": settings_json(app),
        "model": model_json(app, derived),
        "error": shares()
            .map(|measure| (measure.figure().key.to_owned(), json!(derived.figures[measure])))
            .collect::<Map<_, _>>(),
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
        "surfaces": app.surfaces().map(|surfaces| json!({
            "count": surfaces.count,
            "beyond_1": surfaces.beyond_1,
            "delta_e_max": surfaces.delta_e_max,
            "worst": surfaces.worst,
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

/// The figures that are shares of the spectrum, in the order of files.
fn shares() -> impl Iterator<Item = Measure> {
    Measure::ALL
        .into_iter()
        .filter(|measure| !measure.is_colour())
}

/// The settings in force.
pub(super) fn settings_json(app: &App) -> Value {
    let (document, derived) = (app.document(), app.derived());
    let settings = document.settings;
    let mut all = json!(settings);
    if let Value::Object(all) = &mut all {
        for key in ["band", "wide_lines"] {
            all.remove(key);
        }
    }
    all["hand_edits"] = json!(!document.subject_edits().is_empty());
    all["colour_exact_reached"] = json!(derived.exactness.map(Exactness::is_exact));
    all["range_nm"] = json!([settings.band.min_nm(), settings.band.max_nm()]);
    // One's own is named, not written out.
    all["observer"] = json!(settings.observer.word());
    all["light"] = json!(document.light.name());
    all
}

fn model_json(app: &App, derived: &Derived) -> Value {
    let model = &derived.model;
    let lists = model.smooth().lists().into_iter();
    let coefficients: Value = lists.map(|(name, list)| (name, json!(list))).collect();
    let spikes: Vec<Value> = model
        .lines()
        .iter()
        .zip(app.spike_names())
        .map(|(line, name)| {
            let mut entry = json!({
                "at_nm": line.at_nm,
                "weight": line.weight,
                "share_of_power": derived.parts.share(line.weight),
                "line": name.safe,
                "label": name.label,
            });
            // Only where widths were asked for.
            if app.document().settings.wide_lines {
                entry["fwhm_nm"] = json!(line.fwhm_nm);
            }
            entry
        })
        .collect();
    json!({
        "as_given": app.document().as_given().is_some(),
        "range_nm": [derived.band.min_nm(), derived.band.max_nm()],
        "basis": model.smooth().basis.word(),
        "order": model.smooth().order(),
        "coefficients": coefficients,
        "spikes": spikes,
        "numbers": derived.numbers(),
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
    let mut all = json!({
        "srgb_hex": colour.map(|c| c.swatch.hex()),
        "in_srgb_gamut": colour.map(|c| c.swatch.in_gamut),
        "no_cct_because": cct.and_then(Result::err).map(|why| why.to_string()),
    });
    for figures in by_key(&OF_COLOUR).chain(by_key(&OF_LIGHT)) {
        let values = figures.iter().map(|f| (f.of)(&colour?));
        let values: Option<Vec<f64>> = values.collect();
        all[figures[0].figure.key] = match values.as_deref() {
            Some([value]) => json!(value),
            values => json!(values),
        };
    }
    all
}

fn share_words(share: Option<f64>) -> String {
    share.map_or_else(String::new, |share| {
        format!("{:6.2} % of the power", 100.0 * share)
    })
}

/// Known dark lines at their places: those that are seen, those that are too weak here, and what is
/// to be said of bands.
fn dark_words(curve: Curve<'_>, basis: Basis, family: &DarkFamily) -> Vec<String> {
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
    let advice = family.advice(curve, basis);
    words.extend(advice.map(|advice| format!("          {advice}")));
    words
}

/// The report for people.
pub fn text(app: &App) -> String {
    let derived = app.derived();
    let subject = app.document().subject_entry();
    let spectrum = &subject.spectrum;
    let unit = match spectrum.unit.as_str() {
        "" => String::new(),
        unit => format!(", {unit}"),
    };
    let mut lines = vec![format!(
        "{} ({}, {} points, {}-{} nm{unit})",
        spectrum.name,
        spectrum.kind,
        spectrum.samples.len(),
        short(spectrum.samples.first_nm()),
        short(spectrum.samples.last_nm()),
    )];
    if let Some(told) = app.told()
        && let Some(family) = told.family
    {
        lines.push(format!("Family    {}", family.title));
        lines.push(format!("About     {}", told.about.sentence()));
    }
    lines.extend(seen_lines(app));
    lines.extend(model_lines(app));
    let curve = Curve::of(subject, derived.band, &derived.measured);
    for family in dark_lines(curve) {
        let basis = app.document().settings.basis;
        lines.extend(dark_words(curve, basis, &family));
    }
    lines.extend(makers_lines(&beside(subject)));
    lines.push(format!("Error     {}", strict_words(app)));
    let notes = spectrum.notes.iter().chain(&derived.warnings);
    lines.extend(notes.map(|note| format!("Note      {note}")));
    lines.join("\n") + "\n"
}

/// The series and each spike of the model.
fn model_lines(app: &App) -> Vec<String> {
    let derived = app.derived();
    let model = &derived.model;
    let mut lines = vec![format!(
        "Series    {} order {} on {}-{} nm, {}: {}{}",
        model.smooth().basis.word(),
        model.smooth().order(),
        derived.band.min_nm(),
        derived.band.max_nm(),
        many(model.lines().len(), "spike", "spikes"),
        numbers(derived.numbers()),
        match derived.exactness {
            Some(Exactness::Exact { .. }) => ", colour-exact",
            _ => "",
        }
    )];
    for (spike, name) in model.lines().iter().zip(app.spike_names()) {
        lines.push(format!(
            "  spike   {:7.2} nm  {:>11}  {}  {}",
            spike.at_nm,
            short(spike.weight),
            share_words(derived.parts.share(spike.weight)),
            name.safe.as_deref().unwrap_or_default()
        ));
    }
    lines
}

/// What the spectra of model and measured light differ by, the strictest figures last: they compare
/// place by place what no eye keeps apart.
fn strict_words(app: &App) -> String {
    let figures = &app.derived().figures;
    let said: Option<String> = [
        Measure::RmsBlurred,
        Measure::Displacement,
        Measure::Energy,
        Measure::Lowest,
        Measure::Rms,
        Measure::MaxAbs,
    ]
    .into_iter()
    .map(|measure| Some(measure.figure().say(figures[measure]?)))
    .collect();
    said.unwrap_or_else(|| format!("none to speak of: {}", why_no_errors(app)))
}

/// What a person can see: how far the model's colours are off, and the colours.
fn seen_lines(app: &App) -> Vec<String> {
    let (document, derived) = (app.document(), app.derived());
    let colour = &derived.colour;
    let mut lines = Vec::new();
    if let Some(worst) = Worst::of(app) {
        let patch = worst.patch.map(|patch| format!(" ({patch})"));
        lines.push(format!(
            "Seen      {}: CIEDE2000 {:.3} at most{}",
            verdict(app, Seen::of(worst.delta_e_2000)),
            worst.delta_e_2000,
            patch.unwrap_or_default()
        ));
        let surfaces = app.surfaces().map(Surfaces::sentence);
        lines.extend(surfaces.map(|said| format!("          {said}")));
    }
    if let (Some(de), Some(duv)) = (colour.delta_e_2000, colour.delta_uv) {
        lines.push(format!(
            "Colour    CIEDE2000 {de:.3}, u'v' {duv:.5} ({}, Y of the light 100)",
            document.settings.observer.title()
        ));
    }
    if let Some(patches) = &derived.patches
        && let Some(worst) = patches.items.get(patches.worst)
    {
        lines.push(format!(
            "Patches   {} ({}): CIEDE2000 mean {:.3}, worst {:.3} ({})",
            document.patch_set,
            patches.items.len(),
            patches.mean,
            patches.max,
            worst.name
        ));
    }
    for (what, colour) in [
        ("Measured", colour.exact),
        ("Model", colour.model),
        ("360-830", colour.full),
    ] {
        let words = colour.map(|c| colour_words(&c, document.light.name()));
        lines.extend(words.map(|words| format!("{what:<10}{words}")));
    }
    lines
}

/// Why there are not all errors of a model: nothing, or more below zero than above.
fn why_no_errors(app: &App) -> String {
    let (subject, band) = (app.document().subject_entry(), app.derived().band);
    let samples = &subject.spectrum.samples;
    let points = samples.nm().iter().zip(samples.values());
    let values: Vec<f64> = points
        .filter(|(nm, _)| band.contains(**nm))
        .map(|(_, value)| *value)
        .collect();
    let below = values.iter().filter(|value| **value < 0.0).count();
    let above = values.iter().any(|value| *value > 0.0);
    match (below, above) {
        (0, false) => "there is nothing in the range".to_owned(),
        (0, true) => "the values in the range are too small to compute with".to_owned(),
        _ => format!(
            "{below} of {} values in the range are below zero",
            values.len()
        ),
    }
}

fn colour_words(colour: &Colour, light: &str) -> String {
    let said = |row: &ColourFigure| Some(row.figure.say((row.of)(colour)?));
    let figures = |all: &[ColourFigure]| all.iter().filter_map(said).collect::<String>();
    let gamut = match colour.swatch.in_gamut {
        true => "",
        false => " (out of sRGB)",
    };
    let why = match colour.cct {
        Some(Ok(_)) => String::new(),
        Some(Err(why)) => format!(", {why}"),
        None => format!(", under {light}"),
    };
    let (hex, of_light) = (colour.swatch.hex(), figures(&OF_LIGHT));
    format!("{}, {hex}{gamut}{why}{of_light}", figures(&OF_COLOUR))
}

/// The instrument's numbers beside ours, and those that stand alone.
fn makers_lines(rows: &[Beside]) -> Vec<String> {
    let (mut lines, mut alone) = (Vec::new(), Vec::new());
    for row in rows {
        let (name, theirs) = (row.quantity.to_string(), short(row.theirs));
        match row.ours {
            Ok(ours) => lines.push(format!(
                "Maker's   {name:<18} {theirs:>11}, ours {:>11} {}",
                short(ours),
                row.unit
            )),
            Err(_) => alone.push(format!("{name} {theirs}")),
        }
    }
    if !alone.is_empty() {
        lines.push(format!("Maker's   alone: {}", alone.join(", ")));
    }
    lines
}
