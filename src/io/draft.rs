//! A spectrum on its way from a text table to the library: unit, kind, scale, order, notes.

use std::borrow::Cow;

use crate::spectrum::{Kind, NamedSpectrum};

use super::argyll_write::ORIGINATOR;
use super::axis::{self, Axis, AxisUnit};
use super::curve::{self, Trouble};
use super::decided::{BY_HAND, MOST_UNDERSTOOD};
use super::kinds::{self, KindFound};
use super::meaning::{self, PercentFound};
use super::reading::{AxisTold, Told, Understood, provenance};
use super::units::{WavelengthUnit, names_wavelength};
use super::{Counted, Guess, Guessed, Input, ReadError, Reading};

/// What a table says about one spectrum.
pub struct Draft<'a> {
    /// What to call it.
    pub name: String,
    /// Title and unit above its values.
    pub title: String,
    /// Title and unit above the wavelengths.
    pub axis_title: String,
    /// Whether the wavelengths say "nm" themselves.
    pub says_nm: bool,
    /// Lines above the table.
    pub header: &'a [(usize, &'a str)],
    /// Wavelengths in the file's unit; NaN where one is missing.
    pub axis: &'a [f64],
    /// Values in the file's number; NaN where one is missing.
    pub values: Vec<f64>,
    /// Lines of the points in the file, for messages; one only for a spectrum in a row.
    pub lines: &'a [u32],
    /// Whether values carry per cent signs.
    pub percent_signs: bool,
    /// Whether decimals are marked by commas.
    pub decimal_comma: bool,
}

/// Numbers that instruments write for "not measured", when they stand apart from the other
/// values.
const SENTINELS: [f64; 4] = [-9999.0, -999.0, -99.99, -9.999];

