//! JCAMP-DX 4.24 and 5: labelled records, numbers plain or packed into letters.
//!
//! A record is `##LABEL= value` and the lines below it; labels count without blanks, dashes,
//! slashes, underscores and case, `$$` starts a comment. A file is one block from `##TITLE=` to
//! `##END=`, or a block of `DATA TYPE= LINK` with further blocks inside; every block with a
//! spectrum gives one. Numbers are `XYDATA= (X++(Y..Y))`, lines of an abscissa and many ordinates
//! ([`packed`]), or pairs, `(XY..XY)` ([`pairs`]). Ordinates are multiplied by YFACTOR, abscissas
//! by XFACTOR.
//!
//! - McDonald and Wilks, JCAMP-DX: a standard form for exchange of infrared spectra in computer
//!   readable form, Applied Spectroscopy 42 (1988) 151.
//! - Lampen, Hillig, Davies, Linscheid, JCAMP-DX for mass spectrometry, and version 5.01 of the
//!   IUPAC: same packing.

pub(crate) mod blocks;
pub(crate) mod packed;
pub(crate) mod pairs;

use crate::spectrum::Kind;

use super::{Confidence, Format, extent};
use crate::io::error::quoted;
use crate::io::interpret::heading::Heading;
use crate::io::interpret::raw::{RawSpectrum, Scale};
use crate::io::interpret::{interpret, kinds};
use crate::io::reading::decision::Decision;
use crate::io::reading::remark::Remark;
use crate::io::text::units::WavelengthUnit;
use crate::io::{Input, ReadError, Reading, budget};
use crate::languages::with_sign;
use blocks::Block;

/// JCAMP-DX.
pub(crate) const FORMAT: Format = Format {
    name: "JCAMP-DX",
    extensions: &["jdx", "dx", "jcm", "jcamp"],
    sniff,
    read,
};

/// Memory of a point on its way: abscissa and ordinate, and both again while they are put in
/// order, in bytes.
const POINT_BYTES: usize = 72;

/// Wave numbers under this (1/cm) lie beyond 9 um, where no light is: numbers between
/// [`LOW_NM`] and this are nanometres, regardless of the label.
const HIGH_NM: f64 = 1100.0;
const LOW_NM: f64 = 150.0;

/// The per cent beyond which a value is not taken as a transmittance or reflectance.
const ABSURD_PERCENT: f64 = 1000.0;

fn sniff(input: &Input) -> Confidence {
    let head = input.head();
    let first = head.lines().find(|line| {
        let line = line.trim();
        !line.is_empty() && !line.starts_with("$$")
    });
    Confidence::certain_if(first.and_then(blocks::label_of).is_some_and(|(label, _)| {
        matches!(&*label, "TITLE" | "JCAMPDX" | "JCAMPCS") || head.to_uppercase().contains("JCAMP")
    }))
}

fn read(input: &Input) -> Result<Reading, ReadError> {
    let text = &*input.needs_text()?.text;
    let blocks = blocks::of(input, text)?;
    let mut reading = Reading::default();
    let mut left_points = budget::of_text(input.bytes.len()) / POINT_BYTES;
    let mut refusals = Vec::new();
    for block in &blocks {
        if block.is_link() {
            continue;
        }
        match read_block(input, block, left_points, &mut reading) {
            Ok(points) => left_points = left_points.saturating_sub(points),
            Err(refusal) => refusals.push(refusal),
        }
    }
    if reading.spectra.is_empty() {
        let expected = said!("a block with ##XYDATA= or ##XYPOINTS=");
        let nothing = || input.error(said!("a JCAMP-DX file without data"), expected);
        return Err(refusals.into_iter().next().unwrap_or_else(nothing));
    }
    for why in refusals.iter().take(20) {
        let (found, expected) = (&why.found, &why.expected);
        let note = match why.line {
            Some(line) => tr!(
                "block at line {line} left out: found {found}, expected {expected}",
                line,
                found,
                expected
            ),
            None => tr!(
                "block left out: found {found}, expected {expected}",
                found,
                expected
            ),
        };
        reading.notes.push(note);
    }
    Ok(reading)
}

/// The unit that a block names for its wavelengths; it may leave it open.
///
/// # Errors
/// [`ReadError`] for a spectrum over something else.
fn unit_of(
    input: &Input,
    block: &Block,
    x_units: &str,
    data_type: &str,
) -> Result<Option<WavelengthUnit>, ReadError> {
    if data_type.to_lowercase().contains("raman") {
        let found = said!("a Raman spectrum (shifts from its laser's line)");
        return Err(input.error_at(block.line, found, said!("a spectrum over wavelengths")));
    }
    let unit = WavelengthUnit::of_title(x_units);
    let open = ["", "arbitrary units", "unknown", "none"];
    if unit.is_none() && !open.contains(&x_units.to_lowercase().as_str()) {
        let found = tr!("{unit} on the x axis", unit = quoted(x_units));
        let expected = said!("NANOMETERS, MICROMETERS or 1/CM");
        return Err(input.error_at(block.line_of("XUNITS"), found, expected));
    }
    Ok(unit)
}

