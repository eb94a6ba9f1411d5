//! Choosing the count of numbers, the reference and the lines by themselves, by a bound on the
//! error or by a budget of numbers.

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use crate::color::{delta_e_2000, lab_from_xyz};
use crate::spectrum::quantile;
use crate::study::Progress;

use super::light::{Rows, sums};
use super::lines::{Line, find_lines, lines_at};
use super::measure::{Judge, white_y_of};
use super::operator::MOST_NOISE_GAIN;
use super::plan::MARGIN;
use super::strips::over_parts;
use super::survey::Survey;
use super::{Bands, Illuminant, Operator, PictureError, Plan, Reference, ReferenceKind};

/// Most numbers a pixel that are tried.
pub(crate) const MOST_NUMBERS: usize = 40;
/// Default bound on the 95th percentile of dE00.
pub const BOUND_P95: f64 = 0.5;
/// Default bound on the relative rms.
pub const BOUND_RMS: f64 = 0.02;
/// Pixels of the sample that colours are worked out for.
const MOST_JUDGED: usize = 1024;

/// The goal of a choice.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Asked {
    /// The fewest numbers that keep the 95th percentile of dE00 and the relative rms (or the
    /// noise, where that is larger) within bounds.
    Bound { p95: f64, rms: f64 },
    /// The least error at a count of numbers.
    Budget(usize),
}

/// Settings that may be fixed instead of chosen.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FixedSettings {
    /// Kind of the reference that multiplies the series; `None` for the best.
    pub reference: Option<ReferenceKind>,
    /// Lines with a coefficient of their own.
    pub lines: LineChoice,
}

/// Selection of the lines with a coefficient of their own.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LineChoice {
    /// Those that are found, where they pay.
    #[default]
    Best,
    /// None.
    None,
    /// Those that are found, the strongest first.
    Found,
    /// Those at these places, nm, every one of them.
    At(Vec<f64>),
}

/// One way of storing a picture, and what it is off by.
#[derive(Clone, Debug, PartialEq)]
pub struct Candidate {
    /// Numbers a pixel.
    pub numbers: usize,
    /// Kind of the reference that multiplies the series.
    pub reference: ReferenceKind,
    /// Number of lines.
    pub lines: usize,
    /// Extension of the range beyond the bands.
    pub margin: f64,
    /// 95th percentile of dE00 under the judging lights; of own colour where there are none.
    pub p95: f64,
    /// Relative rms.
    pub rms: f64,
}

impl Candidate {
    /// The larger of both errors over its bound.
    fn over(&self, p95: f64, rms: f64) -> f64 {
        (self.p95 / p95).max(self.rms / rms)
    }
}

/// The chosen plan, with every candidate tried.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The plan.
    pub plan: Plan,
    /// The chosen candidate, with its errors on the sample.
    pub chosen: Candidate,
    /// True if the bound is kept; otherwise the plan is the best there is.
    pub is_reached: bool,
    /// Every candidate, for the curve of error against numbers.
    pub tried: Vec<Candidate>,
    /// The bound on the 95th percentile.
    pub bound_p95: f64,
    /// The bound on the rms in force: noise may raise it.
    pub bound_rms: f64,
    /// Notes on merged lines among those requested, one sentence each.
    pub notes: Vec<String>,
}

impl Choice {
    /// The best of all that was tried with so many numbers.
    pub(crate) fn with_numbers(&self, numbers: usize) -> Option<&Candidate> {
        let over = |c: &Candidate| c.over(self.bound_p95, self.bound_rms);
        let tried = self.tried.iter().filter(|c| c.numbers == numbers);
        tried.min_by(|a, b| over(a).total_cmp(&over(b)))
    }
}

/// The plan of what an earlier choice tried, on the same picture.
///
/// # Errors
/// As [`choose`].
pub(crate) fn plan_of(
    bands: &Bands,
    survey: &Survey,
    known: Option<&Illuminant>,
    (base, fixed): (&Plan, &FixedSettings),
    tried: &Candidate,
) -> Result<Plan, PictureError> {
    Ok(Ways::new(bands, survey, known, (base, fixed))?.plan(tried))
}

/// Ingredients of the candidates.
struct Ways<'a> {
    bands: &'a Bands,
    base: Plan,
    references: Vec<Reference>,
    lines: Vec<Line>,
    line_choice: &'a LineChoice,
    notes: Vec<String>,
    survey: &'a Survey,
    known: Option<&'a Illuminant>,
    moments: DMatrix<f64>,
}

