//! The colours of a chart's surroundings and of its curves, in both themes.

use super::{Rgb, Theme};

/// The colours of everything but the series: greys, so that nothing tints the colours on show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Palette {
    /// What a picture in a file is drawn on.
    pub paper: Rgb,
    /// Behind the series.
    pub ground: Rgb,
    /// Names and titles.
    pub text: Rgb,
    /// Numbers of the axes, notes.
    pub faint: Rgb,
    /// Zero lines and tick marks.
    pub axis: Rgb,
    /// Around the panels.
    pub frame: Rgb,
    /// Lines that help to read values.
    pub grid: Rgb,
}

impl Palette {
    /// The palette of a theme.
    pub fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Dark => &Self {
                paper: [24; 3],
                ground: [20; 3],
                text: [205; 3],
                faint: [150; 3],
                axis: [95; 3],
                frame: [62; 3],
                grid: [46; 3],
            },
            Theme::Light => &Self {
                paper: [255; 3],
                ground: [252; 3],
                text: [45; 3],
                faint: [95; 3],
                axis: [150; 3],
                frame: [200; 3],
                grid: [222; 3],
            },
        }
    }
}

/// Line colours that colour-blind eyes tell apart, after Okabe and Ito (2008), tuned for a ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inks {
    /// The measured curve: neutral.
    pub measured: Rgb,
    /// The smooth part: blue.
    pub smooth: Rgb,
    /// Spikes and model: orange.
    pub spikes: Rgb,
    /// The residual: bluish green.
    pub residual: Rgb,
    /// The product with a patch: reddish purple.
    pub product: Rgb,
    /// Overlays, one after the other.
    pub overlays: [Rgb; 4],
}

impl Inks {
    /// Inks on near-black.
    pub const DARK: Self = Self {
        measured: [222, 222, 222],
        smooth: [86, 180, 233],
        spikes: [240, 165, 30],
        residual: [64, 190, 150],
        product: [214, 140, 185],
        overlays: [
            [240, 228, 66],
            [213, 94, 0],
            [150, 150, 220],
            [160, 200, 120],
        ],
    };

    /// Inks on white.
    pub const LIGHT: Self = Self {
        measured: [40, 40, 40],
        smooth: [0, 114, 178],
        spikes: [200, 90, 0],
        residual: [0, 128, 96],
        product: [165, 70, 130],
        overlays: [[150, 130, 0], [160, 60, 0], [90, 80, 170], [70, 120, 40]],
    };

    /// The inks of a theme.
    pub fn of(theme: Theme) -> Self {
        match theme {
            Theme::Dark => Self::DARK,
            Theme::Light => Self::LIGHT,
        }
    }
}
