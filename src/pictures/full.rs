//! The full form `NAME.exr`: OpenEXR with `R`, `G`, `B` for every viewer and the numbers as
//! channels `CS.000`, `CS.001`, ..., the header as the text attribute `compositePicture`.

use std::io::{Cursor, Seek, Write};

use exr::block::UncompressedBlock;
use exr::block::writer::{ChunksWriter, write_chunks_with};
use exr::compression::Compression;
use exr::image::{AnyChannel, FlatSamples};
use exr::meta::attribute::{AttributeValue, ChannelDescription, LineOrder, SampleType, Text};
use exr::meta::header::{Header as ExrHeader, LayerAttributes};
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{ReadChannels, ReadLayers, f16, read as exr_reader};

use crate::color::Xyz;
use crate::io::budget;
use crate::io::guarded;
use crate::study::Progress;

use super::header::{About, Header};
use super::kernel::Kernel;
use super::measure::{Errors, Storage};
use super::preview::to_linear;
use super::survey::percentile;
use super::{Operator, Picture, PictureError, Pixels};

/// The attribute that holds the header.
const ATTRIBUTE: &str = "compositePicture";
/// Largest half.
const MOST_HALF: f64 = 65504.0;

/// How exactly numbers are kept.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Precision {
    /// 16 bits: costs some thousandths of a dE00.
    #[default]
    Half,
    /// 32 bits: costs nothing.
    Single,
}

/// Numbers kept as 16-bit floating point, divided by a scale before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Half {
    /// What stored numbers are multiplied by.
    pub scale: f64,
}

impl Half {
    /// The scale that brings a sample's numbers into range: 1 unless one would overflow, else the
    /// 99th percentile of the first number.
    pub fn of(sample: &[Vec<f64>]) -> Self {
        let largest = sample.iter().flatten().fold(0.0_f64, |m, z| m.max(z.abs()));
        // Pixels beside the sample may be ten times as strong.
        if 10.0 * largest < MOST_HALF || !largest.is_finite() {
            return Self { scale: 1.0 };
        }
        let mut firsts: Vec<f64> = sample.iter().map(|z| z[0].abs()).collect();
        let high = percentile(&mut firsts, 0.99);
        Self {
            scale: if high > 0.0 { high } else { largest },
        }
    }

    fn round(self, number: f32) -> f16 {
        f16::from_f32((f64::from(number) / self.scale).clamp(-MOST_HALF, MOST_HALF) as f32)
    }

    fn back(scale: f64, stored: f32) -> f32 {
        (f64::from(stored) * scale) as f32
    }
}

impl Storage for Half {
    fn kept(&self, numbers: &mut [f32], _: usize) {
        for number in numbers {
            *number = Self::back(self.scale, self.round(*number).to_f32());
        }
    }
}

/// Text with what is beyond ASCII written as JSON escapes: the format knows no other letters.
fn ascii(json: &str) -> String {
    let mut out = String::with_capacity(json.len());
    for letter in json.chars() {
        if letter.is_ascii() {
            out.push(letter);
        } else {
            let mut units = [0; 2];
            letter
                .encode_utf16(&mut units)
                .iter()
                .for_each(|unit| out.push_str(&format!("\\u{unit:04x}")));
        }
    }
    out
}

fn channel_names(numbers: usize) -> Vec<String> {
    // In the order of their names, as the format wants it.
    let mut names = vec!["B".to_owned()];
    names.extend((0..numbers).map(|n| format!("CS.{n:03}")));
    names.extend(["G".to_owned(), "R".to_owned()]);
    names
}

/// Weights of the numbers for linear red, green and blue of the own colour, white = 1.
fn rgb_rows(operator: &Operator) -> [Vec<f64>; 3] {
    let own = operator.own_colour();
    let linear = to_linear(&own);
    let columns: Vec<[f64; 3]> = (0..operator.numbers())
        .map(|n| linear(Xyz::new(own.rows[0][n], own.rows[1][n], own.rows[2][n])))
        .collect();
    std::array::from_fn(|k| columns.iter().map(|c| c[k]).collect())
}

