//! A panel of a chart: its axes, and the marks of series as primitives cut to it.

use super::{
    super::ticks::short,
    Cells, Marks, Piece, Rgb, Series,
    axis::Axis,
    base_at,
    cut::{cut_band, cut_segment},
    looks::Looks,
    palette::Palette,
    points::{dot, form},
    primitive::{Anchor, Field, Place, Primitive, Text},
    text::text_width,
};

/// A panel with its two axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plot {
    /// Where it is in the picture.
    pub field: Field,
    /// From left to right.
    pub x: Axis,
    /// From the bottom up.
    pub y: Axis,
}

impl Plot {
    /// Where a point of the axes stands, in or beside the panel; `None` where it has no place.
    pub fn place(&self, [x, y]: [f64; 2]) -> Option<Place> {
        let place = [self.across(x), self.field.bottom() - self.y.px(y)];
        place.iter().all(|c| c.is_finite()).then_some(place)
    }

    /// Where marks over `x` that stand on a value start.
    fn foot(&self, x: f64, base: f64) -> Option<Place> {
        let place = [self.across(x), self.field.bottom() - self.y.base_px(base)];
        place.iter().all(|c| c.is_finite()).then_some(place)
    }

    /// The values of the axes at a place.
    pub fn values(&self, [x, y]: Place) -> [f64; 2] {
        let up = self.field.bottom() - y;
        [self.x.value(x - self.field.left), self.y.value(up)]
    }

    pub(super) fn across(&self, x: f64) -> f64 {
        self.field.left + self.x.px(x)
    }

    /// The box of a bar inside the panel.
    pub fn bar(&self, [x, y]: [f64; 2], width: f64) -> Option<Field> {
        let foot = self.foot(x - width / 2.0, 0.0)?;
        let head = self.place([x + width / 2.0, y])?;
        Field::between(foot, head).cut_to(self.field)
    }

    /// The box of a heat map inside the panel.
    pub fn cell(&self, cells: &Cells, index: usize) -> Option<Field> {
        let [x, y] = cells.sides(index)?;
        Field::between(self.foot(x[0], y[0])?, self.place([x[1], y[1]])?).cut_to(self.field)
    }
}

/// Draws series into a panel.
pub(super) struct Pen<'a> {
    pub(super) plot: &'a Plot,
    pub(super) looks: Looks,
    pub(super) palette: &'static Palette,
    /// Colours along the horizontal axis, and the values that they reach from and to.
    colours: &'a [Rgb],
    x_range: [f64; 2],
    /// The labels written so far, which go over everything, and their fields.
    pub(super) labels: Vec<Primitive>,
    taken: Vec<Field>,
}

impl<'a> Pen<'a> {
    /// `colours` reach along the horizontal axis, from one end of `x_range` to the other.
    pub(super) fn new(plot: &'a Plot, looks: Looks, colours: &'a [Rgb], x_range: [f64; 2]) -> Self {
        Self {
            plot,
            looks,
            palette: Palette::of(looks.theme),
            colours,
            x_range,
            labels: Vec::new(),
            taken: Vec::new(),
        }
    }

