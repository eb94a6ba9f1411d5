//! The unit of a table's wavelength axis: told by a title or the header, else guessed.

use crate::io::reading::decision::Decision;
use crate::io::text::NumberedLines;
use crate::io::text::units::{
    WavelengthUnit, is_of_lengths, looks_like_metres, names_wavelength, unknown_unit,
};
use crate::io::text::words::holds_one;
use crate::languages::{fixed, with_sign};

/// The known properties of an axis.
#[derive(Clone, Copy)]
pub(crate) struct Axis<'a> {
    /// Title and unit above it.
    pub title: &'a str,
    /// Units that lines above the table name, the nearest line first ([`units_of_header`]).
    pub header: &'a [WavelengthUnit],
    /// True if its numbers carry "nm".
    pub says_nm: bool,
    /// True if the file is one of Bruker's `.dpt` tables.
    pub is_dpt: bool,
    /// Smallest and largest number.
    pub range: (f64, f64),
    /// The unevenness of its steps in nm for a given unit; `None` for few steps.
    pub unevenness: &'a dyn Fn(WavelengthUnit) -> Option<f64>,
}

/// Wavelengths in nm that numbers of an axis plausibly are.
const PLAUSIBLE_NM: (f64, f64) = (100.0, 50_000.0);

const LENGTHS: &str = "wavelen;lambda;λ;|wl;wellen";

/// A text in small letters, and whether it names air or the vacuum ultraviolet: a spectrometer may
/// be one for it.
fn in_small(text: &str) -> (String, bool) {
    let text = text.to_lowercase().replace(['_', '-'], " ");
    let is_other = holds_one(&text, "|air|;vacuum uv;vacuum ultra");
    (text, is_other)
}

/// True if the title of wavelengths states that they are wavelengths in vacuum.
pub(crate) fn names_vacuum(title: &str) -> bool {
    let (title, is_other) = in_small(title);
    !is_other && holds_one(&title, "|vacuum|;|vac|;|vakuum") && holds_one(&title, LENGTHS)
}

/// True if a line of a header states it: "vacuum wavelengths", "wavelengths (nm) are in vacuum". A
/// vacuum chamber, or a quantity with a title of its own, implies nothing about them.
pub(crate) fn says_vacuum(line: &str) -> bool {
    const BETWEEN: &str = "in;im;are;is;all;given;stated;quoted;measured;scale;axis;unit;units;\
         medium;nm;um;µm;μm;å;angstrom;)";
    const BEHIND: &str = "and;as;at;by;from;unless;values;nm;um;µm;μm;å;angstrom;)";
    let has = |words: &str, word: &&&str| words.split(';').any(|own| own == **word);
    let is_length = |text: &str| holds_one(text, LENGTHS);
    let (line, is_other) = in_small(line);
    let cells = || line.split([',', ';', '\t']);
    // Of a row of titles the one above the wavelengths tells.
    if is_other || cells().filter(|cell| is_length(cell)).count() > 1 {
        return false;
    }
    cells().any(|cell| {
        let cell = cell.replace([')', ']'], " ) ");
        let parts = |c: char| !c.is_alphanumeric() && c != ')';
        let words: Vec<&str> = cell.split(parts).filter(|word| !word.is_empty()).collect();
        words.iter().enumerate().any(|(at, word)| {
            let (before, behind) = (&words[..at], words.get(at + 1));
            let mut before = before.iter().rev().skip_while(|word| has(BETWEEN, word));
            let is_of = |word: Option<&&str>| word.is_some_and(|word| is_length(word));
            let ends = behind.as_ref().is_none_or(|word| has(BEHIND, word));
            match *word {
                "vacuum" | "vac" | "vakuum" => is_of(behind) || ends && is_of(before.next()),
                _ => word.starts_with("vakuumwellen"),
            }
        })
    })
}

/// Units that lines of a header name for the wavelength axis, the nearest to the table first.
pub(crate) fn units_of_header(lines: &NumberedLines) -> Vec<WavelengthUnit> {
    const ABOUT_AXIS: &str = "wvl;wavelength;wavenumber;lambda;^x unit;^xunit";
    let is_about_axis = |line: &str| names_wavelength(line) || holds_one(line, ABOUT_AXIS);
    let mut units = Vec::new();
    for (_, line) in lines.iter().rev() {
        let lower = line.trim().to_lowercase();
        if is_about_axis(&lower)
            && let Some(unit) = WavelengthUnit::of_title(&lower)
            && !units.contains(&unit)
        {
            units.push(unit);
        }
    }
    units
}

/// Where an axis' unit is named.
#[derive(Clone, Copy)]
enum Whence {
    Title,
    Header,
}

impl Whence {
    fn words(self) -> &'static str {
        match self {
            Self::Title => said!("the column's title"),
            Self::Header => said!("the header"),
        }
    }
}

