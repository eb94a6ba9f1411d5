//! One purpose of two lights: the values, which is better, and a sentence.

use super::{
    purpose::Purpose,
    rule::{Found, Which},
    side::Side,
};
use crate::app::numbers::fixed;

/// Which of two lights is better for something.
#[derive(Clone, Debug)]
pub struct Better {
    pub purpose: &'static Purpose,
    /// The figure of either light, where it has one.
    pub values: [Option<f64>; 2],
    /// Which is better; `None` where that cannot be said.
    pub which: Option<Which>,
    /// A sentence with both figures, or why nothing can be said.
    pub words: String,
    /// Verb, object and figures of the better light's sentence; empty where there is none.
    pub(super) phrase: [String; 3],
}

impl Better {
    /// Compares two lights for a purpose.
    pub(super) fn of(purpose: &'static Purpose, sides: &[Side; 2]) -> Self {
        let found = sides.each_ref().map(|side| purpose.figure_of(side));
        let values = found.each_ref().map(|value| value.as_ref().ok().copied());
        let known = match &found {
            [Ok(a), Ok(b)] => Ok([*a, *b]),
            all => {
                let whys = all.iter().filter_map(|value| value.as_ref().err());
                let whys: Vec<&str> = whys.map(String::as_str).collect();
                Err(whys.join("; "))
            }
        };
        let (which, words, phrase) = match known {
            Ok(known) => told(purpose, sides, known),
            Err(why) => (None, nothing(purpose, &why), Default::default()),
        };
        Self {
            purpose,
            values,
            which,
            words,
            phrase,
        }
    }

    /// The place of the better light, 0 or 1.
    pub fn winner(&self) -> Option<usize> {
        self.which.and_then(Which::place)
    }
}

/// The sentence where nothing can be said.
fn nothing(purpose: &Purpose, why: &str) -> String {
    format!(
        "Nothing can be said of {}: {why}.",
        purpose.title.to_lowercase()
    )
}

fn told(
    purpose: &Purpose,
    sides: &[Side; 2],
    values: [f64; 2],
) -> (Option<Which>, String, [String; 3]) {
    let shown = values.map(|value| fixed(value, purpose.digits));
    let found = match purpose.rule.of(values) {
        // What the digits do not show is no difference to a reader.
        Found::Better { .. } if shown[0] == shown[1] => Found::Same,
        found => found,
    };
    let [a, b] = &shown;
    let named = |figures: String| {
        let words = [purpose.figure, &figures, purpose.unit];
        let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
        format!("({})", words.join(" "))
    };
    let both = named(format!("{a} and {b}"));
    let against = |place: usize| named(format!("{} against {}", shown[place], shown[1 - place]));
    let [verb, rest] = purpose.wins;
    let phrase = |place: usize, verb: &str, object: String| {
        let phrase = [verb.to_owned(), object, against(place)];
        let words = format!("{} {}.", sides[place].name, phrase.join(" "));
        (words, phrase)
    };
    let (words, phrase) = match found {
        Found::Better {
            place,
            is_much,
            ratio,
        } => {
            let better = if is_much { "much better" } else { "better" };
            let object = rest
                .replace("{better}", better)
                .replace("{more}", &more(ratio));
            phrase(place, verb, object)
        }
        Found::Reaches { place } => phrase(place, "reaches", rest.to_owned()),
        Found::Nearer { place } => {
            phrase(place, "comes nearer to", format!("{rest}, but misses it"))
        }
        Found::BothReach => (
            format!("Both reach {} {both}.", purpose.both),
            Default::default(),
        ),
        Found::BothMiss => (
            format!("Both miss {} {both}.", purpose.both),
            Default::default(),
        ),
        Found::Same => (format!("Both {} {both}.", purpose.both), Default::default()),
        Found::TooLow { least } => {
            let why = format!("{} is below {least} in both lights {both}", purpose.figure);
            (nothing(purpose, &why), Default::default())
        }
    };
    (found.which(), words, phrase)
}

/// How much more one gives: "8 % more", "2.3 times the", "far more".
fn more(ratio: f64) -> String {
    match ratio {
        r if r < 2.0 => format!("{:.0} % more", 100.0 * (r - 1.0)),
        r if r < 100.0 => format!("{r:.1} times the"),
        _ => "far more".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_much_more_is_told_in_per_cent_times_or_not_at_all() {
        assert_eq!(more(1.08), "8 % more");
        assert_eq!(more(2.34), "2.3 times the");
        assert_eq!(more(f64::INFINITY), "far more");
    }
}
