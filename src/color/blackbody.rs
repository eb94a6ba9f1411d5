//! Planck's law, for lights and for the locus that colour temperature refers to.

/// Second radiation constant `c2 = h c / k` in m K.
///
/// Colour temperature is tied to this rounded value (ITS-90, CIE 15:2018); CODATA's would shift
/// every CCT by 1.6e-5 of itself.
pub(crate) const C2_M_K: f64 = 1.4388e-2;

/// The same as measured (CODATA 2018), m K: the known lamps' blackbodies.
pub(crate) const C2_CODATA_M_K: f64 = 1.438_776_877e-2;

/// First radiation constant for radiance, `2 h c^2` in W m2 sr-1, from the exact SI values.
const C1_RADIANCE: f64 = 2.0 * 6.626_070_15e-34 * 299_792_458.0 * 299_792_458.0;

const NM_PER_M: f64 = 1e9;

/// Spectral radiance of a blackbody, W m-2 sr-1 nm-1.
///
/// Zero when wavelength or temperature is not positive.
pub fn radiance(at_nm: f64, kelvin: f64) -> f64 {
    if !(at_nm > 0.0 && kelvin > 0.0) {
        return 0.0;
    }
    let metres = at_nm / NM_PER_M;
    // Far in the ultraviolet the exponential overflows to infinity and the quotient to a true 0.
    let per_metre = C1_RADIANCE / metres.powi(5) / (C2_M_K / (metres * kelvin)).exp_m1();
    if per_metre.is_finite() {
        per_metre / NM_PER_M
    } else {
        0.0
    }
}

/// Blackbody power relative to 560 nm, where it is 1 (the custom of CIE tables, there 100).
///
/// Written with the ratio of exponentials so that it holds down to a few kelvin. Zero when
/// wavelength or temperature is not positive.
pub fn relative(at_nm: f64, kelvin: f64) -> f64 {
    const REFERENCE_NM: f64 = 560.0;
    if !(at_nm > 0.0 && kelvin > 0.0) {
        return 0.0;
    }
    let exponent = |nm: f64| C2_M_K * NM_PER_M / (nm * kelvin);
    let (here, there) = (exponent(at_nm), exponent(REFERENCE_NM));
    // expm1(t)/expm1(h) = e^(t-h) (1 - e^-t)/(1 - e^-h)
    let ratio = (there - here).exp() * (-there).exp_m1() / (-here).exp_m1();
    let value = (REFERENCE_NM / at_nm).powi(5) * ratio;
    if value.is_finite() { value } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_follows_wiens_law() {
        // x = 5 (1 - e^-x) at the peak, so peak * T = c2 / x.
        let x = (0..60).fold(5.0_f64, |x, _| 5.0 * (1.0 - (-x).exp()));
        for kelvin in [2000.0, 5000.0, 10000.0] {
            let peak_nm = C2_M_K / x / kelvin * NM_PER_M;
            let at = |nm| radiance(nm, kelvin);
            // 1 % to either side of a maximum the value must have fallen.
            assert!(at(peak_nm) > at(peak_nm * 0.99) && at(peak_nm) > at(peak_nm * 1.01));
        }
    }

    #[test]
    fn all_wavelengths_together_give_the_stefan_boltzmann_law() {
        let kelvin = 3000.0;
        let step_nm = 5.0;
        let sum: f64 = (1..40_000)
            .map(|i| radiance(f64::from(i) * step_nm, kelvin) * step_nm)
            .sum();
        let expected = 5.670_374_419e-8 * kelvin.powi(4) / std::f64::consts::PI;
        // c2 is rounded by 1.6e-5 and enters with its fourth power; beyond 200 um under 1e-5 is left.
        assert!((sum / expected - 1.0).abs() < 1e-4, "{sum} {expected}");
    }

    #[test]
    fn relative_power_is_the_radiance_over_its_value_at_560_nm() {
        for nm in [360.0, 560.0, 830.0] {
            let expected = radiance(nm, 2856.0) / radiance(560.0, 2856.0);
            // Exponents near 14 carry a rounding of 14 ulps.
            assert!((relative(nm, 2856.0) / expected - 1.0).abs() < 1e-13);
        }
        assert_eq!(relative(560.0, 1.0), 1.0);
    }

    #[test]
    fn nonsense_gives_darkness_not_nan() {
        for (nm, kelvin) in [
            (0.0, 3000.0),
            (-5.0, 3000.0),
            (500.0, 0.0),
            (500.0, f64::NAN),
            (1e-3, 10.0),
            (1e-300, 1e-300),
        ] {
            assert_eq!(radiance(nm, kelvin), 0.0);
            assert!(relative(nm, kelvin).is_finite());
        }
    }
}
