//! Any bytes for the reader of PerkinElmer PEDS ASCII.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("PerkinElmer PEDS ASCII", bytes));
