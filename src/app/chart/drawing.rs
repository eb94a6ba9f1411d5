//! The one drawing of a chart: where its parts stand, and what they are drawn of. A file writes
//! the primitives as SVG, the window paints them.

use super::{
    Chart, Panel, Rgb, Scale,
    axis::Axis,
    legend::legend_fields,
    looks::Looks,
    palette::Palette,
    plot::Plot,
    primitive::{Anchor, Field, Place, Primitive, Text},
    text::{LEADING, text_width, widest, wrap},
};

/// Free space around everything in a file, px.
pub(super) const MARGIN: f64 = 14.0;

/// Font size of a title, px.
const TITLE_SIZE: f64 = 16.0;

/// Distance of what stands over a panel: the highest number reaches half beyond, px.
pub(super) const LIFT: f64 = 5.0;

/// Length of a tick mark, px.
pub(super) const TICK: f64 = 3.0;

/// Least height of a panel, px: the picture grows when titles and notes leave less.
const LEAST_PANEL: f64 = 40.0;

/// Part of the panels' height that the lower one gets.
const LOWER_SHARE: f64 = 0.25;

/// Slant of names that do not fit side by side, degrees.
pub(super) const SLANT: f64 = 35.0;

/// Longest name of a place, letters.
pub(super) const LONGEST_NAME: usize = 24;

/// Distance of a colour bar to its panel, and its width, px.
pub(super) const BAR: f64 = 14.0;

/// The part of a chart's axes that is shown: first and last value of each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The horizontal axis.
    pub x: [f64; 2],
    /// The vertical axis of the main panel.
    pub y: [f64; 2],
}

impl Chart {
    /// Everything.
    pub fn whole_view(&self) -> View {
        View {
            x: self.x_limits(),
            y: self.y_limits(),
        }
    }
}

/// A chart laid out for a size.
#[derive(Debug)]
pub struct Drawing<'a> {
    /// What is drawn.
    pub chart: &'a Chart,
    pub(super) looks: Looks,
    /// Its colours along the horizontal axis, in its theme.
    pub(super) colours: Vec<Rgb>,
    /// Width and height of the picture, px: higher than asked where nothing else would leave the
    /// panels any room.
    pub size: [f64; 2],
    /// The main panel.
    pub main: Field,
    /// The lower panel.
    pub lower: Option<Field>,
    /// Where each entry of [`Chart::legend_series`] stands.
    pub legend: Vec<Field>,
    title: Vec<String>,
    notes: Vec<String>,
    /// Upper end of the horizontal axis's labels, and their height.
    pub(super) foot: f64,
    pub(super) labels: f64,
    pub(super) slanted: bool,
}

impl<'a> Drawing<'a> {
    /// Lays a chart out for a width and height in px.
    pub fn new(chart: &'a Chart, [width, height]: [f64; 2], looks: Looks) -> Self {
        let line = looks.line_height();
        let margin = if looks.whole { MARGIN } else { 0.0 };
        let inner = width - 2.0 * margin;
        let (mut title, mut notes) = (Vec::new(), Vec::new());
        if looks.whole {
            title = wrap(&chart.title, inner, TITLE_SIZE);
            let wrapped = |note: &String| wrap(note, inner, looks.small());
            notes = chart.notes.iter().flat_map(wrapped).collect();
        }
        let top = margin + title.len() as f64 * TITLE_SIZE * LEADING;
        let legend = match looks.legend {
            true => legend_fields(chart, [margin, top], inner, looks),
            false => Vec::new(),
        };
        let top = legend.last().map_or(top, |last| last.bottom() + 2.0);
        let bar_label = chart.heat_map().is_some_and(|map| !map.label.is_empty());
        let over = |label: &str, or: bool| match label.is_empty() && !or {
            true => 0.5 * line,
            false => line + LIFT,
        };
        let top = top + over(&chart.y_label, bar_label);

        let mut drawing = Self {
            chart,
            looks,
            colours: chart
                .colours
                .iter()
                .map(|ink| ink.of(looks.theme))
                .collect(),
            size: [width, height],
            main: Field::default(),
            lower: None,
            legend,
            title,
            notes,
            foot: 0.0,
            labels: 0.0,
            slanted: false,
        };
        let [left, right] = drawing.sides(margin);
        let x_label = if chart.x_label.is_empty() { 0.0 } else { line };
        let notes_height = match drawing.notes.len() {
            0 => 0.0,
            lines => lines as f64 * line + 4.0,
        };
        let below = TICK + drawing.labels + x_label + notes_height + margin;
        let strip = chart.strip().map_or(0.0, |_| 2.0 + drawing.strip_height());
        let between = chart.residual.as_ref();
        let between = between.map_or(0.0, |panel| 4.0 + over(&panel.y_label, false));
        let share = between.min(1.0) * LOWER_SHARE;
        let least = LEAST_PANEL / if share > 0.0 { share } else { 1.0 };
        let least = if looks.whole { least } else { LEAST_PANEL };
        let panels = (height - top - below - strip - between).max(least);
        let at = |top: f64, height: f64| Field {
            left,
            top,
            width: right - left,
            height,
        };
        drawing.main = drawing.evened(at(top, panels * (1.0 - share)));
        let bottom = drawing.main.bottom() + strip;
        drawing.lower = (share > 0.0).then(|| at(bottom + between, panels * share));
        drawing.foot = drawing.lower.map_or(bottom, Field::bottom);
        drawing.size[1] = height.max(drawing.foot + below);
        drawing
    }

