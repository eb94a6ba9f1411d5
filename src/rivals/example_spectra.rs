//! Spectra that the tests fit: formulas, no data.

use crate::spectrum::Band;

/// A blackbody, 1 at 560 nm (Planck's law, `c2 = 1.4388e-2 m K`).
pub(super) fn thermal(band: Band, kelvin: f64) -> Vec<f64> {
    let planck = |nm: f64| (nm / 560.0).powi(-5) / (1.4388e7 / (nm * kelvin)).exp_m1();
    band.grid().map(|nm| planck(nm) / planck(560.0)).collect()
}

/// A smooth background and four mercury lines of 3 nm full width.
pub(super) fn fluorescent(band: Band) -> Vec<f64> {
    let bell =
        |nm: f64, at_nm: f64, sigma_nm: f64| (-0.5 * ((nm - at_nm) / sigma_nm).powi(2)).exp();
    let lines = [(404.7, 2.0), (435.8, 5.0), (546.1, 3.0), (578.0, 1.0)];
    band.grid()
        .map(|nm| {
            let peaks: f64 = lines
                .iter()
                .map(|(at, height)| height * bell(nm, *at, 1.3))
                .sum();
            0.05 + bell(nm, 590.0, 50.0) + peaks
        })
        .collect()
}

/// A reflectance: low, a green bump, and a steep rise to 0.9 beyond 690 nm.
pub(super) fn leaf(band: Band) -> Vec<f64> {
    band.grid()
        .map(|nm| {
            let green = 0.12 * (-((nm - 550.0) / 30.0_f64).powi(2)).exp();
            0.04 + green + 0.86 / (1.0 + (-(nm - 710.0) / 9.0).exp())
        })
        .collect()
}
