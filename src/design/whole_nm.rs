//! Lights on the whole nm of 360-830, of unit power: what channels are made of.
//!
//! A line without width is split over its two neighbouring nm, so that every weighting function
//! counts as it does between its own whole nm: by a straight line.

use crate::{
    color::{
        quality,
        xyz::{FIRST_NM, LAST_NM, POINTS},
    },
    preset,
    spectrum::{Outside, Sampled, gaussian},
};

/// Hottest and coldest daylight for which the formula is stated, K (CIE 15:2018).
pub(super) const DAYLIGHT_K: [f64; 2] = [4000.0, 25_000.0];

/// Wavelengths of the sums, nm.
pub(super) fn nm() -> impl Iterator<Item = f64> {
    (FIRST_NM..=LAST_NM).map(f64::from)
}

/// Divided by its sum; `None` without a positive one, and where a number is not finite.
pub(super) fn of_unit_power(mut values: Vec<f64>) -> Option<Vec<f64>> {
    let sum: f64 = values.iter().sum();
    values.iter_mut().for_each(|v| *v /= sum);
    (sum > 0.0 && values.iter().all(|v| v.is_finite())).then_some(values)
}

/// The two places that a line is split over, with its shares there; `None` outside 360-830 nm.
pub(super) fn split(at_nm: f64) -> Option<[(usize, f64); 2]> {
    let x = at_nm - f64::from(FIRST_NM);
    if !(x >= 0.0 && x <= (POINTS - 1) as f64) {
        return None;
    }
    let left = (x as usize).min(POINTS - 2);
    let share = x - left as f64;
    Some([(left, 1.0 - share), (left + 1, share)])
}

/// A line of unit power.
pub(super) fn line(at_nm: f64) -> Option<Vec<f64>> {
    let mut values = vec![0.0; POINTS];
    split(at_nm)?
        .iter()
        .for_each(|(i, share)| values[*i] += share);
    Some(values)
}

/// A Gaussian of full width `fwhm_nm` at half its height.
pub(super) fn gauss(centre_nm: f64, fwhm_nm: f64) -> Option<Vec<f64>> {
    of_unit_power(
        nm().map(|nm| gaussian((nm - centre_nm) / fwhm_nm))
            .collect(),
    )
}

/// A blackbody.
pub(super) fn planck(kelvin: f64) -> Option<Vec<f64>> {
    of_unit_power(quality::planck(kelvin))
}

/// Daylight by its components; `None` where that is no light.
pub(super) fn daylight(kelvin: f64) -> Option<Vec<f64>> {
    of_unit_power(quality::daylight(kelvin)).filter(|_| kelvin.is_finite())
}

/// A table, zero outside.
pub(super) fn table(light: &Sampled) -> Vec<f64> {
    light.on_whole_nm(FIRST_NM, LAST_NM, Outside::Zero)
}

/// The shipped table of a group; its absence is a broken build, which a test would show.
pub(super) fn shipped(group: &str, name: &str) -> &'static Sampled {
    preset::table(group, name).unwrap_or_else(|| panic!("no shipped table {group}/{name}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_has_unit_power_and_daylight_of_d65_is_d65() {
        for values in [
            line(546.07),
            gauss(500.0, 20.0),
            planck(2700.0),
            daylight(6504.0),
        ] {
            // Sums of 471 numbers below one.
            assert!((values.unwrap().iter().sum::<f64>() - 1.0).abs() < 1e-12);
        }
        let d65 = of_unit_power(table(shipped("cie_illuminants", "CIE D65"))).unwrap();
        let made = daylight(6503.6).unwrap();
        for (a, b) in d65.iter().zip(&made) {
            // The table was made with M1 and M2 rounded to three decimals, the components are
            // straight between 10 nm.
            assert!((a - b).abs() < 2e-3 * a.max(1e-3), "{a} {b}");
        }
    }

    #[test]
    fn what_is_no_light_is_none() {
        assert_eq!(line(359.0), None);
        assert_eq!(line(f64::NAN), None);
        assert_eq!(gauss(500.0, 0.0), None);
        assert_eq!(gauss(5000.0, 1.0), None);
        assert_eq!(planck(-1.0), None);
    }
}
