//! Correlated colour temperature and Duv.
//!
//! Source: Y. Ohno, "Practical use and calculation of CCT and Duv", LEUKOS 10 (2014) 47-55
//! (online 2013): distances to a table of blackbody chromaticities in the CIE 1960 plane, then
//! a triangle through the two neighbours of the nearest entry when the light is close to the
//! locus, else a parabola through the three distances.
//!
//! The paper's factor 0.99991 repairs its table's 1 % steps. The error falls with the square of
//! the step: at the 0.1 % used here it would be 0.999999, far below what a lamp's CCT means, and
//! is left out.

use std::sync::LazyLock;

use crate::languages::fixed;

use super::{
    blackbody,
    chromaticity::uv_1960_from_xyz,
    observer::Observer,
    xyz::{self, Xyz},
};

/// Lowest temperature that is reported, K.
pub(super) const COLDEST_K: f64 = 1000.0;

/// Highest temperature that is reported, K.
pub(super) const HOTTEST_K: f64 = 100_000.0;

/// Largest distance from the blackbody locus at which a CCT means anything (CIE 15:2018).
pub(super) const FARTHEST_DUV: f64 = 0.05;

/// Ratio of neighbouring table temperatures.
const SPACING: f64 = 1.001;

/// |Duv| at which Ohno changes from the triangular to the parabolic solution.
const PARABOLIC_FROM_DUV: f64 = 0.002;

/// Table entries skipped in the first pass of the search: about the square root of the table.
const STRIDE: usize = 64;

/// Tolerance outside the range for the method's own error, as a share of T.
const RANGE_SLACK: f64 = 1e-5;

/// So cold that a blackbody has the colour of the red end of the locus of wavelengths, K.
const RED_END_K: f64 = 250.0;

/// So hot that the chromaticity differs from the limit by 1e-8, K.
const BLUE_END_K: f64 = 1e10;

/// A correlated colour temperature with its distance from the blackbody locus.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Cct {
    /// Temperature of the nearest blackbody, K.
    pub kelvin: f64,
    /// Distance from the locus in CIE 1960 uv: positive above it (greenish), negative below (pinkish).
    pub duv: f64,
}

/// Why a light has no correlated colour temperature.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum NoCct {
    /// There is no chromaticity to begin with.
    #[error("{}", said!("no CCT: there is no visible light"))]
    NoLight,
    /// Farther than `FARTHEST_DUV` from the blackbodies of every temperature.
    #[error(
        "{}",
        tr!(
            "no CCT: the colour is {duv} from the blackbody locus, more than {most}",
            duv = fixed(duv.abs(), 3),
            most = fixed(FARTHEST_DUV, 2)
        )
    )]
    TooFar {
        /// The distance from the nearest of them, with its sign.
        duv: f64,
    },
    /// Redder than a blackbody at `COLDEST_K`.
    #[error(
        "{}",
        tr!("no CCT: redder than a blackbody at {kelvin} K", kelvin = fixed(COLDEST_K, 0))
    )]
    TooCold,
    /// Bluer than a blackbody at `HOTTEST_K`.
    #[error(
        "{}",
        tr!("no CCT: bluer than a blackbody at {kelvin} K", kelvin = fixed(HOTTEST_K, 0))
    )]
    TooHot,
}

/// CCT and Duv of a light from its CIE 1931 XYZ in any scale.
///
/// # Errors
/// [`NoCct`] says why there is no number.
pub(crate) fn cct_from_xyz(xyz: Xyz) -> Result<Cct, NoCct> {
    cct_from_uv_1960(uv_1960_from_xyz(xyz).ok_or(NoCct::NoLight)?)
}

