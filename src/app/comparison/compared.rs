//! Two lights compared for every purpose, and the sentence that sums it up.

use super::{better::Better, purpose::PURPOSES, rule::Which, side::Side};
use crate::{
    app::{ticks::short, tint::kelvin_words},
    languages::{said, with_colon},
    spectrum::Band,
};

/// Two lights compared.
#[derive(Clone, Debug)]
pub struct Compared {
    /// Both lights, A and B.
    pub sides: [Side; 2],
    /// Every purpose, in the order of [`PURPOSES`].
    pub better: Vec<Better>,
    /// Which light is better for what, in one sentence.
    pub summary: String,
    /// What is to be known beside it, a sentence each.
    pub notes: Vec<String>,
}

/// The purposes that the summary tells first.
const FIRST: [&str; 3] = ["colours", "skin", "energy"];

/// How many others it tells where none of them decides.
const OTHERS: usize = 3;

/// Colour temperatures that differ by more than this are told: each light has its own reference.
const OTHER_REFERENCE: f64 = 1.05;

impl Compared {
    /// Compares two lights. Where both have one name, "(A)" and "(B)" follow it.
    pub fn of(sides: [Side; 2]) -> Self {
        let (sides, shared) = Side::paired(sides);
        let better: Vec<Better> = PURPOSES
            .iter()
            .map(|purpose| Better::of(purpose, &sides))
            .collect();
        Self {
            summary: summary(&sides, &better),
            notes: notes(&sides, shared),
            sides,
            better,
        }
    }
}

fn summary(sides: &[Side; 2], better: &[Better]) -> String {
    let is_first = |b: &&Better| FIRST.contains(&b.purpose.key);
    let decided = |b: &&Better| b.winner().is_some();
    let mut chosen: Vec<&Better> = better.iter().filter(is_first).filter(decided).collect();
    if chosen.is_empty() {
        chosen = better.iter().filter(decided).take(OTHERS).collect();
    }
    if chosen.is_empty() {
        return undecided(sides, better);
    }
    let first = chosen[0].winner().unwrap_or(0);
    let clauses = [first, 1 - first].into_iter().filter_map(|place| {
        let wins = chosen.iter().filter(|b| b.winner() == Some(place));
        let mut last = "";
        let parts: Vec<String> = wins
            .filter_map(|b| {
                let (predicate, figures) = b.phrase.as_ref()?;
                let words = match last == predicate.verb {
                    true => &predicate.again,
                    false => &predicate.whole,
                };
                last = predicate.verb;
                // A per cent tells enough.
                Some(match b.purpose.figure {
                    "" => words.clone(),
                    _ => format!("{words} {figures}"),
                })
            })
            .collect();
        (!parts.is_empty()).then(|| format!("{} {}", sides[place].name, listed(&parts)))
    });
    let clauses: Vec<String> = clauses.collect();
    format!("{}.", clauses.join("; "))
}

/// The summary where no purpose has a better light.
fn undecided(sides: &[Side; 2], better: &[Better]) -> String {
    let same = better.iter().filter(|b| b.which == Some(Which::Same));
    let same: Vec<String> = same.map(|b| said(b.purpose.topic).to_owned()).collect();
    let [a, b] = sides.each_ref().map(|side| &side.name);
    match same.len() {
        0 => tr!("Nothing decides between {a} and {b}.", a, b),
        _ => tr!(
            "{a} and {b} are about the same for {purposes}.",
            a,
            b,
            purposes = listed(&same)
        ),
    }
}

/// Words with commas, and an "and" before the last.
fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => tr!("{list} and {last}", list = first.join(", "), last),
    }
}

