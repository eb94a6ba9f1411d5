//! A panel of a chart: its axes, and the marks of series as primitives cut to it.

use super::{
    super::ticks::short,
    Cells, Dash, Marks, Series, Shape,
    axis::Axis,
    base_at,
    cut::{cut_band, cut_segment},
    looks::Looks,
    palette::Palette,
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
        let low = self.foot(x[0], y[0])?;
        Field::between(low, self.place([x[1], y[1]])?).cut_to(self.field)
    }
}

/// Draws series into a panel.
pub(super) struct Pen<'a> {
    pub(super) plot: &'a Plot,
    pub(super) looks: Looks,
    pub(super) palette: &'static Palette,
    /// The labels written so far, which go over everything, and their fields.
    pub(super) labels: Vec<Primitive>,
    taken: Vec<Field>,
}

impl<'a> Pen<'a> {
    pub(super) fn new(plot: &'a Plot, looks: Looks, palette: &'static Palette) -> Self {
        Self {
            plot,
            looks,
            palette,
            labels: Vec::new(),
            taken: Vec::new(),
        }
    }

    /// Draws the marks of a series.
    pub(super) fn series(&mut self, series: &Series) -> Vec<Primitive> {
        let colour = series.colour;
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
            Marks::Area { points, base } => self.bands(points, base, colour),
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
        }
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
    fn bands(&self, points: &[[f64; 2]], base: &[f64], colour: [u8; 3]) -> Vec<Primitive> {
        let corner = |(i, &point): (usize, &[f64; 2])| {
            let [x, top] = self.plot.place(point)?;
            Some([x, top, self.plot.foot(point[0], base_at(base, i))?[1]])
        };
        let corners: Vec<Option<[f64; 3]>> = points.iter().enumerate().map(corner).collect();
        let runs = corners.split(Option::is_none);
        runs.filter_map(|run| {
            let run: Vec<[f64; 3]> = run.iter().flatten().copied().collect();
            let corners = cut_band(&run, self.plot.field);
            (corners.len() > 1).then_some(Primitive::Band {
                corners,
                colour,
                opacity: 0.25,
            })
        })
        .collect()
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
        let mut inner = vec![Primitive::line(
            vec![from, to],
            1.8 * self.looks.line,
            colour,
        )];
        if self.plot.field.holds(top, 1e-6) {
            inner.push(dot(top, 3.5 * self.looks.scale, colour));
        }
        let tip = format!("{}, {}", short(point[0]), short(point[1]));
        if label.is_empty() {
            return Some(Primitive::Group { title: tip, inner });
        }
        let label_above = self.label(to, label);
        self.labels.extend(label_above);
        let title = format!("{label}: {tip}");
        Some(Primitive::Group { title, inner })
    }

    /// A label above a place, or a little higher where another label is in the way.
    ///
    /// A label that finds no free place in a few rows is left out: it would cover others, and the
    /// stem still has it as its title.
    fn label(&mut self, [x, y]: Place, label: &str) -> Option<Primitive> {
        const ROWS: usize = 5;
        let panel = self.plot.field;
        let size = self.looks.small();
        let (width, height) = (text_width(label, size), 1.2 * size);
        // Beside the panel's edges a label slides in; above its top it hangs below the edge.
        let leftmost = panel.left + 2.0;
        let left = (x - width / 2.0)
            .min(panel.right() - 2.0 - width)
            .max(leftmost);
        let lowest = (y - 6.0 * self.looks.scale - height).max(panel.top + 2.0);
        let rows = (0..ROWS).map(|row| Field {
            left,
            top: lowest - row as f64 * height,
            width,
            height,
        });
        let clear = |field: &Field| {
            let apart = |other: &Field| {
                field.left > other.right() + 1.0
                    || field.right() < other.left - 1.0
                    || field.top > other.bottom() - 0.5
                    || field.bottom() < other.top + 0.5
            };
            self.taken.iter().all(apart)
        };
        let free = rows
            .take_while(|field| field.top >= panel.top)
            .find(clear)?;
        self.taken.push(free);
        Some(Primitive::Text(Text {
            at: [free.left + width / 2.0, free.top + height / 2.0],
            anchor: Anchor::Middle,
            size,
            colour: self.palette.text,
            ground: Some(self.palette.ground),
            words: label.to_owned(),
            ..Text::default()
        }))
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
            colour: series.colour,
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
        let strokes = Primitive::Lines {
            runs: strokes,
            width: 1.0,
            dash: Dash::Solid,
            colour: self.palette.axis,
        };
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

/// A filled circle.
pub(super) fn dot(at: Place, radius: f64, colour: [u8; 3]) -> Primitive {
    Primitive::Circle {
        at,
        radius,
        colour,
        hollow: None,
    }
}

/// A point of a form.
pub(super) fn form(at: Place, radius: f64, shape: Shape, colour: [u8; 3]) -> Primitive {
    let corner = |c: &[f64; 2]| [at[0] + radius * c[0], at[1] + radius * c[1]];
    let corners: Vec<Place> = shape.corners().iter().map(corner).collect();
    let thickness = 0.45 * radius;
    match (shape, &corners[..]) {
        (Shape::Ring, _) => Primitive::Circle {
            at,
            radius,
            colour,
            hollow: Some(thickness),
        },
        (Shape::Cross, [a, b, c, d]) => Primitive::Lines {
            runs: vec![vec![*a, *b], vec![*c, *d]],
            width: thickness,
            dash: Dash::Solid,
            colour,
        },
        (_, []) => dot(at, radius, colour),
        _ => Primitive::Polygon { corners, colour },
    }
}
