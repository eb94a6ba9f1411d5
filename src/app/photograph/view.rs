//! A photograph for the window: the picture and its strip as they are seen, beside what was found.

use std::path::{Path, PathBuf};

use super::{
    Fit, Instrument, Kept, Known, Photograph, Said,
    along::picture_of,
    example,
    instrument::FORMAT,
    reading::{About, of_picture},
    words::sentence,
};
use crate::{
    app::{open::few_numbers::is_few_numbers, studies::Question},
    io::{ReadError, disk, name_of, read_photo},
    photographs::picture::Picture,
    spectrum::{Kind, NamedSpectrum, Sampled},
    study::Progress,
};

/// The picture that is read.
#[derive(Clone, Debug, PartialEq)]
pub enum PictureOf {
    File(PathBuf),
    /// The one that the program draws.
    Example,
}

/// A photograph, and what a person said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct PhotographAsk {
    pub of: PictureOf,
    pub said: Said,
}

/// Pixels to be shown, row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixels {
    pub size: [usize; 2],
    pub pixels: Vec<[u8; 3]>,
}

/// A photograph that was read.
#[derive(Clone, Debug)]
pub struct SeenPhotograph {
    /// Its file's name.
    pub name: String,
    /// Width and height as shown.
    pub size: [usize; 2],
    /// The whole picture, made small.
    pub picture: Pixels,
    /// What was found in it, or why nothing was.
    pub found: Result<Photograph, String>,
    /// The strip made straight, in its own colours; of no pixels where there is none.
    pub strip: Pixels,
}

/// Longest side of the picture as it is drawn.
const MOST_SIDE: usize = 1024;
/// Rows of the straightened strip.
const STRIP_ROWS: usize = 24;
/// First bytes of photographs: JPEG, PNG and, after four more, the boxes of telephones.
const JPEG: &[u8] = b"\xff\xd8\xff";
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";
const BOX: &[u8] = b"ftyp";

/// True of a file that begins as that of an instrument does.
pub fn is_instrument(path: &Path) -> bool {
    disk::head(path, 256)
        .windows(FORMAT.len())
        .any(|part| part == FORMAT.as_bytes())
}

/// True of a file that is a photograph by what it begins with, and no picture in few numbers.
pub fn is_photograph(path: &Path) -> bool {
    let head = disk::head(path, 12);
    head.len() == 12
        && (head.starts_with(JPEG)
            || &head[4..8] == BOX
            || head.starts_with(PNG) && !is_few_numbers(path))
}

impl Question for PhotographAsk {
    type Answer = Result<SeenPhotograph, String>;

    fn answer(&self, _: &Progress) -> Option<Self::Answer> {
        Some(self.seen())
    }
}

impl PhotographAsk {
    pub(super) fn seen(&self) -> Result<SeenPhotograph, String> {
        let (photo, name, path) = match &self.of {
            PictureOf::File(path) => {
                let photo = read_photo(path).map_err(|why: ReadError| why.to_string())?;
                (photo, name_of(path), Some(&**path))
            }
            PictureOf::Example => (example::photo(), said!("an example").to_owned(), None),
        };
        let about = About::of(&photo, path);
        let mut picture = picture_of(photo, self.said.is_linear)?;
        let size = picture.size();
        let small = made_small(&picture);
        let found = of_picture(&name, &mut picture, about, &self.said).map(|mut found| {
            let response = self
                .said
                .instrument
                .as_ref()
                .and_then(|i| i.response.clone());
            found.read_through(response.as_ref());
            found
        });
        let strip = found.as_ref().map(|found| straightened(&picture, found));
        Ok(SeenPhotograph {
            name,
            size,
            picture: small,
            strip: strip.unwrap_or(Pixels {
                size: [0, 0],
                pixels: Vec::new(),
            }),
            found,
        })
    }
}

/// A picture with no side longer than is drawn.
fn made_small(picture: &Picture) -> Pixels {
    let [width, height] = picture.size();
    let step = width.max(height).div_ceil(MOST_SIDE).max(1);
    let rows = (0..height).step_by(step);
    let columns = (0..width).step_by(step);
    let size = [columns.len(), rows.len()];
    let places = rows.flat_map(|y| columns.clone().map(move |x| [x, y]));
    Pixels {
        size,
        pixels: places.map(|at| picture.shown(at)).collect(),
    }
}

