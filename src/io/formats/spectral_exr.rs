//! Spectral OpenEXR: an image with one channel a wavelength.
//!
//! The layout is that of Fichet, Pacanowski and Wilkie, An OpenEXR Layout for Spectral Images,
//! JCGT 10(3), 2021. `S0.380,000000nm` is a channel of light at 380 nm (`S1` to `S3` are the other
//! Stokes components, passed over here), `T.380,000000nm` one of reflectance or transmittance, and
//! `T.380,0nm.400,0nm` how much light of 380 nm comes back at 400 nm: of such bispectral images
//! the diagonal is read, which is the reflectance without fluorescence. Decimals are marked by
//! commas, since points part the names of layers. Units are metres or hertz with any prefix. The
//! attribute `emissiveUnits` is the unit of light.
//!
//! Pictures of red, green and blue are refused: they hold no spectrum. Pixels and channels must
//! fit into the memory that a file of its size may take, which is checked before they are decoded.

use std::io::Cursor;
use std::sync::Arc;

use exr::image::{AnyChannel, AnyChannels, FlatSamples, Image, Layer, Layers};
use exr::meta::MetaData;
use exr::meta::attribute::AttributeValue;
use exr::prelude::{ReadChannels, ReadLayers, read as exr_reader};

use crate::spectrum::Kind;
use crate::spectrum::cube::{Cube, Interleave, Layout, Number};

use super::spectral_image::{self, RawImage};
use super::{Confidence, Format};
use crate::io::decode::guarded::guarded;
use crate::io::error::quoted;
use crate::io::interpret::factor_scale::KnownScale;
use crate::io::interpret::raw::Known;
use crate::io::reading::decision::Decision;
use crate::io::text::number;
use crate::io::{Input, ReadError, Reading, budget};

/// Spectral OpenEXR.
pub(crate) const FORMAT: Format = Format {
    name: "spectral OpenEXR",
    extensions: &["exr"],
    sniff,
    read,
};

/// Speed of light in nm Hz.
const LIGHT_NM_HZ: f64 = 299_792_458.0 * 1e9;

fn sniff(input: &Input) -> Confidence {
    Confidence::certain_if(input.bytes.starts_with(b"\x76\x2f\x31\x01"))
}

/// What a channel holds.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Channel {
    /// Light at a wavelength, nm.
    Light(f64),
    /// Another Stokes component than the first.
    Polarised,
    /// Reflectance or transmittance at a wavelength, nm.
    Factor(f64),
    /// Light of one wavelength that comes back at another.
    Reradiated,
    Other,
}

fn channel_of(name: &str) -> Channel {
    let Some((what, at)) = name.split_once('.') else {
        return Channel::Other;
    };
    let stokes = what.strip_prefix('S');
    match (what, stokes) {
        ("S0", _) => wavelength_nm(at).map_or(Channel::Other, Channel::Light),
        (_, Some("1" | "2" | "3")) if wavelength_nm(at).is_some() => Channel::Polarised,
        ("T", _) => match at.split_once('.') {
            Some((from, to)) => match (wavelength_nm(from), wavelength_nm(to)) {
                (Some(from), Some(to)) if from == to => Channel::Factor(from),
                (Some(_), Some(_)) => Channel::Reradiated,
                _ => Channel::Other,
            },
            None => wavelength_nm(at).map_or(Channel::Other, Channel::Factor),
        },
        _ => Channel::Other,
    }
}

