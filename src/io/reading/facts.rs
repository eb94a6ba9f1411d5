//! Facts kept about a spectrum, beside its numbers, while its file is read.

use super::decision::Decisions;
use super::remark::Remark;

/// The known facts about a spectrum beside its numbers, until they are put in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// The decisions about it.
    pub decisions: Decisions,
    /// Another unit that the file names for its axis.
    pub against: Option<String>,
    /// Words for the line of provenance.
    pub how: Vec<String>,
    /// True if that line mentions per cent.
    pub tells_scale: bool,
    /// The remarks to be made, in this order.
    pub remarks: Vec<Remark>,
}
