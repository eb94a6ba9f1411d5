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
    /// What is said of the better light: a verb and what follows it. `{better}` is "better" or
    /// "much better", `{more}` is "8 % more" or "2.3 times the".
    pub(super) wins: [&'static str; 2],
    /// What is said of both where they are about the same, after "Both".
    pub(super) both: &'static str,
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
            .ok_or_else(|| format!("{} has no finite figure", side.name))
    }
}

/// Points of a single test colour's index.
const OF_SAMPLE: Rule = Rule::Points {
    same: 5.0,
    much: 20.0,
    least: f64::NEG_INFINITY,
};

const MELANOPIC: &str = "melanopic DER";

/// Every purpose, in the order in which they are told.
pub const PURPOSES: [Purpose; 10] = [
    Purpose {
        key: "colours",
        title: "Colours",
        figure: "Rf",
        unit: "",
        digits: 0,
        why: "Rf is the mean over 99 surfaces, each light beside its own reference (TM-30).",
        of: Side::rf,
        rule: Rule::Points {
            same: 3.0,
            much: 20.0,
            least: f64::NEG_INFINITY,
        },
        wins: ["shows", "colours {better}"],
        both: "shift colours by about the same amount",
    },
    Purpose {
        key: "skin",
        title: "Light skin",
        figure: "R13",
        unit: "",
        digits: 0,
        why: "R13 tells how far a light skin shifts from its colour under the reference (CIE 13.3).",
        of: Side::r13,
        rule: OF_SAMPLE,
        wins: ["shows", "light skin {better}"],
        both: "shift light skin by about the same amount",
    },
    Purpose {
        key: "reds",
        title: "Strong reds",
        figure: "R9",
        unit: "",
        digits: 0,
        why: "R9 tells how far a strong red shifts from its colour under the reference (CIE 13.3).",
        of: Side::r9,
        rule: OF_SAMPLE,
        wins: ["shows", "strong reds {better}"],
        both: "shift strong reds by about the same amount",
    },
    Purpose {
        key: "reading",
        title: "Reading",
        figure: "Ra",
        unit: "",
        digits: 0,
        why: "EN 12464-1 asks for an Ra of at least 80 where people read and write.",
        of: Side::ra,
        rule: Rule::Border {
            border: 80.0,
            same: 5.0,
        },
        wins: ["", "the Ra of 80 that EN 12464-1 asks for at desks"],
        both: "the Ra of 80 that EN 12464-1 asks for at desks",
    },
    Purpose {
        key: "evening",
        title: "Evening",
        figure: MELANOPIC,
        unit: "",
        digits: 2,
        why: "Melanopic light keeps people awake; Brown et al. (2022) advise at most 10 lx of it \
              before bed.",
        of: Side::melanopic,
        rule: Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better: true,
        },
        wins: ["suits", "the evening {better} at the same lux"],
        both: "suit the evening about equally well at the same lux",
    },
    Purpose {
        key: "day",
        title: "Day",
        figure: MELANOPIC,
        unit: "",
        digits: 2,
        why: "Melanopic light keeps people awake; Brown et al. (2022) advise at least 250 lx of it \
              by day.",
        of: Side::melanopic,
        rule: Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better: false,
        },
        wins: ["suits", "the day {better} at the same lux"],
        both: "suit the day about equally well at the same lux",
    },
    Purpose {
        key: "night",
        title: "Dark streets",
        figure: "S/P ratio",
        unit: "",
        digits: 2,
        why: "Eyes that are used to the dark see by their rods, and the S/P ratio counts light as \
              rods do.",
        of: Side::sp_ratio,
        rule: Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better: false,
        },
        wins: [
            "gives",
            "eyes that are used to the dark {more} light at the same lux",
        ],
        both: "give eyes that are used to the dark about the same light at the same lux",
    },
    Purpose {
        key: "energy",
        title: "Energy",
        figure: "",
        unit: "lm/W",
        digits: 0,
        why: "Luminous efficacy of radiation is the light in a watt that leaves the lamp, not in a \
              watt that it takes from the mains.",
        of: Side::efficacy,
        rule: Rule::Ratio {
            same: 1.03,
            much: f64::INFINITY,
            is_less_better: false,
        },
        wins: ["gives", "{more} light per watt of radiation"],
        both: "give about the same light per watt of radiation",
    },
    Purpose {
        key: "plants",
        title: "Plants",
        figure: "",
        unit: "µmol/J",
        digits: 2,
        why: "Photons of 400-700 nm drive photosynthesis; they are counted in each joule of \
              radiation.",
        of: Side::photon_efficacy,
        rule: Rule::Ratio {
            same: 1.03,
            much: f64::INFINITY,
            is_less_better: false,
        },
        wins: ["gives", "plants {more} photons per watt of radiation"],
        both: "give plants about the same photons per watt of radiation",
    },
    Purpose {
        key: "cameras",
        title: "Cameras",
        figure: "SSI",
        unit: "",
        digits: 0,
        why: "SSI tells how like its reference a light is to any camera (SMPTE ST 2122); a low \
              value promises nothing.",
        of: Side::ssi,
        rule: Rule::Points {
            same: 5.0,
            much: 20.0,
            least: 70.0,
        },
        wins: ["serves", "cameras {better}"],
        both: "serve cameras about equally well",
    },
];
