//! Any bytes for the reader of IES TM-27 .spdx.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("IES TM-27 .spdx", bytes));
