//! Lines of a colour: what powers they can have, and which show colours best at a floor of efficacy.
//!
//! Three lines of a colour have fixed shares; four have one share free, and along it the figure
//! has a sharp kinked top.

use super::against::Against;
use crate::design::{
    scales::{BASIC, LUMENS_PER_WATT, SampleTables, Scales},
    small::solved,
};

/// Shares below zero by rounding.
const ROUNDING: f64 = 1e-12;

/// Digits of the free share: golden sections after the first look.
const SECTIONS: usize = 8;

/// Lines of unit power at whole nm, straight in between, with the sums of one figure.
pub(super) struct LineSearch<'a> {
    pub(super) first_nm: f64,
    basic: Vec<[f64; BASIC]>,
    /// Sums of samples, `numbers` a place.
    samples: Vec<f64>,
    numbers: usize,
    target: [f64; 3],
    scales: &'a Scales,
    pub(super) against: Against,
}

/// Lines with their powers (Y = 1) and what they are worth.
#[derive(Clone, Debug)]
pub(super) struct Found<const L: usize> {
    pub(super) places: [f64; L],
    pub(super) powers: [f64; L],
    pub(super) ler: f64,
    /// The figure, or less than nothing: minus what is missing to the floor.
    pub(super) worth: f64,
}

/// Worth of what misses the floor or the colour: below every figure.
const MISSING: f64 = -1e6;

impl<'a> LineSearch<'a> {
    pub(super) fn new(
        range_nm: [f64; 2],
        target: [f64; 3],
        against: Against,
        tables: &SampleTables,
        scales: &'a Scales,
    ) -> Self {
        let count = (range_nm[1] - range_nm[0]) as usize + 1;
        let (rendering, fidelity) = (against == Against::Ra, against == Against::Rf);
        let mut search = Self {
            first_nm: range_nm[0],
            basic: Vec::with_capacity(count),
            samples: Vec::new(),
            numbers: 0,
            target,
            scales,
            against,
        };
        for place in 0..count {
            let at_nm = search.first_nm + place as f64;
            let sums = tables.line_sums(at_nm, rendering, fidelity);
            search.basic.push(sums.basic);
            let samples = if rendering {
                &sums.rendering
            } else {
                &sums.fidelity
            };
            search.numbers = samples.len();
            search.samples.extend_from_slice(samples);
        }
        search
    }

    pub(super) fn last_nm(&self) -> f64 {
        self.first_nm + (self.basic.len() - 1) as f64
    }

    /// The whole nm left of a place, and the share of the next.
    fn split(&self, at_nm: f64) -> (usize, f64) {
        let x = at_nm - self.first_nm;
        let left = (x.max(0.0) as usize).min(self.basic.len() - 2);
        (left, x - left as f64)
    }

    /// XYZ of the colour, Y = 1.
    pub(super) fn target(&self) -> [f64; 3] {
        self.target
    }

    /// XYZ of a line of unit power.
    pub(super) fn basic_at(&self, at_nm: f64) -> [f64; 3] {
        let (left, share) = self.split(at_nm);
        let (a, b) = (&self.basic[left], &self.basic[left + 1]);
        std::array::from_fn(|k| a[k] + share * (b[k] - a[k]))
    }

    /// Powers of three lines of the target's colour, Y = 1; `None` where there are none.
    fn three(&self, places: [f64; 3]) -> Option<[f64; 3]> {
        let columns = places.map(|nm| self.basic_at(nm));
        let matrix = std::array::from_fn(|row| columns.map(|c| c[row]));
        let powers: [f64; 3] = solved(matrix, self.target)?;
        powers
            .iter()
            .all(|w| *w >= -ROUNDING)
            .then(|| powers.map(|w| w.max(0.0)))
    }

    /// The two ends of what lines of the target's colour can do: one end for three lines.
    pub(super) fn ends<const L: usize>(&self, places: [f64; L]) -> Option<[[f64; L]; 2]> {
        let mut found: Vec<[f64; L]> = Vec::new();
        let left_out = if L == 3 { 0..1 } else { 0..L };
        for out in left_out {
            let kept: Vec<usize> = (0..L).filter(|i| L == 3 || *i != out).collect();
            let three = [kept[0], kept[1], kept[2]];
            if let Some(powers) = self.three(three.map(|i| places[i])) {
                let mut all = [0.0; L];
                three.iter().zip(powers).for_each(|(i, w)| all[*i] = w);
                found.push(all);
            }
        }
        let (first, last) = (found.first()?, found.last()?);
        // Of more than two ends (lines that coincide) the two that differ most.
        let apart =
            |other: &[f64; L]| -> f64 { other.iter().zip(first).map(|(a, b)| (a - b).abs()).sum() };
        let far = found.iter().fold(
            last,
            |far, end| if apart(end) > apart(far) { end } else { far },
        );
        Some([*first, *far])
    }

    pub(super) fn power<const L: usize>(powers: &[f64; L]) -> f64 {
        powers.iter().sum()
    }

