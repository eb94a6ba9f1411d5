//! An ENVI spectral library: `lines` spectra of `samples` channels.

use super::{Header, meaning};
use crate::io::formats::spectral_image::guesses_in_words;
use crate::io::interpret::raw::{RawAxis, RawSpectrum};
use crate::io::reading::remark::Remark;
use crate::io::{Input, ReadError, Reading, budget, interpret};
use crate::languages::said;

/// Memory of a spectrum besides its samples: names, notes, guesses, in bytes.
const SPECTRUM_BYTES: usize = 1500;

/// Memory of a sample: wavelength and value, and both again while they are put in order.
const SAMPLE_BYTES: usize = 32;

/// The number of values that decide kind and scale where the header gives neither.
const LOOKED_AT: usize = 20_000;

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
    let (channels, count) = (header.channels, header.height);
    if header.width != 1 {
        let found = tr!("a library with bands = {bands}", bands = header.width);
        return Err(header.error("bands", found, "bands = 1"));
    }
    let need = header.bytes().filter(|need| *need <= data.len());
    let need = need.ok_or_else(|| header.short(data.len(), data_name))?;
    let axis = meaning::channels(header, input.choices.wavelengths)?;
    let memory = count.saturating_mul(SPECTRUM_BYTES + SAMPLE_BYTES * axis.bands.len());
    if memory > budget::of(file_bytes) {
        let found = tr!(
            "{n} spectra, which take {size}" | "{n} spectra, which take {size}" % count,
            size = budget::in_words(memory)
        );
        return Err(header.error("lines", found, said(budget::WORDS)));
    }
    let layout = header.layout()?;
    let value = |spectrum: usize, channel: usize| {
        let at = layout.place((1, count), (0, spectrum), channel);
        let value = layout.number.read(data, at, layout.big_endian);
        if layout.is_missing(value) {
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

    let mut reading = Reading {
        in_front: format!(
            "{}: ",
            tr!("library of {n} spectrum" | "library of {n} spectra" % count)
        ),
        ..Reading::default()
    };
    let mut empty = 0_usize;
    for index in 0..count {
        let channels = axis.bands.iter().map(|(_, channel)| *channel);
        let values = channels.map(|channel| value(index, channel)).collect();
        let name = match names.get(index) {
            Some(name) if !name.is_empty() => (*name).to_owned(),
            _ => format!("spectrum {}", index + 1),
        };
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
            said!("a library in which nothing was measured"),
            said!("at least 2 numbers in a spectrum"),
        ));
    }
    let odd = odd_words(empty, [names.len(), count], data.len() - need).into_iter();
    reading.notes.extend(odd.flatten().chain(axis.notes));
    reading.notes.extend(of_values);
    // What had to be guessed of the first spectrum, and of all others with it.
    let first = reading.facts.first().map(|facts| &facts.decisions);
    let guessed = first.map(|first| guesses_in_words(first, Remark::Kind));
    reading.notes.extend(guessed.into_iter().flatten());
    Ok(reading)
}

/// What is odd about a library: spectra without numbers, names for another count, bytes behind it.
fn odd_words(empty: usize, [named, count]: [usize; 2], left_over: usize) -> [Option<String>; 3] {
    [
        (empty > 0).then(|| {
            tr!("{n} spectra with fewer than 2 numbers left out"
                | "{n} spectra with fewer than 2 numbers left out" % empty)
        }),
        (named > 0 && named != count).then(|| {
            tr!(
                "{n} names for {spectra} spectra" | "{n} names for {spectra} spectra" % named,
                spectra = count
            )
        }),
        (left_over > 0).then(|| {
            tr!("{n} bytes behind the last spectrum passed over"
                | "{n} bytes behind the last spectrum passed over" % left_over)
        }),
    ]
}
