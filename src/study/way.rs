//! The eight ways to make a composite: basis, with or without spikes, plain or colour-exact.

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
    /// All eight, the paper's basis first, plain before colour-exact.
    pub const ALL: [Self; 8] = [
        Self::new(Basis::Fourier, false, false),
        Self::new(Basis::Fourier, true, false),
        Self::new(Basis::Fourier, false, true),
        Self::new(Basis::Fourier, true, true),
        Self::new(Basis::Cosine, false, false),
        Self::new(Basis::Cosine, true, false),
        Self::new(Basis::Cosine, false, true),
        Self::new(Basis::Cosine, true, true),
    ];

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
        match (self.basis, self.spikes, self.colour_exact) {
            (Basis::Fourier, false, false) => "fourier",
            (Basis::Fourier, true, false) => "fourier+spikes",
            (Basis::Fourier, false, true) => "fourier-exact",
            (Basis::Fourier, true, true) => "fourier-exact+spikes",
            (Basis::Cosine, false, false) => "cosine",
            (Basis::Cosine, true, false) => "cosine+spikes",
            (Basis::Cosine, false, true) => "cosine-exact",
            (Basis::Cosine, true, true) => "cosine-exact+spikes",
        }
    }

    /// In words for people.
    pub fn title(self) -> &'static str {
        match (self.basis, self.spikes, self.colour_exact) {
            (Basis::Fourier, false, false) => "Fourier",
            (Basis::Fourier, true, false) => "Fourier + spikes",
            (Basis::Fourier, false, true) => "Fourier, colour-exact",
            (Basis::Fourier, true, true) => "Fourier, colour-exact + spikes",
            (Basis::Cosine, false, false) => "Cosine",
            (Basis::Cosine, true, false) => "Cosine + spikes",
            (Basis::Cosine, false, true) => "Cosine, colour-exact",
            (Basis::Cosine, true, true) => "Cosine, colour-exact + spikes",
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_way_is_there_once_under_its_own_word() {
        let words: BTreeSet<&str> = FitVariant::ALL.iter().map(|w| w.word()).collect();
        let titles: BTreeSet<&str> = FitVariant::ALL.iter().map(|w| w.title()).collect();
        assert_eq!((words.len(), titles.len()), (8, 8));
        for way in FitVariant::ALL {
            assert_eq!(way.word().contains("exact"), way.colour_exact);
            assert_eq!(way.word().contains("spikes"), way.spikes);
            assert!(way.word().starts_with(way.basis.word()));
        }
    }
}
