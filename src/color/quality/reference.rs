//! Blackbodies and daylight: the lights that colour rendering and similarity are judged against.
//!
//! Sources: Planck's law with c2 = 1.4388e-2 m K; CIE 15:2018 for daylight, `S0 + M1 S1 + M2 S2`
//! with M1 and M2 as they come, not rounded to three decimals. The formula for the chromaticity of
//! daylight is stated for 4000-25000 K and is used as it is beyond.

use std::{fmt, sync::LazyLock};

use crate::{
    color::{blackbody::C2_M_K, observer::Observer},
    languages::fixed,
};

use super::{
    light::{FIRST_NM, LAST_NM, POINTS},
    weight::shipped,
};
use crate::spectrum::{Outside, dot};

/// Hottest temperature that the formula for daylight is stated for, K.
pub(super) const DAYLIGHT_TO_K: f64 = 25_000.0;

/// A reference light of a temperature.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reference {
    /// A blackbody.
    Planck {
        /// Its temperature, K.
        kelvin: f64,
    },
    /// A phase of daylight.
    Daylight {
        /// Its correlated colour temperature, K.
        kelvin: f64,
    },
    /// A mixture of both at equal luminance.
    Mixed {
        /// The temperature of either, K.
        kelvin: f64,
        /// The share of daylight, 0-1.
        daylight: f64,
    },
}

impl Reference {
    /// The reference on whole nm 360-830, relative.
    pub fn on_nm(self) -> Vec<f64> {
        match self {
            Self::Planck { kelvin } => planck(kelvin),
            Self::Daylight { kelvin } => daylight(kelvin),
            Self::Mixed {
                kelvin,
                daylight: share,
            } => {
                let (black, day) = (planck(kelvin), daylight(kelvin));
                let v = &Observer::CIE_1931.table().xyz[1];
                let (black_y, day_y) = (dot(&black, v), dot(&day, v));
                let mixed = black.iter().zip(&day);
                mixed
                    .map(|(b, d)| (1.0 - share) * b / black_y + share * d / day_y)
                    .collect()
            }
        }
    }

    /// The temperature, K.
    pub fn kelvin(self) -> f64 {
        match self {
            Self::Planck { kelvin } | Self::Daylight { kelvin } | Self::Mixed { kelvin, .. } => {
                kelvin
            }
        }
    }
}

impl fmt::Display for Reference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Planck { kelvin } => {
                f.write_str(&tr!("blackbody of {kelvin} K", kelvin = fixed(kelvin, 0)))
            }
            Self::Daylight { kelvin } => {
                f.write_str(&tr!("daylight of {kelvin} K", kelvin = fixed(kelvin, 0)))
            }
            Self::Mixed { kelvin, daylight } => f.write_str(&tr!(
                "blackbody and {share} % daylight of {kelvin} K",
                share = fixed(100.0 * daylight, 0),
                kelvin = fixed(kelvin, 0)
            )),
        }
    }
}

/// The reference of CRI: a blackbody below 5000 K, else daylight (CIE 13.3).
pub(crate) fn rendering_reference(kelvin: f64) -> Reference {
    if kelvin < 5000.0 {
        Reference::Planck { kelvin }
    } else {
        Reference::Daylight { kelvin }
    }
}

/// The reference of TM-30: a blackbody to 4000 K, daylight from 5000 K, between them mixed in
/// proportion.
pub fn fidelity_reference(kelvin: f64) -> Reference {
    if kelvin <= 4000.0 {
        Reference::Planck { kelvin }
    } else if kelvin >= 5000.0 {
        Reference::Daylight { kelvin }
    } else {
        Reference::Mixed {
            kelvin,
            daylight: (kelvin - 4000.0) / 1000.0,
        }
    }
}

/// A blackbody on whole nm 360-830, relative; zeros for a temperature that is not positive.
pub(crate) fn planck(kelvin: f64) -> Vec<f64> {
    if kelvin.is_nan() || kelvin <= 0.0 {
        return vec![0.0; POINTS];
    }
    // Relative to 560 nm in the exponent, so that nothing vanishes for the coldest.
    let reference = C2_M_K * 1e9 / 560.0 / kelvin;
    PLANCK
        .iter()
        .map(|(fifth, exponent_k)| {
            let exponent = exponent_k / kelvin;
            let value = fifth * (reference - exponent).exp() / -(-exponent).exp_m1();
            if value.is_finite() { value } else { 0.0 }
        })
        .collect()
}

