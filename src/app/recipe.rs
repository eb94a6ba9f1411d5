//! How a spectrum is made from others: data that the document keeps and a workspace writes. What
//! it stands on is named by keys;
//! `make` makes it, again whenever one of those changes.

use serde::{Deserialize, Serialize};

use super::combining::act::Act;
use crate::{
    color::Srgb,
    design::{mixture::Source, recover::Method},
    languages::fixed,
    spectrum::Rect,
};

/// How a spectrum is made.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Recipe {
    /// A reflectance of the same colour as a patch under one light and another under a second.
    Metamer {
        /// Key of the light under which both match.
        light: String,
        /// Key of the light under which they part.
        other: String,
        /// The group of the patch.
        patch_set: String,
        /// Which of its reflectances, from 0.
        patch: usize,
        /// How much of the room within 0 to 1 is used, per cent.
        room_percent: i32,
    },
    /// The mean of pixels of a spectral image.
    Region {
        /// Key of the image.
        image: String,
        /// The pixels.
        rect: Rect,
    },
    /// What a chain of filters and surfaces leaves of a light.
    Through {
        /// Key of the light.
        light: String,
        /// Keys of what it meets, in that order.
        chain: Vec<(String, Times)>,
    },
    /// Channels mixed to a light.
    Mix {
        /// What each is made of, named lights by their keys, and its power.
        channels: Vec<(Source, f64)>,
        /// What stands before all of them.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        gels: Vec<Gel>,
    },
    /// A spectrum that has a colour.
    Colour {
        /// The colour.
        given: Given,
        /// Key of the light that it is seen under; for a light of lines, of the lamp whose smooth
        /// part stands behind them.
        light: String,
        /// How it is made.
        method: Method,
        /// Places of the lines of a light of lines, nm.
        #[serde(default)]
        lines: Vec<f64>,
        /// The same surface's colour under a second light, and that light's key.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        second: Option<(Given, String)>,
    },
    /// Measurements combined.
    Combined {
        /// What is done with them.
        act: Act,
        /// Their keys, in the order of their letters.
        parts: Vec<String>,
    },
}

/// What the entry of a key is called.
pub(super) type NameOf<'a> = &'a dyn Fn(&str) -> String;

/// A filter before a light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Gel {
    /// Its key in the library.
    pub key: String,
    /// Its thickness as a multiple of the measured one (Beer-Lambert).
    pub thickness: f64,
}

impl Gel {
    /// Its name and thickness: "CTO x 0.5".
    pub fn words(&self, name_of: NameOf<'_>) -> String {
        let name = name_of(&self.key);
        match self.thickness {
            1.0 => name,
            thickness => format!("{name} \u{d7} {}", fixed(thickness, 2)),
        }
    }
}

/// A colour as a person gives it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Given {
    /// As a screen shows it to an eye that is adapted to the light.
    Srgb([u8; 3]),
    /// X, Y and Z where the light has Y = 100.
    Xyz([f64; 3]),
    /// L*, a* and b* against the light.
    Lab([f64; 3]),
    /// x, y and Y where the light has Y = 100.
    Xyy([f64; 3]),
    /// That of a surface, by its key.
    Of(String),
}

impl Given {
    /// Key of the surface, where it is that of one.
    pub fn surface(&self) -> Option<&str> {
        match self {
            Self::Of(key) => Some(key),
            Self::Srgb(_) | Self::Xyz(_) | Self::Lab(_) | Self::Xyy(_) => None,
        }
    }

    /// The colour in words; of a surface its key.
    pub fn words(&self) -> String {
        match self {
            Self::Srgb(rgb) => Srgb(*rgb).hex(),
            Self::Xyz([x, y, z]) => {
                format!("XYZ {}, {}, {}", fixed(x, 1), fixed(y, 1), fixed(z, 1))
            }
            Self::Lab([l, a, b]) => {
                format!("L*a*b* {}, {}, {}", fixed(l, 1), fixed(a, 1), fixed(b, 1))
            }
            Self::Xyy([x, y, whole]) => {
                format!("xyY {}, {}, {}", fixed(x, 4), fixed(y, 4), fixed(whole, 1))
            }
            Self::Of(key) => key.clone(),
        }
    }
}

impl Recipe {
    /// Keys of all that it stands on.
    pub fn stands_on(&self) -> Vec<&str> {
        match self {
            Self::Metamer { light, other, .. } => vec![light, other],
            Self::Region { image, .. } => vec![image],
            Self::Combined { parts, .. } => parts.iter().map(String::as_str).collect(),
            Self::Through { light, chain } => std::iter::once(light.as_str())
                .chain(chain.iter().map(|(key, _)| key.as_str()))
                .collect(),
            Self::Mix { channels, gels } => {
                let sources = channels.iter().map(|(source, _)| source);
                let keys = sources.filter_map(|source| match source {
                    Source::Named(key) => Some(key.as_str()),
                    _ => None,
                });
                keys.chain(gels.iter().map(|gel| gel.key.as_str()))
                    .collect()
            }
            Self::Colour {
                given,
                light,
                second,
                ..
            } => {
                let mut all = vec![light.as_str()];
                all.extend(given.surface());
                if let Some((given, light)) = second {
                    all.push(light);
                    all.extend(given.surface());
                }
                all
            }
        }
    }

    /// The light that it is made with; `None` where there is none.
    pub fn light(&self) -> Option<&str> {
        match self {
            Self::Metamer { light, .. }
            | Self::Through { light, .. }
            | Self::Colour { light, .. } => Some(light),
            Self::Region { .. } | Self::Mix { .. } | Self::Combined { .. } => None,
        }
    }

    /// The same with another light.
    #[must_use]
    pub fn with_light(mut self, key: &str) -> Self {
        match &mut self {
            Self::Metamer { light, .. }
            | Self::Through { light, .. }
            | Self::Colour { light, .. } => key.clone_into(light),
            Self::Region { .. } | Self::Mix { .. } | Self::Combined { .. } => {}
        }
        self
    }
}

/// How a light meets one factor of a chain.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Times {
    /// Thickness as a multiple of the measured one (Beer-Lambert); 1 is as measured.
    pub thickness: f64,
    /// How many times in a row it is met.
    pub bounces: u32,
}

impl Default for Times {
    fn default() -> Self {
        Self {
            thickness: 1.0,
            bounces: 1,
        }
    }
}