impl Draft<'_> {
    /// Decides what the file leaves open, notes it, and adds the spectrum to a reading.
    ///
    /// # Errors
    /// [`ReadError`] when the numbers are no spectrum.
    pub fn finish(mut self, input: &Input, reading: &mut Reading) -> Result<(), ReadError> {
        let index = reading.spectra.len();
        let mut notes = Vec::new();
        // Told only once there is a spectrum that they are about.
        let mut guesses = Vec::new();
        let mut guess = |what, chosen: &str, because: &str, plain, notes: &mut Vec<String>| {
            notes.push(format!("taken as {chosen}: {because}"));
            guesses.push(Guess {
                spectrum: index,
                what,
                chosen: chosen.to_owned(),
                because: because.to_owned(),
                plain,
            });
        };

        let AxisUnit {
            unit,
            because,
            stated,
        } = match input.choices.wavelengths {
            Some(unit) => AxisUnit {
                unit,
                because: BY_HAND.to_owned(),
                stated: true,
            },
            None => axis::unit(&Axis {
                title: &self.axis_title,
                header: self.header,
                says_nm: self.says_nm,
                is_dpt: input.has_extension("dpt"),
                range: extent(self.axis),
            }),
        };
        if !stated {
            let what = Guessed::WavelengthUnit;
            guess(what, unit.word(), &because, false, &mut notes);
        } else if unit != WavelengthUnit::Nanometre {
            notes.push(format!(
                "wavelengths converted from {} ({because})",
                unit.word()
            ));
        }
        let nm: Cow<[f64]> = match unit {
            WavelengthUnit::Nanometre => Cow::Borrowed(self.axis),
            _ => Cow::Owned(self.axis.iter().map(|x| unit.to_nm(*x)).collect()),
        };

        let is_own = header_field(self.header, "written by:")
            .is_some_and(|program| program.starts_with(ORIGINATOR));
        // In a file of this program every number was measured.
        if !is_own {
            drop_sentinels(&mut self.values, &mut notes);
        }
        let before = reading.spectra.last().map(|spectrum| &spectrum.samples);
        let reversals = if names_wavelength(&self.axis_title) {
            curve::TRACED_REVERSALS
        } else {
            curve::MOST_REVERSALS
        };
        let values = std::mem::take(&mut self.values);
        let cleaned = curve::clean_beside(before, &nm, values, reversals)
            .map_err(|trouble| self.trouble(input, trouble))?;
        notes.extend(cleaned.notes);
        let mut samples = cleaned.samples;

        let found = match input.choices.kind_of(index) {
            Some(kind) => KindFound {
                kind,
                because: BY_HAND.to_owned(),
                stated: true,
                plain: true,
            },
            None => kinds::kind(&self.title, self.header, &input.name, samples.values()),
        };
        if !found.stated {
            let KindFound {
                kind,
                because,
                plain,
                ..
            } = &found;
            guess(Guessed::Kind, kind.word(), because, *plain, &mut notes);
        }
        let mut counted = None;
        let mut scale = 1.0;
        let mut unit_of_values = meaning::unit(&self.title, self.header);
        if found.kind.is_factor() {
            let by_hand = input.choices.counted_of(index);
            let percent = match by_hand {
                Some(counted) => PercentFound {
                    percent: counted == Counted::Percent,
                    because: BY_HAND.to_owned(),
                    stated: true,
                    plain: true,
                },
                None => meaning::percent(
                    &self.title,
                    self.header,
                    self.percent_signs,
                    samples.values(),
                ),
            };
            let counts = by_hand.unwrap_or(Counted::percent(percent.percent));
            if let Some(to_fraction) = counts.scale().filter(|scale| *scale != 1.0) {
                scale = to_fraction;
                samples = samples.scaled(scale);
            }
            if !percent.stated {
                let (what, chosen) = (Guessed::Percent, counts.word());
                guess(what, chosen, &percent.because, percent.plain, &mut notes);
            } else if percent.percent {
                notes.push(format!("per cent divided by 100 ({})", percent.because));
            }
            counted = Some(Told {
                is: counts,
                because: percent.because,
                stated: percent.stated,
                plain: percent.plain,
            });
            "fraction".clone_into(&mut unit_of_values);
        } else if found.kind == Kind::Absorbance {
            unit_of_values.clear();
        }

        if found.kind == Kind::Light && meaning::counts_photons(&unit_of_values) {
            notes.push(meaning::PHOTON_NOTE.to_owned());
        }
        let comma = if self.decimal_comma {
            "decimal comma"
        } else {
            ""
        };
        let percent = if scale == 0.01 { "from per cent" } else { "" };
        let mut spectrum = NamedSpectrum {
            name: self.name,
            kind: found.kind,
            unit: unit_of_values,
            scale,
            samples,
            notes: Vec::new(),
            source: header_field(self.header, "source:")
                .unwrap_or(&input.name)
                .to_owned(),
        };
        let line = provenance(&spectrum, &[percent, comma]);
        if index == 0 {
            reading.notes.insert(0, line.clone());
        }
        if index < MOST_UNDERSTOOD {
            reading.understood.push(Understood {
                axis: Some(AxisTold::Unit(Told {
                    is: unit,
                    because,
                    stated,
                    plain: stated,
                })),
                kind: Told {
                    is: found.kind,
                    because: found.because,
                    stated: found.stated,
                    plain: found.plain,
                },
                counted,
            });
        }
        spectrum.notes.push(line);
        spectrum.notes.extend(notes);
        reading.guesses.extend(guesses);
        reading.spectra.push(spectrum);
        Ok(())
    }

    fn trouble(&self, input: &Input, trouble: Trouble) -> ReadError {
        let error = input.error(trouble.to_string(), trouble.expected());
        let line = trouble
            .index()
            .and_then(|index| self.lines.get(index))
            .or(self.lines.first());
        match line {
            Some(line) => error.at_line(*line as usize),
            None => error,
        }
    }
}

/// What a header line says behind a word ("name:", "source:"); upper or lower case.
pub fn header_field<'a>(header: &[(usize, &'a str)], word: &str) -> Option<&'a str> {
    header.iter().rev().find_map(|(_, line)| {
        let start = line.trim_start().get(..word.len())?;
        let value = line.trim_start()[word.len()..].trim();
        (start.eq_ignore_ascii_case(word) && !value.is_empty()).then_some(value)
    })
}

fn extent(axis: &[f64]) -> (f64, f64) {
    axis.iter()
        .filter(|x| !x.is_nan())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| {
            (lo.min(*x), hi.max(*x))
        })
}

/// Turns a repeated "not measured" number into gaps, if all other values lie well above it.
fn drop_sentinels(values: &mut [f64], notes: &mut Vec<String>) {
    // All of them are below this: a long column is looked through once, not four times.
    if !values.iter().any(|v| *v < -9.0) {
        return;
    }
    for sentinel in SENTINELS {
        let count = values.iter().filter(|v| **v == sentinel).count();
        let lowest = values
            .iter()
            .filter(|v| **v != sentinel && !v.is_nan())
            .fold(f64::INFINITY, |a, v| a.min(*v));
        if count >= 2 && lowest > 0.5 * sentinel {
            for v in values.iter_mut().filter(|v| **v == sentinel) {
                *v = f64::NAN;
            }
            notes.push(format!(
                "{count} values of {sentinel} taken as not measured"
            ));
        }
    }
}
