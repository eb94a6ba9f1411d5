//! A picture as a PNG file.

/// A picture of 8-bit sRGB as a PNG file that says so, of so many columns and rows; `None` when
/// pixels and size differ.
pub fn png([width, height]: [usize; 2], pixels: &[[u8; 3]]) -> Option<Vec<u8>> {
    let side = |side| u32::try_from(side).ok().filter(|side| *side > 0);
    let (across, down) = (side(width)?, side(height)?);
    if pixels.len() != width * height {
        return None;
    }
    let mut file = Vec::new();
    let mut encoder = ::png::Encoder::new(&mut file, across, down);
    encoder.set_color(::png::ColorType::Rgb);
    encoder.set_depth(::png::BitDepth::Eight);
    encoder.set_source_srgb(::png::SrgbRenderingIntent::Perceptual);
    // The command line knows its own pictures by it, and replaces no others.
    let [key, mark] = ["Software", env!("CARGO_PKG_NAME")].map(str::to_owned);
    encoder.add_text_chunk(key, mark).ok()?;
    let mut writer = encoder.write_header().ok()?;
    writer.write_image_data(pixels.as_flattened()).ok()?;
    writer.finish().ok()?;
    Some(file)
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_picture_reads_back_as_its_pixels() {
        let pixels = [[1, 2, 3], [255, 0, 0], [0, 255, 9], [7, 7, 7]];
        let file = super::png([2, 2], &pixels).unwrap();
        let mut reader = ::png::Decoder::new(std::io::Cursor::new(file))
            .read_info()
            .unwrap();
        let mut back = vec![0; 12];
        reader.next_frame(&mut back).unwrap();
        assert_eq!(back, pixels.as_flattened());
        assert!(super::png([3, 3], &pixels).is_none() && super::png([0, 0], &[]).is_none());
    }
}
