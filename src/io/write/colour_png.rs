//! Pictures of colours: PNG files as red, green and blue of each pixel.

use std::{
    fs::File,
    io::{BufRead, BufReader},
    path::Path,
};

use crate::io::why_unopened;

/// What every PNG file begins with.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// What is said of a picture that memory does not hold.
const TOO_LARGE: &str = "found a picture too large for memory, expected a smaller one";

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

impl ColourPng {
    /// Reads a PNG file of at most so many pixels; what shines through is dropped.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn read(path: &Path, most_pixels: usize) -> Result<Self, String> {
        let unopened = |why| {
            let (found, expected) = why_unopened(path, &why);
            format!("found {found}, expected {expected}")
        };
        let mut file = BufReader::new(File::open(path).map_err(unopened)?);
        if !file.fill_buf().map_err(unopened)?.starts_with(SIGNATURE) {
            return Err("found a file of another kind, expected a PNG picture".to_owned());
        }
        let mut decoder = png::Decoder::new(file);
        decoder.set_transformations(png::Transformations::EXPAND);
        let refused = |why: png::DecodingError| match why {
            png::DecodingError::LimitsExceeded => TOO_LARGE.to_owned(),
            _ => "found a damaged picture, expected a whole PNG picture".to_owned(),
        };
        let mut reader = decoder.read_info().map_err(refused)?;
        let info = reader.info();
        let size = [info.width as usize, info.height as usize];
        if size[0].saturating_mul(size[1]) > most_pixels {
            return Err(format!(
                "found {} x {} px, expected at most {most_pixels} pixels",
                size[0], size[1]
            ));
        }
        let bytes = reader.output_buffer_size();
        let bytes = bytes.ok_or(TOO_LARGE)?;
        let mut data = vec![0; bytes];
        let frame = reader.next_frame(&mut data).map_err(refused)?;
        data.truncate(frame.buffer_size());
        let channels = frame.color_type.samples();
        let pixels = match frame.bit_depth {
            png::BitDepth::Sixteen => {
                let words = data
                    .chunks_exact(2)
                    .map(|two| u16::from_be_bytes([two[0], two[1]]));
                ColourPixels::Sixteen(coloured(&words.collect::<Vec<u16>>(), channels))
            }
            _ => ColourPixels::Eight(coloured(&data, channels)),
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
