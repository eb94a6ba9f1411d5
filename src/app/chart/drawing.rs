//! The one drawing of a chart: where its parts stand, and what they are drawn of. A file writes
//! the primitives as SVG, the window paints them.

use super::{
    Chart, Dash, Panel, Scale,
    axis::Axis,
    legend::legend_fields,
    palette::Palette,
    plot::{Pen, Plot},
    primitive::{Anchor, Field, Place, Primitive, Text},
    ramp::ramp_colour,
    text::{LEADING, elided, text_width, widest, wrap},
};

/// Free space around everything in a file, px.
const MARGIN: f64 = 14.0;

/// Font size of a title, px.
const TITLE_SIZE: f64 = 16.0;

/// Distance of what stands over a panel: the highest number reaches half beyond, px.
const LIFT: f64 = 5.0;

/// Length of a tick mark, px.
const TICK: f64 = 3.0;

/// Least height of a panel, px: the picture grows when titles and notes leave less.
const LEAST_PANEL: f64 = 40.0;

/// Part of the panels' height that the lower one gets.
const LOWER_SHARE: f64 = 0.25;

/// Slant of names that do not fit side by side, degrees.
const SLANT: f64 = 35.0;

/// Longest name of a place, letters.
const LONGEST_NAME: usize = 24;

/// Distance of a colour bar to its panel, and its width, px.
const BAR: f64 = 14.0;

/// How large and how complete a chart is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Looks {
    /// Multiplier of type and of fixed sizes.
    pub scale: f64,
    /// Multiplier of the thickness of lines.
    pub line: f64,
    /// With title and notes, and free space around: in files. The window writes them itself.
    pub whole: bool,
    /// With the names of the series.
    pub legend: bool,
}

impl Looks {
    /// How charts look in files.
    pub const FILE: Self = Self {
        scale: 1.0,
        line: 1.0,
        whole: true,
        legend: true,
    };

    /// Size of type beside titles, px.
    pub(super) fn small(self) -> f64 {
        11.0 * self.scale
    }

