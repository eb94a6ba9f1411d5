//! Light through a prism, drops of water and a gem, as the place "Picture" shows it.

mod drawing;
mod drop;
mod gem;
mod gem_file;
mod gem_memory;
mod gem_shown;
mod lights;
mod memory;
mod prism;
mod rainbow;
mod ranges;
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
pub use gem_memory::{
    CutSlider, GREYS, GemColour, GemMemory, LightPart, RAYS_SHOWN, SIZES_SHOWN, THICKNESSES,
};
pub use gem_shown::{GemLook, GemShown};
pub use lights::{another_light, document_light};
pub use memory::{
    APEXES_DEG, Beside, DispersionMemory, Handle, IMPACTS, INCIDENCES_DEG, PrismMemory,
    RainbowMemory, SCREENS_MM, SLITS_MM,
};
pub use prism::{PrismShown, StripShown};
pub use rainbow::{RainbowShown, sky};
pub use ranges::STOPS;
pub use sent::Sent;
pub use strip::Colours;
pub use substance::{ABBES, INDICES, Substance, is_index, material_of, own_indices};
