//! A recovered spectrum as JSON, with the keys of the command `recover`.

use serde_json::{Map, Value, json};

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
    let mut out = Map::new();
    out.insert("method".into(), json!(recovered.method.word()));
    out.insert("light".into(), json!(lights.first().map(|(name, _)| name)));
    if let Some((name, _)) = lights.get(1) {
        out.insert("second_light".into(), json!(name));
    }
    let pairs = table.nm().iter().zip(table.values());
    out.insert(
        "values".into(),
        pairs.map(|(nm, v)| value(*nm, *v)).collect(),
    );
    out.insert(
        "round_trip_delta_e".into(),
        json!(recovered.round_trip_delta_e),
    );
    out.insert("inside_0_1".into(), json!(recovered.is_inside_0_1()));
    out.insert("lowest".into(), json!(lowest));
    out.insert("highest".into(), json!(highest));
    out.insert(
        "condition_number".into(),
        number(recovered.condition_number),
    );
    out.insert("band".into(), band.map_or(Value::Null, band_json));
    out.insert("under".into(), under.iter().map(under_json).collect());
    let nearest = recovered.nearest.as_ref().map(|nearest| {
        let seen = |(xyz, (_, white)): (&Xyz, &(_, Xyz))| {
            Swatch::of_patch(*xyz, *white, Adaptation::ToLight)
        };
        nearest_json(nearest, nearest.xyz.iter().zip(lights).map(seen))
    });
    out.insert("nearest".into(), json!(nearest));
    Value::Object(out)
}

/// The object of a light of lines, with the same keys; what asks for a reflectance is null, and
/// `lines`, `background_power` and `residual` stand beside them.
pub fn line_light_json(light: &LineLight, under: &[Prediction]) -> Value {
    let values = light.on_band();
    let ends = [f64::INFINITY, f64::NEG_INFINITY];
    let [lowest, highest] = values
        .iter()
        .fold(ends, |[low, high], v| [low.min(*v), high.max(*v)]);
    let lines: Vec<Value> = light
        .lines
        .iter()
        .map(|line| json!({"at_nm": line.at_nm, "weight": line.weight}))
        .collect();
    let pairs = BAND.grid().zip(&values);
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
        "values": pairs.map(|(nm, v)| value(nm, *v)).collect::<Vec<_>>(),
        "round_trip_delta_e": light.round_trip_delta_e,
        "inside_0_1": Value::Null,
        "lowest": lowest,
        "highest": highest,
        "condition_number": number(Some(light.condition_number)),
        "band": Value::Null,
        "under": under.iter().map(under_json).collect::<Vec<_>>(),
        "nearest": nearest,
        "lines": lines,
        "background_power": light.background.iter().sum::<f64>(),
        "residual": light.residual,
    })
}

fn value(nm: f64, value: f64) -> Value {
    json!({"nm": nm, "value": value})
}

/// Null for what is no number: JSON knows no infinity.
fn number(value: Option<f64>) -> Value {
    value
        .filter(|v| v.is_finite())
        .map_or(Value::Null, |v| json!(v))
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
    let one = |(((xyz, delta_e), delta_e_ab), swatch): (((&Xyz, &f64), &f64), Swatch)| {
        json!({
            "xyz": xyz.to_array(),
            "srgb_hex": swatch.hex(),
            "delta_e": delta_e,
            "delta_e_ab": delta_e_ab,
        })
    };
    let each = nearest
        .xyz
        .iter()
        .zip(&nearest.delta_e)
        .zip(&nearest.delta_e_ab);
    let each = each.zip(swatches);
    let mut each: Vec<Value> = each.map(one).collect();
    if each.len() == 1 {
        each.remove(0)
    } else {
        Value::Array(each)
    }
}
