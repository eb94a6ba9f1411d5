//! The page "From a colour": what is asked about.

use serde::{Deserialize, Serialize};

use super::{Page, Place, Row, row, states::PageState};
use crate::{
    app::{design::Telling, recipe::Given},
    design::recover::Method,
};

pub(super) const ROW: Row = row(
    Page::FromColour,
    Place::Design,
    (later!("From a colour"), "from-colour"),
    "recover",
    later!("Which spectra have this colour?"),
);

/// Lights that a recovered surface is looked at under, by their keys.
pub const UNDER: [&str; 6] = [
    "cie_illuminants/CIE D65",
    "cie_illuminants/CIE A",
    "cie_fluorescent_1nm/FL2",
    "cie_fluorescent_1nm/FL11",
    "cie_led_1nm/LED-B3",
    "cie_led_1nm/LED-RGB1",
];

/// Lines of mercury, where none are told.
pub const MERCURY_NM: [f64; 4] = [405.0, 436.0, 546.0, 578.0];

/// What the page asks about.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct FromColour {
    /// The colour.
    pub given: Given,
    /// Key of the light that it is seen under.
    pub light: String,
    /// What is taken to the library.
    pub method: Method,
    /// Places of the lines of a light of lines, nm.
    pub lines: Vec<f64>,
    /// Key of the lamp whose smooth part stands behind them.
    pub lamp: String,
    /// The same surface's colour under a second light, and that light's key.
    pub second: Option<(Given, String)>,
    /// The way that colours are told on the page.
    pub telling: Telling,
}

impl Default for FromColour {
    fn default() -> Self {
        Self {
            given: Given::Srgb([0xc0, 0x80, 0x40]),
            light: UNDER[0].to_owned(),
            method: Method::Smoothest,
            lines: MERCURY_NM.to_vec(),
            lamp: UNDER[2].to_owned(),
            second: None,
            telling: Telling::Srgb,
        }
    }
}

impl PageState for FromColour {
    const NAMES: &'static [(&'static str, &'static str)] = &[
        ("given", later!("the colour")),
        ("light", later!("the light that it is seen under")),
        ("method", later!("the way")),
        ("lines", later!("the lines")),
        ("lamp", later!("the lamp behind the lines")),
        ("second", later!("the second colour")),
        ("telling", later!("how the colour is told")),
    ];

    fn settle(&mut self) {
        self.given.settle();
        if let Some((given, _)) = &mut self.second {
            given.settle();
        }
        self.lines.retain(|nm| nm.is_finite());
        self.lines.truncate(12);
        // As many coefficients as there are numbers.
        if let Method::Fourier3 | Method::Fourier6 = self.method {
            self.method = self.coefficients();
        }
    }
}

impl FromColour {
    /// The paper's way for one colour, or for two.
    pub(in crate::app) fn coefficients(&self) -> Method {
        match self.second {
            None => Method::Fourier3,
            Some(_) => Method::Fourier6,
        }
    }
}
