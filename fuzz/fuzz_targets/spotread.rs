//! Any bytes for the reader of Argyll spotread output.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("Argyll spotread output", bytes));
