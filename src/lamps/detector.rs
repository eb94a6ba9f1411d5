//! Lines as wide as they are: the house's detector finds them, each is given the width that fits it
//! best.
//!
//! A line takes its Gaussian out of the spectrum, not the part above the hull, so
//! `S = smooth + lines` holds to rounding and the smooth part keeps all that no Gaussian describes.

use super::encoding::{byte_of_width, width_of_byte};
use crate::spectrum::{Band, Decomposition, Line, LineShape, SpikeSettings, detect_shapes};

/// A line may be found this much wider than the detector was asked for: half a nm of grid on either
/// side, and hulls that are not exact.
const WIDER: f64 = 1.5;

/// Every so many stored widths are looked at first.
const STRIDE: u8 = 8;

/// A spectrum taken apart into a smooth part and lines of their own width.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct WideDecomposition {
    /// The spectrum without the lines, one value a grid point.
    pub smooth: Vec<f64>,
    /// The lines, by rising wavelength.
    pub spikes: Vec<Line>,
    /// The detector's result, for windows, peaks and shares.
    pub found: Decomposition,
}

/// Takes a spectrum apart; the lines are those of the default detector.
pub(crate) fn decompose(band: Band, values: &[f64], settings: SpikeSettings) -> WideDecomposition {
    let (found, shapes) = detect_shapes(band, values, settings);
    let widest = settings.max_width_nm;
    let mut spikes: Vec<Line> = shapes
        .iter()
        .map(|shape| as_wide_as_it_is(band, shape, widest))
        .collect();
    spikes.sort_by(|a, b| a.at_nm.total_cmp(&b.at_nm));
    let mut smooth = values.to_vec();
    for spike in &spikes {
        spike.profile(band).add_to(-spike.weight, &mut smooth);
    }
    WideDecomposition {
        smooth,
        spikes,
        found,
    }
}

/// A found line with the stored width whose Gaussian, at the line's place and of its energy, is
/// nearest to what the detector took out (least squares on the grid); it may be somewhat wider than
/// the `max_width_nm` that the detector was asked for.
pub(crate) fn as_wide_as_it_is(band: Band, shape: &LineShape, max_width_nm: f64) -> Line {
    let spike = |byte: u8| Line {
        at_nm: shape.spike.at_nm,
        weight: shape.spike.weight,
        fwhm_nm: width_of_byte(byte),
    };
    // Squares of heights up to the largest number would overflow.
    let top = shape.residue.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let error = |byte: u8| {
        let line = spike(byte).profile(band);
        let last = (shape.first + shape.residue.len()).max(line.first + line.values.len());
        let at = |first: usize, values: &[f64], i: usize| {
            i.checked_sub(first)
                .and_then(|k| values.get(k))
                .copied()
                .unwrap_or(0.0)
        };
        let misses = (shape.first.min(line.first)..last).map(|i| {
            let taken = at(shape.first, &shape.residue, i);
            let model = shape.spike.weight * at(line.first, &line.values, i);
            band.weight(i) * ((taken - model) / top).powi(2)
        });
        misses.sum::<f64>()
    };
    let most = byte_of_width(WIDER * max_width_nm);
    let nearest = |bytes: &mut dyn Iterator<Item = u8>| {
        bytes
            .map(|b| (b, error(b)))
            .min_by(|a, b| a.1.total_cmp(&b.1))
            .map_or(0, |(b, _)| b)
    };
    let coarse = nearest(&mut (0..=most).step_by(usize::from(STRIDE)));
    let from = coarse.saturating_sub(STRIDE);
    let byte = nearest(&mut (from..=coarse.saturating_add(STRIDE).min(most)));
    spike(byte)
}

/// A found line as its own Gaussian; nothing where its width is none.
pub(crate) fn own_profile(
    band: Band,
    shape: &LineShape,
    settings: SpikeSettings,
) -> Option<LineShape> {
    let line = as_wide_as_it_is(band, shape, settings.max_width_nm);
    if line.is_ideal() {
        return None;
    }
    let profile = line.profile(band);
    Some(LineShape {
        spike: shape.spike,
        first: profile.first,
        residue: profile.values.iter().map(|v| line.weight * v).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spectrum::Outside;

    const BAND: Band = Band::VISIBLE;

    /// A broad bulge with bells of these widths on it.
    fn lamp(lines: &[Line]) -> Vec<f64> {
        let mut values: Vec<f64> = BAND
            .grid()
            .map(|nm| 1.0 + 0.4 * (nm / 80.0).cos())
            .collect();
        crate::spectrum::add_lines(BAND, lines, &mut values);
        values
    }

    #[test]
    fn each_line_is_given_the_width_it_has() {
        let lines =
            [(405.0, 2.5), (436.0, 4.0), (546.0, 6.0), (611.0, 8.0)].map(|(at_nm, width_nm)| {
                Line {
                    at_nm,
                    weight: 60.0,
                    fwhm_nm: width_nm,
                }
            });
        let parts = decompose(BAND, &lamp(&lines), SpikeSettings::default());
        assert_eq!(parts.spikes.len(), 4);
        for (found, line) in parts.spikes.iter().zip(lines) {
            // The hull cuts a foot of up to two per cent off a bell, which narrows it by as much.
            assert!(
                (found.fwhm_nm - line.fwhm_nm).abs() < 0.06 * line.fwhm_nm,
                "{found:?}"
            );
        }
    }

    #[test]
    fn smooth_part_and_lines_are_the_spectrum_and_its_power() {
        let table = crate::preset::table("cie_fluorescent_1nm", "FL2").expect("shipped");
        let values = table.on_band(BAND, Outside::Zero);
        let parts = decompose(BAND, &values, SpikeSettings::default());
        assert_eq!(parts.spikes.len(), 4);
        let mut sum = parts.smooth.clone();
        crate::spectrum::add_lines(BAND, &parts.spikes, &mut sum);
        // One subtraction and one addition of numbers up to 60.
        assert!(sum.iter().zip(&values).all(|(a, b)| (a - b).abs() < 1e-13));
        let power =
            BAND.integral(&parts.smooth) + parts.spikes.iter().map(|s| s.weight).sum::<f64>();
        assert!((power - BAND.integral(&values)).abs() < 1e-10 * power);
        for (wide, ideal) in parts.spikes.iter().zip(&parts.found.spikes) {
            assert_eq!(
                (wide.at_nm, wide.weight),
                (ideal.spike.at_nm, ideal.spike.weight)
            );
        }
    }

    #[test]
    fn a_line_of_one_sample_is_ideal_and_darkness_has_none() {
        let mut values = vec![0.0; 401];
        values[166] = 5.0;
        let parts = decompose(BAND, &values, SpikeSettings::default());
        assert_eq!(
            parts.spikes.iter().map(|s| s.fwhm_nm).collect::<Vec<_>>(),
            [0.0]
        );
        assert!(
            decompose(BAND, &vec![0.0; 401], SpikeSettings::default())
                .spikes
                .is_empty()
        );
    }
}
