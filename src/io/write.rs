//! Writing spectra: which formats there are, what every export says, and numbers.

use std::path::Path;

use crate::spectrum::NamedSpectrum;

use super::atomic::save_atomically;
use super::error::WriteError;
use super::input::name_of;
use super::{argyll_write, csv, spd, spdx_write, spectrum_json};

/// What every export says about itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Provenance {
    /// Program and version ("spectral-explorer 1.0.0").
    pub program: String,
    /// Where the numbers come from; the spectrum's own source where empty.
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
        let Self {
            program,
            source: _,
            scale_words,
            settings,
        } = self;
        let notes = notes_in_a_line(&spectrum.notes);
        [
            ("name", spectrum.name.as_str()),
            ("kind", spectrum.kind.word()),
            ("unit", &spectrum.unit),
            ("source", self.source_of(spectrum)),
            ("scale", scale_words),
            ("settings", settings),
            ("notes", &notes),
            ("written by", program),
        ]
        .into_iter()
        .map(|(key, value)| (key, one_line(value)))
        .filter(|(_, value)| !value.is_empty())
        .collect()
    }

    /// The source to state for a spectrum.
    pub fn source_of<'a>(&'a self, spectrum: &'a NamedSpectrum) -> &'a str {
        if self.source.is_empty() {
            &spectrum.source
        } else {
            &self.source
        }
    }
}

/// What stands between the notes on a spectrum in one line.
const BETWEEN_NOTES: &str = " | ";

/// Most bytes of notes in an export.
const MOST_NOTES: usize = 2000;

/// How a spectrum was read and what is odd about it, in one line. A note that another one begins
/// with is left out: files that were written and read again and again would else grow.
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

/// Adds the notes that [`Provenance::of`] wrote in one line, but what the first note says already:
/// how the file before this one was read is most often how this one is.
pub fn add_notes_of_a_line(notes: &mut Vec<String>, line: &str) {
    let told = |note: &&str| !notes.first().is_some_and(|first| first.starts_with(note));
    let written = line.split(BETWEEN_NOTES).map(str::trim);
    let new: Vec<String> = written.filter(told).map(str::to_owned).collect();
    notes.extend(new);
}

/// Title of the column of measured samples.
pub const MEASURED: &str = "measured";

/// A named column of an export. NaN is written as an empty cell.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// Title above the column.
    pub title: String,
    /// One value each wavelength.
    pub values: Vec<f64>,
}

