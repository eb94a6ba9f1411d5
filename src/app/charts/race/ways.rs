//! Known lamps and lines of their own width beside the other representations: errors on what took
//! no part in any choice, and the cells that are won.

use super::RaceCell;
use crate::{
    app::{numbers, race_report::in_cells, studies::RaceAsk},
    languages::{Language, fixed, said, spoken},
    study::{
        Race, Spread,
        race::{Judged, Racer, figures},
    },
};

/// The counts of numbers of this race.
pub const CELLS_AT: [usize; 4] = [11, 20, 31, 41];

/// The new ways.
const OURS: [Racer; 2] = [Racer::KnownLamps, Racer::WideLines];

/// One representation at one count.
pub struct WaysRow {
    pub racer: Racer,
    /// Patches, filters and blurred spectrum, in the order of `Judged::ALL`.
    pub errors: [RaceCell; 3],
    /// Per cent of the cells that known lamps, then wide lines win against it.
    pub won: [String; 2],
}

/// A way with the others, the cells that it won from each and the cells that there are.
type Won = (Racer, Vec<(Racer, usize, usize)>);

/// What the race of the new ways says.
pub struct Ways {
    /// The result in a sentence.
    pub sentence: String,
    /// What a cell is, and how numbers were counted.
    pub how: String,
    /// For each of the new ways its word, and for each other representation its word, the cells won
    /// and all cells.
    counts: Vec<Won>,
}

/// Per cent with one decimal; what is not all is 99.9 at most.
fn per_cent(won: usize, of: usize) -> String {
    if won == of && of > 0 {
        return "100 %".to_owned();
    }
    (1000 * won + of / 2).checked_div(of).map_or_else(
        || "–".to_owned(),
        |tenths| format!("{} %", fixed(tenths.min(999) as f64 / 10.0, 1)),
    )
}

/// How the cells are counted, for so many lights and at these counts.
fn how(lights: usize, counts: &str, is_strict: bool) -> String {
    let cell = match lights {
        1 => tr!(
            "A cell is an error, and a count of numbers ({counts}).",
            counts
        ),
        _ => tr!(
            "A cell is an error, its median, 95th percentile or worst, a class of lights and a \
             count of numbers ({counts}).",
            counts
        ),
    };
    let one = match is_strict {
        true => {
            said!("Strictly counted: a line takes three numbers, a known lamp two, the label one.")
        }
        false => said!(
            "Numbers are words of 32 bits: a line takes two, a known lamp one, the label one."
        ),
    };
    let judge = said!(
        "No table holds the light at hand or its likes; the 99 samples of TM-30 and filters \
         between those of the choice judge."
    );
    format!("{cell} {one} {judge}")
}

impl Ways {
    /// Of a race, its cells at these counts; nothing where the new ways do not race.
    pub fn of(ask: &RaceAsk, race: &Race, counts: &[usize]) -> Option<Self> {
        let judged = ask.judged_counts();
        let judged = || counts.iter().copied().filter(|n| judged.contains(n));
        let counts: Vec<usize> = judged().collect();
        if counts.is_empty() || !race.racers.contains(&Racer::KnownLamps) {
            return None;
        }
        let others: Vec<Racer> = in_cells(race)
            .into_iter()
            .filter(|racer| !OURS.contains(racer))
            .collect();
        let won: Vec<Won> = OURS
            .into_iter()
            .map(|ours| {
                let count = |peer: &Racer| {
                    let wins = race.cells(ours, *peer, &counts);
                    (*peer, wins.won(), wins.of)
                };
                (ours, others.iter().map(count).collect())
            })
            .collect();
        let budgets: Vec<String> = counts.iter().map(usize::to_string).collect();
        Some(Self {
            sentence: sentence(race, &won),
            how: how(race.lamps.len(), &budgets.join(", "), ask.strict),
            counts: won,
        })
    }

    /// The cells won as lines for a table's head.
    pub fn notes(&self) -> Vec<String> {
        let line = |(ours, counts): &Won| {
            let against = counts
                .iter()
                .map(|(peer, won, of)| format!("{won} of {of} against {}", peer.word()));
            let against: Vec<String> = against.collect();
            format!("cells won by {}: {}", ours.word(), against.join(", "))
        };
        let lines = self.counts.iter().map(line);
        lines.chain([self.sentence.clone()]).collect()
    }

    /// The rows of a class (or all) at a count.
    pub fn rows(&self, race: &Race, class: Option<&str>, budget: usize) -> Vec<WaysRow> {
        let racers = in_cells(race);
        let mut rows: Vec<WaysRow> = racers
            .iter()
            .map(|racer| WaysRow {
                racer: *racer,
                errors: Judged::ALL
                    .map(|error| cell(race.judged(class, budget, *racer, error), error)),
                won: std::array::from_fn(|i| {
                    let counts = &self.counts[i].1;
                    let against = counts.iter().find(|(peer, ..)| peer == racer);
                    against.map_or_else(String::new, |(_, won, of)| per_cent(*won, *of))
                }),
            })
            .collect();
        for (i, error) in Judged::ALL.into_iter().enumerate() {
            let median = |racer| race.judged(class, budget, racer, error).map(|s| s.median);
            let least = racers.iter().copied().filter_map(median);
            let least = least.fold(f64::INFINITY, f64::min);
            for row in &mut rows {
                row.errors[i].wins = median(row.racer) == Some(least);
            }
        }
        rows
    }
}