    /// The panel, narrower or lower where steps are to be as long on both axes.
    fn evened(&self, panel: Field) -> Field {
        if !self.chart.even {
            return panel;
        }
        let span = |[from, to]: [f64; 2]| (to - from).abs();
        let [across, up] = [self.chart.x_limits(), self.chart.y_limits()].map(span);
        let step = (panel.width / across).min(panel.height / up);
        let width = step * across;
        Field {
            // Without an axis at its left it stands in the middle.
            left: match self.chart.is_bare {
                true => panel.left + (panel.width - width) / 2.0,
                false => panel.left,
            },
            width,
            height: step * up,
            ..panel
        }
    }

    /// Where panels begin and end from left to right; sets how labels stand below them.
    fn sides(&mut self, margin: f64) -> [f64; 2] {
        let (chart, looks, width) = (self.chart, self.looks, self.size[0]);
        if chart.is_bare {
            return [margin, width - margin];
        }
        let rough = Axis::new(
            chart.x_limits(),
            chart.x_scale,
            0.85 * (width - 2.0 * margin),
        );
        let names = self.names(rough);
        let half = |name: &String| text_width(name, looks.small()) / 2.0;
        self.slanted = !chart.x_names.is_empty()
            && names.windows(2).any(|pair| {
                let apart = rough.px(pair[1].0) - rough.px(pair[0].0);
                apart < half(&pair[0].1) + half(&pair[1].1) + 8.0 * looks.scale
            });
        let longest = widest(names.iter().map(|(_, name)| name), looks.small());
        let slant = SLANT.to_radians();
        self.labels = looks.line_height();
        let mut overhang = 0.0;
        if self.slanted {
            self.labels += longest * slant.sin();
            let reach = |(x, name): &(f64, String)| 2.0 * half(name) * slant.cos() - rough.px(*x);
            overhang = names.iter().map(reach).fold(0.0, f64::max);
        }
        let numbers = [Some((chart.y_limits(), chart.y_scale)), lower_limits(chart)];
        let numbers = numbers.into_iter().flatten().map(|(limits, scale)| {
            let ticks = Axis::new(limits, scale, 1.0).ticks(self.down(self.size[1]));
            widest(&ticks.1, looks.small())
        });
        let unit = text_width(&chart.y_unit, looks.small());
        let numbers = numbers.fold(20.0 * looks.scale, f64::max) + unit + TICK + 5.0;
        let left = margin + numbers.max(overhang).min(0.45 * width);
        let beyond = match chart.heat_map() {
            Some(map) => {
                let ticks = map.bar(1.0).ticks(self.bar_target(self.size[1]));
                2.0 * BAR + 6.0 + widest(&ticks.1, looks.small()) + 4.0
            }
            // The last number stands half beyond its tick.
            None if chart.x_names.is_empty() => (longest / 2.0 + 2.0).max(8.0),
            None => 14.0 * looks.scale,
        };
        let right = (width - margin - beyond).max(left + 0.2 * width);
        [left, right]
    }

