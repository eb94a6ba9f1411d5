//! Any bytes for the reader of Ocean Optics ProcSpec.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("Ocean Optics ProcSpec", bytes));