    /// Draws the marks of a series.
    pub(super) fn series(&mut self, series: &Series) -> Vec<Primitive> {
        let colour = series.colour.of(self.looks.theme);
        if series.is_tagged {
            self.labels.extend(self.tag(series));
        }
        match &series.marks {
            Marks::Line {
                points,
                width,
                dash,
            } => vec![Primitive::Lines {
                runs: self.runs(points),
                width: sound_px(*width) * self.looks.line,
                dash: *dash,
                colour,
            }],
            Marks::Stems {
                points,
                base,
                labels,
            } => {
                let label = |i| labels.get(i).map_or("", String::as_str);
                let stems = points.iter().enumerate();
                stems
                    .filter_map(|(i, &point)| self.stem(colour, point, base_at(base, i), label(i)))
                    .collect()
            }
            Marks::Area {
                points,
                base,
                is_coloured,
            } => {
                let colours = is_coloured.then_some(self.colours);
                self.bands(points, base, colour, colours.unwrap_or_default())
            }
            Marks::Bars { points, width } => {
                let bars = points.iter().filter_map(|p| self.plot.bar(*p, *width));
                vec![Primitive::Fields(bars.map(|bar| (bar, colour)).collect())]
            }
            Marks::Points {
                points,
                radius,
                shape,
            } => {
                let radius = sound_px(*radius) * self.looks.scale;
                let inside = |point: &&[f64; 2]| self.inside(**point);
                let places = points.iter().filter_map(|p| inside(&p));
                places.map(|at| form(at, radius, *shape, colour)).collect()
            }
            Marks::Cells { cells } => self.cells(cells),
            Marks::Words { words } => self.words(words, colour),
            Marks::Ground { pieces } => {
                let pieces = pieces.iter().filter_map(|piece| self.piece(piece));
                vec![Primitive::Pieces(pieces.collect())]
            }
        }
    }

    /// A piece of a ground moved into the panel, where it is partly outside.
    fn piece(&self, piece: &Piece) -> Option<([Place; 4], [Rgb; 4])> {
        let [low, high] = self.plot.field.corners();
        let mut places = [[0.0; 2]; 4];
        for (place, corner) in places.iter_mut().zip(piece.corners) {
            *place = self.plot.place(corner)?;
        }
        // One that is wholly beside an edge is not seen.
        let is_beside = (0..2).any(|k| {
            places.iter().all(|at| at[k] <= low[k]) || places.iter().all(|at| at[k] >= high[k])
        });
        let into = |at: Place| [0, 1].map(|k| at[k].clamp(low[k], high[k]));
        (!is_beside).then(|| (places.map(into), piece.colours))
    }

    /// Words at their places; those that would be cut or lie over others are left out, from the last
    /// one on.
    fn words(&self, words: &[([f64; 2], String)], colour: [u8; 3]) -> Vec<Primitive> {
        let size = self.looks.small();
        let mut fields: Vec<Field> = Vec::new();
        let free = |(at, words): &([f64; 2], String)| {
            let at = self.inside(*at)?;
            let field = Field {
                left: at[0] - 0.5 * text_width(words, size) - 1.0,
                top: at[1] - 0.55 * size,
                width: text_width(words, size) + 2.0,
                height: 1.1 * size,
            };
            let apart = |other: &Field| field.cut_to(*other).is_none();
            // Half a word tells nothing.
            let mut corners = field.corners().into_iter();
            let is_whole = corners.all(|corner| self.plot.field.holds(corner, 1e-6));
            (is_whole && fields.iter().all(apart)).then(|| {
                fields.push(field);
                Primitive::Text(Text {
                    at,
                    anchor: Anchor::Middle,
                    size,
                    colour,
                    words: words.clone(),
                    ..Text::default()
                })
            })
        };
        words.iter().filter_map(free).collect()
    }

    /// Where a point stands if it is in the panel; the ends of the axes count, in spite of
    /// rounding.
    fn inside(&self, point: [f64; 2]) -> Option<Place> {
        let place = self.plot.place(point)?;
        self.plot.field.holds(place, 1e-6).then_some(place)
    }

    /// A line cut to the panel and interrupted at broken points.
    fn runs(&self, points: &[[f64; 2]]) -> Vec<Vec<Place>> {
        let mut runs: Vec<Vec<Place>> = Vec::new();
        let mut before: Option<Place> = None;
        for &point in points {
            let here = self.plot.place(point);
            if let (Some(from), Some(to)) = (before, here)
                && let Some([start, end]) = cut_segment([from, to], self.plot.field)
            {
                match runs.last_mut() {
                    Some(run) if run.last() == Some(&start) => run.push(end),
                    _ => runs.push(vec![start, end]),
                }
            }
            before = here;
        }
        runs
    }

