//! What the page "Trade-off" keeps.

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error as _};
use serde_json::Value;

use super::{Page, Place, Row, row, states::PageState};
use crate::{
    spectrum::{Basis, PerBasis},
    study::Measure,
};

pub(super) const ROW: Row = row(
    Page::Tradeoff,
    Place::Numbers,
    (later!("Trade-off"), "tradeoff"),
    "spend",
    later!("Error against numbers: how few a model needs."),
)
.among_modes(later!("Curve"));

/// The curve's axis and its lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct TradeoffState {
    /// The figure on the vertical axis.
    pub measure: Measure,
    /// Every way has a curve of its own beside the lowest error of all.
    pub every_way: bool,
    /// The ways that are drawn then.
    pub ways: WaysShown,
}

impl TradeoffState {
    /// The ways with a curve of their own; `None` where the lowest error of all stands alone.
    pub fn drawn(self) -> Option<WaysShown> {
        self.every_way.then_some(self.ways)
    }
}

impl Default for TradeoffState {
    fn default() -> Self {
        Self {
            measure: Measure::Patches,
            every_way: false,
            ways: WaysShown::default(),
        }
    }
}

impl PageState for TradeoffState {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("measure", later!("the error on the axis")),
        ("every_way", later!("a curve for every way")),
        ("ways", later!("the ways drawn")),
    ];

    /// All of a choice where none was chosen: there is always something drawn.
    fn settle(&mut self) {
        let WaysShown {
            bases,
            without_spikes,
            with_spikes,
            plain,
            colour_exact,
        } = &mut self.ways;
        if Basis::ALL.iter().all(|basis| !bases[*basis]) {
            *bases = PerBasis::of(|_| true);
        }
        for (a, b) in [(without_spikes, with_spikes), (plain, colour_exact)] {
            if !*a && !*b {
                (*a, *b) = (true, true);
            }
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
