//! What a designed light is scored by: Ra, Rf, Rg, luminous efficacy, melanopic ratio.
//!
//! All of them are functions of sums that are linear in the light. [`Scales`] holds those sums
//! for each whole nm, for lights of one colour temperature (whose reference is then known), so that
//! a mixture of channels costs a few hundred products and not tables of wavelengths. The tables of
//! samples are given ([`SampleTables`]), so that the figures are those of whoever gives them.
//!
//! ```text
//! samples    the tables of test colours
//! rendering  CRI of CIE 13.3 from sums
//! fidelity   TM-30 of ANSI/IES TM-30-20 = CIE 224 from sums
//! ```

mod fidelity;
mod rendering;
mod samples;

use fidelity::FidelityScale;
use rendering::RenderingScale;
pub use samples::SampleTables;

use super::whole_nm;
use crate::{
    color::{
        Cct, Observer, Xyz, cct_from_xyz, quality::rendering_reference, weighting, xyz::POINTS,
    },
    spectrum::{Outside, Sampled},
};

/// Lumens of a watt at the peak of V, rounded as the programmes' reference counts them; 683.002 is
/// the unit's own, three millionths more.
pub(super) const LUMENS_PER_WATT: f64 = 683.0;

/// Sums that every light has: X, Y, Z, melanopic, power.
pub(super) const BASIC: usize = 5;

/// The linear sums of a light: all that its figures need.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sums {
    /// X, Y, Z (power x function), melanopic sum, power.
    pub(super) basic: [f64; BASIC],
    pub(super) rendering: Vec<f64>,
    pub(super) fidelity: Vec<f64>,
}

impl Sums {
    /// Adds `weight` times another light.
    pub(super) fn add(&mut self, other: &Self, weight: f64, with_samples: bool) {
        for (a, b) in self.basic.iter_mut().zip(&other.basic) {
            *a += weight * b;
        }
        if with_samples {
            self.rendering.resize(other.rendering.len(), 0.0);
            self.fidelity.resize(other.fidelity.len(), 0.0);
            let pairs = self.rendering.iter_mut().zip(&other.rendering);
            pairs.for_each(|(a, b)| *a += weight * b);
            let pairs = self.fidelity.iter_mut().zip(&other.fidelity);
            pairs.for_each(|(a, b)| *a += weight * b);
        }
    }

    /// X, Y, Z in power x colour-matching function.
    pub fn xyz(&self) -> Xyz {
        Xyz::new(self.basic[0], self.basic[1], self.basic[2])
    }

    /// Luminous efficacy of radiation, lm/W; zero without power.
    pub fn efficacy(&self) -> f64 {
        ratio(LUMENS_PER_WATT * self.basic[1], self.basic[4])
    }

    /// Melanopic daylight efficacy ratio (CIE S 026); zero without light.
    pub fn melanopic_der(&self) -> f64 {
        ratio(self.basic[3], self.basic[1]) / *MELANOPIC_OF_D65
    }
}

fn ratio(part: f64, whole: f64) -> f64 {
    let found = part / whole;
    if whole > 0.0 && found.is_finite() {
        found
    } else {
        0.0
    }
}

/// The colour-matching functions, melanopic sensitivity and one, at each whole nm.
static BASIC_ROWS: std::sync::LazyLock<Vec<[f64; BASIC]>> = std::sync::LazyLock::new(|| {
    let table = Observer::Cie1931.table();
    let melanopic = weighting("S026 s_mel (melanopic)").expect("a shipped table");
    let row = |nm: f64| {
        let [x, y, z] = table.at(nm);
        [x, y, z, melanopic.at(nm, Outside::Zero), 1.0]
    };
    whole_nm::nm().map(row).collect()
});

pub(super) static MELANOPIC_OF_D65: std::sync::LazyLock<f64> = std::sync::LazyLock::new(|| {
    let d65 = whole_nm::table(&whole_nm::shipped("cie_illuminants", "CIE D65"));
    let sums = basic_sums(&d65);
    sums[3] / sums[1]
});

/// The basic sums of a light on whole nm.
pub(super) fn basic_sums(values: &[f64]) -> [f64; BASIC] {
    let mut sums = [0.0; BASIC];
    for (value, row) in values.iter().zip(BASIC_ROWS.iter()) {
        (0..BASIC).for_each(|k| sums[k] += value * row[k]);
    }
    sums
}

/// The basic sums of a line of unit power; zeros outside 360-830 nm.
pub(super) fn basic_of_line(at_nm: f64) -> [f64; BASIC] {
    let mut sums = [0.0; BASIC];
    for (index, share) in whole_nm::split(at_nm).into_iter().flatten() {
        (0..BASIC).for_each(|k| sums[k] += share * BASIC_ROWS[index][k]);
    }
    sums
}

