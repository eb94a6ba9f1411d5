//! An encoding as 32-bit words, one a number, and back.
//!
//! ```text
//! integer word   0xff000000 | n, n below 2^24
//! number word    the bits of an f32 between -1e38 and 1e38, whose first byte is never 0xff
//!
//! with a label   label, known lamps' weights, B cosine numbers, (place and width, weight) a line
//!   label        lamp 1 | lamp 2 << 8 | B << 16; 255 is no lamp, two bits are spare (0)
//!   line         round((nm - min) 51200 / L) | width << 8+8; width 0 is ideal, k = 1..=255 is
//!                2 45^((k-1)/254) nm
//! without        numbers, then (place and width, weight) a line; the last bit of the first number
//!                is 0 for cosines and 1 for Fourier's functions
//! ```
//!
//! Rounding to f32 would move the light's own colour by 1e-5. So numbers are rounded one after
//! another, those that move the colour most first, and the rest makes up for what each rounding did.

use nalgebra::Vector3;

use super::{
    encoding::{
        AtomWeight, Decoder, Encoding, MOST_ATOMS, byte_of_width, place_nm, stored_line,
        stored_place, width_of_byte,
    },
    error::EncodingError,
    known::{NONE, known_lamps},
};
use crate::{
    color::Observer,
    spectrum::{Band, Basis, Line, Series, ThreeSums},
    study::FitVariant,
};

/// The first byte of an integer.
const INTEGER: u32 = 0xff00_0000;

/// Bits of an integer.
const MOST_INTEGER: u32 = 0x00ff_ffff;

/// Largest number that a word holds.
const LARGEST: f64 = 1e38;

/// Most words that are read.
const MOST_WORDS: usize = 4096;

fn is_integer(word: u32) -> bool {
    word & INTEGER == INTEGER
}

/// An encoding as words; its numbers are rounded to f32, see [`rounded`].
///
/// # Errors
/// [`EncodingError`] for a number beyond 1e38, a lamp that the list does not have, and more known
/// lamps or labelled numbers than the label can say.
pub(crate) fn to_words(encoding: &Encoding) -> Result<Vec<u32>, EncodingError> {
    let band = encoding.band();
    let number = |value: f64| {
        if value.abs() < LARGEST {
            Ok((value as f32).to_bits())
        } else {
            Err(EncodingError::TooLarge { found: value })
        }
    };
    let mut words = Vec::with_capacity(encoding.numbers());
    let smooth = &encoding.smooth.coefficients;
    let bit = bit_of(encoding)?;
    if encoding.has_label() {
        let index = |k: usize| match encoding.atoms.get(k) {
            None => Ok(NONE),
            Some(atom) if usize::from(atom.index) < known_lamps().len() => Ok(atom.index),
            Some(atom) => Err(EncodingError::Lamp { found: atom.index }),
        };
        let labelled = super::encoding::MOST_LABELLED;
        if encoding.atoms.len() > MOST_ATOMS || smooth.len() > labelled {
            return Err(EncodingError::Words {
                found: format!(
                    "{} lamps and {} numbers",
                    encoding.atoms.len(),
                    smooth.len()
                ),
                expected: "at most 2 known lamps and 63 cosine numbers",
            });
        }
        let lamps = u32::from(index(0)?) | u32::from(index(1)?) << 8;
        words.push(INTEGER | lamps | (smooth.len() as u32) << 16);
    }
    for atom in &encoding.atoms {
        words.push(number(atom.weight)?);
    }
    for (i, c) in smooth.iter().enumerate() {
        let bits = number(*c)?;
        let is_flagged = i == 0 && !encoding.has_label();
        words.push(if is_flagged { bits & !1 | bit } else { bits });
    }
    for line in &encoding.lines {
        let place = u32::from(stored_place(band, line.at_nm));
        let width = u32::from(byte_of_width(line.fwhm_nm));
        words.push(INTEGER | place | width << 16);
        words.push(number(line.weight)?);
    }
    Ok(words)
}

/// The bit by which the basis of an encoding is read again; beside a label it is cosines always.
fn bit_of(encoding: &Encoding) -> Result<u32, EncodingError> {
    let basis = encoding.smooth.basis;
    let held = basis.bit_in_words();
    let is_held = |bit: &u32| !encoding.has_label() || *bit == 0;
    held.filter(is_held).ok_or_else(|| EncodingError::Words {
        found: format!("a {} series", basis.name()),
        expected: "cosines, or Fourier's functions without known lamps and wide lines",
    })
}

