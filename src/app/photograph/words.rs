//! What is said of a photograph: in a sentence, as JSON, as a table.

mod warnings;

use serde_json::{Value, json};

use super::{ColourFigures, Estimate, Fit, Photograph, Row, Source, Stands, line_words::told};
use crate::{
    app::cells::{Columns, Table, cell, column, rounded},
    io::one_line,
    languages::fixed,
    photographs::{
        Lamp,
        axis::{Match, Solution},
    },
};

pub use warnings::warnings;

/// A figure for JSON: rounded to what it is worth, never a number that is none.
fn figure(value: f64, digits: i32) -> Value {
    let scale = 10_f64.powi(digits);
    let rounded = (value * scale).round() / scale;
    if rounded.is_finite() {
        json!(rounded)
    } else {
        Value::Null
    }
}

/// What the axis is, in one sentence with its evidence.
pub fn sentence(photograph: &Photograph) -> String {
    match (photograph.source(), best_of(photograph)) {
        (Source::Found, Some(best)) => tr!(
            "Looks like {lamp}: {lines}. Right?",
            lamp = called(best),
            lines = lines(photograph, best)
        ),
        (Source::Suggested, Some(best)) => tr!(
            "Perhaps {lamp}: {lines}. Right? (--yes takes it)",
            lamp = called(best),
            lines = lines(photograph, best)
        ),
        _ => {
            let [what, _] = sentence_parts(photograph);
            what
        }
    }
}

fn best_of(photograph: &Photograph) -> Option<&Solution> {
    photograph.answer.as_ref()?.best.as_ref()
}

/// What the axis is, and apart from it the lines that say so; none where no lines do.
pub fn sentence_parts(photograph: &Photograph) -> [String; 2] {
    let what = match (photograph.source(), best_of(photograph)) {
        (Source::Pins, _) => match photograph.pins.len() {
            2 => said!("The axis goes through 2 pins, 1-8 nm wrong between grating and line.")
                .to_owned(),
            count => tr!("The axis goes through {count} pins.", count),
        },
        (Source::Instrument, _) => of_instrument(photograph),
        (Source::Found, Some(best)) => {
            let words = tr!("Looks like {lamp}. Right?", lamp = called(best));
            return [words, lines(photograph, best)];
        }
        (Source::Suggested, Some(best)) => {
            let words = tr!("Perhaps {lamp}. Right?", lamp = called(best));
            return [words, lines(photograph, best)];
        }
        _ => said!("Cannot be said: no axis is known.").to_owned(),
    };
    [what, String::new()]
}

/// What an instrument says of a picture.
fn of_instrument(photograph: &Photograph) -> String {
    let Some(applied) = &photograph.instrument else {
        return String::new();
    };
    let name = &applied.name;
    match applied.fit {
        Fit::Moved(px) if photograph.yes => {
            tr!(
                "Read with the instrument {name}, moved by {px} px since.",
                name,
                px = fixed(px, 1)
            )
        }
        Fit::Moved(px) => {
            tr!(
                "The instrument {name} has moved by {px} px since; taken along? (--yes)",
                name,
                px = fixed(px, 1)
            )
        }
        Fit::Unchecked if !photograph.yes => tr!(
            "Nothing in this picture tells whether the instrument {name} still fits. Does it? \
             (--yes)",
            name
        ),
        _ => tr!("Read with the instrument {name}.", name),
    }
}

/// A lamp with its article.
fn called(best: &Solution) -> &'static str {
    match best.lamp {
        Lamp::Fluorescent => said!("a fluorescent lamp"),
        Lamp::Mercury => said!("a mercury lamp"),
        Lamp::Sodium => said!("a sodium lamp"),
        Lamp::Neon => said!("a neon lamp"),
        Lamp::Argon => said!("an argon lamp"),
        Lamp::Krypton => said!("a krypton lamp"),
        Lamp::Xenon => said!("a xenon lamp"),
        Lamp::Hydrogen => said!("a hydrogen lamp"),
        Lamp::Helium => said!("a helium lamp"),
        Lamp::Daylight => said!("daylight"),
    }
}

fn lines(photograph: &Photograph, best: &Solution) -> String {
    tr!(
        "{lines}; {count} lines fit within {rms} nm (within {left_out_rms} where each is left out \
         in turn)",
        lines = told(photograph, best),
        count = best.matches.len(),
        rms = fixed(best.rms_nm(), 1),
        left_out_rms = fixed(best.left_out_rms_nm(), 1)
    )
}

