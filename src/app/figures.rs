//! Every figure of a model and of a colour, once: its key in files, its names, unit, digits and
//! meaning, and of a colour's how it is computed. Files, words, panels, tooltips, charts and tables
//! walk these rows: a new figure is what computes it, and its row here.

use super::{derived::Colour, ticks::short};
use crate::{
    io::Quantity::{self, Cct, ChromaticityX, ChromaticityY, Duv, UPrime, VPrime},
    study::Measure,
};

/// What a figure is counted in where it is shown; files have shares of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// For axes and titles.
    pub sign: &'static str,
    /// What stands behind a number; CIEDE2000 is told by what stands before it.
    pub tail: &'static str,
    /// What a value is multiplied by to be counted in it.
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

/// What is said of a figure wherever it stands.
#[derive(Clone, Copy, Debug)]
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
    /// Whether a plus is written.
    pub signed: bool,
    /// What it counts, a sentence or more.
    pub meaning: &'static str,
    /// How the report says it, `{}` being the number; empty where it says it elsewhere.
    pub said: &'static str,
    /// Behind "under 1 %": what is meant to be small.
    pub goal: &'static str,
}

/// Errors below this are drawn and told as it, in ΔE₀₀ or percent: axes are logarithmic, and less
/// than this nobody can tell from nothing.
pub const SMALLEST: f64 = 1e-4;

impl Figure {
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
            return format!("{shown:.digits$}{tail}");
        }
        if self.unit == Unit::PERCENT {
            let whole = 10_f64.powi(digits as i32);
            // Adding zero turns -0 into 0.
            shown = (self.unit.factor * whole * value).round() / whole + 0.0;
        }
        format!("{shown:+.digits$}{tail}")
    }

    /// A value as the report says it.
    pub fn say(&self, value: f64) -> String {
        self.said.replace("{}", &self.written(value))
    }

    /// An error in three digits: `0.0123`, `12.3 %`, a dash where there is none.
    pub fn brief(&self, error: Option<f64>) -> String {
        error.map_or_else(|| "–".to_owned(), |e| brief(self.shown(e), self.unit))
    }

    /// Title and unit, for an axis.
    pub fn with_unit(&self) -> String {
        format!("{}, {}", self.title, self.unit.sign)
    }
}

/// An error in its unit in three digits, which is what it is good for.
pub fn brief(shown: f64, unit: Unit) -> String {
    let tail = unit.tail;
    if shown < SMALLEST {
        format!("<{SMALLEST}{tail}")
    } else {
        format!("{}{tail}", three_digits(shown))
    }
}

/// A number in two digits.
pub fn two_digits(value: f64) -> String {
    short(format!("{value:.1e}").parse().unwrap_or(value))
}

