//! One spectrum as its reader found it: numbers and words, nothing decided.

use std::cell::{OnceCell, RefCell};

use super::curve::{self, Cleaned, Trouble};
use super::factor_scale::KnownScale;
use super::heading::Heading;
use crate::io::reading::decision::{AxisDecision, Decision};
use crate::io::text::units::WavelengthUnit;
use crate::spectrum::{Kind, SHORTEST_IN_AIR_NM, Sampled, in_air};

/// A spectrum on its way from a reader to [`interpret`](super::interpret()).
#[derive(Default)]
pub(crate) struct RawSpectrum<'a> {
    /// Its name.
    pub name: String,
    /// Its wavelengths.
    pub axis: RawAxis<'a>,
    /// Values in the file's number; NaN where one is missing.
    pub values: Vec<f64>,
    /// Title and unit above its values.
    pub title: String,
    /// True if values carry per cent signs.
    pub percent_signs: bool,
    /// The facts stated by the lines above its table.
    pub heading: Option<&'a Heading<'a>>,
    /// The properties fixed by its format.
    pub known: Known,
    /// Lines of the points in the file, for messages; one only for a spectrum in a row.
    pub lines: &'a [u32],
    /// Words for the line of provenance ("1 nm block", "decimal comma").
    pub how: Vec<String>,
    /// The reader's notes on it, a sentence each.
    pub notes: Vec<String>,
    /// The origin of the numbers, where the file states it.
    pub source: Option<String>,
    /// The notes that a file of this program has in one line.
    pub before: &'a str,
}

pub(crate) enum RawAxis<'a> {
    /// In nm, as the format knows; NaN where one is missing. What else was decided to get them.
    Nm(&'a [f64], Option<AxisDecision>),
    /// As a table has them.
    Written {
        scale: &'a Scale<'a>,
        /// Title and unit above them.
        title: String,
        /// True if they carry "nm" themselves.
        says_nm: bool,
    },
}

impl Default for RawAxis<'_> {
    fn default() -> Self {
        Self::Nm(&[], None)
    }
}

/// The properties of a spectrum fixed by its format; the others are decided by words and numbers.
#[derive(Clone, Debug, Default)]
pub struct Known {
    /// The kind of its values.
    pub kind: Option<Decision<Kind>>,
    /// Unit of its values, the scale applied; factors count as fractions.
    pub unit: Option<String>,
    /// The multiplier of its values.
    pub scale: KnownScale,
    /// True if factors may be stored as whole numbers to 10,000.
    pub may_be_large: bool,
}

impl<'a> RawSpectrum<'a> {
    /// A spectrum of a light on wavelengths in nm, with nothing more to say about it.
    pub(crate) fn light(
        name: impl Into<String>,
        nm: &'a [f64],
        values: Vec<f64>,
        unit: &str,
    ) -> Self {
        Self::known(name, nm, values, Decision::of_format(Kind::Light), unit)
    }

    /// A spectrum of a known kind on wavelengths in nm.
    pub(crate) fn known(
        name: impl Into<String>,
        nm: &'a [f64],
        values: Vec<f64>,
        kind: Decision<Kind>,
        unit: &str,
    ) -> Self {
        let known = Known {
            kind: Some(kind),
            unit: Some(unit.to_owned()),
            scale: KnownScale::Stated(1.0),
            may_be_large: false,
        };
        Self::bare(name.into(), RawAxis::Nm(nm, None), values, known)
    }

    /// A spectrum of a table, of which titles and numbers tell everything.
    pub(crate) fn written(
        name: impl Into<String>,
        scale: &'a Scale<'a>,
        axis_title: &str,
        values: Vec<f64>,
        heading: &'a Heading<'a>,
    ) -> Self {
        let axis = RawAxis::Written {
            scale,
            title: axis_title.to_owned(),
            says_nm: false,
        };
        Self {
            heading: Some(heading),
            before: heading.notes.unwrap_or(""),
            ..Self::bare(name.into(), axis, values, Known::default())
        }
    }

    fn bare(name: String, axis: RawAxis<'a>, values: Vec<f64>, known: Known) -> Self {
        Self {
            name,
            axis,
            values,
            known,
            ..Self::default()
        }
    }

    /// The same, its decimals marked by commas or not.
    #[must_use]
    pub(crate) fn with_comma(mut self, decimal_comma: bool) -> Self {
        if decimal_comma {
            self.how.push(said!("decimal comma").to_owned());
        }
        self
    }

    /// The same with wavelengths that say "nm", or not.
    #[must_use]
    pub(crate) fn saying_nm(mut self, says: bool) -> Self {
        if let RawAxis::Written { says_nm, .. } = &mut self.axis {
            *says_nm = says;
        }
        self
    }
}

