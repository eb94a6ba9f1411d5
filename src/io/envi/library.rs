//! An ENVI spectral library: `lines` spectra of `samples` channels.

use crate::spectrum::NamedSpectrum;
use crate::spectrum::cube::{bytes_of, is_missing};

use super::super::curve;
use super::super::many::many;
use super::super::reading::AxisTold;
use super::super::reading::provenance;
use super::super::{Choices, Guess, ReadError, Reading, budget};
use super::header::Header;
use super::meaning;

/// Memory of a spectrum besides its samples: names, notes, guesses, in bytes.
const SPECTRUM_BYTES: usize = 1500;

/// Memory of a sample: wavelength and value, and both again while they are put in order.
const SAMPLE_BYTES: usize = 32;

/// How many values of the file decide kind and scale where the header is silent.
const LOOKED_AT: usize = 20_000;

/// Reads the spectra; `file_bytes` is the size of both files.
///
/// # Errors
/// [`ReadError`] when the data are too short, or the header gives no wavelengths.
pub fn read(
    header: &Header,
    data: &[u8],
    data_name: &str,
    file_bytes: usize,
    choices: &Choices,
) -> Result<Reading, ReadError> {
    let (channels, count) = (header.samples, header.lines);
    let size = bytes_of(channels, count, header.bands, header.number);
    let need = size.and_then(|size| size.checked_add(header.offset));
    if header.bands != 1 {
        let found = format!("a library with bands = {}", header.bands);
        return Err(header.error("bands", found, "bands = 1"));
    }
    if need.is_none_or(|need| data.len() < need) {
        return Err(short(header, data.len(), data_name));
    }
    let axis = meaning::channels(header, channels, choices.wavelengths)?;
    let memory = count.saturating_mul(SPECTRUM_BYTES + SAMPLE_BYTES * axis.bands.len());
    if memory > budget::of(file_bytes) {
        let found = format!("{count} spectra, which take {}", budget::in_words(memory));
        return Err(header.error("lines", found, budget::WORDS));
    }
    let row_bytes = channels * header.number.bytes();
    let missing = header.number("data ignore value")?;
    let value = |spectrum: usize, channel: usize| {
        let at = header.offset + spectrum * row_bytes + channel * header.number.bytes();
        let value = header.number.read(data, at, header.big_endian);
        if missing.is_some_and(|missing| is_missing(value, missing, header.number)) {
            f64::NAN
        } else {
            value
        }
    };
    let total = channels * count;
    let sample: Vec<f64> = (0..total)
        .step_by(total.div_ceil(LOOKED_AT).max(1))
        .map(|i| value(i / channels, i % channels))
        .collect();
    let meaning = meaning::values(header, data_name, &sample)?;
    let names = header.list("spectra names");
    let nm: Vec<f64> = axis.bands.iter().map(|(nm, _)| *nm).collect();

    let mut reading = Reading::default();
    let mut empty = 0_usize;
    for index in 0..count {
        let values: Vec<f64> = axis
            .bands
            .iter()
            .map(|(_, channel)| value(index, *channel))
            .collect();
        let Ok(cleaned) = curve::clean(&nm, &values) else {
            empty += 1;
            continue;
        };
        let name = names.get(index).filter(|name| !name.is_empty());
        let at = reading.spectra.len();
        let mut spectrum = NamedSpectrum {
            name: name.map_or_else(|| format!("spectrum {}", index + 1), |n| (*n).to_owned()),
            kind: meaning.kind,
            unit: meaning.unit.clone(),
            scale: meaning.scale,
            samples: cleaned.samples.scaled(meaning.scale),
            notes: Vec::new(),
            source: data_name.to_owned(),
        };
        spectrum.notes.push(provenance(&spectrum, &[]));
        spectrum.notes.extend(cleaned.notes);
        if at == 0 {
            let spectra = many(count, "spectrum", "spectra");
            let line = format!("library of {spectra}: {}", spectrum.notes[0]);
            reading.notes.push(line);
        }
        let of_it = meaning.guesses.iter().chain(&axis.guessed);
        reading.guesses.extend(of_it.map(|guess| Guess {
            spectrum: at,
            ..guess.clone()
        }));
        reading.spectra.push(spectrum);
    }
    if reading.spectra.is_empty() {
        return Err(ReadError::new(
            data_name,
            "a library in which nothing was measured",
            "at least 2 numbers in a spectrum",
        ));
    }
    if empty > 0 {
        let note = format!("{empty} spectra with fewer than 2 numbers left out");
        reading.notes.push(note);
    }
    if !names.is_empty() && names.len() != count {
        let note = format!("{} names for {count} spectra", names.len());
        reading.notes.push(note);
    }
    if need.is_some_and(|need| data.len() > need) {
        let note = format!(
            "{} bytes behind the last spectrum passed over",
            data.len() - need.unwrap_or(0)
        );
        reading.notes.push(note);
    }
    reading.notes.extend(axis.notes);
    reading.axis = Some(AxisTold::Unit(axis.told));
    reading.notes.extend(meaning.notes);
    Ok(reading)
}

/// The refusal of data that end too early.
pub fn short(header: &Header, found: usize, data_name: &str) -> ReadError {
    ReadError::new(
        data_name,
        format!("{found} bytes"),
        format!(
            "{} x {} x {} numbers of {} bytes after {} bytes, as {} says",
            header.samples,
            header.lines,
            header.bands,
            header.number.bytes(),
            header.offset,
            header.file
        ),
    )
}
