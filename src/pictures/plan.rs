//! The plan of an operator: a series, its reference, lines, a light and an observer.

use std::sync::Arc;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use crate::color::Observer;

use super::lines::Line;
use super::{Bands, Illuminant, PictureError};

/// The range reaches this share of the bands' length beyond both ends.
pub(super) const MARGIN: f64 = 0.05;
/// Least value of the mean as a reference, as a share of its largest.
const LEAST_MEAN: f64 = 0.02;
/// Least noise of a band where a known light's mean is 1.
pub(super) const LEAST_NOISE: f64 = 0.002;

/// Kind of the reference, which multiplies the series.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ReferenceKind {
    /// Nothing.
    One,
    /// A known light as it falls on the bands.
    Light,
    /// The picture's own mean.
    Mean,
}

impl ReferenceKind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::One, Self::Light, Self::Mean];

    /// Its word in files and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::One => "one",
            Self::Light => "light",
            Self::Mean => "mean",
        }
    }
}

/// A reference spectrum on the bands.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Kind of the reference.
    pub kind: ReferenceKind,
    /// Name of the light, else empty.
    #[serde(default)]
    pub name: String,
    /// One value a band.
    pub values: Vec<f64>,
}

impl Reference {
    /// No reference.
    pub fn one(bands: &Bands) -> Self {
        Self {
            kind: ReferenceKind::One,
            name: String::new(),
            values: vec![1.0; bands.len()],
        }
    }

    /// A known light.
    ///
    /// # Errors
    /// [`PictureError::NoOverlap`] when nothing of it falls on the bands.
    pub fn of_light(bands: &Bands, light: &Illuminant) -> Result<Self, PictureError> {
        Ok(Self {
            kind: ReferenceKind::Light,
            name: light.name().to_owned(),
            values: light.on_bands(bands)?,
        })
    }

    /// The picture's mean, kept at or above 2 % of its largest value.
    ///
    /// # Errors
    /// [`PictureError::AllZero`] when nothing of it is above zero.
    pub(crate) fn of_mean(mean: &[f64]) -> Result<Self, PictureError> {
        let largest = mean.iter().copied().fold(0.0, f64::max);
        if !(largest > 0.0 && largest.is_finite()) {
            return Err(PictureError::AllZero);
        }
        Ok(Self {
            kind: ReferenceKind::Mean,
            name: String::new(),
            values: mean.iter().map(|v| v.max(LEAST_MEAN * largest)).collect(),
        })
    }
}

/// Colours that a fit is weighted with: the mean of `K^T K` over lights.
#[derive(Clone, Debug, PartialEq)]
pub struct Weighting {
    /// Names of the lights.
    pub names: Vec<String>,
    /// `K` of all lights below one another, over the root of their count: the mean is its square, and
    /// it takes no number for each pair of bands.
    pub(super) rows: DMatrix<f64>,
}

impl Weighting {
    /// The weighting of a picture's kind; none of one that is light itself.
    pub fn usual(bands: &Bands, observer: Observer) -> Option<Arc<Self>> {
        let weighting = || Arc::new(Self::of(Illuminant::weighting(), bands, observer));
        bands.is_factor().then(weighting)
    }

    /// The weighting by some lights on some bands; lights that do not shine are left out.
    pub fn of<'a>(
        lights: impl IntoIterator<Item = &'a Illuminant>,
        bands: &Bands,
        observer: Observer,
    ) -> Self {
        let count = bands.len();
        let (mut names, mut values) = (Vec::new(), Vec::new());
        for light in lights {
            let Ok(rows) = light.weights(bands, observer) else {
                continue;
            };
            values.extend(rows.into_iter().flatten());
            names.push(light.name().to_owned());
        }
        let mut rows = DMatrix::from_row_slice(values.len() / count, count, &values);
        rows /= (names.len().max(1) as f64).sqrt();
        Self { names, rows }
    }
}

/// Specification of an operator.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// Numbers of the series.
    pub series: usize,
    /// Extension of the range beyond the bands, as a share of their length.
    pub margin: f64,
    /// Reference that multiplies the series.
    pub reference: Reference,
    /// A second known light, whose series takes half of the numbers.
    pub second: Option<Reference>,
    /// Lines, one number each.
    pub lines: Vec<Line>,
    /// The own light of a reflectance.
    pub own: Option<Illuminant>,
    /// The observer.
    pub observer: Observer,
    /// Colours that the fit of a reflectance is weighted with; none for the plain fit.
    pub weighting: Option<Arc<Weighting>>,
    /// True if own colour is to be exact.
    pub exact: bool,
    /// Noise of a band where a known light's mean is 1.
    pub noise: f64,
}

impl Plan {
    /// The default for a reflectance under D65, or for what is light: no reference, no lines.
    pub fn new(bands: &Bands, series: usize) -> Self {
        let observer = Observer::CIE_1931;
        Self {
            series,
            margin: MARGIN,
            reference: Reference::one(bands),
            second: None,
            lines: Vec::new(),
            own: match bands.is_factor() {
                true => Illuminant::named("D65"),
                false => None,
            },
            observer,
            weighting: Weighting::usual(bands, observer),
            exact: true,
            noise: LEAST_NOISE,
        }
    }

    /// The default for a picture that a known light lit.
    ///
    /// # Errors
    /// [`PictureError::NoOverlap`] when nothing of it falls on the bands.
    pub fn lit(
        bands: &Bands,
        series: usize,
        light: &Illuminant,
        noise: f64,
    ) -> Result<Self, PictureError> {
        Ok(Self {
            reference: Reference::of_light(bands, light)?,
            noise: if noise.is_finite() { noise } else { 0.0 }.max(LEAST_NOISE),
            ..Self::new(bands, series)
        })
    }

    /// Numbers a pixel.
    pub fn numbers(&self) -> usize {
        self.series + self.lines.len()
    }

    /// First and last wavelength of the series, nm.
    pub(crate) fn range_nm(&self, bands: &Bands) -> [f64; 2] {
        let beyond = self.margin * bands.length_nm();
        [bands.nm()[0] - beyond, bands.nm()[bands.len() - 1] + beyond]
    }

    /// Numbers of each light's series.
    pub(super) fn shares(&self) -> (usize, usize) {
        match self.second {
            Some(_) => (self.series.div_ceil(2), self.series / 2),
            None => (self.series, 0),
        }
    }
}
