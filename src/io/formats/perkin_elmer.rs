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

use super::{Confidence, Format, pair};
use crate::io::interpret::{KnownScale, RawSpectrum, alone};
use crate::io::text::{kept_line, lines, number};
use crate::io::{Decision, Input, ReadError, Reading, WavelengthUnit, quoted};
use crate::spectrum::Kind;

pub(crate) const FORMAT: Format = Format {
    name: "PerkinElmer PEDS ASCII",
    extensions: &["sp", "asc", "txt"],
    sniff,
    read,
};

fn sniff(input: &Input) -> Confidence {
    let first = input.first_line();
    Confidence::certain_if(first.starts_with("PE ") && first.contains("ASCII"))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut nm, mut values, mut at) = (Vec::new(), Vec::new(), Vec::new());
    let (mut in_data, mut graph, mut x_unit, mut y_unit) = (false, 0, "", "");
    for (line, content) in lines(text) {
        let content = content.trim();
        if content.starts_with('#') {
            in_data = content.eq_ignore_ascii_case("#DATA");
            graph = usize::from(content.eq_ignore_ascii_case("#GR"));
            continue;
        }
        if !in_data {
            match graph {
                1 => x_unit = content,
                2 => y_unit = content,
                _ => {}
            }
            graph += usize::from((1..3).contains(&graph));
            continue;
        }
        if content.is_empty() {
            continue;
        }
        let cell = |word: &str| number::parse(word, word.contains(',')).plain_value();
        let (wavelength, value) = pair(content, cell)
            .map_err(|found| input.error_at(line, quoted(found), "a wavelength and a value"))?;
        nm.push(wavelength);
        values.push(value);
        at.push(kept_line(line));
    }
    if nm.is_empty() {
        let found = "PerkinElmer ASCII without numbers behind #DATA";
        return Err(input.error(found, "wavelengths and values"));
    }
    let mut notes = Vec::new();
    match WavelengthUnit::of_title(x_unit) {
        None => notes.push("the file names no unit of its wavelengths: taken as nm".to_owned()),
        Some(WavelengthUnit::Nanometre) => {}
        Some(other) => {
            notes.push(format!("wavelengths converted from {} (#GR)", other.word()));
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
        notes.push("a fluorescence spectrum, intensities in arbitrary units".to_owned());
    }
    let kind = match (kind, unit) {
        (Kind::Light, "") => Decision::guessed(kind, false, "#GR names no unit of the values"),
        _ => Decision::of_format(kind),
    };
    let mut spectrum = RawSpectrum::known(input.stem(), &nm, values, kind, unit);
    spectrum.lines = &at;
    spectrum.notes = notes;
    spectrum.known.scale = KnownScale::Stated(scale);
    alone(spectrum, input)
}
