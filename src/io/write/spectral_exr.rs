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
    Ok(with_attributes_in_order(file.into_inner()))
}

/// The same file of one part with the attributes of its header by name, so that the same picture
/// is the same file each time: the encoder keeps them in a map of random order. What follows the
/// header stays where it is. Bytes that are no such file come back as they are.
pub fn with_attributes_in_order(mut file: Vec<u8>) -> Vec<u8> {
    // Behind the magic number and the version.
    const FIRST: usize = 8;
    let mut attributes: Vec<(Vec<u8>, Vec<u8>)> = Vec::new();
    let mut at = FIRST;
    loop {
        let Some(end) = end_of_attribute(&file, at) else {
            return file;
        };
        if end == at {
            break;
        }
        let name = file[at..].split(|byte| *byte == 0).next();
        attributes.push((name.unwrap_or_default().to_vec(), file[at..end].to_vec()));
        at = end;
    }
    attributes.sort();
    let sorted: Vec<u8> = attributes
        .into_iter()
        .flat_map(|(_, bytes)| bytes)
        .collect();
    file[FIRST..at].copy_from_slice(&sorted);
    file
}

/// Where the attribute that starts at a place ends: a name and a type, each ended by a zero, the
/// size of the value in 4 bytes, and the value. The place itself where the header ends.
fn end_of_attribute(file: &[u8], start: usize) -> Option<usize> {
    if *file.get(start)? == 0 {
        return Some(start);
    }
    let zero = |from: usize| Some(from + file.get(from..)?.iter().position(|byte| *byte == 0)?);
    let size_at = zero(zero(start)? + 1)? + 1;
    let size = file.get(size_at..)?.first_chunk::<4>()?;
    let end = size_at + 4 + usize::try_from(i32::from_le_bytes(*size)).ok()?;
    (end <= file.len()).then_some(end)
}
