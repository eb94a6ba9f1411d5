//! From a path, a dropped file or a word on the command line to spectra.

pub mod batch;
mod came;
mod doubt;
pub mod few_numbers;
pub mod folders;
pub mod named;
mod summary;

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

pub use batch::{Finished, Loader, Progress};
pub use came::{Came, FileRead};
pub use named::{Found, Wanted, names_a_file, resolve};
pub use summary::{FileRow, OpenBefore, Outcome, Summary};

use super::{
    entry,
    opened::Opened,
    photons, picture,
    workspace::{self, Restored},
};
use crate::{
    io::{self, Choices, CompositeFile, ReadError, Reading, disk, many},
    spectrum::{Composite, NamedSpectrum, Rect, SpectralImage},
};

/// What a file turned out to be.
#[derive(Debug)]
pub enum Loaded {
    /// Spectra, at least one, or images.
    File(Box<Opened>),
    /// A project of this program.
    Project {
        /// Where it came from.
        path: Option<PathBuf>,
        /// Its content.
        restored: Box<Restored>,
    },
    /// Refused, in one line with file, line, found and expected.
    Refused(String),
}

/// Reads a file.
pub fn load_path(path: &Path) -> Loaded {
    project_at(path).unwrap_or_else(|| load_path_as(path, &Choices::default()))
}

/// Reads a file with decisions about it.
pub fn load_path_as(path: &Path, choices: &Choices) -> Loaded {
    read(path, choices, |why| why)
}

/// Reads a project, or any other file with decisions about it; what is said of it tells its path.
pub fn load_named(path: &Path, choices: &Choices) -> Loaded {
    project_at(path).unwrap_or_else(|| read(path, choices, |why| why.at(path)))
}

fn read(path: &Path, choices: &Choices, told: impl Fn(ReadError) -> ReadError) -> Loaded {
    let as_file = || {
        let reading = io::read_path_as(path, choices).map_err(told);
        from_reading(reading, kept_path(path), None, choices)
    };
    few_numbers::at(path, choices).unwrap_or_else(as_file)
}

/// What a reader makes of a file. A panic in it is a refusal: it must neither stop others nor leave
/// the window waiting for ever.
pub fn unshaken(name: impl std::fmt::Display, read: impl FnOnce() -> Loaded) -> Loaded {
    let read = std::panic::catch_unwind(std::panic::AssertUnwindSafe(read));
    read.unwrap_or_else(|_| Loaded::Refused(tr!("{name}: the reader failed on this file", name)))
}

/// Where a file is found again from any folder that the program is started in.
fn kept_path(path: &Path) -> Option<PathBuf> {
    Some(std::path::absolute(path).unwrap_or_else(|_| path.to_owned()))
}

/// Reads a file that is in memory with decisions about it.
pub fn load_bytes_as(name: &str, bytes: &Arc<[u8]>, choices: &Choices) -> Loaded {
    let as_file = || {
        let reading = io::read_bytes_as(name, bytes, choices);
        from_reading(reading, None, Some(bytes.clone()), choices)
    };
    few_numbers::within(name, bytes, choices).unwrap_or_else(as_file)
}

/// Reads a file that is in memory.
pub fn load_bytes(name: &str, bytes: &[u8]) -> Loaded {
    load_bytes_with(name, &Arc::from(bytes), &Choices::default())
}

/// Reads a project that is in memory, or any other file with decisions about it.
pub fn load_bytes_with(name: &str, bytes: &Arc<[u8]>, choices: &Choices) -> Loaded {
    project_in(name, bytes).unwrap_or_else(|| load_bytes_as(name, bytes, choices))
}

/// The project that a file in memory is, if it is one.
pub fn project_in(name: &str, bytes: &[u8]) -> Option<Loaded> {
    let text = std::str::from_utf8(bytes);
    let text = text.ok().filter(|_| looks_like_project(bytes))?;
    Some(project(name, text, None))
}

/// The project that a file is, if it is one: JSON of our own, looked for by its format word and
/// not by its extension.
pub fn project_at(path: &Path) -> Option<Loaded> {
    if !looks_like_project(&disk::head(path, 512)) {
        return None;
    }
    let name = path.file_name()?.to_string_lossy().into_owned();
    // Too large a one is refused by the reader of files, unread.
    if disk::len(path).ok()? > io::MOST_BYTES {
        return None;
    }
    let text = String::from_utf8(disk::read(path).ok()?).ok()?;
    Some(project(&name, &text, Some(path.to_owned())))
}

fn looks_like_project(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(512)]);
    // Some editors put a byte order mark before a text.
    let text = head.trim_start_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
    text.starts_with('{') && head.contains(workspace::FORMAT)
}

fn project(name: &str, text: &str, path: Option<PathBuf>) -> Loaded {
    match workspace::from_json(text) {
        Ok(restored) => Loaded::Project {
            path,
            restored: Box::new(restored),
        },
        Err(why) => Loaded::Refused(format!("{name}: {why}")),
    }
}

