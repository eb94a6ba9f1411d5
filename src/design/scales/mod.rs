//! The figures that score a designed light: Ra, Rf, Rg, luminous efficacy, melanopic ratio.
//!
//! All of them are functions of sums that are linear in the light. [`Scales`] holds those sums
//! for each whole nm, for lights of one colour temperature (whose reference is then known), so that
//! a mixture of channels costs a few hundred products and not tables of wavelengths. The tables of
//! samples are given ([`SampleTables`]), so that the figures are those of whoever gives them.

mod samples;

pub use samples::SampleTables;

use serde::{Deserialize, Serialize};

pub(super) use crate::color::quality::LUMENS_PER_WATT_ROUNDED as LUMENS_PER_WATT;

use super::whole_nm;
use crate::{
    color::{
        Observer, Xyz, cct_from_xyz,
        quality::{
            FidelityScale, RenderingScale, difference_of, fidelity_reference, index_of,
            rendering_difference, rendering_index, rendering_reference,
        },
        weighting,
        xyz::POINTS,
    },
    spectrum::Outside,
};

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
    pub(super) fn add(&mut self, other: &Self, weight: f64) {
        let add = |to: &mut [f64], from: &[f64]| {
            let both = to.iter_mut().zip(from);
            both.for_each(|(a, b)| *a += weight * b);
        };
        add(&mut self.basic, &other.basic);
        self.rendering.resize(other.rendering.len(), 0.0);
        add(&mut self.rendering, &other.rendering);
        self.fidelity.resize(other.fidelity.len(), 0.0);
        add(&mut self.fidelity, &other.fidelity);
    }

    /// X, Y, Z in power x colour-matching function.
    pub(crate) fn xyz(&self) -> Xyz {
        Xyz::new(self.basic[0], self.basic[1], self.basic[2])
    }

    /// Luminous efficacy of radiation, lm/W; zero without power.
    pub(crate) fn efficacy(&self) -> f64 {
        ratio(LUMENS_PER_WATT * self.basic[1], self.basic[4])
    }

    /// Melanopic daylight efficacy ratio (CIE S 026); zero without light.
    pub(crate) fn melanopic_der(&self) -> f64 {
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
    let table = Observer::CIE_1931.table();
    let melanopic = weighting("S026 s_mel (melanopic)").expect("a shipped table");
    let row = |nm: f64| {
        let [x, y, z] = table.at(nm);
        [x, y, z, melanopic.at(nm, Outside::Zero), 1.0]
    };
    whole_nm::nm().map(row).collect()
});

pub(super) static MELANOPIC_OF_D65: std::sync::LazyLock<f64> = std::sync::LazyLock::new(|| {
    let d65 = whole_nm::table(whole_nm::shipped("cie_illuminants", "CIE D65"));
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

    /// The sums of a line of unit power; none outside 360-830 nm.
    pub(super) fn line_sums(&self, at_nm: f64) -> Sums {
        let split = whole_nm::split(at_nm);
        let between = |rows: &[f64]| {
            let Some([(left, a), (right, b)]) = split else {
                return Vec::new();
            };
            let numbers = rows.len() / POINTS;
            let [here, next] = [left, right].map(|i| &rows[i * numbers..(i + 1) * numbers]);
            here.iter().zip(next).map(|(x, y)| a * x + b * y).collect()
        };
        Sums {
            basic: basic_of_line(at_nm),
            rendering: between(&self.rendering),
            fidelity: between(&self.fidelity),
        }
    }
}

/// A figure that is a mean over samples: what efficacy is traded for along a front.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Against {
    /// The fidelity index.
    #[default]
    Rf,
    /// The colour rendering index.
    Ra,
}

impl Against {
    /// Its sums of a light: X, Y, Z of each sample, last of the light itself.
    pub(super) fn sums_of(self, sums: &Sums) -> &[f64] {
        match self {
            Self::Ra => &sums.rendering,
            Self::Rf => &sums.fidelity,
        }
    }

    /// The mean difference of an index.
    pub(super) fn mean(self, index: f64) -> f64 {
        match self {
            Self::Ra => rendering_difference(index),
            Self::Rf => difference_of(index),
        }
    }
}

/// Figures of lights of one colour temperature.
#[derive(Clone, Debug)]
pub(super) struct Scales {
    rendering: RenderingScale,
    fidelity: FidelityScale,
}

impl Scales {
    /// For lights of the colour temperature of `target`; `None` where it has none.
    pub(super) fn new(target: Xyz, tables: &SampleTables) -> Option<Self> {
        let cct = cct_from_xyz(target).ok()?;
        let blackbody = weighed(&tables.rendering, &rendering_reference(cct.kelvin).on_nm());
        let mixture = weighed(&tables.fidelity, &fidelity_reference(cct.kelvin).on_nm());
        let (references, white) = colours(&blackbody)?;
        let (samples, samples_white) = colours(&mixture)?;
        Some(Self {
            rendering: RenderingScale::new(references, white)?,
            fidelity: FidelityScale::new(samples, samples_white)?,
        })
    }

    /// A figure; `None` where a sample has no colour, or no eye adapts to the light.
    pub(super) fn figure(&self, figure: Against, sums: &Sums) -> Option<f64> {
        self.figure_of(figure, figure.sums_of(sums))
    }

    /// The same from the sums of its samples alone.
    pub(super) fn figure_of(&self, figure: Against, samples: &[f64]) -> Option<f64> {
        let all = self.differences(figure, samples)?;
        let size = |d: &[f64; 3]| d.iter().map(|v| v * v).sum::<f64>().sqrt();
        let mean = all.iter().map(size).sum::<f64>() / all.len() as f64;
        let index = match figure {
            Against::Ra => rendering_index(mean),
            Against::Rf => index_of(mean),
        };
        index.is_finite().then_some(index)
    }

    /// Differences from the reference that a figure is a falling function of the mean size of:
    /// three numbers a sample, each a function of that sample's sums and the light's own.
    pub(super) fn differences(&self, figure: Against, samples: &[f64]) -> Option<Vec<[f64; 3]>> {
        let (samples, white) = colours(samples)?;
        match figure {
            Against::Ra => self.rendering.differences(samples, white),
            Against::Rf => self.fidelity.differences(samples, white),
        }
    }

    /// Gamut index; `None` for a light that no eye adapts to.
    pub(super) fn rg(&self, sums: &Sums) -> Option<f64> {
        let (samples, white) = colours(&sums.fidelity)?;
        self.fidelity.rg(samples, white)
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

/// The samples and the light itself of a row of sums, Y = 100 for the light; `None` in the dark.
fn colours(sums: &[f64]) -> Option<(impl Iterator<Item = Xyz> + '_, Xyz)> {
    let (samples, white) = sums.split_at_checked(sums.len().checked_sub(3)?)?;
    let unit = 100.0 / white[1];
    let at = move |xyz: &[f64]| Xyz::new(xyz[0], xyz[1], xyz[2]) * unit;
    (white[1] > 0.0 && unit.is_finite()).then(|| (samples.chunks_exact(3).map(at), at(white)))
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

/// True if every sample has one finite value per nm.
fn fits(samples: &[Vec<f64>]) -> bool {
    samples
        .iter()
        .all(|s| s.len() == POINTS && s.iter().all(|v| v.is_finite()))
}