    pub(super) fn line_height(self) -> f64 {
        self.small() * LEADING
    }
}

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
    chart: &'a Chart,
    looks: Looks,
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
    foot: f64,
    labels: f64,
    slanted: bool,
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
        drawing.main = at(top, panels * (1.0 - share));
        let bottom = drawing.main.bottom() + strip;
        drawing.lower = (share > 0.0).then(|| at(bottom + between, panels * share));
        drawing.foot = drawing.lower.map_or(bottom, Field::bottom);
        drawing.size[1] = height.max(drawing.foot + below);
        drawing
    }

    /// Where panels begin and end from left to right; sets how labels stand below them.
    fn sides(&mut self, margin: f64) -> [f64; 2] {
        let (chart, looks, width) = (self.chart, self.looks, self.size[0]);
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
        Palette::of(self.chart.theme)
    }

    pub(super) fn looks(&self) -> Looks {
        self.looks
    }

    fn strip_height(&self) -> f64 {
        12.0 * self.looks.scale
    }

    /// About how many numbers a vertical axis has.
    fn down(&self, height: f64) -> usize {
        (height / (36.0 * self.looks.scale)).clamp(3.0, 10.0) as usize
    }

    fn bar_target(&self, height: f64) -> usize {
        (height / (40.0 * self.looks.scale)).clamp(2.0, 9.0) as usize
    }

    /// A small text in a colour, from its place on.
    pub(super) fn text(&self, at: Place, anchor: Anchor, colour: [u8; 3], words: &str) -> Text {
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
            let mut text = self.text(at, Anchor::Start, palette.text, line);
            text.size = TITLE_SIZE;
            out.push(Primitive::Text(text));
        }
        let line = self.looks.line_height();
        for (i, note) in self.notes.iter().rev().enumerate() {
            let y = self.size[1] - MARGIN - (i as f64 + 0.5) * line;
            let text = self.text([MARGIN, y], Anchor::Start, palette.faint, note);
            out.push(Primitive::Text(text));
        }
    }

    /// A panel: grid and vertical axis, then its series, then its frame.
    fn panel(
        &self,
        out: &mut Vec<Primitive>,
        plot: &Plot,
        y_label: &str,
        series: &[super::Series],
    ) {
        let (palette, field) = (self.palette(), plot.field);
        let [left, top] = [field.left, field.top];
        let (right, bottom) = (field.right(), field.bottom());
        out.push(Primitive::Fields(vec![(field, palette.ground)]));
        let (ticks, labels) = plot.y.ticks(self.down(field.height));
        let height = |value: f64| bottom - plot.y.px(value);
        let mut grid: Vec<Vec<Place>> = Vec::new();
        // Names have no in-between that a line could help to read.
        if self.chart.x_names.is_empty() {
            let across = self
                .numbers(plot.x)
                .into_iter()
                .map(|(x, _)| plot.across(x));
            grid.extend(across.map(|x| vec![[x, top], [x, bottom]]));
        }
        grid.extend(
            ticks
                .iter()
                .map(|y| vec![[left, height(*y)], [right, height(*y)]]),
        );
        out.push(lines(grid, palette.grid));
        let is_map = series.iter().any(|series| series.marks.cells().is_some());
        let [low, high] = plot.y.range;
        if plot.y.scale == Scale::Linear && low < 0.0 && high > 0.0 && !is_map {
            out.push(lines(
                vec![vec![[left, height(0.0)], [right, height(0.0)]]],
                palette.axis,
            ));
        }
        let marks = ticks
            .iter()
            .map(|y| vec![[left - TICK, height(*y)], [left, height(*y)]]);
        out.push(lines(marks.collect(), palette.axis));
        for (tick, label) in ticks.iter().zip(labels) {
            let at = [left - TICK - 3.0, height(*tick)];
            let words = label + &self.chart.y_unit;
            out.push(Primitive::Text(self.text(
                at,
                Anchor::End,
                palette.faint,
                &words,
            )));
        }
        if !y_label.is_empty() {
            // Over the upper end: a name never covers data.
            let end = match self.chart.heat_map() {
                Some(_) => left + 0.8 * (right - left),
                None => self.size[0],
            };
            let room = (end - left) / text_width("x", self.looks.small());
            let at = [left + 2.0, top - LIFT - self.looks.line_height() / 2.0];
            let words = elided(y_label, room as usize);
            out.push(Primitive::Text(self.text(
                at,
                Anchor::Start,
                palette.text,
                &words,
            )));
        }
        let mut pen = Pen::new(plot, self.looks, palette);
        for series in series {
            let inner = pen.series(series);
            if series.name.is_empty() {
                out.extend(inner);
            } else {
                let title = series.name.clone();
                out.push(Primitive::Group { title, inner });
            }
        }
        out.extend(pen.labels);
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let sides = (0..4).map(|i| vec![corners[i], corners[(i + 1) % 4]]);
        out.push(lines(sides.collect(), palette.frame));
    }

    /// Says in the middle of the main panel why it is empty.
    fn blank(&self, out: &mut Vec<Primitive>) {
        let (main, line) = (self.main, self.looks.line_height());
        let words = wrap(&self.chart.blank, main.width - 16.0, self.looks.small());
        let first = main.top + (main.height - (words.len() as f64 - 1.0) * line) / 2.0;
        for (i, words) in words.iter().enumerate() {
            let at = [main.left + main.width / 2.0, first + i as f64 * line];
            let text = self.text(at, Anchor::Middle, self.palette().faint, words);
            out.push(Primitive::Text(text));
        }
    }

    /// Colours along the horizontal axis, right under the main panel.
    ///
    /// The first colour belongs to the left end and the last to the right end, so each box reaches
    /// from half way to its left neighbour to half way to its right one. Equal neighbours are one.
    fn strip(&self, out: &mut Vec<Primitive>, main: &Plot) {
        let Some(colours) = self.chart.strip() else {
            return;
        };
        let room = Field {
            top: main.field.bottom() + 2.0,
            height: self.strip_height(),
            ..main.field
        };
        let [left, right] = self.chart.x_limits().map(|x| main.across(x));
        let steps = (colours.len() - 1).max(1) as f64;
        let border = |i: usize| {
            let x = left + (right - left) * ((i as f64 - 0.5) / steps).clamp(0.0, 1.0);
            x.clamp(room.left, room.right())
        };
        let mut fields = Vec::new();
        let mut first = 0;
        for run in colours.chunk_by(|a, b| a == b) {
            let end = first + run.len();
            let corner = [border(end), room.bottom()];
            fields.push((Field::between([border(first), room.top], corner), run[0]));
            first = end;
        }
        fields.retain(|(field, _)| field.width > 0.0);
        out.push(Primitive::Fields(fields));
    }

    /// The colour bar of a heat map at the right of the panel, its name over it.
    fn bar(&self, out: &mut Vec<Primitive>) {
        const STEPS: usize = 64;
        let Some(map) = self.chart.heat_map() else {
            return;
        };
        let (palette, main) = (self.palette(), self.main);
        let (left, right) = (main.right() + BAR, main.right() + 2.0 * BAR);
        let axis = map.bar(main.height);
        let y = |part: f64| main.bottom() - part * main.height;
        let fields = (0..STEPS).map(|step| {
            let [low, high] = [step, step + 1].map(|s| s as f64 / STEPS as f64);
            let field = Field::between([left, y(low)], [right, y(high)]);
            (field, ramp_colour((low + high) / 2.0))
        });
        out.push(Primitive::Fields(fields.collect()));
        let (ticks, labels) = axis.ticks(self.bar_target(main.height));
        for (tick, words) in ticks.into_iter().zip(labels) {
            let y = main.bottom() - axis.px(tick);
            out.push(lines(
                vec![vec![[right, y], [right + TICK, y]]],
                palette.axis,
            ));
            let at = [right + TICK + 3.0, y];
            out.push(Primitive::Text(self.text(
                at,
                Anchor::Start,
                palette.faint,
                &words,
            )));
        }
        let end = self.size[0] - if self.looks.whole { MARGIN } else { 0.0 };
        let at = [end, main.top - LIFT - self.looks.line_height() / 2.0];
        let text = self.text(at, Anchor::End, palette.text, &map.label);
        out.push(Primitive::Text(text));
    }

    /// Numbers or names along the horizontal axis, and what it counts.
    fn horizontal(&self, out: &mut Vec<Primitive>, main: &Plot) {
        let (palette, line) = (self.palette(), self.looks.line_height());
        for (x, words) in self.names(main.x) {
            let x = main.across(x);
            out.push(lines(
                vec![vec![[x, self.foot], [x, self.foot + TICK]]],
                palette.axis,
            ));
            let (at, anchor, rise) = match self.slanted {
                true => ([x + 4.0, self.foot + TICK + 0.4 * line], Anchor::End, SLANT),
                false => ([x, self.foot + TICK + 0.5 * line], Anchor::Middle, 0.0),
            };
            let mut text = self.text(at, anchor, palette.faint, &words);
            text.rise = rise;
            out.push(Primitive::Text(text));
        }
        let x = main.field.left + main.field.width / 2.0;
        let y = self.foot + TICK + self.labels + 0.5 * line;
        let text = self.text([x, y], Anchor::Middle, palette.text, &self.chart.x_label);
        out.push(Primitive::Text(text));
    }

    /// Places of the horizontal axis with what is written there.
    fn names(&self, axis: Axis) -> Vec<(f64, String)> {
        if self.chart.x_names.is_empty() {
            return self.numbers(axis);
        }
        let names = self.chart.x_names.iter();
        let mut names: Vec<(f64, String)> = names
            .filter(|(x, _)| (-1e-6..=axis.length + 1e-6).contains(&axis.px(*x)))
            .map(|(x, name)| (*x, elided(name, LONGEST_NAME)))
            .collect();
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Even slanted names need a line's height each.
        let mut last = f64::NEG_INFINITY;
        names.retain(|(x, _)| {
            let fits = axis.px(*x) - last >= 1.2 * self.looks.small();
            last = if fits { axis.px(*x) } else { last };
            fits
        });
        names
    }

    /// As many numbers as fit side by side; how wide they are shows only when they are made.
    fn numbers(&self, axis: Axis) -> Vec<(f64, String)> {
        let mut target = (axis.length / (60.0 * self.looks.scale)).clamp(2.0, 14.0) as usize;
        loop {
            let (ticks, labels) = axis.ticks(target);
            let widths = labels
                .iter()
                .map(|l| text_width(l, self.looks.small()) + 10.0);
            if target <= 1 || widths.sum::<f64>() <= axis.length {
                return ticks.into_iter().zip(labels).collect();
            }
            target -= 1;
        }
    }
}

fn lower_limits(chart: &Chart) -> Option<([f64; 2], Scale)> {
    let panel = chart.residual.as_ref()?;
    Some((panel.y_limits(), Scale::Linear))
}

/// Thin straight lines.
fn lines(runs: Vec<Vec<Place>>, colour: [u8; 3]) -> Primitive {
    Primitive::Lines {
        runs,
        width: 1.0,
        dash: Dash::Solid,
        colour,
    }
}
