//! Ranges of what the pages remember, and values moved into them.

/// Exposures, stops.
pub const STOPS: std::ops::RangeInclusive<f64> = -6.0..=6.0;

/// Both ends of a range.
pub(super) fn ends(range: std::ops::RangeInclusive<f64>) -> [f64; 2] {
    [*range.start(), *range.end()]
}

/// A value moved into a range; one that is no number becomes the usual one.
pub(super) fn moved(value: f64, [least, most]: [f64; 2], usual: f64) -> f64 {
    if value.is_finite() {
        value.clamp(least, most)
    } else {
        usual
    }
}

/// An exposure that the sliders reach.
pub(super) fn clamped_stops(stops: f64) -> f64 {
    moved(stops, ends(STOPS), 0.0)
}
