//! All mixtures of a colour: weights that are not negative, with floors that are linear.
//!
//! ```text
//! sum w_j XYZ_j + fixed = brightness x target       (brightness 1 where nothing is fixed)
//! 683 Y - floor x power - slack = 0                 melanopic - floor x Y - slack' = 0
//! ```

use crate::design::{
    programme::{Corner, Programme},
    scales::{BASIC, LUMENS_PER_WATT, MELANOPIC_OF_D65},
};

const ROWS: usize = 5;

/// Turns of the method for ratios; each doubles the digits.
const MOST_TURNS: usize = 30;

/// The mixtures of a colour.
#[derive(Clone, Debug)]
pub(super) struct Polytope {
    programme: Programme<ROWS>,
    start: Corner<ROWS>,
    /// Basic sums of each free channel at weight one.
    channels: Vec<[f64; BASIC]>,
    /// Basic sums of what is fixed.
    fixed: [f64; BASIC],
    /// Floors of efficacy and melanopic ratio.
    floors: [Option<f64>; 2],
    /// Unknowns behind the channels: brightness (if anything is fixed) and two slacks.
    others: usize,
}

impl Polytope {
    /// Mixtures of free channels over what is fixed, of the target's colour (Y = 1), with floors
    /// of efficacy and melanopic ratio; `None` where there is none.
    pub(super) fn new(
        channels: &[[f64; BASIC]],
        fixed: [f64; BASIC],
        target: [f64; 3],
        ler: Option<f64>,
        melanopic: Option<f64>,
    ) -> Option<Self> {
        let floors = [ler, melanopic];
        let rows = |sums: &[f64; BASIC]| rows(sums, floors);
        let is_fixed = fixed[4] > 0.0;
        let mut columns: Vec<[f64; ROWS]> = channels.iter().map(rows).collect();
        let [x, y, z] = target;
        if is_fixed {
            columns.push([-x, -y, -z, 0.0, 0.0]);
        }
        columns.push([0.0, 0.0, 0.0, -1.0, 0.0]);
        columns.push([0.0, 0.0, 0.0, 0.0, -1.0]);
        let right = if is_fixed {
            rows(&fixed).map(|v| -v)
        } else {
            [x, y, z, 0.0, 0.0]
        };
        let upper = vec![f64::INFINITY; columns.len()];
        let mut programme = Programme::new(&columns, &upper, right);
        let start = programme.corner()?;
        Some(Self {
            programme,
            start,
            channels: channels.to_vec(),
            fixed,
            floors,
            others: columns.len() - channels.len(),
        })
    }

    /// The corner of the greatest ratio of two linear sums, by turns (Dinkelbach 1967).
    fn greatest_ratio(
        &self,
        part: impl Fn(&[f64; BASIC]) -> f64,
        whole: impl Fn(&[f64; BASIC]) -> f64,
    ) -> Vec<f64> {
        let mut corner = self.start.clone();
        let mut ratio = f64::NEG_INFINITY;
        for _ in 0..MOST_TURNS {
            let sums = self.sums(&self.programme.solution(&corner));
            let now = part(&sums) / whole(&sums);
            if !now.is_finite() || now <= ratio * (1.0 + 1e-14) {
                break;
            }
            ratio = now;
            let gain = self.gain(|sums| part(sums) - ratio * whole(sums));
            if self.programme.maximise(&mut corner, &gain).is_none() {
                break;
            }
        }
        self.programme.solution(&corner)
    }

    /// Weights of the greatest luminous efficacy.
    pub(super) fn most_lumens(&self) -> Vec<f64> {
        self.greatest_ratio(|s| s[1], |s| s[4])
    }

    /// Weights of the greatest melanopic ratio.
    pub(super) fn most_melanopic(&self) -> Vec<f64> {
        self.greatest_ratio(|s| s[3], |s| s[1])
    }

    /// Corners in many directions: all channels' greatest and least weights, greatest efficacy
    /// and melanopic ratio. Each once, in that order.
    pub(super) fn corners(&self) -> Vec<Vec<f64>> {
        let mut found = vec![self.most_lumens(), self.most_melanopic()];
        let mut corner = self.start.clone();
        for channel in 0..self.channels.len() {
            for sign in [1.0, -1.0] {
                let mut gain = vec![0.0; self.channels.len() + self.others];
                gain[channel] = sign;
                if self.programme.maximise(&mut corner, &gain).is_some() {
                    found.push(self.programme.solution(&corner));
                }
            }
        }
        let mut once: Vec<Vec<f64>> = Vec::new();
        for corner in found {
            let size = corner.iter().fold(0.0_f64, |a, v| a.max(*v));
            let same = |old: &Vec<f64>| {
                old.iter()
                    .zip(&corner)
                    .all(|(a, b)| (a - b).abs() <= 1e-9 * size)
            };
            if !once.iter().any(same) {
                once.push(corner);
            }
        }
        once
    }

    /// The unknowns of a mixture of the target's colour at Y = 1, its floors' slacks among them;
    /// `None` where something is fixed, or below a floor.
    pub(super) fn completed(&self, weights: &[f64]) -> Option<Vec<f64>> {
        if self.fixed[4] > 0.0 {
            return None;
        }
        let [_, _, _, lumens, awake] = rows(&self.sums(weights), self.floors);
        let mut all = weights.to_vec();
        all.extend([lumens, awake]);
        (lumens >= 0.0 && awake >= 0.0).then_some(all)
    }

    /// Basic sums of a mixture, what is fixed among it.
    pub(super) fn sums(&self, weights: &[f64]) -> [f64; BASIC] {
        let mut sums = self.fixed;
        for (channel, weight) in self.channels.iter().zip(weights) {
            (0..BASIC).for_each(|k| sums[k] += weight * channel[k]);
        }
        sums
    }

    fn gain(&self, of: impl Fn(&[f64; BASIC]) -> f64) -> Vec<f64> {
        let mut gain: Vec<f64> = self.channels.iter().map(of).collect();
        gain.resize(self.channels.len() + self.others, 0.0);
        gain
    }
}

/// What a light adds to the equations.
fn rows(sums: &[f64; BASIC], [ler, melanopic]: [Option<f64>; 2]) -> [f64; ROWS] {
    let [x, y, z, mel, power] = *sums;
    let lumens = ler.map_or(0.0, |floor| y - floor / LUMENS_PER_WATT * power);
    let awake = melanopic.map_or(0.0, |floor| mel / *MELANOPIC_OF_D65 - floor * y);
    [x, y, z, lumens, awake]
}
