//! Macam spectroradiometers `.DTA`: date and time behind `@`, then one number a line.
//!
//! ```text
//! @19/5/1997
//! @17:44:58
//! #No Title
//!  2.5000000000E+02               wavelength in nm
//!  0.0000000000E+00               spectral irradiance, W m-2 nm-1, and so on by turns
//! ```

use super::{Confidence, Format};
use crate::io::interpret::RawSpectrum;
use crate::io::table::alternating;
use crate::io::text::lines;
use crate::io::{Input, ReadError, Reading};

pub(crate) const FORMAT: Format = Format::new("Macam", &["dta"], sniff, read);

fn sniff(input: &Input) -> Confidence {
    let mut first = lines(input.head()).map(|(_, line)| line.trim());
    let dated = first.next().unwrap_or("").starts_with('@');
    let timed = first.next().unwrap_or("").starts_with(['@', '#']);
    Confidence::certain_if(dated && timed)
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let Some(pairs) = alternating::find(text) else {
        let line = lines(text).take(4).count();
        return Err(input.error_at(
            line,
            said!("no wavelengths and values by turns behind Macam's header"),
            said!("one number a line: a wavelength in nm, its value, the next wavelength"),
        ));
    };
    let titles = lines(text).take(5);
    let mut titles = titles.filter_map(|(_, line)| Some(line.trim().strip_prefix('#')?.trim()));
    let is_one = |title: &&str| !title.is_empty() && !title.eq_ignore_ascii_case("no title");
    let name = titles.find(is_one).unwrap_or(input.stem());
    let mut spectrum = RawSpectrum::light(name, &pairs.axis, pairs.values, "W m-2 nm-1");
    spectrum.lines = &pairs.lines;
    let note = said!("W m-2 nm-1 is the instrument's unit; the file states none");
    spectrum.notes.push(note.to_owned());
    alternating::alone(spectrum.with_comma(pairs.decimal_comma), input)
}
