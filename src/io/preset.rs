//! The shipped spectra's own file format: one JSON file a group, with source and licence.
//!
//! A file is an object with the group's provenance and an array `items`, one item a line. An item
//! is a table (`wavelengths` and `values`), a list of lines (`wavelengths` and `strengths`) or a
//! composite (`composite`). Wavelengths are nm in air; `wavelengths` is either
//! `{"first_nm", "step_nm", "count"}` or `{"list_nm": [...]}`. Numbers are written as the shortest
//! decimals that give the same `f64` back, so that reading and writing lose nothing.

use std::{fmt, io};

use serde::{Deserialize, Serialize};
use serde_json::ser::{CompactFormatter, Formatter};

use crate::spectrum::{Kind, NamedSpectrum, Sampled};

/// The word in `format` that says what the file is.
pub const FORMAT: &str = "spectral-explorer-presets";

/// The version of the format that this module reads and writes.
pub const VERSION: u32 = 1;

/// Why a text is not a preset file.
#[derive(Clone, Debug, PartialEq)]
pub struct PresetError {
    /// Line in the file, counted from 1, where it is known.
    pub line: Option<usize>,
    /// What stands there.
    pub found: String,
    /// What should.
    pub expected: String,
}

impl fmt::Display for PresetError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("preset file")?;
        if let Some(line) = self.line {
            write!(f, ", line {line}")?;
        }
        write!(f, ": expected {}, found {}", self.expected, self.found)
    }
}

impl std::error::Error for PresetError {}

impl PresetError {
    fn of_item(item: &PresetItem, expected: impl Into<String>, found: impl fmt::Display) -> Self {
        Self {
            line: None,
            found: format!("item \"{}\": {found}", item.name),
            expected: expected.into(),
        }
    }

    fn of_json(error: &serde_json::Error) -> Self {
        let line = Some(error.line()).filter(|line| *line > 0);
        // The parser's sentence ends in "at line L column C" and mostly holds "X, expected Y".
        let text = error.to_string();
        let text = text
            .rsplit_once(" at line ")
            .map_or(&*text, |(head, _)| head);
        let (found, expected) = text
            .split_once(", expected ")
            .unwrap_or((text, "a preset file"));
        Self {
            line,
            found: found.to_owned(),
            expected: expected.to_owned(),
        }
    }
}

/// The heading under which the window's library lists an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Shelf {
    /// CIE illuminants A, C, D, E, ID and incandescent lamps, which A stands for.
    #[serde(rename = "Standard lights")]
    Standard,
    /// Fluorescent lamps.
    #[serde(rename = "Fluorescent")]
    Fluorescent,
    /// Light-emitting diodes.
    #[serde(rename = "LED")]
    Led,
    /// Sodium, mercury, metal halide and xenon lamps.
    #[serde(rename = "Discharge")]
    Discharge,
    /// The sun, the sky and the components of daylight.
    #[serde(rename = "Sun and sky")]
    Sun,
    /// The three composites printed in the paper.
    #[serde(rename = "The paper's lamps")]
    Paper,
    /// Lists of atomic lines.
    #[serde(rename = "Line lamps")]
    Lines,
    /// Surfaces, test colours and metals.
    #[serde(rename = "Reflectances")]
    Reflectances,
    /// Transmittances.
    #[serde(rename = "Filters and glasses")]
    Filters,
    /// Colour-matching functions and other weighting functions.
    #[serde(rename = "Observers")]
    Observers,
}

impl Shelf {
    /// Every shelf, in the order in which the library shows them.
    pub const ALL: [Self; 10] = [
        Self::Standard,
        Self::Fluorescent,
        Self::Led,
        Self::Discharge,
        Self::Sun,
        Self::Paper,
        Self::Lines,
        Self::Reflectances,
        Self::Filters,
        Self::Observers,
    ];

    /// The heading, as it stands in files and on screen.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Standard => "Standard lights",
            Self::Fluorescent => "Fluorescent",
            Self::Led => "LED",
            Self::Discharge => "Discharge",
            Self::Sun => "Sun and sky",
            Self::Paper => "The paper's lamps",
            Self::Lines => "Line lamps",
            Self::Reflectances => "Reflectances",
            Self::Filters => "Filters and glasses",
            Self::Observers => "Observers",
        }
    }
}

impl fmt::Display for Shelf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.heading())
    }
}

/// Under which terms numbers may be passed on.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Terms {
    /// SPDX expression; `LicenseRef-facts` for bare numbers that nobody owns.
    pub id: String,
    /// The same in plain words.
    pub words: String,
}

