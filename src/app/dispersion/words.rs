//! Words that the three pages share.

use super::super::products::ModelledLight;
use crate::{
    languages::fixed,
    {app::state::App, optics::Light},
};

/// A spike of a light with what it is called.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Where, nm.
    pub at_nm: f64,
    /// Weight, value x nm.
    pub weight: f64,
    /// Its element and place, or the place alone.
    pub name: String,
}

/// The lines of the document's light that are seen, by rising wavelength.
pub(super) fn lines_of(app: &App, light: &Light) -> Vec<Line> {
    let modelled = ModelledLight::of(app);
    let names = modelled.spike_names(app);
    let spikes = modelled.derived.model.lines();
    let line = |spike: crate::spectrum::Line| {
        let index = spikes.iter().position(|own| own.at_nm == spike.at_nm);
        let label = index.and_then(|i| names.get(i)?.label.clone());
        Line {
            at_nm: spike.at_nm,
            weight: spike.weight,
            name: label.unwrap_or_else(|| nm(spike.at_nm)),
        }
    };
    light.seen_spikes().map(line).collect()
}

/// The first light and its lines.
#[cfg(test)]
pub(super) fn first_lines() -> (Light, Vec<Line>) {
    let app = App::new();
    let light = super::document_light(&app, super::Sent::Measured).expect("FL2 shines");
    let lines = lines_of(&app, &light);
    (light, lines)
}

/// A wavelength with its unit.
pub(super) fn nm(at_nm: f64) -> String {
    format!("{} nm", fixed(at_nm, 1))
}

/// "a, b and c".
pub(super) fn listed(all: &[String]) -> String {
    match all {
        [] => String::new(),
        [one] => one.clone(),
        [before @ .., last] => tr!("{list} and {last}", list = before.join(", "), last),
    }
}

/// Neighbours (by place) that touch: each a place and a width.
pub(super) fn touching(images: &[[f64; 2]]) -> Vec<usize> {
    let touch = |pair: &[[f64; 2]]| {
        let [a, b] = [pair[0], pair[1]];
        (a[0] - b[0]).abs() < 0.5 * (a[1] + b[1])
    };
    let pairs = images.windows(2).enumerate();
    let touching = pairs.filter(|(_, pair)| touch(pair));
    touching.map(|(i, _)| i).collect()
}
