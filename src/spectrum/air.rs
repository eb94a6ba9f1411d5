//! Refractive index of air: between wavelengths in vacuum and wavelengths in air.
//!
//! Ciddor, Applied Optics 35 (1996) 1566-1573, Eq. 1: standard air (15 C, 101325 Pa, 450 ppm CO2),
//! with the wavelength in vacuum. Below [`SHORTEST_IN_AIR_NM`], where the measurements behind the
//! formula end and oxygen swallows the light, the index stays as it is there: nobody measures in
//! air, the formula has a pole at 132 nm, and wavelengths keep their order when they are converted.

use super::formula::gas;

/// Strengths (um^-2) and squared resonances (um^-2) of the two terms.
const CIDDOR: [f64; 4] = [0.057_921_05, 238.018_5, 0.001_679_17, 57.362];

/// The shortest wavelength in vacuum at which the formula is used, nm.
pub(crate) const SHORTEST_IN_AIR_NM: f64 = 185.0;

/// Index of refraction of standard air at a wavelength in vacuum, nm (above 0).
pub(crate) fn index_of_air(vacuum_nm: f64) -> f64 {
    gas(&CIDDOR, 1e-3 * vacuum_nm.max(SHORTEST_IN_AIR_NM))[0]
}

/// Change of the index of standard air with the wavelength in vacuum, 1/nm.
pub(crate) fn slope_of_air(vacuum_nm: f64) -> f64 {
    if vacuum_nm < SHORTEST_IN_AIR_NM {
        return 0.0;
    }
    1e-3 * gas(&CIDDOR, 1e-3 * vacuum_nm)[1]
}

/// The wavelength in air of light whose wavelength in vacuum is given, nm.
pub fn in_air(vacuum_nm: f64) -> f64 {
    vacuum_nm / index_of_air(vacuum_nm)
}

/// The wavelength in vacuum of light whose wavelength in air is given, nm: [`in_air`] backwards.
#[cfg(test)]
pub(crate) fn in_vacuum(air_nm: f64) -> f64 {
    // Each step leaves `l dn/dl` of the error of the one before: 1e-5 in the visible, 2e-4 at
    // 186 nm. The first error is 3e-4 at most, so four reach the last bit.
    let mut vacuum_nm = air_nm;
    for _ in 0..4 {
        vacuum_nm = air_nm * index_of_air(vacuum_nm);
    }
    vacuum_nm
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_have_the_wavelengths_in_air_that_tables_print() {
        // Mercury's green line and sodium's D2 as NIST's Atomic Spectra Database prints both, and
        // the helium-neon laser; printed to 1e-4 nm, so off by two halves of that.
        for (vacuum_nm, air_nm) in [
            (546.2267, 546.0750),
            (589.1583, 588.9951),
            (632.9914, 632.8164),
        ] {
            let found = in_air(vacuum_nm);
            assert!((found - air_nm).abs() < 1e-4, "{vacuum_nm}: {found}");
        }
    }

    #[test]
    fn the_slope_is_the_slope() {
        for nm in [200.0, 400.0, 589.0, 1500.0] {
            let rise = index_of_air(nm + 0.1) - index_of_air(nm - 0.1);
            // The index is told to 16 digits and its slope is down to 1e-9: the difference over .2
            // nm keeps six of its digits.
            let found = slope_of_air(nm);
            assert!((found / (rise / 0.2) - 1.0).abs() < 1e-5, "{nm}: {found}");
        }
    }

    #[test]
    fn the_way_back_is_the_way_there_and_order_stays() {
        let mut last = 0.0;
        for tenths in 100..30_000 {
            let vacuum_nm = 0.1 * f64::from(tenths);
            let air_nm = in_air(vacuum_nm);
            assert!(air_nm > last, "{vacuum_nm}");
            last = air_nm;
            // Roundings of the index, the division and the product back.
            assert!((in_vacuum(air_nm) - vacuum_nm).abs() <= 4.0 * f64::EPSILON * vacuum_nm);
        }
    }
}