    /// The area between points and bases, a band for each unbroken run.
    fn bands(
        &self,
        points: &[[f64; 2]],
        base: &[f64],
        colour: [u8; 3],
        colours: &[[u8; 3]],
    ) -> Vec<Primitive> {
        let corner = |(i, &point): (usize, &[f64; 2])| {
            let [x, top] = self.plot.place(point)?;
            Some([x, top, self.plot.foot(point[0], base_at(base, i))?[1]])
        };
        let corners: Vec<Option<[f64; 3]>> = points.iter().enumerate().map(corner).collect();
        let runs = corners.split(Option::is_none);
        runs.filter_map(|run| {
            let run: Vec<[f64; 3]> = run.iter().flatten().copied().collect();
            let corners = cut_band(&run, self.plot.field);
            let shades = corners.iter().filter_map(|c| self.colour_at(c[0], colours));
            let shades: Vec<[u8; 3]> = shades.collect();
            (corners.len() > 1).then_some(Primitive::Band {
                opacity: if shades.is_empty() { 0.25 } else { 1.0 },
                corners,
                shades,
                colour,
            })
        })
        .collect()
    }

    /// The colour along the axis at a place; `None` where there are none.
    fn colour_at(&self, x: f64, colours: &[[u8; 3]]) -> Option<[u8; 3]> {
        let [first, last] = self.x_range;
        let nm = self.plot.x.value(x - self.plot.field.left);
        let share = ((nm - first) / (last - first)).clamp(0.0, 1.0);
        let at = share * colours.len().saturating_sub(1) as f64;
        colours.get(at.round() as usize).copied()
    }

    /// A line from its base to a dot, with its label above.
    fn stem(
        &mut self,
        colour: [u8; 3],
        point: [f64; 2],
        base: f64,
        label: &str,
    ) -> Option<Primitive> {
        let top = self.plot.place(point)?;
        let foot = self.plot.foot(point[0], base)?;
        let [from, to] = cut_segment([foot, top], self.plot.field)?;
        let mut inner = vec![Primitive::lines(
            vec![vec![from, to]],
            1.8 * self.looks.line,
            colour,
        )];
        if self.plot.field.holds(top, 1e-6) {
            // On whatever ground, the head keeps its edge.
            let radius = 3.5 * self.looks.scale;
            inner.push(dot(top, radius + 1.2, self.palette.ground));
            inner.push(dot(top, radius, colour));
        }
        let tip = format!("{}, {}", short(point[0]), short(point[1]));
        if label.is_empty() {
            return Some(Primitive::Group { title: tip, inner });
        }
        if self.plot.field.holds(top, 1e-6) {
            let label_above = self.label(to, label);
            self.labels.extend(label_above);
        }
        let title = format!("{}: {tip}", label.replace('\n', ", "));
        Some(Primitive::Group { title, inner })
    }

    /// A label above a place, of one line or two; where it would touch another it slides aside by
    /// up to half its width, then goes higher, then does without its second line.
    ///
    /// A label that finds no free place is left out: it would cover others, and the stem still
    /// has it as its title.
    fn label(&mut self, at: Place, label: &str) -> Vec<Primitive> {
        let (first, second) = label.split_once('\n').unwrap_or((label, ""));
        let both: &[&[&str]] = &[&[first, second], &[first]];
        let choices = if second.is_empty() { &both[1..] } else { both };
        for lines in choices {
            if let Some(field) = self.free_field(at, lines) {
                self.taken.push(field);
                return self.lines(field, lines);
            }
        }
        Vec::new()
    }

