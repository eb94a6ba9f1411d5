//! A light's figures for people: measured beside model, and what they mean.

use std::fmt::Write as _;

use super::{
    row::{Row, rows},
    sheet::Sheet,
};
use crate::{
    app::{
        numbers::{DASH, fixed},
        ticks::short,
    },
    color::quality::Figures,
    io::many::{many, numbers},
    spectrum::NamedSpectrum,
};

/// The figures of a light and its model as words; a dash where there is none, with the reason.
pub fn text(sheet: &Sheet, spectrum: &NamedSpectrum) -> String {
    let Sheet {
        name,
        measured,
        model,
        composite,
    } = sheet;
    let samples = &spectrum.samples;
    let mut out = format!(
        "{name} ({}, {} points, {}-{} nm{})\n",
        spectrum.kind,
        samples.len(),
        short(samples.first_nm()),
        short(samples.last_nm()),
        match spectrum.unit.as_str() {
            "" => String::new(),
            unit => format!(", {unit}"),
        }
    );
    let band = composite.band();
    // Writing to a String cannot fail.
    let _ = writeln!(
        out,
        "Model: {} order {} on {}-{} nm, {}: {}\n",
        composite.smooth().basis.word(),
        composite.smooth().order(),
        band.min_nm(),
        band.max_nm(),
        many(composite.lines().len(), "line", "lines"),
        numbers(composite.numbers()),
    );
    out += &table(&lines(measured, model));
    let of_model = model.notes.iter().map(|note| format!("model: {note}"));
    for note in measured.notes.iter().cloned().chain(of_model) {
        let _ = writeln!(out, "Note: {note}");
    }
    for note in &spectrum.notes {
        let _ = writeln!(out, "Note: {note}");
    }
    out
}

/// The figures of two lights beside each other, under their names.
pub fn table_of_two([a, b]: [&str; 2], [of_a, of_b]: [&Figures; 2]) -> String {
    let mut lines = lines(of_a, of_b);
    for line in &mut lines {
        // What a figure means was told of the first light alone.
        line[3].clear();
    }
    lines[0] = ["", a, b, ""].map(str::to_owned);
    // What neither light has is no row.
    lines.retain(|line| line[1] != DASH || line[2] != DASH);
    table(&lines)
}

/// Title, measured, model, meaning.
type Line = [String; 4];

fn lines(measured: &Figures, model: &Figures) -> Vec<Line> {
    let head = ["", "measured", "model", ""].map(str::to_owned);
    let mut lines = vec![head];
    let pair = |pair: &Result<[f64; 2], _>| match pair {
        Ok(pair) => pair.map(|v| fixed(v, 4)).join(" "),
        Err(_) => DASH.to_owned(),
    };
    let why = |figures: &Figures| {
        let no = figures.xyz.as_ref().err();
        no.map(ToString::to_string).unwrap_or_default()
    };
    for (title, of) in [
        ("x y", [&measured.xy[0], &model.xy[0]]),
        ("u' v'", [&measured.uv, &model.uv]),
    ] {
        let [measured_pair, model_pair] = of.map(pair);
        lines.push([title.to_owned(), measured_pair, model_pair, why(measured)]);
    }
    let of_model = rows(model);
    for row in rows(measured) {
        let other = of_model
            .iter()
            .find(|other| other.figure.key == row.figure.key);
        lines.push([
            row.figure.title().to_owned(),
            row.shown(),
            other.map_or_else(|| DASH.to_owned(), Row::shown),
            match row.value {
                Ok(_) => row.reading,
                Err(why) => why,
            },
        ]);
    }
    lines
}

/// Columns as wide as what stands in them, numbers at the right.
fn table(lines: &[Line]) -> String {
    let width = |column: usize| {
        let widths = lines.iter().map(|line| line[column].chars().count());
        widths.max().unwrap_or(0)
    };
    let [title, measured, model] = [0, 1, 2].map(width);
    let mut out = String::new();
    for line in lines {
        let words = format!(
            "{:title$}  {:>measured$}  {:>model$}  {}",
            line[0], line[1], line[2], line[3]
        );
        out += words.trim_end();
        out.push('\n');
    }
    out
}
