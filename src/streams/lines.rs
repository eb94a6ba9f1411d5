//! Bytes to lines to frames. A broken line is skipped and counted, never shown.
//!
//! A line is one of
//!
//! ```text
//! 400,405,410,...                            wavelengths, nm, once and before any values
//! nm 400 405 410                             the same, told by its first word
//! 0.1,0.2,0.3                                values: between commas, tabs or blanks
//! 415nm:12,445nm:30                          labels with their wavelengths, and values
//! F1:12 F2:30                                labels without, in the order of the wavelengths
//! {"wavelength_nm":[...],"values":[...],"integration_ms":30,"unit":"counts"}
//! # a comment
//! ```

use std::ops::RangeInclusive;

use memchr::memchr;

use super::frame::{Frame, Line};
use crate::spectrum::{Kind, Sampled};
use crate::{
    io::{is_measured, names_wavelength, quoted},
    languages::with_sign,
};

/// The longest line.
pub const MOST_LINE_BYTES: usize = 1 << 20;

/// Wavelengths that a line may tell, nm.
const WAVELENGTHS: RangeInclusive<f64> = 1.0..=100_000.0;

/// Wavelengths of a line that no word tells to be one of them, nm.
const PLAIN_WAVELENGTHS: RangeInclusive<f64> = 100.0..=5000.0;

/// Fewest numbers of a line that are taken for wavelengths without a word that says so: three rising
/// channels of a colour sensor are values.
const LEAST_HEADER: usize = 5;

/// Lines that were skipped.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Broken {
    pub count: u64,
    /// Why the last of them was.
    pub last: String,
}

/// The wavelengths of the lines that follow.
#[derive(Clone)]
struct Axis {
    /// In their order on the line.
    sent: Vec<f64>,
    falls: bool,
    /// Rising, with values of zero.
    zeros: Sampled,
}

impl Axis {
    fn new(sent: Vec<f64>) -> Result<Self, String> {
        if let Some(nm) = sent.iter().find(|nm| !WAVELENGTHS.contains(nm)) {
            let [least, most] = [WAVELENGTHS.start(), WAVELENGTHS.end()];
            return Err(tr!(
                "found a wavelength of {nm} nm, expected {least} to {most}",
                nm = with_sign(nm.to_string()),
                least = with_sign(least.to_string()),
                most = with_sign(most.to_string())
            ));
        }
        let falls = sent.len() > 1 && sent[0] > sent[1];
        let mut nm = sent.clone();
        if falls {
            nm.reverse();
        }
        let count = nm.len();
        let zeros = Sampled::new(nm, vec![0.0; count]).map_err(|why| why.to_string())?;
        Ok(Self { sent, falls, zeros })
    }

    fn samples(&self, mut values: Vec<f64>) -> Result<Sampled, String> {
        let (found, wanted) = (values.len(), self.sent.len());
        if found != wanted {
            return Err(tr!(
                "found {found} values, expected {wanted}, one a wavelength",
                found,
                wanted
            ));
        }
        if let Some(value) = values.iter().find(|value| !is_measured(**value)) {
            return Err(tr!(
                "found the value {value}, expected measured ones",
                value = with_sign(value.to_string())
            ));
        }
        if self.falls {
            values.reverse();
        }
        let samples = self.zeros.sharing(values);
        samples.map_err(|(why, _)| why.to_string())
    }
}

/// Takes a stream of bytes apart.
pub struct Lines {
    name: String,
    pending: Vec<u8>,
    is_overlong: bool,
    axis: Option<Axis>,
    /// True if the wavelengths are an instrument's.
    is_given: bool,
    /// True until values came.
    awaits_header: bool,
    pub(super) broken: Broken,
}

