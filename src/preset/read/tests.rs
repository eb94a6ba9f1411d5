//! Stories about small preset files, and about the shipped ones.

use std::path::Path;

use serde_json::Value;

use super::*;
use crate::preset::shipped::{SHIPPED, UNLISTED};

const SMALL: &str = r#"{"format":"spectral-explorer-presets","version":1,"group":"g","title":"t",
"kind":"light","shelf":"LED","source":"s","licence":{"id":"MIT","words":"w"},
"attribution":"a","changes":"c","items":[
{"name":"even","unit":"relative","wavelengths":{"first_nm":400,"step_nm":5,"count":3},"values":[0,1e-7,0.1]},
{"name":"list","kind":"reflectance","unit":"fraction","source":"own","wavelengths":{"list_nm":[400,400.5]},"values":[-0.0,1e300]},
{"name":"Hg","kind":"lines","shelf":"Line lamps","element":"Hg","unit":"u","wavelengths":{"list_nm":[546.075,435.833]},"strengths":[6000,null]},
{"name":"two","unit":"relative","composite":{"range_nm":[400,700],"basis":"fourier","coefficients":{"a":[2,1],"b":[3]},"spikes":[{"at_nm":589,"weight":31.95}],"weight_factor":300}}
]}"#;

fn small() -> Group {
    Group::from_json(SMALL).expect("a well-formed file")
}

fn refusal(from: &str, to: &str) -> PresetError {
    let text = SMALL.replace(from, to);
    assert_ne!(text, SMALL, "{from} is not there");
    Group::from_json(&text).expect_err("a broken file")
}

#[test]
fn an_item_takes_from_its_group_what_it_does_not_state() {
    let file = small();
    let even = file.items[0].spectrum().expect("a table");
    assert_eq!((even.kind, even.source.as_str()), (Kind::Light, "s"));
    assert_eq!(even.samples.nm(), [400.0, 405.0, 410.0]);
    let list = file.items[1].spectrum().expect("a table");
    assert_eq!(
        (list.kind, list.source.as_str()),
        (Kind::Reflectance, "own")
    );
}

#[test]
fn lines_and_composites_are_not_tables() {
    let file = small();
    let lines = file.items[2].line_list().expect("lines");
    assert_eq!(lines.lines[0].strength, Some(6000.0));
    assert_eq!(lines.lines[1].strength, None);
    assert!(file.items[2].spectrum().is_none());
    let composite = file.items[3].composite().expect("a composite");
    let spikes: Vec<_> = composite.spikes_in_unit_nm().collect();
    assert_eq!(spikes, [(589.0, 31.95 * 300.0)]);
    assert!(file.items[3].spectrum().is_none());
}

#[test]
fn a_refusal_names_the_line_what_was_found_and_what_was_expected() {
    let error = refusal("\"step_nm\":5", "\"step_nm\":\"five\"");
    assert_eq!(error.line, Some(4));
    assert!(error.found.contains("five"), "{error}");
    assert!(error.expected.contains("f64"), "{error}");
    let error = refusal("\"step_nm\":5,", "");
    assert_eq!(error.line, Some(4));
    assert!(error.found.contains("incomplete wavelengths"), "{error}");
}

#[test]
fn another_format_or_version_is_called_that() {
    let newer = refusal("\"version\":1", "\"version\":2,\"new\":0");
    assert_eq!(
        newer.to_string(),
        "preset file: expected version 1, found version 2"
    );
    let other = refusal(FORMAT, "composite-spectrum").to_string();
    assert!(other.contains("composite-spectrum"), "{other}");
}

#[test]
fn items_that_do_not_hold_together_are_refused_by_name() {
    let refused = |from, to| refusal(from, to).to_string();
    let short = refused("[0,1e-7,0.1]", "[1]");
    assert!(short.contains("\"even\""), "{short}");
    let twice = refused("\"list\"", "\"even\"");
    assert!(twice.contains("used twice"), "{twice}");
    let falling = refused("[400,400.5]", "[5,4]");
    assert!(falling.contains("above 5 nm"), "{falling}");
    let both = refused("\"composite\":", "\"values\":[],\"composite\":");
    assert!(both.contains("composite"), "{both}");
}

#[test]
fn a_huge_count_costs_nothing() {
    refusal("\"count\":3", "\"count\":99999999999");
}

