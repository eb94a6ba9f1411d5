//! The PNG about the tiles: writing it strip by strip, opening it tile by tile.

use std::io::Write;
use std::sync::Arc;

use crate::spectrum::Rect;
use crate::study::Progress;

use super::super::header::{About, Header};
use super::super::measure::{Errors, measure};
use super::super::preview::Preview;
use super::super::strips::over_parts;
use super::super::{Operator, Picture, PictureError, Pixels, STRIP_ROWS};
use super::quantiser::{P95_OF_STEP, Quantiser, TILE};
use super::tile::{self, Coder};
use super::zlib;

const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";
const HEADER: [u8; 4] = *b"csPH";
const TILES: [u8; 4] = *b"csPT";
/// A header never unfolds beyond this.
const MOST_HEADER: usize = 16 << 20;
/// Times that a step is corrected by what it was measured to make.
const CORRECTIONS: usize = 3;
/// Memory that any compact file may take when it is opened whole, and each of its bytes besides: a
/// flat picture unfolds to a thousand times its size.
const FLOOR: usize = 64 << 20;
const TIMES: usize = 400;

/// What is needed to write a compact file, and what it will be off by.
#[derive(Clone, Debug)]
pub struct CompactPlan {
    /// The steps.
    pub quantiser: Quantiser,
    /// Measured after decoding, over every pixel.
    pub error: Errors,
}

/// Steps that keep the 95th percentile of own colour at a bound: started from what is usual,
/// measured, corrected.
///
/// # Errors
/// Those of the source, and of [`Quantiser::new`].
pub fn compact_plan(
    pixels: &dyn Pixels,
    operator: &Operator,
    sample: &[Vec<f64>],
    bound_p95: f64,
    white_y: f64,
    progress: &Progress,
) -> Result<CompactPlan, PictureError> {
    let numbers: Vec<Vec<f64>> = sample.iter().map(|p| operator.numbers_of(p)).collect();
    let mut quantiser = Quantiser::new(operator, &numbers, bound_p95 / P95_OF_STEP, None)?;
    let mut error = measure(pixels, operator, &quantiser, white_y, progress)?;
    for _ in 0..CORRECTIONS {
        let off = error.own.p95 / bound_p95;
        // Within three per cent below the bound is as near as it gets.
        if !(off.is_finite() && off > 0.0) || (0.97..=1.0).contains(&off) {
            break;
        }
        let step = (quantiser.step() / off * 0.99).clamp(1e-3, 64.0);
        if step == quantiser.step() {
            break;
        }
        quantiser = quantiser.with_step(step);
        error = measure(pixels, operator, &quantiser, white_y, progress)?;
    }
    Ok(CompactPlan { quantiser, error })
}