impl Lines {
    /// Lines of a stream, whose frames are called by `name`.
    pub fn new(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            pending: Vec::new(),
            is_overlong: false,
            axis: None,
            is_given: false,
            awaits_header: true,
            broken: Broken::default(),
        }
    }

    /// The same with the wavelengths of an instrument, for lines that tell none.
    ///
    /// # Errors
    /// What was found and what was expected.
    pub fn on_axis(mut self, nm: Vec<f64>) -> Result<Self, String> {
        self.axis = Some(Axis::new(nm)?);
        self.is_given = true;
        Ok(self)
    }

    /// Begins with another producer: half a line and the wavelengths of the one before are gone.
    pub(super) fn begin(&mut self) {
        self.finish();
        self.restart();
    }

    /// Begins with the same bytes anew.
    pub(super) fn restart(&mut self) {
        self.pending.clear();
        self.is_overlong = false;
        self.awaits_header = true;
        if !self.is_given {
            self.axis = None;
        }
    }

    /// The same for another stream: the wavelengths of an instrument stay.
    pub(super) fn anew(&self, name: &str) -> Self {
        Self {
            axis: self.axis.clone().filter(|_| self.is_given),
            is_given: self.is_given,
            ..Self::new(name)
        }
    }

    /// True if a line makes a frame, or tells wavelengths, before any others: an object, or with an
    /// instrument's wavelengths anything.
    pub(super) fn understands(&self, line: &[u8]) -> bool {
        let is_object = line.trim_ascii_start().first() == Some(&b'{');
        (is_object || self.is_given)
            && line.len() <= MOST_LINE_BYTES
            && self.anew("").read(line, 0.0).is_ok()
    }

    /// The end of a stream: what stands behind the last line end is half a line, since a number that
    /// is cut is a number still.
    pub(super) fn finish(&mut self) {
        if self.is_overlong || !self.pending.trim_ascii().is_empty() {
            self.skip(said!("found half a line at the end, expected a line end").to_owned());
        }
        self.pending.clear();
        self.is_overlong = false;
    }

    /// The frame of an object without a line end, which tells itself that it is whole.
    pub(super) fn whole_object(&mut self, time_ms: f64) -> Option<Frame> {
        if self.pending.trim_ascii_start().first() != Some(&b'{') {
            return None;
        }
        let pending = std::mem::take(&mut self.pending);
        match self.read(&pending, time_ms) {
            Ok(frame) => frame,
            Err(_) => {
                self.pending = pending;
                None
            }
        }
    }

    /// True if half a line waits for its end.
    pub(super) fn is_waiting(&self) -> bool {
        !self.pending.trim_ascii().is_empty()
    }

    /// Takes bytes that came at a time, ms, and hands over the frames of all lines that they end.
    pub fn feed(&mut self, mut bytes: &[u8], time_ms: f64, mut take: impl FnMut(Frame)) {
        while let Some(end) = memchr(b'\n', bytes) {
            let (line, rest) = (&bytes[..end], &bytes[end + 1..]);
            bytes = rest;
            if self.is_overlong || self.pending.len() + line.len() > MOST_LINE_BYTES {
                self.pending.clear();
                self.is_overlong = false;
                self.skip(tr!(
                    "found a line of more than {most} bytes, expected a shorter one",
                    most = MOST_LINE_BYTES
                ));
                continue;
            }
            let read = if self.pending.is_empty() {
                self.read(line, time_ms)
            } else {
                let mut whole = std::mem::take(&mut self.pending);
                whole.extend_from_slice(line);
                let read = self.read(&whole, time_ms);
                whole.clear();
                self.pending = whole;
                read
            };
            match read {
                Ok(Some(frame)) => take(frame),
                Ok(None) => {}
                Err(why) => self.skip(why),
            }
        }
        if self.is_overlong || self.pending.len() + bytes.len() > MOST_LINE_BYTES {
            self.is_overlong = true;
            self.pending.clear();
        } else {
            self.pending.extend_from_slice(bytes);
        }
    }

    fn skip(&mut self, why: String) {
        self.broken.count += 1;
        self.broken.last = why;
    }

    fn read(&mut self, line: &[u8], time_ms: f64) -> Result<Option<Frame>, String> {
        let text = std::str::from_utf8(line).map_err(|_| {
            said!("found bytes that are no text, expected a line of numbers").to_owned()
        })?;
        let text = text.trim_start_matches('\u{feff}').trim();
        if text.is_empty() || text.starts_with('#') {
            return Ok(None);
        }
        if text.starts_with('{') {
            return self.object(text, time_ms);
        }
        if text.contains(':') {
            return self.pairs(text, time_ms).map(Some);
        }
        let cells = cells(text);
        if number(cells[0]).is_err() && names_wavelength(cells[0]) {
            self.set_axis(numbers(&cells[1..])?)?;
            return Ok(None);
        }
        let values = numbers(&cells)?;
        if self.is_header(&values) {
            self.set_axis(values)?;
            return Ok(None);
        }
        self.frame(values, time_ms, Line::default()).map(Some)
    }

    /// Whether numbers are wavelengths: they rise or fall all along, before any values, or were sent
    /// as wavelengths before.
    fn is_header(&self, numbers: &[f64]) -> bool {
        let is_again = |axis: &Axis| axis.sent == numbers;
        if self.is_given || !self.awaits_header {
            return self.axis.as_ref().is_some_and(is_again);
        }
        numbers.len() >= LEAST_HEADER
            && numbers.iter().all(|nm| PLAIN_WAVELENGTHS.contains(nm))
            && (numbers.is_sorted_by(|a, b| a < b) || numbers.is_sorted_by(|a, b| a > b))
    }

    fn set_axis(&mut self, nm: Vec<f64>) -> Result<(), String> {
        if self.axis.as_ref().is_none_or(|axis| axis.sent != nm) {
            self.axis = Some(Axis::new(nm)?);
            self.is_given = false;
        }
        Ok(())
    }

    fn object(&mut self, text: &str, time_ms: f64) -> Result<Option<Frame>, String> {
        let mut line: Line = serde_json::from_str(text).map_err(|why| {
            tr!(
                "found no object of numbers ({why}), expected one a line",
                why
            )
        })?;
        let wavelengths = line.wavelength_nm.take();
        if wavelengths.is_none() && line.values.is_none() {
            return Err(said!("found no values, expected the key values").to_owned());
        }
        if let Some(nm) = wavelengths {
            self.set_axis(nm)?;
        }
        match line.values.take() {
            Some(values) => self.frame(values, time_ms, line).map(Some),
            None => Ok(None),
        }
    }

    fn pairs(&mut self, text: &str, time_ms: f64) -> Result<Frame, String> {
        let text = text.replace(": ", ":");
        let pair = |cell: &str| -> Result<(Option<f64>, f64), String> {
            let (label, value) = cell
                .rsplit_once(':')
                .ok_or_else(|| expected(cell, "label:value"))?;
            Ok((wavelength_of(label), number(value)?))
        };
        let pairs: Vec<(Option<f64>, f64)> = cells(&text)
            .into_iter()
            .map(pair)
            .collect::<Result<_, _>>()?;
        let mut placed: Vec<(f64, f64)> = pairs
            .iter()
            .filter_map(|(nm, value)| Some(((*nm)?, *value)))
            .collect();
        if placed.len() < 2 || self.is_given {
            let values = pairs.into_iter().map(|(_, value)| value).collect();
            return self.frame(values, time_ms, Line::default());
        }
        placed.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (nm, values) = placed.into_iter().unzip();
        self.set_axis(nm)?;
        self.frame(values, time_ms, Line::default())
    }

    fn frame(&mut self, values: Vec<f64>, time_ms: f64, line: Line) -> Result<Frame, String> {
        self.awaits_header = false;
        let axis = self.axis.as_ref().ok_or(said!(
            "found values without wavelengths, expected a line of wavelengths before them, \
                 the key wavelength_nm or an instrument"
        ))?;
        let positive = |value: &f64| value.is_finite() && *value > 0.0;
        Ok(Frame {
            time_ms: line.time_ms.filter(|t| t.is_finite()).unwrap_or(time_ms),
            name: line.name.unwrap_or_else(|| self.name.clone()),
            kind: Kind::Light,
            samples: axis.samples(values)?,
            integration_ms: line.integration_ms.filter(positive),
            unit: line.unit.unwrap_or_default(),
            instrument: line.instrument.unwrap_or_default(),
        })
    }
}

