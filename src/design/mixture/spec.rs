//! A channel in words.
//!
//! ```text
//! line:546.1        a line without width, nm
//! gauss:450,20      a Gaussian LED: centre and full width at half height, nm
//! blackbody:2700    a blackbody, K
//! daylight:6500     daylight, 4000-25000 K
//! NAME              any light or file
//! ...=WEIGHT        the same with its power fixed
//! ```

use std::{fmt, str::FromStr};

use serde::{Deserialize, Serialize};

use super::error::MixError;
use crate::{
    color::xyz::{FIRST_NM, LAST_NM},
    design::whole_nm::DAYLIGHT_K,
};

/// Coldest and hottest blackbody that is mixed, K.
const BLACKBODY_K: [f64; 2] = [500.0, 100_000.0];

/// Narrowest and widest Gaussian, nm: below 1 nm a sum over whole nm sees no Gaussian.
const WIDTHS_NM: [f64; 2] = [1.0, 400.0];

/// Greatest weight: beside it the least is still a share that can be told.
const MOST_WEIGHT: f64 = 1e9;

/// The source of a channel's light.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Source {
    /// A line without width.
    Line {
        /// Its place.
        at_nm: f64,
    },
    /// A Gaussian LED.
    Gauss {
        /// Its centre.
        centre_nm: f64,
        /// Full width at half height.
        fwhm_nm: f64,
    },
    /// A blackbody.
    Blackbody {
        /// Its temperature.
        kelvin: f64,
    },
    /// Daylight by its components.
    Daylight {
        /// Its temperature.
        kelvin: f64,
    },
    /// A light or a file by its name; whoever knows names brings its table.
    Named(String),
}

/// A channel in words, taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// The words, without the weight.
    pub words: String,
    /// The source of its light.
    pub source: Source,
    /// Its power where that is fixed.
    pub fixed: Option<f64>,
}

impl Source {
    /// The words that it is read from.
    pub fn words(&self) -> String {
        match self {
            Self::Line { at_nm } => format!("line:{at_nm}"),
            Self::Gauss { centre_nm, fwhm_nm } => format!("gauss:{centre_nm},{fwhm_nm}"),
            Self::Blackbody { kelvin } => format!("blackbody:{kelvin}"),
            Self::Daylight { kelvin } => format!("daylight:{kelvin}"),
            Self::Named(name) => name.clone(),
        }
    }

    /// Its numbers, what each is in words, and the least and the greatest that it may be.
    fn numbers(&mut self) -> Vec<(&mut f64, &'static str, [f64; 2])> {
        let visible = [f64::from(FIRST_NM), f64::from(LAST_NM)];
        match self {
            Self::Line { at_nm } => vec![(at_nm, "a place in nm", visible)],
            Self::Gauss { centre_nm, fwhm_nm } => vec![
                (centre_nm, "a centre in nm", visible),
                (fwhm_nm, "a full width at half height in nm", WIDTHS_NM),
            ],
            Self::Blackbody { kelvin } => vec![(kelvin, "a temperature in K", BLACKBODY_K)],
            Self::Daylight { kelvin } => vec![(kelvin, "a temperature in K", DAYLIGHT_K)],
            Self::Named(_) => Vec::new(),
        }
    }

    /// Every number moved to the nearest one that is allowed; what is no number to the lowest.
    #[must_use]
    pub(crate) fn clamped(mut self) -> Self {
        for (value, _, [least, most]) in self.numbers() {
            *value = value.max(least).min(most);
        }
        self
    }
}

impl Spec {
    /// A channel of what it is made of, its power not fixed.
    pub(crate) fn of(source: Source) -> Self {
        Self {
            words: source.words(),
            source,
            fixed: None,
        }
    }

    /// A channel of a name that is taken as it stands, with any signs in it (a file).
    pub(crate) fn named(name: &str) -> Self {
        Self {
            words: name.to_owned(),
            source: Source::Named(name.to_owned()),
            fixed: None,
        }
    }
}

impl fmt::Display for Spec {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.fixed {
            Some(weight) => write!(f, "{}={weight}", self.words),
            None => f.write_str(&self.words),
        }
    }
}

