//! How large and how complete a chart is drawn.

use super::{Theme, text::LEADING};

/// How large and how complete a chart is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Looks {
    /// Multiplier of type and of fixed sizes.
    pub scale: f64,
    /// Multiplier of the thickness of lines.
    pub line: f64,
    /// With title and notes, and free space around: in files. The window writes them itself.
    pub whole: bool,
    /// With the names of the series.
    pub legend: bool,
    /// Dark or light.
    pub theme: Theme,
}

impl Looks {
    /// How charts look in files.
    pub fn of_file(theme: Theme) -> Self {
        Self {
            scale: 1.0,
            line: 1.0,
            whole: true,
            legend: true,
            theme,
        }
    }

    /// Size of type beside titles, px.
    pub(super) fn small(self) -> f64 {
        11.0 * self.scale
    }

    pub(super) fn line_height(self) -> f64 {
        self.small() * LEADING
    }
}
