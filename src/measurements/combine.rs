//! A formula over measurements: its values on the union of their grids, with sigma and mask.
//!
//! Every point is computed with its slopes against each input, so that an input that stands in
//! two places (a dark that is taken off sample and reference) counts once: the sigma of `A - A` is
//! nothing, that of `(A - C) / (B - C)` is the shared dark's.

use crate::languages::{fixed, with_sign};

use super::{
    columns::{Column, Grid},
    error::MeasurementError,
    finish::finished,
    formula::{Formula, Tree},
    mask::{Mask, doubtful, in_the_dark},
    measurement::{Masked, Measurement, letter},
    quantity::{Meaning, Operation, Quantity, absorbance_of},
    quotient::{LinePoint, fieller, line_points},
    union::Union,
};

/// Least transmittance for an absorbance, in its sigmas.
const LEAST_FOR_ABSORBANCE: f64 = 7.0;

/// Options for the evaluation of a formula.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Nothing is masked but what is no finite number.
    pub keep_all: bool,
    /// Most that a quotient may be off by, from noise and axis; for references with lines.
    pub most_doubt: Option<f64>,
    /// True if quotients are told at the lines that sample and reference share.
    pub tells_lines: bool,
}

/// A combination, and what is to be known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Combined {
    pub result: Measurement,
    /// Median step of the finest input, nm: the result's own where pieces are finer.
    pub step_nm: f64,
    /// Share of the points that hold a value.
    pub kept: f64,
    /// Quotients at lines that sample and reference share.
    pub points: Vec<LinePoint>,
    /// Of a quotient of which nothing is masked the intervals that hold it 95 times of 100, one a
    /// sample; `None` where it has no end.
    pub intervals: Option<Vec<Option<[f64; 2]>>>,
    /// A sentence each.
    pub notes: Vec<String>,
}

/// A formula over measurements.
///
/// # Errors
/// A sentence for a combination that means nothing, for inputs that share no wavelengths, and for
/// a result that the noise leaves nothing of.
pub fn combine(
    formula: &Formula,
    inputs: &[Measurement],
    options: Options,
) -> Result<Combined, MeasurementError> {
    let letters = letters_of(formula, inputs.len())?;
    let mut notes = Vec::new();
    let (step, meaning) = understood(&formula.0, inputs, &mut notes)?;
    let parts: Vec<&Measurement> = letters.iter().map(|index| &inputs[*index]).collect();
    let bare = Union::of(&parts, false)?;
    let union = match step.is_curved() {
        true => Union::of(&parts, true)?,
        false => bare.clone(),
    };
    let grid = Grid::new(&union, inputs, &letters);
    let bare_grid = Grid::new(&bare, inputs, &letters);
    let mut mask = Mask::new(&bare_grid);
    if !options.keep_all {
        step.mask(&bare_grid, options, &mut mask);
    }
    let found = step.column(&grid);
    let result = finished(
        &grid,
        found,
        &meaning,
        &mask.on(&bare.nm, &union.nm),
        &mask.why,
    )?;
    let kept = result.kept_values().iter().flatten().count() as f64 / union.nm.len() as f64;
    if kept == 0.0 {
        return Err(MeasurementError::AllMasked(match mask.why.as_str() {
            "" => said!("Nothing of the result is a finite number.").to_owned(),
            why => tr!("{why} everywhere: nothing is left.", why),
        }));
    }
    notes.extend(masked_words(&step, &grid, &result));
    let points = match options
        .tells_lines
        .then(|| step.divided(&bare_grid))
        .flatten()
    {
        Some([a, b]) => {
            let part = |column| finished(&bare_grid, column, &meaning, &[], "");
            line_points(&part(a)?, &part(b)?)
        }
        None => Vec::new(),
    };
    let intervals = match options.keep_all && result.sigma.is_some() {
        true => step.divided(&grid).map(|[a, b]| intervals(&grid, &a, &b)),
        false => None,
    };
    let steps = parts.iter().map(|m| m.samples.step_nm());
    Ok(Combined {
        step_nm: steps.fold(f64::INFINITY, f64::min),
        result,
        kept,
        points,
        intervals,
        notes,
    })
}

