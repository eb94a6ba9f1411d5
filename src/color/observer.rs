//! Standard observers: colour-matching functions and the other weighting tables of the CIE.
//!
//! The numbers are in `presets/observers.json` with their sources and licence, never in code.

use std::sync::{LazyLock, PoisonError, RwLock};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};

use super::weights::Weights;
use crate::{
    languages::with_sign,
    preset,
    spectrum::{Band, Outside, Sampled},
};

/// A set of colour-matching functions, shipped or of one's own: a handle that is as cheap as a
/// number, compared by what it stands for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Observer(u16);

/// Everything that is known of an observer.
#[derive(Debug)]
struct Known {
    word: String,
    title: String,
    source: String,
    table: ColourMatching,
}

/// The shipped group of their tables.
const GROUP: &str = "observers";

/// Observers of one's own, in the order in which they came. They live as long as the program: a
/// handle must stay true wherever it was put.
static OWN: RwLock<Vec<&'static Known>> = RwLock::new(Vec::new());

/// Most observers of one's own in one run of the program.
const MOST_OWN: usize = 1000;

/// Most whole nm of one table.
const MOST_NM: usize = 5000;

/// Words and titles of the CIE's observers, and what stands before and behind `xbar`, `ybar` and
/// `zbar` in the names of their tables. Of any other shipped observer the tables are called by its
/// name and the axis, as in "Judd-Vos 1978 xbar".
const CIE: [[&str; 4]; 4] = [
    ["1931", "CIE 1931, 2°", "CIE 1931 2deg", ""],
    ["1964", "CIE 1964, 10°", "CIE 1964 10deg", ""],
    ["2015-2", "CIE 2015, 2°", "CIE 2015 2deg", "_F"],
    ["2015-10", "CIE 2015, 10°", "CIE 2015 10deg", "_F,10"],
];

/// Why three columns are no observer.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ObserverError {
    /// The three functions do not share two whole nm, or more than any table has.
    #[error(
        "{}",
        tr!(
            "found {found} whole nm that all three functions cover, expected 2 to {most_nm}",
            found, most_nm = MOST_NM
        )
    )]
    Points {
        /// Number of whole nm they share.
        found: usize,
    },
    /// A value is no finite number.
    #[error("{}", said!("found a value that is no finite number, expected numbers"))]
    NotFinite,
    /// Nothing weighs luminance.
    #[error(
        "{}",
        tr!(
            "the second function sums to {sum}, expected more than 0: it weighs luminance",
            sum = with_sign(sum.to_string())
        )
    )]
    Dark {
        /// Its sum over the table, nm.
        sum: f64,
    },
    /// The list is full.
    #[error(
        "{}",
        tr!("found more than {most_own} observers of one's own in one run", most_own = MOST_OWN)
    )]
    TooMany,
}

impl Observer {
    /// CIE 1931 standard observer, 2 degree field.
    pub const CIE_1931: Self = Self(0);
    /// CIE 1964 standard observer, 10 degree field.
    pub const CIE_1964: Self = Self(1);
    /// CIE 2015 cone-fundamental-based observer, 2 degree field (CIE 170-2).
    pub(crate) const CIE_2015_2DEG: Self = Self(2);
    /// CIE 2015 cone-fundamental-based observer, 10 degree field (CIE 170-2).
    pub(crate) const CIE_2015_10DEG: Self = Self(3);

    /// The CIE's observers, which are shipped first.
    pub const CIE: [Self; 4] = [
        Self::CIE_1931,
        Self::CIE_1964,
        Self::CIE_2015_2DEG,
        Self::CIE_2015_10DEG,
    ];

    /// An observer of one's own: three functions of wavelength, the second of which weighs
    /// luminance (of a camera: its green). The same name and table lead to the same observer.
    ///
    /// # Errors
    /// [`ObserverError`] where the functions weigh nothing.
    pub fn own(name: &str, source: &str, table: ColourMatching) -> Result<Self, ObserverError> {
        table.check()?;
        let mut own = OWN.write().unwrap_or_else(PoisonError::into_inner);
        let same = |known: &&Known| known.word == name && known.table == table;
        let index = match own.iter().position(same) {
            Some(index) => index,
            None if own.len() == MOST_OWN => return Err(ObserverError::TooMany),
            None => {
                own.push(Box::leak(Box::new(Known {
                    word: name.to_owned(),
                    title: name.to_owned(),
                    source: source.to_owned(),
                    table,
                })));
                own.len() - 1
            }
        };
        Ok(Self((Self::tables().len() + index) as u16))
    }

    /// True if it ships with the program.
    pub(crate) fn is_shipped(self) -> bool {
        usize::from(self.0) < Self::tables().len()
    }

    /// The shipped observers, in the order in which menus list them.
    pub(crate) fn shipped() -> impl Iterator<Item = Self> {
        (0..Self::tables().len()).map(|index| Self(index as u16))
    }

