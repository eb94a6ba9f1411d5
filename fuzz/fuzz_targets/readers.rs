//! Any bytes for any reader, which the first byte chooses.
#![no_main]

use libfuzzer_sys::{Corpus, fuzz_target};

#[path = "../harness.rs"]
mod harness;

/// Names the only readers to try, as [`FORMATS`](spectral_explorer::io::FORMATS) does, commas
/// between them.
const ONLY: &str = "SPECTRAL_EXPLORER_FUZZ_READER";

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Some((name, file)) = harness::reader_and_file(bytes) else {
        return Corpus::Reject;
    };
    if std::env::var(ONLY).is_ok_and(|only| !only.split(',').any(|one| one == name)) {
        return Corpus::Reject;
    }
    harness::attack(name, file);
    Corpus::Keep
});
