//! The ways to make a composite: basis, with or without spikes, plain or colour-exact.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use crate::spectrum::Basis;

/// Method of fitting a composite, regardless of its cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct FitVariant {
    /// Functions of the smooth part.
    pub basis: Basis,
    /// Lines become spikes.
    pub spikes: bool,
    /// The light's own X, Y, Z are made exact.
    pub colour_exact: bool,
}

impl FitVariant {
    /// Basis by basis, plain before colour-exact, each without spikes and with them.
    pub const ALL: [Self; 4 * Basis::ALL.len()] = {
        let mut all = [Self::new(Basis::ALL[0], false, false); 4 * Basis::ALL.len()];
        let mut place = 0;
        while place < all.len() {
            all[place] = Self::new(Basis::ALL[place / 4], place % 2 == 1, place % 4 > 1);
            place += 1;
        }
        all
    };

    /// From its three choices.
    pub const fn new(basis: Basis, spikes: bool, colour_exact: bool) -> Self {
        Self {
            basis,
            spikes,
            colour_exact,
        }
    }

    /// The word used on the command line and in files: `cosine-exact+spikes`.
    pub fn word(self) -> &'static str {
        static WORDS: LazyLock<Vec<String>> =
            LazyLock::new(|| spelled(|basis| basis.word().to_owned(), "-exact", "+spikes"));
        &WORDS[self.place()]
    }

    /// In words for people.
    pub fn title(self) -> &'static str {
        let titles = match self.basis {
            Basis::Fourier => [
                later!("Fourier"),
                later!("Fourier + lines"),
                later!("Fourier, colour-exact"),
                later!("Fourier, colour-exact + lines"),
            ],
            Basis::Cosine => [
                later!("Cosine"),
                later!("Cosine + lines"),
                later!("Cosine, colour-exact"),
                later!("Cosine, colour-exact + lines"),
            ],
        };
        titles[self.place() % 4]
    }

    /// Its place in [`FitVariant::ALL`].
    fn place(self) -> usize {
        4 * self.basis as usize + 2 * usize::from(self.colour_exact) + usize::from(self.spikes)
    }
}

/// Every way in letters, in the order of [`FitVariant::ALL`].
fn spelled(name: fn(Basis) -> String, exact: &str, spikes: &str) -> Vec<String> {
    let part = |is_there: bool, part| if is_there { part } else { "" };
    let way = |way: FitVariant| {
        let exact = part(way.colour_exact, exact);
        name(way.basis) + exact + part(way.spikes, spikes)
    };
    FitVariant::ALL.map(way).into()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_way_is_there_once_under_its_own_word() {
        let words: BTreeSet<&str> = FitVariant::ALL.iter().map(|w| w.word()).collect();
        let titles: BTreeSet<&str> = FitVariant::ALL.iter().map(|w| w.title()).collect();
        let all = FitVariant::ALL.len();
        assert_eq!((words.len(), titles.len()), (all, all));
        for (place, way) in FitVariant::ALL.into_iter().enumerate() {
            assert_eq!(way.place(), place);
            assert_eq!(way.word().contains("exact"), way.colour_exact);
            assert_eq!(way.word().contains("spikes"), way.spikes);
            assert!(way.word().starts_with(way.basis.word()));
        }
    }
}
