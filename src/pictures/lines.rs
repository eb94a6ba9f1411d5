//! Lines of a whole picture: places and shapes from one spectrum, one number a pixel each.

use crate::spectrum::{FoundSpike, detect, window_near};
use crate::{
    languages::with_sign,
    spectrum::{Band, Outside, Sampled, SpikeSettings},
};

use super::{Bands, PictureError};

/// Least share of the power that a line carries.
const THRESHOLD: f64 = 0.005;
/// Widest line looked for where bands are dense, nm.
const WIDEST_NM: f64 = 10.0;
/// Or so many median distances of bands.
const WIDEST_SPACINGS: f64 = 2.0;
/// Or so many bandwidths of the instrument.
const WIDEST_BANDWIDTHS: f64 = 1.5;

/// A line that every pixel of a picture may have.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Centroid, nm.
    pub at_nm: f64,
    /// Share of the power of the spectrum that it was found in; 0 for one set by hand.
    pub share: f64,
    /// Values on the bands, of unit area: a weight is value x nm.
    pub shape: Vec<f64>,
    /// First and last band that it may touch.
    pub window: [usize; 2],
}

/// Lines set by hand, and what was merged.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct HandLines {
    /// The lines by rising wavelength.
    pub lines: Vec<Line>,
    /// Notes on merged lines, one sentence each.
    pub notes: Vec<String>,
}

/// The widest line that is looked for, nm.
pub(super) fn widest_nm(bands: &Bands) -> f64 {
    let by_instrument = bands.bandwidth_nm().unwrap_or(0.0) * WIDEST_BANDWIDTHS;
    let by_spacing = WIDEST_SPACINGS * bands.median_spacing_nm();
    WIDEST_NM.max(by_spacing).max(by_instrument)
}

/// The lines of a spectrum on the bands, the strongest first.
///
/// # Errors
/// [`PictureError`] when the spectrum has not one finite value a band.
pub(crate) fn find_lines(bands: &Bands, spectrum: &[f64]) -> Result<Vec<Line>, PictureError> {
    let Some((band, values)) = on_grid(bands, spectrum)? else {
        return Ok(Vec::new());
    };
    let settings = SpikeSettings {
        threshold: THRESHOLD,
        max_width_nm: widest_nm(bands),
        dips: false,
    };
    let parts = detect(band, &values, settings);
    let mut lines: Vec<Line> = parts
        .spikes
        .iter()
        .filter_map(|found| line_of(bands, spectrum, found, parts.power))
        .collect();
    lines.sort_by(|a, b| b.share.total_cmp(&a.share));
    Ok(lines)
}

/// Lines at places that a person names: where a peak stands near, with its shape, else the hat of
/// the nearest band. Two within half a band of one another are one.
///
/// # Errors
/// [`PictureError::LineOutside`] for a place beyond the bands.
pub(crate) fn lines_at(
    bands: &Bands,
    spectrum: &[f64],
    at_nm: &[f64],
) -> Result<HandLines, PictureError> {
    at_nm.iter().try_for_each(|at_nm| inside(bands, *at_nm))?;
    let mut places = at_nm.to_vec();
    places.sort_by(f64::total_cmp);
    let near = 0.5 * bands.median_spacing_nm();
    let mut found = HandLines::default();
    let mut kept: Vec<f64> = Vec::new();
    for place in places {
        match kept.last_mut() {
            Some(last) if place - *last < near => {
                let middle = 0.5 * (*last + place);
                let shown = |nm: f64| with_sign(nm.to_string());
                let note = tr!(
                    "lines at {last} and {place} nm are one at {middle} nm",
                    last = shown(*last),
                    place = shown(place),
                    middle = shown(middle)
                );
                found.notes.push(note);
                *last = middle;
            }
            _ => kept.push(place),
        }
    }
    let grid = on_grid(bands, spectrum)?;
    let widest = widest_nm(bands);
    for place in kept {
        let window = grid
            .as_ref()
            .and_then(|(band, values)| window_near(*band, values, place, widest, 1.0));
        let shaped = window.and_then(|window_nm| {
            let window = bands_about(bands, window_nm);
            let (shape, centroid) = above_chord(bands, spectrum, window)?;
            Some((centroid, shape, window))
        });
        let (at_nm, shape, window) = shaped.unwrap_or_else(|| hat(bands, place));
        found.lines.push(Line {
            at_nm,
            share: 0.0,
            shape,
            window,
        });
    }
    Ok(found)
}

