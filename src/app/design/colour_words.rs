//! A colour and the spectra that have it, in words.

use super::colour::ColourSheet;
use crate::design::recover::{Method, NODES, Recovered, node_nm};

/// Where the band's width is told: the ends are hardly seen, nm.
const TOLD_NM: std::ops::RangeInclusive<f64> = 420.0..=680.0;

impl ColourSheet {
    /// The result in a sentence.
    pub fn sentence(&self) -> String {
        let lights: Vec<&str> = self.seen.iter().map(|seen| seen.light.as_str()).collect();
        let light = &lights.join(" and ");
        let are_two = lights.len() > 1;
        if let Some(nearest) = &self.smoothest.nearest {
            let most = |all: &[f64]| all.iter().copied().fold(0.0, f64::max);
            let (off, visible) = (most(&nearest.delta_e_ab), most(&nearest.delta_e));
            let these = match are_two {
                true => "these colours under",
                false => "this colour under",
            };
            return format!(
                "No surface has {these} {light}: the nearest by ΔE*ab that one can have is \
                 {off:.1} ΔE*ab off ({visible:.1} ΔE₀₀), and is what is drawn."
            );
        }
        let first = match (&self.surface, &self.told) {
            (Some(entry), Some(told)) => {
                let looks = self.under.iter().zip(&told.delta_e);
                let worst = looks
                    .filter_map(|(under, off)| Some((&under.light, (*off)?)))
                    .max_by(|a, b| a.1.total_cmp(&b.1));
                let worst = worst.map_or_else(String::new, |(light, off)| {
                    format!(", and under {light} it looks {off:.1} ΔE₀₀ off")
                });
                let its = if are_two { "its colours" } else { "its colour" };
                format!(
                    "From {its} under {light}, {} comes out {:.3} off (rms){worst}.",
                    entry.name(),
                    told.rms
                )
            }
            _ => {
                let [low, high] = self.smoothest.reflectance.extent().map(|v| 100.0 * v);
                let each = self.seen.iter().map(|seen| match are_two {
                    true => format!("{} under {}", seen.swatch.hex(), seen.light),
                    false => seen.swatch.hex(),
                });
                let each: Vec<String> = each.collect();
                format!(
                    "The smoothest surface of {} reflects {low:.0} to {high:.0} %.",
                    each.join(" and ")
                )
            }
        };
        let spread = self.spread().map_or_else(String::new, |spread| {
            let per_cent = 100.0 * spread;
            format!(
                " At a single wavelength, two surfaces that match it under {light} can differ by \
                 {per_cent:.0} points of reflectance (averaged over wavelength)."
            )
        });
        format!("{first}{spread}")
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
                value.map_or_else(|| "-".to_owned(), |value| format!("{value:.digits$}"))
            };
            let name = method_name(method).to_owned();
            [name, range, number(round, 2), number(condition, 0)]
        };
        let of_surface = |method: Method, found: &Recovered| {
            let [low, high] = found.reflectance.extent();
            let inside = match found.is_inside_0_1() {
                true => "",
                false => " \u{25b2} no surface is so",
            };
            let range = format!("{low:.2} to {high:.2}{inside}");
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
                    Some(_) => "\u{25b2} only near it".to_owned(),
                    None => format!("{share:.0} % in the lines"),
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
        Method::Smoothest => "Smoothest surface",
        Method::Fourier3 => "Three coefficients",
        Method::Fourier6 => "Six coefficients",
        Method::Lines => "Light of lines",
    }
}
