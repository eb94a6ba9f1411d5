//! Axes: the ranges they show, from values to px and back, round ticks and their labels.

use super::{
    super::ticks::{extent, log_ticks, nice_ticks, root_ticks, short, tick_labels},
    Chart, Marks, Panel, Scale, Series,
};

/// Numbers that are too large to subtract from one another are not drawn.
const LARGEST: f64 = 1e300;

/// The range of no data: it becomes a usual one when it is made sound.
pub(super) const NOTHING: [f64; 2] = [f64::NAN; 2];

/// A range that can be divided by: finite, rising, and not empty.
pub(super) fn sound_range(range: [f64; 2], scale: Scale) -> [f64; 2] {
    let [mut low, mut high] = range.map(|end| end.clamp(-LARGEST, LARGEST));
    if low > high {
        std::mem::swap(&mut low, &mut high);
    }
    match scale {
        // NaN has survived all of the above.
        Scale::Linear | Scale::Root if low.is_nan() || high.is_nan() => [0.0, 1.0],
        Scale::Linear | Scale::Root => {
            // Flat data stand in the middle of a range as wide as they are high.
            let least = (low.abs().max(high.abs()) * 1e-12).max(1e-300);
            if high - low >= least {
                [low, high]
            } else if low == 0.0 {
                [-1.0, 1.0]
            } else {
                let half = low.abs() / 2.0;
                [low - half, high + half]
            }
        }
        Scale::Log10 if high > 0.0 => {
            let high = high.max(1e-300);
            // Zero is infinitely far down; six decades are about what one can tell apart.
            let low = if low > 0.0 { low } else { high / 1e6 }.max(1e-300);
            if high / low > 1.0 + 1e-9 {
                [low, high]
            } else {
                [low / 3.0, high * 3.0]
            }
        }
        Scale::Log10 => [0.1, 10.0],
    }
}

/// A square root with the sign of its number.
pub fn root(value: f64) -> f64 {
    value.abs().sqrt().copysign(value)
}

/// The number of a square root with a sign.
pub fn square(root: f64) -> f64 {
    (root * root).copysign(root)
}

/// An axis: values to px from its beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Axis {
    /// First and last value: finite and rising.
    pub range: [f64; 2],
    /// How values become places.
    pub scale: Scale,
    /// Length in px.
    pub length: f64,
}

impl Axis {
    /// An axis over a range, which is made sound.
    pub fn new(range: [f64; 2], scale: Scale, length: f64) -> Self {
        let range = sound_range(range, scale);
        Self {
            range,
            scale,
            length,
        }
    }

    /// How far from the beginning a value stands, px; NaN where it has no place.
    pub fn px(&self, value: f64) -> f64 {
        let [low, high] = self.range;
        let part = match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Root => (root(value) - root(low)) / (root(high) - root(low)),
            Scale::Log10 if value > 0.0 => (value.ln() - low.ln()) / (high.ln() - low.ln()),
            Scale::Log10 => f64::NAN,
        };
        self.length * part
    }

    /// The same for what marks stand on: 0 is at the beginning of a logarithmic axis.
    pub fn base_px(&self, base: f64) -> f64 {
        if self.scale == Scale::Log10 && base <= 0.0 {
            0.0
        } else {
            self.px(base)
        }
    }

    /// The value at a distance from the beginning.
    pub fn value(&self, px: f64) -> f64 {
        let ([low, high], part) = (self.range, px / self.length);
        match self.scale {
            Scale::Linear => low + (high - low) * part,
            Scale::Root => square(root(low) + (root(high) - root(low)) * part),
            Scale::Log10 => low * (high / low).powf(part),
        }
    }

    /// About `target` round numbers in the range, and how they are written.
    pub fn ticks(&self, target: usize) -> (Vec<f64>, Vec<String>) {
        let [low, high] = self.range;
        let ticks = match self.scale {
            Scale::Linear => nice_ticks(low, high, target),
            Scale::Root => root_ticks(low, high, target),
            Scale::Log10 => log_ticks(low, high, target),
        };
        let labels = match self.scale {
            Scale::Linear => tick_labels(&ticks),
            Scale::Root | Scale::Log10 => ticks.iter().copied().map(short).collect(),
        };
        (ticks, labels)
    }
}

