//! Writing Argyll `.sp`: CGATS text of one set, as `spec2cie`, `illumread` and `specplot` take it.

use super::every::awkward_spectrum;
use crate::told::first;
use spectral_explorer::{
    io::{Columns, Provenance, encode},
    spectrum::{Kind, NamedSpectrum, Sampled},
};

fn write(spectrum: &NamedSpectrum) -> Result<String, String> {
    encode(
        "sp",
        spectrum,
        &Columns::measured(spectrum),
        &Provenance::default(),
    )
}

fn losses(spectrum: &NamedSpectrum) -> Vec<String> {
    spectral_explorer::io::losses("sp", spectrum)
}

fn on(nm: Vec<f64>) -> NamedSpectrum {
    let values = (0..nm.len()).map(|i| 0.1 * i as f64 - 0.3).collect();
    NamedSpectrum {
        name: "Lampe \"1\"".to_owned(),
        samples: Sampled::new(nm, values).unwrap(),
        ..awkward_spectrum(Kind::Light)
    }
}

fn back(spectrum: &NamedSpectrum) -> NamedSpectrum {
    first("x.sp", write(spectrum).unwrap())
}

#[test]
fn even_grids_keep_every_value() {
    for (first, step) in [
        (380.0, 5.0),
        (380.0, 10.0 / 3.0),
        (355.5, 1.0),
        (100.0, 1.5),
    ] {
        let nm: Vec<f64> = (0..20).map(|i| first + step * f64::from(i)).collect();
        let spectrum = on(nm);
        let read = back(&spectrum);
        assert_eq!(read.samples.values(), spectrum.samples.values());
        assert_eq!((read.name.as_str(), read.kind), ("Lampe '1'", Kind::Light));
        assert_eq!((read.unit.as_str(), read.scale), ("W m-2 nm-1", 1.0));
        assert_eq!(read.source, "Own measurement");
        for (a, b) in read.samples.nm().iter().zip(spectrum.samples.nm()) {
            assert!((a - b).abs() < 1e-9, "{a} {b}");
        }
        assert_eq!(losses(&spectrum), Vec::<String>::new());
    }
}

#[test]
fn uneven_and_fine_grids_are_resampled_and_said() {
    let uneven = on(vec![380.0, 381.0, 385.0, 400.0]);
    assert!(losses(&uneven)[0].contains("resampled to 21 values"));
    let read = back(&uneven);
    assert_eq!(read.samples.len(), 21);
    assert_eq!(read.samples.values()[5], uneven.samples.values()[2]);
    let fine = on((0..101).map(|i| 400.0 + 0.25 * f64::from(i)).collect());
    assert_eq!(back(&fine).samples.len(), 26);
    let wide = losses(&on(vec![350.0, 351.0, 2500.0]));
    assert!(wide[0].contains("every 5 nm"), "{wide:?}");
}

#[test]
fn resampling_keeps_the_power_and_every_line() {
    // Lines a tenth of a nm wide, on and off whole nm, on a table that begins between two.
    let lines = [404.656, 435.833, 546.074, 600.0, 700.5];
    let bell = |x: f64| (-4.0 * std::f64::consts::LN_2 * (x / 0.1).powi(2)).exp();
    let nm: Vec<f64> = (0..8000).map(|i| 380.3 + 0.05 * f64::from(i)).collect();
    let values = nm
        .iter()
        .map(|nm| 0.02 + 100.0 * lines.iter().map(|at| bell(nm - at)).sum::<f64>())
        .collect();
    let fine = NamedSpectrum {
        samples: Sampled::new(nm, values).unwrap(),
        ..awkward_spectrum(Kind::Light)
    };
    let read = back(&fine);
    let power = |s: &NamedSpectrum, from, to| s.samples.power_between(from, to);
    let whole = (power(&fine, 0.0, 1e4), power(&read, 0.0, 1e4));
    assert!((whole.1 / whole.0 - 1.0).abs() < 1e-12, "{whole:?}");
    for at in lines {
        // Wide enough for the two nm that a line is shared out to; the ground is the same.
        let (from, to) = (at.round() - 3.0, at.round() + 3.0);
        let line = (power(&fine, from, to), power(&read, from, to));
        assert!((line.1 / line.0 - 1.0).abs() < 1e-3, "{at}: {line:?}");
    }
    assert!(losses(&fine)[0].contains("the area under the curve is kept"));
}

#[test]
fn what_the_format_cannot_hold_is_refused() {
    let refusal = |nm| write(&on(nm)).unwrap_err();
    assert!(refusal(vec![400.2, 400.4, 400.9]).contains("at least 3 whole nm"));
    assert!(refusal(vec![50.0, 60.0, 70.0]).contains("at least 100 nm"));
    assert_eq!(
        refusal(vec![3.8e8, 5.8e8, 7.8e8]),
        "found wavelengths up to 780000000 nm, expected at most 100000 nm in Argyll .sp"
    );
}

#[test]
fn the_longest_wavelengths_that_are_written_are_read_back() {
    let longest = on((0..9).map(|i| 92_000.0 + 1000.0 * f64::from(i)).collect());
    assert_eq!(back(&longest).samples, longest.samples);
}