/// A line at a place (nm) with the shape of what stands in a window of bands (first and last);
/// where nothing stands above the straight line between these, the hat of the nearest band.
///
/// # Errors
/// [`PictureError`] when the window or the place lies outside the bands.
pub(crate) fn line_in(
    bands: &Bands,
    spectrum: &[f64],
    window: [usize; 2],
    at_nm: f64,
) -> Result<Line, PictureError> {
    let (first_nm, last_nm) = (bands.nm()[0], bands.nm()[bands.len() - 1]);
    if spectrum.len() != bands.len()
        || window[1] >= bands.len()
        || !(first_nm..=last_nm).contains(&at_nm)
    {
        return Err(PictureError::LineOutside {
            at_nm,
            first_nm,
            last_nm,
        });
    }
    let above = above_chord(bands, spectrum, window);
    let shape = above.map_or_else(|| hat(bands, at_nm).1, |(shape, _)| shape);
    Ok(Line {
        at_nm,
        share: 0.0,
        shape,
        window,
    })
}

/// Refuses a line beyond the bands.
fn inside(bands: &Bands, at_nm: f64) -> Result<(), PictureError> {
    let (first_nm, last_nm) = (bands.nm()[0], bands.nm()[bands.len() - 1]);
    match (first_nm..=last_nm).contains(&at_nm) {
        true => Ok(()),
        false => Err(PictureError::LineOutside {
            at_nm,
            first_nm,
            last_nm,
        }),
    }
}

/// A spectrum on whole nm of its bands; `None` where these are too few, or too many, for lines.
fn on_grid(bands: &Bands, spectrum: &[f64]) -> Result<Option<(Band, Vec<f64>)>, PictureError> {
    let sampled = Sampled::new(bands.nm().to_vec(), spectrum.to_vec())
        .map_err(|error| PictureError::broken(error.to_string(), said!("a finite value a band")))?;
    let (first, last) = (bands.nm()[0].ceil(), bands.nm()[bands.len() - 1].floor());
    let band = Band::new(first, last).ok();
    Ok(band.map(|band| (band, sampled.on_band(band, Outside::Zero))))
}

fn bands_about(bands: &Bands, [from_nm, to_nm]: [f64; 2]) -> [usize; 2] {
    let nm = bands.nm();
    let first = nm.partition_point(|w| *w <= from_nm).saturating_sub(1);
    let last = nm.partition_point(|w| *w < to_nm).min(nm.len() - 1);
    [first, last]
}

fn line_of(bands: &Bands, spectrum: &[f64], found: &FoundSpike, power: f64) -> Option<Line> {
    let window = bands_about(bands, found.window_nm);
    let line = line_in(bands, spectrum, window, found.spike.at_nm).ok()?;
    Some(Line {
        share: found.spike.weight / power,
        ..line
    })
}

