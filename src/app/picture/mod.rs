//! Spectral images: from a cube to pixels of the screen, and from a pixel or a region to a
//! spectrum with its model. Numbers only; the window draws them.

pub mod back;
mod develop;
mod eye;
mod memory;
mod probe;
mod raster;

pub use develop::{Developed, NOT_MEASURED, developed, seen_in};
pub use eye::Eye;
pub use memory::{BAND_NM, ImageMemory, STOPS, Show, Spread};
pub use probe::{ProbeAsk, Probed, named};
pub use raster::{MOST_SIDE, Raster, RasterAsk, Source, step_of};

use std::sync::Arc;

use super::{document::Document, opened::ImageEntry};
use crate::spectrum::{Kind, SpectralImage};

/// An image that is the same only as itself: comparing its bytes at every frame would cost more
/// than the frame.
#[derive(Clone, Debug)]
pub struct Held(pub Arc<SpectralImage>);

impl PartialEq for Held {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// The image that the page shows: the chosen one, or the one opened last.
pub fn shown<'a>(document: &'a Document, memory: &ImageMemory) -> Option<&'a Arc<ImageEntry>> {
    let chosen = memory.key.as_deref();
    let named = |image: &&Arc<ImageEntry>| Some(image.key.as_str()) == chosen;
    let images = &document.images;
    images.iter().find(named).or_else(|| images.last())
}

/// Whether the window can model spectra of the kind: a light, a reflectance or a transmittance.
pub fn is_usable(kind: Kind) -> bool {
    kind == Kind::Light || kind.is_factor()
}
