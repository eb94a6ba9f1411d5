//! Measurements from spectra and files, and as CSV with a column of sigma and keys for the rest.
//!
//! Own CSV holds a spectrum in a column, `sigma of NAME` in the next one and what else is known in
//! comments; a cell is empty where the mask leaves a sample out. Own JSON has it under a key. Both are
//! read back bit for bit; readers that know nothing of it see one column, or key, more.

use serde_json::Value;

use super::stored_doubt::StoredDoubt;
use crate::{
    io::{Column, Columns, Provenance, csv, encode, one_line, shortest},
    measurements::{Kernel, Measurement, MeasurementError, Quantity, Slit, quantity_of},
    spectrum::{Kind, NamedSpectrum, Sampled},
};

/// What stands before a spectrum's name above the column of its sigma.
const SIGMA_OF: &str = "sigma of ";

/// Title of the column of wavelengths.
const NM: &str = "wavelength_nm,";

/// Words that other programs call a standard deviation by.
const DEVIATIONS: [&str; 9] = [
    "sd", "std", "stdev", "sigma", "u", "error", "\u{b1}", "+-", "+/-",
];

/// The same in several words.
const PHRASES: [&str; 5] = [
    "standard deviation",
    "standard uncertainty",
    "std. dev",
    "std dev",
    "uncertainty",
];

/// Whether a spectrum of this name is the sigma of the one before it.
pub fn is_sigma(name: &str) -> bool {
    name.starts_with(SIGMA_OF)
}

/// Whether a title says that its column is the sigma of the one before it, which is called `of`:
/// true in this program's words, false in another's, who may mean something else by them; `None`
/// where it says nothing of the kind.
pub fn is_sigma_of(title: &str, of: &str) -> Option<bool> {
    if is_sigma(title) {
        return Some(true);
    }
    let mut title = title.to_lowercase();
    if !of.is_empty() {
        title = title.replace(&of.to_lowercase(), " ");
    }
    for phrase in PHRASES {
        title = title.replace(phrase, " sd ");
    }
    let words = title.split(|c: char| c.is_whitespace() || "_()[]:,;".contains(c));
    let mut words = words
        .filter(|word| !matches!(word.trim_end_matches('.'), "" | "of"))
        .peekable();
    words.peek()?;
    let is_deviation = |word: &str| DEVIATIONS.contains(&word.trim_end_matches('.'));
    words.all(is_deviation).then_some(false)
}

/// The measurement that a spectrum is, with the sigma that stands beside it.
///
/// # Errors
/// A sentence for what is no measurement.
pub fn measurement(
    spectrum: &NamedSpectrum,
    sigma: Option<&NamedSpectrum>,
) -> Result<Measurement, MeasurementError> {
    let quantity = quantity_of(&spectrum.name, spectrum.kind, &spectrum.unit)?;
    let samples = spectrum.samples.clone();
    let mut found = Measurement::new(&spectrum.name, quantity, &spectrum.unit, samples);
    let beside = sigma.filter(|s| s.samples.nm() == spectrum.samples.nm());
    found.sigma = beside
        .map(|s| s.samples.values())
        .filter(|values| values.iter().all(|v| *v >= 0.0))
        .map(<[f64]>::to_vec);
    Ok(found)
}

/// The measurement of a spectrum and what is known beside its values; `None` where the two do not
/// belong together.
pub fn measured_of(spectrum: &NamedSpectrum, doubt: StoredDoubt) -> Option<Measurement> {
    let quantity = quantity_of(&spectrum.name, spectrum.kind, &spectrum.unit).ok()?;
    doubt.on(spectrum, quantity)
}