impl fmt::Display for Terms {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.id, self.words)
    }
}

/// One group of shipped spectra: the whole content of a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PresetFile {
    /// Always [`FORMAT`].
    pub format: String,
    /// Always [`VERSION`].
    pub version: u32,
    /// Short name of the group, which is also the file's name.
    pub group: String,
    /// What the group is, in a line.
    pub title: String,
    /// Kind of the items that state none of their own.
    pub kind: Kind,
    /// Heading of the items that state none of their own.
    pub shelf: Shelf,
    /// Where the numbers come from, for items that state no source of their own.
    pub source: String,
    /// Licence of the items that state none of their own.
    pub licence: Terms,
    /// Whom to name, with title and DOI where the licence asks for them.
    pub attribution: String,
    /// What was done to the source's numbers.
    pub changes: String,
    /// What to know before using the group.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub note: String,
    /// The spectra.
    pub items: Vec<PresetItem>,
}

/// One item of a group: a table, a list of lines or a composite.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PresetItem {
    /// Its name, unique in the group.
    pub name: String,
    /// Its kind, where it is not the group's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kind: Option<Kind>,
    /// Its heading, where it is not the group's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shelf: Option<Shelf>,
    /// Symbol of the element whose lines these are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub element: Option<String>,
    /// Unit of the values.
    pub unit: String,
    /// `air` or `vacuum`, where the source states it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub medium: Option<String>,
    /// Its source, where it is not the group's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub source: Option<String>,
    /// Its licence, where it is not the group's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub licence: Option<Terms>,
    /// What is odd about it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// Thickness for which a transmittance holds, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness_mm: Option<f64>,
    /// Weakest strength that a list of lines keeps.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub threshold: Option<f64>,
    /// How the CIE says to interpolate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cie_interpolation: Option<String>,
    /// How the CIE says to extrapolate.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cie_extrapolation: Option<String>,
    /// How many values are zero because the source had none there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub nan_filled_with_zero: Option<u32>,
    /// Wavelengths of a table or of lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wavelengths: Option<Wavelengths>,
    /// Values of a table, one a wavelength.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub values: Option<Vec<f64>>,
    /// Vacuum wavelengths of lines, nm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vacuum_nm: Option<Vec<f64>>,
    /// Strengths of lines, `null` where unknown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strengths: Option<Vec<Option<f64>>>,
    /// Names of lines.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub labels: Option<Vec<String>>,
    /// Refractive index, one a wavelength.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub n: Option<Vec<f64>>,
    /// Extinction coefficient, one a wavelength.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub k: Option<Vec<f64>>,
    /// The composite, instead of a table.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub composite: Option<PresetComposite>,
}

/// Where a table's values stand, nm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "WavelengthsText", into = "WavelengthsText")]
pub enum Wavelengths {
    /// `first_nm`, `first_nm + step_nm`, ...
    Even {
        /// First wavelength, nm.
        first_nm: f64,
        /// Step, nm.
        step_nm: f64,
        /// Number of wavelengths.
        count: usize,
    },
    /// Each wavelength written out, nm.
    List(Vec<f64>),
}

#[derive(Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WavelengthsText {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    first_nm: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    step_nm: Option<f64>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    count: Option<usize>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    list_nm: Option<Vec<f64>>,
}

impl TryFrom<WavelengthsText> for Wavelengths {
    type Error = &'static str;

    fn try_from(text: WavelengthsText) -> Result<Self, Self::Error> {
        match text {
            WavelengthsText {
                first_nm: Some(first_nm),
                step_nm: Some(step_nm),
                count: Some(count),
                list_nm: None,
            } => Ok(Self::Even {
                first_nm,
                step_nm,
                count,
            }),
            WavelengthsText {
                first_nm: None,
                step_nm: None,
                count: None,
                list_nm: Some(list),
            } => Ok(Self::List(list)),
            _ => Err("incomplete wavelengths, expected first_nm, step_nm and count, or list_nm"),
        }
    }
}

impl From<Wavelengths> for WavelengthsText {
    fn from(wavelengths: Wavelengths) -> Self {
        let none = Self {
            first_nm: None,
            step_nm: None,
            count: None,
            list_nm: None,
        };
        match wavelengths {
            Wavelengths::Even {
                first_nm,
                step_nm,
                count,
            } => Self {
                first_nm: Some(first_nm),
                step_nm: Some(step_nm),
                count: Some(count),
                ..none
            },
            Wavelengths::List(list) => Self {
                list_nm: Some(list),
                ..none
            },
        }
    }
}