/// The pixels of a strip, its lines upright.
fn straightened(picture: &Picture, found: &Photograph) -> Pixels {
    let strip = found.found.strip;
    let [width, height] = picture.size();
    let rows = (0..STRIP_ROWS).map(|i| (i as f64 + 0.5) / STRIP_ROWS as f64 - 0.5);
    let rows = rows.map(|share| 2.0 * share * strip.half);
    let places = rows.flat_map(|v| (0..strip.columns).map(move |column| (column as f64, v)));
    let near = |at: f64, count: usize| (at.round().max(0.0) as usize).min(count - 1);
    let pixel = |(column, v)| {
        let (x, y) = strip.pixel_of(column, v);
        picture.shown([near(x, width), near(y, height)])
    };
    Pixels {
        size: [strip.columns, STRIP_ROWS],
        pixels: places.map(pixel).collect(),
    }
}

impl Photograph {
    /// Its spectrum for the library: relative, a light; `None` without an axis that is used.
    pub fn spectrum(&self) -> Option<NamedSpectrum> {
        let rows = self.rows()?;
        let nm = rows.rows.iter().map(|row| row.nm).collect();
        let values = rows.rows.iter().map(|row| row.value.max(0.0)).collect();
        let stem = self
            .file
            .rsplit_once('.')
            .map_or(&*self.file, |(stem, _)| stem);
        Some(NamedSpectrum {
            name: stem.to_owned(),
            kind: Kind::Light,
            unit: "relative".to_owned(),
            scale: 1.0,
            samples: Sampled::new(nm, values).ok()?,
            notes: vec![said!("Made from a picture.").to_owned()],
            source: self.file.clone(),
        })
    }
}

/// An instrument that is to learn what it makes of light from a picture of a known one.
#[derive(Clone, Debug, PartialEq)]
pub struct ResponseAsk {
    pub instrument: Instrument,
    /// The picture that the axis is from, where it is at hand, and what was said of it.
    pub lamp: Option<(PathBuf, Said)>,
    /// The picture of the light that is known.
    pub path: PathBuf,
    pub known: Known,
}

impl Question for ResponseAsk {
    type Answer = Result<Instrument, String>;

    fn answer(&self, _: &Progress) -> Option<Self::Answer> {
        let learnt = || {
            let with_it = || Said {
                instrument: Some(self.instrument.clone()),
                yes: true,
                ..Said::default()
            };
            // Without the lamp's picture the axis that was kept serves.
            let (own, said) = (self.lamp.clone()).unwrap_or_else(|| (self.path.clone(), with_it()));
            let mut lamp = super::read(&own, &said)?;
            let kept = Kept::learn(&self.path, &self.known, &mut lamp, Some(&own))?;
            Ok(self.instrument.clone().with_response(kept))
        };
        Some(learnt())
    }
}

/// Several pictures that are read with one instrument.
#[derive(Clone, Debug, PartialEq)]
pub struct ManyAsk {
    pub paths: Vec<PathBuf>,
    pub instrument: Instrument,
}

/// One of them.
#[derive(Clone, Debug)]
pub struct OfMany {
    pub name: String,
    pub path: PathBuf,
    /// Its spectrum, or why it has none.
    pub spectrum: Result<NamedSpectrum, String>,
}

impl Question for ManyAsk {
    type Answer = Vec<OfMany>;

    fn answer(&self, progress: &Progress) -> Option<Self::Answer> {
        let said = Said {
            instrument: Some(self.instrument.clone()),
            ..Said::default()
        };
        progress.expect(self.paths.len());
        let mut all = Vec::new();
        for path in &self.paths {
            if progress.is_cancelled() {
                return None;
            }
            let spectrum = super::read(path, &said).and_then(|mut photograph| {
                photograph.read_through(self.instrument.response.as_ref());
                let why = || match &photograph.instrument.as_ref().map(|i| &i.fit) {
                    Some(Fit::No(why)) => why.clone(),
                    _ => sentence(&photograph).replace(" (--yes)", ""),
                };
                photograph.spectrum().ok_or_else(why)
            });
            all.push(OfMany {
                name: name_of(path),
                path: path.clone(),
                spectrum,
            });
            progress.step();
        }
        Some(all)
    }
}
