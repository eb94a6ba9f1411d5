//! Instruments on disk: response, axis, slit and what is known of them, as JSON.

use serde_json::{Value, json};

use crate::{
    measurements::{AxisFound, Instrument, Kernel, Measurement, Quantity, Slit},
    spectrum::Sampled,
};

/// What the file says that it is.
const FORMAT: &str = "spectral-explorer-response";

/// Keys of an instrument, without its response.
pub fn keys(of: &Instrument) -> Value {
    let kept = of.factor.kept_values();
    let nm = of.factor.samples.nm().iter().zip(&kept);
    let mut told = nm.filter(|(_, k)| k.is_some()).map(|(nm, _)| *nm);
    let first = told.next();
    json!({
        "name": of.name,
        "serial": of.serial,
        "date": of.date,
        "known": of.known,
        "unit": of.unit,
        "level": of.factor.level,
        "first_nm": first,
        "last_nm": told.next_back().or(first),
        "axis": of.axis.as_ref().map(|axis| json!({
            "at_550_nm": axis.at_550_nm,
            "slope": axis.slope,
            "features": axis.features,
        })),
        "slit": of.slit.map(|slit| json!({ "fwhm_nm": slit.fwhm_nm, "shape": slit.shape.word() })),
    })
}

/// An instrument as its file.
pub fn text(of: &Instrument) -> String {
    let mut all = keys(of);
    all["format"] = json!(FORMAT);
    all["version"] = json!(1);
    all["factor"] = json!({
        "nm": of.factor.samples.nm(),
        "values": of.factor.kept_values(),
        "sigma": of.factor.sigma,
        "shared": of.factor.shared,
    });
    format!("{all:#}\n")
}

fn refused(found: &str) -> String {
    tr!(
        "found {found}, expected an instrument as combine instrument learn writes it",
        found
    )
}

/// The JSON of an instrument's file, which [`of`] has an instrument of.
///
/// # Errors
/// What was found and what was expected.
pub fn json_of(text: &str) -> Result<Value, String> {
    let all = serde_json::from_str::<Value>(text).map_err(|_| refused(said!("no JSON")))?;
    of(&all).map(|_| all)
}

/// The instrument in the JSON of its file.
///
/// # Errors
/// What was found and what was expected.
pub fn of(all: &Value) -> Result<Instrument, String> {
    if all["format"] != FORMAT {
        return Err(refused(said!("JSON of another kind")));
    }
    let words = |key: &str| all[key].as_str().unwrap_or_default().to_owned();
    match factor(all) {
        Some(factor) => Ok(Instrument {
            name: words("name"),
            serial: words("serial"),
            date: words("date"),
            known: words("known"),
            unit: words("unit"),
            axis: axis(&all["axis"]),
            slit: slit(&all["slit"]),
            factor,
        }),
        None => Err(refused(said!("no response that is one"))),
    }
}

fn numbers(value: &Value) -> Option<Vec<f64>> {
    value.as_array()?.iter().map(Value::as_f64).collect()
}

fn factor(all: &Value) -> Option<Measurement> {
    let of = &all["factor"];
    let nm = numbers(&of["nm"])?;
    let values = of["values"].as_array()?;
    let sigma = numbers(&of["sigma"])?;
    let mask: Vec<bool> = values.iter().map(Value::is_null).collect();
    let values: Vec<f64> = values.iter().map(|v| v.as_f64().unwrap_or(0.0)).collect();
    let shared = of["shared"].as_array()?.iter().map(numbers);
    let shared: Vec<Vec<f64>> = shared.collect::<Option<_>>()?;
    let is_as_long = |list: &[f64]| list.len() == nm.len() && list.iter().all(|v| v.is_finite());
    if !is_as_long(&sigma) || !shared.iter().all(|s| is_as_long(s)) {
        return None;
    }
    let samples = Sampled::new(nm, values).ok()?;
    let mut factor = Measurement::new("response", Quantity::Factor, "factor", samples);
    factor.sigma = Some(sigma);
    factor.shared = shared;
    factor.level = all["level"].as_f64().filter(|v| *v >= 0.0).unwrap_or(0.0);
    if mask.contains(&true) {
        factor.mask = mask;
        factor.why_masked = "The known light's reading is below 10 of its noise".to_owned();
    }
    Some(factor)
}

fn axis(of: &Value) -> Option<AxisFound> {
    let features = of["features"].as_array()?.iter();
    let features = features.map(|pair| Some((pair[0].as_f64()?, pair[1].as_f64()?)));
    Some(AxisFound {
        at_550_nm: of["at_550_nm"].as_f64()?,
        slope: of["slope"].as_f64()?,
        features: features.collect::<Option<_>>()?,
    })
}

fn slit(of: &Value) -> Option<Slit> {
    Some(Slit {
        shape: Kernel::from_word(of["shape"].as_str()?)?,
        fwhm_nm: of["fwhm_nm"].as_f64().filter(|v| *v > 0.0)?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_instrument_comes_back_from_its_file_bit_for_bit() {
        let samples = Sampled::even(400.0, 0.7, vec![0.0, 1.0 / 3.0, 2.0]).expect("finite");
        let mut factor = Measurement::new("response", Quantity::Factor, "factor", samples);
        factor.sigma = Some(vec![0.0, 0.1, 0.2]);
        factor.shared = vec![vec![0.01, 1.0 / 7.0, -0.01]];
        factor.level = 0.02;
        factor.mask = vec![true, false, false];
        factor.why_masked = "The known light's reading is below 10 of its noise".to_owned();
        let instrument = Instrument {
            name: "Flame".to_owned(),
            serial: "FLMS1".to_owned(),
            date: "2026-11-27".to_owned(),
            known: "black body 2856 K".to_owned(),
            unit: String::new(),
            axis: Some(AxisFound {
                at_550_nm: -1.8,
                slope: 0.001,
                features: vec![(430.3, -2.0), (517.3, -1.7)],
            }),
            slit: Some(Slit {
                shape: Kernel::Gauss,
                fwhm_nm: 1.5,
            }),
            factor,
        };
        let read = |text: &str| json_of(text).and_then(|all| of(&all));
        assert_eq!(read(&text(&instrument)), Ok(instrument));
        assert!(read("{}").is_err());
        assert!(read("nm,v").is_err());
    }
}
