//! Any bytes for the reader of Sekonic CSV.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("Sekonic CSV", bytes));
