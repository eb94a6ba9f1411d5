//! What the lines of a light are called.
//!
//! No name is better than a wrong one. A line is never named by itself: the peaks of the whole
//! curve are looked at together, and an element or a phosphor is there when its strongest lines
//! are, in about the right order. A peak that one has explained is no witness for another, and
//! where what is explained is the smaller part of all that stands up nothing is named at all.
//! Only elements that lamps are made of are looked for (`table`). Phosphors shine in bands, which
//! are called bands. What hangs down is no line of a lamp: dips have names of their own
//! (`absorption_names`).
//!
//! The names belong to the light, not to a model of it: they do not change while its knobs are
//! turned, and a model's spike has the name of the peak that it stands for.

mod gases;
mod halides;
mod identify;
mod mercury;
mod peaks;
mod phosphors;
mod scene;
mod sodium;
mod table;

pub(super) use super::library::ElementLine;
pub(super) use identify::Identified;
pub use identify::spike_under;

/// What a spike is called.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct LineName {
    /// Its name: "Hg 435.8", "terbium band 545, with Hg 546.1 in it".
    pub safe: Option<String>,
    /// The same where there is little room: "Hg 435.8", "Tb band + Hg 546.1".
    pub label: Option<String>,
}

#[cfg(test)]
mod tests;
