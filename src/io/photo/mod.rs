//! Photographs: JPEG and PNG pictures as red, green and blue, turned as their EXIF says.
//!
//! Of EXIF only orientation, exposure time, ISO and date are read; the place never is.

mod exif;
mod jpeg;
mod png_photo;

use std::path::Path;

use super::{
    decode::{
        guarded::guarded,
        png::{ColourPixels, SIGNATURE},
    },
    error::ReadError,
    input::name_of,
};
pub(crate) use exif::Exif;

/// Fewest and most pixels of a side, and most of both.
const SIDES: (usize, usize) = (24, 16_384);
const MOST_PIXELS: usize = 100_000_000;
/// Longest file.
const MOST_BYTES: u64 = 512 << 20;

/// A photograph as it is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Photo {
    /// Width and height.
    pub size: [usize; 2],
    /// Its pixels, row by row, as codes.
    pub pixels: ColourPixels,
    /// The codes are proportional to light: a PNG says so by a gamma of 1.
    pub is_linear: bool,
    /// The EXIF data kept of it.
    pub exif: Exif,
    /// The changes made to it.
    pub notes: Vec<&'static str>,
}

/// The contents of a file before the picture is turned.
struct Stored {
    size: [usize; 2],
    pixels: ColourPixels,
    is_linear: bool,
    exif: Exif,
    notes: Vec<&'static str>,
}

/// Why a picture is not read: what was found, what was expected.
type Refused = (String, String);

fn refused<T>(found: impl Into<String>, expected: &str) -> Result<T, Refused> {
    Err((found.into(), expected.to_owned()))
}

/// Reads a photograph from disk.
///
/// # Errors
/// [`ReadError`] for what is no JPEG or PNG, a broken stream, and sides or sizes beyond the limits.
pub(crate) fn read_photo(path: &Path) -> Result<Photo, ReadError> {
    let name = name_of(path);
    let trouble = |error: std::io::Error| {
        let (found, expected) = super::why_unopened(path, &error);
        ReadError::new(&name, found, expected)
    };
    let size = super::disk::len(path).map_err(trouble)?;
    if !super::disk::is_file(path) {
        return Err(ReadError::new(
            &name,
            said!("no file"),
            said!("a JPEG or PNG picture"),
        ));
    }
    if size > MOST_BYTES {
        return Err(ReadError::new(
            &name,
            said!("more than 512 MiB"),
            said!("a smaller picture"),
        ));
    }
    photo_of(&name, &super::disk::read(path).map_err(trouble)?)
}

/// The photograph that bytes hold.
///
/// # Errors
/// As [`read_photo`].
pub(crate) fn photo_of(name: &str, bytes: &[u8]) -> Result<Photo, ReadError> {
    let stored = if bytes.starts_with(SIGNATURE) {
        guarded(|| png_photo::read(bytes))
    } else if bytes.starts_with(b"\xff\xd8") {
        guarded(|| jpeg::read(bytes))
    } else {
        Some(refused(kind_of(bytes).0, kind_of(bytes).1))
    };
    let broken = || {
        refused(
            said!("a broken stream"),
            said!("a whole JPEG or PNG picture"),
        )
    };
    let stored = stored.unwrap_or_else(broken);
    stored
        .map(shown)
        .map_err(|(found, expected)| ReadError::new(name, found, expected))
}

