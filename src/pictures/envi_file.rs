//! An ENVI cube on disk, some rows at a time: pictures larger than the memory.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Mutex;

use crate::io::Meant;
use crate::io::OfOne;
use crate::io::envi::{self, Header, all_bytes};
use crate::spectrum::Kind;
use crate::spectrum::cube::{Interleave, Number, is_missing};

use super::{Bands, KeptBands, PictureError, Pixels};

/// Numbers of this size and beyond stand for "not measured".
const ABSURD: f64 = 1e30;
/// Numbers that decide kind and scale.
const LOOKED_AT: usize = 400;

/// An ENVI cube whose pixels stay on disk.
#[derive(Debug)]
pub struct EnviFile {
    file: Mutex<File>,
    header: Header,
    missing: Option<f64>,
    scale: f64,
    unit: String,
    bands: Bands,
    /// The file's bands that each kept one is the mean of.
    of: Vec<Vec<usize>>,
    said: Vec<String>,
    is_kind_guessed: bool,
}

impl EnviFile {
    /// Opens a cube by its header or its data; only the header and some rows are read. `kind` is
    /// a person's word for what the values are.
    ///
    /// # Errors
    /// [`PictureError`] when there is no such pair, or it is no cube.
    pub fn open(path: &Path, all: bool, kind: Option<Kind>) -> Result<Self, PictureError> {
        let trouble = |error: crate::io::ReadError| PictureError::Trouble(error.to_string());
        let header_path = if envi::starts_as_header(path) {
            path.to_owned()
        } else {
            envi::header_of(path).ok_or_else(|| {
                PictureError::broken("data by themselves", "an ENVI header beside them")
            })?
        };
        let header = envi::read_header(&header_path).map_err(trouble)?;
        let need = all_bytes(&header)
            .ok_or_else(|| PictureError::broken("a size beyond counting", "a cube"))?;
        let data = envi::place_of_data(&header_path, need).ok_or_else(|| {
            PictureError::broken("an ENVI header by itself", "its data beside it")
        })?;
        let file = File::open(&data)?;
        let found = file.metadata()?.len();
        if found < need as u64 || header.is_library() || header.samples == 0 || header.lines == 0 {
            return Err(PictureError::broken(
                format!("{found} bytes"),
                format!("a cube of {need} bytes"),
            ));
        }
        let channels = envi::channels(&header, header.bands, None).map_err(trouble)?;
        let missing = header.number("data ignore value").map_err(trouble)?;
        let mut opened = Self {
            file: Mutex::new(file),
            missing,
            scale: 1.0,
            unit: String::new(),
            bands: Bands::new(channels.bands.iter().map(|b| b.0).collect(), Kind::Light)?,
            of: channels.bands.iter().map(|b| vec![b.1]).collect(),
            said: channels.notes,
            is_kind_guessed: false,
            header,
        };
        let (nm, stored): (Vec<f64>, Vec<usize>) = channels.bands.into_iter().unzip();
        let (sample, gone) = opened.looked_at()?;
        let name = data
            .file_name()
            .map(|n| n.to_string_lossy().into_owned())
            .unwrap_or_default();
        let (known, notes) = envi::values(&opened.header, &name, &sample).map_err(trouble)?;
        let chosen = OfOne {
            kind,
            ..OfOne::default()
        };
        let meant = Meant::of(known, chosen, || sample);
        opened.said.extend(notes);
        opened.said.extend(envi::left_over(&opened.header, found));
        let kept = KeptBands::of_file(&nm, &gone, all);
        let width = envi::bandwidth_nm(&opened.header, &nm, &stored);
        opened.bands = kept.bands(meant.kind.value)?.with_bandwidth(width);
        opened.of = kept
            .of
            .iter()
            .map(|g| g.iter().map(|b| stored[*b]).collect())
            .collect();
        opened.said.extend(meant.said());
        opened.is_kind_guessed = meant.is_kind_guessed();
        opened.said.extend(kept.said);
        (opened.scale, opened.unit) = (meant.scale, meant.unit);
        Ok(opened)
    }

    /// Some rows spread over the picture: their numbers, and each band's share of missing ones.
    fn looked_at(&self) -> Result<(Vec<f64>, Vec<f64>), PictureError> {
        let (width, height) = self.size();
        let count = self.bands.len();
        let (mut sample, mut gone, mut rows) = (Vec::new(), vec![0.0; count], 0.0);
        let mut row = vec![0.0; width * count];
        for y in (0..height).step_by(height.div_ceil(16).max(1)) {
            self.rows(y, 1, &mut row)?;
            rows += 1.0;
            for (band, gone) in row.chunks_exact(width).zip(&mut gone) {
                *gone += band.iter().filter(|v| v.is_nan()).count() as f64 / width as f64;
            }
            for x in (0..width).step_by(width.div_ceil(LOOKED_AT / 16).max(1)) {
                sample.extend((0..count).map(|j| f64::from(row[j * width + x])));
            }
        }
        gone.iter_mut().for_each(|g| *g /= rows);
        Ok((sample, gone))
    }