/// CCT and Duv from CIE 1960 `[u, v]` of the CIE 1931 observer.
///
/// # Errors
/// [`NoCct`] says why there is no number.
pub(crate) fn cct_from_uv_1960(uv: [f64; 2]) -> Result<Cct, NoCct> {
    if !uv.iter().all(|v| v.is_finite()) {
        return Err(NoCct::NoLight);
    }
    // The table reaches beyond the range by an entry on either side, so that every temperature of
    // the range has two neighbours; where an outermost entry is the nearest, there is no solution.
    let (nearest, last) = (nearest_entry(uv), LOCUS.len() - 1);
    let found = solution(uv, nearest.clamp(1, last - 1));
    let is_outermost = nearest == 0 || nearest == last;
    if is_outermost || found.duv.abs() > FARTHEST_DUV {
        return Err(beyond(uv, found.duv, is_outermost));
    }
    if found.kelvin < COLDEST_K * (1.0 - RANGE_SLACK) {
        return Err(NoCct::TooCold);
    }
    if found.kelvin > HOTTEST_K * (1.0 + RANGE_SLACK) {
        return Err(NoCct::TooHot);
    }
    Ok(Cct {
        kelvin: found.kelvin.clamp(COLDEST_K, HOTTEST_K),
        ..found
    })
}

/// CIE 1960 `[u, v]` of a blackbody, by 1 nm sums over 360-830 with the CIE 1931 observer;
/// `None` when it is too cold to emit visible light.
pub(crate) fn uv_1960_from_kelvin(kelvin: f64) -> Option<[f64; 2]> {
    if kelvin.is_nan() || kelvin <= 0.0 {
        return None;
    }
    // Some five thousand blackbodies fill the table at the first call, so what does not depend
    // on the temperature is kept, and what does not change the chromaticity is left out.
    let sum = PLANCK_WEIGHTS.iter().fold([0.0; 3], |sum, weight| {
        let power = 1.0 / ((weight.exponent_k / kelvin).exp() - 1.0);
        std::array::from_fn(|k| sum[k] + power * weight.xyz[k])
    });
    uv_1960_from_xyz(Xyz::from_array(sum))
}

/// Contribution of one nm to a blackbody's XYZ: `xyz / (exp(exponent_k / T) - 1)`.
struct PlanckWeight {
    /// `c2 / wavelength`, K.
    exponent_k: f64,
    /// Colour-matching functions over the fifth power of the wavelength (560 nm = 1).
    xyz: [f64; 3],
}

static PLANCK_WEIGHTS: LazyLock<Vec<PlanckWeight>> = LazyLock::new(|| {
    let table = Observer::CIE_1931.table();
    (xyz::FIRST_NM..=xyz::LAST_NM)
        .map(|nm| {
            let nm = f64::from(nm);
            let fifth = (560.0 / nm).powi(5);
            PlanckWeight {
                exponent_k: blackbody::C2_M_K * 1e9 / nm,
                xyz: table.at(nm).map(|v| v * fifth),
            }
        })
        .collect()
});

/// One blackbody of the table.
#[derive(Clone, Copy)]
struct Entry {
    kelvin: f64,
    uv: [f64; 2],
}

impl Entry {
    fn squared_distance(&self, [u, v]: [f64; 2]) -> f64 {
        let (du, dv) = (self.uv[0] - u, self.uv[1] - v);
        du * du + dv * dv
    }
}

static LOCUS: LazyLock<Vec<Entry>> = LazyLock::new(|| {
    let steps = (HOTTEST_K / COLDEST_K).ln() / SPACING.ln();
    (-1..=steps.ceil() as i32 + 1)
        .map(|step| {
            let kelvin = COLDEST_K * SPACING.powi(step);
            let uv = uv_1960_from_kelvin(kelvin).expect("a blackbody near 1000 K or above glows");
            Entry { kelvin, uv }
        })
        .collect()
});

