//! Kind, axis and gaps, as they are decided for every table.

use crate::told::{assert_told, first, read};
use spectral_explorer::io::{Choices, read_bytes_as};
use spectral_explorer::spectrum::{Kind, in_air};

#[test]
fn a_single_not_measured_number_is_a_gap_too() {
    let one = first("a.csv", "nm,lamp\n380,1\n390,-9999\n400,2\n");
    assert_eq!(one.samples.values(), [1.0, 2.0]);
    let said = "1 value of -9999 taken as not measured".to_owned();
    assert!(one.notes.contains(&said));
    let low = first("a.csv", "nm,lamp\n380,1\n390,-9.999\n400,2\n");
    assert_eq!(low.samples.values(), [1.0, -9.999, 2.0]);
}

#[test]
fn a_kind_that_goes_against_the_file_is_noted() {
    let choices = Choices {
        kind: Some(Kind::Transmittance),
        ..Choices::default()
    };
    let notes = |text: &str| {
        let reading = read_bytes_as("a.csv", text.as_bytes(), &choices).expect("a table");
        reading.spectra[0].notes.join("; ")
    };
    let against =
        "chosen by hand as transmittance: the column's title \"absorbance\" tells absorbance";
    let told = notes("nm,absorbance\n380,0.1\n390,0.5\n");
    assert!(told.contains(against), "{told}");
    for agrees in ["nm,transmittance\n380,0.1\n390,0.5\n", "380,0.1\n390,0.5\n"] {
        let told = notes(agrees);
        assert!(!told.contains("by hand"), "{told}");
    }
}

#[test]
fn metres_are_told_by_a_title_and_guessed_from_their_size() {
    let text = "wavelength (m),irradiance\n3.8e-7,1\n5e-7,2\n7.8e-07,3\n";
    let told = read("a.csv", text);
    let samples = &told.spectra[0].samples;
    assert!((samples.first_nm() - 380.0).abs() < 1e-9);
    let is_plain = !told.is_doubtful() || told.guesses.iter().all(|g| g.plain);
    assert!(is_plain, "{:?}", told.guesses);
    let bare = read("a.csv", "3.8e-7 1e-6\n5.0e-7 3e-6\n6.0e-7 2e-6\n");
    assert!((bare.spectra[0].samples.last_nm() - 600.0).abs() < 1e-9);
    assert!(bare.is_doubtful());
}

#[test]
fn frequencies_and_small_units_are_turned_into_wavelengths_and_said() {
    let thz = first("a.csv", "Frequency (THz),lamp\n400,1\n500,2\n600,3\n");
    let samples = &thz.samples;
    // 749.4811 nm in vacuum, over the index of air there, 1.000 275 2.
    assert!((samples.last_nm() - 749.2749).abs() < 1e-3);
    assert_told(&thz.notes, "in vacuum turned into those in air");
    assert_eq!(samples.values(), [3.0, 2.0, 1.0]);
    assert_told(&thz.notes, "not rescaled");
    let mev = first("a.csv", "Energy (meV),lamp\n1600,1\n2000,2\n");
    assert!((mev.samples.first_nm() - 619.75).abs() < 0.01);
    let odd = read("a.csv", "Frequency (PHz),lamp [W/m2/nm]\n400,1\n500,2\n");
    assert!(odd.is_doubtful(), "{:?}", odd.guesses);
}

#[test]
fn wavelengths_in_vacuum_are_turned_as_far_as_air_has_an_index() {
    let read = first(
        "a.csv",
        "Vacuum wavelength (nm),lamp\n180,1\n190,2\n210,3\n",
    );
    // 185 nm, as for colours.
    assert_eq!(read.samples.nm(), [180.0, in_air(190.0), in_air(210.0)]);
}

#[test]
fn an_efficiency_of_photons_is_what_a_light_is_weighed_with_and_no_light() {
    for title in [
        "Photon detection efficiency (%)",
        "PDE (%)",
        "Incident photon-to-current efficiency [%]",
    ] {
        let text = format!("Wavelength (nm),{title}\n400,10\n450,40\n500,20\n");
        let found = first("a.csv", text);
        assert_eq!(
            (found.kind, &*found.unit),
            (Kind::Weighting, "%"),
            "{title}"
        );
        assert_eq!(found.samples.values(), [10.0, 40.0, 20.0]);
    }
}