/// The inputs that a formula names, each once.
fn letters_of(formula: &Formula, inputs: usize) -> Result<Vec<usize>, MeasurementError> {
    let letters = formula.letters();
    if let Some(missing) = letters.iter().find(|index| **index >= inputs) {
        return Err(MeasurementError::Meaningless(tr!(
            "found {letter} in the formula and {inputs} inputs, expected an input for each letter",
            letter = letter(*missing),
            inputs
        )));
    }
    if letters.is_empty() {
        return Err(MeasurementError::Meaningless(
            said!("found a formula without a letter, expected one of an input").to_owned(),
        ));
    }
    Ok(letters)
}

/// What is masked and what is known there all the same, a sentence a stretch.
fn masked_words(step: &Step, grid: &Grid, result: &Measurement) -> Vec<String> {
    let bound = step.bound(grid);
    let told = |m: &Masked| match &bound {
        // At least so much of it is known even there.
        Some(bound) => {
            let inside = grid.nm.iter().zip(bound);
            let inside = inside.filter(|(nm, _)| (m.from_nm..=m.to_nm).contains(*nm));
            let least = inside
                .map(|(_, bound)| *bound)
                .fold(f64::INFINITY, f64::min);
            match least > 0.0 {
                true => tr!(
                    "the absorbance is more than {least} there",
                    least = fixed(least, 2)
                ),
                false => said!("no absorbance is told there").to_owned(),
            }
        }
        None => untold(result.quantity).to_owned(),
    };
    let words = |m: &Masked| {
        let (from, to) = (m.from_nm, m.to_nm);
        tr!(
            "{why} from {from} to {to} nm: {told}.",
            why = m.why,
            from = with_sign(from.to_string()),
            to = with_sign(to.to_string()),
            told = told(m)
        )
    };
    result
        .masked()
        .iter()
        .take(MOST_MASKED)
        .map(words)
        .collect()
}

/// What is masked tells nothing.
fn untold(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Light => said!("no radiant is told there"),
        Quantity::Counts => said!("no counts is told there"),
        Quantity::Transmittance => said!("no transmittance is told there"),
        Quantity::Reflectance => said!("no reflectance is told there"),
        Quantity::Absorbance => said!("no absorbance is told there"),
        Quantity::Factor => said!("no factor is told there"),
        Quantity::Number => said!("no number is told there"),
    }
}

/// Fieller's interval of every quotient.
fn intervals(grid: &Grid, s: &Column, r: &Column) -> Vec<Option<[f64; 2]>> {
    let (of_s, of_both, of_r) = (
        s.covariance(s, grid),
        s.covariance(r, grid),
        r.covariance(r, grid),
    );
    (0..grid.nm.len())
        .map(|i| fieller([s.values[i], r.values[i]], [of_s[i], of_both[i], of_r[i]]))
        .collect()
}

/// Most stretches without values that are named.
const MOST_MASKED: usize = 6;

/// A formula of which each operation is known to mean something.
#[derive(Clone, Debug)]
enum Step {
    Input(usize),
    Number(f64),
    /// An operation, and the factor that brings the second part to the first one's unit.
    Of(Operation, Box<Step>, Box<Step>, f64),
    /// `-log10` of a part.
    Absorbance(Box<Step>),
}

/// A tree with what it means.
fn understood(
    tree: &Tree,
    inputs: &[Measurement],
    notes: &mut Vec<String>,
) -> Result<(Step, Meaning), MeasurementError> {
    let meaning = |text: String, quantity, unit: &str, exposure_ms| Meaning {
        text,
        quantity,
        unit: unit.to_owned(),
        exposure_ms,
    };
    Ok(match tree {
        Tree::Input(index) => {
            let of = &inputs[*index];
            let text = letter(*index).to_string();
            (
                Step::Input(*index),
                meaning(text, of.quantity, &of.unit, of.exposure_ms),
            )
        }
        Tree::Number(value) => (
            Step::Number(*value),
            meaning(value.to_string(), Quantity::Number, "", None),
        ),
        Tree::Of(operation, a, b) => {
            let (a, of_a) = understood(a, inputs, notes)?;
            let (b, of_b) = understood(b, inputs, notes)?;
            let outcome = operation.of(&of_a, &of_b)?;
            notes.extend(outcome.note);
            let step = Step::Of(*operation, Box::new(a), Box::new(b), outcome.second_by);
            (step, outcome.meaning)
        }
        Tree::Absorbance(a) => {
            let (a, of_a) = understood(a, inputs, notes)?;
            (Step::Absorbance(Box::new(a)), absorbance_of(&of_a)?)
        }
    })
}

