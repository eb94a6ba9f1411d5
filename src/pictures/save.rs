//! Files on disk: written beside their place and moved there when they are whole.

use std::io::{BufWriter, Seek, SeekFrom, Write};
use std::path::Path;

use crate::io::{Precision, disk::Unfinished, save_by};
use crate::study::Progress;

use super::compact::{Coder, CompactPlan, write_compact};
use super::full::{Half, write_full};
use super::header::About;
use super::measure::Errors;
use super::{Operator, PictureError, Pixels};

/// Writes a file as a whole or not at all, and tells its bytes.
fn whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<&mut Unfinished>) -> Result<(), PictureError>,
) -> Result<u64, PictureError> {
    save_by(path, |file| {
        let mut out = BufWriter::new(file);
        write(&mut out)?;
        out.flush()?;
        Ok(out.get_mut().seek(SeekFrom::End(0))?)
    })
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
    about: (&About, Errors),
    progress: &Progress,
) -> Result<u64, PictureError> {
    whole(path, |out| {
        write_full(out, pixels, operator, kept, about, progress)
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
