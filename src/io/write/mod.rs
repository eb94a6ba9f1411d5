//! Writing spectra: the available formats.

pub(super) mod argyll;
#[cfg_attr(
    target_arch = "wasm32",
    allow(dead_code, reason = "a browser saves by `disk`")
)]
pub(super) mod atomic;
pub(super) mod csv;
pub(super) mod exr;
pub(super) mod json;
pub(super) mod png;
pub(super) mod spd;
pub(super) mod spdx;
pub(super) mod spectral_exr;

use std::path::Path;

use crate::io::error::WriteError;
use crate::io::input::name_of;
use crate::io::provenance::{Columns, Provenance, one_line};
use crate::spectrum::NamedSpectrum;
use atomic::save_atomically;

/// Extensions that [`write_as`] knows, with the format's name for file dialogues.
pub const WRITABLE: [(&str, &str); 5] = [
    ("csv", "CSV"),
    ("json", later!("spectrum JSON")),
    ("sp", "Argyll .sp"),
    ("spd", "pbrt .spd"),
    ("spdx", "IES TM-27 .spdx"),
];

/// A spectrum in the format of an extension. `columns` is for CSV; other formats hold the
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
        "json" => Ok(json::write(spectrum, provenance)),
        "sp" => argyll::write(spectrum, provenance),
        "spd" => Ok(spd::write(spectrum, provenance)),
        "spdx" => Ok(spdx::write(spectrum, provenance)),
        other => {
            let known = WRITABLE.map(|(extension, _)| format!(".{extension}"));
            let known = known.join(", ");
            Err(match other {
                "" => tr!("found no extension, expected one of {known}", known),
                other => tr!(
                    "found extension .{extension}, expected one of {known}",
                    extension = one_line(other),
                    known
                ),
            })
        }
    }
}

/// The properties of a spectrum's samples lost in the format of an extension, a sentence each.
pub fn losses(extension: &str, spectrum: &NamedSpectrum) -> Vec<String> {
    match extension.to_lowercase().as_str() {
        "sp" => argyll::losses(spectrum),
        "spdx" => spdx::losses(spectrum),
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
    let extension = path.extension().unwrap_or_default().to_string_lossy();
    let text = encode(&extension, spectrum, columns, provenance)
        .map_err(|why| WriteError::new(&name_of(path), why))?;
    save_atomically(path, text.as_bytes())
}
