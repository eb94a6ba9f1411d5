//! Writing CSV: comment lines that say what it is, a line of titles, one row a wavelength.

use super::every::awkward_spectrum;
use crate::told::{names, read};
use spectral_explorer::io::{Column, Columns, Provenance, csv as write, shortest};
use spectral_explorer::spectrum::{Kind, NamedSpectrum};

#[test]
fn names_that_look_like_something_else_come_back() {
    let odd = [
        "standard deviation lamp",
        "Zinc sigma",
        "Raman shift std",
        "wavelength panel",
        "x",
        "[nm]",
        "5%",
        "380nm",
        "n/a",
        "R(ref) target",
        "LED (1/2)",
        "column 7",
        "measured",
        &"long ".repeat(50),
    ];
    let named = |name: &str| NamedSpectrum {
        name: name.to_owned(),
        unit: "mW m-2 nm-1".to_owned(),
        ..awkward_spectrum(Kind::Light)
    };
    let all = odd.map(named);
    for spectra in [&all[..], &all[..1], &all[6..7]] {
        let columns = Columns::together(spectra).unwrap();
        let text = write(&spectra[0], &columns, &Provenance::default());
        let reading = read("x.csv", text);
        assert_eq!(reading.guesses, []);
        assert_eq!(reading.spectra.len(), spectra.len());
        for (back, was) in reading.spectra.iter().zip(spectra) {
            assert_eq!(back.name, was.name.trim());
            assert_eq!((back.kind, &back.unit), (was.kind, &was.unit));
            assert_eq!(back.samples, was.samples);
        }
    }
}

#[test]
fn several_columns_come_back_by_their_titles_and_gaps_stay_gaps() {
    let spectrum = awkward_spectrum(Kind::Light);
    let mut columns = Columns::measured(&spectrum);
    columns.columns.push(Column {
        title: "model, order 7".to_owned(),
        values: vec![f64::NAN, 1.0, 2.0, 3.0, 4.0, f64::NAN],
    });
    let text = write(&spectrum, &columns, &Provenance::default());
    let reading = read("x.csv", text);
    assert_eq!(names(&reading)[1..], ["model, order 7"]);
    assert_eq!(reading.spectra[0].samples, spectrum.samples);
    assert_eq!(reading.spectra[1].samples.values(), [1.0, 2.0, 3.0, 4.0]);
    assert!(reading.guesses.is_empty(), "{:?}", reading.guesses);
}

#[test]
fn shortest_numbers_are_exact() {
    for value in [0.1, 380.0, -0.0, 5e-324, f64::MAX, 1e21, 123_456_789.125] {
        let back: f64 = shortest(value).parse().unwrap();
        assert_eq!(back.to_bits(), value.to_bits());
    }
    assert_eq!(shortest(380.0), "380");
}
