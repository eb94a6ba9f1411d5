//! JSON of no program in particular.

use crate::told::{self, refusal};
use spectral_explorer::io::Reading;
use spectral_explorer::spectrum::Kind;

fn read(text: &str) -> Reading {
    told::read("a.json", text)
}

fn names(reading: &Reading) -> Vec<&str> {
    reading.spectra.iter().map(|s| s.name.as_str()).collect()
}

#[test]
fn lists_beside_wavelengths_are_spectra_of_the_kind_that_their_key_names() {
    let one = read(
        r#"{"name":"Lamp A","unit":"W/m2/nm","wavelengths":[380,390,400],"values":[1,null,3]}"#,
    );
    let spectrum = &one.spectra[0];
    assert_eq!((&*spectrum.name, spectrum.kind), ("Lamp A", Kind::Light));
    assert_eq!(spectrum.unit, "W/m2/nm");
    assert_eq!(spectrum.samples.nm(), [380.0, 400.0]);
    let two = read(r#"{"data":{"wavelength_um":[0.4,0.5],"reflectance":[0.1,0.2],"n":7}}"#);
    assert_eq!(two.spectra[0].kind, Kind::Reflectance);
    assert_eq!(two.spectra[0].samples.nm(), [400.0, 500.0]);
}

#[test]
fn samples_below_shared_wavelengths_keep_their_names() {
    let list = read(
        r#"{"wavelengthsNm":[400,410],"samples":[{"name":"A","reflectance":[0.1,0.2]},
                {"name":"B","reflectance":[0.3,0.4]}]}"#,
    );
    assert_eq!(names(&list), ["A", "B"]);
    assert!(list.spectra.iter().all(|s| s.kind == Kind::Reflectance));
    let keyed = read(r#"{"lambda":[400,410],"spectra":{"A":[1,2],"B":[3,4]}}"#);
    assert_eq!(names(&keyed), ["A", "B"]);
    assert_eq!(keyed.spectra[1].samples.values(), [3.0, 4.0]);
}