/// The spectrum that a measurement is, without samples that hold no value.
pub fn spectrum(of: &Measurement, made_by: &str) -> NamedSpectrum {
    let kept = |values: &[f64]| -> Vec<f64> {
        let all = values.iter().enumerate();
        all.filter(|(i, _)| of.is_kept(*i))
            .map(|(_, v)| *v)
            .collect()
    };
    let samples = Sampled::new(kept(of.samples.nm()), kept(of.samples.values()));
    NamedSpectrum {
        name: of.name.clone(),
        kind: of.quantity.kind(),
        unit: of.unit.clone(),
        scale: 1.0,
        // Fewer than two are kept: the mask's zeros are all there is.
        samples: samples.unwrap_or_else(|_| of.samples.clone()),
        notes: Vec::new(),
        source: made_by.to_owned(),
    }
}

pub fn measurement_csv(of: &Measurement, made_by: &str) -> String {
    let or_empty = |values: &[f64]| -> Vec<f64> {
        let all = values.iter().enumerate();
        all.map(|(i, v)| if of.is_kept(i) { *v } else { f64::NAN })
            .collect()
    };
    let title = match one_line(&of.name) {
        name if name.parse::<f64>().is_ok() || name.is_empty() => format!("spectrum {name}"),
        name => name.to_owned(),
    };
    let mut columns = vec![Column {
        title: title.clone(),
        values: or_empty(of.samples.values()),
    }];
    if let Some(sigma) = &of.sigma {
        columns.push(Column {
            title: format!("{SIGMA_OF}{title}"),
            values: or_empty(sigma),
        });
    }
    let columns = Columns {
        nm: of.samples.nm().to_vec(),
        columns,
    };
    let named = NamedSpectrum {
        source: String::new(),
        ..spectrum(of, "")
    };
    let text = csv(&named, &columns, &provenance());
    let keys: String = keys(of, made_by)
        .into_iter()
        .map(|(key, value)| format!("# {key}: {}\n", one_line(&value)))
        .collect();
    match text.find(NM) {
        Some(start) => format!("{}{keys}{}", &text[..start], &text[start..]),
        None => text,
    }
}

fn provenance() -> Provenance {
    Provenance {
        program: format!("Spectral Explorer {}", env!("CARGO_PKG_VERSION")),
        scale_words: "as measured".to_owned(),
        ..Provenance::default()
    }
}

/// What is known beside the values, by its key.
fn keys(of: &Measurement, made_by: &str) -> Vec<(&'static str, String)> {
    let mut keys = Vec::new();
    if of.level > 0.0 {
        keys.push(("level", shortest(of.level)));
    }
    if of.axis_nm > 0.0 {
        keys.push(("axis_nm", shortest(of.axis_nm)));
    }
    if !of.memory.is_empty() {
        let all: Vec<String> = of.memory.iter().map(|rho| shortest(*rho)).collect();
        keys.push(("memory", format!("1 {}", all.join(" "))));
    }
    if let Some(scans) = of.scans {
        keys.push(("scans", scans.to_string()));
    }
    if let Some(slit) = of.slit {
        keys.push((
            "slit",
            format!("{} {}", shortest(slit.fwhm_nm), slit.shape.word()),
        ));
    }
    if !made_by.is_empty() {
        keys.push(("made_by", made_by.to_owned()));
    }
    keys
}

/// Whether the head of a file is that of one of this program's that may hold more than values.
pub fn states_doubt(head: &str) -> bool {
    head.contains(&format!("\n{NM}")) || head.contains(SPECTRUM_JSON)
}

/// The format word of a spectrum as JSON.
const SPECTRUM_JSON: &str = "spectral-explorer-spectrum";

/// The key of what such a file holds beside the values.
const DOUBT: &str = "doubt";

/// A measurement as this program's JSON of a spectrum, with what is known beside its values.
///
/// # Errors
/// A sentence where it cannot be written.
fn measurement_json(of: &Measurement, made_by: &str) -> Result<String, String> {
    let named = spectrum(of, made_by);
    let text = encode("json", &named, &Columns::measured(&named), &provenance())?;
    let doubt = serde_json::to_string(&StoredDoubt::of(of)).map_err(|why| why.to_string())?;
    // Behind the rest: a file is known by its beginning.
    let rest = text.trim_end().trim_end_matches('}');
    Ok(format!("{rest},\"{DOUBT}\":{doubt}}}\n"))
}