/// The encoding of words on a band.
///
/// # Errors
/// [`EncodingError::Words`] with what is wrong, [`EncodingError::Lamp`] for a lamp unknown.
pub(crate) fn from_words(words: &[u32], band: Band) -> Result<Encoding, EncodingError> {
    let wrong = |found: String, expected| Err(EncodingError::Words { found, expected });
    if words.is_empty() || words.len() > MOST_WORDS {
        return wrong(format!("{} words", words.len()), "1 to 4096 words");
    }
    let mut left = words.iter().copied();
    let (mut atoms, mut basis) = (Vec::new(), Basis::Cosine);
    let has_label = is_integer(words[0]);
    let count = if has_label {
        let label = left.next().unwrap_or(0) & MOST_INTEGER;
        if label >> 22 != 0 {
            return wrong(
                format!("the label {label:06x}"),
                "one whose first two bits are 0",
            );
        }
        for index in [label as u8, (label >> 8) as u8] {
            if index != NONE {
                if usize::from(index) >= known_lamps().len() {
                    return Err(EncodingError::Lamp { found: index });
                }
                let weight = number(left.next())?;
                atoms.push(AtomWeight { index, weight });
            }
        }
        (label >> 16 & 0x3f) as usize
    } else {
        let bit = Some(words[0] & 1);
        let of_bit = |of: &Basis| of.bit_in_words() == bit;
        basis = Basis::ALL.into_iter().find(of_bit).unwrap_or(basis);
        words.iter().take_while(|word| !is_integer(**word)).count()
    };
    if count == 0 {
        return wrong("no smooth number".to_owned(), "at least one");
    }
    let coefficients = (0..count)
        .map(|_| number(left.next()))
        .collect::<Result<Vec<f64>, _>>()?;
    let most = 2 * Basis::highest_order(band) + 1;
    if count > most {
        return wrong(
            format!("{count} smooth numbers"),
            "no more than the range carries",
        );
    }
    let mut lines = Vec::new();
    while let Some(word) = left.next() {
        if !is_integer(word) {
            return wrong(
                format!("the word {word:08x}"),
                "a line's place, whose word begins with ff",
            );
        }
        let Some(at_nm) = place_nm(band, word as u16) else {
            return wrong(format!("place {}", word as u16), "a place up to 51200");
        };
        lines.push(Line {
            at_nm,
            fwhm_nm: width_of_byte((word >> 16) as u8),
            weight: number(left.next())?,
        });
    }
    if has_label && atoms.is_empty() && lines.is_empty() {
        return wrong(
            "a label without lamp or line".to_owned(),
            "the numbers alone",
        );
    }
    let way = (!(has_label || lines.is_empty() && basis == Basis::Cosine))
        .then(|| FitVariant::new(basis, !lines.is_empty(), true));
    Ok(Encoding {
        atoms,
        smooth: Series {
            band,
            basis,
            coefficients,
        },
        lines,
        way,
    })
}

/// The number of a word.
fn number(word: Option<u32>) -> Result<f64, EncodingError> {
    let wrong = |found: String| {
        Err(EncodingError::Words {
            found,
            expected: "a number between -1e38 and 1e38",
        })
    };
    match word {
        None => wrong("the end of the words".to_owned()),
        Some(word) => {
            let value = f64::from(f32::from_bits(word));
            if value.abs() < LARGEST && !is_integer(word) {
                Ok(value)
            } else {
                wrong(format!("the word {word:08x}"))
            }
        }
    }
}

/// Words as text, eight hexadecimal digits each.
pub(crate) fn words_in_text(words: &[u32]) -> Vec<String> {
    words.iter().map(|word| format!("{word:08x}")).collect()
}

/// Words from text: eight hexadecimal digits each, parted by blanks, commas or line breaks.
///
/// # Errors
/// [`EncodingError::Words`] with the first that is none.
pub(crate) fn words_from_text(text: &str) -> Result<Vec<u32>, EncodingError> {
    let parts = text
        .split(|c: char| c.is_whitespace() || c == ',')
        .filter(|p| !p.is_empty());
    let word = |part: &str| {
        let digits = part.strip_prefix("0x").unwrap_or(part);
        let is_word = digits.len() == 8 && digits.bytes().all(|b| b.is_ascii_hexdigit());
        u32::from_str_radix(digits, 16)
            .ok()
            .filter(|_| is_word)
            .ok_or_else(|| EncodingError::Words {
                found: format!("\"{}\"", part.chars().take(40).collect::<String>()),
                expected: "eight hexadecimal digits a word",
            })
    };
    parts.map(word).collect()
}

