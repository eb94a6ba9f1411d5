//! The composite model as one line of text, to paste into a message; bit-exact there and back.

use crate::told::{read, refusal};
use proptest::prelude::*;
use spectral_explorer::{
    io::{CompositeFile, composite_json, composite_line as write, parse_composite_line as parse},
    spectrum::{Band, Basis, Composite, Kind, Line, Series},
};

#[test]
fn the_line_of_the_description_is_read_and_written() {
    let line = "cs1;fourier;380:780;2 0.5 -0.25;404.87*2.39 435.84*5.94";
    let composite = parse(line).unwrap();
    assert_eq!(composite.smooth().order(), 1);
    assert_eq!(composite.lines()[1].at_nm, 435.84);
    assert_eq!(write(&composite), line);
    let broken = parse("  cs1; cosine;380:780;\n1 2\n3;\n").unwrap();
    assert_eq!(broken.numbers(), 3);
}

#[test]
fn each_fault_is_named() {
    for (line, words) in [
        (
            "cs3;x",
            "found \"cs3\", expected a line that begins with \"cs1;\"",
        ),
        ("cs1;fourier", "found 2 fields"),
        (
            "cs1;sine;380:780;1;",
            "found basis \"sine\", expected fourier or cosine",
        ),
        ("cs1;cosine;380-780;1;", "expected MIN:MAX in nm"),
        ("cs1;cosine;380:381;1;", "at least 20 nm"),
        (
            "cs1;cosine;380:780;1;850*2",
            "found a line at 850 nm, expected lines on the composite's range, 380 to 780 nm",
        ),
        (
            "cs1;cosine;380:780;1 x;",
            "found \"x\", expected a number as coefficient",
        ),
        ("cs1;cosine;380:780;;", "found 0 coefficients"),
        (
            "cs1;cosine;380:780;1;404",
            "found spike \"404\", expected nm*weight",
        ),
        ("cs1;cosine;380:780;1;404*inf", "expected a spike's weight"),
    ] {
        let error = parse(line).unwrap_err().to_string();
        assert!(error.contains(words), "{line}: {error}");
    }
}

#[test]
fn widths_come_back_in_line_and_json_and_sort_with_their_lines() {
    let line = "cs2;cosine;380:780;1 2 3;404.87*2.39*3.1 435.84*5.94";
    let of_line = |line: &str| read("x.txt", line).composites.remove(0).composite;
    let widths = |composite: &Composite| -> Vec<f64> {
        composite.lines().iter().map(|line| line.fwhm_nm).collect()
    };
    let composite = of_line(line);
    assert_eq!(widths(&composite), [3.1, 0.0]);
    assert_eq!(write(&composite), line);
    let turned = "cs2;cosine;380:780;1 2 3;435.84*5.94 404.87*2.39*3.1";
    assert_eq!(of_line(turned), composite);
    let file = CompositeFile {
        composite,
        unit: String::new(),
        source: String::new(),
        name: "wide".to_owned(),
        kind: Kind::Light,
    };
    let text = composite_json(&file).unwrap();
    assert!(text.contains("\"version\": 2"), "{text}");
    let composites = |text: &str| read("x.json", text).composites;
    assert_eq!(composites(&text), std::slice::from_ref(&file));
    // The first version knows no widths.
    let first = text.replace("\"version\": 2", "\"version\": 1");
    let plain = &composites(&first)[0];
    assert!(!plain.composite.has_widths());
    refusal("x.json", text.replace("3.1", "-3.1"));
    let text = composite_json(plain).unwrap();
    assert!(text.contains("\"version\": 1"), "{text}");
    assert!(parse("cs1;cosine;380:780;1;404*1*2").is_err());
}

fn bits() -> impl Strategy<Value = f64> {
    prop_oneof![
        9 => any::<u64>().prop_map(f64::from_bits).prop_map(small),
        1 => Just(-0.0),
        1 => (0u64..1 << 52).prop_map(f64::from_bits),
    ]
}

/// The same digits of a size that is believed.
fn small(value: f64) -> f64 {
    match value.abs() {
        size if size < 1e30 => value,
        size if size < 1e300 => value * 1e-280,
        _ => 1.0,
    }
}

fn composite() -> impl Strategy<Value = Composite> {
    let width = prop_oneof![Just(0.0), 0.1..90.0_f64];
    let spike = (380.0..=780.0_f64, bits(), width).prop_map(|(at_nm, weight, fwhm_nm)| Line {
        at_nm,
        weight,
        fwhm_nm,
    });
    (
        0..20usize,
        prop::sample::select(vec![Basis::Fourier, Basis::Cosine]),
        prop::collection::vec(bits(), 41),
        prop::collection::vec(spike, 0..6),
    )
        .prop_map(|(order, basis, mut coefficients, mut spikes)| {
            coefficients.truncate(2 * order + 1);
            spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
            let smooth = Series {
                band: Band::VISIBLE,
                basis,
                coefficients,
            };
            Composite::of_lines_inside(smooth, spikes)
        })
}

fn all_bits(composite: &Composite) -> Vec<u64> {
    let spikes = composite
        .lines()
        .iter()
        .flat_map(|s| [s.at_nm, s.weight, s.fwhm_nm]);
    let coefficients = composite.smooth().coefficients.iter().copied();
    coefficients.chain(spikes).map(f64::to_bits).collect()
}

proptest! {
    #[test]
    fn any_composite_comes_back_to_the_bit(composite in composite()) {
        let line = parse(&write(&composite)).unwrap();
        prop_assert_eq!(all_bits(&line), all_bits(&composite));
        let file = CompositeFile {
            composite: composite.clone(),
            unit: "W m-2 nm-1".to_owned(),
            source: "a \"test\"".to_owned(),
            name: "a leaf".to_owned(),
            kind: Kind::Reflectance,
        };
        let text = composite_json(&file).unwrap();
        let back = read("x.json", text).composites.remove(0);
        prop_assert_eq!(all_bits(&back.composite), all_bits(&composite));
        prop_assert_eq!(back, file);
    }
}

/// Every shipped light as a line: cosines, a fourth of them with wide lines, a tenth as in the
/// paper; written by the program before the two kinds of composite became one (commit 6694549).
const LINES: &str = include_str!("../../golden/composite_lines.txt");

/// Some of them as documents, a form feed behind each.
const DOCUMENTS: &str = include_str!("../../golden/composite_documents.txt");

#[test]
fn lines_and_documents_of_earlier_programs_are_written_again_byte_for_byte() {
    for line in LINES.lines() {
        let composite = parse(line).unwrap_or_else(|why| panic!("{why}: {line}"));
        assert_eq!(write(&composite), line);
    }
    assert_eq!(LINES.lines().count(), 221);
    let documents: Vec<&str> = DOCUMENTS.split('\u{c}').filter(|d| !d.is_empty()).collect();
    assert_eq!(documents.len(), 8);
    for document in documents {
        let file = read("x.json", document).composites.remove(0);
        assert_eq!(composite_json(&file).unwrap(), document);
    }
}
