//! Measurements made comparable: combined, repeated, doubted. Numbers only, no files.
//!
//! ```text
//! error         why a combination is refused
//! measurement   a table with what is known of its doubt
//! quantity      what values are, and which combination of them means what
//! units         units of lights, converted
//! union         the grid on which a combination is exact
//! formula       A - B, (A - C) / (B - C), -log10(A / B): text to a tree
//! columns       values with their slopes against each input
//! mask          what the noise leaves nothing of
//! combine       a tree over measurements: values, sigma, mask
//! noise         white noise by second differences
//! kernel        the shapes of slits
//! slit          a table seen through a slit, resampled by area
//! normalise     by peak, area, a wavelength, Y
//! repeats       scans of one light: mean, level, axis, noise and its memory
//! belonging     scans that do not belong, and drift
//! figures       Y, x, y, CCT, Duv, Ra, R9 and Rf as functions of 345 colour sums
//! doubt         sigma points in those sums: u, bias, 95 % half width
//! splice        two ranges of one light as one
//! changed       what differs between two sets of scans
//! statistics    Student's t, Holm's procedure
//! ```
//!
//! Every step is exact for tables that are straight lines between their samples.

mod belonging;
mod changed;
mod columns;
mod combine;
mod doubt;
mod error;
mod figures;
mod formula;
#[cfg(test)]
mod golden;
mod kernel;
mod mask;
mod measurement;
mod noise;
mod normalise;
mod quantity;
mod repeats;
mod slit;
mod splice;
mod statistics;
mod union;
mod units;

pub use belonging::{Drift, Misfit, drift, misfits};
pub use changed::{ChangeError, Changed, Feature, Part, Verdict, changed};
pub use combine::{Combined, Options, combine};
pub use doubt::{Doubt, Doubted, doubts, rounded};
pub use error::MeasurementError;
pub use figures::{FIGURES, Figure, figures_of};
pub use formula::{Formula, FormulaError};
pub use kernel::{Kernel, Slit};
pub use measurement::{Masked, Measurement, letter};
pub use noise::noise_of;
pub use normalise::{Normalise, normalised};
pub use quantity::{Meaning, Quantity, quantity_of};
pub use repeats::{Repeats, RepeatsError};
pub use slit::{resampled, smoothed};
pub use splice::{Spliced, splice};
pub use statistics::{holm, student_95, two_sided_p};
pub use union::{MOST_POINTS, PIECE_NM, Union};