/// One number of an encoding while numbers are rounded.
struct Number {
    value: f64,
    /// X, Y, Z of it at 1.
    xyz: Vector3<f64>,
    /// Squared norm of its function: what a change of it costs.
    norm: f64,
    /// The last bit that is wanted.
    last_bit: Option<u32>,
    is_fixed: bool,
}

impl Number {
    /// Largest change of the colour by rounding.
    fn reach(&self) -> f64 {
        let next = (self.value as f32).abs().next_up();
        let step = f64::from(next) - f64::from(next.next_down());
        step * self.xyz.norm()
    }

    /// The nearest f32 with the wanted last bit.
    fn nearest(&self) -> f64 {
        let near = self.value as f32;
        match self.last_bit {
            Some(bit) if near.to_bits() & 1 != bit => {
                let sides = [near.next_up(), near.next_down()].map(f64::from);
                let off = |v: f64| (v - self.value).abs();
                if off(sides[0]) <= off(sides[1]) {
                    sides[0]
                } else {
                    sides[1]
                }
            }
            _ => f64::from(near),
        }
    }
}

/// An encoding whose numbers are f32 and whose lines stand where they are stored, with the own
/// colour it had: what its words decode to.
///
/// # Errors
/// As `to_words`, and as [`Decoder::decode`].
pub(crate) fn rounded(
    encoding: &Encoding,
    decoder: &Decoder,
    observer: Observer,
) -> Result<Encoding, EncodingError> {
    let band = encoding.band();
    let seen = observer.table().on_band(band);
    let xyz = |values: &[f64]| Vector3::from(seen.each_ref().map(|row| band.inner(values, row)));
    let wanted = xyz(&decoder.decode(encoding)?);
    let mut rounded = encoding.clone();
    for line in &mut rounded.lines {
        *line = stored_line(band, *line);
    }
    let mut numbers = Vec::with_capacity(encoding.numbers());
    let mut add = |value: f64, function: &[f64], last_bit| {
        numbers.push(Number {
            value,
            xyz: xyz(function),
            norm: band.inner(function, function),
            last_bit,
            is_fixed: false,
        });
    };
    for atom in &rounded.atoms {
        let values = decoder
            .atom(atom.index)
            .ok_or(EncodingError::Lamp { found: atom.index })?;
        add(atom.weight, values, None);
    }
    let (basis, bit) = (rounded.smooth.basis, bit_of(&rounded)?);
    for (n, c) in rounded.smooth.coefficients.iter().enumerate() {
        let function: Vec<f64> = band.grid().map(|nm| basis.function(n, band, nm)).collect();
        add(
            *c,
            &function,
            (n == 0 && !rounded.has_label()).then_some(bit),
        );
    }
    for line in &rounded.lines {
        let mut function = vec![0.0; band.points()];
        line.profile(band).add_to(1.0, &mut function);
        add(line.weight, &function, None);
    }
    round_in_turn(&mut numbers, wanted);
    for (size, number) in rounded.sizes_mut().zip(&numbers) {
        *size = number.value;
    }
    to_words(&rounded)?;
    Ok(rounded)
}

/// Rounds every number, the rest making up for what it does to the colour as long as it can.
fn round_in_turn(numbers: &mut [Number], wanted: Vector3<f64>) {
    let missing = |numbers: &[Number]| {
        let sum = numbers
            .iter()
            .fold(Vector3::zeros(), |sum, n| sum + n.xyz * n.value);
        wanted - sum
    };
    for _ in 0..numbers.len() {
        let lacking = missing(numbers);
        spread(numbers, lacking);
        let free = numbers.iter().enumerate().filter(|(_, n)| !n.is_fixed);
        let Some((next, _)) = free.max_by(|a, b| a.1.reach().total_cmp(&b.1.reach())) else {
            break;
        };
        numbers[next].value = numbers[next].nearest();
        numbers[next].is_fixed = true;
    }
}

