//! Spectral pictures in few numbers a pixel, relit live.
//!
//! ```text
//! bands       the wavelengths of a picture                   light     what falls on it
//! lines       places and shapes shared by all pixels         plan, operator  pixel <-> numbers, one matrix
//! prior       what reflectances usually do                   scene     a wall of paints, made
//! pixels      memory, cube or file, some rows at a time      strips    the same on every thread
//! survey      mean, noise, a sample                          choose    how many numbers, and which
//! kernel      a small matrix times many pixels               measure   what a picture is off by
//! relight     other lights in coefficients                   trust     how far to believe them
//! picture     numbers in memory                              preview   what a viewer shows
//! header      what the numbers mean                          full      OpenEXR
//! compact     PNG with the numbers in private chunks
//! save        files whole or not at all                      envi_file a cube on disk, by rows
//! peers       other ways, in the same run                    fit       tables of many spectra
//! report      JSON
//! ```

mod bands;
mod choose;
mod compact;
mod envi_file;
mod error;
mod fit;
mod fitting;
mod full;
mod header;
mod kernel;
mod light;
mod lines;
mod measure;
mod operator;
mod peers;
mod picture;
mod pixels;
mod plan;
mod preview;
mod prior;
mod relight;
mod report;
mod save;
mod scene;
mod strips;
mod survey;
mod trust;

pub use crate::io::Precision;
pub use bands::Bands;
pub(crate) use bands::KeptBands;
pub use choose::{Asked, BOUND_P95, BOUND_RMS, FixedSettings, LineChoice, choose};
pub(crate) use choose::{Candidate, Choice, MOST_NUMBERS, plan_of};
pub use compact::{Coder, CompactFile, CompactPlan, Quantiser, compact_plan, write_compact};
pub use envi_file::EnviFile;
pub use error::PictureError;
pub(crate) use fit::fit_spectra;
pub use fit::{FitAsk, fit_line, fit_values};
pub use full::{Half, read_full, write_full};
pub use header::{About, Header};
pub(crate) use kernel::Kernel;
pub use light::Illuminant;
pub use lines::Line;
#[cfg(test)]
pub(crate) use lines::{find_lines, line_in};
#[cfg(test)]
pub(crate) use measure::Storage;
pub use measure::{Errors, Spread, Tally, measure};
pub(crate) use measure::{Exactly, white_y_of};
pub use operator::Operator;
pub use peers::exact_bytes;
pub(crate) use peers::{Peer, peers};
pub use picture::{Picture, relit_into};
pub(crate) use pixels::OfImage;
pub use pixels::{InMemory, Pixels, STRIP_ROWS};
pub(crate) use plan::Weighting;
pub use plan::{Plan, Reference, ReferenceKind};
#[cfg(test)]
pub(crate) use preview::Preview;
pub(crate) use relight::Between;
pub use relight::Relit;
pub(crate) use report::{Bytes, peers_json, picture_json};
pub use save::{save_compact, save_full};
pub use scene::Scene;
#[cfg(test)]
pub(crate) use scene::hash;
pub use strips::over_strips;
pub use survey::Survey;
pub(crate) use trust::Trust;
pub use trust::Verdict;
#[cfg(test)]
pub(crate) use trust::blind_share;