/// Writes the full form, a block of rows at a time.
///
/// # Errors
/// Those of the source and of the writer, and [`PictureError::Cancelled`].
pub fn write_full<W: Write + Seek>(
    out: W,
    pixels: &dyn Pixels,
    operator: &Operator,
    (precision, half): (Precision, Half),
    (about, error): (&About, Errors),
    progress: &Progress,
) -> Result<(), PictureError> {
    let (width, height) = pixels.size();
    let mut header = Header::of(operator, (width, height), about, error);
    if precision == Precision::Half {
        header.scale = half.scale;
    }
    let names = channel_names(operator.numbers());
    let number = match precision {
        Precision::Half => SampleType::F16,
        Precision::Single => SampleType::F32,
    };
    let channels = names.iter().map(|name| {
        let kind = if name.starts_with("CS.") {
            number
        } else {
            SampleType::F16
        };
        ChannelDescription::new(name.as_str(), kind, false)
    });
    let text = Text::new_or_none(ascii(&header.to_json()))
        .ok_or_else(|| PictureError::broken("a header beyond ASCII", "ASCII"))?;
    let mut attributes = LayerAttributes::default();
    attributes
        .other
        .insert(Text::from(ATTRIBUTE), AttributeValue::Text(text));
    let exr = ExrHeader::new(Text::from("picture"), (width, height), channels.collect())
        .with_attributes(attributes);
    let (encode, rgb) = (operator.encoder(), rgb_rows(operator));
    let rgb = Kernel::of_rows(&[&rgb[2], &rgb[1], &rgb[0]]);
    write_blocks(out, exr, progress, |block| {
        block_bytes(pixels, (&encode, &rgb), block, (precision, half))
    })
}

/// Writes an OpenEXR image as ZIP, a block of rows at a time: `bytes` of the first row and how many
/// there are.
///
/// # Errors
/// Those of `bytes` and of the writer, and [`PictureError::Cancelled`].
pub(super) fn write_blocks<W: Write + Seek>(
    out: W,
    exr: ExrHeader,
    progress: &Progress,
    bytes: impl Fn((usize, usize)) -> Result<Vec<u8>, PictureError>,
) -> Result<(), PictureError> {
    let exr = exr.with_encoding(
        Compression::ZIP16,
        BlockDescription::ScanLines,
        LineOrder::Increasing,
    );
    let mut failed = None;
    let written = write_chunks_with(out, [exr].into_iter().collect(), false, |meta, writer| {
        let mut compressor = writer.sequential_blocks_compressor(&meta);
        let blocks: Vec<_> = meta.enumerate_ordered_header_block_indices().collect();
        progress.expect(blocks.len());
        for (at, index) in blocks {
            match bytes((index.pixel_position.y(), index.pixel_size.height())) {
                Ok(data) if !progress.is_cancelled() => {
                    compressor.compress_block(at, UncompressedBlock { index, data })?;
                }
                other => {
                    failed = Some(other.err().unwrap_or(PictureError::Cancelled));
                    return Err(exr::error::Error::Aborted);
                }
            }
            progress.step();
        }
        Ok(())
    });
    match (failed, written) {
        (Some(error), _) => Err(error),
        (None, Err(error)) => Err(PictureError::Trouble(error.to_string())),
        (None, Ok(())) => Ok(()),
    }
}

/// Some rows as the format has them: row by row, channel by channel.
fn block_bytes(
    pixels: &dyn Pixels,
    (encode, rgb): (&Kernel, &Kernel),
    (top, rows): (usize, usize),
    (precision, half): (Precision, Half),
) -> Result<Vec<u8>, PictureError> {
    let width = pixels.size().0;
    let count = width * rows;
    let mut values = vec![0.0; count * pixels.bands().len()];
    pixels.rows(top, rows, &mut values)?;
    let mut numbers = vec![0.0; encode.rows() * count];
    encode.apply(&values, count, &mut numbers);
    let mut colours = vec![0.0; 3 * count];
    rgb.apply(&numbers, count, &mut colours);
    let mut data = Vec::with_capacity(count * (encode.rows() * 4 + 6));
    for y in 0..rows {
        let row = |plane: &[f32], n: usize| plane[n * count + y * width..][..width].to_vec();
        let colour = |data: &mut Vec<u8>, n: usize| {
            for value in row(&colours, n) {
                data.extend(f16::from_f32(value.clamp(-65504.0, 65504.0)).to_ne_bytes());
            }
        };
        colour(&mut data, 0);
        for n in 0..encode.rows() {
            for value in row(&numbers, n) {
                match precision {
                    Precision::Half => data.extend(half.round(value).to_ne_bytes()),
                    Precision::Single => data.extend(value.to_ne_bytes()),
                }
            }
        }
        colour(&mut data, 1);
        colour(&mut data, 2);
    }
    Ok(data)
}

