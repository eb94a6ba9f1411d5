//! Any bytes for the reader of a format that is not read.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("a format that is not read", bytes));
