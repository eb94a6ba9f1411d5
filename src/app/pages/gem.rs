//! What the page "Gem" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    prism::{EXPOSED, STOPS},
    row,
    states::PageState,
};
use crate::{
    app::{
        Entry,
        dispersion::{Sent, Substance},
    },
    optics::{Brilliant, BuiltinMaterial},
    spectrum::Kind,
};

pub(super) const ROW: Row = row(
    Page::Gem,
    Place::Picture,
    (later!("Gem"), "gem"),
    "prism",
    later!("A cut gem under the light, traced ray by ray; under another light at once."),
);

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
            Self::Clear => said!("clear"),
            Self::Grey => said!("grey"),
            Self::Filter => said!("that of a filter"),
        }
    }
}

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
            Self::Whole => said!("the whole light"),
            Self::Lines => said!("its lines alone"),
            Self::Smooth => said!("its smooth part alone"),
        }
    }
}

/// The gem's page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct GemMemory {
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
    /// Key of the light of the second picture: of the light that all pages compare, where none was
    /// chosen here.
    pub fn light_beside(&self, compared: Option<&Entry>) -> Option<String> {
        let compared = compared.filter(|entry| entry.kind() == Kind::Light);
        match compared {
            Some(light) if self.under == Self::default().under => Some(light.key.clone()),
            _ => self.under.clone(),
        }
    }

    pub const GREY: Knob<Self> = knob!(grey: later!("Takes away"), Reach::Within(0.0, 2.0), 2 "",
        later!("The part of the light that it absorbs for each radius of the girdle."));
    pub const THICKNESS: Knob<Self> = knob!(thickness: later!("as thick as"),
        Reach::Within(0.5, 50.0), 1 later!(" radii"),
        later!("How thick the filter is, radii of the girdle."));
    const HEIGHT: Knob<Self> = knob!(height_deg: later!("Height of the camera"),
        Reach::Within(15.0, 89.0), 1 "\u{b0}",
        later!("Below it looks past the crown, straight above it has no up."));

    /// The parts of the cut: those that change the look most, then the others.
    pub fn cut_knobs() -> impl Iterator<Item = &'static Knob<Self>> {
        Self::KNOBS.iter().filter(|knob| knob.key == "cut")
    }

    /// The camera follows a hand, which moved so many points to the right and down.
    pub fn turn_by(&mut self, [right, down]: [f64; 2]) {
        let turn = self.turn_deg - DEGREES_A_POINT * right + 180.0;
        self.turn_deg = turn.rem_euclid(360.0) - 180.0;
        Self::HEIGHT.set(self, self.height_deg + DEGREES_A_POINT * down);
    }

    /// The camera as it stands at first.
    pub fn look_from_front(&mut self) {
        (self.turn_deg, self.height_deg) = (USUAL_TURN_DEG, USUAL_HEIGHT_DEG);
    }
}

/// Where the camera stands at first: down on the crown, almost from the front, degrees.
const USUAL_TURN_DEG: f64 = 8.0;
const USUAL_HEIGHT_DEG: f64 = 64.0;

impl PageState for GemMemory {
    const KNOBS: &'static [Knob<Self>] = &[
        knob!(cut.pavilion_deg: later!("Pavilion"), Reach::Within(30.0, 55.0), 2 "\u{b0}",
            later!("Slope of the lower facets. Near 41\u{b0} a diamond sends most light back up.")),
        knob!(cut.crown_deg: later!("Crown"), Reach::Within(20.0, 50.0), 2 "\u{b0}",
            later!("Slope of the upper facets, which spread white light into colours.")),
        knob!(cut.table: later!("Table"), Reach::Within(0.3, 0.85), 3 "",
            later!("Width of the flat top, as a share of the gem's.")),
        knob!(cut.star: later!("Stars"), Reach::Within(0.2, 0.8), 3 "",
            later!("How far the facets beside the table reach towards the edge.")),
        knob!(cut.lower: later!("Lower halves"), Reach::Within(0.4, 0.95), 3 "",
            later!("How far the narrow facets below reach from the edge to the tip.")),
        knob!(cut.girdle: later!("Girdle"), Reach::Within(0.005, 0.1), 3 "",
            later!("Height of the gem's edge, as a share of its width.")),
        knob!(cut.culet: later!("Culet"), Reach::Within(0.0, 0.2), 3 "",
            later!("Width of a facet in place of the tip, as a share of the gem's; 0 for a tip.")),
        Self::GREY,
        Self::THICKNESS,
        knob!(turn_deg: later!("Turn of the camera"), Reach::Within(-180.0, 180.0), 1 "\u{b0}",
            later!("How far the camera went round the gem.")),
        Self::HEIGHT,
        knob!(size: later!("Picture"), Reach::OneOf(&[240.0, 360.0, 480.0, 720.0]), 0 " px",
            later!("Columns and rows of the picture.")),
        knob!(rays: later!("Rays a pixel"), Reach::OneOf(&[8.0, 16.0, 32.0, 64.0, 256.0]), 0 "",
            later!("Twice as many take twice the time and leave 0.7 of the noise.")),
        knob!(stops: later!("Exposure"), STOPS, 1 later!(" stops"), EXPOSED),
    ];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("made_of", later!("the material")),
        ("colour", later!("the gem's colour")),
        ("filter", later!("the filter that colours it")),
        ("part", later!("the part of the light")),
        ("under", later!("the second light")),
        ("sent", later!("the light sent through")),
    ];

    fn settle(&mut self) {
        self.made_of.settle();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_slider_moves_its_own_part_of_the_cut() {
        for (index, knob) in GemMemory::cut_knobs().enumerate() {
            let mut gem = GemMemory::default();
            let value = knob.get(&mut gem) + 0.01;
            knob.set(&mut gem, value);
            assert_ne!(gem.cut, Brilliant::default(), "{}", knob.title);
            for (other, of) in GemMemory::cut_knobs().enumerate() {
                let moved = of.get(&mut gem) != of.get(&mut GemMemory::default());
                assert_eq!(moved, index == other, "{}", knob.title);
            }
        }
        assert_eq!(GemMemory::cut_knobs().count(), 7);
    }
}
