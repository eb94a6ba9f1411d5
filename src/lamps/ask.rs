//! Requests to an encoder.

use super::{
    columns::LEADING,
    encoding::MOST_LABELLED,
    known::{ALIKE, LIKES},
};

/// Fewest smooth numbers beside a label: three carry the colour.
pub(super) const LEAST_LABELLED: usize = 4;

/// Fewest and most numbers of an encoding.
pub const NUMBERS: [usize; 2] = [LEADING, MOST_LABELLED + 1];

/// Counting rule for numbers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Count {
    /// 32-bit words: a known lamp's index is in the label, a line's place and width share a word.
    #[default]
    Words,
    /// Index and width are numbers of their own.
    Strict,
}

/// A request to an encoder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ask {
    /// Most numbers.
    pub numbers: usize,
    /// Their counting rule.
    pub count: Count,
    /// True if known lamps may be used: decoding then needs the program's list.
    pub known_lamps: bool,
    /// Known lamps left out for being the light itself.
    pub leave_out: LeaveOut,
}

/// Known lamps left out for being too similar to the light at hand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum LeaveOut {
    /// None: what the program does for a person.
    #[default]
    None,
    /// Those whose cosine with the light exceeds 0.9999 (LINES.md section 2).
    Itself,
    /// Those whose cosine exceeds 0.9995, the rule by which principal components are trained
    /// without a light's likes: a lamp's 5 nm table is left out with its 1 nm table.
    Likes,
}

impl LeaveOut {
    /// Largest cosine that may stay.
    pub(super) fn most(self) -> f64 {
        match self {
            Self::None => f64::INFINITY,
            Self::Itself => ALIKE,
            Self::Likes => LIKES,
        }
    }
}

impl Ask {
    /// So many words, known lamps allowed.
    pub const fn numbers(numbers: usize) -> Self {
        Self {
            numbers,
            count: Count::Words,
            known_lamps: true,
            leave_out: LeaveOut::None,
        }
    }

    /// Without known lamps: whoever has the formula can decode it.
    pub const fn portable(self) -> Self {
        Self {
            known_lamps: false,
            ..self
        }
    }

    /// Without the known lamps that are the light itself.
    pub const fn in_comparison(self) -> Self {
        Self {
            leave_out: LeaveOut::Itself,
            ..self
        }
    }

    /// Numbers that so many known lamps and lines leave for the smooth part.
    pub(super) fn smooth(self, atoms: usize, lines: usize) -> Option<usize> {
        let (atom, line) = match self.count {
            Count::Words => (1, 2),
            Count::Strict => (2, 3),
        };
        let left = self.numbers.checked_sub(1 + atom * atoms + line * lines)?;
        (left >= LEAST_LABELLED).then_some(left.min(MOST_LABELLED))
    }
}
