//! All that is shown about one spectrum, from the document in one pure step.

mod colour;
mod curve;
mod fitted;
mod patches;
mod wide;

pub use colour::{Colour, ColourComparison};
pub use curve::{OF_CURVE, OrderPoint};
pub use patches::{PatchComparison, PatchPair};

use crate::{
    color::{Adaptation, Observer, Xyz},
    io::many::numbers,
    languages::fixed,
    spectrum::{
        Band, Composite, Decomposed, Exactness, Line, Series, SpikeEdits, add_lines, gaussian,
    },
    study::{Measure, Verdict},
};

use super::{settings::Settings, tables::Tables, ticks::short};
use fitted::Fitted;

/// What a recomputation needs to know beside the shared tables.
#[derive(Clone, Copy, Debug)]
pub struct Question<'a> {
    /// The subject on the band's grid.
    pub measured: &'a [f64],
    /// Whether the subject is a light (it has patches and a CCT) or a reflectance.
    pub is_light: bool,
    /// Whether the subject's numbers were divided when its file was read.
    pub is_divided: bool,
    /// The light on the band's grid: the subject itself, or what a reflectance is seen under.
    pub light: &'a [f64],
    /// XYZ of the subject by 1 nm sums over 360-830, Y of the light at 100; CIE 1931 beside it.
    pub full: Option<(Xyz, Xyz)>,
    /// Y of the light over 360-830, not scaled.
    pub full_luminance: f64,
    /// First and last wavelength of the subject's table, nm.
    pub table_nm: [f64; 2],
    /// The part of a light's power that lies outside the band, 0-1; 0 for a reflectance.
    pub power_outside: f64,
    /// The knobs.
    pub settings: Settings,
    /// The hand edits of the subject's spikes.
    pub edits: &'a SpikeEdits,
    /// The composite that the subject is, where it is to be shown as it is.
    pub given: Option<&'a Composite>,
    /// Bring patches to the screen's white.
    pub adaptation: Adaptation,
    /// The errors of every order, where they are known: another order has the same.
    pub curve: Option<&'a [OrderPoint]>,
}

/// Everything derived from one subject and one set of knobs.
#[derive(Clone, Debug, PartialEq)]
pub struct Derived {
    /// The model's range.
    pub band: Band,
    /// The measured spectrum on the grid.
    pub measured: Vec<f64>,
    /// Smooth target, spikes, total power.
    pub parts: Decomposed,
    /// The model; its lines have widths where they were asked for.
    pub model: Composite,
    /// Its lines that have a width, on the grid; empty where there are none.
    pub bells: Vec<f64>,
    /// The smooth series on the grid.
    pub smooth: Vec<f64>,
    /// Smooth plus lines (ideal ones split over their neighbouring nm) minus measured, on the grid.
    pub residual: Vec<f64>,
    /// How the colour-exact fit went; `None` when it was not asked for.
    pub exactness: Option<Exactness>,
    /// What the model is off by; nothing behind narrow filters.
    pub figures: Verdict,
    /// The subject's colour.
    pub colour: ColourComparison,
    /// The patches under a light.
    pub patches: Option<PatchComparison>,
    /// Errors against order, from 0 on.
    pub curve: Vec<OrderPoint>,
    /// What must be said about this result, a sentence each.
    pub warnings: Vec<String>,
}

/// A curve less another one on the same grid.
pub(super) fn less(values: &[f64], others: &[f64]) -> Vec<f64> {
    let pairs = values.iter().zip(others);
    pairs.map(|(value, other)| value - other).collect()
}

/// What is said of a table that lies beside the range.
pub fn nothing_measured(band: Band, [first_nm, last_nm]: [f64; 2]) -> String {
    tr!(
        "Nothing was measured in {from}-{to} nm: the table covers {first}-{last} nm.",
        from = short(band.min_nm()),
        to = short(band.max_nm()),
        first = short(first_nm),
        last = short(last_nm)
    )
}

/// What is said of a composite that is shown as it is.
pub fn as_given_words(given: &Composite) -> String {
    tr!(
        "Shown as the composite that it is: its own {numbers} on {from}-{to} nm, {n} line among \
         them; nothing was analysed."
            | "Shown as the composite that it is: its own {numbers} on {from}-{to} nm, {n} lines \
               among them; nothing was analysed."
                % given.lines().len(),
        numbers = numbers(given.numbers()),
        from = short(given.band().min_nm()),
        to = short(given.band().max_nm())
    )
}

