//! Spectral OpenEXR: an image with one channel a wavelength.
//!
//! The layout is that of Fichet, Pacanowski and Wilkie, An OpenEXR Layout for Spectral Images,
//! JCGT 10(3), 2021. `S0.380,000000nm` is a channel of light at 380 nm (`S1` to `S3` are the other
//! Stokes components, passed over here), `T.380,000000nm` one of reflectance or transmittance, and
//! `T.380,0nm.400,0nm` the share of light of 380 nm re-emitted at 400 nm: of such bispectral images
//! the diagonal is read, which is the reflectance without fluorescence. Decimals are marked by
//! commas, since points part the names of layers. Units are metres or hertz with any prefix. The
//! attribute `emissiveUnits` is the unit of light.
//!
//! Pictures of red, green and blue are refused: they hold no spectrum. The numbers of the spectral
//! channels may take [`budget::of`] bytes, which is checked before one is decoded. Then block
//! after block (some rows, or a tile) is decoded, its spectral channels are kept and the block is
//! dropped, so that a truncated file takes no more memory than its contents.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::spectrum::Kind;
use crate::spectrum::cube::{Cube, Interleave, Layout, Number};

use super::spectral_image::{self, RawImage};
use super::{Confidence, Format};
use crate::io::decode::exr::{ExrImage, Layer};
use crate::io::error::quoted;
use crate::io::interpret::factor_scale::KnownScale;
use crate::io::interpret::raw::Known;
use crate::io::reading::decision::Decision;
use crate::io::text::number;
use crate::io::{Input, ReadError, Reading, budget};
use crate::languages::said;

/// Spectral OpenEXR.
pub(crate) const FORMAT: Format = Format {
    name: later!("spectral OpenEXR"),
    extensions: &["exr"],
    sniff,
    read,
};

/// Speed of light in nm Hz.
const LIGHT_NM_HZ: f64 = 299_792_458.0 * 1e9;

fn sniff(input: &Input) -> Confidence {
    Confidence::certain_if(input.bytes.starts_with(b"\x76\x2f\x31\x01"))
}

/// The contents of a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Channel {
    /// Light at a wavelength, nm.
    Light(f64),
    /// Another Stokes component than the first.
    Polarised,
    /// Reflectance or transmittance at a wavelength, nm.
    Factor(f64),
    /// Light of one wavelength re-emitted at another.
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
    let broken = |why: Option<String>| {
        let found = match why {
            Some(why) => tr!("a broken OpenEXR image ({why})", why),
            None => said!("a broken OpenEXR image").to_owned(),
        };
        input.error(found, said!("one that can be decoded"))
    };
    let file = ExrImage::open(input.bytes).map_err(broken)?;
    check(input, &file.layers)?;
    let mut pictures = pictures_in(&file.layers);
    let kept = pictures.iter().map(|p| p.row().saturating_mul(p.size.1));
    let largest = file.layers.iter().map(|l| l.block_bytes).max().unwrap_or(0);
    let needed = kept.fold(largest, usize::saturating_add);
    if needed > budget::of(input.bytes.len()) {
        let found = tr!(
            "an image that takes {size} to decode",
            size = budget::in_words(needed)
        );
        return Err(input.error(found, said(budget::WORDS)));
    }
    if pictures.is_empty() {
        let found = said!("fewer than two spectral channels a layer");
        return Err(input.error(found, said!("two or more")));
    }
    let many = file.layers.len() > 1;
    let mut of_channel: BTreeMap<[usize; 2], (usize, usize)> = BTreeMap::new();
    for (index, picture) in pictures.iter().enumerate() {
        for (band, (_, channel)) in picture.bands.iter().enumerate() {
            of_channel.insert([picture.layer, *channel], (index, band));
        }
    }
    let is_wanted = |layer, channel| of_channel.contains_key(&[layer, channel]);
    let keep = |place: [usize; 2], at, numbers: &[f32]| {
        let (index, band) = of_channel[&place];
        pictures[index].keep(band, at, numbers);
    };
    file.decode(is_wanted, keep).map_err(broken)?;
    let mut reading = Reading::default();
    for picture in pictures {
        add(input, picture, many, &mut reading)?;
    }
    Ok(reading)
}

/// Refuses anything but a spectral image.
fn check(input: &Input, layers: &[Layer]) -> Result<(), ReadError> {
    for layer in layers {
        if layer.is_deep {
            return Err(input.error(said!("a deep OpenEXR image"), said!("a flat one")));
        }
        if layer.channels.iter().any(|channel| !channel.is_full) {
            let found = said!("a channel of fewer samples than pixels");
            return Err(input.error(found, said!("one a pixel")));
        }
    }
    let channels = layers.iter().flat_map(|layer| &layer.channels);
    let names: Vec<&str> = channels.map(|channel| &*channel.name).collect();
    let is_spectral =
        |name: &&&str| matches!(channel_of(name), Channel::Light(_) | Channel::Factor(_));
    if names.iter().filter(is_spectral).count() < 2 {
        let names = quoted(&names[..names.len().min(6)].join(" "));
        return Err(input.error(
            tr!("an OpenEXR image of the channels {names}", names),
            said!("two or more spectral channels such as \"S0.380,0nm\" or \"T.380,0nm\""),
        ));
    }
    Ok(())
}

