//! One light being encoded: the goals near it, the candidates and the choice among them.

use std::sync::Arc;

use super::{
    ask::{Ask, LEAST_LABELLED},
    columns::LEADING,
    encoder::{Counted, Encoder},
    encoding::{AtomWeight, Encoding, MOST_ATOMS, stored_line},
    fit::{FIRST_WEIGHTS, directions, fit, is_none, score, small_errors},
    goals::{GOALS, Goals},
    judge::Errors,
    orthonormal::Orthonormal,
    refine::{errors_of, refine},
    search::{Counts, Search, Selection},
    today::ways,
};
use crate::{
    spectrum::{Basis, Line, Series, dot},
    study::Reference,
};

/// Counts of lines that are tried.
const LINE_COUNTS: [usize; 10] = [0, 1, 2, 3, 4, 5, 6, 8, 10, 13];

/// Makeups that are fitted and measured.
const FITTED: usize = 10;

/// Makeups whose lines are refined.
const REFINED: usize = 3;

/// Fits again with weights from the errors: the plain series, and every makeup.
const PLAIN_AGAIN: usize = 2;
const AGAIN: usize = 3;

/// A candidate with its values and what its true errors score.
pub(super) struct Candidate {
    pub(super) encoding: Encoding,
    weights: [f64; GOALS],
    /// Place of each known lamp among the columns' atoms.
    atoms: Vec<usize>,
    pub(super) errors: Errors,
    pub(super) score: f64,
}

/// A light being encoded.
pub(super) struct EncodeJob<'a> {
    encoder: &'a Encoder,
    goals: Goals,
    pub(super) exact: Reference,
    pub(super) counted: Arc<Counted>,
    /// The light's own colour in the leading cosines.
    gamma: [f64; 3],
    /// The light without it, as errors of the goals.
    target: Vec<f64>,
    /// The cosines after the leading ones, as errors of the goals.
    cosines: Vec<Vec<f64>>,
    pub(super) small: [f64; GOALS],
    /// Weights of the plain series' last fit: search and candidates begin with them.
    weights: [f64; GOALS],
    /// The cosines' directions at these weights, shared by all candidates.
    smooth: Orthonormal,
}

impl<'a> EncodeJob<'a> {
    /// Linearises the goals and fits the plain series.
    pub(super) fn new(encoder: &'a Encoder, exact: Reference, numbers: usize) -> Self {
        let light = exact.measured();
        let columns = &encoder.columns;
        let operators = &columns.operators;
        let rows = operators.rows_of(0, light);
        let blurred = encoder.panel.measures().blur.values(light);
        let norm = dot(&blurred, &blurred).sqrt();
        let goals = Goals::near(operators, &rows, operators.xyz(0, light), norm);
        let own = columns.column(0, light);
        let target = goals.errors_of(&own.rows);
        let cosines = columns.cosines.iter().take(numbers - LEADING);
        let cosines: Vec<Vec<f64>> = cosines.map(|c| goals.errors_of(&c.rows)).collect();
        let all = || cosines.iter().map(Vec::as_slice);
        let plain =
            |basis: Orthonormal, fits| fit(&goals, basis, &[], &target, FIRST_WEIGHTS, fits);
        let basis = directions(&goals, all(), FIRST_WEIGHTS);
        let small = small_errors(plain(basis.clone(), (None, 0)).errors);
        let weights = plain(basis, (Some(small), PLAIN_AGAIN)).goals;
        Self {
            smooth: directions(&goals, all(), weights),
            gamma: own.gamma,
            counted: encoder.counted(numbers),
            target,
            cosines,
            small,
            weights,
            encoder,
            goals,
            exact,
        }
    }

    /// The candidate with the least true errors.
    pub(super) fn best(&self, usable: &[bool], ask: Ask) -> Candidate {
        let mut candidates = Vec::with_capacity(FITTED + REFINED + 9);
        // The plain series: all numbers smooth, no label.
        candidates.extend(self.candidate(ask.numbers, &[], &[]));
        for makeup in self.makeups(usable, ask) {
            let lines: Vec<Line> = makeup
                .lines
                .iter()
                .map(|i| self.stored(self.encoder.columns.lines[*i].line))
                .collect();
            candidates.extend(self.candidate(makeup.cosines, &makeup.atoms, &lines));
        }
        candidates.sort_by(|a, b| a.score.total_cmp(&b.score));
        let refined: Vec<Candidate> = candidates
            .iter()
            .filter(|c| !c.encoding.lines.is_empty())
            .take(REFINED)
            .filter_map(|c| self.refined(c))
            .collect();
        candidates.extend(refined);
        for encoding in self.today() {
            candidates.extend(self.measured(encoding, self.weights, Vec::new()));
        }
        // The first of equals; the plain series is always there.
        let best = (0..candidates.len())
            .min_by(|a, b| candidates[*a].score.total_cmp(&candidates[*b].score));
        let best = candidates.swap_remove(best.unwrap_or(0));
        self.shortest(&best).unwrap_or(best)
    }

    /// Today's ways with as many numbers.
    pub(super) fn today(&self) -> Vec<Encoding> {
        ways(&self.exact, &self.counted, self.encoder.spikes)
    }

    /// A light that is known lamps and nothing else, in as few numbers as say so: more of them would
    /// hold rounding.
    fn shortest(&self, best: &Candidate) -> Option<Candidate> {
        if best.atoms.is_empty() || !is_none(best.errors.to_array()) {
            return None;
        }
        let of = |count: usize| {
            self.candidate(LEAST_LABELLED, &best.atoms[..count], &[])
                .filter(|short| is_none(short.errors.to_array()))
        };
        (1..=best.atoms.len()).find_map(of)
    }

