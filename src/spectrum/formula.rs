//! The nine dispersion formulas of refractiveindex.info (its document "Dispersion formulas"), with
//! the index and its slope in closed form.
//!
//! With `l` the wavelength in um and coefficients C1, C2, ...:
//!
//! ```text
//! 1 Sellmeier    n2 - 1 = C1 + C2 l2/(l2 - C3^2) + C4 l2/(l2 - C5^2) + ...
//! 2 Sellmeier-2  n2 - 1 = C1 + C2 l2/(l2 - C3) + C4 l2/(l2 - C5) + ...
//! 3 polynomial   n2 = C1 + C2 l^C3 + C4 l^C5 + ...
//! 4 the site's   n2 = C1 + C2 l^C3/(l2 - C4^C5) + C6 l^C7/(l2 - C8^C9) + C10 l^C11 + ...
//! 5 Cauchy       n = C1 + C2 l^C3 + C4 l^C5 + ...
//! 6 gases        n - 1 = C1 + C2/(C3 - l^-2) + C4/(C5 - l^-2) + ...
//! 7 Herzberger   n = C1 + C2/(l2 - 0.028) + C3 (1/(l2 - 0.028))^2 + C4 l2 + C5 l^4 + C6 l^6
//! 8 retro        (n2 - 1)/(n2 + 2) = C1 + C2 l2/(l2 - C3) + C4 l2
//! 9 exotic       n2 = C1 + C2/(l2 - C3) + C4 (l - C5)/((l - C5)^2 + C6)
//! ```

use serde::{Deserialize, Serialize};

/// Most coefficients of a formula, several times what any has: each counts at every wavelength.
pub(crate) const MOST_COEFFICIENTS: usize = 100;

/// A dispersion formula with its coefficients.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "Stored")]
pub struct Formula {
    number: u8,
    coefficients: Vec<f64>,
    range_nm: [f64; 2],
}

/// A formula as it is written, not checked yet.
#[derive(Deserialize)]
struct Stored {
    number: u8,
    coefficients: Vec<f64>,
    range_nm: [f64; 2],
}

impl TryFrom<Stored> for Formula {
    type Error = &'static str;

    fn try_from(stored: Stored) -> Result<Self, Self::Error> {
        Self::new(stored.number, stored.coefficients, stored.range_nm)
            .ok_or("expected a dispersion formula from 1 to 9 with finite coefficients and a range")
    }
}

/// Pairs of numbers; where the last stands alone, the other of its pair is zero.
fn pairs(numbers: &[f64]) -> impl Iterator<Item = (f64, f64)> {
    let second = |pair: &[f64]| pair.get(1).copied().unwrap_or(0.0);
    numbers.chunks(2).map(move |pair| (pair[0], second(pair)))
}

/// Index of a gas and its slope (1/um) at a wavelength, um: `n = 1 + sum a / (b - um^-2)`, with the
/// `a` and `b` of each term side by side, um^-2.
pub(super) fn gas(terms: &[f64], um: f64) -> Pair {
    let over = 1.0 / (um * um);
    let terms = pairs(terms).map(|(a, b)| {
        let off = b - over;
        [a / off, -2.0 * a * over / um / (off * off)]
    });
    above(1.0, sum(terms))
}

/// The index or its square, and the slope of the same.
pub(super) type Pair = [f64; 2];

impl Formula {
    /// Formula `number` with coefficients C1, C2, ... (missing ones are zero), published for a
    /// range of wavelengths, nm. `None` for a number other than 1 to 9, more than
    /// `MOST_COEFFICIENTS`, what is not finite, and a range that does not rise.
    pub fn new(number: u8, coefficients: Vec<f64>, range_nm: [f64; 2]) -> Option<Self> {
        let [from, to] = range_nm;
        let is_sound = (1..=9).contains(&number)
            && coefficients.len() <= MOST_COEFFICIENTS
            && coefficients.iter().all(|c| c.is_finite())
            && from.is_finite()
            && to.is_finite()
            && from <= to;
        is_sound.then_some(Self {
            number,
            coefficients,
            range_nm,
        })
    }

    /// Its number in the site's list, 1 to 9.
    pub fn number(&self) -> u8 {
        self.number
    }

    /// First and last wavelength that it was published for, nm.
    pub(crate) fn range_nm(&self) -> [f64; 2] {
        self.range_nm
    }

    /// Squared resonances, um^2, of a Sellmeier formula (1 and 2); none of the others.
    pub(crate) fn resonances_um2(&self) -> Vec<f64> {
        match self.number {
            1 => self.pairs(2).map(|(_, b)| b * b).collect(),
            2 => self.pairs(2).map(|(_, b)| b).collect(),
            _ => Vec::new(),
        }
    }

    /// Refractive index at a wavelength in um; NaN where the formula has no real value.
    pub fn index(&self, um: f64) -> f64 {
        self.index_and_slope(um)[0]
    }

