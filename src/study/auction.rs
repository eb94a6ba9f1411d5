//! Auction of the next numbers: one more order, one more spike, or widths.
//!
//! An order and a spike cost two numbers each. One number alone buys that lines are as wide as they
//! are: it says so of all of them, since a width shares a word with its line's place. From order 0
//! on the auction buys whatever lowers the goal most at its price. One purchase alone is short-sighted (a line may only pay once the smooth part has
//! another order), so every model is followed by all single purchases and the best one by all
//! pairs; and at every price the plain models are bid too, all orders with none, one, two ... of
//! the heaviest lines, ideal and wide. What is sold at each price is the best model seen at that price, or one
//! within a twentieth of it that keeps what was bought before; otherwise something is given back,
//! and the step says what. It is never worse than the better of "with" and "without" spikes, and
//! a price at which nothing better is for sale is left out: every step lowers the error. The
//! auction ends when nothing lowers the goal.

use std::collections::BTreeMap;

use super::{
    goal::Goal,
    measure::Verdict,
    progress::Progress,
    projected_spectrum::ProjectedSpectrum,
    reference::Reference,
    sweep::{Examined, Subject},
};
use crate::spectrum::{Basis, Line, LineShape, numbers_of_order};

/// Terms of an auction.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Terms {
    /// Functions of the smooth part.
    pub basis: Basis,
    /// True if the subject's own colour is made exact.
    pub colour_exact: bool,
    /// Goal to minimise.
    pub goal: Goal,
    /// Most numbers that may be spent.
    pub numbers: usize,
}

/// Something that numbers buy.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub enum Purchase {
    /// That the lines are as wide as they are, for one number.
    Widths,
    /// The smooth part's next order.
    Order(usize),
    /// A line as a spike (weight over the spectrum's largest value).
    Line(Line),
}

/// One step of the path.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Step {
    /// Purchases of this step; empty in the first step, which is order 0.
    pub bought: Vec<Purchase>,
    /// Purchases given back in exchange.
    pub gave_back: Vec<Purchase>,
    /// Numbers spent so far.
    pub numbers: usize,
    /// The goal: of a plain goal the error itself, of a mixed one the weighted mean of the errors,
    /// each over its value at order 0.
    pub error: f64,
    /// Order of the smooth part.
    pub order: usize,
    /// The lines that are spikes, heaviest first, as indices into [`Auction::lines`].
    pub lines: Vec<usize>,
    /// True if the lines have their own widths.
    pub wide: bool,
    /// Every figure of the model.
    pub verdict: Verdict,
}

/// Reason for the end of an auction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Ended {
    /// The budget was spent, or less than two numbers were left.
    Spent,
    /// Nothing within the budget lowered the goal any more.
    NothingHelps,
}

/// A plain model at a price, for comparison.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Bid {
    /// Numbers.
    pub numbers: usize,
    /// The goal.
    pub error: f64,
}

/// The result of an auction.
#[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Auction {
    /// The path, by rising numbers and falling error.
    pub steps: Vec<Step>,
    /// The lines on offer, heaviest first; weights over the spectrum's largest value.
    pub lines: Vec<Line>,
    /// All lines as spikes, every order that the budget allows.
    pub with: Vec<Bid>,
    /// No spikes, every order that the budget allows.
    pub without: Vec<Bid>,
    /// Reason for its end.
    pub ended: Ended,
}

impl Auction {
    /// The model that was bought in the end.
    pub fn last(&self) -> &Step {
        &self.steps[self.steps.len() - 1]
    }
}

/// Lines that can be bought one by one: the heaviest. The others only come with all heavier ones.
const SINGLY: usize = 24;

/// Models of each price whose single purchases are all tried.
const FOLLOWED: usize = 8;

/// Least improvement, as a share, for which the best model replaces one that keeps past purchases.
const LOYALTY: f64 = 0.05;

/// Errors closer than this share of the one at order 0 are equal but for rounding.
const ROUNDING: f64 = 1e-9;

/// Holds the auction; `None` for an all-zero spectrum, a goal that cannot be measured on it, or
/// when it was cancelled.
pub fn hold(subject: &Subject, terms: Terms, progress: &Progress) -> Option<Auction> {
    let terms = Terms {
        goal: terms.goal.clamped(),
        numbers: terms.numbers.max(1),
        ..terms
    };
    let examined = Examined::of(subject, terms.numbers)?;
    hold_on(&examined, terms, progress)
}

/// [`hold`] on a subject that was examined already.
pub(crate) fn hold_on(examined: &Examined, terms: Terms, progress: &Progress) -> Option<Auction> {
    let stock = Stock::new(examined, terms.basis);
    let mut room = ResidualState::new(&examined.reference, &stock, terms)?;
    progress.expect(terms.numbers);
    for numbers in 1..=terms.numbers {
        if progress.is_cancelled() {
            return None;
        }
        room.bid_plain(numbers);
        room.follow(numbers);
        progress.step();
    }
    Some(room.close())
}

