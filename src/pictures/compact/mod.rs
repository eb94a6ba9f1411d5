//! The compact form `NAME.cspx.png`: a PNG that any viewer shows, with the picture's numbers in
//! private chunks.
//!
//! `csPH` is the header as zlib, `csPT` one tile: u32 column and row of the tile, then for each
//! plane one byte that names its coder, u32 length, bytes; all numbers most significant byte
//! first. A mask plane (coder 2: bits, zlib) stands first where the header has `"mask": true`.

mod coder;
mod file;
mod predictor;
mod quantiser;
mod range_coder;
mod simple;
mod tile;
mod zlib;

pub use file::{CompactFile, CompactPlan, compact_plan, write_compact};
pub use quantiser::Quantiser;
pub use tile::Coder;
