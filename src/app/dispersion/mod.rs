//! Light through a prism, drops of water and a gem, as the place "Picture" shows it.

mod drawing;
mod drop;
mod gem;
mod gem_file;
mod gem_shown;
mod lights;
mod prism;
mod rainbow;
mod sent;
mod strip;
mod substance;
mod words;

pub use drawing::{BenchDrawing, DrawnRay, Grip, Leaves, MostBent};
pub use drop::{DropDrawing, DropRay};
pub use gem::{
    GemFilm, GemPass, GemScene, NoiseAsk, facts_of, next_pass, noise_words, places, sentence,
};
pub use gem_file::{GemFile, GemForm, gem_exr};
pub use gem_shown::{GemLook, GemShown};
pub use lights::{another_light, document_light};
pub use prism::{PrismShown, StripShown};
pub use rainbow::{RainbowShown, sky};
pub use sent::Sent;
pub use strip::Colours;
pub use substance::{ABBES, INDICES, Substance, is_index, material_of, own_indices};