/// A number in three digits.
pub fn three_digits(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
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

/// A colour difference: key, title and short name, goal, meaning.
const fn delta_e(key: Words, [title, short]: [Words; 2], goal: Words, meaning: Words) -> Figure {
    Figure {
        key,
        title,
        short,
        unit: Unit::DELTA_E,
        digits: 3,
        meaning,
        goal,
        ..NUMBER
    }
}

/// A share of the spectrum: key, title and short name, as the report says it, meaning.
const fn share(key: Words, [title, short]: [Words; 2], said: Words, meaning: Words) -> Figure {
    Figure {
        said,
        unit: Unit::PERCENT,
        digits: 2,
        ..delta_e(key, [title, short], "", meaning)
    }
}

impl Measure {
    /// What is said of it.
    #[expect(clippy::too_many_lines, reason = "a table: one row a measure")]
    pub fn figure(self) -> Figure {
        match self {
            Self::Own => delta_e(
                "delta_e_own",
                ["own colour", "own"],
                "in its own colour",
                "CIEDE2000 of the spectrum's own colour.",
            ),
            Self::Patches => delta_e(
                "delta_e_patches_mean",
                ["mean of the surfaces", "patches"],
                "on the surfaces (mean)",
                "Mean CIEDE2000 of the patches under the light, products at 1 nm.",
            ),
            Self::PatchesWorst => delta_e(
                "delta_e_patches_max",
                ["worst surface", "worst"],
                "on every patch",
                "Largest CIEDE2000 of the patches under the light, products at 1 nm.",
            ),
            Self::Filters => delta_e(
                "delta_e_filters",
                ["narrow filters", "filters"],
                "behind narrow filters (mean)",
                "Mean CIEDE2000 behind Gaussian band-passes of 10 nm full width at 420, 430 ... \
                 670 nm. The filter is exact; the exact light behind it is brought to Y = 50.",
            ),
            Self::Rms => Figure {
                goal: "rms at 1 nm",
                ..share(
                    "relative_rms",
                    ["rms at 1 nm", "rms 1 nm"],
                    "; at 1 nm {} rms",
                    "Root mean square of model minus measured over that of the spectrum, on the \
                     1 nm grid. A spike has no width: there it stands against a line of several \
                     nm, so lamps with broad lines show large numbers.",
                )
            },
            Self::RmsBlurred => Figure {
                goal: "rms behind a 10 nm blur",
                ..share(
                    "relative_rms_10nm",
                    ["rms behind 10 nm", "rms 10 nm"],
                    "{} rms behind a 10 nm blur",
                    "Root mean square of model minus measured over that of the spectrum, both \
                     behind a Gaussian blur of 10 nm full width at half maximum.",
                )
            },
            Self::MaxAbs => share(
                "max_abs",
                ["largest"; 2],
                ", {} at most",
                "Largest difference over the largest value.",
            ),
            Self::Energy => Figure {
                digits: 3,
                signed: true,
                ..share(
                    "energy",
                    ["energy"; 2],
                    ", energy {}",
                    "Power of the model over that of the spectrum, less one.",
                )
            },
            Self::Lowest => share(
                "lowest",
                ["lowest"; 2],
                ", lowest {}",
                "Lowest value of the smooth part over the largest value; negative is a lobe below \
                 zero.",
            ),
            Self::Displacement => Figure {
                unit: Unit::NANOMETRE,
                ..share(
                    "displacement_nm",
                    ["displacement", "displaced"],
                    ", light displaced by {}",
                    "Mean distance that the model's power would have to be moved to be where it \
                     was measured: the area between both running sums of power, each over its \
                     own total.",
                )
            },
        }
    }
}

/// The shares in the order of the panel, where two stand in a row.
pub const SHARES: [Measure; 6] = [
    Measure::Displacement,
    Measure::RmsBlurred,
    Measure::Rms,
    Measure::MaxAbs,
    Measure::Lowest,
    Measure::Energy,
];

pub struct ColourFigure {
    /// What is said of it.
    pub figure: Figure,
    /// What instruments call it, where theirs is in the same unit.
    pub quantity: Option<Quantity>,
    /// What computes it; `None` where it does not exist.
    pub of: fn(&Colour) -> Option<f64>,
}

const fn row(
    title: Words,
    said: Words,
    figure: Figure,
    quantity: Option<Quantity>,
    of: fn(&Colour) -> Option<f64>,
) -> ColourFigure {
    let figure = Figure {
        title,
        short: title,
        said,
        ..figure
    };
    ColourFigure {
        figure,
        quantity,
        of,
    }
}

const fn number(key: Words, digits: usize, meaning: Words) -> Figure {
    Figure {
        key,
        digits,
        meaning,
        ..NUMBER
    }
}

const XYZ: Figure = number(
    "xyz",
    3,
    "Tristimulus value of the observer in force; 100 is the Y of the measured light.",
);
const XY: Figure = number("xy", 4, "Chromaticity x, y, no unit.");
const UV: Figure = number("uv", 4, "Chromaticity u′, v′ of CIE 1976, no unit.");
const CCT: Figure = Figure {
    unit: Unit::KELVIN,
    ..number(
        "cct",
        0,
        "Correlated colour temperature, K (Ohno 2013, CIE 1931).",
    )
};
const DUV: Figure = Figure {
    signed: true,
    ..number(
        "duv",
        4,
        "Distance from the blackbody locus in CIE 1960 uv; above it is positive.",
    )
};

/// The figures of every colour.
pub static OF_COLOUR: [ColourFigure; 7] = [
    row("X", "XYZ {}", XYZ, None, |c| Some(c.xyz.x)),
    row("Y", " {}", XYZ, None, |c| Some(c.xyz.y)),
    row("Z", " {}", XYZ, None, |c| Some(c.xyz.z)),
    row("x", ", xy {}", XY, Some(ChromaticityX), |c| Some(c.xy[0])),
    row("y", " {}", XY, Some(ChromaticityY), |c| Some(c.xy[1])),
    row("u′", "", UV, Some(UPrime), |c| Some(c.uv[0])),
    row("v′", "", UV, Some(VPrime), |c| Some(c.uv[1])),
];

/// The figures that only lights have.
pub static OF_LIGHT: [ColourFigure; 2] = [
    row("CCT", ", {}", CCT, Some(Cct), |c| Some(c.cct?.ok()?.kelvin)),
    row("Duv", ", Duv {}", DUV, Some(Duv), |c| {
        Some(c.cct?.ok()?.duv)
    }),
];

/// The figure of a colour that an instrument computed, too.
pub fn of_quantity(quantity: &Quantity) -> Option<&'static ColourFigure> {
    let mut all = OF_COLOUR.iter().chain(&OF_LIGHT);
    all.find(|figure| figure.quantity.as_ref() == Some(quantity))
}

/// Figures with the same key: a list in files, or one number.
pub fn by_key(figures: &[ColourFigure]) -> impl Iterator<Item = &[ColourFigure]> {
    figures.chunk_by(|a, b| a.figure.key == b.figure.key)
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;

    #[test]
    fn every_figure_has_a_key_of_its_own_and_says_what_it_is() {
        let keys: BTreeSet<&str> = Measure::ALL.map(|m| m.figure().key).into();
        assert_eq!(keys.len(), Measure::ALL.len());
        for measure in Measure::ALL {
            let figure = measure.figure();
            assert!(figure.meaning.ends_with('.'), "{measure:?}");
            assert_eq!(figure.unit == Unit::DELTA_E, measure.is_colour());
            assert_ne!(SHARES.contains(&measure), measure.is_colour());
            let is_compared = Measure::COMPARED.contains(&measure);
            assert_ne!(figure.goal.is_empty(), is_compared, "{measure:?}");
        }
    }

    #[test]
    fn numbers_are_written_in_their_unit_and_zero_has_no_minus() {
        assert_eq!(Measure::Rms.figure().written(0.1234), "12.34 %");
        assert_eq!(Measure::Energy.figure().written(-1e-9), "+0.000 %");
        assert_eq!(Measure::Own.figure().brief(Some(0.012_345)), "0.0123");
        assert_eq!(Measure::Rms.figure().brief(Some(1e-9)), "<0.0001 %");
        assert_eq!(Measure::Rms.figure().brief(None), "–");
        assert_eq!(OF_LIGHT[0].figure.written(6503.6), "6504 K");
    }
}
