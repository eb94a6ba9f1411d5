//! Known lamps and lines of their own width beside the other representations: errors on what took
//! no part in any choice, and the cells that are won.

use super::{RaceCell, figure};
use crate::{
    lamps::{Count, Entrant, ErrorKind, Standing, figures},
    study::Spread,
};

/// The counts of numbers of this race.
pub const CELLS_AT: [usize; 4] = [11, 20, 31, 41];

/// The new ways.
const OURS: [Entrant; 2] = [Entrant::KnownLamps, Entrant::WideLines];

/// One representation at one count.
pub struct WaysRow {
    /// Who.
    pub entrant: Entrant,
    /// Patches, filters and blurred spectrum, in the order of [`ErrorKind::ALL`].
    pub errors: [RaceCell; 3],
    /// Per cent of the cells that known lamps, then wide lines win against it.
    pub won: [String; 2],
}

/// A way with the others, the cells that it won from each and the cells that there are.
type Won = (Entrant, Vec<(Entrant, usize, usize)>);

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

/// Whole per cent, rounded down so that 100 means all.
fn per_cent(won: usize, of: usize) -> String {
    (100 * won)
        .checked_div(of)
        .map_or_else(|| "–".to_owned(), |share| format!("{share} %"))
}

impl Ways {
    /// Of a race.
    pub fn of(standing: &Standing) -> Self {
        let others = || Entrant::ALL.into_iter().filter(|e| !OURS.contains(e));
        let counts: Vec<(Entrant, Vec<_>)> = OURS
            .into_iter()
            .map(|ours| {
                let count = |peer| {
                    let wins = standing.wins(ours, peer);
                    (peer, wins.won(), wins.of)
                };
                (ours, others().map(count).collect())
            })
            .collect();
        let budgets: Vec<String> = standing.budgets.iter().map(usize::to_string).collect();
        Self {
            sentence: sentence(standing, &counts),
            how: format!(
                "A cell is an error, its median, 95th percentile or worst, a class of lights and a \
                 count of numbers ({}). {} No table holds the light at hand or its likes; the 99 \
                 samples of TM-30 and filters between those of the choice judge.",
                budgets.join(", "),
                match standing.count {
                    Count::Words =>
                        "Numbers are words of 32 bits: a line takes two, a known lamp \
                                     one, the label one.",
                    Count::Strict =>
                        "Strictly counted: a line takes three numbers, a known lamp \
                                      two, the label one.",
                }
            ),
            counts,
        }
    }

