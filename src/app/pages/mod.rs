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
    /// Surfaces that are one colour under a light and two under another.
    Metamers,
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
    /// How many numbers most lights need.
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
    /// A photograph of a spectrum becomes a spectrum.
    Photograph,
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
    /// What the tab is called that its modes share.
    tab_title: &'static str,
}

/// A row of a tab of its own, under its only word.
const fn row(
    page: Page,
    place: Place,
    (title, word): (&'static str, &'static str),
    lesson: &'static str,
    meaning: &'static str,
) -> Row {
    Row {
        page,
        place,
        tab: page,
        title,
        word,
        old: &[],
        lesson,
        meaning,
        mode: title,
        tab_title: title,
    }
}

impl Row {
    /// A mode of another page's tab.
    const fn under(self, tab: Page) -> Self {
        Self { tab, ..self }
    }

    /// With words of earlier versions.
    const fn once(self, old: &'static [&'static str]) -> Self {
        Self { old, ..self }
    }

    /// The first page of a tab that is called otherwise than the page.
    const fn titled_tab(self, tab_title: &'static str) -> Self {
        Self { tab_title, ..self }
    }

    /// A tab's own page, where it is called otherwise among the modes of its tab.
    const fn among_modes(self, mode: &'static str) -> Self {
        Self { mode, ..self }
    }
}

/// The pages, place by place.
const ROWS: &[Row] = &[
    row(
        Page::Lessons,
        Place::Learn,
        ("Lessons", "lessons"),
        "",
        "Short walks through the program: predict, do, see why.",
    ),
    row(
        Page::Glossary,
        Place::Learn,
        ("Glossary", "glossary"),
        "",
        "What the words of this window mean.",
    ),
    row(
        Page::Teachers,
        Place::Learn,
        ("For teachers", "teachers"),
        "",
        "What each lesson teaches, what to prepare, handouts, and how to write one.",
    ),
    row(
        Page::Spectrum,
        Place::Look,
        ("Spectrum", "look"),
        "waves",
        "The spectrum, its model and surfaces under both.",
    )
    .once(&["spectrum"]),
    row(
        Page::Absorption,
        Place::Look,
        ("Dark lines", "dark-lines"),
        "missing",
        "Absorption lines kept as negative spikes, and their names.",
    )
    .once(&["absorption"]),
    row(
        Page::Chain,
        Place::Through,
        ("Chain", "chain"),
        "filters",
        "The light through filters and off surfaces, exact beside model.",
    )
    .once(&["products"]),
    row(
        Page::Narrow,
        Place::Through,
        ("One filter", "filter"),
        "samples",
        "A narrow band-pass moved over the light, at equal numbers.",
    )
    .once(&["narrow"]),
    row(
        Page::TwoLights,
        Place::Through,
        ("Two lights", "two-lights"),
        "metamers",
        "The same surfaces under two lights: which colours change.",
    )
    .once(&["lights"]),
    row(
        Page::Metamers,
        Place::Through,
        ("Metamers", "metamers"),
        "metamers",
        "Surfaces that look alike under one light and differ under another, found and made.",
    ),
    row(
        Page::SameSurface,
        Place::Through,
        ("Same surface?", "same-surface"),
        "filters",
        "Whether a spectrum is the light off a surface: S3 = S1 S2.",
    )
    .once(&["check"]),
    row(
        Page::Quality,
        Place::Quality,
        ("Verdict", "quality"),
        "quality",
        "Is it a good light? Surfaces under it, twelve figures in words, and all of them.",
    ),
    row(
        Page::Chromaticity,
        Place::Quality,
        ("Chromaticity", "chromaticity"),
        "quality",
        "Where the light is among colours, whites and screens.",
    ),
    row(
        Page::Rendition,
        Place::Quality,
        ("Colours under it", "rendition"),
        "quality",
        "What the light does to colours: TM-30 and CRI, hue by hue.",
    ),
    row(
        Page::QualityOrder,
        Place::Quality,
        ("Against order", "quality-order"),
        "quality",
        "How many numbers a model needs to give the light's own figures.",
    ),
    row(
        Page::Mix,
        Place::Design,
        ("Mix", "mix"),
        "white",
        "Mix lines, LEDs and lamps with faders and rate the mix.",
    ),
    row(
        Page::Solve,
        Place::Design,
        ("Solve", "solve"),
        "white",
        "Find fader settings for a colour, and the best that several searches find with free lines.",
    ),
    row(
        Page::FromColour,
        Place::Design,
        ("From a colour", "from-colour"),
        "recover",
        "Which spectra have this colour?",
    ),
    row(
        Page::Tradeoff,
        Place::Numbers,
        ("Trade-off", "tradeoff"),
        "spend",
        "Error against numbers: every order, with and without spikes.",
    )
    .among_modes("Curve"),
    row(
        Page::Many,
        Place::Numbers,
        ("Many lights", "many-lights"),
        "spend",
        "How many numbers most of your lights need: a set, or your folders.",
    )
    .under(Page::Tradeoff),
    row(
        Page::Auction,
        Place::Numbers,
        ("Auction", "auction"),
        "spend",
        "What to buy with the next numbers: an order, a spike or the lines' widths.",
    )
    .under(Page::Tradeoff),
    row(
        Page::Coefficients,
        Place::Numbers,
        ("Why few suffice", "why"),
        "colour",
        "Why few numbers carry colour: the coefficients of the light beside those of the eye.",
    )
    .once(&["coefficients"])
    .titled_tab("For authors"),
    row(
        Page::Race,
        Place::Numbers,
        ("Race", "race"),
        "samples",
        "The composite against other representations, at equal numbers.",
    )
    .under(Page::Coefficients),
    row(
        Page::KnownLamps,
        Place::Numbers,
        ("Known lamps", "known-lamps"),
        "spend",
        "What the light is made of: lamps that are known, a short series, a few lines.",
    )
    .under(Page::Coefficients),
    row(
        Page::Resampling,
        Place::Numbers,
        ("Products in few numbers", "resampling"),
        "filters",
        "One product formed on few points, by convolution and at every nm.",
    )
    .once(&["forming"])
    .under(Page::Coefficients),
    row(
        Page::Bounces,
        Place::Numbers,
        ("Bounces", "bounces"),
        "filters",
        "What the ways of forming products cost as bounces add up.",
    )
    .under(Page::Coefficients),
    row(
        Page::Truth,
        Place::Numbers,
        ("The paper checked", "truth"),
        "colour",
        "The paper's claims, measured on this spectrum and range.",
    )
    .under(Page::Coefficients),
    row(
        Page::Image,
        Place::Picture,
        ("Spectral image", "image"),
        "recover",
        "A spectral image: a pixel or a region's mean becomes a spectrum.",
    ),
    row(
        Page::Photograph,
        Place::Picture,
        ("Photograph", "photograph"),
        "prism",
        "A photograph of a spectrum: the lines of a lamp fix its wavelengths.",
    ),
    row(
        Page::Prism,
        Place::Picture,
        ("Prism and rainbow", "prism"),
        "prism",
        "The light through a prism: every line one exact ray, the rest a smooth band.",
    )
    .among_modes("Prism"),
    row(
        Page::Rainbow,
        Place::Picture,
        ("Rainbow", "rainbow"),
        "prism",
        "The light in drops of water: both bows, every line a stripe of its own.",
    )
    .under(Page::Prism),
    row(
        Page::Gem,
        Place::Picture,
        ("Gem", "gem"),
        "prism",
        "A cut gem under the light, traced ray by ray; under another light at once.",
    ),
    row(
        Page::Relit,
        Place::Picture,
        ("In few numbers, relit", "relit"),
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
