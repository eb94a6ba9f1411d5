//! From what a reader found to a spectrum: axis ([`axis`]), kind ([`kinds`]) and scale, per cent or
//! fraction ([`factor_scale`]), a person's decisions first, then what a format states, which its
//! reader hands over as known. What is decided is kept as [`Decisions`] until the whole file was
//! read; then spectra of a kind are counted alike ([`agree`]) and everything is put in words
//! ([`describe`]).

pub(super) mod agree;
pub(super) mod axis;
pub(super) mod curve;
pub(super) mod describe;
pub(super) mod factor_scale;
pub(super) mod heading;
pub(super) mod kinds;
pub(super) mod raw;
pub(super) mod value_unit;

use crate::io::provenance::notes_of_a_line;
use crate::io::reading::decision::{AxisDecision, Decision, Decisions};
use crate::io::reading::facts::Facts;
use crate::io::reading::remark::{self, Remark};
use crate::io::text::units::{WavelengthUnit, names_wavelength};
use crate::io::{Input, ReadError, Reading, budget};
use crate::languages::{said, with_sign};
use crate::spectrum::{Kind, NamedSpectrum};
use axis::Axis;
use curve::{Cleaned, Trouble};
use factor_scale::{decide_scale, or_large};

pub(super) use factor_scale::KnownScale;
pub(super) use heading::Heading;
pub(super) use raw::{Known, RawAxis, RawSpectrum, Scale};

/// The memory of a spectrum beside its values, in bytes: name, source, and reading notes. Files of
/// tens of thousands of spectra of a few values each would take far more than their size.
const BYTES_BESIDE: usize = 3072;

/// Numbers that instruments write for "not measured", when they stand apart from the other
/// values.
const SENTINELS: [f64; 4] = [-9999.0, -999.0, -99.99, -9.999];

/// Most spectra of one file: more than any library has, and all that are read in a few seconds.
const MOST_SPECTRA: usize = 100_000;

/// Refuses more spectra than one file may hold, or than fit into the memory that it may take; best
/// before they are made.
///
/// # Errors
/// [`ReadError`] with their number.
pub(super) fn check_room(input: &Input, spectra: usize) -> Result<(), ReadError> {
    if spectra > MOST_SPECTRA {
        let expected = tr!("at most {most} in one file", most = MOST_SPECTRA);
        let found = tr!("{n} spectrum" | "{n} spectra" % spectra);
        return Err(input.error(found, expected));
    }
    if spectra.saturating_sub(1) * BYTES_BESIDE <= budget::of(input.bytes.len()) {
        return Ok(());
    }
    let found = tr!("{n} spectrum of a few values" | "{n} spectra of a few values each" % spectra);
    Err(input.error(found, said(budget::WORDS)))
}

/// Decides what a file leaves open about a spectrum and adds it to a reading.
///
/// # Errors
/// [`ReadError`] when the numbers are no spectrum.
pub(super) fn interpret(
    raw: RawSpectrum,
    input: &Input,
    reading: &mut Reading,
) -> Result<(), ReadError> {
    check_room(input, reading.spectra.len() + 1)?;
    add(raw, input, reading)
}

/// The reading of a file that holds this spectrum alone.
pub(super) fn alone(raw: RawSpectrum, input: &Input) -> Result<Reading, ReadError> {
    let mut reading = Reading::default();
    interpret(raw, input, &mut reading)?;
    Ok(reading)
}

