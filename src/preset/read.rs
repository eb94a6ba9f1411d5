//! The file as JSON has it, checked and turned into what the program uses.

use serde::Deserialize;

use super::{
    error::PresetError,
    group::{
        AtomicLine, Body, Composite, Group, LineList, OpticalConstants, Preset, PrintedSpike, Terms,
    },
    shelf::Shelf,
};
use crate::spectrum::{Kind, NamedSpectrum, Sampled};

/// The word in `format` that says what the file is.
const FORMAT: &str = "spectral-explorer-presets";

/// The version of the format that is read.
const VERSION: u64 = 1;

/// A whole file; what an item does not state it takes from here.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u64,
    group: String,
    title: String,
    kind: Kind,
    shelf: Shelf,
    source: String,
    licence: Terms,
    attribution: String,
    changes: String,
    #[serde(default)]
    note: String,
    items: Vec<Item>,
}

/// A table, a list of lines or a composite.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Item {
    name: String,
    kind: Option<Kind>,
    shelf: Option<Shelf>,
    /// Symbol of the element whose lines these are.
    element: Option<String>,
    unit: String,
    /// `air` or `vacuum`, where the source states it; `wavelengths` are in air all the same.
    #[serde(rename = "medium")]
    _medium: Option<String>,
    source: Option<String>,
    licence: Option<Terms>,
    note: Option<String>,
    thickness_mm: Option<f64>,
    /// Weakest strength that a list of lines keeps.
    threshold: Option<f64>,
    cie_interpolation: Option<String>,
    cie_extrapolation: Option<String>,
    /// Number of values that are zero because the source had none there.
    nan_filled_with_zero: Option<u32>,
    wavelengths: Option<Wavelengths>,
    values: Option<Vec<f64>>,
    vacuum_nm: Option<Vec<f64>>,
    /// Strengths of lines, `null` where unknown.
    strengths: Option<Vec<Option<f64>>>,
    labels: Option<Vec<String>>,
    n: Option<Vec<f64>>,
    k: Option<Vec<f64>>,
    composite: Option<CompositeText>,
}

/// Wavelengths of the values, nm.
#[derive(Clone, Deserialize)]
#[serde(try_from = "WavelengthsText")]
enum Wavelengths {
    /// `first_nm`, `first_nm + step_nm`, ...
    Even {
        first_nm: f64,
        step_nm: f64,
        count: usize,
    },
    /// Each written out.
    List(Vec<f64>),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct WavelengthsText {
    first_nm: Option<f64>,
    step_nm: Option<f64>,
    count: Option<usize>,
    list_nm: Option<Vec<f64>>,
}

impl TryFrom<WavelengthsText> for Wavelengths {
    type Error = &'static str;

    fn try_from(text: WavelengthsText) -> Result<Self, Self::Error> {
        match (text.first_nm, text.step_nm, text.count, text.list_nm) {
            (Some(first_nm), Some(step_nm), Some(count), None) => Ok(Self::Even {
                first_nm,
                step_nm,
                count,
            }),
            (None, None, None, Some(list)) => Ok(Self::List(list)),
            _ => Err("incomplete wavelengths, expected first_nm, step_nm and count, or list_nm"),
        }
    }
}

impl Wavelengths {
    fn count(&self) -> usize {
        match self {
            Self::Even { count, .. } => *count,
            Self::List(list) => list.len(),
        }
    }

    fn nm(self) -> Vec<f64> {
        match self {
            Self::Even {
                first_nm,
                step_nm,
                count,
            } => (0..count).map(|i| first_nm + i as f64 * step_nm).collect(),
            Self::List(list) => list,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct CompositeText {
    range_nm: [f64; 2],
    #[serde(rename = "basis")]
    _basis: Basis,
    coefficients: Coefficients,
    spikes: Vec<PrintedSpike>,
    weight_factor: f64,
}

/// The only basis that the format knows.
#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Basis {
    Fourier,
}

/// `a0..aN` and `b1..bN`; there is no `b0`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Coefficients {
    a: Vec<f64>,
    b: Vec<f64>,
}

impl Group {
    /// Reads a preset file.
    ///
    /// # Errors
    /// [`PresetError`] when the text is not JSON, is another format or version, has a field that
    /// this version does not know, or an item does not hold together: names used twice, not one
    /// body, lists of unequal length, wavelengths of a table that do not rise.
    pub(crate) fn from_json(text: &str) -> Result<Self, PresetError> {
        let file: File = serde_json::from_str(text)
            .map_err(|error| wrong_header(text).unwrap_or(PresetError::of_json(&error)))?;
        if let Some(error) = header_error(&file.format, file.version) {
            return Err(error);
        }
        let mut group = Self {
            id: file.group,
            title: file.title,
            shelf: file.shelf,
            kind: file.kind,
            source: file.source,
            licence: file.licence,
            attribution: file.attribution,
            changes: file.changes,
            note: file.note,
            items: Vec::with_capacity(file.items.len()),
        };
        for item in file.items {
            if group.items.iter().any(|other| other.name == item.name) {
                return Err(PresetError::of_item(
                    &item.name,
                    "names used once",
                    "used twice",
                ));
            }
            let preset = item.of_group(&group)?;
            group.items.push(preset);
        }
        Ok(group)
    }
}

/// A file of another format or version is called that, not blamed for a field it may have.
fn wrong_header(text: &str) -> Option<PresetError> {
    #[derive(Deserialize)]
    struct Header {
        format: String,
        version: u64,
    }
    let header: Header = serde_json::from_str(text).ok()?;
    header_error(&header.format, header.version)
}

fn header_error(format: &str, version: u64) -> Option<PresetError> {
    let (found, expected) = if format != FORMAT {
        (format!("format \"{format}\""), format!("\"{FORMAT}\""))
    } else if version != VERSION {
        (format!("version {version}"), format!("version {VERSION}"))
    } else {
        return None;
    };
    Some(PresetError {
        line: None,
        found,
        expected,
    })
}

impl Item {
    fn of_group(mut self, group: &Group) -> Result<Preset, PresetError> {
        if self.name.trim().is_empty() {
            return Err(PresetError::of_item(&self.name, "a name", "an empty one"));
        }
        let kind = self.kind.unwrap_or(group.kind);
        let source = self.source.take();
        let source = source.unwrap_or_else(|| group.source.clone());
        let notes = self.notes(&group.note);
        self.check_lengths()?;
        let body = match (
            self.values.take(),
            self.strengths.take(),
            self.composite.take(),
        ) {
            (Some(values), None, None) if kind != Kind::Lines => Body::Spectrum(NamedSpectrum {
                name: self.name.clone(),
                kind,
                unit: self.unit.clone(),
                scale: 1.0,
                samples: self.samples(values)?,
                notes: notes.clone(),
                source: source.clone(),
            }),
            (None, Some(strengths), None) if kind == Kind::Lines => {
                Body::Lines(self.lines(strengths)?)
            }
            (None, None, Some(composite)) if kind != Kind::Lines => {
                Body::Composite(composite.checked(&self.name)?)
            }
            _ => {
                return Err(PresetError::of_item(
                    &self.name,
                    "either values, strengths (of kind lines) or a composite",
                    format!("another mixture of kind {kind}"),
                ));
            }
        };
        Ok(Preset {
            group: group.id.clone(),
            kind,
            shelf: self.shelf.unwrap_or(group.shelf),
            unit: self.unit,
            source,
            licence: self.licence.unwrap_or_else(|| group.licence.clone()),
            notes,
            thickness_mm: self.thickness_mm,
            optical: self.n.zip(self.k).map(|(n, k)| OpticalConstants { n, k }),
            body,
            name: self.name,
        })
    }

