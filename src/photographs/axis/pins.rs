//! Axes by hand: places whose wavelengths a person has given.

use crate::languages::fixed;

use super::{
    super::peaks::Peaks,
    curve::{Curve, Degree, Point},
    refine::Solution,
};

/// A column with a wavelength that a person has given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pin {
    /// The column.
    pub px: f64,
    /// Its wavelength.
    pub nm: f64,
    /// It stays where it was set, also beside a peak.
    pub is_exact: bool,
}

impl Pin {
    /// One that goes onto a peak that is near.
    pub fn near(px: f64, nm: f64) -> Self {
        Self {
            px,
            nm,
            is_exact: false,
        }
    }
}

/// Why pins make no axis.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PinError {
    #[error("{}", said!("found one pin, expected two or more, or one and a lamp"))]
    TooFew,
    /// A pin beside the strip.
    #[error(
        "{}",
        tr!(
            "found a pin outside the picture, at {found}, expected 0 to {most}",
            found = fixed(.0, 1),
            most = .1
        )
    )]
    Outside(f64, usize),
    /// Two at one place.
    #[error(
        "{}",
        tr!(
            "found two pins on one peak, at {found}, expected each at a place of its own",
            found = fixed(.0, 1)
        )
    )]
    Twice(f64),
    /// Wavelengths that rise and fall.
    #[error("{}", said!("found pins out of order: nm must rise or fall all along"))]
    Order,
    /// A curve that turns.
    #[error("{}", tr!("the axis would turn round at {place} nm", place = fixed(.0, 0)))]
    Turns(f64),
}

/// Largest distance of a pin from the peak that it is meant for: columns, and share of all.
const SNAP: (f64, f64) = (4.0, 0.012);
/// Error of a pin set by hand, columns.
const BY_HAND_PX: f64 = 0.5;

/// Pins on the peaks that they were meant for, in the order of their columns.
///
/// # Errors
/// [`PinError`] for pins outside, at one place, or out of order.
pub fn snapped(pins: &[Pin], columns: usize, peaks: &Peaks) -> Result<Vec<Pin>, PinError> {
    let reach = SNAP.0.max(SNAP.1 * columns as f64);
    let mut snapped = Vec::new();
    for pin in pins {
        if !(0.0..=columns as f64 - 1.0).contains(&pin.px) || !pin.nm.is_finite() {
            return Err(PinError::Outside(pin.px, columns.saturating_sub(1)));
        }
        let away = |px: f64| (px - pin.px).abs();
        let near = peaks
            .peaks
            .iter()
            .map(|p| p.px)
            .filter(|px| !pin.is_exact && away(*px) <= reach);
        let nearest = near.min_by(|a, b| away(*a).total_cmp(&away(*b)));
        snapped.push(Pin {
            px: nearest.unwrap_or(pin.px),
            ..*pin
        });
    }
    snapped.sort_by(|a, b| a.px.total_cmp(&b.px));
    for pair in snapped.windows(2) {
        if pair[1].px - pair[0].px < 1e-6 {
            return Err(PinError::Twice(pair[0].px));
        }
    }
    let rises = |sign: f64| {
        snapped
            .windows(2)
            .all(|pair| sign * (pair[1].nm - pair[0].nm) > 0.0)
    };
    if rises(1.0) || rises(-1.0) {
        Ok(snapped)
    } else {
        Err(PinError::Order)
    }
}

