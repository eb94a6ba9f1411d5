//! JPEG pictures.

use std::io::Cursor;

use zune_jpeg::{
    JpegDecoder,
    zune_core::{colorspace::ColorSpace, options::DecoderOptions},
};

use super::{ColourPixels, Exif, Refused, SIDES, Stored, check_size, refused};

/// No JPEG keeps more pixels in a byte than this.
const PIXELS_A_BYTE: usize = 2000;

pub(super) fn read(bytes: &[u8]) -> Result<Stored, Refused> {
    // Headers first, with room for sizes that are refused in words.
    let options = DecoderOptions::default()
        .set_max_width(4 * SIDES.1)
        .set_max_height(4 * SIDES.1)
        .set_strict_mode(true)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    let broken = |_| {
        (
            said!("a broken stream").to_owned(),
            said!("a whole JPEG picture").to_owned(),
        )
    };
    decoder.decode_headers().map_err(broken)?;
    let Some(info) = decoder.info() else {
        return refused(said!("a broken stream"), said!("a whole JPEG picture"));
    };
    let size = [usize::from(info.width), usize::from(info.height)];
    check_size(size, bytes.len(), PIXELS_A_BYTE)?;
    match decoder.input_colorspace() {
        Some(ColorSpace::CMYK | ColorSpace::YCCK) => {
            return refused(
                said!("a CMYK picture, made for printing"),
                said!("RGB: save it as RGB JPEG"),
            );
        }
        _ if !ends(bytes) => {
            return refused(
                said!("a picture that was cut off"),
                said!("a whole JPEG picture"),
            );
        }
        _ => {}
    }
    let pixels = decoder.decode().map_err(broken)?;
    if pixels.len() != 3 * size[0] * size[1] {
        return refused(said!("a broken stream"), said!("a whole JPEG picture"));
    }
    let exif = info.exif_data.as_deref().map(Exif::of).unwrap_or_default();
    Ok(Stored {
        size,
        pixels: ColourPixels::Eight(pixels),
        is_linear: false,
        exif,
        notes: Vec::new(),
    })
}

/// True if the picture's own end marker is present, after its first scan.
fn ends(bytes: &[u8]) -> bool {
    let mut at = 2;
    while let Some([0xff, marker, high, low]) = bytes.get(at..at + 4) {
        match marker {
            // Bytes that fill up.
            0xff => at += 1,
            0xda => return bytes[at..].windows(2).any(|two| two == [0xff, 0xd9]),
            _ => at += 2 + usize::from(u16::from_be_bytes([*high, *low])),
        }
    }
    false
}