/// Everything about a photograph, with the wavelengths at some of its pixels.
pub fn json(photograph: &Photograph, at: &[[f64; 2]]) -> Value {
    let found = &photograph.found;
    let strip = found.strip;
    let curve = photograph.curve();
    let falls = curve.map(|c| c.c[1] < 0.0).or(found.blue_is_right);
    let answer = photograph.answer.as_ref();
    let answer = answer.filter(|_| photograph.is_by_lines());
    let best = answer.and_then(|a| a.best.as_ref());
    let other = answer.and_then(|a| a.runner_up.as_ref());
    json!({
        "file": photograph.file,
        "size": photograph.size,
        "orientation": photograph.exif.orientation,
        "strip": {
            "vertical": strip.is_vertical,
            "flip": falls,
            "turn_deg": figure(strip.turn_deg, 4),
            "shear": figure(strip.shear, 6),
            "smile": figure(strip.smile, 9),
            "centre_y": figure(strip.centre_y, 3),
            "half": figure(strip.half, 3),
            "x0": figure(strip.x0, 3),
            "columns": strip.columns,
            "rows": found.profile.rows,
            "by_hand": photograph.by_hand,
        },
        "strips": found.strips,
        "grey": found.profile.is_grey,
        "black": found.profile.black_seen,
        "clipped_columns": found.profile.clipped_columns(),
        "state": photograph.source().word(),
        "lamp": best.map(|b| b.lamp.name()),
        "score": best.map(|b| figure(b.score, 2)),
        "margin": answer.filter(|_| best.is_some()).map(|a| figure(a.margin, 2)),
        "runner_up": other.map(|o| json!({ "lamp": o.lamp.name(), "score": figure(o.score, 2) })),
        "lines": best.map(|b| lines_json(photograph, b)).unwrap_or_default(),
        "peaks": peaks_json(photograph),
        "axis": curve.map(|_| axis_json(photograph, best)),
        "fwhm_nm": photograph.fwhm_nm().map(|nm| figure(nm, 2)),
        "hairlines_ignored": photograph.bright.hairlines,
        "at": at.iter().map(|pixel| at_json(photograph, *pixel)).collect::<Vec<Value>>(),
        "instrument": photograph.instrument.as_ref().map(|i| json!({
            "name": i.name,
            "shift_px": i.shift_px.map(|px| figure(px, 2)),
            "shift_nm": i.shift_nm.map(|nm| figure(nm, 3)),
            "hue_difference": i.hue_difference.map(|d| figure(d, 4)),
        })),
        "exposures": photograph.exposed.as_ref().map(|e| json!({
            "light_power": figure(e.light_power, 3),
            "joined_columns": e.joined.len(),
        })),
        "response": photograph.through.as_ref().map(|t| json!({
            "known_as": t.known_as,
            "tone_p": t.tone_p,
            "light_power": figure(t.light_power, 3),
            "disagreement": figure(t.disagreement, 4),
            "undefined_nm": t.undefined_nm(),
        })),
        "figures": photograph.figures.as_ref().and_then(|f| f.as_ref().ok()).map(figures_json),
        "warnings": warnings(photograph),
    })
}

/// Low, best and high of each colour figure.
fn figures_json(figures: &ColourFigures) -> Value {
    let estimate = |of: Option<Estimate>, digits: i32| of.map(|e| e.map(|v| figure(v, digits)));
    json!({
        "cct": estimate(figures.cct, 0),
        "duv": estimate(figures.duv, 4),
        "x": estimate(figures.x, 4),
        "y": estimate(figures.y, 4),
        "ra": estimate(figures.ra, 1),
        "rf": estimate(figures.rf, 1),
    })
}

/// The colour figures in words, each with its band; none without them.
pub fn colour_words(photograph: &Photograph) -> Option<String> {
    let figures = photograph.figures.as_ref()?.as_ref().ok()?;
    let told = |name: &str, of: Option<Estimate>, digits: usize, unit: &str| {
        of.map(|[low, best, high]| {
            let [low, best, high] = [low, best, high].map(|value| fixed(value, digits));
            format!("{name} {best}{unit} ({low}-{high})")
        })
    };
    let all = [
        told("CCT", figures.cct, 0, " K"),
        told("Ra", figures.ra, 0, ""),
        told("Rf", figures.rf, 0, ""),
    ];
    let all: Vec<String> = all.into_iter().flatten().collect();
    (!all.is_empty()).then(|| {
        tr!(
            "Estimates, with their bands: {figures}.",
            figures = all.join(", ")
        )
    })
}