/// Writes the compact form. Nothing of the picture is kept but one row of tiles.
///
/// # Errors
/// Those of the source and of the writer, and [`PictureError::Cancelled`].
pub fn write_compact(
    out: &mut dyn Write,
    pixels: &dyn Pixels,
    operator: &Operator,
    plan: &CompactPlan,
    about: &About,
    coder: Coder,
    progress: &Progress,
) -> Result<(), PictureError> {
    let (width, height) = pixels.size();
    let preview = Preview::of(pixels, operator, progress)?;
    let mut header = Header::of(operator, (width, height), about, plan.error.clone());
    header.mask = plan.error.no_data > 0;
    header.quantiser = Some(plan.quantiser.as_stored().clone());
    let trouble = |error: png::EncodingError| PictureError::Trouble(error.to_string());
    let mut encoder = png::Encoder::new(out, preview.width as u32, preview.height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_source_srgb(png::SrgbRenderingIntent::Perceptual);
    let mut writer = encoder.write_header().map_err(trouble)?;
    writer.write_image_data(&preview.rgb).map_err(trouble)?;
    let packed = zlib::packed(header.to_json().as_bytes());
    writer
        .write_chunk(png::chunk::ChunkType(HEADER), &packed)
        .map_err(trouble)?;
    let encode = operator.encoder();
    let count = operator.numbers();
    progress.expect(height.div_ceil(TILE));
    for (row, top) in (0..height).step_by(TILE).enumerate() {
        let rows = TILE.min(height - top);
        let band = width * rows;
        let mut numbers = vec![0.0; count * band];
        for first in (0..rows).step_by(STRIP_ROWS) {
            let some = STRIP_ROWS.min(rows - first);
            let mut values = vec![0.0; width * some * pixels.bands().len()];
            pixels.rows(top + first, some, &mut values)?;
            let mut found = vec![0.0; count * width * some];
            encode.apply(&values, width * some, &mut found);
            for (n, plane) in found.chunks_exact(width * some).enumerate() {
                numbers[n * band + first * width..][..width * some].copy_from_slice(plane);
            }
        }
        let silent = Progress::default();
        let tiles = over_parts(
            width.div_ceil(TILE),
            TILE * TILE * count,
            &silent,
            |column| {
                if progress.is_cancelled() {
                    return Err(PictureError::Cancelled);
                }
                let left = column * TILE;
                let across = TILE.min(width - left);
                let mut of_tile = Vec::with_capacity(count * across * rows);
                for n in 0..count {
                    for y in 0..rows {
                        of_tile
                            .extend_from_slice(&numbers[n * band + y * width + left..][..across]);
                    }
                }
                let mut bytes = Vec::new();
                bytes.extend((column as u32).to_be_bytes());
                bytes.extend((row as u32).to_be_bytes());
                bytes.extend(tile::encode(
                    &of_tile,
                    (across, rows),
                    &plan.quantiser,
                    header.mask,
                    coder,
                ));
                Ok(bytes)
            },
        )?;
        for bytes in tiles {
            writer
                .write_chunk(png::chunk::ChunkType(TILES), &bytes)
                .map_err(trouble)?;
        }
        progress.step();
    }
    writer.finish().map_err(trouble)
}

/// A compact file that was opened; its tiles are decoded when they are asked for.
#[derive(Clone, Debug)]
pub struct CompactFile {
    /// The header.
    pub header: Header,
    quantiser: Quantiser,
    bytes: Arc<Vec<u8>>,
    /// Where each tile's planes lie, row after row.
    tiles: Vec<(usize, usize)>,
    across: usize,
}

impl CompactFile {
    /// Opens a file from its bytes; the header is read, the tiles are found, nothing is decoded.
    ///
    /// # Errors
    /// [`PictureError::Broken`] with what is wrong.
    pub fn open(bytes: Vec<u8>) -> Result<Self, PictureError> {
        if !bytes.starts_with(SIGNATURE) {
            return Err(PictureError::broken(
                "no PNG",
                "a composite picture NAME.cspx.png",
            ));
        }
        let mut header: Option<Header> = None;
        let mut found: Vec<(u32, u32, usize, usize)> = Vec::new();
        let mut at = SIGNATURE.len();
        let mut is_ended = false;
        while !is_ended {
            let (kind, start, end) = chunk(&bytes, at)?;
            let data = &bytes[start..end];
            match kind {
                HEADER if header.is_some() => {
                    return Err(PictureError::broken("two headers csPH", "one"));
                }
                HEADER => {
                    let text = zlib::unpacked(data, MOST_HEADER)?;
                    let text = String::from_utf8(text)
                        .map_err(|_| PictureError::broken("a header that is no text", "JSON"))?;
                    header = Some(Header::from_json(&text)?);
                }
                TILES => {
                    let place = data.split_at_checked(8).ok_or_else(|| {
                        PictureError::broken("a tile without a place", "its column and row")
                    })?;
                    let word = |i: usize| {
                        u32::from_be_bytes([
                            place.0[i],
                            place.0[i + 1],
                            place.0[i + 2],
                            place.0[i + 3],
                        ])
                    };
                    found.push((word(0), word(4), start + 8, end));
                }
                _ => is_ended = kind == *b"IEND",
            }
            at = end + 4;
        }
        let header = header.ok_or_else(|| {
            PictureError::broken(
                "a PNG without the chunk csPH (an editor may have dropped it): a picture and nothing more",
                "a composite picture",
            )
        })?;
        let stored = header.quantiser.as_ref().ok_or_else(|| {
            PictureError::broken("a header without a quantiser", "one in a compact file")
        })?;
        let quantiser = Quantiser::stored(stored, header.numbers)?;
        let tile = stored.tile;
        let (across, down) = (header.width.div_ceil(tile), header.height.div_ceil(tile));
        if across.checked_mul(down) != Some(found.len()) {
            let found = format!("{} tiles", found.len());
            return Err(PictureError::broken(found, format!("{across} x {down}")));
        }
        let mut tiles = vec![(0, 0); found.len()];
        for (x, y, start, end) in found {
            let (x, y) = (x as usize, y as usize);
            let place = (x < across && y < down).then(|| y * across + x);
            match place.and_then(|place| tiles.get_mut(place)) {
                Some(slot) if slot.1 == 0 => *slot = (start, end),
                _ => {
                    let found = format!("a tile at column {x}, row {y} out of range or twice");
                    return Err(PictureError::broken(
                        found,
                        format!("each of {across} x {down} once"),
                    ));
                }
            }
        }
        Ok(Self {
            header,
            quantiser,
            bytes: Arc::new(bytes),
            tiles,
            across,
        })
    }

    /// Tiles across and down.
    pub fn tiles(&self) -> (usize, usize) {
        (self.across, self.tiles.len() / self.across)
    }

    /// The pixels of a tile.
    pub fn rect(&self, x: usize, y: usize) -> Rect {
        let tile = self.quantiser.as_stored().tile;
        Rect {
            x: x * tile,
            y: y * tile,
            width: tile.min(self.header.width.saturating_sub(x * tile)),
            height: tile.min(self.header.height.saturating_sub(y * tile)),
        }
    }

    /// The numbers of one tile, `[number * pixels + i]`.
    ///
    /// # Errors
    /// [`PictureError::Broken`] when it cannot be decoded or there is none.
    pub fn tile(&self, x: usize, y: usize) -> Result<Vec<f32>, PictureError> {
        let (across, down) = self.tiles();
        if x >= across || y >= down {
            let found = format!("tile {x}, {y}");
            return Err(PictureError::broken(
                found,
                format!("one of {across} x {down}"),
            ));
        }
        let (start, end) = self.tiles[y * across + x];
        let Rect { width, height, .. } = self.rect(x, y);
        let header = &self.header;
        tile::decode(
            &self.bytes[start..end],
            (width, height),
            &self.quantiser,
            header.numbers,
            header.mask,
        )
    }

    /// The whole picture in memory.
    ///
    /// # Errors
    /// [`PictureError::Memory`] beyond 64 MiB and 400 times the file's size, those of a tile, and
    /// [`PictureError::Cancelled`].
    pub fn picture(&self, progress: &Progress) -> Result<Picture, PictureError> {
        let header = &self.header;
        let pixels = header.width.saturating_mul(header.height);
        let needs = pixels.saturating_mul(header.numbers).saturating_mul(4);
        let most = FLOOR.saturating_add(self.bytes.len().saturating_mul(TIMES));
        if needs > most {
            return Err(PictureError::Memory { needs, most });
        }
        progress.expect(self.tiles.len());
        let tile = self.quantiser.as_stored().tile;
        let across = self.across;
        let tiles = over_parts(
            self.tiles.len(),
            tile * tile * header.numbers,
            progress,
            |at| self.tile(at % across, at / across),
        )?;
        let mut planes = vec![0.0; pixels * header.numbers];
        for (at, numbers) in tiles.iter().enumerate() {
            let rect = self.rect(at % across, at / across);
            for (n, plane) in numbers.chunks_exact(rect.pixels()).enumerate() {
                for (y, row) in plane.chunks_exact(rect.width).enumerate() {
                    let start = n * pixels + (rect.y + y) * header.width + rect.x;
                    planes[start..start + rect.width].copy_from_slice(row);
                }
            }
        }
        Picture::new(header.clone(), planes)
    }
}

/// The chunk at a place: its kind, where its data begin and end.
fn chunk(bytes: &[u8], at: usize) -> Result<([u8; 4], usize, usize), PictureError> {
    let short = || PictureError::broken("a PNG that ends early", "one to its IEND");
    let head = bytes.get(at..at + 8).ok_or_else(short)?;
    let length = u32::from_be_bytes([head[0], head[1], head[2], head[3]]) as usize;
    let kind = [head[4], head[5], head[6], head[7]];
    let end = (at + 8).checked_add(length).ok_or_else(short)?;
    let sum = bytes.get(end..end + 4).ok_or_else(short)?;
    let mut check = flate2::Crc::new();
    check.update(&bytes[at + 4..end]);
    if check.sum().to_be_bytes() != sum {
        // Any bytes may stand in a damaged file, line ends too.
        let name = kind.escape_ascii();
        return Err(PictureError::broken(
            format!("a chunk {name} with a wrong check sum"),
            "a whole one",
        ));
    }
    Ok((kind, at + 8, end))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_damaged_chunk_is_refused_in_one_line() {
        let bytes = [&[0, 0, 0, 0][..], b"ID\0\n", &[1, 2, 3, 4]].concat();
        let refusal = chunk(&bytes, 0).unwrap_err().to_string();
        assert!(
            refusal.contains("a chunk ID\\x00\\n with a wrong check sum"),
            "{refusal}"
        );
        assert!(!refusal.contains(char::is_control), "{refusal}");
    }
}
