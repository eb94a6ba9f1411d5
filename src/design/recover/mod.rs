//! Spectra from colours.
//!
//! ```text
//! viewing     a light and an observer: colours as sums over 81 nodes
//! colour      sRGB, XYZ, Lab, xyY, and what they ask of a surface under a light
//! method      the ways: smoothest, three and six Fourier coefficients, lines
//! edge        how far a colour may go from grey
//! smoothest   the bounded smoothest reflectance
//! fourier     the paper's Eq. 18
//! possible    colours that no surface has, and the nearest that one has
//! lines       a light of lines over a background
//! metamers    least and greatest reflectance of a colour, and examples of it
//! recovered   the reflectance with what must be known to trust it
//! prediction  the same surface under other lights, and beside the real one
//! picture     a picture of colours as a spectral one
//! report      JSON
//! ```

mod colour;
mod edge;
mod error;
mod fourier;
mod lines;
mod metamers;
mod method;
mod picture;
mod possible;
mod prediction;
mod recovered;
mod report;
mod smoothest;
mod viewing;

pub use colour::Colour;
pub use error::RecoverError;
pub(crate) use lines::{LineLight, LitColour};
pub(crate) use metamers::MetamerBand;
pub use method::Method;
pub(crate) use picture::PictureCount;
#[cfg(test)]
pub(crate) use picture::spectral_cube;
pub use picture::{ColourPicture, Encoded, spectral_rows, usual_bands};
pub(crate) use prediction::{Deviation, Prediction};
pub use prediction::{deviation, predictions};
pub(crate) use recovered::Nearest;
#[cfg(test)]
pub(crate) use recovered::can_be;
pub use recovered::{Recovered, Seen, metamers};
pub(crate) use recovered::{Reflectance, examples};
pub use report::json;
pub(crate) use report::line_light_json;
pub(crate) use viewing::{BAND, node_nm};
pub use viewing::{NODES, Viewing};
#[cfg(test)]
pub(crate) use viewing::{Nodes, sampled_nodes};
