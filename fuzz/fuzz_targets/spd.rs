//! Any bytes for the reader of pbrt .spd.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("pbrt .spd", bytes));
