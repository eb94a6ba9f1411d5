//! What each page remembers beside the document; not part of undo.

use std::path::PathBuf;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use serde_json::Value;

use super::{Page, Place};
use crate::{
    app::{
        charts::quality::{DiagramShows, OfColours},
        design::{DeskSurfaces, colour::FromColour, mix::Snapshot, wish::MixWish},
        dispersion::DispersionMemory,
        picture::ImageMemory,
        products::ProductsMemory,
        relit::RelitMemory,
        verdicts::HARD_TO_SEE,
    },
    lamps::NUMBERS,
    spectrum::{Basis, PerBasis},
    study::{Goal, Measure},
};

/// What the pages remember; not part of undo.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PageMemory {
    /// The page shown.
    pub page: Page,
    /// The pages that were shown last, one a place: the rail leads back to them.
    pub last_of_places: Vec<Page>,
    /// Coefficients: the partial sum's order.
    pub partial_order: usize,
    /// Coefficients: which of X, Y, Z the bars are of.
    pub channel: usize,
    /// Trade-off: the figure on the vertical axis.
    pub measure: Measure,
    /// Trade-off: the lines that are drawn.
    pub ways: WaysShown,
    /// Many lights: which, how good, for how many.
    pub many: ManyMemory,
    /// Auction: what is to be made small.
    pub goal: Goal,
    /// Auction: most numbers.
    pub auction_numbers: usize,
    /// "Spend ... numbers for me".
    pub spend_numbers: usize,
    /// What is then made small; `None` for the goal of the auction's page.
    pub spend_goal: Option<Goal>,
    /// Race: who races.
    pub field: FieldChoice,
    /// Race: the count of numbers that the table shows.
    pub race_numbers: usize,
    /// Race: the figure that decides.
    pub race_measure: Measure,
    /// Race: whether known lamps and widths of lines are counted as numbers of their own.
    pub race_strict: bool,
    /// Known lamps: what the light is made of.
    pub words: WordsMemory,
    /// Products: its parts.
    pub products: ProductsMemory,
    /// Chromaticity: what the diagram shows.
    pub diagram: DiagramShows,
    /// Colours under it: the large chart.
    pub of_colours: OfColours,
    /// Design: desks that were kept, A, B and C.
    pub kept: [Option<Snapshot>; 3],
    /// Design: which surfaces stand under the mixture.
    pub desk_surfaces: DeskSurfaces,
    /// Design: what is wished of the mixture.
    pub wish: MixWish,
    /// Design: the colour that spectra are made from.
    pub colour: FromColour,
    /// Image: which one, which pixels, and how it is drawn.
    pub image: ImageMemory,
    /// Prism, rainbow and gem.
    pub dispersion: DispersionMemory,
    /// In few numbers, relit: which picture, how many numbers, which lights.
    pub relit: RelitMemory,
    /// Lessons: names of those that were gone through.
    pub lessons_finished: Vec<String>,
    /// Lessons: the code of the language that they are shown in, where they have texts in it.
    pub lesson_language: String,
    /// A photograph of a spectrum that is to be read, once.
    #[serde(skip)]
    pub photograph_asked: Option<PathBuf>,
    /// A lesson that is to be begun, once.
    #[serde(skip)]
    pub lesson_asked: Option<AskedLesson>,
}

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

impl Default for PageMemory {
    fn default() -> Self {
        Self {
            page: Page::Spectrum,
            last_of_places: Vec::new(),
            partial_order: 3,
            channel: 1,
            measure: Measure::Patches,
            ways: WaysShown::default(),
            many: ManyMemory::default(),
            goal: Goal::PATCHES,
            auction_numbers: 41,
            spend_numbers: 21,
            spend_goal: Some(Goal::PATCHES),
            field: FieldChoice::ThisLight,
            race_numbers: 20,
            race_measure: Measure::Patches,
            race_strict: false,
            words: WordsMemory::default(),
            products: ProductsMemory::default(),
            diagram: DiagramShows::default(),
            of_colours: OfColours::default(),
            kept: [None, None, None],
            desk_surfaces: DeskSurfaces::default(),
            wish: MixWish::default(),
            colour: FromColour::default(),
            image: ImageMemory::default(),
            dispersion: DispersionMemory::default(),
            relit: RelitMemory::default(),
            lessons_finished: Vec::new(),
            lesson_language: "en".to_owned(),
            photograph_asked: None,
            lesson_asked: None,
        }
    }
}

/// Counts of numbers that may be spent.
pub const SPENDABLE: std::ops::RangeInclusive<usize> = 1..=101;