/// The unit of an axis. A stated unit that makes nonsense of the numbers (under 1 nm or over
/// 1 mm) is passed over; one that takes numbers which would be plausible nanometres to where hardly
/// any light is measured is a guess: a length is then taken for nanometres, other quantities for
/// what they say they are.
///
/// With it another unit that the file names, which makes no sense or is not known here.
pub(crate) fn unit(axis: &Axis) -> (Decision<WavelengthUnit>, Option<String>) {
    let (min, max) = axis.range;
    let [from, to] = [min, max].map(|x| with_sign(x.to_string()));
    let ends = |unit: WavelengthUnit| {
        let (a, b) = (unit.to_nm(min), unit.to_nm(max));
        (a.min(b), a.max(b))
    };
    let makes_sense = |unit: &WavelengthUnit| ends(*unit).0 >= 1.0 && ends(*unit).1 <= 1e6;
    let is_plausible = |(low, high): (f64, f64)| low >= PLAUSIBLE_NM.0 && high <= PLAUSIBLE_NM.1;
    let guess = |unit, because: &str| Decision::guessed(unit, false, because);
    if axis.says_nm {
        let labels = Decision::stated(WavelengthUnit::Nanometre, said!("the file's own labels"));
        return (labels, None);
    }
    let by_title = WavelengthUnit::of_title(axis.title).map(|unit| (unit, Whence::Title));
    // A header may speak of the wave numbers in a column beside the wavelengths.
    let of_lengths = is_of_lengths(axis.title);
    let by_header = || {
        let units = axis.header.iter();
        let fitting = units.filter(|unit| unit.is_length() || !of_lengths);
        fitting.map(|unit| (*unit, Whence::Header))
    };
    let named = || by_title.into_iter().chain(by_header());
    if let Some((unit, whence)) = named().find(|(unit, _)| makes_sense(unit)) {
        if is_plausible(ends(unit)) || !is_plausible((min, max)) {
            return (Decision::stated(unit, whence.words()), None);
        }
        let (low, high) = ends(unit);
        let (low, high, unit_word) = (fixed(low, 4), fixed(high, 4), unit.word());
        let because = match whence {
            Whence::Title => tr!(
                "the column's title says {unit}, which makes {low} to {high} nm of {min} to {max}",
                unit = unit_word,
                low,
                high,
                min = from,
                max = to
            ),
            Whence::Header => tr!(
                "the header says {unit}, which makes {low} to {high} nm of {min} to {max}",
                unit = unit_word,
                low,
                high,
                min = from,
                max = to
            ),
        };
        return if unit.is_length() {
            let other = unit.word().to_owned();
            (guess(WavelengthUnit::Nanometre, &because), Some(other))
        } else {
            (guess(unit, &because), None)
        };
    }
    if axis.is_dpt {
        let because =
            said!("Bruker's .dpt tables mostly count wave numbers; flip it if these are nm");
        return (guess(WavelengthUnit::PerCentimetre, because), None);
    }
    let of_range = WavelengthUnit::of_range(min, max);
    if let Some(unit) = of_range.and_then(|unit| by_steps(axis, unit)) {
        let because = tr!(
            "the range {from} to {to} and its steps, even in nm",
            from,
            to
        );
        return (guess(unit, &because), None);
    }
    let guessed = of_range_alone(axis, of_range, of_lengths);
    let nonsense = by_title.map(|(unit, _)| unit.word().to_owned());
    let against = nonsense
        .or_else(|| unknown_unit(axis.title))
        .filter(|other| other != guessed.value.word());
    (guessed, against)
}

/// The unit that a range suggests, where nothing else tells it.
fn of_range_alone(
    axis: &Axis,
    of_range: Option<WavelengthUnit>,
    of_lengths: bool,
) -> Decision<WavelengthUnit> {
    let (min, max) = axis.range;
    let [from, to] = [min, max].map(|x| with_sign(x.to_string()));
    let guess = |unit, because: &str| Decision::guessed(unit, false, because);
    match of_range {
        Some(WavelengthUnit::PerCentimetre) if is_visible_in_angstrom(axis) => {
            let because = tr!(
                "the range {from} to {to} at even steps, visible light in Å",
                from,
                to
            );
            guess(WavelengthUnit::Angstrom, &because)
        }
        Some(WavelengthUnit::PerCentimetre) if of_lengths => {
            let because = tr!("wavelengths in the range {from} to {to}", from, to);
            guess(WavelengthUnit::Angstrom, &because)
        }
        Some(unit) => guess(unit, &tr!("the range {from} to {to}", from, to)),
        None if looks_like_metres(min, max) => {
            let because = tr!(
                "the range {from} to {to}",
                from = with_sign(format!("{min:e}")),
                to = with_sign(format!("{max:e}"))
            );
            guess(WavelengthUnit::Metre, &because)
        }
        None => guess(
            WavelengthUnit::Nanometre,
            &tr!("no unit fits the range {from} to {to} well", from, to),
        ),
    }
}

/// Energies or frequencies whose range would fit another unit: their steps are even in nm, and not
/// in what the range suggests.
fn by_steps(axis: &Axis, of_range: WavelengthUnit) -> Option<WavelengthUnit> {
    let other = match of_range {
        WavelengthUnit::Micrometre => WavelengthUnit::Electronvolt,
        WavelengthUnit::Nanometre => WavelengthUnit::Terahertz,
        _ => return None,
    };
    let (own, turned) = ((axis.unevenness)(of_range)?, (axis.unevenness)(other)?);
    (turned < 0.1 && turned < 0.1 * own).then_some(other)
}

/// True if wavelengths in ångström would span visible light at even steps: wave numbers in that
/// range are near-infrared, mostly at fractional steps.
fn is_visible_in_angstrom(axis: &Axis) -> bool {
    let (min, max) = axis.range;
    let is_visible = (2000.0..=4500.0).contains(&min) && (6500.0..=11_000.0).contains(&max);
    is_visible
        && min.fract() == 0.0
        && (axis.unevenness)(WavelengthUnit::Angstrom).is_some_and(|uneven| uneven < 1e-6)
}
