//! Which laser a Raman spectrum was taken with: as a person says, as the header does, else as the
//! file is called.

use crate::io::Input;
use crate::io::reading::decision::Decision;
use crate::io::text::words::holds_any;

/// Lasers that Raman spectrometers have, nm: from deep ultraviolet to infrared.
const LASERS_NM: std::ops::RangeInclusive<f64> = 220.0..=1100.0;

/// The laser's wavelength, nm; `None` where nothing names it.
pub(super) fn decided<'a>(
    input: &Input,
    headers: impl Iterator<Item = &'a str>,
) -> Option<Decision<f64>> {
    let by_hand = input.choices.laser_nm.map(Decision::chosen);
    let by_header = || of_header(headers).map(|nm| Decision::stated(nm, "the header"));
    // `iR785` in a name is the laser of a Raman spectrometer and nothing else.
    let by_name = || of_name(&input.name).map(|nm| Decision::guessed(nm, true, "the file's name"));
    by_hand.or_else(by_header).or_else(by_name)
}

/// The laser in a file's name: `iR785`, `__Raman__532__`.
pub(super) fn of_name(name: &str) -> Option<f64> {
    let horiba = name.match_indices("iR");
    let rruff = name.match_indices("__Raman__");
    horiba.chain(rruff).find_map(|(at, word)| {
        let before = name[..at].chars().next_back();
        let digits: String = name[at + word.len()..]
            .chars()
            .take_while(char::is_ascii_digit)
            .collect();
        let apart = word != "iR" || before.is_none_or(|c| !c.is_alphanumeric());
        digits
            .parse()
            .ok()
            .filter(|nm| apart && digits.len() >= 3 && LASERS_NM.contains(nm))
    })
}

/// The laser in a header line: `Laser wavelength: 785 nm`, `#Laser=785nm_edge`.
pub(super) fn of_header<'a>(headers: impl Iterator<Item = &'a str>) -> Option<f64> {
    let named: Vec<(f64, bool)> = headers.flat_map(lasers_of_line).collect();
    let by_unit = named.iter().find(|(_, says_nm)| *says_nm);
    by_unit.or(named.first()).map(|(nm, _)| *nm)
}

/// The numbers of a header line that may be a laser's wavelength, not its power or its share, and
/// whether they are said to be one.
fn lasers_of_line(line: &str) -> Vec<(f64, bool)> {
    let lower = line.to_lowercase();
    let words = [
        "laser",
        "excitation",
        "raman wavelength",
        "raman_wavelength",
    ];
    let Some(at) = words.iter().find_map(|word| lower.find(word)) else {
        return Vec::new();
    };
    // RRUFF's crystals lie somehow to the beam: "Laser parallel to c* (0 0 1)".
    if holds_any(&lower, &["orientation", "parallel"]) {
        return Vec::new();
    }
    let is_number = |c: char| c.is_ascii_digit() || c == '.';
    let names_wavelength = holds_any(&lower, &["wavelength", "lambda"]);
    let names_other = holds_any(&lower, &["power", "attenuation", "exposure"]);
    let mut lasers = Vec::new();
    let mut rest = &lower[at..];
    while let Some(from) = rest.find(is_number) {
        rest = &rest[from..];
        let end = rest.find(|c| !is_number(c)).unwrap_or(rest.len());
        let (number, behind) = rest.split_at(end);
        let unit = word_of(behind.trim_start());
        let counts_other = ["mw", "w", "%", "µw", "s", "ms"].contains(&unit);
        let says_nm = unit.starts_with("nm");
        if let Ok(nm) = number.parse::<f64>()
            && LASERS_NM.contains(&nm)
            && nm != 1000.0
            && (says_nm || !counts_other && !names_other)
        {
            lasers.push((nm, says_nm || names_wavelength));
        }
        rest = behind;
    }
    lasers
}

/// The letters (or per cent sign) that a text begins with.
fn word_of(text: &str) -> &str {
    let end = text
        .find(|c: char| !(c.is_alphabetic() || c == '%'))
        .unwrap_or(text.len());
    &text[..end]
}
