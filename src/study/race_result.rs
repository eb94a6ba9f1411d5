//! Racers, the set-up of a race and its results: runs, spreads, rows and winners.

use std::{fmt::Debug, sync::Arc};

use super::{
    error::Spread,
    measure::{ByMeasure, Measure, Verdict},
    reference::Measures,
    training::{Lamp, Training},
    way::FitVariant,
};
use crate::{
    rivals::{Family, PrincipalBasis},
    spectrum::SpikeSettings,
};

/// A competitor in the race.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
pub enum Racer {
    /// A composite, or its smooth part alone.
    Composite(FitVariant),
    /// Cosines and lines of their own width.
    WideLines,
    /// Known lamps, cosines and lines of their own width.
    KnownLamps,
    /// Another representation.
    Rival(Family),
    /// For each light the composite that is best on the patches: what the program would choose.
    Chosen,
}

impl Racer {
    /// Racers that an [`Encode`] produces from a light.
    pub(crate) const ENCODED: [Self; 2] = [Self::WideLines, Self::KnownLamps];

    /// Everybody, composites first.
    pub(crate) fn all() -> impl Iterator<Item = Self> + Clone {
        FitVariant::ALL
            .into_iter()
            .map(Self::Composite)
            .chain(Self::ENCODED)
            .chain(Family::ALL.into_iter().map(Self::Rival))
            .chain([Self::Chosen])
    }

    /// The word used in files.
    pub(crate) fn word(self) -> &'static str {
        match self {
            Self::Composite(way) => way.word(),
            Self::WideLines => "wide-lines",
            Self::KnownLamps => "known-lamps",
            Self::Rival(family) => family.about().word,
            Self::Chosen => "chosen",
        }
    }

    /// In words for people.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Composite(way) => way.title(),
            Self::WideLines => later!("Wide lines"),
            Self::KnownLamps => later!("Known lamps + lines"),
            Self::Rival(family) => family.about().title,
            Self::Chosen => later!("Best composite, chosen per light"),
        }
    }

    /// True if fewer numbers are a prefix of more: one fit, truncated at will. With spikes the
    /// smooth part's numbers depend on which lines were taken out.
    pub(crate) fn is_prefix(self) -> bool {
        match self {
            Self::Composite(way) => !way.spikes && !way.colour_exact,
            // Another count may be fitted with the table of another class.
            Self::Rival(Family::Principal) | Self::Chosen => false,
            Self::WideLines | Self::KnownLamps => false,
            Self::Rival(family) => family.is_prefix(),
        }
    }

    /// True if its numbers are meaningless without a table that is not counted among them.
    pub(crate) fn needs_table(self) -> bool {
        match self {
            Self::KnownLamps => true,
            Self::Rival(family) => family.needs_table(),
            Self::Composite(_) | Self::WideLines | Self::Chosen => false,
        }
    }
}

/// Encodes lights for [`Racer::ENCODED`]; made above this room.
pub trait Encode: Debug + Send + Sync {
    /// A light (its values on the grid, 1 at most) in at most so many numbers, with known lamps or
    /// without; no table holds the light at hand. Nothing where it cannot be encoded so.
    fn encoded(&self, lamp: &Lamp, numbers: usize, known_lamps: bool) -> Option<Box<dyn Encoded>>;
}

/// A light as an encoder stores it.
pub trait Encoded {
    /// Numbers it takes.
    fn numbers(&self) -> usize;
    /// Lines among them.
    fn lines(&self) -> usize;
    /// Bytes of its numbers.
    fn bytes(&self) -> usize;
    /// The light on the grid.
    fn on_band(&self) -> Vec<f64>;
    /// The light at a wavelength, without lines of no width.
    fn at(&self, nm: f64) -> f64;
}

/// Everything that a race is run on, all on one band.
#[derive(Clone, Debug)]
pub struct RaceConfig {
    /// Measures with the patches that choose.
    pub measures: Arc<Measures>,
    /// The patches' reflectances.
    pub patches: Vec<Vec<f64>>,
    /// Reflectances that judge without having taken part in a choice.
    pub check: Vec<Vec<f64>>,
    /// Components for lights.
    pub lights: Arc<Training>,
    /// Components for reflectances, trained without patches and check.
    pub reflectances: Arc<PrincipalBasis>,
    /// Settings of the line detector.
    pub spikes: SpikeSettings,
    /// Encodes for `Racer::ENCODED`, who do not race without it.
    pub encoder: Option<Arc<dyn Encode>>,
    /// Counts of numbers, rising.
    pub budgets: Vec<usize>,
}

/// Result of one racer on one light at one count.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Run {
    /// Numbers it took, at most the budget.
    pub numbers: usize,
    /// Spikes among them (two numbers each; a line with a width of its own three, where it is counted).
    pub spikes: usize,
    /// Its errors.
    pub verdict: Verdict,
    /// Mean CIEDE2000 of the check reflectances.
    pub check: Option<f64>,
    /// Mean CIEDE2000 behind narrow filters that took no part in a choice.
    pub check_filters: Option<f64>,
}

