//! Figures of a colour, of the measured spectrum or of its model.

use super::{Figure, Unit, Words, number};
use crate::app::derived::Colour;

pub struct ColourFigure {
    /// What is said of it.
    pub figure: Figure,
    /// What computes it; `None` where it does not exist.
    pub of: fn(&Colour) -> Option<f64>,
}

const fn row(
    title: Words,
    said: Words,
    figure: Figure,
    of: fn(&Colour) -> Option<f64>,
) -> ColourFigure {
    let figure = Figure {
        title,
        short: title,
        said,
        ..figure
    };
    ColourFigure { figure, of }
}

const XYZ: Figure = number(
    "xyz",
    3,
    later!("Tristimulus value of the observer in force; 100 is the Y of the measured light."),
);
const XY: Figure = number("xy", 4, later!("Chromaticity x, y, no unit."));
const UV: Figure = number("uv", 4, later!("Chromaticity u′, v′ of CIE 1976, no unit."));
const CCT: Figure = Figure {
    unit: Unit::KELVIN,
    ..number(
        "cct",
        0,
        later!("Correlated colour temperature, K (Ohno 2013, CIE 1931)."),
    )
};
const DUV: Figure = Figure {
    signed: true,
    ..number(
        "duv",
        4,
        later!("Distance from the blackbody locus in CIE 1960 uv; above it is positive."),
    )
};

/// The figures of every colour.
pub static OF_COLOUR: [ColourFigure; 7] = [
    row("X", "XYZ {}", XYZ, |c| Some(c.xyz.x)),
    row("Y", " {}", XYZ, |c| Some(c.xyz.y)),
    row("Z", " {}", XYZ, |c| Some(c.xyz.z)),
    row("x", ", xy {}", XY, |c| Some(c.xy[0])),
    row("y", " {}", XY, |c| Some(c.xy[1])),
    row("u′", "", UV, |c| Some(c.uv[0])),
    row("v′", "", UV, |c| Some(c.uv[1])),
];

/// The figures that only lights have.
pub static OF_LIGHT: [ColourFigure; 2] = [
    row("CCT", ", {}", CCT, |c| Some(c.cct?.ok()?.kelvin)),
    row("Duv", ", Duv {}", DUV, |c| Some(c.cct?.ok()?.duv)),
];

/// Figures with the same key: a list in files, or one number.
pub fn by_key(figures: &[ColourFigure]) -> impl Iterator<Item = &[ColourFigure]> {
    figures.chunk_by(|a, b| a.figure.key == b.figure.key)
}
