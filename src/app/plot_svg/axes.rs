//! Axes: from values to px, with round ticks and their labels.

use super::{
    super::ticks::{extent, log_ticks, nice_ticks, short, tick_labels},
    Chart, Marks, Panel, Scale, Series,
    text::{LEADING, TEXT_SIZE, clean, text_width},
};

/// Numbers that are too large to subtract from one another are not drawn.
const LARGEST: f64 = 1e300;

/// A range that can be divided by: finite, rising, and not empty.
pub(super) fn sound_range(range: [f64; 2], scale: Scale) -> [f64; 2] {
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

/// Slant of names that do not fit side by side, degrees.
pub(super) const SLANT: f64 = 35.0;

/// The horizontal axis of a chart: values to px from the left end of a panel.
pub(super) struct Horizontal {
    range: [f64; 2],
    scale: Scale,
    pub(super) length: f64,
    pub(super) ticks: Vec<f64>,
    pub(super) labels: Vec<String>,
    /// Whether places have names instead of numbers.
    pub(super) named: bool,
    /// Labels that are too long to stand side by side.
    pub(super) slanted: bool,
}

impl Horizontal {
    pub(super) fn new(chart: &Chart, length: f64) -> Self {
        let mut axis = Self {
            range: chart.x_limits(),
            scale: chart.x_scale,
            length,
            ticks: Vec::new(),
            labels: Vec::new(),
            named: !chart.x_names.is_empty(),
            slanted: false,
        };
        if axis.named {
            axis.name(&chart.x_names);
        } else {
            axis.number();
        }
        axis
    }

    /// As many numbers as fit side by side; how wide they are shows only when they are made.
    fn number(&mut self) {
        let mut target = (self.length / 60.0).clamp(2.0, 14.0) as usize;
        loop {
            (self.ticks, self.labels) = ticks_of(self.range, self.scale, target);
            let widths = self.labels.iter().map(|l| text_width(l, TEXT_SIZE) + 10.0);
            if target <= 1 || widths.sum::<f64>() <= self.length {
                return;
            }
            target -= 1;
        }
    }

    fn name(&mut self, names: &[(f64, String)]) {
        let mut places: Vec<(f64, String)> = names
            .iter()
            .filter(|(x, _)| (0.0..=self.length).contains(&self.px(*x)))
            .map(|(x, name)| (*x, elided(&clean(name))))
            .collect();
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        self.slanted = places.windows(2).any(|pair| {
            let [a, b] = [&pair[0], &pair[1]];
            let needed = (text_width(&a.1, TEXT_SIZE) + text_width(&b.1, TEXT_SIZE)) / 2.0;
            self.px(b.0) - self.px(a.0) < needed + 8.0
        });
        // Even slanted names need a line's height each.
        let mut last = f64::NEG_INFINITY;
        places.retain(|(x, _)| {
            let px = self.px(*x);
            let fits = px - last >= TEXT_SIZE * 1.2;
            if fits {
                last = px;
            }
            fits
        });
        (self.ticks, self.labels) = places.into_iter().unzip();
    }

    /// The height that the labels need, px.
    pub(super) fn label_height(&self) -> f64 {
        if !self.slanted {
            return TEXT_SIZE * LEADING;
        }
        let widths = self.labels.iter().map(|l| text_width(l, TEXT_SIZE));
        widths.fold(0.0, f64::max) * SLANT.to_radians().sin() + TEXT_SIZE * LEADING
    }

    /// How far slanted labels reach to the left of the panel, px.
    pub(super) fn label_overhang(&self) -> f64 {
        if !self.slanted {
            return 0.0;
        }
        let reach = |(tick, label): (&f64, &String)| {
            text_width(label, TEXT_SIZE) * SLANT.to_radians().cos() - self.px(*tick)
        };
        let reaches = self.ticks.iter().zip(&self.labels).map(reach);
        reaches.fold(0.0, f64::max)
    }

    pub(super) fn px(&self, x: f64) -> f64 {
        self.length * part(x, self.range, self.scale)
    }
}

/// Longest name of a place, characters.
const LONGEST_NAME: usize = 24;

/// A name that is cut where it would take too much room.
fn elided(name: &str) -> String {
    if name.chars().count() <= LONGEST_NAME {
        return name.to_owned();
    }
    let kept: String = name.chars().take(LONGEST_NAME - 1).collect();
    format!("{}…", kept.trim_end())
}

/// Where a value stands in a range, 0 to 1; NaN where it has no place.
fn part(value: f64, [low, high]: [f64; 2], scale: Scale) -> f64 {
    match scale {
        Scale::Linear => (value - low) / (high - low),
        Scale::Log10 if value > 0.0 => (value.ln() - low.ln()) / (high.ln() - low.ln()),
        Scale::Log10 => f64::NAN,
    }
}

/// Round numbers in a range and how they are written.
fn ticks_of(range: [f64; 2], scale: Scale, target: usize) -> (Vec<f64>, Vec<String>) {
    let [low, high] = range;
    match scale {
        Scale::Linear => {
            let ticks = nice_ticks(low, high, target);
            let labels = tick_labels(&ticks);
            (ticks, labels)
        }
        Scale::Log10 => {
            let ticks = log_ticks(low, high, target);
            let labels = ticks.iter().copied().map(short).collect();
            (ticks, labels)
        }
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

/// The vertical axis of a panel: values to px from its top.
pub(super) struct Vertical {
    pub(super) range: [f64; 2],
    pub(super) scale: Scale,
    pub(super) length: f64,
    pub(super) ticks: Vec<f64>,
    pub(super) labels: Vec<String>,
}

impl Vertical {
    pub(super) fn new(range: [f64; 2], scale: Scale, length: f64) -> Self {
        let target = (length / 36.0).clamp(2.0, 12.0) as usize;
        let (ticks, labels) = ticks_of(range, scale, target);
        Self {
            range,
            scale,
            length,
            ticks,
            labels,
        }
    }

    pub(super) fn px(&self, y: f64) -> f64 {
        (1.0 - part(y, self.range, self.scale)) * self.length
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
    let is_map = |series: &Series| series.marks.cells().is_some();
    match (extent(heights.filter(usable)), scale) {
        // A heat map fills its panel.
        (Some(range), _) if series.iter().any(is_map) => range,
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
        let axis = Vertical::new([1.0, 100.0], Scale::Log10, 200.0);
        assert!((axis.px(10.0) - 100.0).abs() < 1e-9);
        assert!(axis.px(0.0).is_nan());
        assert_eq!(axis.base_px(0.0), 200.0);
        assert!(axis.labels.contains(&"10".to_owned()));
    }
}