/// Cost of a racer at one count, measured in this run on [`Race::cost_of`].
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Cost {
    /// Bytes of the stored numbers of one spectrum.
    pub bytes: usize,
    /// Values that a product multiplies.
    pub points: usize,
    /// From the stored numbers of a light and a reflectance to their product's values, ns.
    pub ns_per_product: f64,
    /// One value at one wavelength, ns.
    pub ns_per_evaluation: f64,
}

/// A whole race.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Race {
    /// Names and classes of the lights that shine.
    pub lamps: Vec<(String, String)>,
    /// Counts of numbers, rising.
    pub budgets: Vec<usize>,
    /// Everybody who ran.
    pub racers: Vec<Racer>,
    /// The light that costs were measured on: that with most lines, so that spikes cost.
    pub cost_of: String,
    /// By light, then count, then racer.
    pub(super) runs: Vec<Run>,
    /// By count, then racer.
    pub(super) costs: Vec<Option<Cost>>,
}

/// One line of the result.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Who.
    pub racer: Racer,
    /// The budget.
    pub numbers: usize,
    /// Lights counted.
    pub lamps: usize,
    /// Every figure over the lights.
    pub spreads: ByMeasure<Option<Spread>>,
    /// Mean of the check reflectances.
    pub check: Option<Spread>,
    /// Share of the lights that dip below -0.1 % of their peak.
    pub negative_lobes: f64,
    /// Its cost; [`Racer::Chosen`] has none of its own.
    pub cost: Option<Cost>,
}

/// A dip below zero that counts, as a share of the peak.
const A_LOBE: f64 = 1e-3;

impl Race {
    /// Run of a racer on a light at a count, by their indices.
    pub fn run(&self, lamp: usize, budget: usize, racer: usize) -> &Run {
        &self.runs[(lamp * self.budgets.len() + budget) * self.racers.len() + racer]
    }

    /// Cost of a racer at a count, by their indices.
    pub(crate) fn cost(&self, budget: usize, racer: usize) -> Option<Cost> {
        self.costs[budget * self.racers.len() + racer]
    }

    /// The classes in the order of their first light.
    pub(crate) fn classes(&self) -> Vec<&str> {
        let mut classes: Vec<&str> = Vec::new();
        for (_, class) in &self.lamps {
            if !classes.contains(&class.as_str()) {
                classes.push(class);
            }
        }
        classes
    }

    /// The lights of a class, by place; of all classes without one.
    pub(crate) fn of_class<'a>(
        &'a self,
        class: Option<&'a str>,
    ) -> impl Iterator<Item = usize> + 'a {
        let wanted = move |own: &str| class.is_none_or(|class| class == own);
        (0..self.lamps.len()).filter(move |i| wanted(&self.lamps[*i].1))
    }

    /// A figure over a class (or all) at a count; `None` where no light has it.
    pub fn spread(
        &self,
        class: Option<&str>,
        budget: usize,
        racer: usize,
        measure: Measure,
    ) -> Option<Spread> {
        let error = |lamp: usize| self.run(lamp, budget, racer).verdict[measure];
        Spread::of(&self.of_class(class).filter_map(error).collect::<Vec<_>>())
    }

    /// A racer's line over a class (or all) at a count.
    pub fn row(&self, class: Option<&str>, budget: usize, racer: usize) -> Row {
        let run = |lamp: usize| self.run(lamp, budget, racer);
        let runs: Vec<&Run> = self.of_class(class).map(run).collect();
        let checks: Vec<f64> = runs.iter().filter_map(|run| run.check).collect();
        let dips = |run: &&&Run| run.verdict[Measure::Lowest].is_some_and(|low| low < -A_LOBE);
        Row {
            racer: self.racers[racer],
            numbers: self.budgets[budget],
            lamps: runs.len(),
            spreads: ByMeasure::from_fn(|measure| self.spread(class, budget, racer, measure)),
            check: Spread::of(&checks),
            negative_lobes: runs.iter().filter(dips).count() as f64 / runs.len().max(1) as f64,
            cost: self.cost(budget, racer),
        }
    }

    /// The racer with the least error on one light; [`Racer::Chosen`] is one of the others again
    /// and does not count.
    pub(crate) fn winner_on(&self, lamp: usize, budget: usize, measure: Measure) -> Option<Racer> {
        self.best(|racer| self.run(lamp, budget, racer).verdict[measure])
    }

    /// The racer with the least median over a class (or all).
    pub(crate) fn winner_of(
        &self,
        class: Option<&str>,
        budget: usize,
        measure: Measure,
    ) -> Option<Racer> {
        self.best(|racer| {
            let spread = self.spread(class, budget, racer, measure);
            spread.map(|spread| spread.median)
        })
    }

    fn best(&self, error: impl Fn(usize) -> Option<f64>) -> Option<Racer> {
        (0..self.racers.len())
            .filter(|racer| self.racers[*racer] != Racer::Chosen)
            .filter_map(|racer| Some((racer, error(racer)?)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map(|(racer, _)| self.racers[racer])
    }
}
