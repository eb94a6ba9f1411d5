//! Figures that are one number: their words, and what computes each.

use super::{light::Light, no_figure::NoFigure};

/// A figure that is one number of a light alone. Reports, tables and JSON walk [`super::SINGLES`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Single {
    /// Its key in JSON and in tables.
    pub key: &'static str,
    /// The name that people read.
    pub title: &'static str,
    /// Unit, empty for pure numbers.
    pub unit: &'static str,
    /// Digits behind the point that are shown.
    pub digits: usize,
    /// By which formula or standard, and over which range.
    pub method: &'static str,
    /// The number of a light, or why it has none.
    pub of: fn(&Light) -> Result<f64, NoFigure>,
}