impl Derived {
    /// Answers the question: fit, errors, colours, patches and the whole order curve.
    pub fn of(question: Question<'_>, tables: &Tables) -> Self {
        let settings = question.settings;
        let band = tables.band();
        let fitted = Fitted::of(question, tables);
        let order = settings.effective_order();
        let (coefficients, exactness) = fitted.coefficients(order, tables);
        let smooth = tables.basis.evaluate(&coefficients);
        let mut residual = wide::with_bells(less(&smooth, question.measured), &fitted.bells);
        add_lines(band, &fitted.ideal, &mut residual);
        let colour = fitted.colour(question, tables, &coefficients);
        // Without a white there is nothing to bring patches to.
        let is_visible = colour.exact.is_some() && colour.model.is_some();
        let patches = is_visible
            .then(|| fitted.patches(question, tables, &coefficients))
            .flatten();
        let mut figures = fitted.spectrum_errors(question.measured, &smooth, tables);
        figures[Measure::Own] = colour.delta_e_2000;
        figures[Measure::Patches] = patches.as_ref().map(|p| p.mean);
        figures[Measure::PatchesWorst] = patches.as_ref().map(|p| p.max);
        let mut derived = Self {
            band,
            measured: question.measured.to_vec(),
            figures,
            model: Composite::of_lines_inside(
                Series {
                    band,
                    basis: settings.basis,
                    coefficients,
                },
                fitted.lines.clone(),
            ),
            smooth,
            residual,
            exactness: settings.colour_exact.then_some(exactness),
            colour,
            patches,
            curve: match question.curve {
                Some(curve) => curve.to_vec(),
                None => fitted.curve(question, tables),
            },
            parts: fitted.parts,
            bells: fitted.bells,
            warnings: Vec::new(),
        };
        derived.warnings = derived.warnings_for(question);
        derived
    }

    /// Whether there is a spectrum to be off: no [`why_no_errors`](Self::why_no_errors).
    pub fn has_errors(&self) -> bool {
        self.figures[Measure::Rms].is_some()
    }