/// The wavelength at a pixel, none where the axis has none.
fn at_json(photograph: &Photograph, [x, y]: [f64; 2]) -> Value {
    let (column, _) = photograph.found.strip.column_of(x, y);
    let last = photograph.found.profile.columns() as f64 - 1.0;
    let inside = (-0.5..=last + 0.5).contains(&column);
    let curve = photograph.curve().filter(|_| inside);
    json!({
        "x": x,
        "y": y,
        "nm": curve.map(|c| figure(c.nm(column), 3)),
        "sigma_nm": curve.map(|c| figure(c.sigma(column), 3)),
    })
}

fn lines_json(photograph: &Photograph, best: &Solution) -> Vec<Value> {
    let line = |m: &Match| {
        let peak = photograph.peaks().peaks[m.peak];
        let width = peak.fwhm_px * best.curve.slope(peak.px).abs();
        json!({
            "nm": m.landmark.nm,
            "px": figure(peak.px, 2),
            "error_nm": figure(m.error_nm, 3),
            "width_nm": figure(width, 2),
            "clipped": peak.is_clipped,
            "named": m.error_nm.abs() <= 2.0 * m.sigma_nm,
        })
    };
    best.matches.iter().map(line).collect()
}

fn peaks_json(photograph: &Photograph) -> Vec<Value> {
    let curve = photograph.curve();
    let peaks = photograph.peaks().peaks.iter();
    peaks
        .map(|peak| {
            json!({
                "px": figure(peak.px, 2),
                "error_px": figure(peak.error_px, 3),
                "height": figure(peak.height, 5),
                "width_px": figure(peak.fwhm_px, 2),
                "clipped": peak.is_clipped,
                "nm": curve.map(|c| figure(c.nm(peak.px), 2)),
            })
        })
        .collect()
}

fn axis_json(photograph: &Photograph, best: Option<&Solution>) -> Value {
    let Some(curve) = photograph.curve() else {
        return Value::Null;
    };
    let last = photograph.found.profile.columns() as f64 - 1.0;
    let valid = photograph.valid_nm();
    let sigma = (38..=78)
        .map(|ten| 10.0 * f64::from(ten))
        .filter_map(|nm| Some((nm, curve.px(nm, 0.0, last)?)))
        .map(|(nm, px)| json!([nm, figure(curve.sigma(px), 3)]));
    json!({
        "c": curve.c.map(|c| figure(c, 5)),
        "centre_px": curve.centre_px,
        "scale_px": curve.scale_px,
        "rms_nm": best.map(|b| figure(b.rms_nm(), 3)),
        "loo_nm": best.map(|b| figure(b.left_out_rms_nm(), 3)),
        "valid_nm": valid.map(|(low, high)| [figure(low, 1), figure(high, 1)]),
        "sigma_nm_at": sigma.collect::<Vec<Value>>(),
    })
}

/// The spectrum as a table; `None` without an axis that may be used.
pub fn table(photograph: &Photograph) -> Option<Table> {
    let rows = photograph.rows()?;
    let answer = photograph
        .answer
        .as_ref()
        .filter(|_| photograph.is_by_lines());
    let best = answer.and_then(|a| a.best.as_ref());
    let lamp = best.map_or("none", |b| b.lamp.name());
    let instrument = photograph.instrument.as_ref().map_or("none", |i| &i.name);
    let error = match best {
        Some(best) => format!("{:.2} nm rms", best.rms_nm()),
        None => "not known".to_owned(),
    };
    let place = match rows.stands {
        Stands::WholeNm => "as the camera saw it, means over 1 nm",
        Stands::Columns => "as the camera saw it, at the columns' own places",
        Stands::Response => "through the camera's response, means over 2 nm",
    };
    let comments = format!(
        "# instrument: {}\n# lamp: {lamp}\n# axis error: {error}\n# unit: relative, {place}\n\
         # made from a picture\n",
        one_line(instrument)
    );
    let channel = |key: &'static str, at: usize| {
        column(key, move |row: &Row| rounded(row.channels[at], 6, ""))
    };
    let of_columns = matches!(rows.stands, Stands::Columns);
    let columns = Columns::<Row>::default()
        .with("nm", |row| match of_columns {
            true => rounded(row.nm, 3, ""),
            false => cell(row.nm),
        })
        .with("value", |row| rounded(row.value, 6, ""))
        .with("sigma", |row| rounded(row.sigma, 6, ""))
        .and(channel("r", 0))
        .and(channel("g", 1))
        .and(channel("b", 2))
        .with("clipped", |row| cell(u8::from(row.is_clipped)));
    Some(Table::new(comments, columns, rows.rows))
}
