//! The places of the window and the pages in them: one row a page, and what pages keep under undo.
//! All that is listed page by page is listed here.

mod memory;
mod page;
mod place;

use serde::{Deserialize, Serialize};

use super::{design::mix::Mix, recipe::NameOf};

pub use memory::{
    AskedLesson, FieldChoice, LIMITS, ManyMemory, PageMemory, RACE_BUDGETS, SHARES_PERCENT,
    SPENDABLE, WaysShown, WordsMemory,
};
pub use place::Place;

/// A page of the window: they all show the same document.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Page {
    /// The plot with the patches below it.
    #[default]
    Spectrum,
    /// Absorption lines as negative spikes.
    Absorption,
    /// A light through filters and off surfaces.
    Chain,
    /// A narrow band-pass over the light.
    Narrow,
    /// The same surfaces under two lights.
    TwoLights,
    /// Is this light that one off this surface?
    SameSurface,
    /// Figures of light quality, measured and by the model.
    Quality,
    /// Where the light is among colours.
    Chromaticity,
    /// What the light does to colours: TM-30 and CRI.
    Rendition,
    /// Figures of light quality against the order.
    QualityOrder,
    /// Channels mixed to a light by hand.
    Mix,
    /// Channels mixed to a light that is wished for.
    Solve,
    /// A spectrum from its colour.
    FromColour,
    /// The light's coefficients beside those of the colour-matching functions.
    Coefficients,
    /// Error against numbers.
    Tradeoff,
    /// Which order is enough for how many lights.
    Many,
    /// What to buy with the next numbers.
    Auction,
    /// The composite against other representations.
    Race,
    /// The light in few words: known lamps, a short series, lines of their own width.
    KnownLamps,
    /// The same product formed in every way.
    Resampling,
    /// Error against the number of bounces.
    Bounces,
    /// A spectral image: a pixel or a region becomes a spectrum.
    Image,
    /// Light through a prism.
    Prism,
    /// Light through drops of water.
    Rainbow,
    /// Light through a cut gem.
    Gem,
    /// A spectral image in few numbers a pixel, under any light.
    Relit,
    /// Short walks through the program.
    Lessons,
    /// What the lessons teach, and how to write one.
    Teachers,
    /// Words explained.
    Glossary,
    /// The paper's claims, measured on this spectrum.
    Truth,
}

/// All that is fixed about a page.
struct Row {
    page: Page,
    place: Place,
    /// The page whose tab it stands under: its own, or that of the page that it is a mode of.
    tab: Page,
    title: &'static str,
    word: &'static str,
    /// Words of earlier versions.
    old: &'static [&'static str],
    /// The name of the lesson that answers what it asks; "" for none.
    lesson: &'static str,
    meaning: &'static str,
    /// What it is called among the modes of its tab.
    mode: &'static str,
}

const fn row(
    page: Page,
    (place, tab): (Place, Page),
    (title, word): (&'static str, &'static str),
    old: &'static [&'static str],
    lesson: &'static str,
    meaning: &'static str,
) -> Row {
    Row {
        page,
        place,
        tab,
        title,
        word,
        old,
        lesson,
        meaning,
        mode: title,
    }
}

/// A tab's own page, where it is called otherwise among the modes of its tab.
const fn among_modes(row: Row, mode: &'static str) -> Row {
    Row { mode, ..row }
}

