//! Mixtures by an objective and constraints.
//!
//! ```text
//! target    the colour: xy, CCT and Duv, another light
//! problem   objective, floors, colour
//! figures   the figures of a mixture
//! polytope  all mixtures of a colour
//! interior  the best by a figure that is no sum
//! part      a figure at a mixture: value, slope, bend
//! duals     the worth of the edges of the interior
//! solution  weights for a problem
//! best      the best by figures of samples, the fewest channels
//! against   words for what efficacy is traded for
//! front     the trade between efficacy and colour rendering with free lines
//! light     a light of lines: its colour, its floor and its figure
//! net       a net over all places of two and three lines
//! moves     lines that move: the best places and powers
//! report    JSON
//! ```

mod against;
mod best;
mod duals;
mod figures;
mod front;
mod interior;
mod light;
mod moves;
mod net;
mod part;
mod polytope;
mod problem;
mod report;
mod solution;
mod target;

pub use super::scales::Against;
pub use figures::MixFigures;
pub(crate) use front::{FREE_LINES, FrontPoint};
pub use front::{FrontProblem, front};
pub use problem::{Care, Floors, Objective, Problem};
pub(crate) use report::{faders, front_json, mix_json};
pub use solution::Mixer;
pub(crate) use solution::Solution;
pub use target::Target;
