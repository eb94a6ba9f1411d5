//! An ENVI cube on disk, some rows at a time: pictures larger than the memory.

use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Mutex;

use crate::io::{Meant, OfOne, envi, name_of};
use crate::spectrum::Kind;
use crate::spectrum::cube::{Interleave, Layout};

use super::{Bands, KeptBands, PictureError, Pixels};

/// Numbers that decide kind and scale.
const LOOKED_AT: usize = 400;
/// Pixels that are taken from bytes at a time, so that a band's strides stay in the nearest cache.
const AT_ONCE: usize = 64;

/// An ENVI cube whose pixels stay on disk.
#[derive(Debug)]
pub struct EnviFile {
    file: Mutex<File>,
    size: (usize, usize),
    layout: Layout,
    scale: f64,
    unit: String,
    bands: Bands,
    /// The file's bands that each kept one is the mean of.
    of: Vec<Vec<usize>>,
    notes: Vec<String>,
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
        let header_path = envi::header_at(path).ok_or_else(|| {
            PictureError::broken(
                said!("data by themselves"),
                said!("an ENVI header beside them"),
            )
        })?;
        let header = envi::read_header(&header_path).map_err(trouble)?;
        let need = (header.bytes()).ok_or_else(|| {
            PictureError::broken(said!("a size beyond counting"), said!("a cube"))
        })?;
        let data = envi::place_of_data(&header_path, need).ok_or_else(|| {
            PictureError::broken(
                said!("an ENVI header by itself"),
                said!("its data beside it"),
            )
        })?;
        let file = File::open(&data)?;
        let found = file.metadata()?.len();
        if found < need as u64 || header.is_library {
            return Err(PictureError::broken(
                tr!("{found} bytes", found),
                tr!("a cube of {need} bytes", need),
            ));
        }
        let channels = envi::channels(&header, None).map_err(trouble)?;
        let (nm, stored): (Vec<f64>, Vec<usize>) = channels.bands.into_iter().unzip();
        let mut opened = Self {
            file: Mutex::new(file),
            size: (header.width, header.height),
            layout: header.layout().map_err(trouble)?,
            scale: 1.0,
            unit: String::new(),
            bands: Bands::new(nm.clone(), Kind::Light)?,
            of: stored.iter().map(|band| vec![*band]).collect(),
            notes: channels.notes,
            is_kind_guessed: false,
        };
        let (sample, gone) = opened.looked_at()?;
        let (known, notes) = envi::values(&header, &name_of(&data), &sample).map_err(trouble)?;
        let chosen = OfOne {
            kind,
            ..OfOne::default()
        };
        let meant = Meant::of(known, chosen, || sample);
        opened.notes.extend(notes);
        opened.notes.extend(envi::left_over(&header, found));
        let kept = KeptBands::of_file(&nm, &gone, all);
        let width = envi::bandwidth_nm(&header, &nm, &stored);
        opened.bands = kept.bands(meant.kind.value)?.with_bandwidth(width);
        let group = |of: &Vec<usize>| of.iter().map(|band| stored[*band]).collect();
        opened.of = kept.of.iter().map(group).collect();
        opened.notes.extend(meant.notes());
        opened.is_kind_guessed = meant.is_kind_guessed();
        opened.notes.extend(kept.notes);
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

    /// True if neither the header nor the caller states the quantity of the values.
    pub(crate) fn is_kind_guessed(&self) -> bool {
        self.is_kind_guessed
    }

    /// Notes on guesses, merging and omissions, one sentence each.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    fn read(&self, at: usize, into: &mut [u8]) -> Result<(), PictureError> {
        let mut file = self
            .file
            .lock()
            .unwrap_or_else(|broken| broken.into_inner());
        file.seek(SeekFrom::Start(at as u64))?;
        file.read_exact(into)?;
        Ok(())
    }

    /// Neighbouring pixels' numbers of a band of a group, from where the first starts, added to
    /// what its first band left in `into`.
    fn add(&self, bytes: &[u8], (at, group): (usize, &[usize]), into: &mut [f32]) {
        let factor = (self.scale / group.len() as f64) as f32;
        let mut numbers = [f64::NAN; AT_ONCE];
        let numbers = &mut numbers[..into.len()];
        self.layout.read_row(bytes, numbers);
        for (sum, number) in into.iter_mut().zip(numbers) {
            let found = *number as f32 * factor;
            *sum = if at == 0 { found } else { *sum + found };
        }
    }
}

impl Pixels for EnviFile {
    fn size(&self) -> (usize, usize) {
        self.size
    }

    fn bands(&self) -> &Bands {
        &self.bands
    }

    fn rows(&self, first: usize, count: usize, into: &mut [f32]) -> Result<(), PictureError> {
        let (layout, (width, _)) = (&self.layout, self.size);
        let (size, pixels) = (layout.number.bytes(), width * count);
        let groups = || self.of.iter();
        if layout.interleave == Interleave::Bands {
            let mut bytes = vec![0; pixels * size];
            for (group, out) in groups().zip(into.chunks_exact_mut(pixels)) {
                for (at, band) in group.iter().enumerate() {
                    self.read(layout.place(self.size, (0, first), *band), &mut bytes)?;
                    let parts = out.chunks_mut(AT_ONCE).zip(bytes.chunks(AT_ONCE * size));
                    parts.for_each(|(out, bytes)| self.add(bytes, (at, group), out));
                }
            }
            return Ok(());
        }
        let mut bytes = vec![0; width * layout.stored_bands * size];
        for y in 0..count {
            let start = layout.place(self.size, (0, first + y), 0);
            self.read(start, &mut bytes)?;
            for x in (0..width).step_by(AT_ONCE) {
                let row = y * width + x..y * width + width.min(x + AT_ONCE);
                for (group, out) in groups().zip(into.chunks_exact_mut(pixels)) {
                    for (at, band) in group.iter().enumerate() {
                        let from = layout.place(self.size, (x, first + y), *band) - start;
                        self.add(&bytes[from..], (at, group), &mut out[row.clone()]);
                    }
                }
            }
        }
        Ok(())
    }
}
