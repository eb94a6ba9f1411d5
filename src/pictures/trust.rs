//! Reliability of relighting: regions that the old light left dark, and noise from the division.

use nalgebra::{DMatrix, DVector};

use crate::spectrum::{Outside, Sampled};
use crate::{
    color::{Observer, Xyz},
    languages::fixed,
};

#[cfg(test)]
use super::fitting::lit_fit;
use super::light::Rows;
#[cfg(test)]
use super::light::sums;
#[cfg(test)]
use super::plan::LEAST_NOISE;
use super::{Bands, Illuminant, Operator, Relit};

/// Below this share of its mean the old light shows nothing of a surface.
const DARK: f64 = 0.02;
/// A blind share above this is warned of (provisional).
const WARN_BLIND: f64 = 0.05;
/// A blind share above this is refused (provisional).
const REFUSE_BLIND: f64 = 0.5;
/// Foretold noise of two lights above this is warned of (provisional, from four pairs).
#[cfg(test)]
const WARN_PARTS: f64 = 0.8;
/// And refused above this.
#[cfg(test)]
const REFUSE_PARTS: f64 = 3.0;
/// The grey that noise is foretold at.
const GREY_Y: f64 = 0.2;
/// The grey of the two lights' rank.
#[cfg(test)]
const GREY_OF_PARTS: f64 = 0.1;

/// Verdict on reliability.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Nothing speaks against it.
    Good,
    /// With care.
    Care,
    /// The old light left too much dark.
    Refused,
}

impl Verdict {
    fn of(value: f64, warn: f64, refuse: f64) -> Self {
        match value {
            v if v > refuse || !v.is_finite() => Self::Refused,
            v if v > warn => Self::Care,
            _ => Self::Good,
        }
    }

    /// The word in JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Good => "good",
            Self::Care => "care",
            Self::Refused => "refused",
        }
    }
}

/// Reliability of relighting from one light to another.
#[derive(Clone, Debug, PartialEq)]
pub struct Trust {
    /// Share of the new white's X, Y, Z that falls where the old light was dark: a reflectance of
    /// 0-1 there moves them by at most so much of white.
    pub blind: [f64; 3],
    /// Mean colour difference that the picture's noise makes, foretold at a mid grey.
    pub noise: f64,
    /// Verdict on the relighting.
    pub verdict: Verdict,
    /// True if the quantity of the picture's values is only guessed: counts under a lamp that are
    /// taken for reflectances are wrong by the lamp's whole spectrum.
    pub guessed: bool,
}

impl Trust {
    /// The same of a picture of which nobody says what its values are: never better than care.
    #[must_use]
    pub(crate) fn of_a_guess(self) -> Self {
        let verdict = match self.verdict {
            Verdict::Good => Verdict::Care,
            other => other,
        };
        Self {
            verdict,
            guessed: true,
            ..self
        }
    }

    /// In one line.
    pub(crate) fn words(&self) -> String {
        let blind = self.blind.iter().copied().fold(0.0, f64::max);
        match self.verdict {
            Verdict::Care if self.guessed => tr!(
                "with care: nothing states that the values are reflectances, and under a lamp \
                 they would be off by its whole spectrum; noise makes about {noise} ΔE₀₀",
                noise = fixed(self.noise, 2)
            ),
            Verdict::Good => tr!(
                "trust it: noise makes about {noise} ΔE₀₀",
                noise = fixed(self.noise, 2)
            ),
            Verdict::Care => tr!(
                "with care: the old light left {share} % of the new one's colour dark, noise \
                 makes about {noise} ΔE₀₀",
                share = fixed(100.0 * blind, 0),
                noise = fixed(self.noise, 2)
            ),
            Verdict::Refused => tr!(
                "not to be trusted: the old light left {share} % of the new one's colour dark",
                share = fixed(100.0 * blind, 0)
            ),
        }
    }
}