/// A measurement in the format of an extension that keeps all that is known of it; `None` for an
/// extension that does not.
///
/// # Errors
/// A sentence where it cannot be written.
pub fn measurement_as(
    extension: &str,
    of: &Measurement,
    made_by: &str,
) -> Option<Result<String, String>> {
    match extension {
        "csv" => Some(Ok(measurement_csv(of, made_by))),
        "json" => Some(measurement_json(of, made_by)),
        _ => None,
    }
}

/// True if more is known of a measurement than its values.
pub fn has_doubt(of: &Measurement) -> bool {
    of.sigma.is_some()
        || !of.mask.is_empty()
        || of.level > 0.0
        || of.axis_nm > 0.0
        || of.scans.is_some()
        || of.slit.is_some()
}

/// What an extension loses of a measurement, in a sentence; `None` where that is nothing.
pub fn lost_of_measurement(extension: &str, of: &Measurement) -> Option<String> {
    let keeps_all = matches!(extension, "csv" | "json");
    let is_more = of.sigma.is_some() || !of.mask.is_empty();
    (is_more && !keeps_all).then(|| {
        tr!(
            ".{extension} keeps neither sigma nor what is masked: .csv and .json keep both",
            extension
        )
    })
}

/// The measurement in this program's JSON of a spectrum; `None` where nothing but values is known.
fn measurement_of_json(text: &str) -> Option<Measurement> {
    let mut all: Value = serde_json::from_str(text).ok()?;
    if all["format"] != SPECTRUM_JSON {
        return None;
    }
    let doubt: StoredDoubt = serde_json::from_value(all[DOUBT].take()).ok()?;
    let numbers =
        |list: &Value| -> Option<Vec<f64>> { list.as_array()?.iter().map(Value::as_f64).collect() };
    let words = |key: &str| all[key].as_str().unwrap_or_default().to_owned();
    let (nm, values) = (numbers(&all["wavelengths_nm"])?, numbers(&all["values"])?);
    let named = NamedSpectrum {
        name: words("name"),
        kind: serde_json::from_value(all["kind"].clone()).ok()?,
        unit: words("unit"),
        scale: 1.0,
        samples: Sampled::new(nm, values).ok()?,
        notes: Vec::new(),
        source: String::new(),
    };
    measured_of(&named, doubt)
}

/// The measurement in a file of this program that holds one spectrum and more than its values;
/// `None` for every other text.
pub fn own_measurement(text: &str) -> Option<Measurement> {
    if text.trim_start().starts_with('{') {
        return measurement_of_json(text);
    }
    let (head, table) = text.split_at(text.find(&format!("\n{NM}"))? + 1);
    let value = |key: &str| {
        let start = format!("# {key}: ");
        head.lines().find_map(|line| line.strip_prefix(&start))
    };
    let mut lines = table.lines();
    let titles: Vec<&str> = lines.next()?.split(',').collect();
    let sigma = titles.last().filter(|_| titles.len() == 3);
    let has_sigma = sigma.is_some_and(|t| t.trim_matches('"').starts_with(SIGMA_OF));
    let has_key = ["level", "axis_nm", "memory", "scans", "slit", "made_by"];
    let has_key = has_key.iter().any(|key| value(key).is_some());
    if titles.len() != 2 + usize::from(has_sigma) || !(has_sigma || has_key) {
        return None;
    }
    let (mut nm, mut values, mut sigma, mut mask) = (vec![], vec![], vec![], vec![]);
    for line in lines.filter(|line| !line.is_empty()) {
        let cells: Vec<&str> = line.split(',').collect();
        let number = |k: usize| match cells.get(k).copied().unwrap_or_default() {
            "" => Some(None),
            cell => cell.parse::<f64>().ok().map(Some),
        };
        nm.push(number(0)??);
        let found = number(1)?;
        mask.push(found.is_none());
        values.push(found.unwrap_or(0.0));
        sigma.push(number(2)?.unwrap_or(0.0));
    }
    let kind: Kind =
        value("kind").and_then(|word| Kind::ALL.into_iter().find(|k| k.word() == word))?;
    let (name, unit) = (
        value("name").unwrap_or_default(),
        value("unit").unwrap_or_default(),
    );
    let quantity = quantity_of(name, kind, unit).ok()?;
    let mut found = Measurement::new(name, quantity, unit, Sampled::new(nm, values).ok()?);
    let number = |key: &str| {
        value(key)
            .and_then(|v| v.parse::<f64>().ok())
            .filter(|v| *v >= 0.0)
    };
    found.sigma = has_sigma.then_some(sigma);
    found.level = number("level").unwrap_or(0.0);
    found.axis_nm = number("axis_nm").unwrap_or(0.0);
    found.scans = value("scans").and_then(|v| v.parse().ok());
    let memory = value("memory")
        .unwrap_or_default()
        .split_whitespace()
        .skip(1);
    found.memory = memory.filter_map(|v| v.parse().ok()).collect();
    found.slit = value("slit").and_then(|v| {
        let (fwhm, shape) = v.split_once(' ')?;
        let fwhm_nm = fwhm.parse::<f64>().ok().filter(|v| *v > 0.0)?;
        Some(Slit {
            shape: Kernel::from_word(shape)?,
            fwhm_nm,
        })
    });
    if mask.contains(&true) {
        found.mask = mask;
        found.why_masked = "The file has no value".to_owned();
    }
    Some(found)
}