impl Wavelengths {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Even { count, .. } => *count,
            Self::List(list) => list.len(),
        }
    }

    /// All of them, nm, in the file's order.
    pub fn nm(&self) -> Vec<f64> {
        match self {
            Self::Even {
                first_nm,
                step_nm,
                count,
            } => (0..*count).map(|i| first_nm + i as f64 * step_nm).collect(),
            Self::List(list) => list.clone(),
        }
    }
}

/// The basis of a composite's smooth part.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum PresetBasis {
    /// `a0/2 + sum a_n cos(2 pi n x/L) + b_n sin(2 pi n x/L)`, x = nm above the range's start.
    Fourier,
}

/// A smooth part and spikes, as printed in the paper.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PresetComposite {
    /// First and last wavelength of the model, nm.
    pub range_nm: [f64; 2],
    /// Basis of the smooth part.
    pub basis: PresetBasis,
    /// Coefficients of the smooth part.
    pub coefficients: PresetCoefficients,
    /// Spikes with the weights as printed.
    pub spikes: Vec<PresetSpike>,
    /// Factor that takes a printed weight to unit x nm (the paper does not state it).
    pub weight_factor: f64,
}

/// Fourier coefficients: `a0..aN` and `b1..bN`; there is no `b0`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PresetCoefficients {
    /// `a0` (to be halved) to `aN`.
    pub a: Vec<f64>,
    /// `b1` to `bN`.
    pub b: Vec<f64>,
}

/// A spike with its weight as printed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PresetSpike {
    /// Place, nm.
    pub at_nm: f64,
    /// Weight as printed; times [`PresetComposite::weight_factor`] it is in unit x nm.
    pub weight: f64,
}

impl PresetComposite {
    /// Places (nm) and weights in unit x nm, the factor applied.
    pub fn spikes_in_unit_nm(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.spikes
            .iter()
            .map(|spike| (spike.at_nm, spike.weight * self.weight_factor))
    }
}

/// Spectral lines of one element, or named absorption lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LineList {
    /// What the list is called.
    pub name: String,
    /// Symbol of the element, if all lines are of one.
    pub element: Option<String>,
    /// What the strengths are measured in.
    pub unit: String,
    /// Weakest strength kept, if the list was cut.
    pub threshold: Option<f64>,
    /// The lines in the file's order, which need not rise.
    pub lines: Vec<AtomicLine>,
}

/// One spectral line.
#[derive(Clone, Debug, PartialEq)]
pub struct AtomicLine {
    /// Place in air, nm.
    pub at_nm: f64,
    /// Place in vacuum, nm, where the source gives it.
    pub vacuum_nm: Option<f64>,
    /// Strength on the list's own scale, never radiometric; none where unknown.
    pub strength: Option<f64>,
    /// Its name, such as "D2 Na".
    pub label: Option<String>,
}

impl PresetFile {
    /// Reads a preset file.
    ///
    /// # Errors
    /// [`PresetError`] when the text is not JSON, is another format or version, has a field that
    /// this version does not know, or an item does not hold together (see [`PresetFile::check`]).
    pub fn from_json(text: &str) -> Result<Self, PresetError> {
        let file: Self = serde_json::from_str(text)
            .map_err(|error| Self::wrong_header(text).unwrap_or(PresetError::of_json(&error)))?;
        file.check()?;
        Ok(file)
    }

    /// Writes the file: one field and one item a line, shortest decimals that read back the same.
    pub fn to_json(&self) -> String {
        let mut bytes = Vec::new();
        let mut writer = serde_json::Serializer::with_formatter(&mut bytes, LinePerItem::default());
        self.serialize(&mut writer)
            .expect("strings, numbers and lists always become JSON");
        bytes.push(b'\n');
        String::from_utf8(bytes).expect("JSON is written as UTF-8")
    }

    /// Whether the items hold together: unique names, one body each, lists of equal length,
    /// strictly rising wavelengths in tables.
    ///
    /// # Errors
    /// [`PresetError`] naming the first item that does not.
    pub fn check(&self) -> Result<(), PresetError> {
        self.check_header()?;
        for (index, item) in self.items.iter().enumerate() {
            if self.items[..index]
                .iter()
                .any(|other| other.name == item.name)
            {
                return Err(PresetError::of_item(item, "names used once", "used twice"));
            }
            item.check(item.kind.unwrap_or(self.kind))?;
        }
        Ok(())
    }

