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
//! finish        the measurement that a column is
//! noise         white noise by second differences
//! kernel        the shapes of slits
//! slit          a table seen through a slit, resampled by area
//! normalise     by peak, area, a wavelength, Y
//! repeats       scans of one light: mean, level, axis, noise and its memory
//! belonging     scans that do not belong, and drift
//! figures       Y, x, y, CCT, Duv, Ra, R9 and Rf as functions of 345 colour sums
//! doubt         sigma points in those sums: u, bias, 95 % half width
//! splice        two ranges of one light as one
//! counts        counts that are no light, and how they are known
//! flat_tops     where an instrument was at the end of its scale
//! draws         normal numbers of a seed
//! on_nm         a measurement on whole nm
//! guards        lines that noise cannot make, the order at which a series draws noise
//! lines         lines with their doubt: jackknife, copies
//! atoms         atomic lines without width
//! slit_width    the width of a slit, by such lines
//! composites    sums of composites
//! quotient      intervals of quotients, and their lines
//! unslit        a slit taken off
//! deconvolve    the part without lines, sharpened until the noise
//! features      what two sets are compared by
//! axis          what an axis is off by
//! instrument    an instrument's response, learnt and taken off
//! changed       what differs between two sets of scans
//! jumps         where series over time jump
//! statistics    Student's t, Holm's procedure
//! ```
//!
//! Every step is exact for tables that are straight lines between their samples.

mod atoms;
mod axis;
mod belonging;
mod changed;
mod columns;
mod combine;
mod composites;
mod counts;
mod deconvolve;
mod doubt;
mod draws;
mod error;
mod features;
mod figures;
mod finish;
mod flat_tops;
mod formula;
#[cfg(test)]
mod golden;
#[cfg(test)]
mod golden_slit;
mod guards;
mod instrument;
mod jumps;
mod kernel;
mod lines;
mod mask;
mod measurement;
mod noise;
mod normalise;
mod on_nm;
mod quantity;
mod quotient;
mod repeats;
mod slit;
mod slit_width;
mod splice;
mod statistics;
#[cfg(test)]
mod study;
#[cfg(test)]
mod study_slit;
mod union;
mod units;
mod unslit;

pub use axis::{AxisFound, axis_of, slit_of_daylight};
pub use belonging::{Drift, Misfit, drift, misfits};
pub use changed::{ChangeError, Changed, Part, Verdict, changed};
pub use combine::{Combined, Options, combine};
pub use composites::{Summand, sum_of_composites};
pub use counts::{CountsSign, counts_sign};
pub use doubt::{Doubt, Doubted, doubts, missing_light, rounded};
pub(crate) use draws::normal;
pub use error::MeasurementError;
pub use features::{COSINES, Feature};
pub use figures::{FIGURES, Figure, figures_of};
pub use flat_tops::{FlatTop, flat_tops};
pub use formula::{Formula, FormulaError};
pub use guards::{MOST_ORDER, doubts_of_numbers, lines_of_the_noise, order_of_the_noise};
pub use instrument::{Instrument, Known, learn};
pub use jumps::{Moment, Shift, jumps, scatter};
pub use kernel::{Kernel, Slit};
pub use lines::{LineWithDoubt, lines_of, lines_of_scans};
pub use measurement::{Masked, Measurement, letter};
pub use noise::{has_memory, noise_behind, noise_of};
pub use normalise::{Normalise, normalised};
pub use quantity::{Meaning, Quantity, quantity_of};
pub use quotient::{LinePoint, fieller, line_points};
pub use repeats::{Repeats, RepeatsError, mean_of};
pub use slit::{resampled, smoothed};
pub use slit_width::{SlitFound, SlitLine, slit_of};
pub use splice::{Spliced, splice};
pub use statistics::{OF_95, holm, student_95, two_sided_p};
pub use union::{MOST_POINTS, PIECE_NM, Union};
pub use unslit::{NarrowLine, Unslit, unslit};