    /// Where a label of some lines has room.
    fn free_field(&self, [x, y]: Place, lines: &[&str]) -> Option<Field> {
        const ROWS: usize = 5;
        let panel = self.plot.field;
        let line = 1.2 * self.looks.small();
        let sizes = lines.iter().zip(self.label_sizes());
        let width = sizes
            .map(|(words, size)| text_width(words, size))
            .fold(0.0, f64::max);
        let height = line * lines.len() as f64;
        // Beside the panel's edges a label slides in; above its top it hangs below the edge.
        let leftmost = panel.left + 2.0;
        let within = |left: f64| left.min(panel.right() - 2.0 - width).max(leftmost);
        let lowest = (y - 6.0 * self.looks.scale - height).max(panel.top + 2.0);
        let rows = (0..ROWS).map(|row| lowest - row as f64 * line);
        let places = rows.flat_map(|top| {
            let aside = [0.0, -0.25, 0.25, -0.5, 0.5];
            aside.map(|part| Field {
                left: within(x + (part - 0.5) * width),
                top,
                width,
                height,
            })
        });
        let clear = |field: &Field| {
            let apart = |other: &Field| {
                field.left > other.right() + 3.0
                    || field.right() < other.left - 3.0
                    || field.top > other.bottom() - 0.5
                    || field.bottom() < other.top + 0.5
            };
            self.taken.iter().all(apart)
        };
        places.filter(|field| field.top >= panel.top).find(clear)
    }

    /// Sizes of the first and the second line of a label.
    fn label_sizes(&self) -> [f64; 2] {
        [1.0, 0.86].map(|part| part * self.looks.small())
    }

    fn lines(&self, field: Field, lines: &[&str]) -> Vec<Primitive> {
        let inks = [self.palette.text, self.palette.faint];
        let rows = lines.iter().zip(self.label_sizes()).zip(inks).enumerate();
        let count = lines.len() as f64;
        rows.map(|(row, ((words, size), colour))| {
            let part = (row as f64 + 0.5) / count;
            Primitive::Text(Text {
                at: [
                    field.left + field.width / 2.0,
                    field.top + part * field.height,
                ],
                anchor: Anchor::Middle,
                size,
                colour,
                ground: Some(self.palette.ground),
                words: (*words).to_owned(),
                ..Text::default()
            })
        })
        .collect()
    }

    /// The name of a series at its highest point in view.
    fn tag(&self, series: &Series) -> Option<Primitive> {
        let panel = self.plot.field;
        let places = series.marks.points().iter().filter_map(|p| {
            let [x, y] = self.plot.place(*p)?;
            (panel.left..=panel.right()).contains(&x).then_some([x, y])
        });
        let [x, y] = places.min_by(|a, b| a[1].total_cmp(&b[1]))?;
        let size = self.looks.small();
        let fits = x + 6.0 + text_width(&series.name, size) <= panel.right();
        let (anchor, x) = match fits {
            true => (Anchor::Start, x + 6.0),
            false => (Anchor::End, x - 6.0),
        };
        let half = 0.6 * size;
        Some(Primitive::Text(Text {
            at: [x, y.clamp(panel.top + half + 1.0, panel.bottom() - half)],
            anchor,
            size,
            colour: series.colour.of(self.looks.theme),
            ground: Some(self.palette.ground),
            words: series.name.clone(),
            ..Text::default()
        }))
    }

    /// The boxes; one without a value is the ground with a stroke through it.
    fn cells(&self, cells: &Cells) -> Vec<Primitive> {
        let (mut fields, mut strokes) = (Vec::new(), Vec::new());
        for (i, colour) in cells.colours().into_iter().enumerate() {
            let Some(field) = self.plot.cell(cells, i) else {
                continue;
            };
            match colour {
                Some(colour) => fields.push((field, colour)),
                None => strokes.push(vec![
                    [field.left, field.bottom()],
                    [field.right(), field.top],
                ]),
            }
        }
        let strokes = Primitive::lines(strokes, 1.0, self.palette.axis);
        vec![Primitive::Fields(fields), strokes]
    }
}

/// A thickness or radius that can be drawn.
pub(super) fn sound_px(size: f64) -> f64 {
    if size.is_finite() {
        size.clamp(0.1, 50.0)
    } else {
        1.0
    }
}
