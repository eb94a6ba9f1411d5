//! The legend: a sample and a name for every series, in as many rows as it needs.

use super::{
    Chart, Series,
    looks::Looks,
    primitive::{Field, Place},
    text::{elided, text_width},
};

/// Length of a sample and its distance to the name, px.
pub(super) const SAMPLE: f64 = 22.0;
pub(super) const GAP: f64 = 6.0;

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
pub(super) fn fitted(name: &str, width: f64, looks: Looks) -> String {
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