    /// The best makeups of all counts, best first.
    fn makeups(&self, usable: &[bool], ask: Ask) -> Vec<Selection> {
        let columns = &self.encoder.columns;
        let known = usable.iter().filter(|u| **u).count();
        let mut search = Search::new(
            columns,
            &self.goals,
            &self.target,
            (self.weights, self.small),
            usable,
            &self.smooth,
        );
        let mut counts: Vec<Counts> = Vec::new();
        for atoms in 0..=MOST_ATOMS.min(known) {
            for lines in LINE_COUNTS {
                // Neither lamp nor line is the plain series, which needs no label.
                if let Some(cosines) = ask.smooth(atoms, lines).filter(|_| atoms + lines > 0) {
                    counts.push(Counts {
                        cosines,
                        atoms,
                        lines,
                    });
                }
            }
        }
        // Rooms are built from smaller ones.
        counts.sort_by_key(|c| c.cosines);
        let mut makeups: Vec<Selection> = counts
            .into_iter()
            .filter_map(|c| search.makeup(c))
            .collect();
        makeups.sort_by(|a, b| a.score.total_cmp(&b.score));
        makeups.truncate(FITTED);
        makeups
    }

    /// Fits a makeup and measures it.
    fn candidate(&self, cosines: usize, atoms: &[usize], lines: &[Line]) -> Option<Candidate> {
        let columns = &self.encoder.columns;
        let smooth = cosines - LEADING;
        let lamps: Vec<Vec<f64>> = self.lamps(atoms);
        let shapes: Vec<Vec<f64>> = lines
            .iter()
            .map(|line| errors_of(columns, &self.goals, *line))
            .collect();
        let others: Vec<&[f64]> = lamps.iter().chain(&shapes).map(Vec::as_slice).collect();
        let basis = self.smooth.first(smooth);
        let fits = (Some(self.small), AGAIN);
        let fitted = fit(
            &self.goals,
            basis,
            &others,
            &self.target,
            self.weights,
            fits,
        );
        let cosine_gammas = columns.cosines[..smooth].iter().map(|c| c.gamma);
        let lamp_gammas = atoms.iter().map(|i| columns.atoms[*i].gamma);
        let line_gammas = lines.iter().map(|line| {
            let shape = line.profile(columns.band());
            columns.gamma(shape.first, &shape.values)
        });
        // What the columns have of the light's own colour, the leading cosines need not have.
        let mut leading = self.gamma;
        for (weight, gamma) in fitted
            .weights
            .iter()
            .zip(cosine_gammas.chain(lamp_gammas).chain(line_gammas))
        {
            for (l, g) in leading.iter_mut().zip(gamma) {
                *l -= weight * g;
            }
        }
        let (of_cosines, rest) = fitted.weights.split_at(smooth);
        let (of_atoms, of_lines) = rest.split_at(atoms.len());
        let indices = atoms.iter().map(|i| self.encoder.decoder.atoms()[*i].index);
        let encoding = Encoding {
            atoms: indices
                .zip(of_atoms)
                .map(|(index, weight)| AtomWeight {
                    index,
                    weight: *weight,
                })
                .collect(),
            smooth: Series {
                band: columns.band(),
                basis: Basis::Cosine,
                coefficients: leading.iter().chain(of_cosines).copied().collect(),
            },
            lines: lines
                .iter()
                .zip(of_lines)
                .map(|(line, weight)| Line {
                    weight: *weight,
                    ..*line
                })
                .collect(),
            way: None,
        };
        self.measured(encoding, fitted.goals, atoms.to_vec())
    }

    /// Known lamps as errors of the goals.
    fn lamps(&self, atoms: &[usize]) -> Vec<Vec<f64>> {
        let columns = &self.encoder.columns;
        let errors = |i: &usize| self.goals.errors_of(&columns.atoms[*i].rows);
        atoms.iter().map(errors).collect()
    }

    /// A candidate with its lines refined, stored and fitted again.
    fn refined(&self, candidate: &Candidate) -> Option<Candidate> {
        let Candidate {
            encoding,
            weights,
            atoms,
            ..
        } = candidate;
        let cosines = encoding.smooth.coefficients.len();
        let lamps = self.lamps(atoms);
        let cosine_rows = self.cosines[..cosines - LEADING].iter();
        let others: Vec<&[f64]> = cosine_rows.chain(&lamps).map(Vec::as_slice).collect();
        let columns = &self.encoder.columns;
        let moved = refine(
            columns,
            &self.goals,
            &others,
            &encoding.lines,
            &self.target,
            *weights,
        );
        let lines: Vec<Line> = moved.into_iter().map(|line| self.stored(line)).collect();
        self.candidate(cosines, atoms, &lines)
    }

    fn stored(&self, line: Line) -> Line {
        stored_line(self.encoder.columns.band(), line)
    }

    /// A candidate with its true errors; `None` when they are no numbers.
    pub(super) fn measured(
        &self,
        encoding: Encoding,
        weights: [f64; GOALS],
        atoms: Vec<usize>,
    ) -> Option<Candidate> {
        let values = self.encoder.decoder.decode(&encoding).ok()?;
        let errors = self
            .encoder
            .panel
            .errors(&self.exact, &values, &self.counted.patches);
        let score = score(errors.to_array(), self.small);
        score.is_finite().then_some(Candidate {
            encoding,
            weights,
            atoms,
            errors,
            score,
        })
    }
}
