//! pbrt and Mitsuba `.spd`: one wavelength in nm and one value a line, `#` comments, nothing else.
//!
//! The format states neither kind nor unit; comments and the file's name may. Files named
//! `eta`, `n` or `k` hold optical constants, not a reflectance.

use super::rows::{Rows, filled, numbers};
use super::{Confidence, Format};
use crate::io::interpret::{Heading, RawSpectrum, Scale, alone};
use crate::io::text::{lines, number};
use crate::io::{Input, ReadError, Reading, quoted};

pub(crate) const FORMAT: Format = Format::new("pbrt .spd", &["spd"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let first = lines(input.head())
        .map(|(_, line)| line.split('#').next().unwrap_or("").trim())
        .find(|body| !body.is_empty());
    match first.map(pair) {
        Some(Ok(_)) if input.has_extension("spd") => Confidence::Likely,
        _ => Confidence::No,
    }
}

/// The two numbers of a line, or the finding and the expectation.
fn pair(line: &str) -> Result<[f64; 2], (String, &'static str)> {
    let number = |word: &str| number::number(word, false).filter(|v| v.is_finite());
    let all = numbers(line.split_ascii_whitespace(), usize::MAX, number);
    let all = all.map_err(|(_, word)| (quoted(word), said!("a wavelength in nm and a value")))?;
    match all[..] {
        [nm, value] => Ok([nm, value]),
        [_] => Err((quoted(line), said!("a value after the wavelength"))),
        _ => Err((
            tr!("{n} numbers" | "{n} numbers" % all.len()),
            said!("a wavelength in nm and one value"),
        )),
    }
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let (mut rows, mut comments) = (Rows::default(), Vec::new());
    for (line, content) in filled(text) {
        let (body, comment) = content.split_once('#').unwrap_or((content, ""));
        if !comment.trim().is_empty() && comments.len() < 200 {
            comments.push((line, comment.trim()));
        }
        if !body.trim().is_empty() {
            let pair = pair(body);
            let pair = pair.map_err(|(found, expected)| input.error_at(line, found, expected))?;
            rows.add(line, &pair);
        }
    }
    let (nm, values) = (rows.take(0), rows.take(1));
    let heading = Heading::of(&comments);
    let name = heading.name.unwrap_or(input.stem());
    let scale = Scale::new(&nm);
    let raw = RawSpectrum {
        lines: &rows.lines,
        ..RawSpectrum::written(name, &scale, "", values, &heading).saying_nm(true)
    };
    alone(raw, input)
}
