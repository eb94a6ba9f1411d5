//! What the page "Prism" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    row,
    states::PageState,
};
use crate::{
    app::dispersion::{Sent, Substance},
    optics::{BuiltinMaterial, SEEN_NM},
};

pub(super) const ROW: Row = row(
    Page::Prism,
    Place::Picture,
    (later!("Prism and rainbow"), "prism"),
    "prism",
    later!("The light through a prism: every line one exact ray, the rest a smooth band."),
)
.among_modes(later!("Prism"));

/// Exposures, stops.
pub const STOPS: Reach = Reach::Within(-6.0, 6.0);

/// What an exposure is.
pub(super) const EXPOSED: &str = later!("Each stop doubles the light.");

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
            Self::Nothing => said!("nothing"),
            Self::Bulb => said!("a bulb (2856 K)"),
            Self::Sun => said!("the sun (5772 K)"),
            Self::Overlaid => said!("the light compared with it"),
        }
    }
}

/// The prism's page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PrismMemory {
    /// The glass.
    pub made_of: Substance,
    /// Apex angle, degrees.
    pub apex_deg: f64,
    /// A wavelength passes with least deviation; else the incidence below counts.
    pub at_minimum: bool,
    /// That wavelength, nm.
    pub minimum_nm: f64,
    /// Incidence, degrees.
    pub incidence_deg: f64,
    /// Width of the slit, mm.
    pub slit_mm: f64,
    /// From the prism to the screen, mm.
    pub screen_mm: f64,
    /// Exposure, stops.
    pub stops: f64,
    /// The second strip.
    pub beside: Beside,
    /// What of the light is sent through.
    pub sent: Sent,
}

/// What a hand takes hold of in the drawing of the bench.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Handle {
    /// A lower corner of the prism: the apex angle.
    Apex,
    /// A jaw of the slit.
    Slit,
}

impl Handle {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Apex, Self::Slit];

    /// What it moves, in words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Apex => said!("Apex angle"),
            Self::Slit => said!("Slit"),
        }
    }
}

impl PrismMemory {
    pub const APEX: Knob<Self> = knob!(apex_deg: later!(
        "Apex angle"
    ), Reach::Within(5.0, 90.0), 1 "\u{b0}",
        later!("The angle between the two faces that the light goes through."));
    pub const MINIMUM: Knob<Self> = knob!(minimum_nm: later!("Least deviation for"),
        Reach::Within(SEEN_NM[0], SEEN_NM[1]), 1 " nm",
        later!("The wavelength that passes at minimum deviation."));
    pub const INCIDENCE: Knob<Self> = knob!(incidence_deg: later!("Light meets it at"),
        Reach::Within(-20.0, 89.0), 1 "\u{b0}",
        later!("Angle between the light and the normal of the first face."));
    pub const SLIT: Knob<Self> = knob!(slit_mm: later!("Slit"), Reach::Within(0.02, 30.0), 2 " mm",
        later!("Width of the beam. Wide, lines run together and the middle turns white."));
    pub const SCREEN: Knob<Self> = knob!(screen_mm: later!("Screen"),
        Reach::Within(50.0, 2000.0), 0 " mm",
        later!("From the prism to the screen."));
    const EXPOSURE: Knob<Self> =
        knob!(stops: later!("Exposure"), STOPS, 1 later!(" stops"), EXPOSED);

    /// A hand moved a handle: degrees of the apex, mm of the slit, as far as the sliders reach.
    pub fn set(&mut self, handle: Handle, value: f64) {
        let knob = match handle {
            Handle::Apex => Self::APEX,
            Handle::Slit => Self::SLIT,
        };
        knob.set(self, value);
    }

    /// A hand turned the prism from an incidence by so many degrees.
    pub fn turn(&mut self, from_deg: Option<f64>, by_deg: f64) {
        let to = from_deg.unwrap_or(self.incidence_deg) + by_deg;
        Self::INCIDENCE.set(self, to);
        self.at_minimum = false;
    }
}

impl Default for PrismMemory {
    fn default() -> Self {
        Self {
            made_of: Substance::Shipped(BuiltinMaterial::NSf11),
            apex_deg: 60.0,
            at_minimum: true,
            minimum_nm: 546.075,
            incidence_deg: 60.0,
            slit_mm: 0.5,
            screen_mm: 500.0,
            stops: 0.0,
            beside: Beside::Bulb,
            sent: Sent::Measured,
        }
    }
}

impl PageState for PrismMemory {
    const KNOBS: &'static [Knob<Self>] = &[
        Self::APEX,
        Self::MINIMUM,
        Self::INCIDENCE,
        Self::SLIT,
        Self::SCREEN,
        Self::EXPOSURE,
    ];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("made_of", later!("the glass")),
        ("at_minimum", later!("how the prism stands")),
        ("beside", later!("the light beside it")),
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
    fn a_hand_moves_the_bench_as_far_as_the_sliders_reach() {
        let mut prism = PrismMemory::default();
        prism.set(Handle::Apex, 45.0);
        prism.set(Handle::Slit, -1.0);
        prism.set(Handle::Apex, f64::NAN);
        assert_eq!((prism.apex_deg, prism.slit_mm), (45.0, 0.02));
        assert!(prism.at_minimum);
        prism.turn(Some(50.0), 3.0);
        assert_eq!((prism.at_minimum, prism.incidence_deg), (false, 53.0));
        prism.turn(Some(50.0), 1e3);
        assert_eq!(prism.incidence_deg, 89.0);
    }
}
