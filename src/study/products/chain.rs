//! A light through a chain of factors: exact beside model at every stage.

use super::Colours;
use crate::{
    color::{Weights, Xyz, delta_e_of_xyz, xyz_of_parts},
    spectrum::{
        Band, ChainTables, Composite, Factor, Line, LineInDip, Sampling, below_zero,
        product::multiply,
    },
    study::error::Spread,
};

/// The light of a product, and the settings for forming and viewing it.
#[derive(Clone, Copy, Debug)]
pub struct Product<'a> {
    /// The light as measured, on the band's grid.
    pub measured: &'a [f64],
    /// The light's model. Its lines are weighed at their centres; a width counts where a line meets
    /// a dip of a factor.
    pub model: &'a Composite,
    /// Method of forming products.
    pub sampling: Sampling,
    /// Colour-matching functions on the band's grid.
    pub seen: &'a Weights,
    /// Full width with which a spike is drawn, nm: decides which dips go below zero.
    pub width_nm: f64,
}

/// The light behind one factor.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Measured light times measured factors, on the grid.
    pub exact: Vec<f64>,
    /// The model's smooth part on the grid.
    pub smooth: Vec<f64>,
    /// The model's spikes, carried exactly.
    pub spikes: Vec<Line>,
    /// Both colours: what the whole model is off by so far.
    pub colours: Colours,
    /// CIEDE2000 that forming the products adds: against the exact product of the very same model
    /// and series.
    pub added: Option<f64>,
    /// `Y out / Y in` of this factor, exact and model; `None` where no light comes in.
    pub transmission: [Option<f64>; 2],
    /// Share of the product's power that the points fold back (a convolution: cuts off).
    pub folded_share: f64,
    /// Multiplications of this factor.
    pub multiplications: usize,
    /// Lines of the light that stood on a dip of this factor.
    pub met: Vec<LineInDip>,
    /// Places (nm) where a dip takes the total below zero.
    pub below_zero: Vec<f64>,
    /// Places (nm) of lines that the factors' series have turned negative: a short series of a
    /// dark filter rings below zero.
    pub turned: Vec<f64>,
}

/// A light through a whole chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    /// XYZ of the exact light, value x nm: the white of every difference.
    pub white: Xyz,
    /// The light before the first factor.
    pub light: Colours,
    /// The light behind each factor in turn.
    pub steps: Vec<Step>,
}

/// A chain as one product.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Total {
    /// Both colours of what comes out.
    pub colours: Colours,
    /// CIEDE2000 that forming the products adds.
    pub added: Option<f64>,
    /// `Y out / Y in` of the whole chain, exact and model.
    pub transmission: [Option<f64>; 2],
    /// Share of the product's power that is folded back or cut off.
    pub folded_share: f64,
    /// Multiplications of all factors.
    pub multiplications: usize,
}

impl Passage {
    /// The same passage with runs of steps told as one: `counts` says how many each has, as when
    /// a light bounces several times off the same surface. Runs without a step are left out.
    #[must_use]
    pub(crate) fn grouped(self, counts: &[usize]) -> Self {
        let mut before = self.light;
        let mut steps = self.steps.into_iter();
        let mut groups = Vec::with_capacity(counts.len());
        for count in counts {
            let run: Vec<Step> = steps.by_ref().take(*count).collect();
            let multiplications = run.iter().map(|step| step.multiplications).sum();
            let mut met: Vec<LineInDip> = run.iter().flat_map(|step| step.met.clone()).collect();
            met.dedup_by(|a, b| a == b);
            let Some(last) = run.into_iter().next_back() else {
                continue;
            };
            let after = last.colours;
            groups.push(Step {
                transmission: after.transmission(&before),
                multiplications,
                met,
                ..last
            });
            before = after;
        }
        Self {
            steps: groups,
            ..self
        }
    }

    /// The chain as one product; without factors the light itself.
    pub(crate) fn total(&self) -> Total {
        let last = self.steps.last();
        let colours = last.map_or(self.light, |step| step.colours);
        Total {
            colours,
            added: last.map_or(Some(0.0), |step| step.added),
            transmission: colours.transmission(&self.light),
            folded_share: last.map_or(0.0, |step| step.folded_share),
            multiplications: self.steps.iter().map(|step| step.multiplications).sum(),
        }
    }
}

