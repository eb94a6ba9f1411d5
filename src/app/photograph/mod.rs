//! A photograph of a spectrum: read, its strip found, its axis by the lines of a lamp or by pins.

mod along;
mod example;
mod exposures;
mod figures;
mod instrument;
mod line_words;
mod on_page;
mod reading;
mod response;
mod spectrum;
mod view;
mod words;

pub use exposures::{Exposed, Exposure};
pub use figures::{ColourFigures, Estimate};
pub use instrument::{Applied, Fit, Instrument};
pub use on_page::{OnPage, Seen, Staged, example};
pub use reading::{of_photo, read};
pub use response::{Kept, Known, Through};
pub use spectrum::{Row, Rows, Stands};
pub use view::{
    ManyAsk, OfMany, PhotographAsk, PictureOf, Pixels, ResponseAsk, SeenPhotograph, is_instrument,
    is_photograph,
};
pub use words::{colour_words, json, sentence, sentence_parts, table, warnings};

use crate::{
    io::Exif,
    photographs::{
        Lamp,
        axis::{Answer, Curve, Pin, State},
        peaks::{Peak, Peaks},
        picture::Tones,
        strip::{ByHand, Found},
    },
};

/// Which lamp a person has named.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LampChoice {
    /// Any of them.
    #[default]
    Auto,
    /// None: no axis is looked for.
    Nothing,
    /// This one.
    Is(Lamp),
}

/// What a person has said about a photograph.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Said {
    /// Where its strip is.
    pub strip: ByHand,
    /// Wavelengths fall along it.
    pub falls: Option<bool>,
    /// Codes are proportional to light.
    pub is_linear: bool,
    /// Several exposures of one light.
    pub exposures: Vec<Exposure>,
    /// Which lamp it shows.
    pub lamp: LampChoice,
    /// Columns with their wavelengths.
    pub pins: Vec<Pin>,
    /// A suggested axis is taken.
    pub yes: bool,
    /// The strip and the axis of this one.
    pub instrument: Option<Instrument>,
}

/// Where an axis comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Source {
    /// By the lines, surely.
    Found,
    /// By the lines, perhaps.
    Suggested,
    /// By pins alone.
    Pins,
    /// By an instrument that was kept.
    Instrument,
    /// There is none.
    Nothing,
}

impl Source {
    /// The word of the JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Found => "found",
            Self::Suggested => "suggested",
            Self::Pins => "pins",
            Self::Instrument => "instrument",
            Self::Nothing => "none",
        }
    }
}

/// A photograph with what was found in it.
#[derive(Clone, Debug)]
pub struct Photograph {
    /// What the file is called.
    pub file: String,
    /// Width and height as shown.
    pub size: [usize; 2],
    /// What is kept of its EXIF.
    pub exif: Exif,
    /// What was done to the picture when it was read.
    pub notes: Vec<&'static str>,
    /// Its strip and the light along it.
    pub found: Found,
    /// The strip was drawn, turned or chosen by hand.
    pub by_hand: bool,
    /// Codes were said to be proportional to light.
    pub is_linear: bool,
    /// Lines of light.
    pub bright: Peaks,
    /// Dark lines, where no bright ones stand out.
    pub dark: Option<Peaks>,
    /// What the lines say of the axis; `None` where nothing was asked of them.
    pub answer: Option<Answer>,
    /// The axis through pins alone.
    pub pinned: Option<Curve>,
    pub pins: Vec<Pin>,
    /// Why the pins make no axis: it is then that of the lines.
    pub pins_refused: Option<String>,
    /// A suggestion was taken.
    pub yes: bool,
    /// The instrument that it was read with.
    pub instrument: Option<Applied>,
    /// How the camera bends its tones, which was undone.
    pub tones: Tones,
    /// The exposures that tell of it, and what was taken from them.
    pub exposed: Option<Exposed>,
    /// What it is through a response.
    pub through: Option<Through>,
    /// Its colour figures, or why there are none; not asked for without a response or an instrument.
    pub figures: Option<Result<ColourFigures, String>>,
}

impl Photograph {
    /// Where its axis comes from.
    pub fn source(&self) -> Source {
        let state = self.answer.as_ref().map(|answer| answer.state);
        match (state, self.pinned) {
            (_, Some(_)) => Source::Pins,
            _ if self.instrument.is_some() => match self.instrument.as_ref().map(|i| &i.fit) {
                Some(Fit::No(_)) => Source::Nothing,
                _ => Source::Instrument,
            },
            (Some(State::Found), _) => Source::Found,
            (Some(State::Suggested), _) => Source::Suggested,
            _ => Source::Nothing,
        }
    }

    /// Its axis, found or suggested.
    pub fn curve(&self) -> Option<Curve> {
        match self.source() {
            Source::Pins => self.pinned,
            Source::Instrument => Some(self.instrument.as_ref()?.curve),
            Source::Nothing => None,
            _ => Some(self.answer.as_ref()?.best.as_ref()?.curve),
        }
    }

