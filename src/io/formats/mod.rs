//! The formats, one a file or a folder: each rates its confidence in a file, and reads it.

pub(super) mod cgats;
pub(super) mod columns;
pub(super) mod composite_json;
pub(super) mod composite_line;
pub(super) mod cxf;
pub mod envi;
pub(super) mod foreign_json;
pub(super) mod gdtf;
pub(super) mod jcamp;
pub(super) mod keyed_lines;
pub(super) mod licor_1800;
pub(super) mod macam;
pub(super) mod own_csv;
pub(super) mod perkin_elmer;
pub(super) mod procspec;
pub(super) mod raman;
pub(super) mod refractive_yaml;
mod rows;
pub(super) mod sekonic;
pub(super) mod spd;
pub(super) mod spdx;
pub(super) mod spectral_exr;
pub(super) mod spectral_image;
pub(super) mod spectrum_json;
pub(super) mod spotread;
pub(super) mod svc;
pub(super) mod tuv;
pub(super) mod unreadable;
pub(super) mod uprtek;
pub(super) mod usgs;
pub(super) mod wasatch;
pub(super) mod xlsx;

use roxmltree::Node;

use super::decode::xml;
use super::interpret::{KnownScale, RawSpectrum, interpret};
use super::{Input, ReadError, Reading};

/// The confidence of a format that a file is its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Confidence {
    /// Not this format.
    No,
    /// No evidence against it.
    Possible,
    /// The content looks like it.
    Likely,
    /// The content identifies it.
    Certain,
    /// This program wrote it: words in its names that other formats use do not matter.
    Own,
}

impl Confidence {
    /// Certain if the content identifies the format, else not this format.
    fn certain_if(says_so: bool) -> Self {
        match says_so {
            true => Self::Certain,
            false => Self::No,
        }
    }
}

/// The confidence that a file is JSON of this program, marked by a word.
fn own_json(input: &Input, word: &str) -> Confidence {
    Confidence::certain_if(input.head().starts_with('{') && input.head().contains(word))
}

/// Adds the spectrum of an XML element, whose factors are fractions; the lines of its points, where
/// it has any, are their places in `points`.
///
/// # Errors
/// [`ReadError`] at the line of the point or the element when the numbers are no spectrum.
fn add_element(
    input: &Input,
    mut raw: RawSpectrum,
    (node, points): (Node, &[Node]),
    reading: &mut Reading,
) -> Result<(), ReadError> {
    raw.known.scale = KnownScale::Fractions;
    interpret(raw, input, reading).map_err(|refusal| {
        // Lines are counted from the file's start, so only where there is trouble.
        let point = refusal.line.and_then(|place| points.get(place));
        refusal.at_line(xml::line(*point.unwrap_or(&node)))
    })?;
    reading.keep_scale_to_notes();
    Ok(())
}

/// The least and the greatest of some numbers, gaps passed over.
fn extent(numbers: &[f64]) -> (f64, f64) {
    let none = (f64::INFINITY, f64::NEG_INFINITY);
    let wider = |(low, high): (f64, f64), x: &f64| (low.min(*x), high.max(*x));
    numbers.iter().fold(none, wider)
}

/// A file format that the program knows.
#[derive(Clone, Copy)]
pub struct Format {
    /// The name used in messages.
    pub name: &'static str,
    /// Usual extensions, lower case, for file dialogues.
    pub extensions: &'static [&'static str],
    /// Rates the confidence that a file is its own.
    pub sniff: fn(&Input) -> Confidence,
    /// Reads a file of its own, or refuses it.
    pub read: fn(&Input) -> Result<Reading, ReadError>,
}

impl Format {
    const fn new(
        name: &'static str,
        extensions: &'static [&'static str],
        sniff: fn(&Input) -> Confidence,
        read: fn(&Input) -> Result<Reading, ReadError>,
    ) -> Self {
        Self {
            name,
            extensions,
            sniff,
            read,
        }
    }
}

/// Every format, the special before the general.
pub const FORMATS: &[Format] = &[
    envi::FORMAT,
    spectral_exr::FORMAT,
    gdtf::FORMAT,
    xlsx::FORMAT,
    procspec::FORMAT,
    jcamp::FORMAT,
    cxf::FORMAT,
    refractive_yaml::FORMAT,
    unreadable::FORMAT,
    composite_json::FORMAT,
    composite_line::FORMAT,
    spectrum_json::FORMAT,
    foreign_json::FORMAT,
    spdx::FORMAT,
    spd::FORMAT,
    cgats::FORMAT,
    uprtek::FORMAT,
    uprtek::LI_180,
    sekonic::FORMAT,
    licor_1800::FORMAT,
    svc::FORMAT,
    usgs::FORMAT,
    perkin_elmer::FORMAT,
    tuv::FORMAT,
    macam::FORMAT,
    wasatch::FORMAT,
    spotread::FORMAT,
    raman::FORMAT,
    own_csv::FORMAT,
    columns::FORMAT,
];