const MOST_STEPS: usize = 4096;

/// Wavelengths as a file gives them, and what was found of them: a long table has one column of
/// them for many of values.
pub(crate) struct Scale<'a> {
    /// In the file's unit; NaN where one is missing.
    numbers: &'a [f64],
    extent: OnceCell<(f64, f64)>,
    /// A spectrum whose wavelengths are these, turned from a unit and otherwise unchanged.
    kept: RefCell<Option<(WavelengthUnit, Sampled)>>,
}

impl<'a> Scale<'a> {
    /// Wavelengths in the file's unit; NaN where one is missing.
    pub(crate) fn new(numbers: &'a [f64]) -> Self {
        Self {
            numbers,
            extent: OnceCell::new(),
            kept: RefCell::default(),
        }
    }

    /// The least and the greatest of them.
    pub(super) fn extent(&self) -> (f64, f64) {
        *self.extent.get_or_init(|| extent(self.numbers))
    }

    /// The unevenness of the steps between neighbours in nm: the widest less the narrowest, over
    /// the median; `None` for few steps.
    pub(super) fn unevenness(&self, unit: WavelengthUnit) -> Option<f64> {
        let steps = self.steps(unit);
        let (first, last) = (steps.first()?, steps.last()?);
        (steps.len() >= 20).then(|| (last - first) / steps[steps.len() / 2])
    }

    /// The steps between neighbours, nm, the narrowest first.
    fn steps(&self, unit: WavelengthUnit) -> Vec<f64> {
        // The first of very many are enough.
        let numbers = self.numbers.iter().take(MOST_STEPS);
        let nm: Vec<f64> = numbers.map(|x| unit.to_nm(*x)).collect();
        let mut steps: Vec<f64> = nm
            .windows(2)
            .map(|pair| (pair[1] - pair[0]).abs())
            .collect();
        steps.retain(|step| step.is_finite());
        steps.sort_by(f64::total_cmp);
        steps
    }

    /// True if wavelengths in vacuum are converted to those in air: with many points far apart the
    /// difference is lost between two of them.
    pub(super) fn tells_air_from_vacuum(&self, unit: WavelengthUnit) -> bool {
        const MANY: usize = 20;
        let (low, high) = self.extent();
        let middle = 0.5 * (unit.to_nm(low) + unit.to_nm(high));
        let steps = self.steps(unit);
        let step = steps.get(steps.len() / 2).copied().unwrap_or(0.0);
        steps.len() < MANY || step < 10.0 * (middle - in_air(middle))
    }

    /// A spectrum of these wavelengths and of values, in order and without gaps; from vacuum to air
    /// where they were measured in the one and are wanted in the other.
    pub(super) fn clean(
        &self,
        (unit, from_vacuum): (WavelengthUnit, bool),
        values: Vec<f64>,
        reversals: f64,
    ) -> Result<Cleaned, Trouble> {
        let beside = match &*self.kept.borrow() {
            Some((of, kept)) if *of == unit => curve::beside(kept, values),
            _ => Err(values),
        };
        let values = match beside {
            Ok(cleaned) => return Ok(cleaned),
            Err(values) => values,
        };
        let turned: Vec<f64>;
        // Shorter ones stay those in vacuum: air lets no such light through.
        let to_nm = |x: &f64| match unit.to_nm(*x) {
            nm if from_vacuum && nm >= SHORTEST_IN_AIR_NM => in_air(nm).max(SHORTEST_IN_AIR_NM),
            nm => nm,
        };
        let nm = match unit {
            WavelengthUnit::Nanometre if !from_vacuum => self.numbers,
            _ => {
                turned = self.numbers.iter().map(to_nm).collect();
                &turned
            }
        };
        let cleaned = curve::clean_within(nm, &values, reversals)?;
        if cleaned.samples.nm() == nm {
            *self.kept.borrow_mut() = Some((unit, cleaned.samples.clone()));
        }
        Ok(cleaned)
    }
}

fn extent(axis: &[f64]) -> (f64, f64) {
    // Eight at a time: a long axis is looked through for each of its columns.
    let (mut low, mut high) = ([f64::INFINITY; 8], [f64::NEG_INFINITY; 8]);
    let (eights, rest) = axis.as_chunks::<8>();
    for some in eights.iter().map(|eight| &eight[..]).chain([rest]) {
        for (i, x) in some.iter().enumerate() {
            // Neither is true of a gap. A zero is no wavelength.
            low[i] = if *x < low[i] && *x > 0.0 { *x } else { low[i] };
            high[i] = if *x > high[i] { *x } else { high[i] };
        }
    }
    (
        low.into_iter().fold(f64::INFINITY, f64::min),
        high.into_iter().fold(f64::NEG_INFINITY, f64::max),
    )
}