    /// The cells won as lines for a table's head.
    pub fn notes(&self) -> Vec<String> {
        let line = |(ours, counts): &(Entrant, Vec<(Entrant, usize, usize)>)| {
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
    pub fn rows(&self, standing: &Standing, class: Option<&str>, budget: usize) -> Vec<WaysRow> {
        let mut rows: Vec<WaysRow> = Entrant::ALL
            .into_iter()
            .map(|entrant| WaysRow {
                entrant,
                errors: ErrorKind::ALL
                    .map(|error| cell(spread(standing, class, budget, entrant, error), error)),
                won: std::array::from_fn(|i| {
                    let counts = &self.counts[i].1;
                    let against = counts.iter().find(|(peer, ..)| *peer == entrant);
                    against.map_or_else(String::new, |(_, won, of)| per_cent(*won, *of))
                }),
            })
            .collect();
        for (i, error) in ErrorKind::ALL.into_iter().enumerate() {
            let median = |e| spread(standing, class, budget, e, error).map(|s| s.median);
            let least = Entrant::ALL.into_iter().filter_map(median);
            let least = least.fold(f64::INFINITY, f64::min);
            for row in &mut rows {
                row.errors[i].wins = median(row.entrant) == Some(least);
            }
        }
        rows
    }
}

/// What an entrant is, a sentence.
pub fn about_entrant(entrant: Entrant) -> String {
    match entrant {
        Entrant::KnownLamps => "Up to two of the program's lamps, a short cosine series and lines \
                                of their own width, chosen together; needs the program's list of \
                                lamps."
            .to_owned(),
        Entrant::WideLines => {
            "The same without known lamps: whoever has the formula can decode it.".to_owned()
        }
        Entrant::Today => "The best of the eight composites, chosen for each light.".to_owned(),
        Entrant::Peer(family) => family.about().meaning.to_owned(),
    }
}

fn spread(
    standing: &Standing,
    class: Option<&str>,
    budget: usize,
    entrant: Entrant,
    error: ErrorKind,
) -> Option<Spread> {
    let is_in = |lamp: &usize| class.is_none_or(|class| standing.lamps[*lamp].1 == class);
    let values: Vec<f64> = (0..standing.lamps.len())
        .filter(is_in)
        .filter_map(|lamp| standing.errors(lamp, budget, entrant))
        .map(|errors| error.of(errors))
        .collect();
    Spread::of(&values)
}

fn cell(spread: Option<Spread>, error: ErrorKind) -> RaceCell {
    let factor = if error == ErrorKind::Blurred {
        100.0
    } else {
        1.0
    };
    spread.map_or_else(RaceCell::default, |spread| {
        let [median, p95, worst] = figures(spread).map(|value| figure(factor * value));
        let is_one = median == worst;
        RaceCell {
            text: if is_one {
                median.clone()
            } else {
                format!("{median} / {p95}")
            },
            tip: format!("median {median}, 95 % below {p95}, worst {worst}"),
            wins: false,
        }
    })
}

fn sentence(standing: &Standing, counts: &[Won]) -> String {
    let who = match &standing.lamps[..] {
        [(name, _)] => format!("On {name}"),
        lamps => format!("On {} lights", lamps.len()),
    };
    let said = counts.iter().filter_map(|(ours, against)| {
        let peers = || against.iter().filter(|(peer, ..)| *peer != Entrant::Today);
        let won: usize = peers().map(|(_, won, _)| won).sum();
        let of: usize = peers().map(|(.., of)| of).sum();
        let share = |(_, won, of): &&(Entrant, usize, usize)| (1000 * won).checked_div(*of);
        let least = peers()
            .filter(|count| share(count).is_some())
            .min_by_key(share)?;
        let (peer, least_won, least_of) = least;
        let title = match ours {
            Entrant::KnownLamps => "known lamps with wide lines",
            _ => "wide lines alone",
        };
        let least = if won == of {
            String::new()
        } else {
            let share = per_cent(*least_won, *least_of);
            format!(", least against {} ({share})", peer.title().to_lowercase())
        };
        Some(format!(
            "{title} are ahead of the other representations in {won} of {of} cells ({}){least}",
            per_cent(won, of)
        ))
    });
    let said: Vec<String> = said.collect();
    if said.is_empty() {
        return format!("{who} there is nothing to compare.");
    }
    format!("{who}, {}.", said.join("; "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            App,
            memo::ByAddress,
            studies::{Field, RaceAsk, WaysAsk},
        },
        study::Progress,
    };

    #[test]
    fn each_way_has_a_row_and_the_sentence_counts_the_cells() {
        let app = App::new();
        let light = app.entry("cie_fluorescent_1nm/FL11").expect("shipped");
        let field = Field::One(ByAddress(light));
        let race = RaceAsk::of(app.document(), field, vec![20]);
        let ask = WaysAsk::of(&race, &[11, 20], false).expect("in range");
        let standing = ask.answer(&Progress::default()).expect("a light");
        let ways = Ways::of(&standing);
        // Three errors, three figures, two counts, six peers.
        assert!(ways.sentence.contains(" of 108 cells"), "{}", ways.sentence);
        assert!(ways.sentence.starts_with("On FL11, known lamps"));
        assert_eq!(ways.notes().len(), 3);
        let rows = ways.rows(&standing, None, 1);
        assert_eq!(rows.len(), Entrant::ALL.len());
        for i in 0..3 {
            assert!(rows.iter().any(|row| row.errors[i].wins));
        }
        let row = |word: &str| rows.iter().find(|row| row.entrant.word() == word);
        assert_eq!(row("known-lamps").expect("ours").won, ["", ""]);
        assert!(row("samples").expect("a peer").won[0].ends_with(" %"));
    }

    #[test]
    fn all_but_one_cell_is_not_hundred_per_cent() {
        assert_eq!(per_cent(143, 144), "99 %");
        assert_eq!(per_cent(144, 144), "100 %");
        assert_eq!(per_cent(0, 0), "–");
    }
}