impl SampleTables {
    /// The sums of a light on whole nm.
    ///
    /// # Panics
    /// When `values` does not have 471 values.
    pub fn sums(&self, values: &[f64]) -> Sums {
        assert_eq!(values.len(), POINTS, "one value per nm of 360-830");
        Sums {
            basic: basic_sums(values),
            rendering: weighed(&self.rendering, values),
            fidelity: weighed(&self.fidelity, values),
        }
    }

    /// The sums of a line of unit power, for what is asked; empty where not asked.
    pub(super) fn line_sums(&self, at_nm: f64, rendering: bool, fidelity: bool) -> Sums {
        let split = whole_nm::split(at_nm);
        let between = |rows: &[f64], wanted: bool| {
            let Some([(left, a), (right, b)]) = split.filter(|_| wanted) else {
                return Vec::new();
            };
            let numbers = rows.len() / POINTS;
            let [here, next] = [left, right].map(|i| &rows[i * numbers..(i + 1) * numbers]);
            here.iter().zip(next).map(|(x, y)| a * x + b * y).collect()
        };
        Sums {
            basic: basic_of_line(at_nm),
            rendering: between(&self.rendering, rendering),
            fidelity: between(&self.fidelity, fidelity),
        }
    }
}

/// Figures of lights of one colour temperature.
#[derive(Clone, Debug)]
pub(super) struct Scales {
    cct: Cct,
    rendering: RenderingScale,
    fidelity: FidelityScale,
}

impl Scales {
    /// For lights of the colour temperature of `target`; `None` where it has none.
    pub(super) fn new(target: Xyz, tables: &SampleTables) -> Option<Self> {
        let cct = cct_from_xyz(target).ok()?;
        Some(Self {
            cct,
            rendering: RenderingScale::new(cct.kelvin, &tables.rendering)?,
            fidelity: FidelityScale::new(cct.kelvin, &tables.fidelity)?,
        })
    }

    /// The light that rendering is judged against, of unit power on whole nm.
    pub(super) fn reference(&self) -> Option<Vec<f64>> {
        whole_nm::of_unit_power(rendering_reference(self.cct.kelvin).on_nm())
    }

    /// General colour rendering index; `None` where a test colour has no chromaticity.
    pub(super) fn ra(&self, sums: &Sums) -> Option<f64> {
        self.rendering.ra(&sums.rendering)
    }

    /// Fidelity index; `None` for a light that no eye adapts to.
    pub(super) fn rf(&self, sums: &Sums) -> Option<f64> {
        self.fidelity.rf(&sums.fidelity)
    }

    /// Gamut index; `None` as [`Scales::rf`].
    pub(super) fn rg(&self, sums: &Sums) -> Option<f64> {
        self.fidelity.rg(&sums.fidelity)
    }
}

/// Sums of rows (those of a nm one behind the other) times a light.
fn weighed(rows: &[f64], values: &[f64]) -> Vec<f64> {
    let numbers = rows.len() / POINTS;
    let mut sums = vec![0.0; numbers];
    for (row, value) in rows.chunks_exact(numbers.max(1)).zip(values) {
        if *value != 0.0 {
            sums.iter_mut().zip(row).for_each(|(s, r)| *s += value * r);
        }
    }
    sums
}

/// Rows of samples (last the light itself): at each nm X, Y, Z of every sample.
fn sample_rows(samples: &[Vec<f64>], observer: Observer, first_nm: u32, last_nm: u32) -> Vec<f64> {
    let table = observer.table();
    let mut rows = Vec::with_capacity(POINTS * 3 * (samples.len() + 1));
    for (index, nm) in whole_nm::nm().enumerate() {
        let inside = (f64::from(first_nm)..=f64::from(last_nm)).contains(&nm);
        let seen = table.at(nm).map(|v| if inside { v } else { 0.0 });
        for sample in samples {
            rows.extend(seen.map(|v| v * sample[index]));
        }
        rows.extend(seen);
    }
    rows
}

/// Whether every sample has a value a nm.
fn fits(samples: &[Vec<f64>]) -> bool {
    samples
        .iter()
        .all(|s| s.len() == POINTS && s.iter().all(|v| v.is_finite()))
}

/// Samples on whole nm 360-830, end values held.
fn on_nm(samples: &Sampled) -> Vec<f64> {
    use crate::color::xyz::{FIRST_NM, LAST_NM};
    samples.on_whole_nm(FIRST_NM, LAST_NM, Outside::Hold)
}
