//! OpenEXR out: whole images of 32-bit numbers, and large ones some rows at a time.

use std::io::{self, Cursor, Seek, Write};

use exr::block::UncompressedBlock;
use exr::block::writer::{ChunksWriter, write_chunks_with};
use exr::compression::Compression;
use exr::image::{AnyChannel, AnyChannels, FlatSamples, Image, Layer};
use exr::meta::BlockDescription;
use exr::meta::attribute::{AttributeValue, ChannelDescription, LineOrder, SampleType, Text};
use exr::meta::header::Header;
use exr::prelude::{Encoding, LayerAttributes, WritableImage, f16};

/// The precision of stored numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// 16 bits: costs some thousandths of a dE00.
    #[default]
    Half,
    /// 32 bits: costs nothing.
    Single,
}

impl Precision {
    /// A number as it is kept.
    pub fn kept(self, number: f32) -> f32 {
        match self {
            Self::Half => f16::from_f32(number).to_f32(),
            Self::Single => number,
        }
    }
}

/// Rows that [`write_rows`] requests at a time.
pub(crate) const BLOCK_ROWS: usize = 16;

/// Attributes from texts; those with letters that the format does not know are left out.
fn attributes(texts: impl IntoIterator<Item = (String, String)>) -> LayerAttributes {
    let mut attributes = LayerAttributes::default();
    for (key, text) in texts {
        if let (Some(key), Some(text)) = (Text::new_or_none(key), Text::new_or_none(text)) {
            attributes.other.insert(key, AttributeValue::Text(text));
        }
    }
    attributes
}

/// An image of channels, each with its numbers row after row from the top, and texts about it.
///
/// # Errors
/// The encoder's error, in words.
pub(super) fn image(
    [width, height]: [usize; 2],
    channels: Vec<(String, Vec<f32>)>,
    texts: impl IntoIterator<Item = (String, String)>,
) -> Result<Vec<u8>, String> {
    let channel = |(name, values): (String, _)| AnyChannel::new(&*name, FlatSamples::F32(values));
    let layer = Layer::new(
        (width, height),
        attributes(texts),
        Encoding::FAST_LOSSLESS,
        AnyChannels::sort(channels.into_iter().map(channel).collect()),
    );
    let mut file = Cursor::new(Vec::new());
    let image = Image::from_layer(layer);
    let written = image.write().non_parallel().to_buffered(&mut file);
    written.map_err(|why| why.to_string())?;
    Ok(with_attributes_in_order(file.into_inner()))
}

/// Writes an image of channels (in the order of their names) as ZIP. `rows` gives the numbers of
/// some rows from their first and their count, `[channel * (count * width) + pixel]`. An image with
/// a text has no name.
///
/// # Errors
/// Those of `rows` and of the writer.
pub(crate) fn write_rows<E: From<io::Error>>(
    out: impl Write + Seek,
    [width, height]: [usize; 2],
    channels: &[(String, Precision)],
    text: Option<(&str, String)>,
    mut rows: impl FnMut(usize, usize) -> Result<Vec<f32>, E>,
) -> Result<(), E> {
    let described = channels.iter().map(|(name, precision)| {
        let number = match precision {
            Precision::Half => SampleType::F16,
            Precision::Single => SampleType::F32,
        };
        ChannelDescription::new(&**name, number, false)
    });
    let mut header = Header::new(Text::from("picture"), (width, height), described.collect())
        .with_encoding(
            Compression::ZIP16,
            BlockDescription::ScanLines,
            LineOrder::Increasing,
        );
    if let Some((key, text)) = text {
        header = header.with_attributes(attributes([(key.to_owned(), text)]));
    }
    let mut failed = None;
    let written = write_chunks_with(
        out,
        [header].into_iter().collect(),
        false,
        |meta, writer| {
            let mut compressor = writer.sequential_blocks_compressor(&meta);
            for (at, index) in meta.enumerate_ordered_header_block_indices() {
                let count = index.pixel_size.height();
                let planes = rows(index.pixel_position.y(), count).map_err(|error| {
                    failed = Some(error);
                    exr::error::Error::Aborted
                })?;
                let data = block(&planes, width, count, channels);
                compressor.compress_block(at, UncompressedBlock { index, data })?;
            }
            Ok(())
        },
    );
    match failed {
        Some(error) => Err(error),
        None => written.map_err(|error| io::Error::other(error).into()),
    }
}

/// Some rows as the format has them: row by row, channel by channel.
fn block(planes: &[f32], width: usize, rows: usize, channels: &[(String, Precision)]) -> Vec<u8> {
    let mut data = Vec::with_capacity(4 * planes.len());
    for y in 0..rows {
        for (plane, (_, precision)) in planes.chunks_exact(rows * width).zip(channels) {
            let row = &plane[y * width..][..width];
            match precision {
                Precision::Half => {
                    data.extend(row.iter().flat_map(|v| f16::from_f32(*v).to_ne_bytes()));
                }
                Precision::Single => data.extend(row.iter().flat_map(|v| v.to_ne_bytes())),
            }
        }
    }
    data
}

/// The same file of one part with the attributes of its header by name, so that the same picture
/// is the same file each time: the encoder keeps them in a map of random order. What follows the
/// header stays where it is. Bytes of any other kind are returned unchanged.
fn with_attributes_in_order(mut file: Vec<u8>) -> Vec<u8> {
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

/// The end of the attribute that starts at a place: a name and a type, each ended by a zero, the
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

#[cfg(test)]
mod tests {
    use super::{image, with_attributes_in_order};

    #[test]
    fn attributes_are_in_order_once_and_what_is_no_image_stays() {
        let texts = (0..12).map(|i| (format!("fact {i}"), i.to_string()));
        let file = image([1, 1], vec![("R".to_owned(), vec![0.5])], texts).unwrap();
        assert_eq!(with_attributes_in_order(file.clone()), file);
        assert_eq!(with_attributes_in_order(b"no image".to_vec()), b"no image");
    }
}