/// Chooses. `known` is the light on a picture that is light itself; `base` tells own light,
/// observer and weighting, `fixed` what is not left to the choice.
///
/// # Errors
/// [`PictureError`] when no candidate can be formed at all, and for a fixed setting that cannot be met.
pub fn choose(
    bands: &Bands,
    survey: &Survey,
    known: Option<&Illuminant>,
    (base, fixed): (&Plan, &FixedSettings),
    asked: Asked,
    progress: &Progress,
) -> Result<Choice, PictureError> {
    let ways = Ways::new(bands, survey, known, (base, fixed))?;
    let bases = ways.bases();
    let most = (bands.len() - 1).min(MOST_NUMBERS);
    let jobs: Vec<(usize, usize)> = (3..=most)
        .flat_map(|p| (0..bases.len()).map(move |b| (p, b)))
        .collect();
    let (wanted, p95, rms) = match asked {
        Asked::Budget(numbers) => (Some(numbers), BOUND_P95, BOUND_RMS),
        Asked::Bound { p95, rms } => (None, p95, rms),
    };
    let rms = rms.max(survey.relative_noise(bands));
    let possible = 3..bands.len();
    if let Some(found) = wanted.filter(|numbers| !possible.contains(numbers)) {
        let most = bands.len() - 1;
        return Err(PictureError::Numbers { found, most });
    }
    ways.check(wanted.unwrap_or(most))?;
    progress.expect(jobs.len());
    let tried = over_parts(jobs.len(), 1 << 20, progress, |at| {
        let (numbers, base) = jobs[at];
        Ok(ways.try_one(&bases[base], numbers))
    })?;
    let mut tried: Vec<Candidate> = tried.into_iter().flatten().collect();
    if let Some(numbers) = wanted.filter(|n| *n > most) {
        tried.extend(bases.iter().filter_map(|base| ways.try_one(base, numbers)));
    }
    let over = |c: &Candidate| c.over(p95, rms);
    let by_over = |a: &&Candidate, b: &&Candidate| over(a).total_cmp(&over(b));
    let chosen = match wanted {
        Some(numbers) => {
            // Fewer where so many would amplify noise.
            let counts = tried.iter().map(|c| c.numbers);
            let nearest = counts.filter(|n| *n <= numbers).max();
            let all = tried.iter().filter(|c| Some(c.numbers) == nearest);
            all.min_by(by_over)
        }
        None => {
            let keeps = tried.iter().filter(|c| over(c) <= 1.0);
            let fewest = |a: &&Candidate, b: &&Candidate| {
                (a.numbers.cmp(&b.numbers)).then(a.rms.total_cmp(&b.rms))
            };
            keeps
                .min_by(fewest)
                .or_else(|| tried.iter().min_by(by_over))
        }
    };
    let chosen = chosen.cloned().ok_or(PictureError::NotSolved)?;
    Ok(Choice {
        plan: ways.plan(&chosen),
        is_reached: chosen.over(p95, rms) <= 1.0,
        chosen,
        tried,
        bound_p95: p95,
        bound_rms: rms,
        notes: ways.notes,
    })
}

/// The references that may multiply the series.
fn references(
    bands: &Bands,
    survey: &Survey,
    known: Option<&Illuminant>,
    fixed: Option<ReferenceKind>,
) -> Result<Vec<Reference>, PictureError> {
    let of = |kind: ReferenceKind| match (kind, known) {
        (ReferenceKind::One, _) => Ok(Reference::one(bands)),
        (ReferenceKind::Mean, _) => Reference::of_mean(&survey.mean),
        (ReferenceKind::Light, Some(light)) => Reference::of_light(bands, light),
        (ReferenceKind::Light, None) => Err(PictureError::NoRelighting(
            said!(
                "expected a picture of light and the light that lit it for a light as reference, \
                 found none"
            )
            .to_owned(),
        )),
    };
    if let Some(kind) = fixed {
        return Ok(vec![of(kind)?]);
    }
    let usual = match known {
        Some(_) => ReferenceKind::Light,
        None => ReferenceKind::One,
    };
    let mean = of(ReferenceKind::Mean).ok();
    Ok(std::iter::once(of(usual)?).chain(mean).collect())
}

/// A reference, whether lines are taken, and a margin.
type Base = (usize, bool, f64);

