//! The twelve figures that a client reads, each with its place on a bar and a word.

use std::sync::LazyLock;

use crate::{
    app::{
        combining::words::shown_value,
        comparison::{Better, Compared, Purpose, Side},
        entry::bundled_entries,
        numbers::fixed as figure_words,
        tint, verdicts,
    },
    color::quality::NoFigure,
    languages::{fixed, said, with_sign},
    measurements::{Doubted, Figure, rounded},
};

/// A figure in large type, of one light or of two.
#[derive(Clone, Debug, PartialEq)]
pub struct Tile {
    /// What it is about: "All colours".
    pub title: &'static str,
    /// What the figure is called: "Rf"; the unit where it has no name of its own.
    pub figure: &'static str,
    /// Why it matters, a sentence.
    pub why: &'static str,
    /// The ends of its bar.
    pub ends: [f64; 2],
    /// Where its bar begins: at an end, or at the value that is neither.
    pub from: f64,
    /// Each light's.
    pub sides: Vec<Told>,
    /// The place of the better of two lights.
    pub better: Option<usize>,
}

/// A light's figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Told {
    /// The number, or why there is none.
    pub value: Result<f64, String>,
    /// The number with its unit; a dash where there is none.
    pub shown: String,
    /// The half width of its 95 % interval, "± 0.4"; empty where that is not known.
    pub half: String,
    /// What it says; why there is none.
    pub word: String,
    /// How good that is, from 0 (good) to 3; `None` for what is a matter of taste.
    pub grade: Option<usize>,
}

/// The titles of the groups, each of four tiles.
pub const GROUPS: [&str; 3] = [
    later!("Colours"),
    later!("White and brightness"),
    later!("People, plants and cameras"),
];

/// Tiles of a group.
pub const IN_GROUP: usize = 4;

/// What a figure is and how it is read.
struct Kind {
    title: &'static str,
    of: Of,
    ends: [f64; 2],
    from: f64,
    word: fn(&Side, f64) -> String,
    /// Borders from good to bad, the highest first.
    grades: Option<[f64; 3]>,
}

