//! Spectral similarity index: SSI (SMPTE ST 2122:2020, Academy S-2018-001).
//!
//! 30 bands of 10 nm at 380, 390 .. 670 nm, each the trapezium sum of whole nm (both ends half),
//! light and reference each divided by its sum; relative differences `(t - r) / (r + 1/30)`,
//! weighted, smoothed by .22 .56 .22, and `100 - 32 sqrt(sum of squares)`. The standard shows the
//! number rounded; it may be negative for lights of a few lines and is not cut off here. A line of
//! no width counts as the two whole nm beside it do, by its distance to each: whole in the band that
//! both are in, and evenly from one to the other where it crosses a border.

use std::{fmt, sync::LazyLock};

use super::{
    light::{FIRST_NM, Light, positive},
    no_figure::NoFigure,
    reference::{daylight, planck},
    weight::shipped,
};

const BANDS: usize = 30;
const BAND_NM: usize = 10;

/// Lower edge of the first band, nm.
const FROM_NM: u32 = 375;

/// From this temperature on the reference is daylight, K.
const DAYLIGHT_FROM_K: f64 = 4000.0;

/// The weights of the five bands at the blue end and of the two at the red one; 1 between.
const BLUE_END: [f64; 5] = [
    12.0 / 45.0,
    22.0 / 45.0,
    32.0 / 45.0,
    40.0 / 45.0,
    44.0 / 45.0,
];
const RED_END: [f64; 2] = [11.0 / 15.0, 3.0 / 15.0];

/// The reference that a light is compared with.
#[derive(Clone, Debug, PartialEq)]
pub enum SimilarityReference {
    /// A blackbody of this temperature, K: `P2856`.
    Planck(f64),
    /// Daylight by its formula at this temperature, K: `D5500`.
    Daylight(f64),
    /// Another light, by its name.
    Other(String),
}

impl SimilarityReference {
    /// The reference of a CCT: rounded to 1 K, a blackbody below 4000 K, else daylight.
    pub(crate) fn of_cct(kelvin: f64) -> Self {
        let kelvin = kelvin.round();
        if kelvin < DAYLIGHT_FROM_K {
            Self::Planck(kelvin)
        } else {
            Self::Daylight(kelvin)
        }
    }
}

impl fmt::Display for SimilarityReference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Planck(kelvin) => write!(f, "P{kelvin:.0}"),
            Self::Daylight(kelvin) => write!(f, "D{kelvin:.0}"),
            Self::Other(name) => f.write_str(name),
        }
    }
}

/// A light in the 30 bands, as shares of their sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SimilarityBands([f64; BANDS]);

impl SimilarityBands {
    /// The bands of a light.
    ///
    /// # Errors
    /// [`NoFigure`] when there is no light in 375-675 nm.
    pub(crate) fn of(light: &Light) -> Result<Self, NoFigure> {
        let light = light.lit()?;
        let mut bands = of_values(light.values());
        for line in light.lines() {
            let below = line.at_nm.floor();
            let beyond = line.at_nm - below;
            add_at(&mut bands, below, (1.0 - beyond) * line.weight);
            add_at(&mut bands, below + 1.0, beyond * line.weight);
        }
        Self::of_sums(bands, later!("sum of 375-675 nm"))
    }

    fn of_sums(mut bands: [f64; BANDS], sum: &'static str) -> Result<Self, NoFigure> {
        let total = positive(bands.iter().sum(), sum)?;
        bands.iter_mut().for_each(|band| *band /= total);
        Ok(Self(bands))
    }

    /// The bands of a reference that is no other light.
    fn of_reference(reference: &SimilarityReference) -> Option<Self> {
        let values = match reference {
            SimilarityReference::Planck(kelvin) => planck(*kelvin),
            SimilarityReference::Daylight(kelvin) => daylight(*kelvin),
            SimilarityReference::Other(_) => return None,
        };
        Self::of_sums(of_values(&values), "reference").ok()
    }

    /// SSI of these bands against a reference's: 100 for the same light, not rounded, maybe
    /// negative.
    pub(crate) fn similarity_to(&self, reference: &Self) -> f64 {
        let mut padded = [0.0; BANDS + 2];
        for (band, difference) in padded[1..=BANDS].iter_mut().enumerate() {
            let (t, r) = (self.0[band], reference.0[band]);
            *difference = weight_of(band) * (t - r) / (r + 1.0 / BANDS as f64);
        }
        let smooth = padded
            .windows(3)
            .map(|w| 0.22 * w[0] + 0.56 * w[1] + 0.22 * w[2]);
        100.0 - 32.0 * smooth.map(|d| d * d).sum::<f64>().sqrt()
    }
}

fn of_values(values: &[f64]) -> [f64; BANDS] {
    let first = (FROM_NM - FIRST_NM) as usize;
    std::array::from_fn(|band| {
        let here = &values[first + band * BAND_NM..][..=BAND_NM];
        here.iter().sum::<f64>() - 0.5 * (here[0] + here[BAND_NM])
    })
}

/// Adds what stands at a whole nm: half to either band at a border, nothing outside.
fn add_at(bands: &mut [f64; BANDS], nm: f64, weight: f64) {
    let x = nm - f64::from(FROM_NM);
    if !(0.0..=(BANDS * BAND_NM) as f64).contains(&x) {
        return;
    }
    let right = x as usize / BAND_NM;
    let is_border = (x as usize).is_multiple_of(BAND_NM);
    if !is_border {
        bands[right] += weight;
        return;
    }
    for band in [right.checked_sub(1), Some(right)].into_iter().flatten() {
        if let Some(band) = bands.get_mut(band) {
            *band += 0.5 * weight;
        }
    }
}

