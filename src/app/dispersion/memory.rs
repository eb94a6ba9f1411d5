//! What the three pages remember; not part of undo.

use serde::{Deserialize, Serialize};

use crate::optics::{Brilliant, Stuff};

/// Exposures, stops.
pub const STOPS: std::ops::RangeInclusive<f64> = -6.0..=6.0;

/// Apex angles of the prism that the slider reaches, degrees.
pub const APEXES_DEG: std::ops::RangeInclusive<f64> = 5.0..=90.0;

/// Angles of incidence that the slider reaches, degrees from the normal.
pub const INCIDENCES_DEG: std::ops::RangeInclusive<f64> = -20.0..=89.0;

/// Widths of the slit that the slider reaches, mm.
pub const SLITS_MM: std::ops::RangeInclusive<f64> = 0.02..=30.0;

/// Sides of the gem's picture, pixels.
pub const SIZES_SHOWN: [usize; 4] = [240, 360, 480, 720];

/// Rays a pixel of the gem's picture.
pub const RAYS_SHOWN: [u32; 5] = [8, 16, 32, 64, 256];

/// Crown angles of the slider, degrees.
pub const CROWNS_DEG: [f64; 2] = [20.0, 50.0];

/// Pavilion angles of the slider, degrees.
pub const PAVILIONS_DEG: [f64; 2] = [30.0, 55.0];

/// Girdles of the slider, shares of the diameter.
pub const GIRDLES: [f64; 2] = [0.005, 0.1];

/// A light that stands beside the document's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Beside {
    /// None.
    Nothing,
    /// A blackbody of 2856 K.
    #[default]
    Bulb,
    /// A blackbody of 5772 K.
    Sun,
    /// The first light that is laid over the document's.
    Overlaid,
}

impl Beside {
    /// All choices in the order of the menu.
    pub const ALL: [Self; 4] = [Self::Nothing, Self::Bulb, Self::Sun, Self::Overlaid];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::Bulb => "a bulb (2856 K)",
            Self::Sun => "the sun (5772 K)",
            Self::Overlaid => "the light laid over it",
        }
    }
}

/// The prism's page.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PrismMemory {
    /// The glass.
    pub stuff: Stuff,
    /// Apex angle, degrees.
    pub apex_deg: f64,
    /// The green line passes with least deviation; else the incidence below counts.
    pub at_minimum: bool,
    /// Incidence, degrees.
    pub incidence_deg: f64,
    /// Width of the slit, mm.
    pub slit_mm: f64,
    /// Exposure, stops.
    pub stops: f64,
    /// The second strip.
    pub beside: Beside,
}

impl Default for PrismMemory {
    fn default() -> Self {
        Self {
            stuff: Stuff::NSf11,
            apex_deg: 60.0,
            at_minimum: true,
            incidence_deg: 60.0,
            slit_mm: 0.5,
            stops: 0.0,
            beside: Beside::Bulb,
        }
    }
}

/// The rainbow's page.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RainbowMemory {
    /// The source is as wide as the sun's disc; else it is a point.
    pub disc: bool,
    /// Exposure, stops.
    pub stops: f64,
    /// The second strip.
    pub beside: Beside,
}

impl Default for RainbowMemory {
    fn default() -> Self {
        Self {
            disc: true,
            stops: 0.0,
            beside: Beside::Sun,
        }
    }
}

/// The gem's page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct GemMemory {
    /// What it is made of.
    pub stuff: Stuff,
    /// How it is cut.
    pub cut: Brilliant,
    /// How far the camera went round it, degrees.
    pub turn_deg: f64,
    /// How high the camera stands, degrees above the girdle.
    pub height_deg: f64,
    /// Side of the picture, pixels.
    pub size: usize,
    /// Rays a pixel.
    pub rays: u32,
    /// Exposure, stops.
    pub stops: f64,
    /// Key of the light of the second picture.
    pub under: Option<String>,
}

