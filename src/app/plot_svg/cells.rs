//! A heat map: values on a grid, coloured by lightness.

use std::fmt::Write as _;

use super::{
    super::ticks::{extent, log_ticks, nice_ticks, short, tick_labels},
    Rgb, Scale,
    axes::sound_range,
    marks::Plot,
    palette::{Palette, hex},
    ramp::ramp_colour,
    text::{Anchor, TEXT_SIZE, Text, escaped, px, text_width},
};

/// Values on a grid of boxes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cells {
    /// Borders of the columns, rising; one more than there are columns.
    pub x_edges: Vec<f64>,
    /// Borders of the rows, rising; one more than there are rows.
    pub y_edges: Vec<f64>,
    /// One row after the other, the lowest first; `None` where there is no value.
    pub values: Vec<Option<f64>>,
    /// Values of the first and the last colour; `None` takes the smallest and the largest.
    pub range: Option<[f64; 2]>,
    /// How values become colours.
    pub scale: Scale,
    /// What is coloured, with its unit: written at the colour bar.
    pub label: String,
}

impl Cells {
    /// How many boxes stand side by side.
    pub fn columns(&self) -> usize {
        self.x_edges.len().saturating_sub(1)
    }

    /// How many rows there are.
    pub fn rows(&self) -> usize {
        self.y_edges.len().saturating_sub(1)
    }

    /// The value of a box by its place in `values`; `None` when it cannot be shown.
    pub fn value(&self, index: usize) -> Option<f64> {
        let value = self.values.get(index).copied().flatten()?;
        let shown = value.is_finite() && (self.scale == Scale::Linear || value > 0.0);
        shown.then_some(value)
    }

    /// Left and right, then lower and upper border of a box.
    pub fn sides(&self, index: usize) -> Option<[[f64; 2]; 2]> {
        let columns = self.columns().max(1);
        let [column, row] = [index % columns, index / columns];
        let pair = |edges: &[f64], i: usize| Some([*edges.get(i)?, *edges.get(i + 1)?]);
        Some([pair(&self.x_edges, column)?, pair(&self.y_edges, row)?])
    }

    /// The middle of a box.
    pub fn middle(&self, index: usize) -> Option<[f64; 2]> {
        let sides = self.sides(index)?;
        Some(sides.map(|[low, high]| low + (high - low) / 2.0))
    }

    /// The box that holds a place.
    pub fn at(&self, place: [f64; 2]) -> Option<usize> {
        let find = |edges: &[f64], at: f64| edges.windows(2).position(|w| w[0] <= at && at < w[1]);
        let column = find(&self.x_edges, place[0])?;
        let row = find(&self.y_edges, place[1])?;
        let index = row * self.columns() + column;
        (index < self.values.len()).then_some(index)
    }

    /// Values of the first and the last colour: finite and rising.
    pub fn limits(&self) -> [f64; 2] {
        let shown = || (0..self.values.len()).filter_map(|i| self.value(i));
        let range = self.range.or_else(|| extent(shown()));
        let nothing = match self.scale {
            Scale::Linear => [0.0, 1.0],
            Scale::Log10 => [0.1, 10.0],
        };
        sound_range(range.unwrap_or(nothing), self.scale)
    }

    /// Where a value stands between the `limits`, 0 to 1.
    pub fn place(&self, value: f64, limits: [f64; 2]) -> f64 {
        let [low, high] = limits;
        let part = match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Log10 => (value / low).ln() / (high / low).ln(),
        };
        if part.is_nan() {
            0.0
        } else {
            part.clamp(0.0, 1.0)
        }
    }

    /// The colour of every box, in the order of `values`.
    pub fn colours(&self) -> Vec<Option<Rgb>> {
        let limits = self.limits();
        let colour = |i| Some(ramp_colour(self.place(self.value(i)?, limits)));
        (0..self.values.len()).map(colour).collect()
    }

    /// About `target` round values for the colour bar, with their words.
    pub fn bar_ticks(&self, target: usize) -> Vec<(f64, String)> {
        let [low, high] = self.limits();
        match self.scale {
            Scale::Linear => {
                let ticks = nice_ticks(low, high, target);
                let labels = tick_labels(&ticks);
                ticks.into_iter().zip(labels).collect()
            }
            Scale::Log10 => {
                let ticks = log_ticks(low, high, target);
                ticks.into_iter().map(|tick| (tick, short(tick))).collect()
            }
        }
    }
}

