//! Light through prisms, drops and gems: every spike one exact ray.
//!
//! ```text
//! index       dispersion formulas, materials    prism, bench, strip   a slit, a prism, a screen
//! rainbow     a ray in a drop, the bows         sky                   the strip of sky
//! solid, cut  convex bodies, the brilliant      scene, studio         dome, lamps, camera
//! chain       the whole tree of rays as a chain film, plane, tile, plan  its planes
//! picture     a film under a light, its noise   develop, spectral     what goes out
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
mod develop;
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

pub use absorption::{Absorption, AbsorptionError};
pub use bench::{Bench, BenchError, BenchSettings, Landing, RayPath, Resolving};
pub use chain::{Ending, Traced};
pub use cut::{Brilliant, CutError};
pub use develop::Shown;
pub(crate) use develop::into_gamut;
pub use film::{Film, FilmError, MOST_BYTES, MOST_LINES, SIZES};
pub(crate) use film::{RAYS, film_bytes};
pub use fresnel::reflectances;
pub use index::{AbbeFigures, Material, Term};
pub use index_error::IndexError;
pub(crate) use light::SEEN_NM;
pub use light::{Light, LightError};
pub use materials::BuiltinMaterial;
pub use picture::{Noise, Picture};
pub use plane::{FilmSettings, Plane};
pub use prism::{Incidence, Limits, Passage, Prism, PrismError, limits, minimum_deviation};
pub(crate) use rainbow::from_antisolar;
pub use rainbow::{Bow, Bows, DropRay, bow};
pub(crate) use report::prism_csv;
pub use report::{GemReport, gem_json, prism_json, rainbow_json};
pub use scene::{Camera, Lamp, Scene, SceneError, View};
pub(crate) use sky::{SKY_DEG, SUN_DEG};
pub use sky::{Sky, SkyStrip};
pub use solid::{HalfSpace, Solid, SolidError, Vec3};
pub use spectral::{SpectralPlanes, spectral_planes};
pub use strip::{LineImage, MOST_COLUMNS, Screen, Strip};
pub use studio::{Seen, Studio, StudioError};
