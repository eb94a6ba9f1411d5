//! Colour fidelity and gamut: Rf, Rg, the hue bins and the vector graphic.
//!
//! Sources: ANSI/IES TM-30-20, whose Rf is that of CIE 224:2017. 99 samples on their 1 nm table,
//! 380-780 nm, CIE 1964 observer, CAM02-UCS; a sample belongs to the bin of its hue under the
//! reference. Local shifts are along and across the middle direction of the bin, over the chroma
//! of the bin's mean reference colour.

use std::sync::LazyLock;

use crate::{
    color::{Cct, Observer, Xyz},
    preset,
    spectrum::{NamedSpectrum, Outside},
};

use super::{
    appearance::ViewingConditions,
    hue_bin::{BINS, BinSum, HueBin, bin_of, index_of},
    light::{FIRST_NM, Light, POINTS, positive},
    no_figure::NoFigure,
    reference::{Reference, fidelity_reference},
    test_colours::TestColours,
};

/// Number of samples.
pub(crate) const SAMPLES: usize = 99;

/// First nm of the samples' table.
const SAMPLES_FIRST_NM: u32 = 380;

/// Number of nm of the samples' table.
const SAMPLES_POINTS: usize = 401;

/// The group of the samples on their 1 nm table: that of 5 nm moves some to other hue bins.
const GROUP: &str = "tm30_ces99_1nm";

/// The fidelity of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Fidelity {
    /// Fidelity index, 0-100.
    pub rf: f64,
    /// Gamut index; 100 is the reference's.
    pub rg: f64,
    /// Fidelity of every sample, CES01 to CES99.
    pub samples: Vec<f64>,
    /// The hue bins; `None` where no sample has that hue under the reference.
    pub bins: [Option<HueBin>; BINS],
    /// The reference it was compared with.
    pub reference: Reference,
    /// The light itself (CIE 1964, Y = 100).
    pub test_white: Xyz,
    /// The reference itself (CIE 1964, Y = 100).
    pub reference_white: Xyz,
}

/// The fidelity of a light of this CCT.
///
/// # Errors
/// [`NoFigure`] when there is no light, or it is too narrow for an eye to adapt to.
pub fn fidelity(light: &Light, cct: Cct) -> Result<Fidelity, NoFigure> {
    let light = light.lit()?;
    let reference = fidelity_reference(cct.kelvin);
    let colours = &TABLES.colours;
    let (tests, test_white) = colours.under(light)?;
    let (references, reference_white) = colours.under(&Light::of_nm_values(&reference.on_nm()))?;
    let too_narrow = || NoFigure::OutOfRange {
        what: later!("no eye adapts to a light that leaves one of its signals dark"),
    };
    let scale = FidelityScale::new(references.iter().copied(), reference_white);
    let scale = scale.ok_or_else(too_narrow)?;
    let found = appearances(tests.iter().copied(), test_white).ok_or_else(too_narrow)?;
    let mut samples = Vec::with_capacity(SAMPLES);
    let mut sums = [BinSum::default(); BINS];
    let mut total = 0.0;
    for (i, [_, a, b]) in found.iter().enumerate() {
        let [_, expected_a, expected_b] = scale.expected[i];
        let difference = scale.difference(i, &found[i]);
        let difference = difference.iter().map(|d| d * d).sum::<f64>().sqrt();
        total += difference;
        samples.push(index_of(difference));
        let sum = &mut sums[scale.bins[i]];
        sum.samples += 1;
        sum.difference += difference;
        sum.test_ab = [sum.test_ab[0] + a, sum.test_ab[1] + b];
        sum.reference_ab = [
            sum.reference_ab[0] + expected_a,
            sum.reference_ab[1] + expected_b,
        ];
        sum.test_xyz += tests[i];
        sum.reference_xyz += references[i];
    }
    if !total.is_finite() {
        return Err(NoFigure::OutOfRange {
            what: later!("a sample has no appearance under this light"),
        });
    }
    positive(scale.area, later!("area of the reference's gamut"))?;
    let means = sums.map(BinSum::mean);
    Ok(Fidelity {
        rf: index_of(total / SAMPLES as f64),
        rg: scale.rg_of(&found),
        samples,
        bins: std::array::from_fn(|bin| means[bin].and_then(|mean| mean.figures(bin))),
        reference,
        test_white,
        reference_white,
    })
}

/// Samples under a reference, which the same under a light are compared with; all colours with
/// Y = 100 for their light (CIE 1964).
#[derive(Clone, Debug)]
pub(crate) struct FidelityScale {
    /// `[J', a', b']` of the samples.
    expected: Vec<[f64; 3]>,
    bins: Vec<usize>,
    area: f64,
}

impl FidelityScale {
    /// `None` where no eye adapts to the reference.
    pub(crate) fn new(references: impl Iterator<Item = Xyz>, white: Xyz) -> Option<Self> {
        let expected = appearances(references, white)?;
        let bins: Vec<usize> = expected.iter().map(|[_, a, b]| bin_of([*a, *b])).collect();
        let area = gamut_area(&expected, &bins);
        Some(Self {
            expected,
            bins,
            area,
        })
    }

