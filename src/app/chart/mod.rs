//! Charts: as data (lines, stems, areas, bars, points and heat maps over one or two panels), as
//! tables, and their one drawing, which files write as SVG and the window paints.
//!
//! The drawing gets numbers and returns numbers; it knows nothing of the window. Places that cannot
//! be drawn (NaN, infinite, or not above 0 on a logarithmic axis) are left out and break a line in
//! two.

mod around;
mod axis;
mod cells;
mod cut;
mod drawing;
mod legend;
mod looks;
mod palette;
mod plot;
mod points;
mod primitive;
mod ramp;
mod series;
mod shape;
mod svg;
mod table;
#[cfg(test)]
mod tests;
mod text;

use std::fmt::Write as _;

use super::ticks::short;

pub use axis::{Axis, root, square};
pub use cells::Cells;
pub use drawing::{Drawing, View};
pub use looks::Looks;
pub use palette::{Ink, OVERLAY_INKS, Palette};
pub use plot::Plot;
pub use primitive::{Anchor, Field, Place, Primitive, Text};
pub use ramp::ramp_colour;
pub use series::{curve, stroke};
pub use shape::{Dash, Shape};
pub use svg::{SVG_HEAD, escaped, px};
pub use text::{elided, text_width, wrap};

/// An sRGB colour, 8 bits a channel.
pub type Rgb = [u8; 3];

/// A chart: titles, axes, one panel of series, and perhaps a second one below it.
///
/// `Chart::default()` is an empty chart over 0 to 1, for use with `..Chart::default()`.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Shown on top and read out by screen readers.
    pub title: String,
    /// What the horizontal axis counts, with its unit: `"Wavelength (nm)"`.
    pub x_label: String,
    /// What the vertical axis counts, with its unit.
    pub y_label: String,
    /// First and last value of the horizontal axis.
    pub x_range: [f64; 2],
    /// How values become places on the horizontal axis.
    pub x_scale: Scale,
    /// Places on the horizontal axis with names, which stand there instead of numbers.
    pub x_names: Vec<(f64, String)>,
    /// First and last value of the vertical axis; `None` fits it to the series.
    pub y_range: Option<[f64; 2]>,
    /// How values become heights.
    pub y_scale: Scale,
    /// Whether a step is as long on both linear axes: a circle stays one.
    pub even: bool,
    /// Whether it stands without axes: nothing is read off them.
    pub is_bare: bool,
    /// Written after each number of the vertical axis.
    pub y_unit: String,
    /// Drawn in this order, the last on top.
    pub series: Vec<Series>,
    /// Colours along the horizontal axis, evenly spaced from its first value to its last: of
    /// coloured areas, and of a strip below the panel.
    pub colours: Vec<Ink>,
    /// Whether the strip is drawn.
    pub strip: bool,
    /// A second, lower panel that shares the horizontal axis.
    pub residual: Option<Panel>,
    /// Small lines at the bottom: where the data come from, which version drew them.
    pub notes: Vec<String>,
    /// Said in the middle of the main panel: why it is empty.
    pub blank: String,
}

impl Default for Chart {
    fn default() -> Self {
        Self {
            title: String::new(),
            x_label: String::new(),
            y_label: String::new(),
            x_range: [0.0, 1.0],
            x_scale: Scale::Linear,
            x_names: Vec::new(),
            y_range: None,
            y_scale: Scale::Linear,
            even: false,
            is_bare: false,
            y_unit: String::new(),
            series: Vec::new(),
            colours: Vec::new(),
            strip: false,
            residual: None,
            notes: Vec::new(),
            blank: String::new(),
        }
    }
}

/// The lower panel of a [`Chart`]; its vertical axis is linear.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Panel {
    /// What its vertical axis counts.
    pub y_label: String,
    /// First and last value of its vertical axis; `None` fits it to the series.
    pub y_range: Option<[f64; 2]>,
    /// Drawn in this order, the last on top.
    pub series: Vec<Series>,
}

/// How values become places on an axis.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scale {
    /// Equal differences are equal distances.
    #[default]
    Linear,
    /// Equal differences of square roots are equal distances: what is low is seen beside what
    /// towers over it. A negative value stands as far below 0 as its size stands above.
    Root,
    /// Equal ratios are equal distances; only values above 0 can be shown.
    Log10,
}

/// The colours of everything but the series.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Theme {
    /// Light text on near-black, for screens.
    Dark,
    /// Dark text on white, for paper.
    #[default]
    Light,
}

/// Data of one kind and colour.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Shown in the legend; a series with an empty name, or one that was there before, is not.
    pub name: String,
    /// What its marks are drawn in.
    pub colour: Ink,
    /// What the marks are and where they stand.
    pub marks: Marks,
    /// A word on each point (or box), shown where it is pointed at; empty or missing for none.
    pub notes: Vec<String>,
    /// Whether its name stands at its highest point too.
    pub is_tagged: bool,
}

/// A four-sided piece of a ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Its corners, one after the other around it.
    pub corners: [[f64; 2]; 4],
    /// The colour at each.
    pub colours: [Rgb; 4],
}

