//! What the page "In few numbers, relit" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::pictures::{BOUND_P95, FixedSettings, LineChoice, MOST_NUMBERS};

pub(super) const ROW: Row = row(
    Page::Relit,
    Place::Picture,
    (later!("In few numbers, relit"), "relit"),
    "recover",
    later!("A spectral image in few numbers a pixel, and how it looks under any light."),
);

/// What stands large on the page.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Look {
    /// The picture, exact beside few numbers.
    #[default]
    Picture,
    /// The difference of every pixel.
    Difference,
    /// Other ways of keeping it in as many numbers.
    Others,
}

impl Look {
    /// Every choice, in the order of the page.
    pub const ALL: [Self; 3] = [Self::Picture, Self::Difference, Self::Others];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Picture => said!("Picture"),
            Self::Difference => said!("Difference"),
            Self::Others => said!("Other ways"),
        }
    }

    /// What it means, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Picture => {
                said!(
                    "Every band left of the line, few numbers right of it. Drag the line; click a \
                 pixel to see its spectrum."
                )
            }
            Self::Difference => {
                said!(
                    "How far each pixel's colour in few numbers is from that of every band (ΔE₀₀)."
                )
            }
            Self::Others => {
                said!(
                    "The same picture in as many numbers kept in other ways, measured here and now."
                )
            }
        }
    }
}

/// Most lines that are chosen by hand.
pub const MOST_LINES: usize = 12;
/// Where lines are, nm.
pub const LINES_NM: Reach = Reach::Within(100.0, 1e5);

/// Picture, numbers, lights and looks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RelitMemory {
    /// The wall of paints although an image is open.
    pub wall: bool,
    /// Key of the light that fell on the picture when it was taken; `None` where it holds
    /// reflectances, or nobody knows.
    pub taken_under: Option<String>,
    /// Key of a reflectance's own light, under which its colours are exact; `None` for daylight.
    pub own: Option<String>,
    /// Numbers a pixel; `None` for the fewest that are enough.
    pub numbers: Option<usize>,
    /// What is enough: 95 % of the differences (ΔE₀₀) are within.
    pub bound: f64,
    /// What multiplies the series, and which lines there are.
    pub wish: FixedSettings,
    /// Whether a reflectance's numbers are weighed by the colours under many lights.
    pub weighted: bool,
    /// Whether the series itself stands between bands, not a straight line.
    pub between_series: bool,
    /// Key of the light that shines on it; `None` for the document's.
    pub under: Option<String>,
    /// Key of a second light that shines beside it.
    pub second: Option<String>,
    /// How much of the brightness is the second light's, percent.
    pub second_percent: u32,
    /// What stands large.
    pub look: Look,
    /// Where the line between both halves is, 0-1.
    pub split: f32,
    /// The pixel whose spectrum is shown, among the drawn ones; `None` for the worst.
    pub pixel: Option<[usize; 2]>,
}

impl Default for RelitMemory {
    fn default() -> Self {
        Self {
            wall: false,
            taken_under: None,
            own: None,
            numbers: None,
            bound: BOUND_P95,
            wish: FixedSettings::default(),
            weighted: true,
            between_series: false,
            under: None,
            second: None,
            second_percent: 50,
            look: Look::Picture,
            split: 0.5,
            pixel: None,
        }
    }
}

impl RelitMemory {
    pub const BOUND: Knob<Self> = knob!(bound: later!("Enough"),
        Reach::Within(0.05, 5.0), 2 " \u{394}E₀₀",
        later!("95 % of the differences are within it."));
}

impl PageState for RelitMemory {
    const KNOBS: &'static [Knob<Self>] = &[
        Self::BOUND,
        knob!(second_percent: later!(
            "Share of the second light"
        ), Reach::Within(0.0, 100.0), 0 " %",
            later!("Share of the brightness that is the second light's.")),
        knob!(split: later!("Line between the halves"), Reach::Within(0.0, 1.0), 2 "",
            later!("Every band left of it, few numbers right of it.")),
    ];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("wall", later!("the picture")),
        ("taken_under", later!("the light of the picture")),
        ("own", later!("the surfaces' own light")),
        ("numbers", later!("numbers a pixel")),
        ("wish", later!("what is kept of it")),
        ("weighted", later!("what the numbers are weighed by")),
        ("between_series", later!("what stands between bands")),
        ("under", later!("the light on the picture")),
        ("second", later!("the second light")),
        ("look", later!("what stands large")),
        ("pixel", later!("the pixel chosen")),
    ];

    fn settle(&mut self) {
        if let LineChoice::At(places) = &mut self.wish.lines {
            places.retain(|nm| LINES_NM.range().contains(nm));
            places.truncate(MOST_LINES);
        }
        self.numbers = self.numbers.map(|n| n.clamp(3, MOST_NUMBERS));
    }
}

#[cfg(test)]
mod tests {
    use super::{super::states::in_reach, *};

    #[test]
    fn what_is_remembered_is_always_something_that_can_be_shown() {
        let nonsense = RelitMemory {
            numbers: Some(usize::MAX),
            second_percent: 400,
            split: f32::NAN,
            bound: f64::NAN,
            wish: FixedSettings {
                lines: LineChoice::At(vec![f64::NAN, 546.1, -3.0]),
                ..FixedSettings::default()
            },
            ..RelitMemory::default()
        };
        let sound = in_reach(nonsense);
        assert_eq!(sound.numbers, Some(MOST_NUMBERS));
        assert_eq!((sound.second_percent, sound.split), (100, 0.5));
        assert_eq!(sound.bound, BOUND_P95);
        assert_eq!(sound.wish.lines, LineChoice::At(vec![546.1]));
        let usual = RelitMemory::default();
        assert_eq!(in_reach(usual.clone()), usual);
    }
}