    fn difference(&self, sample: usize, found: &[f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| found[k] - self.expected[sample][k])
    }

    /// `[J', a', b']` of each sample under a light less those under the reference; `None` where no
    /// eye adapts to the light.
    pub(crate) fn differences(
        &self,
        tests: impl Iterator<Item = Xyz>,
        white: Xyz,
    ) -> Option<Vec<[f64; 3]>> {
        let found = appearances(tests, white)?;
        let all = found.iter().enumerate();
        Some(all.map(|(i, found)| self.difference(i, found)).collect())
    }

    /// The gamut index; `None` where no eye adapts to the light.
    pub(crate) fn rg(&self, tests: impl Iterator<Item = Xyz>, white: Xyz) -> Option<f64> {
        let rg = self.rg_of(&appearances(tests, white)?);
        rg.is_finite().then_some(rg)
    }

    fn rg_of(&self, found: &[[f64; 3]]) -> f64 {
        100.0 * gamut_area(found, &self.bins) / self.area
    }
}

/// Area of the polygon of the bins' mean a'b'.
fn gamut_area(found: &[[f64; 3]], bins: &[usize]) -> f64 {
    let mut sums = [[0.0; 3]; BINS];
    for ([_, a, b], bin) in found.iter().zip(bins) {
        let sum = &mut sums[*bin];
        *sum = [sum[0] + a, sum[1] + b, sum[2] + 1.0];
    }
    let filled = sums.iter().filter(|sum| sum[2] > 0.0);
    let points: Vec<[f64; 2]> = filled.map(|[a, b, n]| [a / n, b / n]).collect();
    let next = points.iter().cycle().skip(1);
    let twice: f64 = points
        .iter()
        .zip(next)
        .map(|([x, y], [next_x, next_y])| x * next_y - next_x * y)
        .sum();
    0.5 * twice.abs()
}

/// `[J', a', b']` of every sample under a light; `None` where no eye adapts to it.
fn appearances(samples: impl Iterator<Item = Xyz>, white: Xyz) -> Option<Vec<[f64; 3]>> {
    let eye = ViewingConditions::adapted_to(white)?;
    Some(samples.map(|xyz| eye.uniform(xyz)).collect())
}

/// Names of the samples, in their order.
pub(crate) fn sample_names() -> &'static [String] {
    &TABLES.names
}

/// Reflectances of the samples on whole nm 360-830, zero outside 380-780 nm.
pub(crate) fn fidelity_factors() -> Vec<Vec<f64>> {
    let first = (SAMPLES_FIRST_NM - FIRST_NM) as usize;
    let whole = |row: &Vec<f64>| {
        let mut values = vec![0.0; POINTS];
        values[first..first + row.len()].copy_from_slice(row);
        values
    };
    TABLES.colours.rows.iter().map(whole).collect()
}

struct Tables {
    names: Vec<String>,
    colours: TestColours,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let group = preset::group(GROUP).expect("a shipped file, read in a test of the presets");
    let tables = group
        .items
        .iter()
        .filter_map(|item| Some((&item.name, item.spectrum()?)));
    let last_nm = SAMPLES_FIRST_NM + SAMPLES_POINTS as u32 - 1;
    let row = |(name, table): (&String, &NamedSpectrum)| {
        let row = table
            .samples
            .on_whole_nm(SAMPLES_FIRST_NM, last_nm, Outside::Hold);
        (name.clone(), row)
    };
    let (names, rows): (Vec<String>, Vec<Vec<f64>>) = tables.map(row).unzip();
    assert_eq!(names.len(), SAMPLES, "a shipped file, read in a test");
    Tables {
        names,
        colours: TestColours {
            first_nm: SAMPLES_FIRST_NM,
            rows,
            observer: Observer::CIE_1964,
            luminous_sum: later!("sum with the 10° luminosity function"),
        },
    }
});

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reference_is_its_own_copy() {
        for kelvin in [2000.0, 4000.0, 4500.0, 5000.0, 9000.0] {
            let light = Light::of_nm_values(&fidelity_reference(kelvin).on_nm());
            let found = fidelity(&light, Cct { kelvin, duv: 0.0 }).unwrap();
            assert_eq!(found.rf, 100.0, "{kelvin}");
            assert!((found.rg - 100.0).abs() < 1e-9);
            for bin in found.bins.iter().flatten() {
                // The 0.9th power enlarges the rounding of near-equal signals.
                assert!(bin.rcs.abs() < 1e-9 && bin.rhs.abs() < 1e-9);
                let [a, b] = bin.reference_ab;
                assert!((a.hypot(b) - 1.0).abs() < 1e-12, "on the unit circle");
            }
            let count: usize = found.bins.iter().flatten().map(|bin| bin.samples).sum();
            assert_eq!(count, SAMPLES);
        }
    }

    #[test]
    fn every_sample_is_a_reflectance() {
        assert_eq!(sample_names()[98], "CES99");
        assert!(
            TABLES
                .colours
                .rows
                .iter()
                .flatten()
                .all(|v| (0.0..=1.0).contains(v))
        );
    }
}
