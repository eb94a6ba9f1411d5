//! The one scale switch: in what unit a light's values are shown and exported.

use serde::{Deserialize, Serialize};

pub(super) use crate::color::quality::LUMENS_PER_WATT;
use crate::{
    color::Observer,
    spectrum::{Kind, NamedSpectrum},
};

/// How a light's numbers are shown; reflectances are always shown as measured.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scale {
    /// The file's unit.
    #[default]
    AsMeasured,
    /// Largest value 1.
    PeakOne,
    /// Tristimulus Y of 100 (plain 1 nm sum over 360-830 nm, CIE 1931).
    LuminanceHundred,
    /// An illuminance of 100 lx, when the values are W m-2 nm-1.
    HundredLux,
    /// One watt over the table's range.
    OneWatt,
}

impl Scale {
    /// Every choice, as the switch lists them.
    pub const ALL: [Self; 5] = [
        Self::AsMeasured,
        Self::PeakOne,
        Self::LuminanceHundred,
        Self::HundredLux,
        Self::OneWatt,
    ];

    /// Short words for the switch and for exports.
    pub fn words(self) -> &'static str {
        match self {
            Self::AsMeasured => said!("as measured"),
            Self::PeakOne => said!("peak 1"),
            Self::LuminanceHundred => "Y 100",
            Self::HundredLux => "100 lx",
            Self::OneWatt => "1 W",
        }
    }

    /// What the choice means, in a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::AsMeasured => said!("The numbers of the file, in its own unit."),
            Self::PeakOne => said!("The largest value of the table becomes 1."),
            Self::LuminanceHundred => {
                said!("The sum with the CIE 1931 y-bar over 360-830 nm becomes 100.")
            }
            Self::HundredLux => {
                said!("The values become W m⁻² nm⁻¹ of an illuminance of 100 lx (683 lm/W).")
            }
            Self::OneWatt => {
                said!("The integral over the table becomes 1 W; the values are W nm⁻¹.")
            }
        }
    }

    /// The factor that takes a spectrum's own numbers to this scale; `None` where it has none
    /// (no power, nothing visible, or not a light).
    pub fn factor(self, spectrum: &NamedSpectrum) -> Option<f64> {
        if spectrum.kind != Kind::Light {
            return (self == Self::AsMeasured).then_some(1.0);
        }
        let samples = &spectrum.samples;
        let luminance = || -> f64 {
            let table = Observer::CIE_1931.table();
            let values = samples.on_whole_nm(360, 830, Kind::Light.outside());
            let values = values.iter().enumerate();
            let weighed = values.map(|(i, v)| v * table.at(360.0 + i as f64)[1]);
            weighed.sum()
        };
        let factor = match self {
            Self::AsMeasured => 1.0,
            Self::PeakOne => 1.0 / samples.values().iter().copied().fold(0.0, f64::max),
            Self::LuminanceHundred => 100.0 / luminance(),
            Self::HundredLux => 100.0 / (LUMENS_PER_WATT * luminance()),
            Self::OneWatt => {
                let power: f64 = samples
                    .nm()
                    .windows(2)
                    .zip(samples.values().windows(2))
                    .map(|(w, v)| 0.5 * (w[1] - w[0]) * (v[0] + v[1]))
                    .sum();
                1.0 / power
            }
        };
        (factor.is_finite() && factor > 0.0).then_some(factor)
    }

    /// The unit that values have under this scale.
    pub fn unit(self, spectrum: &NamedSpectrum) -> String {
        if self.factor(spectrum).is_none() {
            return spectrum.unit.clone();
        }
        match self {
            Self::AsMeasured => spectrum.unit.clone(),
            Self::PeakOne => said!("share of the peak").to_owned(),
            Self::LuminanceHundred => "Y = 100".to_owned(),
            Self::HundredLux => said!("W m⁻² nm⁻¹ at 100 lx").to_owned(),
            Self::OneWatt => said!("W nm⁻¹ of 1 W").to_owned(),
        }
    }
}
