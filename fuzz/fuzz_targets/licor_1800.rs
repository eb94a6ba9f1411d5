//! Any bytes for the reader of LI-COR LI-1800.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("LI-COR LI-1800", bytes));
