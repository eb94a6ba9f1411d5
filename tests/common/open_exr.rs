//! OpenEXR images made and read in memory, for tests.

#![allow(dead_code, reason = "no program of tests needs all of it")]

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, ReadChannels,
    ReadLayers, SmallVec, WritableImage, read,
};

/// An OpenEXR image with channels of these names.
pub(crate) fn exr(size: (usize, usize), names: &[&str], encoding: Encoding) -> Vec<u8> {
    let list: SmallVec<_> = names
        .iter()
        .enumerate()
        .map(|(i, name)| {
            let values = (0..size.0 * size.1).map(|p| (10 * p + i) as f32).collect();
            AnyChannel::new(*name, FlatSamples::F32(values))
        })
        .collect();
    let attributes = LayerAttributes::default();
    let layer = Layer::new(size, attributes, encoding, AnyChannels::sort(list));
    let mut bytes = Cursor::new(Vec::new());
    let image = Image::from_layer(layer);
    let written = image.write().non_parallel().to_buffered(&mut bytes);
    written.expect("an image");
    bytes.into_inner()
}

/// The spikes of an image of light: places (nm, rising) with the energy of each pixel.
pub(crate) fn lines_of_exr(file: &[u8]) -> Vec<(f64, Vec<f32>)> {
    let reader = read().no_deep_data().largest_resolution_level();
    let reader = reader.all_channels().first_valid_layer().all_attributes();
    let image = reader.from_buffered(Cursor::new(file)).expect("an image");
    let line = |channel: AnyChannel<FlatSamples>| {
        let name = channel.name.to_string();
        let place = name.strip_prefix("line.")?.strip_suffix("nm")?;
        let FlatSamples::F32(energy) = channel.sample_data else {
            return None;
        };
        Some((place.replace(',', ".").parse().ok()?, energy))
    };
    let channels = image.layer_data.channel_data.list;
    let mut lines: Vec<(f64, Vec<f32>)> = channels.into_iter().filter_map(line).collect();
    lines.sort_by(|a, b| a.0.total_cmp(&b.0));
    lines
}
