//! A formula over measurements: its values on the union of their grids, with sigma and mask.
//!
//! Every point is computed with its slopes against each input, so that an input that stands in
//! two places (a dark that is taken off sample and reference) counts once: the sigma of `A - A` is
//! nothing, that of `(A - C) / (B - C)` is the shared dark's.

use super::{
    columns::{Column, Grid, OnGrid},
    error::MeasurementError,
    formula::{Formula, Tree},
    mask::{Mask, doubtful, in_the_dark},
    measurement::{Measurement, letter},
    quantity::{Meaning, Operation, Quantity, absorbance_of},
    union::Union,
};
use crate::spectrum::Sampled;

/// Least transmittance for an absorbance, in its sigmas.
const LEAST_FOR_ABSORBANCE: f64 = 7.0;

/// Options for the evaluation of a formula.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Options {
    /// Nothing is masked but what is no finite number.
    pub keep_all: bool,
    /// Most that a quotient may be off by, from noise and axis; for references with lines.
    pub most_doubt: Option<f64>,
}

/// A combination, and what is to be known of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Combined {
    pub result: Measurement,
    /// Median step of the finest input, nm: the result's own where pieces are finer.
    pub step_nm: f64,
    /// Share of the points that hold a value.
    pub kept: f64,
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
    let letters = formula.letters();
    if let Some(missing) = letters.iter().find(|index| **index >= inputs.len()) {
        return Err(MeasurementError::Meaningless(format!(
            "found {} in the formula and {} inputs, expected an input for each letter",
            letter(*missing),
            inputs.len()
        )));
    }
    if letters.is_empty() {
        return Err(MeasurementError::Meaningless(
            "found a formula without a letter, expected one of an input".to_owned(),
        ));
    }
    let mut notes = Vec::new();
    let (step, meaning) = understood(&formula.0, inputs, &mut notes)?;
    for index in (0..inputs.len()).filter(|index| !letters.contains(index)) {
        notes.push(format!("{} is not used.", letter(index)));
    }
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
            "" => "Nothing of the result is a finite number.".to_owned(),
            why => format!("{why} everywhere: nothing is left."),
        }));
    }
    notes.extend(
        result
            .masked()
            .iter()
            .take(MOST_MASKED)
            .map(|m| format!("{} from {} to {} nm.", m.why, m.from_nm, m.to_nm)),
    );
    let steps = parts.iter().map(|m| m.samples.step_nm());
    Ok(Combined {
        step_nm: steps.fold(f64::INFINITY, f64::min),
        result,
        kept,
        notes,
    })
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
                let why = "The transmittance is below 7 of its noise: only \"more than\" could be \
                           told of the absorbance";
                mask.add(is_dark.collect(), why);
            }
            Self::Of(operation, a, b, _) => {
                a.mask(grid, options, mask);
                b.mask(grid, options, mask);
                if *operation == Operation::Divide && !b.is_number() {
                    let r = b.column(grid);
                    let why = "The reference is below 10 of its noise: nothing is told there,";
                    mask.add(in_the_dark(&r, grid), why);
                    if let Some(most) = options.most_doubt {
                        let why = "The quotient is known to no better than the reference between \
                                   its lines allows";
                        mask.add(doubtful(&self.column(grid), &r, grid, most), why);
                    }
                }
            }
        }
    }
}

