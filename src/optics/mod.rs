//! Light through prisms, drops and gems: every spike one exact ray.
//!
//! ```text
//! index       dispersion formulas, materials    prism, bench, strip   a slit, a prism, a screen
//! rainbow     a ray in a drop, the bows         sky                   the strip of sky
//! solid, cut  convex bodies, the brilliant      scene, studio         dome, lamps, camera
//! chain       the whole tree of rays as a chain film, plane, tile, plan  its planes
//! picture     a film under a light, its noise   tone_map, spectral    what goes out
//! ```
//!
//! The smooth part and the spikes of a light are told apart before anything is traced: a spike is
//! one wavelength, refracted exactly, and never smeared. Units: wavelengths are nm in air, angles
//! in public are degrees, lengths mm on the bench and radii of the girdle at the gem. Clear
//! bodies, unpolarised light at each face of a gem, no double refraction, geometric optics.

mod absorption;
mod bench;
mod chain;
mod cut;
mod film;
mod fresnel;
mod index;
mod index_error;
mod lanes;
mod light;
mod lines;
mod materials;
mod monotone;
mod picture;
mod plan;
mod plane;
mod points;
mod prism;
mod rainbow;
mod real;
mod report;
mod scene;
mod screen;
mod sky;
mod solid;
mod spectral;
mod strip;
mod studio;
mod tile;
mod tone_map;

pub use absorption::Absorption;
pub(crate) use absorption::AbsorptionError;
pub(crate) use bench::Landing;
pub use bench::{Bench, BenchError, BenchSettings};
pub use chain::Ending;
pub use cut::{Brilliant, CutError};
pub use film::{Film, FilmError};
pub(crate) use film::{MOST_LINES, RAYS, SIZES, film_bytes};
#[cfg(test)]
pub(crate) use fresnel::reflectances;
pub use index::Material;
pub use index_error::IndexError;
pub(crate) use light::SEEN_NM;
pub use light::{Light, LightError};
pub use materials::BuiltinMaterial;
pub(crate) use picture::Noise;
pub use picture::Picture;
pub use plane::FilmSettings;
#[cfg(test)]
pub(crate) use plane::Plane;
pub(crate) use prism::{Incidence, Limits};
#[cfg(test)]
pub(crate) use prism::{Passage, Prism, limits, minimum_deviation};
#[cfg(test)]
pub(crate) use rainbow::bow;
pub(crate) use rainbow::{Bows, DropRay, from_antisolar};
pub(crate) use report::{GemReport, gem_json, prism_csv, prism_json, rainbow_json};
pub(crate) use scene::View;
pub use scene::{Lamp, Scene, SceneError};
pub use sky::Sky;
pub(crate) use sky::{SKY_DEG, SUN_DEG};
#[cfg(test)]
pub(crate) use solid::{HalfSpace, Solid};
pub(crate) use spectral::spectral_planes;
pub use strip::MOST_COLUMNS;
pub(crate) use strip::{Screen, Strip};
pub use studio::{Seen, Studio, StudioError};
pub(crate) use tone_map::into_gamut;