/// Counts of numbers that the race is run at.
pub const RACE_BUDGETS: [usize; 7] = [8, 11, 15, 20, 25, 31, 41];

impl PageMemory {
    /// Remembers the page that is shown as the last of its place.
    pub fn note_page(&mut self) {
        let page = self.page;
        if !self.last_of_places.contains(&page) {
            self.last_of_places
                .retain(|other| other.place() != page.place());
            self.last_of_places.push(page);
        }
    }

    /// Goes to the page of a place that was shown last.
    pub fn go_to(&mut self, place: Place) {
        self.note_page();
        let mut last = self.last_of_places.iter();
        let last = last.find(|page| page.place() == place).copied();
        self.page = last.unwrap_or_else(|| place.first());
    }

    /// Goes to the page "From a colour" with a screen's colour.
    pub fn ask_about_colour(&mut self, rgb: [u8; 3]) {
        self.colour = self.colour.clone().about(rgb);
        self.page = Page::FromColour;
    }

    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        let spendable = |n: usize| n.clamp(*SPENDABLE.start(), *SPENDABLE.end());
        let nearest = RACE_BUDGETS
            .into_iter()
            .min_by_key(|budget| budget.abs_diff(self.race_numbers));
        Self {
            last_of_places: one_a_place(self.last_of_places),
            partial_order: self.partial_order.min(100),
            channel: self.channel.min(2),
            ways: self.ways.clamped(),
            many: self.many.clamped(),
            goal: self.goal.clamped(),
            spend_goal: self.spend_goal.map(Goal::clamped),
            auction_numbers: spendable(self.auction_numbers),
            spend_numbers: spendable(self.spend_numbers),
            race_numbers: nearest.unwrap_or(20),
            race_measure: match self.race_measure {
                // The table has no column for it.
                Measure::PatchesWorst => Measure::Patches,
                measure => measure,
            },
            words: WordsMemory {
                numbers: self.words.numbers.clamp(NUMBERS[0], NUMBERS[1]),
                ..self.words
            },
            products: self.products.clamped(),
            kept: self.kept.map(|kept| kept.map(Snapshot::clamped)),
            wish: self.wish.clamped(),
            colour: self.colour.clamped(),
            image: self.image.clamped(),
            dispersion: self.dispersion.clamped(),
            relit: self.relit.clamped(),
            ..self
        }
    }
}

/// The last page of each place.
fn one_a_place(pages: Vec<Page>) -> Vec<Page> {
    let mut all = PageMemory::default();
    for page in pages {
        all.page = page;
        all.note_page();
    }
    all.last_of_places
}

/// What is asked of many lights.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ManyMemory {
    /// Which lights.
    pub field: FieldChoice,
    /// The figure that has a limit.
    pub measure: Measure,
    /// What it may be at most, in its unit on screen: ΔE₀₀ or percent.
    pub limit: f64,
    /// For how many of the lights, percent.
    pub share_percent: u8,
}

/// Limits that may be set, ΔE₀₀ or percent.
pub const LIMITS: std::ops::RangeInclusive<f64> = 0.01..=100.0;

/// Shares of many lights that may be asked for, percent.
pub const SHARES_PERCENT: std::ops::RangeInclusive<u8> = 1..=100;

impl Default for ManyMemory {
    fn default() -> Self {
        Self {
            field: FieldChoice::Shipped,
            measure: Measure::Patches,
            limit: Self::usual_limit(Measure::Patches),
            share_percent: 95,
        }
    }
}

impl ManyMemory {
    /// A limit worth beginning with: the difference is hard to see, or 5 % of a spectrum.
    pub fn usual_limit(measure: Measure) -> f64 {
        if measure.is_colour() {
            HARD_TO_SEE
        } else {
            5.0
        }
    }

    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        let (least, most) = (*LIMITS.start(), *LIMITS.end());
        let (fewest, all) = (*SHARES_PERCENT.start(), *SHARES_PERCENT.end());
        Self {
            limit: match self.limit.is_finite() {
                true => self.limit.clamp(least, most),
                false => Self::usual_limit(self.measure),
            },
            share_percent: self.share_percent.clamp(fewest, all),
            ..self
        }
    }
}

/// How a light is put into few words.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct WordsMemory {
    /// Most numbers.
    pub numbers: usize,
    /// Without known lamps: whoever has the formula can decode the words.
    pub portable: bool,
    /// Whether a shipped lamp may be said to be itself.
    pub itself: bool,
    /// Whether Automatic may use known lamps.
    pub automatic: bool,
}

