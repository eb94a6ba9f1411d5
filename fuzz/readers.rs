//! The program's readers without its window, which takes long to build for the fuzzer.

#[path = "../src/io/mod.rs"]
pub mod io;
#[path = "../src/spectrum/mod.rs"]
pub mod spectrum;
