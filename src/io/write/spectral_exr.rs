//! Spectral OpenEXR out: a picture of reflectances, one channel a band.
//!
//! The layout is that of Fichet, Pacanowski and Wilkie, JCGT 10(3), 2021: `T.550,000000nm` is the
//! reflectance at 550 nm. `io/spectral_exr.rs` reads it back.

use std::io::Cursor;

use exr::{
    image::{AnyChannel, AnyChannels, FlatSamples, Image, Layer},
    meta::attribute::{AttributeValue, Text},
    prelude::{Encoding, LayerAttributes, SmallVec, WritableImage},
};

/// A picture as a file; `planes` hold a band each, row after row from the top, and `facts` become
/// attributes (`made.light` for "light").
///
/// # Errors
/// What the encoder says, in words.
pub fn reflectance_exr(
    [width, height]: [usize; 2],
    bands_nm: &[f64],
    planes: Vec<Vec<f32>>,
    facts: &[(&str, String)],
) -> Result<Vec<u8>, String> {
    let agrees = planes.iter().all(|plane| plane.len() == width * height);
    if !agrees || planes.len() != bands_nm.len() {
        return Err("found planes of another size, expected one value a pixel and band".to_owned());
    }
    let channels: SmallVec<[AnyChannel<FlatSamples>; 4]> = bands_nm
        .iter()
        .zip(planes)
        .map(|(nm, plane)| {
            let place = format!("{nm:.6}").replace('.', ",");
            let name = format!("T.{place}nm");
            AnyChannel::new(name.as_str(), FlatSamples::F32(plane))
        })
        .collect();
    let mut layer = Layer::new(
        (width, height),
        LayerAttributes::default(),
        Encoding::FAST_LOSSLESS,
        AnyChannels::sort(channels),
    );
    let version = [("spectralLayoutVersion".to_owned(), "1.0".to_owned())];
    let facts = facts
        .iter()
        .map(|(key, value)| (format!("made.{key}"), value.clone()));
    for (key, value) in version.into_iter().chain(facts) {
        let (Some(key), Some(value)) = (Text::new_or_none(&key), Text::new_or_none(&value)) else {
            continue;
        };
        let value = AttributeValue::Text(value);
        layer.attributes.other.insert(key, value);
    }
    let mut file = Cursor::new(Vec::new());
    let written = Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut file);
    written.map_err(|why| format!("found {why}, expected to write OpenEXR"))?;
    Ok(file.into_inner())
}
