//! refractiveindex.info: YAML with the optical constants n and k over wavelengths in micrometres.

use crate::told::{has, read, refusal};
use spectral_explorer::spectrum::{Kind, Outside};

const YAML: &str = "REFERENCES: |\n    A. Author.\n    <i>Metals</i> (1972)\nCOMMENTS: |\n    Warm\n\
    DATA:\n  - type: tabulated nk\n    data: |\n        0.5 1.5 0\n        0.6 1.0 2.0\n";

fn formula(body: &str) -> String {
    format!("DATA:\n  - type: {body}\n")
}

#[test]
fn n_and_k_and_the_reflectance_between_them_are_read() {
    let reading = read("Au.yml", YAML);
    let names: Vec<_> = reading.spectra.iter().map(|s| &*s.name).collect();
    assert_eq!(names, ["Au n", "Au k", "Au reflectance"]);
    assert_eq!(reading.spectra[0].samples.nm(), [500.0, 600.0]);
    assert_eq!(reading.spectra[1].samples.values(), [0.0, 2.0]);
    let reflected = reading.spectra[2].samples.values();
    // Glass of n 1.5 sends 4 % back; n 1, k 2 sends 4 / 8.
    assert!((reflected[0] - 0.04).abs() < 1e-15 && (reflected[1] - 0.5).abs() < 1e-15);
    assert_eq!(reading.spectra[0].source, "A. Author. Metals (1972)");
    let notes = &reading.spectra[2].notes;
    assert!(has(notes, "computed from n and k"), "{notes:?}");
}

#[test]
fn a_formula_is_sampled_over_its_range() {
    let text = formula(
        "formula 1\n    wavelength_range: 0.4 0.7\n    coefficients: 0 1.03961212 0.0774641 \
         0.231792344 0.141484 1.01046945 10.176475",
    );
    let reading = read("bk7.yml", text);
    let n = &reading.spectra[0].samples;
    assert_eq!((n.len(), n.first_nm(), n.last_nm()), (301, 400.0, 700.0));
    // Schott N-BK7 at 587.6 nm.
    assert!((n.at(587.6, Outside::Hold) - 1.5168).abs() < 2e-4);
    assert_eq!(reading.spectra[1].kind, Kind::Reflectance);
}

#[test]
fn a_formula_for_the_far_infrared_is_sampled_to_its_end() {
    let text = formula("formula 5\n    wavelength_range: 6 22.5\n    coefficients: 1.5 0.1 -2");
    let spectrum = &read("ir.yml", text).spectra[0];
    let n = &spectrum.samples;
    let ends = (n.first_nm(), n.last_nm(), n.len());
    assert_eq!(ends, (6000.0, 22500.0, 1651));
    let notes = &spectrum.notes;
    assert!(has(notes, "in steps of 10 nm beyond 5000 nm"), "{notes:?}");
}

#[test]
fn quoted_text_may_go_on_at_the_start_of_a_line() {
    let text = "REFERENCES: \"1) A \\\"quoted\\\" author.\n\nDATA: of others\"\nCOMMENTS: 'it''s\n\
                warm' # said\nDATA:\n  - type: tabulated n\n    data: |\n        0.5 1.5\n        0.6 1.4\n";
    let first = &read("q.yml", text).spectra[0];
    assert_eq!(first.source, "1) A \"quoted\" author. DATA: of others");
    assert!(has(&first.notes, "comment in the file: it's warm"));
    let why = refusal("q.yml", text.replace("0.6 1.4", "0.6 1.4 x"));
    assert!(why.starts_with("q.yml, line 10:"), "{why}");
}

#[test]
fn a_table_of_n_counts_more_than_a_formula_beside_it() {
    let text = "DATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.7\n    coefficients: 3\n  \
                - type: tabulated nk\n    data: |\n        0.5 1.5 0\n        0.6 1.5 0\n";
    let reading = read("p.yml", text);
    let names: Vec<_> = reading.spectra.iter().map(|s| &*s.name).collect();
    assert_eq!(names, ["p n", "p k", "p n by formula 5", "p reflectance"]);
    assert!((reading.spectra[3].samples.values()[0] - 0.04).abs() < 1e-12);
    assert!(has(&reading.spectra[2].notes, "as a table too"));
}

#[test]
fn what_is_wrong_is_said() {
    let said = |text: &str| refusal("a.yml", text);
    let wrong = said(&YAML.replace("0.6 1.0 2.0", "0.6 1.0"));
    let told = "a.yml, line 10: found \"0.6 1.0\", expected 3 numbers";
    assert_eq!(wrong, told);
    assert!(said(&formula("formula 12")).contains("data of the type \"formula 12\""));
    let range = said(&formula("formula 5\n    coefficients: 1 2 3"));
    assert!(range.contains("a wavelength range of 0 numbers"), "{range}");
}

#[test]
fn bombs_are_refused() {
    let mut bomb = "a: &a [x,x,x,x,x,x,x,x,x]\n".to_owned();
    for (one, other) in "abcdefgh".chars().zip("bcdefghi".chars()) {
        bomb += &format!("{other}: &{other} [*{one},*{one},*{one},*{one},*{one},*{one},*{one}]\n");
    }
    bomb += "DATA:\n  - type: tabulated n\n    data: *i\n";
    refusal("a.yml", bomb);
}
