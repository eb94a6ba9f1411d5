//! One purpose of two lights: the values, which is better, and a sentence.

use super::{
    purpose::{Predicate, Purpose, Win, reading_both, reading_nearer},
    rule::{Found, Which},
    side::Side,
};
use crate::{
    app::{numbers::fixed, ticks::short},
    languages::said,
};

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
    /// What is said of the better light, and the figures; `None` where none is better.
    pub(super) phrase: Option<(Predicate, String)>,
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
            Err(why) => (None, nothing(purpose, &why), None),
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
    tr!(
        "Nothing can be said of {purpose}: {why}.",
        purpose = said(purpose.topic),
        why
    )
}

fn told(
    purpose: &Purpose,
    sides: &[Side; 2],
    values: [f64; 2],
) -> (Option<Which>, String, Option<(Predicate, String)>) {
    let shown = values.map(|value| fixed(value, purpose.digits));
    let found = match purpose.rule.of(values) {
        // What the digits do not show is no difference to a reader.
        Found::Better { .. } if shown[0] == shown[1] => Found::Same,
        found => found,
    };
    let [a, b] = &shown;
    let figure = match purpose.figure {
        "" => "",
        figure => said(figure),
    };
    let named = |figures: String| {
        let words = [figure, &figures, purpose.unit];
        let words: Vec<&str> = words.into_iter().filter(|word| !word.is_empty()).collect();
        format!("({})", words.join(" "))
    };
    let both = named(tr!("{a} and {b}", a, b));
    let phrase = |place: usize, predicate: Predicate| {
        let (better, other) = (&shown[place], &shown[1 - place]);
        let figures = named(tr!("{better} against {other}", better, other));
        let words = tr!(
            "{light} {predicate} {figures}.",
            light = sides[place].name,
            predicate = predicate.whole,
            figures
        );
        (words, Some((predicate, figures)))
    };
    let (words, phrase) = match found {
        Found::Better {
            place,
            is_much,
            ratio,
        } => phrase(place, (purpose.wins)(Win { is_much, ratio })),
        Found::Reaches { place } => {
            let win = Win {
                is_much: false,
                ratio: 1.0,
            };
            phrase(place, (purpose.wins)(win))
        }
        Found::Nearer { place } => phrase(place, reading_nearer()),
        Found::BothReach => (reading_both(&both, true), None),
        Found::BothMiss => (reading_both(&both, false), None),
        Found::Same => ((purpose.same)(&both), None),
        Found::TooLow { least } => {
            let why = tr!(
                "{figure} is below {least} in both lights {both}",
                figure,
                least = short(least),
                both
            );
            (nothing(purpose, &why), None)
        }
    };
    (found.which(), words, phrase)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn how_much_more_is_told_in_per_cent_times_or_not_at_all() {
        let energy = Purpose::of_key("energy").expect("a purpose");
        for (ratio, words) in [
            (1.08, "gives 8 % more light per watt of radiation"),
            (2.34, "gives 2.3 times the light per watt of radiation"),
            (f64::INFINITY, "gives far more light per watt of radiation"),
        ] {
            let win = Win {
                is_much: false,
                ratio,
            };
            assert_eq!((energy.wins)(win).whole, words);
        }
    }
}
