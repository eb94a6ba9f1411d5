//! PNG out: pictures of 8-bit sRGB declared as such, followed by custom chunks.

use std::io::{self, Write};

use png::chunk::ChunkType;
use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent, Writer};

/// A picture that is written, to which chunks may be added.
pub(crate) struct PngFile<W: Write>(Writer<W>);

impl<W: Write> PngFile<W> {
    /// Writes columns and rows of red, green, blue (and alpha, where there are four
    /// bytes a pixel); `is_own` marks it as one of this program's.
    ///
    /// # Errors
    /// Those of the writer, and of bytes that are no such picture.
    pub(crate) fn new(
        [width, height]: [usize; 2],
        bytes: &[u8],
        is_own: bool,
        out: W,
    ) -> io::Result<Self> {
        let side = |side: usize| u32::try_from(side).map_err(io::Error::other);
        let mut encoder = Encoder::new(out, side(width)?, side(height)?);
        let has_alpha = bytes.len() == 4 * width * height;
        encoder.set_color(if has_alpha {
            ColorType::Rgba
        } else {
            ColorType::Rgb
        });
        encoder.set_depth(BitDepth::Eight);
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
        if is_own {
            // The command line knows its own pictures by it, and replaces no others.
            let [key, mark] = ["Software", env!("CARGO_PKG_NAME")].map(str::to_owned);
            encoder.add_text_chunk(key, mark)?;
        }
        let mut writer = encoder.write_header()?;
        writer.write_image_data(bytes)?;
        Ok(Self(writer))
    }

    /// Adds a chunk.
    ///
    /// # Errors
    /// Those of the writer.
    pub(crate) fn chunk(&mut self, kind: [u8; 4], data: &[u8]) -> io::Result<()> {
        Ok(self.0.write_chunk(ChunkType(kind), data)?)
    }

    /// Ends the file.
    ///
    /// # Errors
    /// Those of the writer.
    pub(crate) fn finish(self) -> io::Result<()> {
        Ok(self.0.finish()?)
    }
}

/// A picture of so many columns and rows as a file with this program's mark, from three or four
/// bytes a pixel; `None` when pixels and size differ.
pub fn png(size: [usize; 2], bytes: &[u8]) -> Option<Vec<u8>> {
    let mut file = Vec::new();
    PngFile::new(size, bytes, true, &mut file)
        .ok()?
        .finish()
        .ok()?;
    Some(file)
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_picture_reads_back_as_its_pixels() {
        let pixels = [[1, 2, 3], [255, 0, 0], [0, 255, 9], [7, 7, 7]];
        let file = super::png([2, 2], pixels.as_flattened()).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file))
            .read_info()
            .unwrap();
        let mut back = vec![0; 12];
        reader.next_frame(&mut back).unwrap();
        assert_eq!(back, pixels.as_flattened());
        let wrong = super::png([3, 3], pixels.as_flattened());
        assert!(wrong.is_none() && super::png([0, 0], &[]).is_none());
    }
}
