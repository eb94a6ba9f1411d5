//! Any bytes for the reader of Raman text.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("Raman text", bytes));
