//! What lights are for, a row each: the figure, how it is compared, and its words.
//!
//! | purpose | figure | threshold |
//! |---|---|---|
//! | colours | Rf of TM-30 | 3 points, a mean difference of 0.45 in CAM02-UCS; much: 20 |
//! | skin, reds | R13, R9 of CIE 13.3 | 5 points, a difference of 1.1 in U*V*W*; much: 20 |
//! | reading | Ra | the 80 of EN 12464-1; where both miss it 5 points |
//! | evening, day | melanopic DER of CIE S 026 | a tenth; much: twofold |
//! | night | S/P ratio | a tenth; much: twofold |
//! | energy | luminous efficacy of radiation | 3 % |
//! | plants | photons of 400-700 nm per joule of radiation | 3 % |
//! | cameras | SSI to the light's own reference | 5 points; nothing where both are below 70 |
//!
//! The thresholds are this program's, but for the 80 of EN 12464-1.

mod wins;

use super::{rule::Rule, side::Side};

/// Something that a light is for.
#[derive(Clone, Copy, Debug)]
pub struct Purpose {
    /// Its word in JSON.
    pub key: &'static str,
    /// Its title on screen.
    pub title: &'static str,
    /// What the figure is called in a sentence; empty where the unit says enough.
    pub figure: &'static str,
    /// Unit of the figure, empty for pure numbers.
    pub unit: &'static str,
    /// Digits behind the point that are shown.
    pub digits: usize,
    /// Why this figure decides, a sentence.
    pub why: &'static str,
    /// The figure of a light, or why there is none.
    pub(super) of: fn(&Side) -> Result<f64, String>,
    /// How two of them are compared.
    pub(super) rule: Rule,
    /// What it is called in the middle of a sentence.
    pub(super) topic: &'static str,
    /// What is said of the better light.
    pub(super) wins: fn(Win) -> Predicate,
    /// What is said of both where they are about the same, with their figures.
    pub(super) same: fn(&str) -> String,
}

impl Purpose {
    /// The purpose of a key.
    pub fn of_key(key: &str) -> Option<&'static Self> {
        PURPOSES.iter().find(|purpose| purpose.key == key)
    }

    /// The figure of a light.
    ///
    /// # Errors
    /// Why there is none.
    pub fn figure_of(&self, side: &Side) -> Result<f64, String> {
        let value = (self.of)(side)?;
        let is_finite = value.is_finite();
        is_finite
            .then_some(value)
            .ok_or_else(|| tr!("{side} has no finite figure", side = side.name))
    }
}

/// Points of a single test colour's index.
const OF_SAMPLE: Rule = Rule::Points {
    same: 5.0,
    much: 20.0,
    least: f64::NEG_INFINITY,
};

const MELANOPIC: &str = later!("melanopic DER");

