//! What is under the pointer.

use eframe::egui;
use egui::{Color32, Pos2, Response, Stroke, StrokeKind, Ui};

use super::{super::theme::Theme, screen::Screen};
use crate::app::{
    chart::{Chart, Marks, Series},
    ticks::short,
};

/// How near the pointer must be to a point, points.
const REACH: f32 = 9.0;

/// A point of a series, or a box of a heat map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The series, counted through both panels as [`Chart::all_series`] does.
    pub series: usize,
    /// The point in the series, or the box in the values of the heat map.
    pub point: usize,
    /// Where it is, in the units of the axes; the middle of a box.
    pub at: [f64; 2],
}

/// The nearest point in reach; else the bar, else the box that the pointer is in.
pub(super) fn find(series: &[Series], screen: &Screen, at: Pos2, theme: Theme) -> Option<Hit> {
    if !screen.frame().expand(1.0).contains(at) {
        return None;
    }
    point(series, screen, at, theme)
        .or_else(|| bar(series, screen, at))
        .or_else(|| cell(series, screen, at))
}

fn point(series: &[Series], screen: &Screen, at: Pos2, theme: Theme) -> Option<Hit> {
    let mut nearest = (REACH * theme.scale).powi(2);
    let mut found = None;
    for (index, one) in series.iter().enumerate() {
        for (i, point) in one.marks.points().iter().enumerate() {
            let Some(pos) = screen.pos(*point) else {
                continue;
            };
            let off = pos.distance_sq(at);
            // Of equals the later one is on top.
            if off <= nearest {
                nearest = off;
                found = Some(Hit {
                    series: index,
                    point: i,
                    at: *point,
                });
            }
        }
    }
    found
}

fn bar(series: &[Series], screen: &Screen, at: Pos2) -> Option<Hit> {
    let (index, point, tip) = series.iter().enumerate().rev().find_map(|(index, one)| {
        let Marks::Bars { points, width } = &one.marks else {
            return None;
        };
        let inside = |p: &&[f64; 2]| screen.bar(**p, *width).is_some_and(|r| r.contains(at));
        let i = points.iter().position(|p| inside(&p))?;
        Some((index, i, points[i]))
    })?;
    Some(Hit {
        series: index,
        point,
        at: tip,
    })
}

fn cell(series: &[Series], screen: &Screen, at: Pos2) -> Option<Hit> {
    series.iter().enumerate().rev().find_map(|(index, one)| {
        let cells = one.marks.cells()?;
        let point = cells.at(screen.values(at))?;
        Some(Hit {
            series: index,
            point,
            at: cells.middle(point)?,
        })
    })
}

/// Rings what is pointed at.
pub(super) fn mark(ui: &Ui, series: &Series, hit: Hit, screen: &Screen, theme: Theme) {
    let painter = ui.painter().with_clip_rect(screen.frame().expand(8.0));
    let colour = ui.visuals().strong_text_color();
    let stroke = Stroke::new(1.6 * theme.scale, colour);
    match &series.marks {
        Marks::Cells { cells } => {
            if let Some(rect) = screen.cell(cells, hit.point) {
                let under = Stroke::new(3.4 * theme.scale, theme.ground);
                painter.rect_stroke(rect, 0.0, under, StrokeKind::Middle);
                painter.rect_stroke(rect, 0.0, stroke, StrokeKind::Middle);
            }
        }
        Marks::Bars { width, .. } => {
            if let Some(rect) = screen.bar(hit.at, *width) {
                painter.rect(rect, 0.0, Color32::TRANSPARENT, stroke, StrokeKind::Middle);
            }
        }
        _ => {
            if let Some(at) = screen.pos(hit.at) {
                painter.circle_stroke(at, 6.0 * theme.scale, stroke);
            }
        }
    }
}

/// Tells series, place, value and note beside the pointer.
pub(super) fn read_out(response: &Response, chart: &Chart, series: &Series, hit: Hit) {
    let lower = hit.series >= chart.series.len();
    let y_label = match &chart.residual {
        Some(panel) if lower => &panel.y_label,
        _ => &chart.y_label,
    };
    let or = |label: &str, otherwise: &str| {
        let label = if label.is_empty() { otherwise } else { label };
        label.to_owned()
    };
    let x = match chart.name_at(hit.at[0]) {
        Some(name) => name.to_owned(),
        None => short(hit.at[0]),
    };
    let mut lines = vec![
        crate::languages::with_colon(or(&chart.x_label, "x"), x),
        crate::languages::with_colon(or(y_label, "y"), short(hit.at[1])),
    ];
    if let Some(cells) = series.marks.cells() {
        let value = cells
            .value(hit.point)
            .map_or(said!("no value").to_owned(), short);
        lines.push(crate::languages::with_colon(
            or(&cells.label, said!("value")),
            value,
        ));
    }
    egui::Tooltip::for_widget(response).at_pointer().show(|ui| {
        if !series.name.is_empty() {
            ui.strong(&series.name);
        }
        for line in lines {
            ui.label(line);
        }
        if let Some(note) = series.notes.get(hit.point).filter(|n| !n.is_empty()) {
            ui.label(note);
        }
    });
}
