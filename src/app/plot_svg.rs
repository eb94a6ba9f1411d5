//! Charts as SVG files: lines, stems, areas, bars and points over one or two panels.
//!
//! The writer gets numbers and returns text; it knows nothing of the window. Everything is cut to
//! its panel before it is written, so the file needs no clip paths (and no ids, which would clash
//! where several charts are pasted into one page), and no number in it is far outside the picture.
//! Places that cannot be drawn (NaN, infinite, or not above 0 on a logarithmic axis) are left out
//! and break a line in two.

use std::fmt::Write as _;

use super::ticks::{extent, log_ticks, nice_ticks, short, tick_labels, without_trailing_zeros};

/// An sRGB colour, 8 bits a channel.
pub type Rgb = [u8; 3];

const TITLE_SIZE: f64 = 17.0;
const TEXT_SIZE: f64 = 12.0;
const NOTE_SIZE: f64 = 10.5;

/// Line spacing as a multiple of the font size.
const LEADING: f64 = 1.4;

/// Mean width of a letter as a multiple of the font size: that of a wide sans-serif face, because
/// the reader's font is unknown and too much room looks better than too little.
const LETTER_WIDTH: f64 = 0.58;

/// Free space around everything, px.
const MARGIN: f64 = 14.0;

/// Height of the colour strip, px, and its distance to the panel above.
const STRIP_HEIGHT: f64 = 14.0;
const STRIP_GAP: f64 = 3.0;

/// Distance between the two panels, px.
const PANEL_GAP: f64 = 16.0;

/// Length of a tick mark, px.
const TICK: f64 = 4.0;

/// Least height of a panel, px: the picture grows when titles and notes leave less.
const LEAST_PANEL: f64 = 40.0;

/// Part of the panels' height that the residual gets.
const RESIDUAL_SHARE: f64 = 0.28;

/// Numbers that are too large to subtract from one another are not drawn.
const LARGEST: f64 = 1e300;

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

/// How values become heights.
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
        /// Dashed instead of drawn through.
        dash: bool,
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
    /// Dots.
    Points {
        /// Middles of the dots.
        points: Vec<[f64; 2]>,
        /// Radius in px.
        radius: f64,
    },
}

impl Marks {
    /// The points of any kind of marks.
    pub fn points(&self) -> &[[f64; 2]] {
        match self {
            Self::Line { points, .. }
            | Self::Stems { points, .. }
            | Self::Area { points, .. }
            | Self::Bars { points, .. }
            | Self::Points { points, .. } => points,
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
        }
    }
}

impl Series {
    /// A solid line of normal thickness.
    pub fn line(name: impl Into<String>, colour: Rgb, points: Vec<[f64; 2]>) -> Self {
        let marks = Marks::Line {
            points,
            width: 1.8,
            dash: false,
        };
        Self::new(name, colour, marks)
    }

    /// A series of any kind of marks.
    pub fn new(name: impl Into<String>, colour: Rgb, marks: Marks) -> Self {
        Self {
            name: name.into(),
            colour,
            marks,
        }
    }
}

impl Chart {
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
        let below = TICK + TEXT_SIZE * LEADING + x_label_height + notes_height + MARGIN;

        let strip = self.strip.as_deref().filter(|colours| !colours.is_empty());
        let strip_height = strip.map_or(0.0, |_| STRIP_GAP + STRIP_HEIGHT);
        let gaps = strip_height + self.residual.as_ref().map_or(0.0, |_| PANEL_GAP);
        let share = self.residual.as_ref().map_or(0.0, |_| RESIDUAL_SHARE);
        let least = LEAST_PANEL / (if share > 0.0 { share } else { 1.0 });
        let panels = (asked_height - top - below - gaps).max(least);
        let height = asked_height.max(top + below + gaps + panels);

