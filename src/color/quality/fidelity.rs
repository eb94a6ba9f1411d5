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
    spectrum::Outside,
};

use super::{
    appearance::ViewingConditions,
    hue_bin::{BINS, BinSum, HueBin, bin_of, index_of},
    light::{FIRST_NM, Light, POINTS, positive},
    no_figure::NoFigure,
    reference::{Reference, fidelity_reference},
    weight::value_at,
};

/// Number of samples.
pub(crate) const SAMPLES: usize = 99;

/// Samples summed side by side: a common divisor of their number that keeps the registers full.
const ABREAST: usize = 3;

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
    /// What it was compared with.
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
    let ([tests, references], [test_white, reference_white]) = seen(light, &reference.on_nm())?;
    let too_narrow = || NoFigure::OutOfRange {
        what: "no eye adapts to a light that leaves one of its signals dark",
    };
    let eye = ViewingConditions::adapted_to(test_white).ok_or_else(too_narrow)?;
    let reference_eye = ViewingConditions::adapted_to(reference_white).ok_or_else(too_narrow)?;
    let mut samples = Vec::with_capacity(SAMPLES);
    let mut sums = [BinSum::default(); BINS];
    let mut total = 0.0;
    for (test, expected) in tests.into_iter().zip(references) {
        let [j, a, b] = eye.uniform(test);
        let [expected_j, expected_a, expected_b] = reference_eye.uniform(expected);
        let (dj, da, db) = (j - expected_j, a - expected_a, b - expected_b);
        let difference = (dj * dj + da * da + db * db).sqrt();
        total += difference;
        samples.push(index_of(difference));
        let sum = &mut sums[bin_of([expected_a, expected_b])];
        sum.samples += 1;
        sum.difference += difference;
        sum.test_ab = [sum.test_ab[0] + a, sum.test_ab[1] + b];
        sum.reference_ab = [
            sum.reference_ab[0] + expected_a,
            sum.reference_ab[1] + expected_b,
        ];
        sum.test_xyz += test;
        sum.reference_xyz += expected;
    }
    if !total.is_finite() {
        return Err(NoFigure::OutOfRange {
            what: "a sample has no appearance under this light",
        });
    }
    let means = sums.map(BinSum::mean);
    let filled = means.iter().flatten();
    let tested: Vec<[f64; 2]> = filled.clone().map(|bin| bin.test_ab).collect();
    let expected: Vec<[f64; 2]> = filled.map(|bin| bin.reference_ab).collect();
    Ok(Fidelity {
        rf: index_of(total / SAMPLES as f64),
        rg: 100.0 * area(&tested) / positive(area(&expected), "area of the reference's gamut")?,
        samples,
        bins: std::array::from_fn(|bin| means[bin].and_then(|mean| mean.figures(bin))),
        reference,
        test_white,
        reference_white,
    })
}

/// Names of the samples, in their order.
pub fn sample_names() -> &'static [String] {
    &TABLES.names
}

/// Reflectances of the samples on whole nm 360-830, zero outside 380-780 nm.
pub(crate) fn fidelity_factors() -> Vec<Vec<f64>> {
    let first = (SAMPLES_FIRST_NM - FIRST_NM) as usize;
    let rows = TABLES.samples.chunks_exact(SAMPLES_POINTS);
    let whole = |row: &[f64]| {
        let mut values = vec![0.0; POINTS];
        values[first..first + SAMPLES_POINTS].copy_from_slice(row);
        values
    };
    rows.map(whole).collect()
}

/// Area of a polygon.
pub(crate) fn area(points: &[[f64; 2]]) -> f64 {
    let next = points.iter().cycle().skip(1);
    let twice: f64 = points
        .iter()
        .zip(next)
        .map(|([x, y], [next_x, next_y])| x * next_y - next_x * y)
        .sum();
    0.5 * twice.abs()
}

