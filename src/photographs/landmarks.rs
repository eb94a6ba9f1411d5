//! Positions at which the lines of lamps appear as peaks, by slit width.

use std::{collections::BTreeMap, sync::OnceLock};

use serde::Deserialize;

const FILE: &str = include_str!("../../presets/photograph_landmarks.json");

/// A lamp whose lines are known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Lamp {
    /// Compact and tubular fluorescent lamps of three bands.
    Fluorescent,
    /// Mercury lamps and tubes of one phosphor.
    Mercury,
    /// High-pressure sodium.
    Sodium,
    Neon,
    Argon,
    Krypton,
    Xenon,
    Hydrogen,
    Helium,
    /// The sky or the sun: dark lines.
    Daylight,
}

impl Lamp {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Fluorescent,
        Self::Mercury,
        Self::Sodium,
        Self::Neon,
        Self::Argon,
        Self::Krypton,
        Self::Xenon,
        Self::Hydrogen,
        Self::Helium,
        Self::Daylight,
    ];

    /// Name, also on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fluorescent => later!("fluorescent"),
            Self::Mercury => later!("mercury"),
            Self::Sodium => later!("sodium"),
            Self::Neon => later!("neon"),
            Self::Argon => later!("argon"),
            Self::Krypton => later!("krypton"),
            Self::Xenon => later!("xenon"),
            Self::Hydrogen => later!("hydrogen"),
            Self::Helium => later!("helium"),
            Self::Daylight => later!("daylight"),
        }
    }

    /// The lamp of a name.
    pub fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|lamp| lamp.name() == name)
    }

    /// Prior log-likelihood relative to the commonest lamps.
    pub(super) fn prior(self) -> f64 {
        match self {
            Self::Fluorescent | Self::Mercury | Self::Daylight => 0.0,
            Self::Sodium | Self::Neon => -0.5,
            Self::Hydrogen | Self::Helium => -1.0,
            Self::Argon | Self::Krypton | Self::Xenon => -2.0,
        }
    }

    /// By how much an axis must be better than one that is elsewhere to be used at once.
    pub(super) fn least_margin(self) -> f64 {
        match self {
            // Dark lines are many and alike.
            Self::Daylight => 7.0,
            _ if self.crowds() => 6.0,
            _ => 4.0,
        }
    }

    /// Its lines crowd at the blue end: a group of others can slip by one.
    pub(super) fn crowds(self) -> bool {
        matches!(self, Self::Argon | Self::Krypton | Self::Xenon)
    }

    /// Its lines are dark.
    pub fn is_dark(self) -> bool {
        self == Self::Daylight
    }

    /// Its landmarks, one table a slit width.
    pub fn tables(self) -> &'static [Table] {
        &tables()[&self]
    }
}

/// A peak that a lamp makes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Landmark {
    /// Its place.
    pub nm: f64,
    /// Scatter of the place from lamp to lamp.
    pub scatter_nm: f64,
    /// Probability of a peak of its own.
    pub chance: f64,
    /// Its height over the brightest column.
    pub strength: f64,
    /// The peak as it is where over-exposed.
    pub is_clipped: bool,
}

/// A lamp's landmarks through a slit.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Width that the slit gives a line.
    pub slit_nm: f64,
    /// By their place.
    pub landmarks: Vec<Landmark>,
}

#[derive(Deserialize)]
struct File {
    slit_fwhm_nm: Vec<f64>,
    lamps: BTreeMap<String, BTreeMap<String, Vec<[f64; 5]>>>,
}

fn tables() -> &'static BTreeMap<Lamp, Vec<Table>> {
    static TABLES: OnceLock<BTreeMap<Lamp, Vec<Table>>> = OnceLock::new();
    TABLES.get_or_init(|| {
        let file: File = serde_json::from_str(FILE).expect("a shipped file, read in a test");
        let of_lamp = |lamp: Lamp| {
            let slits = &file.lamps[lamp.name()];
            let table = |slit: &f64| Table {
                slit_nm: *slit,
                landmarks: landmarks(&slits[&format!("{slit:.1}")]),
            };
            (lamp, file.slit_fwhm_nm.iter().map(table).collect())
        };
        Lamp::ALL.into_iter().map(of_lamp).collect()
    })
}

fn landmarks(rows: &[[f64; 5]]) -> Vec<Landmark> {
    let landmark = |&[nm, scatter_nm, chance, strength, clipped]: &[f64; 5]| Landmark {
        nm,
        scatter_nm,
        chance,
        strength,
        is_clipped: clipped != 0.0,
    };
    let mut landmarks: Vec<Landmark> = rows.iter().map(landmark).collect();
    landmarks.sort_by(|a, b| a.nm.total_cmp(&b.nm));
    landmarks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_lamp_has_its_tables_for_all_slits_with_places_that_rise() {
        for lamp in Lamp::ALL {
            assert_eq!(Lamp::named(lamp.name()), Some(lamp));
            let slits: Vec<f64> = lamp.tables().iter().map(|t| t.slit_nm).collect();
            assert_eq!(slits, [1.0, 1.4, 2.0, 2.8, 4.0, 5.6, 8.0]);
            for table in lamp.tables() {
                assert!(table.landmarks.len() >= 7, "{lamp:?}");
                assert!(table.landmarks.is_sorted_by(|a, b| a.nm <= b.nm));
                for l in &table.landmarks {
                    assert!((380.0..800.0).contains(&l.nm), "{l:?}");
                    assert!(l.chance > 0.0 && l.chance <= 1.0 && l.scatter_nm > 0.0);
                    assert!(l.strength > 0.0 && l.strength < 1.1, "{l:?}");
                }
            }
        }
        assert_eq!(Lamp::named("candle"), None);
    }
}