        let main_height = panels * (1.0 - share);
        let lower_height = panels * share;
        let main = Vertical::new(self.y_range, self.y_scale, &self.series, main_height);
        let lower = self.residual.as_ref().map(|panel| {
            let axis = Vertical::new(panel.y_range, Scale::Linear, &panel.series, lower_height);
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
        // The last label stands half to the right of its tick.
        let right = width - MARGIN - 14.0;
        let horizontal = Horizontal::new(self.x_range, right - left);

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
            middle.write(&mut body, [x, bottom + TICK + TEXT_SIZE], label);
        }
        if !self.x_label.is_empty() {
            let y = bottom + TICK + TEXT_SIZE * (1.0 + LEADING);
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
        let lower = self.residual.iter().flat_map(|panel| &panel.series);
        let names: Vec<&str> = unique_names(self.series.iter().chain(lower))
            .into_iter()
            .map(|series| series.name.as_str())
            .collect();
        if !names.is_empty() {
            let _ = write!(text, " Shown: {}.", names.join(", "));
        }
        if let Some(panel) = &self.residual {
            let _ = write!(text, " Below: {}.", or(&panel.y_label, "a second panel"));
        }
        text
    }

    /// Writes the legend in as many rows as it needs and returns where it ends.
    fn legend(&self, out: &mut String, palette: &Palette, top: f64, width: f64) -> f64 {
        const SAMPLE: f64 = 22.0;
        let lower = self.residual.iter().flat_map(|panel| &panel.series);
        let entries = unique_names(self.series.iter().chain(lower));
        let row_height = TEXT_SIZE * LEADING;
        let (mut x, mut y) = (0.0, top);
        for (i, series) in entries.iter().enumerate() {
            let name = clean(&series.name);
            let needed = SAMPLE + 6.0 + text_width(&name, TEXT_SIZE) + 16.0;
            if i > 0 && x + needed > width {
                (x, y) = (0.0, y + row_height);
            }
            series.sample(out, [MARGIN + x, y + row_height / 2.0], SAMPLE);
            let style = Text {
                size: TEXT_SIZE,
                colour: palette.text,
                anchor: Anchor::Start,
            };
            let at = [
                MARGIN + x + SAMPLE + 6.0,
                y + row_height / 2.0 + TEXT_SIZE * 0.36,
            ];
            style.write(out, at, &name);
            x += needed;
        }
        if entries.is_empty() {
            top
        } else {
            y + row_height
        }
    }
}

/// The first series of each name, without the nameless.
fn unique_names<'a>(all: impl Iterator<Item = &'a Series>) -> Vec<&'a Series> {
    let mut found: Vec<&Series> = Vec::new();
    for series in all {
        if !series.name.is_empty() && found.iter().all(|other| other.name != series.name) {
            found.push(series);
        }
    }
    found
}

/// The colours of a theme.
struct Palette {
    background: Rgb,
    text: Rgb,
    faint_text: Rgb,
    axis: Rgb,
    grid: Rgb,
}

impl Palette {
    /// Greys throughout, so that nothing tints the colours on show.
    fn of(theme: Theme) -> &'static Self {
        match theme {
            Theme::Dark => &Self {
                background: [24; 3],
                text: [225; 3],
                faint_text: [165; 3],
                axis: [140; 3],
                grid: [52; 3],
            },
            Theme::Light => &Self {
                background: [255; 3],
                text: [25; 3],
                faint_text: [95; 3],
                axis: [110; 3],
                grid: [226; 3],
            },
        }
    }
}

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
struct Horizontal {
    range: [f64; 2],
    length: f64,
    ticks: Vec<f64>,
    labels: Vec<String>,
}

