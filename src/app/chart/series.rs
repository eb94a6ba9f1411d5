//! The short ways to make a series of each kind.

use super::{Cells, Dash, Ink, Marks, Series, Shape};

/// Values over their places as points.
pub fn curve(
    at: impl IntoIterator<Item = f64>,
    values: impl IntoIterator<Item = f64>,
) -> Vec<[f64; 2]> {
    let points = at.into_iter().zip(values);
    points.map(|(x, y)| [x, y]).collect()
}

/// A line of a thickness in px.
pub fn stroke(
    name: impl Into<String>,
    colour: impl Into<Ink>,
    points: Vec<[f64; 2]>,
    width: f64,
    dash: Dash,
) -> Series {
    let marks = Marks::Line {
        points,
        width,
        dash,
    };
    Series::new(name, colour, marks)
}

impl Series {
    /// A solid line of normal thickness.
    pub fn line(name: impl Into<String>, colour: impl Into<Ink>, points: Vec<[f64; 2]>) -> Self {
        stroke(name, colour, points, 1.8, Dash::Solid)
    }

    /// Points of normal size.
    pub fn points(
        name: impl Into<String>,
        colour: impl Into<Ink>,
        shape: Shape,
        points: Vec<[f64; 2]>,
    ) -> Self {
        let marks = Marks::Points {
            points,
            radius: 3.5,
            shape,
        };
        Self::new(name, colour, marks)
    }

    /// Stems without labels; each stands on its base, or on 0 where there is none.
    pub fn stems(
        name: impl Into<String>,
        colour: impl Into<Ink>,
        points: Vec<[f64; 2]>,
        base: Vec<f64>,
    ) -> Self {
        let marks = Marks::Stems {
            points,
            base,
            labels: Vec::new(),
        };
        Self::new(name, colour, marks)
    }

    /// The area between points and their bases (0 where there is none), thinly in its colour.
    pub fn area(
        name: impl Into<String>,
        colour: impl Into<Ink>,
        points: Vec<[f64; 2]>,
        base: Vec<f64>,
    ) -> Self {
        let marks = Marks::Area {
            points,
            base,
            is_coloured: false,
        };
        Self::new(name, colour, marks)
    }

    /// Boxes of a width in units of the horizontal axis.
    pub fn bars(
        name: impl Into<String>,
        colour: impl Into<Ink>,
        width: f64,
        points: Vec<[f64; 2]>,
    ) -> Self {
        Self::new(name, colour, Marks::Bars { points, width })
    }

    /// A heat map.
    pub fn cells(name: impl Into<String>, cells: Cells) -> Self {
        Self::new(name, [128; 3], Marks::Cells { cells })
    }

    /// The same, a line drawn in another way.
    #[must_use]
    pub fn dashed(mut self, how: Dash) -> Self {
        if let Marks::Line { dash, .. } = &mut self.marks {
            *dash = how;
        }
        self
    }

    /// The same, points of another radius in px.
    #[must_use]
    pub fn sized(mut self, px: f64) -> Self {
        if let Marks::Points { radius, .. } = &mut self.marks {
            *radius = px;
        }
        self
    }

    /// The same, stems with a text above each.
    #[must_use]
    pub fn labelled(mut self, texts: Vec<String>) -> Self {
        if let Marks::Stems { labels, .. } = &mut self.marks {
            *labels = texts;
        }
        self
    }

    /// The same, an area filled with the chart's colours.
    #[must_use]
    pub fn coloured(mut self) -> Self {
        if let Marks::Area { is_coloured, .. } = &mut self.marks {
            *is_coloured = true;
        }
        self
    }

    /// The same with a word on each point.
    #[must_use]
    pub fn with_notes(mut self, notes: Vec<String>) -> Self {
        self.notes = notes;
        self
    }

    /// A series of any kind of marks.
    pub fn new(name: impl Into<String>, colour: impl Into<Ink>, marks: Marks) -> Self {
        Self {
            name: name.into(),
            colour: colour.into(),
            marks,
            notes: Vec::new(),
            is_tagged: false,
        }
    }
}
