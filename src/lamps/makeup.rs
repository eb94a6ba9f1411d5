//! The composition of a light in words: "0.62 FL2 + 0.21 F32T8/TL841 (Triphosphor) + 9 cosine
//! numbers + 1 line".

use super::{
    encoding::Encoding,
    known::{known_lamps, title_of},
};
use crate::{
    languages::{fixed, said, with_sign},
    spectrum::{Basis, Line},
};

/// A known lamp's part of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Part {
    /// The lamp's name.
    pub title: &'static str,
    /// Its index in the list of known lamps.
    pub index: u8,
    /// Its share of the light's power; `None` where the light has no positive power to share.
    pub share: Option<f64>,
    /// Its power, in the spectrum's unit x nm.
    pub weight: f64,
}

impl Part {
    /// The lamp's name in the language spoken.
    pub fn shown(&self) -> String {
        title_of(self.index).unwrap_or_else(|| said(self.title).to_owned())
    }
}

/// The composition of a light.
#[derive(Clone, Debug, PartialEq)]
pub struct Ingredients {
    /// Known lamps.
    pub parts: Vec<Part>,
    /// Functions of the smooth part.
    pub basis: Basis,
    /// Numbers of the smooth part.
    pub smooth: usize,
    /// Lines, by rising wavelength.
    pub lines: Vec<Line>,
    /// Light's power, in its unit x nm.
    pub power: f64,
}

impl Ingredients {
    /// The makeup of an encoding.
    pub(crate) fn of(encoding: &Encoding) -> Self {
        let power = encoding.power();
        let share = |weight: f64| Some(weight / power).filter(|s| power > 0.0 && s.is_finite());
        let part = |atom: &super::AtomWeight| {
            let lamp = known_lamps().get(usize::from(atom.index));
            Part {
                title: lamp.map_or(later!("a lamp unknown"), |lamp| &lamp.title),
                index: atom.index,
                share: share(atom.weight),
                weight: atom.weight,
            }
        };
        Self {
            parts: encoding.atoms.iter().map(part).collect(),
            basis: encoding.smooth.basis,
            smooth: encoding.smooth.coefficients.len(),
            lines: encoding.composite().into_parts().1,
            power,
        }
    }

    /// In one line: shares of the power before the lamps' names.
    pub(crate) fn in_words(&self) -> String {
        let mut words = String::new();
        for part in &self.parts {
            let value = part.share.unwrap_or(part.weight);
            let sign = match (words.is_empty(), value < 0.0) {
                (true, false) => "",
                (true, true) => "\u{2212}",
                (false, false) => " + ",
                (false, true) => " \u{2212} ",
            };
            words.push_str(&format!(
                "{sign}{} {}",
                two_digits(value.abs()),
                part.shown()
            ));
        }
        if !words.is_empty() {
            words.push_str(" + ");
        }
        words.push_str(&match self.basis {
            Basis::Fourier => {
                tr!("{n} Fourier number" | "{n} Fourier numbers" % self.smooth)
            }
            Basis::Cosine => tr!("{n} cosine number" | "{n} cosine numbers" % self.smooth),
        });
        if !self.lines.is_empty() {
            words.push_str(" + ");
            words.push_str(&tr!("{n} line" | "{n} lines" % self.lines.len()));
        }
        words
    }

    /// The lines, one a sentence: "436.8 nm, 8.2 nm wide, 0.013 of the power".
    pub(crate) fn lines_in_words(&self) -> Vec<String> {
        let line = |line: &Line| {
            let (at, width) = (fixed(line.at_nm, 1), fixed(line.fwhm_nm, 1));
            let share = line.weight / self.power;
            if self.power > 0.0 && share.is_finite() {
                let sign = if share < 0.0 { "\u{2212}" } else { "" };
                let share = format!("{sign}{}", two_digits(share.abs()));
                match line.is_ideal() {
                    true => tr!("{at} nm, ideal, {share} of the power", at, share),
                    false => tr!(
                        "{at} nm, {width} nm wide, {share} of the power",
                        at,
                        width,
                        share
                    ),
                }
            } else if line.is_ideal() {
                tr!("{at} nm, ideal", at)
            } else {
                tr!("{at} nm, {width} nm wide", at, width)
            }
        };
        self.lines.iter().map(line).collect()
    }
}

/// Two decimals; two digits of what would show as less than 0.1.
fn two_digits(value: f64) -> String {
    with_sign(if value >= 0.095 || value == 0.0 {
        format!("{value:.2}")
    } else if value >= 1e-4 {
        let decimals = (1.0 - value.log10().floor()) as usize;
        format!("{value:.decimals$}")
    } else {
        format!("{value:.1e}")
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lamps::AtomWeight,
        spectrum::{Band, Line, Series},
    };

    fn encoding(atoms: &[(u8, f64)], lines: Vec<Line>) -> Encoding {
        Encoding {
            atoms: atoms
                .iter()
                .map(|(index, weight)| AtomWeight {
                    index: *index,
                    weight: *weight,
                })
                .collect(),
            smooth: Series {
                band: Band::VISIBLE,
                basis: Basis::Cosine,
                coefficients: vec![0.0; 9],
            },
            lines,
            way: None,
        }
    }

    #[test]
    fn a_makeup_reads_like_a_recipe() {
        let line = Line {
            at_nm: 436.796,
            weight: 0.17,
            fwhm_nm: 0.0,
        };
        let makeup = Ingredients::of(&encoding(&[(133, 0.62), (150, 0.21)], vec![line]));
        assert_eq!(
            makeup.in_words(),
            "0.62 blackbody 2600 K + 0.21 daylight 5700 K + 9 cosine numbers + 1 line"
        );
        assert_eq!(
            makeup.lines_in_words(),
            ["436.8 nm, ideal, 0.17 of the power"]
        );
    }

    #[test]
    fn what_is_taken_away_and_what_is_little_shows() {
        let makeup = Ingredients::of(&encoding(&[(133, 1.06), (150, -0.0612)], Vec::new()));
        assert_eq!(
            makeup.in_words(),
            "1.06 blackbody 2600 K \u{2212} 0.061 daylight 5700 K + 9 cosine numbers"
        );
        assert_eq!(two_digits(0.0007), "0.00070");
        assert_eq!(two_digits(3.4e-7), "3.4e-7");
    }

    #[test]
    fn a_light_without_power_shows_weights() {
        let makeup = Ingredients::of(&encoding(&[(133, -2.0)], Vec::new()));
        assert_eq!(makeup.parts[0].share, None);
        assert_eq!(
            makeup.in_words(),
            "\u{2212}2.00 blackbody 2600 K + 9 cosine numbers"
        );
    }
}
