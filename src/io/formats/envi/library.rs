//! An ENVI spectral library: `lines` spectra of `samples` channels.

use crate::spectrum::cube::is_missing;

use super::header::Header;
use super::{all_bytes, meaning};
use crate::io::formats::spectral_image::guesses_in_words;
use crate::io::interpret::raw::{RawAxis, RawSpectrum};
use crate::io::many::many;
use crate::io::reading::remark::Remark;
use crate::io::{Input, ReadError, Reading, budget, interpret};

/// Memory of a spectrum besides its samples: names, notes, guesses, in bytes.
const SPECTRUM_BYTES: usize = 1500;

/// Memory of a sample: wavelength and value, and both again while they are put in order.
const SAMPLE_BYTES: usize = 32;

/// How many values of the file decide kind and scale where the header is silent.
const LOOKED_AT: usize = 20_000;

/// What the header calls a spectrum, or its number.
fn name_of(names: &[&str], index: usize) -> String {
    let named = names.get(index).filter(|name| !name.is_empty());
    named.map_or_else(
        || format!("spectrum {}", index + 1),
        |name| (*name).to_owned(),
    )
}

/// Reads the spectra; `file_bytes` is the size of both files.
///
/// # Errors
/// [`ReadError`] when the data are too short, or the header gives no wavelengths.
pub(super) fn read(
    header: &Header,
    data: &[u8],
    data_name: &str,
    file_bytes: usize,
    input: &Input,
) -> Result<Reading, ReadError> {
    let (channels, count) = (header.samples, header.lines);
    let need = all_bytes(header);
    if header.bands != 1 {
        let found = format!("a library with bands = {}", header.bands);
        return Err(header.error("bands", found, "bands = 1"));
    }
    if need.is_none_or(|need| data.len() < need) {
        return Err(short(header, data.len(), data_name));
    }
    let axis = meaning::channels(header, channels, input.choices.wavelengths)?;
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
    let (known, of_values) = meaning::values(header, data_name, &sample)?;
    let names = header.list("spectra names");
    let nm: Vec<f64> = axis.bands.iter().map(|(nm, _)| *nm).collect();

    let spectra = many(count, "spectrum", "spectra");
    let mut reading = Reading {
        in_front: format!("library of {spectra}: "),
        ..Reading::default()
    };
    let mut empty = 0_usize;
    for index in 0..count {
        let values: Vec<f64> = axis
            .bands
            .iter()
            .map(|(_, channel)| value(index, *channel))
            .collect();
        let name = name_of(&names, index);
        let raw = RawSpectrum {
            axis: RawAxis::Nm(&nm, Some(axis.axis.clone())),
            known: known.clone(),
            source: Some(data_name.to_owned()),
            ..RawSpectrum::light(name, &nm, values, "")
        };
        if interpret::add(raw, input, &mut reading).is_err() {
            empty += 1;
            continue;
        }
        if let Some(facts) = reading.facts.last_mut() {
            // Said once, of the whole file.
            let of_file = |remark: &Remark| matches!(remark, Remark::Kind | Remark::Counted);
            facts.remarks.retain(|remark| !of_file(remark));
            facts.against.clone_from(&axis.against);
            facts.tells_scale = false;
        }
    }
    if reading.spectra.is_empty() {
        return Err(ReadError::new(
            data_name,
            "a library in which nothing was measured",
            "at least 2 numbers in a spectrum",
        ));
    }
    let left_over = data.len() - need.unwrap_or(data.len());
    let odd = oddities(empty, names.len(), count, left_over);
    reading.notes.extend(odd);
    reading.notes.extend(axis.notes);
    reading.notes.extend(of_values);
    // What had to be guessed of the first spectrum, and of all others with it.
    let first = reading.facts.first().map(|facts| &facts.decisions);
    let guessed = first.map(|first| guesses_in_words(first, Remark::Kind));
    reading.notes.extend(guessed.into_iter().flatten());
    Ok(reading)
}

/// What is odd about a library: spectra without numbers, names that are not one for each of
/// `count` spectra, bytes that are left over.
fn oddities(empty: usize, names: usize, count: usize, left_over: usize) -> Vec<String> {
    let odd = [
        (empty > 0).then(|| format!("{empty} spectra with fewer than 2 numbers left out")),
        (names > 0 && names != count).then(|| format!("{names} names for {count} spectra")),
        (left_over > 0).then(|| format!("{left_over} bytes behind the last spectrum passed over")),
    ];
    odd.into_iter().flatten().collect()
}

/// The refusal of data that end too early.
pub(super) fn short(header: &Header, found: usize, data_name: &str) -> ReadError {
    ReadError::new(
        data_name,
        format!("{found} bytes"),
        format!(
            "{} after {} bytes, as {} says",
            header.numbers_in_words(),
            header.offset,
            header.file
        ),
    )
}