impl Horizontal {
    fn new(range: [f64; 2], length: f64) -> Self {
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

    fn px(&self, x: f64) -> f64 {
        (x - self.range[0]) / (self.range[1] - self.range[0]) * self.length
    }
}

/// The vertical axis of a panel: values to px from its top.
struct Vertical {
    range: [f64; 2],
    scale: Scale,
    length: f64,
    ticks: Vec<f64>,
    labels: Vec<String>,
}

impl Vertical {
    fn new(range: Option<[f64; 2]>, scale: Scale, series: &[Series], length: f64) -> Self {
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

    fn px(&self, y: f64) -> f64 {
        let [low, high] = self.range;
        let part = match self.scale {
            Scale::Linear => (y - low) / (high - low),
            Scale::Log10 if y > 0.0 => (y.ln() - low.ln()) / (high.ln() - low.ln()),
            Scale::Log10 => f64::NAN,
        };
        (1.0 - part) * self.length
    }

    /// Where marks that stand on a value start: 0 has no place on a logarithmic axis.
    fn base_px(&self, base: f64) -> f64 {
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

/// Place and size of a panel in the picture, px.
struct Frame {
    left: f64,
    top: f64,
    width: f64,
    height: f64,
}

impl Frame {
    /// Writes a panel: grid, axes, marks.
    fn draw(
        &self,
        out: &mut String,
        palette: &Palette,
        horizontal: &Horizontal,
        vertical: &Vertical,
        y_label: &str,
        series: &[Series],
    ) {
        let (left, top) = (px(self.left), px(self.top));
        let (width, height) = (px(self.width), px(self.height));

        let mut grid = String::new();
        for &tick in &horizontal.ticks {
            let x = self.left + horizontal.px(tick);
            let _ = write!(grid, "M{} {top}v{height}", px(x));
        }
        for &tick in &vertical.ticks {
            let y = self.top + vertical.px(tick);
            let _ = write!(grid, "M{left} {}h{width}", px(y));
        }
        let colour = hex(palette.grid);
        let _ = writeln!(out, r#"<path d="{grid}" stroke="{colour}"/>"#);
        let axis = hex(palette.axis);
        if vertical.scale == Scale::Linear && vertical.range[0] < 0.0 && vertical.range[1] > 0.0 {
            let y = px(self.top + vertical.px(0.0));
            let _ = writeln!(out, r#"<path d="M{left} {y}h{width}" stroke="{axis}"/>"#);
        }

        let label = Text {
            size: TEXT_SIZE,
            colour: palette.text,
            anchor: Anchor::End,
        };
        for (tick, text) in vertical.ticks.iter().zip(&vertical.labels) {
            let y = self.top + vertical.px(*tick);
            let start = px(self.left - TICK);
            let _ = writeln!(
                out,
                r#"<path d="M{start} {}h{TICK}" stroke="{axis}"/>"#,
                px(y)
            );
            let at = [self.left - TICK - 3.0, y + TEXT_SIZE * 0.36];
            label.write(out, at, text);
        }
        if !y_label.is_empty() {
            let (x, y) = (MARGIN + TEXT_SIZE * 0.8, self.top + self.height / 2.0);
            let _ = writeln!(
                out,
                r#"<text transform="translate({} {}) rotate(-90)" font-size="{TEXT_SIZE}" text-anchor="middle" fill="{}">{}</text>"#,
                px(x),
                px(y),
                hex(palette.text),
                escaped(y_label),
            );
        }

        let _ = writeln!(out, r#"<g transform="translate({left} {top})">"#);
        let mut taken = Vec::new();
        for series in series {
            let _ = writeln!(out, "<g>");
            if !series.name.is_empty() {
                let _ = writeln!(out, "<title>{}</title>", escaped(&series.name));
            }
            let plot = Plot {
                horizontal,
                vertical,
                palette,
            };
            plot.marks(out, series, &mut taken);
            let _ = writeln!(out, "</g>");
        }
        let _ = writeln!(
            out,
            "</g>\n<rect x=\"{left}\" y=\"{top}\" width=\"{width}\" height=\"{height}\" stroke=\"{axis}\"/>"
        );
    }
}

/// A place in a panel, px from its top left corner.
type Place = [f64; 2];

/// The two axes that marks are placed by.
struct Plot<'a> {
    horizontal: &'a Horizontal,
    vertical: &'a Vertical,
    palette: &'a Palette,
}

impl Plot<'_> {
    fn place(&self, point: [f64; 2]) -> Option<Place> {
        let place = [self.horizontal.px(point[0]), self.vertical.px(point[1])];
        place.iter().all(|c| c.is_finite()).then_some(place)
    }

    fn size(&self) -> [f64; 2] {
        [self.horizontal.length, self.vertical.length]
    }

    /// Whether a place is in the panel; the ends of the axes count, in spite of rounding.
    fn holds(&self, place: Place) -> bool {
        let size = self.size();
        (0..2).all(|axis| (-1e-6..=size[axis] + 1e-6).contains(&place[axis]))
    }

    /// Writes the marks of a series; `taken` are the boxes of the labels written so far.
    fn marks(&self, out: &mut String, series: &Series, taken: &mut Vec<[f64; 4]>) {
        let colour = hex(series.colour);
        match &series.marks {
            Marks::Line {
                points,
                width,
                dash,
            } => {
                let path = self.line(points);
                if !path.is_empty() {
                    let stroke = stroke_attributes(*width, *dash);
                    let _ = writeln!(
                        out,
                        r#"<path d="{path}" stroke="{colour}" stroke-linejoin="round" {stroke}/>"#
                    );
                }
            }
            Marks::Stems {
                points,
                base,
                labels,
            } => {
                for (i, &point) in points.iter().enumerate() {
                    let label = labels.get(i).map_or("", String::as_str);
                    self.stem(out, &colour, point, base_at(base, i), label, taken);
                }
            }
            Marks::Area { points, base } => {
                let path = self.area(points, base);
                if !path.is_empty() {
                    let _ = writeln!(
                        out,
                        r#"<path d="{path}" fill="{colour}" fill-opacity="0.25"/>"#
                    );
                }
            }
            Marks::Bars { points, width } => {
                for &[x, y] in points {
                    self.bar(out, &colour, [x - width / 2.0, x + width / 2.0], y);
                }
            }
            Marks::Points { points, radius } => {
                let radius = px(sound_px(*radius));
                for &point in points {
                    if let Some([x, y]) = self.place(point).filter(|&place| self.holds(place)) {
                        let _ = writeln!(
                            out,
                            r#"<circle cx="{}" cy="{}" r="{radius}" fill="{colour}"/>"#,
                            px(x),
                            px(y)
                        );
                    }
                }
            }
        }
    }

    /// Path data of a line, cut to the panel and interrupted at broken points.
    fn line(&self, points: &[[f64; 2]]) -> String {
        let mut path = String::new();
        let mut pen: Option<Place> = None;
        let mut before: Option<Place> = None;
        for &point in points {
            let here = self.place(point);
            if let (Some(from), Some(to)) = (before, here)
                && let Some([start, end]) = cut_segment([from, to], self.size())
            {
                if pen != Some(start) {
                    let _ = write!(path, "M{} {}", px(start[0]), px(start[1]));
                }
                let _ = write!(path, "L{} {}", px(end[0]), px(end[1]));
                pen = Some(end);
            }
            before = here;
        }
        path
    }

    /// Path data of the area between points and bases, one ring for each unbroken run.
    fn area(&self, points: &[[f64; 2]], base: &[f64]) -> String {
        let mut path = String::new();
        let (mut there, mut back): (Vec<Place>, Vec<Place>) = Default::default();
        for i in 0..=points.len() {
            let pair = points.get(i).and_then(|&point| {
                let top = self.place(point)?;
                let foot = self.vertical.base_px(base_at(base, i));
                foot.is_finite().then_some((top, [top[0], foot]))
            });
            if let Some((top, foot)) = pair {
                there.push(top);
                back.push(foot);
                continue;
            }
            there.extend(back.drain(..).rev());
            for (k, corner) in cut_ring(&there, self.size()).iter().enumerate() {
                let step = if k == 0 { 'M' } else { 'L' };
                let _ = write!(path, "{step}{} {}", px(corner[0]), px(corner[1]));
            }
            if !path.is_empty() && !path.ends_with('Z') {
                path.push('Z');
            }
            there.clear();
        }
        path
    }

    fn bar(&self, out: &mut String, colour: &str, sides: [f64; 2], value: f64) {
        let [width, height] = self.size();
        let sides = sides.map(|x| self.horizontal.px(x));
        let ends = [self.vertical.base_px(0.0), self.vertical.px(value)];
        if sides.iter().chain(&ends).any(|c| !c.is_finite()) {
            return;
        }
        let sides = sides.map(|x| x.clamp(0.0, width));
        let ends = ends.map(|y| y.clamp(0.0, height));
        let size = [sides[1] - sides[0], ends[1] - ends[0]].map(f64::abs);
        if size.iter().all(|&side| side > 0.0) {
            let _ = writeln!(
                out,
                r#"<rect x="{}" y="{}" width="{}" height="{}" fill="{colour}" fill-opacity="0.85"/>"#,
                px(sides[0].min(sides[1])),
                px(ends[0].min(ends[1])),
                px(size[0]),
                px(size[1]),
            );
        }
    }

    fn stem(
        &self,
        out: &mut String,
        colour: &str,
        point: [f64; 2],
        base: f64,
        label: &str,
        taken: &mut Vec<[f64; 4]>,
    ) {
        let Some(top) = self.place(point) else {
            return;
        };
        let foot = self.vertical.base_px(base);
        if !foot.is_finite() {
            return;
        }
        let Some([from, to]) = cut_segment([[top[0], foot], top], self.size()) else {
            return;
        };
        let tip = format!("{}, {}", short(point[0]), short(point[1]));
        let tip = if label.is_empty() {
            tip
        } else {
            format!("{label}: {tip}")
        };
        let _ = writeln!(out, "<g>\n<title>{}</title>", escaped(&tip));
        let _ = writeln!(
            out,
            r#"<path d="M{} {}V{}" stroke="{colour}" stroke-width="1.6"/>"#,
            px(from[0]),
            px(from[1]),
            px(to[1])
        );
        if self.holds(top) {
            let _ = writeln!(
                out,
                r#"<circle cx="{}" cy="{}" r="3" fill="{colour}"/>"#,
                px(top[0]),
                px(top[1])
            );
        }
        if !label.is_empty() {
            self.stem_label(out, to, label, taken);
        }
        let _ = writeln!(out, "</g>");
    }

    /// Writes a label above a place, or a little higher where another label is in the way.
    ///
    /// A label that finds no free place in a few rows is left out: it would cover others, and the
    /// stem still has it as its tooltip.
    fn stem_label(&self, out: &mut String, place: Place, label: &str, taken: &mut Vec<[f64; 4]>) {
        const ROWS: usize = 4;
        let label = clean(label);
        let half = text_width(&label, NOTE_SIZE) / 2.0;
        let [width, _] = self.size();
        let x = if width > 2.0 * half {
            place[0].clamp(half, width - half)
        } else {
            width / 2.0
        };
        for row in 0..ROWS {
            let baseline = place[1] - 6.0 - row as f64 * NOTE_SIZE * 1.2;
            // Labels of the highest stems go below the panel's upper edge.
            let baseline = baseline.max(NOTE_SIZE + 2.0);
            let covers = [x - half, baseline - NOTE_SIZE, x + half, baseline + 1.0];
            let clear = |other: &[f64; 4]| {
                covers[0] > other[2]
                    || covers[2] < other[0]
                    || covers[1] > other[3]
                    || covers[3] < other[1]
            };
            if taken.iter().all(clear) {
                taken.push(covers);
                // A rim in the background colour keeps the text legible over lines.
                let rim = hex(self.palette.background);
                let _ = writeln!(
                    out,
                    r#"<g stroke="{rim}" stroke-width="3" stroke-linejoin="round" paint-order="stroke">"#
                );
                let style = Text {
                    size: NOTE_SIZE,
                    colour: self.palette.text,
                    anchor: Anchor::Middle,
                };
                style.write(out, [x, baseline], &label);
                let _ = writeln!(out, "</g>");
                return;
            }
        }
    }
}

impl Series {
    /// Writes what the series looks like into the legend: `at` is the left end of its middle.
    fn sample(&self, out: &mut String, at: Place, length: f64) {
        let colour = hex(self.colour);
        let [x, y] = at;
        let dot = |radius: f64| {
            let (x, y) = (px(x + length / 2.0), px(y));
            format!(
                r#"<circle cx="{x}" cy="{y}" r="{}" fill="{colour}"/>"#,
                px(radius)
            )
        };
        let block = |opacity: f64| {
            let (x, y) = (px(x), px(y - 5.0));
            format!(
                r#"<rect x="{x}" y="{y}" width="{}" height="10" fill="{colour}" fill-opacity="{opacity}"/>"#,
                px(length)
            )
        };
        let sample = match &self.marks {
            Marks::Line { width, dash, .. } => {
                let stroke = stroke_attributes(*width, *dash);
                let (x, y, length) = (px(x), px(y), px(length));
                format!(r#"<path d="M{x} {y}h{length}" stroke="{colour}" {stroke}/>"#)
            }
            Marks::Stems { .. } => {
                let (x, foot, top) = (px(x + length / 2.0), px(y + 6.0), px(y - 4.0));
                format!(
                    r#"<path d="M{x} {foot}V{top}" stroke="{colour}" stroke-width="1.6"/><circle cx="{x}" cy="{top}" r="3" fill="{colour}"/>"#
                )
            }
            Marks::Area { .. } => block(0.4),
            Marks::Bars { .. } => block(0.85),
            Marks::Points { radius, .. } => dot(sound_px(*radius).min(5.0)),
        };
        let _ = writeln!(out, "{sample}");
    }
}

/// Writes colours as a row of boxes.
///
/// The first colour belongs to the left end and the last to the right end, so each box reaches
/// from half way to its left neighbour to half way to its right one. Equal neighbours are one box.
fn draw_strip(out: &mut String, at: Place, width: f64, colours: &[Rgb]) {
    let steps = (colours.len() - 1).max(1) as f64;
    let border = |i: usize| ((i as f64 - 0.5) / steps).clamp(0.0, 1.0) * width;
    let _ = writeln!(out, r#"<g shape-rendering="crispEdges">"#);
    let mut first = 0;
    for run in colours.chunk_by(|a, b| a == b) {
        let end = first + run.len();
        let from = border(first);
        // Up to the right end, so that no rounding leaves a gap; the next boxes go on top.
        let _ = writeln!(
            out,
            r#"<rect x="{}" y="{}" width="{}" height="{STRIP_HEIGHT}" fill="{}"/>"#,
            px(at[0] + from),
            px(at[1]),
            px(width - from),
            hex(run[0]),
        );
        first = end;
    }
    let _ = writeln!(out, "</g>");
}

/// The part of a segment inside the box from the origin to `size` (Liang and Barsky's method).
fn cut_segment(ends: [Place; 2], size: [f64; 2]) -> Option<[Place; 2]> {
    let [from, to] = ends;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for axis in 0..2 {
        let step = to[axis] - from[axis];
        let (to_low, to_high) = (-from[axis], size[axis] - from[axis]);
        if step == 0.0 {
            if to_low > 0.0 || to_high < 0.0 {
                return None;
            }
            continue;
        }
        let (a, b) = (to_low / step, to_high / step);
        enter = enter.max(a.min(b));
        leave = leave.min(a.max(b));
    }
    if enter > leave {
        return None;
    }
    let at = |part: f64, end: Place| {
        let along = |axis: usize| {
            // The ends themselves, unchanged, so that consecutive segments meet exactly.
            let value = if part == 0.0 || part == 1.0 {
                end[axis]
            } else {
                from[axis] + (to[axis] - from[axis]) * part
            };
            value.clamp(0.0, size[axis])
        };
        [along(0), along(1)]
    };
    let cut = [at(enter, from), at(leave, to)];
    cut.iter().flatten().all(|c| c.is_finite()).then_some(cut)
}

/// The part of a closed ring inside the box from the origin to `size` (Sutherland and Hodgman).
fn cut_ring(ring: &[Place], size: [f64; 2]) -> Vec<Place> {
    let mut ring = ring.to_vec();
    for axis in 0..2 {
        for (limit, sign) in [(0.0, 1.0), (size[axis], -1.0)] {
            // How far inside this side of the box, negative outside.
            let depth = |place: Place| (place[axis] - limit) * sign;
            let mut kept = Vec::with_capacity(ring.len() + 4);
            for (i, &to) in ring.iter().enumerate() {
                let from = ring[(i + ring.len() - 1) % ring.len()];
                let (a, b) = (depth(from), depth(to));
                if (a < 0.0) != (b < 0.0) {
                    let part = a / (a - b);
                    let mut crossing = [0, 1].map(|k| from[k] + (to[k] - from[k]) * part);
                    crossing[axis] = limit;
                    if crossing.iter().all(|c| c.is_finite()) {
                        kept.push(crossing);
                    }
                }
                if b >= 0.0 {
                    kept.push(to);
                }
            }
            ring = kept;
        }
    }
    ring
}

fn base_at(base: &[f64], index: usize) -> f64 {
    base.get(index).copied().unwrap_or(0.0)
}

/// A thickness or radius that can be drawn.
fn sound_px(size: f64) -> f64 {
    if size.is_finite() {
        size.clamp(0.1, 50.0)
    } else {
        1.0
    }
}

fn stroke_attributes(width: f64, dash: bool) -> String {
    let width = px(sound_px(width));
    let dash = if dash {
        r#" stroke-dasharray="6 4""#
    } else {
        ""
    };
    format!(r#"stroke-width="{width}"{dash}"#)
}

/// A length or coordinate with at most two decimals.
fn px(length: f64) -> String {
    let digits = format!("{length:.2}");
    let digits = without_trailing_zeros(&digits);
    if digits == "-0" { "0" } else { digits }.to_owned()
}

fn hex([r, g, b]: Rgb) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Which part of a text stands at its place.
enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text is written.
struct Text {
    size: f64,
    colour: Rgb,
    anchor: Anchor,
}

impl Text {
    /// Writes a line of text with its baseline at a place.
    fn write(&self, out: &mut String, at: Place, text: &str) {
        let anchor = match self.anchor {
            Anchor::Start => "",
            Anchor::Middle => r#" text-anchor="middle""#,
            Anchor::End => r#" text-anchor="end""#,
        };
        let _ = writeln!(
            out,
            r#"<text x="{}" y="{}" font-size="{}"{anchor} fill="{}">{}</text>"#,
            px(at[0]),
            px(at[1]),
            px(self.size),
            hex(self.colour),
            escaped(text)
        );
    }
}

/// Estimated width of a text, px.
fn text_width(text: &str, size: f64) -> f64 {
    text.chars().count() as f64 * size * LETTER_WIDTH
}

/// A text as lines that are no wider than `width` px, broken at spaces; words are left whole.
fn wrap(text: &str, width: f64, size: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in clean(text).split_whitespace() {
        match lines.last_mut() {
            Some(line) if text_width(line, size) + text_width(word, size) + size < width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A text on one line, without the characters that XML 1.0 forbids.
fn clean(text: &str) -> String {
    let sound = |c: char| match c {
        '\t' | '\n' | '\r' => ' ',
        '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => char::REPLACEMENT_CHARACTER,
        c => c,
    };
    text.chars().map(sound).collect()
}

/// A text as it stands between tags.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in clean(text).chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&apos;"),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: Rgb = [200, 30, 20];

    /// Parses a chart and checks what must hold for every one of them.
    fn checked(chart: &Chart) -> String {
        let svg = chart.to_svg(640, 400);
        let document = roxmltree::Document::parse(&svg).unwrap();
        for node in document.descendants() {
            for attribute in node.attributes() {
                let value = attribute.value();
                assert!(!value.contains("NaN") && !value.contains("inf"), "{value}");
                if attribute.name() != "d" {
                    continue;
                }
                let numbers = value.split(|c: char| c.is_ascii_alphabetic() || c == ' ');
                for number in numbers.filter(|number| !number.is_empty()) {
                    let number: f64 = number.parse().unwrap();
                    assert!((-1.0..=2000.0).contains(&number), "{number} in {value}");
                }
            }
        }
        assert_eq!(document.root_element().tag_name().name(), "svg");
        svg
    }

    fn texts(svg: &str) -> Vec<String> {
        let document = roxmltree::Document::parse(svg).unwrap();
        let texts = document.descendants().filter(|n| n.has_tag_name("text"));
        texts.filter_map(|n| n.text().map(str::to_owned)).collect()
    }

    fn one(marks: Marks) -> Chart {
        Chart {
            series: vec![Series::new("data", RED, marks)],
            ..Chart::default()
        }
    }

    fn line(points: &[[f64; 2]]) -> Chart {
        Chart {
            series: vec![Series::line("data", RED, points.to_vec())],
            ..Chart::default()
        }
    }

    /// Path data of the first thing drawn in the chart's colour, after the legend's sample.
    fn drawn(svg: &str) -> String {
        let document = roxmltree::Document::parse(svg).unwrap();
        let group = document
            .descendants()
            .find(|n| n.has_tag_name("g") && n.children().any(|c| c.has_tag_name("title")));
        let path = group.and_then(|g| g.children().find(|n| n.has_tag_name("path")));
        let data = path.and_then(|n| n.attribute("d").map(str::to_owned));
        data.unwrap_or_default()
    }

    #[test]
    fn names_labels_and_notes_are_in_the_file() {
        let chart = Chart {
            title: "Fluorescent lamp".into(),
            x_label: "Wavelength (nm)".into(),
            y_label: "Power".into(),
            x_range: [380.0, 780.0],
            series: vec![Series::line(
                "measured",
                RED,
                vec![[380.0, 0.0], [780.0, 1.0]],
            )],
            strip: Some(vec![[0, 0, 255], [0, 255, 0], [255, 0, 0]]),
            residual: Some(Panel {
                y_label: "Residual".into(),
                series: vec![Series::line(
                    "difference",
                    RED,
                    vec![[400.0, -0.1], [700.0, 0.1]],
                )],
                ..Panel::default()
            }),
            notes: vec!["Source: a table".into()],
            ..Chart::default()
        };
        let texts = texts(&checked(&chart));
        for expected in [
            "Fluorescent lamp",
            "Wavelength (nm)",
            "Power",
            "measured",
            "difference",
            "Residual",
            "Source: a table",
            "400",
            "750",
            "0.0",
            "1.0",
        ] {
            assert!(texts.iter().any(|text| text == expected), "{expected}");
        }
    }

    #[test]
    fn text_with_markup_comes_back_as_it_was() {
        let odd = "a <b> & \"c\" 'd'";
        let mut chart = line(&[[0.0, 0.0], [1.0, 1.0]]);
        chart.title = odd.into();
        chart.notes = vec!["null \u{0} and bell \u{7}".into()];
        chart.series[0].name = odd.into();
        let svg = checked(&chart);
        assert_eq!(texts(&svg).iter().filter(|text| *text == odd).count(), 2);
        let document = roxmltree::Document::parse(&svg).unwrap();
        let title = document.descendants().find(|n| n.has_tag_name("title"));
        assert_eq!(title.unwrap().text(), Some(odd));
    }

    #[test]
    fn charts_without_data_are_still_charts() {
        checked(&Chart::default());
        checked(&line(&[]));
        checked(&line(&[[0.5, 0.5]]));
        checked(&Chart {
            strip: Some(Vec::new()),
            residual: Some(Panel::default()),
            y_scale: Scale::Log10,
            theme: Theme::Dark,
            ..Chart::default()
        });
    }

    #[test]
    fn flat_data_get_a_range_around_them() {
        for level in [0.0, 5.0, -3e-9, 1e12, 1e300] {
            let chart = line(&[[0.0, level], [1.0, level]]);
            let svg = checked(&chart);
            assert!(!drawn(&svg).is_empty(), "level {level}");
            let log = Chart {
                y_scale: Scale::Log10,
                y_range: Some([level, level]),
                ..chart
            };
            checked(&log);
        }
    }

    #[test]
    fn huge_tiny_and_broken_numbers_stay_inside() {
        let numbers = [
            0.0,
            1.0,
            -1.0,
            1e-300,
            5e-324,
            1e300,
            -1e308,
            1e308,
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
        ];
        let mut points = Vec::new();
        for x in numbers {
            for y in numbers {
                points.push([x, y]);
            }
        }
        let base: Vec<f64> = numbers.into_iter().cycle().take(points.len()).collect();
        let all = [
            Marks::Line {
                points: points.clone(),
                width: f64::NAN,
                dash: true,
            },
            Marks::Stems {
                points: points.clone(),
                base: base.clone(),
                labels: vec!["Hg".into(); 50],
            },
            Marks::Area {
                points: points.clone(),
                base,
            },
            Marks::Bars {
                points: points.clone(),
                width: 0.1,
            },
            Marks::Points {
                points,
                radius: f64::INFINITY,
            },
        ];
        for marks in all {
            for y_scale in [Scale::Linear, Scale::Log10] {
                for low in numbers {
                    for high in numbers {
                        for y_range in [None, Some([low, high])] {
                            checked(&Chart {
                                x_range: [low, high],
                                y_range,
                                y_scale,
                                ..one(marks.clone())
                            });
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn a_broken_point_breaks_the_line() {
        let svg = checked(&line(&[
            [0.0, 0.0],
            [0.2, 1.0],
            [0.4, f64::NAN],
            [0.6, 1.0],
            [1.0, 0.0],
        ]));
        assert_eq!(drawn(&svg).matches('M').count(), 2);
    }

    #[test]
    fn lines_are_cut_where_they_leave_the_panel() {
        let size = [10.0, 10.0];
        let cut = cut_segment([[-5.0, 5.0], [15.0, 5.0]], size);
        assert_eq!(cut, Some([[0.0, 5.0], [10.0, 5.0]]));
        assert_eq!(cut_segment([[-5.0, -1.0], [15.0, -1.0]], size), None);
        assert_eq!(
            cut_segment([[-4.0, 5.0], [5.0, -4.0]], size).map(|c| c[0]),
            Some([0.0, 1.0])
        );
        let inside = [[1.0, 2.0], [3.0, 4.0]];
        assert_eq!(cut_segment(inside, size), Some(inside));
    }

    #[test]
    fn areas_keep_their_part_inside_the_panel() {
        // A triangle whose tip is above the panel becomes a trapezium of known area.
        let ring = cut_ring(&[[0.0, 10.0], [5.0, -10.0], [10.0, 10.0]], [10.0, 10.0]);
        let next = |i: usize| ring[(i + 1) % ring.len()];
        let doubled: f64 = (0..ring.len())
            .map(|i| ring[i][0] * next(i)[1] - next(i)[0] * ring[i][1])
            .sum();
        // Bases 10 and 5, height 10; all in short binary fractions, so equality holds.
        assert_eq!(doubled.abs() / 2.0, 75.0);
    }

    #[test]
    fn log_axes_place_decades_evenly() {
        let axis = Vertical::new(Some([1.0, 100.0]), Scale::Log10, &[], 200.0);
        assert!((axis.px(10.0) - 100.0).abs() < 1e-9);
        assert!(axis.px(0.0).is_nan());
        assert_eq!(axis.base_px(0.0), 200.0);
        assert!(axis.labels.contains(&"10".to_owned()));
    }

    #[test]
    fn the_strip_gives_its_end_colours_half_a_step() {
        let mut out = String::new();
        draw_strip(&mut out, [0.0, 0.0], 100.0, &[[1; 3], [2; 3], [3; 3]]);
        let starts: Vec<bool> = [r#"x="0""#, r#"x="25""#, r#"x="75""#]
            .map(|start| out.contains(start))
            .to_vec();
        assert_eq!(starts, [true; 3]);
    }

    #[test]
    fn labels_of_close_stems_do_not_cover_each_other() {
        let points: Vec<[f64; 2]> = (0..30).map(|i| [f64::from(i) / 300.0, 0.5]).collect();
        let labels = (0..30).map(|i| format!("line {i}")).collect();
        let svg = checked(&one(Marks::Stems {
            points,
            base: vec![],
            labels,
        }));
        let written = texts(&svg).iter().filter(|t| t.starts_with("line")).count();
        assert!((1..30).contains(&written), "{written} labels");
        // All thirty are there as tooltips.
        assert_eq!(svg.matches("<title>line").count(), 30);
    }

    #[test]
    fn the_picture_grows_rather_than_lose_its_panels() {
        let chart = Chart {
            notes: vec!["note".into(); 40],
            ..line(&[[0.0, 0.0], [1.0, 1.0]])
        };
        let svg = checked(&chart);
        let document = roxmltree::Document::parse(&svg).unwrap();
        let height: f64 = document
            .root_element()
            .attribute("height")
            .unwrap()
            .parse()
            .unwrap();
        assert!(height > 500.0, "{height}");
    }
}
