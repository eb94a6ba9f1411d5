//! Any bytes for the reader of spectral OpenEXR.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("spectral OpenEXR", bytes));
