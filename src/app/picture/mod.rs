//! Spectral images: from a cube to pixels of the screen, and from a pixel or a region to a
//! spectrum with its model. Numbers only; the window draws them.

mod at_hand;
mod band_weights;
mod exposure;
mod raster;
mod region_spectrum;
pub mod reload;

pub use at_hand::{WALL_KEY, at_hand};
pub use band_weights::BandWeights;
pub use exposure::{Exposed, NOT_MEASURED, exposed, seen_in};
pub use raster::{MOST_SIDE, Raster, RasterAsk, Source, step_of};
pub use region_spectrum::{RegionAsk, RegionSpectrum, named};

use std::sync::Arc;

use super::{document::Document, opened::ImageEntry, pages::ImageMemory};

/// The image that the page shows: the chosen one, or the one opened last.
pub fn shown<'a>(document: &'a Document, memory: &ImageMemory) -> Option<&'a Arc<ImageEntry>> {
    let chosen = memory.key.as_deref();
    let named = |image: &&Arc<ImageEntry>| Some(image.key.as_str()) == chosen;
    let images = &document.images;
    images.iter().find(named).or_else(|| images.last())
}
