//! The families of waves that a smooth part is added up from: all that one basis has of its own.
//!
//! ```text
//! fourier  S(l) = a0/2 + sum a_n cos(2 pi n (l - min)/L) + b_n sin(2 pi n (l - min)/L)   (Eq. 4)
//! cosine   S(l) = c0   + sum c_n cos(pi n (l - min)/L),  n = 0..2N
//! ```
//!
//! Coefficients are kept in **prefix order**, `a0 a1 b1 a2 b2 ...` or `c0 c1 c2 ...`, so that a
//! lower order is a prefix of a higher one: fit once to the largest order, truncate for a slider.
//! A basis is its words, its waves ([`Basis::wave`]) and how far they turn over the band
//! ([`Basis::half_turns`]); values, norms, products and sample points follow from these.

use std::{
    f64::consts::PI,
    ops::{Index, IndexMut},
};

use serde::{Deserialize, Serialize};

use super::band::Band;

/// The family of basis functions that make up the smooth part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Basis {
    /// The paper's periodic Fourier series: rings where the two ends of the band differ.
    Fourier,
    /// Half-range cosines: the same count of numbers, no jump at the ends.
    Cosine,
}

/// One function of a basis: `cos cos(multiple u) + sin sin(multiple u)`, where `u` makes the basis'
/// half turns over the band. The functions of one multiple are orthogonal to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wave {
    /// List that holds its coefficient in files; with the multiple its name: `a3`.
    pub list: &'static str,
    /// How often it turns; from one function to the next it stays or grows by one.
    pub multiple: usize,
    /// Amplitude of the cosine.
    pub cos: f64,
    /// Amplitude of the sine.
    pub sin: f64,
}

impl Wave {
    const fn new(list: &'static str, multiple: usize, [cos, sin]: [f64; 2]) -> Self {
        Self {
            list,
            multiple,
            cos,
            sin,
        }
    }

    /// The value where the angle has this sine and cosine.
    pub(super) fn value(self, sin: f64, cos: f64) -> f64 {
        self.cos * cos + self.sin * sin
    }

    /// Mean of the square over the band.
    fn mean_square(self) -> f64 {
        let squares = self.cos * self.cos + self.sin * self.sin;
        if self.multiple == 0 {
            squares
        } else {
            0.5 * squares
        }
    }
}

impl Basis {
    /// Every basis, the paper's first.
    pub const ALL: [Self; 2] = [Self::Fourier, Self::Cosine];