/// As [`interpret`], where the reader saw to it that there is room.
pub(super) fn add(raw: RawSpectrum, input: &Input, reading: &mut Reading) -> Result<(), ReadError> {
    let RawSpectrum { title, known, .. } = raw;
    let (index, none) = (reading.spectra.len(), Heading::default());
    let is_written = matches!(raw.axis, RawAxis::Written { .. });
    let heading = raw.heading.unwrap_or(&none);
    let placed = place(raw.axis, raw.values, heading, input)
        .map_err(|trouble| refusal(input, trouble, raw.lines))?;
    let samples = placed.cleaned.samples;
    let mut remarks = vec![Remark::Line];
    let notes = raw.notes.into_iter().chain(placed.notes);
    remarks.extend(notes.chain(placed.cleaned.notes).map(Remark::Note));

    let own = known.kind.clone().unwrap_or_else(|| {
        let found = kinds::kind(&title, &heading.kind, &input.name, samples.values());
        let signs = raw.percent_signs;
        let is_percent = factor_scale::states_percent(&title, heading.percent, signs);
        kinds::no_light_in_percent(found, is_percent, &title)
    });
    let own_kind = own.value;
    let (kind, against_choice) = kind_as_chosen(own, input.choices.kind_of(index));
    remarks.push(against_choice.unwrap_or(Remark::Kind));
    let counted = input.choices.counted_of(index);
    let (counted, scale) = decide_scale((kind.value, own_kind), &known.scale, counted, || {
        let values = samples.values();
        let size = factor_scale::counted(&title, heading.percent, raw.percent_signs, values);
        or_large(size, known.may_be_large, values)
    });
    if is_written || counted.as_ref().is_some_and(Decision::is_guess) {
        remarks.push(Remark::Counted);
    }
    let samples = match scale {
        1.0 => samples,
        scale => samples.scaled(scale),
    };
    let unit_of_values = unit_of_values(kind.value, known, &title, heading);
    let is_written_light = is_written && kind.value == Kind::Light;
    if is_written_light && value_unit::counts_photons(&unit_of_values) {
        remarks.push(Remark::Note(said(remark::PHOTON_NOTE).to_owned()));
    }
    if is_written_light && !placed.unit.is_length() {
        remarks.push(Remark::Note(said(remark::PER_OTHER).to_owned()));
    }
    let before = notes_of_a_line(raw.before).filter(|note| !note.is_empty());
    remarks.extend(before.map(|note| Remark::Before(note.to_owned())));
    reading.spectra.push(NamedSpectrum {
        name: raw.name,
        kind: kind.value,
        unit: unit_of_values,
        scale,
        samples,
        notes: Vec::new(),
        source: raw
            .source
            .unwrap_or_else(|| heading.source.unwrap_or(&input.name).to_owned()),
    });
    reading.facts.push(Facts {
        decisions: Decisions {
            axis: placed.axis,
            kind,
            counted,
        },
        against: placed.against,
        tells_scale: true,
        how: raw.how,
        remarks,
    });
    Ok(())
}

/// A spectrum over its wavelengths, and what was decided about these.
struct Placed {
    cleaned: Cleaned,
    unit: WavelengthUnit,
    axis: Option<AxisDecision>,
    /// Another unit that the file names.
    against: Option<String>,
    notes: Vec<String>,
}

/// Puts values over the wavelengths of an axis.
fn place(
    axis: RawAxis,
    mut values: Vec<f64>,
    heading: &Heading,
    input: &Input,
) -> Result<Placed, Trouble> {
    let (scale, title, says_nm) = match axis {
        RawAxis::Nm(nm, axis) => {
            return Ok(Placed {
                cleaned: curve::clean(nm, &values)?,
                unit: WavelengthUnit::Nanometre,
                axis,
                against: None,
                notes: Vec::new(),
            });
        }
        RawAxis::Written {
            scale,
            title,
            says_nm,
        } => (scale, title, says_nm),
    };
    let (decision, against) = match input.choices.wavelengths {
        Some(unit) => (Decision::chosen(unit), None),
        None => axis::unit(&Axis {
            title: &title,
            header: &heading.axis_units,
            says_nm: says_nm || heading.is_own,
            is_dpt: input.has_extension("dpt"),
            range: scale.extent(),
            unevenness: &|unit| scale.unevenness(unit),
        }),
    };
    let unit = decision.value;
    let mut notes: Vec<String> = Vec::new();
    notes.extend(remark::axis_words(&decision, against.as_deref()));
    // In a file of this program every number was measured.
    if !heading.is_own {
        drop_sentinels(&mut values, &mut notes);
    }
    // All wavelengths here are in air, and a frequency, an energy or a wave number knows those in
    // vacuum alone.
    let in_vacuum = !unit.is_length() || axis::names_vacuum(&title) || heading.in_vacuum;
    let is_turned = in_vacuum && scale.tells_air_from_vacuum(unit);
    let note = match is_turned {
        true => remark::TO_AIR,
        false => remark::KEPT_IN_VACUUM,
    };
    notes.extend(in_vacuum.then(|| said(note).to_owned()));
    let reversals = match names_wavelength(&title) {
        true => curve::TRACED_REVERSALS,
        false => curve::MOST_REVERSALS,
    };
    Ok(Placed {
        cleaned: scale.clean((unit, is_turned), values, reversals)?,
        unit,
        axis: Some(AxisDecision::Unit(decision)),
        against,
        notes,
    })
}

