//! The colours of a chart's surroundings and of its curves, in both themes.

use std::sync::LazyLock;

use super::{Rgb, Theme};
use crate::color::{Srgb, srgb_from_wavelength_over};

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

/// What a mark is drawn in: the part it has in a chart, which a theme gives a colour, or a colour of
/// its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ink {
    /// A colour that the data have.
    Own(Rgb),
    /// The colour of a wavelength, nm, over the ground.
    Wavelength(f64),
    /// The measured curve: neutral.
    Measured,
    /// The model: an outline.
    Model,
    /// The smooth part: blue.
    Smooth,
    /// Lines: orange.
    Spikes,
    /// The residual: bluish green.
    Residual,
    /// The product with a patch: reddish purple.
    Product,
    /// The second light: a magenta, which no wavelength has.
    Second,
    /// Overlays, one after the other.
    Overlay(usize),
    /// As numbers of the axes.
    Faint,
    /// As names and titles.
    Text,
    /// As zero lines.
    Axis,
    /// As lines that help to read values.
    Grid,
    /// As what lies behind the series.
    Ground,
    /// Beyond what is taken: a grey.
    Beyond,
}

impl From<Rgb> for Ink {
    fn from(colour: Rgb) -> Self {
        Self::Own(colour)
    }
}

/// How many inks overlays have.
pub const OVERLAY_INKS: usize = 4;

impl Ink {
    /// Its colour in a theme. The line colours can be told apart by colour-blind eyes: after Okabe
    /// and Ito (2008), tuned for a ground.
    pub fn of(self, theme: Theme) -> Rgb {
        let palette = Palette::of(theme);
        let [dark, light]: [Rgb; 2] = match self {
            Self::Own(colour) => return colour,
            Self::Wavelength(nm) => return of_wavelength(nm, theme),
            Self::Faint => return palette.faint,
            Self::Text => return palette.text,
            Self::Axis => return palette.axis,
            Self::Grid => return palette.grid,
            Self::Ground => return palette.ground,
            Self::Measured => [[222; 3], [40; 3]],
            Self::Model => [[255; 3], [0; 3]],
            Self::Smooth => [[86, 180, 233], [0, 114, 178]],
            Self::Spikes => [[240, 165, 30], [200, 90, 0]],
            Self::Residual => [[64, 190, 150], [0, 128, 96]],
            Self::Product => [[214, 140, 185], [165, 70, 130]],
            Self::Second => [[255, 96, 208], [178, 20, 134]],
            Self::Beyond => [[54; 3], [214; 3]],
            Self::Overlay(index) => match index % OVERLAY_INKS {
                0 => [[240, 228, 66], [150, 130, 0]],
                1 => [[213, 94, 0], [160, 60, 0]],
                2 => [[150, 150, 220], [90, 80, 170]],
                _ => [[160, 200, 120], [70, 120, 40]],
            },
        };
        match theme {
            Theme::Dark => dark,
            Theme::Light => light,
        }
    }
}

/// The colour of a wavelength, nm, over the ground of strips.
fn of_wavelength(nm: f64, theme: Theme) -> Rgb {
    const FIRST_NM: u32 = 360;
    const LAST_NM: u32 = 830;
    const GROUNDS: [(Theme, Rgb); 2] = [(Theme::Dark, [27; 3]), (Theme::Light, [255; 3])];
    /// Whole nm, which strips are made of: they are painted every frame.
    static WHOLE_NM: LazyLock<[Vec<Rgb>; 2]> = LazyLock::new(|| {
        GROUNDS.map(|(_, ground)| {
            let all = (FIRST_NM..=LAST_NM).map(f64::from);
            all.map(|nm| srgb_from_wavelength_over(nm, Srgb(ground)).0)
                .collect()
        })
    });
    let which = usize::from(theme != GROUNDS[0].0);
    let place = nm - f64::from(FIRST_NM);
    let whole = (nm.fract() == 0.0 && place >= 0.0).then(|| WHOLE_NM[which].get(place as usize));
    let whole = whole.flatten().copied();
    whole.unwrap_or_else(|| srgb_from_wavelength_over(nm, Srgb(GROUNDS[which].1)).0)
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
            for ink in [Ink::Measured, Ink::Smooth, Ink::Spikes, Ink::Residual] {
                assert_eq!(palette.legible(ink.of(theme)), ink.of(theme));
            }
        }
    }

    #[test]
    fn a_wavelength_has_its_colour_over_the_ground_of_its_theme() {
        for (theme, ground) in [(Theme::Dark, [27; 3]), (Theme::Light, [255; 3])] {
            for nm in [
                300.0, 360.0, 380.0, 546.0, 546.1, 780.0, 830.0, 831.0, 2500.0,
            ] {
                let expected = srgb_from_wavelength_over(nm, Srgb(ground)).0;
                assert_eq!(Ink::Wavelength(nm).of(theme), expected, "{nm} nm");
            }
            assert_eq!(Ink::Wavelength(300.0).of(theme), ground);
        }
    }
}
