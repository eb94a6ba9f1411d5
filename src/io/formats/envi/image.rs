//! An ENVI cube: a picture whose pixels are spectra.

use std::sync::Arc;

use crate::spectrum::cube::{Cube, CubeError};

use super::{Header, meaning};
use crate::io::formats::spectral_image::{self, RawImage};
use crate::io::{Choices, ReadError, Reading};

/// Reads a cube; its numbers stay as they are.
///
/// # Errors
/// [`ReadError`] when the data are too short, or the header gives no wavelengths.
pub(super) fn read(
    header: &Header,
    data: Vec<u8>,
    data_name: &str,
    choices: &Choices,
) -> Result<Reading, ReadError> {
    let kind = header.text("file type").unwrap_or("");
    if kind.to_lowercase().contains("classification") {
        let found = said!("a classification (classes, not spectra)");
        let expected = said!("a cube or a spectral library");
        return Err(header.error("file type", found, expected));
    }
    let channels = meaning::channels(header, choices.wavelengths)?;
    let (layout, bytes) = (header.layout()?, data.len() as u64);
    let (width, height) = (header.width, header.height);
    let cube = Cube::new(width, height, &channels.bands, layout, Arc::new(data));
    let cube = cube.map_err(|error| match error {
        CubeError::Short { found, .. } => header.short(found, data_name),
        CubeError::Empty | CubeError::Bands => header.error(
            "bands",
            error.to_string(),
            said!("an image of two or more bands"),
        ),
    })?;
    let (known, of_values) = meaning::values(header, data_name, &spectral_image::sample(&cube))?;
    let mut notes = channels.notes;
    notes.extend(of_values);
    notes.extend(meaning::left_over(header, bytes));
    let stem = data_name.rsplit_once('.').map(|(stem, _)| stem);
    let (nm, stored): (Vec<f64>, Vec<usize>) = channels.bands.into_iter().unzip();
    let raw = RawImage {
        name: stem.unwrap_or(data_name).to_owned(),
        source: data_name.to_owned(),
        bandwidth_nm: meaning::bandwidth_nm(header, &nm, &stored),
        cube,
        notes,
        known,
        axis: Some(channels.axis),
        against: channels.against,
    };
    let mut reading = Reading::default();
    spectral_image::add(raw, choices, &mut reading);
    Ok(reading)
}
