//! Mixtures and fronts as JSON, with the keys of the command `mix`.

use serde::Serialize;
use serde_json::{Value, json};

use super::{front::FrontPoint, solution::Solution};
use crate::{
    color::Xyz,
    design::mixture::{Channel, composite},
};

/// A channel as a mixing desk shows it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Fader {
    /// The channel in words.
    pub spec: String,
    /// Its power.
    pub weight: f64,
    /// Its share of the whole power, 0-1.
    pub share_of_power: f64,
    /// Its power in per cent of the strongest channel's.
    pub drive_percent: f64,
    /// The same for lighting desks of 8 bits.
    #[serde(skip)]
    pub dmx_8: u8,
    /// The same for lighting desks of 16 bits.
    #[serde(skip)]
    pub dmx_16: u16,
}

/// The faders of a mixture.
pub(crate) fn faders(channels: &[Channel], weights: &[f64]) -> Vec<Fader> {
    let whole: f64 = weights.iter().sum();
    let strongest = weights.iter().copied().fold(0.0, f64::max);
    let share = |part: f64, of: f64| if of > 0.0 { part / of } else { 0.0 };
    let one = |(channel, weight): (&Channel, &f64)| {
        let drive = share(*weight, strongest);
        Fader {
            spec: channel.spec.words.clone(),
            weight: *weight,
            share_of_power: share(*weight, whole),
            drive_percent: 100.0 * drive,
            dmx_8: (255.0 * drive).round() as u8,
            dmx_16: (65535.0 * drive).round() as u16,
        }
    };
    channels.iter().zip(weights).map(one).collect()
}

/// The object of a mixture.
pub(crate) fn mix_json(channels: &[Channel], solution: &Solution) -> Value {
    let figures = &solution.figures;
    json!({
        "channels": faders(channels, &solution.weights),
        "xyz": figures.xyz.map(Xyz::to_array),
        "xy": figures.xy,
        "uv": figures.uv,
        "cct": figures.cct.map(|cct| cct.kelvin),
        "duv": figures.cct.map(|cct| cct.duv),
        "ra": figures.ra,
        "rf": figures.rf,
        "rg": figures.rg,
        "ler": figures.ler,
        "melanopic_der": figures.melanopic_der,
        "delta_uv_to_target": solution.delta_uv_to_target,
        "reached": solution.reached,
        "why": solution.why,
        "composite": composite_json(channels, &solution.weights),
    })
}

/// The mixture in the keys of the program's composite files.
fn composite_json(channels: &[Channel], weights: &[f64]) -> Value {
    let model = composite(channels, weights);
    let spike = |s: &crate::spectrum::Line| json!({"at_nm": s.at_nm, "weight": s.weight});
    json!({
        "format": "composite-spectrum",
        "version": 1,
        "range_nm": model.band(),
        "basis": model.smooth().basis.word(),
        "coefficients": {"c": model.smooth().coefficients},
        "spikes": model.lines().iter().map(spike).collect::<Vec<_>>(),
        "unit": "relative",
        "source": "mixed channels",
        "name": "mixture",
        "kind": "light",
    })
}

/// The object of a front.
pub(crate) fn front_json(points: &[FrontPoint]) -> Value {
    let point = |point: &FrontPoint| {
        json!({
            "ler": point.figures.ler,
            "rf": point.figures.rf,
            "ra": point.figures.ra,
            "rg": point.figures.rg,
            "lines": point.lines,
        })
    };
    json!({"front": points.iter().map(point).collect::<Vec<_>>()})
}
