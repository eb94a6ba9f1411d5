//! pbrt and Mitsuba `.spd`: one wavelength in nm and one value a line, `#` comments, nothing else.
//!
//! The format states neither kind nor unit; comments and the file's name may. Files whose name
//! says `eta`, `n` or `k` hold optical constants, not a reflectance.

use super::{Confidence, Format};
use crate::io::interpret::{Heading, RawSpectrum, Scale, alone};
use crate::io::text::{kept_line, lines, number};
use crate::io::{Input, ReadError, Reading, quoted};

pub(crate) const FORMAT: Format = Format {
    name: "pbrt .spd",
    extensions: &["spd"],
    sniff,
    read,
};

fn sniff(input: &Input) -> Confidence {
    let first = lines(input.head())
        .map(|(_, line)| line.split('#').next().unwrap_or("").trim())
        .find(|body| !body.is_empty());
    match first.map(pair) {
        Some(Ok(_)) if input.has_extension("spd") => Confidence::Likely,
        _ => Confidence::No,
    }
}

/// The two numbers of a line, or what is wrong with it.
fn pair(line: &str) -> Result<(f64, f64), (String, &'static str)> {
    let mut numbers = [0.0; 2];
    let mut count = 0;
    for word in line.split_ascii_whitespace() {
        let value = number::number(word, false)
            .filter(|v| v.is_finite())
            .ok_or_else(|| (quoted(word), "a wavelength in nm and a value"))?;
        if let Some(slot) = numbers.get_mut(count) {
            *slot = value;
        }
        count += 1;
    }
    match count {
        2 => Ok((numbers[0], numbers[1])),
        1 => Err((quoted(line), "a value after the wavelength")),
        n => Err((format!("{n} numbers"), "a wavelength in nm and one value")),
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut nm, mut values, mut at, mut comments) = (vec![], vec![], vec![], vec![]);
    for (line, content) in lines(text) {
        let content = content.trim();
        let (body, comment) = content.split_once('#').unwrap_or((content, ""));
        if !comment.trim().is_empty() && comments.len() < 200 {
            comments.push((line, comment.trim()));
        }
        if body.trim().is_empty() {
            continue;
        }
        let (wavelength, value) =
            pair(body).map_err(|(found, expected)| input.error_at(line, found, expected))?;
        nm.push(wavelength);
        values.push(value);
        at.push(kept_line(line));
    }
    let heading = Heading::of(&comments);
    let name = heading.name.unwrap_or(input.stem());
    let scale = Scale::new(&nm);
    let raw = RawSpectrum {
        lines: &at,
        ..RawSpectrum::written(name, &scale, "", values, &heading).saying_nm(true)
    };
    alone(raw, input)
}
