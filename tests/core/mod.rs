//! Tests of the core that need its inside: spectra, colour, the other representations, studies, and the
//! promises of the house. One file a subject.

#[path = "../common/mod.rs"]
mod common;
#[path = "../common/docs.rs"]
mod docs;
#[path = "../common/lights.rs"]
mod lights;
#[path = "../common/open_exr.rs"]
mod open_exr;
#[path = "../common/plain.rs"]
mod plain;
#[path = "../common/root.rs"]
pub(crate) mod root;

mod colour;
mod design_best;
mod design_recover;
mod design_solve;
mod detector;
mod documents;
mod fine_data;
mod held_out;
mod lamps;
mod lamps_golden;
mod languages;
mod layers;
mod model;
mod optics_any_settings;
mod optics_dispersion;
mod optics_gem;
mod optics_laws;
pub(crate) mod photographs;
mod pictures_files;
mod pictures_golden;
mod pictures_ways;
mod products;
mod products_chain;
mod quality_diagram;
mod quality_golden;
mod quality_sentences;
mod quality_words;
mod race;
mod readme;
mod spectra;
mod tradeoff;
mod vocabulary;