/// The numbers below some keys of an item, bit by bit; none where it does not have the key.
fn bits_of(item: &Value, pointer: &str) -> Option<Vec<Option<u64>>> {
    let list = item.pointer(pointer)?.as_array().expect("a list");
    Some(list.iter().map(|v| v.as_f64().map(f64::to_bits)).collect())
}

fn bits(list: &[f64]) -> Vec<Option<u64>> {
    list.iter().map(|v| Some(v.to_bits())).collect()
}

#[test]
fn every_number_of_a_file_is_kept_to_the_bit() {
    let mut compared = 0;
    for text in SHIPPED.into_iter().chain(UNLISTED).chain([SMALL]) {
        let group = Group::from_json(text).expect("a shipped file");
        let file: Value = serde_json::from_str(text).expect("JSON");
        let items = file["items"].as_array().expect("items");
        assert_eq!(items.len(), group.items.len(), "{}", group.id);
        for (preset, item) in group.items.iter().zip(items) {
            assert_eq!(item["name"], preset.name.as_str());
            let (nm, values) = match &preset.body {
                Body::Spectrum(table) => (
                    bits(table.samples.nm()),
                    bits_of(item, "/values").zip(Some(bits(table.samples.values()))),
                ),
                Body::Lines(list) => (
                    list.lines.iter().map(|l| Some(l.at_nm.to_bits())).collect(),
                    bits_of(item, "/strengths").zip(Some(
                        list.lines
                            .iter()
                            .map(|l| l.strength.map(f64::to_bits))
                            .collect(),
                    )),
                ),
                Body::Composite(composite) => {
                    let there =
                        |key: &str| bits_of(item, &format!("/composite/coefficients/{key}"));
                    assert_eq!(there("a"), Some(bits(&composite.a)));
                    assert_eq!(there("b"), Some(bits(&composite.b)));
                    continue;
                }
            };
            let (there, here) = values.expect("values");
            assert_eq!(there, here, "{}", preset.id());
            if let Some(there) = bits_of(item, "/wavelengths/list_nm") {
                assert_eq!(there, nm, "{}", preset.id());
            }
            let optical = preset.optical.as_ref();
            assert_eq!(bits_of(item, "/n"), optical.map(|o| bits(&o.n)));
            assert_eq!(bits_of(item, "/k"), optical.map(|o| bits(&o.k)));
            compared += here.len();
        }
    }
    assert!(compared > 60_000, "{compared} values compared");
    let list = small().items[1].spectrum().expect("a table").clone();
    let zero = list.samples.values()[0].to_bits();
    assert_eq!(zero, (-0.0f64).to_bits(), "-0 is kept");
}

#[test]
fn every_shipped_item_stands_on_a_line_of_its_own_in_shortest_decimals() {
    for text in SHIPPED.into_iter().chain(UNLISTED) {
        let count = Group::from_json(text).expect("a shipped file").items.len();
        let items = text.lines().filter(|line| line.starts_with("{\"name\""));
        let mut seen = 0;
        for line in items {
            let line = line.trim_end_matches(',');
            let item: Value = serde_json::from_str(line).expect("one item");
            // Written anew an item differs in the order of its keys alone.
            let letters = |text: &str| {
                let mut letters = text.as_bytes().to_vec();
                letters.sort_unstable();
                letters
            };
            assert!(
                letters(&item.to_string()) == letters(line),
                "{}",
                item["name"]
            );
            seen += 1;
        }
        assert_eq!(seen, count, "{}", &text[..120]);
    }
}

#[test]
fn no_shipped_text_tells_a_path_of_a_machine() {
    for text in SHIPPED.into_iter().chain(UNLISTED) {
        let bad = [
            "/home/", "/root/", "/tmp/", "/work/", "/usr/", "/mnt/", "C:\\", "file:",
        ];
        for word in bad {
            assert!(!text.contains(word), "{word}: {}", &text[..120]);
        }
    }
}

/// Compares with the collection from which the files were made, where it is at hand.
/// Lines were added to this table: all of the source's are there with their strengths, and of what
/// was added the file says so.
fn holds_all_lines(file: &File, items: &[Value]) -> usize {
    let said = &file.changes;
    for item in &file.items {
        let is_original = items.iter().any(|o| o["name"] == item.name.as_str());
        let symbol = item.element.as_deref().unwrap_or(&item.name);
        assert!(is_original || said.contains(symbol), "{symbol}: {said}");
    }
    for original in items {
        let name = original["name"].as_str().expect("a name");
        let ours = file.items.iter().find(|item| item.name == name);
        let ours = ours.unwrap_or_else(|| panic!("{name} is missing"));
        let nm = ours.wavelengths.as_ref().expect("places").clone().nm();
        let strengths = ours.strengths.as_ref().expect("strengths");
        let list = |key: &str| original[key].as_array().expect("a list").clone();
        for (place, strength) in list("wavelength_nm").iter().zip(list("values")) {
            let index = nm.iter().position(|nm| Some(*nm) == place.as_f64());
            let index = index.unwrap_or_else(|| panic!("{name}: {place} is missing"));
            let known = strength.as_f64();
            assert!(
                known.is_none() || strengths[index] == known,
                "{name}: {place}"
            );
        }
    }
    items.len()
}