    /// Refractive index at a wavelength in um, and its change with wavelength, 1/um, by the
    /// formula's derivative; NaN where the formula has no real value.
    pub(crate) fn index_and_slope(&self, um: f64) -> [f64; 2] {
        // Most formulas give the square of n, whose slope is 2 n times that of n.
        let root = |[square, slope]: Pair| {
            let n = square.sqrt();
            [n, 0.5 * slope / n]
        };
        match self.number {
            1 => root(self.sellmeier(um, |b| b * b)),
            2 => root(self.sellmeier(um, |b| b)),
            3 => root(above(self.c(1), self.powers(2, um))),
            4 => root(self.of_the_site(um)),
            5 => above(self.c(1), self.powers(2, um)),
            6 => self.of_gases(um),
            7 => self.herzberger(um),
            8 => root(self.retro(um)),
            _ => root(self.exotic(um)),
        }
    }

    /// Coefficient C1, C2, ...; zero where there is none.
    fn c(&self, place: usize) -> f64 {
        self.coefficients.get(place - 1).copied().unwrap_or(0.0)
    }

    /// Pairs (C2, C3), (C4, C5), ... from a place on.
    fn pairs(&self, from: usize) -> impl Iterator<Item = (f64, f64)> {
        let rest = self.coefficients.get(from - 1..).unwrap_or(&[]);
        pairs(rest)
    }

    fn sellmeier(&self, um: f64, resonance: impl Fn(f64) -> f64) -> Pair {
        let square = um * um;
        let terms = self.pairs(2).map(|(a, b)| {
            let off = square - resonance(b);
            [a * square / off, -2.0 * a * resonance(b) * um / (off * off)]
        });
        above(1.0 + self.c(1), sum(terms))
    }

    /// The sum of powers from a place on.
    fn powers(&self, from: usize, um: f64) -> Pair {
        let terms = self.pairs(from);
        sum(terms.map(|(a, b)| [a * um.powf(b), a * b * um.powf(b - 1.0)]))
    }

    fn of_the_site(&self, um: f64) -> Pair {
        let term = |from: usize| {
            let (a, power) = (self.c(from), self.c(from + 1));
            if a == 0.0 {
                return [0.0; 2];
            }
            let off = um * um - self.c(from + 2).powf(self.c(from + 3));
            let over = a * um.powf(power);
            let rise = a * power * um.powf(power - 1.0);
            [over / off, (rise * off - over * 2.0 * um) / (off * off)]
        };
        let terms = [term(2), term(6), self.powers(10, um)];
        above(self.c(1), sum(terms.into_iter()))
    }

    fn of_gases(&self, um: f64) -> Pair {
        above(
            self.c(1),
            gas(self.coefficients.get(1..).unwrap_or(&[]), um),
        )
    }

    fn herzberger(&self, um: f64) -> Pair {
        let square = um * um;
        let part = 1.0 / (square - 0.028);
        let d_part = -2.0 * um * part * part;
        let [c2, c3, c4, c5, c6] = [2, 3, 4, 5, 6].map(|place| self.c(place));
        [
            self.c(1)
                + c2 * part
                + c3 * part * part
                + c4 * square
                + c5 * square * square
                + c6 * square * square * square,
            (c2 + 2.0 * c3 * part) * d_part
                + (2.0 * c4 + 4.0 * c5 * square + 6.0 * c6 * square * square) * um,
        ]
    }

    fn retro(&self, um: f64) -> Pair {
        let (square, off) = (um * um, um * um - self.c(3));
        let ratio = self.c(1) + self.c(2) * square / off + self.c(4) * square;
        let slope = 2.0 * um * (self.c(4) - self.c(2) * self.c(3) / (off * off));
        let left = 1.0 - ratio;
        [(1.0 + 2.0 * ratio) / left, 3.0 * slope / (left * left)]
    }

    fn exotic(&self, um: f64) -> Pair {
        let (pole, off) = (um * um - self.c(3), um - self.c(5));
        let below = off * off + self.c(6);
        [
            self.c(1) + self.c(2) / pole + self.c(4) * off / below,
            -2.0 * self.c(2) * um / (pole * pole)
                + self.c(4) * (self.c(6) - off * off) / (below * below),
        ]
    }
}

/// Terms on top of a constant.
fn above(constant: f64, [value, slope]: Pair) -> Pair {
    [constant + value, slope]
}