/// The type of a file that is neither JPEG nor PNG, and the suggested remedy.
fn kind_of(bytes: &[u8]) -> (&'static str, &'static str) {
    let brand = bytes.get(4..12).unwrap_or_default();
    let is_brand = |names: &[&[u8; 4]]| {
        brand.starts_with(b"ftyp") && names.iter().any(|name| brand[4..] == name[..])
    };
    if is_brand(&[b"heic", b"heix", b"heif", b"hevc", b"mif1", b"msf1"]) {
        (
            said!("a HEIC picture, which cannot be read"),
            said!("JPEG or PNG: save it as JPEG"),
        )
    } else if is_brand(&[b"avif", b"avis"]) {
        (
            said!("an AVIF picture, which cannot be read"),
            said!("JPEG or PNG: save it as JPEG"),
        )
    } else if bytes.starts_with(b"GIF8") {
        (
            said!("a GIF"),
            said!("JPEG or PNG: save one of its pictures as PNG"),
        )
    } else if bytes.starts_with(b"II*\0") || bytes.starts_with(b"MM\0*") || is_brand(&[b"crx "]) {
        (
            said!("a raw or TIFF file"),
            said!("JPEG or PNG: save it as JPEG, or as PNG of 16 bit"),
        )
    } else if bytes.starts_with(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
        (
            said!("a WebP picture"),
            said!("JPEG or PNG: save it as PNG"),
        )
    } else if bytes.is_empty() {
        (said!("an empty file"), said!("a JPEG or PNG picture"))
    } else {
        (
            said!("a file of another kind"),
            said!("a JPEG or PNG picture"),
        )
    }
}

/// Refuses sizes beyond the limits, and those that so few bytes cannot hold.
fn check_size(size: [usize; 2], bytes: usize, most_pixels_a_byte: usize) -> Result<(), Refused> {
    let [width, height] = size;
    let found = format!("{width} x {height} px");
    let pixels = width.saturating_mul(height);
    if width.min(height) < SIDES.0 || width.max(height) > SIDES.1 {
        return refused(found, said!("sides of 24 to 16384 px"));
    }
    if pixels > MOST_PIXELS {
        return refused(found, said!("at most 100 megapixels"));
    }
    if pixels > bytes.saturating_mul(most_pixels_a_byte) {
        let found = tr!(
            "{size} in {n} bytes" | "{size} in {n} bytes" % bytes,
            size = found
        );
        let expected = said!("a file that holds as many pixels as its header says");
        return refused(found, expected);
    }
    Ok(())
}

/// A stored picture as it is shown.
fn shown(stored: Stored) -> Photo {
    let turn = stored.exif.orientation;
    let size = match turn {
        5.. => [stored.size[1], stored.size[0]],
        _ => stored.size,
    };
    let pixels = match stored.pixels {
        ColourPixels::Eight(codes) => ColourPixels::Eight(turned(codes, stored.size, turn)),
        ColourPixels::Sixteen(codes) => ColourPixels::Sixteen(turned(codes, stored.size, turn)),
    };
    Photo {
        size,
        pixels,
        is_linear: stored.is_linear,
        exif: stored.exif,
        notes: stored.notes,
    }
}

