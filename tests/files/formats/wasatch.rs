//! Wasatch ENLIGHTEN JSON: one measurement with its spectrometer's wavelengths.

use crate::told::{first, read, refusal};
use spectral_explorer::spectrum::Kind;

#[test]
fn processed_values_over_the_spectrometers_wavelengths_are_read() {
    let text = r#"{"metadata":{"ENLIGHTEN Version":"2","Label":"lamp","Technique":"Scope"},
            "spectrometerSettings":{"wavelengths":[400.5,401.0,401.5]},
            "spectrum":{"Dark":[1,1,1],"Processed":[2.5,null,-1],"Raw":[9,9,9]}}"#;
    let reading = read("a.json", text);
    let spectrum = &reading.spectra[0];
    assert_eq!(reading.format, "Wasatch ENLIGHTEN JSON");
    assert_eq!(spectrum.name, "lamp");
    assert_eq!(spectrum.samples.values(), [2.5, -1.0]);
    assert_eq!((spectrum.kind, &*spectrum.unit), (Kind::Light, "counts"));
    let text = text
        .replace("Scope", "Transmission")
        .replace("[400.5,401.0,401.5]", "null");
    let with = text.replace(
        "\"wavelengths\"",
        "\"eeprom\":{\"wavelength_coeffs\":[400,2,0.5]},\"wavelengths\"",
    );
    let spectrum = first("a.json", with);
    assert_eq!(spectrum.samples.nm(), [400.0, 406.0]);
    assert_eq!((spectrum.kind, spectrum.scale), (Kind::Transmittance, 0.01));
    let why = refusal("a.json", text);
    let found = "found ENLIGHTEN JSON without wavelengths";
    assert!(why.contains(found), "{why}");
}

#[test]
fn a_region_of_interest_has_the_wavelengths_from_its_start() {
    let text = |start: &str| {
        format!(
            r#"{{"metadata":{{"ENLIGHTEN Version":"2","ROI Pixel Start":{start}}},
                "spectrometerSettings":{{"wavelengths":[400,410,420]}},
                "spectrum":{{"Processed":[1,2]}}}}"#
        )
    };
    assert_eq!(first("a.json", text("1")).samples.nm(), [410.0, 420.0]);
    for beyond in ["2", "18446744073709551615"] {
        let why = refusal("a.json", text(beyond));
        assert!(why.contains("3 wavelengths and 2 values"), "{why}");
    }
}