impl Default for WordsMemory {
    fn default() -> Self {
        Self {
            numbers: 20,
            portable: false,
            itself: false,
            automatic: false,
        }
    }
}

/// Which ways are drawn: a way is when all three of its choices are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct WaysShown {
    /// The bases; in files each by its word.
    #[serde(flatten, serialize_with = "by_word", deserialize_with = "of_words")]
    pub bases: PerBasis<bool>,
    /// Models without spikes.
    pub without_spikes: bool,
    /// Models with spikes.
    pub with_spikes: bool,
    /// Plain least squares.
    pub plain: bool,
    /// The colour-exact fit.
    pub colour_exact: bool,
}

fn by_word<S: Serializer>(bases: &PerBasis<bool>, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(Basis::ALL.map(|basis| (basis.word(), bases[basis])))
}

/// One that is not said is shown.
///
/// # Errors
/// A basis with anything but true or false.
fn of_words<'de, D: Deserializer<'de>>(deserializer: D) -> Result<PerBasis<bool>, D::Error> {
    let said = serde_json::Map::<String, Value>::deserialize(deserializer)?;
    for basis in Basis::ALL {
        if let Some(other) = said.get(basis.word()).filter(|value| !value.is_boolean()) {
            let word = basis.word();
            return Err(D::Error::custom(format!(
                "found {other} for {word}, expected true or false"
            )));
        }
    }
    let is_shown = |basis: Basis| said.get(basis.word()).and_then(Value::as_bool);
    Ok(PerBasis::of(|basis| is_shown(basis).unwrap_or(true)))
}

impl Default for WaysShown {
    fn default() -> Self {
        Self {
            bases: PerBasis::of(|_| true),
            without_spikes: true,
            with_spikes: true,
            plain: true,
            colour_exact: true,
        }
    }
}

impl WaysShown {
    /// The same with all of a choice where none was chosen: there is always something drawn.
    #[must_use]
    pub fn clamped(self) -> Self {
        let both = |a: bool, b: bool| if a || b { (a, b) } else { (true, true) };
        let none = Basis::ALL.iter().all(|basis| !self.bases[*basis]);
        let bases = PerBasis::of(|basis| none || self.bases[basis]);
        let (without_spikes, with_spikes) = both(self.without_spikes, self.with_spikes);
        let (plain, colour_exact) = both(self.plain, self.colour_exact);
        Self {
            bases,
            without_spikes,
            with_spikes,
            plain,
            colour_exact,
        }
    }
}

/// Who races, as a choice that outlives the document.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FieldChoice {
    /// The document's light.
    #[default]
    ThisLight,
    /// Every shipped light.
    Shipped,
    /// The shipped smooth lights: standard lights, sun and sky.
    Smooth,
    /// The shipped LED lights.
    Led,
    /// The shipped fluorescent lamps.
    Fluorescent,
    /// The shipped discharge lamps.
    Discharge,
    /// The user's own lights.
    Own,
}

impl FieldChoice {
    /// Every choice, in the order of the menu.
    pub const ALL: [Self; 7] = [
        Self::ThisLight,
        Self::Shipped,
        Self::Smooth,
        Self::Led,
        Self::Fluorescent,
        Self::Discharge,
        Self::Own,
    ];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::ThisLight => "this light",
            Self::Shipped => "all shipped lights",
            Self::Smooth => "smooth lights",
            Self::Led => "LED",
            Self::Fluorescent => "fluorescent",
            Self::Discharge => "discharge",
            Self::Own => "my lights",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_page_remembers_is_always_something_it_can_show() {
        let nonsense = PageMemory {
            partial_order: usize::MAX,
            channel: 7,
            goal: Goal {
                own: f64::NAN,
                patches: -1.0,
                ..Goal::OWN
            },
            auction_numbers: 0,
            spend_numbers: 100_000,
            race_numbers: 21,
            words: WordsMemory {
                numbers: 0,
                ..WordsMemory::default()
            },
            many: ManyMemory {
                limit: f64::NAN,
                share_percent: 0,
                ..ManyMemory::default()
            },
            ..PageMemory::default()
        };
        let sound = nonsense.clamped();
        assert_eq!((sound.channel, sound.race_numbers), (2, 20));
        assert_eq!((sound.auction_numbers, sound.spend_numbers), (1, 101));
        assert_eq!(sound.words.numbers, 3);
        assert_eq!((sound.many.limit, sound.many.share_percent), (1.0, 1));
        assert_eq!(sound.goal, Goal::PATCHES);
        let usual = PageMemory::default();
        assert_eq!(usual.clone().clamped(), usual);
        assert!(RACE_BUDGETS.is_sorted());
    }
}