/// Blackbodies colder than the range, from its end to the red end, and hotter ones to infinity:
/// evenly in reciprocal temperature, so near that the chords leave the curve by less than 1e-5.
static BEYOND: LazyLock<[Vec<[f64; 2]>; 2]> = LazyLock::new(|| {
    let between = |from: f64, to: f64, steps: u32| {
        let at = |step| {
            let share = f64::from(step) / f64::from(steps);
            uv_1960_from_kelvin(1.0 / ((1.0 - share) / from + share / to))
        };
        (0..=steps).filter_map(at).collect()
    };
    [
        between(COLDEST_K, RED_END_K, 60),
        between(HOTTEST_K, BLUE_END_K, 8),
    ]
});

/// Why a colour that has no solution has none: it lies at colder or hotter blackbodies than those
/// of the range, or far from all of them. The solution's own distance does not count where the
/// range ends before it.
fn beyond(uv: [f64; 2], solved_duv: f64, is_outermost: bool) -> NoCct {
    let [cold, hot] = BEYOND.each_ref().map(|locus| duv_from(uv, locus));
    let near = match cold.abs() <= hot.abs() {
        true => (cold, NoCct::TooCold),
        false => (hot, NoCct::TooHot),
    };
    match near {
        (duv, no) if duv.abs() <= FARTHEST_DUV => no,
        (duv, _) if is_outermost || duv.abs() < solved_duv.abs() => NoCct::TooFar { duv },
        _ => NoCct::TooFar { duv: solved_duv },
    }
}

/// Distance from a chain of chords, positive above it (greater v).
fn duv_from([u, v]: [f64; 2], chain: &[[f64; 2]]) -> f64 {
    let from_chord = |ends: &[[f64; 2]]| {
        let ([from_u, from_v], [to_u, to_v]) = (ends[0], ends[1]);
        let (du, dv) = (to_u - from_u, to_v - from_v);
        let along = ((u - from_u) * du + (v - from_v) * dv) / (du * du + dv * dv);
        let along = along.clamp(0.0, 1.0);
        let (off_u, off_v) = (u - from_u - along * du, v - from_v - along * dv);
        off_u.hypot(off_v).copysign(off_v)
    };
    let all = chain.windows(2).map(from_chord);
    all.min_by(|a, b| a.abs().total_cmp(&b.abs()))
        .unwrap_or(f64::INFINITY)
}

/// Index of the nearest entry: every 64th first, then all around the best.
fn nearest_entry(uv: [f64; 2]) -> usize {
    let closest = |candidates: &mut dyn Iterator<Item = usize>| {
        candidates
            .map(|i| (LOCUS[i].squared_distance(uv), i))
            .min_by(|a, b| a.0.total_cmp(&b.0))
            .map_or(0, |(_, i)| i)
    };
    let coarse = closest(&mut (0..LOCUS.len()).step_by(STRIDE));
    let from = coarse.saturating_sub(STRIDE);
    let to = (coarse + STRIDE).min(LOCUS.len() - 1);
    closest(&mut (from..=to))
}

