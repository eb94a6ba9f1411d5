//! What a reader of images hands out: the picture, and its pixels where they are a list of
//! patches rather than a picture.

use crate::spectrum::SpectralImage;

use super::Reading;
use super::budget;
use super::reading::provenance;

/// Images of at most so many pixels are patches: each becomes a spectrum.
pub const MOST_PATCHES: usize = 64;

/// The reading of one image.
pub fn reading(mut image: SpectralImage) -> Reading {
    let cube = &image.cube;
    let (width, height) = (cube.width(), cube.height());
    let line = format!(
        "image of {width} x {height} pixels, {} bands, {:.1}-{:.1} nm, {}, {} of memory",
        cube.nm().len(),
        cube.nm()[0],
        cube.nm()[cube.nm().len() - 1],
        image.kind.word(),
        budget::in_words(cube.memory()),
    );
    image.notes.insert(0, line);
    let mut reading = Reading {
        notes: image.notes.clone(),
        ..Reading::default()
    };
    if width.saturating_mul(height) <= MOST_PATCHES {
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        for (x, y) in places {
            let Some(mut spectrum) = image.pixel(x, y) else {
                continue;
            };
            if (width, height) == (1, 1) {
                spectrum.name.clone_from(&image.name);
            }
            spectrum.notes[0] = provenance(&spectrum, &[]);
            reading.spectra.push(spectrum);
        }
    }
    reading.images.push(image);
    reading
}
