//! What a race gave: every error of every light, its spreads, and the cells that are won.

use super::{
    ask::{Count, LeaveOut},
    judge::Errors,
};
use crate::{rivals::Family, study::Spread};

/// Who is in this race.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Entrant {
    /// Known lamps, cosines and lines of their own width.
    KnownLamps,
    /// Cosines and lines of their own width.
    WideLines,
    /// The best of today's eight ways, chosen a light on the panel that chooses.
    Today,
    /// Another representation.
    Peer(Family),
}

impl Entrant {
    /// Everybody, ours first.
    pub const ALL: [Self; 9] = [
        Self::KnownLamps,
        Self::WideLines,
        Self::Today,
        Self::Peer(Family::Samples),
        Self::Peer(Family::Bins),
        Self::Peer(Family::Legendre),
        Self::Peer(Family::Principal),
        Self::Peer(Family::Moments),
        Self::Peer(Family::Wavelet),
    ];

    /// The word used in files: the key of `representation`.
    pub fn word(self) -> &'static str {
        match self {
            Self::KnownLamps => "known-lamps",
            Self::WideLines => "wide-lines",
            Self::Today => "chosen",
            Self::Peer(family) => family.about().word,
        }
    }

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::KnownLamps => "Known lamps + lines",
            Self::WideLines => "Wide lines",
            Self::Today => "Best composite, chosen per light",
            Self::Peer(family) => family.about().title,
        }
    }

    /// Whether its numbers mean nothing without a table that is not counted among them.
    pub fn needs_table(self) -> bool {
        match self {
            Self::KnownLamps => true,
            Self::WideLines | Self::Today => false,
            Self::Peer(family) => family.needs_table(),
        }
    }
}

/// One of the three errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ErrorKind {
    /// Mean CIEDE2000 of patches, both factors approximated.
    Patches,
    /// Mean CIEDE2000 behind 10 nm band-passes.
    Filters,
    /// Relative RMS behind a 10 nm blur.
    Blurred,
}

impl ErrorKind {
    /// All three.
    pub const ALL: [Self; 3] = [Self::Patches, Self::Filters, Self::Blurred];

    /// The key used in files.
    pub fn word(self) -> &'static str {
        match self {
            Self::Patches => "patches_check",
            Self::Filters => "filters",
            Self::Blurred => "relative_rms_10nm",
        }
    }

    /// The error.
    pub fn of(self, errors: Errors) -> f64 {
        match self {
            Self::Patches => errors.patches,
            Self::Filters => errors.filters,
            Self::Blurred => errors.blurred,
        }
    }
}

/// Figures of a spread that are compared.
pub const FIGURES: [&str; 3] = ["median", "p95", "worst"];

/// The figures of a spread in that order.
pub fn figures(spread: Spread) -> [f64; 3] {
    [spread.median, spread.p95, spread.worst]
}

/// A cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The class.
    pub class: String,
    /// The count of numbers.
    pub numbers: usize,
    /// The error.
    pub error: ErrorKind,
    /// The figure of its spread.
    pub figure: &'static str,
    /// Ours and the peer's.
    pub values: [f64; 2],
}

/// Cells won against a peer.
#[derive(Clone, Debug, PartialEq)]
pub struct Wins {
    /// The peer.
    pub against: Entrant,
    /// Cells in all.
    pub of: usize,
    /// Cells that are not won.
    pub behind: Vec<Cell>,
}

impl Wins {
    /// Cells won.
    pub fn won(&self) -> usize {
        self.of - self.behind.len()
    }

    /// Per cent of the cells won; nothing without a cell.
    pub fn per_cent(&self) -> Option<f64> {
        (self.of > 0).then(|| 100.0 * self.won() as f64 / self.of as f64)
    }
}

/// Every error of every light.
#[derive(Clone, Debug, PartialEq)]
pub struct Standing {
    /// Names and classes of the lights that have a colour.
    pub lamps: Vec<(String, String)>,
    /// Counts of numbers.
    pub budgets: Vec<usize>,
    /// How numbers were counted.
    pub count: Count,
    /// Which known lamps were left out.
    pub leave_out: LeaveOut,
    /// By light, then count, then entrant in the order of [`Entrant::ALL`]; `None` where an entrant
    /// has no result.
    pub(super) errors: Vec<Option<Errors>>,
}

impl Standing {
    /// The error of a light at a count, by their places.
    pub fn errors(&self, lamp: usize, budget: usize, entrant: Entrant) -> Option<Errors> {
        let place = Entrant::ALL.iter().position(|e| *e == entrant)?;
        let row = (lamp * self.budgets.len() + budget) * Entrant::ALL.len();
        *self.errors.get(row + place)?
    }

    /// The classes in the order of their first light.
    pub fn classes(&self) -> Vec<&str> {
        let mut classes: Vec<&str> = Vec::new();
        for (_, class) in &self.lamps {
            if !classes.contains(&class.as_str()) {
                classes.push(class);
            }
        }
        classes
    }

    /// The spread of an error over a class.
    pub fn spread(
        &self,
        class: &str,
        budget: usize,
        entrant: Entrant,
        error: ErrorKind,
    ) -> Option<Spread> {
        let lamps = (0..self.lamps.len()).filter(|i| self.lamps[*i].1 == class);
        let values: Vec<f64> = lamps
            .filter_map(|lamp| self.errors(lamp, budget, entrant))
            .map(|errors| error.of(errors))
            .collect();
        Spread::of(&values)
    }

    /// Cells that an entrant wins against another.
    pub fn wins(&self, entrant: Entrant, against: Entrant) -> Wins {
        let mut wins = Wins {
            against,
            of: 0,
            behind: Vec::new(),
        };
        for class in self.classes() {
            for (budget, numbers) in self.budgets.iter().enumerate() {
                for error in ErrorKind::ALL {
                    let spread = |entrant| self.spread(class, budget, entrant, error);
                    let (Some(ours), Some(theirs)) = (spread(entrant), spread(against)) else {
                        continue;
                    };
                    let pairs = figures(ours).into_iter().zip(figures(theirs));
                    for (figure, (ours, theirs)) in FIGURES.into_iter().zip(pairs) {
                        wins.of += 1;
                        if ours >= theirs {
                            wins.behind.push(Cell {
                                class: class.to_owned(),
                                numbers: *numbers,
                                error,
                                figure,
                                values: [ours, theirs],
                            });
                        }
                    }
                }
            }
        }
        wins
    }
}
