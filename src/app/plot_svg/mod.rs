//! Charts as data, as SVG files and as tables: lines, stems, areas, bars, points and heat maps
//! over one or two panels.
//!
//! The writer gets numbers and returns text; it knows nothing of the window. Everything is cut to
//! its panel before it is written, so the file needs no clip paths (and no ids, which would clash
//! where several charts are pasted into one page), and no number in it is far outside the picture.
//! Places that cannot be drawn (NaN, infinite, or not above 0 on a logarithmic axis) are left out
//! and break a line in two.

mod axes;
mod cells;
mod cut;
mod legend;
mod marks;
mod palette;
mod panel;
mod ramp;
mod shape;
mod strip;
mod table;
#[cfg(test)]
mod tests;
mod text;

use std::fmt::Write as _;

use super::ticks::short;
use axes::{Horizontal, SLANT, Vertical};
use cells::{bar_room, draw_bar};
use palette::{Palette, hex};
use panel::Frame;
use strip::{STRIP_HEIGHT, draw_strip};
use text::{
    Anchor, LEADING, NOTE_SIZE, TEXT_SIZE, TITLE_SIZE, Text, clean, escaped, px, text_width, wrap,
};

pub use cells::Cells;
pub use cut::cut_segment;
pub use ramp::ramp_colour;
pub use shape::{Dash, Shape};

/// An sRGB colour, 8 bits a channel.
pub type Rgb = [u8; 3];

/// Free space around everything, px.
const MARGIN: f64 = 14.0;

/// Distance of the colour strip to the panel above, px.
const STRIP_GAP: f64 = 3.0;

/// Distance between the two panels, px.
const PANEL_GAP: f64 = 16.0;

/// Length of a tick mark, px.
const TICK: f64 = 4.0;

/// Least height of a panel, px: the picture grows when titles and notes leave less.
const LEAST_PANEL: f64 = 40.0;

/// Part of the panels' height that the residual gets.
const RESIDUAL_SHARE: f64 = 0.28;

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
    /// Drawn in this order, the last on top.
    pub series: Vec<Series>,
    /// Colours along the horizontal axis, evenly spaced from its first value to its last.
    pub strip: Option<Vec<Rgb>>,
    /// A second, lower panel that shares the horizontal axis.
    pub residual: Option<Panel>,
    /// Small lines at the bottom: where the data come from, which version drew them.
    pub notes: Vec<String>,
    /// Dark or light background.
    pub theme: Theme,
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
            series: Vec::new(),
            strip: None,
            residual: None,
            notes: Vec::new(),
            theme: Theme::Light,
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
    /// Colour of its marks.
    pub colour: Rgb,
    /// What the marks are and where they stand.
    pub marks: Marks,
    /// A word on each point (or box), shown where it is pointed at; empty or missing for none.
    pub notes: Vec<String>,
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
        /// A text above each dot; empty or missing for none.
        labels: Vec<String>,
    },
    /// The area between the points and their bases.
    Area {
        /// One border.
        points: Vec<[f64; 2]>,
        /// The value of the other border at each point; 0 where an entry is missing.
        base: Vec<f64>,
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
    Cells {
        /// The boxes and their values.
        cells: Cells,
    },
}

impl Marks {
    /// The points of any kind of marks; a heat map has none.
    pub fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Line { points, .. }
            | Self::Stems { points, .. }
            | Self::Area { points, .. }
            | Self::Bars { points, .. }
            | Self::Points { points, .. } => points,
            Self::Cells { .. } => &[],
        }
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
        }
    }
}

impl Series {
    /// A solid line of normal thickness.
    pub fn line(name: impl Into<String>, colour: Rgb, points: Vec<[f64; 2]>) -> Self {
        let marks = Marks::Line {
            points,
            width: 1.8,
            dash: Dash::Solid,
        };
        Self::new(name, colour, marks)
    }

