//! A picture some rows at a time, on as many threads as there are.

use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use crate::study::Progress;

use super::{PictureError, Pixels};

/// Most threads that share out the strips.
const MOST_THREADS: usize = 8;

/// Most values that a strip of all threads together may hold: 64 Mi numbers.
const MOST_VALUES: usize = 64 << 20;

/// Some rows of a picture.
pub struct Strip<'a> {
    /// First row.
    pub first: usize,
    /// How many pixels.
    pub pixels: usize,
    /// `[band * pixels + i]`.
    pub values: &'a [f32],
}

/// What `work` makes of every strip of at most `rows` rows, in the order of the strips whatever
/// thread worked on which.
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

/// What `work` makes of each of `count` parts, in their order; `values` numbers are held by each.
///
/// # Errors
/// As [`over_strips`].
pub(crate) fn over_parts<T: Send>(
    count: usize,
    values: usize,
    progress: &Progress,
    work: impl Fn(usize) -> Result<T, PictureError> + Sync,
) -> Result<Vec<T>, PictureError> {
    let next = AtomicUsize::new(0);
    let found: Mutex<Vec<Option<Result<T, PictureError>>>> = Mutex::new(Vec::new());
    let at_once = (MOST_VALUES / values.max(1)).clamp(1, MOST_THREADS);
    let threads = std::thread::available_parallelism()
        .map_or(1, |n| n.get())
        .min(at_once)
        .min(count);
    let worker = || {
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count || progress.is_cancelled() {
                return;
            }
            let answer = work(index);
            let failed = answer.is_err();
            let mut found = found.lock().unwrap_or_else(|broken| broken.into_inner());
            if found.len() <= index {
                found.resize_with(index + 1, || None);
            }
            found[index] = Some(answer);
            progress.step();
            if failed {
                next.store(count, Ordering::Relaxed);
            }
        }
    };
    if threads <= 1 {
        worker();
    } else {
        std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(worker))));
    }
    if progress.is_cancelled() {
        return Err(PictureError::Cancelled);
    }
    let found = found
        .into_inner()
        .unwrap_or_else(|broken| broken.into_inner());
    found.into_iter().flatten().collect()
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
