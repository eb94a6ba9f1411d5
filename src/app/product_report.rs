//! Light through filters and off surfaces: what the command line prints, in words or as JSON.
//!
//! The JSON's keys are stable; the README documents them. XYZ has the exact light's Y at 100, the
//! white of every difference is the exact light, and a number that does not exist is `null`.

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::{entry::Entry, report::settings_json, state::App, ticks::short};
use crate::{
    color::{Adaptation, Xyz, srgb::Swatch},
    spectrum::{Factor, Spike},
    study::{
        Spread,
        products::{Colours, Passage, Product, SetErrors, Step},
    },
};

/// Shares above this are no shares of light: bright fluorescent surfaces stay below.
const LARGEST_SHARE: f64 = 2.0;

/// The state's light and model, ready to be multiplied as its settings say.
pub fn product_of(app: &App) -> Product<'_> {
    let (derived, settings) = (app.derived(), app.document().settings);
    Product {
        measured: &derived.measured,
        model: &derived.model,
        sampling: settings.sampling,
        seen: &app.tables().viewing.weights,
        width_nm: settings.max_width_nm,
    }
}

/// A curve of shares on the model's grid; its dips are kept as spikes when the settings ask for
/// dips.
pub fn factor_of(app: &App, values: Vec<f64>) -> Factor {
    let settings = app.document().settings;
    if settings.dips && settings.spikes {
        Factor::keeping_dips(settings.band, values, settings.spike_settings())
    } else {
        Factor::new(values)
    }
}

/// A reflectance or transmittance as a factor of the state's light.
pub fn factor_of_entry(app: &App, entry: &Entry) -> Factor {
    factor_of(app, entry.on_band(app.document().settings.band))
}

/// A chain as JSON; `names` are those of the factors, in their order.
pub fn chain_json(app: &App, names: &[String], passage: &Passage) -> Value {
    let total = passage.total();
    let stages: Vec<Value> = names
        .iter()
        .zip(&passage.steps)
        .map(|(name, step)| stage_json(passage, name, step))
        .collect();
    let mut value = head_json(app);
    add(
        &mut value,
        json!({
            "factors": names,
            "delta_e_2000": total.colours.delta_e_2000,
            "luminance_error": total.colours.luminance_error,
            "added": total.added,
            "total": total.colours.delta_e_2000,
            "folded_share": total.folded_share,
            "multiplications": total.multiplications,
            "transmission": transmission_json(total.transmission),
            "exact": colour_json(passage, total.colours.exact),
            "model": colour_json(passage, total.colours.model),
            "stages": stages,
            "notes": notes(app, names, passage),
        }),
    );
    value
}

/// A light with every factor of a group as JSON.
pub fn set_json(app: &App, set: &str, names: &[String], errors: &SetErrors) -> Value {
    let each = names.iter().zip(&errors.each);
    let items: Vec<Value> = each
        .map(|(name, [added, total])| json!({ "name": name, "added": added, "total": total }))
        .collect();
    let mut value = head_json(app);
    add(
        &mut value,
        json!({
            "set": set,
            "count": errors.count,
            "added": spread_json(errors.added),
            "total": spread_json(errors.total),
            "items": items,
        }),
    );
    value
}

fn head_json(app: &App) -> Value {
    let light = &app.document().light.spectrum;
    json!({
        "program": { "name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION") },
        "light": { "name": light.name, "unit": light.unit, "source": light.source },
        "settings": settings_json(app),
        "sampling": app.document().settings.sampling.word(),
    })
}

fn add(value: &mut Value, more: Value) {
    if let (Value::Object(all), Value::Object(more)) = (value, more) {
        all.extend(more);
    }
}

fn stage_json(passage: &Passage, name: &str, step: &Step) -> Value {
    let Step {
        exact: _,
        smooth: _,
        spikes,
        colours,
        added,
        transmission,
        folded_share,
        multiplications,
        met,
        below_zero,
        turned,
    } = step;
    json!({
        "name": name,
        "delta_e_2000": colours.delta_e_2000,
        "luminance_error": colours.luminance_error,
        "added": added,
        "folded_share": folded_share,
        "multiplications": multiplications,
        "transmission": transmission_json(*transmission),
        "exact": colour_json(passage, colours.exact),
        "model": colour_json(passage, colours.model),
        "spikes": spikes
            .iter()
            .map(|Spike { at_nm, weight }| json!({ "at_nm": at_nm, "weight": weight }))
            .collect::<Vec<_>>(),
        "lines_on_dips": met
            .iter()
            .map(|met| json!({ "at_nm": met.line_nm, "dip_nm": met.dip_nm, "depth": met.depth }))
            .collect::<Vec<_>>(),
        "below_zero_nm": below_zero,
        "turned_negative_nm": turned,
    })
}

fn transmission_json([exact, model]: [Option<f64>; 2]) -> Value {
    json!({ "exact": exact, "model": model })
}

fn spread_json(spread: Option<Spread>) -> Value {
    json!({
        "median": spread.map(|s| s.median),
        "p95": spread.map(|s| s.p95),
        "worst": spread.map(|s| s.worst),
    })
}

/// XYZ with the exact light's Y at 100 and what the screen shows; `null` without a white.
fn colour_json(passage: &Passage, xyz: Xyz) -> Value {
    let Some((xyz, swatch)) = scaled(passage, xyz) else {
        return json!({ "xyz": null, "srgb_hex": null });
    };
    json!({ "xyz": xyz.to_array(), "srgb_hex": swatch.hex() })
}