    /// Points of normal size.
    pub fn points(
        name: impl Into<String>,
        colour: Rgb,
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

    /// Boxes of a width in units of the horizontal axis.
    pub fn bars(name: impl Into<String>, colour: Rgb, width: f64, points: Vec<[f64; 2]>) -> Self {
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

    /// The same with a word on each point.
    #[must_use]
    pub fn with_notes(mut self, notes: Vec<String>) -> Self {
        self.notes = notes;
        self
    }

    /// A series of any kind of marks.
    pub fn new(name: impl Into<String>, colour: Rgb, marks: Marks) -> Self {
        Self {
            name: name.into(),
            colour,
            marks,
            notes: Vec::new(),
        }
    }
}

/// Where the mark of a point starts; 0 where no base is given.
pub fn base_at(base: &[f64], index: usize) -> f64 {
    base.get(index).copied().unwrap_or(0.0)
}

impl Chart {
    /// All series: those of the main panel, then those of the lower one.
    pub fn all_series(&self) -> impl Iterator<Item = &Series> {
        let lower = self.residual.iter().flat_map(|panel| &panel.series);
        self.series.iter().chain(lower)
    }

    /// The heat map whose colours the bar explains: the first one.
    pub fn heat_map(&self) -> Option<&Cells> {
        self.series.iter().find_map(|series| series.marks.cells())
    }

    /// The name of a place on the horizontal axis: that of the nearest named one.
    pub fn name_at(&self, x: f64) -> Option<&str> {
        let off = |(at, _): &&(f64, String)| (at - x).abs();
        let nearest = self.x_names.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        nearest.map(|(_, name)| name.as_str())
    }

    /// The chart as an SVG document of the given size in px (at least 160 x 120).
    ///
    /// The document is higher than asked where titles and notes leave no room for the panels.
    pub fn to_svg(&self, width: u32, height: u32) -> String {
        let width = f64::from(width.max(160));
        let asked_height = f64::from(height.max(120));
        let palette = Palette::of(self.theme);
        let inner = width - 2.0 * MARGIN;

        let mut body = String::new();
        let mut y = MARGIN;
        for line in wrap(&self.title, inner, TITLE_SIZE) {
            y += TITLE_SIZE;
            let style = Text {
                size: TITLE_SIZE,
                colour: palette.text,
                anchor: Anchor::Start,
            };
            style.write(&mut body, [MARGIN, y], &line);
            y += TITLE_SIZE * (LEADING - 1.0);
        }
        y = self.legend(&mut body, palette, y + 2.0, inner);
        let top = y + 8.0;

        let notes: Vec<String> = self.notes.iter().map(|note| clean(note)).collect();
        let notes: Vec<String> = notes
            .iter()
            .flat_map(|note| wrap(note, inner, NOTE_SIZE))
            .collect();
        let notes_height = match notes.len() {
            0 => 0.0,
            lines => lines as f64 * NOTE_SIZE * LEADING + 6.0,
        };
        let x_label_height = if self.x_label.is_empty() {
            0.0
        } else {
            TEXT_SIZE * LEADING
        };
        // How long the axis will be is known only when the panels' height is: names are measured
        // on a shorter one.
        let labels_height = Horizontal::new(self, 0.85 * inner).label_height();
        let below = TICK + labels_height + x_label_height + notes_height + MARGIN;

        let strip = self.strip.as_deref().filter(|colours| !colours.is_empty());
        let strip_height = strip.map_or(0.0, |_| STRIP_GAP + STRIP_HEIGHT);
        let gaps = strip_height + self.residual.as_ref().map_or(0.0, |_| PANEL_GAP);
        let share = self.residual.as_ref().map_or(0.0, |_| RESIDUAL_SHARE);
        let least = LEAST_PANEL / (if share > 0.0 { share } else { 1.0 });
        let panels = (asked_height - top - below - gaps).max(least);
        let height = asked_height.max(top + below + gaps + panels);

        let main_height = panels * (1.0 - share);
        let lower_height = panels * share;
        let main = Vertical::new(self.y_limits(), self.y_scale, main_height);
        let lower = self.residual.as_ref().map(|panel| {
            let axis = Vertical::new(panel.y_limits(), Scale::Linear, lower_height);
            (panel, axis)
        });

        let widest = lower
            .iter()
            .map(|(_, axis)| axis)
            .chain([&main])
            .flat_map(|axis| &axis.labels)
            .map(|label| text_width(label, TEXT_SIZE))
            .fold(0.0, f64::max);
        let left = (MARGIN + TEXT_SIZE * LEADING + widest + TICK + 4.0).min(width * 0.4);
        let map = self.heat_map();
        let bar = map.map_or(0.0, |cells| bar_room(cells, main_height));
        // The last label stands half to the right of its tick.
        let right = (width - MARGIN - bar.max(14.0)).max(left + 0.2 * width);
        let overhang = Horizontal::new(self, right - left).label_overhang();
        let left = left.max((MARGIN + overhang).min(width * 0.4));
        let horizontal = Horizontal::new(self, right - left);

        let mut frame = Frame {
            left,
            top,
            width: right - left,
            height: main_height,
        };
        frame.draw(
            &mut body,
            palette,
            &horizontal,
            &main,
            &self.y_label,
            &self.series,
        );
        if let Some(cells) = map {
            draw_bar(&mut body, palette, cells, [right, top], main_height, bar);
        }
        let mut bottom = top + main_height;
        if let Some(colours) = strip {
            bottom += STRIP_GAP;
            draw_strip(&mut body, [left, bottom], right - left, colours);
            bottom += STRIP_HEIGHT;
        }
        if let Some((panel, axis)) = &lower {
            frame.top = bottom + PANEL_GAP;
            frame.height = lower_height;
            frame.draw(
                &mut body,
                palette,
                &horizontal,
                axis,
                &panel.y_label,
                &panel.series,
            );
            bottom = frame.top + lower_height;
        }

        let middle = Text {
            size: TEXT_SIZE,
            colour: palette.text,
            anchor: Anchor::Middle,
        };
        for (at, label) in horizontal.ticks.iter().zip(&horizontal.labels) {
            let x = left + horizontal.px(*at);
            let _ = writeln!(
                body,
                r#"<path d="M{} {}v{TICK}" stroke="{}"/>"#,
                px(x),
                px(bottom),
                hex(palette.axis),
            );
            if horizontal.slanted {
                let _ = writeln!(
                    body,
                    r#"<text transform="translate({} {}) rotate(-{SLANT})" font-size="{TEXT_SIZE}" text-anchor="end" fill="{}">{}</text>"#,
                    px(x + 4.0),
                    px(bottom + TICK + TEXT_SIZE * 0.8),
                    hex(palette.text),
                    escaped(label),
                );
            } else {
                middle.write(&mut body, [x, bottom + TICK + TEXT_SIZE], label);
            }
        }
        if !self.x_label.is_empty() {
            let y = bottom + TICK + labels_height + TEXT_SIZE;
            middle.write(&mut body, [(left + right) / 2.0, y], &clean(&self.x_label));
        }
        let first_note = height - MARGIN - notes_height + NOTE_SIZE + 6.0;
        for (i, note) in notes.iter().enumerate() {
            let style = Text {
                size: NOTE_SIZE,
                colour: palette.faint_text,
                anchor: Anchor::Start,
            };
            let y = first_note + i as f64 * NOTE_SIZE * LEADING;
            style.write(&mut body, [MARGIN, y], note);
        }

        let (width, height) = (px(width), px(height.ceil()));
        let title = escaped(&self.title);
        let description = escaped(&self.description());
        let background = hex(palette.background);
        format!(
            r#"<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{width}" height="{height}" viewBox="0 0 {width} {height}" font-family="sans-serif" fill="none">
<title>{title}</title>
<desc>{description}</desc>
<rect width="{width}" height="{height}" fill="{background}"/>
{body}</svg>
"#
        )
    }

    /// The chart in a sentence or two, for those who cannot see it.
    fn description(&self) -> String {
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