    /// The kind of one of this file's items.
    pub fn kind_of(&self, item: &PresetItem) -> Kind {
        item.kind.unwrap_or(self.kind)
    }

    /// The heading of one of this file's items.
    pub fn shelf_of(&self, item: &PresetItem) -> Shelf {
        item.shelf.unwrap_or(self.shelf)
    }

    /// The source of one of this file's items.
    pub fn source_of<'a>(&'a self, item: &'a PresetItem) -> &'a str {
        item.source.as_deref().unwrap_or(&self.source)
    }

    /// The licence of one of this file's items.
    pub fn licence_of<'a>(&'a self, item: &'a PresetItem) -> &'a Terms {
        item.licence.as_ref().unwrap_or(&self.licence)
    }

    /// What is to be said about one of this file's items, a sentence or two each.
    pub fn notes_of(&self, item: &PresetItem) -> Vec<String> {
        let mut notes: Vec<String> = item.note.iter().cloned().collect();
        if let Some(mm) = item.thickness_mm {
            notes.push(format!("Thickness {mm} mm."));
        }
        if let Some(count) = item.nan_filled_with_zero {
            notes.push(format!("{count} values missing in the source are zero."));
        }
        if let (Some(inside), Some(outside)) = (&item.cie_interpolation, &item.cie_extrapolation) {
            notes.push(format!(
                "The CIE's interpolation is {inside}, extrapolation {outside}."
            ));
        }
        notes.extend(Some(self.note.clone()).filter(|note| !note.is_empty()));
        notes
    }

    /// A table item as a spectrum.
    ///
    /// # Errors
    /// [`PresetError`] when the item is a composite or a list of lines, or its table is not a
    /// spectrum.
    pub fn spectrum(&self, item: &PresetItem) -> Result<NamedSpectrum, PresetError> {
        Ok(NamedSpectrum {
            name: item.name.clone(),
            kind: self.kind_of(item),
            unit: item.unit.clone(),
            scale: 1.0,
            samples: item.samples()?,
            notes: self.notes_of(item),
            source: self.source_of(item).to_owned(),
        })
    }

