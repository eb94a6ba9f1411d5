//! Standard observers: colour-matching functions and the other weighting tables of the CIE.
//!
//! The numbers are in `presets/observers.json` with their sources and licence, never in code.

use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use super::weights::Weights;
use crate::{
    preset::{Body, Group, OBSERVERS},
    spectrum::{Band, Outside, Sampled},
};

/// A set of colour-matching functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Observer {
    /// CIE 1931 standard observer, 2 degree field.
    #[default]
    #[serde(rename = "1931")]
    Cie1931,
    /// CIE 1964 standard observer, 10 degree field.
    #[serde(rename = "1964")]
    Cie1964,
    /// CIE 2015 cone-fundamental-based observer, 2 degree field (CIE 170-2).
    #[serde(rename = "2015-2")]
    Cie2015Deg2,
    /// CIE 2015 cone-fundamental-based observer, 10 degree field (CIE 170-2).
    #[serde(rename = "2015-10")]
    Cie2015Deg10,
}

impl Observer {
    /// Every observer, in the order in which menus list them.
    pub const ALL: [Self; 4] = [
        Self::Cie1931,
        Self::Cie1964,
        Self::Cie2015Deg2,
        Self::Cie2015Deg10,
    ];

    /// The word used in files, in JSON and on the command line.
    pub fn word(self) -> &'static str {
        match self {
            Self::Cie1931 => "1931",
            Self::Cie1964 => "1964",
            Self::Cie2015Deg2 => "2015-2",
            Self::Cie2015Deg10 => "2015-10",
        }
    }

    /// The observer of a [`Observer::word`].
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL
            .into_iter()
            .find(|observer| observer.word() == word)
    }

    /// The name that people read.
    pub fn title(self) -> &'static str {
        match self {
            Self::Cie1931 => "CIE 1931, 2°",
            Self::Cie1964 => "CIE 1964, 10°",
            Self::Cie2015Deg2 => "CIE 2015, 2°",
            Self::Cie2015Deg10 => "CIE 2015, 10°",
        }
    }

    /// The colour-matching functions on whole nm, read once.
    pub fn table(self) -> &'static ColourMatching {
        static TABLES: LazyLock<[ColourMatching; 4]> = LazyLock::new(|| {
            Observer::ALL.map(|observer| ColourMatching::from_weightings(observer.table_names()))
        });
        match self {
            Self::Cie1931 => &TABLES[0],
            Self::Cie1964 => &TABLES[1],
            Self::Cie2015Deg2 => &TABLES[2],
            Self::Cie2015Deg10 => &TABLES[3],
        }
    }

    /// Names of the x-bar, y-bar and z-bar tables in the preset file.
    fn table_names(self) -> [&'static str; 3] {
        match self {
            Self::Cie1931 => [
                "CIE 1931 2deg xbar",
                "CIE 1931 2deg ybar",
                "CIE 1931 2deg zbar",
            ],
            Self::Cie1964 => [
                "CIE 1964 10deg xbar",
                "CIE 1964 10deg ybar",
                "CIE 1964 10deg zbar",
            ],
            Self::Cie2015Deg2 => [
                "CIE 2015 2deg xbar_F",
                "CIE 2015 2deg ybar_F",
                "CIE 2015 2deg zbar_F",
            ],
            Self::Cie2015Deg10 => [
                "CIE 2015 10deg xbar_F,10",
                "CIE 2015 10deg ybar_F,10",
                "CIE 2015 10deg zbar_F,10",
            ],
        }
    }
}

impl std::fmt::Display for Observer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.title())
    }
}

/// Colour-matching functions on every whole nm of their table, dimensionless.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourMatching {
    /// First tabulated wavelength, nm.
    pub first_nm: u32,
    /// Last tabulated wavelength, nm.
    pub last_nm: u32,
    /// x-bar, y-bar and z-bar, each with `last_nm - first_nm + 1` values.
    pub xyz: [Vec<f64>; 3],
}

impl ColourMatching {
    fn from_weightings(names: [&str; 3]) -> Self {
        let tables = names.map(bundled);
        let (first_nm, last_nm) = (tables[0].first_nm() as u32, tables[0].last_nm() as u32);
        Self {
            first_nm,
            last_nm,
            xyz: tables.map(|table| table.on_whole_nm(first_nm, last_nm, Outside::Zero)),
        }
    }

    /// The three functions at any wavelength: straight lines between whole nm, zero outside.
    pub fn at(&self, at_nm: f64) -> [f64; 3] {
        let x = at_nm - f64::from(self.first_nm);
        let last = (self.last_nm - self.first_nm) as usize;
        if !(x >= 0.0 && x <= last as f64) {
            return [0.0; 3];
        }
        let left = (x as usize).min(last - 1);
        let t = x - left as f64;
        std::array::from_fn(|k| self.xyz[k][left] * (1.0 - t) + self.xyz[k][left + 1] * t)
    }

