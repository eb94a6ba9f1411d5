//! The header of both file forms: all that a reader needs to know what the numbers mean.

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::color::xyz::{FIRST_NM, LAST_NM};
use crate::spectrum::{Kind, Sampled};
use crate::{color::Observer, languages::with_sign};

use super::measure::Errors;
use super::plan::Reference;
use super::{Bands, Illuminant, Line, Operator, PictureError, Plan};

/// The word that says what a header is.
pub(super) const FORMAT: &str = "composite-picture";
/// The newest version that is read.
pub(super) const VERSION: u64 = 1;
/// Most pixels on a side.
pub(super) const MOST_SIDE: usize = 1 << 20;
/// Most bands.
const MOST_BANDS: usize = 4096;

/// A line as files have it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredLine {
    /// Where, nm.
    pub at_nm: f64,
    /// Share of power.
    pub share: f64,
    /// One value a band, of unit area.
    pub shape: Vec<f64>,
}

/// The own light as files have it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredOwn {
    /// Its name; empty for a picture that is light itself.
    pub light: String,
    /// First and last wavelength and step of its values, nm.
    pub values_nm_first_last_step: [f64; 3],
    /// Its values; empty for a picture that is light itself.
    pub values: Vec<f64>,
    /// The observer: a word, or the numbers of one that is not shipped.
    pub observer: Observer,
}

/// Quantisation of the numbers in the compact form.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct StoredQuantiser {
    /// One step of every plane but the first.
    pub step: f64,
    /// One step of the first plane's cube root.
    pub dc_step: f64,
    /// Unit of the first number.
    pub c_ref: f64,
    /// Steps of the first plane below which the others are no longer scaled down.
    pub floor: f64,
    /// Mean of the other numbers.
    pub mean: Vec<f64>,
    /// Matrix from steps back to numbers, row by row.
    pub inverse: Vec<f64>,
    /// Pixels on a side of a tile.
    pub tile: usize,
    /// Order of the planes in a tile.
    pub order: Vec<usize>,
}

/// The header.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Header {
    /// Always `FORMAT`.
    pub format: String,
    /// At most `VERSION`.
    pub version: u64,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
    /// Quantity that the spectra represent.
    pub kind: Kind,
    /// Unit of the spectra.
    pub unit: String,
    /// Factor by which stored numbers are multiplied.
    pub scale: f64,
    /// Wavelengths, nm.
    pub bands_nm: Vec<f64>,
    /// Numbers a pixel.
    pub numbers: usize,
    /// Always `cosine`.
    pub basis: String,
    /// First and last wavelength of the series, nm.
    pub range_nm: [f64; 2],
    /// Number of coefficients of the series.
    pub series: usize,
    /// Reference that multiplies the series.
    pub reference: Reference,
    /// A second known light.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second_reference: Option<Reference>,
    /// Lines.
    pub lines: Vec<StoredLine>,
    /// The own light.
    pub own: StoredOwn,
    /// True if own colour was exact before the numbers were rounded.
    pub exact: bool,
    /// Lights that the fit was weighted with.
    pub weighting: Vec<String>,
    /// Noise of a band.
    pub noise: f64,
    /// Errors, measured after decoding.
    pub error: Errors,
    /// Source of the picture.
    pub source: String,
    /// Program that wrote the file.
    pub made_by: String,
    /// True if a mask of measured pixels comes first in every tile (compact form).
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub mask: bool,
    /// Quantisation of the numbers (compact form).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub quantiser: Option<StoredQuantiser>,
    /// Fields written by other programs; kept.
    #[serde(flatten)]
    pub other: Map<String, Value>,
}

/// Description of a picture in a file, besides its numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct About {
    /// Unit of the spectra.
    pub unit: String,
    /// Source of the picture.
    pub source: String,
    /// Noise of a band, measured.
    pub noise: f64,
}