fn from_reading(
    reading: Result<Reading, ReadError>,
    path: Option<PathBuf>,
    bytes: Option<Arc<[u8]>>,
    choices: &Choices,
) -> Loaded {
    let reading = match reading {
        Ok(reading) => reading,
        Err(refusal) => return Loaded::Refused(refusal.to_string()),
    };
    let how = format!(
        "{}: {}{}{}",
        reading.file,
        reading.format,
        if reading.notes.is_empty() { "" } else { ", " },
        reading.notes.first().map_or("", String::as_str)
    );
    let Reading {
        file,
        format,
        spectra,
        composites,
        table,
        cut_by: _,
        understood,
        images_understood,
        results,
        images,
        guesses,
        facts: _,
        in_front: _,
        notes,
    } = reading;
    let composites = composites.into_iter();
    let composites: Vec<CompositeFile> = composites.filter(|c| sampled(c).is_some()).collect();
    let first = spectra.len();
    let given = composites.iter().enumerate();
    let given = given.map(|(index, file)| (first + index, Arc::new(file.composite.clone())));
    let mut given: Vec<(usize, Arc<Composite>)> = given.collect();
    let mut spectra = spectra_of(spectra, &composites, &notes, &file);
    let photons = spectra.iter().any(photons::counts_photons);
    if !choices.keep_photons {
        given.retain(|(index, _)| !photons::counts_photons(&spectra[*index]));
        spectra.iter_mut().for_each(photons::to_power);
    }
    if spectra.is_empty() && images.is_empty() {
        return Loaded::Refused(tr!(
            "{file}: found no spectrum, expected at least one",
            file
        ));
    }
    let mut opened = Opened {
        path,
        bytes,
        file,
        format,
        how,
        spectra,
        composites: given,
        makers: results,
        images: images.into_iter().map(Arc::new).collect(),
        table,
        understood,
        photons,
        images_understood,
        guesses,
        choices: choices.clone(),
        ..Opened::default()
    };
    doubt::find(&mut opened);
    Loaded::File(Box::new(opened))
}

/// Every spectrum of a file; composites are sampled at 1 nm. The file's notes go to each.
fn spectra_of(
    spectra: Vec<NamedSpectrum>,
    composites: &[CompositeFile],
    notes: &[String],
    file: &str,
) -> Vec<NamedSpectrum> {
    let mut all = spectra;
    all.extend(composites.iter().filter_map(sampled));
    for spectrum in &mut all {
        for note in notes {
            if !spectrum.notes.contains(note) {
                spectrum.notes.push(note.clone());
            }
        }
        if spectrum.source.is_empty() {
            file.clone_into(&mut spectrum.source);
        }
    }
    all
}

impl Opened {
    /// The spectra of some pixels, one of each of the file's images.
    ///
    /// # Errors
    /// One line when there is no image, or the pixels are not in it or were not measured.
    pub fn spectra_of_pixels(&self, pixels: Rect) -> Result<Vec<NamedSpectrum>, String> {
        let file = &self.file;
        if self.images.is_empty() {
            return Err(format!(
                "{file}: found {} without an image, expected a spectral image with --pixel and \
                 --region",
                self.format
            ));
        }
        let of = |image: &Arc<SpectralImage>| {
            let cube = &image.cube;
            let Rect {
                x,
                y,
                width,
                height,
            } = pixels;
            if !pixels.is_inside(cube.all()) {
                return Err(format!(
                    "{file}: found {width} x {height} pixels from column {x}, row {y}, expected \
                     columns 0-{} and rows 0-{}",
                    cube.width() - 1,
                    cube.height() - 1
                ));
            }
            picture::named(image, pixels).ok_or_else(|| {
                format!("{file}: found nothing measured in column {x}, row {y}, expected two bands")
            })
        };
        self.images.iter().map(of).collect()
    }

    /// The spectra that a command works on: those of the file, or of an image without any its
    /// mean.
    pub fn into_spectra(self) -> Vec<NamedSpectrum> {
        if self.spectra.is_empty() {
            return self.means();
        }
        self.spectra
    }

    /// The means of its images; of one in which nothing was measured the spectra listed.
    pub fn means(&self) -> Vec<NamedSpectrum> {
        let means: Vec<_> = self.images.iter().filter_map(|i| i.mean()).collect();
        if means.is_empty() {
            return self.spectra.clone();
        }
        means
    }
}

fn sampled(file: &CompositeFile) -> Option<NamedSpectrum> {
    let composite = &file.composite;
    let count = many::numbers(composite.numbers());
    Some(NamedSpectrum {
        samples: entry::sampled(composite)?,
        name: file.name.clone(),
        kind: file.kind,
        unit: file.unit.clone(),
        scale: 1.0,
        notes: vec![format!("A composite of {count}, sampled at 1 nm.")],
        source: file.source.clone(),
    })
}
