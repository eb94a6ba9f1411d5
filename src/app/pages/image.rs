//! What the page "Spectral image" keeps.

use serde::{Deserialize, Serialize};

use super::{
    Page, Place, Row,
    knob::{Knob, Reach, knob},
    prism::EXPOSED,
    row,
    states::PageState,
};
use crate::spectrum::{Cube, Rect};

pub(super) const ROW: Row = row(
    Page::Image,
    Place::Picture,
    (later!("Spectral image"), "image"),
    "recover",
    later!("A spectral image: a pixel or a region's mean becomes a spectrum."),
);

pub(super) const PHOTOGRAPH: Row = row(
    Page::Photograph,
    Place::Picture,
    (later!("Photograph"), "photograph"),
    "room",
    later!("A photograph of a spectrum: the lines of a lamp fix its wavelengths."),
);

/// How the bands of an image become colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Show {
    /// XYZ of every pixel by the document's observer.
    #[default]
    TrueColour,
    /// A band each for red, green and blue.
    ThreeBands,
    /// One band in grey.
    OneBand,
}

impl Show {
    /// Every choice, in the order of the menu.
    pub const ALL: [Self; 3] = [Self::TrueColour, Self::ThreeBands, Self::OneBand];

    /// In words for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::TrueColour => said!("true colour"),
            Self::ThreeBands => said!("three bands"),
            Self::OneBand => said!("one band"),
        }
    }

    /// What it means, a sentence.
    pub fn meaning(self) -> &'static str {
        match self {
            Self::TrueColour => {
                said!(
                    "X, Y and Z of every pixel by the observer in force, brought to sRGB. A \
                 reflectance is looked at under the document's light."
                )
            }
            Self::ThreeBands => {
                said!(
                    "A band each for red, green and blue, each scaled by its own 99th percentile: \
                 false colours."
                )
            }
            Self::OneBand => said!("One band in grey, scaled by its 99th percentile."),
        }
    }
}

/// What is drawn about the mean of a region.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Spread {
    /// One standard deviation to both sides.
    #[default]
    Deviation,
    /// From the smallest to the largest value.
    Extremes,
}

/// Image, place and looks.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ImageMemory {
    /// Key of the image shown; `None` for the one opened last.
    pub key: Option<String>,
    /// The chosen pixel or region; `None` for the whole image.
    pub selection: Option<Rect>,
    /// How bands become colours.
    pub show: Show,
    /// Wavelengths of the bands shown as red, green and blue, nm: the nearest bands are taken.
    pub three_nm: [f64; 3],
    /// Wavelength of the band shown in grey, nm.
    pub one_nm: f64,
    /// Exposure over that of the 99th percentile, stops.
    pub stops: f64,
    /// What is drawn about the mean of a region.
    pub spread: Spread,
}

impl Default for ImageMemory {
    fn default() -> Self {
        Self {
            key: None,
            selection: None,
            show: Show::TrueColour,
            three_nm: [640.0, 550.0, 460.0],
            one_nm: 550.0,
            stops: 0.0,
            spread: Spread::Deviation,
        }
    }
}

/// Wavelengths of bands that can be asked for, nm.
const BAND_NM: Reach = Reach::Within(100.0, 100_000.0);

impl PageState for ImageMemory {
    const KNOBS: &'static [Knob<Self>] = &[
        knob!(three_nm[0]: later!("Red"), BAND_NM, 1 " nm", BANDS),
        knob!(three_nm[1]: later!("Green"), BAND_NM, 1 " nm", BANDS),
        knob!(three_nm[2]: later!("Blue"), BAND_NM, 1 " nm", BANDS),
        knob!(one_nm: later!("Band"), BAND_NM, 1 " nm", BANDS),
        Self::EXPOSURE,
    ];

    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("key", later!("the image")),
        ("selection", later!("the pixels chosen")),
        ("show", later!("how bands become colours")),
        ("spread", later!("the spread drawn")),
    ];
}

const BANDS: &str = later!("The nearest band is shown.");

impl ImageMemory {
    pub const EXPOSURE: Knob<Self> =
        knob!(stops: later!("Exposure"), Reach::Within(-8.0, 8.0), 1 later!(" stops"), EXPOSED);

    /// Another image: a place of the last one is none in this.
    pub fn choose(&mut self, key: &str) {
        if self.key.as_deref() != Some(key) {
            self.key = Some(key.to_owned());
            self.selection = None;
        }
    }

    /// The chosen pixels of an image: the whole of it where the selection does not fit.
    pub fn rect(&self, cube: &Cube) -> Rect {
        let fits = |rect: &Rect| rect.is_inside(cube.all());
        self.selection.filter(fits).unwrap_or_else(|| cube.all())
    }

    /// The bands whose numbers become red, green and blue, or grey; `None` for true colour.
    pub fn bands(&self, cube: &Cube) -> Option<Vec<usize>> {
        match self.show {
            Show::TrueColour => None,
            Show::ThreeBands => Some(self.three_nm.map(|nm| cube.nearest_band(nm)).to_vec()),
            Show::OneBand => Some(vec![cube.nearest_band(self.one_nm)]),
        }
    }
}
