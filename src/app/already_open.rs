//! Whether a file that was read is open already: the same twice is only a second row to look at.

use std::{path::Path, sync::Arc};

use super::{document::Document, entry::Entry, opened::Opened};
use crate::spectrum::NamedSpectrum;

/// What is known of a file that was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Known {
    /// Nothing: it is opened.
    No,
    /// All that it holds is open; the keys of its first spectrum and its first image.
    All(Option<String>, Option<String>),
    /// It is open with other values: the file changed, or it was read with other choices.
    OtherValues,
}

/// Whether what a file holds is open. What came from another file of the same name is not it;
/// where that is not known (after a restart) name and values decide.
pub fn known(document: &Document, opened: &Opened) -> Known {
    let path = opened.path.as_deref();
    let is_there = |entry: &&Arc<Entry>| {
        is_source(entry, &opened.spectra) && may_be_same(path_of(entry), path)
    };
    let near: Vec<&Arc<Entry>> = document.own.iter().filter(is_there).collect();
    let open_as = |spectrum: &NamedSpectrum| near.iter().find(|e| is_same(e, spectrum));
    let images_near = || {
        let images = document.images.iter();
        images.filter(|image| path.is_some() && image.path() == path)
    };
    let image_as = |index: usize| {
        let image = opened.images.get(index)?;
        images_near().find(|known| known.from.index == index && known.image == *image)
    };
    let all = opened.spectra.iter().all(|s| open_as(s).is_some())
        && (0..opened.images.len()).all(|index| image_as(index).is_some());
    if all {
        let spectrum = opened.spectra.first().and_then(open_as);
        return Known::All(
            spectrum.map(|entry| entry.key.clone()),
            image_as(0).map(|image| image.key.clone()),
        );
    }
    // Only where it is sure that it is the same file.
    let other = |entry: &&&Arc<Entry>| {
        path_of(entry) == path
            && path.is_some()
            && !opened.spectra.iter().any(|s| is_same(entry, s))
    };
    let other_image = images_near().any(|known| image_as(known.from.index).is_none());
    if near.iter().any(|entry| other(&entry)) || other_image {
        Known::OtherValues
    } else {
        Known::No
    }
}

fn path_of(entry: &Entry) -> Option<&Path> {
    entry.origin.file()?.reading.file.path.as_deref()
}

fn is_source(entry: &Entry, spectra: &[NamedSpectrum]) -> bool {
    spectra.iter().any(|s| s.source == entry.spectrum.source)
}

fn may_be_same(here: Option<&Path>, there: Option<&Path>) -> bool {
    here.zip(there).is_none_or(|(here, there)| here == there)
}

/// Name and kind may have been changed by hand since.
fn is_same(entry: &Entry, spectrum: &NamedSpectrum) -> bool {
    entry.spectrum.source == spectrum.source && entry.spectrum.samples == spectrum.samples
}