/// Terms and their slopes, each added up.
fn sum(terms: impl Iterator<Item = Pair>) -> Pair {
    terms.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Formula `number` at a wavelength, um.
    fn index(number: u8, coefficients: &[f64], um: f64) -> f64 {
        let formula = Formula::new(number, coefficients.to_vec(), [200.0, 2000.0]);
        formula.expect("a formula").index(um)
    }

    #[test]
    fn a_last_coefficient_without_its_partner_counts() {
        // n = C1 + C2 um^0.
        assert!((index(5, &[1.5, 0.004], 0.589) - 1.504).abs() < 1e-15);
    }

    /// Published values: n at a wavelength (um) by the formula and coefficients of the site.
    #[test]
    fn published_indices_are_met() {
        // Water by Daimon and Masumura 2007, 20 C: 1.33336 at 587.6 nm.
        let water = [
            0.0,
            5.684_027_565e-1,
            5.101_829_712e-3,
            1.726_177_391e-1,
            1.821_153_936e-2,
            2.086_189_578e-2,
            2.620_722_293e-2,
            1.130_748_688e-1,
            1.069_792_721e1,
        ];
        assert!((index(2, &water, 0.5876) - 1.3334).abs() < 2e-4);
        // Air by Ciddor 1996: 1.000277 at 589.3 nm.
        let air = [0.0, 0.057_921_05, 238.0185, 0.001_679_17, 57.362];
        assert!((index(6, &air, 0.5893) - 1.000_277).abs() < 1e-6);
        // Silver bromide by Schroeter 1931 (formula 8): about 2.25 at 589 nm.
        let bromide = [0.452_505, 0.099_39, 0.070_537, -0.001_50];
        assert!((index(8, &bromide, 0.589) - 2.25).abs() < 0.03);
        // Urea, ordinary ray, by Rosker 1985 (formula 9): about 1.49 at 589 nm.
        let urea = [2.1823, 0.0125, 0.0300, 0.0, 0.0, 0.0];
        assert!((index(9, &urea, 0.589) - 1.49).abs() < 0.01);
    }

    #[test]
    fn formulas_of_one_meaning_agree() {
        let sellmeier = index(1, &[0.0, 1.0, 0.1], 0.5);
        assert_eq!(sellmeier, index(2, &[0.0, 1.0, 0.1_f64 * 0.1], 0.5));
        let cauchy = index(5, &[1.5, 0.004, -2.0], 0.5);
        let squared = index(3, &[cauchy * cauchy], 0.5);
        assert!((cauchy - 1.516).abs() < 1e-12 && (squared - cauchy).abs() < 1e-12);
        let fourth = index(
            4,
            &[2.25, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.01, -2.0],
            0.5,
        );
        assert!((fourth - index(3, &[2.25, 0.01, -2.0], 0.5)).abs() < 1e-12);
        assert_eq!(index(7, &[1.5], 0.5), 1.5);
        assert_eq!(Formula::new(0, Vec::new(), [200.0, 2000.0]), None);
        assert_eq!(Formula::new(1, vec![f64::NAN], [200.0, 2000.0]), None);
        assert_eq!(Formula::new(1, vec![0.0; 101], [200.0, 2000.0]), None);
        assert_eq!(Formula::new(1, vec![0.0], [2000.0, 200.0]), None);
    }

    /// At .5876 um, by mpmath with 50 digits and its numerical derivative. Coefficients of 3, 4
    /// and 9 are made up, so that every term counts.
    const ALL: [(u8, &[f64], f64, f64); 9] = [
        (
            1,
            &[
                0.0,
                1.03961212,
                0.0774641157,
                0.231792344,
                0.1414845652,
                1.01046945,
                10.17653,
            ],
            1.5167984321406007,
            -0.041791848427714225,
        ),
        (
            2,
            &[
                0.0,
                1.03961212,
                0.00600069867,
                0.231792344,
                0.0200179144,
                1.01046945,
                103.560653,
            ],
            1.5167984379050088,
            -0.041791954256078,
        ),
        (
            3,
            &[2.2, -0.0095, 2.0, 0.011, -2.0, 0.0002, -4.0],
            1.4934042764169095,
            -0.04386680537906345,
        ),
        (
            4,
            &[2.1, 0.9, 0.3, 0.11, 2.0, 0.4, 1.5, 9.0, 1.2, 0.003, -2.0],
            2.097253918485126,
            -1.6717248912592486,
        ),
        (
            5,
            &[1.5, 0.0042, -2.0, 0.00007, -4.0],
            1.512751440123654,
            -0.045400339117679635,
        ),
        (
            6,
            &[0.0, 0.05792105, 238.0185, 0.00167917, 57.362],
            1.0002771742391947,
            -1.59083898138135e-5,
        ),
        (
            7,
            &[
                3.41983,
                0.159906,
                -0.123109,
                0.00000126878,
                -1.95104e-09,
                0.0000000000012,
            ],
            2.700844496214111,
            7.193175767939923,
        ),
        (
            8,
            &[0.452505, 0.09939, 0.070537, -0.00150],
            2.2561995409093867,
            -0.4119199142953245,
        ),
        (
            9,
            &[2.1823, 0.0125, 0.0300, 0.017, 0.21, 0.0137],
            1.5043346081835742,
            -0.0789375070792348,
        ),
    ];

    #[test]
    fn index_and_slope_are_those_of_the_formula_to_rounding() {
        for (number, coefficients, n, slope) in ALL {
            let formula = Formula::new(number, coefficients.to_vec(), [200.0, 2000.0]);
            let found = formula.expect("a formula").index_and_slope(0.5876);
            // A dozen operations; 4 and 7 lose a digit in their differences.
            assert!((found[0] / n - 1.0).abs() < 1e-14, "{number}: {found:?}");
            assert!(
                (found[1] / slope - 1.0).abs() < 1e-12,
                "{number}: {found:?}"
            );
        }
    }
}
