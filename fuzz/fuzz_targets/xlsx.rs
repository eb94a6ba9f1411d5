//! Any bytes for the reader of Excel workbook.
#![no_main]

#[path = "../harness.rs"]
mod harness;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| harness::attack("Excel workbook", bytes));
