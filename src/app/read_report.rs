//! What a file holds and how it was read: what `read` prints, in words or as JSON.
//!
//! Values are the file's own numbers, before per cent, scale factors and norms (`scale` takes
//! them to the spectrum's unit); wavelengths are nm. docs/command_line.md tells the keys.

use std::{borrow::Cow, fmt::Write as _, path::Path};

use serde_json::{Value, json};

use super::{readings, ticks::short};
use crate::{
    io::{
        CompositeFile, MakersResult, ReadError, Reading,
        many::{many, numbers},
        shown,
    },
    spectrum::{NamedSpectrum, SpectralImage},
};

/// Spectra of one file that the words tell one by one.
const MOST_TOLD: usize = 12;

/// One file as JSON: what was read, or the refusal under `error`.
pub fn json(path: &Path, read: &Result<Reading, ReadError>) -> Value {
    let file = path.display().to_string();
    match read {
        Ok(reading) => {
            let Reading {
                file: _,
                format,
                spectra,
                composites,
                table: _,
                cut_by: _,
                understood: _,
                images_understood: _,
                results,
                images,
                guesses: _,
                facts: _,
                in_front: _,
                notes,
            } = reading;
            json!({
                "file": file,
                "format": format,
                "spectra": listed(spectra, images).iter().map(|s| spectrum_json(s)).collect::<Vec<_>>(),
                "composites": composites.iter().map(composite_json).collect::<Vec<_>>(),
                "images": images.iter().map(image_json).collect::<Vec<_>>(),
                "makers_results": results.iter().map(result_json).collect::<Vec<_>>(),
                "notes": notes,
                "error": null,
            })
        }
        Err(refusal) => json!({
            "file": file,
            "format": null,
            "spectra": [],
            "composites": [],
            "images": [],
            "makers_results": [],
            "notes": [],
            "error": refusal.to_string(),
        }),
    }
}

/// The spectra that are listed: the file's own, and of a file with none the first, the last and
/// the middle pixel of its images.
fn listed<'a>(
    spectra: &'a [NamedSpectrum],
    images: &[SpectralImage],
) -> Vec<Cow<'a, NamedSpectrum>> {
    if !spectra.is_empty() {
        return spectra.iter().map(Cow::Borrowed).collect();
    }
    let probes = images.iter().flat_map(SpectralImage::probes);
    probes.map(Cow::Owned).collect()
}

/// One spectrum in the file's own numbers.
fn spectrum_json(spectrum: &NamedSpectrum) -> Value {
    let NamedSpectrum {
        name,
        kind,
        unit,
        scale,
        samples,
        notes,
        source,
    } = spectrum;
    let own: Vec<f64> = samples.values().iter().map(|v| own(*v, *scale)).collect();
    let highest = own
        .iter()
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(b.1).then(b.0.cmp(&a.0)));
    let [counts, clipped] = readings::Reading::of(spectrum, false).keys();
    json!({
        "counts": counts.1,
        "clipped": clipped.1,
        "name": name,
        "kind": kind.word(),
        "unit": unit,
        "scale": scale,
        "points": samples.len(),
        "first_nm": samples.first_nm(),
        "last_nm": samples.last_nm(),
        "first_value": own.first(),
        "last_value": own.last(),
        "sum": own.iter().sum::<f64>(),
        "max": highest.map(|(_, max)| max),
        "max_at_nm": highest.map(|(index, _)| samples.nm()[index]),
        "notes": notes,
        "source": source,
    })
}

fn image_json(image: &SpectralImage) -> Value {
    let cube = &image.cube;
    json!({
        "name": image.name,
        "kind": image.kind.word(),
        "unit": image.unit,
        "width": cube.width(),
        "height": cube.height(),
        "bands": cube.nm().len(),
        "first_nm": cube.nm().first(),
        "last_nm": cube.nm().last(),
    })
}

fn result_json(result: &MakersResult) -> Value {
    let MakersResult {
        spectrum,
        quantity,
        value,
        unit,
        as_written,
    } = result;
    json!({
        "spectrum": spectrum.map(|index| index + 1),
        "quantity": quantity.to_string(),
        "value": value,
        "unit": unit,
        "as_written": as_written,
    })
}

