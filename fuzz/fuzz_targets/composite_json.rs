//! Any bytes for the reader of composite JSON.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("composite JSON", bytes));
