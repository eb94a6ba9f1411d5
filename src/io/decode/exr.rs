//! OpenEXR images, read a block (some rows, or a tile) at a time: a truncated file takes no more
//! memory than its contents.

use std::io::Cursor;

use exr::block::{self, reader::ChunksReader, reader::Reader};
use exr::error::Result as Decoded;
use exr::meta::attribute::{AttributeValue, ChannelDescription, SampleType};
use exr::meta::header::Header;
use exr::prelude::f16;

use super::guarded::guarded;

/// A channel of a layer.
pub(crate) struct Channel {
    pub name: String,
    /// True if it has a number for each pixel.
    pub is_full: bool,
    /// True if its numbers are integers.
    pub is_whole: bool,
}

/// A layer before its numbers are decoded.
pub(crate) struct Layer {
    /// Columns and rows.
    pub size: (usize, usize),
    pub is_deep: bool,
    pub channels: Vec<Channel>,
    /// Attributes that are texts: its own, then those of all layers.
    texts: Vec<(String, String)>,
    /// Memory of its largest block on the way: packed, unpacked and put in order, in bytes.
    pub block_bytes: usize,
}

impl Layer {
    fn of(header: &Header) -> Self {
        let (block, size) = (header.max_block_pixel_size(), header.layer_size);
        let pixels = block.0.min(size.0).saturating_mul(block.1.min(size.1));
        let channel = |channel: &ChannelDescription| Channel {
            name: channel.name.to_string(),
            is_full: (channel.sampling.0, channel.sampling.1) == (1, 1),
            is_whole: channel.sample_type == SampleType::U32,
        };
        let own = header.own_attributes.other.iter();
        let all = own.chain(&header.shared_attributes.other);
        let texts = all.filter_map(|(name, value)| match value {
            AttributeValue::Text(text) => Some((name.to_string(), text.to_string())),
            _ => None,
        });
        Self {
            size: (size.0, size.1),
            is_deep: header.deep,
            channels: header.channels.list.iter().map(channel).collect(),
            texts: texts.collect(),
            block_bytes: pixels.saturating_mul(2 * header.channels.bytes_per_pixel),
        }
    }

    /// The text attribute of a name.
    pub(crate) fn text(&self, name: &str) -> Option<&str> {
        let found = self.texts.iter().find(|(key, _)| key == name);
        found.map(|(_, text)| &**text)
    }
}

/// An image whose headers are read.
pub(crate) struct ExrImage<'a> {
    file: Reader<Cursor<&'a [u8]>>,
    pub layers: Vec<Layer>,
}

/// The decoder's result; its error in words, `None` if it panics.
fn decoded<T>(decode: impl FnOnce() -> Decoded<T>) -> Result<T, Option<String>> {
    let decoded = guarded(decode).ok_or(None)?;
    decoded.map_err(|error| Some(error.to_string()))
}

impl<'a> ExrImage<'a> {
    /// Reads the headers.
    ///
    /// # Errors
    /// The decoder's error in words, `None` if it panics.
    pub(crate) fn open(bytes: &'a [u8]) -> Result<Self, Option<String>> {
        let file = decoded(|| block::read(Cursor::new(bytes), false))?;
        let layers = file.headers().iter().map(Layer::of).collect();
        Ok(Self { file, layers })
    }

    /// Decodes the channels that are wanted by layer and channel. `keep` takes a piece of a row at
    /// a time: layer and channel, column and row of its first number, its numbers.
    ///
    /// # Errors
    /// As [`ExrImage::open`].
    pub(crate) fn decode(
        self,
        is_wanted: impl Fn(usize, usize) -> bool,
        mut keep: impl FnMut([usize; 2], [usize; 2], &[f32]),
    ) -> Result<(), Option<String>> {
        let meta = self.file.meta_data().clone();
        let channels = |layer: usize| &meta.headers[layer].channels;
        let has_wanted: Vec<bool> = (0..meta.headers.len())
            .map(|layer| (0..channels(layer).list.len()).any(|c| is_wanted(layer, c)))
            .collect();
        let mut numbers: Vec<f32> = Vec::new();
        decoded(|| {
            let chunks = self.file.filter_chunks(false, |_, tile, block| {
                tile.is_largest_resolution_level() && has_wanted[block.layer]
            })?;
            for block in chunks.sequential_decompressor(false) {
                let block = block?;
                let layer = block.index.layer;
                for line in block.lines(channels(layer)) {
                    let (channel, at) = (line.location.channel, line.location.position);
                    if !is_wanted(layer, channel) {
                        continue;
                    }
                    numbers.clear();
                    let four = line.value.as_chunks().0.iter();
                    match channels(layer).list[channel].sample_type {
                        SampleType::F16 => {
                            let two = line.value.as_chunks().0.iter();
                            numbers.extend(two.map(|b| f16::from_ne_bytes(*b).to_f32()));
                        }
                        SampleType::F32 => numbers.extend(four.map(|b| f32::from_ne_bytes(*b))),
                        SampleType::U32 => {
                            numbers.extend(four.map(|b| u32::from_ne_bytes(*b) as f32));
                        }
                    }
                    keep([layer, channel], [at.0, at.1], &numbers);
                }
            }
            Ok(())
        })
    }
}