/// What is to be said where another count was announced than was found.
fn miscounted(announced: Option<f64>, count: usize) -> Option<String> {
    let announced = announced.filter(|announced| *announced != count as f64)?;
    Some(tr!(
        "NPOINTS says {number}, found {n} points"
            | "NPOINTS says {number}, found {n} points" % count,
        number = with_sign(announced.to_string())
    ))
}

/// Reads the spectrum of one block; returns its number of points.
fn read_block(
    input: &Input,
    block: &Block,
    most_points: usize,
    reading: &mut Reading,
) -> Result<usize, ReadError> {
    let curve = block.curve(input, most_points)?;
    let x_units = block.text("XUNITS").unwrap_or("");
    let y_units = y_units(block);
    let data_type = block.text("DATATYPE").unwrap_or("");
    let unit = unit_of(input, block, x_units, data_type)?;
    let mut notes = Vec::new();
    let (axis, values) = match curve.data.is_pairs {
        true => pairs::read(&curve, &mut notes)?,
        false => packed::read(&curve, &mut notes)?,
    };
    let count = axis.len();
    notes.extend(miscounted(curve.number("NPOINTS")?, count));
    let range = extent(&axis);
    let not_wave_numbers =
        unit == Some(WavelengthUnit::PerCentimetre) && range.0 >= LOW_NM && range.1 <= HIGH_NM;
    let axis_title = match unit.is_some() && !not_wave_numbers {
        true => x_units,
        false => "",
    };
    if not_wave_numbers {
        notes.push(tr!(
            "XUNITS says {unit}, which would be beyond 9 um: taken as nm",
            unit = x_units
        ));
    }
    // A block of the spread of repeated measurements accompanies that of their mean.
    let of_spread = [y_units, data_type, block.text("TITLE").unwrap_or("")]
        .into_iter()
        .find(|text| kinds::is_spread(text));
    let kind = match of_spread {
        Some(_) => Some(Kind::Other),
        None => kinds::kind_of_title(y_units),
    };
    let highest = extent(&values).1;
    let counts = kind.is_some_and(Kind::is_factor) && highest > ABSURD_PERCENT;
    let title = match of_spread {
        Some(spread) => spread,
        None if counts => "counts",
        None => y_units,
    };
    let header = (kind.is_none() && !y_units.is_empty()).then_some((block.line, y_units));
    let index = reading.spectra.len();
    let name = block.text("TITLE").unwrap_or(input.stem()).to_owned();
    let (scale, at) = (Scale::new(&axis), [curve.data.line as u32]);
    let heading = Heading::of(header.as_slice());
    let raw = RawSpectrum {
        title: title.to_owned(),
        lines: &at,
        ..RawSpectrum::written(name, &scale, axis_title, values, &heading)
    };
    interpret(raw.with_comma(curve.decimal_comma), input, reading)?;
    let spectrum = &mut reading.spectra[index];
    if counts && input.choices.kind_of(index).is_none() {
        let because = tr!(
            "YUNITS says {unit}, but the values reach {highest}",
            unit = quoted(y_units),
            highest = with_sign(highest.to_string())
        );
        notes.push(tr!("taken as counts: {reason}", reason = because));
        if let Some(facts) = reading.facts.get_mut(index) {
            facts.decisions.kind = Decision::guessed(spectrum.kind, false, because);
            facts.remarks.retain(|remark| *remark != Remark::Kind);
        }
    } else if !y_units.is_empty() && spectrum.unit.is_empty() {
        notes.push(tr!("values in {unit}", unit = y_units.to_lowercase()));
    }
    let about = [
        ("ORIGIN", said!("origin")),
        ("DATE", said!("date")),
        ("LONGDATE", said!("date")),
    ];
    let about = about.map(|(label, what)| Some(format!("{what}: {}", block.text(label)?)));
    notes.extend(about.into_iter().flatten());
    spectrum.notes.extend(notes);
    Ok(count)
}

/// The unit of the y axis, with instruments' own terms replaced by the standard one.
fn y_units<'b>(block: &'b Block) -> &'b str {
    match block.text("YUNITS").unwrap_or("") {
        "A" | "AU" | "EXTINCTION" => "ABSORBANCE",
        other => other,
    }
}
