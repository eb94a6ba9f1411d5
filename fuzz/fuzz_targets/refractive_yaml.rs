//! Any bytes for the reader of refractiveindex.info YAML.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("refractiveindex.info YAML", bytes));
