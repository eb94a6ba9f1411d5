//! The PNG about the tiles: writing it strip by strip, opening it tile by tile.

use std::io::Write;
use std::ops::Range;
use std::sync::Arc;

use crate::io::{PngFile, png_chunks};
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

/// Quantiser for writing a compact file, and the errors that the file will have.
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
    let mut file = PngFile::new([preview.width, preview.height], &preview.rgb, false, out)?;
    file.chunk(HEADER, &zlib::packed(header.to_json().as_bytes()))?;
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
            file.chunk(TILES, &bytes)?;
        }
        progress.step();
    }
    Ok(file.finish()?)
}

/// A compact file that was opened; its tiles are decoded when they are asked for.
#[derive(Clone, Debug)]
pub struct CompactFile {
    /// The header.
    pub header: Header,
    quantiser: Quantiser,
    bytes: Arc<Vec<u8>>,
    /// Byte range of each tile's planes, row after row.
    tiles: Vec<(usize, usize)>,
    across: usize,
}

/// Where each tile's bytes stand, row by row, from tiles with their columns and rows.
fn placed(
    found: &[(u32, u32, usize, usize)],
    [across, down]: [usize; 2],
) -> Result<Vec<(usize, usize)>, PictureError> {
    let mut tiles = vec![(0, 0); found.len()];
    for &(x, y, start, end) in found {
        let (x, y) = (x as usize, y as usize);
        let place = (x < across && y < down).then(|| y * across + x);
        match place.and_then(|place| tiles.get_mut(place)) {
            Some(slot) if slot.1 == 0 => *slot = (start, end),
            _ => {
                let found = tr!("a tile at column {x}, row {y} out of range or twice", x, y);
                return Err(PictureError::broken(
                    found,
                    tr!("each of {across} x {down} once", across, down),
                ));
            }
        }
    }
    Ok(tiles)
}

impl CompactFile {
    /// Opens a file from its bytes; the header is read, the tiles are found, nothing is decoded.
    ///
    /// # Errors
    /// [`PictureError::Broken`] with what is wrong.
    pub fn open(bytes: Vec<u8>) -> Result<Self, PictureError> {
        let chunks = png_chunks(&bytes).ok_or_else(|| {
            PictureError::broken(said!("no PNG"), said!("a composite picture NAME.cspx.png"))
        })?;
        let mut header: Option<Header> = None;
        let mut found: Vec<(u32, u32, usize, usize)> = Vec::new();
        for chunk in chunks {
            let (kind, Range { start, end }) =
                chunk.map_err(|[found, expected]| PictureError::broken(found, expected))?;
            let data = &bytes[start..end];
            match kind {
                HEADER if header.is_some() => {
                    return Err(PictureError::broken(
                        said!("two headers csPH"),
                        said!("one"),
                    ));
                }
                HEADER => {
                    let text = zlib::unpacked(data, MOST_HEADER)?;
                    let text = String::from_utf8(text).map_err(|_| {
                        PictureError::broken(said!("a header that is no text"), "JSON")
                    })?;
                    header = Some(Header::from_json(&text)?);
                }
                TILES => {
                    let ([column, row], _) =
                        data.as_chunks().0.split_first_chunk().ok_or_else(|| {
                            PictureError::broken(
                                said!("a tile without a place"),
                                said!("its column and row"),
                            )
                        })?;
                    let word = |bytes: &[u8; 4]| u32::from_be_bytes(*bytes);
                    found.push((word(column), word(row), start + 8, end));
                }
                _ => {}
            }
        }
        let header = header.ok_or_else(|| {
            PictureError::broken(
                said!(
                    "a PNG without the chunk csPH (an editor may have dropped it): a picture and \
                     nothing more"
                ),
                said!("a composite picture"),
            )
        })?;
        let stored = header.quantiser.as_ref().ok_or_else(|| {
            PictureError::broken(
                said!("a header without a quantiser"),
                said!("one in a compact file"),
            )
        })?;
        let quantiser = Quantiser::stored(stored, header.numbers)?;
        let tile = stored.tile;
        let (across, down) = (header.width.div_ceil(tile), header.height.div_ceil(tile));
        if across.checked_mul(down) != Some(found.len()) {
            let found = tr!("{found} tiles", found = found.len());
            return Err(PictureError::broken(found, format!("{across} x {down}")));
        }
        let tiles = placed(&found, [across, down])?;
        Ok(Self {
            header,
            quantiser,
            bytes: Arc::new(bytes),
            tiles,
            across,
        })
    }

    /// Tiles across and down.
    pub(crate) fn tiles(&self) -> (usize, usize) {
        (self.across, self.tiles.len() / self.across)
    }

    /// The pixels of a tile.
    pub(crate) fn rect(&self, x: usize, y: usize) -> Rect {
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
            let found = tr!("tile {x}, {y}", x, y);
            return Err(PictureError::broken(
                found,
                tr!("one of {across} x {down}", across, down),
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