/// The marks of a series; each point is `[x, y]` in the units of the axes.
#[derive(Clone, Debug, PartialEq)]
pub enum Marks {
    /// A line through the points, in their order.
    Line {
        /// Corners of the line.
        points: Vec<[f64; 2]>,
        /// Thickness in px.
        width: f64,
        /// Drawn through, dashed or dotted.
        dash: Dash,
    },
    /// A vertical line with a dot on top at each point.
    Stems {
        /// The dots.
        points: Vec<[f64; 2]>,
        /// Where each stem starts; 0 where an entry is missing.
        base: Vec<f64>,
        /// A text above each dot; empty or missing for none. A second line of it is written
        /// smaller and fainter, and left out where there is no room for both.
        labels: Vec<String>,
    },
    /// The area between the points and their bases.
    Area {
        /// One border.
        points: Vec<[f64; 2]>,
        /// The value of the other border at each point; 0 where an entry is missing.
        base: Vec<f64>,
        /// Filled with the chart's colours along the horizontal axis, and opaque; else with the
        /// series' colour, thinly.
        is_coloured: bool,
    },
    /// Boxes from 0 (or the bottom of a logarithmic axis) to each point.
    Bars {
        /// Middle and height of each box.
        points: Vec<[f64; 2]>,
        /// Width of a box in the units of the horizontal axis.
        width: f64,
    },
    /// Single points.
    Points {
        /// Their middles.
        points: Vec<[f64; 2]>,
        /// Radius in px.
        radius: f64,
        /// Their form.
        shape: Shape,
    },
    /// A heat map, with a colour bar at the right of the chart.
    Cells { cells: Cells },
    /// Words at places, without marks: what lines nearby are.
    Words {
        /// Where the middle of each stands, and what it says.
        words: Vec<([f64; 2], String)>,
    },
    /// Four-sided pieces whose colours run into one another, as a ground for other series; no data.
    Ground {
        /// The pieces, each convex.
        pieces: Vec<Piece>,
    },
}

impl Marks {
    /// The points of any kind of marks; heat maps, words and a ground have none.
    pub fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Line { points, .. }
            | Self::Stems { points, .. }
            | Self::Area { points, .. }
            | Self::Bars { points, .. }
            | Self::Points { points, .. } => points,
            Self::Cells { .. } | Self::Ground { .. } | Self::Words { .. } => &[],
        }
    }

    /// Whether it has no points that a table could hold.
    pub(super) fn is_no_series(&self) -> bool {
        matches!(
            self,
            Self::Cells { .. } | Self::Ground { .. } | Self::Words { .. }
        )
    }

    /// The heat map, if it is one.
    pub fn cells(&self) -> Option<&Cells> {
        match self {
            Self::Cells { cells } => Some(cells),
            _ => None,
        }
    }

    /// All heights that the vertical axis should show.
    fn heights(&self) -> Vec<f64> {
        let tops = self.points().iter().map(|point| point[1]);
        match self {
            Self::Line { .. } | Self::Points { .. } => tops.collect(),
            Self::Stems { base, .. } | Self::Area { base, .. } => {
                let bases = (0..self.points().len()).map(|i| base_at(base, i));
                tops.chain(bases).collect()
            }
            Self::Bars { .. } => tops.chain([0.0]).collect(),
            Self::Cells { cells } => cells.y_edges.clone(),
            Self::Ground { .. } | Self::Words { .. } => Vec::new(),
        }
    }
}

/// Where the mark of a point starts; 0 where no base is given.
pub fn base_at(base: &[f64], index: usize) -> f64 {
    base.get(index).copied().unwrap_or(0.0)
}

impl Chart {
    /// An empty chart over wavelengths, from the first to the last.
    pub fn over_nm(x_range: [f64; 2]) -> Self {
        Self {
            x_label: said!("Wavelength (nm)").to_owned(),
            x_range,
            ..Self::default()
        }
    }

    /// All series: those of the main panel, then those of the lower one.
    pub fn all_series(&self) -> impl Iterator<Item = &Series> {
        let lower = self.residual.iter().flat_map(|panel| &panel.series);
        self.series.iter().chain(lower)
    }

    /// The heat map whose colours the bar explains: the first one.
    pub fn heat_map(&self) -> Option<&Cells> {
        self.series.iter().find_map(|series| series.marks.cells())
    }

    /// The colours along the horizontal axis, if there are any.
    pub(super) fn strip(&self) -> Option<&[Ink]> {
        (self.strip && !self.colours.is_empty()).then_some(&self.colours[..])
    }

    /// The name of a place on the horizontal axis: that of the nearest named one.
    pub fn name_at(&self, x: f64) -> Option<&str> {
        let off = |(at, _): &&(f64, String)| (at - x).abs();
        let nearest = self.x_names.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.map(|(_, name)| name.as_str())
    }

    /// The chart in a sentence or two, for those who cannot see it.
    pub fn description(&self) -> String {
        let or = |label: &str, otherwise: &str| {
            if label.is_empty() {
                otherwise.to_owned()
            } else {
                label.to_owned()
            }
        };
        let mut text = format!(
            "Chart of {} over {} from {} to {}.",
            or(&self.y_label, "values"),
            or(&self.x_label, "a horizontal axis"),
            short(self.x_range[0]),
            short(self.x_range[1]),
        );
        let names: Vec<&str> = self
            .legend_series()
            .into_iter()
            .map(|series| series.name.as_str())
            .collect();
        if !names.is_empty() {
            let _ = write!(text, " Shown: {}.", names.join(", "));
        }
        if let Some(cells) = self.heat_map() {
            let [low, high] = cells.limits().map(short);
            let _ = write!(
                text,
                " Coloured by {} from {low} to {high}.",
                or(&cells.label, "value")
            );
        }
        if let Some(panel) = &self.residual {
            let _ = write!(text, " Below: {}.", or(&panel.y_label, "a second panel"));
        }
        text
    }
}
