//! An ENVI cube: a picture whose pixels are spectra.

use std::sync::Arc;

use crate::spectrum::SpectralImage;
use crate::spectrum::cube::{Cube, CubeError, Layout};

use super::super::reading::AxisTold;
use super::super::spectral_image;
use super::super::{Choices, Guess, ReadError, Reading};
use super::header::Header;
use super::library::short;
use super::meaning;

/// How many pixels decide kind and scale where the header is silent.
const LOOKED_AT: usize = 400;

/// Reads a cube; its numbers stay as they are.
///
/// # Errors
/// [`ReadError`] when the data are too short, or the header gives no wavelengths.
pub fn read(
    header: &Header,
    data: Vec<u8>,
    data_name: &str,
    choices: &Choices,
) -> Result<Reading, ReadError> {
    let kind = header.text("file type").unwrap_or("");
    if kind.to_lowercase().contains("classification") {
        let found = "a classification (classes, not spectra)";
        return Err(header.error("file type", found, "a cube or a spectral library"));
    }
    let channels = meaning::channels(header, header.bands, choices.wavelengths)?;
    let layout = Layout {
        first_byte: header.offset,
        number: header.number,
        big_endian: header.big_endian,
        interleave: header.interleave,
        stored_bands: header.bands,
        missing: header.number("data ignore value")?,
    };
    let cube = Cube::new(
        header.samples,
        header.lines,
        &channels.bands,
        layout,
        Arc::new(data),
    )
    .map_err(|error| match error {
        CubeError::Short { found, .. } => short(header, found, data_name),
        CubeError::Empty | CubeError::Bands => {
            header.error("bands", error.to_string(), "an image of two or more bands")
        }
    })?;
    let pixels = cube.width() * cube.height();
    let sample: Vec<f64> = (0..pixels)
        .step_by(pixels.div_ceil(LOOKED_AT).max(1))
        .flat_map(|i| cube.values_at(i % cube.width(), i / cube.width()))
        .collect();
    let values = meaning::values(header, data_name, &sample)?;
    let mut notes = channels.notes;
    notes.extend(values.notes);
    let stem = data_name
        .rsplit_once('.')
        .map_or(data_name, |(stem, _)| stem);
    let image = SpectralImage {
        name: stem.to_owned(),
        kind: values.kind,
        unit: values.unit,
        scale: values.scale,
        cube,
        notes,
        source: data_name.to_owned(),
    };
    let mut reading = spectral_image::reading(image);
    reading.axis = Some(AxisTold::Unit(channels.told));
    reading.image_guesses.clone_from(&values.guesses);
    for at in 0..reading.spectra.len() {
        let of_it = values.guesses.iter().chain(&channels.guessed);
        reading.guesses.extend(of_it.map(|guess| Guess {
            spectrum: at,
            ..guess.clone()
        }));
    }
    Ok(reading)
}