/// Samples and light itself under the light and under the reference, each with Y = 100.
#[allow(clippy::type_complexity)]
fn seen(light: &Light, reference: &[f64]) -> Result<([Vec<Xyz>; 2], [Xyz; 2]), NoFigure> {
    let tables = &*TABLES;
    let skip = (SAMPLES_FIRST_NM - FIRST_NM) as usize;
    let weighted: Vec<[f64; 6]> = tables
        .observer
        .iter()
        .zip(&light.values()[skip..])
        .zip(&reference[skip..])
        .map(|((w, t), r)| [w[0] * t, w[1] * t, w[2] * t, w[0] * r, w[1] * r, w[2] * r])
        .collect();
    let mut whites = [[0.0; 6]];
    sum_rows([&tables.ones], &weighted, &mut whites);
    let mut sums = vec![[0.0; 6]; SAMPLES];
    let rows = tables.samples.chunks_exact(ABREAST * SAMPLES_POINTS);
    for (rows, sums) in rows.zip(sums.as_chunks_mut::<ABREAST>().0) {
        let rows: [&[f64]; ABREAST] =
            std::array::from_fn(|i| &rows[i * SAMPLES_POINTS..][..SAMPLES_POINTS]);
        sum_rows(rows, &weighted, sums);
    }
    for line in light.lines() {
        // Nothing is known of the samples outside their table.
        let inside = value_at(SAMPLES_FIRST_NM, &tables.ones, line.at_nm);
        let xyz = Observer::CIE_1964.table().at(line.at_nm);
        let xyz = xyz.map(|w| w * line.weight * inside);
        let rows = tables.samples.chunks_exact(SAMPLES_POINTS);
        for (sum, row) in sums.iter_mut().zip(rows) {
            let factor = value_at(SAMPLES_FIRST_NM, row, line.at_nm);
            (0..3).for_each(|k| sum[k] += factor * xyz[k]);
        }
        (0..3).for_each(|k| whites[0][k] += xyz[k]);
    }
    let [test_unit, reference_unit] = [
        100.0 / positive(whites[0][1], "sum with the 10° luminosity function")?,
        100.0 / positive(whites[0][4], "luminance of the reference")?,
    ];
    let test = |sum: &[f64; 6]| Xyz::new(sum[0], sum[1], sum[2]) * test_unit;
    let expected = |sum: &[f64; 6]| Xyz::new(sum[3], sum[4], sum[5]) * reference_unit;
    Ok((
        [
            sums.iter().map(test).collect(),
            sums.iter().map(expected).collect(),
        ],
        [test(&whites[0]), expected(&whites[0])],
    ))
}

/// Sums of rows times six weighted lights, several rows at once so that each weight is loaded once.
fn sum_rows<const N: usize>(rows: [&[f64]; N], weighted: &[[f64; 6]], sums: &mut [[f64; 6]; N]) {
    let rows = rows.map(|row| &row[..weighted.len()]);
    let mut running = [[0.0; 6]; N];
    for (i, weights) in weighted.iter().enumerate() {
        for (row, sum) in rows.iter().zip(&mut running) {
            let factor = row[i];
            for (s, w) in sum.iter_mut().zip(weights) {
                *s += factor * w;
            }
        }
    }
    *sums = running;
}

struct Tables {
    names: Vec<String>,
    /// One row of 401 values a sample.
    samples: Vec<f64>,
    /// The CIE 1964 functions at each nm of the samples.
    observer: Vec<[f64; 3]>,
    /// A perfect reflector.
    ones: Vec<f64>,
}

static TABLES: LazyLock<Tables> = LazyLock::new(|| {
    let group = preset::group(GROUP).expect("a shipped file, read in a test of the presets");
    let mut names = Vec::with_capacity(SAMPLES);
    let mut samples = Vec::with_capacity(SAMPLES * SAMPLES_POINTS);
    let last_nm = SAMPLES_FIRST_NM + SAMPLES_POINTS as u32 - 1;
    for item in &group.items {
        if let Some(table) = item.spectrum() {
            names.push(item.name.clone());
            samples.extend(
                table
                    .samples
                    .on_whole_nm(SAMPLES_FIRST_NM, last_nm, Outside::Hold),
            );
        }
    }
    assert_eq!(names.len(), SAMPLES, "a shipped file, read in a test");
    let observer = Observer::CIE_1964.table();
    Tables {
        names,
        samples,
        observer: (SAMPLES_FIRST_NM..=last_nm)
            .map(|nm| observer.at(f64::from(nm)))
            .collect(),
        ones: vec![1.0; SAMPLES_POINTS],
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
        assert!(TABLES.samples.iter().all(|v| (0.0..=1.0).contains(v)));
    }
}
