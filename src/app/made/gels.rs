//! Stage gels: the colours that lighting designers name, as smooth curves by a formula, and the two
//! that turn daylight into a bulb's white and back.

use super::{by_formula, empty, item};
use crate::{
    color::blackbody,
    preset::{Group, Preset, Shelf},
    spectrum::Kind,
};

/// Id of the group.
pub(super) const GELS: &str = "stage_gels";

/// The share that a dye lets through where it takes nothing, and the width of its edges, nm.
const CLEAR: f64 = 0.88;
const EDGE_NM: f64 = 9.0;

/// The range over which a gel that converts whites keeps the ratio of the blackbodies, nm.
const CONVERTED_NM: [f64; 2] = [380.0, 780.0];

/// One gel.
#[derive(Clone, Copy, Debug)]
enum Gel {
    /// A dye that lets a band through: its edges, nm, and the share that passes beside it.
    Passes(f64, f64, f64),
    /// A dye that stops a band: its edges, nm, and the share that passes within.
    Stops(f64, f64, f64),
    /// A gel that turns the white of one blackbody into that of another, K.
    Converts(f64, f64),
}

/// The names, warm ones first, as swatch books have them.
const NAMED: [(&str, Gel); 13] = [
    ("Straw gel", Gel::Passes(505.0, f64::INFINITY, 0.45)),
    ("Amber gel", Gel::Passes(535.0, f64::INFINITY, 0.08)),
    ("Orange gel", Gel::Passes(565.0, f64::INFINITY, 0.06)),
    ("Red gel", Gel::Passes(605.0, f64::INFINITY, 0.03)),
    ("Pink gel", Gel::Stops(470.0, 565.0, 0.45)),
    ("Magenta gel", Gel::Stops(485.0, 600.0, 0.06)),
    ("Lavender gel", Gel::Stops(505.0, 620.0, 0.35)),
    ("Blue gel", Gel::Passes(f64::NEG_INFINITY, 490.0, 0.03)),
    (
        "Steel blue gel",
        Gel::Passes(f64::NEG_INFINITY, 560.0, 0.45),
    ),
    ("Cyan gel", Gel::Passes(f64::NEG_INFINITY, 575.0, 0.05)),
    ("Green gel", Gel::Passes(495.0, 575.0, 0.05)),
    (
        "Warming gel 5600 K to 3200 K",
        Gel::Converts(5600.0, 3200.0),
    ),
    (
        "Cooling gel 3200 K to 5600 K",
        Gel::Converts(3200.0, 5600.0),
    ),
];

impl Gel {
    /// The share of light that it lets through at a wavelength, 0-1.
    fn share_at(self, at_nm: f64) -> f64 {
        // 0 far below an edge, 1 far above it.
        let above = |edge: f64| 1.0 / (1.0 + ((edge - at_nm) / EDGE_NM).exp());
        let band = |from, to| above(from) * (1.0 - above(to));
        match self {
            Self::Passes(from, to, beside) => beside + (CLEAR - beside) * band(from, to),
            Self::Stops(from, to, within) => CLEAR - (CLEAR - within) * band(from, to),
            Self::Converts(from, to) => {
                let [first, last] = CONVERTED_NM;
                let ratio = |nm: f64| blackbody::radiance(nm, to) / blackbody::radiance(nm, from);
                // The ratio rises or falls throughout, so one end has the most.
                let most = ratio(first).max(ratio(last));
                CLEAR * ratio(at_nm.clamp(first, last)) / most
            }
        }
    }

    fn note(self) -> &'static str {
        match self {
            Self::Converts(..) => {
                "Made by this program: the ratio of two blackbodies from 380 to 780 nm. A maker's \
                 gel only comes near it."
            }
            _ => {
                "Made by this program: a smooth curve of this colour, and no maker's gel. Open the \
                 maker's table as CSV for a real one."
            }
        }
    }
}

/// All of them.
pub(super) fn group() -> Group {
    let mut group = empty(
        GELS,
        "Gels of the theatre, made: the colours by their names, and the two that convert whites",
        Shelf::Filters,
        Kind::Transmittance,
        "made by this program",
    );
    let made = NAMED.iter().filter_map(|(name, gel)| -> Option<Preset> {
        let samples = by_formula(|nm| gel.share_at(nm))?;
        Some(item(
            &group,
            name,
            "fraction",
            vec![gel.note().to_owned()],
            samples,
        ))
    });
    group.items = made.collect();
    group
}
