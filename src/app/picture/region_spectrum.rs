//! From a pixel or a region of an image to its mean spectrum, its spread and its model.

use std::sync::Arc;

use crate::{
    app::{
        derived::Derived,
        document::{Document, Subject},
        entry::Entry,
        memo::ByAddress,
        settings::Settings,
        state::derived_of,
        studies::Question,
    },
    spectrum::{NamedSpectrum, Rect, Region, Sampled, SpectralImage},
    study::Progress,
};

/// Which spectrum of which image, and how its model is made.
#[derive(Clone, Debug, PartialEq)]
pub struct RegionAsk {
    pub image: ByAddress<SpectralImage>,
    /// The pixels.
    pub rect: Rect,
    /// The knobs.
    pub settings: Settings,
    /// The light that a reflectance is looked at under.
    pub light: ByAddress<Entry>,
}

#[derive(Clone, Debug, PartialEq)]
pub struct RegionSpectrum {
    /// The pixels.
    pub rect: Rect,
    /// Their mean in the image's unit, with its provenance.
    pub spectrum: NamedSpectrum,
    /// Wavelengths at which any of them was measured, nm.
    pub nm: Vec<f64>,
    /// Standard deviation at each wavelength, in the image's unit.
    pub deviation: Vec<f64>,
    /// Smallest and largest value at each wavelength, in the image's unit.
    pub extremes: Vec<[f64; 2]>,
    /// Model and colours; `None` for kinds that have none.
    pub derived: Option<Arc<Derived>>,
}

impl RegionAsk {
    /// A document about the spectrum alone.
    fn document(&self, entry: Arc<Entry>) -> Document {
        let mut document = if entry.kind().is_factor() {
            let mut document = Document::about(self.light.0.clone());
            document.factor = Some(entry);
            document.subject = Subject::Factor;
            document
        } else {
            Document::about(entry)
        };
        document.settings = self.settings;
        document
    }
}

impl Question for RegionAsk {
    type Answer = RegionSpectrum;

    /// The answer; `None` where nothing was measured or it was cancelled.
    fn answer(&self, progress: &Progress) -> Option<RegionSpectrum> {
        let image = &self.image.0;
        let region = Region::of(&image.cube, self.rect, || !progress.is_cancelled())?;
        let spectrum = of_region(image, &region)?;
        let scale = image.scale;
        let there = |band: &usize| region.measured[*band] > 0;
        let bands: Vec<usize> = (0..region.mean.len()).filter(there).collect();
        let entry = Entry::own(0, spectrum.clone());
        let derived = entry
            .is_usable()
            .then(|| Arc::new(derived_of(&self.document(Arc::new(entry))).0));
        Some(RegionSpectrum {
            rect: region.rect,
            nm: bands.iter().map(|b| image.cube.nm()[*b]).collect(),
            deviation: bands
                .iter()
                .map(|b| region.deviation[*b] * scale.abs())
                .collect(),
            extremes: bands
                .iter()
                .map(|b| [region.least[*b] * scale, region.most[*b] * scale])
                .map(|[a, b]| [a.min(b), a.max(b)])
                .collect(),
            spectrum,
            derived,
        })
    }
}

/// The mean spectrum of a pixel or a region with its provenance: what "Take as spectrum" and the
/// command line take. `None` where nothing was measured.
pub fn named(image: &SpectralImage, rect: Rect) -> Option<NamedSpectrum> {
    of_region(image, &Region::of(&image.cube, rect, || true)?)
}

fn of_region(image: &SpectralImage, region: &Region) -> Option<NamedSpectrum> {
    let rect = region.rect;
    let measured = image.cube.nm().iter().zip(&region.mean);
    let (nm, values) = measured.filter(|(_, v)| v.is_finite()).unzip();
    let samples: Sampled = Sampled::new(nm, values).ok()?;
    let name = image.name_of(rect);
    let mut notes = image.notes.clone();
    notes.push(place_words(image, region));
    Some(NamedSpectrum {
        name,
        kind: image.kind,
        unit: image.unit.clone(),
        scale: image.scale,
        samples: samples.scaled(image.scale),
        notes,
        source: image.source.clone(),
    })
    .filter(|_| rect.pixels() > 0)
}

/// "Mean of 4 x 3 pixels: columns 10-13, rows 5-7 (counted from 0) of 512 x 512."
fn place_words(image: &SpectralImage, region: &Region) -> String {
    let Rect {
        x,
        y,
        width,
        height,
    } = region.rect;
    let (across, down) = (image.cube.width(), image.cube.height());
    let mut words = if region.rect.pixels() == 1 {
        tr!(
            "Pixel in column {x}, row {y} (counted from 0) of {across} x {down}",
            x,
            y,
            across,
            down
        )
    } else {
        tr!(
            "Mean of {width} x {height} pixels: columns {x}-{last_x}, rows {y}-{last_y} (counted \
             from 0) of {across} x {down}",
            width,
            height,
            x,
            last_x = x + width - 1,
            y,
            last_y = y + height - 1,
            across,
            down
        )
    };
    let pixels = region.rect.pixels();
    let least = region.measured.iter().copied().min().unwrap_or(0);
    if least < pixels {
        let most = region.measured.iter().copied().max().unwrap_or(0);
        words += "; ";
        words += &tr!(
            "{least} to {most} of {pixels} pixels were measured in a band",
            least,
            most,
            pixels
        );
    }
    words + "."
}
