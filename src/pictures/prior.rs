//! Prior for reflectances: second moments of the coefficients of the 99 colour evaluation
//! samples (CIE 224:2017, 5 nm table).

use std::sync::LazyLock;

use nalgebra::DMatrix;

use crate::preset;
use crate::spectrum::{Outside, Sampled};

use super::fitting::{cosines, plain_fit};
use super::{Bands, PictureError};

/// Added to every moment, as a share of their mean, so that none is zero.
const LEAST: f64 = 1e-9;

fn samples() -> &'static [Sampled] {
    static SAMPLES: LazyLock<Vec<Sampled>> = LazyLock::new(|| {
        let items = preset::group("tm30_ces99_5nm").into_iter();
        let tables = items
            .flat_map(|group| &group.items)
            .filter_map(|item| item.spectrum());
        tables.map(|table| table.samples.clone()).collect()
    });
    &SAMPLES
}

/// The diagonal second moments of the plain coefficients on some bands.
///
/// # Errors
/// [`PictureError`] when the bands do not tell the coefficients apart.
pub(super) fn prior(
    bands: &Bands,
    range_nm: [f64; 2],
    count: usize,
) -> Result<Vec<f64>, PictureError> {
    let asked = count.max(3);
    let most = bands.len() - 1;
    if asked > most {
        return Err(PictureError::Numbers { found: asked, most });
    }
    let plain = plain_fit(bands, None, &cosines(bands.nm(), range_nm, asked))?;
    if plain.encode.iter().any(|v| !v.is_finite()) {
        return Err(PictureError::NotSolved);
    }
    let samples = samples();
    let on_bands: Vec<Vec<f64>> = samples
        .iter()
        .map(|table| bands.by_area(table, Outside::Hold))
        .collect();
    let values = DMatrix::from_fn(bands.len(), samples.len(), |j, i| on_bands[i][j]);
    let numbers = &plain.encode * values;
    let of_row = |row: usize| {
        let squares = numbers.row(row).iter().map(|v| v * v).sum::<f64>();
        squares / samples.len().max(1) as f64
    };
    let mut moments: Vec<f64> = (0..asked).map(of_row).collect();
    let mean = moments.iter().sum::<f64>() / moments.len() as f64;
    moments.iter_mut().for_each(|v| *v += LEAST * mean);
    moments.truncate(count);
    Ok(moments)
}
