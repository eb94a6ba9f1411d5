//! Every figure of a model and of a colour, once: its key in files, its names, unit, digits and
//! meaning, and of a colour's how it is computed. Files, words, panels, tooltips, charts and tables
//! walk these rows: a new figure is what computes it, and its row here.

use super::{derived::Colour, ticks::short};
use crate::{io::Quantity, study::Measure};

/// What a figure is counted in where it is shown; files have shares of 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// CIEDE2000.
    DeltaE,
    /// A share, in percent.
    Percent,
    /// Kelvin.
    Kelvin,
    /// Nanometres.
    Nanometre,
    /// A pure number.
    None,
}

impl Unit {
    /// Its sign, for axes and titles.
    pub fn sign(self) -> &'static str {
        match self {
            Self::DeltaE => "ΔE00",
            Self::Percent => "%",
            Self::Kelvin => "K",
            Self::Nanometre => "nm",
            Self::None => "",
        }
    }

    /// What stands behind a number; CIEDE2000 is told by what stands before it.
    pub fn tail(self) -> &'static str {
        match self {
            Self::Percent => " %",
            Self::Kelvin => " K",
            Self::Nanometre => " nm",
            Self::DeltaE | Self::None => "",
        }
    }

    /// What a value is multiplied by to be counted in it.
    pub fn factor(self) -> f64 {
        if self == Self::Percent { 100.0 } else { 1.0 }
    }
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

/// Errors below this are drawn and told as it, in ΔE00 or percent: axes are logarithmic, and less
/// than this nobody can tell from nothing.
pub const SMALLEST: f64 = 1e-4;

impl Figure {
    /// A value in the unit.
    pub fn shown(&self, value: f64) -> f64 {
        value * self.unit.factor()
    }

    /// An error on a logarithmic axis.
    pub fn drawn(&self, error: f64) -> f64 {
        self.shown(error).max(SMALLEST)
    }

    /// A value with its digits: `17.53 %`.
    pub fn written(&self, value: f64) -> String {
        let (digits, shown, tail) = (self.digits, self.shown(value), self.unit.tail());
        match (self.signed, self.unit) {
            (false, _) => format!("{shown:.digits$}{tail}"),
            (true, Unit::Percent) => {
                let whole = 10_f64.powi(digits as i32);
                // Adding zero turns -0 into 0.
                let rounded = (self.unit.factor() * whole * value).round() / whole + 0.0;
                format!("{rounded:+.digits$}{tail}")
            }
            (true, _) => format!("{shown:+.digits$}{tail}"),
        }
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
        format!("{}, {}", self.title, self.unit.sign())
    }

    /// The goal with what it is counted in: `ΔE00 on every patch`.
    pub fn goal_words(&self) -> String {
        match self.unit {
            Unit::DeltaE => format!("ΔE00 {}", self.goal),
            _ => self.goal.to_owned(),
        }
    }
}

/// An error in its unit in three digits, which is what it is good for.
pub fn brief(shown: f64, unit: Unit) -> String {
    let tail = unit.tail();
    if shown < SMALLEST {
        format!("<{SMALLEST}{tail}")
    } else {
        format!("{}{tail}", three_digits(shown))
    }
}

/// A number in three digits.
pub fn three_digits(value: f64) -> String {
    short(format!("{value:.2e}").parse().unwrap_or(value))
}

const COLOUR_DIFFERENCE: Figure = Figure {
    unit: Unit::DeltaE,
    digits: 3,
    ..NUMBER
};

const SHARE: Figure = Figure {
    unit: Unit::Percent,
    digits: 2,
    ..NUMBER
};

const NUMBER: Figure = Figure {
    key: "",
    title: "",
    short: "",
    unit: Unit::None,
    digits: 4,
    signed: false,
    meaning: "",
    said: "",
    goal: "",
};