/// Whether figures of light are told of it.
pub fn is_light(of: &Measurement) -> bool {
    of.quantity == Quantity::Light
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn measurements_come_back_from_csv_bit_for_bit() {
        let nm = vec![400.0, 400.1, 401.0 / 3.0 * 3.1];
        let samples = Sampled::new(nm, vec![1.0 / 3.0, 0.0, -2e-17]).expect("rising");
        let mut light = Measurement::new("a lamp", Quantity::Light, "W m-2 nm-1", samples);
        light.sigma = Some(vec![0.1, 0.0, 1.0 / 7.0]);
        light.mask = vec![false, true, false];
        light.why_masked = "The file has no value".to_owned();
        light.level = 0.01 / 3.0;
        light.axis_nm = 0.1;
        light.memory = vec![0.5, 1.0 / 3.0];
        light.scans = Some(5);
        light.slit = Some(Slit {
            shape: Kernel::Gauss,
            fwhm_nm: 7.5,
        });
        let text = measurement_csv(&light, "mean of 5 scans");
        assert!(
            text.contains("\nwavelength_nm,a lamp,sigma of a lamp\n"),
            "{text}"
        );
        assert!(text.contains("# made_by: mean of 5 scans\n"), "{text}");
        assert!(text.contains("\n400.1,,\n"), "{text}");
        assert_eq!(own_measurement(&text), Some(light.clone()));
        // Readers that know nothing of it see one column more.
        let reading = crate::io::read_bytes("lamp.csv", text.as_bytes()).expect("own CSV");
        let names: Vec<&str> = reading.spectra.iter().map(|s| s.name.as_str()).collect();
        assert_eq!(names, ["a lamp", "sigma of a lamp"]);
        assert_eq!(own_measurement("nm,x\n400,1\n500,1\n"), None);
    }

    #[test]
    fn the_sigma_of_a_measurement_is_known_by_its_title() {
        assert!(is_sigma("sigma of x"));
        assert!(!is_sigma("sodium"));
        let foreign = [
            "sd",
            "Standard deviation",
            "Std. dev.",
            "Std",
            "lamp sd",
            "u(lamp)",
            "STDEV of lamp",
            "\u{b1}",
            "lamp +-",
        ];
        for title in foreign {
            assert_eq!(is_sigma_of(title, "lamp"), Some(false), "{title}");
        }
        for title in ["lamp", "sodium", "lamp 2", "u_v", ""] {
            assert_eq!(is_sigma_of(title, "lamp"), None, "{title}");
        }
    }
}