/// The axis through pins alone: two a straight line, three a quadratic, more a cubic.
///
/// # Errors
/// [`PinError`] for too few, for those that are outside or out of order, and for a curve that
/// turns.
pub fn through_pins(pins: &[Pin], columns: usize, peaks: &Peaks) -> Result<Curve, PinError> {
    let pins = snapped(pins, columns, peaks)?;
    let [first, .., last] = pins[..] else {
        return Err(PinError::TooFew);
    };
    let slope = (last.nm - first.nm) / (last.px - first.px) * columns as f64;
    let degree = match pins.len() {
        2 => Degree::Straight,
        3 => Degree::Quadratic,
        _ => Degree::Cubic,
    };
    let sigma_nm = BY_HAND_PX * slope.abs() / columns as f64;
    let point = |pin: &Pin| Point {
        px: pin.px,
        nm: pin.nm,
        sigma_nm,
    };
    let points: Vec<Point> = pins.iter().map(point).collect();
    let fitted = Curve::fit(&points, columns, slope, degree).ok_or(PinError::TooFew)?;
    match fitted.0.turns_at() {
        Some(nm) => Err(PinError::Turns(nm)),
        None => Ok(fitted.0),
    }
}

/// The axis of a solution with one of its lines at another column, as a hand moves it: only the
/// fit, no search. `None` where it would turn round.
pub fn with_line_at(best: &Solution, peaks: &Peaks, line: usize, px: f64) -> Option<Curve> {
    let curve = &best.curve;
    let columns = curve.scale_px.round() as usize;
    let points: Vec<Point> = (best.matches.iter().enumerate())
        .map(|(i, found)| {
            let peak = peaks.peaks[found.peak];
            let by_hand = BY_HAND_PX * curve.slope(peak.px).abs();
            Point {
                px: if i == line { px } else { peak.px },
                nm: found.landmark.nm,
                sigma_nm: if i == line { by_hand } else { found.sigma_nm },
            }
        })
        .collect();
    let fitted = Curve::fit(&points, columns, curve.c[1], Degree::Quadratic)?;
    Some(fitted.0).filter(Curve::is_monotone)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photographs::peaks::Peak;

    fn pins(pins: &[(f64, f64)]) -> Vec<Pin> {
        pins.iter().map(|&(px, nm)| Pin::near(px, nm)).collect()
    }

    fn none() -> Peaks {
        Peaks {
            peaks: Vec::new(),
            limit: 0.01,
            width_px: 3.0,
            hairlines: 0,
        }
    }

    #[test]
    fn two_pins_are_a_straight_line_through_both() {
        let pins = pins(&[(500.0, 436.0), (100.0, 611.0)]);
        let curve = through_pins(&pins, 600, &none()).expect("an axis");
        for pin in pins {
            assert!((curve.nm(pin.px) - pin.nm).abs() < 0.01);
        }
        assert!((curve.nm(300.0) - 523.5).abs() < 0.01);
    }

    #[test]
    fn a_pin_goes_onto_a_peak_that_is_near_unless_it_is_exact() {
        let peak = Peak {
            px: 102.0,
            error_px: 0.1,
            height: 1.0,
            fwhm_px: 3.0,
            is_clipped: false,
            is_band: false,
            hue: None,
        };
        let peaks = Peaks {
            peaks: vec![peak],
            ..none()
        };
        let mut pins = pins(&[(100.0, 436.0), (300.0, 546.0)]);
        let snapped_px = |pins: &[Pin]| snapped(pins, 600, &peaks).expect("in order")[0].px;
        assert_eq!(snapped_px(&pins), 102.0);
        pins[0].is_exact = true;
        assert_eq!(snapped_px(&pins), 100.0);
    }

    #[test]
    fn pins_that_make_no_axis_are_refused_in_words() {
        let refused = |list: &[(f64, f64)]| {
            let found = through_pins(&pins(list), 600, &none());
            found.expect_err("no axis").to_string()
        };
        assert!(refused(&[(5.0, 400.0)]).contains("one pin"));
        assert!(refused(&[(5.0, 400.0), (605.0, 500.0)]).contains("outside"));
        assert!(refused(&[(5.0, 400.0), (5.0, 500.0)]).contains("one peak"));
        let zigzag = [(5.0, 400.0), (100.0, 500.0), (200.0, 450.0)];
        assert!(refused(&zigzag).contains("out of order"));
        let turning = [(5.0, 400.0), (100.0, 600.0), (300.0, 640.0), (590.0, 641.0)];
        assert!(refused(&turning).contains("turn round"));
    }
}