impl Default for GemMemory {
    fn default() -> Self {
        Self {
            stuff: Stuff::Diamond,
            cut: Brilliant::default(),
            turn_deg: 0.0,
            height_deg: USUAL_HEIGHT_DEG,
            size: 360,
            rays: 32,
            stops: 0.0,
            under: Some("cie_illuminants/CIE D65".to_owned()),
        }
    }
}

/// Degrees that the camera moves by for each point that a hand does.
const DEGREES_A_POINT: f64 = 0.4;

impl GemMemory {
    /// The camera follows a hand, which moved so many points to the right and down.
    pub fn turn_by(&mut self, [right, down]: [f64; 2]) {
        let turn = self.turn_deg - DEGREES_A_POINT * right + 180.0;
        self.turn_deg = turn.rem_euclid(360.0) - 180.0;
        let height = self.height_deg + DEGREES_A_POINT * down;
        self.height_deg = height.clamp(HEIGHTS_DEG[0], HEIGHTS_DEG[1]);
    }

    /// The camera as it stands at first.
    pub fn look_from_front(&mut self) {
        (self.turn_deg, self.height_deg) = (0.0, USUAL_HEIGHT_DEG);
    }
}

/// Height of the camera at first: down on the crown from the front, degrees.
const USUAL_HEIGHT_DEG: f64 = 58.1;

/// Heights of the camera, degrees: below it looks past the crown, straight above it has no up.
const HEIGHTS_DEG: [f64; 2] = [15.0, 89.0];

/// A part of the cut that a slider moves.
#[derive(Clone, Copy, Debug)]
pub struct CutSlider {
    /// In words.
    pub title: &'static str,
    /// What it is, a sentence.
    pub meaning: &'static str,
    /// Least and largest value.
    pub range: [f64; 2],
    /// Whether it is an angle; else a share.
    pub is_angle: bool,
    /// The value.
    pub of: fn(&mut Brilliant) -> &mut f64,
}

impl CutSlider {
    /// Those that change the look most, then the others.
    pub const ALL: [Self; 7] = [
        Self {
            title: "Pavilion",
            meaning: "Slope of the lower facets. Near 41\u{b0} a diamond sends most light back up.",
            range: PAVILIONS_DEG,
            is_angle: true,
            of: |cut| &mut cut.pavilion_deg,
        },
        Self {
            title: "Crown",
            meaning: "Slope of the upper facets, which spread white light into colours.",
            range: CROWNS_DEG,
            is_angle: true,
            of: |cut| &mut cut.crown_deg,
        },
        Self {
            title: "Table",
            meaning: "Width of the flat top, as a share of the gem's.",
            range: [0.3, 0.85],
            is_angle: false,
            of: |cut| &mut cut.table,
        },
        Self {
            title: "Stars",
            meaning: "How far the facets beside the table reach towards the edge.",
            range: [0.2, 0.8],
            is_angle: false,
            of: |cut| &mut cut.star,
        },
        Self {
            title: "Lower halves",
            meaning: "How far the narrow facets below reach from the edge to the tip.",
            range: [0.4, 0.95],
            is_angle: false,
            of: |cut| &mut cut.lower,
        },
        Self {
            title: "Girdle",
            meaning: "Height of the gem's edge, as a share of its width.",
            range: GIRDLES,
            is_angle: false,
            of: |cut| &mut cut.girdle,
        },
        Self {
            title: "Culet",
            meaning: "Width of a facet in place of the tip, as a share of the gem's; 0 for a tip.",
            range: [0.0, 0.2],
            is_angle: false,
            of: |cut| &mut cut.culet,
        },
    ];
}

/// What the three pages remember.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct DispersionMemory {
    /// The prism's page.
    pub prism: PrismMemory,
    /// The rainbow's page.
    pub rainbow: RainbowMemory,
    /// The gem's page.
    pub gem: GemMemory,
}

/// A value moved into a range; one that is no number becomes the usual one.
fn moved(value: f64, [least, most]: [f64; 2], usual: f64) -> f64 {
    if value.is_finite() {
        value.clamp(least, most)
    } else {
        usual
    }
}