impl Step {
    /// True if the result is curved between points where its inputs are straight.
    fn is_curved(&self) -> bool {
        match self {
            Self::Input(_) | Self::Number(_) => false,
            Self::Absorbance(_) => true,
            Self::Of(operation, a, b, _) => {
                let linear = match operation {
                    Operation::Add | Operation::Subtract => true,
                    Operation::Multiply => a.is_number() || b.is_number(),
                    Operation::Divide => b.is_number(),
                };
                !linear || a.is_curved() || b.is_curved()
            }
        }
    }

    fn is_number(&self) -> bool {
        match self {
            Self::Input(_) => false,
            Self::Number(_) => true,
            Self::Of(_, a, b, _) => a.is_number() && b.is_number(),
            Self::Absorbance(a) => a.is_number(),
        }
    }

    fn column(&self, grid: &Grid) -> Column {
        let points = grid.nm.len();
        match self {
            Self::Input(index) => {
                let mut slopes = vec![None; grid.inputs.len()];
                slopes[*index] = Some(vec![1.0; points]);
                let input = grid.inputs[*index].as_ref();
                Column {
                    values: input.map_or_else(|| vec![0.0; points], |input| input.values.clone()),
                    slopes,
                }
            }
            Self::Number(value) => Column {
                values: vec![*value; points],
                slopes: vec![None; grid.inputs.len()],
            },
            Self::Of(operation, a, b, by) => {
                let (a, b) = (a.column(grid), b.column(grid));
                let by = *by;
                match operation {
                    Operation::Add => a.with(b, |a, b| [a + by * b, 1.0, by]),
                    Operation::Subtract => a.with(b, |a, b| [a - by * b, 1.0, -by]),
                    Operation::Multiply => a.with(b, |a, b| [a * b * by, b * by, a * by]),
                    Operation::Divide => a.with(b, |a, b| {
                        let r = b * by;
                        [a / r, 1.0 / r, -a * by / (r * r)]
                    }),
                }
            }
            Self::Absorbance(a) => {
                let slope = -std::f64::consts::LOG10_E;
                a.column(grid).through(|t| [-t.log10(), slope / t])
            }
        }
    }

    /// Of an absorbance the least that it is, as far as noise tells: of the transmittance and two of
    /// its doubts.
    fn bound(&self, grid: &Grid) -> Option<Vec<f64>> {
        let Self::Absorbance(a) = self else {
            return None;
        };
        let t = a.column(grid);
        let pairs = t.values.iter().zip(t.sigma(grid));
        let bound = pairs.map(|(t, u)| match t + 2.0 * u {
            most if most > 0.0 && most.is_finite() => -most.log10(),
            _ => f64::NEG_INFINITY,
        });
        Some(bound.collect())
    }

    /// What a quotient divides and by what, the divisor in the unit of the other.
    fn divided(&self, grid: &Grid) -> Option<[Column; 2]> {
        match self {
            Self::Of(Operation::Divide, a, b, by) if !b.is_number() => {
                let by = *by;
                Some([a.column(grid), b.column(grid).through(|r| [r * by, by])])
            }
            _ => None,
        }
    }

    /// Leaves out what the noise leaves nothing of: divisors in the dark, absorbances of nothing.
    fn mask(&self, grid: &Grid, options: Options, mask: &mut Mask) {
        match self {
            Self::Input(_) | Self::Number(_) => {}
            Self::Absorbance(a) => {
                a.mask(grid, options, mask);
                let t = a.column(grid);
                let sigma = t.sigma(grid);
                let pairs = t.values.iter().zip(&sigma);
                let is_dark =
                    pairs.map(|(t, s)| t.is_nan() || *t <= 0.0 || *t < LEAST_FOR_ABSORBANCE * s);
                let why = said!("The transmittance is below 7 of its noise");
                mask.add(is_dark.collect(), why);
            }
            Self::Of(operation, a, b, _) => {
                a.mask(grid, options, mask);
                b.mask(grid, options, mask);
                if *operation == Operation::Divide && !b.is_number() {
                    let r = b.column(grid);
                    let why = said!("The reference is below 10 of its noise");
                    mask.add(in_the_dark(&r, grid), why);
                    if let Some(most) = options.most_doubt {
                        let why = said!(
                            "The quotient is known to no better than the reference between its \
                             lines allows"
                        );
                        mask.add(doubtful(&self.column(grid), &r, grid, most), why);
                    }
                }
            }
        }
    }
}