/// Opens the full form.
///
/// # Errors
/// [`PictureError::Broken`] with what is wrong, and [`PictureError::Memory`] for more than a file
/// of its size may take.
pub fn read_full(bytes: &[u8]) -> Result<Picture, PictureError> {
    let broken = || PictureError::broken("a broken OpenEXR image", "one that can be decoded");
    let head = guarded(|| MetaData::read_from_buffered(Cursor::new(bytes), false))
        .ok_or_else(broken)?
        .map_err(|_| broken())?;
    let [exr] = &head.headers[..] else {
        return Err(PictureError::broken(
            format!("{} layers", head.headers.len()),
            "one layer",
        ));
    };
    let header = checked(exr)?;
    let pixels = header.width.saturating_mul(header.height);
    let needs = pixels
        .saturating_mul(exr.channels.list.len())
        .saturating_mul(8);
    let most = budget::of(bytes.len());
    if needs > most {
        return Err(PictureError::Memory { needs, most });
    }
    let image = guarded(|| {
        exr_reader()
            .no_deep_data()
            .largest_resolution_level()
            .all_channels()
            .first_valid_layer()
            .all_attributes()
            .non_parallel()
            .from_buffered(Cursor::new(bytes))
    })
    .ok_or_else(broken)?
    .map_err(|_| broken())?;
    let planes = planes_of(&image.layer_data.channel_data.list, &header)?;
    Picture::new(header, planes)
}

/// The composite picture's header, if the layer is as it says.
fn checked(exr: &ExrHeader) -> Result<Header, PictureError> {
    let attributes = exr.own_attributes.other.iter();
    let mut texts = attributes.filter(|(name, _)| **name == *ATTRIBUTE);
    let Some((_, AttributeValue::Text(text))) = texts.next() else {
        return Err(PictureError::broken(
            "an OpenEXR image without the attribute compositePicture",
            "a composite picture",
        ));
    };
    let header = Header::from_json(&text.to_string())?;
    if exr.deep || (exr.layer_size.0, exr.layer_size.1) != (header.width, header.height) {
        let found = format!("{} x {} pixels", exr.layer_size.0, exr.layer_size.1);
        let expected = format!("the header's {} x {}", header.width, header.height);
        return Err(PictureError::broken(found, expected));
    }
    let mut names: Vec<String> = exr
        .channels
        .list
        .iter()
        .map(|c| c.name.to_string())
        .collect();
    names.sort();
    if names != channel_names(header.numbers)
        || exr
            .channels
            .list
            .iter()
            .any(|c| c.sampling.0 != 1 || c.sampling.1 != 1)
    {
        let found = format!("{} channels", names.len());
        let expected = format!("B, G, R and CS.000 to CS.{:03}", header.numbers - 1);
        return Err(PictureError::broken(found, expected));
    }
    Ok(header)
}

/// The planes of numbers, one after the other.
fn planes_of(
    channels: &[AnyChannel<FlatSamples>],
    header: &Header,
) -> Result<Vec<f32>, PictureError> {
    let pixels = header.width * header.height;
    let mut planes = vec![f32::NAN; pixels * header.numbers];
    for channel in channels {
        let name = channel.name.to_string();
        let Some(n) = name
            .strip_prefix("CS.")
            .and_then(|n| n.parse::<usize>().ok())
        else {
            continue;
        };
        let Some(plane) = planes.chunks_exact_mut(pixels).nth(n) else {
            continue;
        };
        match &channel.sample_data {
            FlatSamples::F16(values) if values.len() == pixels => {
                let values = plane.iter_mut().zip(values);
                values.for_each(|(z, v)| *z = Half::back(header.scale, v.to_f32()));
            }
            FlatSamples::F32(values) if values.len() == pixels => {
                let values = plane.iter_mut().zip(values);
                values.for_each(|(z, v)| *z = Half::back(header.scale, *v));
            }
            _ => {
                return Err(PictureError::broken(
                    "a channel of other numbers",
                    "half or float",
                ));
            }
        }
    }
    // A single infinite number is no number; the pixel was not measured.
    for i in 0..pixels {
        if (0..header.numbers).any(|n| !planes[n * pixels + i].is_finite()) {
            (0..header.numbers).for_each(|n| planes[n * pixels + i] = f32::NAN);
        }
    }
    Ok(planes)
}