impl Chart {
    /// First and last value of the horizontal axis as drawn: finite and rising.
    pub fn x_limits(&self) -> [f64; 2] {
        sound_range(self.x_range, self.x_scale)
    }

    /// First and last value of the vertical axis as drawn: finite and rising.
    pub fn y_limits(&self) -> [f64; 2] {
        limits(self.y_range, self.y_scale, &self.series)
    }
}

impl Panel {
    /// First and last value of the vertical axis as drawn: finite and rising.
    pub fn y_limits(&self) -> [f64; 2] {
        limits(self.y_range, Scale::Linear, &self.series)
    }
}

fn limits(range: Option<[f64; 2]>, scale: Scale, series: &[Series]) -> [f64; 2] {
    let range = range.unwrap_or_else(|| fitted_range(series, scale));
    sound_range(range, scale)
}

/// The range of the data with a little air around, and standing on 0 if it starts there.
fn fitted_range(series: &[Series], scale: Scale) -> [f64; 2] {
    let heights = series.iter().flat_map(|series| series.marks.heights());
    let usable = |y: &f64| y.abs() <= LARGEST && (scale != Scale::Log10 || *y > 0.0);
    let is_map = |series: &Series| series.marks.cells().is_some();
    match (extent(heights.filter(usable)), scale) {
        // A heat map fills its panel.
        (Some(range), _) if series.iter().any(is_map) => range,
        (None, _) => NOTHING,
        (Some([low, high]), scale @ (Scale::Linear | Scale::Root)) => {
            let air = (high - low) * 0.05;
            let foot = if low == 0.0 { 0.0 } else { low - air };
            // Labels stand above their stems.
            let labelled = series.iter().any(
                |series| matches!(&series.marks, Marks::Stems { labels, .. } if !labels.is_empty()),
            );
            let head = match high {
                // Two lines of a label, and the head below them.
                _ if labelled && scale == Scale::Root => high * 1.6,
                _ if labelled => high + 5.0 * air,
                0.0 => 0.0,
                _ => high + air,
            };
            [foot, head]
        }
        (Some([low, high]), Scale::Log10) => {
            let air = (high / low).powf(0.05).clamp(1.0, 1e10);
            [low / air, high * air]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn log_axes_place_decades_evenly() {
        let axis = Axis::new([1.0, 100.0], Scale::Log10, 200.0);
        assert!((axis.px(10.0) - 100.0).abs() < 1e-9);
        assert!(axis.px(0.0).is_nan());
        assert_eq!(axis.base_px(0.0), 0.0);
        assert!(axis.ticks(5).1.contains(&"10".to_owned()));
    }

    #[test]
    fn on_a_root_axis_four_times_the_height_is_twice_as_high_and_below_zero_alike() {
        let axis = Axis::new([0.0, 100.0], Scale::Root, 200.0);
        assert_eq!((axis.px(25.0), axis.px(100.0)), (100.0, 200.0));
        let axis = Axis::new([-4.0, 16.0], Scale::Root, 60.0);
        assert_eq!(
            (axis.px(-4.0), axis.px(0.0), axis.px(4.0)),
            (0.0, 20.0, 40.0)
        );
        assert_eq!(axis.value(0.0), -4.0);
    }

    #[test]
    fn a_place_leads_back_to_its_value() {
        for (scale, value) in [
            (Scale::Linear, 25.0),
            (Scale::Log10, 3.0),
            (Scale::Root, 7.0),
        ] {
            let axis = Axis::new([1.0, 100.0], scale, 200.0);
            assert!((axis.value(axis.px(value)) - value).abs() < 1e-12);
        }
    }
}