    fn check_header(&self) -> Result<(), PresetError> {
        header_error(&self.format, u64::from(self.version)).map_or(Ok(()), Err)
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
}

fn header_error(format: &str, version: u64) -> Option<PresetError> {
    let (found, expected) = if format != FORMAT {
        (format!("format \"{format}\""), format!("\"{FORMAT}\""))
    } else if version != u64::from(VERSION) {
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

impl PresetItem {
    /// The table as a sampled spectrum.
    ///
    /// # Errors
    /// [`PresetError`] when there is no table or it is not a spectrum.
    pub fn samples(&self) -> Result<Sampled, PresetError> {
        let (Some(wavelengths), Some(values)) = (&self.wavelengths, &self.values) else {
            return Err(PresetError::of_item(
                self,
                "wavelengths and values",
                "no table",
            ));
        };
        self.same_length("values", values.len())?;
        Sampled::new(wavelengths.nm(), values.clone())
            .map_err(|error| PresetError::of_item(self, "a spectrum", error))
    }

    /// The composite, if it is one.
    pub fn composite(&self) -> Option<&PresetComposite> {
        self.composite.as_ref()
    }

    /// The list of lines, if it is one.
    pub fn line_list(&self) -> Option<LineList> {
        let (Some(wavelengths), Some(strengths)) = (&self.wavelengths, &self.strengths) else {
            return None;
        };
        let vacuum_nm = |i: usize| self.vacuum_nm.as_ref().and_then(|all| all.get(i)).copied();
        let label = |i: usize| self.labels.as_ref().and_then(|all| all.get(i)).cloned();
        Some(LineList {
            name: self.name.clone(),
            element: self.element.clone(),
            unit: self.unit.clone(),
            threshold: self.threshold,
            lines: wavelengths
                .nm()
                .into_iter()
                .zip(strengths)
                .enumerate()
                .map(|(i, (at_nm, strength))| AtomicLine {
                    at_nm,
                    vacuum_nm: vacuum_nm(i),
                    strength: *strength,
                    label: label(i),
                })
                .collect(),
        })
    }

    fn check(&self, kind: Kind) -> Result<(), PresetError> {
        if self.name.trim().is_empty() {
            return Err(PresetError::of_item(self, "a name", "an empty one"));
        }
        let tables = [&self.n, &self.k, &self.vacuum_nm];
        for list in tables.into_iter().flatten() {
            self.same_length("numbers beside the wavelengths", list.len())?;
        }
        if let Some(labels) = &self.labels {
            self.same_length("labels", labels.len())?;
        }
        match (&self.values, &self.strengths, &self.composite) {
            (Some(_), None, None) if kind != Kind::Lines => self.samples().map(|_| ()),
            (None, Some(strengths), None) if kind == Kind::Lines => {
                self.same_length("strengths", strengths.len())
            }
            (None, None, Some(composite)) if kind != Kind::Lines => {
                let PresetCoefficients { a, b } = &composite.coefficients;
                let [min_nm, max_nm] = composite.range_nm;
                if a.len() != b.len() + 1 {
                    let found = format!("{} and {}", a.len(), b.len());
                    return Err(PresetError::of_item(self, "one more a than b", found));
                }
                if min_nm >= max_nm {
                    let found = format!("{min_nm} to {max_nm} nm");
                    return Err(PresetError::of_item(self, "a rising range", found));
                }
                Ok(())
            }
            _ => Err(PresetError::of_item(
                self,
                "either values, strengths (of kind lines) or a composite",
                format!("another mixture of kind {kind}"),
            )),
        }
    }

    fn same_length(&self, what: &str, found: usize) -> Result<(), PresetError> {
        let expected = self.wavelengths.as_ref().map_or(0, Wavelengths::count);
        if found == expected {
            return Ok(());
        }
        Err(PresetError::of_item(
            self,
            format!("as many {what} as wavelengths ({expected})"),
            found,
        ))
    }
}

/// JSON with one field of the file and one item a line; whole numbers without ".0".
#[derive(Default)]
struct LinePerItem {
    depth: usize,
}

/// Whole numbers below this are exact in `i64` and in `f64`.
const LARGEST_WHOLE: f64 = 1e15;

impl LinePerItem {
    /// Depth inside the file's own object.
    const FIELDS: usize = 1;
    /// Depth inside a list that is a field of the file: the items.
    const ITEMS: usize = 2;

    fn separate<W: ?Sized + io::Write>(
        &self,
        writer: &mut W,
        first: bool,
        broken_at: usize,
    ) -> io::Result<()> {
        if !first {
            writer.write_all(b",")?;
        }
        if self.depth == broken_at {
            writer.write_all(b"\n")?;
        }
        Ok(())
    }

    fn close<W: ?Sized + io::Write>(
        &mut self,
        writer: &mut W,
        bracket: &[u8],
        broken_at: usize,
    ) -> io::Result<()> {
        if self.depth == broken_at {
            writer.write_all(b"\n")?;
        }
        self.depth -= 1;
        writer.write_all(bracket)
    }
}

impl Formatter for LinePerItem {
    fn write_f64<W: ?Sized + io::Write>(&mut self, writer: &mut W, value: f64) -> io::Result<()> {
        let negative_zero = value == 0.0 && value.is_sign_negative();
        if value.fract() == 0.0 && value.abs() < LARGEST_WHOLE && !negative_zero {
            write!(writer, "{}", value as i64)
        } else {
            CompactFormatter.write_f64(writer, value)
        }
    }

    fn begin_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(b"{")
    }

    fn end_object<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"}", Self::FIELDS)
    }