/// The measurement that a column is.
fn finished(
    grid: &Grid,
    found: Column,
    meaning: &Meaning,
    mask: &[bool],
    why: &str,
) -> Result<Measurement, MeasurementError> {
    let has_sigma = grid.used().any(|(_, input)| input.of.sigma.is_some());
    let sigma = found.sigma(grid);
    let is_no_number = |i: usize| !found.values[i].is_finite() || !sigma[i].is_finite();
    let mask: Vec<bool> = (0..mask.len())
        .map(|i| mask[i] || is_no_number(i))
        .collect();
    let or_zero = |values: &[f64]| -> Vec<f64> {
        let pairs = values.iter().zip(&mask);
        pairs
            .map(|(v, masked)| if *masked { 0.0 } else { *v })
            .collect()
    };
    let samples = Sampled::new(grid.nm.to_vec(), or_zero(&found.values))?;
    let mut result = Measurement::new(&meaning.text, meaning.quantity, &meaning.unit, samples);
    result.level = level(grid, &found, &mask);
    result.axis_nm = grid
        .used()
        .map(|(_, input)| input.of.axis_nm)
        .fold(0.0, f64::max);
    result.exposure_ms = meaning.exposure_ms;
    if has_sigma {
        result.memory = memory(grid, &found, &mask);
        result.sigma = Some(or_zero(&sigma));
    }
    let slits: Vec<_> = grid.used().map(|(_, input)| input.of.slit).collect();
    result.slit = slits[0].filter(|_| slits.iter().all(|slit| *slit == slits[0]));
    if mask.contains(&true) {
        result.mask = mask;
        result.why_masked = match why {
            "" => "No finite number".to_owned(),
            why => why.to_owned(),
        };
    }
    Ok(result)
}

/// Relative error of the result's total by the common factors of the inputs.
fn level(grid: &Grid, found: &Column, mask: &[bool]) -> f64 {
    let total = |of: &dyn Fn(usize) -> f64| -> f64 {
        (0..grid.nm.len())
            .filter(|i| !mask[*i])
            .map(|i| width(grid.nm, i) * of(i))
            .sum()
    };
    let whole = total(&|i| found.values[i].abs());
    let part = |(index, input): (usize, &OnGrid)| {
        let slopes = found.slopes[index]
            .as_ref()
            .map(|slopes| total(&|i| slopes[i] * input.values[i]));
        (input.of.level * slopes.unwrap_or(0.0)).powi(2)
    };
    let squares: f64 = grid.used().map(part).sum();
    if whole > 0.0 {
        squares.sqrt() / whole
    } else {
        0.0
    }
}

/// The stretch that a point stands for, nm.
fn width(nm: &[f64], i: usize) -> f64 {
    0.5 * (nm[(i + 1).min(nm.len() - 1)] - nm[i.saturating_sub(1)])
}

/// Least correlation that is kept.
const LEAST_MEMORY: f64 = 0.01;

/// Correlation of the noise of neighbouring points of the result: points between samples share
/// the noise of both, samples have the memory that they had.
fn memory(grid: &Grid, found: &Column, mask: &[bool]) -> Vec<f64> {
    let weight = |(index, input): (usize, &OnGrid)| -> f64 {
        let slopes = found.slopes[index].as_ref();
        let squares = slopes.map(|slopes| {
            let kept = (0..mask.len()).filter(|i| !mask[*i]);
            kept.map(|i| (slopes[i] * input.sigma[i]).powi(2)).sum()
        });
        squares.unwrap_or(0.0)
    };
    let weights: Vec<(f64, &OnGrid)> = grid
        .used()
        .map(|(i, input)| (weight((i, input)), input))
        .collect();
    let all: f64 = weights.iter().map(|(weight, _)| weight).sum();
    if all <= 0.0 {
        return Vec::new();
    }
    let of_input = |input: &OnGrid, lag: usize| {
        let lag = lag as f64 / input.points_a_sample;
        let rho = |k: usize| match k {
            0 => 1.0,
            k => input.of.memory.get(k - 1).copied().unwrap_or(0.0),
        };
        let (below, share) = (lag as usize, lag.fract());
        rho(below) * (1.0 - share) + rho(below + 1) * share
    };
    let at = |lag: usize| -> f64 {
        weights
            .iter()
            .map(|(weight, input)| weight * of_input(input, lag))
            .sum::<f64>()
            / all
    };
    (1..grid.nm.len())
        .map(at)
        .take_while(|rho| *rho > LEAST_MEMORY)
        .collect()
}
