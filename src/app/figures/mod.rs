//! Every figure, once: its key in files, its names, unit, digits and meaning, and how it is
//! computed. Files, words, panels, charts, tables, lessons and instruments' own values walk these
//! rows: a new figure is what computes it, and its row.
//!
//! ```text
//! model    errors of models, for each measure of `study`
//! colour   figures of a colour of the model or the measured spectrum
//! quality  figures of light quality, and where JSON has them
//! reading  what a figure of quality means in plain words
//! ```

mod colour;
mod model;
mod quality;
mod reading;

pub use colour::{ColourFigure, OF_COLOUR, OF_LIGHT, by_key};
pub use model::SHARES;
pub use quality::{OF_QUALITY, QualityFigure, TLCI, of_quantity};

use super::numbers::{ROUNDING, fixed, hundredths, or_dash, significant};
use crate::languages::{said, with_sign};

/// The unit of a figure where it is shown; files have shares of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// For axes and titles.
    pub sign: &'static str,
    /// Behind a number; CIEDE2000 has ΔE₀₀ before it instead.
    pub tail: &'static str,
    /// Its count in the unit of files.
    pub factor: f64,
}

const fn unit(sign: &'static str, tail: &'static str, factor: f64) -> Unit {
    Unit { sign, tail, factor }
}

impl Unit {
    /// CIEDE2000.
    pub const DELTA_E: Self = unit("ΔE₀₀", "", 1.0);
    /// Of shares.
    pub const PERCENT: Self = unit("%", " %", 100.0);
    const KELVIN: Self = unit("K", " K", 1.0);
    const NANOMETRE: Self = unit("nm", " nm", 1.0);
    /// Of counts and pure numbers.
    pub const NONE: Self = unit("", "", 1.0);
}

/// Names, unit and meaning of a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// In files. Figures of a colour that share a key stand there as a list.
    pub key: &'static str,
    /// In menus and over charts.
    pub title: &'static str,
    /// Over a narrow column.
    pub short: &'static str,
    /// What it is shown in.
    pub unit: Unit,
    /// Decimals in that unit.
    pub digits: usize,
    /// A plus is written.
    pub signed: bool,
    /// Definition, of quality its standard and data; a sentence or more.
    pub meaning: &'static str,
    /// The report's words, `{}` being the number; empty where it says it elsewhere.
    pub said: &'static str,
    /// Behind "under 1 %": the error that is meant.
    pub goal: &'static str,
}

/// The least error that is drawn or written, in ΔE₀₀ or percent: axes are logarithmic, and values
/// below this are indistinguishable from zero.
pub const SMALLEST: f64 = 1e-4;

impl Figure {
    /// In menus and over charts, in the language spoken.
    pub fn title(&self) -> &'static str {
        said(self.title)
    }

    /// Over a narrow column, in the language spoken.
    pub fn short(&self) -> &'static str {
        said(self.short)
    }

    /// Definition, in the language spoken.
    pub fn meaning(&self) -> &'static str {
        said(self.meaning)
    }

    /// The error that is meant, in the language spoken.
    pub fn goal(&self) -> &'static str {
        said(self.goal)
    }

    /// A value in the unit.
    pub fn shown(&self, value: f64) -> f64 {
        value * self.unit.factor
    }

    /// An error on a logarithmic axis.
    pub fn drawn(&self, error: f64) -> f64 {
        self.shown(error).max(SMALLEST)
    }

    /// A value with its digits: `17.53 %`.
    pub fn written(&self, value: f64) -> String {
        let (digits, tail) = (self.digits, self.unit.tail);
        let mut shown = self.shown(value);
        if !self.signed {
            return format!("{}{tail}", fixed(shown, digits));
        }
        if self.unit == Unit::PERCENT {
            let whole = 10_f64.powi(digits as i32);
            // Adding zero turns -0 into 0.
            shown = (self.unit.factor * whole * value).round() / whole + 0.0;
        }
        with_sign(format!("{shown:+.digits$}")) + tail
    }

    /// A value as the report says it.
    pub fn say(&self, value: f64) -> String {
        said(self.said).replace("{}", &self.written(value))
    }

    /// An error in three digits: `0.0123`, `12.3 %`, a dash where there is none.
    pub fn brief(&self, error: Option<f64>) -> String {
        error.map_or_else(|| "–".to_owned(), |e| brief(self.shown(e), self.unit))
    }

    /// An error in a column, whose decimal points stand below each other: `0.09`, `21.4 %`.
    pub fn in_column(&self, error: Option<f64>) -> String {
        in_column(error.map(|error| self.shown(error)), self.unit)
    }

    /// Title and unit, for an axis.
    pub fn with_unit(&self) -> String {
        format!("{}, {}", said(self.title), self.unit.sign)
    }
}

/// An error in its unit in three digits, which is what it is good for.
pub fn brief(shown: f64, unit: Unit) -> String {
    let tail = unit.tail;
    if shown < SMALLEST {
        format!("< {}{tail}", with_sign(SMALLEST.to_string()))
    } else {
        format!("{}{tail}", significant(shown, 3))
    }
}

/// An error in its unit with the decimals of a column.
pub fn in_column(shown: Option<f64>, unit: Unit) -> String {
    let shown = shown.map(|v| if v.abs() < ROUNDING { 0.0 } else { v });
    if unit != Unit::PERCENT {
        return format!("{}{}", hundredths(shown), unit.tail);
    }
    or_dash(shown, |shown| match shown {
        v if v > 0.0 && v < 0.05 => format!("< {} %", fixed(0.1, 1)),
        v => format!("{} %", fixed(v, 1)),
    })
}

const NUMBER: Figure = Figure {
    key: "",
    title: "",
    short: "",
    unit: Unit::NONE,
    digits: 4,
    signed: false,
    meaning: "",
    said: "",
    goal: "",
};

type Words = &'static str;

const fn number(key: Words, digits: usize, meaning: Words) -> Figure {
    Figure {
        key,
        digits,
        meaning,
        ..NUMBER
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::study::Measure;

    #[test]
    fn numbers_are_written_in_their_unit_and_zero_has_no_minus() {
        assert_eq!(Measure::Rms.figure().written(0.1234), "12.34 %");
        assert_eq!(Measure::Energy.figure().written(-1e-9), "+0.000 %");
        assert_eq!(Measure::Own.figure().brief(Some(0.012_345)), "0.0123");
        assert_eq!(Measure::Rms.figure().brief(Some(1e-9)), "< 0.0001 %");
        assert_eq!(Measure::Rms.figure().brief(None), "–");
        let [own, rms] = [Measure::Own, Measure::Rms].map(Measure::figure);
        assert_eq!(
            [0.0928, 13.5, 1e-3, 1e-13].map(|e| own.in_column(Some(e))),
            ["0.09", "13.50", "< 0.01", "0.00"]
        );
        assert_eq!(
            [0.2137, 0.67, 1e-4].map(|e| rms.in_column(Some(e))),
            ["21.4 %", "67.0 %", "< 0.1 %"]
        );
        assert_eq!([own, rms].map(|figure| figure.in_column(None)), ["–", "–"]);
        assert_eq!(OF_LIGHT[0].figure.written(6503.6), "6504 K");
    }
}
