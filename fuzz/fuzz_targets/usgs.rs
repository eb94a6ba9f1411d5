//! Any bytes for the reader of USGS splib07.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("USGS splib07", bytes));
