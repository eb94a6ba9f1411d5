//! The legend: a sample and a name for every series, in as many rows as it needs.

use super::{
    Chart, Marks, Series,
    drawing::{Drawing, Looks},
    plot::{dot, form, sound_px},
    primitive::{Anchor, Field, Place, Primitive},
    text::{elided, text_width},
};

/// Length of a sample and its distance to the name, px.
const SAMPLE: f64 = 22.0;
const GAP: f64 = 6.0;

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
}

/// The longest name that fits a row.
fn fitted(name: &str, width: f64, looks: Looks) -> String {
    let room = width - (SAMPLE + GAP) * looks.scale;
    elided(
        name,
        (room / text_width("x", looks.small())).max(8.0) as usize,
    )
}

/// Where the entries of a legend stand, `width` px wide in all.
pub(super) fn legend_fields(chart: &Chart, corner: Place, width: f64, looks: Looks) -> Vec<Field> {
    let [mut left, mut top] = corner;
    let height = looks.line_height();
    let mut fields = Vec::new();
    for series in chart.legend_series() {
        let name = text_width(&fitted(&series.name, width, looks), looks.small());
        let needed = (SAMPLE + GAP) * looks.scale + name;
        if left > corner[0] && left + needed > corner[0] + width {
            (left, top) = (corner[0], top + height);
        }
        fields.push(Field {
            left,
            top,
            width: needed,
            height,
        });
        left += needed + 14.0 * looks.scale;
    }
    fields
}

impl Drawing<'_> {
    /// What a series looks like, and its name.
    pub(super) fn legend_entry(&self, out: &mut Vec<Primitive>, series: &Series, field: Field) {
        let (looks, colour) = (self.looks, series.colour);
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
                out.push(Primitive::line(vec![foot, top], 1.8 * looks.line, colour));
                out.push(dot(top, 2.5 * looks.scale, colour));
            }
            Marks::Area { .. } => {
                let Field { top, height, .. } = block(length / 2.0);
                let side = |x: f64| [x, top, top + height];
                out.push(Primitive::Band {
                    corners: vec![side(field.left), side(field.left + length)],
                    colour,
                    opacity: 0.4,
                });
            }
            Marks::Bars { .. } => {
                out.push(Primitive::Fields(vec![(block(0.3 * length), colour)]));
            }
            Marks::Points { radius, shape, .. } => {
                let radius = (sound_px(*radius) * looks.scale).min(5.0);
                out.push(form(middle, radius, *shape, colour));
            }
            // The colour bar tells what its colours mean.
            Marks::Cells { .. } => {}
        }
        let at = [field.left + (SAMPLE + GAP) * looks.scale, y];
        let room = self.size[0] - 2.0 * self.legend[0].left;
        let name = fitted(&series.name, room, looks);
        let text = self.text(at, Anchor::Start, self.palette().text, &name);
        out.push(Primitive::Text(text));
    }
}