/// Where a figure comes from.
enum Of {
    /// What lights are compared for.
    Purpose(&'static str),
    /// Its name, digits, why it matters, and the figure.
    Own {
        figure: &'static str,
        digits: usize,
        why: &'static str,
        of: fn(&Side) -> Result<f64, String>,
    },
}

const OF_SAMPLE: Option<[f64; 3]> = Some([90.0, 75.0, 50.0]);

/// The tiles, group by group.
static KINDS: [Kind; GROUPS.len() * IN_GROUP] = [
    Kind {
        title: later!("All colours"),
        of: Of::Purpose("colours"),
        ends: [0.0, 100.0],
        from: 0.0,
        word: |_, rf| verdicts::of_rf(rf).to_owned(),
        grades: Some([85.0, 70.0, 50.0]),
    },
    Kind {
        title: later!("Light skin"),
        of: Of::Purpose("skin"),
        ends: [0.0, 100.0],
        from: 0.0,
        word: |_, index| verdicts::of_sample(index).to_owned(),
        grades: OF_SAMPLE,
    },
    Kind {
        title: later!("Strong red"),
        of: Of::Purpose("reds"),
        ends: [0.0, 100.0],
        from: 0.0,
        word: of_red,
        grades: OF_SAMPLE,
    },
    Kind {
        title: later!("Vividness"),
        of: Of::Own {
            figure: "Rg",
            digits: 0,
            why: later!(
                "Rg is 100 where colours are as vivid on average as under the reference (TM-30)."
            ),
            of: |side| known(&side.figures.fidelity).map(|found| found.rg),
        },
        ends: [60.0, 140.0],
        from: 100.0,
        word: |_, rg| verdicts::vividness(rg),
        grades: None,
    },
    Kind {
        title: later!("White"),
        of: Of::Own {
            figure: "K",
            digits: 0,
            why: later!("The correlated colour temperature: low is warm, high is cool."),
            of: |side| known(&side.figures.cct).map(|cct| cct.kelvin),
        },
        ends: [1500.0, 8000.0],
        from: 1500.0,
        word: |side, _| {
            let cct = side.figures.cct.as_ref();
            cct.map_or_else(|_| String::new(), |cct| tint::name(*cct))
        },
        grades: None,
    },
    Kind {
        title: later!("Tint"),
        of: Of::Own {
            figure: "Duv",
            digits: 4,
            why: later!(
                "Duv is the distance from the line of blackbodies: green above it, pink below."
            ),
            of: |side| known(&side.figures.cct).map(|cct| cct.duv),
        },
        ends: [-0.02, 0.02],
        from: 0.0,
        word: |side, _| {
            let cct = side.figures.cct.as_ref();
            let tint = cct.map_or("", |cct| tint::tint(*cct));
            if tint.is_empty() {
                said!("no tint")
            } else {
                tint
            }
            .to_owned()
        },
        grades: None,
    },
    Kind {
        title: later!("Light for its power"),
        of: Of::Purpose("energy"),
        ends: [0.0, 500.0],
        from: 0.0,
        word: |_, lumens| {
            tr!(
                "{share} % of the most possible",
                share = fixed(100.0 * lumens / 683.0, 0)
            )
        },
        grades: None,
    },
    Kind {
        title: later!("Dark streets"),
        of: Of::Purpose("night"),
        ends: [0.0, 3.0],
        from: 0.0,
        word: |_, ratio| of_daylight(ratio, "night"),
        grades: None,
    },
    Kind {
        title: later!("Reading and work"),
        of: Of::Purpose("reading"),
        ends: [0.0, 100.0],
        from: 0.0,
        word: |_, ra| {
            // As the figure is printed, so that the word does not contradict it.
            let reaches = ra.round() >= 80.0;
            let words = match reaches {
                true => said!("reaches the 80 for desks"),
                false => said!("misses the 80 for desks"),
            };
            words.to_owned()
        },
        grades: Some([90.0, 79.5, 60.0]),
    },
    Kind {
        title: later!("Body clock"),
        of: Of::Purpose("day"),
        ends: [0.0, 1.5],
        from: 0.0,
        word: |_, der| of_daylight(der, "day"),
        grades: None,
    },
    Kind {
        title: later!("Plants"),
        of: Of::Purpose("plants"),
        ends: [0.0, 6.0],
        from: 0.0,
        word: |_, photons| of_daylight(photons, "plants"),
        grades: None,
    },
    Kind {
        title: later!("Cameras"),
        of: Of::Purpose("cameras"),
        ends: [0.0, 100.0],
        from: 0.0,
        word: |_, ssi| verdicts::of_cameras(ssi).to_owned(),
        grades: Some([90.0, 70.0, 0.0]),
    },
];

fn known<T: Clone>(figure: &Result<T, NoFigure>) -> Result<T, String> {
    figure.clone().map_err(|why| why.to_string())
}

/// How a strong red looks, and which way it went where hue by hue that is known.
fn of_red(side: &Side, index: f64) -> String {
    let looks = verdicts::of_sample(index);
    let red = side.figures.fidelity.as_ref().ok();
    let red = red.and_then(|found| found.bins[0].as_ref());
    match red.and_then(|bin| verdicts::of_chroma(&[bin.rcs])) {
        Some(way) if index < 90.0 => format!("{looks}, {way}"),
        _ => looks.to_owned(),
    }
}

/// A figure as a share of the daylight's.
fn of_daylight(value: f64, key: &str) -> String {
    let daylight = &*DAYLIGHT;
    let found = daylight.as_ref().zip(Purpose::of_key(key));
    let found = found.and_then(|(day, purpose)| purpose.figure_of(day).ok());
    found.map_or_else(String::new, |day| {
        tr!(
            "{share} % of daylight's",
            share = fixed(100.0 * value / day, 0)
        )
    })
}

/// Daylight of 6500 K.
static DAYLIGHT: LazyLock<Option<Side>> = LazyLock::new(|| {
    let found = bundled_entries()
        .iter()
        .find(|entry| entry.key == "cie_illuminants/CIE D65");
    found.map(|entry| Side::of("daylight".to_owned(), &entry.spectrum))
});

/// The tiles of a light, or of two that are compared.
/// `doubts` are what is known of each one's figures.
pub(super) fn tiles(
    sides: &[Side],
    compared: Option<&Compared>,
    doubts: &[Vec<Doubted>],
) -> Vec<Tile> {
    let tile = |kind: &Kind| kind.tile(sides, compared, doubts);
    KINDS.iter().map(tile).collect()
}

/// Whether a figure with its doubt is the one that a tile calls by this name.
fn is_of(doubted: &Doubted, name: &str) -> bool {
    match doubted.figure {
        Figure::Cct => name == "K",
        figure => figure.words() == name,
    }
}

impl Told {
    /// The number with its half width: `62.1 ± 0.4`.
    pub fn told(&self) -> String {
        [self.shown.as_str(), &self.half]
            .join(" ")
            .trim_end()
            .to_owned()
    }

