//! One number a line: wavelengths and values by turns, as Macam radiometers write them.

use super::row_order::{may_be_wavelengths, runs_one_way};
use crate::io::interpret::heading::Heading;
use crate::io::interpret::interpret;
use crate::io::interpret::raw::{RawSpectrum, Scale};
use crate::io::text::number::{self, Cell};
use crate::io::text::{kept_line, lines};
use crate::io::{Input, ReadError, Reading};

/// Fewest points that alternating lines must hold to be taken for a spectrum.
const FEWEST_POINTS: usize = 5;

/// Longest text that is looked through for them, in bytes: thousands of times what a radiometer
/// writes.
const MOST_BYTES: usize = 16 << 20;

/// A column of single numbers read as pairs.
#[derive(Debug)]
pub(crate) struct Pairs<'a> {
    header: Vec<(usize, &'a str)>,
    /// Wavelengths in the file's unit.
    pub axis: Vec<f64>,
    pub values: Vec<f64>,
    /// Line of each value.
    pub lines: Vec<u32>,
    /// True if decimals are marked by commas.
    pub decimal_comma: bool,
}

/// The lines above the longest run of lines with one number each, and that run with its lines.
type Lone<'a> = (Vec<(usize, &'a str)>, Vec<(u32, f64)>);

fn longest_run(text: &str, decimal_comma: bool) -> Lone<'_> {
    let mut best = Lone::default();
    let (mut header, mut run) = Lone::default();
    let trimmed = lines(text).map(|(line, content)| (line, content.trim()));
    for (line, content) in trimmed.filter(|(_, content)| !content.is_empty()) {
        if let Cell::Number(value) = number::parse(content, decimal_comma) {
            run.push((kept_line(line), value));
            continue;
        }
        if run.len() > best.1.len() {
            best = (std::mem::take(&mut header), std::mem::take(&mut run));
        }
        run.clear();
        if header.len() < 50 {
            header.push((line, content));
        }
    }
    if run.len() > best.1.len() {
        best = (header, run);
    }
    best
}

/// The number of lines with one number each, and the first of them; `None` if there are hardly any.
pub(crate) fn lone_numbers(text: &str) -> Option<(usize, usize)> {
    let (_, run) = longest_run(text, false);
    let (first, _) = run.first()?;
    (run.len() >= FEWEST_POINTS).then_some((run.len(), *first as usize))
}

/// Wavelengths and values by turns, if the text holds them.
pub(crate) fn find(text: &str) -> Option<Pairs<'_>> {
    if text.len() > MOST_BYTES {
        return None;
    }
    [false, true].into_iter().find_map(|decimal_comma| {
        let (header, run) = longest_run(text, decimal_comma);
        // An odd count has one number of a header in front (a count, a scan number).
        let run = &run[run.len() % 2..];
        let numbers: Vec<f64> = run.iter().map(|(_, number)| *number).collect();
        let pairs = || run.chunks_exact(2).map(|pair| (pair[0].1, pair[1]));
        let axis: Vec<f64> = pairs().map(|(nm, _)| nm).collect();
        // What runs one way as a whole is wavelengths alone, without values between them.
        let is_one = axis.len() >= FEWEST_POINTS && may_be_wavelengths(&axis);
        (is_one && !runs_one_way(&numbers)).then(|| Pairs {
            header,
            axis,
            values: pairs().map(|(_, (_, value))| value).collect(),
            lines: pairs().map(|(_, (line, _))| line).collect(),
            decimal_comma,
        })
    })
}

pub(crate) fn read(input: &Input, pairs: &Pairs) -> Result<Reading, ReadError> {
    let (scale, heading) = (Scale::new(&pairs.axis), Heading::of(&pairs.header));
    let raw = RawSpectrum {
        lines: &pairs.lines,
        ..RawSpectrum::written(input.stem(), &scale, "", pairs.values.clone(), &heading)
    };
    alone(raw.with_comma(pairs.decimal_comma), input)
}

/// The reading of a file whose one spectrum is such pairs.
pub(crate) fn alone(raw: RawSpectrum, input: &Input) -> Result<Reading, ReadError> {
    let mut reading = Reading::default();
    interpret(raw, input, &mut reading)?;
    reading
        .notes
        .push(said!("one number a line: wavelength and value by turns").to_owned());
    Ok(reading)
}
