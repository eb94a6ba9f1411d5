//! What is kept of a spectrum beside its numbers while its file is read.

use super::decision::Decisions;
use super::remark::Remark;

/// What is known of a spectrum beside its numbers, until it is put in words.
#[derive(Clone, Debug, PartialEq)]
pub struct Facts {
    /// What was decided.
    pub decisions: Decisions,
    /// Another unit that the file names for its axis.
    pub against: Option<String>,
    /// Words for the line of provenance.
    pub how: Vec<String>,
    /// Whether that line tells of per cent.
    pub tells_scale: bool,
    /// What is to be said, in this order.
    pub remarks: Vec<Remark>,
}
