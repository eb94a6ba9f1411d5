//! A factor on the command line: which spectrum, how thick and how often it is met.
//!
//! ```text
//! NAME[#SPECTRUM][@THICKNESS][*TIMES]
//!
//! glasses.csv#3                      the third spectrum of a file, or #its name
//! "isuzu IVG550 (Green filter) 2 mm@4mm"   a glass whose name tells its thickness
//! glasses.csv#3@x1.5                 any other glass, as a multiple
//! "colorchecker_ohta/red*3"          three bounces
//! ```
//!
//! No shipped name has one of the three signs (a test), and a file whose own name has them is
//! taken as it stands.

use std::{ffi::OsStr, path::Path};

use super::refusal::Refusal;
use crate::{
    app::{
        Library,
        products::{BOUNCES, Link, THICKNESSES},
        ticks::short,
    },
    io::{quoted, shown},
};

/// A word taken apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct FactorWord<'a> {
    /// A file, a preset's name or group/name.
    pub name: &'a OsStr,
    /// Which spectrum of the file, by name or number from 1.
    pub spectrum: Option<&'a str>,
    /// How thick.
    pub thickness: Option<Thickness>,
    /// How many times in a row it is met.
    pub times: Option<u32>,
}

/// How thick a glass is to be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Thickness {
    Mm(f64),
    /// As a multiple of the measured one.
    Times(f64),
}

impl<'a> FactorWord<'a> {
    /// Takes a word apart.
    ///
    /// # Errors
    /// [`Refusal::Usage`] for a sign with something else behind it.
    pub(super) fn of(word: &'a OsStr) -> Result<Self, Refusal> {
        Self::within(word, &|name| {
            let is_shipped = |name: &str| Library::bundled().knows(name);
            Path::new(name).exists() || name.to_str().is_some_and(is_shipped)
        })
    }

    fn within(word: &'a OsStr, exists: &dyn Fn(&OsStr) -> bool) -> Result<Self, Refusal> {
        let mut found = Self {
            name: word,
            spectrum: None,
            thickness: None,
            times: None,
        };
        let shown = shown(Path::new(word));
        while !exists(found.name) {
            let Some((name, sign, value)) = split_at_sign(found.name, "#@*") else {
                break;
            };
            let refused = |expected: String| {
                Refusal::Usage(format!(
                    "FACTOR: {shown}: found {} after {sign}, expected {expected}",
                    quoted(value)
                ))
            };
            let again = match sign {
                '#' => {
                    if value.is_empty() {
                        return Err(refused("a spectrum's name or number".to_owned()));
                    }
                    found.spectrum.replace(value).is_some()
                }
                '@' => {
                    let thickness = thickness(value).ok_or_else(|| {
                        refused("a thickness such as 4mm, or a multiple such as x2".to_owned())
                    })?;
                    found.thickness.replace(thickness).is_some()
                }
                _ => {
                    let times = value
                        .trim()
                        .parse()
                        .ok()
                        .filter(|times| BOUNCES.contains(times));
                    let times = times.ok_or_else(|| {
                        let (least, most) = (BOUNCES.start(), BOUNCES.end());
                        refused(format!("a whole number from {least} to {most}"))
                    })?;
                    found.times.replace(times).is_some()
                }
            };
            if again {
                return Err(Refusal::Usage(format!(
                    "FACTOR: {shown}: found {sign} twice, expected it once"
                )));
            }
            found.name = name;
        }
        Ok(found)
    }

    /// The same thickness and times for a link.
    ///
    /// # Errors
    /// [`Refusal::Usage`] for mm of a factor whose name tells none, and for a thickness beyond
    /// what may be asked for.
    pub(super) fn over(self, mut link: Link) -> Result<Link, Refusal> {
        let refused = |found: String, expected: String| {
            let name = link.entry.name();
            Refusal::Usage(format!(
                "FACTOR: {name}: found {found}, expected {expected}"
            ))
        };
        let ratio = match self.thickness {
            None => 1.0,
            Some(Thickness::Times(ratio)) => ratio,
            Some(Thickness::Mm(mm)) => match link.measured_mm() {
                Some(measured) => mm / measured,
                None => {
                    return Err(refused(
                        format!("a thickness of {} mm", short(mm)),
                        "a multiple such as x2 where the name tells no thickness in mm".to_owned(),
                    ));
                }
            },
        };
        if !THICKNESSES.contains(&ratio) {
            return Err(refused(
                format!("{} times the measured thickness", short(ratio)),
                format!("{} to {}", THICKNESSES.start(), THICKNESSES.end()),
            ));
        }
        if self.thickness.is_some() && !link.has_thickness() {
            return Err(refused(
                "a thickness of a surface".to_owned(),
                "one of a filter or glass only (a surface may be met several times: *2)".to_owned(),
            ));
        }
        link.thickness = ratio;
        link.bounces = self.times.unwrap_or(1);
        Ok(link)
    }
}

