//! One word of the commands that trace, make and keep: to a value, or what was found and what was
//! expected.

use super::words::{number, one_of, refused, whole};
use crate::{
    color::{Adaptation, Srgb},
    design::{
        recover::Method,
        solve::{Against, FREE_LINES, Objective},
    },
    measurements::Normalise,
    optics::{self, View},
    pictures::ReferenceKind,
};

/// Any number that is finite.
pub(super) fn finite(word: &str) -> Result<f64, String> {
    let value: Option<f64> = word.trim().parse().ok();
    value
        .filter(|value| value.is_finite())
        .ok_or_else(|| refused(word, "a number"))
}

/// The wavelengths of a combination.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Grid {
    /// Those of all inputs.
    Union,
    /// Those of one input, from 0.
    Input(usize),
    /// Even steps, nm.
    Step(f64),
}

pub(super) fn grid(word: &str) -> Result<Grid, String> {
    let word = word.trim();
    let step = word.trim_end_matches("nm").trim().parse::<f64>().ok();
    match (word.to_ascii_lowercase().as_bytes(), step) {
        (b"union", _) => Ok(Grid::Union),
        ([letter @ b'a'..=b'z'], _) => Ok(Grid::Input(usize::from(letter - b'a'))),
        (_, Some(step)) if (1e-3..=1000.0).contains(&step) => Ok(Grid::Step(step)),
        _ => Err(refused(
            word,
            "union, a letter of an input (a, b) or a step in nm",
        )),
    }
}

/// `--equal`: Y, area, peak, or a wavelength in nm.
pub(super) fn equal(word: &str) -> Result<Normalise, String> {
    let nm = || word.trim_end_matches("nm").trim().parse::<f64>().ok();
    match word.trim().to_lowercase().as_str() {
        "y" => Ok(Normalise::Y),
        "area" => Ok(Normalise::Area),
        "peak" => Ok(Normalise::Peak),
        _ => nm()
            .filter(|nm| *nm > 0.0 && nm.is_finite())
            .map(Normalise::At)
            .ok_or_else(|| refused(word, "Y, area, peak or a wavelength in nm")),
    }
}

/// `--level`: a share, or per cent with its sign.
pub(super) fn level(word: &str) -> Result<f64, String> {
    let (number, unit) = match word.trim().strip_suffix('%') {
        Some(number) => (number, 0.01),
        None => (word, 1.0),
    };
    let level = number.trim().parse::<f64>().ok().map(|level| unit * level);
    level
        .filter(|level| (0.0..1.0).contains(level))
        .ok_or_else(|| refused(word, "per cent such as 1% or a share of 1"))
}

/// `--axis`: nm, with or without the unit.
pub(super) fn axis(word: &str) -> Result<f64, String> {
    let axis = word
        .trim()
        .trim_end_matches("nm")
        .trim()
        .parse::<f64>()
        .ok();
    axis.filter(|axis| (0.0..=100.0).contains(axis))
        .ok_or_else(|| refused(word, "nm from 0 to 100, such as 0.1nm"))
}

/// `--known-doubt`: K.
pub(super) fn known_doubt(word: &str) -> Result<f64, String> {
    let number = word.trim().trim_end_matches('K').trim();
    let kelvin = number.parse::<f64>().ok();
    kelvin
        .filter(|kelvin| (0.0..=1e4).contains(kelvin))
        .ok_or_else(|| refused(word, "K from 0 to 10000, such as 50"))
}

/// `--size` of a traced picture.
pub(super) fn side(word: &str) -> Result<usize, String> {
    whole(word.trim(), &optics::SIZES)
}

pub(super) fn rays(word: &str) -> Result<u32, String> {
    whole(word.trim(), &optics::RAYS)
}

pub(super) fn seed(word: &str) -> Result<u64, String> {
    whole(word.trim(), &(0..=u64::MAX))
}

/// A count whose limits are told where it is used.
pub(super) fn whole_number(word: &str) -> Result<usize, String> {
    let number = word.trim().parse().ok();
    number.ok_or_else(|| refused(word, "a whole number"))
}

