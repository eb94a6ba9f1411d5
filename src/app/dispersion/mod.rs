//! Light through a prism, drops of water and a gem, as the place "Picture" shows it.

mod drawing;
mod gem;
mod gem_file;
mod lights;
mod memory;
mod prism;
mod rainbow;
mod strip;
mod words;

pub use drawing::{BenchDrawing, DrawnRay};
pub use gem::{GemFilm, GemPass, GemScene, NoiseAsk, facts_of, next_pass, places, sentence};
pub use gem_file::{GemFile, GemForm};
pub use lights::{document_light, modelled};
pub use memory::{
    APEXES_DEG, Beside, CROWNS_DEG, CutSlider, DispersionMemory, GIRDLES, GemMemory,
    INCIDENCES_DEG, PAVILIONS_DEG, PrismMemory, RAYS_SHOWN, RainbowMemory, SIZES_SHOWN, SLITS_MM,
    STOPS, stuff_title,
};
pub use prism::{PrismShown, StripShown};
pub use rainbow::{RainbowShown, sky};
pub use strip::Colours;
