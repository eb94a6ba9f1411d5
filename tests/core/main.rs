//! What needs no window and no files: spectra, colour, the other representations, studies, and the
//! promises of the house. One file a subject.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/docs.rs"]
mod docs;
#[path = "../common/lights.rs"]
mod lights;
#[path = "../common/root.rs"]
mod root;

mod colour;
mod detector;
mod documents;
mod fine_data;
mod layers;
mod model;
mod products;
mod products_chain;
mod quality_diagram;
mod quality_golden;
mod quality_words;
mod race;
mod readme;
mod spectra;
mod tradeoff;