    /// Sums of samples of lines.
    pub(super) fn sums(&self, places: &[f64], powers: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.numbers];
        for (at_nm, power) in places.iter().zip(powers) {
            let (left, share) = self.split(*at_nm);
            let rows = &self.samples[left * self.numbers..(left + 2) * self.numbers];
            let (here, next) = rows.split_at(self.numbers);
            let (a, b) = (power * (1.0 - share), power * share);
            let all = sums.iter_mut().zip(here).zip(next);
            all.for_each(|((s, x), y)| *s += a * x + b * y);
        }
        sums
    }

    /// The figure of sums of samples.
    pub(super) fn figure(&self, samples: &[f64]) -> f64 {
        let found = self.scales.figure_of(self.against.figure(), samples);
        found.unwrap_or(MISSING)
    }

    /// The figure at a few even shares along the free one: what the net looks at.
    pub(super) fn look<const L: usize>(
        &self,
        places: [f64; L],
        shares: usize,
        mut each: impl FnMut(f64, f64),
    ) {
        let Some([a, b]) = self.ends(places) else {
            return;
        };
        let shares = if L == 3 || a == b { 1 } else { shares };
        for index in 0..shares {
            let t = (index as f64 + 0.5) / shares as f64;
            let powers: [f64; L] = std::array::from_fn(|i| a[i] + t * (b[i] - a[i]));
            let ler = LUMENS_PER_WATT / Self::power(&powers);
            each(ler, self.figure(&self.sums(&places, &powers)));
        }
    }

    /// The best powers of these lines at a floor of efficacy; what is surely below `bar` is not
    /// looked at closely.
    pub(super) fn best<const L: usize>(
        &self,
        places: [f64; L],
        floor: f64,
        bar: f64,
    ) -> Option<Found<L>> {
        let [a, b] = self.ends(places)?;
        let (power_a, power_b) = (Self::power(&a), Self::power(&b));
        let most = if floor > 0.0 {
            LUMENS_PER_WATT / floor
        } else {
            f64::INFINITY
        };
        let least = power_a.min(power_b);
        let at = |t: f64| -> [f64; L] { std::array::from_fn(|i| a[i] + t * (b[i] - a[i])) };
        let whole = |powers: [f64; L], worth: f64| Found {
            places,
            ler: LUMENS_PER_WATT / Self::power(&powers),
            powers,
            worth,
        };
        // Rounding at the floor itself.
        if least > most * (1.0 + 1e-12) {
            let t = if power_a <= power_b { 0.0 } else { 1.0 };
            let missing = floor - LUMENS_PER_WATT / least;
            return Some(whole(at(t), MISSING - missing));
        }
        // The power is straight along the free share: where it stays below the most.
        let cross = ((most - power_a) / (power_b - power_a)).clamp(0.0, 1.0);
        let [from, to] = match (power_a <= most, power_b <= most) {
            (true, true) => [0.0, 1.0],
            (true, false) => [0.0, cross],
            _ => [cross, 1.0],
        };
        let (sums_a, sums_b) = (self.sums(&places, &a), self.sums(&places, &b));
        let figure = |t: f64| {
            let both = sums_a.iter().zip(&sums_b);
            self.figure(&both.map(|(a, b)| a + t * (b - a)).collect::<Vec<f64>>())
        };
        if L == 3 || a == b || to - from < 1e-9 {
            let value = figure(from);
            return Some(whole(at(from), value));
        }
        let (t, value) = top(&figure, from, to, bar);
        Some(whole(at(t), value))
    }
}

/// The greatest value on an interval: five looks, then golden sections around the best. The figure
/// being nearly hollow downwards, it rises between two looks by no more than it rose before the
/// first of them; where that stays below `bar`, the looks are enough.
fn top(value: &dyn Fn(f64) -> f64, from: f64, to: f64, bar: f64) -> (f64, f64) {
    const LOOKS: usize = 5;
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let at = |i: usize| from + (to - from) * i as f64 / (LOOKS - 1) as f64;
    let looks: Vec<f64> = (0..LOOKS).map(|i| value(at(i))).collect();
    let mut best = 0;
    for i in 1..LOOKS {
        if looks[i] > looks[best] {
            best = i;
        }
    }
    let mut top = (at(best), looks[best]);
    let beside = [best.checked_sub(1), Some(best + 1).filter(|i| *i < LOOKS)];
    let rise = beside.into_iter().flatten().map(|i| looks[best] - looks[i]);
    if looks[best] + rise.fold(0.0, f64::max) <= bar {
        return top;
    }
    let (mut left, mut right) = (at(best.saturating_sub(1)), at((best + 1).min(LOOKS - 1)));
    let inner = |left: f64, right: f64| {
        [
            right - GOLDEN * (right - left),
            left + GOLDEN * (right - left),
        ]
    };
    let [mut x, mut y] = inner(left, right);
    let (mut at_x, mut at_y) = (value(x), value(y));
    for _ in 0..SECTIONS {
        for (t, v) in [(x, at_x), (y, at_y)] {
            if v > top.1 {
                top = (t, v);
            }
        }
        if at_x >= at_y {
            (right, y, at_y) = (y, x, at_x);
            x = inner(left, right)[0];
            at_x = value(x);
        } else {
            (left, x, at_x) = (x, y, at_y);
            y = inner(left, right)[1];
            at_y = value(y);
        }
    }
    top
}
