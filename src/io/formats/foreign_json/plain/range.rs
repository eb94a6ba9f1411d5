//! Wavelengths that are given by their ends and their step or number.
//!
//! ```text
//! {"start": 380, "end": 730, "interval": 10}    {"domain": [300, 780], "interval": 5}
//! {"lambda_min": 380, "lambda_max": 780, "n": 41}    {"bands": [380, 780, 10]}
//! ```

use super::keys::{is_axis, one_number, spaced};
use crate::io::decode::json_tree::Tree;
use crate::io::text::words::holds_one;

/// Plausible ends of an axis, nm, where no key names wavelengths.
const PLAUSIBLE_NM: std::ops::RangeInclusive<f64> = 150.0..=50_000.0;

/// Fewest wavelengths: a pair or three numbers may be ends again.
const FEWEST: usize = 4;

/// The description of an axis by keys.
#[derive(Clone, Debug, Default)]
pub(super) struct Ends {
    start: Option<f64>,
    end: Option<f64>,
    step: Option<f64>,
    count: Option<f64>,
    /// True if the key of an end marks it as a wavelength.
    names_wavelengths: bool,
    /// True if the ends have keys of their own.
    are_apart: bool,
    unit: Option<&'static str>,
}

/// Words in a key that refer to wavelengths.
const ABOUT: &str = "|wavelength|;|wavelengths|;|lambda|;|wl|;|nm|;|um|;|µm|;|spectral|;|band|";

/// Words in a key without meaning here.
const FILLING: &str = "|range|;|axis|;|sampling|;|in|;|bands|;|of|;|spectrum|";

/// Words in a key of two or three numbers that are ends and a step.
const RANGES: &str = "|domain|;|span|;|bands|;|range|;|limits|;|extent|";

/// The words of a key in small letters.
fn words(key: &str) -> impl Iterator<Item = &str> {
    let words = key.split(|c: char| !c.is_alphanumeric());
    words.filter(|word| !word.is_empty())
}

impl Ends {
    /// The description of an axis in an object.
    pub(super) fn of<'o>(object: impl IntoIterator<Item = &'o (String, Tree)>) -> Self {
        let mut ends = Self::default();
        for (key, value) in object {
            ends.look(&spaced(key).to_lowercase(), is_axis(key), value);
        }
        ends
    }

    fn look(&mut self, key: &str, is_axis: bool, value: &Tree) {
        let is_range = holds_one(key, RANGES);
        match value {
            Tree::Number(number) => self.number(key, *number),
            Tree::List(list) if is_range || is_axis && list.len() == 3 => self.list(key, list),
            Tree::Object(inner) if is_range || is_axis => {
                // No search at deeper levels.
                let is_number = |entry: &&(String, Tree)| matches!(entry.1, Tree::Number(_));
                let inner = Self::of(inner.iter().filter(is_number));
                if inner.start.is_some() && self.start.is_none() {
                    *self = inner;
                    self.names_wavelengths |= is_axis;
                    self.note_unit(key);
                }
            }
            _ => {}
        }
    }

    /// Assigns a number to the part of the axis named by its key.
    fn number(&mut self, key: &str, number: f64) {
        let is_left = |word: &&str| !holds_one(word, ABOUT) && !holds_one(word, FILLING);
        let left: Vec<&str> = words(key).filter(is_left).collect();
        let (is_end, place) = match left.join(" ").as_str() {
            "start" | "from" | "first" | "min" | "minimum" | "begin" => (true, &mut self.start),
            "end" | "to" | "last" | "max" | "maximum" | "stop" => (true, &mut self.end),
            "step" | "interval" | "increment" | "delta" | "spacing" | "step size" => {
                (false, &mut self.step)
            }
            "n" | "count" | "points" | "num" | "num points" | "number points" => {
                (false, &mut self.count)
            }
            "" if words(key).last() == Some("bands") => (false, &mut self.count),
            _ => return,
        };
        place.get_or_insert(number);
        if is_end {
            self.are_apart = true;
            self.names_wavelengths |= holds_one(key, ABOUT);
            self.note_unit(key);
        }
    }

    /// Takes two or three numbers for the ends and the step.
    fn list(&mut self, key: &str, list: &[Tree]) {
        let ends @ ([_, _] | [_, _, _]) = list else {
            return;
        };
        let numbers: Option<Vec<f64>> = ends.iter().map(one_number).collect();
        if let Some([start, end, step @ ..]) = numbers.as_deref()
            && self.start.is_none()
            && start < end
        {
            (self.start, self.end) = (Some(*start), Some(*end));
            self.step = step.first().copied().or(self.step);
            self.note_unit(key);
        }
    }

    fn note_unit(&mut self, key: &str) {
        let units = ["nm", "um", "µm"].into_iter();
        let mut units = units.filter(|unit| words(key).any(|word| word == *unit));
        self.unit = units.next().or(self.unit);
    }

    /// The possible numbers of wavelengths; `beside` is the length of the first list of numbers.
    pub(super) fn lengths(&self, beside: Option<usize>) -> Vec<usize> {
        let (Some(start), Some(end)) = (self.start, self.end) else {
            return Vec::new();
        };
        let is_light = PLAUSIBLE_NM.contains(&start) && PLAUSIBLE_NM.contains(&end);
        if !(start > 0.0 && start < end && (is_light || self.names_wavelengths)) {
            return Vec::new();
        }
        let whole = |count: f64| {
            let is_whole = (count - count.round()).abs() < 1e-6 && count < 1e9;
            (is_whole && count >= FEWEST as f64).then_some(count.round() as usize)
        };
        let by_step = self.step.filter(|step| *step > 0.0);
        let by_step = by_step.and_then(|step| whole((end - start) / step + 1.0));
        let mut lengths: Vec<usize> = by_step.into_iter().collect();
        lengths.extend(self.count.and_then(whole));
        if self.step.is_none() && self.count.is_none() && self.are_apart && self.names_wavelengths {
            // Pixels of a spectrometer are not evenly apart: only round steps as chosen by hand.
            let is_chosen = |n: &usize| {
                let hundredths = 100.0 * (end - start) / (*n as f64 - 1.0);
                (hundredths - hundredths.round()).abs() < 1e-6
            };
            lengths.extend(beside.filter(|n| *n >= FEWEST).filter(is_chosen));
        }
        lengths
    }

    /// That many wavelengths from end to end, and their title.
    pub(super) fn axis(&self, length: usize) -> (String, Vec<f64>) {
        let (start, end) = (self.start.unwrap_or(0.0), self.end.unwrap_or(0.0));
        let last = (length.max(2) - 1) as f64;
        // Rounded, so that steps of a tenth are even.
        let at = |i: usize| ((start + (end - start) * (i as f64) / last) * 1e9).round() / 1e9;
        let title = format!("wavelength {}", self.unit.unwrap_or(""));
        (title.trim_end().to_owned(), (0..length).map(at).collect())
    }
}
