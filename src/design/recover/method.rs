//! The ways from colours to a spectrum.

use std::fmt;

use serde::{Deserialize, Serialize};

/// A way from colours to a spectrum.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// The smoothest reflectance within 0-1, for one colour or two.
    #[default]
    Smoothest,
    /// The paper's three lowest Fourier coefficients (Eq. 18), for one colour.
    Fourier3,
    /// The six lowest, for the colours under two lights.
    Fourier6,
    /// A light of lines at given places over a background of known shape.
    Lines,
}

impl Method {
    /// Every method, the default first.
    pub const ALL: [Self; 4] = [Self::Smoothest, Self::Fourier3, Self::Fourier6, Self::Lines];

    /// The word used in JSON and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Smoothest => "smoothest",
            Self::Fourier3 => "fourier3",
            Self::Fourier6 => "fourier6",
            Self::Lines => "lines",
        }
    }

    /// The name that people read.
    pub(crate) fn title(self) -> &'static str {
        match self {
            Self::Smoothest => said!("smoothest within 0-1"),
            Self::Fourier3 => said!("three Fourier coefficients (Eq. 18)"),
            Self::Fourier6 => said!("six Fourier coefficients, two lights"),
            Self::Lines => said!("lines over a background"),
        }
    }

    /// The colours it takes, in words.
    pub(super) fn colours_words(self) -> &'static str {
        match self {
            Self::Smoothest => said!("a colour, or two under two lights"),
            Self::Fourier3 => said!("one colour"),
            Self::Fourier6 => said!("two colours under two lights"),
            Self::Lines => said!("at least one colour"),
        }
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.title())
    }
}