    /// The axis that may be used: where it is open only once a person said yes.
    pub fn used_curve(&self) -> Option<Curve> {
        self.curve().filter(|_| !self.is_open())
    }

    /// An axis is there, and nobody said yet that it is right: a suggestion, or an instrument that
    /// has moved or that nothing in the picture checks.
    pub fn is_open(&self) -> bool {
        let is_doubted = match self.source() {
            Source::Suggested => true,
            Source::Instrument => {
                let fit = self.instrument.as_ref().map(|i| &i.fit);
                matches!(fit, Some(Fit::Moved(_) | Fit::Unchecked))
            }
            _ => false,
        };
        is_doubted && !self.yes
    }

    /// The peaks that the axis is made of: dark ones where it is that of daylight.
    pub fn peaks(&self) -> &Peaks {
        let lamp = self
            .answer
            .as_ref()
            .and_then(|a| a.best.as_ref())
            .map(|best| best.lamp);
        match (&self.dark, lamp) {
            (Some(dark), Some(lamp)) if lamp.is_dark() && self.is_by_lines() => dark,
            _ => &self.bright,
        }
    }

    /// Reads it through a response, and estimates its colour figures.
    pub fn read_through(&mut self, response: Option<&Kept>) {
        self.through = response.and_then(|response| response.through(self));
        let is_asked = self.through.is_some() || self.instrument.is_some();
        let is_asked = is_asked && self.used_curve().is_some();
        self.figures = is_asked.then(|| ColourFigures::of(self));
    }

    /// Its light is lines: the channels of one column see different parts of one.
    pub fn is_of_lines(&self) -> bool {
        self.bright.stand_out()
    }

    /// The axis is that of the picture's own lines.
    pub fn is_by_lines(&self) -> bool {
        matches!(self.source(), Source::Found | Source::Suggested)
    }

    /// The wavelengths in which the axis holds: near its lines, and where its doubt is small.
    pub fn valid_nm(&self) -> Option<(f64, f64)> {
        self.sure_nm(BEYOND_NM)
    }

    /// The wavelengths that colour figures are made of: also farther from the lines, where the doubt
    /// is small.
    pub fn reach_nm(&self) -> Option<(f64, f64)> {
        self.sure_nm(FARTHEST_NM)
    }

    /// From where to where the doubt is small, so far beyond the outermost lines.
    fn sure_nm(&self, beyond: f64) -> Option<(f64, f64)> {
        let curve = self.curve()?;
        let (low, high) = match self.source() {
            Source::Instrument => {
                let (low, high) = self.instrument.as_ref()?.valid_nm;
                (low + BEYOND_NM, high - BEYOND_NM)
            }
            Source::Pins => {
                let nm = self.pins.iter().map(|pin| pin.nm);
                let high = nm.clone().fold(f64::MIN, f64::max);
                (nm.fold(f64::MAX, f64::min), high)
            }
            _ => self.answer.as_ref()?.best.as_ref()?.span_nm(),
        };
        let middle = 0.5 * (low + high);
        let last = self.found.profile.columns() as f64 - 1.0;
        let ends = [curve.nm(0.0), curve.nm(last)];
        let (least, most) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let (mut from, mut to) = ((low - beyond).max(least), (high + beyond).min(most));
        let sure = |nm: f64| {
            let px = curve.px(nm, 0.0, last);
            px.is_some_and(|px| curve.sigma(px) <= MOST_SIGMA_NM)
        };
        while from < middle && !sure(from) {
            from += 1.0;
        }
        while to > middle && !sure(to) {
            to -= 1.0;
        }
        (to > from).then_some((from, to))
    }

    /// The width of lines that are no bands and not over-exposed, nm, where there is one.
    pub fn fwhm_nm(&self) -> Option<f64> {
        self.resolution().map(|(fwhm, _)| fwhm)
    }

    /// The same, and the wavelength of the line that is so wide.
    pub fn resolution(&self) -> Option<(f64, f64)> {
        let curve = self.curve()?;
        let sharp = |p: &&Peak| !p.is_clipped && !p.is_band;
        let width = |p: &Peak| (p.fwhm_px * curve.slope(p.px).abs(), curve.nm(p.px));
        let mut widths: Vec<(f64, f64)> =
            self.peaks().peaks.iter().filter(sharp).map(width).collect();
        widths.sort_by(|a, b| a.0.total_cmp(&b.0));
        widths.get(widths.len() / 2).copied()
    }
}

/// An axis holds so far beyond its outermost lines, where its doubt is not larger than this.
const BEYOND_NM: f64 = 15.0;
const MOST_SIGMA_NM: f64 = 1.5;
/// Figures may reach so far beyond them.
const FARTHEST_NM: f64 = 60.0;

#[cfg(test)]
mod tests;