    /// The word used in files and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Fourier => "fourier",
            Self::Cosine => "cosine",
        }
    }

    /// The name within a sentence.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fourier => later!("Fourier"),
            Self::Cosine => later!("cosine"),
        }
    }

    /// A sentence on the functions, for people.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::Fourier => {
                later!(
                    "The paper's periodic series: 2N + 1 numbers. It rings where the two ends of the \
                 range differ."
                )
            }
            Self::Cosine => {
                later!("Half-range cosines: the same 2N + 1 numbers, no jump at the ends.")
            }
        }
    }

    /// Half turns of the first wave over the band: two for a basis of periodic functions.
    pub(crate) fn half_turns(self) -> usize {
        match self {
            Self::Fourier => 2,
            Self::Cosine => 1,
        }
    }

    /// The function that coefficient `index` (prefix order) multiplies.
    pub(crate) fn wave(self, index: usize) -> Wave {
        const COS: [f64; 2] = [1.0, 0.0];
        const SIN: [f64; 2] = [0.0, 1.0];
        match self {
            Self::Fourier if index == 0 => Wave::new("a", 0, [0.5, 0.0]),
            Self::Fourier if index % 2 == 1 => Wave::new("a", index.div_ceil(2), COS),
            Self::Fourier => Wave::new("b", index / 2, SIN),
            Self::Cosine => Wave::new("c", index, COS),
        }
    }

    /// Last bit of the first of an encoding's words (`lamps`), by which the basis is read again;
    /// `None` for a basis that words do not hold.
    pub(crate) fn bit_in_words(self) -> Option<u32> {
        match self {
            Self::Fourier => Some(1),
            Self::Cosine => Some(0),
        }
    }

    /// The basis of that word.
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|basis| basis.word() == word)
    }

    /// True if the functions end as they begin.
    pub(crate) fn is_periodic(self) -> bool {
        self.half_turns().is_multiple_of(2)
    }

    /// Names of the lists that hold the coefficients in files.
    pub(crate) fn lists(self) -> Vec<&'static str> {
        let mut lists: Vec<_> = (0..3).map(|index| self.wave(index).list).collect();
        lists.dedup();
        lists
    }

    /// The name of coefficient `index`: `b3`.
    pub(crate) fn number_name(self, index: usize) -> String {
        let wave = self.wave(index);
        format!("{}{}", wave.list, wave.multiple)
    }

    /// Highest order that the band's 1 nm grid can carry: above it the functions are not
    /// independent on the grid any more.
    pub fn highest_order(band: Band) -> usize {
        (band.steps() - 1) / 2
    }

    /// Half turns of function `index` over the band.
    pub(crate) fn half_turns_of(self, index: usize) -> usize {
        self.half_turns() * self.wave(index).multiple
    }

    /// Value of the function that coefficient `index` (prefix order) multiplies.
    pub fn function(self, index: usize, band: Band, at_nm: f64) -> f64 {
        let x = (at_nm - band.min_nm()) / band.length_nm();
        let (sin, cos) = (PI * self.half_turns_of(index) as f64 * x).sin_cos();
        self.wave(index).value(sin, cos)
    }

    /// Integral of the square of function `index` over the band, in nm.
    ///
    /// Holds to rounding for the trapezoid sum on the 1 nm grid too, which is why the projection
    /// of Eq. 5 is the least-squares fit.
    pub fn norm_squared(self, index: usize, band: Band) -> f64 {
        self.wave(index).mean_square() * band.length_nm()
    }

    /// Mean over the band of a series whose first coefficient this is.
    pub(crate) fn mean(self, first: f64) -> f64 {
        self.wave(0).cos * first
    }

    /// The first `count` functions on the band's grid, row by row.
    ///
    /// Whole nm are whole fractions of a turn, so one turn of the circle serves all orders.
    pub(super) fn rows(self, band: Band, count: usize) -> Vec<f64> {
        let turn = 2 * band.steps() / self.half_turns();
        let circle: Vec<(f64, f64)> = (0..turn)
            .map(|i| (2.0 * PI * i as f64 / turn as f64).sin_cos())
            .collect();
        let mut rows = Vec::with_capacity(count * band.points());
        for index in 0..count {
            let wave = self.wave(index);
            rows.extend((0..band.points()).map(|i| {
                let (sin, cos) = circle[wave.multiple * i % turn];
                wave.value(sin, cos)
            }));
        }
        rows
    }

    /// Offset of the first of a number of sample points from the band's start, in halves of their
    /// distance: periodic functions are sampled from the start on, others in the middle of each part.
    pub(super) fn halves_before_samples(self) -> usize {
        usize::from(!self.is_periodic())
    }

    /// Value of function `index` at sample `i` of `points`, without going through nm.
    pub(super) fn at_sample(self, index: usize, i: usize, points: usize) -> f64 {
        let halves = 2 * i + self.halves_before_samples();
        let angle = PI * (self.half_turns_of(index) * halves) as f64 / (2 * points) as f64;
        let (sin, cos) = angle.sin_cos();
        self.wave(index).value(sin, cos)
    }

    /// Factor that turns a sum over `points` samples into coefficient `index`.
    pub(super) fn sample_scale(self, index: usize, points: usize) -> f64 {
        let wave = self.wave(index);
        // The cosine of half the sampling frequency is its own alias: all its samples are crests.
        let is_crest = self.is_periodic() && self.half_turns_of(index) == points;
        let mean_square = if is_crest {
            wave.cos * wave.cos
        } else {
            wave.mean_square()
        };
        1.0 / (mean_square * points as f64)
    }

    /// Coefficients of the product of two series of the basis, every order kept, O(N^2).
    pub(super) fn product(self, a: &[f64], b: &[f64]) -> Vec<f64> {
        let [[cos_1, sin_1], [cos_2, sin_2]] = [self.amplitudes(a), self.amplitudes(b)];
        let has_sines = [&sin_1, &sin_2]
            .iter()
            .any(|sin| sin.iter().any(|s| *s != 0.0));
        let count = cos_1.len() + cos_2.len() - 1;
        let (mut cos, mut sin) = (vec![0.0; count], vec![0.0; count]);
        for m in 0..cos_1.len() {
            for n in 0..cos_2.len() {
                let (sum, difference) = (m + n, m.abs_diff(n));
                // cos m cos n = (cos(m+n) + cos(m-n)) / 2
                let cc = 0.5 * cos_1[m] * cos_2[n];
                cos[sum] += cc;
                cos[difference] += cc;
                if !has_sines {
                    continue;
                }
                // sin m sin n = (cos(m-n) - cos(m+n)) / 2
                let ss = 0.5 * sin_1[m] * sin_2[n];
                cos[difference] += ss;
                cos[sum] -= ss;
                // sin m cos n = (sin(m+n) + sin(m-n)) / 2, the sine of a negative order is minus it
                let sc = 0.5 * sin_1[m] * cos_2[n];
                sin[sum] += sc;
                sin[difference] += if m >= n { sc } else { -sc };
                let cs = 0.5 * cos_1[m] * sin_2[n];
                sin[sum] += cs;
                sin[difference] += if n >= m { cs } else { -cs };
            }
        }
        let waves = (0..).map(|index| self.wave(index));
        waves
            .take_while(|wave| wave.multiple < count)
            .map(|wave| {
                let squares = wave.cos * wave.cos + wave.sin * wave.sin;
                wave.value(sin[wave.multiple], cos[wave.multiple]) / squares
            })
            .collect()
    }

    /// A series by its amplitudes of cosines and sines, each by the multiple.
    fn amplitudes(self, coefficients: &[f64]) -> [Vec<f64>; 2] {
        let count = self.wave(coefficients.len() - 1).multiple + 1;
        let [mut cos, mut sin] = [vec![0.0; count], vec![0.0; count]];
        for (index, c) in coefficients.iter().enumerate() {
            let wave = self.wave(index);
            cos[wave.multiple] += c * wave.cos;
            sin[wave.multiple] += c * wave.sin;
        }
        [cos, sin]
    }
}