    /// Unit of the values.
    pub fn unit(&self) -> &str {
        &self.unit
    }

    /// Whether neither the header nor a person says what the values are.
    pub(crate) fn is_kind_guessed(&self) -> bool {
        self.is_kind_guessed
    }

    /// What was guessed, merged or left out, a sentence each.
    pub fn said(&self) -> &[String] {
        &self.said
    }

    fn read(&self, at: usize, into: &mut [u8]) -> Result<(), PictureError> {
        let mut file = self
            .file
            .lock()
            .unwrap_or_else(|broken| broken.into_inner());
        file.seek(SeekFrom::Start((self.header.offset + at) as u64))?;
        file.read_exact(into)?;
        Ok(())
    }

    /// Numbers that start every `step` bytes, added to `into` times the scale.
    fn add(&self, bytes: &[u8], step: usize, factor: f32, is_first: bool, into: &mut [f32]) {
        let missing = self.missing;
        let number = self.header.number;
        macro_rules! numbers {
            ($kind:ty) => {{
                const SIZE: usize = size_of::<$kind>();
                let big = self.header.big_endian;
                let missing = missing.unwrap_or(f64::NAN);
                for (value, piece) in into.iter_mut().zip(bytes.chunks(step)) {
                    let Some(raw) = piece.first_chunk::<SIZE>() else {
                        continue;
                    };
                    let raw = if big {
                        <$kind>::from_be_bytes(*raw)
                    } else {
                        <$kind>::from_le_bytes(*raw)
                    };
                    let found = raw as f64;
                    let gone = found.abs() >= ABSURD || is_missing(found, missing, number);
                    let found = if gone { f32::NAN } else { raw as f32 * factor };
                    *value = if is_first { found } else { *value + found };
                }
            }};
        }
        match number {
            Number::U8 => numbers!(u8),
            Number::I16 => numbers!(i16),
            Number::I32 => numbers!(i32),
            Number::F32 => numbers!(f32),
            Number::F64 => numbers!(f64),
            Number::U16 => numbers!(u16),
            Number::U32 => numbers!(u32),
            Number::I64 => numbers!(i64),
            Number::U64 => numbers!(u64),
        }
    }
}

impl Pixels for EnviFile {
    fn size(&self) -> (usize, usize) {
        (self.header.samples, self.header.lines)
    }

    fn bands(&self) -> &Bands {
        &self.bands
    }

    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError> {
        let Header {
            samples,
            lines,
            bands,
            ..
        } = self.header;
        let size = self.header.number.bytes();
        let pixels = samples * count;
        match self.header.interleave {
            Interleave::Bands => {
                let mut bytes = vec![0; pixels * size];
                for (group, out) in self.of.iter().zip(into.chunks_exact_mut(pixels)) {
                    for (at, band) in group.iter().enumerate() {
                        self.read((band * lines + first) * samples * size, &mut bytes)?;
                        let factor = (self.scale / group.len() as f64) as f32;
                        self.add(&bytes, size, factor, at == 0, out);
                    }
                }
            }
            Interleave::Lines => {
                let mut bytes = vec![0; samples * bands * size];
                for y in 0..count {
                    self.read((first + y) * samples * bands * size, &mut bytes)?;
                    for (group, out) in self.of.iter().zip(into.chunks_exact_mut(pixels)) {
                        for (at, band) in group.iter().enumerate() {
                            let row = &bytes[band * samples * size..][..samples * size];
                            let factor = (self.scale / group.len() as f64) as f32;
                            self.add(
                                row,
                                size,
                                factor,
                                at == 0,
                                &mut out[y * samples..][..samples],
                            );
                        }
                    }
                }
            }
            Interleave::Pixels => {
                let mut bytes = vec![0; samples * bands * size];
                for y in 0..count {
                    self.read((first + y) * samples * bands * size, &mut bytes)?;
                    // Some pixels at a time, so that a band's strides stay in the nearest cache.
                    for x in (0..samples).step_by(64) {
                        let some = 64.min(samples - x);
                        for (group, out) in self.of.iter().zip(into.chunks_exact_mut(pixels)) {
                            for (at, band) in group.iter().enumerate() {
                                let from = &bytes[(x * bands + band) * size..];
                                let factor = (self.scale / group.len() as f64) as f32;
                                let out = &mut out[y * samples + x..][..some];
                                self.add(from, bands * size, factor, at == 0, out);
                            }
                        }
                    }
                }
            }
        }
        Ok(())
    }
}
