//! The colours of a theme, and how a colour is written.

use super::{Rgb, Theme};

/// The colours of a theme.
pub(super) struct Palette {
    pub(super) background: Rgb,
    pub(super) text: Rgb,
    pub(super) faint_text: Rgb,
    pub(super) axis: Rgb,
    pub(super) grid: Rgb,
}

impl Palette {
    /// Greys throughout, so that nothing tints the colours on show.
    pub(super) fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Dark => &Self {
                background: [24; 3],
                text: [225; 3],
                faint_text: [165; 3],
                axis: [140; 3],
                grid: [52; 3],
            },
            Theme::Light => &Self {
                background: [255; 3],
                text: [25; 3],
                faint_text: [95; 3],
                axis: [110; 3],
                grid: [226; 3],
            },
        }
    }
}

pub(super) fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}
