//! The places of the window and the pages in them: one row a page, and what each keeps.
//! All that is listed page by page is listed here.

mod auction;
mod bounces;
mod chain;
mod chromaticity;
mod dark_lines;
mod from_colour;
mod gem;
mod image;
pub mod knob;
mod known_lamps;
mod learn;
mod look;
mod many;
mod mix;
mod narrow;
pub mod orders;
mod page;
mod place;
mod prism;
mod quality;
mod race;
mod rainbow;
mod relit;
mod resampling;
pub mod same_surface;
mod solve;
pub mod states;
mod tradeoff;
mod two_lights;
mod why;

use std::collections::BTreeMap;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use serde_json::{Map, Value};

use super::recipe::NameOf;
use states::{PageState, in_reach, read, states, words_of, written};

pub use super::charts::quality::DiagramShows;
pub use auction::AuctionState;
pub use bounces::BouncesMemory;
pub use chain::ChainMemory;
pub use dark_lines::AbsorptionMemory;
pub use from_colour::{FromColour, MERCURY_NM, UNDER};
pub use gem::{GemColour, GemMemory, LightPart, RAYS_SHOWN, SIZES_SHOWN};
pub use image::{ImageMemory, Show, Spread};
pub use known_lamps::WordsMemory;
pub use look::{LookState, SPENDABLE};
pub use many::ManyMemory;
pub use mix::MixState;
pub use orders::OrdersState;
pub use narrow::{NarrowMemory, PASS_WIDTHS_NM};
pub use place::Place;
pub use prism::{Beside, Handle, PrismMemory, STOPS};
pub use quality::RenditionState;
pub use race::{FieldChoice, RACE_BUDGETS, RaceState};
pub use rainbow::RainbowMemory;
pub use relit::{LINES_NM, Look, MOST_LINES, RelitMemory};
pub use resampling::ResamplingMemory;
pub use same_surface::SameSurfaceMemory;
pub use solve::MixWish;
pub use tradeoff::{TradeoffState, WaysShown};
pub use two_lights::TwoLightsMemory;
pub use why::WhyState;

/// A lesson that is to be begun.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AskedLesson {
    /// The name of one that is known, or the path of a file.
    pub name: String,
    /// The step that it is to begin with, from 0.
    pub step: usize,
    /// The step with its task done and its answer told.
    pub done: bool,
}

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
    /// What every order leaves out.
    Orders,
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

/// The pages, place by place: a row each, in the page's own file.
const ROWS: &[Row] = &[
    learn::LESSONS,
    learn::GLOSSARY,
    learn::TEACHERS,
    look::ROW,
    dark_lines::ROW,
    chain::ROW,
    narrow::ROW,
    two_lights::ROW,
    two_lights::METAMERS,
    same_surface::ROW,
    quality::QUALITY,
    chromaticity::ROW,
    quality::RENDITION,
    quality::QUALITY_ORDER,
    mix::ROW,
    solve::ROW,
    from_colour::ROW,
    tradeoff::ROW,
    many::ROW,
    auction::ROW,
    why::ROW,
    race::ROW,
    known_lamps::ROW,
    resampling::ROW,
    bounces::ROW,
    orders::ROW,
    learn::TRUTH,
    image::ROW,
    image::PHOTOGRAPH,
    prism::ROW,
    rainbow::ROW,
    gem::ROW,
    relit::ROW,
];

states! {
    look: LookState = Spectrum,
    dark_lines: AbsorptionMemory = Absorption,
    chain: ChainMemory = Chain,
    narrow: NarrowMemory = Narrow,
    two_lights: TwoLightsMemory = TwoLights,
    same_surface: SameSurfaceMemory = SameSurface,
    chromaticity: DiagramShows = Chromaticity,
    rendition: RenditionState = Rendition,
    // A wish takes the desk along.
    solve: MixWish = Solve,
    mix: MixState = Mix,
    from_colour: FromColour = FromColour,
    why: WhyState = Coefficients,
    tradeoff: TradeoffState = Tradeoff,
    many: ManyMemory = Many,
    auction: AuctionState = Auction,
    race: RaceState = Race,
    known_lamps: WordsMemory = KnownLamps,
    resampling: ResamplingMemory = Resampling,
    bounces: BouncesMemory = Bounces,
    orders: OrdersState = Orders,
    image: ImageMemory = Image,
    prism: PrismMemory = Prism,
    rainbow: RainbowMemory = Rainbow,
    gem: GemMemory = Gem,
    relit: RelitMemory = Relit,
}

impl PageStates {
    /// A second light that was chosen stands beside the light in prism and rainbow too; where it is
    /// let go of, what stood there at first.
    pub fn follow_second(&mut self, is_there: bool) {
        let usual = Self::default();
        let both = [
            (&mut self.prism.beside, usual.prism.beside),
            (&mut self.rainbow.beside, usual.rainbow.beside),
        ];
        for (beside, usual) in both {
            match (is_there, *beside) {
                (true, _) => *beside = Beside::Overlaid,
                (false, Beside::Overlaid) => *beside = usual,
                (false, _) => {}
            }
        }
    }
}