/// Shape above the straight line between a window's end bands, of unit area, and its centroid (nm);
/// `None` where nothing rises above that line.
fn above_chord(
    bands: &Bands,
    spectrum: &[f64],
    [first, last]: [usize; 2],
) -> Option<(Vec<f64>, f64)> {
    let nm = bands.nm();
    if last <= first + 1 {
        return None;
    }
    let mut shape = vec![0.0; nm.len()];
    for j in first..=last {
        let t = (nm[j] - nm[first]) / (nm[last] - nm[first]);
        let chord = spectrum[first] * (1.0 - t) + spectrum[last] * t;
        shape[j] = (spectrum[j] - chord).max(0.0);
    }
    let weighed = || shape.iter().zip(bands.weights_nm()).map(|(s, q)| s * q);
    let area: f64 = weighed().sum();
    let centroid = weighed().zip(nm).map(|(w, nm)| w * nm).sum::<f64>() / area;
    if !(area > 0.0 && area.is_finite()) {
        return None;
    }
    shape.iter_mut().for_each(|s| *s /= area);
    Some((shape, centroid))
}

/// A line without a peak: the hat of the nearest band, down to zero at its two neighbours.
fn hat(bands: &Bands, at_nm: f64) -> (f64, Vec<f64>, [usize; 2]) {
    let nm = bands.nm();
    let far = |j: &usize| (nm[*j] - at_nm).abs();
    let nearest = (0..nm.len())
        .min_by(|a, b| far(a).total_cmp(&far(b)))
        .unwrap_or(0);
    let mut shape = vec![0.0; nm.len()];
    shape[nearest] = 1.0 / bands.weights_nm()[nearest];
    let window = [nearest.saturating_sub(1), (nearest + 1).min(nm.len() - 1)];
    (at_nm, shape, window)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Kind;

    fn lamp() -> (Bands, Vec<f64>) {
        let nm: Vec<f64> = (0..81).map(|i| 380.0 + 5.0 * f64::from(i)).collect();
        let value = |nm: &f64| {
            let line = |at: f64, height: f64| height * (-((nm - at) / 4.0).powi(2)).exp();
            1.0 + line(545.0, 20.0) + line(435.0, 9.0)
        };
        let values = nm.iter().map(value).collect();
        (Bands::new(nm, Kind::Light).unwrap(), values)
    }

    #[test]
    fn lines_are_found_strongest_first_with_unit_area() {
        let (bands, values) = lamp();
        let lines = find_lines(&bands, &values).unwrap();
        assert_eq!(lines.len(), 2);
        assert!((lines[0].at_nm - 545.0).abs() < 1.0 && lines[0].share > lines[1].share);
        for line in &lines {
            let area: f64 = line
                .shape
                .iter()
                .zip(bands.weights_nm())
                .map(|(s, q)| s * q)
                .sum();
            assert!((area - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn a_wide_instrument_widens_what_counts_as_a_line() {
        let (bands, _) = lamp();
        assert_eq!(widest_nm(&bands), 10.0);
        assert_eq!(widest_nm(&bands.clone().with_bandwidth(Some(16.0))), 24.0);
        assert_eq!(widest_nm(&bands.with_bandwidth(Some(f64::NAN))), 10.0);
    }

    #[test]
    fn a_line_by_hand_takes_the_shape_of_a_peak_or_the_tent_of_the_nearest_band() {
        let (bands, values) = lamp();
        let found = lines_at(&bands, &values, &[545.5, 622.0]).unwrap();
        assert!((found.lines[0].at_nm - 545.0).abs() < 0.5);
        let hat = &found.lines[1];
        let touched: Vec<usize> = (0..81).filter(|j| hat.shape[*j] != 0.0).collect();
        assert_eq!(
            (hat.at_nm, bands.nm()[touched[0]], touched.len()),
            (622.0, 620.0, 1)
        );
    }

    #[test]
    fn lines_too_close_are_merged_and_said_and_outside_refused() {
        let (bands, values) = lamp();
        let found = lines_at(&bands, &values, &[600.0, 602.0]).unwrap();
        assert_eq!((found.lines.len(), found.notes.len()), (1, 1));
        let refused = lines_at(&bands, &values, &[350.0]).unwrap_err();
        assert!(
            refused
                .to_string()
                .contains("between the bands' ends 380 and 780 nm, found 350")
        );
    }
}
