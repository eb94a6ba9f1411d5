//! A claim as a row: what the paper says, what is measured here, what became of it; and how its
//! figures are written.

use crate::{
    app::{
        numbers::{ROUNDING, percent},
        ticks::short,
    },
    spectrum::Band,
};

/// What became of a claim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// It is so here.
    Holds,
    /// It is so here under a condition that the paper does not name.
    OnlyIf,
    /// It is not so here.
    Fails,
    /// There is nothing to measure here.
    Open,
}

impl Verdict {
    /// The verdict in words; a condition follows `OnlyIf` and `Open`.
    pub fn words(self) -> &'static str {
        match self {
            Self::Holds => said!("holds"),
            Self::OnlyIf => said!("holds only"),
            Self::Fails => said!("does not hold"),
            Self::Open => said!("nothing to measure"),
        }
    }

    /// A sign of its own, so that colour never says it alone.
    pub fn sign(self) -> &'static str {
        match self {
            Self::Holds => "✔",
            Self::OnlyIf => "◐",
            Self::Fails => "✘",
            Self::Open => "○",
        }
    }
}

/// A claim, what the paper says, what is measured here, and what became of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The claim in a few words.
    pub claim: &'static str,
    /// Where the paper makes it.
    pub place: &'static str,
    /// What the paper says.
    pub paper: String,
    /// What is measured on this spectrum and range, a sentence or more.
    pub measured: String,
    /// What became of it.
    pub verdict: Verdict,
    /// Under which condition, or why; may be empty.
    pub condition: String,
}

impl Row {
    /// The verdict with its condition.
    pub fn verdict_words(&self) -> String {
        match (self.verdict, self.condition.is_empty()) {
            (verdict, true) => verdict.words().to_owned(),
            (Verdict::OnlyIf, false) => tr!("holds only {condition}", condition = self.condition),
            (verdict, false) => format!("{}: {}", verdict.words(), self.condition),
        }
    }
}

/// What is missing of a total as how far a sum is off it: in percent, with a sign.
pub fn off_percent(missing: f64) -> String {
    let words = percent(-missing);
    if missing < -ROUNDING {
        format!("+{words}")
    } else {
        words
    }
}

/// Three figures in a row: `0.1, 0.2 and 0.3`.
pub fn three(words: [String; 3]) -> String {
    let [x, y, z] = words;
    tr!("{x}, {y} and {z}", x, y, z)
}

pub(super) fn range(band: Band) -> String {
    format!("{}-{} nm", short(band.min_nm()), short(band.max_nm()))
}
