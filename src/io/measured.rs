//! A spectrum on its way from an instrument's file, whose format tells what it is, to the library.
//!
//! [`Draft`](super::draft::Draft) guesses from titles and ranges; here the reader already knows
//! the wavelengths in nm, the kind and the unit, and says what it could not know.

use crate::spectrum::{Kind, NamedSpectrum};

use super::curve;
use super::meaning;
use super::reading::provenance;
use super::{Guess, Guessed, Input, ReadError, Reading};

/// What a format knows of one spectrum.
#[derive(Clone, Debug)]
pub struct Measured<'a> {
    /// What to call it.
    pub name: String,
    /// Wavelengths, nm; NaN where one is missing.
    pub nm: &'a [f64],
    /// Values in the file's number; NaN where one is missing.
    pub values: Vec<f64>,
    /// Lines of the points in the file, for messages; one only for a spectrum in a row.
    pub lines: &'a [u32],
    /// What it is.
    pub kind: Kind,
    /// Why it is taken for that, where the file does not state it.
    pub kind_because: Option<String>,
    /// Whether that leaves hardly a doubt.
    pub kind_is_plain: bool,
    /// Unit of its values, `scale` applied; factors count as fractions.
    pub unit: String,
    /// Factor to `unit`; `None` lets the values of a factor tell per cent from fraction.
    pub scale: Option<f64>,
    /// Words for the line of provenance ("1 nm block", "decimal comma").
    pub how: Vec<String>,
    /// What is odd about it, a sentence each.
    pub notes: Vec<String>,
}

impl<'a> Measured<'a> {
    /// A spectrum of a light with nothing more to say about it.
    pub fn light(name: impl Into<String>, nm: &'a [f64], values: Vec<f64>, unit: &str) -> Self {
        Self {
            name: name.into(),
            nm,
            values,
            lines: &[],
            kind: Kind::Light,
            kind_because: None,
            kind_is_plain: false,
            unit: unit.to_owned(),
            scale: Some(1.0),
            how: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Cleans the numbers, applies the scale, and adds the spectrum to a reading.
    ///
    /// # Errors
    /// [`ReadError`] when the numbers are no spectrum.
    pub fn finish(self, input: &Input, reading: &mut Reading) -> Result<(), ReadError> {
        let Self {
            name,
            nm,
            values,
            lines,
            kind,
            kind_because,
            kind_is_plain,
            unit,
            scale,
            mut how,
            notes: own_notes,
        } = self;
        let cleaned = curve::clean(nm, &values).map_err(|trouble| {
            let error = input.error(trouble.to_string(), trouble.expected());
            let line = trouble
                .index()
                .and_then(|index| lines.get(index))
                .or(lines.first());
            match line {
                Some(line) => error.at_line(*line as usize),
                None => error,
            }
        })?;
        let index = reading.spectra.len();
        let mut notes = Vec::new();
        let mut guess = |what, chosen: &str, because: String, plain| {
            notes.push(format!("taken as {chosen}: {because}"));
            reading.guesses.push(Guess {
                spectrum: index,
                what,
                chosen: chosen.to_owned(),
                because,
                plain,
            });
        };
        if let Some(because) = kind_because {
            guess(Guessed::Kind, kind.word(), because, kind_is_plain);
        }
        let scale = scale.unwrap_or_else(|| {
            if !kind.is_factor() {
                return 1.0;
            }
            let found = meaning::percent("", &[], false, cleaned.samples.values());
            let (chosen, scale) = if found.percent {
                ("percent", 0.01)
            } else {
                ("fraction", 1.0)
            };
            guess(Guessed::Percent, chosen, found.because, found.plain);
            scale
        });
        let unit = if kind.is_factor() {
            "fraction".to_owned()
        } else if kind == Kind::Absorbance {
            String::new()
        } else {
            unit
        };
        if kind.is_factor() && scale == 0.01 {
            how.insert(0, "from per cent".to_owned());
        }
        let samples = if scale == 1.0 {
            cleaned.samples
        } else {
            cleaned.samples.scaled(scale)
        };
        let mut spectrum = NamedSpectrum {
            name,
            kind,
            unit,
            scale,
            samples,
            notes: Vec::new(),
            source: input.name.clone(),
        };
        let words: Vec<&str> = how.iter().map(String::as_str).collect();
        let line = provenance(&spectrum, &words);
        if index == 0 {
            reading.notes.insert(0, line.clone());
        }
        spectrum.notes.push(line);
        spectrum.notes.extend(own_notes);
        spectrum.notes.extend(notes);
        spectrum.notes.extend(cleaned.notes);
        reading.spectra.push(spectrum);
        Ok(())
    }
}