/// Pixels turned and mirrored by an orientation of EXIF, 1 to 8.
fn turned<T: Copy + Default>(pixels: Vec<T>, [width, height]: [usize; 2], turn: u8) -> Vec<T> {
    if turn < 2 {
        return pixels;
    }
    let new_width = if turn > 4 { height } else { width };
    let mut shown = vec![T::default(); pixels.len()];
    for (y, row) in pixels.chunks_exact(3 * width).enumerate() {
        for (x, pixel) in row.chunks_exact(3).enumerate() {
            let (right, below) = (width - 1 - x, height - 1 - y);
            let (column, line) = match turn {
                2 => (right, y),
                3 => (right, below),
                4 => (x, below),
                5 => (y, x),
                6 => (below, x),
                7 => (below, right),
                _ => (y, right),
            };
            let at = 3 * (line * new_width + column);
            shown[at..at + 3].copy_from_slice(pixel);
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A picture of 32 x 24 px whose red tells the column and green the row.
    fn png(depth: png::BitDepth, gamma: bool) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 32, 24);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(depth);
        if gamma {
            encoder.set_source_gamma(png::ScaledFloat::new(1.0));
        }
        let wide = depth == png::BitDepth::Sixteen;

        let codes = (0..=255_u8).chain(0..=255).chain(0..=255).zip(0_u16..);
        let data = codes.flat_map(|(_, i)| {
            let [r, g, b] = [i % 32, i / 32, 7].map(|v| v as u8);

            if wide {
                vec![r, 9, g, 9, b, 9]
            } else {
                vec![r, g, b]
            }
        });
        let data: Vec<u8> = data.collect();
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(&data).expect("pixels");
        writer.finish().expect("an end");
        bytes
    }

    fn words(bytes: &[u8]) -> String {
        photo_of("a.jpg", bytes)
            .expect_err("no picture")
            .to_string()
    }

    #[test]
    fn pixels_of_eight_and_sixteen_bits_are_read_as_they_are() {
        let photo = photo_of("a.png", &png(png::BitDepth::Eight, false)).expect("a picture");
        assert_eq!((photo.size, photo.is_linear), ([32, 24], false));
        let ColourPixels::Eight(codes) = photo.pixels else {
            panic!("bytes")
        };
        assert_eq!(codes[3 * (5 * 32 + 4)..][..3], [4, 5, 7]);
        let photo = photo_of("a.png", &png(png::BitDepth::Sixteen, true)).expect("a picture");
        assert!(photo.is_linear);
        let ColourPixels::Sixteen(codes) = photo.pixels else {
            panic!("words")
        };
        assert_eq!(codes[3 * (5 * 32 + 4)], 4 * 256 + 9);
    }

    #[test]
    fn every_orientation_brings_the_corner_where_it_belongs() {
        // 2 x 3 pixels whose first is 1: where it is shown, as column, row.
        let pixels: Vec<u8> = (1..=6).flat_map(|i| [i; 3]).collect();
        let corners = [
            (0, 0),
            (1, 0),
            (1, 2),
            (0, 2),
            (0, 0),
            (2, 0),
            (2, 1),
            (0, 1),
        ];
        for (turn, (column, row)) in (1..=8).zip(corners) {
            let width = if turn > 4 { 3 } else { 2 };
            let shown = turned(pixels.clone(), [2, 3], turn);
            assert_eq!(shown[3 * (row * width + column)], 1, "orientation {turn}");
        }
    }

    #[test]
    fn what_is_no_whole_picture_of_its_size_is_refused_in_words() {
        let whole = png(png::BitDepth::Eight, false);
        assert!(words(&whole[..whole.len() - 40]).contains("broken"));
        assert!(words(&whole[..20]).contains("broken"));
        let mut lying = whole.clone();
        lying[16..24].copy_from_slice(&[0, 0, 0x27, 0x10, 0, 0, 0x27, 0x0f]);
        let crc = png_crc(&lying[12..29]);
        lying[29..33].copy_from_slice(&crc.to_be_bytes());
        assert!(
            words(&lying).contains("as its header says"),
            "{}",
            words(&lying)
        );
        lying[16..20].copy_from_slice(&[0, 0, 0, 5]);
        let crc = png_crc(&lying[12..29]);
        lying[29..33].copy_from_slice(&crc.to_be_bytes());
        assert!(words(&lying).contains("24 to 16384"), "{}", words(&lying));
        assert!(words(b"\xff\xd8\xff\xe0 no picture at all").contains("broken"));
        assert!(words(b"\0\0\0\x18ftypheic\0\0\0\0").contains("HEIC"));
        assert!(words(b"GIF89a").contains("GIF"));
        assert!(words(b"II*\0abcd").contains("raw"));
        assert!(words(b"lamp").contains("another kind"));
    }

    /// The check sum of a PNG chunk.
    fn png_crc(bytes: &[u8]) -> u32 {
        let step = |crc: u32, byte: &u8| {
            (0..8).fold(crc ^ u32::from(*byte), |c, _| {
                (c >> 1) ^ (0xedb8_8320 * (c & 1))
            })
        };
        !bytes.iter().fold(!0, step)
    }
}
