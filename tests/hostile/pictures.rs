//! Pictures in few numbers, both forms, changed in the ways in which files break.

use std::io::Cursor;

use spectral_explorer::pictures::*;
use spectral_explorer::study::Progress;

use crate::{
    attacked::{Reader, attack},
    mutate::Mutator,
    runs,
};

const WORDS: &[&str] = &[
    "composite-picture",
    "\"version\":",
    "\"width\":",
    "\"numbers\":",
    "\"series\":",
    "bands_nm",
    "values",
    "quantiser",
    "inverse",
    "\"tile\":",
    "\"mask\":true,",
    "csPH",
    "csPT",
    "CS.000",
    "null",
    "1e308",
];

/// A small wall in both forms, and their header.
pub(crate) fn seeds() -> [(Reader, Vec<u8>); 3] {
    let quiet = Progress::default();
    let nm = (0..12).map(|j| 400.0 + 25.0 * f64::from(j)).collect();
    let wall = InMemory::of(&Scene::reflectance(20, 14, nm).expect("bands")).expect("pixels");
    let survey = Survey::of(&wall, &quiet).expect("measured");
    let operator = Operator::new(wall.bands(), &Plan::new(wall.bands(), 5)).expect("solved");
    let about = About::default();
    let plan = compact_plan(&wall, &operator, &survey.sample, 0.5, 1.0, &quiet).expect("a plan");
    let mut compact = Vec::new();
    let coder = Coder::Fitted;
    write_compact(&mut compact, &wall, &operator, &plan, &about, coder, &quiet).expect("written");
    let sample: Vec<Vec<f64>> = survey
        .sample
        .iter()
        .map(|p| operator.numbers_of(p))
        .collect();
    let mut full = Cursor::new(Vec::new());
    let kept = (Precision::Half, Half::of(&sample));
    let said = (&about, plan.error);
    write_full(&mut full, &wall, &operator, kept, said, &quiet).expect("written");
    let header = CompactFile::open(compact.clone()).expect("it opens").header;
    [
        (Reader::Full, full.into_inner()),
        (Reader::Compact, compact),
        (Reader::Header, header.to_json().into_bytes()),
    ]
}

#[test]
fn changed_pictures_in_few_numbers_are_refused_or_read_whole() {
    let mut mutator = Mutator::new(WORDS);
    for (reader, seed) in seeds() {
        assert!(attack(reader, &seed), "{reader:?}: the seed is read");
        for cut in (0..seed.len()).step_by(seed.len() / 60 + 1) {
            assert!(!attack(reader, &seed[..cut]), "{reader:?}: cut at {cut}");
        }
        for _ in 0..runs() {
            attack(reader, &mutator.mutate(std::slice::from_ref(&seed)));
        }
    }
}

#[test]
fn a_long_word_of_a_header_is_not_said_in_full() {
    let [.., (reader, header)] = seeds();
    let header = String::from_utf8(header).expect("text");
    let long = header.replace(
        "\"kind\":\"one\"",
        &format!("\"kind\":\"{}\"", "x".repeat(4000)),
    );
    assert_ne!(long, header);
    assert!(!attack(reader, long.as_bytes()));
    let long = header.replace("composite-picture", &"x".repeat(4000));
    assert!(!attack(reader, long.as_bytes()));
}
