//! From a path, a dropped file or a word on the command line to spectra.

pub mod batch;
pub mod folders;
pub mod summary;

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

pub use batch::{Came, FileRead, Finished, Loader, Progress};
pub use summary::{FileRow, OpenBefore, Outcome, Summary};

use super::{
    entry::{Entry, sampled_from_composite},
    library::{Body, Library},
    opened::Opened,
    photons, picture,
    workspace::{self, Restored},
};
use crate::{
    io::{self, Choices, CompositeFile, Reading},
    spectrum::{Kind, NamedSpectrum, Rect, SpectralImage, Spike},
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
    load_path_with(path, &Choices::default())
}

/// Reads a project, or any other file with decisions about it.
pub fn load_path_with(path: &Path, choices: &Choices) -> Loaded {
    project_at(path).unwrap_or_else(|| load_path_as(path, choices))
}

/// Reads a file with decisions about it.
pub fn load_path_as(path: &Path, choices: &Choices) -> Loaded {
    let reading = io::read_path_as(path, choices);
    // It is found again from any folder that the program is started in.
    let kept = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    from_reading(reading, Some(kept), None, choices)
}

/// Reads a file that is in memory with decisions about it.
pub fn load_bytes_as(name: &str, bytes: &Arc<[u8]>, choices: &Choices) -> Loaded {
    let reading = io::read_bytes_as(name, bytes, choices);
    from_reading(reading, None, Some(bytes.clone()), choices)
}

/// Reads a file that is in memory.
pub fn load_bytes(name: &str, bytes: &[u8]) -> Loaded {
    if looks_like_project(bytes)
        && let Ok(text) = std::str::from_utf8(bytes)
    {
        return project(name, text, None);
    }
    load_bytes_as(name, &Arc::from(bytes), &Choices::default())
}

/// A project is JSON of our own: it is looked for by its format word, not by its extension.
fn project_at(path: &Path) -> Option<Loaded> {
    use std::io::Read;
    // Looking into a pipe would eat its beginning.
    if !path.is_file() {
        return None;
    }
    let mut head = [0; 512];
    let mut file = std::fs::File::open(path).ok()?;
    let count = file.read(&mut head).ok()?;
    if !looks_like_project(&head[..count]) {
        return None;
    }
    let name = path.file_name()?.to_string_lossy().into_owned();
    // Too large a one is refused by the reader of files, unread.
    if file.metadata().ok()?.len() > io::text::MOST_BYTES {
        return None;
    }
    let text = std::fs::read_to_string(path).ok()?;
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
    reading: Result<Reading, io::ReadError>,
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
        understood,
        images_understood,
        axis: _,
        results,
        images,
        guesses,
        image_guesses: _,
        notes,
    } = reading;
    let mut spectra = spectra_of(spectra, composites, &notes, &file);
    let photons = spectra.iter().any(photons::counts_photons);
    if !choices.keep_photons {
        spectra.iter_mut().for_each(photons::to_power);
    }
    if spectra.is_empty() && images.is_empty() {
        return Loaded::Refused(format!("{file}: found no spectrum, expected at least one"));
    }
    Loaded::File(Box::new(Opened {
        path,
        bytes,
        file,
        format,
        how,
        spectra,
        makers: results,
        images: images.into_iter().map(Arc::new).collect(),
        table,
        understood,
        photons,
        images_understood,
        guesses,
        choices: choices.clone(),
    }))
}

