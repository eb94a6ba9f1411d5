//! A light's figures as JSON, with the keys of the command `light`.
//!
//! A figure that does not exist is `null`, and `notes` says why, beginning with its key.

use serde_json::{Map, Value, json};

use crate::color::quality::{ALPHA_OPIC_WORDS, Figures, HueBin, NoFigure, Radiometric, SAMPLES};

/// A light and its model, if there is one; every key is present, `null` where there is no figure.
///
/// Hue bins are given as points of the vector graphic: mean a'b' under test and reference over
/// the chroma of the mean reference point, so that `reference_ab` lies on the unit circle.
pub fn json(name: &str, measured: &Figures, model: Option<&Figures>) -> Value {
    beside(measured, model, |figures| of(name, figures))
}

/// As [`json()`] with what has no key there: all observers, single samples, shape, absolute values.
pub fn full_json(name: &str, measured: &Figures, model: Option<&Figures>) -> Value {
    beside(measured, model, |figures| {
        let mut object = of(name, figures);
        object.extend(rest(figures));
        object
    })
}

fn beside(
    measured: &Figures,
    model: Option<&Figures>,
    told: impl Fn(&Figures) -> Map<String, Value>,
) -> Value {
    let mut object = told(measured);
    let model = model.map_or(Value::Null, |model| Value::Object(told(model)));
    object.insert("model".to_owned(), model);
    Value::Object(object)
}

fn of(name: &str, figures: &Figures) -> Map<String, Value> {
    let mut why = Reasons(Vec::new());
    let cct = why.of("cct, duv", &figures.cct);
    let rendering = why.of("ra, r", &figures.rendering);
    let fidelity = why.of("rf, rg, hue_bins", &figures.fidelity);
    let dominant = why.of("dominant_nm, purity", &figures.dominant);
    let dominant_nm = dominant.and_then(|found| why.of("dominant_nm", &found.nm));
    let alpha = why.of("melanopic_der, alphaopic", &figures.alpha_opic);
    let xyz = why.of("xyz", &figures.xyz).map(|xyz| xyz.to_array());
    let xy = why.of("xy", &figures.xy[0]);
    let uv = why.of("uv", &figures.uv);
    let singles: Vec<(&str, Option<f64>)> = figures
        .singles()
        .map(|(single, value)| (single.key, why.of(single.key, value).copied()))
        .collect();
    let photons = why.of("ppfd_per_100lx", &figures.photons);
    let ssi = ssi(figures, &mut why);
    let bins = fidelity.map(|found| {
        let bins = found.bins.iter().map(|bin| bin.as_ref().map(bin_json));
        bins.collect::<Vec<_>>()
    });
    let alphaopic = alpha.map(|found| {
        let named = ALPHA_OPIC_WORDS.into_iter().zip(found.der);
        named
            .map(|(word, der)| (word.to_owned(), json!(der)))
            .collect::<Map<_, _>>()
    });
    let notes: Vec<String> = figures.notes.iter().cloned().chain(why.0).collect();
    let object = json!({
        "name": name,
        "xyz": xyz,
        "xy": xy,
        "uv": uv,
        "cct": cct.map(|cct| cct.kelvin),
        "duv": cct.map(|cct| cct.duv),
        "ra": rendering.map(|found| found.ra),
        "r": rendering.map(|found| found.indices()),
        "rf": fidelity.map(|found| found.rf),
        "rg": fidelity.map(|found| found.rg),
        "hue_bins": bins,
        "dominant_nm": dominant_nm,
        "purity": dominant.map(|found| found.purity),
        "melanopic_der": alpha.map(|found| found.melanopic_der()),
        "alphaopic": alphaopic,
        "ppfd_per_100lx": photons.map(|found| found.ppfd),
        "ssi": ssi,
        "notes": notes,
    });
    let mut object = match object {
        Value::Object(object) => object,
        _ => Map::new(),
    };
    let singles = singles.into_iter();
    object.extend(singles.map(|(key, value)| (key.to_owned(), json!(value))));
    object
}

/// Reasons for what is `null`, each once.
struct Reasons(Vec<String>);

impl Reasons {
    fn of<'a, T>(&mut self, keys: &str, figure: &'a Result<T, NoFigure>) -> Option<&'a T> {
        figure
            .as_ref()
            .map_err(|why| self.0.push(format!("{keys}: {why}")))
            .ok()
    }
}

fn ssi(figures: &Figures, why: &mut Reasons) -> Value {
    let similarity = why.of("ssi", &figures.similarity);
    let own = similarity.and_then(|found| why.of("ssi.reference, ssi.value", &found.of_cct));
    json!({
        "reference": own.map(|(reference, _)| reference.to_string()),
        "value": own.map(|(_, value)| value),
        "p3200": similarity.map(|found| found.p3200),
        "d55": similarity.map(|found| found.d55),
        "d65": similarity.map(|found| found.d65),
    })
}

fn bin_json(bin: &HueBin) -> Value {
    let HueBin {
        rf,
        rcs,
        rhs,
        test_ab,
        reference_ab,
        samples: _,
        test_xyz: _,
        reference_xyz: _,
    } = bin;
    json!({
        "rf": rf,
        "rcs": rcs,
        "rhs": rhs,
        "test_ab": test_ab,
        "reference_ab": reference_ab,
    })
}

fn rest(figures: &Figures) -> Map<String, Value> {
    let [_, xy_1964, xy_2015_2, xy_2015_10] = &figures.xy;
    let absolute = figures.absolute.as_ref().ok();
    let shape = figures.shape.as_ref().ok();
    let width = shape.and_then(|found| found.width.as_ref().ok());
    let alpha = figures.alpha_opic.as_ref().ok();
    let is_irradiance = absolute.is_some_and(|found| found.what == Radiometric::Irradiance);
    let samples = figures.fidelity.as_ref().ok().map(|found| &found.samples);
    debug_assert!(samples.is_none_or(|samples| samples.len() == SAMPLES));
    // Photons and melanopic light on a square metre: only of what falls on one.
    let on_a_surface = |value: Option<f64>| value.filter(|_| is_irradiance);
    let reasons: Vec<Value> = super::rows(figures)
        .into_iter()
        .filter_map(|row| Some(json!({ "key": row.key, "why": row.value.err()? })))
        .collect();
    let object = json!({
        "xy_1964": xy_1964.as_ref().ok(),
        "xy_2015_2": xy_2015_2.as_ref().ok(),
        "xy_2015_10": xy_2015_10.as_ref().ok(),
        "rf_samples": samples,
        "alphaopic_elr": alpha.map(|found| found.elr),
        "eppfd_per_100lx": figures.photons.as_ref().ok().map(|found| found.eppfd),
        "peak_nm": shape.and_then(|found| found.peak.as_ref().ok()).map(|peak| peak.nm),
        "centroid_nm": shape.and_then(|found| found.centroid_nm.as_ref().ok()),
        "fwhm_nm": width.map(|width| width.fwhm_nm),
        "absolute": absolute.map(|found| json!({
            "quantity": found.what.photometric_name(),
            "unit": found.what.photometric_unit(),
            "value": found.photometric,
            "radiometric": found.radiometric,
            "ppfd": on_a_surface(Some(found.ppfd)),
            "eppfd": on_a_surface(Some(found.eppfd)),
            "melanopic_edi":
                on_a_surface(alpha.map(|alpha| alpha.melanopic_edi(found.photometric))),
        })),
        "reasons": reasons,
    });
    match object {
        Value::Object(object) => object,
        _ => Map::new(),
    }
}