impl Plot<'_> {
    /// Writes the boxes; a box without a value is the ground with a stroke through it.
    pub(super) fn cells(&self, out: &mut String, cells: &Cells) {
        let _ = writeln!(out, r#"<g shape-rendering="crispEdges">"#);
        let mut empty = String::new();
        for (i, colour) in cells.colours().into_iter().enumerate() {
            let Some([left, top, right, bottom]) = self.cell(cells, i) else {
                continue;
            };
            let Some(colour) = colour else {
                let _ = write!(
                    empty,
                    "M{} {}L{} {}",
                    px(left),
                    px(bottom),
                    px(right),
                    px(top)
                );
                continue;
            };
            let _ = writeln!(
                out,
                r#"<rect x="{}" y="{}" width="{}" height="{}" fill="{}"/>"#,
                px(left),
                px(top),
                px(right - left),
                px(bottom - top),
                hex(colour),
            );
        }
        let _ = writeln!(out, "</g>");
        if !empty.is_empty() {
            let stroke = hex(self.palette.axis);
            let _ = writeln!(
                out,
                r#"<path d="{empty}" stroke="{stroke}" stroke-opacity="0.6"/>"#
            );
        }
    }

    /// Left, top, right and bottom of a box, px, cut to the panel; `None` when nothing is left.
    fn cell(&self, cells: &Cells, index: usize) -> Option<[f64; 4]> {
        let [x, y] = cells.sides(index)?;
        let [width, height] = self.size();
        let [left, right] = x.map(|x| self.horizontal.px(x).clamp(0.0, width));
        let [bottom, top] = y.map(|y| self.vertical.base_px(y).clamp(0.0, height));
        // NaN fails both comparisons.
        (right > left && bottom > top).then_some([left, top, right, bottom])
    }
}

/// Width of a colour bar, px.
const BAR_WIDTH: f64 = 14.0;

/// Distance of a colour bar to its panel, px.
const BAR_GAP: f64 = 14.0;

/// The room that a colour bar takes at the right of its panel, px.
pub(super) fn bar_room(cells: &Cells, height: f64) -> f64 {
    let ticks = cells.bar_ticks(bar_target(height));
    let widest = ticks
        .iter()
        .map(|(_, label)| text_width(label, TEXT_SIZE))
        .fold(0.0, f64::max);
    let name = if cells.label.is_empty() { 0.0 } else { 18.0 };
    BAR_GAP + BAR_WIDTH + 6.0 + widest + name
}

fn bar_target(height: f64) -> usize {
    (height / 40.0).clamp(2.0, 10.0) as usize
}

/// Writes a colour bar beside a panel: `at` is the panel's upper right corner, `room` what
/// [`bar_room`] told.
pub(super) fn draw_bar(
    out: &mut String,
    palette: &Palette,
    cells: &Cells,
    at: [f64; 2],
    height: f64,
    room: f64,
) {
    const STEPS: usize = 64;
    let left = at[0] + BAR_GAP;
    let (x, width) = (px(left), px(BAR_WIDTH));
    let _ = writeln!(out, r#"<g shape-rendering="crispEdges">"#);
    for step in 0..STEPS {
        // From the top down, each up to the lower end: no rounding leaves a gap.
        let part = step as f64 / STEPS as f64;
        let colour = ramp_colour(1.0 - (step as f64 + 0.5) / STEPS as f64);
        let _ = writeln!(
            out,
            r#"<rect x="{x}" y="{}" width="{width}" height="{}" fill="{}"/>"#,
            px(at[1] + part * height),
            px((1.0 - part) * height),
            hex(colour),
        );
    }
    let _ = writeln!(out, "</g>");
    let label = Text {
        size: TEXT_SIZE,
        colour: palette.text,
        anchor: Anchor::Start,
    };
    let limits = cells.limits();
    for (tick, words) in cells.bar_ticks(bar_target(height)) {
        let y = at[1] + (1.0 - cells.place(tick, limits)) * height;
        let at = [left + BAR_WIDTH + 5.0, y + TEXT_SIZE * 0.36];
        label.write(out, at, &words);
    }
    if !cells.label.is_empty() {
        let (x, y) = (at[0] + room - 4.0, at[1] + height / 2.0);
        let _ = writeln!(
            out,
            r#"<text transform="translate({} {}) rotate(-90)" font-size="{TEXT_SIZE}" text-anchor="middle" fill="{}">{}</text>"#,
            px(x),
            px(y),
            hex(palette.text),
            escaped(&cells.label),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn grid() -> Cells {
        Cells {
            x_edges: vec![0.0, 1.0, 3.0],
            y_edges: vec![0.0, 10.0, 20.0],
            values: vec![Some(1.0), Some(10.0), None, Some(100.0)],
            scale: Scale::Log10,
            ..Cells::default()
        }
    }

    #[test]
    fn a_place_finds_its_box_and_the_box_its_middle() {
        let cells = grid();
        assert_eq!(cells.at([2.0, 5.0]), Some(1));
        assert_eq!(cells.middle(1), Some([2.0, 5.0]));
        assert_eq!(cells.at([3.5, 5.0]), None);
        assert_eq!(cells.middle(4), None);
    }

    #[test]
    fn colours_follow_the_logarithm_and_what_is_missing_has_none() {
        let colours = grid().colours();
        assert_eq!(colours[0], Some(ramp_colour(0.0)));
        assert_eq!(colours[1], Some(ramp_colour(0.5)));
        assert_eq!(colours[2], None);
        assert_eq!(colours[3], Some(ramp_colour(1.0)));
    }

    #[test]
    fn grids_that_do_not_fit_their_values_are_no_trouble() {
        for values in [vec![], vec![Some(f64::NAN); 2], vec![Some(1.0); 9]] {
            let cells = Cells { values, ..grid() };
            assert!(cells.limits().iter().all(|end| end.is_finite()));
            assert_eq!(cells.colours().len(), cells.values.len());
            assert!(cells.at([2.0, 15.0]).is_none_or(|i| i < cells.values.len()));
        }
    }
}
