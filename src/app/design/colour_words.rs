//! A colour and the spectra that have it, in words.

use super::colour::ColourSheet;
use crate::{
    design::recover::{Method, NODES, Recovered, node_nm},
    languages::fixed,
};

/// Where the band's width is told: the ends are hardly seen, nm.
const TOLD_NM: std::ops::RangeInclusive<f64> = 420.0..=680.0;

/// One thing, or two with an "and" between.
fn and(words: &[&str]) -> String {
    let mut words = words.iter().map(|word| (*word).to_owned());
    let first = words.next().unwrap_or_default();
    words.fold(first, |list, last| tr!("{list} and {last}", list, last))
}

impl ColourSheet {
    /// The result in a sentence.
    pub fn sentence(&self) -> String {
        let lights: Vec<&str> = self.seen.iter().map(|seen| seen.light.as_str()).collect();
        let light = &and(&lights);
        let are_two = lights.len() > 1;
        if let Some(nearest) = &self.smoothest.nearest {
            let most = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
            let (off, visible) = (most(&nearest.delta_e_ab), most(&nearest.delta_e));
            let (off, visible) = (fixed(off, 1), fixed(visible, 1));
            return match are_two {
                true => tr!(
                    "No surface has these colours under {lights}: the nearest by ΔE*ab that one \
                     can have is {off} ΔE*ab off ({visible} ΔE₀₀), and is what is drawn.",
                    lights = light,
                    off,
                    visible
                ),
                false => tr!(
                    "No surface has this colour under {light}: the nearest by ΔE*ab that one can \
                     have is {off} ΔE*ab off ({visible} ΔE₀₀), and is what is drawn.",
                    light,
                    off,
                    visible
                ),
            };
        }
        let first = self.came_out(light, are_two);
        let Some(spread) = self.spread() else {
            return first;
        };
        let spread = tr!(
            "At a single wavelength, two surfaces that match it under {light} can differ by \
             {points} points of reflectance (averaged over wavelength).",
            light,
            points = fixed(100.0 * spread, 0)
        );
        format!("{first} {spread}")
    }

    /// How near a surface comes out of its colours, or the smoothest surface of the colours.
    fn came_out(&self, light: &str, are_two: bool) -> String {
        match (&self.surface, &self.told) {
            (Some(entry), Some(told)) => {
                let looks = self.under.iter().zip(&told.delta_e);
                let worst = looks
                    .filter_map(|(under, off)| Some((&under.light, (*off)?)))
                    .max_by(|a, b| a.1.total_cmp(&b.1));
                let (surface, rms) = (entry.name(), fixed(told.rms, 3));
                match (are_two, worst) {
                    (true, Some((other, off))) => tr!(
                        "From its colours under {lights}, {surface} comes out {rms} off (rms), \
                         and under {other} it looks {off} ΔE₀₀ off.",
                        lights = light,
                        surface,
                        rms,
                        other,
                        off = fixed(off, 1)
                    ),
                    (true, None) => tr!(
                        "From its colours under {lights}, {surface} comes out {rms} off (rms).",
                        lights = light,
                        surface,
                        rms
                    ),
                    (false, Some((other, off))) => tr!(
                        "From its colour under {light}, {surface} comes out {rms} off (rms), and \
                         under {other} it looks {off} ΔE₀₀ off.",
                        light,
                        surface,
                        rms,
                        other,
                        off = fixed(off, 1)
                    ),
                    (false, None) => tr!(
                        "From its colour under {light}, {surface} comes out {rms} off (rms).",
                        light,
                        surface,
                        rms
                    ),
                }
            }
            _ => {
                let [low, high] = self.smoothest.reflectance.extent().map(|v| 100.0 * v);
                let each = self.seen.iter().map(|seen| match are_two {
                    true => tr!(
                        "{colour} under {light}",
                        colour = seen.swatch.hex(),
                        light = seen.light
                    ),
                    false => seen.swatch.hex(),
                });
                let each: Vec<String> = each.collect();
                let each: Vec<&str> = each.iter().map(String::as_str).collect();
                tr!(
                    "The smoothest surface of {colours} reflects {low} to {high} %.",
                    colours = and(&each),
                    low = fixed(low, 0),
                    high = fixed(high, 0)
                )
            }
        }
    }

    /// Mean over the wavelengths of the distance of the least and the greatest reflectance: no two
    /// surfaces need be that far apart, since each wavelength has its own extremes.
    pub(super) fn spread(&self) -> Option<f64> {
        let band = self.band.as_ref()?;
        let seen: Vec<usize> = (0..NODES)
            .filter(|node| TOLD_NM.contains(&node_nm(*node)))
            .collect();
        let sum: f64 = seen
            .iter()
            .map(|i| band.greatest[*i] - band.least[*i])
            .sum();
        Some(sum / seen.len() as f64)
    }

    /// What each way is to be trusted by: name, range of values, round trip, condition, words.
    pub fn facts(&self) -> Vec<[String; 4]> {
        let row = |method: Method, range: String, round: Option<f64>, condition: Option<f64>| {
            let number = |value: Option<f64>, digits: usize| {
                value.map_or_else(|| "-".to_owned(), |value| fixed(value, digits))
            };
            let name = method_name(method).to_owned();
            [name, range, number(round, 2), number(condition, 0)]
        };
        let of_surface = |method: Method, found: &Recovered| {
            let [low, high] = found.reflectance.extent();
            let (low, high) = (fixed(low, 2), fixed(high, 2));
            let range = match found.is_inside_0_1() {
                true => tr!("{low} to {high}", low, high),
                false => tr!("{low} to {high} \u{25b2} no surface is so", low, high),
            };
            let round = Some(found.round_trip_delta_e);
            row(method, range, round, found.condition_number)
        };
        let none = |method: Method, why: &String| row(method, why.clone(), None, None);
        let few = match self.seen.len() {
            1 => Method::Fourier3,
            _ => Method::Fourier6,
        };
        let fourier = match &self.fourier {
            Ok(found) => of_surface(few, found),
            Err(why) => none(few, why),
        };
        let lines = match &self.lines {
            Ok(found) => {
                let power: f64 = found.background.iter().sum();
                let lines: f64 = found.lines.iter().map(|line| line.weight).sum();
                let share = 100.0 * lines / (lines + power);
                let told = match &found.nearest {
                    Some(_) => said!("\u{25b2} only near it").to_owned(),
                    None => tr!("{share} % in the lines", share = fixed(share, 0)),
                };
                let condition = Some(found.condition_number);
                row(
                    Method::Lines,
                    told,
                    Some(found.round_trip_delta_e),
                    condition,
                )
            }
            Err(why) => none(Method::Lines, why),
        };
        vec![
            of_surface(Method::Smoothest, &self.smoothest),
            fourier,
            lines,
        ]
    }
}

/// What a method is called on the page.
pub fn method_name(method: Method) -> &'static str {
    match method {
        Method::Smoothest => said!("Smoothest surface"),
        Method::Fourier3 => said!("Three coefficients"),
        Method::Fourier6 => said!("Six coefficients"),
        Method::Lines => said!("Light of lines"),
    }
}
