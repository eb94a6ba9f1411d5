//! Files on disk: written beside their place and moved there when they are whole.

use std::io::{BufWriter, Write};
use std::path::Path;

use crate::study::Progress;

use super::compact::{Coder, CompactPlan, write_compact};
use super::full::{Half, Precision, write_full};
use super::header::About;
use super::measure::Errors;
use super::{Operator, PictureError, Pixels};

/// Writes a file as a whole or not at all, and tells its bytes.
fn whole<T>(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut std::fs::File>) -> Result<T, PictureError>,
) -> Result<u64, PictureError> {
    let folder = path
        .parent()
        .filter(|p| !p.as_os_str().is_empty())
        .unwrap_or(Path::new("."));
    let mut file = tempfile::NamedTempFile::new_in(folder)?;
    let mut out = BufWriter::new(file.as_file_mut());
    write(&mut out)?;
    out.flush()?;
    drop(out);
    file.as_file().sync_all()?;
    let bytes = file.as_file().metadata()?.len();
    file.persist(path)
        .map_err(|error| PictureError::Trouble(error.to_string()))?;
    Ok(bytes)
}

/// Saves the full form; tells its bytes.
///
/// # Errors
/// As [`write_full`]; nothing is left behind and what was there stays.
pub fn save_full(
    path: &Path,
    pixels: &dyn Pixels,
    operator: &Operator,
    kept: (Precision, Half),
    said: (&About, Errors),
    progress: &Progress,
) -> Result<u64, PictureError> {
    whole(path, |out| {
        write_full(out, pixels, operator, kept, said, progress)
    })
}

/// Saves the compact form; tells its bytes.
///
/// # Errors
/// As [`write_compact`]; nothing is left behind and what was there stays.
pub fn save_compact(
    path: &Path,
    pixels: &dyn Pixels,
    operator: &Operator,
    plan: &CompactPlan,
    about: &About,
    progress: &Progress,
) -> Result<u64, PictureError> {
    whole(path, |out| {
        write_compact(out, pixels, operator, plan, about, Coder::Fitted, progress)
    })
}