impl Measure {
    /// What is said of it.
    pub fn figure(self) -> Figure {
        match self {
            Self::Own => Figure {
                key: "delta_e_own",
                title: "own colour",
                short: "own",
                meaning: "CIEDE2000 of the spectrum's own colour.",
                goal: "in its own colour",
                ..COLOUR_DIFFERENCE
            },
            Self::Patches => Figure {
                key: "delta_e_patches_mean",
                title: "patches' mean",
                short: "patches",
                meaning: "Mean CIEDE2000 of the patches under the light, products at 1 nm.",
                goal: "on the patches (mean)",
                ..COLOUR_DIFFERENCE
            },
            Self::PatchesWorst => Figure {
                key: "delta_e_patches_max",
                title: "worst patch",
                short: "worst",
                meaning: "Largest CIEDE2000 of the patches under the light, products at 1 nm.",
                goal: "on every patch",
                ..COLOUR_DIFFERENCE
            },
            Self::Filters => Figure {
                key: "delta_e_filters",
                title: "narrow filters",
                short: "filters",
                meaning: "Mean CIEDE2000 behind Gaussian band-passes of 10 nm full width at 420, \
                          430 ... 670 nm. The filter is exact; the exact light behind it is \
                          brought to Y = 50.",
                goal: "behind narrow filters (mean)",
                ..COLOUR_DIFFERENCE
            },
            Self::Rms => Figure {
                key: "relative_rms",
                title: "rms at 1 nm",
                short: "rms 1 nm",
                meaning: "Root mean square of model minus measured over that of the spectrum, on \
                          the 1 nm grid. A spike has no width: there it stands against a line of \
                          several nm, so lamps with broad lines show large numbers.",
                said: "{} rms at 1 nm",
                goal: "rms at 1 nm",
                ..SHARE
            },
            Self::RmsBlurred => Figure {
                key: "relative_rms_10nm",
                title: "rms behind 10 nm",
                short: "rms 10 nm",
                meaning: "Root mean square of model minus measured over that of the spectrum, both \
                          behind a Gaussian blur of 10 nm full width at half maximum.",
                said: ", {} behind a 10 nm blur",
                goal: "rms behind a 10 nm blur",
                ..SHARE
            },
            Self::MaxAbs => share(
                ["max_abs", "largest"],
                "Largest difference over the largest value.",
                ", {} at most",
            ),
            Self::Energy => Figure {
                digits: 3,
                signed: true,
                ..share(
                    ["energy", "energy"],
                    "Power of the model over that of the spectrum, less one.",
                    ", energy {}",
                )
            },
            Self::Lowest => share(
                ["lowest", "lowest"],
                "Lowest value of the smooth part over the largest value; negative is a lobe below \
                 zero.",
                ", lowest {}",
            ),
            Self::Displacement => Figure {
                key: "displacement_nm",
                title: "displacement",
                short: "displaced",
                unit: Unit::Nanometre,
                meaning: "Mean distance that the model's power would have to be moved to be where \
                          it was measured: the area between both running sums of power, each \
                          over its own total.",
                said: ", light displaced by {}",
                digits: 2,
                ..NUMBER
            },
        }
    }
}