fn composite_json(file: &CompositeFile) -> Value {
    let CompositeFile {
        composite,
        unit,
        source,
        name,
        kind,
    } = file;
    json!({
        "name": name,
        "kind": kind.word(),
        "unit": unit,
        "source": source,
        "range_nm": [composite.band().min_nm(), composite.band().max_nm()],
        "basis": composite.smooth().basis.word(),
        "order": composite.smooth().order(),
        "spikes": composite.lines().len(),
        "numbers": composite.numbers(),
    })
}

/// A value in the file's own number. The scale was multiplied, so that the last bits of the
/// quotient may differ from what the file says: fifteen figures do not.
fn own(value: f64, scale: f64) -> f64 {
    if scale == 1.0 {
        return value;
    }
    let quotient = value / scale;
    format!("{quotient:.14e}").parse().unwrap_or(quotient)
}

/// One file for people.
pub fn text(path: &Path, read: &Result<Reading, ReadError>) -> String {
    let reading = match read {
        Ok(reading) => reading,
        Err(refusal) => return format!("{refusal}\n"),
    };
    let mut out = format!("{}: {}\n", shown(path), reading.format);
    // Writing to a String cannot fail.
    let mut line = |text: String| {
        let _ = writeln!(out, "  {text}");
    };
    for image in &reading.images {
        let how = image.notes.first().map_or("", String::as_str);
        line(format!("{}: {how}", image.name));
    }
    if reading.spectra.is_empty() {
        for probe in listed(&[], &reading.images) {
            let samples = &probe.samples;
            let values = || samples.values().iter();
            line(format!(
                "{}: {} points, lowest {}, highest {}",
                probe.name,
                samples.len(),
                short(values().copied().fold(f64::INFINITY, f64::min)),
                short(values().copied().fold(f64::NEG_INFINITY, f64::max)),
            ));
        }
    }
    for spectrum in reading.spectra.iter().take(MOST_TOLD) {
        let how = spectrum.notes.first().map_or("", String::as_str);
        line(format!("{}: {how}", spectrum.name));
        for note in spectrum.notes.iter().skip(1) {
            line(format!("  {note}"));
        }
        for said in readings::Reading::of(spectrum, false).sentences() {
            line(format!("  {said}"));
        }
    }
    let left = reading.spectra.len().saturating_sub(MOST_TOLD);
    if left > 0 {
        line(format!(
            "and {}",
            many(left, "more spectrum", "more spectra")
        ));
    }
    for file in &reading.composites {
        let band = file.composite.band();
        line(format!(
            "{}: a composite of {} on {}-{} nm",
            file.name,
            numbers(file.composite.numbers()),
            short(band.min_nm()),
            short(band.max_nm()),
        ));
    }
    let told = |note: &&String| {
        !reading.spectra.iter().any(|s| s.notes.contains(note))
            && !reading.images.iter().any(|i| i.notes.first() == Some(note))
    };
    for note in reading.notes.iter().filter(told) {
        line(note.clone());
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::read_bytes;

    fn read(text: &str) -> Value {
        json(Path::new("a.csv"), &read_bytes("a.csv", text.as_bytes()))
    }

    #[test]
    fn the_numbers_are_the_files_own_and_the_scale_stands_beside_them() {
        let value = read("wavelength (nm),reflectance %\n390,14.249\n385,67.606\n380,7.3\n");
        let spectrum = &value["spectra"][0];
        assert_eq!(spectrum["scale"], 0.01);
        assert_eq!(
            (&spectrum["first_nm"], &spectrum["last_nm"]),
            (&json!(380.0), &json!(390.0))
        );
        assert_eq!(
            (&spectrum["first_value"], &spectrum["last_value"]),
            (&json!(7.3), &json!(14.249))
        );
        assert_eq!(
            (&spectrum["max"], &spectrum["max_at_nm"]),
            (&json!(67.606), &json!(385.0))
        );
        approx::assert_relative_eq!(
            spectrum["sum"].as_f64().unwrap(),
            89.155,
            max_relative = 1e-14
        );
        assert_eq!(value["error"], Value::Null);
    }

    #[test]
    fn a_refusal_is_told_under_error_with_no_spectra() {
        let value = read("no numbers here");
        assert_eq!(value["spectra"], json!([]));
        assert!(value["error"].as_str().unwrap().contains("expected"));
    }

    #[test]
    fn of_equal_highest_values_the_first_is_named() {
        let value = read("nm,v\n380,1\n385,3\n390,3\n395,2\n");
        assert_eq!(value["spectra"][0]["max_at_nm"], 385.0);
    }
}
