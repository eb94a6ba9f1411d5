//! A spectrum on its way from a text table to the library: unit, kind, scale, order, notes.

use std::cell::{OnceCell, RefCell};

use crate::spectrum::{Kind, NamedSpectrum, Sampled};

use super::axis::{self, Axis, AxisUnit};
use super::curve::{self, Cleaned, Trouble};
use super::decided::{BY_HAND, MOST_UNDERSTOOD};
use super::heading::Heading;
use super::kinds::{self, KindFound};
use super::meaning::{self, PercentFound};
use super::provenance::add_notes_of_a_line;
use super::reading::{AxisTold, Told, Understood, provenance};
use super::units::{WavelengthUnit, names_wavelength};
use super::{Counted, Guess, Guessed, Input, ReadError, Reading, budget};

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
    /// What the lines above the table say.
    pub heading: &'a Heading<'a>,
    /// Its wavelengths.
    pub axis: &'a Scale<'a>,
    /// Values in the file's number; NaN where one is missing.
    pub values: Vec<f64>,
    /// Lines of the points in the file, for messages; one only for a spectrum in a row.
    pub lines: &'a [u32],
    /// Whether values carry per cent signs.
    pub percent_signs: bool,
    /// Whether decimals are marked by commas.
    pub decimal_comma: bool,
}

/// Wavelengths as a file gives them, and what was found of them: a long table has one column of
/// them for many of values.
pub struct Scale<'a> {
    /// In the file's unit; NaN where one is missing.
    numbers: &'a [f64],
    extent: OnceCell<(f64, f64)>,
    /// A spectrum whose wavelengths are these, turned from a unit and otherwise unchanged.
    kept: RefCell<Option<(WavelengthUnit, Sampled)>>,
}

impl<'a> Scale<'a> {
    /// Wavelengths in the file's unit; NaN where one is missing.
    pub fn new(numbers: &'a [f64]) -> Self {
        Self {
            numbers,
            extent: OnceCell::new(),
            kept: RefCell::default(),
        }
    }

    /// The least and the greatest of them.
    fn extent(&self) -> (f64, f64) {
        *self.extent.get_or_init(|| extent(self.numbers))
    }

    /// A spectrum of these wavelengths and of values, in order and without gaps.
    fn clean(
        &self,
        unit: WavelengthUnit,
        values: Vec<f64>,
        reversals: f64,
    ) -> Result<Cleaned, Trouble> {
        let beside = match &*self.kept.borrow() {
            Some((of, kept)) if *of == unit => curve::beside(kept, values),
            _ => Err(values),
        };
        match beside {
            Ok(cleaned) => Ok(cleaned),
            Err(values) => self.clean_alone(unit, &values, reversals),
        }
    }

    fn clean_alone(
        &self,
        unit: WavelengthUnit,
        values: &[f64],
        reversals: f64,
    ) -> Result<Cleaned, Trouble> {
        let turned: Vec<f64>;
        let nm = match unit {
            WavelengthUnit::Nanometre => self.numbers,
            _ => {
                turned = self.numbers.iter().map(|x| unit.to_nm(*x)).collect();
                &turned
            }
        };
        let cleaned = curve::clean_within(nm, values, reversals)?;
        if cleaned.samples.nm() == nm {
            *self.kept.borrow_mut() = Some((unit, cleaned.samples.clone()));
        }
        Ok(cleaned)
    }
}

/// What a spectrum takes beside its values, in bytes: name, source, and how it was read. Files of
/// tens of thousands of spectra of a few values each would take far more than their size.
const BYTES_BESIDE: usize = 3072;

/// Numbers that instruments write for "not measured", when they stand apart from the other
/// values.
const SENTINELS: [f64; 4] = [-9999.0, -999.0, -99.99, -9.999];

/// What is said of a light over an axis that counts no lengths.
const PER_OTHER_NOTE: &str = "the values are kept as written: where they are per unit of that axis \
     (per THz, per 1/cm, per eV) and not per nm, they are not rescaled";

/// Most spectra of one file: more than any library has, and all that are read in a few seconds.
const MOST_SPECTRA: usize = 100_000;

/// Refuses more spectra than one file may hold, or than fit into the memory that it may take; best
/// before they are made.
///
/// # Errors
/// [`ReadError`] with their number.
pub fn check_room(input: &Input, spectra: usize) -> Result<(), ReadError> {
    if spectra > MOST_SPECTRA {
        let expected = format!("at most {MOST_SPECTRA} in one file");
        return Err(input.error(format!("{spectra} spectra"), expected));
    }
    if spectra.saturating_sub(1) * BYTES_BESIDE <= budget::of(input.bytes.len()) {
        return Ok(());
    }
    let found = format!("{spectra} spectra of a few values each");
    Err(input.error(found, budget::WORDS))
}