#[test]
fn every_number_is_the_sources_bit_for_bit() {
    let root = std::env::var("CARGO_MANIFEST_DIR")
        .unwrap_or_else(|_| env!("CARGO_MANIFEST_DIR").to_owned());
    let folder = Path::new(&root).join("../shared/data/presets_source");
    if !folder.is_dir() {
        println!("skipped: the source collection is not at hand");
        return;
    }
    let numbers = |value: &Value| -> Vec<Option<u64>> {
        let list = value.as_array().expect("a list");
        list.iter().map(|v| v.as_f64().map(f64::to_bits)).collect()
    };
    let mut compared = 0;
    for text in SHIPPED.into_iter().chain(UNLISTED) {
        let file: File = serde_json::from_str(text).expect("a shipped file");
        if file.group == "paper" {
            continue;
        }
        let source = std::fs::read_to_string(folder.join(format!("{}.json", file.group)));
        let source: Value = serde_json::from_str(&source.expect("the source file")).unwrap();
        let items = source["items"].as_array().expect("items");
        if file.group == "atomic_lines" {
            compared += holds_all_lines(&file, items);
            continue;
        }
        assert_eq!(items.len(), file.items.len(), "{}", file.group);
        for (item, original) in file.items.iter().zip(items) {
            let at = format!("{}/{}", file.group, item.name);
            // Skins are named by their tone; the source names them by people.
            if !item.name.starts_with("Skin") {
                assert_eq!(original["name"], item.name.as_str());
            }
            assert_eq!(original["unit"], item.unit.as_str());
            let values = match (&item.values, &item.strengths) {
                (Some(values), None) => bits(values),
                (None, Some(s)) => s.iter().map(|v| v.map(f64::to_bits)).collect(),
                _ => panic!("{at}: neither a table nor lines"),
            };
            assert_eq!(values, numbers(&original["values"]), "{at}");
            let wavelengths = item.wavelengths.as_ref().expect("wavelengths");
            let nm = wavelengths.clone().nm();
            let given = &original["wavelength_nm"];
            if original["wavelength_form"] == "range" {
                let range: Vec<f64> = serde_json::from_value(given.clone()).unwrap();
                assert_eq!((nm[0], nm[nm.len() - 1]), (range[0], range[1]), "{at}");
                assert!(nm.windows(2).all(|w| w[1] - w[0] == range[2]), "{at}");
            } else {
                assert_eq!(bits(&nm), numbers(given), "{at}");
            }
            for (key, ours) in [
                ("n", &item.n),
                ("k", &item.k),
                ("wavelength_vacuum_nm", &item.vacuum_nm),
            ] {
                let ours = ours.as_deref().map(bits);
                assert_eq!(ours, original.get(key).map(numbers), "{at} {key}");
            }
            let labels: Option<Vec<String>> =
                serde_json::from_value(original["labels"].clone()).unwrap();
            assert_eq!(labels, item.labels, "{at}");
            let number = |key: &str| original[key].as_f64();
            assert_eq!(item.threshold, number("threshold"), "{at}");
            assert_eq!(item.thickness_mm, number("thickness_mm"), "{at}");
            let filled = item.nan_filled_with_zero.map(f64::from);
            assert_eq!(filled, number("nan_filled_with_zero"), "{at}");
            let word = |key: &str| original[key].as_str();
            assert_eq!(item._medium.as_deref(), word("medium"), "{at}");
            assert_eq!(item.cie_interpolation.as_deref(), word("cie_interpolation"));
            assert_eq!(item.cie_extrapolation.as_deref(), word("cie_extrapolation"));
            if let Some(note) = word("note") {
                assert!(item.note.as_ref().is_some_and(|n| n.contains(note)), "{at}");
            }
            compared += values.len();
        }
    }
    assert!(compared > 60_000, "{compared} values compared");
}