    fn tables() -> &'static [Known] {
        static TABLES: LazyLock<Vec<Known>> = LazyLock::new(|| {
            let of = |word: &str, [title, before, behind]: [&str; 3]| Known {
                word: word.to_owned(),
                title: title.to_owned(),
                source: "presets/observers.json".to_owned(),
                table: ColourMatching::from_weightings(before, behind),
            };
            let items = preset::group(GROUP)
                .into_iter()
                .flat_map(|group| &group.items);
            let others = items
                .filter_map(|item| item.name.strip_suffix(" xbar"))
                .filter(|name| CIE.iter().all(|[_, _, before, _]| before != name))
                .map(|name| of(&name.to_lowercase().replace(' ', "-"), [name, name, ""]));
            let cie = CIE.map(|[word, rest @ ..]| of(word, rest));
            cie.into_iter().chain(others).collect()
        });
        &TABLES
    }

    fn known(self) -> &'static Known {
        let (index, shipped) = (usize::from(self.0), Self::tables());
        match index.checked_sub(shipped.len()) {
            None => &shipped[index],
            Some(own) => OWN.read().unwrap_or_else(PoisonError::into_inner)[own],
        }
    }

    /// The word used in files, in JSON and on the command line; the name of one's own.
    pub fn word(self) -> &'static str {
        &self.known().word
    }

    /// The shipped observer of a [`Observer::word`].
    pub(crate) fn from_word(word: &str) -> Option<Self> {
        Self::shipped().find(|observer| observer.word() == word)
    }

    /// The name that people read.
    pub(crate) fn title(self) -> &'static str {
        &self.known().title
    }

    /// Origin of the numbers.
    pub fn source(self) -> &'static str {
        &self.known().source
    }

    /// The colour-matching functions on whole nm.
    pub fn table(self) -> &'static ColourMatching {
        &self.known().table
    }
}

impl std::fmt::Display for Observer {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.title())
    }
}

/// An observer in a file: the word of a shipped one, the numbers of one's own.
#[derive(Serialize, Deserialize)]
#[serde(untagged)]
enum Stored {
    Shipped(String),
    Own {
        name: String,
        #[serde(default)]
        source: String,
        first_nm: u32,
        xyz: [Vec<f64>; 3],
    },
}

