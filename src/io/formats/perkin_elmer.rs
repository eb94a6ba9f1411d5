//! PerkinElmer PEDS ASCII: `#HDR`, `#GR` and `#DATA` behind some fixed header lines.
//!
//! ```text
//! PE FL                   SPECTRUM    ASCII       PEDS        1.60
//! ...
//! #GR
//! NM                             unit of x: NM, CM-1
//!                                unit of y: %T, %R, A, INT; empty for intensities
//! ...
//! #DATA
//! 405.000000<TAB>27.150000
//! ```

use super::rows::Rows;
use super::{Confidence, Format};
use crate::io::interpret::{KnownScale, RawSpectrum, alone};
use crate::io::text::{lines, number};
use crate::io::{Decision, Input, ReadError, Reading, WavelengthUnit};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format =
    Format::new("PerkinElmer PEDS ASCII", &["sp", "asc", "txt"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let first = input.first_line();
    Confidence::certain_if(first.starts_with("PE ") && first.contains("ASCII"))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut rows, mut x_unit, mut y_unit) = (Rows::default(), "", "");
    let (mut section, mut below) = (String::new(), 0);
    for (line, content) in lines(text) {
        let content = content.trim();
        if content.starts_with('#') {
            (section, below) = (content.to_ascii_uppercase(), 0);
            continue;
        }
        below += 1;
        match (&*section, below) {
            ("#GR", 1) => x_unit = content,
            ("#GR", 2) => y_unit = content,
            ("#DATA", _) if !content.is_empty() => {
                let number = |word: &str| number::parse(word, word.contains(',')).plain_value();
                let expected = said!("a wavelength and a value");
                rows.add_pair(input, (line, content), number, expected)?;
            }
            _ => {}
        }
    }
    let (mut nm, values) = (rows.take(0), rows.take(1));
    if nm.is_empty() {
        let found = said!("PerkinElmer ASCII without numbers behind #DATA");
        return Err(input.error(found, said!("wavelengths and values")));
    }
    let mut notes = Vec::new();
    match WavelengthUnit::of_title(x_unit) {
        None => {
            let note = said!("the file names no unit of its wavelengths: taken as nm");
            notes.push(note.to_owned());
        }
        Some(WavelengthUnit::Nanometre) => {}
        Some(other) => {
            notes.push(tr!(
                "wavelengths converted from {unit} ({reason})",
                unit = other.word(),
                reason = "#GR"
            ));
            nm.iter_mut().for_each(|x| *x = other.to_nm(*x));
        }
    }
    let fluorescence = input.first_line().starts_with("PE FL");
    let (kind, scale, unit) = match y_unit.to_uppercase().as_str() {
        "%T" | "T%" => (Kind::Transmittance, 0.01, ""),
        "T" => (Kind::Transmittance, 1.0, ""),
        "%R" | "R%" => (Kind::Reflectance, 0.01, ""),
        "R" => (Kind::Reflectance, 1.0, ""),
        "A" | "ABS" => (Kind::Absorbance, 1.0, ""),
        _ if fluorescence => (Kind::Light, 1.0, "a.u."),
        _ => (Kind::Light, 1.0, ""),
    };
    if fluorescence {
        notes.push(said!("a fluorescence spectrum, intensities in arbitrary units").to_owned());
    }
    let kind = match (kind, unit) {
        (Kind::Light, "") => {
            Decision::guessed(kind, false, said!("#GR names no unit of the values"))
        }
        _ => Decision::of_format(kind),
    };
    let mut spectrum = RawSpectrum::known(input.stem(), &nm, values, kind, unit);
    spectrum.lines = &rows.lines;
    spectrum.notes = notes;
    spectrum.known.scale = KnownScale::Stated(scale);
    alone(spectrum, input)
}
