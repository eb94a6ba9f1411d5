//! The result of reading a file.

pub(super) mod decision;
pub(super) mod facts;
pub(super) mod makers_results;
pub(super) mod remark;

use std::collections::{HashMap, HashSet};

use crate::io::error::printable_line;
use crate::io::text::units::WavelengthUnit;
use crate::io::{Choices, Delimiter, Dialect};
use crate::languages::{said, with_sign};
use crate::spectrum::{Composite, Kind, NamedSpectrum, Sampled, SpectralImage};
use decision::{AxisDecision, Decisions, Origin};
use facts::Facts;
use makers_results::MakersResult;

/// A property guessed by a reader and open to change by the user.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Guessed {
    /// The kind of the values.
    Kind,
    /// The quantity along the wavelength axis.
    WavelengthUnit,
    /// The scale of the values: per cent or fractions.
    Percent,
    /// The separator between the cells of a table.
    Columns,
}

/// A question about a spectrum left open by its file: the choice made, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct OpenQuestion {
    /// Index into [`Reading::spectra`], counted on through [`Reading::composites`].
    pub spectrum: usize,
    /// The guessed property.
    pub what: Guessed,
    /// The choice in a word ("light", "nm", "percent", "fraction").
    pub chosen: String,
    /// The evidence for it.
    pub because: String,
    /// True if words or numbers leave hardly any doubt, so that no question is needed.
    pub plain: bool,
}

/// The structure of a plain table, for inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct TableFound {
    /// The separator of cells and the decimal mark.
    pub dialect: Dialect,
    /// The column of wavelengths, from 0; `None` where they stand in a row.
    pub axis_column: Option<usize>,
    /// Cells in a row.
    pub width: usize,
    /// Line of the first row, from 1.
    pub first_line: usize,
    /// Columns that became spectra, from 0; empty where the wavelengths stand in a row.
    pub values: Vec<usize>,
}

impl OpenQuestion {
    /// True if it should be reviewed: the kind and per cent can hardly be inferred from numbers,
    /// and anything but nanometres is rare enough to ask about.
    pub(crate) fn is_doubtful(&self) -> bool {
        match self.what {
            _ if self.plain => false,
            Guessed::Kind | Guessed::Percent | Guessed::Columns => true,
            Guessed::WavelengthUnit => self.chosen != WavelengthUnit::Nanometre.word(),
        }
    }
}

/// A composite with what a person needs to know about it.
#[derive(Clone, Debug, PartialEq)]
pub struct CompositeFile {
    /// The model.
    pub composite: Composite,
    /// Unit of its smooth part; empty when unknown. A spike's weight is in this unit x nm.
    pub unit: String,
    /// The origin of the numbers; empty when unknown.
    pub source: String,
    /// The name in lists and plots; the file's own name where the format has none.
    pub name: String,
    /// The kind of its values; a light where the format does not state it.
    pub kind: Kind,
}

/// Everything that one file holds.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reading {
    /// Name of the file without its folder.
    pub file: String,
    /// Name of the format that read it.
    pub format: &'static str,
    /// Measured spectra, in file order.
    pub spectra: Vec<NamedSpectrum>,
    /// Composite models.
    pub composites: Vec<CompositeFile>,
    /// The structure of its first plain table; `None` for other formats.
    pub table: Option<TableFound>,
    /// The separator of the cells of a text that is cut into cells without being a plain table.
    pub cut_by: Option<Delimiter>,
    /// The interpretation of its first spectra, in their order.
    pub understood: Vec<Decisions>,
    /// The interpretation of each of its images.
    pub images_understood: Vec<Decisions>,
    /// The results computed by the instrument itself and written beside its spectra.
    pub results: Vec<MakersResult>,
    /// Images whose pixels are spectra.
    pub images: Vec<SpectralImage>,
    /// The guesses made about its spectra.
    pub guesses: Vec<OpenQuestion>,
    /// The known facts about each spectrum until all are put in words; empty afterwards.
    pub facts: Vec<Facts>,
    /// The prefix of the first spectrum's line of provenance in the file's own notes.
    pub in_front: String,
    /// Provenance and whatever is odd about the file, a line each; the first is the line that the
    /// window and the command line show ("1 nm block, 401 points, W m-2 nm-1, decimal comma").
    pub notes: Vec<String>,
}

impl Reading {
    /// True if the reading of the file should be reviewed.
    pub fn is_doubtful(&self) -> bool {
        self.guesses.iter().any(OpenQuestion::is_doubtful)
            || self.images_understood.iter().any(Decisions::is_doubtful)
    }

    /// Lets the last spectrum's line of provenance not tell of per cent: its notes do.
    pub(crate) fn keep_scale_to_notes(&mut self) {
        if let Some(facts) = self.facts.last_mut() {
            facts.tells_scale = false;
        }
    }

    /// Makes every text one line without control characters: files put anything into their titles.
    /// A spectrum or image without a name gets the file's.
    pub(crate) fn tidy(&mut self) {
        let spectra = self.spectra.iter_mut().map(|of| {
            tidy_notes(&mut of.notes);
            [&mut of.name, &mut of.unit, &mut of.source]
        });
        let images = self.images.iter_mut().map(|of| {
            tidy_notes(&mut of.notes);
            [&mut of.name, &mut of.unit, &mut of.source]
        });
        let composites = self.composites.iter_mut();
        let composites = composites.map(|of| [&mut of.name, &mut of.unit, &mut of.source]);
        for mut texts in spectra.chain(images).chain(composites) {
            texts.iter_mut().for_each(|text| tidy(text));
            if texts[0].is_empty() {
                *texts[0] = printable_line(&self.file);
            }
        }
        let results = self.results.iter_mut();
        let results = results.flat_map(|of| [&mut of.unit, &mut of.as_written]);
        let guesses = self.guesses.iter_mut();
        let guesses = guesses.flat_map(|of| [&mut of.chosen, &mut of.because]);
        let decisions = self
            .understood
            .iter_mut()
            .chain(&mut self.images_understood);
        let reasons = decisions.flat_map(Decisions::reasons);
        results.chain(guesses).chain(reasons).for_each(tidy);
        tidy_notes(&mut self.notes);
    }