    /// What is said where there are no errors: what was measured is zero, or so small that it cannot
    /// be brought to a height of 1.
    pub fn why_no_errors(&self) -> &'static str {
        if self.measured.iter().all(|value| *value == 0.0) {
            said!("The spectrum is zero over the whole range.")
        } else {
            said!("The spectrum's values are too small to compute with: none reaches 1e-308.")
        }
    }

    /// Numbers that the model takes: one more, the label, where a line has a width.
    pub fn numbers(&self) -> usize {
        self.model.numbers()
    }

    /// The model's lines of no width.
    pub fn ideal_spikes(&self) -> Vec<Line> {
        let lines = self.model.lines().iter().copied();
        lines.filter(|line| line.is_ideal()).collect()
    }

    /// The smooth part and the lines that have a width, on the grid.
    pub fn outline(&self) -> Vec<f64> {
        wide::with_bells(self.smooth.clone(), &self.bells)
    }

    /// The model with each line of no width split linearly over its two neighbouring nm, on the
    /// grid.
    pub fn model_values(&self) -> Vec<f64> {
        let mut values = self.outline();
        add_lines(self.band, &self.ideal_spikes(), &mut values);
        values
    }

    /// The width that a spike at a place is drawn with in every chart, nm: that of the line which it
    /// stands for; what a surface left of it is as wide.
    pub fn stem_width_at(&self, at_nm: f64) -> f64 {
        let spikes = self.model.lines();
        let same = |spike: &&Line| (spike.at_nm - at_nm).abs() < 1e-6;
        let index = spikes.iter().position(|spike| same(&spike));
        self.parts.stem_width_nm(index.unwrap_or(spikes.len()))
    }

    /// The model with each spike as a Gaussian of its line's own width, less what was measured.
    pub fn widened_residual(&self) -> Vec<f64> {
        let mut values = less(&self.smooth, &self.measured);
        for (i, spike) in self.model.lines().iter().enumerate() {
            let width = self.parts.stem_width_nm(i);
            let height = spike.stem_height(width);
            for (nm, value) in self.band.grid().zip(&mut values) {
                *value += height * gaussian((nm - spike.at_nm) / width);
            }
        }
        values
    }

    /// The parts of 380-780 nm that the range does not reach: "380-400 and 700-780".
    fn missing_visible(&self) -> Option<String> {
        let (min, max) = (self.band.min_nm(), self.band.max_nm());
        let (first, last) = (Band::VISIBLE.min_nm(), Band::VISIBLE.max_nm());
        let range = |ends: [f64; 2]| {
            let [from, to] = ends.map(short);
            format!("{from}-{to}")
        };
        let below = (min > first).then(|| range([first, min.min(last)]));
        let above = (max < last).then(|| range([max.max(first), last]));
        match (below, above) {
            (Some(below), Some(above)) => Some(tr!("{below} and {above}", below, above)),
            (below, above) => below.or(above),
        }
    }

    fn warnings_for(&self, question: Question<'_>) -> Vec<String> {
        let settings = question.settings;
        let mut warnings = Vec::new();
        if let Some(given) = question.given {
            warnings.push(as_given_words(given));
        }
        let [first_nm, last_nm] = question.table_nm;
        let is_beside = first_nm > self.band.max_nm() || last_nm < self.band.min_nm();
        warnings.extend(self.why_no_colour(question, is_beside));
        if question.power_outside > 0.5 && !is_beside {
            warnings.push(tr!(
                "{share} % of the light's power is outside {from}-{to} nm.",
                share = fixed(100.0 * question.power_outside, 1),
                from = short(self.band.min_nm()),
                to = short(self.band.max_nm())
            ));
        }
        if settings.order > settings.effective_order() {
            warnings.push(tr!(
                "Order cut to {order}: the range has one point per nm, which carries no more.",
                order = settings.effective_order()
            ));
        }
        warnings.extend(self.why_not_exact().map(str::to_owned));
        if let Some(missing) = self.missing_visible() {
            let share = 100.0 * self.colour.missing_luminance;
            warnings.push(if share > 100.0 * WORTH_SAYING {
                tr!(
                    "The range leaves out {missing} nm of the visible, {share} % of the light's \
                     luminance.",
                    missing,
                    share = fixed(share, 1)
                )
            } else {
                tr!("The range leaves out {missing} nm of the visible.", missing)
            });
        }
        warnings.extend(self.observer_ends(settings.observer));
        warnings.extend(question.more_than_a_fraction());
        if !is_beside && (first_nm > self.band.min_nm() || last_nm < self.band.max_nm()) {
            let [first, last] = question.table_nm.map(short);
            warnings.push(match question.is_light {
                true => tr!(
                    "Measured from {first} to {last} nm; beyond, the light is taken for zero.",
                    first,
                    last
                ),
                false => tr!(
                    "Measured from {first} to {last} nm; beyond, its end values are used.",
                    first,
                    last
                ),
            });
        }
        if let Some(colour) = self.colour.exact
            && self.colour.model.is_some()
            && !colour.swatch.in_gamut
        {
            warnings.push(tr!(
                "This screen cannot show the colour exactly: {how}.",
                how = crate::languages::said(colour.swatch.mapping.words())
            ));
        }
        if let Some(lowest) = self.figures[Measure::Lowest]
            && lowest < -WORTH_SAYING
        {
            warnings.push(tr!(
                "The waves dip below zero, to {lowest} % of the peak.",
                lowest = fixed(100.0 * lowest, 1)
            ));
        }
        warnings
    }

    /// What an observer's table leaves out of the range.
    fn observer_ends(&self, observer: Observer) -> Option<String> {
        let table = observer.table();
        let [first, last] = [table.first_nm, table.last_nm];
        let is_short =
            f64::from(first) > self.band.min_nm() || f64::from(last) < self.band.max_nm();
        (is_short && !observer.is_shipped()).then(|| {
            let title = observer.title();
            tr!(
                "The observer {title} is known from {first} to {last} nm: beyond, nothing counts.",
                title,
                first,
                last
            )
        })
    }

    /// Why there are no errors, or no colours to compare.
    fn why_no_colour(&self, question: Question<'_>, is_beside: bool) -> Option<String> {
        if is_beside {
            let mut said = nothing_measured(self.band, question.table_nm);
            if !question.is_light {
                said += " ";
                said += said!("What is shown is its nearest value, held.");
            }
            return Some(said);
        }
        let said = if !self.has_errors() {
            self.why_no_errors()
        } else if self.colour.exact.is_some() && self.colour.model.is_none() {
            said!("The model's X, Y, Z are not all positive: it has no colour to compare.")
        } else if self.colour.exact.is_none() {
            said!("No visible light in this range (X, Y, Z are not positive): there is no colour.")
        } else {
            return None;
        };
        Some(said.to_owned())
    }

    fn why_not_exact(&self) -> Option<&'static str> {
        match self.exactness? {
            Exactness::TooFewNumbers => Some(said!(
                "Colour-exact needs order 1 or more: plain least squares used."
            )),
            Exactness::IllConditioned { .. } => Some(said!(
                "This range does not tell X, Y and Z apart: plain least squares used."
            )),
            Exactness::Exact { .. } => None,
        }
    }
}

impl Question<'_> {
    fn more_than_a_fraction(&self) -> Option<String> {
        let top = self.measured.iter().copied().fold(0.0, f64::max);
        (!self.is_light && top > LARGEST_FRACTION).then(|| {
            // What was divided already is asked about no more.
            let question = if self.is_divided {
                said!("Per cent was taken out already: noise, or more light than fell on it?")
            } else {
                said!("Are they per cent, or a light?")
            };
            let reach = tr!(
                "Values reach {top}: a reflectance is a fraction up to 1.",
                top = short(top)
            );
            format!("{reach} {question}")
        })
    }
}

/// Measured fractions above this are no fractions: bright fluorescent surfaces stay below.
const LARGEST_FRACTION: f64 = 2.0;

/// Shares below this go without a word.
const WORTH_SAYING: f64 = 0.001;