/// A model as a choice: the order, the lines, and whether these have widths.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Choice {
    order: usize,
    lines: Vec<usize>,
    wide: bool,
}

impl Choice {
    const START: Self = Self {
        order: 0,
        lines: Vec::new(),
        wide: false,
    };

    /// The heaviest lines.
    fn heaviest(order: usize, lines: usize, wide: bool) -> Self {
        Self {
            order,
            lines: (0..lines).collect(),
            wide,
        }
    }

    fn with_order(&self) -> Self {
        Self {
            order: self.order + 1,
            ..self.clone()
        }
    }

    fn with_line(&self, line: usize) -> Option<Self> {
        let at = self.lines.binary_search(&line).err()?;
        let mut with = self.clone();
        with.lines.insert(at, line);
        Some(with)
    }

    fn with_widths(&self) -> Option<Self> {
        (!self.wide).then(|| Self {
            wide: true,
            ..self.clone()
        })
    }

    /// Everything that one purchase makes of it.
    fn next(&self, lines: usize) -> Vec<Self> {
        std::iter::once(self.with_order())
            .chain(self.with_widths())
            .chain((0..lines).filter_map(|line| self.with_line(line)))
            .collect()
    }

    /// Numbers it takes.
    fn numbers(&self) -> usize {
        numbers_of_order(self.order) + 2 * self.lines.len() + usize::from(self.wide)
    }
}

/// Models for sale: the spectrum with its lines ideal, and with those that have a width as profiles.
struct Stock<'a> {
    ideal: ProjectedSpectrum,
    wide: ProjectedSpectrum,
    profiles: &'a [Option<LineShape>],
}

impl<'a> Stock<'a> {
    fn new(examined: &'a Examined, basis: Basis) -> Self {
        let projected = |profiles: &[Option<LineShape>]| {
            examined.projected_with(basis, &examined.shapes, profiles)
        };
        Self {
            ideal: projected(&[]),
            wide: projected(&examined.profiles),
            profiles: &examined.profiles,
        }
    }

    fn profile(&self, line: usize) -> Option<&LineShape> {
        self.profiles.get(line)?.as_ref()
    }

    /// True if a model is for sale: widths are sold with a line that has one.
    fn has(&self, choice: &Choice) -> bool {
        !choice.wide
            || choice
                .lines
                .iter()
                .any(|line| self.profile(*line).is_some())
    }

    /// A model's values on the grid, its lines with a width among them, and the ideal ones.
    fn model(&self, choice: &Choice, colour_exact: bool) -> (Vec<f64>, Vec<Line>) {
        let projected = if choice.wide { &self.wide } else { &self.ideal };
        let numbers = numbers_of_order(choice.order);
        let (model, _) = projected.model(numbers, &choice.lines, colour_exact);
        let mut values = projected.smooth(&model);
        if !choice.wide {
            return (values, model.into_parts().1);
        }
        let mut ideal = Vec::new();
        for line in &choice.lines {
            match self.profile(*line) {
                Some(profile) => profile.give_back_to(&mut values),
                None => ideal.push(projected.spike(*line)),
            }
        }
        (values, ideal)
    }
}

/// The saleroom: every model bid so far, by the numbers that it takes.
struct ResidualState<'a> {
    reference: &'a Reference,
    stock: &'a Stock<'a>,
    terms: Terms,
    /// The errors at order 0, which a mixed goal divides by.
    at_start: Verdict,
    bids: Vec<BTreeMap<Choice, f64>>,
    highest_order: usize,
}

impl<'a> ResidualState<'a> {
    fn new(reference: &'a Reference, stock: &'a Stock<'a>, terms: Terms) -> Option<Self> {
        let band = reference.measures().band();
        let mut room = Self {
            reference,
            stock,
            terms,
            at_start: Verdict::default(),
            bids: vec![BTreeMap::new(); terms.numbers + 1],
            highest_order: Basis::highest_order(band).min((terms.numbers - 1) / 2),
        };
        let (values, spikes) = stock.model(&Choice::START, terms.colour_exact);
        room.at_start = terms.goal.errors(reference, &values, &spikes);
        // A goal none of whose parts can be measured (patches of a reflectance) is no goal.
        let mut measures = Goal::MEASURES.into_iter();
        measures.any(|m| room.at_start[m].is_some()).then_some(room)
    }

    fn error(&self, choice: &Choice) -> f64 {
        let (values, spikes) = self.stock.model(choice, self.terms.colour_exact);
        let goal = self.terms.goal;
        let errors = goal.errors(self.reference, &values, &spikes);
        goal.error(&errors, &self.at_start).unwrap_or(0.0)
    }

    fn lines(&self) -> usize {
        self.stock.ideal.lines()
    }

