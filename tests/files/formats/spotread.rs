//! What Argyll's `spotread` prints: results in words, and with `-S` or `-s` the spectrum.

use crate::told::{read, refusal};
use spectral_explorer::io::Quantity;

const RESULTS: &str = " Result is XYZ: 1.0 2.0 3.0, D50 Lab: 1 2 3\n Ambient = 44632.4 Lux, CCT = 5528K (Duv 0.0031)\n Color Rendering Index (Ra) = 99.0 [ R9 = 95.4 ]\n";

#[test]
fn results_alone_are_refused_by_what_they_are() {
    let why = refusal("a.txt", RESULTS);
    let found = "a.txt: found what Argyll's spotread printed";
    assert!(why.starts_with(found), "{why}");
}

#[test]
fn a_printed_spectrum_is_read_with_its_results() {
    let text = format!(
        "Spectrum from 380.000000 to 400.000000 nm in 3 steps\n 0.5, 1.5,\n 2.5\n{RESULTS}"
    );
    let reading = read("a.txt", text);
    assert_eq!(reading.spectra[0].samples.nm(), [380.0, 390.0, 400.0]);
    assert_eq!(reading.spectra[0].samples.values(), [0.5, 1.5, 2.5]);
    let found = reading.results.into_iter().map(|r| (r.quantity, r.value));
    assert_eq!(
        found.collect::<Vec<_>>(),
        [
            (Quantity::Illuminance, 44632.4),
            (Quantity::Cct, 5528.0),
            (Quantity::Duv, 0.0031),
            (Quantity::Ra, 99.0),
            (Quantity::R(9), 95.4)
        ]
    );
}