/// The pages, place by place.
const ROWS: &[Row] = &[
    row(
        Page::Lessons,
        (Place::Learn, Page::Lessons),
        ("Lessons", "lessons"),
        &[],
        "",
        "Short walks through the program: predict, do, see why.",
    ),
    row(
        Page::Glossary,
        (Place::Learn, Page::Glossary),
        ("Glossary", "glossary"),
        &[],
        "",
        "What the words of this window mean.",
    ),
    row(
        Page::Truth,
        (Place::Learn, Page::Truth),
        ("The paper checked", "truth"),
        &[],
        "",
        "The paper's claims, measured on this spectrum and range.",
    ),
    row(
        Page::Teachers,
        (Place::Learn, Page::Teachers),
        ("For teachers", "teachers"),
        &[],
        "",
        "What each lesson teaches, what to prepare, handouts, and how to write one.",
    ),
    row(
        Page::Spectrum,
        (Place::Look, Page::Spectrum),
        ("Spectrum", "look"),
        &["spectrum"],
        "waves",
        "The spectrum, its model and surfaces under both.",
    ),
    row(
        Page::Absorption,
        (Place::Look, Page::Absorption),
        ("Dark lines", "dark-lines"),
        &["absorption"],
        "missing",
        "Absorption lines kept as negative spikes, and their names.",
    ),
    row(
        Page::Chain,
        (Place::Through, Page::Chain),
        ("Chain", "chain"),
        &["products"],
        "filters",
        "The light through filters and off surfaces, exact beside model.",
    ),
    row(
        Page::Narrow,
        (Place::Through, Page::Narrow),
        ("One filter", "filter"),
        &["narrow"],
        "samples",
        "A narrow band-pass moved over the light, at equal numbers.",
    ),
    row(
        Page::TwoLights,
        (Place::Through, Page::TwoLights),
        ("Two lights", "two-lights"),
        &["lights"],
        "metamers",
        "The same surfaces under two lights; metamers found and made.",
    ),
    row(
        Page::SameSurface,
        (Place::Through, Page::SameSurface),
        ("Same surface?", "same-surface"),
        &["check"],
        "filters",
        "Whether a spectrum is the light off a surface: S3 = S1 S2.",
    ),
    row(
        Page::Quality,
        (Place::Quality, Page::Quality),
        ("Figures", "quality"),
        &[],
        "quality",
        "Every figure of light quality, measured beside model, and what it means.",
    ),
    row(
        Page::Chromaticity,
        (Place::Quality, Page::Chromaticity),
        ("Chromaticity", "chromaticity"),
        &[],
        "quality",
        "Where the light is among colours, whites and screens.",
    ),
    row(
        Page::Rendition,
        (Place::Quality, Page::Rendition),
        ("Colours under it", "rendition"),
        &[],
        "quality",
        "What the light does to colours: TM-30 and CRI, hue by hue.",
    ),
    row(
        Page::QualityOrder,
        (Place::Quality, Page::QualityOrder),
        ("Against order", "quality-order"),
        &[],
        "quality",
        "From how many numbers on a model has the figures of its light.",
    ),
    row(
        Page::Mix,
        (Place::Design, Page::Mix),
        ("Mix", "mix"),
        &[],
        "white",
        "Lines, LEDs and lights mixed by faders, with what the mixture is worth.",
    ),
    row(
        Page::Solve,
        (Place::Design, Page::Solve),
        ("Solve", "solve"),
        &[],
        "white",
        "The faders for a colour that is wished for, and what lines can reach at best.",
    ),
    row(
        Page::FromColour,
        (Place::Design, Page::FromColour),
        ("From a colour", "from-colour"),
        &[],
        "recover",
        "Spectra that have a colour, and all that could have it.",
    ),
    row(
        Page::Coefficients,
        (Place::Numbers, Page::Coefficients),
        ("Why few suffice", "why"),
        &["coefficients"],
        "colour",
        "Why few numbers carry colour: the coefficients of the light beside those of the eye.",
    ),
    among_modes(
        row(
            Page::Tradeoff,
            (Place::Numbers, Page::Tradeoff),
            ("Trade-off", "tradeoff"),
            &[],
            "spend",
            "Error against numbers: every order, with and without spikes.",
        ),
        "Curve",
    ),
    row(
        Page::Many,
        (Place::Numbers, Page::Tradeoff),
        ("Many lights", "many-lights"),
        &[],
        "spend",
        "Which order is enough for how many lights of a set or of your folders.",
    ),
    row(
        Page::Auction,
        (Place::Numbers, Page::Tradeoff),
        ("Auction", "auction"),
        &[],
        "spend",
        "What to buy with the next numbers: an order, a spike or the lines' widths.",
    ),
    row(
        Page::Race,
        (Place::Numbers, Page::Race),
        ("Race", "race"),
        &[],
        "samples",
        "The composite against other representations, at equal numbers.",
    ),
    row(
        Page::KnownLamps,
        (Place::Numbers, Page::KnownLamps),
        ("Known lamps", "known-lamps"),
        &[],
        "spend",
        "What the light is made of: lamps that are known, a short series, a few lines.",
    ),
    among_modes(
        row(
            Page::Resampling,
            (Place::Numbers, Page::Resampling),
            ("Products in few numbers", "resampling"),
            &["forming"],
            "filters",
            "One product formed on few points, by convolution and at every nm.",
        ),
        "Ways",
    ),
    row(
        Page::Bounces,
        (Place::Numbers, Page::Resampling),
        ("Bounces", "bounces"),
        &[],
        "filters",
        "What the ways of forming products cost as bounces add up.",
    ),
    row(
        Page::Image,
        (Place::Picture, Page::Image),
        ("Spectral image", "image"),
        &[],
        "recover",
        "A spectral image: a pixel or a region's mean becomes a spectrum.",
    ),
    among_modes(
        row(
            Page::Prism,
            (Place::Picture, Page::Prism),
            ("Prism and rainbow", "prism"),
            &[],
            "prism",
            "The light through a prism: every line one exact ray, the rest a smooth band.",
        ),
        "Prism",
    ),
    row(
        Page::Rainbow,
        (Place::Picture, Page::Prism),
        ("Rainbow", "rainbow"),
        &[],
        "prism",
        "The light in drops of water: both bows, every line a stripe of its own.",
    ),
    row(
        Page::Gem,
        (Place::Picture, Page::Gem),
        ("Gem", "gem"),
        &[],
        "prism",
        "A cut gem under the light, traced ray by ray; under another light at once.",
    ),
    row(
        Page::Relit,
        (Place::Picture, Page::Relit),
        ("In few numbers, relit", "relit"),
        &[],
        "recover",
        "A spectral image in few numbers a pixel, and how it looks under any light.",
    ),
];

/// What pages keep in the document, under undo and in projects, each under its own key: plain data,
/// spectra by their keys.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PageSettings {
    /// The mixing desk of the place `Design`.
    pub mix: Mix,
}

/// What one page keeps.
#[derive(Clone, Debug, PartialEq)]
pub enum PageSetting {
    /// The mixing desk.
    Mix(Mix),
}

impl Default for PageSettings {
    fn default() -> Self {
        Self { mix: Mix::first() }
    }
}

impl PageSettings {
    /// One of them anew, moved to what is allowed.
    pub fn set(&mut self, setting: PageSetting) {
        match setting {
            PageSetting::Mix(mix) => self.mix = mix.clamped(),
        }
    }

    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        Self {
            mix: self.mix.clamped(),
        }
    }

    /// Lets go of a spectrum that left the library.
    pub fn forget(&mut self, key: &str) {
        self.mix.forget(key);
    }

    /// What changed, in words.
    pub fn changed_since(&self, before: &Self, name_of: NameOf<'_>) -> Vec<String> {
        let mix = self.mix.changed_since(&before.mix, name_of);
        mix.into_iter().collect()
    }
}
