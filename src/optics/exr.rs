//! A gem as a spectral OpenEXR image, and its spikes read back.
//!
//! Channels `S0.<nm>nm` at the middles of the strata hold the whole light (a spike's energy over
//! the stratum's width added in its stratum: energy is kept), in the layout of Fichet, Pacanowski
//! and Wilkie, JCGT 10(3), 2021. One channel more a spike, `line.<nm>nm`, holds its exact energy,
//! so that a reader who knows it gets smooth part and spikes apart, and all others the right
//! colour.

use std::{fmt, io::Cursor};

use exr::{
    image::{AnyChannel, AnyChannels, FlatSamples, Image, Layer},
    meta::attribute::{AttributeValue, Text},
    prelude::{Encoding, LayerAttributes, ReadChannels, ReadLayers, SmallVec, WritableImage, read},
};

use super::{film::Film, light::Light, plane::Plane};
use crate::spectrum::Line;

/// Why there is no image.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ExrError {
    /// It cannot be written.
    Write { why: String },
    /// It cannot be read.
    Read { why: String },
}

impl fmt::Display for ExrError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Write { why } => {
                write!(
                    f,
                    "expected a film that can be written as OpenEXR, found {why}"
                )
            }
            Self::Read { why } => {
                write!(f, "expected an OpenEXR image that can be read, found {why}")
            }
        }
    }
}

impl std::error::Error for ExrError {}

/// One wavelength as the layout writes it.
fn label(nm: f64) -> String {
    format!("{nm:.6}nm").replace('.', ",")
}

/// A film under a light as a file. `facts` become attributes (`made.view` for "view"):
/// light, gem, cut, view, rays a pixel.
///
/// # Errors
/// [`ExrError`] when the encoder refuses.
pub fn spectral_exr(
    film: &Film,
    light: &Light,
    facts: &[(&str, String)],
) -> Result<Vec<u8>, ExrError> {
    let size = film.settings().size;
    let mut lines: Vec<(Line, Vec<f32>)> = Vec::new();
    for spike in light.seen_spikes() {
        let transport = film.transport(spike.at_nm);
        let weight = spike.weight as f32;
        lines.push((spike, transport.iter().map(|t| weight * t).collect()));
    }
    let mut channels: SmallVec<[AnyChannel<FlatSamples>; 4]> = SmallVec::new();
    for (place, plane) in film.planes().iter().enumerate() {
        let Plane::Stratum { from_nm, to_nm } = *plane else {
            continue;
        };
        let width = to_nm - from_nm;
        let mean = (light.smooth_power([from_nm, to_nm]) / width) as f32;
        let mut values: Vec<f32> = film.plane(place).iter().map(|t| mean * t).collect();
        let is_last = to_nm >= super::light::SEEN_NM[1];
        for (spike, energy) in &lines {
            let inside = spike.at_nm >= from_nm
                && (spike.at_nm < to_nm || (is_last && spike.at_nm <= to_nm));
            if inside {
                let over = (1.0 / width) as f32;
                values
                    .iter_mut()
                    .zip(energy)
                    .for_each(|(v, e)| *v += over * e);
            }
        }
        let name = format!("S0.{}", label(0.5 * (from_nm + to_nm)));
        channels.push(AnyChannel::new(name.as_str(), FlatSamples::F32(values)));
    }
    for (spike, energy) in lines {
        let name = format!("line.{}", label(spike.at_nm));
        channels.push(AnyChannel::new(name.as_str(), FlatSamples::F32(energy)));
    }
    let mut layer = Layer::new(
        (size, size),
        LayerAttributes::default(),
        Encoding::FAST_LOSSLESS,
        AnyChannels::sort(channels),
    );
    let texts = [
        ("spectralLayoutVersion", "1.0".to_owned()),
        ("emissiveUnits", "W.m^-2.sr^-1.nm^-1".to_owned()),
    ];
    // Plain names such as "view" are the format's own.
    let facts = facts
        .iter()
        .map(|(key, value)| (format!("made.{key}"), value));
    let texts = texts.iter().map(|(key, value)| ((*key).to_owned(), value));
    for (key, value) in texts.chain(facts) {
        let (Some(key), Some(value)) = (Text::new_or_none(&key), Text::new_or_none(value)) else {
            continue;
        };
        layer
            .attributes
            .other
            .insert(key, AttributeValue::Text(value));
    }
    let mut file = Cursor::new(Vec::new());
    let written = Image::from_layer(layer)
        .write()
        .non_parallel()
        .to_buffered(&mut file);
    written.map_err(|why| ExrError::Write {
        why: why.to_string(),
    })?;
    Ok(file.into_inner())
}

/// The spikes that [`spectral_exr`] wrote: places, nm, with the energy of each pixel, value x nm;
/// by rising wavelength.
///
/// # Errors
/// [`ExrError`] for what is no OpenEXR image.
pub fn lines_of_exr(file: &[u8]) -> Result<Vec<(f64, Vec<f32>)>, ExrError> {
    let image = read()
        .no_deep_data()
        .largest_resolution_level()
        .all_channels()
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(file))
        .map_err(|why| ExrError::Read {
            why: why.to_string(),
        })?;
    let mut lines = Vec::new();
    for channel in image.layer_data.channel_data.list {
        let name = channel.name.to_string();
        let place = name
            .strip_prefix("line.")
            .and_then(|n| n.strip_suffix("nm"));
        let nm = place.and_then(|text| text.replace(',', ".").parse::<f64>().ok());
        if let (Some(nm), FlatSamples::F32(values)) = (nm, channel.sample_data) {
            lines.push((nm, values));
        }
    }
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    Ok(lines)
}