/// Every purpose, in the order in which they are told.
pub const PURPOSES: [Purpose; 10] = [
    Purpose {
        key: "colours",
        title: later!("Colours"),
        figure: "Rf",
        unit: "",
        digits: 0,
        why: later!(
            "Rf is the mean over 99 surfaces, each light beside its own reference (TM-30)."
        ),
        of: Side::rf,
        rule: Rule::Points {
            same: 3.0,
            much: 20.0,
            least: f64::NEG_INFINITY,
        },
        topic: later!("colours"),
        wins: wins::colours,
        same: colours_same,
    },
    Purpose {
        key: "skin",
        title: later!("Light skin"),
        figure: "R13",
        unit: "",
        digits: 0,
        why: later!(
            "R13 tells how far a light skin shifts from its colour under the reference (CIE 13.3)."
        ),
        of: Side::r13,
        rule: OF_SAMPLE,
        topic: later!("light skin"),
        wins: wins::skin,
        same: skin_same,
    },
    Purpose {
        key: "reds",
        title: later!("Strong reds"),
        figure: "R9",
        unit: "",
        digits: 0,
        why: later!(
            "R9 tells how far a strong red shifts from its colour under the reference (CIE 13.3)."
        ),
        of: Side::r9,
        rule: OF_SAMPLE,
        topic: later!("strong reds"),
        wins: wins::reds,
        same: reds_same,
    },
    Purpose {
        key: "reading",
        title: later!("Reading"),
        figure: "Ra",
        unit: "",
        digits: 0,
        why: later!("EN 12464-1 asks for an Ra of at least 80 where people read and write."),
        of: Side::ra,
        rule: Rule::Border {
            border: 80.0,
            same: 5.0,
        },
        topic: later!("reading"),
        wins: wins::reading,
        same: reading_same,
    },
    Purpose {
        key: "evening",
        title: later!("Evening"),
        figure: MELANOPIC,
        unit: "",
        digits: 2,
        why: later!(
            "Melanopic light keeps people awake; Brown et al. (2022) advise at most 10 lx of it \
             before bed."
        ),
        of: Side::melanopic,
        rule: Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better: true,
        },
        topic: later!("evening"),
        wins: wins::evening,
        same: evening_same,
    },
    Purpose {
        key: "day",
        title: later!("Day"),
        figure: MELANOPIC,
        unit: "",
        digits: 2,
        why: later!(
            "Melanopic light keeps people awake; Brown et al. (2022) advise at least 250 lx of it \
             by day."
        ),
        of: Side::melanopic,
        rule: Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better: false,
        },
        topic: later!("day"),
        wins: wins::day,
        same: day_same,
    },
    Purpose {
        key: "night",
        title: later!("Dark streets"),
        figure: later!("S/P ratio"),
        unit: "",
        digits: 2,
        why: later!(
            "Eyes that are used to the dark see by their rods, and the S/P ratio counts light as \
             rods do."
        ),
        of: Side::sp_ratio,
        rule: Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better: false,
        },
        topic: later!("dark streets"),
        wins: wins::night,
        same: night_same,
    },
    Purpose {
        key: "energy",
        title: later!("Energy"),
        figure: "",
        unit: "lm/W",
        digits: 0,
        why: later!(
            "Luminous efficacy of radiation is the light in a watt that leaves the lamp, not in a \
             watt that it takes from the mains."
        ),
        of: Side::efficacy,
        rule: Rule::Ratio {
            same: 1.03,
            much: f64::INFINITY,
            is_less_better: false,
        },
        topic: later!("energy"),
        wins: wins::energy,
        same: energy_same,
    },
    Purpose {
        key: "plants",
        title: later!("Plants"),
        figure: "",
        unit: "µmol/J",
        digits: 2,
        why: later!(
            "Photons of 400-700 nm drive photosynthesis; they are counted in each joule of \
             radiation."
        ),
        of: Side::photon_efficacy,
        rule: Rule::Ratio {
            same: 1.03,
            much: f64::INFINITY,
            is_less_better: false,
        },
        topic: later!("plants"),
        wins: wins::plants,
        same: plants_same,
    },
    Purpose {
        key: "cameras",
        title: later!("Cameras"),
        figure: "SSI",
        unit: "",
        digits: 0,
        why: later!(
            "SSI tells how like its reference a light is to any camera (SMPTE ST 2122); a low \
             value promises nothing."
        ),
        of: Side::ssi,
        rule: Rule::Points {
            same: 5.0,
            much: 20.0,
            least: 70.0,
        },
        topic: later!("cameras"),
        wins: wins::cameras,
        same: cameras_same,
    },
];

/// How much better the better light is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Win {
    pub is_much: bool,
    /// Larger over smaller figure; may be infinite.
    pub ratio: f64,
}

/// What is said of the better light, behind its name.
#[derive(Clone, Debug)]
pub(super) struct Predicate {
    /// Which verb it has: behind another one of the same verb `again` is said.
    pub verb: &'static str,
    pub whole: String,
    pub again: String,
}

impl Predicate {
    pub(super) fn new(verb: &'static str, [whole, again]: [impl Into<String>; 2]) -> Self {
        Self {
            verb,
            whole: whole.into(),
            again: again.into(),
        }
    }
}

fn colours_same(figures: &str) -> String {
    tr!(
        "Both shift colours by about the same amount {figures}.",
        figures
    )
}

fn skin_same(figures: &str) -> String {
    tr!(
        "Both shift light skin by about the same amount {figures}.",
        figures
    )
}

fn reds_same(figures: &str) -> String {
    tr!(
        "Both shift strong reds by about the same amount {figures}.",
        figures
    )
}

fn evening_same(figures: &str) -> String {
    tr!(
        "Both suit the evening about equally well at the same lux {figures}.",
        figures
    )
}

fn day_same(figures: &str) -> String {
    tr!(
        "Both suit the day about equally well at the same lux {figures}.",
        figures
    )
}

fn night_same(figures: &str) -> String {
    tr!(
        "Both give eyes that are used to the dark about the same light at the same lux {figures}.",
        figures
    )
}

fn energy_same(figures: &str) -> String {
    tr!(
        "Both give about the same light per watt of radiation {figures}.",
        figures
    )
}

fn plants_same(figures: &str) -> String {
    tr!(
        "Both give plants about the same photons per watt of radiation {figures}.",
        figures
    )
}

fn cameras_same(figures: &str) -> String {
    tr!("Both serve cameras about equally well {figures}.", figures)
}

/// Reading has a border, which lights reach or miss.
fn reading_same(figures: &str) -> String {
    reading_both(figures, true)
}

/// Both reach what reading asks for, or both miss it.
pub(super) fn reading_both(figures: &str, reach: bool) -> String {
    match reach {
        true => tr!(
            "Both reach the Ra of 80 that EN 12464-1 asks for at desks {figures}.",
            figures
        ),
        false => tr!(
            "Both miss the Ra of 80 that EN 12464-1 asks for at desks {figures}.",
            figures
        ),
    }
}

/// What is said of the light that comes nearer to what reading asks for.
pub(super) fn reading_nearer() -> Predicate {
    let words =
        said!("comes nearer to the Ra of 80 that EN 12464-1 asks for at desks, but misses it");
    Predicate::new("comes nearer", [words, words])
}
