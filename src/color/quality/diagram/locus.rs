//! The spectral locus, blackbodies with their ticks, and daylight.

use crate::color::{Observer, Xyz, cct::uv_1960_from_kelvin, xy_from_xyz};

use super::{
    super::reference::daylight_xy,
    plane::{Plane, xy_from_uv_1960},
};

/// Temperatures at which the Planckian locus is marked, K; the last is its end.
pub(crate) const TICKS_K: [f64; 12] = [
    1000.0,
    1500.0,
    2000.0,
    2500.0,
    3000.0,
    4000.0,
    5000.0,
    6500.0,
    8000.0,
    10_000.0,
    20_000.0,
    f64::INFINITY,
];

/// So hot that the chromaticity differs from the limit by 1e-8, K.
const HOT_ENOUGH_K: f64 = 1e10;

/// Share of the temperature by which the direction of the locus is measured.
const STEP: f64 = 1e-4;

/// A wavelength's place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LocusPoint {
    /// Wavelength, nm.
    pub nm: u32,
    /// Coordinates in the plane.
    pub at: [f64; 2],
}

/// A mark across the Planckian locus: an isotherm between two Duv.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tick {
    /// Temperature, K; infinite at the end of the locus.
    pub kelvin: f64,
    /// On the locus.
    pub at: [f64; 2],
    /// The end below the locus, at -Duv.
    pub below: [f64; 2],
    /// The end above the locus, at +Duv.
    pub above: [f64; 2],
}

/// The locus of whole nm that an observer's table has, closed by the purple line when drawn.
pub(crate) fn spectral_locus(observer: Observer, plane: Plane) -> Vec<LocusPoint> {
    let table = observer.table();
    let points = (table.first_nm..=table.last_nm).filter_map(|nm| {
        let xyz = Xyz::from_array(table.at(f64::from(nm)));
        let at = plane.of_xy(xy_from_xyz(xyz)?);
        Some(LocusPoint { nm, at })
    });
    points.collect()
}

/// The curve of blackbodies from 1000 K to infinity, even in reciprocal temperature.
pub(crate) fn planckian_locus(plane: Plane) -> Vec<[f64; 2]> {
    const STEPS: u32 = 200;
    (0..=STEPS)
        .rev()
        .filter_map(|step| {
            let kelvin = 1000.0 * f64::from(STEPS) / f64::from(step);
            let uv = uv_1960_from_kelvin(kelvin.min(HOT_ENOUGH_K))?;
            Some(plane.of_xy(xy_from_uv_1960(uv)))
        })
        .collect()
}

/// A mark of a temperature that reaches `duv` to either side; `None` below some 300 K, where a
/// blackbody has no visible light.
pub(crate) fn tick(kelvin: f64, duv: f64, plane: Plane) -> Option<Tick> {
    let at = |duv| uv_1960_of_cct(kelvin, duv).map(|uv| plane.of_xy(xy_from_uv_1960(uv)));
    Some(Tick {
        kelvin,
        at: at(0.0)?,
        below: at(-duv)?,
        above: at(duv)?,
    })
}

/// CIE 1960 `[u, v]` of a correlated colour temperature (which may be infinite) and a Duv.
pub(crate) fn uv_1960_of_cct(kelvin: f64, duv: f64) -> Option<[f64; 2]> {
    let kelvin = kelvin.min(HOT_ENOUGH_K);
    let at = uv_1960_from_kelvin(kelvin)?;
    let (warm, cool) = if kelvin == HOT_ENOUGH_K {
        // At the limit the locus ends: its direction is that of what comes before.
        (uv_1960_from_kelvin(1e7)?, uv_1960_from_kelvin(1e8)?)
    } else {
        (
            uv_1960_from_kelvin(kelvin * (1.0 - STEP))?,
            uv_1960_from_kelvin(kelvin * (1.0 + STEP))?,
        )
    };
    let [du, dv] = [cool[0] - warm[0], cool[1] - warm[1]];
    let length = du.hypot(dv);
    // Across the locus, with growing v.
    let sign = if du < 0.0 { 1.0 } else { -1.0 };
    let across = [sign * dv / length, -sign * du / length];
    let found = [at[0] + duv * across[0], at[1] + duv * across[1]];
    found.iter().all(|v| v.is_finite()).then_some(found)
}

/// The curve of daylight by its formula, 4000-25000 K.
pub(crate) fn daylight_locus(plane: Plane) -> Vec<[f64; 2]> {
    const STEPS: u32 = 84;
    (0..=STEPS)
        .map(|step| {
            // Even in reciprocal megakelvin from 250 to 40.
            let mired = 250.0 - 2.5 * f64::from(step);
            plane.of_xy(daylight_xy(1e6 / mired))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::cct::cct_from_uv_1960;

    #[test]
    fn a_place_beside_the_locus_has_its_temperature_and_distance() {
        for kelvin in [1500.0, 2700.0, 4000.0, 6500.0, 20_000.0] {
            for duv in [-0.02, -0.006, 0.0, 0.006, 0.02] {
                let found = cct_from_uv_1960(uv_1960_of_cct(kelvin, duv).unwrap()).unwrap();
                // Ohno's parabola is off by some 1e-5 of T, more beside the locus at 20 000 K.
                assert!((found.kelvin / kelvin - 1.0).abs() < 5e-5, "{kelvin} {duv}");
                assert!((found.duv - duv).abs() < 1e-6, "{kelvin} {duv}");
            }
        }
    }

    #[test]
    fn curves_have_no_gap() {
        for plane in [Plane::Xy, Plane::Uv1976] {
            for curve in [planckian_locus(plane), daylight_locus(plane)] {
                let longest = curve
                    .windows(2)
                    .map(|w| (w[0][0] - w[1][0]).hypot(w[0][1] - w[1][1]))
                    .fold(0.0, f64::max);
                assert!(longest < 0.01, "{longest}");
            }
        }
        assert!(TICKS_K.iter().all(|k| tick(*k, 0.01, Plane::Xy).is_some()));
        assert_eq!(
            spectral_locus(Observer::CIE_2015_2DEG, Plane::Xy)[0].nm,
            390
        );
    }
}
