//! What the page "Race" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::study::Measure;

pub(super) const ROW: Row = row(
    Page::Race,
    Place::Numbers,
    (later!("Race"), "race"),
    "samples",
    later!("The composite against other representations, at equal numbers."),
)
.under(Page::Coefficients);

/// Who races, and what decides.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct RaceState {
    /// Who races.
    pub field: FieldChoice,
    /// The count of numbers that the table shows.
    pub numbers: usize,
    /// The figure that decides.
    pub measure: Measure,
    /// Known lamps and widths of lines are counted as numbers of their own.
    pub strict: bool,
}

impl Default for RaceState {
    fn default() -> Self {
        Self {
            field: FieldChoice::ThisLight,
            numbers: 20,
            measure: Measure::Patches,
            strict: false,
        }
    }
}

/// Counts of numbers that the race is run at.
pub const RACE_BUDGETS: [usize; 7] = [8, 11, 15, 20, 25, 31, 41];

impl PageState for RaceState {
    const KNOBS: &'static [Knob<Self>] = &[knob!(numbers: later!("Numbers"),
        Reach::OneOf(&[8.0, 11.0, 15.0, 20.0, 25.0, 31.0, 41.0]), 0 "",
        later!("The count of numbers that every representation may take."))];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("field", later!("who races")),
        ("measure", later!("the error that decides")),
        ("strict", later!("how numbers are counted")),
    ];

    fn settle(&mut self) {
        if self.measure == Measure::PatchesWorst {
            // The table has no column for it.
            self.measure = Measure::Patches;
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
            Self::ThisLight => said!("this light"),
            Self::Shipped => said!("all shipped lights"),
            Self::Smooth => said!("smooth lights"),
            Self::Led => "LED",
            Self::Fluorescent => said!("fluorescent"),
            Self::Discharge => said!("discharge"),
            Self::Own => said!("my lights"),
        }
    }
}
