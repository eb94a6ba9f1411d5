//! A slit put on, and one taken off.

use super::{
    parts::{doubt_from, with_noise},
    result::{Found, LineRow},
    said,
};
use crate::{
    languages::{fixed, signed},
    measurements::{
        Kernel, Measurement, Slit, SlitFound, noise_behind, slit_of, slit_of_daylight, smoothed,
        unslit,
    },
    spectrum::Sampled,
};

fn the_one(parts: Vec<Measurement>) -> Result<Measurement, String> {
    let one = with_noise(parts).into_iter().next();
    one.ok_or_else(|| said!("expected a light").to_owned())
}

/// A light as an instrument with this slit sees it.
///
/// # Errors
/// A sentence where it was seen through a wider one.
pub(super) fn through(parts: Vec<Measurement>, slit: Slit) -> Result<Found, String> {
    let from = doubt_from(&parts);
    let part = the_one(parts)?;
    let seen = smoothed(&part, slit).map_err(said)?;
    let (width, shape) = (slit.fwhm_nm, slit.shape.word());
    let made_by = format!("{} through {width} nm ({shape})", part.name);
    let mut found = Found::of(seen, made_by, from);
    found.first_nm = vec![part.samples.nm().to_vec()];
    found.tell_lines();
    Ok(found)
}

/// A light without its slit, whose width is told or found.
///
/// # Errors
/// A sentence where no line tells the width, or it is none.
pub(super) fn taken_off(
    parts: Vec<Measurement>,
    fwhm_nm: Option<f64>,
    shape: Kernel,
) -> Result<Found, String> {
    let from = doubt_from(&parts);
    let is_stated = parts.first().is_some_and(|part| part.sigma.is_some());
    let mut part = the_one(parts)?;
    let slit = match (fwhm_nm, part.slit) {
        (Some(fwhm_nm), _) => told(Slit { shape, fwhm_nm }),
        (None, Some(known)) => told(known),
        (None, None) => slit_of(&part, shape)
            .or_else(|why| slit_of_daylight(&part).ok_or(why))
            .map_err(said)?,
    };
    if !is_stated {
        part.sigma = noise_behind(&part.samples, slit.slit);
    }
    let made = unslit(&part, slit.slit).map_err(said)?;
    let (width, shape) = (slit.slit.fwhm_nm, slit.slit.shape.word());
    let about = if slit.is_sure { "" } else { "about " };
    let made_by = format!(
        "{} without its slit of {about}{width:.2} nm ({shape})",
        part.name
    );
    let mut found = Found::of(made.result, made_by, from);
    found.first_nm = vec![part.samples.nm().to_vec()];
    if !made.is_made {
        let why = said!("Bandwidth changes less than the noise: left as it is.");
        found.notes.push(why.to_owned());
    }
    if !slit.lines.is_empty() && slit.u > 0.0 {
        found.notes.push(tr!(
            "The slit is {width}, told by {lines} lines; they are read {shift} nm from their \
             places.",
            width,
            lines = slit.lines.len(),
            shift = signed(slit.shift_nm, 2)
        ));
    }
    if !slit.is_sure && slit.lines.is_empty() {
        found.notes.push(tr!(
            "The slit is {width}, told by oxygen's band of daylight at 763 nm.",
            width
        ));
    }
    if made.is_made && !made.lines.is_empty() {
        found.notes.push(tr!(
            "{lines} lines are drawn 2 nm wide: each is a line, or a band narrower than {width} \
             nm.",
            lines = made.lines.len(),
            width = fixed((0.5 * slit.slit.fwhm_nm).max(1.0), 0)
        ));
    }
    let power = area(&part.samples);
    if made.is_made {
        found.lines = made
            .lines
            .iter()
            .map(|line| LineRow::of_narrow(line, power))
            .collect();
    }
    found.slit = Some(slit);
    found.tell_lines();
    Ok(found)
}

/// A slit that a person told.
fn told(slit: Slit) -> SlitFound {
    SlitFound {
        slit,
        u: 0.0,
        shift_nm: 0.0,
        lines: Vec::new(),
        is_sure: true,
    }
}

/// Integral of the absolute value, value x nm.
fn area(samples: &Sampled) -> f64 {
    let pairs = samples.nm().windows(2).zip(samples.values().windows(2));
    pairs
        .map(|(nm, v)| 0.5 * (nm[1] - nm[0]) * (v[0].abs() + v[1].abs()))
        .sum()
}