impl Serialize for Observer {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if self.is_shipped() {
            return Stored::Shipped(self.word().to_owned()).serialize(serializer);
        }
        let table = self.table();
        Stored::Own {
            name: self.word().to_owned(),
            source: self.source().to_owned(),
            first_nm: table.first_nm,
            xyz: table.xyz.clone(),
        }
        .serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Observer {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        match Stored::deserialize(deserializer)? {
            Stored::Shipped(word) => Self::from_word(&word).ok_or_else(|| {
                let shipped: Vec<&str> = Self::shipped().map(Self::word).collect();
                D::Error::custom(format!(
                    "found observer {word:?}, expected {} or a table",
                    shipped.join(", ")
                ))
            }),
            Stored::Own {
                name,
                source,
                first_nm,
                xyz,
            } => {
                let table = ColourMatching::new(first_nm, xyz).map_err(D::Error::custom)?;
                Self::own(&name, &source, table).map_err(D::Error::custom)
            }
        }
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
    /// Three functions on whole nm from `first_nm` on.
    ///
    /// # Errors
    /// [`ObserverError`] where they are not equally long, too short, or weigh no luminance.
    pub fn new(first_nm: u32, xyz: [Vec<f64>; 3]) -> Result<Self, ObserverError> {
        let found = xyz.iter().map(Vec::len).min().unwrap_or(0);
        let is_even = xyz.iter().all(|row| row.len() == found);
        if !is_even || !(2..=MOST_NM).contains(&found) || first_nm > 1_000_000 {
            return Err(ObserverError::Points { found });
        }
        let table = Self {
            first_nm,
            last_nm: first_nm + found as u32 - 1,
            xyz,
        };
        table.check().map(|()| table)
    }

    /// Three measured functions of any steps, read off on the whole nm that all of them cover.
    ///
    /// # Errors
    /// As [`ColourMatching::new`].
    pub fn of(functions: [&Sampled; 3]) -> Result<Self, ObserverError> {
        let first = functions.iter().map(|f| f.first_nm()).fold(0.0, f64::max);
        let last = functions
            .iter()
            .map(|f| f.last_nm())
            .fold(f64::MAX, f64::min);
        let points = last.floor() - first.ceil() + 1.0;
        if !(2.0..=MOST_NM as f64).contains(&points) {
            let found = points.clamp(0.0, 1e9) as usize;
            return Err(ObserverError::Points { found });
        }
        let (first_nm, last_nm) = (first.ceil() as u32, last.floor() as u32);
        let xyz = functions.map(|f| f.on_whole_nm(first_nm, last_nm, Outside::Zero));
        Self::new(first_nm, xyz)
    }

    fn check(&self) -> Result<(), ObserverError> {
        if !self.xyz.iter().flatten().all(|value| value.is_finite()) {
            return Err(ObserverError::NotFinite);
        }
        let sum = self.luminous_sum();
        if sum > 0.0 && sum.is_finite() {
            Ok(())
        } else {
            Err(ObserverError::Dark { sum })
        }
    }

    fn from_weightings(before: &str, behind: &str) -> Self {
        let table = |axis| bundled(&format!("{before} {axis}bar{behind}"));
        let tables = ["x", "y", "z"].map(table);
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
    pub(crate) fn weighted_on_band(&self, band: Band) -> [Vec<f64>; 3] {
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
    pub(crate) fn luminous_sum(&self) -> f64 {
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
    preset::table(GROUP, name)
}

/// A table that ships with the program; its absence is a broken build, which a test would show.
pub(super) fn bundled(name: &str) -> &'static Sampled {
    weighting(name).unwrap_or_else(|| panic!("the observer file has no table named {name:?}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_observer_has_a_table_of_one_value_per_nm() {
        for observer in Observer::shipped() {
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
    fn an_observer_of_ones_own_is_a_table_with_a_name_and_goes_through_files() {
        let cie = Observer::CIE_1964.table();
        let from_300 = |k: usize| {
            let values = (300..=900).map(|nm| cie.at(f64::from(nm))[k]);
            values.collect::<Vec<f64>>()
        };
        let table = ColourMatching::new(300, [0, 1, 2].map(from_300)).expect("a table");
        let own = Observer::own("mine", "a test", table.clone()).expect("it sees");
        assert_eq!(
            own,
            Observer::own("mine", "again", table).expect("the same")
        );
        assert!(!own.is_shipped() && Observer::CIE.iter().all(|shipped| *shipped != own));
        assert_eq!(
            (own.word(), own.title(), own.source()),
            ("mine", "mine", "a test")
        );
        let text = serde_json::to_string(&own).expect("JSON");
        assert_eq!(
            serde_json::from_str::<Observer>(&text).expect("its own"),
            own
        );
        let shipped = serde_json::to_string(&Observer::CIE_2015_2DEG).expect("JSON");
        assert_eq!(shipped, "\"2015-2\"");
        assert!(serde_json::from_str::<Observer>("\"1932\"").is_err());
        // Zeros beyond the table change nothing.
        let light = Sampled::new(vec![250.0, 1000.0], vec![1.0, 2.0]).expect("rising");
        let colour = |observer| crate::color::xyz_from_light(&light, Outside::Zero, observer);
        let [own, cie] = [own, Observer::CIE_1964].map(|o| colour(o).expect("seen").to_array());
        for (a, b) in own.iter().zip(cie) {
            // The same products summed in another order.
            assert!((a - b).abs() < 1e-10, "{a} {b}");
        }
    }

    #[test]
    fn three_columns_that_weigh_nothing_are_no_observer() {
        let of = |values: [f64; 3]| {
            ColourMatching::new(400, [vec![1.0; 3], values.to_vec(), vec![1.0; 3]])
        };
        assert!(of([0.1, 0.2, 0.1]).is_ok());
        assert_eq!(of([0.0, 0.0, 0.0]), Err(ObserverError::Dark { sum: 0.0 }));
        assert_eq!(of([0.0, f64::NAN, 1.0]), Err(ObserverError::NotFinite));
        let short = ColourMatching::new(400, [vec![1.0], vec![1.0], vec![1.0]]);
        assert_eq!(short, Err(ObserverError::Points { found: 1 }));
        let [a, b] = [(300.0, 400.0), (450.0, 700.0)]
            .map(|(from, to)| Sampled::new(vec![from, to], vec![1.0; 2]).expect("rising"));
        let apart = ColourMatching::of([&a, &b, &b]).expect_err("nothing shared");
        assert_eq!(apart, ObserverError::Points { found: 0 });
    }

    #[test]
    fn words_are_distinct_and_lead_back_to_their_observer() {
        for observer in Observer::shipped() {
            assert_eq!(Observer::from_word(observer.word()), Some(observer));
        }
        assert_eq!(Observer::from_word("1932"), None);
    }

    #[test]
    fn the_light_that_is_equal_everywhere_is_nearly_neutral() {
        for observer in Observer::shipped() {
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
        let table = Observer::CIE_1931.table();
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
        let rows = Observer::CIE_1931.table().on_band(band);
        assert_eq!(rows[1].len(), 601);
        assert_eq!(rows[1][0], 0.0);
        assert_eq!(rows[1][255], 1.0, "555 nm");
        let weighted = Observer::CIE_1931.table().weighted_on_band(Band::PAPER);
        let plain = Observer::CIE_1931.table().on_band(Band::PAPER);
        assert_eq!(weighted[2][0], 0.5 * plain[2][0]);
        assert_eq!(weighted[2][1], plain[2][1]);
    }

    #[test]
    fn the_photopic_curve_is_the_y_function_of_1931() {
        let photopic = weighting("V(lambda) photopic").unwrap();
        assert_eq!(photopic.values(), Observer::CIE_1931.table().xyz[1]);
        assert!(weighting("no such curve").is_none());
        assert!(weighting("S026 s_mel (melanopic)").is_some());
    }
}