fn notes(sides: &[Side; 2], shared: Option<Band>) -> Vec<String> {
    let mut notes = Vec::new();
    if let [Ok(a), Ok(b)] = sides.each_ref().map(|side| &side.figures.cct) {
        let [a, b] = [a.kelvin, b.kelvin];
        if a.max(b) > OTHER_REFERENCE * a.min(b) {
            notes.push(tr!(
                "Rf, Ra, R9, R13 and SSI compare each light with a reference of its own colour \
                 temperature, {first} and {second}.",
                first = kelvin_words(a),
                second = kelvin_words(b)
            ));
        }
    }
    if let Some(band) = shared {
        notes.push(tr!(
            "Energy and plants count the radiation of {from}-{to} nm, where both lights are known.",
            from = short(band.min_nm()),
            to = short(band.max_nm())
        ));
    }
    for side in sides {
        let of_side = side.figures.notes.iter();
        notes.extend(of_side.map(|note| with_colon(&side.name, format!("{note}."))));
    }
    notes.push(
        said!(
            "A spectrum does not tell how much power a lamp takes from the mains, whether it \
             flickers or what it costs."
        )
        .to_owned(),
    );
    notes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        app::{
            open,
            tint::{Whiteness, whiteness},
        },
        color::quality::EFFICACY,
        spectrum::{Kind, NamedSpectrum, Sampled},
    };

    fn side(name: &str) -> Side {
        let entry = open::resolve(name, None, None).expect("a preset");
        Side::of(entry.name().to_owned(), &entry.spectrum)
    }

    fn made(name: &str, first_nm: f64, step_nm: f64, values: Vec<f64>) -> Side {
        let spectrum = NamedSpectrum {
            name: name.to_owned(),
            kind: Kind::Light,
            unit: String::new(),
            scale: 1.0,
            samples: Sampled::even(first_nm, step_nm, values).expect("finite values"),
            notes: Vec::new(),
            source: String::new(),
        };
        Side::of(name.to_owned(), &spectrum)
    }

    fn compared(a: &str, b: &str) -> Compared {
        Compared::of([side(a), side(b)])
    }

    fn of<'c>(compared: &'c Compared, key: &str) -> &'c Better {
        let mut all = compared.better.iter();
        all.find(|b| b.purpose.key == key).expect(key)
    }

    #[test]
    fn a_tube_and_a_lamp_are_told_apart_by_their_own_figures() {
        let found = compared("FL2", "LED-B1");
        let figures = found.sides.each_ref().map(|side| &side.figures);
        let rf = figures.map(|f| f.fidelity.as_ref().unwrap().rf);
        let r13 = figures.map(|f| f.rendering.as_ref().unwrap().samples[12].index);
        assert_eq!(of(&found, "colours").values, rf.map(Some));
        assert_eq!(of(&found, "skin").values, r13.map(Some));
        // The digits in the sentences are those of the figures.
        let colours = format!(
            "LED-B1 shows colours better (Rf {:.0} against {:.0})",
            rf[1], rf[0]
        );
        assert_eq!(of(&found, "colours").words, format!("{colours}."));
        assert!(rf[1] - rf[0] >= 3.0 && rf[1] - rf[0] < 20.0, "{rf:?}");
        assert!(r13[1] - r13[0] >= 20.0, "{r13:?}");
        let skin = of(&found, "skin");
        assert!(
            skin.words
                .starts_with("LED-B1 shows light skin much better (R13 ")
        );
        assert!(found.summary.starts_with(&colours));
        assert!(found.summary.contains(" and light skin much better (R13 "));
        assert!(found.summary.contains("; FL2 gives "), "{}", found.summary);
        assert!(
            found
                .summary
                .ends_with(" % more light per watt of radiation.")
        );
    }

    #[test]
    fn turned_round_the_same_light_wins_everywhere() {
        for [a, b] in [["FL2", "LED-B1"], ["CIE A", "FL11"], ["HP1", "CIE D65"]] {
            let (one, other) = (compared(a, b), compared(b, a));
            assert_eq!(one.better.len(), PURPOSES.len());
            for (one, other) in one.better.iter().zip(&other.better) {
                let turned = other.which.map(|which| match which {
                    Which::A => Which::B,
                    Which::B => Which::A,
                    Which::Same => Which::Same,
                });
                assert_eq!(one.which, turned, "{a} {b} {}", one.purpose.key);
                if one.winner().is_some() {
                    assert_eq!(one.words, other.words);
                }
            }
        }
    }

    #[test]
    fn a_light_is_about_the_same_as_itself_under_two_names() {
        let found = compared("CIE D65", "CIE D65");
        for better in &found.better {
            assert_eq!(better.which, Some(Which::Same), "{}", better.words);
            assert!(better.words.starts_with("Both "), "{}", better.words);
        }
        assert!(
            found
                .summary
                .starts_with("CIE D65 (A) and CIE D65 (B) are about the same for colours"),
            "{}",
            found.summary
        );
    }

    #[test]
    fn what_suits_the_evening_less_suits_the_day_more() {
        let found = compared("CIE A", "CIE D65");
        assert_eq!(of(&found, "evening").which, Some(Which::A));
        assert_eq!(of(&found, "day").which, Some(Which::B));
        let words = &of(&found, "evening").words;
        assert!(
            words.starts_with("CIE A suits the evening much better"),
            "{words}"
        );
        // Both are their own references.
        assert_eq!(of(&found, "colours").which, Some(Which::Same));
        assert!(
            found.notes[0].contains("2860 K and 6500 K"),
            "{:?}",
            found.notes
        );
    }

    #[test]
    fn power_is_compared_where_both_lights_are_known() {
        // The same light, of which one table goes on into the infrared.
        let flat = |last_nm: u32| vec![1.0; (last_nm - 380 + 1) as usize];
        let sides = [
            made("short", 380.0, 1.0, flat(780)),
            made("long", 380.0, 1.0, flat(830)),
        ];
        let efficacy = |side: &Side| side.figures.single(&EFFICACY).unwrap();
        assert!(efficacy(&sides[0]) > 1.1 * efficacy(&sides[1]));
        let found = Compared::of(sides);
        for key in ["energy", "plants"] {
            let found = of(&found, key);
            assert_eq!(found.which, Some(Which::Same), "{}", found.words);
            assert_eq!(found.values[0], found.values[1]);
        }
        assert!(found.notes.iter().any(|note| note.contains("380-780 nm")));
    }

    #[test]
    fn photons_for_plants_are_counted_in_a_joule() {
        // At 500 nm a joule has 500 / 119.627 micromoles.
        let mut values = vec![0.0; 401];
        values[120] = 1.0;
        let narrow = made("narrow", 380.0, 1.0, values);
        let found = narrow.photon_efficacy().unwrap();
        assert!((found / (500.0 / 119.626_57) - 1.0).abs() < 1e-4, "{found}");
    }

    #[test]
    fn nothing_is_said_of_coloured_lights_and_of_no_light() {
        // A green hump on a flat ground, until the light is no white.
        let green = (1..60).find_map(|tenths| {
            let value = |nm: u32| {
                let off = (f64::from(nm) - 530.0) / 30.0;
                1.0 + 0.1 * f64::from(tenths) * (-off * off).exp()
            };
            let values = (380..=780).map(value).collect();
            let side = made("green", 380.0, 1.0, values);
            let cct = side.figures.cct.clone().ok()?;
            (whiteness(cct) == Whiteness::Coloured).then_some(side)
        });
        let green = Compared::of([green.expect("a coloured light with a CCT"), side("CIE A")]);
        for key in ["colours", "skin", "reds", "reading", "cameras"] {
            let found = of(&green, key);
            assert_eq!(found.which, None, "{}", found.words);
            assert!(
                found.words.ends_with(": green is a coloured light."),
                "{}",
                found.words
            );
        }
        assert!(of(&green, "energy").which.is_some());
        let laser = compared("Green laser pointer", "CIE A");
        let colours = &of(&laser, "colours").words;
        let start = "Nothing can be said of colours: Green laser pointer has no Rf (";
        assert!(colours.starts_with(start), "{colours}");
        let dark = Compared::of([side("CIE A"), made("dark", 380.0, 1.0, vec![0.0; 401])]);
        for better in &dark.better {
            assert_eq!(better.which, None, "{}", better.words);
            assert!(better.words.contains("dark has no "), "{}", better.words);
        }
        assert_eq!(dark.summary, "Nothing decides between CIE A and dark.");
    }

    #[test]
    fn every_sentence_is_one_and_fills_its_places() {
        let names = [
            "FL2",
            "FL4",
            "FL11",
            "LED-B1",
            "LED-RGB1",
            "HP1",
            "CIE A",
            "Neon tube",
        ];
        let mut whys = std::collections::BTreeSet::new();
        for a in names {
            for b in names {
                let found = compared(a, b);
                let sentences = found.better.iter().map(|b| &b.words);
                for words in sentences.chain([&found.summary]).chain(&found.notes) {
                    assert!(!words.contains(['{', '}']), "{words}");
                    assert!(!words.contains("  ") && !words.contains("NaN"), "{words}");
                    assert!(words.ends_with('.') && !words.ends_with(".."), "{words}");
                }
                whys.extend(found.better.iter().map(|b| b.which.map(Which::word)));
            }
        }
        assert_eq!(whys.len(), 4, "{whys:?}");
    }
}