    /// Notes on the item, a sentence or two each.
    fn notes(&self, of_group: &str) -> Vec<String> {
        let mut notes: Vec<String> = self.note.iter().cloned().collect();
        if let Some(mm) = self.thickness_mm {
            notes.push(format!("Thickness {mm} mm."));
        }
        if let Some(count) = self.nan_filled_with_zero {
            notes.push(format!("{count} values missing in the source are zero."));
        }
        if let (Some(inside), Some(outside)) = (&self.cie_interpolation, &self.cie_extrapolation) {
            notes.push(format!(
                "The CIE's interpolation is {inside}, extrapolation {outside}."
            ));
        }
        notes.extend(Some(of_group.to_owned()).filter(|note| !note.is_empty()));
        notes
    }

    fn check_lengths(&self) -> Result<(), PresetError> {
        for list in [&self.n, &self.k, &self.vacuum_nm].into_iter().flatten() {
            self.same_length("numbers beside the wavelengths", list.len())?;
        }
        if let Some(labels) = &self.labels {
            self.same_length("labels", labels.len())?;
        }
        Ok(())
    }

    fn samples(&mut self, values: Vec<f64>) -> Result<Sampled, PresetError> {
        self.same_length("values", values.len())?;
        let nm = self.wavelengths.take().map(Wavelengths::nm);
        Sampled::new(nm.unwrap_or_default(), values)
            .map_err(|error| PresetError::of_item(&self.name, "a spectrum", error))
    }

    fn lines(&mut self, strengths: Vec<Option<f64>>) -> Result<LineList, PresetError> {
        self.same_length("strengths", strengths.len())?;
        let nm = self.wavelengths.take().map(Wavelengths::nm);
        let labels = self.labels.as_ref();
        let lines = nm.unwrap_or_default().into_iter().zip(strengths);
        Ok(LineList {
            name: self.name.clone(),
            element: self.element.clone(),
            unit: self.unit.clone(),
            threshold: self.threshold,
            lines: lines
                .enumerate()
                .map(|(i, (at_nm, strength))| AtomicLine {
                    at_nm,
                    vacuum_nm: self.vacuum_nm.as_ref().map(|all| all[i]),
                    strength,
                    label: labels.map(|all| all[i].clone()),
                })
                .collect(),
        })
    }

    fn same_length(&self, what: &str, found: usize) -> Result<(), PresetError> {
        let expected = self.wavelengths.as_ref().map_or(0, Wavelengths::count);
        if found == expected {
            return Ok(());
        }
        Err(PresetError::of_item(
            &self.name,
            format!("as many {what} as wavelengths ({expected})"),
            found,
        ))
    }
}

impl CompositeText {
    fn checked(self, item: &str) -> Result<Composite, PresetError> {
        let ([min_nm, max_nm], Coefficients { a, b }) = (self.range_nm, self.coefficients);
        if a.len() != b.len() + 1 {
            let found = format!("{} and {}", a.len(), b.len());
            return Err(PresetError::of_item(item, "one more a than b", found));
        }
        if min_nm >= max_nm {
            let found = format!("{min_nm} to {max_nm} nm");
            return Err(PresetError::of_item(item, "a rising range", found));
        }
        Ok(Composite {
            range_nm: self.range_nm,
            a,
            b,
            spikes: self.spikes,
            weight_factor: self.weight_factor,
        })
    }
}

#[cfg(test)]
mod tests;
