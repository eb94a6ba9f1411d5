//! A spectral image with what a person needs to know about it.

use super::kind::Kind;
use super::named::NamedSpectrum;
use super::sampled::Sampled;
use super::{cube::Cube, rect::Rect};

/// An image whose pixels are spectra, with its meaning and provenance.
#[derive(Clone, Debug, PartialEq)]
pub struct SpectralImage {
    /// Name shown in lists.
    pub name: String,
    /// Kind of quantity that its values represent.
    pub kind: Kind,
    /// Unit of the values, as for a [`NamedSpectrum`].
    pub unit: String,
    /// Factor that takes the file's numbers to `unit`; not applied to `cube`, applied to the
    /// spectra taken from it.
    pub scale: f64,
    /// The image in the file's own numbers.
    pub cube: Cube,
    /// Width of a band at half of its height, nm, where the file has one.
    pub bandwidth_nm: Option<f64>,
    /// Notes on how it was read and on any oddities, a sentence each.
    pub notes: Vec<String>,
    /// Origin of the image; empty when unknown.
    pub source: String,
}

impl SpectralImage {
    /// The spectrum of a pixel, counted from 0; `None` where it was not measured.
    pub fn pixel(&self, x: usize, y: usize) -> Option<NamedSpectrum> {
        let samples = self.cube.spectrum_at(x, y)?;
        Some(self.named(self.name_of(Rect::pixel(x, y)), samples))
    }

    /// The mean spectrum of a region; `None` where nothing of it was measured.
    pub fn mean_of(&self, region: Rect) -> Option<NamedSpectrum> {
        Some(self.named(self.name_of(region), self.cube.mean_of(region)?))
    }

    /// Name of a pixel's spectrum or of a region's mean.
    pub(crate) fn name_of(&self, region: Rect) -> String {
        let Rect {
            x,
            y,
            width,
            height,
        } = region;
        let name = &self.name;
        if region == self.cube.all() {
            tr!("{name}, mean", name)
        } else if region.pixels() == 1 {
            tr!("{name}, row {y} column {x}", name, y, x)
        } else {
            tr!(
                "{name}, mean of {width} x {height} from row {y} column {x}",
                name,
                width,
                height,
                y,
                x
            )
        }
    }

    /// The mean spectrum of the whole image; `None` where nothing was measured.
    pub fn mean(&self) -> Option<NamedSpectrum> {
        self.mean_of(self.cube.all())
    }

    /// The first, the last and the middle pixel: what a listing shows of an image.
    pub fn probes(&self) -> Vec<NamedSpectrum> {
        let (width, height) = (self.cube.width(), self.cube.height());
        let mut places = vec![(0, 0), (width - 1, height - 1), (width / 2, height / 2)];
        places.dedup();
        places
            .into_iter()
            .filter_map(|(x, y)| self.pixel(x, y))
            .collect()
    }

    fn named(&self, name: String, samples: Sampled) -> NamedSpectrum {
        NamedSpectrum {
            name,
            kind: self.kind,
            unit: self.unit.clone(),
            scale: self.scale,
            samples: samples.scaled(self.scale),
            notes: self.notes.clone(),
            source: self.source.clone(),
        }
    }
}
