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
                ground: [18; 3],
                text: [208; 3],
                faint: [162; 3],
                axis: [95; 3],
                frame: [56; 3],
                grid: [37; 3],
            },
            Theme::Light => &Self {
                paper: [255; 3],
                ground: [255; 3],
                text: [48; 3],
                faint: [95; 3],
                axis: [150; 3],
                frame: [205; 3],
                grid: [236; 3],
            },
        }
    }

    /// A sample's colour on the paper: black or white ink that would be lost there takes the text's.
    pub fn legible(&self, ink: Rgb) -> Rgb {
        let parts = ink.iter().zip(self.paper);
        let farthest = parts.map(|(one, other)| one.abs_diff(other)).max();
        if farthest < Some(LOST) {
            self.text
        } else {
            ink
        }
    }
}

/// An ink all of whose parts are nearer to the paper than this is not seen on it.
const LOST: u8 = 40;

/// Line colours that colour-blind eyes tell apart, after Okabe and Ito (2008), tuned for a ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inks {
    /// The measured curve: neutral.
    pub measured: Rgb,
    /// The model: an outline.
    pub model: Rgb,
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
        model: [255, 255, 255],
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
        model: [0, 0, 0],
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ink_is_seen_on_the_paper_of_its_theme_and_a_seen_one_is_left_as_it_is() {
        for theme in [Theme::Dark, Theme::Light] {
            let palette = Palette::of(theme);
            for ink in [[0; 3], [255; 3], palette.paper] {
                let drawn = palette.legible(ink);
                assert!(
                    drawn[0].abs_diff(palette.paper[0]) >= LOST,
                    "{ink:?} as {drawn:?} on {:?}",
                    palette.paper
                );
            }
            let inks = Inks::of(theme);
            for ink in [inks.measured, inks.smooth, inks.spikes, inks.residual] {
                assert_eq!(palette.legible(ink), ink);
            }
        }
    }
}
