//! A picture some rows at a time, on as many threads as there are.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::study::{Progress, in_parallel, processors};

use super::{PictureError, Pixels};

/// Most threads that share out the strips.
const MOST_THREADS: usize = 8;

/// Most values that a strip of all threads together may hold: 64 Mi numbers.
const MOST_VALUES: usize = 64 << 20;

/// Some rows of a picture.
pub struct Strip<'a> {
    /// First row.
    pub first: usize,
    /// Number of pixels.
    pub pixels: usize,
    /// `[band * pixels + i]`.
    pub values: &'a [f32],
}

/// Applies `work` to every strip of at most `rows` rows; the results are in the order of the strips
/// whichever thread worked on which.
///
/// # Errors
/// The first strip's that failed, [`PictureError::Cancelled`] when it was.
pub fn over_strips<T: Send>(
    pixels: &dyn Pixels,
    rows: usize,
    progress: &Progress,
    work: impl Fn(&Strip) -> Result<T, PictureError> + Sync,
) -> Result<Vec<T>, PictureError> {
    let (width, height) = pixels.size();
    let rows = rows.clamp(1, height.max(1));
    let bands = pixels.bands().len();
    over_parts(
        height.div_ceil(rows),
        width * rows * bands,
        progress,
        |index| {
            let first = index * rows;
            let rows = rows.min(height - first);
            let mut values = vec![0.0; rows * width * bands];
            pixels.rows(first, rows, &mut values)?;
            work(&Strip {
                first,
                pixels: rows * width,
                values: &values,
            })
        },
    )
}

/// Applies `work` to each of `count` parts, results in order; each part holds `values` numbers.
///
/// # Errors
/// As [`over_strips`].
pub(crate) fn over_parts<T: Send>(
    count: usize,
    values: usize,
    progress: &Progress,
    work: impl Fn(usize) -> Result<T, PictureError> + Sync,
) -> Result<Vec<T>, PictureError> {
    let at_once = (MOST_VALUES / values.max(1)).clamp(1, MOST_THREADS);
    let first_failed = AtomicUsize::new(usize::MAX);
    let parts: Vec<usize> = (0..count).collect();
    let made = in_parallel(&parts, processors().min(at_once), progress, |index| {
        if *index > first_failed.load(Ordering::Relaxed) {
            return None;
        }
        let answer = work(*index);
        if answer.is_err() {
            first_failed.fetch_min(*index, Ordering::Relaxed);
        }
        Some(answer)
    });
    let made = made.filter(|_| !progress.is_cancelled());
    let made = made.ok_or(PictureError::Cancelled)?;
    made.into_iter().flatten().collect()
}

/// Planes of a whole picture from those of its strips, `[plane * pixels + i]` each.
pub(super) fn joined<'a>(
    parts: impl Iterator<Item = &'a Vec<f32>> + Clone,
    planes: usize,
) -> Vec<f32> {
    let mut all = Vec::with_capacity(parts.clone().map(Vec::len).sum());
    for plane in 0..planes {
        for part in parts.clone() {
            let pixels = part.len() / planes;
            all.extend_from_slice(&part[plane * pixels..][..pixels]);
        }
    }
    all
}
