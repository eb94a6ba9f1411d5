//! PNG pictures.

use std::io::Cursor;

use png::{DecodingError, Transformations};

use crate::io::decode::png::frame;

use super::{ColourPixels, Exif, Refused, Stored, check_size, refused};

/// Deflate keeps at most 1032 bytes in one, and a pixel of palettes may be an eighth of a byte.
const PIXELS_A_BYTE: usize = 8 * 1032;

pub(super) fn read(bytes: &[u8]) -> Result<Stored, Refused> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::EXPAND);
    let broken = |_: DecodingError| {
        (
            said!("a broken stream").to_owned(),
            said!("a whole PNG picture").to_owned(),
        )
    };
    // What is said in the header is looked at before anything is made for it.
    let header = decoder.read_header_info().map_err(broken)?;
    let size = [header.width as usize, header.height as usize];
    let channels = header.color_type.samples() * header.bit_depth as usize;
    check_size(size, bytes.len(), PIXELS_A_BYTE / channels.max(1))?;
    let reader = decoder.read_info().map_err(broken)?;
    let info = reader.info();
    let gamma = info.gamma().map(|gamma| gamma.into_value());
    let is_linear = gamma.is_some_and(|g| (g - 1.0).abs() < 0.01);
    let exif = info
        .exif_metadata
        .as_deref()
        .map(Exif::of)
        .unwrap_or_default();
    let (pixels, channels) = match frame(reader) {
        Ok(decoded) => decoded,
        Err(None) => {
            return refused(
                said!("a picture too large for memory"),
                said!("a smaller one"),
            );
        }
        Err(Some(error)) => return Err(broken(error)),
    };
    let (pixels, shone_through) = match pixels {
        ColourPixels::Sixteen(words) => {
            let (codes, through) = over_black(words, channels, u64::from(u16::MAX));
            (ColourPixels::Sixteen(codes), through)
        }
        ColourPixels::Eight(bytes) => {
            let (codes, through) = over_black(bytes, channels, u64::from(u8::MAX));
            (ColourPixels::Eight(codes), through)
        }
    };
    let notes = if shone_through {
        vec![said!("what shines through is shown over black")]
    } else {
        vec![]
    };
    Ok(Stored {
        size,
        pixels,
        is_linear,
        exif,
        notes,
    })
}

/// Red, green and blue of pixels of one to four channels, and whether any shone through.
fn over_black<T>(data: Vec<T>, channels: usize, full: u64) -> (Vec<T>, bool)
where
    T: Copy + Into<u64> + TryFrom<u64>,
{
    let mut shone_through = false;
    let mut through = |code: T, alpha: T| {
        let alpha: u64 = alpha.into();
        shone_through |= alpha < full;
        T::try_from((code.into() * alpha + full / 2) / full).unwrap_or(code)
    };
    let codes = match channels {
        3 => data,
        4 => (data.chunks_exact(4))
            .flat_map(|p| {
                [
                    through(p[0], p[3]),
                    through(p[1], p[3]),
                    through(p[2], p[3]),
                ]
            })
            .collect(),
        2 => (data.chunks_exact(2))
            .flat_map(|p| [through(p[0], p[1]); 3])
            .collect(),
        _ => data.iter().flat_map(|p| [*p; 3]).collect(),
    };
    (codes, shone_through)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_shines_through_is_darker_and_said() {
        assert_eq!(
            over_black(vec![200_u8, 100, 50, 255], 4, 255),
            (vec![200, 100, 50], false)
        );
        assert_eq!(
            over_black(vec![200_u8, 100, 50, 51], 4, 255),
            (vec![40, 20, 10], true)
        );
        assert_eq!(
            over_black(vec![8_u8, 255, 9, 0], 2, 255),
            (vec![8, 8, 8, 0, 0, 0], true)
        );
        assert_eq!(over_black(vec![7_u16], 1, 65_535), (vec![7, 7, 7], false));
    }
}
