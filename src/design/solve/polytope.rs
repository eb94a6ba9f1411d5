//! All mixtures of a colour: weights that are not negative, with floors that are linear.
//!
//! ```text
//! sum w_j XYZ_j + w XYZ_fixed = target                 Y = 1
//! 683 Y - floor x power - slack = 0                    melanopic - floor x Y - slack' = 0
//! ```
//!
//! The fixed part is one more channel, by whose weight all others are divided in the end: so every
//! mixture has Y = 1, and efficacy and melanopic ratio are greatest where a sum is.

use crate::design::{
    programme::{BasicSolution, End, Programme},
    scales::{BASIC, LUMENS_PER_WATT, MELANOPIC_OF_D65},
};

const ROWS: usize = 5;

/// Least power of the fixed part, as a share of that which 683 lm/W would take: otherwise the best
/// mixture would often be one that drowns it, however bright.
const LEAST_FIXED: f64 = 1e-3;

/// The mixtures of a colour.
#[derive(Clone, Debug)]
pub(super) struct Polytope {
    programme: Programme<ROWS>,
    start: BasicSolution<ROWS>,
    /// Basic sums of each free channel at weight one, behind them of what is fixed at unit power.
    pub(super) columns: Vec<[f64; BASIC]>,
    /// The least power of what is fixed, beyond which its unknown counts; `None` for nothing.
    pub(super) least_fixed: Option<f64>,
    /// Power of what is fixed as it stands.
    fixed_power: f64,
}

impl Polytope {
    /// Mixtures of free channels over what is fixed, of the target's colour (Y = 1), with floors
    /// of efficacy and melanopic ratio.
    ///
    /// # Errors
    /// [`End::Impossible`] where there is none, [`End::Stuck`] where that is not known.
    pub(super) fn new(
        channels: &[[f64; BASIC]],
        fixed: [f64; BASIC],
        target: [f64; 3],
        ler: Option<f64>,
        melanopic: Option<f64>,
    ) -> Result<Self, End> {
        let floors = [ler, melanopic];
        let mut columns = channels.to_vec();
        let [x, y, z] = target;
        let mut right = [x, y, z, 0.0, 0.0];
        let fixed_power = fixed[4];
        let least_fixed = (fixed_power > 0.0).then_some(LEAST_FIXED * y);
        if let Some(least) = least_fixed {
            let fixed = fixed.map(|v| v / fixed_power);
            columns.push(fixed);
            let taken = rows(&fixed, floors);
            (0..ROWS).for_each(|row| right[row] -= least * taken[row]);
        }
        let mut equations: Vec<[f64; ROWS]> = columns.iter().map(|c| rows(c, floors)).collect();
        equations.push([0.0, 0.0, 0.0, -1.0, 0.0]);
        equations.push([0.0, 0.0, 0.0, 0.0, -1.0]);
        let upper = vec![f64::INFINITY; equations.len()];
        let mut programme = Programme::new(&equations, &upper, right);
        Ok(Self {
            start: programme.corner()?,
            programme,
            columns,
            least_fixed,
            fixed_power,
        })
    }

    /// The unknowns of the greatest sum of a number a column.
    fn greatest(&self, of: impl Fn(&[f64; BASIC]) -> f64) -> Result<Vec<f64>, End> {
        let mut gain: Vec<f64> = self.columns.iter().map(of).collect();
        gain.resize(self.columns.len() + 2, 0.0);
        let mut corner = self.start.clone();
        self.programme.maximise(&mut corner, &gain)?;
        Ok(self.unknowns(&corner))
    }

    /// Unknowns of the greatest luminous efficacy.
    ///
    /// # Errors
    /// [`End::Stuck`] where it is not known.
    pub(super) fn most_lumens(&self) -> Result<Vec<f64>, End> {
        self.greatest(|sums| -sums[4])
    }

    /// Unknowns of the greatest melanopic ratio.
    ///
    /// # Errors
    /// As [`Polytope::most_lumens`].
    pub(super) fn most_melanopic(&self) -> Result<Vec<f64>, End> {
        self.greatest(|sums| sums[3])
    }

    /// Corners in many directions: greatest efficacy and melanopic ratio, then the greatest and the
    /// least of every unknown and every slack. Each once, in that order.
    pub(super) fn corners(&self) -> Vec<Vec<f64>> {
        let mut found: Vec<Vec<f64>> = [self.most_lumens(), self.most_melanopic()]
            .into_iter()
            .flatten()
            .collect();
        let mut corner = self.start.clone();
        for unknown in 0..self.columns.len() + 2 {
            for sign in [1.0, -1.0] {
                // One that nothing bounds is not seen, and is left out of every mixture.
                if let Ok(Some(_)) = self.programme.extreme(&mut corner, unknown, sign) {
                    found.push(self.unknowns(&corner));
                }
            }
        }
        let mut once: Vec<Vec<f64>> = Vec::new();
        for corner in found {
            let size = corner.iter().fold(0.0_f64, |a, v| a.max(*v));
            let same = |old: &Vec<f64>| {
                let both = old.iter().zip(&corner);
                both.map(|(a, b)| (a - b).abs())
                    .all(|off| off <= 1e-9 * size)
            };
            if !once.iter().any(same) {
                once.push(corner);
            }
        }
        once
    }

    fn unknowns(&self, corner: &BasicSolution<ROWS>) -> Vec<f64> {
        let mut all = self.programme.solution(corner);
        all.truncate(self.columns.len());
        all
    }

    /// Weights of the free channels: at Y = 1, or as they are beside what is fixed.
    pub(super) fn weights(&self, unknowns: &[f64]) -> Vec<f64> {
        let Some(least) = self.least_fixed else {
            return unknowns.to_vec();
        };
        let (fixed, free) = unknowns.split_last().unwrap_or((&0.0, &[]));
        let factor = self.fixed_power / (least + fixed);
        free.iter().map(|weight| weight * factor).collect()
    }
}

/// The terms that a light adds to the equations.
fn rows(sums: &[f64; BASIC], [ler, melanopic]: [Option<f64>; 2]) -> [f64; ROWS] {
    let [x, y, z, mel, power] = *sums;
    let lumens = ler.map_or(0.0, |floor| y - floor / LUMENS_PER_WATT * power);
    let awake = melanopic.map_or(0.0, |floor| mel / *MELANOPIC_OF_D65 - floor * y);
    [x, y, z, lumens, awake]
}
