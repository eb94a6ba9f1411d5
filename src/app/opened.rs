//! What a file brought: spectra, images, the maker's own results, and how it was read.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
};

use super::origin::FromFile;

use crate::{
    io::{Choices, Decisions, Guessed, MakersResult, OpenQuestion, TableFound},
    measurements::Measurement,
    spectrum::{Composite, NamedSpectrum, SpectralImage},
};

/// A file that was read.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Opened {
    /// Where it came from; `None` for bytes that were dropped without a path.
    pub path: Option<PathBuf>,
    /// Its content where there is no path to read it from again.
    pub bytes: Option<Arc<[u8]>>,
    /// Its name without the folder.
    pub file: String,
    /// The format that read it.
    pub format: &'static str,
    /// "lamp.csv: plain columns, 401 points, ...".
    pub how: String,
    /// Its spectra (composites sampled at 1 nm), in their order.
    pub spectra: Vec<NamedSpectrum>,
    /// The composites among them, each by its index, all lines on its range.
    pub composites: Vec<(usize, Arc<Composite>)>,
    /// Those of which more is known than their values, each by its index.
    pub measured: Vec<(usize, Arc<Measurement>)>,
    /// Indices of the spectra that are the sigma of the one before them.
    pub sigmas: Vec<usize>,
    /// What the instrument computed itself; `spectrum` is an index into `spectra`.
    pub makers: Vec<MakersResult>,
    /// Images whose pixels are spectra.
    pub images: Vec<Arc<SpectralImage>>,
    /// How its first plain table was taken apart.
    pub table: Option<TableFound>,
    /// How its first spectra were understood, in their order.
    pub understood: Vec<Decisions>,
    pub images_understood: Vec<Decisions>,
    /// Whether one of its lights counts photons, in the file.
    pub photons: bool,
    /// What had to be guessed.
    pub guesses: Vec<OpenQuestion>,
    /// What a person decided about it.
    pub choices: Choices,
}

impl Opened {
    /// One spectrum alone, with what its instrument computed.
    pub fn alone(spectrum: NamedSpectrum, makers: Vec<MakersResult>) -> Self {
        let of_it = |result| MakersResult {
            spectrum: Some(0),
            ..result
        };
        Self {
            file: spectrum.name.clone(),
            makers: makers.into_iter().map(of_it).collect(),
            spectra: vec![spectrum],
            ..Self::default()
        }
    }

    /// Whether a person should look at how it was read.
    pub fn is_doubtful(&self) -> bool {
        self.guesses.iter().any(OpenQuestion::is_doubtful)
            || self.images_understood.iter().any(Decisions::is_doubtful)
    }

    /// Which of its spectra are of a kind that is doubtful.
    pub fn doubtful_kinds(&self) -> Vec<bool> {
        let mut all = vec![false; self.spectra.len()];
        let of_kind = |guess: &&OpenQuestion| guess.what == Guessed::Kind && guess.is_doubtful();
        for guess in self.guesses.iter().filter(of_kind) {
            if let Some(doubtful) = all.get_mut(guess.spectrum) {
                *doubtful = true;
            }
        }
        all
    }

    /// The composite that one of its spectra is.
    pub fn composite_of(&self, index: usize) -> Option<Arc<Composite>> {
        let mut composites = self.composites.iter();
        let (_, composite) = composites.find(|(of, _)| *of == index)?;
        Some(composite.clone())
    }

    /// What is known of one of its spectra beside its values.
    pub fn measured_of(&self, index: usize) -> Option<Arc<Measurement>> {
        let mut measured = self.measured.iter();
        let (_, measured) = measured.find(|(of, _)| *of == index)?;
        Some(measured.clone())
    }

    /// Whether one of its spectra is the sigma of the one before it.
    pub fn is_sigma(&self, index: usize) -> bool {
        self.sigmas.contains(&index)
    }

    /// The maker's results that belong to one of its spectra: those that say so, and those of the
    /// whole file when it holds one spectrum.
    pub fn makers_of(&self, index: usize) -> Vec<MakersResult> {
        let alone = self.spectra.len() == 1;
        let belongs = |result: &&MakersResult| match result.spectrum {
            Some(of) => of == index,
            None => alone,
        };
        self.makers.iter().filter(belongs).cloned().collect()
    }
}

/// A spectral image in the window's hands.
#[derive(Clone, Debug)]
pub struct ImageEntry {
    /// What finds it again: `image/<number>`.
    pub key: String,
    /// The file that it was read from, and is read from again after a restart.
    pub from: FromFile,
    pub image: Arc<SpectralImage>,
}

impl ImageEntry {
    /// The path of its file; `None` when it came without one.
    pub fn path(&self) -> Option<&Path> {
        self.from.reading.file.path.as_deref()
    }
}

/// Two images are the same when they look the same and come back from the same file.
impl PartialEq for ImageEntry {
    fn eq(&self, other: &Self) -> bool {
        self.key == other.key
            && self.from.index == other.from.index
            && self.path() == other.path()
            && self.from.reading.choices == other.from.reading.choices
            && self.image == other.image
    }
}

/// It equals itself: one that two documents share is not read through to be compared.
impl Eq for ImageEntry {}