/// Share of the new light's X, Y, Z where the old one on the bands is below 2 % of its mean.
pub(crate) fn blind_share(
    bands: &Bands,
    old: &[f64],
    new: &Illuminant,
    observer: Observer,
) -> [f64; 3] {
    let mean = old.iter().sum::<f64>() / old.len().max(1) as f64;
    let table = Sampled::new(bands.nm().to_vec(), old.to_vec()).ok();
    let (first, last) = (bands.nm()[0], bands.nm()[bands.len() - 1]);
    // What lies beyond the bands was not seen at all; the ends' values are held there.
    let value = |nm: f64| {
        let nm = nm.clamp(first, last);
        table
            .as_ref()
            .map_or(0.0, |table| table.at(nm, Outside::Hold))
    };
    let is_dark = |nm: f64| value(nm) < DARK * mean;
    let (mut dark, mut all) = ([0.0; 3], [0.0; 3]);
    for (nm, xyz) in new.seen(observer) {
        let missing = if is_dark(nm) { 1.0 } else { 0.0 };
        for (k, value) in xyz.into_iter().enumerate() {
            all[k] += value;
            dark[k] += missing * value;
        }
    }
    std::array::from_fn(|k| if all[k] > 0.0 { dark[k] / all[k] } else { 0.0 })
}

/// Lab by XYZ at a grey of some Y of a white.
pub(super) fn lab_by_xyz(white: Xyz, grey_y: f64) -> DMatrix<f64> {
    // The derivative of a cube root.
    let slope = grey_y.powf(-2.0 / 3.0) / 3.0;
    let turn = DMatrix::from_row_slice(
        3,
        3,
        &[0.0, 116.0, 0.0, 500.0, -500.0, 0.0, 0.0, 200.0, -200.0],
    );
    let per_white = white
        .to_array()
        .map(|v| if v.abs() > 1e-9 { slope / v } else { 0.0 });
    turn * DMatrix::from_diagonal(&DVector::from_row_slice(&per_white))
}

pub(super) fn matrix_of(rows: &Rows) -> DMatrix<f64> {
    DMatrix::from_fn(3, rows[0].len(), |k, n| rows[k][n])
}

impl Operator {
    /// Mean colour difference that noise of the bands makes under a light, foretold at a mid grey.
    pub(crate) fn foretold_noise(&self, relit: &Relit, noise: &[f64]) -> f64 {
        let to_lab = lab_by_xyz(relit.white, GREY_Y) * matrix_of(&relit.rows) * &self.encode;
        let sum: f64 = to_lab
            .column_iter()
            .zip(noise)
            .map(|(column, s)| column.norm_squared() * s * s)
            .sum();
        sum.sqrt()
    }

    /// Reliability of relighting to a light; `old` is the light on the bands, `None` for a
    /// reflectance.
    pub(crate) fn trust(
        &self,
        relit: &Relit,
        new: &Illuminant,
        old: Option<&[f64]>,
        noise: &[f64],
    ) -> Trust {
        let observer = self.plan().observer;
        let blind = old.map_or([0.0; 3], |old| {
            blind_share(self.bands(), old, new, observer)
        });
        let worst = blind.iter().copied().fold(0.0, f64::max);
        Trust {
            blind,
            noise: self.foretold_noise(relit, noise),
            verdict: Verdict::of(worst, WARN_BLIND, REFUSE_BLIND),
            guessed: false,
        }
    }

    /// Separability of two known lights: for each light's part alone a rank (it understates the
    /// error), and the verdict; `None` for a picture of one light.
    #[cfg(test)]
    pub(crate) fn parts_rank(&self) -> Option<([f64; 2], Verdict)> {
        let plan = self.plan();
        let (one, two) = plan.shares();
        let noise = plan.noise.max(LEAST_NOISE);
        let fit = lit_fit(self.bands(), &self.decode, self.prior()?, noise).ok()?;
        let spread = fit.inverse;
        let rank = |from: usize, count: usize, light: &[f64]| {
            let mut rows = self.own_colour().rows;
            let white = sums(self.own_weights(), light);
            for row in &mut rows {
                row[..from].fill(0.0);
                row[from + count..].fill(0.0);
            }
            let to_lab = lab_by_xyz(white, GREY_OF_PARTS) * matrix_of(&rows);
            (&to_lab * &spread * to_lab.transpose())
                .trace()
                .max(0.0)
                .sqrt()
        };
        let second = &plan.second.as_ref()?.values;
        let ranks = [rank(0, one, &plan.reference.values), rank(one, two, second)];
        let worst = ranks[0].max(ranks[1]);
        Some((ranks, Verdict::of(worst, WARN_PARTS, REFUSE_PARTS)))
    }
}