    /// The panels with their axes: the main one, and the lower one.
    pub fn plots(&self, view: View) -> (Plot, Option<Plot>) {
        let plot = |field: Field, y: [f64; 2], scale: Scale| Plot {
            field,
            x: Axis::new(view.x, self.chart.x_scale, field.width),
            y: Axis::new(y, scale, field.height),
        };
        let lower = self.lower.zip(lower_limits(self.chart));
        (
            plot(self.main, view.y, self.chart.y_scale),
            lower.map(|(field, (limits, scale))| plot(field, limits, scale)),
        )
    }

    /// Everything that is to be seen, the last on top.
    pub fn primitives(&self, view: View) -> Vec<Primitive> {
        let (main, lower) = self.plots(view);
        let chart = self.chart;
        let mut out = Vec::new();
        if self.looks.whole {
            let [width, height] = self.size;
            let paper = Field::between([0.0, 0.0], [width, height.ceil()]);
            out.push(Primitive::Fields(vec![(paper, self.palette().paper)]));
        }
        self.head(&mut out);
        for (series, field) in chart.legend_series().iter().zip(&self.legend) {
            self.legend_entry(&mut out, series, *field);
        }
        self.panel(&mut out, &main, &chart.y_label, &chart.series);
        if let (
            Some(plot),
            Some(Panel {
                y_label, series, ..
            }),
        ) = (&lower, &chart.residual)
        {
            self.panel(&mut out, plot, y_label, series);
        }
        self.blank(&mut out);
        self.strip(&mut out, &main);
        self.bar(&mut out);
        self.horizontal(&mut out, &main);
        out.retain(|one| !matches!(one, Primitive::Text(text) if text.words.is_empty()));
        out
    }

    pub(super) fn palette(&self) -> &'static Palette {
        Palette::of(self.looks.theme)
    }

    pub(super) fn strip_height(&self) -> f64 {
        12.0 * self.looks.scale
    }

    /// About how many numbers a vertical axis has.
    pub(super) fn down(&self, height: f64) -> usize {
        let scaled = height / self.looks.scale;
        // A low panel has no room for three that stand apart.
        (scaled / 36.0).clamp((scaled / 16.0).clamp(1.0, 3.0), 10.0) as usize
    }

    pub(super) fn bar_target(&self, height: f64) -> usize {
        (height / (40.0 * self.looks.scale)).clamp(2.0, 9.0) as usize
    }

    /// A small text in a colour.
    pub(super) fn text(
        &self,
        at: Place,
        anchor: Anchor,
        colour: [u8; 3],
        words: &str,
    ) -> Primitive {
        Primitive::Text(self.letters(at, anchor, colour, words))
    }

    /// The same, to be changed.
    pub(super) fn letters(&self, at: Place, anchor: Anchor, colour: [u8; 3], words: &str) -> Text {
        Text {
            at,
            anchor,
            size: self.looks.small(),
            colour,
            words: words.to_owned(),
            ..Text::default()
        }
    }

    /// Title and notes.
    fn head(&self, out: &mut Vec<Primitive>) {
        let palette = self.palette();
        for (i, line) in self.title.iter().enumerate() {
            let at = [MARGIN, MARGIN + (i as f64 + 0.5) * TITLE_SIZE * LEADING];
            let mut text = self.letters(at, Anchor::Start, palette.text, line);
            text.size = TITLE_SIZE;
            out.push(Primitive::Text(text));
        }
        let line = self.looks.line_height();
        for (i, note) in self.notes.iter().rev().enumerate() {
            let y = self.size[1] - MARGIN - (i as f64 + 0.5) * line;
            out.push(self.text([MARGIN, y], Anchor::Start, palette.faint, note));
        }
    }

    /// Says in the middle of the main panel why it is empty.
    fn blank(&self, out: &mut Vec<Primitive>) {
        let (main, line) = (self.main, self.looks.line_height());
        let words = wrap(&self.chart.blank, main.width - 16.0, self.looks.small());
        let first = main.top + (main.height - (words.len() as f64 - 1.0) * line) / 2.0;
        for (i, words) in words.iter().enumerate() {
            let at = [main.left + main.width / 2.0, first + i as f64 * line];
            out.push(self.text(at, Anchor::Middle, self.palette().faint, words));
        }
    }
}

fn lower_limits(chart: &Chart) -> Option<([f64; 2], Scale)> {
    let panel = chart.residual.as_ref()?;
    Some((panel.y_limits(), Scale::Linear))
}