impl<'a> Ways<'a> {
    fn new(
        bands: &'a Bands,
        survey: &'a Survey,
        known: Option<&'a Illuminant>,
        (base, fixed): (&Plan, &'a FixedSettings),
    ) -> Result<Self, PictureError> {
        let known = known.filter(|_| !bands.is_factor());
        let mut source = survey.mean.clone();
        let mut plan = base.clone();
        if let Some(light) = known {
            source = light.on_bands(bands)?;
            let noise = survey.usual_noise_under(&source);
            plan.noise = noise.max(super::plan::LEAST_NOISE);
        }
        let references = references(bands, survey, known, fixed.reference)?;
        let mut notes = Vec::new();
        let lines = match &fixed.lines {
            LineChoice::None => Vec::new(),
            // No lamp is in a reflectance.
            LineChoice::Best if bands.is_factor() => Vec::new(),
            LineChoice::Best | LineChoice::Found => find_lines(bands, &source)?,
            LineChoice::At(places) => {
                let found = lines_at(bands, &source, places)?;
                notes = found.notes;
                found.lines
            }
        };
        let count = survey.sample.len().max(1) as f64;
        let all = DMatrix::from_fn(bands.len(), survey.sample.len(), |j, i| survey.sample[i][j]);
        Ok(Self {
            bands,
            base: plan,
            references,
            lines,
            line_choice: &fixed.lines,
            notes,
            survey,
            known,
            moments: &all * all.transpose() / count,
        })
    }

    fn bases(&self) -> Vec<Base> {
        let is_left_to_us = *self.line_choice == LineChoice::Best;
        let mut bases = Vec::new();
        for margin in [MARGIN, 0.0] {
            for (at, reference) in self.references.iter().enumerate() {
                // A known light carries its lines itself.
                let carries = is_left_to_us && reference.kind == ReferenceKind::Light;
                let has_lines = !carries && !self.lines.is_empty();
                if is_left_to_us || !has_lines {
                    bases.push((at, false, margin));
                }
                if has_lines {
                    bases.push((at, true, margin));
                }
            }
        }
        bases
    }

    /// Greatest number of lines among so many numbers: at least three belong to the series.
    fn room(numbers: usize) -> usize {
        numbers.saturating_sub(3)
    }

    /// Checks that lines set by hand leave three numbers to the series.
    fn check(&self, numbers: usize) -> Result<(), PictureError> {
        let lines = self.lines.len();
        match self.line_choice {
            LineChoice::At(_) if lines > Self::room(numbers) => {
                Err(PictureError::TooManyLines { lines, numbers })
            }
            _ => Ok(()),
        }
    }

    fn form(&self, (reference, lines, margin): Base, numbers: usize) -> Plan {
        let room = if lines { Self::room(numbers) } else { 0 };
        let lines = self.lines.len().min(room);
        Plan {
            series: numbers - lines,
            margin,
            reference: self.references[reference].clone(),
            second: None,
            lines: self.lines[..lines].to_vec(),
            ..self.base.clone()
        }
    }

    fn plan(&self, chosen: &Candidate) -> Plan {
        let is_it = |reference: &Reference| reference.kind == chosen.reference;
        let at = self.references.iter().position(is_it).unwrap_or(0);
        let base = (at, chosen.lines > 0, chosen.margin);
        let mut plan = self.form(base, chosen.numbers);
        plan.lines.truncate(chosen.lines);
        plan.series = chosen.numbers - plan.lines.len();
        plan
    }

    fn try_one(&self, base: &Base, numbers: usize) -> Option<Candidate> {
        self.check(numbers).ok()?;
        let plan = self.form(*base, numbers);
        let operator = Operator::new(self.bands, &plan).ok()?;
        if operator.noise_gain() > MOST_NOISE_GAIN {
            return None;
        }
        Some(Candidate {
            numbers,
            reference: plan.reference.kind,
            lines: plan.lines.len(),
            margin: plan.margin,
            p95: self.colour_error(&operator)?,
            rms: self.rms(&operator),
        })
    }

    /// From the second moments of the sample alone.
    fn rms(&self, operator: &Operator) -> f64 {
        let count = self.bands.len();
        let off = DMatrix::identity(count, count) - &operator.decode * &operator.encode;
        let spread = &off * &self.moments;
        let weights = self.bands.weights_nm();
        let (mut error, mut all) = (0.0, 0.0);
        for (j, weight) in weights.iter().enumerate() {
            error += weight * spread.row(j).dot(&off.row(j));
            all += weight * self.moments[(j, j)];
        }
        if all > 0.0 {
            (error.max(0.0) / all).sqrt()
        } else {
            0.0
        }
    }

    /// 95th percentile of dE00 under the judging lights, or of own colour.
    fn colour_error(&self, operator: &Operator) -> Option<f64> {
        let white_y = white_y_of(operator, &self.survey.sample);
        let judges = Judge::all(operator, white_y, self.known).ok()?;
        let judges = &judges[usize::from(judges.len() > 1)..];
        let step = self.survey.sample.len().div_ceil(MOST_JUDGED).max(1);
        let sample: Vec<&Vec<f64>> = self.survey.sample.iter().step_by(step).collect();
        let mut off: Vec<f64> = Vec::with_capacity(judges.len() * sample.len());
        for judge in judges {
            let (exact, found, white) = judge.ends(operator);
            let lab = |rows: &Rows, pixel: &[f64]| lab_from_xyz(sums(rows, pixel), white);
            let difference = |p: &&Vec<f64>| delta_e_2000(lab(exact, p), lab(&found, p));
            off.extend(sample.iter().map(difference).filter(|d| d.is_finite()));
        }
        quantile(&mut off, 0.95)
    }
}
