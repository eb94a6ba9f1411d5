//! JSON of this program and of others that say what they hold.

use crate::told::{read, refusal};
use spectral_explorer::spectrum::Kind;

#[test]
fn numbers_that_json_cannot_write_are_gaps_and_words_stay() {
    let text = r#"{"name": "a \" NaN", "wavelengths": [380, 390, 400, 410],
            "values": [1, NaN, -Infinity, 4]}"#;
    let spectrum = &read("a.json", text).spectra[0];
    assert_eq!(spectrum.samples.nm(), [380.0, 410.0]);
    assert_eq!(spectrum.name, "a \" NaN");
}

#[test]
fn other_json_is_refused_with_its_keys() {
    for (text, words) in [
        (
            r#"{"metadata":1,"x":2}"#,
            "found JSON with the keys \"metadata, x\"",
        ),
        ("[1,2]", "a JSON list with no wavelengths in it"),
        (
            "{\"spd\":{\"abc\":1}}",
            "found \"abc\", expected a wavelength in nm as key",
        ),
        ("{", "line 1: found JSON with EOF"),
        (
            r#"{"wavelength_axis":{"range_nm":{"start":1,"end":9,"interval":0}},"spectral_data":{"values":[1]}}"#,
            "steps of 0",
        ),
    ] {
        let said = refusal("a.json", text);
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn colorimetry_io_gives_a_range_or_a_list_of_wavelengths() {
    let text = r#"{"schema_version":"1.0.0","spectra":[
            {"id":"a","metadata":{"title":"Tile","measurement_type":"reflectance"},
             "wavelength_axis":{"range_nm":{"start":400,"end":420,"interval":10}},
             "spectral_data":{"scale":"percent","values":[10,20,30]}},
            {"id":"b","metadata":{"measurement_type":"irradiance"},
             "wavelength_axis":{"values_nm":[400,405.5]},"spectral_data":{"values":[1,2]}}]}"#;
    let [tile, other] = &read("a.json", text).spectra[..] else {
        panic!("two spectra");
    };
    assert_eq!((&*tile.name, tile.kind), ("Tile", Kind::Reflectance));
    assert_eq!((tile.scale, tile.samples.last_nm()), (0.01, 420.0));
    assert_eq!((&*other.name, other.kind), ("b", Kind::Light));
    assert_eq!(other.samples.values(), [1.0, 2.0]);
}

#[test]
fn rawtoaces_and_tobes_use_wavelengths_as_keys_in_any_order() {
    let text = r#"{"header":{"description":"Tungsten"},"spectral_data":{"units":"relative",
            "index":{"main":["power"]},"data":{"main":{"1000":[3.0],"380":[1.0],"400":[2.0]}}}}"#;
    let lamp = &read("a.json", text).spectra[0];
    assert_eq!(lamp.samples.values(), [1.0, 2.0, 3.0]);
    assert_eq!((&*lamp.name, lamp.kind), ("Tungsten", Kind::Light));
    let text = r#"{"status":"normal","spd":{"340":0.0,"1000":0.5}}"#;
    let samples = &read("b.json", text).spectra[0].samples;
    assert_eq!(samples.nm(), [340.0, 1000.0]);
}

const HEAD: &str = r#"{"format":"spectral-explorer-spectrum","version":1,"kind":"light","#;

#[test]
fn faults_are_named_with_their_line() {
    for (body, words) in [
        (
            "\n\"wavelengths_nm\":[400,\"x\"],\"values\":[1,2]}",
            "line 2: found JSON with invalid type: string \"x\", expected f64",
        ),
        (
            "\"wavelengths_nm\":[400,500],\"values\":[1]}",
            "found 2 wavelengths and 1 values, expected one value for each wavelength",
        ),
        (
            "\"wavelengths_nm\":[400],\"values\":[1]}",
            "found 1 point with a wavelength and a value, expected at least 2",
        ),
        (
            "\"wavelengths_nm\":[400,500],\"values\":[1,1e999]}",
            "number out of range",
        ),
    ] {
        let why = refusal("a.json", HEAD.to_owned() + body);
        assert!(why.contains(words), "{why}");
    }
}
