//! A number that a person sets: its range, its name and its words in one row.

use std::ops::RangeInclusive;

use crate::{app::ticks::short, languages::said};

/// A field that a knob moves: any kind of number.
pub trait Number {
    fn get(&self) -> f64;
    /// The nearest that the field can hold.
    fn set(&mut self, value: f64);
}

macro_rules! numbers {
    ($($kind:ty: $rounded:expr),*) => {$(
        impl Number for $kind {
            fn get(&self) -> f64 {
                *self as f64
            }

            fn set(&mut self, value: f64) {
                let rounded: fn(f64) -> f64 = $rounded;
                *self = rounded(value) as $kind;
            }
        }
    )*};
}

numbers!(f64: |v| v, f32: |v| v, usize: f64::round, u32: f64::round, i32: f64::round, u8: f64::round);

/// The values that a knob may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// From the first to the second.
    Within(f64, f64),
    /// One of these.
    OneOf(&'static [f64]),
}

impl Reach {
    /// The nearest value that it allows; the usual one for what is no number.
    pub fn nearest(self, wanted: f64, usual: f64) -> f64 {
        let range = self.range();
        let wanted = wanted.clamp(*range.start(), *range.end());
        let distance = |value: &f64| (value - wanted).abs();
        match self {
            _ if wanted.is_nan() => usual,
            Self::Within(..) => wanted,
            Self::OneOf(values) => {
                let nearest = values
                    .iter()
                    .min_by(|a, b| distance(a).total_cmp(&distance(b)));
                nearest.copied().unwrap_or(usual)
            }
        }
    }

    /// From the least to the largest value.
    pub fn range(self) -> RangeInclusive<f64> {
        match self {
            Self::Within(least, most) => least..=most,
            Self::OneOf(values) => values[0]..=values[values.len() - 1],
        }
    }
}

/// A number of a value `T` that a person sets.
pub struct Knob<T> {
    /// The field's name in files.
    pub key: &'static str,
    /// The control's name.
    pub title: &'static str,
    /// A sentence about it.
    pub meaning: &'static str,
    pub reach: Reach,
    /// Decimals on screen.
    pub digits: i32,
    /// What stands behind the number on screen, with its space.
    pub unit: &'static str,
    of: fn(&mut T) -> &mut dyn Number,
}

impl<T> Knob<T> {
    pub const fn new(
        (key, title): (&'static str, &'static str),
        meaning: &'static str,
        reach: Reach,
        (digits, unit): (i32, &'static str),
        of: fn(&mut T) -> &mut dyn Number,
    ) -> Self {
        Self {
            key,
            title,
            meaning,
            reach,
            digits,
            unit,
            of,
        }
    }

    /// The control's name in the language spoken.
    pub fn title(&self) -> &'static str {
        said(self.title)
    }

    /// A sentence about it, in the language spoken.
    pub fn meaning(&self) -> &'static str {
        said(self.meaning)
    }

    /// What stands behind the number, in the language spoken.
    pub fn unit(&self) -> &'static str {
        said(self.unit)
    }

    pub fn get(&self, value: &mut T) -> f64 {
        (self.of)(value).get()
    }

    /// Moves it to the nearest allowed value; what is no number leaves it as it is.
    pub fn set(&self, value: &mut T, wanted: f64) {
        let now = self.get(value);
        let nearest = self.reach.nearest(wanted, now);
        // What a field holds already is not rounded again.
        if nearest != now {
            (self.of)(value).set(nearest);
        }
    }

    /// A value as it is told, without the unit.
    fn told(&self, value: f64) -> String {
        let ten = 10_f64.powi(self.digits);
        short((value * ten).round() / ten)
    }
}

/// A row of a table of knobs: `field: title, reach, decimals unit, meaning`.
macro_rules! knob {
    ($key:ident $(.$part:ident)* $([$i:literal])?: $title:expr, $reach:expr,
        $digits:literal $unit:expr, $meaning:expr) => {
        $crate::app::pages::knob::Knob::<Self>::new(
            (stringify!($key), $title),
            $meaning,
            $reach,
            ($digits, $unit),
            |state| &mut state.$key $(.$part)* $([$i])?,
        )
    };
}

pub(in crate::app) use knob;

/// Moves every number of a table to the nearest that is allowed; what is no number becomes the
/// usual one.
pub fn keep_in_reach<T: Default>(knobs: &[Knob<T>], value: &mut T) {
    for knob in knobs {
        let now = knob.get(value);
        let usual = || knob.get(&mut T::default());
        knob.set(value, if now.is_nan() { usual() } else { now });
    }
}

/// The difference between two values in the words of the first knob that moved: "Slit 0.5 to 2 mm".
pub fn moved_words<T: Clone>(knobs: &[Knob<T>], from: &T, to: &T) -> Option<String> {
    let (mut from, mut to) = (from.clone(), to.clone());
    knobs.iter().find_map(|knob| {
        let (was, is) = (knob.get(&mut from), knob.get(&mut to));
        let [from, to] = [was, is].map(|value| knob.told(value));
        (was != is).then(|| {
            tr!(
                "{knob} {from} to {to}{unit}",
                knob = said(knob.title),
                from,
                to,
                unit = said(knob.unit)
            )
        })
    })
}
