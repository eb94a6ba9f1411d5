//! LI-COR LI-180 text.

use crate::told::{first, read};
use spectral_explorer::io::Quantity;

#[test]
fn the_values_unit_may_stand_behind_each_wavelength() {
    let text = "Model Name\tLI-180\nPPFD\t30\n380nm(umol/m2s)\t1\n390nm(umol/m2s)\t1.5\n400nm(umol/m2s)\t2\n410nm(umol/m2s)\t4\n";
    let spectrum = first("a.txt", text);
    assert_eq!(spectrum.samples.values(), [1.0, 1.5, 2.0, 4.0]);
    // 400-410 nm: 10 nm of 3 on average.
    assert_eq!(spectrum.unit, "µmol m-2 s-1 nm-1");
}

#[test]
fn energy_is_told_by_the_irradiance_and_results_behind_the_spectrum_are_kept() {
    let text = "Model Name\tLI-180\nPPFD\t5.5\nR:B\t1.48\nIRR\t0.03\n380nm\t1\n390nm\t1.5\n400nm\t2\nCCT\t5465.0\nu'\t0.2037\n";
    let reading = read("a.txt", text);
    assert_eq!(reading.format, "LI-COR LI-180");
    assert_eq!(reading.spectra[0].unit, "mW m-2 nm-1");
    assert_eq!(reading.spectra[0].samples.len(), 3);
    let found: Vec<_> = reading.results.iter().map(|r| r.quantity.clone()).collect();
    assert_eq!(
        found,
        [
            Quantity::Ppfd,
            Quantity::Other("R:B".to_owned()),
            Quantity::Irradiance,
            Quantity::Cct,
            Quantity::UPrime
        ]
    );
}
