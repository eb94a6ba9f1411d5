//! Files that mean harm, and files that are merely broken: no reader panics, hangs, or takes more
//! memory than 512 MiB or 20 times the file.
//!
//! The harness is the fuzz target's own (`fuzz/harness.rs`), run here on the stable toolchain over
//! a fixed number of changed miniature files. Large files are read by a child process, whose peak
//! of memory the system counts.

#[path = "../../fuzz/pictures.rs"]
mod attacked;
mod found;
#[path = "../../fuzz/harness.rs"]
mod harness;
mod large;
mod mutate;
#[path = "../common/open_exr.rs"]
mod open_exr;
mod pictures;
mod pictures_memory;
mod refusals;
#[path = "../common/root.rs"]
mod root;
mod seeds;

use std::collections::BTreeSet;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};

use mutate::Mutator;
use root::root;
use spectral_explorer::io::{FORMATS, read_bytes};

/// Changed files for each reader; `SPECTRAL_EXPLORER_HOSTILE_RUNS` asks for more.
const RUNS: usize = 400;

fn runs() -> usize {
    let asked = std::env::var("SPECTRAL_EXPLORER_HOSTILE_RUNS");
    asked.map_or(RUNS, |text| text.parse().expect("a number of runs"))
}

#[test]
fn every_reader_keeps_its_promises_on_changed_files() {
    let mut broken = Vec::new();
    let mut total = 0;
    for seeds in seeds::all() {
        let mut mutator = Mutator::new(seeds.words);
        let mut cases: Vec<Vec<u8>> = vec![Vec::new()];
        for file in &seeds.files {
            cases.push(file.clone());
            let step = file.len() / 60 + 1;
            cases.extend((1..file.len()).step_by(step).map(|at| file[..at].to_vec()));
        }
        cases.extend((0..runs()).map(|_| mutator.mutate(&seeds.files)));
        total += cases.len();
        let mut known = Vec::new();
        for case in &cases {
            let attack = catch_unwind(AssertUnwindSafe(|| harness::attack(seeds.format, case)));
            let Err(why) = attack else { continue };
            let why = why.downcast_ref::<String>().cloned().unwrap_or_default();
            // One of a kind is enough to mend.
            if known.len() < 3 {
                known.push(format!(
                    "{}: {why}\n  {:?}",
                    seeds.format,
                    String::from_utf8_lossy(case)
                ));
            }
        }
        broken.extend(known);
    }
    println!("{total} files for {} readers", FORMATS.len());
    assert!(broken.is_empty(), "{}", broken.join("\n"));
}

#[test]
fn every_reader_has_seeds_that_it_reads() {
    let seeds = seeds::all();
    let named: Vec<_> = seeds.iter().map(|seeds| seeds.format).collect();
    let known: Vec<_> = FORMATS.iter().map(|format| format.name).collect();
    assert_eq!(named, known, "seeds in the order of the list");
    for seeds in &seeds {
        let own = |file: &Vec<u8>| harness::opens_as(seeds.format, file);
        assert_eq!(
            seeds.files.iter().position(|file| !own(file)),
            None,
            "{}: a seed that is not read",
            seeds.format
        );
    }
}

/// A seed as the fuzzer has it: before it the byte that chooses its reader.
fn seed(place: usize, file: &[u8]) -> Vec<u8> {
    let mut bytes = vec![u8::try_from(place).expect("fewer readers than bytes")];
    bytes.extend(file);
    bytes
}

#[test]
fn the_fuzzer_reaches_every_reader_by_the_first_byte() {
    for (place, format) in FORMATS.iter().enumerate() {
        let bytes = seed(place, b"a file");
        let chosen = harness::reader_and_file(&bytes);
        assert_eq!(chosen, Some((format.name, &b"a file"[..])));
    }
    assert_eq!(harness::reader_and_file(b""), None);
}

/// Writes what the fuzzer starts from: `cargo test --test hostile -- --ignored`.
#[test]
#[ignore = "writes fuzz/corpus"]
fn seeds_are_written_for_the_fuzzer() {
    let folder = root().join("fuzz/corpus/readers");
    fs::create_dir_all(&folder).expect("a folder");
    let mut words = BTreeSet::new();
    for (place, seeds) in seeds::all().iter().enumerate() {
        for (number, file) in seeds.files.iter().enumerate() {
            let path = folder.join(format!("{}_{number}", seeds.module));
            fs::write(path, seed(place, file)).expect("a seed");
        }
        words.extend(seeds.words);
    }
    let pictures = root().join("fuzz/corpus/pictures");
    fs::create_dir_all(&pictures).expect("a folder");
    for (place, (reader, file)) in pictures::seeds().iter().enumerate() {
        assert_eq!(attacked::Reader::ALL[place], *reader);
        fs::write(pictures.join(format!("{reader:?}")), seed(place, file)).expect("a seed");
    }
    let words: String = words.into_iter().map(entry).collect();
    fs::write(root().join("fuzz/corpus/readers.dict"), words).expect("a dictionary");
}

/// A line of the fuzzer's dictionary.
fn entry(word: &str) -> String {
    let shown = |byte: u8| match byte {
        b'"' | b'\\' => format!("\\{}", byte as char),
        b' '..=b'~' => (byte as char).to_string(),
        _ => format!("\\x{byte:02x}"),
    };
    format!("\"{}\"\n", word.bytes().map(shown).collect::<String>())
}

#[test]
fn a_path_in_an_archive_goes_nowhere() {
    let names = [
        "../../description.xml",
        "/description.xml",
        "..\\description.xml",
        "C:\\description.xml",
    ];
    for name in names {
        let archive = harness::zipped(
            &[(name, seeds::GDTF.as_bytes())],
            zip::CompressionMethod::Deflated,
        );
        let said = read_bytes("a.gdtf", &archive).unwrap_err().to_string();
        assert!(said.contains("without description.xml"), "{name}: {said}");
        harness::attack("GDTF", &archive);
    }
}
