//! Axes: from values to px, with round ticks and their labels.

use super::{
    super::ticks::{extent, log_ticks, nice_ticks, short, tick_labels},
    Marks, Scale, Series,
    text::{TEXT_SIZE, text_width},
};

/// Numbers that are too large to subtract from one another are not drawn.
const LARGEST: f64 = 1e300;

/// A range that can be divided by: finite, rising, and not empty.
fn sound_range(range: [f64; 2], scale: Scale) -> [f64; 2] {
    let [mut low, mut high] = range.map(|end| end.clamp(-LARGEST, LARGEST));
    if low > high {
        std::mem::swap(&mut low, &mut high);
    }
    match scale {
        // NaN has survived all of the above.
        Scale::Linear if low.is_nan() || high.is_nan() => [0.0, 1.0],
        Scale::Linear => {
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

/// The horizontal axis of a chart: values to px from the left end of a panel.
pub(super) struct Horizontal {
    range: [f64; 2],
    pub(super) length: f64,
    pub(super) ticks: Vec<f64>,
    pub(super) labels: Vec<String>,
}

impl Horizontal {
    pub(super) fn new(range: [f64; 2], length: f64) -> Self {
        let range = sound_range(range, Scale::Linear);
        // As many labels as fit side by side; how wide they are shows only when they are made.
        let mut target = (length / 60.0).clamp(2.0, 14.0) as usize;
        loop {
            let ticks = nice_ticks(range[0], range[1], target);
            let labels = tick_labels(&ticks);
            let widths = labels
                .iter()
                .map(|label| text_width(label, TEXT_SIZE) + 10.0);
            if target <= 1 || widths.sum::<f64>() <= length {
                return Self {
                    range,
                    length,
                    ticks,
                    labels,
                };
            }
            target -= 1;
        }
    }

    pub(super) fn px(&self, x: f64) -> f64 {
        (x - self.range[0]) / (self.range[1] - self.range[0]) * self.length
    }
}

/// The vertical axis of a panel: values to px from its top.
pub(super) struct Vertical {
    pub(super) range: [f64; 2],
    pub(super) scale: Scale,
    pub(super) length: f64,
    pub(super) ticks: Vec<f64>,
    pub(super) labels: Vec<String>,
}

impl Vertical {
    pub(super) fn new(
        range: Option<[f64; 2]>,
        scale: Scale,
        series: &[Series],
        length: f64,
    ) -> Self {
        let range = range.unwrap_or_else(|| fitted_range(series, scale));
        let range = sound_range(range, scale);
        let target = (length / 36.0).clamp(2.0, 12.0) as usize;
        let (ticks, labels) = match scale {
            Scale::Linear => {
                let ticks = nice_ticks(range[0], range[1], target);
                let labels = tick_labels(&ticks);
                (ticks, labels)
            }
            Scale::Log10 => {
                let ticks = log_ticks(range[0], range[1], target);
                let labels = ticks.iter().copied().map(short).collect();
                (ticks, labels)
            }
        };
        Self {
            range,
            scale,
            length,
            ticks,
            labels,
        }
    }

    pub(super) fn px(&self, y: f64) -> f64 {
        let [low, high] = self.range;
        let part = match self.scale {
            Scale::Linear => (y - low) / (high - low),
            Scale::Log10 if y > 0.0 => (y.ln() - low.ln()) / (high.ln() - low.ln()),
            Scale::Log10 => f64::NAN,
        };
        (1.0 - part) * self.length
    }

    /// Where marks that stand on a value start: 0 has no place on a logarithmic axis.
    pub(super) fn base_px(&self, base: f64) -> f64 {
        if self.scale == Scale::Log10 && base <= 0.0 {
            self.length
        } else {
            self.px(base)
        }
    }
}

/// The range of the data with a little air around, and standing on 0 if it starts there.
fn fitted_range(series: &[Series], scale: Scale) -> [f64; 2] {
    let heights = series.iter().flat_map(|series| series.marks.heights());
    let usable = |y: &f64| y.abs() <= LARGEST && (scale == Scale::Linear || *y > 0.0);
    match (extent(heights.filter(usable)), scale) {
        (None, Scale::Linear) => [0.0, 1.0],
        (None, Scale::Log10) => [0.1, 10.0],
        (Some([low, high]), Scale::Linear) => {
            let air = (high - low) * 0.05;
            let foot = if low == 0.0 { 0.0 } else { low - air };
            // Labels stand above their stems.
            let labelled = series.iter().any(
                |series| matches!(&series.marks, Marks::Stems { labels, .. } if !labels.is_empty()),
            );
            let head = match high {
                _ if labelled => high + 2.5 * air,
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
        let axis = Vertical::new(Some([1.0, 100.0]), Scale::Log10, &[], 200.0);
        assert!((axis.px(10.0) - 100.0).abs() < 1e-9);
        assert!(axis.px(0.0).is_nan());
        assert_eq!(axis.base_px(0.0), 200.0);
        assert!(axis.labels.contains(&"10".to_owned()));
    }
}
