//! OpenEXR images made in memory, for tests.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec,
    WritableImage,
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
