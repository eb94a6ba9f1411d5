//! From two values to the better one, or that they are about the same.

/// Which of two lights is better.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Which {
    /// The first.
    A,
    /// The second.
    B,
    /// Neither: they differ by less than the threshold.
    Same,
}

impl Which {
    /// Its word in JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::A => "a",
            Self::B => "b",
            Self::Same => "same",
        }
    }

    /// The place of the better light, 0 or 1.
    pub fn place(self) -> Option<usize> {
        match self {
            Self::A => Some(0),
            Self::B => Some(1),
            Self::Same => None,
        }
    }
}

/// How two values of a figure are compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Rule {
    /// By their difference.
    Points {
        /// Below it they are about the same.
        same: f64,
        /// From it on one is much better.
        much: f64,
        /// Where both are below it, the figure decides nothing.
        least: f64,
    },
    /// By the larger over the smaller.
    Ratio {
        /// Below it they are about the same.
        same: f64,
        /// From it on one is much better.
        much: f64,
        /// Whether the smaller value is the better one.
        is_less_better: bool,
    },
    /// By a value that a standard asks for.
    Border {
        /// That value, of whole numbers.
        border: f64,
        /// Where both miss it: below this difference they are about the same.
        same: f64,
    },
}

/// What a rule finds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Found {
    /// One is better, at this place: 0 or 1.
    Better {
        place: usize,
        is_much: bool,
        /// Larger over smaller; infinite where the smaller is not positive.
        ratio: f64,
    },
    /// One reaches what is asked for, and the other does not.
    Reaches {
        place: usize,
    },
    /// Neither reaches it, and one comes nearer.
    Nearer {
        place: usize,
    },
    BothReach,
    /// Both miss it by about as much.
    BothMiss,
    /// They are about the same.
    Same,
    /// The figure is too low in both to decide anything: below this.
    TooLow {
        least: f64,
    },
}

impl Found {
    /// Which of the lights is better; `None` where that cannot be said.
    pub(super) fn which(self) -> Option<Which> {
        match self {
            Self::Better { place, .. } | Self::Reaches { place } | Self::Nearer { place } => {
                Some(if place == 0 { Which::A } else { Which::B })
            }
            Self::BothReach | Self::BothMiss | Self::Same => Some(Which::Same),
            Self::TooLow { .. } => None,
        }
    }
}

impl Rule {
    /// Compares two finite values.
    pub(super) fn of(self, [a, b]: [f64; 2]) -> Found {
        let larger = usize::from(b > a);
        let difference = (a - b).abs();
        let ratio = match (a.max(b), a.min(b)) {
            (most, least) if least > 0.0 => most / least,
            (most, least) if most == least => 1.0,
            _ => f64::INFINITY,
        };
        match self {
            Self::Points { least, .. } if a.max(b) < least => Found::TooLow { least },
            Self::Points { same, .. } if difference < same => Found::Same,
            Self::Points { much, .. } => Found::Better {
                place: larger,
                is_much: difference >= much,
                ratio,
            },
            Self::Ratio { same, .. } if ratio < same => Found::Same,
            Self::Ratio {
                much,
                is_less_better,
                ..
            } => Found::Better {
                place: if is_less_better { 1 - larger } else { larger },
                is_much: ratio >= much,
                ratio,
            },
            Self::Border { border, same } => {
                // As the figure is printed, so that no sentence contradicts itself.
                match [a, b].map(|value| value.round() >= border) {
                    [true, true] => Found::BothReach,
                    [false, false] if difference < same => Found::BothMiss,
                    [false, false] => Found::Nearer { place: larger },
                    [is_a, _] => Found::Reaches {
                        place: usize::from(!is_a),
                    },
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POINTS: Rule = Rule::Points {
        same: 5.0,
        much: 20.0,
        least: f64::NEG_INFINITY,
    };

    #[test]
    fn a_difference_below_the_threshold_is_about_the_same() {
        assert_eq!(POINTS.of([60.0, 64.9]), Found::Same);
        let better = |values: [f64; 2], place, is_much| match POINTS.of(values) {
            Found::Better {
                place: found,
                is_much: much,
                ..
            } => assert_eq!((found, much), (place, is_much), "{values:?}"),
            other => panic!("{values:?}: {other:?}"),
        };
        better([60.0, 65.0], 1, false);
        better([82.0, 60.0], 0, true);
        better([-84.0, 12.0], 1, true);
    }

    #[test]
    fn a_ratio_is_of_the_larger_and_the_smaller_may_be_the_better() {
        let rule = |is_less_better| Rule::Ratio {
            same: 1.1,
            much: 2.0,
            is_less_better,
        };
        assert_eq!(rule(false).of([1.0, 1.09]), Found::Same);
        assert_eq!(rule(false).of([0.0, 0.0]), Found::Same);
        assert_eq!(rule(false).of([1.0, 1.11]).which(), Some(Which::B));
        assert_eq!(rule(true).of([1.0, 1.11]).which(), Some(Which::A));
        // Nothing is any number of times less.
        let none = rule(true).of([0.0, 0.3]);
        assert_eq!(
            none,
            Found::Better {
                place: 0,
                is_much: true,
                ratio: f64::INFINITY
            }
        );
    }

    #[test]
    fn a_border_is_reached_missed_or_nearly_reached() {
        let rule = Rule::Border {
            border: 80.0,
            same: 5.0,
        };
        for (values, found) in [
            ([81.0, 99.0], Found::BothReach),
            ([79.5, 80.0], Found::BothReach),
            ([79.4, 80.0], Found::Reaches { place: 1 }),
            ([82.0, 64.0], Found::Reaches { place: 0 }),
            ([51.0, 64.0], Found::Nearer { place: 1 }),
            ([61.0, 64.0], Found::BothMiss),
        ] {
            assert_eq!(rule.of(values), found, "{values:?}");
        }
    }

    #[test]
    fn two_low_values_decide_nothing() {
        let rule = Rule::Points {
            same: 5.0,
            much: 20.0,
            least: 70.0,
        };
        assert_eq!(rule.of([30.0, 69.9]).which(), None);
        assert_eq!(rule.of([30.0, 70.0]).which(), Some(Which::B));
    }
}