impl FromStr for Spec {
    type Err = MixError;

    fn from_str(text: &str) -> Result<Self, MixError> {
        let text = text.trim();
        let refused = |expected: String| MixError::Spec {
            found: text.to_owned(),
            expected,
        };
        // A name may hold the sign too: only a number behind the last one is a weight.
        let (words, fixed) = match text.rsplit_once('=') {
            Some((words, weight)) => match weight.trim().parse::<f64>() {
                Ok(weight) if (0.0..=MOST_WEIGHT).contains(&weight) => (words.trim(), Some(weight)),
                Ok(_) => {
                    let weights = format!("a weight of 0 to {MOST_WEIGHT} behind =");
                    return Err(refused(weights));
                }
                Err(_) => (text, None),
            },
            None => (text, None),
        };
        if words.is_empty() {
            let forms = "line:NM, gauss:NM,WIDTH, blackbody:K, daylight:K or a light";
            return Err(refused(forms.to_owned()));
        }
        let (mut source, numbers) = match words.split_once(':') {
            Some(("line", place)) => (Source::Line { at_nm: 0.0 }, place),
            Some(("gauss", numbers)) => {
                let (centre_nm, fwhm_nm) = (0.0, 0.0);
                (Source::Gauss { centre_nm, fwhm_nm }, numbers)
            }
            Some(("blackbody", kelvin)) => (Source::Blackbody { kelvin: 0.0 }, kelvin),
            Some(("daylight", kelvin)) => (Source::Daylight { kelvin: 0.0 }, kelvin),
            _ => (Source::Named(words.to_owned()), ""),
        };
        let places = source.numbers();
        let texts: Vec<&str> = numbers.splitn(places.len(), ',').collect();
        if texts.len() < places.len() {
            return Err(refused("gauss:CENTRE,WIDTH in nm".to_owned()));
        }
        for ((value, what, [least, most]), text) in places.into_iter().zip(texts) {
            let found = text.trim().parse::<f64>().ok();
            let found = found.filter(|v| (least..=most).contains(v));
            *value = found.ok_or_else(|| refused(format!("{what} of {least} to {most}")))?;
        }
        Ok(Self {
            words: words.to_owned(),
            source,
            fixed,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(text: &str) -> Source {
        text.parse::<Spec>().unwrap().source
    }

    #[test]
    fn every_form_is_read_and_written_back() {
        assert_eq!(source("line:546.1"), Source::Line { at_nm: 546.1 });
        assert_eq!(
            source("gauss:450,20"),
            Source::Gauss {
                centre_nm: 450.0,
                fwhm_nm: 20.0
            }
        );
        assert_eq!(
            source("blackbody:2700"),
            Source::Blackbody { kelvin: 2700.0 }
        );
        assert_eq!(
            source("daylight:6500=2"),
            Source::Daylight { kelvin: 6500.0 }
        );
        assert_eq!(source("CIE D65"), Source::Named("CIE D65".to_owned()));
        for words in [
            "line:546.1",
            "gauss:450,20",
            "blackbody:2700",
            "daylight:6500",
        ] {
            assert_eq!(Spec::of(source(words)), words.parse().unwrap());
        }
        let fixed: Spec = "gauss:450,20=0.5".parse().unwrap();
        assert_eq!(fixed.fixed, Some(0.5));
        assert_eq!(fixed.to_string(), "gauss:450,20=0.5");
    }

    #[test]
    fn a_name_may_hold_the_signs_and_numbers_must_make_sense() {
        assert_eq!(
            source("C:\\a=b.csv"),
            Source::Named("C:\\a=b.csv".to_owned())
        );
        for wrong in [
            "",
            "=1",
            "line:",
            "line:2000",
            "line:nan",
            "gauss:450",
            "gauss:450,0",
            "blackbody:0",
            "daylight:3000",
            "line:500=-1",
            "line:500=inf",
            "line:500=1e308",
        ] {
            assert!(wrong.parse::<Spec>().is_err(), "{wrong:?}");
        }
        assert_eq!(
            "line:2000".parse::<Spec>().unwrap_err().to_string(),
            "channel: expected a place in nm of 360 to 830, found \"line:2000\""
        );
    }
}
