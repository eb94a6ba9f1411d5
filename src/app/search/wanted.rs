//! Colour temperatures and figures in what is typed: "2700 K", "led Ra 90", "cri>=95".

/// A figure that can be searched by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Figure {
    /// Correlated colour temperature, K.
    Kelvin,
    /// CRI's mean.
    Ra,
    /// TM-30's mean.
    Rf,
    /// CRI's strong red.
    R9,
    /// CRI's light skin.
    R13,
}

/// How a figure is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Bound {
    /// Near it.
    About(f64),
    /// At least so much.
    AtLeast(f64),
    /// At most so much.
    AtMost(f64),
}

/// A figure that is wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wanted {
    pub figure: Figure,
    /// How much of it.
    pub bound: Bound,
}

/// How far a light's temperature may be from the one that is typed, K.
const NEAR_K: f64 = 150.0;

/// Temperatures that a light is called by, K.
const KELVINS: std::ops::RangeInclusive<f64> = 1000.0..=40_000.0;

impl Wanted {
    /// How far a value is from what is wanted; `None` where it is not what is wanted.
    pub(super) fn distance(self, value: f64) -> Option<f64> {
        let (border, is_there) = match self.bound {
            Bound::About(border) => (border, (value - border).abs() <= NEAR_K),
            // As the figure is printed.
            Bound::AtLeast(border) => (border, value.round() >= border),
            Bound::AtMost(border) => (border, value.round() <= border),
        };
        is_there.then(|| (value - border).abs())
    }

    fn kelvin(kelvin: f64) -> Option<Self> {
        KELVINS.contains(&kelvin).then_some(Self {
            figure: Figure::Kelvin,
            bound: Bound::About(kelvin),
        })
    }
}

/// The figures in what is typed, and the words beside them.
pub(super) fn wanted(typed: &str) -> (Vec<Wanted>, String) {
    let typed = typed.to_lowercase().replace('≥', ">=").replace('≤', "<=");
    let words: Vec<&str> = typed.split_whitespace().collect();
    let (mut found, mut rest) = (Vec::new(), Vec::new());
    let mut at = 0;
    while at < words.len() {
        let most = MOST_WORDS.min(words.len() - at);
        let taken = (1..=most).rev().find_map(|count| {
            let joined = words[at..at + count].concat();
            Some((count, of_words(&joined)?))
        });
        match taken {
            Some((count, wanted)) => {
                found.push(wanted);
                at += count;
            }
            None => {
                rest.push(words[at]);
                at += 1;
            }
        }
    }
    (found, rest.join(" "))
}

/// "Ra", ">=" and "90".
const MOST_WORDS: usize = 3;

/// A temperature without its unit: "4000", alone or among words.
pub(super) fn bare_kelvin(typed: &str) -> Option<(Wanted, String)> {
    let words: Vec<&str> = typed.split_whitespace().collect();
    let found = words.iter().enumerate().find_map(|(at, word)| {
        let is_whole = word.len() >= 4 && word.chars().all(|c| c.is_ascii_digit());
        let kelvin = word.parse().ok().filter(|_| is_whole)?;
        Some((at, Wanted::kelvin(kelvin)?))
    });
    let (at, wanted) = found?;
    let rest: Vec<&str> = [&words[..at], &words[at + 1..]].concat();
    Some((wanted, rest.join(" ")))
}

/// One figure, its words joined: "ra90", "ra>=90", "2700k", "cct2700".
fn of_words(joined: &str) -> Option<Wanted> {
    const NAMES: [(&str, Figure); 6] = [
        ("cct", Figure::Kelvin),
        ("cri", Figure::Ra),
        ("ra", Figure::Ra),
        ("rf", Figure::Rf),
        ("r13", Figure::R13),
        ("r9", Figure::R9),
    ];
    let number = |words: &str| {
        words
            .parse::<f64>()
            .ok()
            .filter(|n| n.is_finite() && *n >= 0.0)
    };
    for unit in ["kelvin", "°k", "k"] {
        if let Some(kelvin) = joined.strip_suffix(unit).and_then(number) {
            return Wanted::kelvin(kelvin);
        }
    }
    let (rest, figure) = NAMES
        .iter()
        .find_map(|(name, figure)| Some((joined.strip_prefix(name)?, *figure)))?;
    let rest = rest.trim_start_matches([':', '=']);
    let rest = rest.strip_suffix('+').unwrap_or(rest);
    if figure == Figure::Kelvin {
        return Wanted::kelvin(number(rest.trim_end_matches('k'))?);
    }
    let signs = rest.find(|c: char| c.is_ascii_digit())?;
    let (sign, value) = rest.split_at(signs);
    let value = number(value).filter(|value| *value <= 100.0)?;
    let bound = match sign {
        "" | ">" | ">=" => Bound::AtLeast(value),
        "<" | "<=" => Bound::AtMost(value),
        _ => return None,
    };
    Some(Wanted { figure, bound })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn temperatures_and_figures_are_taken_out_of_words() {
        let kelvin = |kelvin| Wanted::kelvin(kelvin).unwrap();
        let at_least = |figure, value| Wanted {
            figure,
            bound: Bound::AtLeast(value),
        };
        let at_most = |figure, value| Wanted {
            figure,
            bound: Bound::AtMost(value),
        };
        for (typed, found, rest) in [
            ("2700 K", vec![kelvin(2700.0)], ""),
            ("2700k", vec![kelvin(2700.0)], ""),
            ("4000 kelvin led", vec![kelvin(4000.0)], "led"),
            ("CCT 6500", vec![kelvin(6500.0)], ""),
            ("Ra 90", vec![at_least(Figure::Ra, 90.0)], ""),
            ("cri90", vec![at_least(Figure::Ra, 90.0)], ""),
            ("CRI 90+", vec![at_least(Figure::Ra, 90.0)], ""),
            ("Rf ≥ 85", vec![at_least(Figure::Rf, 85.0)], ""),
            ("ra < 80", vec![at_most(Figure::Ra, 80.0)], ""),
            ("R9 50", vec![at_least(Figure::R9, 50.0)], ""),
            (
                "LED 3000 K R9 50",
                vec![kelvin(3000.0), at_least(Figure::R9, 50.0)],
                "led",
            ),
        ] {
            assert_eq!(wanted(typed), (found, rest.to_owned()), "{typed}");
        }
    }

    #[test]
    fn names_and_other_numbers_are_no_figures() {
        for typed in [
            "FL3.11",
            "led-b5",
            "rail",
            "radio",
            "ra",
            "F32T8/TL830",
            "450 nm",
            "12 K",
            "4000",
            "f34t12/lw/rs/ew",
            "ra 900",
            "krypton",
            "d65",
            "cri",
        ] {
            assert_eq!(wanted(typed), (Vec::new(), typed.to_lowercase()), "{typed}");
        }
        assert_eq!(
            bare_kelvin("led 4000"),
            Some((Wanted::kelvin(4000.0).unwrap(), "led".to_owned()))
        );
        for typed in ["589", "1", "led", "99999", "400.5"] {
            assert_eq!(bare_kelvin(typed), None, "{typed}");
        }
    }

    #[test]
    fn a_temperature_is_near_and_a_figure_is_reached_as_it_is_printed() {
        let near = Wanted::kelvin(2700.0).unwrap();
        assert_eq!(near.distance(2840.0), Some(140.0));
        assert_eq!(near.distance(2856.0), None);
        let ra = wanted("Ra 90").0[0];
        assert!(ra.distance(89.6).is_some() && ra.distance(89.4).is_none());
    }
}