/// The kind of the values: as chosen, else as in the file; with a remark where the file plainly
/// contradicts the choice.
pub(super) fn kind_as_chosen(
    own: Decision<Kind>,
    chosen: Option<Kind>,
) -> (Decision<Kind>, Option<Remark>) {
    let Some(kind) = chosen else {
        return (own, None);
    };
    let goes_against = !own.is_doubtful() && own.value != kind;
    let against = goes_against.then(|| {
        tr!(
            "chosen by hand as {kind}: {reason} tells {other}",
            kind = said(kind.word()),
            reason = own.reason,
            other = said(own.value.word())
        )
    });
    (Decision::chosen(kind), against.map(Remark::Note))
}

/// Factors count as fractions, absorbances as themselves, all else as title, header or format say.
fn unit_of_values(kind: Kind, known: Known, title: &str, heading: &Heading) -> String {
    if kind.is_factor() {
        return "fraction".to_owned();
    }
    if kind == Kind::Absorbance {
        return String::new();
    }
    // What a factor is counted in says nothing of what is taken for something else.
    let unit = known.unit.filter(|unit| unit != "fraction");
    let unit = unit.unwrap_or_else(|| {
        let of_title = value_unit::unit_of_title(title).map(str::to_owned);
        of_title.unwrap_or_else(|| heading.unit.clone())
    });
    match kind {
        Kind::Light
            if value_unit::title_counts_photons(title) && !value_unit::counts_photons(&unit) =>
        {
            value_unit::PHOTONS_ALONE.to_owned()
        }
        Kind::Light if unit.is_empty() && value_unit::title_tells_counts(title) => {
            value_unit::COUNTS.to_owned()
        }
        _ => unit,
    }
}

/// The refusal of numbers that are no spectrum, at their line.
fn refusal(input: &Input, trouble: Trouble, lines: &[u32]) -> ReadError {
    let of_point = trouble.index.and_then(|index| lines.get(index));
    let error = input.error(trouble.found, trouble.expected);
    match of_point.or(lines.first()) {
        Some(line) => error.at_line(*line as usize),
        None => error,
    }
}

/// Turns "not measured" numbers into gaps, if all other values lie well above them.
fn drop_sentinels(values: &mut [f64], notes: &mut Vec<String>) {
    // All of them are below this: a long column is looked through once, not four times.
    if !values.iter().fold(false, |low, v| low | (*v < -9.0)) {
        return;
    }
    for value in SENTINELS {
        let count = values.iter().filter(|v| **v == value).count();
        // A single one of the small numbers may well have been measured.
        let fewest = if value <= -999.0 { 1 } else { 2 };
        if count < fewest {
            continue;
        }
        let lowest = values
            .iter()
            .filter(|v| **v != value && !v.is_nan())
            .fold(f64::INFINITY, |a, v| a.min(*v));
        if lowest.is_finite() && lowest > 0.5 * value {
            for v in values.iter_mut().filter(|v| **v == value) {
                *v = f64::NAN;
            }
            notes.push(tr!(
                "{n} value of {value} taken as not measured"
                    | "{n} values of {value} taken as not measured" % count,
                value = with_sign(value.to_string())
            ));
        }
    }
}