/// The wavelength of `380,000000nm`, `0,38um`, `789THz`.
fn wavelength_nm(label: &str) -> Option<f64> {
    let (body, is_hertz) = match label.strip_suffix("Hz") {
        Some(body) => (body, true),
        None => (label.strip_suffix('m')?, false),
    };
    let end = body.rfind(|c: char| c.is_ascii_digit() || c == ',')? + 1;
    let factor = match &body[end..] {
        "" => 1.0,
        "Y" => 1e24,
        "Z" => 1e21,
        "E" => 1e18,
        "P" => 1e15,
        "T" => 1e12,
        "G" => 1e9,
        "M" => 1e6,
        "k" => 1e3,
        "h" => 1e2,
        "da" => 1e1,
        "d" => 1e-1,
        "c" => 1e-2,
        "m" => 1e-3,
        "u" => 1e-6,
        "n" => 1e-9,
        "p" => 1e-12,
        _ => return None,
    };
    let digits = body[..end].trim_end_matches(',');
    let value = number::number(digits, true).or_else(|| number::number(digits, false))?;
    let nm = if is_hertz {
        LIGHT_NM_HZ / (value * factor)
    } else if factor == 1e-9 {
        // As written, without the rounding of going to metres and back.
        value
    } else {
        value * (factor * 1e9)
    };
    (nm.is_finite() && nm > 0.0).then_some(nm)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let head = decoded(input, || {
        MetaData::read_from_buffered(Cursor::new(input.bytes), false)
    })?;
    check(input, &head)?;
    let image = decoded(input, || {
        exr_reader()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .all_layers()
            .all_attributes()
            .non_parallel()
            .from_buffered(Cursor::new(input.bytes))
    })?;

    let mut reading = Reading::default();
    let several = image.layer_data.len() > 1;
    for (number, layer) in image.layer_data.iter().enumerate() {
        let part = match several {
            true => format!(", layer {}", number + 1),
            false => String::new(),
        };
        for kind in [Kind::Light, Kind::Reflectance] {
            read_layer(input, &image, layer, &part, kind, &mut reading)?;
        }
    }
    if reading.images.is_empty() {
        return Err(input.error("fewer than two spectral channels a layer", "two or more"));
    }
    Ok(reading)
}

/// What the parser of others makes of the file.
fn decoded<T>(
    input: &Input,
    decode: impl FnOnce() -> exr::error::Result<T>,
) -> Result<T, ReadError> {
    let why = match guarded(decode) {
        Some(Ok(decoded)) => return Ok(decoded),
        Some(Err(error)) => format!(" ({error})"),
        None => String::new(),
    };
    let found = format!("a broken OpenEXR image{why}");
    Err(input.error(found, "one that can be decoded"))
}

/// Refuses what is no spectral image, or would take too much memory.
fn check(input: &Input, head: &MetaData) -> Result<(), ReadError> {
    let mut names: Vec<String> = Vec::new();
    let mut memory = 0_usize;
    for header in &head.headers {
        if header.deep {
            return Err(input.error("a deep OpenEXR image", "a flat one"));
        }
        let pixels = header.layer_size.0.saturating_mul(header.layer_size.1);
        let channels = header.channels.list.len();
        // Decoded samples, the copy that is kept, and a block on its way.
        memory = memory.saturating_add(pixels.saturating_mul(channels).saturating_mul(8));
        let channels = header.channels.list.iter();
        names.extend(channels.map(|channel| channel.name.to_string()));
    }
    let is_spectral =
        |name: &&String| matches!(channel_of(name), Channel::Light(_) | Channel::Factor(_));
    if names.iter().filter(is_spectral).count() < 2 {
        names.truncate(6);
        let names = quoted(&names.join(" "));
        return Err(input.error(
            format!("an OpenEXR image of the channels {names}"),
            "two or more spectral channels such as \"S0.380,0nm\" or \"T.380,0nm\"",
        ));
    }
    if memory > budget::of(input.bytes.len()) {
        let found = format!("an image that takes {} to decode", budget::in_words(memory));
        return Err(input.error(found, budget::WORDS));
    }
    Ok(())
}

/// A layer of any channels, and an image of such.
type AnyLayer = Layer<AnyChannels<FlatSamples>>;
type AnyImage = Image<Layers<AnyChannels<FlatSamples>>>;

/// The words of an attribute of a layer, or else of the whole image.
fn words_of(image: &AnyImage, layer: &AnyLayer, key: &str) -> Option<String> {
    let mut found = layer.attributes.other.iter().chain(&image.attributes.other);
    found.find_map(|(name, value)| match value {
        AttributeValue::Text(text) if *name == *key => Some(text.to_string()),
        _ => None,
    })
}