/// Ohno's solution around one table entry, which has two neighbours.
fn solution(uv: [f64; 2], centre: usize) -> Cct {
    let [before, at, after] = [LOCUS[centre - 1], LOCUS[centre], LOCUS[centre + 1]];
    let [d_before, d_at, d_after] =
        [before, at, after].map(|entry| entry.squared_distance(uv).sqrt());

    // Foot of the perpendicular on the chord between the neighbours.
    let (du, dv) = (after.uv[0] - before.uv[0], after.uv[1] - before.uv[1]);
    let chord = du.hypot(dv);
    let along = (d_before * d_before - d_after * d_after + chord * chord) / (2.0 * chord);
    let share = along / chord;
    let sign = if uv[1] - (before.uv[1] + dv * share) < 0.0 {
        -1.0
    } else {
        1.0
    };
    let triangular = Cct {
        kelvin: before.kelvin + (after.kelvin - before.kelvin) * share,
        duv: sign * (d_before * d_before - along * along).max(0.0).sqrt(),
    };
    if triangular.duv.abs() < PARABOLIC_FROM_DUV {
        return triangular;
    }

    // Lowest point of the parabola through the three distances, in kelvin from the centre so that
    // nothing cancels.
    let (left, right) = (before.kelvin - at.kelvin, after.kelvin - at.kelvin);
    let (rise_left, rise_right) = ((d_before - d_at) / left, (d_after - d_at) / right);
    let curvature = (rise_right - rise_left) / (right - left);
    let slope = rise_left - curvature * left;
    if curvature > 0.0 {
        let offset = -slope / (2.0 * curvature);
        Cct {
            kelvin: at.kelvin + offset,
            duv: sign * (d_at + 0.5 * slope * offset),
        }
    } else {
        // Beyond the centre of the locus's curvature no parabola opens upwards.
        triangular
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_blackbody_has_its_own_temperature_and_lies_on_the_locus() {
        for kelvin in [
            1000.0, 1001.0, 1850.0, 2856.0, 6504.0, 25_000.0, 99_000.0, 100_000.0,
        ] {
            let found = cct_from_uv_1960(uv_1960_from_kelvin(kelvin).unwrap()).unwrap();
            // The chord of a 0.1 % table: about 1e-6 of T (see the module's head) at both ends
            // of the curved part of the locus.
            assert!(
                (found.kelvin / kelvin - 1.0).abs() < 2e-6,
                "{kelvin} {found:?}"
            );
            // The sagitta of that chord.
            assert!(found.duv.abs() < 2e-7, "{kelvin} {found:?}");
        }
    }

    #[test]
    fn the_quick_blackbody_of_the_table_is_plancks() {
        for kelvin in [1000.0, 2856.0, 100_000.0] {
            let light: Vec<f64> = (xyz::FIRST_NM..=xyz::LAST_NM)
                .map(|nm| blackbody::radiance(f64::from(nm), kelvin))
                .collect();
            let sums = xyz::xyz_from_nm_values(&light, Observer::CIE_1931);
            let (planck, quick) = (
                uv_1960_from_xyz(sums).unwrap(),
                uv_1960_from_kelvin(kelvin).unwrap(),
            );
            // Sums of 471 products, rounded differently.
            assert!((planck[0] - quick[0]).abs() < 1e-13);
            assert!((planck[1] - quick[1]).abs() < 1e-13);
        }
        for kelvin in [0.0, -1.0, 1.0, f64::NAN] {
            assert_eq!(uv_1960_from_kelvin(kelvin), None);
        }
    }

    #[test]
    fn a_step_across_the_locus_is_found_as_duv() {
        for kelvin in [1500.0, 3000.0, 6500.0, 15_000.0, 80_000.0] {
            let at = uv_1960_from_kelvin(kelvin).unwrap();
            let near = uv_1960_from_kelvin(kelvin * 1.000_01).unwrap();
            let (du, dv) = (near[0] - at[0], near[1] - at[1]);
            let length = du.hypot(dv);
            for duv in [-0.03, -0.004, -0.0015, 0.0015, 0.004, 0.03] {
                // Toward higher temperature the locus runs down and left: its left side is below.
                let uv = [at[0] + duv * dv / length, at[1] - duv * du / length];
                let found = cct_from_uv_1960(uv).unwrap();
                // Far from the locus the nearest point is blurred by distance times curvature.
                assert!(
                    (found.kelvin / kelvin - 1.0).abs() < 2e-5,
                    "{kelvin} {duv} {found:?}"
                );
                assert!((found.duv - duv).abs() < 1e-6, "{kelvin} {duv} {found:?}");
            }
        }
    }

    #[test]
    fn what_has_no_temperature_says_why() {
        assert_eq!(cct_from_xyz(Xyz::ZERO), Err(NoCct::NoLight));
        assert_eq!(cct_from_uv_1960([f64::NAN, 0.3]), Err(NoCct::NoLight));
        let green = cct_from_xyz(Xyz::new(0.063, 0.71, 0.078)).unwrap_err();
        assert!(
            matches!(green, NoCct::TooFar { duv } if duv > 0.05),
            "{green}"
        );
        assert!(green.to_string().contains("blackbody locus"));
        let red = cct_from_uv_1960(uv_1960_from_kelvin(900.0).unwrap());
        assert_eq!(red, Err(NoCct::TooCold));
        let blue = cct_from_uv_1960(uv_1960_from_kelvin(300_000.0).unwrap());
        assert_eq!(blue, Err(NoCct::TooHot));
    }

    #[test]
    fn no_blackbody_and_no_red_light_is_said_to_be_far_from_the_blackbodies() {
        for kelvin in [500.0, 700.0, 850.0, 999.0] {
            let uv = uv_1960_from_kelvin(kelvin).unwrap();
            assert_eq!(cct_from_uv_1960(uv), Err(NoCct::TooCold), "{kelvin}");
            // Chords leave the curve by less than 1e-5.
            assert!(duv_from(uv, &BEYOND[0]).abs() < 1e-5, "{kelvin}");
        }
        // Distances from blackbodies of every tenth of a kelvin from 200 K on, computed elsewhere:
        // a red LED of 620 nm and 20 nm width, and lasers.
        for (uv, distance) in [
            ([0.505_717_42, 0.349_391_04], 1.011e-4),
            ([0.520_211_45, 0.347_944_15], 5.97e-5),
            ([0.565_383_53, 0.343_451_22], 1.56e-5),
            ([0.619_942_34, 0.338_005_77], 6e-7),
        ] {
            assert_eq!(cct_from_uv_1960(uv), Err(NoCct::TooCold), "{uv:?}");
            let found = duv_from(uv, &BEYOND[0]);
            assert!((found.abs() - distance).abs() < 1e-5, "{uv:?}: {found}");
        }
    }

    #[test]
    fn the_distance_that_is_told_is_that_from_the_nearest_blackbody_of_all() {
        // Beside the cold end and beyond the hot one; computed elsewhere, as above.
        for (uv, expected) in [
            ([0.5, 0.25], -0.099_379),
            ([0.6, 0.25], -0.089_550),
            ([0.62, 0.4], 0.061_694),
            ([0.2, 0.1], -0.164_732),
        ] {
            let Err(NoCct::TooFar { duv }) = cct_from_uv_1960(uv) else {
                panic!("{uv:?}");
            };
            assert!((duv - expected).abs() < 1e-5, "{uv:?}: {duv}");
        }
    }

    #[test]
    fn every_chromaticity_has_a_sensible_answer() {
        for u in 0..140 {
            for v in 0..120 {
                let uv = [0.005 * f64::from(u), 0.005 * f64::from(v)];
                match cct_from_uv_1960(uv) {
                    Ok(Cct { kelvin, duv }) => {
                        assert!((COLDEST_K..=HOTTEST_K).contains(&kelvin), "{uv:?}");
                        assert!(duv.abs() <= FARTHEST_DUV, "{uv:?}");
                    }
                    // No point of this square is a unit away from the locus.
                    Err(NoCct::TooFar { duv }) => assert!(duv.abs() < 1.0, "{uv:?} {duv}"),
                    Err(NoCct::NoLight) => panic!("{uv:?}"),
                    Err(NoCct::TooCold) => assert!(uv[0] > 0.4, "{uv:?}"),
                    Err(NoCct::TooHot) => assert!(uv[0] < 0.25, "{uv:?}"),
                }
            }
        }
    }

    #[test]
    fn the_two_pass_search_finds_what_a_full_search_finds() {
        for u in 0..40 {
            for v in 0..40 {
                let uv = [0.1 + 0.01 * f64::from(u), 0.2 + 0.005 * f64::from(v)];
                let all = LOCUS
                    .iter()
                    .map(|entry| entry.squared_distance(uv))
                    .fold(f64::INFINITY, f64::min);
                let found = LOCUS[nearest_entry(uv)].squared_distance(uv);
                if all.sqrt() <= FARTHEST_DUV {
                    assert_eq!(found, all, "{uv:?}");
                }
            }
        }
    }
}