pub(super) fn colour(word: &str) -> Result<Srgb, String> {
    word.parse().map_err(|_| refused(word, "#rrggbb"))
}

pub(super) fn method(word: &str) -> Result<Method, String> {
    one_of(word, &Method::ALL, Method::word)
}

pub(super) fn favour(word: &str) -> Result<Objective, String> {
    one_of(word, &Objective::ALL, Objective::word)
}

/// `--front`.
pub(super) fn against(word: &str) -> Result<Against, String> {
    word.parse().map_err(|_| refused(word, "rf,ler or ra,ler"))
}

/// `--lines` of a front.
pub(super) fn free_lines(word: &str) -> Result<usize, String> {
    whole(word.trim(), &FREE_LINES)
}

pub(super) fn bound(word: &str) -> Result<f64, String> {
    number(word, &(0.01..=20.0), "CIEDE2000")
}

/// `--reference` of a picture.
pub(super) fn reference(word: &str) -> Result<ReferenceKind, String> {
    one_of(word, &ReferenceKind::ALL, ReferenceKind::word)
}

/// `--reference` of a table.
pub(super) fn fit_reference(word: &str) -> Result<ReferenceKind, String> {
    one_of(
        word,
        &[ReferenceKind::One, ReferenceKind::Mean],
        ReferenceKind::word,
    )
}

/// Which lines of a picture have a number of their own.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Lines {
    /// Those that are found.
    Auto,
    None,
    /// Those at these places, nm.
    At(Vec<f64>),
}

/// `--lines` of a picture.
pub(super) fn lines(word: &str) -> Result<Lines, String> {
    match word {
        "auto" => Ok(Lines::Auto),
        "none" => Ok(Lines::None),
        _ => {
            let places: Option<Vec<f64>> = word.split(',').map(|n| finite(n).ok()).collect();
            let expected = "auto, none or places in nm with commas";
            places.map(Lines::At).ok_or_else(|| refused(word, expected))
        }
    }
}

/// `--lines` of a table: whether there are any.
pub(super) fn fit_lines(word: &str) -> Result<bool, String> {
    one_of(
        word,
        &[true, false],
        |auto| if auto { "auto" } else { "none" },
    )
}

pub(super) fn blocks(word: &str) -> Result<usize, String> {
    whole(word.trim(), &(1..=*optics::SIZES.end()))
}

pub(super) fn stops(word: &str) -> Result<f64, String> {
    number(word, &(-20.0..=20.0), "stops")
}

/// Three numbers: a place, or X, Y and Z of a colour.
pub(super) fn place(word: &str) -> Result<[f64; 3], String> {
    three(word, "X,Y,Z: three numbers")
}

/// Three numbers: a colour in L\*a\*b\*.
pub(super) fn lab(word: &str) -> Result<[f64; 3], String> {
    three(word, "L,A,B: three numbers")
}

fn three(word: &str, expected: &str) -> Result<[f64; 3], String> {
    let numbers: Option<Vec<f64>> = word.split(',').map(|n| finite(n).ok()).collect();
    numbers
        .and_then(|numbers| numbers.try_into().ok())
        .ok_or_else(|| refused(word, expected))
}

pub(super) fn view(word: &str) -> Result<View, String> {
    match word {
        "A" | "a" => Ok(View::A),
        _ => Err(refused(word, "A (or --from X,Y,Z)")),
    }
}

/// What shines on a gem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lamps {
    /// The scene that is compared with other programs.
    Studio,
    /// The window's.
    Jeweller,
}

pub(super) fn lamps(word: &str) -> Result<Lamps, String> {
    let name = |lamps| match lamps {
        Lamps::Studio => "studio",
        Lamps::Jeweller => "jeweller",
    };
    one_of(word, &[Lamps::Studio, Lamps::Jeweller], name)
}

pub(super) fn seen(word: &str) -> Result<Adaptation, String> {
    let name = |seen| match seen {
        Adaptation::ToLight => "eye",
        Adaptation::None => "camera",
    };
    one_of(word, &[Adaptation::ToLight, Adaptation::None], name)
}
