//! The marks of a series as SVG elements, cut to their panel.

use std::fmt::Write as _;

use super::{
    super::ticks::short,
    Dash, Marks, Series, Shape,
    axes::{Horizontal, Vertical},
    base_at,
    cut::{Place, cut_ring, cut_segment},
    palette::{Palette, hex},
    text::{Anchor, NOTE_SIZE, Text, clean, escaped, px, text_width},
};

/// The two axes that marks are placed by.
pub(super) struct Plot<'a> {
    pub(super) horizontal: &'a Horizontal,
    pub(super) vertical: &'a Vertical,
    pub(super) palette: &'a Palette,
}

impl Plot<'_> {
    fn place(&self, point: [f64; 2]) -> Option<Place> {
        let place = [self.horizontal.px(point[0]), self.vertical.px(point[1])];
        place.iter().all(|c| c.is_finite()).then_some(place)
    }

    pub(super) fn size(&self) -> [f64; 2] {
        [self.horizontal.length, self.vertical.length]
    }

    /// Whether a place is in the panel; the ends of the axes count, in spite of rounding.
    fn holds(&self, place: Place) -> bool {
        let size = self.size();
        (0..2).all(|axis| (-1e-6..=size[axis] + 1e-6).contains(&place[axis]))
    }

    /// Writes the marks of a series; `taken` are the boxes of the labels written so far.
    pub(super) fn marks(&self, out: &mut String, series: &Series, taken: &mut Vec<[f64; 4]>) {
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
            Marks::Points {
                points,
                radius,
                shape,
            } => {
                for &point in points {
                    if let Some(place) = self.place(point).filter(|&place| self.holds(place)) {
                        let point = point_element(place, sound_px(*radius), *shape, &colour);
                        let _ = writeln!(out, "{point}");
                    }
                }
            }
            Marks::Cells { cells } => self.cells(out, cells),
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
                r#"<rect x="{}" y="{}" width="{}" height="{}" fill="{colour}"/>"#,
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

/// A thickness or radius that can be drawn.
pub(super) fn sound_px(size: f64) -> f64 {
    if size.is_finite() {
        size.clamp(0.1, 50.0)
    } else {
        1.0
    }
}

pub(super) fn stroke_attributes(width: f64, dash: Dash) -> String {
    let width = px(sound_px(width));
    match dash.pattern() {
        Some([dash, gap]) => {
            let (dash, gap) = (px(dash), px(gap));
            format!(r#"stroke-width="{width}" stroke-dasharray="{dash} {gap}""#)
        }
        None => format!(r#"stroke-width="{width}""#),
    }
}

/// A point of a form as an element.
pub(super) fn point_element(at: Place, radius: f64, shape: Shape, colour: &str) -> String {
    let [x, y] = at.map(px);
    let r = px(radius);
    let place = |corner: &[f64; 2]| {
        let [x, y] = [at[0] + radius * corner[0], at[1] + radius * corner[1]].map(px);
        format!("{x} {y}")
    };
    let corners: Vec<String> = shape.corners().iter().map(place).collect();
    match (shape, &corners[..]) {
        (Shape::Ring, _) => {
            format!(r#"<circle cx="{x}" cy="{y}" r="{r}" stroke="{colour}" stroke-width="1.6"/>"#)
        }
        (Shape::Cross, [a, b, c, d]) => {
            format!(r#"<path d="M{a}L{b}M{c}L{d}" stroke="{colour}" stroke-width="1.8"/>"#)
        }
        (_, []) => format!(r#"<circle cx="{x}" cy="{y}" r="{r}" fill="{colour}"/>"#),
        (_, corners) => format!(r#"<path d="M{}Z" fill="{colour}"/>"#, corners.join("L")),
    }
}
