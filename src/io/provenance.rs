//! The provenance in every export, and its recovery by a reader.

use crate::languages::said;
use crate::spectrum::NamedSpectrum;

/// The name of the writing program in files written here.
pub(super) const ORIGINATOR: &str = "Spectral Explorer";

/// The provenance stated in every export.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Provenance {
    /// Program and version ("spectral-explorer 1.0.0").
    pub program: String,
    /// The origin of the numbers; the spectrum's own source where empty.
    pub source: String,
    /// The scale in force in words ("as measured", "peak 1", "100 lx").
    pub scale_words: String,
    /// Settings of the model in words; empty where no model is written.
    pub settings: String,
}

impl Provenance {
    /// Keys and values about a spectrum, in the order written; empty ones left out, and no value
    /// holds a line end.
    pub fn of(&self, spectrum: &NamedSpectrum) -> Vec<(&'static str, String)> {
        let notes = notes_in_a_line(&spectrum.notes);
        [
            ("name", spectrum.name.as_str()),
            ("kind", spectrum.kind.word()),
            ("unit", &spectrum.unit),
            ("source", self.source_of(spectrum)),
            ("scale", &self.scale_words),
            ("settings", &self.settings),
            ("notes", &notes),
            ("written by", &self.program),
        ]
        .into_iter()
        .map(|(key, value)| (key, one_line(value)))
        .filter(|(_, value)| !value.is_empty())
        .collect()
    }

    /// The same as comments, a line each, as CSV and `.spd` have them.
    pub(crate) fn comments(&self, spectrum: &NamedSpectrum) -> String {
        let lines = self.of(spectrum).into_iter();
        lines
            .map(|(key, value)| format!("# {key}: {value}\n"))
            .collect()
    }

    /// The source to state for a spectrum.
    pub(crate) fn source_of<'a>(&'a self, spectrum: &'a NamedSpectrum) -> &'a str {
        match self.source.as_str() {
            "" => &spectrum.source,
            source => source,
        }
    }
}

/// The separator between the notes on a spectrum in one line.
const BETWEEN_NOTES: &str = " | ";

/// Most bytes of notes in an export.
const MOST_NOTES: usize = 2000;

/// The interpretation and oddities of a spectrum, in one line. A note that is the beginning of
/// another is left out: otherwise files written and read repeatedly would grow.
fn notes_in_a_line(notes: &[String]) -> String {
    let is_told = |at: usize| {
        let mut others = notes.iter().enumerate();
        others.any(|(other, note)| {
            other != at
                && note.starts_with(&notes[at])
                && (other < at || note.len() > notes[at].len())
        })
    };
    let mut line = String::new();
    for at in (0..notes.len().min(100)).filter(|at| !is_told(*at)) {
        let note = one_line(&notes[at]);
        if note.is_empty() || line.len() + note.len() > MOST_NOTES {
            continue;
        }
        if !line.is_empty() {
            line.push_str(BETWEEN_NOTES);
        }
        line.push_str(&note);
    }
    line
}

/// The notes that [`Provenance::of`] wrote in one line.
pub(super) fn notes_of_a_line(line: &str) -> impl Iterator<Item = &str> {
    line.split(BETWEEN_NOTES).map(str::trim)
}

/// Title of the column of measured samples.
pub(super) const MEASURED: &str = "measured";

/// A named column of an export. NaN is written as an empty cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Title above the column.
    pub title: String,
    /// One value each wavelength.
    pub values: Vec<f64>,
}

/// The contents of a CSV file: columns on one grid.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// Wavelengths, nm.
    pub nm: Vec<f64>,
    /// The columns, each as long as `nm`.
    pub columns: Vec<Column>,
}

impl Columns {
    /// All spectra of a kind and unit, a column each under its name, on every wavelength that one
    /// of them has; where another has none its cell is empty.
    ///
    /// # Errors
    /// One line when there is none, or their kinds or units differ: the file states one.
    pub fn together(spectra: &[NamedSpectrum]) -> Result<Self, String> {
        let Some(first) = spectra.first() else {
            return Err(said!("found no spectrum, expected at least one").to_owned());
        };
        let same = |s: &NamedSpectrum| (s.kind, &s.unit) == (first.kind, &first.unit);
        if let Some(other) = spectra.iter().find(|s| !same(s)) {
            let words = |s: &NamedSpectrum| match s.unit.as_str() {
                "" => format!("{} ({})", one_line(&s.name), said(s.kind.word())),
                unit => format!("{} ({}, {unit})", one_line(&s.name), said(s.kind.word())),
            };
            return Err(tr!(
                "found {first} beside {other}, expected one kind and unit in a file; name one with \
                 --spectrum",
                first = words(first),
                other = words(other)
            ));
        }
        let mut nm: Vec<f64> = first.samples.nm().to_vec();
        for spectrum in &spectra[1..] {
            // A file's spectra share their wavelengths as a rule.
            if spectrum.samples.nm() != &nm[..] {
                nm.extend(spectrum.samples.nm());
                nm.sort_by(f64::total_cmp);
                nm.dedup();
            }
        }
        let column = |spectrum: &NamedSpectrum| {
            let samples = &spectrum.samples;
            let mut own = samples.nm().iter().zip(samples.values()).peekable();
            let values = nm.iter().map(|at| match own.next_if(|(nm, _)| *nm == at) {
                Some((_, value)) => *value,
                None => f64::NAN,
            });
            Column {
                title: title_of(&spectrum.name),
                values: values.collect(),
            }
        };
        Ok(Self {
            columns: spectra.iter().map(column).collect(),
            nm,
        })
    }

    /// The measured samples of a spectrum alone.
    pub fn measured(spectrum: &NamedSpectrum) -> Self {
        Self {
            nm: spectrum.samples.nm().to_vec(),
            columns: vec![Column {
                title: MEASURED.to_owned(),
                values: spectrum.samples.values().to_vec(),
            }],
        }
    }
}

/// The shortest decimals that read back to the same bits: `0.1`, `380`, `5e-324`, `-0`.
pub fn shortest(value: f64) -> String {
    let mut text = format!("{value:?}");
    if text.ends_with(".0") {
        text.truncate(text.len() - 2);
    }
    text
}

/// A spectrum's name as a column's title: a bare number would be taken for data.
fn title_of(name: &str) -> String {
    let name = one_line(name);
    if name.is_empty() || name.replace(',', ".").parse::<f64>().is_ok() {
        format!("spectrum {name}").trim_end().to_owned()
    } else {
        name
    }
}

/// Text without line ends and other control characters.
pub(crate) fn one_line(text: &str) -> String {
    let text: String = text
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    text.trim().to_owned()
}