/// The image that a layer holds of one kind.
struct Picture {
    layer: usize,
    kind: Kind,
    unit: String,
    /// Columns and rows.
    size: (usize, usize),
    /// Wavelengths, nm, rising, each with its place among the layer's channels.
    bands: Vec<(f64, usize)>,
    notes: Vec<String>,
    /// Row after row, of each row band after band, single precision; as far as it is decoded.
    bytes: Vec<u8>,
}

impl Picture {
    /// Bytes of one row of all bands.
    fn row(&self) -> usize {
        self.size.0.saturating_mul(4 * self.bands.len())
    }

    /// Keeps a piece of one row of one band.
    fn keep(&mut self, band: usize, [x, y]: [usize; 2], numbers: &[f32]) {
        let (row, all) = (self.row(), self.row() * self.size.1);
        let end = row * (y + 1);
        if self.bytes.len() < end {
            // Rows may come in any order. Doubled each time, so that few copies are made.
            let room = end.max(2 * self.bytes.len()).min(all);
            self.bytes.reserve_exact(room - self.bytes.len());
            self.bytes.resize(end, 0);
        }
        let start = row * y + 4 * (band * self.size.0 + x);
        let into = self.bytes[start..].as_chunks_mut().0;
        for (to, number) in into.iter_mut().zip(numbers) {
            *to = number.to_le_bytes();
        }
    }
}

/// The images of two bands or more that the layers hold, light before reflectance; empty ones.
fn pictures_in(layers: &[Layer]) -> Vec<Picture> {
    let mut pictures = Vec::new();
    for (index, layer) in layers.iter().enumerate() {
        for kind in [Kind::Light, Kind::Reflectance] {
            let (mut reradiated, mut polarised) = (0_usize, 0_usize);
            let mut bands: Vec<(f64, usize)> = Vec::new();
            for (place, channel) in layer.channels.iter().enumerate() {
                match (channel_of(&channel.name), kind) {
                    (Channel::Light(nm), Kind::Light)
                    | (Channel::Factor(nm), Kind::Reflectance) => bands.push((nm, place)),
                    (Channel::Reradiated, Kind::Reflectance) => reradiated += 1,
                    (Channel::Polarised, Kind::Light) => polarised += 1,
                    _ => {}
                }
            }
            bands.sort_by(|a, b| a.0.total_cmp(&b.0));
            bands.dedup_by(|later, earlier| later.0 == earlier.0);
            if bands.len() < 2 {
                continue;
            }
            let mut notes = Vec::new();
            if reradiated > 0 {
                notes.push(tr!(
                    "bispectral: {n} channels of fluorescence left out, the diagonal read"
                        | "bispectral: {n} channels of fluorescence left out, the diagonal read"
                            % reradiated
                ));
            }
            if polarised > 0 {
                notes.push(tr!("{n} channels of polarisation left out"
                    | "{n} channels of polarisation left out" % polarised));
            }
            let unit = match kind {
                Kind::Light => layer.text("emissiveUnits").unwrap_or_default(),
                _ => "fraction",
            };
            pictures.push(Picture {
                layer: index,
                kind,
                unit: unit.to_owned(),
                size: layer.size,
                bands,
                notes,
                bytes: Vec::new(),
            });
        }
    }
    pictures
}

/// Adds an image that was decoded; `many` where the file has several layers.
fn add(
    input: &Input,
    picture: Picture,
    many: bool,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    let ((width, height), bands) = (picture.size, picture.bands);
    let places: Vec<(f64, usize)> = bands.iter().map(|(nm, _)| *nm).zip(0..).collect();
    let layout = Layout {
        first_byte: 0,
        number: Number::F32,
        big_endian: false,
        interleave: Interleave::Lines,
        stored_bands: bands.len(),
        missing: None,
    };
    let cube = Cube::new(width, height, &places, layout, Arc::new(picture.bytes))
        .map_err(|error| input.error(error.to_string(), said!("a whole image")))?;
    let part = match many {
        true => format!(", layer {}", picture.layer + 1),
        false => String::new(),
    };
    let both = match picture.kind == Kind::Reflectance && !reading.images.is_empty() {
        true => ", reflectance",
        false => "",
    };
    let raw = RawImage {
        name: format!("{}{part}{both}", input.stem()),
        source: input.name.clone(),
        bandwidth_nm: None,
        cube,
        notes: picture.notes,
        known: Known {
            kind: Some(Decision::of_format(picture.kind)),
            unit: Some(picture.unit),
            scale: KnownScale::Stated(1.0),
            may_be_large: false,
        },
        axis: None,
        against: None,
    };
    spectral_image::add(raw, &input.choices, reading);
    Ok(())
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
