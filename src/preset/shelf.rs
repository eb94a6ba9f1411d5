//! The headings under which the window's library lists its items.

use std::fmt;

use serde::Deserialize;

/// The heading under which the window's library lists an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Deserialize)]
#[serde(try_from = "String")]
pub enum Shelf {
    /// CIE illuminants A, C, D, E, ID and incandescent lamps, which A stands for.
    Standard,
    /// Fluorescent lamps.
    Fluorescent,
    /// Light-emitting diodes.
    Led,
    /// Sodium, mercury, metal halide and xenon lamps.
    Discharge,
    /// The sun, the sky and the components of daylight.
    Sun,
    /// The three composites printed in the paper.
    Paper,
    /// Lists of atomic lines.
    Lines,
    /// Surfaces, test colours and metals.
    Reflectances,
    /// Transmittances.
    Filters,
    /// Colour-matching functions and other weighting functions.
    Observers,
}

impl Shelf {
    /// Every shelf, in the order in which the library shows them.
    pub const ALL: [Self; 10] = [
        Self::Standard,
        Self::Fluorescent,
        Self::Led,
        Self::Discharge,
        Self::Sun,
        Self::Paper,
        Self::Lines,
        Self::Reflectances,
        Self::Filters,
        Self::Observers,
    ];

    /// The heading, as it stands in files and on screen.
    pub(crate) fn heading(self) -> &'static str {
        match self {
            Self::Standard => later!("Standard lights"),
            Self::Fluorescent => later!("Fluorescent"),
            Self::Led => "LED",
            Self::Discharge => later!("Discharge"),
            Self::Sun => later!("Sun and sky"),
            Self::Paper => later!("The paper's lamps"),
            Self::Lines => later!("Line lamps"),
            Self::Reflectances => later!("Reflectances"),
            Self::Filters => later!("Filters and glasses"),
            Self::Observers => later!("Observers"),
        }
    }
}

impl fmt::Display for Shelf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.heading())
    }
}

impl TryFrom<String> for Shelf {
    type Error = String;

    fn try_from(heading: String) -> Result<Self, String> {
        let mut all = Self::ALL.into_iter();
        all.find(|shelf| shelf.heading() == heading)
            .ok_or_else(|| format!("shelf \"{heading}\", expected a heading of the library"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shelves_are_read_by_their_headings() {
        for shelf in Shelf::ALL {
            let word = format!("\"{}\"", shelf.heading());
            assert_eq!(
                serde_json::from_str::<Shelf>(&word).expect("a heading"),
                shelf
            );
        }
        let error = serde_json::from_str::<Shelf>("\"Attic\"").expect_err("no heading");
        assert!(error.to_string().contains("\"Attic\""), "{error}");
    }
}