/// Numbers that a series of an order takes: `2N + 1` in every basis.
pub fn numbers_of_order(order: usize) -> usize {
    2 * order + 1
}

/// One value a basis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PerBasis<T>([T; Basis::ALL.len()]);

impl<T> PerBasis<T> {
    /// The value of each basis.
    pub fn of(value: impl FnMut(Basis) -> T) -> Self {
        Self(Basis::ALL.map(value))
    }
}

impl<T> Index<Basis> for PerBasis<T> {
    type Output = T;

    fn index(&self, basis: Basis) -> &T {
        &self.0[basis as usize]
    }
}

impl<T> IndexMut<Basis> for PerBasis<T> {
    fn index_mut(&mut self, basis: Basis) -> &mut T {
        &mut self.0[basis as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BAND: Band = Band::VISIBLE;

    #[test]
    fn every_basis_is_listed_in_its_place_under_words_of_its_own() {
        // serde names every variant where a word is none.
        let error = serde_json::from_str::<Basis>("\"\"").expect_err("no basis has no word");
        let named = error.to_string().matches('`').count() / 2 - 1;
        assert_eq!(named, Basis::ALL.len(), "{error}");
        for (place, basis) in Basis::ALL.into_iter().enumerate() {
            assert_eq!(basis as usize, place);
            assert_eq!(Basis::from_word(basis.word()), Some(basis));
            let in_json = serde_json::to_string(&basis).expect("a word");
            assert_eq!(in_json, format!("\"{}\"", basis.word()));
        }
    }

    #[test]
    fn the_waves_of_every_basis_are_orthogonal_on_the_grid_and_on_its_sample_points() {
        for basis in Basis::ALL {
            let count = 21;
            let rows = basis.rows(BAND, count);
            let rows: Vec<&[f64]> = rows.chunks_exact(BAND.points()).collect();
            for m in 0..count {
                let grown = basis.wave(m + 1).multiple - basis.wave(m).multiple;
                assert!(grown <= 1, "{basis:?} {m}");
                for (i, value) in rows[m].iter().enumerate() {
                    // Angles of up to 20 half turns, rounded once more on the long way.
                    assert!((value - basis.function(m, BAND, BAND.nm(i))).abs() < 1e-13);
                }
                for n in 0..count {
                    let expected = if m == n {
                        basis.norm_squared(m, BAND)
                    } else {
                        0.0
                    };
                    // 401 products of numbers up to 1.
                    assert!((BAND.inner(rows[m], rows[n]) - expected).abs() < 1e-10);
                    for points in [count, count + 1] {
                        let product =
                            |i| basis.at_sample(m, i, points) * basis.at_sample(n, i, points);
                        let sum: f64 = (0..points).map(product).sum();
                        let found = sum * basis.sample_scale(m, points);
                        let expected = f64::from(u8::from(m == n));
                        assert!(
                            (found - expected).abs() < 1e-12,
                            "{basis:?} {m} {n} {points}"
                        );
                    }
                }
            }
        }
    }
}