fn scaled(passage: &Passage, xyz: Xyz) -> Option<(Xyz, Swatch)> {
    let white = passage.white.with_y(100.0)?;
    let xyz = xyz * (100.0 / passage.white.y);
    xyz.is_finite()
        .then(|| (xyz, Swatch::of_patch(xyz, white, Adaptation::None)))
}

/// What must be said about the result, a sentence each.
fn notes(app: &App, names: &[String], passage: &Passage) -> Vec<String> {
    let mut notes = app.derived().warnings.clone();
    let (mut before, mut said) = (&app.derived().measured, Vec::new());
    for (name, step) in names.iter().zip(&passage.steps) {
        let grown = before
            .iter()
            .zip(&step.exact)
            .any(|(before, after)| *before > 0.0 && *after > LARGEST_SHARE * before);
        if grown {
            notes.push(format!(
                "{name}: values above {LARGEST_SHARE}: a share of light is at most 1. Are they \
                 per cent?"
            ));
        }
        before = &step.exact;
        for met in &step.met {
            notes.push(format!(
                "{name}: the line at {:.1} nm stands on a dip at {:.1} nm {:.0} % deep; it is \
                 multiplied by what the dip lets through.",
                met.line_nm,
                met.dip_nm,
                100.0 * met.depth
            ));
        }
        for nm in step.below_zero.iter().chain(&step.turned) {
            // What is below zero at one stage is so at the next ones.
            if said.contains(nm) {
                continue;
            }
            said.push(*nm);
            notes.push(if step.turned.contains(nm) {
                format!(
                    "{name}: its series is below zero at {nm:.1} nm and turns the line there \
                     negative."
                )
            } else {
                format!("{name}: the dip at {nm:.1} nm takes the total below zero.")
            });
        }
    }
    notes
}

fn number(value: Option<f64>, digits: usize) -> String {
    value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
}

fn percent(share: Option<f64>) -> String {
    // Adding zero turns -0 into 0.
    share.map_or_else(
        || "-".to_owned(),
        |share| format!("{:.2} %", (1e4 * share).round() / 1e2 + 0.0),
    )
}

fn head_text(app: &App) -> String {
    let model = &app.derived().model;
    format!(
        "Light     {}\nModel     {} order {} on {}-{} nm, {} spike{}: {} numbers\nProducts  {}\n",
        app.document().light.name(),
        model.smooth.basis.word(),
        model.smooth.order(),
        short(model.band().min_nm()),
        short(model.band().max_nm()),
        model.spikes.len(),
        if model.spikes.len() == 1 { "" } else { "s" },
        model.numbers(),
        app.document().settings.sampling.word(),
    )
}

/// A chain for people.
pub fn chain_text(app: &App, names: &[String], passage: &Passage) -> String {
    let mut out = head_text(app);
    // Writing to a String cannot fail.
    let mut line = |text: String| {
        let _ = writeln!(out, "{text}");
    };
    let colours = |colours: &Colours| {
        format!(
            "CIEDE2000 {}, luminance {}",
            number(colours.delta_e_2000, 3),
            percent(colours.luminance_error)
        )
    };
    line(format!("Itself    {}", colours(&passage.light)));
    for (i, (name, step)) in names.iter().zip(&passage.steps).enumerate() {
        line(format!("{:<9} {name}", format!("Stage {}", i + 1)));
        line(format!(
            "  passes  {} (model {})",
            percent(step.transmission[0]),
            percent(step.transmission[1])
        ));
        line(format!(
            "  error   {}; {} of it added by forming the product",
            colours(&step.colours),
            number(step.added, 4)
        ));
        for spike in &step.spikes {
            line(format!(
                "  spike   {:7.2} nm  {:>11}",
                spike.at_nm,
                short(spike.weight)
            ));
        }
    }
    let total = passage.total();
    line(format!(
        "Total     {}; passes {}",
        colours(&total.colours),
        percent(total.transmission[0])
    ));
    line(format!(
        "Forming   adds CIEDE2000 {}, {} of the power folded or cut, {} multiplications",
        number(total.added, 4),
        percent(Some(total.folded_share)),
        total.multiplications
    ));
    for (what, xyz) in [
        ("Exact", total.colours.exact),
        ("Model", total.colours.model),
    ] {
        if let Some((xyz, swatch)) = scaled(passage, xyz) {
            line(format!(
                "{what:<9} XYZ {:.3} {:.3} {:.3}, {}",
                xyz.x,
                xyz.y,
                xyz.z,
                swatch.hex()
            ));
        }
    }
    for note in notes(app, names, passage) {
        line(format!("Note      {note}"));
    }
    out
}

/// A light with every factor of a group for people.
pub fn set_text(app: &App, set: &str, errors: &SetErrors) -> String {
    let mut out = head_text(app);
    let _ = writeln!(out, "Set       {set}, {} factors", errors.count);
    for (what, spread) in [("Added", errors.added), ("Total", errors.total)] {
        let _ = writeln!(
            out,
            "{what:<9} CIEDE2000 median {}, 95 % below {}, worst {}",
            number(spread.map(|s| s.median), 4),
            number(spread.map(|s| s.p95), 4),
            number(spread.map(|s| s.worst), 4)
        );
    }
    out
}