/// Per nm `(560 / nm)^5` and `c2 / nm` in K.
static PLANCK: LazyLock<Vec<(f64, f64)>> = LazyLock::new(|| {
    let nm = (FIRST_NM..=LAST_NM).map(f64::from);
    nm.map(|nm| ((560.0 / nm).powi(5), C2_M_K * 1e9 / nm))
        .collect()
});

/// CIE 1931 chromaticity of daylight by its formula; below 1000 K that of 1000 K.
pub(crate) fn daylight_xy(kelvin: f64) -> [f64; 2] {
    // `max` also takes what is no number to 1000 K.
    let kelvin = kelvin.max(1000.0);
    let t = 1000.0 / kelvin;
    let [c0, c1, c2, c3] = if kelvin <= 7000.0 {
        [0.244063, 0.09911, 2.9678, -4.6070]
    } else {
        [0.237040, 0.24748, 1.9018, -2.0064]
    };
    let x = c0 + t * (c1 + t * (c2 + t * c3));
    [x, -3.0 * x * x + 2.870 * x - 0.275]
}

/// Daylight on whole nm 360-830, relative.
pub(crate) fn daylight(kelvin: f64) -> Vec<f64> {
    let [m1, m2] = daylight_factors(kelvin);
    let [s0, s1, s2] = &*COMPONENTS;
    let parts = s0.iter().zip(s1).zip(s2);
    parts.map(|((s0, s1), s2)| s0 + m1 * s1 + m2 * s2).collect()
}

/// `M1` and `M2` of daylight.
pub(crate) fn daylight_factors(kelvin: f64) -> [f64; 2] {
    let [x, y] = daylight_xy(kelvin);
    let m = 0.0241 + 0.2562 * x - 0.7341 * y;
    [
        (-1.3515 - 1.7703 * x + 5.9114 * y) / m,
        (0.0300 - 31.4424 * x + 30.0717 * y) / m,
    ]
}

/// The daylight components S0, S1 and S2 on whole nm 360-830.
static COMPONENTS: LazyLock<[Vec<f64>; 3]> = LazyLock::new(|| {
    [0, 1, 2].map(|k| {
        shipped("cie_illuminants", &format!("CIE daylight component S{k}")).on_whole_nm(
            FIRST_NM,
            LAST_NM,
            Outside::Zero,
        )
    })
});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::blackbody;

    #[test]
    fn a_blackbody_is_plancks_law_relative_to_560_nm() {
        for kelvin in [1000.0, 2856.0, 6500.0, 100_000.0] {
            let (here, peak) = (planck(kelvin), blackbody::relative(560.0, kelvin));
            for (value, nm) in here.iter().zip(FIRST_NM..) {
                // `relative` divides by expm1 at 560 nm as well: a constant factor.
                let factor = here[200] / peak;
                let expected = factor * blackbody::relative(f64::from(nm), kelvin);
                // Exponents up to 40 carry a rounding of 40 ulps.
                assert!((value / expected - 1.0).abs() < 1e-13, "{kelvin} {nm}");
            }
        }
        for nothing in [0.0, -1.0, f64::NAN] {
            assert!(planck(nothing).iter().all(|v| *v == 0.0));
        }
        for odd in [0.0, -1.0, 1e-300, 1e300, f64::NAN, f64::INFINITY] {
            assert!(planck(odd).iter().all(|v| v.is_finite()));
            assert!(daylight(odd).iter().all(|v| v.is_finite()));
        }
    }

    #[test]
    fn the_mixture_joins_both_ends() {
        for (kelvin, pure) in [
            (4000.000001, Reference::Planck { kelvin: 4000.0 }),
            (4999.999999, Reference::Daylight { kelvin: 5000.0 }),
        ] {
            let (mixed, pure) = (fidelity_reference(kelvin).on_nm(), pure.on_nm());
            let factor = pure[200] / mixed[200];
            let close = mixed.iter().zip(&pure);
            // A microkelvin is 1e-9 of the way, and the spectra differ by less than a half.
            assert!(
                close
                    .into_iter()
                    .all(|(m, p)| (m * factor / p - 1.0).abs() < 1e-8)
            );
        }
    }
}
