//! A heat map: values on a grid, coloured by lightness.

use super::{
    super::ticks::extent,
    Rgb, Scale,
    axis::{Axis, NOTHING, root, sound_range},
    ramp::ramp_colour,
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
        let shown = value.is_finite() && (self.scale != Scale::Log10 || value > 0.0);
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
        sound_range(range.unwrap_or(NOTHING), self.scale)
    }

    /// Where a value stands between the `limits`, 0 to 1.
    pub fn place(&self, value: f64, limits: [f64; 2]) -> f64 {
        let [low, high] = limits;
        let part = match self.scale {
            Scale::Linear => (value - low) / (high - low),
            Scale::Root => (root(value) - root(low)) / (root(high) - root(low)),
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

    /// The colour bar as an axis of a length in px.
    pub(super) fn bar(&self, length: f64) -> Axis {
        Axis::new(self.limits(), self.scale, length)
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
