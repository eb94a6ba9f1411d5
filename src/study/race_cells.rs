//! The cells of a race: in how many of them one representation is ahead of another.
//!
//! A cell is a class of lights, a count of numbers, an error (patches, filters, blurred spectrum,
//! each on what took no part in any choice) and a figure of its spread (median, 95th percentile,
//! worst). One light alone has one figure, which counts once.

use super::{
    error::Spread,
    measure::Measure,
    race_result::{Race, Racer, Run},
};

/// One of the three errors that cells are of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Judged {
    /// Mean CIEDE2000 of the check reflectances, both factors approximated.
    Patches,
    /// Mean CIEDE2000 behind 10 nm band-passes at 425, 435 ... 675 nm.
    Filters,
    /// Relative RMS behind a 10 nm blur.
    Blurred,
}

impl Judged {
    /// All three.
    pub(crate) const ALL: [Self; 3] = [Self::Patches, Self::Filters, Self::Blurred];

    /// The key used in files.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Patches => "patches_check",
            Self::Filters => "filters",
            Self::Blurred => "relative_rms_10nm",
        }
    }

    fn of(self, run: &Run) -> Option<f64> {
        match self {
            Self::Patches => run.check,
            Self::Filters => run.check_filters,
            Self::Blurred => run.verdict[Measure::RmsBlurred],
        }
    }
}

/// Figures of a spread that are compared.
pub(crate) const FIGURES: [&str; 3] = ["median", "p95", "worst"];

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
    pub error: Judged,
    /// The figure of its spread.
    pub figure: &'static str,
    /// Ours and the peer's.
    pub values: [f64; 2],
}

/// Cells won against a peer.
#[derive(Clone, Debug, PartialEq)]
pub struct Wins {
    /// The peer.
    pub against: Racer,
    /// Cells in all.
    pub of: usize,
    /// Cells that are not won.
    pub behind: Vec<Cell>,
}

impl Wins {
    /// Cells won.
    pub(crate) fn won(&self) -> usize {
        self.of - self.behind.len()
    }

    /// Per cent of the cells won; nothing without a cell.
    pub(crate) fn per_cent(&self) -> Option<f64> {
        (self.of > 0).then(|| 100.0 * self.won() as f64 / self.of as f64)
    }
}

impl Race {
    /// The spread of a judged error over a class (or all) at a count, by place; nothing of who does
    /// not race.
    pub fn judged(
        &self,
        class: Option<&str>,
        budget: usize,
        racer: Racer,
        error: Judged,
    ) -> Option<Spread> {
        let racer = self.racers.iter().position(|r| *r == racer)?;
        let of = |lamp: usize| error.of(self.run(lamp, budget, racer));
        Spread::of(&self.of_class(class).filter_map(of).collect::<Vec<_>>())
    }

    /// Cells that a racer wins against another at these counts.
    pub fn cells(&self, racer: Racer, against: Racer, counts: &[usize]) -> Wins {
        let mut wins = Wins {
            against,
            of: 0,
            behind: Vec::new(),
        };
        let budgets = self.budgets.iter().enumerate();
        let budgets: Vec<_> = budgets.filter(|(_, n)| counts.contains(n)).collect();
        for class in self.classes() {
            let is_alone = self.of_class(Some(class)).count() == 1;
            let figures_of = if is_alone { 1 } else { FIGURES.len() };
            for (budget, numbers) in &budgets {
                for error in Judged::ALL {
                    let spread = |racer| self.judged(Some(class), *budget, racer, error);
                    let (Some(ours), Some(theirs)) = (spread(racer), spread(against)) else {
                        continue;
                    };
                    let pairs = figures(ours).into_iter().zip(figures(theirs));
                    for (figure, (ours, theirs)) in FIGURES.into_iter().zip(pairs).take(figures_of)
                    {
                        wins.of += 1;
                        if ours >= theirs {
                            wins.behind.push(Cell {
                                class: class.to_owned(),
                                numbers: **numbers,
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