    /// Says of every spectrum where nothing was measured in its midst. A file that was written here
    /// may say so already.
    pub fn tell_holes(&mut self) {
        for spectrum in &mut self.spectra {
            let mut holes = hole_notes(&spectrum.samples);
            holes.retain(|note| !spectrum.notes.contains(note));
            spectrum.notes.append(&mut holes);
        }
    }

    /// Says which of a person's decisions about the table do not apply to the file's format.
    pub(crate) fn tell_unused(&mut self, choices: &Choices) {
        let is_by_hand = |decisions: &Decisions| match &decisions.axis {
            Some(AxisDecision::Unit(unit)) => unit.origin == Origin::Chosen,
            Some(AxisDecision::Laser(_)) | None => false,
        };
        let mut all = self.understood.iter().chain(&self.images_understood);
        if choices.wavelengths.is_some() && !all.any(is_by_hand) {
            let note =
                said!("the unit chosen for the wavelengths is not used: the format has its own");
            self.notes.push(note.to_owned());
        }
        if self.table.is_some() {
            return;
        }
        let delimiter = choices.delimiter.filter(|by| self.cut_by != Some(*by));
        if choices.axis_column.is_some() {
            let note = said!("the column that was chosen is not used: no plain table");
            self.notes.push(note.to_owned());
        }
        if delimiter.is_some() {
            let note = said!("the delimiter that was chosen is not used: no plain table");
            self.notes.push(note.to_owned());
        }
    }

    /// Gives every spectrum a name of its own: doubles get "(2)", "(3)", ...
    pub fn name_apart(&mut self) {
        // The names as the file has them are taken first: one of them may end in "(2)".
        let mut taken: HashSet<String> = self.spectra.iter().map(|s| s.name.clone()).collect();
        let mut seen: HashMap<String, usize> = HashMap::new();
        for spectrum in &mut self.spectra {
            let count = seen.entry(spectrum.name.clone()).or_default();
            *count += 1;
            while *count > 1 {
                let name = format!("{} ({count})", spectrum.name);
                if taken.insert(name.clone()) {
                    spectrum.name = name;
                    break;
                }
                *count += 1;
            }
        }
    }
}

/// Notes of one line each, without empty ones.
fn tidy_notes(notes: &mut Vec<String>) {
    notes.iter_mut().for_each(tidy);
    notes.retain(|note| !note.is_empty());
}

fn tidy(text: &mut String) {
    let line = printable_line(text);
    let line = line.trim();
    if line != text.as_str() {
        *text = line.to_owned();
    }
}

const MOST_HOLES: usize = 3;

/// The notes on the interior gaps in a spectrum's samples, a sentence each.
fn hole_notes(samples: &Sampled) -> Vec<String> {
    let holes = samples.holes();
    let range = samples.last_nm() - samples.first_nm();
    let share = |holes: &[[f64; 2]]| {
        let wide: f64 = holes.iter().map(|[from, to]| to - from).sum();
        plain(round_step(100.0 * wide / range))
    };
    if holes.len() > MOST_HOLES {
        let count = holes.len();
        return vec![tr!(
            "{n} hole without measurements, {share} % of the range"
                | "{n} holes without measurements, {share} % of the range" % count,
            share = share(&holes)
        )];
    }
    let note = |hole: &[f64; 2]| {
        let [from, to] = hole.map(|nm| plain(round3(nm)));
        let share = share(&[*hole]);
        tr!(
            "nothing measured between {from} and {to} nm, {share} % of the range",
            from,
            to,
            share
        )
    };
    holes.iter().map(note).collect()
}

/// One line about a spectrum: grid, points, unit, and counts of what is odd.
pub(super) fn provenance(spectrum: &NamedSpectrum, how: &[&str]) -> String {
    let samples = &spectrum.samples;
    let step = samples.step_nm();
    let grid = if samples.has_even_steps() {
        tr!("{step} nm steps", step = plain(round_step(step)))
    } else {
        tr!(
            "irregular steps (about {step} nm)",
            step = plain(round_step(step))
        )
    };
    let mut parts = vec![
        grid,
        tr!("{n} point" | "{n} points" % samples.len()),
        format!(
            "{}-{} nm",
            plain(round3(samples.first_nm())),
            plain(round3(samples.last_nm()))
        ),
        said(spectrum.kind.word()).to_owned(),
    ];
    if !spectrum.unit.is_empty() && spectrum.unit != spectrum.kind.word() {
        parts.push(spectrum.unit.clone());
    }
    let how = how.iter().filter(|words| !words.is_empty());
    parts.extend(how.map(|words| (*words).to_owned()));
    let negative = samples.values().iter().filter(|v| **v < 0.0).count();
    if negative > 0 {
        parts.push(tr!(
            "{n} negative value kept" | "{n} negative values kept" % negative
        ));
    }
    parts.join(", ")
}

/// A step to three decimals, to three figures where it is finer than that.
fn round_step(step: f64) -> f64 {
    if step >= 0.1 {
        round3(step)
    } else {
        format!("{step:.2e}").parse().unwrap_or(step)
    }
}

fn round3(x: f64) -> f64 {
    (x * 1000.0).round() / 1000.0
}

/// A number with all its decimals.
fn plain(x: f64) -> String {
    with_sign(x.to_string())
}