/// Changes free numbers as little as possible so that they add `xyz`; nothing where three of them
/// cannot.
fn spread(numbers: &mut [Number], xyz: Vector3<f64>) {
    let is_free = |n: &Number| !n.is_fixed && n.norm > 0.0;
    let free = numbers.iter().filter(|n| is_free(n));
    let sums = ThreeSums::new(free.map(|n| (n.xyz / n.norm.sqrt()).into()));
    let Some(change) = sums.change(xyz.into()) else {
        return;
    };
    let change: Vec<f64> = change.collect();
    if !change.iter().all(|c| c.is_finite()) {
        return;
    }
    for (n, change) in numbers.iter_mut().filter(|n| is_free(n)).zip(change) {
        n.value += change / n.norm.sqrt();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const BAND: Band = Band::VISIBLE;

    fn encodings() -> impl Strategy<Value = Encoding> {
        let weight = || (-1e6_f32..1e6).prop_map(f64::from);
        let atoms = prop::collection::vec((0_u8..158, weight()), 0..=2);
        let smooth = prop::collection::vec(weight(), 4..20);
        let lines = prop::collection::vec((0_u16..=51_200, any::<u8>(), weight()), 0..6);
        (atoms, smooth, lines).prop_map(|(atoms, coefficients, lines)| Encoding {
            atoms: atoms
                .into_iter()
                .map(|(index, weight)| AtomWeight { index, weight })
                .collect(),
            smooth: Series {
                band: BAND,
                basis: Basis::Cosine,
                coefficients,
            },
            lines: lines
                .into_iter()
                .map(|(place, byte, weight)| Line {
                    at_nm: place_nm(BAND, place).expect("a place"),
                    fwhm_nm: width_of_byte(byte),
                    weight,
                })
                .collect(),
            way: None,
        })
    }

    proptest! {
        #[test]
        fn words_lead_back_to_the_encoding(encoding in encodings()) {
            let words = to_words(&encoding).expect("small numbers");
            prop_assert_eq!(words.len(), encoding.numbers());
            let back = from_words(&words, BAND).expect("our own words");
            if encoding.has_label() {
                prop_assert_eq!(back, encoding);
            } else {
                // The first number lost its last bit.
                prop_assert_eq!(to_words(&back).expect("small numbers"), words);
            }
        }

        #[test]
        fn no_words_make_it_panic(words in prop::collection::vec(any::<u32>(), 0..40)) {
            if let Ok(encoding) = from_words(&words, BAND) {
                prop_assert!(encoding.smooth.coefficients.iter().all(|c| c.is_finite()));
                prop_assert_eq!(encoding.numbers(), words.len());
            }
        }

        #[test]
        fn no_text_makes_it_panic(text in ".{0,60}") {
            let _ = words_from_text(&text);
        }
    }

    #[test]
    fn todays_ways_need_no_label() {
        for basis in Basis::ALL {
            let encoding = Encoding {
                atoms: Vec::new(),
                smooth: Series {
                    band: BAND,
                    basis,
                    coefficients: vec![1.0, 0.5, -0.25],
                },
                lines: vec![Line::ideal(436.0, 3.0)],
                way: Some(FitVariant::new(basis, true, true)),
            };
            let decoder = Decoder::new(BAND);
            let rounded = rounded(&encoding, &decoder, Observer::CIE_1931).expect("small numbers");
            let words = to_words(&rounded).expect("small numbers");
            assert_eq!(words.len(), 5);
            assert_eq!(from_words(&words, BAND), Ok(rounded));
        }
    }

    #[test]
    fn faults_are_named() {
        let said = |words: &[u32]| {
            from_words(words, BAND)
                .expect_err("no encoding")
                .to_string()
        };
        assert_eq!(said(&[]), "expected 1 to 4096 words, found 0 words");
        assert_eq!(
            said(&[INTEGER | 0xffff]),
            "expected at least one, found no smooth number"
        );
        assert_eq!(
            said(&[INTEGER | 0x0001_ff00 | 0xf0, 0]),
            "expected a known lamp that covers the range, found index 240"
        );
        assert_eq!(
            said(&[INTEGER | 0x0004_ffff, 0, 0]),
            "expected a number between -1e38 and 1e38, found the end of the words"
        );
        let text = words_from_text("3f800000 zz")
            .expect_err("no word")
            .to_string();
        assert_eq!(
            text,
            "expected eight hexadecimal digits a word, found \"zz\""
        );
    }
}
