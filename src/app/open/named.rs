//! From a word on the command line to a spectrum: one of a file's, a preset, `group/name`.

use std::{
    ffi::OsStr,
    fs,
    path::{Path, PathBuf},
};

use super::{Loaded, load_named};
use crate::{
    app::{entry::Entry, library::Library, opened::Opened},
    io::{Choices, quoted, shown, stream::is_stream, why_unopened},
    preset::Body,
    spectrum::{Kind, NamedSpectrum, Rect},
};

/// Spectra of a file that a refusal tells by name.
const MOST_NAMES: usize = 8;

/// Which spectrum is meant by a word, and how its file is to be read.
#[derive(Clone, Debug, Default)]
pub struct Wanted<'a> {
    /// Which of a file's spectra, by name or number from 1.
    pub spectrum: Option<&'a str>,
    /// Some pixels of a spectral image: a pixel's spectrum or the mean of a region.
    pub pixels: Option<Rect>,
    /// Decisions about the file.
    pub choices: Choices,
    /// A file of several spectra of which none is named.
    pub several: Several,
}

/// A file of several spectra of which none is named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Several {
    /// The first is meant, which whoever asked has to be told.
    #[default]
    First,
    /// The first is meant, and the answer itself tells so.
    FirstAsNoted,
    Refused,
}

/// What was meant.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The spectrum.
    pub entry: Entry,
    /// Whether nothing tells a light from a share of light: neither the file nor a person.
    pub is_kind_open: bool,
    /// How many spectra there were to choose from.
    pub among: usize,
}

impl Found {
    /// The spectrum that a word means, if it is one that has a colour.
    ///
    /// # Errors
    /// One line for absorbance, weighting functions, n and k.
    pub fn usable(self, word: &OsStr) -> Result<Entry, String> {
        let entry = self.entry;
        if entry.is_usable() {
            return Ok(entry);
        }
        Err(format!(
            "{}: found {} values, expected a light, a reflectance or a transmittance (say --kind, \
             or --spectrum for another of the file)",
            shown(Path::new(word)),
            entry.kind()
        ))
    }
}

/// The light, reflectance or transmittance that a word means: a file, a preset or `group/name`.
///
/// `pick` chooses one of a file's spectra by name or by number from 1.
///
/// # Errors
/// One line that says what was found and what was expected.
pub fn resolve(word: &str, pick: Option<&str>, kind: Option<Kind>) -> Result<Entry, String> {
    let wanted = Wanted {
        spectrum: pick,
        choices: Choices {
            kind,
            ..Choices::default()
        },
        ..Wanted::default()
    };
    let word = OsStr::new(word);
    find(word, &wanted, load_named)?.usable(word)
}

/// What a word means, whatever its values are; `load` reads a file.
///
/// # Errors
/// One line that says what was found and what was expected.
pub fn find(
    word: &OsStr,
    wanted: &Wanted,
    load: impl FnOnce(&Path, &Choices) -> Loaded,
) -> Result<Found, String> {
    let path = Path::new(word);
    // Not `is_file`: a pipe is a fine input too.
    if is_stream(path) || path.exists() && !path.is_dir() {
        return match load(path, &wanted.choices) {
            Loaded::File(opened) => of_file(path, *opened, wanted),
            Loaded::Refused(why) => Err(why),
            Loaded::Project { restored, .. } => Ok(of_kind(
                Entry::clone(restored.document.subject_entry()),
                wanted,
            )),
        };
    }
    if wanted.pixels.is_some() {
        return Err(format!(
            "{}: found no file, expected a spectral image with --pixel and --region",
            shown(path)
        ));
    }
    of_library(path, wanted.spectrum).map(|entry| of_kind(entry, wanted))
}

/// A spectrum that knows what it is, unless a person says otherwise.
fn of_kind(mut entry: Entry, wanted: &Wanted) -> Found {
    entry.spectrum.kind = wanted.choices.kind.unwrap_or(entry.spectrum.kind);
    Found {
        entry,
        is_kind_open: false,
        among: 1,
    }
}

/// The spectra of a file of which one is meant.
struct Choice {
    all: Vec<Found>,
    /// Whether the first stands for all: what the picture of an image is of.
    is_whole: bool,
}

impl Choice {
    fn of(opened: Opened, wanted: &Wanted) -> Result<Self, String> {
        let of_image = |spectra: Vec<NamedSpectrum>| {
            let mut told = opened.images_understood.iter();
            let is_kind_open = told.any(|told| told.kind.is_doubtful());
            let found = spectra.into_iter().map(|spectrum| Found {
                entry: Entry::own(1, spectrum),
                is_kind_open,
                among: 1,
            });
            Self {
                all: found.collect(),
                is_whole: true,
            }
        };
        let has_images = !opened.images.is_empty();
        if let Some(pixels) = wanted.pixels {
            return Ok(of_image(opened.spectra_of_pixels(pixels)?));
        }
        // What the picture of an image is of, unless one of the listed pixels is named.
        if has_images && (wanted.spectrum.is_none() || opened.spectra.is_empty()) {
            return Ok(of_image(opened.means()));
        }
        let open = opened.doubtful_kinds();
        let of = |index| {
            let composite = opened.composite_of(index);
            (
                opened.makers_of(index),
                composite,
                opened.measured_of(index),
            )
        };
        let parts: Vec<_> = (0..open.len()).map(of).collect();
        let spectra = opened.spectra.into_iter().zip(parts).zip(open);
        let found = spectra.map(
            |((spectrum, (makers, composite, measured)), is_kind_open)| Found {
                entry: Entry {
                    makers,
                    composite,
                    measured,
                    ..Entry::own(1, spectrum)
                },
                is_kind_open,
                among: 1,
            },
        );
        Ok(Self {
            all: found.collect(),
            is_whole: has_images,
        })
    }

