//! A recovered spectrum as JSON, with the keys of the command `recover`.

use serde::Serialize;
use serde_json::{Value, json};

use super::{
    lines::LineLight,
    metamers::MetamerBand,
    method::Method,
    prediction::Prediction,
    recovered::{Nearest, Recovered},
    viewing::{BAND, node_nm},
};
use crate::color::{Adaptation, Swatch, Xyz};

/// The object of a recovered reflectance. `lights` names the lights it was made from, with their
/// whites; `band` and `under` are what was asked for of [`super::metamers`] and
/// [`super::predictions`].
pub fn json(
    recovered: &Recovered,
    lights: &[(&str, Xyz)],
    band: Option<&MetamerBand>,
    under: &[Prediction],
) -> Value {
    let table = recovered.reflectance.sampled();
    let [lowest, highest] = recovered.reflectance.extent();
    let nearest = recovered.nearest.as_ref().map(|nearest| {
        let seen = |(xyz, (_, white)): (&Xyz, &(_, Xyz))| {
            Swatch::of_patch(*xyz, *white, Adaptation::ToLight)
        };
        nearest_json(nearest, nearest.xyz.iter().zip(lights).map(seen))
    });
    let mut out = json!({
        "method": recovered.method.word(),
        "light": lights.first().map(|(name, _)| name),
        "values": values(table.nm().iter().zip(table.values())),
        "round_trip_delta_e": recovered.round_trip_delta_e,
        "inside_0_1": recovered.is_inside_0_1(),
        "lowest": lowest,
        "highest": highest,
        "condition_number": recovered.condition_number,
        "band": band.map(band_json),
        "under": all(under, under_json),
        "nearest": nearest,
    });
    if let Some((name, _)) = lights.get(1) {
        out["second_light"] = json!(name);
    }
    out
}

/// The object of a light of lines, with the same keys; what asks for a reflectance is null, and
/// `lines`, `background_power` and `residual` stand beside them.
pub(crate) fn line_light_json(light: &LineLight, under: &[Prediction]) -> Value {
    let on_band = light.on_band();
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    let [lowest, highest] = on_band
        .iter()
        .fold(ends, |[low, high], v| [low.min(*v), high.max(*v)]);
    let nearest = light.nearest.as_ref();
    let nearest = nearest.map(|nearest| {
        nearest_json(
            nearest,
            nearest.xyz.iter().map(|xyz| Swatch::of_light(*xyz)),
        )
    });
    json!({
        "method": Method::Lines.word(),
        "light": Value::Null,
        "values": values(BAND.grid().zip(&on_band)),
        "round_trip_delta_e": light.round_trip_delta_e,
        "inside_0_1": Value::Null,
        "lowest": lowest,
        "highest": highest,
        "condition_number": light.condition_number,
        "band": Value::Null,
        "under": all(under, under_json),
        "nearest": nearest,
        "lines": all(&light.lines, |line| json!({"at_nm": line.at_nm, "weight": line.weight})),
        "background_power": light.background.iter().sum::<f64>(),
        "residual": light.residual,
    })
}

/// The objects of a list.
fn all<T>(items: &[T], object: impl Fn(&T) -> Value) -> Value {
    items.iter().map(object).collect()
}

fn values<'a, N: Serialize>(pairs: impl Iterator<Item = (N, &'a f64)>) -> Value {
    pairs
        .map(|(nm, value)| json!({"nm": nm, "value": value}))
        .collect()
}

fn band_json(band: &MetamerBand) -> Value {
    let rows = band.least.iter().zip(band.greatest.iter()).enumerate();
    rows.map(|(node, (least, greatest))| {
        json!({"nm": node_nm(node), "least": least, "greatest": greatest})
    })
    .collect()
}

fn under_json(prediction: &Prediction) -> Value {
    json!({
        "light": prediction.light,
        "srgb_hex": prediction.swatch.hex(),
        "xyz": prediction.xyz.to_array(),
    })
}

/// One object; with two lights an array of two.
fn nearest_json(nearest: &Nearest, swatches: impl Iterator<Item = Swatch>) -> Value {
    let each = nearest.xyz.iter().zip(swatches).enumerate();
    let one = |(i, (xyz, swatch)): (usize, (&Xyz, Swatch))| {
        json!({
            "xyz": xyz.to_array(),
            "srgb_hex": swatch.hex(),
            "delta_e": nearest.delta_e.get(i),
            "delta_e_ab": nearest.delta_e_ab.get(i),
        })
    };
    let mut each: Vec<Value> = each.map(one).collect();
    match each.len() {
        1 => each.remove(0),
        _ => Value::Array(each),
    }
}
