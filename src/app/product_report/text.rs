//! The same for people.

use std::fmt::Write as _;

use super::{Told, notes, scaled};
use crate::{
    app::{
        numbers::{decimals, share_words},
        state::App,
        ticks::short,
    },
    io::many::{many, numbers},
    spectrum::Sampling,
    study::products::{Colours, SetErrors},
};

fn head_text(app: &App) -> String {
    let model = &app.derived().model;
    format!(
        "Light     {}\nModel     {} order {} on {}-{} nm, {}: {}\nProducts  {}\n",
        app.document().light.name(),
        model.smooth().basis.word(),
        model.smooth().order(),
        short(model.band().min_nm()),
        short(model.band().max_nm()),
        many(model.lines().len(), "spike", "spikes"),
        numbers(model.numbers()),
        app.document().settings.sampling.word(),
    )
}

/// A chain for people.
pub fn chain_text(app: &App, told: &Told) -> String {
    let Told {
        remarks: _,
        names,
        known,
        passage,
    } = told;
    let mut out = head_text(app);
    // Writing to a String cannot fail.
    let mut line = |text: String| {
        let _ = writeln!(out, "{text}");
    };
    let colours = |colours: &Colours| {
        format!(
            "CIEDE2000 {}, luminance {}",
            decimals(colours.delta_e_2000, 3),
            share_words(colours.luminance_error)
        )
    };
    line(format!("Itself    {}", colours(&passage.light)));
    for (i, (name, step)) in names.iter().zip(&passage.steps).enumerate() {
        line(format!("{:<9} {name}", format!("Stage {}", i + 1)));
        line(format!(
            "  passes  {} (model {})",
            share_words(step.transmission[0]),
            share_words(step.transmission[1])
        ));
        line(format!(
            "  error   {}; {} of it added by forming the product",
            colours(&step.colours),
            decimals(step.added, 4)
        ));
        for spike in &step.spikes {
            line(format!(
                "  {:<7} {:7.2} nm  {:>11}{}",
                // A line that a ringing series turned negative is no dip.
                if spike.weight < 0.0 && !step.turned.contains(&spike.at_nm) {
                    "dip"
                } else {
                    "spike"
                },
                spike.at_nm,
                short(spike.weight),
                known
                    .safe(spike.at_nm)
                    .map_or_else(String::new, |name| format!("  {name}"))
            ));
        }
    }
    let total = passage.total();
    line(format!(
        "Total     {}; passes {}",
        colours(&total.colours),
        share_words(total.transmission[0])
    ));
    line(format!(
        "Forming   adds CIEDE2000 {}, {} of the power folded or cut, {} multiplications",
        decimals(total.added, 4),
        share_words(Some(total.folded_share)),
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
    for note in notes(app, told) {
        line(format!("Note      {note}"));
    }
    out
}

/// A light with every factor of a group for people.
pub fn set_text(app: &App, set: &str, errors: &SetErrors) -> String {
    let mut out = head_text(app);
    let _ = writeln!(
        out,
        "Set       {set}, {}",
        many(errors.count, "factor", "factors")
    );
    for (what, spread) in [("Added", errors.added), ("Total", errors.total)] {
        let _ = writeln!(
            out,
            "{what:<9} CIEDE2000 median {}, 95 % below {}, worst {}",
            decimals(spread.map(|s| s.median), 4),
            decimals(spread.map(|s| s.p95), 4),
            decimals(spread.map(|s| s.worst), 4)
        );
    }
    if app.document().settings.sampling == Sampling::Exact {
        out.push_str(FORMED_EXACTLY);
    }
    out
}

/// Why nothing is added in the way that is the default.
const FORMED_EXACTLY: &str =
    "Note      at every nm nothing is folded: --sampling double shows what few points add\n";
