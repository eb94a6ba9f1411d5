//! Ideal filters: all of the light or nothing, at any place.

use super::{RANGE_NM, by_formula, empty, item};
use crate::{
    preset::{Group, Preset, Shelf},
    spectrum::Kind,
};

/// Id of the group.
pub(super) const FILTERS: &str = "ideal_filters";

/// What an ideal filter lets through.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum IdealFilter {
    /// All above an edge, nm.
    LongPass(f64),
    /// All below an edge, nm.
    ShortPass(f64),
    /// All about a place: its middle and width, nm.
    BandPass(f64, f64),
    /// All but what lies about a place: its middle and width, nm.
    Notch(f64, f64),
}

/// Those that are listed: yellow, orange and red edges, blue and green ones, bands of the colours,
/// and what takes a laser's or sodium's line out.
const LISTED: [IdealFilter; 16] = [
    IdealFilter::LongPass(450.0),
    IdealFilter::LongPass(500.0),
    IdealFilter::LongPass(550.0),
    IdealFilter::LongPass(600.0),
    IdealFilter::LongPass(650.0),
    IdealFilter::ShortPass(450.0),
    IdealFilter::ShortPass(500.0),
    IdealFilter::ShortPass(550.0),
    IdealFilter::ShortPass(600.0),
    IdealFilter::BandPass(450.0, 50.0),
    IdealFilter::BandPass(500.0, 50.0),
    IdealFilter::BandPass(550.0, 50.0),
    IdealFilter::BandPass(600.0, 50.0),
    IdealFilter::BandPass(650.0, 50.0),
    IdealFilter::Notch(532.0, 20.0),
    IdealFilter::Notch(589.0, 20.0),
];

impl IdealFilter {
    /// What it is called: "Ideal band-pass 546 nm, 10 nm wide".
    pub(super) fn name(self) -> String {
        match self {
            Self::LongPass(edge) => format!("Ideal long-pass {edge} nm"),
            Self::ShortPass(edge) => format!("Ideal short-pass {edge} nm"),
            Self::BandPass(middle, width) => {
                format!("Ideal band-pass {middle} nm, {width} nm wide")
            }
            Self::Notch(middle, width) => format!("Ideal notch {middle} nm, {width} nm wide"),
        }
    }

    /// The filter that a name asks for: its own one, or "long-pass 550", "band-pass 546/10";
    /// `None` for other words and for edges that no table holds.
    pub(super) fn from_name(name: &str) -> Option<Self> {
        let lower = name.trim().to_lowercase();
        let rest = lower.strip_prefix("ideal").unwrap_or(&lower).trim_start();
        let (word, rest) = rest.split_at(rest.find(|c: char| c.is_ascii_digit())?);
        let word: String = word.chars().filter(char::is_ascii_lowercase).collect();
        let numbers: Option<Vec<f64>> = rest
            .split(|c: char| c == '/' || c == ',' || c.is_whitespace())
            .filter(|piece| !matches!(*piece, "" | "nm" | "wide"))
            .map(|piece| piece.trim_end_matches("nm").parse().ok())
            .collect();
        let filter = match (word.as_str(), &numbers?[..]) {
            ("longpass", [edge]) => Self::LongPass(*edge),
            ("shortpass", [edge]) => Self::ShortPass(*edge),
            ("bandpass", [middle, width]) => Self::BandPass(*middle, *width),
            ("notch", [middle, width]) => Self::Notch(*middle, *width),
            _ => return None,
        };
        filter.is_in_range().then_some(filter)
    }

    /// The share of light that it lets through at a wavelength, 0-1: an edge is one nm wide, so
    /// that what passes, summed over whole nm, has the edge's place to the last digit.
    pub(super) fn share_at(self, at_nm: f64) -> f64 {
        let above = |edge: f64| (at_nm - edge + 0.5).clamp(0.0, 1.0);
        match self {
            Self::LongPass(edge) => above(edge),
            Self::ShortPass(edge) => 1.0 - above(edge),
            Self::BandPass(middle, width) => {
                above(middle - 0.5 * width) - above(middle + 0.5 * width)
            }
            Self::Notch(middle, width) => {
                1.0 - above(middle - 0.5 * width) + above(middle + 0.5 * width)
            }
        }
    }

    fn is_in_range(self) -> bool {
        let [first, last] = RANGE_NM;
        let inside = |nm: f64| (first..=last).contains(&nm);
        match self {
            Self::LongPass(edge) | Self::ShortPass(edge) => inside(edge),
            Self::BandPass(middle, width) | Self::Notch(middle, width) => {
                width >= 1.0 && inside(middle - 0.5 * width) && inside(middle + 0.5 * width)
            }
        }
    }

    fn preset(self, group: &Group) -> Option<Preset> {
        let samples = by_formula(|nm| self.share_at(nm))?;
        let notes = vec![
            "Made by this program: all of the light or nothing, each edge one nm wide. No glass \
             and no coating does that."
                .to_owned(),
        ];
        Some(item(group, &self.name(), "fraction", notes, samples))
    }
}

/// The filters that are listed.
pub(super) fn group() -> Group {
    let mut group = bare();
    group.items = LISTED
        .iter()
        .filter_map(|filter| filter.preset(&group))
        .collect();
    group
}

/// A filter that is not listed, by its name.
pub(super) fn on_demand(name: &str) -> Option<Preset> {
    IdealFilter::from_name(name)?.preset(&bare())
}

fn bare() -> Group {
    empty(
        FILTERS,
        "Ideal filters, made: long-pass, short-pass, band-pass and notch at any place",
        Shelf::Filters,
        Kind::Transmittance,
        "made by this program",
    )
}
