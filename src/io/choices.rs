//! The user's decisions where a file leaves a choice open, or was misread: a file is read again
//! with these.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::io::Dialect;
use crate::io::text::dialect::Delimiter;
use crate::io::text::units::WavelengthUnit;
use crate::spectrum::Kind;

/// Decisions about one file; what is `None` the reader decides.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Choices {
    /// The separator of cells and the decimal mark, in plain columns.
    #[serde(skip)]
    pub dialect: Option<Dialect>,
    /// The separator of cells, in plain columns, where the decimal mark is left to the reader.
    #[serde(skip)]
    pub delimiter: Option<Delimiter>,
    /// The column of wavelengths, from 0, in plain columns.
    #[serde(skip)]
    pub axis_column: Option<usize>,
    /// The unit of the wavelength axis.
    pub wavelengths: Option<WavelengthUnit>,
    /// The laser that Raman shifts count from, nm.
    #[serde(skip)]
    pub laser_nm: Option<f64>,
    /// The kind of the values of every spectrum and image.
    pub kind: Option<Kind>,
    /// The scale of the values of every factor.
    pub counted: Option<Counted>,
    /// The decisions about one spectrum alone, by its place in the file from 0.
    #[serde(skip)]
    pub each: BTreeMap<usize, OfOne>,
    /// The decisions about one image alone, by its place in the file from 0.
    pub each_image: BTreeMap<usize, OfOne>,
    /// True if a light's photon counts are kept. Readers never touch them; unless this is set,
    /// opening a file for its light converts them to power.
    #[serde(skip)]
    pub keep_photons: bool,
    /// True if a column called sd, std, sigma, u or the like is the standard deviation of the one
    /// before it. Readers never ask.
    #[serde(skip)]
    pub take_sigma: bool,
}

/// Decisions about one spectrum or image of several.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct OfOne {
    /// The kind of its values.
    pub kind: Option<Kind>,
    /// The scale of its values.
    pub counted: Option<Counted>,
}

/// The scale of the values of a reflectance or transmittance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Counted {
    /// 1 is all of the light: the values as they are.
    Fraction,
    /// 100 is all of the light.
    Percent,
    /// 10 000 is all of the light, as remote sensing stores it.
    TenThousandths,
    /// 65 535 is all of the light, the largest whole number of 16 bits.
    SixteenBits,
    /// 255 is all of the light, the largest whole number of 8 bits.
    EightBits,
    /// Another number is, which the file states.
    Otherwise,
}

impl Counted {
    /// Those that a person may choose.
    pub const OFFERED: [Self; 5] = [
        Self::Fraction,
        Self::Percent,
        Self::TenThousandths,
        Self::SixteenBits,
        Self::EightBits,
    ];

    /// Per cent or fraction.
    pub fn percent(is_percent: bool) -> Self {
        match is_percent {
            true => Self::Percent,
            false => Self::Fraction,
        }
    }

    /// The scale that corresponds to a factor from the file's numbers to fractions.
    pub(crate) fn of_scale(scale: f64) -> Self {
        let is = |other: f64| (scale - other).abs() <= 1e-9 * other;
        let mut offered = Self::OFFERED.into_iter();
        let found = offered.find(|counted| counted.scale().is_some_and(is));
        found.unwrap_or(Self::Otherwise)
    }

    /// The factor to fractions; `None` where only the file knows it.
    pub fn scale(self) -> Option<f64> {
        match self {
            Self::Fraction => Some(1.0),
            Self::Percent => Some(0.01),
            Self::TenThousandths => Some(1e-4),
            Self::SixteenBits => Some(1.0 / 65_535.0),
            Self::EightBits => Some(1.0 / 255.0),
            Self::Otherwise => None,
        }
    }

    /// In a word or two.
    pub fn word(self) -> &'static str {
        match self {
            Self::Fraction => later!("fraction"),
            Self::Percent => later!("percent"),
            Self::TenThousandths => later!("fraction x 10000"),
            Self::SixteenBits => later!("fraction x 65535"),
            Self::EightBits => later!("fraction x 255"),
            Self::Otherwise => later!("as the file states"),
        }
    }
}

impl Choices {
    /// The chosen kind of one spectrum's values.
    pub(crate) fn kind_of(&self, spectrum: usize) -> Option<Kind> {
        let own = self.each.get(&spectrum).and_then(|one| one.kind);
        own.or(self.kind)
    }

    /// The chosen scale of one spectrum's values.
    pub(crate) fn counted_of(&self, spectrum: usize) -> Option<Counted> {
        let own = self.each.get(&spectrum).and_then(|one| one.counted);
        own.or(self.counted)
    }

    /// The same, and how tables are written as others have it where nothing is said here.
    #[must_use]
    pub(crate) fn or_table_of(&self, others: &Self) -> Self {
        Self {
            dialect: self.dialect.or(others.dialect),
            delimiter: self.delimiter.or(others.delimiter),
            axis_column: self.axis_column.or(others.axis_column),
            wavelengths: self.wavelengths.or(others.wavelengths),
            ..self.clone()
        }
    }

    /// The same for a part of a file whose first spectrum is the file's `first`.
    #[must_use]
    pub fn from(&self, first: usize) -> Self {
        let each = self.each.range(first..);
        Self {
            each: each.map(|(at, one)| (at - first, *one)).collect(),
            ..self.clone()
        }
    }
}
