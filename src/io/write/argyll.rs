//! Writing Argyll `.sp`: CGATS text of one set, as `spec2cie`, `illumread` and `specplot` take it.
//!
//! The format knows even steps of 1 nm and more only, and its labels are whole nm: an irregular or
//! finer grid is resampled so that its area is kept, and [`losses`] notes it. Values are the
//! spectrum's own, to the bit (`SPECTRAL_NORM` is 1). Properties without an Argyll keyword (kind,
//! unit, scale, source, settings) go into keywords of our own, which its tools pass over.

use std::fmt::Write;

use super::csv::quoted_where;
use crate::io::provenance::{ORIGINATOR, Provenance, one_line, shortest};
use crate::languages::{Language, in_language, with_sign};
use crate::spectrum::{Kind, NamedSpectrum, Outside};

/// Most bands that Argyll's own tools read.
const ARGYLL_BANDS: usize = 601;

/// The largest distance from an even grid at which a wavelength counts as on it, nm.
const EVEN_NM: f64 = 1e-3;

/// Steps that an uneven grid is resampled to, nm: the first that Argyll's bands suffice for.
const STEPS_NM: [f64; 6] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0];

/// Wavelengths that a label can give, nm: smaller and larger numbers in one mean something else.
pub(crate) const LABELS_NM: std::ops::RangeInclusive<f64> = 100.0..=100_000.0;

struct Grid {
    first_nm: f64,
    last_nm: f64,
    bands: usize,
    /// Largest distance of a sample from it, nm; `None` when values are resampled.
    moved_nm: Option<f64>,
}

impl Grid {
    fn nm(&self, band: usize) -> f64 {
        let step = (self.last_nm - self.first_nm) / (self.bands - 1) as f64;
        self.first_nm + step * band as f64
    }
}

fn grid(spectrum: &NamedSpectrum) -> Result<Grid, String> {
    let samples = &spectrum.samples;
    let (first, last, bands) = (samples.first_nm(), samples.last_nm(), samples.len());
    let (least, most) = (LABELS_NM.start(), LABELS_NM.end());
    let (from, to) = (shortest(first), shortest(last));
    let [from, to] = [from, to].map(with_sign);
    if first < *least {
        return Err(tr!(
            "found wavelengths from {from} nm, expected at least {least} nm in Argyll .sp",
            from,
            least
        ));
    }
    if last > *most {
        return Err(tr!(
            "found wavelengths up to {to} nm, expected at most {most} nm in Argyll .sp",
            to,
            most
        ));
    }
    let too_short = tr!(
        "found a spectrum of {from} to {to} nm, expected at least 3 whole nm in Argyll .sp",
        from,
        to
    );
    let mut even = Grid {
        first_nm: first,
        last_nm: last,
        bands,
        moved_nm: Some(0.0),
    };
    let samples = samples.nm().iter().enumerate();
    let off = samples.map(|(band, nm)| (nm - even.nm(band)).abs());
    let moved = off.fold(0.0, f64::max);
    // Labels in whole nm distinguish steps of 1 nm and more.
    let fine = last - first < (bands - 1) as f64 * (1.0 - 1e-9);
    if moved <= EVEN_NM && !fine && bands >= 3 {
        even.moved_nm = Some(moved);
        return Ok(even);
    }
    // The first and last nm of a light are filled in part; a reflectance has no part of a value.
    let round: [fn(f64) -> f64; 2] = match spectrum.kind.outside() {
        Outside::Zero => [f64::floor, f64::ceil],
        Outside::Hold => [f64::ceil, f64::floor],
    };
    let (from, to) = (round[0](first), round[1](last));
    let step = STEPS_NM
        .into_iter()
        .find(|step| (to - from) / step < ARGYLL_BANDS as f64)
        .unwrap_or(STEPS_NM[STEPS_NM.len() - 1]);
    let steps = round[1]((to - from) / step);
    let bands = steps.max(0.0) as usize + 1;
    if bands < 3 {
        return Err(too_short);
    }
    Ok(Grid {
        first_nm: from,
        last_nm: from + step * (bands - 1) as f64,
        bands,
        moved_nm: None,
    })
}