    fn bid(&mut self, choice: Choice) {
        let numbers = choice.numbers();
        if numbers > self.terms.numbers
            || choice.order > self.highest_order
            || !self.stock.has(&choice)
        {
            return;
        }
        if !self.bids[numbers].contains_key(&choice) {
            let error = self.error(&choice);
            self.bids[numbers].insert(choice, error);
        }
    }

    /// The plain models of a price: none, one, two ... of the heaviest lines. An even count of
    /// numbers is that of lines with widths.
    fn bid_plain(&mut self, numbers: usize) {
        let (count, wide) = ((numbers - 1) / 2, numbers.is_multiple_of(2));
        for lines in 0..=count.min(self.lines()) {
            self.bid(Choice::heaviest(count - lines, lines, wide));
        }
    }

    /// Every single purchase after the best models of a price, and every pair after the best one.
    fn follow(&mut self, numbers: usize) {
        let lines = self.lines().min(SINGLY);
        for (place, choice) in self.best_of(numbers, FOLLOWED).into_iter().enumerate() {
            for next in choice.next(lines) {
                if place == 0 {
                    for second in next.next(lines) {
                        self.bid(second);
                    }
                }
                self.bid(next);
            }
        }
    }

    fn best_of(&self, numbers: usize, most: usize) -> Vec<Choice> {
        let bids = self.bids[numbers].iter();
        let mut sorted: Vec<(&Choice, f64)> =
            bids.map(|(choice, error)| (choice, *error)).collect();
        sorted.sort_by(|a, b| a.1.total_cmp(&b.1));
        sorted
            .into_iter()
            .take(most)
            .map(|(choice, _)| choice.clone())
            .collect()
    }

    /// The best model of a price; one that contains `now` when it is nearly as good and no plain
    /// model is better.
    fn pick(&self, numbers: usize, now: &Choice) -> Option<Choice> {
        let best = self.best_of(numbers, 1).into_iter().next()?;
        let bids = &self.bids[numbers];
        let is_plain = |choice: &Choice| {
            let lines = choice.lines.len();
            (lines == 0 || lines == self.lines()) && choice.lines.iter().copied().eq(0..lines)
        };
        let bar = bids
            .iter()
            .filter(|(choice, _)| is_plain(choice))
            .map(|(_, error)| *error)
            .fold(bids[&best] * (1.0 + LOYALTY), f64::min);
        let contains = |choice: &Choice| {
            choice.order >= now.order
                && choice.wide >= now.wide
                && now.lines.iter().all(|line| choice.lines.contains(line))
        };
        bids.iter()
            .filter(|(choice, error)| **error <= bar && contains(choice))
            .min_by(|a, b| a.1.total_cmp(b.1))
            .map(|(choice, _)| choice.clone())
            .or(Some(best))
    }

    /// Reads the path off the bids.
    fn close(self) -> Auction {
        let mut steps: Vec<Step> = Vec::new();
        let mut best = f64::INFINITY;
        let mut now = Choice::START;
        let start = self.bids[1].values().copied().next().unwrap_or(0.0);
        for numbers in 1..=self.terms.numbers {
            let Some(choice) = self.pick(numbers, &now) else {
                continue;
            };
            let error = self.bids[numbers][&choice];
            if error >= best - ROUNDING * start && numbers > 1 {
                continue;
            }
            best = error;
            steps.push(self.step(&now, &choice, error));
            now = choice;
        }
        let spent = steps
            .last()
            .is_some_and(|s| s.numbers + 2 > self.terms.numbers);
        let plain = |lines: usize| -> Vec<Bid> {
            (0..=self.highest_order)
                .filter_map(|order| {
                    let choice = Choice::heaviest(order, lines, false);
                    let numbers = choice.numbers();
                    let error = *self.bids.get(numbers)?.get(&choice)?;
                    Some(Bid { numbers, error })
                })
                .collect()
        };
        Auction {
            with: plain(self.lines()),
            without: plain(0),
            lines: (0..self.lines())
                .map(|i| self.stock.ideal.spike(i))
                .collect(),
            steps,
            ended: if spent {
                Ended::Spent
            } else {
                Ended::NothingHelps
            },
        }
    }

    fn step(&self, before: &Choice, now: &Choice, error: f64) -> Step {
        let only_in = |a: &Choice, b: &Choice| -> Vec<Purchase> {
            let orders = (b.order + 1..=a.order).map(Purchase::Order);
            let lines = a.lines.iter().filter(|line| !b.lines.contains(line));
            let widths = (a.wide && !b.wide).then_some(Purchase::Widths);
            lines
                .map(|line| Purchase::Line(self.stock.ideal.spike(*line)))
                .chain(widths)
                .chain(orders)
                .collect()
        };
        let (values, spikes) = self.stock.model(now, self.terms.colour_exact);
        Step {
            bought: only_in(now, before),
            gave_back: only_in(before, now),
            numbers: now.numbers(),
            error,
            order: now.order,
            lines: now.lines.clone(),
            wide: now.wide,
            verdict: self.reference.verdict(&values, &spikes),
        }
    }
}