    fn begin_object_key<W: ?Sized + io::Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        self.separate(writer, first, Self::FIELDS)
    }

    fn begin_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.depth += 1;
        writer.write_all(b"[")
    }

    fn end_array<W: ?Sized + io::Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.close(writer, b"]", Self::ITEMS)
    }

    fn begin_array_value<W: ?Sized + io::Write>(
        &mut self,
        writer: &mut W,
        first: bool,
    ) -> io::Result<()> {
        self.separate(writer, first, Self::ITEMS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn small() -> PresetFile {
        PresetFile::from_json(
            r#"{"format":"spectral-explorer-presets","version":1,"group":"g","title":"t",
"kind":"light","shelf":"LED","source":"s","licence":{"id":"MIT","words":"w"},
"attribution":"a","changes":"c","items":[
{"name":"even","unit":"relative","wavelengths":{"first_nm":400,"step_nm":5,"count":3},"values":[0,1e-7,0.1]},
{"name":"list","kind":"reflectance","unit":"fraction","source":"own","wavelengths":{"list_nm":[400,400.5]},"values":[-0.0,1e300]},
{"name":"Hg","kind":"lines","shelf":"Line lamps","element":"Hg","unit":"u","wavelengths":{"list_nm":[546.075,435.833]},"strengths":[6000,null]},
{"name":"two","unit":"relative","composite":{"range_nm":[400,700],"basis":"fourier","coefficients":{"a":[2,1],"b":[3]},"spikes":[{"at_nm":589,"weight":31.95}],"weight_factor":300}}
]}"#,
        )
        .expect("a well-formed file")
    }

    fn refused(change: impl FnOnce(&mut PresetFile)) -> String {
        let mut file = small();
        change(&mut file);
        PresetFile::from_json(&file.to_json())
            .expect_err("a broken file")
            .to_string()
    }

    #[test]
    fn writing_and_reading_again_changes_no_bit() {
        let file = small();
        let text = file.to_json();
        let again = PresetFile::from_json(&text).expect("our own output");
        assert_eq!(again, file);
        assert_eq!(again.to_json(), text);
        let bits = |f: &PresetFile| f.items[1].values.as_ref().map(|v| v[0].to_bits());
        assert_eq!(bits(&again), Some((-0.0f64).to_bits()), "-0 is kept");
    }

    #[test]
    fn every_item_stands_on_a_line_of_its_own() {
        let text = small().to_json();
        let items = text.lines().filter(|line| line.starts_with("{\"name\""));
        assert_eq!(items.count(), 4);
        assert!(text.contains("\"values\":[0,1e-7,0.1]"), "{text}");
    }

    #[test]
    fn an_item_takes_from_its_group_what_it_does_not_state() {
        let file = small();
        let even = file.spectrum(&file.items[0]).expect("a table");
        assert_eq!((even.kind, even.source.as_str()), (Kind::Light, "s"));
        assert_eq!(even.samples.nm(), [400.0, 405.0, 410.0]);
        let list = file.spectrum(&file.items[1]).expect("a table");
        assert_eq!(
            (list.kind, list.source.as_str()),
            (Kind::Reflectance, "own")
        );
    }

    #[test]
    fn lines_and_composites_are_not_tables() {
        let file = small();
        let lines = file.items[2].line_list().expect("lines");
        assert_eq!(lines.lines[0].strength, Some(6000.0));
        assert_eq!(lines.lines[1].strength, None);
        assert!(file.spectrum(&file.items[2]).is_err());
        let composite = file.items[3].composite().expect("a composite");
        let spikes: Vec<_> = composite.spikes_in_unit_nm().collect();
        assert_eq!(spikes, [(589.0, 31.95 * 300.0)]);
        assert!(file.spectrum(&file.items[3]).is_err());
    }

    #[test]
    fn a_refusal_names_the_line_what_was_found_and_what_was_expected() {
        let text = small()
            .to_json()
            .replace("\"step_nm\":5", "\"step_nm\":\"five\"");
        let error = PresetFile::from_json(&text).expect_err("a word for a number");
        assert_eq!(error.line, Some(13));
        assert!(error.found.contains("five"), "{error}");
        assert!(error.expected.contains("f64"), "{error}");
    }

    #[test]
    fn another_format_or_version_is_called_that() {
        let text = small().to_json();
        let newer = text.replace("\"version\":1", "\"version\":2,\"new\":0");
        let error = PresetFile::from_json(&newer).expect_err("a newer file");
        assert_eq!(
            error.to_string(),
            "preset file: expected version 1, found version 2"
        );
        let other = text.replace(FORMAT, "composite-spectrum");
        assert!(PresetFile::from_json(&other).is_err());
    }

    #[test]
    fn items_that_do_not_hold_together_are_refused_by_name() {
        let short = refused(|f| f.items[0].values = Some(vec![1.0]));
        assert!(short.contains("\"even\""), "{short}");
        let twice = refused(|f| f.items[1].name = "even".into());
        assert!(twice.contains("used twice"), "{twice}");
        let falling = refused(|f| f.items[1].wavelengths = Some(Wavelengths::List(vec![5.0, 4.0])));
        assert!(falling.contains("above 5 nm"), "{falling}");
        let both = refused(|f| f.items[3].values = Some(vec![]));
        assert!(both.contains("composite"), "{both}");
    }

    #[test]
    fn a_huge_count_costs_nothing() {
        let text = small()
            .to_json()
            .replace("\"count\":3", "\"count\":99999999999");
        assert!(PresetFile::from_json(&text).is_err());
    }

    #[test]
    fn shelves_are_written_as_their_headings() {
        for shelf in Shelf::ALL {
            let word = serde_json::to_string(&shelf).expect("a word");
            assert_eq!(word, format!("\"{}\"", shelf.heading()));
        }
    }
}