    /// The same with a doubt: number and half width are rounded so that the last digit is worth
    /// writing.
    fn doubted(self, known: Option<&Doubted>) -> Self {
        let doubt = known.and_then(|known| known.doubt);
        let (Some(known), Some(doubt), Ok(_)) = (known, doubt, &self.value) else {
            return self;
        };
        let (shown, half) = rounded(shown_value(known.figure, &doubt), doubt.half_width_95);
        Self {
            shown: with_sign(shown),
            half: format!("\u{b1} {}", with_sign(half)),
            ..self
        }
    }
}

impl Kind {
    fn tile(&self, sides: &[Side], compared: Option<&Compared>, doubts: &[Vec<Doubted>]) -> Tile {
        let (figure, digits, why) = match self.of {
            Of::Purpose(key) => Purpose::of_key(key).map_or(("", 0, ""), |purpose| {
                let named = [purpose.figure, purpose.unit];
                let named = named.into_iter().find(|words| !words.is_empty());
                (named.unwrap_or_default(), purpose.digits, purpose.why)
            }),
            Of::Own {
                figure,
                digits,
                why,
                ..
            } => (figure, digits, why),
        };
        Tile {
            title: said(self.title),
            figure,
            why: said(why),
            ends: self.ends,
            from: self.from,
            sides: sides
                .iter()
                .enumerate()
                .map(|(place, side)| {
                    let told = self.told(side, digits);
                    let known = doubts.get(place).map_or(&[][..], |known| known);
                    told.doubted(known.iter().find(|doubted| is_of(doubted, figure)))
                })
                .collect(),
            better: compared.and_then(|compared| self.better(compared)),
        }
    }

    fn told(&self, side: &Side, digits: usize) -> Told {
        let value = match &self.of {
            Of::Purpose(key) => Purpose::of_key(key)
                .ok_or_else(String::new)
                .and_then(|purpose| purpose.figure_of(side)),
            Of::Own { of, .. } => of(side),
        };
        let grade = self
            .grades
            .zip(value.as_ref().ok())
            .map(|(borders, value)| {
                let reached = borders.iter().position(|border| *value >= *border);
                reached.unwrap_or(borders.len())
            });
        Told {
            shown: value
                .as_ref()
                .map_or_else(|_| "–".to_owned(), |value| figure_words(*value, digits)),
            word: match &value {
                Ok(value) => (self.word)(side, *value),
                Err(why) => why.clone(),
            },
            grade,
            value,
            half: String::new(),
        }
    }

    /// The better light, where the same figure is better for every purpose that it decides.
    fn better(&self, compared: &Compared) -> Option<usize> {
        let Of::Purpose(key) = self.of else {
            return None;
        };
        // The same light that rouses by day keeps people awake in the evening.
        let of_key = |better: &&Better| better.purpose.key == key && key != "day";
        compared.better.iter().find(of_key)?.winner()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::open;

    fn side(name: &str) -> Side {
        let entry = open::resolve(name, None, None).expect("a preset");
        Side::of(entry.name().to_owned(), &entry.spectrum)
    }

    #[test]
    fn every_tile_of_a_white_has_a_figure_on_its_bar_and_a_word() {
        let daylight = tiles(&[side("CIE D65")], None, &[]);
        assert_eq!(daylight.len(), GROUPS.len() * IN_GROUP);
        for tile in &daylight {
            let [told] = &tile.sides[..] else {
                panic!("{}", tile.title)
            };
            let value = *told.value.as_ref().expect(tile.title);
            let [low, high] = tile.ends;
            assert!((low..=high).contains(&value), "{} {value}", tile.title);
            assert!((low..=high).contains(&tile.from), "{}", tile.title);
            assert!(!told.word.is_empty() && !tile.why.is_empty());
            assert!(told.grade.is_none_or(|grade| grade == 0), "{}", tile.title);
            assert_eq!(tile.better, None);
        }
        let words = |title: &str| {
            let tile = daylight.iter().find(|tile| tile.title == title);
            tile.expect(title).sides[0].word.clone()
        };
        for title in ["Body clock", "Plants", "Dark streets"] {
            assert_eq!(words(title), "100 % of daylight's");
        }
    }

    #[test]
    fn of_two_lights_the_better_is_the_one_that_the_sentence_calls_better() {
        let compared = Compared::of([side("FL2"), side("LED-B1")]);
        let all = tiles(&compared.sides, Some(&compared), &[]);
        for better in &compared.better {
            let tile = KINDS
                .iter()
                .zip(&all)
                .find(|(kind, _)| matches!(kind.of, Of::Purpose(key) if key == better.purpose.key));
            let Some((_, tile)) = tile else { continue };
            let values = tile.sides.iter().map(|told| told.value.clone().ok());
            assert!(values.eq(better.values), "{}", tile.title);
            let winner = (better.purpose.key != "day").then(|| better.winner());
            assert_eq!(tile.better, winner.flatten(), "{}", tile.title);
        }
    }

    #[test]
    fn a_light_without_a_white_says_why_where_a_figure_would_stand() {
        // Redder than any blackbody: there is no reference.
        let neon = tiles(&[side("Neon tube")], None, &[]);
        let rf = &neon[0].sides[0];
        assert_eq!(rf.shown, "–");
        assert!(rf.value.is_err() && !rf.word.is_empty());
        assert!(neon.iter().any(|tile| tile.sides[0].value.is_ok()));
        // The yellow of sodium is near a blackbody's, and its Rf is as low as can be.
        let sodium = tiles(&[side("paper/Sodium")], None, &[]);
        let rf = &sodium[0].sides[0];
        assert_eq!((rf.shown.as_str(), rf.grade), ("0", Some(3)));
    }
}
