//! The unit of a table's wavelength axis: told by a title or the header, else guessed.

use crate::io::reading::decision::Decision;
use crate::io::text::NumberedLines;
use crate::io::text::units::{
    WavelengthUnit, is_of_lengths, looks_like_metres, names_wavelength, unknown_unit,
};
use crate::io::text::words::holds_any;

/// What is known of an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axis<'a> {
    /// Title and unit above it.
    pub title: &'a str,
    /// Units that lines above the table name, the nearest line first ([`units_of_header`]).
    pub header: &'a [WavelengthUnit],
    /// Whether its numbers carry "nm".
    pub says_nm: bool,
    /// Whether the file is one of Bruker's `.dpt` tables.
    pub is_dpt: bool,
    /// Smallest and largest number.
    pub range: (f64, f64),
}

/// Wavelengths in nm that numbers of an axis plausibly are.
const PLAUSIBLE_NM: (f64, f64) = (100.0, 50_000.0);

/// Units that lines of a header name for the wavelength axis, the nearest to the table first.
pub(crate) fn units_of_header(lines: &NumberedLines) -> Vec<WavelengthUnit> {
    let is_about_axis = |line: &str| {
        names_wavelength(line)
            || holds_any(line, &["wvl", "wavelength", "wavenumber", "lambda"])
            || line.starts_with("x unit")
            || line.starts_with("xunit")
    };
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

/// The unit of an axis. A stated unit that makes nonsense of the numbers (under 1 nm or over
/// 1 mm) is passed over; one that takes numbers which would be plausible nanometres to where hardly
/// any light is measured is a guess: a length is then taken for nanometres, other quantities for
/// what they say they are.
///
/// With it another unit that the file names, which makes no sense or is not known here.
pub(crate) fn unit(axis: &Axis) -> (Decision<WavelengthUnit>, Option<String>) {
    let (min, max) = axis.range;
    let ends = |unit: WavelengthUnit| {
        let (a, b) = (unit.to_nm(min), unit.to_nm(max));
        (a.min(b), a.max(b))
    };
    let makes_sense = |unit: &WavelengthUnit| ends(*unit).0 >= 1.0 && ends(*unit).1 <= 1e6;
    let is_plausible = |(low, high): (f64, f64)| low >= PLAUSIBLE_NM.0 && high <= PLAUSIBLE_NM.1;
    let guess = |unit, because: &str| Decision::guessed(unit, false, because);
    if axis.says_nm {
        let labels = Decision::stated(WavelengthUnit::Nanometre, "the file's own labels");
        return (labels, None);
    }
    let by_title = WavelengthUnit::of_title(axis.title).map(|unit| (unit, "the column's title"));
    // A header may speak of the wave numbers in a column beside the wavelengths.
    let of_lengths = is_of_lengths(axis.title);
    let by_header = || {
        let units = axis.header.iter();
        let fitting = units.filter(|unit| unit.is_length() || !of_lengths);
        fitting.map(|unit| (*unit, "the header"))
    };
    let named = || by_title.into_iter().chain(by_header());
    if let Some((unit, whence)) = named().find(|(unit, _)| makes_sense(unit)) {
        if is_plausible(ends(unit)) || !is_plausible((min, max)) {
            return (Decision::stated(unit, whence), None);
        }
        let (low, high) = ends(unit);
        let because = format!(
            "{whence} says {}, which makes {low:.4} to {high:.4} nm of {min} to {max}",
            unit.word()
        );
        return if unit.is_length() {
            let other = unit.word().to_owned();
            (guess(WavelengthUnit::Nanometre, &because), Some(other))
        } else {
            (guess(unit, &because), None)
        };
    }
    if axis.is_dpt {
        let because = "Bruker's .dpt tables mostly count wave numbers; flip it if these are nm";
        return (guess(WavelengthUnit::PerCentimetre, because), None);
    }
    let guessed = match WavelengthUnit::of_range(min, max) {
        Some(WavelengthUnit::PerCentimetre) if of_lengths => {
            let because = format!("wavelengths in the range {min} to {max}");
            guess(WavelengthUnit::Angstrom, &because)
        }
        Some(unit) => guess(unit, &format!("the range {min} to {max}")),
        None if looks_like_metres(min, max) => {
            let because = format!("the range {min:e} to {max:e}");
            guess(WavelengthUnit::Metre, &because)
        }
        None => guess(
            WavelengthUnit::Nanometre,
            &format!("no unit fits the range {min} to {max} well"),
        ),
    };
    let nonsense = by_title.map(|(unit, _)| unit.word().to_owned());
    let against = nonsense
        .or_else(|| unknown_unit(axis.title))
        .filter(|other| other != guessed.value.word());
    (guessed, against)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::io::reading::remark::unit_words;

    fn axis<'a>(title: &'a str, header: &'a [WavelengthUnit], range: (f64, f64)) -> Axis<'a> {
        Axis {
            title,
            header,
            says_nm: false,
            is_dpt: false,
            range,
        }
    }

    #[test]
    fn a_title_outweighs_the_header_and_the_header_the_range() {
        let header = units_of_header(&[(1, "X Units: Wavelength (micrometers)")]);
        let mut axis = axis("Wavelength (nm)", &header, (350.0, 2500.0));
        assert_eq!(unit(&axis).0.value, WavelengthUnit::Nanometre);
        axis.title = "";
        let found = unit(&axis).0.value;
        assert_eq!(found, WavelengthUnit::Nanometre, "2500 um is nonsense");
        axis.range = (0.35, 2.5);
        let (found, _) = unit(&axis);
        assert_eq!(found.value, WavelengthUnit::Micrometre);
        assert!(!found.is_guess());
        axis.header = &[];
        assert!(unit(&axis).0.is_guess());
    }

    #[test]
    fn brukers_point_tables_count_wave_numbers_unless_they_say_so() {
        let mut axis = axis("", &[], (800.0, 2500.0));
        axis.is_dpt = true;
        assert_eq!(unit(&axis).0.value, WavelengthUnit::PerCentimetre);
    }

    /// The unit of 380 to 780 under a title and a header line, and whether a person should look.
    fn of_visible(title: &str, line: &str) -> (String, bool) {
        let header = units_of_header(&[(1, line)]);
        let (found, against) = unit(&axis(title, &header, (380.0, 780.0)));
        let words = unit_words(found.value, against.as_deref());
        (words, !found.is_guess())
    }

    #[test]
    fn a_unit_that_takes_nanometres_away_from_light_is_only_a_guess() {
        let nm = |words: &str| (words.to_owned(), false);
        assert_eq!(of_visible("Våglängd", ""), nm("nm"));
        assert_eq!(of_visible("lambda (Micronix spectrometer)", ""), nm("nm"));
        assert_eq!(
            of_visible("", "Wavelength calibration lamp, Ångström Laboratory"),
            nm("nm, not Å")
        );
        assert_eq!(of_visible("Wavelength (Å)", ""), nm("nm, not Å"));
        assert_eq!(of_visible("Frequency (PHz)", ""), nm("nm, not PHz"));
        assert_eq!(of_visible("Frequency (THz)", ""), ("THz".to_owned(), true));
        assert_eq!(of_visible("[cm-1]", ""), ("1/cm".to_owned(), true));
    }
}