/// The allowed value nearest to one.
fn nearest<T: Copy>(allowed: &[T], usual: T, off: impl Fn(T) -> u64) -> T {
    let best = allowed.iter().copied().min_by_key(|value| off(*value));
    best.unwrap_or(usual)
}

impl DispersionMemory {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        let usual = Self::default();
        let ends = |range: std::ops::RangeInclusive<f64>| [*range.start(), *range.end()];
        let stops = |value: f64| moved(value, ends(STOPS), 0.0);
        let prism = PrismMemory {
            apex_deg: moved(self.prism.apex_deg, ends(APEXES_DEG), usual.prism.apex_deg),
            incidence_deg: moved(
                self.prism.incidence_deg,
                ends(INCIDENCES_DEG),
                usual.prism.incidence_deg,
            ),
            slit_mm: moved(self.prism.slit_mm, ends(SLITS_MM), usual.prism.slit_mm),
            stops: stops(self.prism.stops),
            ..self.prism
        };
        let mut cut = self.gem.cut;
        for slider in CutSlider::ALL {
            let first = *(slider.of)(&mut usual.gem.cut.clone());
            let value = (slider.of)(&mut cut);
            *value = moved(*value, slider.range, first);
        }
        let gem = GemMemory {
            cut,
            turn_deg: moved(self.gem.turn_deg, [-180.0, 180.0], 0.0),
            height_deg: moved(self.gem.height_deg, HEIGHTS_DEG, USUAL_HEIGHT_DEG),
            size: nearest(&SIZES_SHOWN, usual.gem.size, |size| {
                size.abs_diff(self.gem.size) as u64
            }),
            rays: nearest(&RAYS_SHOWN, usual.gem.rays, |rays| {
                u64::from(rays.abs_diff(self.gem.rays))
            }),
            stops: stops(self.gem.stops),
            ..self.gem
        };
        let rainbow = RainbowMemory {
            stops: stops(self.rainbow.stops),
            ..self.rainbow
        };
        Self {
            prism,
            rainbow,
            gem,
        }
    }
}

/// A material in words for people.
pub fn stuff_title(stuff: Stuff) -> &'static str {
    match stuff {
        Stuff::Diamond => "diamond",
        Stuff::Zirconia => "cubic zirconia",
        Stuff::Sapphire => "sapphire",
        Stuff::NBk7 => "N-BK7, crown glass",
        Stuff::NSf11 => "N-SF11, heavy flint glass",
        Stuff::NSf10 => "N-SF10, flint glass",
        Stuff::Silica => "fused silica",
        Stuff::Water => "water",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_pages_remember_is_always_something_they_can_show() {
        let mut wild = DispersionMemory::default();
        wild.prism.apex_deg = f64::NAN;
        wild.prism.slit_mm = -3.0;
        wild.gem.cut.pavilion_deg = 1e9;
        wild.gem.size = 0;
        wild.gem.rays = 1_000_000;
        wild.gem.height_deg = f64::INFINITY;
        let sound = wild.clamped();
        assert_eq!(sound.prism.apex_deg, 60.0);
        assert_eq!(sound.prism.slit_mm, *SLITS_MM.start());
        assert_eq!(sound.gem.cut.pavilion_deg, PAVILIONS_DEG[1]);
        assert_eq!((sound.gem.size, sound.gem.rays), (240, 256));
        assert_eq!(sound.gem.height_deg, USUAL_HEIGHT_DEG);
        let usual = DispersionMemory::default();
        assert_eq!(usual.clone().clamped(), usual);
    }

    #[test]
    fn every_slider_moves_its_own_part_of_the_cut() {
        for (index, slider) in CutSlider::ALL.iter().enumerate() {
            let mut cut = Brilliant::default();
            *(slider.of)(&mut cut) += 0.01;
            for (other, of) in CutSlider::ALL.iter().enumerate() {
                let moved = *(of.of)(&mut cut) != *(of.of)(&mut Brilliant::default());
                assert_eq!(moved, index == other, "{}", slider.title);
            }
        }
    }
}
