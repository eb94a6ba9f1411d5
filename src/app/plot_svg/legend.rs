//! The legend: a sample and a name for every series.

use std::fmt::Write as _;

use super::{
    Chart, MARGIN, Marks, Series,
    cut::Place,
    marks::{point_element, sound_px, stroke_attributes},
    palette::{Palette, hex},
    text::{Anchor, LEADING, TEXT_SIZE, Text, clean, px, text_width},
};

impl Chart {
    /// The series that the legend names: the first of each name. Heat maps have a colour bar.
    pub fn legend_series(&self) -> Vec<&Series> {
        let mut found: Vec<&Series> = Vec::new();
        for series in self.all_series() {
            let is_new = found.iter().all(|other| other.name != series.name);
            if !series.name.is_empty() && is_new && series.marks.cells().is_none() {
                found.push(series);
            }
        }
        found
    }

    /// Writes the legend in as many rows as it needs and returns where it ends.
    pub(super) fn legend(&self, out: &mut String, palette: &Palette, top: f64, width: f64) -> f64 {
        const SAMPLE: f64 = 22.0;
        let entries = self.legend_series();
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

impl Series {
    /// Writes what the series looks like into the legend: `at` is the left end of its middle.
    fn sample(&self, out: &mut String, at: Place, length: f64) {
        let colour = hex(self.colour);
        let [x, y] = at;
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
            Marks::Bars { .. } => block(1.0),
            Marks::Points { radius, shape, .. } => {
                let radius = sound_px(*radius).min(5.0);
                point_element([x + length / 2.0, y], radius, *shape, &colour)
            }
            // The colour bar tells what its colours mean.
            Marks::Cells { .. } => return,
        };
        let _ = writeln!(out, "{sample}");
    }
}
