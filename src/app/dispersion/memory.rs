//! What the three pages remember; not part of undo.

use serde::{Deserialize, Serialize};

use super::{
    gem_memory::GemMemory,
    ranges::{clamped_stops, ends, moved},
    sent::Sent,
    substance::Substance,
};
use crate::optics::{BuiltinMaterial, SEEN_NM};

/// Apex angles of the prism that the slider reaches, degrees.
pub const APEXES_DEG: std::ops::RangeInclusive<f64> = 5.0..=90.0;

/// Angles of incidence that the slider reaches, degrees from the normal.
pub const INCIDENCES_DEG: std::ops::RangeInclusive<f64> = -20.0..=89.0;

/// Widths of the slit that the slider reaches, mm.
pub const SLITS_MM: std::ops::RangeInclusive<f64> = 0.02..=30.0;

/// Distances of the screen that the slider reaches, mm.
pub const SCREENS_MM: std::ops::RangeInclusive<f64> = 50.0..=2000.0;

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
            Self::Overlaid => "the light compared with it",
        }
    }
}

/// The prism's page.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PrismMemory {
    /// The glass.
    #[serde(alias = "stuff")]
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
            Self::Apex => "Apex angle",
            Self::Slit => "Slit",
        }
    }
}

impl PrismMemory {
    /// A hand moved a handle: degrees of the apex, mm of the slit, as far as the sliders reach.
    pub fn set(&mut self, handle: Handle, value: f64) {
        let (to, range) = match handle {
            Handle::Apex => (&mut self.apex_deg, APEXES_DEG),
            Handle::Slit => (&mut self.slit_mm, SLITS_MM),
        };
        *to = moved(value, ends(range), *to);
    }

    /// A hand turned the prism from an incidence by so many degrees.
    pub fn turn(&mut self, from_deg: Option<f64>, by_deg: f64) {
        let to = from_deg.unwrap_or(self.incidence_deg) + by_deg;
        self.incidence_deg = moved(to, ends(INCIDENCES_DEG), self.incidence_deg);
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

/// The rainbow's page.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RainbowMemory {
    /// The source is as wide as the sun's disc; else it is a point.
    pub disc: bool,
    /// Where the drawn rays meet the drop, radii off its middle.
    pub impact: f64,
    /// The drawn rays are reflected twice in the drop; else once.
    pub twice: bool,
    /// Exposure, stops.
    pub stops: f64,
    /// The second strip.
    pub beside: Beside,
    /// What of the light is sent through.
    pub sent: Sent,
}

/// Where rays of green light meet the drop that make the first and the second bow, radii.
const BOW_IMPACTS: [f64; 2] = [0.86, 0.95];

/// Where rays may meet the drop, radii off its middle.
pub const IMPACTS: std::ops::RangeInclusive<f64> = 0.0..=0.995;

impl RainbowMemory {
    /// Draws the rays of one of the two bows, from where they meet the drop.
    pub fn look_at(&mut self, twice: bool) {
        self.twice = twice;
        self.impact = BOW_IMPACTS[usize::from(twice)];
    }
}

impl Default for RainbowMemory {
    fn default() -> Self {
        Self {
            disc: true,
            impact: BOW_IMPACTS[0],
            twice: false,
            stops: 0.0,
            beside: Beside::Sun,
            sent: Sent::Measured,
        }
    }
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

impl DispersionMemory {
    /// A second light that was chosen stands beside the light in prism and rainbow too; where it is
    /// let go of, what stood there at first.
    pub fn follow_second(&mut self, is_there: bool) {
        let usual = Self::default();
        let both = [
            (&mut self.prism.beside, usual.prism.beside),
            (&mut self.rainbow.beside, usual.rainbow.beside),
        ];
        for (beside, usual) in both {
            match (is_there, *beside) {
                (true, _) => *beside = Beside::Overlaid,
                (false, Beside::Overlaid) => *beside = usual,
                (false, _) => {}
            }
        }
    }

    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        let usual = Self::default();
        let prism = PrismMemory {
            apex_deg: moved(self.prism.apex_deg, ends(APEXES_DEG), usual.prism.apex_deg),
            incidence_deg: moved(
                self.prism.incidence_deg,
                ends(INCIDENCES_DEG),
                usual.prism.incidence_deg,
            ),
            slit_mm: moved(self.prism.slit_mm, ends(SLITS_MM), usual.prism.slit_mm),
            screen_mm: moved(
                self.prism.screen_mm,
                ends(SCREENS_MM),
                usual.prism.screen_mm,
            ),
            minimum_nm: moved(self.prism.minimum_nm, SEEN_NM, usual.prism.minimum_nm),
            made_of: self.prism.made_of.clamped(),
            stops: clamped_stops(self.prism.stops),
            ..self.prism
        };
        let rainbow = RainbowMemory {
            stops: clamped_stops(self.rainbow.stops),
            impact: moved(self.rainbow.impact, ends(IMPACTS), usual.rainbow.impact),
            ..self.rainbow
        };
        Self {
            prism,
            rainbow,
            gem: self.gem.clamped(),
        }
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
        let found = (prism.apex_deg, prism.slit_mm);
        assert_eq!(found, (45.0, *SLITS_MM.start()));
        assert!(prism.at_minimum);
        prism.turn(Some(50.0), 3.0);
        assert_eq!((prism.at_minimum, prism.incidence_deg), (false, 53.0));
        prism.turn(Some(50.0), 1e3);
        assert_eq!(prism.incidence_deg, *INCIDENCES_DEG.end());
    }

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
        assert_eq!(sound.gem.cut.pavilion_deg, 55.0);
        assert_eq!((sound.gem.size, sound.gem.rays), (240, 256));
        assert_eq!(sound.gem.height_deg, GemMemory::default().height_deg);
        let usual = DispersionMemory::default();
        assert_eq!(usual.clone().clamped(), usual);
    }
}
