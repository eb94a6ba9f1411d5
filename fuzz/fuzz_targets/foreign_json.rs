//! Any bytes for the reader of JSON of another program.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("JSON of another program", bytes));
