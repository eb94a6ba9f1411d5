//! The map of differences: a colour for each pixel, and the scale beside it.

use super::Turned;
use crate::app::{
    chart::{Rgb, ramp_colour},
    picture::NOT_MEASURED,
};

/// Differences (ΔE₀₀) that the scale names, at even distances: the eye needs the low ones most.
pub const NAMED: [f64; 4] = [0.0, 1.0, 2.0, 4.0];

/// Where a difference stands on the scale, 0-1.
pub fn place_of(off: f64) -> f64 {
    let steps = (NAMED.len() - 1) as f64;
    let above = NAMED.iter().filter(|named| off >= **named).count();
    let below = above.clamp(1, NAMED.len() - 1) - 1;
    let part = (off - NAMED[below]) / (NAMED[below + 1] - NAMED[below]);
    ((below as f64 + part) / steps).clamp(0.0, 1.0)
}

/// The map, row after row; chequers where nothing was measured.
pub fn difference_colours(turned: &Turned) -> Vec<Rgb> {
    let across = turned.sides[0].width;
    let colour = |(i, off): (usize, &f32)| {
        if off.is_finite() {
            ramp_colour(place_of(f64::from(*off)))
        } else {
            NOT_MEASURED[(i % across + i / across) % 2]
        }
    };
    turned.off.iter().enumerate().map(colour).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_is_even_between_its_names_and_ends_there() {
        for (i, named) in NAMED.into_iter().enumerate() {
            assert!((place_of(named) - i as f64 / 3.0).abs() < 1e-12, "{named}");
        }
        assert!((place_of(3.0) - 5.0 / 6.0).abs() < 1e-12);
        assert_eq!(place_of(40.0), 1.0);
    }
}
