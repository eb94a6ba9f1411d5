//! What stands around the series: grids, axes with their numbers and names, the colour strip, the
//! colour bar of a heat map, the entries of the legend.

use super::{
    Marks, Scale, Series,
    axis::Axis,
    drawing::{BAR, Drawing, LIFT, LONGEST_NAME, MARGIN, SLANT, TICK},
    legend::{GAP, SAMPLE, fitted},
    plot::{Pen, Plot, sound_px},
    points::{dot, form},
    primitive::{Anchor, Field, Place, Primitive},
    ramp::ramp_colour,
    text::{elided, text_width},
};

impl Drawing<'_> {
    /// What a series looks like, and its name.
    pub(super) fn legend_entry(&self, out: &mut Vec<Primitive>, series: &Series, field: Field) {
        let (looks, colour) = (
            self.looks,
            self.palette().legible(series.colour.of(self.looks.theme)),
        );
        let length = SAMPLE * looks.scale;
        let middle = [field.left + length / 2.0, field.top + field.height / 2.0];
        let [x, y] = middle;
        let block = |half: f64| {
            let reach = 0.35 * field.height;
            Field::between([x - half, y - reach], [x + half, y + reach])
        };
        match &series.marks {
            Marks::Line { width, dash, .. } => out.push(Primitive::Lines {
                runs: vec![vec![[field.left, y], [field.left + length, y]]],
                width: sound_px(*width) * looks.line,
                dash: *dash,
                colour,
            }),
            Marks::Stems { .. } => {
                let (foot, top) = ([x, y + 6.0], [x, y - 4.0]);
                out.push(Primitive::lines(
                    vec![vec![foot, top]],
                    1.8 * looks.line,
                    colour,
                ));
                out.push(dot(top, 2.5 * looks.scale, colour));
            }
            Marks::Area { .. } => {
                let Field { top, height, .. } = block(length / 2.0);
                let side = |x: f64| [x, top, top + height];
                out.push(Primitive::Band {
                    corners: vec![side(field.left), side(field.left + length)],
                    shades: Vec::new(),
                    colour,
                    opacity: 0.4,
                });
            }
            Marks::Bars { .. } => {
                out.push(Primitive::Fields(vec![(block(0.3 * length), colour)]));
            }
            Marks::Points { radius, shape, .. } => {
                let radius = (sound_px(*radius) * looks.scale).min(5.0);
                // On paper of its own colour it has an edge, as it has in the plot.
                let own = series.colour.of(looks.theme);
                if own != colour {
                    out.push(form(middle, radius + 1.2, *shape, colour));
                }
                out.push(form(middle, radius, *shape, own));
            }
            // The colour bar tells what its colours mean.
            Marks::Cells { .. } | Marks::Ground { .. } | Marks::Words { .. } => {}
        }
        let at = [field.left + (SAMPLE + GAP) * looks.scale, y];
        let room = self.size[0] - 2.0 * self.legend[0].left;
        let name = fitted(&series.name, room, looks);
        out.push(self.text(at, Anchor::Start, self.palette().text, &name));
    }

    /// A panel: grid and vertical axis, then its series, then its frame.
    pub(super) fn panel(
        &self,
        out: &mut Vec<Primitive>,
        plot: &Plot,
        y_label: &str,
        series: &[Series],
    ) {
        let (palette, field) = (self.palette(), plot.field);
        let [left, top] = [field.left, field.top];
        let (right, bottom) = (field.right(), field.bottom());
        if !self.chart.is_bare {
            out.push(Primitive::Fields(vec![(field, palette.ground)]));
            self.scales(out, plot, series);
            self.y_label(out, field, y_label);
        }
        let mut pen = Pen::new(plot, self.looks, &self.colours, self.chart.x_range);
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
        if self.chart.is_bare {
            return;
        }
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let sides = (0..4).map(|i| vec![corners[i], corners[(i + 1) % 4]]);
        out.push(lines(sides.collect(), palette.frame));
    }

    /// Lines that help to read values, and the vertical axis with its numbers.
    fn scales(&self, out: &mut Vec<Primitive>, plot: &Plot, series: &[Series]) {
        let (palette, field) = (self.palette(), plot.field);
        let [left, top] = [field.left, field.top];
        let (right, bottom) = (field.right(), field.bottom());
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
            let zero = vec![[left, height(0.0)], [right, height(0.0)]];
            out.push(lines(vec![zero], palette.axis));
        }
        let marks = ticks
            .iter()
            .map(|y| vec![[left - TICK, height(*y)], [left, height(*y)]]);
        out.push(lines(marks.collect(), palette.axis));
        for (tick, label) in ticks.iter().zip(labels) {
            let at = [left - TICK - 3.0, height(*tick)];
            let words = label + &self.chart.y_unit;
            out.push(self.text(at, Anchor::End, palette.faint, &words));
        }
    }

    /// What a vertical axis counts, over its upper end: a name never covers data.
    fn y_label(&self, out: &mut Vec<Primitive>, panel: Field, label: &str) {
        let end = match self.chart.heat_map() {
            Some(_) => panel.left + 0.8 * panel.width,
            None => self.size[0],
        };
        let room = (end - panel.left) / text_width("x", self.looks.small());
        let y = panel.top - LIFT - self.looks.line_height() / 2.0;
        let words = elided(label, room as usize);
        let at = [panel.left + 2.0, y];
        out.push(self.text(at, Anchor::Start, self.palette().text, &words));
    }

    /// Colours along the horizontal axis, right under the main panel.
    ///
    /// The first colour belongs to the left end and the last to the right end, so each box reaches
    /// from half way to its left neighbour to half way to its right one. Equal neighbours are one.
    pub(super) fn strip(&self, out: &mut Vec<Primitive>, main: &Plot) {
        if self.chart.strip().is_none() {
            return;
        }
        let colours = &self.colours;
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
    pub(super) fn bar(&self, out: &mut Vec<Primitive>) {
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
            out.push(self.text(at, Anchor::Start, palette.faint, &words));
        }
        let end = self.size[0] - if self.looks.whole { MARGIN } else { 0.0 };
        let at = [end, main.top - LIFT - self.looks.line_height() / 2.0];
        out.push(self.text(at, Anchor::End, palette.text, &map.label));
    }

    /// Numbers or names along the horizontal axis, and what it counts.
    pub(super) fn horizontal(&self, out: &mut Vec<Primitive>, main: &Plot) {
        if self.chart.is_bare {
            return;
        }
        let (palette, line) = (self.palette(), self.looks.line_height());
        for (x, words) in self.names(main.x) {
            let x = main.across(x);
            let tick = vec![[x, self.foot], [x, self.foot + TICK]];
            out.push(lines(vec![tick], palette.axis));
            let (at, anchor, rise) = match self.slanted {
                true => ([x + 4.0, self.foot + TICK + 0.4 * line], Anchor::End, SLANT),
                false => ([x, self.foot + TICK + 0.5 * line], Anchor::Middle, 0.0),
            };
            let mut text = self.letters(at, anchor, palette.faint, &words);
            text.rise = rise;
            out.push(Primitive::Text(text));
        }
        let x = main.field.left + main.field.width / 2.0;
        let y = self.foot + TICK + self.labels + 0.5 * line;
        out.push(self.text([x, y], Anchor::Middle, palette.text, &self.chart.x_label));
    }

    /// Places of the horizontal axis with what is written there.
    pub(super) fn names(&self, axis: Axis) -> Vec<(f64, String)> {
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
    pub(super) fn numbers(&self, axis: Axis) -> Vec<(f64, String)> {
        // At most so many that a spectrum has a tick every 50 nm in windows of every width.
        let mut target = (axis.length / (60.0 * self.looks.scale)).clamp(2.0, 12.0) as usize;
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

/// Thin straight lines.
fn lines(runs: Vec<Vec<Place>>, colour: [u8; 3]) -> Primitive {
    Primitive::lines(runs, 1.0, colour)
}