/// The properties of a spectrum lost in the format, a sentence each.
pub(crate) fn losses(spectrum: &NamedSpectrum) -> Vec<String> {
    let Ok(grid) = grid(spectrum) else {
        return Vec::new();
    };
    let mut notes = Vec::new();
    match grid.moved_nm {
        None => notes.push(tr!(
            "Argyll .sp holds even steps of 1 nm and more: resampled to {n} values, {from} to {to} \
             nm every {step} nm; the area under the curve is kept."
                | "Argyll .sp holds even steps of 1 nm and more: resampled to {n} values, {from} to \
                   {to} nm every {step} nm; the area under the curve is kept." % grid.bands,
            from = with_sign(grid.first_nm.to_string()),
            to = with_sign(grid.last_nm.to_string()),
            step = with_sign((grid.nm(1) - grid.first_nm).to_string())
        )),
        Some(moved) if moved > 1e-9 => notes.push(tr!(
            "Argyll .sp holds even steps: wavelengths moved by up to {moved} nm.",
            moved = with_sign(format!("{moved:.1e}"))
        )),
        Some(_) => {}
    }
    if grid.bands > ARGYLL_BANDS {
        notes.push(tr!(
            "It has {n} values; Argyll's own tools read at most {most}."
                | "It has {n} values; Argyll's own tools read at most {most}." % grid.bands,
            most = ARGYLL_BANDS
        ));
    }
    notes
}

/// Argyll's term for a measurement of that kind; `None` for kinds without one.
fn measurement(spectrum: &NamedSpectrum) -> Option<&'static str> {
    let unit = &spectrum.unit;
    let falls_on = unit.contains("m-2") && !unit.contains("sr-1");
    match spectrum.kind {
        Kind::Light if falls_on => Some("AMBIENT"),
        Kind::Light => Some("EMISSION"),
        Kind::Reflectance => Some("REFLECTIVE"),
        Kind::Transmittance => Some("TRANSMISSIVE"),
        Kind::Weighting => Some("SENSITIVITY"),
        Kind::Absorbance | Kind::Lines | Kind::Other => None,
    }
}

/// A spectrum as Argyll `.sp`.
///
/// # Errors
/// One line for a spectrum too short, or of wavelengths that the format cannot represent.
pub(crate) fn write(spectrum: &NamedSpectrum, provenance: &Provenance) -> Result<String, String> {
    let samples = &spectrum.samples;
    let grid = grid(spectrum)?;
    let values: Vec<f64> = match grid.moved_nm {
        Some(_) => samples.values().to_vec(),
        None => {
            let step = grid.nm(1) - grid.nm(0);
            samples.on_grid(grid.first_nm, step, grid.bands, spectrum.kind.outside())
        }
    };
    let program = match provenance.program.as_str() {
        "" => ORIGINATOR,
        program => program,
    };
    let (name, program) = (quoted(&spectrum.name), quoted(program));
    let mut out = format!("SPECT\n\nDESCRIPTOR {name}\nORIGINATOR {program}\n");
    // Writing to a String cannot fail.
    let mut keyword = |key: &str, value: &str| {
        let _ = writeln!(out, "KEYWORD \"{key}\"\n{key} {}", quoted(value));
    };
    if let Some(word) = measurement(spectrum) {
        keyword("MEAS_TYPE", word);
    }
    for (key, value) in provenance.of(spectrum) {
        // The name is the descriptor, the program the originator.
        if !matches!(key, "name" | "written by") {
            keyword(&key.to_uppercase(), &value);
        }
    }
    // The file speaks English, whatever the window does.
    for loss in in_language(Language::English, || losses(spectrum)) {
        keyword("NOTE", &loss);
    }
    keyword("SPECTRAL_BANDS", &grid.bands.to_string());
    keyword("SPECTRAL_START_NM", &shortest(grid.first_nm));
    keyword("SPECTRAL_END_NM", &shortest(grid.last_nm));
    keyword("SPECTRAL_NORM", "1.000000");
    // As Argyll rounds when it looks for a column.
    let labels: Vec<String> = (0..grid.bands)
        .map(|band| format!("SPEC_{:03}", (grid.nm(band) + 0.5).floor()))
        .collect();
    for label in &labels {
        let _ = writeln!(out, "KEYWORD \"{label}\"");
    }
    let values: Vec<String> = values.iter().map(|v| shortest(*v)).collect();
    let _ = write!(
        out,
        "NUMBER_OF_FIELDS {}\nBEGIN_DATA_FORMAT\n{}\nEND_DATA_FORMAT\n\nNUMBER_OF_SETS 1\n\
         BEGIN_DATA\n{}\nEND_DATA\n",
        grid.bands,
        labels.join(" "),
        values.join(" ")
    );
    Ok(out)
}

/// A text between double quotes; those inside become single ones.
fn quoted(text: &str) -> String {
    quoted_where(true, &one_line(text).replace('"', "'"))
}