fn expected(cell: &str, what: &str) -> String {
    tr!(
        "found {found}, expected {expected}",
        found = quoted(cell),
        expected = what
    )
}

/// The cells of a line: between commas, else tabs, else blanks. One separator may end the line.
fn cells(text: &str) -> Vec<&str> {
    let of = |separator: char| {
        let text = text.strip_suffix(separator).unwrap_or(text);
        text.split(separator).map(str::trim).collect()
    };
    match text {
        text if text.contains(',') => of(','),
        text if text.contains('\t') => of('\t'),
        text => text.split_whitespace().collect(),
    }
}

fn number(cell: &str) -> Result<f64, String> {
    let value = cell.trim().parse::<f64>().ok();
    let value = value.filter(|value| value.is_finite());
    value.ok_or_else(|| expected(cell, said!("a number")))
}

fn numbers(cells: &[&str]) -> Result<Vec<f64>, String> {
    cells.iter().map(|cell| number(cell)).collect()
}

/// The wavelength that a label tells: `415`, `415nm`, `F1 (415 nm)`; not the 1 of `F1`.
fn wavelength_of(label: &str) -> Option<f64> {
    let label = label.trim().trim_end_matches([')', ']']).trim_end();
    let is_unit =
        |at: &usize| label.is_char_boundary(*at) && label[*at..].eq_ignore_ascii_case("nm");
    let number = match label.len().checked_sub(2).filter(is_unit) {
        None => label,
        Some(unit) => {
            let body = label[..unit].trim_end_matches(['(', '[', ' ']);
            let is_digit = |c: char| c.is_ascii_digit() || c == '.';
            &body[body.trim_end_matches(is_digit).len()..]
        }
    };
    let nm = number.parse::<f64>().ok();
    nm.filter(|nm| WAVELENGTHS.contains(nm))
}

#[cfg(test)]
#[path = "../../tests/core/live/lines.rs"]
mod tests;