    fn names(&self) -> String {
        let names = self.all.iter().map(|found| found.entry.name());
        let told: Vec<&str> = names.take(MOST_NAMES).collect();
        let more = if told.len() < self.all.len() {
            ", ..."
        } else {
            ""
        };
        format!("{}{more}", told.join(", "))
    }

    /// Each of them alone, of the kind that a person says it is.
    fn into_found(self, kind: Option<Kind>) -> Vec<Found> {
        let count = self.all.len();
        let told = |(index, mut found): (usize, Found)| {
            // The first of an image stands for all of it.
            found.among = if self.is_whole { 1 } else { count };
            let spectrum = &mut found.entry.spectrum;
            // An image's pixels have the image's kind.
            spectrum.kind = kind.unwrap_or(spectrum.kind);
            if count > 1 {
                spectrum
                    .notes
                    .push(format!("Spectrum {} of {count} in the file.", index + 1));
            }
            // Words for absorbance or weighting functions are told from a light's or a filter's.
            let may_be_either = spectrum.kind == Kind::Light || spectrum.kind.is_factor();
            found.is_kind_open &= may_be_either;
            found
        };
        self.all.into_iter().enumerate().map(told).collect()
    }
}

fn of_file(path: &Path, opened: Opened, wanted: &Wanted) -> Result<Found, String> {
    let sigmas = opened.sigmas.clone();
    let mut choice = Choice::of(opened, wanted)?;
    if wanted.spectrum.is_none() && !choice.is_whole {
        // The sigma of a spectrum belongs to it; who wants it alone names it.
        let all = std::mem::take(&mut choice.all).into_iter().enumerate();
        let others = all.filter(|(index, _)| !sigmas.contains(index));
        choice.all = others.map(|(_, found)| found).collect();
    }
    let count = choice.all.len();
    let index = match wanted.spectrum {
        Some(pick) => picked(&choice.all, pick).ok_or_else(|| {
            format!(
                "{}: found no spectrum {}, expected a name or a number from 1 to {count} ({})",
                shown(path),
                quoted(pick),
                choice.names()
            )
        })?,
        None if count > 1 && wanted.several == Several::Refused && !choice.is_whole => {
            return Err(format!(
                "{}: found {count} spectra, expected one of them (--spectrum NAME or a number from \
                 1 to {count}: {}), or --all for all of them into .csv",
                shown(path),
                choice.names()
            ));
        }
        None if count == 0 => {
            return Err(format!(
                "{}: found no measured value in the image, expected some",
                shown(path)
            ));
        }
        None => 0,
    };
    Ok(choice.into_found(wanted.choices.kind).swap_remove(index))
}

/// Every spectrum of a file, those of an image for what its picture is of, as [`find`] gives one of
/// them.
pub fn every(opened: Opened, choices: &Choices) -> Vec<Found> {
    let choice = Choice::of(opened, &Wanted::default());
    choice.map_or_else(|_| Vec::new(), |all| all.into_found(choices.kind))
}

fn picked(all: &[Found], pick: &str) -> Option<usize> {
    let called = |is_it: &dyn Fn(&str) -> bool| all.iter().position(|s| is_it(s.entry.name()));
    let by_name = called(&|name| name == pick);
    let by_number = || {
        let number: usize = pick.parse().ok()?;
        (1..=all.len()).contains(&number).then(|| number - 1)
    };
    let by_any_case = || {
        let pick = pick.to_lowercase();
        called(&|name| name.to_lowercase() == pick)
    };
    by_name.or_else(by_number).or_else(by_any_case)
}

/// Whether a word means a file, be it there or not: it ends as files do, or is a whole path.
pub fn names_a_file(path: &Path) -> bool {
    let is_ending =
        |e: &OsStr| e.len() <= 5 && e.to_string_lossy().chars().all(|c| c.is_ascii_alphabetic());
    path.extension().is_some_and(is_ending) || path.is_absolute()
}

fn of_library(path: &Path, pick: Option<&str>) -> Result<Entry, String> {
    let word = path.as_os_str().to_string_lossy();
    let preset = Library::bundled()
        .find_or_make(&word)
        .map_err(|why| no_file(path).unwrap_or_else(|| why.to_string()))?;
    if pick.is_some() {
        return Err(format!(
            "{word}: found a preset, expected a file where one of several spectra is named"
        ));
    }
    match &preset.body {
        Body::Lines(_) => Err(format!(
            "{word}: found a list of lines, expected a spectrum"
        )),
        Body::Spectrum(_) | Body::Composite(_) => Entry::of_preset(&preset).ok_or_else(|| {
            format!("{word}: found numbers that are no spectrum, expected a spectrum")
        }),
    }
}

/// Why a word that is no preset's name is no file either; `None` where it looks like no file.
fn no_file(path: &Path) -> Option<String> {
    if path.is_dir() {
        let name = shown(path);
        return Some(format!(
            "{name}: found a folder, expected a file or a preset's name"
        ));
    }
    let error = fs::metadata(path).err()?;
    let is_there = path.is_symlink() || stands_on_a_file(path);
    let (found, expected) = why_unopened(path, &error);
    (is_there || names_a_file(path)).then(|| {
        let name = shown(path);
        format!("{name}: found {found}, expected {expected}")
    })
}

/// Whether a path goes on behind a file: `lamp.csv/1`.
fn stands_on_a_file(path: &Path) -> bool {
    let parts: PathBuf = path.components().collect();
    parts.ancestors().any(Path::is_file)
}