#[test]
fn points_as_objects_lists_or_keys_are_spectra_too() {
    for text in [
        r#"[{"wavelength":380,"power":1},{"wavelength":390,"power":"2.5"}]"#,
        "[[380,1],[390,2.5]]",
        r#"{"390":2.5,"380":1}"#,
        r#"{"lamp":{"390nm":2.5,"380nm":1}}"#,
        r#"{"points":[{"nm":390,"v":2.5},{"nm":380,"v":1}]}"#,
        // Keys that count rows are no wavelengths.
        r#"{"wavelength":{"0":380,"1":390},"value":{"0":1,"1":2.5}}"#,
        r#"{"0":{"wavelength":380,"value":1},"1":{"wavelength":390,"value":2.5}}"#,
        // One object a line, and a number with its unit.
        "{\"wavelength\":\"380 nm\",\"v\":1}\n{\"wavelength\":\"390 nm\",\"v\":2.5}\n",
    ] {
        let reading = read(text);
        assert_eq!(reading.spectra.len(), 1, "{text}");
        let samples = &reading.spectra[0].samples;
        assert_eq!(samples.nm(), [380.0, 390.0], "{text}");
        assert_eq!(samples.values(), [1.0, 2.5], "{text}");
    }
    refusal("a.json", r#"{"value":{"0":1,"1":2.5,"2":3}}"#);
    let broken = refusal("a.json", "{\"nm\":380}\n{\"nm\":390}\n{\"x\" 5}");
    assert!(broken.contains("line 3"), "{broken}");
    let spectra = "{\"name\":\"A\",\"nm\":[380,390],\"v\":[1,2]}\n{\"name\":\"B\",\"nm\":[400,410],\"v\":[3,4]}";
    assert_eq!(names(&read(spectra)), ["A", "B"]);
}

#[test]
fn ends_and_a_step_are_wavelengths_where_they_fit_the_lists() {
    for axis in [
        r#""start":380,"end":420,"interval":10"#,
        r#""domain":[380,420],"interval":10"#,
        r#""span":[380,420],"step":10"#,
        r#""bands":[380,420,10]"#,
        r#""lambda_min":380,"lambda_max":420,"n":5"#,
        r#""wavelength_min_nm":380,"wavelength_max_nm":420"#,
        r#""range":{"start":380,"end":420,"increment":10}"#,
    ] {
        let reading = read(&format!(r#"{{"name":"L","values":[1,2,3,4,5],{axis}}}"#));
        assert_eq!(names(&reading), ["L"], "{axis}");
        let samples = &reading.spectra[0].samples;
        assert_eq!(samples.nm(), [380.0, 390.0, 400.0, 410.0, 420.0], "{axis}");
    }
    for axis in [
        r#""start":380,"end":430,"interval":10"#,
        r#""start":1,"end":5,"interval":1"#,
        r#""start":380,"end":420"#,
        r#""bands":[380,420,11]"#,
        r#""domain":[380,420]"#,
    ] {
        refusal("a.json", format!(r#"{{"values":[1,2,3,4,5],{axis}}}"#));
    }
    let several = read(
        r#"{"spectra":[{"name":"A","bands":[400,430,10],"values":[1,2,3,4]},
                {"name":"B","bands":[400,430,10],"values":[4,3,2,1]}]}"#,
    );
    assert_eq!(names(&several), ["A", "B"]);
}

#[test]
fn the_list_that_fits_others_has_the_wavelengths() {
    for text in [
        r#"{"wavelength_range":[400,420],"wavelengths":[400,410,420],"v":[1,2,3]}"#,
        r#"{"x":[1,2,3],"wavelength":[400,410,420],"wavenumber":[25000,24390,23810]}"#,
        r#"{"wavelengths":[400,430,10],"v":[1,2,3,4]}"#,
    ] {
        let reading = read(text);
        assert_eq!(reading.spectra.len(), 1, "{text}");
        let samples = &reading.spectra[0].samples;
        assert_eq!(samples.nm()[..3], [400.0, 410.0, 420.0], "{text}");
        assert_eq!(samples.values()[..3], [1.0, 2.0, 3.0], "{text}");
    }
}

#[test]
fn bands_and_three_channels_are_a_cameras() {
    let camera = read(
        r#"{"camera":"C","ssf_bands":[400,410,420,430],"red_ssf":[0.1,0.2,0.3,0.2],
                "green_ssf":[0.1,0.3,0.3,0.2],"blue_ssf":[0.3,0.2,0.1,0.1]}"#,
    );
    assert_eq!(names(&camera), ["a red_ssf", "a green_ssf", "a blue_ssf"]);
    assert!(camera.spectra.iter().all(|s| s.kind == Kind::Weighting));
    let points = read(r#"[{"nm":400,"R":0.1,"G":0.2,"B":0.3},{"nm":410,"R":0.2,"G":0.2,"B":0.2}]"#);
    assert_eq!(names(&points), ["a R", "a G", "a B"]);
    assert!(points.spectra.iter().all(|s| s.kind == Kind::Light));
}

#[test]
fn keys_above_tables_are_names_in_the_order_of_the_file() {
    for text in [
        r#"{"D65":{"wavelength":[400,410],"values":[1,2]},"A":{"wavelength":[400,410],"values":[3,4]}}"#,
        r#"{"D65":{"400":1,"410":2},"A":{"400":3,"410":4}}"#,
        r#"{"name":"set","spectra":{"D65":[{"nm":400,"v":1},{"nm":410,"v":2}],"A":[[400,3],[410,4]]}}"#,
        r#"{"nm":[400,410],"D65":{"values":[1,2]},"A":{"values":[3,4]}}"#,
    ] {
        assert_eq!(names(&read(text)), ["D65", "A"], "{text}");
    }
    let numbers = read(r#"{"b":{"400":1,"410":-2,"420":0.5,"430":null},"a":{"400":3,"410":4}}"#);
    assert_eq!(names(&numbers), ["b", "a"]);
    assert_eq!(numbers.spectra[0].samples.values(), [1.0, -2.0, 0.5]);
    let kinds =
        read(r#"{"reflectance":{"400":0.5,"410":0.4},"transmittance":{"400":0.1,"410":0.2}}"#);
    assert_eq!(names(&kinds), ["a reflectance", "a transmittance"]);
    assert_eq!(kinds.spectra[1].kind, Kind::Transmittance);
}

#[test]
fn lists_of_other_things_are_no_spectra() {
    for text in [
        r#"{"prices":[1,2,3],"items":[4,5,6]}"#,
        r#"{"x":[0.31,0.32,0.33],"y":[0.33,0.34,0.35]}"#,
        r#"{"wavelengths":[380,390],"values":[1,2,3]}"#,
        "[1,2,3]",
        "[[5,1],[3,2],[4,4]]",
    ] {
        refusal("a.json", text);
    }
    let trouble = refusal("a.json", r#"{"wl":[-380,370],"v":[1,2]}"#);
    assert!(trouble.contains("-380 nm"), "{trouble}");
}