fn weight_of(band: usize) -> f64 {
    let from_end = BANDS - band;
    if band < BLUE_END.len() {
        BLUE_END[band]
    } else if from_end <= RED_END.len() {
        RED_END[RED_END.len() - from_end]
    } else {
        1.0
    }
}

/// The similarity of a light to its own reference and to fixed ones, not rounded.
#[derive(Clone, Debug, PartialEq)]
pub struct Similarity {
    /// The light in bands, to compare it with any other.
    pub bands: SimilarityBands,
    /// The reference of its CCT and the index; why there is none else.
    pub of_cct: Result<(SimilarityReference, f64), NoFigure>,
    /// Against a blackbody of 3200 K.
    pub p3200: f64,
    /// Against the table of D55.
    pub d55: f64,
    /// Against the table of D65.
    pub d65: f64,
}

/// The similarity of a light of this CCT, if it has one.
///
/// # Errors
/// [`NoFigure`] when there is no light in 375-675 nm.
pub(crate) fn similarity(
    light: &Light,
    kelvin: Result<f64, NoFigure>,
) -> Result<Similarity, NoFigure> {
    let bands = SimilarityBands::of(light)?;
    let of_cct = kelvin.and_then(|kelvin| {
        let reference = SimilarityReference::of_cct(kelvin);
        let expected = SimilarityBands::of_reference(&reference).ok_or(NoFigure::DarkReference)?;
        Ok((reference, bands.similarity_to(&expected)))
    });
    let [p3200, d55, d65] = FIXED.each_ref().map(|fixed| bands.similarity_to(fixed));
    Ok(Similarity {
        bands,
        of_cct,
        p3200,
        d55,
        d65,
    })
}

/// P3200, D55 and D65.
static FIXED: LazyLock<[SimilarityBands; 3]> = LazyLock::new(|| {
    let of = |light: Light| SimilarityBands::of(&light).expect("a reference is lit");
    [
        of(Light::of_nm_values(&planck(3200.0))),
        of(Light::of_sampled(shipped("cie_illuminants", "CIE D55"))),
        of(Light::of_sampled(shipped("cie_illuminants", "CIE D65"))),
    ]
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::{Band, Line};

    fn line(at_nm: f64) -> [f64; BANDS] {
        let light = Light::of_line(Line::ideal(at_nm, 2.0));
        SimilarityBands::of(&light).unwrap().0
    }

    #[test]
    fn a_light_is_like_itself_and_a_line_like_no_other() {
        for fixed in &*FIXED {
            assert_eq!(fixed.similarity_to(fixed), 100.0);
        }
        let sodium = SimilarityBands(line(589.3));
        assert!(sodium.similarity_to(&FIXED[0]) < 0.0);
    }

    #[test]
    fn a_line_counts_in_its_band_and_half_at_a_border() {
        assert_eq!(line(379.9)[0], 1.0);
        assert_eq!(line(384.0)[0], 1.0);
        assert_eq!(line(385.0)[..2], [0.5, 0.5]);
        // As 385 nm has half in either band and 386 nm all in the second: three quarters.
        assert_eq!(line(385.5)[..2], [0.25, 0.75]);
        // Half of a line at either outer border is outside; shares are of what is inside.
        assert_eq!(line(375.0)[0], 1.0);
        assert_eq!(line(675.0)[29], 1.0);
        let outside = Light::of_line(Line::ideal(700.0, 1.0));
        assert!(SimilarityBands::of(&outside).is_err());
    }

    #[test]
    fn a_line_that_moves_by_little_changes_the_bands_by_little() {
        const STEP_NM: f64 = 1e-6;
        let band = Band::new(360.0, 830.0).unwrap();
        let shares = |at_nm: f64| {
            let line = Line::ideal(at_nm, 50.0);
            let light = Light::of_parts(band, &vec![1.0; band.points()], &[line]);
            SimilarityBands::of(&light).unwrap().0
        };
        for tenth in 3740..=6760 {
            let at_nm = f64::from(tenth) / 10.0;
            let [below, at, above] = [at_nm - STEP_NM, at_nm, at_nm + STEP_NM].map(shares);
            for (one, other) in below.iter().zip(at).chain(above.iter().zip(at)) {
                // A whole line goes from a band to the next within 2 nm, and it is about one in seven
                // of the light.
                assert!((one - other).abs() < STEP_NM, "{at_nm}: {one} {other}");
            }
        }
    }

    #[test]
    fn the_weights_are_those_of_the_standard() {
        let weights: Vec<f64> = (0..BANDS).map(weight_of).collect();
        assert_eq!(weights.iter().filter(|w| **w == 1.0).count(), 23);
        assert_eq!(weights[..5], BLUE_END);
        assert_eq!(weights[28..], RED_END);
    }

    #[test]
    fn the_reference_is_named_after_the_rounded_temperature() {
        assert_eq!(SimilarityReference::of_cct(2855.6).to_string(), "P2856");
        assert_eq!(SimilarityReference::of_cct(3999.5).to_string(), "D4000");
        assert_eq!(SimilarityReference::of_cct(3999.4).to_string(), "P3999");
    }
}
