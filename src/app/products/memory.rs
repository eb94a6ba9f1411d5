//! What the page `Products` remembers beside the document; not part of undo.

use serde::{Deserialize, Serialize};

use crate::{app::settings::within, spectrum::Sampling};

/// What the page remembers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ProductsMemory {
    /// Chain: the stage whose spectrum is drawn; beyond the last, what comes out.
    pub chain: ChainMemory,
    #[serde(rename = "forming")]
    pub resampling: ResamplingMemory,
    pub bounces: BouncesMemory,
    /// Narrow filters.
    pub narrow: NarrowMemory,
    #[serde(rename = "lights")]
    pub two_lights: TwoLightsMemory,
    #[serde(rename = "check")]
    pub same_surface: SameSurfaceMemory,
    pub absorption: AbsorptionMemory,
}

impl ProductsMemory {
    /// Every value moved to the nearest one that is allowed.
    #[must_use]
    pub fn clamped(self) -> Self {
        Self {
            resampling: self.resampling.clamped(),
            narrow: self.narrow.clamped(),
            two_lights: self.two_lights.clamped(),
            ..self
        }
    }
}

/// What the chain remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct ChainMemory {
    /// The stage that is drawn, 0 the first factor; `None` for the last.
    pub stage: Option<usize>,
    /// The light before any factor is drawn, whatever stage is remembered.
    pub light: bool,
}

/// What the resampling bench remembers.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ResamplingMemory {
    /// Ways whose curves are not drawn.
    pub hidden: Vec<Sampling>,
}

impl ResamplingMemory {
    /// Shows or hides a way's curve.
    pub fn show(&mut self, way: Sampling, shown: bool) {
        self.hidden.retain(|one| *one != way);
        if !shown {
            self.hidden.push(way);
        }
        // In the order that they are kept in.
        *self = std::mem::take(self).clamped();
    }

    fn clamped(mut self) -> Self {
        self.hidden = Sampling::ALL
            .into_iter()
            .filter(|way| self.hidden.contains(way))
            .collect();
        self
    }
}

/// What the bounces remember.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct BouncesMemory {
    /// Whether only what forming the products adds is told.
    pub added: bool,
    /// Whether the vertical axis is logarithmic.
    pub log: bool,
}

impl Default for BouncesMemory {
    fn default() -> Self {
        Self {
            added: false,
            log: true,
        }
    }
}

/// What the narrow band-pass remembers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct NarrowMemory {
    /// Centre of the band-pass, nm.
    pub centre_nm: f64,
    /// Its full width at half maximum, nm.
    pub width_nm: f64,
    /// The key of a real filter that stands in the band-pass's place; `None` for the Gaussian.
    pub filter: Option<String>,
    /// Whether errors of luminance are drawn instead of those of colour.
    pub luminance: bool,
}

impl Default for NarrowMemory {
    fn default() -> Self {
        Self {
            centre_nm: 546.0,
            width_nm: 10.0,
            filter: None,
            luminance: false,
        }
    }
}

/// Centres of the band-pass, nm.
pub(super) const CENTRES_NM: std::ops::RangeInclusive<f64> = 200.0..=20_000.0;
/// Full widths of the band-pass at half its maximum, nm.
pub const PASS_WIDTHS_NM: std::ops::RangeInclusive<f64> = 2.0..=100.0;

impl NarrowMemory {
    fn clamped(self) -> Self {
        let usual = Self::default();
        Self {
            centre_nm: within(self.centre_nm, CENTRES_NM, usual.centre_nm),
            width_nm: within(self.width_nm, PASS_WIDTHS_NM, usual.width_nm),
            ..self
        }
    }
}

/// What the comparison of two lights remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct TwoLightsMemory {
    /// The patch whose metamer is made.
    pub patch: usize,
    /// The pair that is drawn.
    pub pair: usize,
    /// A metamer is made for a patch; else pairs are looked for.
    pub makes: bool,
    /// Pairs are looked for among all shipped reflectances, not the patches alone.
    pub everywhere: bool,
    /// Part of the room that the metameric black takes, percent; below 0 the other way.
    pub room_percent: i32,
}

impl Default for TwoLightsMemory {
    fn default() -> Self {
        Self {
            patch: 0,
            pair: 0,
            makes: false,
            everywhere: true,
            room_percent: *ROOM_PERCENT.end(),
        }
    }
}

/// Parts of the room that may be asked for, percent.
pub const ROOM_PERCENT: std::ops::RangeInclusive<i32> = -100..=100;

impl TwoLightsMemory {
    fn clamped(self) -> Self {
        Self {
            room_percent: self
                .room_percent
                .clamp(*ROOM_PERCENT.start(), *ROOM_PERCENT.end()),
            ..self
        }
    }
}

/// What the check remembers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct SameSurfaceMemory {
    /// The best surface is looked for among all shipped reflectances, not the patches alone.
    pub everywhere: bool,
    /// The example's light meets its surface twice.
    pub twice: bool,
}

impl Default for SameSurfaceMemory {
    fn default() -> Self {
        Self {
            everywhere: true,
            twice: false,
        }
    }
}

/// What the absorption part remembers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct AbsorptionMemory {
    /// The example that is shown.
    pub example: usize,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_band_pass_of_no_width_becomes_one_that_can_be_seen() {
        let nonsense = ProductsMemory {
            narrow: NarrowMemory {
                centre_nm: f64::NAN,
                width_nm: -1.0,
                ..NarrowMemory::default()
            },
            resampling: ResamplingMemory {
                hidden: vec![Sampling::Exact, Sampling::Paper, Sampling::Exact],
            },
            ..ProductsMemory::default()
        };
        let sound = nonsense.clamped();
        assert_eq!(sound.resampling.hidden, [Sampling::Paper, Sampling::Exact]);
        let sound = sound.narrow;
        assert_eq!((sound.centre_nm, sound.width_nm), (546.0, 2.0));
    }
}
