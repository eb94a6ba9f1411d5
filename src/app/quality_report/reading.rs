//! What figures mean in plain words.
//!
//! Borders are those of standards and custom where there are any: warm, neutral and cool white of
//! EN 12464-1 (3300 and 5300 K), Ra 80 for work indoors (EN 12464-1), 0.0054 for white (CIE 13.3).

use crate::color::quality::{Figures, diagram::quadrangle_of};

/// CCT, with the quadrangle that the colour lies in.
pub(super) fn of_cct(figures: &Figures, kelvin: f64) -> String {
    let white = match kelvin {
        k if k < 2000.0 => "amber, like a candle",
        k if k < 3300.0 => "warm white",
        k if k < 5300.0 => "neutral white",
        k if k < 8000.0 => "cool white, like daylight",
        _ => "bluish, like a clear sky",
    };
    let quadrangle = figures.xy[0].clone().ok().and_then(quadrangle_of);
    match quadrangle {
        Some(found) => format!("{white}; may be sold as {:.0} K", found.nominal_k),
        None => format!("{white}; in none of the ten basic quadrangles of ANSI C78.377"),
    }
}

pub(super) fn of_duv(duv: f64) -> String {
    match duv {
        d if d.abs() < 0.001 => "on the line of blackbodies",
        d if d > 0.0054 => "visibly greenish: not white in the sense of CIE 13.3",
        d if d > 0.0 => "a trace to the green",
        d if d < -0.0054 => "visibly pinkish: not white in the sense of CIE 13.3",
        _ => "a trace to the pink",
    }
    .to_owned()
}

pub(super) fn of_ra(ra: f64) -> String {
    match ra {
        r if r >= 95.0 => "colours look as they do by daylight or a lamp with a filament",
        r if r >= 90.0 => "colours look nearly right",
        r if r >= 80.0 => "enough for work indoors; reds may still look dull",
        r if r >= 60.0 => "some colours look wrong",
        r if r >= 20.0 => "many colours look wrong",
        _ => "colours can hardly be told apart",
    }
    .to_owned()
}

/// One of R1 to R15, named by its test colour.
pub(super) fn of_sample(number: usize, name: &str, index: f64) -> String {
    let degree = match index {
        r if r >= 90.0 => "looks right",
        r if r >= 75.0 => "looks a little off",
        r if r >= 50.0 => "looks off",
        _ => "looks wrong",
    };
    let digits = format!("R{number} {index:.0}");
    match (number, index) {
        (9, r) if r < 50.0 => format!("skin and red things look dull: {digits}"),
        (13 | 15, r) if r < 75.0 => format!("faces look unwell: {digits}"),
        _ => format!("{name} {degree}: {digits}"),
    }
}

pub(super) fn of_rf(rf: f64) -> String {
    match rf {
        r if r >= 95.0 => "no colour shifts that anybody notices",
        r if r >= 85.0 => "slight shifts, seen side by side only",
        r if r >= 70.0 => "shifts that can be seen",
        r if r >= 50.0 => "strong shifts",
        _ => "colours are badly distorted",
    }
    .to_owned()
}

pub(super) fn of_rg(rg: f64) -> String {
    match rg {
        r if r > 102.0 => "colours look more vivid than under the reference",
        r if r >= 98.0 => "colours are as vivid as under the reference",
        r if r >= 80.0 => "colours look duller than under the reference",
        _ => "colours look grey",
    }
    .to_owned()
}

pub(super) fn of_efficacy(lumens: f64) -> String {
    format!(
        "{:.0} % of the 683 lm/W that are possible",
        100.0 * lumens / 683.0
    )
}

pub(super) fn of_melanopic(der: f64) -> String {
    format!("acts on the body's clock {der:.2} times as strongly as daylight (D65) of the same lux")
}

pub(super) fn of_sp(ratio: f64) -> String {
    match ratio {
        r if r < 1.0 => "little for eyes at night",
        r if r < 2.0 => "as most lamps at night",
        _ => "much for eyes at night, like daylight",
    }
    .to_owned()
}

pub(super) fn of_purity(purity: f64) -> String {
    match purity {
        p if p < 0.1 => "nearly white",
        p if p < 0.5 => "tinted",
        p if p < 0.9 => "coloured",
        _ => "nearly a single wavelength's colour, or a pure purple",
    }
    .to_owned()
}

pub(super) fn of_similarity(index: f64, reference: &str) -> String {
    let degree = match index {
        s if s >= 90.0 => "cameras see no difference from",
        s if s >= 70.0 => "cameras see nearly what they see under",
        s if s >= 50.0 => "some cameras see other colours than under",
        _ => "cameras see other colours than under",
    };
    format!("{degree} {reference}")
}

pub(super) fn of_dominant(nm: f64) -> String {
    let name = match nm.abs() {
        l if l < 450.0 => "violet",
        l if l < 485.0 => "blue",
        l if l < 500.0 => "blue-green",
        l if l < 560.0 => "green",
        l if l < 585.0 => "yellow",
        l if l < 610.0 => "orange",
        _ => "red",
    };
    if nm < 0.0 {
        format!("a purple; the complement is {name}")
    } else {
        format!("the hue of a {name} line")
    }
}
