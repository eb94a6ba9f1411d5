//! Charts of the pages, built once as data: the window draws them and files hold them.

pub mod auction;
pub mod coefficients;
pub mod colour;
pub mod combined;
pub mod design;
pub mod image;
pub mod import;
pub mod known_lamps;
pub mod live;
pub mod many;
pub mod order;
pub mod products;
pub mod quality;
pub mod race;
pub mod relit;
pub mod spectrum;
pub mod threshold;
pub mod tradeoff;
pub mod truth;
mod units;
