//! What the gem's page remembers; not part of undo.

use serde::{Deserialize, Serialize};

use super::{
    ranges::{clamped_stops, ends, moved},
    sent::Sent,
    substance::Substance,
};
use crate::optics::{Brilliant, BuiltinMaterial};

/// Sides of the gem's picture, pixels.
pub const SIZES_SHOWN: [usize; 4] = [240, 360, 480, 720];

/// Rays a pixel of the gem's picture.
pub const RAYS_SHOWN: [u32; 5] = [8, 16, 32, 64, 256];

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GemColour {
    /// It takes nothing away.
    #[default]
    Clear,
    /// It takes away the same at every wavelength.
    Grey,
    /// It takes away what a filter of the library does.
    Filter,
}

impl GemColour {
    /// All of them in the order of the menu.
    pub const ALL: [Self; 3] = [Self::Clear, Self::Grey, Self::Filter];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Clear => "clear",
            Self::Grey => "grey",
            Self::Filter => "that of a filter",
        }
    }
}

/// How much a grey gem may absorb for each radius.
pub const GREYS: std::ops::RangeInclusive<f64> = 0.0..=2.0;

/// How thick the filter may be, radii of the girdle.
pub const THICKNESSES: std::ops::RangeInclusive<f64> = 0.5..=50.0;

/// Which part of a light is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LightPart {
    #[default]
    Whole,
    /// Its lines alone.
    Lines,
    /// Its smooth part alone.
    Smooth,
}

impl LightPart {
    /// All parts in the order of the menu.
    pub const ALL: [Self; 3] = [Self::Whole, Self::Lines, Self::Smooth];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Whole => "the whole light",
            Self::Lines => "its lines alone",
            Self::Smooth => "its smooth part alone",
        }
    }
}

/// The gem's page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct GemMemory {
    #[serde(alias = "stuff")]
    pub made_of: Substance,
    pub colour: GemColour,
    /// How much a grey gem absorbs for each radius of the girdle.
    pub grey: f64,
    /// Key of the filter that colours it.
    pub filter: String,
    /// How thick that filter is, radii of the girdle.
    pub thickness: f64,
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
    /// Which part of the light is shown.
    pub part: LightPart,
    /// Key of the light of the second picture.
    pub under: Option<String>,
    /// What of the lights is sent through.
    pub sent: Sent,
}

impl Default for GemMemory {
    fn default() -> Self {
        Self {
            made_of: Substance::Shipped(BuiltinMaterial::Diamond),
            colour: GemColour::Clear,
            grey: 0.1,
            filter: "filters_glass_cc0/isuzu IVG550 (Green filter) 2 mm".to_owned(),
            // The light goes to and fro in a gem.
            thickness: 10.0,
            cut: Brilliant::default(),
            turn_deg: USUAL_TURN_DEG,
            height_deg: USUAL_HEIGHT_DEG,
            size: 480,
            rays: 16,
            stops: 0.0,
            part: LightPart::Whole,
            // One colour: what it leaves of a gem's fire is the plainest difference.
            under: Some("line_tubes/Sodium tube".to_owned()),
            sent: Sent::Measured,
        }
    }
}

/// Degrees that the camera moves by for each point that a hand does.
const DEGREES_A_POINT: f64 = 0.4;

impl GemMemory {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub(super) fn clamped(self) -> Self {
        let usual = Self::default();
        let mut cut = self.cut;
        for slider in CutSlider::ALL {
            let first = *(slider.of)(&mut usual.cut.clone());
            let value = (slider.of)(&mut cut);
            *value = moved(*value, slider.range, first);
        }
        let (sizes, rays) = (SIZES_SHOWN.into_iter(), RAYS_SHOWN.into_iter());
        let size = sizes.min_by_key(|size| size.abs_diff(self.size));
        let rays = rays.min_by_key(|rays| rays.abs_diff(self.rays));
        Self {
            made_of: self.made_of.clamped(),
            grey: moved(self.grey, ends(GREYS), usual.grey),
            thickness: moved(self.thickness, ends(THICKNESSES), usual.thickness),
            cut,
            turn_deg: moved(self.turn_deg, [-180.0, 180.0], USUAL_TURN_DEG),
            height_deg: moved(self.height_deg, HEIGHTS_DEG, USUAL_HEIGHT_DEG),
            size: size.unwrap_or(usual.size),
            rays: rays.unwrap_or(usual.rays),
            stops: clamped_stops(self.stops),
            ..self
        }
    }

    /// The camera follows a hand, which moved so many points to the right and down.
    pub fn turn_by(&mut self, [right, down]: [f64; 2]) {
        let turn = self.turn_deg - DEGREES_A_POINT * right + 180.0;
        self.turn_deg = turn.rem_euclid(360.0) - 180.0;
        let height = self.height_deg + DEGREES_A_POINT * down;
        self.height_deg = height.clamp(HEIGHTS_DEG[0], HEIGHTS_DEG[1]);
    }

    /// The camera as it stands at first.
    pub fn look_from_front(&mut self) {
        (self.turn_deg, self.height_deg) = (USUAL_TURN_DEG, USUAL_HEIGHT_DEG);
    }
}

/// Where the camera stands at first: down on the crown, almost from the front, degrees.
const USUAL_TURN_DEG: f64 = 8.0;
const USUAL_HEIGHT_DEG: f64 = 64.0;

/// Heights of the camera, degrees: below it looks past the crown, straight above it has no up.
const HEIGHTS_DEG: [f64; 2] = [15.0, 89.0];

/// A part of the cut that a slider moves.
#[derive(Clone, Copy, Debug)]
pub struct CutSlider {
    /// In words.
    pub title: &'static str,
    /// What it is, a sentence.
    pub meaning: &'static str,
    /// Least and largest value, degrees or a share.
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
            range: [30.0, 55.0],
            is_angle: true,
            of: |cut| &mut cut.pavilion_deg,
        },
        Self {
            title: "Crown",
            meaning: "Slope of the upper facets, which spread white light into colours.",
            range: [20.0, 50.0],
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
            range: [0.005, 0.1],
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

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn what_an_earlier_version_kept_is_understood() {
        let kept: GemMemory = serde_json::from_str("{\"stuff\":\"zirconia\"}").expect("a memory");
        assert_eq!(kept.made_of, Substance::Shipped(BuiltinMaterial::Zirconia));
    }

    #[test]
    fn colours_stay_within_what_can_be_set() {
        let usual = GemMemory::default();
        let wild = GemMemory {
            grey: f64::NAN,
            thickness: -1.0,
            ..usual.clone()
        };
        let sound = wild.clamped();
        assert_eq!(
            (sound.grey, sound.thickness),
            (usual.grey, *THICKNESSES.start())
        );
        assert_eq!(usual.clone().clamped(), usual);
    }
}