impl Draft<'_> {
    /// Decides what the file leaves open, notes it, and adds the spectrum to a reading.
    ///
    /// # Errors
    /// [`ReadError`] when the numbers are no spectrum.
    pub fn finish(mut self, input: &Input, reading: &mut Reading) -> Result<(), ReadError> {
        let index = reading.spectra.len();
        check_room(input, index + 1)?;
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

        let found = match input.choices.wavelengths {
            Some(unit) => AxisUnit {
                unit,
                because: BY_HAND.to_owned(),
                stated: true,
                against: None,
            },
            None => axis::unit(&Axis {
                title: &self.axis_title,
                header: &self.heading.axis_units,
                says_nm: self.says_nm || self.heading.is_own,
                is_dpt: input.has_extension("dpt"),
                range: self.axis.extent(),
            }),
        };
        let chosen = found.words();
        let AxisUnit {
            unit,
            because,
            stated,
            against: _,
        } = found;
        if !stated {
            let what = Guessed::WavelengthUnit;
            guess(what, &chosen, &because, false, &mut notes);
        } else if unit != WavelengthUnit::Nanometre {
            notes.push(format!(
                "wavelengths converted from {} ({because})",
                unit.word()
            ));
        }

        // In a file of this program every number was measured.
        if !self.heading.is_own {
            drop_sentinels(&mut self.values, &mut notes);
        }
        let reversals = if names_wavelength(&self.axis_title) {
            curve::TRACED_REVERSALS
        } else {
            curve::MOST_REVERSALS
        };
        let values = std::mem::take(&mut self.values);
        let cleaned = self
            .axis
            .clean(unit, values, reversals)
            .map_err(|trouble| self.trouble(input, trouble))?;
        notes.extend(cleaned.notes);
        let mut samples = cleaned.samples;

        let (title, header) = (&self.title, &self.heading.kind);
        let own = kinds::kind(title, header, &input.name, samples.values());
        let found = match input.choices.kind_of(index) {
            Some(kind) => {
                if own.plain && own.kind != kind {
                    let (tells, because) = (own.kind, &own.because);
                    notes.push(format!("chosen by hand as {kind}: {because} tells {tells}"));
                }
                KindFound {
                    kind,
                    because: BY_HAND.to_owned(),
                    stated: true,
                    plain: true,
                }
            }
            None => own,
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
        let mut unit_of_values = match meaning::unit_of_title(&self.title) {
            Some(unit) => unit.to_owned(),
            None => self.heading.unit.clone(),
        };
        if found.kind.is_factor() {
            let by_hand = input.choices.counted_of(index);
            let percent = match by_hand {
                Some(counted) => PercentFound {
                    percent: counted == Counted::Percent,
                    counted,
                    because: BY_HAND.to_owned(),
                    stated: true,
                    plain: true,
                },
                None => meaning::percent_told(
                    &self.title,
                    self.heading.percent,
                    self.percent_signs,
                    samples.values(),
                ),
            };
            let counts = percent.counted;
            if let Some(to_fraction) = counts.scale().filter(|scale| *scale != 1.0) {
                scale = to_fraction;
                samples = samples.scaled(scale);
            }
            if !percent.stated {
                let (what, chosen) = (Guessed::Percent, counts.word());
                guess(what, chosen, &percent.because, percent.plain, &mut notes);
            } else if percent.percent {
                notes.push(format!("per cent divided by 100 ({})", percent.because));
            } else if counts == Counted::TenThousandths {
                notes.push(format!("values divided by 10000 ({})", percent.because));
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
        if found.kind == Kind::Light && !unit.is_length() {
            notes.push(PER_OTHER_NOTE.to_owned());
        }
        let comma = if self.decimal_comma {
            "decimal comma"
        } else {
            ""
        };
        let percent = match Counted::of_scale(scale) {
            Counted::Percent => "from per cent",
            Counted::TenThousandths => "from ten thousandths",
            Counted::SixteenBits => "from 16-bit numbers",
            Counted::Fraction | Counted::Otherwise => "",
        };
        let mut spectrum = NamedSpectrum {
            name: self.name,
            kind: found.kind,
            unit: unit_of_values,
            scale,
            samples,
            notes: Vec::new(),
            source: self.heading.source.unwrap_or(&input.name).to_owned(),
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
        add_notes_of_a_line(&mut spectrum.notes, self.heading.notes.unwrap_or(""));
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

fn extent(axis: &[f64]) -> (f64, f64) {
    // Eight at a time: a long axis is looked through for each of its columns.
    let (mut low, mut high) = ([f64::INFINITY; 8], [f64::NEG_INFINITY; 8]);
    let (eights, rest) = axis.as_chunks::<8>();
    for some in eights.iter().map(|eight| &eight[..]).chain([rest]) {
        for (i, x) in some.iter().enumerate() {
            // Neither is true of a gap. A zero is no wavelength.
            low[i] = if *x < low[i] && *x > 0.0 { *x } else { low[i] };
            high[i] = if *x > high[i] { *x } else { high[i] };
        }
    }
    (
        low.into_iter().fold(f64::INFINITY, f64::min),
        high.into_iter().fold(f64::NEG_INFINITY, f64::max),
    )
}

/// Turns "not measured" numbers into gaps, if all other values lie well above them.
fn drop_sentinels(values: &mut [f64], notes: &mut Vec<String>) {
    // All of them are below this: a long column is looked through once, not four times.
    if !values.iter().fold(false, |low, v| low | (*v < -9.0)) {
        return;
    }
    for sentinel in SENTINELS {
        let count = values.iter().filter(|v| **v == sentinel).count();
        // A single one of the small numbers may well have been measured.
        let fewest = if sentinel <= -999.0 { 1 } else { 2 };
        if count < fewest {
            continue;
        }
        let lowest = values
            .iter()
            .filter(|v| **v != sentinel && !v.is_nan())
            .fold(f64::INFINITY, |a, v| a.min(*v));
        if lowest.is_finite() && lowest > 0.5 * sentinel {
            for v in values.iter_mut().filter(|v| **v == sentinel) {
                *v = f64::NAN;
            }
            let values = if count == 1 { "value" } else { "values" };
            notes.push(format!(
                "{count} {values} of {sentinel} taken as not measured"
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::io::{Choices, Reading, read_bytes, read_bytes_as};
    use crate::spectrum::Kind;

    fn read(text: &str) -> Reading {
        read_bytes("a.csv", text.as_bytes()).expect("a table")
    }

    #[test]
    fn a_single_not_measured_number_is_a_gap_too() {
        let one = read("nm,lamp\n380,1\n390,-9999\n400,2\n");
        assert_eq!(one.spectra[0].samples.values(), [1.0, 2.0]);
        let notes = &one.spectra[0].notes;
        assert!(notes.contains(&"1 value of -9999 taken as not measured".to_owned()));
        let low = read("nm,lamp\n380,1\n390,-9.999\n400,2\n");
        assert_eq!(low.spectra[0].samples.values(), [1.0, -9.999, 2.0]);
    }

    #[test]
    fn a_kind_that_goes_against_the_file_is_noted() {
        let choices = Choices {
            kind: Some(Kind::Transmittance),
            ..Choices::default()
        };
        let notes = |text: &str| {
            let reading = read_bytes_as("a.csv", text.as_bytes(), &choices).expect("a table");
            reading.spectra[0].notes.join("; ")
        };
        let against =
            "chosen by hand as transmittance: the column's title \"absorbance\" tells absorbance";
        let told = notes("nm,absorbance\n380,0.1\n390,0.5\n");
        assert!(told.contains(against), "{told}");
        for agrees in ["nm,transmittance\n380,0.1\n390,0.5\n", "380,0.1\n390,0.5\n"] {
            let told = notes(agrees);
            assert!(!told.contains("by hand"), "{told}");
        }
    }

    #[test]
    fn metres_are_told_by_a_title_and_guessed_from_their_size() {
        let told = read("wavelength (m),irradiance\n3.8e-7,1\n5e-7,2\n7.8e-07,3\n");
        let samples = &told.spectra[0].samples;
        assert!((samples.first_nm() - 380.0).abs() < 1e-9);
        assert!(
            !told.is_doubtful() || told.guesses.iter().all(|g| g.plain),
            "{:?}",
            told.guesses
        );
        let bare = read("3.8e-7 1e-6\n5.0e-7 3e-6\n6.0e-7 2e-6\n");
        assert!((bare.spectra[0].samples.last_nm() - 600.0).abs() < 1e-9);
        assert!(bare.is_doubtful());
    }

    #[test]
    fn frequencies_and_small_units_are_turned_into_wavelengths_and_said() {
        let thz = read("Frequency (THz),lamp\n400,1\n500,2\n600,3\n");
        let samples = &thz.spectra[0].samples;
        assert!((samples.last_nm() - 299_792.458 / 400.0).abs() < 1e-9);
        assert_eq!(samples.values(), [3.0, 2.0, 1.0]);
        let notes = thz.spectra[0].notes.join("; ");
        assert!(notes.contains("not rescaled"), "{notes}");
        let mev = read("Energy (meV),lamp\n1600,1\n2000,2\n");
        assert!((mev.spectra[0].samples.first_nm() - 619.92).abs() < 0.01);
        let odd = read("Frequency (PHz),lamp [W/m2/nm]\n400,1\n500,2\n");
        assert!(odd.is_doubtful(), "{:?}", odd.guesses);
    }
}