/// Errors of one light with every factor of a set, each alone behind it.
#[derive(Clone, Debug, PartialEq)]
pub struct SetErrors {
    /// Number of factors measured.
    pub count: usize,
    /// Error added by forming the product; `None` when nothing has a colour.
    pub added: Option<Spread>,
    /// Error of the whole model.
    pub total: Option<Spread>,
    /// Each factor's added and total CIEDE2000, in the order of the set.
    pub each: Vec<[Option<f64>; 2]>,
}

impl Product<'_> {
    fn band(&self) -> Band {
        self.model.band()
    }

    /// XYZ of the exact light.
    pub fn white(&self) -> Xyz {
        xyz_of_parts(self.band(), self.measured, &[], self.seen)
    }

    /// Sends the light through factors, one after the other.
    ///
    /// # Panics
    /// When a curve does not have [`Band::points`] values.
    pub fn through(&self, factors: &[Factor]) -> Passage {
        let tables = ChainTables::for_light(self.model, self.sampling, factors.len());
        self.through_by(&tables, factors)
    }

    /// The same with tables that are there already.
    ///
    /// # Panics
    /// As [`ChainTables::pass`].
    pub(crate) fn through_by(&self, tables: &ChainTables, factors: &[Factor]) -> Passage {
        self.beginning_with(self.light(), tables, factors)
    }

    /// The light before any factor.
    fn light(&self) -> Colours {
        let white = self.white();
        let smooth = self.model.smooth().on_band();
        let own = xyz_of_parts(
            self.band(),
            &smooth,
            self.model.idealised().lines(),
            self.seen,
        );
        Colours::of(white, own, white)
    }

    fn beginning_with(&self, light: Colours, tables: &ChainTables, factors: &[Factor]) -> Passage {
        let (band, white) = (self.band(), light.exact);
        let mut exact = self.measured.to_vec();
        let mut before = light;
        let stages = tables.pass(self.model, factors);
        let steps = stages.into_iter().zip(factors).map(|(stage, factor)| {
            exact = multiply(&exact, factor.values());
            let model = xyz_of_parts(band, &stage.smooth, &stage.spikes, self.seen);
            let colours = Colours::of(xyz_of_parts(band, &exact, &[], self.seen), model, white);
            let unfolded = xyz_of_parts(band, &stage.unfolded, &stage.spikes, self.seen);
            let is_line = |nm: f64| {
                let mut lines = self.model.lines().iter().filter(|s| s.weight > 0.0);
                lines.any(|s| s.at_nm == nm)
            };
            let negative = stage.spikes.iter().filter(|s| s.weight < 0.0);
            let (turned, dips): (Vec<Line>, Vec<Line>) =
                negative.copied().partition(|s| is_line(s.at_nm));
            let step = Step {
                exact: exact.clone(),
                colours,
                added: delta_e_of_xyz(unfolded, model, white),
                transmission: colours.transmission(&before),
                folded_share: stage.folded_share,
                multiplications: stage.multiplications,
                below_zero: below_zero(band, &stage.smooth, &dips, self.width_nm),
                turned: turned.iter().map(|s| s.at_nm).collect(),
                met: stage.met,
                smooth: stage.smooth,
                spikes: stage.spikes,
            };
            before = colours;
            step
        });
        Passage {
            white,
            light,
            steps: steps.collect(),
        }
    }

    /// The light with each factor of a set alone.
    ///
    /// # Panics
    /// When a curve does not have [`Band::points`] values.
    pub fn over(&self, set: &[Factor]) -> SetErrors {
        let tables = ChainTables::for_light(self.model, self.sampling, 1);
        let light = self.light();
        let each: Vec<[Option<f64>; 2]> = set
            .iter()
            .map(|factor| {
                let passage = self.beginning_with(light, &tables, std::slice::from_ref(factor));
                let total = passage.total();
                [total.added, total.colours.delta_e_2000]
            })
            .collect();
        let spread = |which: usize| {
            let found: Vec<f64> = each.iter().filter_map(|errors| errors[which]).collect();
            Spread::of(&found)
        };
        SetErrors {
            count: set.len(),
            added: spread(0),
            total: spread(1),
            each,
        }
    }
}
