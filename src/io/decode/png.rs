//! PNG files: pictures as red, green and blue of each pixel, and the chunks they consist of.

use std::io::{BufRead, BufReader, Seek};
use std::ops::Range;
use std::path::Path;

use png::{BitDepth, Decoder, DecodingError, Reader, Transformations};

use crate::io::{disk, unopened::words as why_unopened};
use crate::languages::said;

/// The first bytes of every PNG file.
pub(crate) const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// The message about a picture that does not fit into memory.
const TOO_LARGE: &str = later!("found a picture too large for memory, expected a smaller one");

/// Kind of a chunk, and the range of its data in the file.
pub(crate) type Chunk = ([u8; 4], Range<usize>);

/// The chunks of a file to its end; `None` if it is not a PNG. Found and expected for an incomplete
/// chunk, which is the last.
pub(crate) fn chunks(bytes: &[u8]) -> Option<impl Iterator<Item = Result<Chunk, [String; 2]>>> {
    let mut next = bytes.starts_with(SIGNATURE).then_some(SIGNATURE.len());
    next?;
    Some(std::iter::from_fn(move || {
        let found = chunk(bytes, next?);
        let is_last = |(kind, _): &Chunk| kind == b"IEND";
        let goes_on = found.as_ref().ok().filter(|chunk| !is_last(chunk));
        next = goes_on.map(|(_, data)| data.end + 4);
        Some(found)
    }))
}

/// The chunk at a place.
fn chunk(bytes: &[u8], at: usize) -> Result<Chunk, [String; 2]> {
    let short = || [said!("a PNG that ends early"), said!("one to its IEND")].map(str::to_owned);
    let word = |at: usize| {
        let word = bytes.get(at..).and_then(<[u8]>::first_chunk::<4>);
        word.copied().ok_or_else(short)
    };
    let (length, kind) = (u32::from_be_bytes(word(at)?), word(at + 4)?);
    let end = (at + 8).checked_add(length as usize).ok_or_else(short)?;
    let sum = word(end)?;
    let mut check = flate2::Crc::new();
    check.update(&bytes[at + 4..end]);
    if check.sum().to_be_bytes() != sum {
        // A damaged file may hold any bytes, line ends too.
        let name = kind.escape_ascii();
        let found = tr!("a chunk {name} with a wrong check sum", name);
        return Err([found, said!("a whole one").to_owned()]);
    }
    Ok((kind, at + 8..end))
}

/// A picture of colours.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourPng {
    /// Width and height.
    pub size: [usize; 2],
    /// Its pixels, row by row.
    pub pixels: ColourPixels,
}

/// Red, green and blue of pixels, one behind the other.
#[derive(Clone, Debug, PartialEq)]
pub enum ColourPixels {
    /// Bytes.
    Eight(Vec<u8>),
    /// Numbers of two bytes.
    Sixteen(Vec<u16>),
}

/// The numbers of a picture, and their number of channels. An error is `None` if the picture does
/// not fit into memory.
pub(crate) fn frame<R: BufRead + Seek>(
    mut reader: Reader<R>,
) -> Result<(ColourPixels, usize), Option<DecodingError>> {
    let mut data = vec![0; reader.output_buffer_size().ok_or(None)?];
    let frame = reader.next_frame(&mut data)?;
    data.truncate(frame.buffer_size());
    let words = || {
        data.as_chunks()
            .0
            .iter()
            .map(|two| u16::from_be_bytes(*two))
    };
    let pixels = match frame.bit_depth {
        BitDepth::Sixteen => ColourPixels::Sixteen(words().collect()),
        _ => ColourPixels::Eight(data),
    };
    Ok((pixels, frame.color_type.samples()))
}

impl ColourPng {
    /// Reads a PNG file of at most so many pixels; the alpha channel is dropped.
    ///
    /// # Errors
    /// A message of what was found and what was expected.
    pub fn read(path: &Path, most_pixels: usize) -> Result<Self, String> {
        let unopened = |why| {
            let (found, expected) = why_unopened(path, &why);
            tr!("found {found}, expected {expected}", found, expected)
        };
        let mut file = BufReader::new(disk::open(path).map_err(unopened)?);
        if !file.fill_buf().map_err(unopened)?.starts_with(SIGNATURE) {
            return Err(said!("found a file of another kind, expected a PNG picture").to_owned());
        }
        let mut decoder = Decoder::new(file);
        decoder.set_transformations(Transformations::EXPAND);
        let refused = |why: Option<DecodingError>| match why {
            None | Some(DecodingError::LimitsExceeded) => said(TOO_LARGE).to_owned(),
            _ => said!("found a damaged picture, expected a whole PNG picture").to_owned(),
        };
        let reader = decoder.read_info().map_err(|why| refused(Some(why)))?;
        let info = reader.info();
        let size = [info.width as usize, info.height as usize];
        if size[0].saturating_mul(size[1]) > most_pixels {
            return Err(tr!(
                "found {width} x {height} px, expected at most {most} pixels",
                width = size[0],
                height = size[1],
                most = most_pixels
            ));
        }
        let pixels = match frame(reader).map_err(refused)? {
            (ColourPixels::Eight(bytes), n) => ColourPixels::Eight(coloured(&bytes, n)),
            (ColourPixels::Sixteen(words), n) => ColourPixels::Sixteen(coloured(&words, n)),
        };
        Ok(Self { size, pixels })
    }

    /// The colour of a pixel in bytes; `None` beside the picture.
    pub fn pixel(&self, x: usize, y: usize) -> Option<[u8; 3]> {
        let [width, height] = self.size;
        if x >= width || y >= height {
            return None;
        }
        let at = 3 * (y * width + x);
        let byte = |k: usize| match &self.pixels {
            ColourPixels::Eight(bytes) => bytes.get(at + k).copied(),
            // 65535 is 255 times 257.
            ColourPixels::Sixteen(words) => {
                let word = words.get(at + k)?;
                u8::try_from((u32::from(*word) + 128) / 257).ok()
            }
        };
        Some([byte(0)?, byte(1)?, byte(2)?])
    }
}

/// Red, green and blue of pixels that have one, two, three or four channels.
fn coloured<T: Copy>(data: &[T], channels: usize) -> Vec<T> {
    let pixels = data.chunks_exact(channels.max(1));
    match channels {
        3 | 4 => pixels.flat_map(|p| [p[0], p[1], p[2]]).collect(),
        _ => pixels.flat_map(|p| [p[0]; 3]).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damaged_chunk_is_refused_in_one_line() {
        let bytes = [SIGNATURE, &[0; 4], b"ID\0\n", &[1, 2, 3, 4]].concat();
        let mut found = chunks(&bytes).unwrap();
        let [refusal, _] = found.next().unwrap().unwrap_err();
        assert_eq!(refusal, "a chunk ID\\x00\\n with a wrong check sum");
        assert!(found.next().is_none() && chunks(&bytes[1..]).is_none());
    }
}