impl Header {
    /// The header of a picture of some size.
    pub fn of(
        operator: &Operator,
        (width, height): (usize, usize),
        about: &About,
        error: Errors,
    ) -> Self {
        let (plan, bands) = (operator.plan(), operator.bands());
        let own = plan.own.as_ref().filter(|_| bands.is_factor());
        let lines = plan.lines.iter().map(|line| StoredLine {
            at_nm: line.at_nm,
            share: line.share,
            shape: line.shape.clone(),
        });
        let weighting = plan.weighting.as_ref().filter(|_| bands.is_factor());
        Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            width,
            height,
            kind: bands.kind(),
            unit: about.unit.clone(),
            scale: 1.0,
            bands_nm: bands.nm().to_vec(),
            numbers: plan.numbers(),
            basis: "cosine".to_owned(),
            range_nm: operator.range_nm(),
            series: plan.series,
            reference: plan.reference.clone(),
            second_reference: plan.second.clone(),
            lines: lines.collect(),
            own: StoredOwn {
                light: own.map(|l| l.name().to_owned()).unwrap_or_default(),
                values_nm_first_last_step: [f64::from(FIRST_NM), f64::from(LAST_NM), 1.0],
                values: own.map(|l| l.on_nm().to_vec()).unwrap_or_default(),
                observer: plan.observer,
            },
            exact: operator.is_exact(),
            weighting: weighting.map(|w| w.names.clone()).unwrap_or_default(),
            noise: about.noise,
            error,
            source: about.source.clone(),
            made_by: concat!("spectral-explorer ", env!("CARGO_PKG_VERSION")).to_owned(),
            mask: false,
            quantiser: None,
            other: Map::new(),
        }
    }

    /// The header as it stands in files.
    pub fn to_json(&self) -> String {
        serde_json::to_string(self).unwrap_or_default()
    }

    /// A header from a file, checked so that everything below may trust it.
    ///
    /// # Errors
    /// [`PictureError::Broken`] with what is wrong.
    pub fn from_json(text: &str) -> Result<Self, PictureError> {
        let value: Value = serde_json::from_str(text).map_err(|error| {
            PictureError::broken(
                tr!("a header that is no JSON ({error})", error),
                said!("one"),
            )
        })?;
        let format = value.get("format").and_then(Value::as_str).unwrap_or("");
        if format != FORMAT {
            return Err(PictureError::broken(
                format!("a header of the format {format:?}"),
                format!("{FORMAT:?}"),
            ));
        }
        match value.get("version").and_then(Value::as_u64) {
            Some(1..=VERSION) => {}
            found => {
                let found = found.map_or(said!("no version").to_owned(), |v| {
                    tr!("version {found}", found = v)
                });
                return Err(PictureError::broken(
                    found,
                    tr!("version 1 to {newest}", newest = VERSION),
                ));
            }
        }
        let header: Self = serde_json::from_value(value).map_err(|error| {
            PictureError::broken(tr!("a header with {error}", error), said!("every field"))
        })?;
        header.check()?;
        Ok(header)
    }

    fn check(&self) -> Result<(), PictureError> {
        let broken = |found: String, expected: &str| Err(PictureError::broken(found, expected));
        let count = self.bands_nm.len();
        let mut sides = [self.width, self.height].into_iter();
        if !sides.all(|side| (1..=MOST_SIDE).contains(&side)) {
            let found = tr!(
                "a picture of {width} x {height} pixels",
                width = self.width,
                height = self.height
            );
            return broken(found, said!("1 to 1048576 pixels on a side"));
        }
        if count > MOST_BANDS {
            return broken(tr!("{count} bands", count), said!("at most 4096"));
        }
        Bands::new(self.bands_nm.clone(), self.kind)?;
        if self.basis != "cosine" {
            return broken(format!("the basis {:?}", self.basis), "\"cosine\"");
        }
        let numbers = self.series.checked_add(self.lines.len());
        let fits = self.series > 0 && (3..count).contains(&self.numbers);
        if numbers != Some(self.numbers) || !fits {
            let (series, lines) = (self.series, self.lines.len());
            let found = tr!(
                "{numbers} numbers of {series} and {lines} lines",
                numbers = self.numbers,
                series,
                lines
            );
            return broken(found, said!("3 or more, fewer than bands, that add up"));
        }
        let [lo, hi] = self.range_nm;
        let covers = lo <= self.bands_nm[0] && hi >= self.bands_nm[count - 1];
        if !(lo.is_finite() && hi.is_finite() && covers) {
            return broken(
                tr!(
                    "the range {lo}:{hi} nm",
                    lo = with_sign(lo.to_string()),
                    hi = with_sign(hi.to_string())
                ),
                said!("one that covers the bands"),
            );
        }
        let mut tables = vec![&self.reference.values];
        tables.extend(self.second_reference.iter().map(|r| &r.values));
        tables.extend(self.lines.iter().map(|l| &l.shape));
        for table in tables {
            if table.len() != count || table.iter().any(|v| !v.is_finite()) {
                return broken(
                    tr!("a table of {found} values", found = table.len()),
                    said!("one finite value a band"),
                );
            }
        }
        if !self.own.values.is_empty() {
            self.own_light()?;
        }
        if !(self.scale.is_finite() && self.scale > 0.0 && self.noise.is_finite()) {
            return broken(
                tr!(
                    "the scale {scale}",
                    scale = with_sign(self.scale.to_string())
                ),
                said!("one above 0"),
            );
        }
        Ok(())
    }

    fn own_light(&self) -> Result<Illuminant, PictureError> {
        let [first, last, step] = self.own.values_nm_first_last_step;
        let rises = step > 0.0 && first > 0.0 && last > first && last < 1e6;
        let steps = ((last - first) / step).round();
        let fits = (steps + 1.0 - self.own.values.len() as f64).abs() < 0.5;
        match Sampled::even(first, step, self.own.values.clone()) {
            Ok(table) if rises && fits => Ok(Illuminant::new(&self.own.light, &table)),
            _ => Err(PictureError::broken(
                said!("an own light that is no table"),
                said!("values from first to last nm"),
            )),
        }
    }

    /// The bands.
    ///
    /// # Errors
    /// As [`Header::from_json`].
    pub fn bands(&self) -> Result<Bands, PictureError> {
        Bands::new(self.bands_nm.clone(), self.kind)
    }

    /// The operator that the header stands for: its D is the file's. Its E is of the plain fit
    /// unless the weighting's lights are in the library.
    ///
    /// # Errors
    /// [`PictureError`] when the header does not lead to one.
    pub fn operator(&self) -> Result<Operator, PictureError> {
        let bands = self.bands()?;
        let observer = self.own.observer;
        let lines = self.lines.iter().map(|line| {
            let touched = |s: &f64| *s != 0.0;
            let first = line.shape.iter().position(touched).unwrap_or(0);
            let first = first.saturating_sub(1);
            let last = line.shape.iter().rposition(touched).unwrap_or(0) + 1;
            Line {
                at_nm: line.at_nm,
                share: line.share,
                shape: line.shape.clone(),
                window: [first, last.min(self.bands_nm.len() - 1)],
            }
        });
        let names = self.weighting.iter().take(100);
        let names = names.filter(|_| bands.is_factor());
        let weighting: Vec<Illuminant> = names.filter_map(|name| Illuminant::named(name)).collect();
        let plan = Plan {
            series: self.series,
            margin: (self.bands_nm[0] - self.range_nm[0]) / bands.length_nm(),
            reference: self.reference.clone(),
            second: self.second_reference.clone(),
            lines: lines.collect(),
            own: match self.own.values.is_empty() {
                true => None,
                false => Some(self.own_light()?),
            },
            observer,
            weighting: (!weighting.is_empty())
                .then(|| std::sync::Arc::new(super::Weighting::of(&weighting, &bands, observer))),
            exact: self.exact,
            noise: self.noise,
        };
        Operator::with_range(&bands, &plan, self.range_nm)
    }
}