    /// The three functions on the 1 nm grid of a band, zero outside the table.
    pub fn on_band(&self, band: Band) -> Weights {
        let mut rows: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(band.points()));
        for at_nm in band.grid() {
            for (row, value) in rows.iter_mut().zip(self.at(at_nm)) {
                row.push(value);
            }
        }
        Weights::new(band, rows)
    }

    /// [`ColourMatching::on_band`] times the band's trapezoid weights: with these rows XYZ is
    /// three plain sums of products, in value x nm.
    pub fn weighted_on_band(&self, band: Band) -> [Vec<f64>; 3] {
        self.on_band(band).each_ref().map(|row| {
            row.iter()
                .enumerate()
                .map(|(i, value)| value * band.weight(i))
                .collect()
        })
    }

    /// Sum of y-bar over the table (nm): the Y of a light that is 1 at every nm.
    ///
    /// Normalising constants come from this sum of the table in use, not from a pasted number.
    pub fn luminous_sum(&self) -> f64 {
        self.xyz[1].iter().sum()
    }

    /// Sums of the three functions over the table (nm).
    pub fn sums(&self) -> [f64; 3] {
        std::array::from_fn(|k| self.xyz[k].iter().sum())
    }
}

/// A weighting table by its name in `presets/observers.json`, such as `"V(lambda) photopic"`,
/// `"V'(lambda) scotopic"` or `"S026 s_mel (melanopic)"`; zero outside its wavelengths.
pub fn weighting(name: &str) -> Option<&'static Sampled> {
    WEIGHTINGS
        .iter()
        .find(|(known, _)| known == name)
        .map(|(_, table)| table)
}

static WEIGHTINGS: LazyLock<Vec<(String, Sampled)>> = LazyLock::new(|| {
    let group = Group::from_json(OBSERVERS).expect("a shipped file, read in a test of the presets");
    let weightings = group.items.into_iter().filter_map(|item| match item.body {
        Body::Spectrum(table) => Some((item.name, table.samples)),
        Body::Composite(_) | Body::Lines(_) => None,
    });
    weightings.collect()
});

/// A table that ships with the program; its absence is a broken build, which a test would show.
fn bundled(name: &str) -> &'static Sampled {
    weighting(name).unwrap_or_else(|| panic!("the observer file has no table named {name:?}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_observer_has_a_table_of_one_value_per_nm() {
        for observer in Observer::ALL {
            let table = observer.table();
            let count = (table.last_nm - table.first_nm + 1) as usize;
            assert!(
                table.xyz.iter().all(|row| row.len() == count),
                "{observer:?}"
            );
            assert_eq!(table.last_nm, 830);
        }
    }

    #[test]
    fn words_are_distinct_and_lead_back_to_their_observer() {
        for observer in Observer::ALL {
            assert_eq!(Observer::from_word(observer.word()), Some(observer));
        }
        assert_eq!(Observer::from_word("1932"), None);
    }

    #[test]
    fn the_light_that_is_equal_everywhere_is_nearly_neutral() {
        for observer in Observer::ALL {
            let [x, y, z] = observer.table().sums();
            // The functions were scaled to equal sums from finer tables; 4e-4 is what their
            // rounding to the published digits leaves (1931: 106.8655, 106.8569, 106.8923).
            assert!(
                (x / y - 1.0).abs() < 4e-4 && (z / y - 1.0).abs() < 4e-4,
                "{observer:?}"
            );
        }
    }

    #[test]
    fn between_whole_nm_the_functions_are_straight_and_outside_zero() {
        let table = Observer::Cie1931.table();
        let (left, right) = (table.at(555.0), table.at(556.0));
        let between = table.at(555.25);
        for k in 0..3 {
            // Both sides are the same straight line; only rounding differs.
            assert!((between[k] - (0.75 * left[k] + 0.25 * right[k])).abs() < 1e-15);
        }
        assert_eq!(left[1], 1.0);
        for outside_nm in [359.999, 830.001, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(table.at(outside_nm), [0.0; 3]);
        }
        assert_eq!(table.at(830.0)[1], table.xyz[1][470]);
    }

    #[test]
    fn a_band_wider_than_the_table_is_filled_with_zeros() {
        let band = Band::new(300.0, 900.0).unwrap();
        let rows = Observer::Cie1931.table().on_band(band);
        assert_eq!(rows[1].len(), 601);
        assert_eq!(rows[1][0], 0.0);
        assert_eq!(rows[1][255], 1.0, "555 nm");
        let weighted = Observer::Cie1931.table().weighted_on_band(Band::PAPER);
        let plain = Observer::Cie1931.table().on_band(Band::PAPER);
        assert_eq!(weighted[2][0], 0.5 * plain[2][0]);
        assert_eq!(weighted[2][1], plain[2][1]);
    }

    #[test]
    fn the_photopic_curve_is_the_y_function_of_1931() {
        let photopic = weighting("V(lambda) photopic").unwrap();
        assert_eq!(photopic.values(), Observer::Cie1931.table().xyz[1]);
        assert!(weighting("no such curve").is_none());
        assert!(weighting("S026 s_mel (melanopic)").is_some());
    }
}