/// What is written as CSV: columns on one grid.
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
            return Err("found no spectrum, expected at least one".to_owned());
        };
        let same = |s: &NamedSpectrum| (s.kind, &s.unit) == (first.kind, &first.unit);
        if let Some(other) = spectra.iter().find(|s| !same(s)) {
            let words = |s: &NamedSpectrum| match s.unit.as_str() {
                "" => format!("{} ({})", one_line(&s.name), s.kind),
                unit => format!("{} ({}, {unit})", one_line(&s.name), s.kind),
            };
            return Err(format!(
                "found {} beside {}, expected one kind and unit in a file; name one with --spectrum",
                words(first),
                words(other)
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

/// Extensions that [`write_as`] knows, with the format's name for file dialogues.
pub const WRITABLE: [(&str, &str); 5] = [
    ("csv", "CSV"),
    ("json", "spectrum JSON"),
    ("sp", "Argyll .sp"),
    ("spd", "pbrt .spd"),
    ("spdx", "IES TM-27 .spdx"),
];

/// A spectrum in the format of an extension. `columns` is what CSV holds; other formats hold the
/// measured samples.
///
/// # Errors
/// The extensions that can be written, when this one cannot.
pub fn encode(
    extension: &str,
    spectrum: &NamedSpectrum,
    columns: &Columns,
    provenance: &Provenance,
) -> Result<String, String> {
    match extension.to_lowercase().as_str() {
        "csv" => Ok(csv::write(spectrum, columns, provenance)),
        "json" => Ok(spectrum_json::write(spectrum, provenance)),
        "sp" => argyll_write::write(spectrum, provenance),
        "spd" => Ok(spd::write(spectrum, provenance)),
        "spdx" => Ok(spdx_write::write(spectrum, provenance)),
        other => {
            let known: Vec<String> = WRITABLE.iter().map(|(e, _)| format!(".{e}")).collect();
            let found = if other.is_empty() {
                "no extension".to_owned()
            } else {
                format!("extension .{}", one_line(other))
            };
            Err(format!(
                "found {found}, expected one of {}",
                known.join(", ")
            ))
        }
    }
}

/// What the format of an extension does not keep of a spectrum's samples, a sentence each.
pub fn losses(extension: &str, spectrum: &NamedSpectrum) -> Vec<String> {
    match extension.to_lowercase().as_str() {
        "sp" => argyll_write::losses(spectrum),
        "spdx" => spdx_write::losses(spectrum),
        _ => Vec::new(),
    }
}

/// Writes a spectrum in the format of the path's extension, in one step: the file is either the
/// old one or the new one, never half of it.
///
/// # Errors
/// [`WriteError`] for an extension that cannot be written or a place that cannot be written to.
pub fn write_as(
    path: &Path,
    spectrum: &NamedSpectrum,
    columns: &Columns,
    provenance: &Provenance,
) -> Result<(), WriteError> {
    let extension = path
        .extension()
        .map(|e| e.to_string_lossy().into_owned())
        .unwrap_or_default();
    let text = encode(&extension, spectrum, columns, provenance)
        .map_err(|why| WriteError::new(&name_of(path), why))?;
    save_atomically(path, text.as_bytes())
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
pub fn one_line(text: &str) -> String {
    let text: String = text
        .chars()
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect();
    text.trim().to_owned()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::io::{read_bytes, read_path};
    use crate::spectrum::{Kind, Sampled};

    /// A spectrum with numbers and a name that are hard to write.
    pub(crate) fn awkward_spectrum(kind: Kind) -> NamedSpectrum {
        let nm = vec![360.0, 380.1, 404.656, 1e3 / 3.0 + 100.0, 780.0, 2500.25];
        let values = vec![0.1 + 0.2, -0.0, 5e-324, 1.0 / 3.0, -1e-300, 1.25];
        NamedSpectrum {
            name: "Lampe <b> & \"no. 1\", käse; µ".to_owned(),
            kind,
            unit: if kind.is_factor() {
                "fraction"
            } else {
                "W m-2 nm-1"
            }
            .to_owned(),
            scale: 1.0,
            samples: Sampled::new(nm, values).unwrap(),
            notes: Vec::new(),
            source: "Own measurement".to_owned(),
        }
    }

    fn bits(values: &[f64]) -> Vec<u64> {
        values.iter().map(|v| v.to_bits()).collect()
    }

    #[test]
    fn every_writer_is_read_back_to_the_same_bits() {
        let provenance = Provenance {
            program: "spectral-explorer 0.0.0".to_owned(),
            source: String::new(),
            scale_words: "as measured".to_owned(),
            settings: "cosine, N = 7\n".to_owned(),
        };
        let folder = tempfile::tempdir().unwrap();
        for (extension, _) in WRITABLE {
            for kind in Kind::ALL {
                let spectrum = awkward_spectrum(kind);
                let columns = Columns::measured(&spectrum);
                let path = folder.path().join(format!("x.{extension}"));
                write_as(&path, &spectrum, &columns, &provenance).unwrap();
                if *extension == *"sp" {
                    // Even steps only; tests/files/writers.rs has those.
                    continue;
                }
                let reading = read_path(&path).unwrap();
                let back = &reading.spectra[0];
                assert_eq!(
                    bits(back.samples.nm()),
                    bits(spectrum.samples.nm()),
                    "{extension}"
                );
                assert_eq!(
                    bits(back.samples.values()),
                    bits(spectrum.samples.values()),
                    "{extension}"
                );
                assert_eq!(back.scale, 1.0);
                if kind.is_factor() || kind == Kind::Light {
                    assert_eq!(
                        (back.kind, &back.unit),
                        (kind, &spectrum.unit),
                        "{extension}"
                    );
                }
            }
        }
    }

    #[test]
    fn how_a_spectrum_was_read_goes_out_and_comes_back_and_does_not_grow() {
        let folder = tempfile::tempdir().unwrap();
        let provenance = Provenance {
            program: "Spectral Explorer 0.0.0".to_owned(),
            ..Provenance::default()
        };
        let notes = [
            "5 nm steps, 3 points, 380-390 nm, light, W m-2 nm-1, decimal comma",
            "divided by NORM 100; unit: odd",
            "2 missing values dropped",
        ];
        for (extension, _) in WRITABLE {
            let mut spectrum = awkward_spectrum(Kind::Light);
            spectrum.samples = Sampled::even(380.0, 5.0, vec![1.0, 0.5, 0.25]).unwrap();
            spectrum.notes = notes.map(str::to_owned).to_vec();
            let path = folder.path().join(format!("x.{extension}"));
            let mut texts = Vec::new();
            for _ in 0..3 {
                write_as(&path, &spectrum, &Columns::measured(&spectrum), &provenance).unwrap();
                texts.push(std::fs::read_to_string(&path).unwrap());
                spectrum = read_path(&path).unwrap().spectra.remove(0);
                for note in notes {
                    assert!(
                        spectrum.notes.iter().any(|n| n == note),
                        "{extension}: {note} not in {:?}",
                        spectrum.notes
                    );
                }
            }
            assert_eq!(texts[1].len(), texts[2].len(), "{extension}: {}", texts[2]);
        }
    }

    #[test]
    fn what_was_read_back_says_once_how_it_was_read() {
        let folder = tempfile::tempdir().unwrap();
        let provenance = Provenance {
            program: "Spectral Explorer 0.0.0".to_owned(),
            ..Provenance::default()
        };
        let mut spectrum = awkward_spectrum(Kind::Light);
        spectrum.samples = Sampled::even(380.0, 5.0, vec![1.0, 0.5, 0.25]).unwrap();
        let line = "5 nm steps, 3 points, 380-390 nm, light, W m-2 nm-1";
        spectrum.notes = vec![line.to_owned(), "2 missing values dropped".to_owned()];
        for (extension, _) in WRITABLE {
            let path = folder.path().join(format!("x.{extension}"));
            let columns = Columns::measured(&spectrum);
            write_as(&path, &spectrum, &columns, &provenance).unwrap();
            let back = read_path(&path).unwrap().spectra.remove(0).notes;
            let told = |what: &str| back.iter().filter(|note| **note == *what).count();
            assert_eq!(told(line), 1, "{extension}: {back:?}");
            assert_eq!(told(&spectrum.notes[1]), 1, "{extension}: {back:?}");
        }
    }

    #[test]
    fn an_extension_that_cannot_be_written_lists_those_that_can() {
        let spectrum = awkward_spectrum(Kind::Light);
        let columns = Columns::measured(&spectrum);
        let error = write_as(
            Path::new("a.xyz"),
            &spectrum,
            &columns,
            &Provenance::default(),
        );
        assert_eq!(
            error.unwrap_err().to_string(),
            "a.xyz: found extension .xyz, expected one of .csv, .json, .sp, .spd, .spdx"
        );
    }

    #[test]
    fn shortest_numbers_are_exact() {
        for value in [0.1, 380.0, -0.0, 5e-324, f64::MAX, 1e21, 123_456_789.125] {
            let back: f64 = shortest(value).parse().unwrap();
            assert_eq!(back.to_bits(), value.to_bits());
        }
        assert_eq!(shortest(380.0), "380");
        let text = read_bytes("a.csv", b"380,1\n381,2\n").unwrap();
        assert_eq!(text.spectra.len(), 1);
    }
}
