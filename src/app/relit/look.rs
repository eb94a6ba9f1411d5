//! A picture before anything is kept of it: which one, what falls on it, what was tried on it.

use super::{Outcome, told};
use crate::{
    app::{
        document::Document, entry::Entry, memo::ByAddress, pages::ImageMemory, pages::RelitMemory,
        state::App, studies::Question,
    },
    color::Observer,
    languages::with_sign,
    pictures::{
        Asked, BOUND_RMS, Bands, Choice, FixedSettings, Illuminant, InMemory, LineChoice, OfImage,
        PictureError, Pixels, Plan, ReferenceKind, Scene, Survey, Weighting, choose,
    },
    spectrum::SpectralImage,
    study::Progress,
};

/// Most pixels that are drawn, and most values that are kept of them.
const MOST_DRAWN: usize = 1 << 18;
const MOST_VALUES: usize = 1 << 24;

/// Which picture.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// The wall of paints, formed when it is asked for.
    Wall,
    /// An image that was opened.
    Image(ByAddress<SpectralImage>),
}

#[derive(Clone, Debug, PartialEq)]
pub struct LookAsk {
    /// The picture.
    pub subject: Subject,
    /// The light that fell on it when it was taken; `None` for reflectances, and where nobody
    /// knows.
    pub taken_under: Option<ByAddress<Entry>>,
    /// A reflectance's own light, under which its colours are exact; `None` for daylight.
    pub own: Option<ByAddress<Entry>>,
    pub observer: Observer,
    /// What is enough: 95 % of the differences (ΔE₀₀) are within.
    pub bound: f64,
    /// What is not left to the choice of reference and lines.
    pub wish: FixedSettings,
    /// Whether a reflectance's numbers are weighed by the colours under many lights.
    pub weighted: bool,
}

/// A picture with all that was found out about it.
#[derive(Debug)]
pub struct Looked {
    pub ask: LookAsk,
    /// What lists call it.
    pub name: String,
    /// Unit of its values.
    pub unit: String,
    /// What was merged or left out of its bands, a sentence each.
    pub said: Vec<String>,
    /// Mean, noise, a sample.
    pub survey: Survey,
    /// What was tried, and what is enough.
    pub choice: Choice,
    /// The pixels that are drawn: every `step`-th across and down.
    pub drawn: InMemory,
    /// See `drawn`.
    pub step: usize,
    /// Own light, observer and weighting.
    pub base: Plan,
    /// What was not left to the choice.
    pub wish: FixedSettings,
    /// The light that fell on it.
    pub known: Option<Illuminant>,
}

/// A light of the library as pictures take it.
pub(super) fn light_of(entry: &Entry) -> Illuminant {
    Illuminant::new(entry.name(), &entry.spectrum.samples)
}

impl LookAsk {
    /// What the page is about: the image that the page Spectral image shows, or the wall.
    pub fn of(app: &App, memory: &RelitMemory, image: &ImageMemory) -> Self {
        let document: &Document = app.document();
        let shown = crate::app::picture::shown(document, image).filter(|_| !memory.wall);
        let subject = match shown {
            Some(entry) => Subject::Image(ByAddress(entry.image.clone())),
            None => Subject::Wall,
        };
        let taken_under = memory.taken_under.as_deref().and_then(|key| app.entry(key));
        let ask = Self {
            subject,
            taken_under: None,
            own: None,
            observer: document.settings.observer,
            bound: memory.bound,
            wish: memory.wish.clone(),
            weighted: memory.weighted,
        };
        let taken_under = taken_under.filter(|_| ask.asks_for_light());
        // The light of one picture need not be known of the next.
        let reference = ask.wish.reference;
        let can_be = |kind: &ReferenceKind| *kind != ReferenceKind::Light || taken_under.is_some();
        let own = memory.own.as_deref().and_then(|key| app.entry(key));
        Self {
            own: own.filter(|_| !ask.asks_for_light()).map(ByAddress),
            wish: FixedSettings {
                reference: reference.filter(can_be),
                ..ask.wish
            },
            taken_under: taken_under.map(ByAddress),
            ..ask
        }
    }

    /// Whether it matters what fell on it: a picture of reflectances was divided already.
    pub fn asks_for_light(&self) -> bool {
        match &self.subject {
            Subject::Wall => true,
            Subject::Image(image) => !image.0.kind.is_factor(),
        }
    }

    fn looked(&self, progress: &Progress) -> Result<Looked, PictureError> {
        let known = self.taken_under.as_ref().map(|entry| light_of(&entry.0));
        match &self.subject {
            Subject::Wall => {
                let wall = Scene::at_hand(known.as_ref())?;
                let pixels = InMemory::of(&wall)?;
                let named = (wall.name().to_owned(), String::new());
                self.found(&pixels, named, Vec::new(), known, progress)
            }
            Subject::Image(image) => {
                let image = &image.0;
                let pixels = OfImage::new(image, false)?;
                let named = (image.name.clone(), image.unit.clone());
                self.found(&pixels, named, pixels.notes().to_vec(), known, progress)
            }
        }
    }

