//! Any bytes for the reader of SVC .sig.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("SVC .sig", bytes));