/// A word before the last of some signs, the sign, and what stands behind it; `None` where it has
/// none, or what stands behind it is no text.
pub(super) fn split_at_sign<'a>(
    word: &'a OsStr,
    signs: &str,
) -> Option<(&'a OsStr, char, &'a str)> {
    let is_sign = |byte: &u8| signs.as_bytes().contains(byte);
    let at = word.as_encoded_bytes().iter().rposition(is_sign)?;
    let (name, rest) = split_at(word, at)?;
    let sign = rest.chars().next()?;
    Some((name, sign, &rest[sign.len_utf8()..]))
}

/// The two parts of a word of which the second is text, as a file's name need not be.
#[cfg(unix)]
fn split_at(word: &OsStr, at: usize) -> Option<(&OsStr, &str)> {
    use std::os::unix::ffi::OsStrExt;
    let (name, rest) = word.as_bytes().split_at_checked(at)?;
    Some((OsStr::from_bytes(name), std::str::from_utf8(rest).ok()?))
}

#[cfg(not(unix))]
fn split_at(word: &OsStr, at: usize) -> Option<(&OsStr, &str)> {
    let (name, rest) = word.to_str()?.split_at_checked(at)?;
    Some((OsStr::new(name), rest))
}

fn thickness(word: &str) -> Option<Thickness> {
    let number = |text: &str| {
        let number: f64 = text.trim().parse().ok()?;
        (number >= 0.0 && number.is_finite()).then_some(number)
    };
    let word = word.trim().to_lowercase();
    if let Some(mm) = word.strip_suffix("mm") {
        return number(mm).map(Thickness::Mm);
    }
    number(word.strip_prefix('x')?).map(Thickness::Times)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn taken_apart(word: &str) -> FactorWord<'_> {
        FactorWord::within(OsStr::new(word), &|name| name == "a@x2.csv").unwrap()
    }

    #[test]
    fn no_shipped_name_has_a_sign_of_the_factors_in_it() {
        for preset in Library::bundled().presets() {
            let id = preset.id();
            assert!(!id.contains(['#', '@', '*']), "{id}");
        }
    }

    #[test]
    fn a_word_is_a_name_a_spectrum_a_thickness_and_times_of_which_only_the_name_must_be() {
        let plain = |name| FactorWord {
            name: OsStr::new(name),
            spectrum: None,
            thickness: None,
            times: None,
        };
        assert_eq!(taken_apart("a b (c) 2 mm"), plain("a b (c) 2 mm"));
        assert_eq!(
            taken_apart("f.csv#red 2@4mm*3"),
            FactorWord {
                name: OsStr::new("f.csv"),
                spectrum: Some("red 2"),
                thickness: Some(Thickness::Mm(4.0)),
                times: Some(3),
            }
        );
        assert_eq!(
            taken_apart("glass*2@x1.5").thickness,
            Some(Thickness::Times(1.5))
        );
        // A file's own name comes first.
        assert_eq!(taken_apart("a@x2.csv"), plain("a@x2.csv"));
        assert_eq!(taken_apart("a@x2.csv*2").name, "a@x2.csv");
    }

    #[cfg(unix)]
    #[test]
    fn a_name_that_is_no_text_is_taken_apart_all_the_same() {
        use std::os::unix::ffi::OsStrExt;
        let word = OsStr::from_bytes(b"gr\xfcn.csv#2*3");
        let found = FactorWord::within(word, &|name| name.as_bytes() == b"gr\xfcn.csv").unwrap();
        assert_eq!((found.spectrum, found.times), (Some("2"), Some(3)));
    }

    #[test]
    fn signs_without_sense_are_refused() {
        for word in [
            "red*",
            "red*0",
            "red*17",
            "red*x",
            "red@",
            "red@2",
            "red@xmm",
            "red@-1mm",
            "red@xNaN",
            "f#",
            "red*2*2",
            "red@x1@x2",
        ] {
            let refused = FactorWord::within(OsStr::new(word), &|_| false);
            assert!(matches!(refused, Err(Refusal::Usage(_))), "{word}");
        }
    }
}