    fn found(
        &self,
        pixels: &dyn Pixels,
        (name, unit): (String, String),
        mut said: Vec<String>,
        known: Option<Illuminant>,
        progress: &Progress,
    ) -> Result<Looked, PictureError> {
        let bands = pixels.bands();
        let survey = Survey::of(pixels, progress)?;
        let base = self.base(bands);
        let wish = self.wish_within(bands, &mut said);
        let asked = Asked::Bound {
            p95: self.bound,
            rms: BOUND_RMS,
        };
        let with = (&base, &wish);
        let choice = choose(bands, &survey, known.as_ref(), with, asked, progress)?;
        said.extend(choice.notes.iter().cloned());
        let step = step(pixels);
        Ok(Looked {
            ask: self.clone(),
            name,
            unit,
            said,
            drawn: drawn(pixels, step)?,
            survey,
            choice,
            step,
            base,
            wish,
            known,
        })
    }

    fn base(&self, bands: &Bands) -> Plan {
        let weighting = Weighting::usual(bands, self.observer);
        let usual = Plan::new(bands, 3);
        let own = self.own.as_ref().map(|entry| light_of(&entry.0));
        Plan {
            observer: self.observer,
            weighting: weighting.filter(|_| self.weighted),
            own: own.or(usual.own.clone()),
            ..usual
        }
    }

    /// The wish, without lines that this picture has no bands for: they may be another picture's.
    fn wish_within(&self, bands: &Bands, said: &mut Vec<String>) -> FixedSettings {
        let mut wish = self.wish.clone();
        if let LineChoice::At(places) = &mut wish.lines {
            let [first, last] = [bands.nm()[0], bands.nm()[bands.len() - 1]];
            places.retain(|nm| {
                let is_within = (first..=last).contains(nm);
                if !is_within {
                    let [nm, first, last] = [*nm, first, last].map(|nm| with_sign(nm.to_string()));
                    said.push(tr!(
                        "The line at {nm} nm is left out: the bands reach from {first} to {last} \
                         nm.",
                        nm,
                        first,
                        last
                    ));
                }
                is_within
            });
            // Three numbers are the series', and one fewer than bands are all there are.
            let room = bands.len().saturating_sub(4);
            if places.len() > room {
                places.truncate(room);
                said.push(tr!("So few bands have room for {n} line."
                    | "So few bands have room for {n} lines." % room));
            }
        }
        wish
    }
}

impl Question for LookAsk {
    type Answer = Outcome<Looked>;

    fn answer(&self, progress: &Progress) -> Option<Self::Answer> {
        told(self.looked(progress))
    }
}

/// By how many pixels one goes on for the next drawn one.
fn step(pixels: &dyn Pixels) -> usize {
    let (width, height) = pixels.size();
    let most = MOST_DRAWN.min(MOST_VALUES / pixels.bands().len());
    let mut step = 1;
    while width.div_ceil(step) * height.div_ceil(step) > most {
        step += 1;
    }
    step
}

/// Every `step`-th pixel across and down: pixels as they are, with their noise, so that what is
/// measured on them is true of pixels.
fn drawn(pixels: &dyn Pixels, step: usize) -> Result<InMemory, PictureError> {
    if step == 1 {
        return InMemory::of(pixels);
    }
    let (width, height) = pixels.size();
    let bands = pixels.bands().len();
    let (across, down) = (width.div_ceil(step), height.div_ceil(step));
    let mut values = vec![0.0; across * down * bands];
    let mut row = vec![0.0; width * bands];
    for y in 0..down {
        pixels.rows(y * step, 1, &mut row)?;
        for (j, band) in row.chunks_exact(width).enumerate() {
            let into = &mut values[(j * down + y) * across..][..across];
            into.iter_mut()
                .zip(band.iter().step_by(step))
                .for_each(|(into, value)| *into = *value);
        }
    }
    InMemory::new(across, down, pixels.bands().clone(), values)
}

impl Looked {
    /// Work on every pixel.
    ///
    /// # Errors
    /// Those of the work, and of bands that are none.
    pub fn with_pixels<T>(
        &self,
        work: impl FnOnce(&dyn Pixels) -> Result<T, PictureError>,
    ) -> Result<T, PictureError> {
        match &self.ask.subject {
            Subject::Image(image) if self.step > 1 => work(&OfImage::new(&image.0, false)?),
            _ => work(&self.drawn),
        }
    }

    pub fn bands(&self) -> &Bands {
        self.drawn.bands()
    }

    /// Columns and rows that are drawn.
    pub fn size(&self) -> [usize; 2] {
        let (width, height) = self.drawn.size();
        [width, height]
    }

    /// Fewest and most numbers a pixel that can be asked for.
    pub fn numbers(&self) -> [usize; 2] {
        let tried = || self.choice.tried.iter().map(|tried| tried.numbers);
        [tried().min(), tried().max()].map(|end| end.unwrap_or(3))
    }
}