fn cell(spread: Option<Spread>, error: Judged) -> RaceCell {
    let factor = if error == Judged::Blurred { 100.0 } else { 1.0 };
    spread.map_or_else(RaceCell::default, |spread| {
        let [median, _, worst] = figures(spread).map(|value| numbers::error(factor * value));
        let mut cell = RaceCell::of_spread(spread, factor);
        if median == worst {
            cell.text = median;
        }
        cell
    })
}

fn sentence(race: &Race, counts: &[Won]) -> String {
    let said = counts.iter().filter_map(|(ours, against)| {
        let peers = || against.iter().filter(|(peer, ..)| *peer != Racer::Chosen);
        let won: usize = peers().map(|(_, won, _)| won).sum();
        let of: usize = peers().map(|(.., of)| of).sum();
        let share = |(_, won, of): &&(Racer, usize, usize)| (1000 * won).checked_div(*of);
        let least = peers()
            .filter(|count| share(count).is_some())
            .min_by_key(share)?;
        let (peer, least_won, least_of) = least;
        let share = per_cent(won, of);
        let least = per_cent(*least_won, *least_of);
        // In the middle of a sentence; only English writes all of it small.
        let peer = match spoken() {
            Language::English => peer.title().to_lowercase(),
            _ => said(peer.title()).to_owned(),
        };
        Some(match (ours, won == of) {
            (Racer::KnownLamps, true) => tr!(
                "known lamps with wide lines are ahead of the other representations in {won} of \
                 {of} cells ({share})",
                won,
                of,
                share
            ),
            (Racer::KnownLamps, false) => tr!(
                "known lamps with wide lines are ahead of the other representations in {won} of \
                 {of} cells ({share}), least against {peer} ({least})",
                won,
                of,
                share,
                peer,
                least
            ),
            (_, true) => tr!(
                "wide lines alone are ahead of the other representations in {won} of {of} cells \
                 ({share})",
                won,
                of,
                share
            ),
            (_, false) => tr!(
                "wide lines alone are ahead of the other representations in {won} of {of} cells \
                 ({share}), least against {peer} ({least})",
                won,
                of,
                share,
                peer,
                least
            ),
        })
    });
    let clauses: Vec<String> = said.collect();
    let clauses = clauses.join("; ");
    match (&race.lamps[..], clauses.is_empty()) {
        ([(name, _)], true) => tr!("On {name} there is nothing to compare.", name),
        ([(name, _)], false) => tr!("On {name}, {clauses}.", name, clauses),
        (lamps, true) => tr!(
            "On {count} lights there is nothing to compare.",
            count = lamps.len()
        ),
        (lamps, false) => tr!(
            "On {count} lights, {clauses}.",
            count = lamps.len(),
            clauses
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            App,
            memo::ByAddress,
            studies::{Field, Question, RaceAsk},
        },
        study::Progress,
    };

    #[test]
    fn each_way_has_a_row_and_the_sentence_counts_the_cells() {
        let app = App::new();
        let light = app.entry("cie_fluorescent_1nm/FL11").expect("shipped");
        let field = Field::One(ByAddress(light));
        let ask = RaceAsk::of(app.document(), field, vec![11, 15, 20]);
        let race = ask.answer(&Progress::default()).expect("a light");
        let ways = Ways::of(&ask, &race, &CELLS_AT).expect("counts in range");
        // Three errors, two counts, six peers; median and worst of one light are one figure.
        assert!(ways.sentence.contains(" of 36 cells"), "{}", ways.sentence);
        assert!(ways.how.starts_with("A cell is an error, and a count"));
        assert!(ways.sentence.starts_with("On FL11, known lamps"));
        assert_eq!(ways.notes().len(), 3);
        let rows = ways.rows(&race, None, 2);
        assert_eq!(rows.len(), 9);
        for i in 0..3 {
            assert!(rows.iter().any(|row| row.errors[i].wins));
        }
        let row = |word: &str| rows.iter().find(|row| row.racer.word() == word);
        assert_eq!(row("known-lamps").expect("ours").won, ["", ""]);
        assert!(row("samples").expect("a peer").won[0].ends_with(" %"));
        assert!(Ways::of(&ask, &race, &[8]).is_none(), "nobody raced at 8");
    }

    #[test]
    fn all_but_one_cell_is_not_hundred_per_cent() {
        assert_eq!(per_cent(211, 216), "97.7 %");
        assert_eq!(per_cent(9996, 10_000), "99.9 %");
        assert_eq!(per_cent(144, 144), "100 %");
        assert_eq!(per_cent(0, 0), "–");
    }
}