/// Adds the image that a layer holds of one kind, where it has two bands or more.
fn read_layer(
    input: &Input,
    image: &AnyImage,
    layer: &AnyLayer,
    part: &str,
    kind: Kind,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let (mut reradiated, mut polarised) = (0, 0);
    let mut bands: Vec<(f64, &AnyChannel<FlatSamples>)> = Vec::new();
    for channel in &layer.channel_data.list {
        match (channel_of(&channel.name.to_string()), kind) {
            (Channel::Light(nm), Kind::Light) | (Channel::Factor(nm), Kind::Reflectance) => {
                bands.push((nm, channel));
            }
            (Channel::Reradiated, Kind::Reflectance) => reradiated += 1,
            (Channel::Polarised, Kind::Light) => polarised += 1,
            _ => {}
        }
    }
    bands.sort_by(|a, b| a.0.total_cmp(&b.0));
    bands.dedup_by(|later, earlier| later.0 == earlier.0);
    if bands.len() < 2 {
        return Ok(());
    }
    let mut notes = Vec::new();
    if reradiated > 0 {
        notes.push(format!(
            "bispectral: {reradiated} channels of fluorescence left out, the diagonal read"
        ));
    }
    if polarised > 0 {
        notes.push(format!("{polarised} channels of polarisation left out"));
    }
    let cube = cube_of((layer.size.0, layer.size.1), &bands)
        .map_err(|why| input.error(why, "a whole image"))?;
    let unit = match kind {
        Kind::Light => words_of(image, layer, "emissiveUnits").unwrap_or_default(),
        _ => "fraction".to_owned(),
    };
    let both = match kind == Kind::Reflectance && !reading.images.is_empty() {
        true => ", reflectance",
        false => "",
    };
    let raw = RawImage {
        name: format!("{}{part}{both}", input.stem()),
        source: input.name.clone(),
        bandwidth_nm: None,
        cube,
        notes,
        known: Known {
            kind: Some(Decision::of_format(kind)),
            unit: Some(unit),
            scale: KnownScale::Stated(1.0),
            may_be_large: false,
        },
        axis: None,
        against: None,
    };
    spectral_image::add(raw, &input.choices, reading);
    Ok(())
}

/// A cube of single precision, band after band.
fn cube_of(
    (width, height): (usize, usize),
    bands: &[(f64, &AnyChannel<FlatSamples>)],
) -> Result<Cube, String> {
    let mut bytes = Vec::with_capacity(width * height * bands.len() * 4);
    for (_, channel) in bands {
        let (step_x, step_y) = (channel.sampling.0.max(1), channel.sampling.1.max(1));
        let columns = width / step_x;
        for y in 0..height {
            for x in 0..width {
                let at = (y / step_y) * columns + (x / step_x).min(columns.saturating_sub(1));
                let value = match &channel.sample_data {
                    FlatSamples::F16(values) => values.get(at).map(|v| v.to_f32()),
                    FlatSamples::F32(values) => values.get(at).copied(),
                    FlatSamples::U32(values) => values.get(at).map(|v| *v as f32),
                };
                bytes.extend(value.unwrap_or(f32::NAN).to_le_bytes());
            }
        }
    }
    let places: Vec<(f64, usize)> = bands.iter().map(|(nm, _)| *nm).zip(0..).collect();
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Bands,
        stored_bands: bands.len(),
        missing: None,
    };
    Cube::new(width, height, &places, layout, Arc::new(bytes)).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_wavelengths_in_any_unit() {
        for (name, channel) in [
            ("S0.380,000000nm", Channel::Light(380.0)),
            ("S0.0,5um", Channel::Light(500.0)),
            ("S0.499,654THz", Channel::Light(600.000_116)),
            ("S2.380,0nm", Channel::Polarised),
            ("T.400,0nm", Channel::Factor(400.0)),
            ("T.400,0nm.420,0nm", Channel::Reradiated),
            ("R", Channel::Other),
            ("T.x", Channel::Other),
        ] {
            match (channel_of(name), channel) {
                (Channel::Light(found), Channel::Light(nm)) => {
                    assert!((found - nm).abs() < 1e-3, "{name}: {found}");
                }
                (found, expected) => assert_eq!(found, expected, "{name}"),
            }
        }
    }
}