/// Every spectrum of a file; composites are sampled at 1 nm. The file's notes go to each.
fn spectra_of(
    spectra: Vec<NamedSpectrum>,
    composites: Vec<CompositeFile>,
    notes: &[String],
    file: &str,
) -> Vec<NamedSpectrum> {
    let mut all = spectra;
    all.extend(composites.into_iter().filter_map(sampled));
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

fn sampled(file: CompositeFile) -> Option<NamedSpectrum> {
    Some(NamedSpectrum {
        samples: sampled_from_composite(&file.composite)?,
        name: file.name,
        kind: file.kind,
        unit: file.unit,
        scale: 1.0,
        notes: {
            let composite = &file.composite;
            let mut notes = vec![format!(
                "A composite of {} numbers, sampled at 1 nm; the model on screen is fitted anew.",
                composite.numbers()
            )];
            let band = composite.band();
            let outside = |s: &&Spike| !band.contains(s.at_nm);
            notes.extend(composite.spikes.iter().filter(outside).map(|s| {
                format!(
                    "The spike at {} nm is outside its range and left out.",
                    s.at_nm
                )
            }));
            notes
        },
        source: file.source,
    })
}

/// The spectrum that the command line names: a file, a preset or `group/name`.
///
/// `pick` chooses one of a file's spectra by name or by number from 1.
///
/// # Errors
/// One line that says what was found and what was expected.
pub fn resolve(input: &str, pick: Option<&str>, kind: Option<Kind>) -> Result<Entry, String> {
    resolve_pixels(input, pick, None, kind)
}

/// The same with some pixels of a spectral image: a pixel's spectrum or the mean of a region.
///
/// # Errors
/// One line that says what was found and what was expected.
pub fn resolve_pixels(
    input: &str,
    pick: Option<&str>,
    pixels: Option<Rect>,
    kind: Option<Kind>,
) -> Result<Entry, String> {
    let choices = Choices {
        kind,
        ..Choices::default()
    };
    let entry = resolve_any(input, pick, pixels, &choices)?;
    if !entry.is_usable() {
        return Err(format!(
            "{}: found {} values, expected a light, a reflectance or a transmittance (say --kind, \
             or --spectrum for another of the file)",
            entry.name(),
            entry.kind()
        ));
    }
    Ok(entry)
}

/// The same, whatever its values are, with decisions about a file: absorbance, weighting functions
/// and n and k have no colour, but are kept and written.
///
/// # Errors
/// One line that says what was found and what was expected.
pub fn resolve_any(
    input: &str,
    pick: Option<&str>,
    pixels: Option<Rect>,
    choices: &Choices,
) -> Result<Entry, String> {
    let path = Path::new(input);
    // Not `is_file`: a pipe is a fine input too.
    let entry = if path.exists() && !path.is_dir() {
        from_file(path, pick, pixels, choices)?
    } else if pixels.is_some() {
        return Err(format!(
            "{input}: found no file, expected a spectral image with --pixel and --region"
        ));
    } else {
        let mut preset = from_library(input, path, pick)?;
        preset.spectrum.kind = choices.kind.unwrap_or(preset.spectrum.kind);
        preset
    };
    Ok(entry)
}

fn from_file(
    path: &Path,
    pick: Option<&str>,
    pixels: Option<Rect>,
    choices: &Choices,
) -> Result<Entry, String> {
    let kind = choices.kind;
    let (mut spectra, makers) = match load_path_with(path, choices) {
        Loaded::File(opened) => match pixels {
            Some(pixels) => (opened.spectra_of_pixels(pixels)?, Vec::new()),
            // What the picture of an image is of, unless one of the listed pixels is named.
            None if pick.is_none() && !opened.images.is_empty() => (opened.means(), Vec::new()),
            None => {
                let makers: Vec<_> = (0..opened.spectra.len())
                    .map(|index| opened.makers_of(index))
                    .collect();
                (opened.into_spectra(), makers)
            }
        },
        Loaded::Refused(why) => return Err(why),
        Loaded::Project { restored, .. } => {
            let mut entry = Entry::clone(restored.document.subject_entry());
            entry.spectrum.kind = kind.unwrap_or(entry.spectrum.kind);
            return Ok(entry);
        }
    };
    let index = match pick {
        Some(pick) => picked(&spectra, pick).ok_or_else(|| {
            let names: Vec<&str> = spectra.iter().take(8).map(|s| s.name.as_str()).collect();
            format!(
                "{}: found no spectrum {pick:?}, expected a name or a number from 1 to {} ({}{})",
                path.display(),
                spectra.len(),
                names.join(", "),
                if spectra.len() > 8 { ", ..." } else { "" }
            )
        })?,
        None => 0,
    };
    let count = spectra.len();
    let mut spectrum = spectra.swap_remove(index);
    // An image's pixels have the image's kind.
    spectrum.kind = kind.unwrap_or(spectrum.kind);
    if count > 1 {
        spectrum
            .notes
            .push(format!("Spectrum {} of {count} in the file.", index + 1));
    }
    Ok(Entry {
        makers: makers.into_iter().nth(index).unwrap_or_default(),
        ..Entry::own(1, spectrum)
    })
}

fn picked(spectra: &[NamedSpectrum], pick: &str) -> Option<usize> {
    let by_name = spectra.iter().position(|s| s.name == pick);
    let by_number = || {
        let number: usize = pick.parse().ok()?;
        (1..=spectra.len()).contains(&number).then(|| number - 1)
    };
    let by_any_case = || {
        let pick = pick.to_lowercase();
        spectra.iter().position(|s| s.name.to_lowercase() == pick)
    };
    by_name.or_else(by_number).or_else(by_any_case)
}

/// Whether a word means a file, be it there or not: it ends as files do, or is a whole path.
pub fn names_a_file(path: &Path) -> bool {
    let is_ending = |e: &std::ffi::OsStr| {
        e.len() <= 5 && e.to_string_lossy().chars().all(|c| c.is_ascii_alphabetic())
    };
    path.extension().is_some_and(is_ending) || path.is_absolute()
}

fn from_library(input: &str, path: &Path, pick: Option<&str>) -> Result<Entry, String> {
    let preset = match Library::bundled().find(input) {
        Ok(preset) => preset,
        Err(_) if names_a_file(path) => {
            // The reader's own words for a missing file or a folder.
            return Err(io::read_path(path).err().map_or_else(
                || format!("{input}: found no file, expected a file or a preset's name"),
                |e| e.to_string(),
            ));
        }
        Err(why) => return Err(why.to_string()),
    };
    if pick.is_some() {
        return Err(format!(
            "{input}: found a preset, expected a file where one of several spectra is named"
        ));
    }
    match &preset.body {
        Body::Lines(_) => Err(format!(
            "{input}: found a list of lines, expected a spectrum"
        )),
        Body::Spectrum(_) | Body::Composite(_) => Entry::of_preset(preset).ok_or_else(|| {
            format!("{input}: found numbers that are no spectrum, expected a spectrum")
        }),
    }
}
