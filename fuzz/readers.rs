//! The program's readers without its window, which takes long to build for the fuzzer.

#[path = "../src/color/mod.rs"]
pub mod color;
#[path = "../src/io/mod.rs"]
pub mod io;
#[path = "../src/pictures/mod.rs"]
pub mod pictures;
#[path = "../src/preset/mod.rs"]
pub mod preset;
#[path = "../src/rivals/mod.rs"]
pub mod rivals;
#[path = "../src/spectrum/mod.rs"]
pub mod spectrum;
#[path = "../src/study/mod.rs"]
pub mod study;