/// A share that no model is chosen by.
fn share([key, name]: [&'static str; 2], meaning: &'static str, said: &'static str) -> Figure {
    Figure {
        key,
        title: name,
        short: name,
        meaning,
        said,
        ..SHARE
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

/// A figure of a colour.
pub struct ColourFigure {
    /// What is said of it.
    pub figure: Figure,
    /// What instruments call it, where theirs is in the same unit.
    pub quantity: Option<Quantity>,
    /// What computes it; `None` where it does not exist.
    pub of: fn(&Colour) -> Option<f64>,
}

const TRISTIMULUS: Figure = Figure {
    key: "xyz",
    digits: 3,
    meaning: "Tristimulus value of the observer in force; 100 is the Y of the measured light.",
    said: " {}",
    ..NUMBER
};

const CHROMATICITY: Figure = Figure {
    key: "xy",
    meaning: "Chromaticity x, y: X and Y over X + Y + Z, no unit.",
    said: " {}",
    ..NUMBER
};

const CHROMATICITY_1976: Figure = Figure {
    key: "uv",
    meaning: "Chromaticity u′, v′ of CIE 1976, no unit.",
    ..NUMBER
};

const fn row(
    title: &'static str,
    figure: Figure,
    quantity: Option<Quantity>,
    of: fn(&Colour) -> Option<f64>,
) -> ColourFigure {
    let figure = Figure {
        title,
        short: title,
        ..figure
    };
    ColourFigure {
        figure,
        quantity,
        of,
    }
}

/// The figures of every colour.
pub static OF_COLOUR: [ColourFigure; 7] = [
    row(
        "X",
        Figure {
            said: "XYZ {}",
            ..TRISTIMULUS
        },
        None,
        |c| Some(c.xyz.x),
    ),
    row("Y", TRISTIMULUS, None, |c| Some(c.xyz.y)),
    row("Z", TRISTIMULUS, None, |c| Some(c.xyz.z)),
    row(
        "x",
        Figure {
            said: ", xy {}",
            ..CHROMATICITY
        },
        Some(Quantity::ChromaticityX),
        |c| Some(c.xy[0]),
    ),
    row("y", CHROMATICITY, Some(Quantity::ChromaticityY), |c| {
        Some(c.xy[1])
    }),
    row("u′", CHROMATICITY_1976, Some(Quantity::UPrime), |c| {
        Some(c.uv[0])
    }),
    row("v′", CHROMATICITY_1976, Some(Quantity::VPrime), |c| {
        Some(c.uv[1])
    }),
];

/// The figures that only lights have.
pub static OF_LIGHT: [ColourFigure; 2] = [
    row(
        "CCT",
        Figure {
            key: "cct",
            unit: Unit::Kelvin,
            digits: 0,
            meaning: "Correlated colour temperature, K (Ohno 2013, CIE 1931).",
            said: ", {}",
            ..NUMBER
        },
        Some(Quantity::Cct),
        |c| Some(c.cct?.ok()?.kelvin),
    ),
    row(
        "Duv",
        Figure {
            key: "duv",
            signed: true,
            meaning: "Distance from the blackbody locus in CIE 1960 uv; above it is positive.",
            said: ", Duv {}",
            ..NUMBER
        },
        Some(Quantity::Duv),
        |c| Some(c.cct?.ok()?.duv),
    ),
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
        let errors = Measure::ALL.map(Measure::figure);
        let colours = OF_COLOUR.iter().chain(&OF_LIGHT).map(|row| &row.figure);
        let keys: BTreeSet<&str> = errors.iter().map(|f| f.key).collect();
        assert_eq!(keys.len(), errors.len());
        for figure in errors.iter().chain(colours) {
            assert!(!figure.title.is_empty() && !figure.short.is_empty());
            assert!(figure.meaning.ends_with('.'), "{}", figure.title);
        }
        for measure in Measure::ALL {
            assert_ne!(SHARES.contains(&measure), measure.is_colour());
        }
        for measure in Measure::COMPARED {
            assert!(!measure.figure().goal.is_empty(), "{measure:?}");
            assert_eq!(
                measure.figure().unit == Unit::DeltaE,
                measure.is_colour(),
                "{measure:?}"
            );
        }
    }

    #[test]
    fn numbers_are_written_in_their_unit_and_zero_has_no_minus() {
        assert_eq!(Measure::Rms.figure().written(0.1234), "12.34 %");
        assert_eq!(Measure::Energy.figure().written(-1e-9), "+0.000 %");
        assert_eq!(Measure::Energy.figure().say(0.01), ", energy +1.000 %");
        assert_eq!(Measure::Own.figure().brief(Some(0.012_345)), "0.0123");
        assert_eq!(Measure::Rms.figure().brief(Some(1e-9)), "<0.0001 %");
        assert_eq!(Measure::Rms.figure().brief(None), "–");
        assert_eq!(Measure::Rms.figure().with_unit(), "rms at 1 nm, %");
        assert_eq!(OF_LIGHT[0].figure.written(6503.6), "6504 K");
    }
}
