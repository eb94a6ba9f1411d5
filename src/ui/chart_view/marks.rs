//! The marks of a chart on screen.

use eframe::egui;
use egui::{Align2, Color32, Mesh, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2};

use super::{super::theme::Theme, colour_of, place::Place};
use crate::app::plot_svg::{self, Cells, Dash, Marks, Series, base_at, cut_segment};

/// Points closer than this to the last one drawn change nothing that can be seen.
const UNSEEN: f32 = 0.4;

/// Paints series into their panel, the last on top.
pub(super) fn paint(ui: &Ui, series: &[Series], place: &Place, theme: Theme) {
    let painter = ui.painter().with_clip_rect(place.frame());
    let mut taken = Vec::new();
    for series in series {
        let colour = colour_of(series);
        match &series.marks {
            Marks::Line {
                points,
                width,
                dash,
            } => {
                let stroke = Stroke::new(thickness(*width, theme), colour);
                line(&painter, points, place, stroke, *dash);
            }
            Marks::Stems {
                points,
                base,
                labels,
            } => {
                stems(&painter, points, base, place, colour, theme);
                let named = points.iter().zip(labels);
                for (point, label) in named.filter(|(_, label)| !label.is_empty()) {
                    stem_label(ui, &painter, place, *point, label, &mut taken, theme);
                }
            }
            Marks::Area { points, base } => area(&painter, points, base, place, colour),
            Marks::Bars { points, width } => {
                for point in points {
                    if let Some(rect) = bar_rect(place, *point, *width) {
                        painter.rect_filled(rect, 0.0, colour);
                    }
                }
            }
            Marks::Points {
                points,
                radius,
                shape,
            } => {
                let near = place.frame().expand(12.0);
                for at in points.iter().filter_map(|p| place.pos(*p)) {
                    if near.contains(at) {
                        painter.add(form(at, size(*radius, theme), *shape, colour));
                    }
                }
            }
            Marks::Cells { cells } => boxes(&painter, cells, place, theme),
        }
    }
}

/// The thickness of a line in the theme.
pub(super) fn thickness(width: f64, theme: Theme) -> f32 {
    let width = if width.is_finite() { width } else { 1.0 };
    // Charts are written for a line of 1.8; themes have their own.
    (width as f32).clamp(0.1, 50.0) * theme.line / 1.8
}

/// The radius of a point in the theme.
pub(super) fn size(radius: f64, theme: Theme) -> f32 {
    let radius = if radius.is_finite() { radius } else { 1.0 };
    (radius as f32).clamp(0.1, 50.0) * theme.scale
}

/// The lines of a path, cut to the frame and broken where points have no place.
fn runs(points: &[[f64; 2]], place: &Place) -> Vec<Vec<Pos2>> {
    let frame = place.frame().expand(4.0);
    let origin = [f64::from(frame.left()), f64::from(frame.top())];
    let room = [f64::from(frame.width()), f64::from(frame.height())];
    let to_pos = |[x, y]: [f64; 2]| frame.min + vec2(x as f32, y as f32);
    let mut runs: Vec<Vec<Pos2>> = Vec::new();
    let mut before: Option<[f64; 2]> = None;
    let mut pen: Option<[f64; 2]> = None;
    for point in points {
        let here = place.exact(*point);
        let here = here.map(|at| [at[0] - origin[0], at[1] - origin[1]]);
        if let (Some(from), Some(to)) = (before, here)
            && let Some([start, end]) = cut_segment([from, to], room)
        {
            if pen != Some(start) || runs.is_empty() {
                runs.push(vec![to_pos(start)]);
            }
            if let Some(run) = runs.last_mut() {
                run.push(to_pos(end));
            }
            pen = Some(end);
        }
        before = here;
    }
    runs
}

/// The same line without corners that nobody can see.
fn thinned(run: Vec<Pos2>) -> Vec<Pos2> {
    let last = run.len().saturating_sub(1);
    let mut kept: Vec<Pos2> = Vec::with_capacity(run.len());
    for (i, at) in run.into_iter().enumerate() {
        let far = kept
            .last()
            .is_none_or(|k| (at - *k).length_sq() > UNSEEN * UNSEEN);
        if far || i == last {
            kept.push(at);
        }
    }
    kept
}

fn line(painter: &Painter, points: &[[f64; 2]], place: &Place, stroke: Stroke, dash: Dash) {
    for run in runs(points, place) {
        let run = thinned(run);
        match dash.pattern() {
            None => {
                painter.add(Shape::line(run, stroke));
            }
            Some([dash, gap]) => {
                painter.extend(Shape::dashed_line(&run, stroke, dash as f32, gap as f32));
            }
        }
    }
}

fn stems(
    painter: &Painter,
    points: &[[f64; 2]],
    base: &[f64],
    place: &Place,
    colour: Color32,
    theme: Theme,
) {
    for (i, point) in points.iter().enumerate() {
        if let (Some(top), Some(foot)) = (place.pos(*point), place.foot(point[0], base_at(base, i)))
        {
            painter.line_segment([foot, top], (theme.line, colour));
            painter.circle_filled(top, 3.0 * theme.scale, colour);
        }
    }
}

/// A label above a tip, a little higher where another is in the way, or none: it would cover.
fn stem_label(
    ui: &Ui,
    painter: &Painter,
    place: &Place,
    point: [f64; 2],
    label: &str,
    taken: &mut Vec<Rect>,
    theme: Theme,
) {
    const ROWS: usize = 4;
    let Some(tip) = place.pos(point).filter(|at| place.frame().contains(*at)) else {
        return;
    };
    let font = egui::TextStyle::Small.resolve(ui.style());
    let colour = ui.visuals().text_color();
    let galley = painter.layout_no_wrap(label.to_owned(), font, colour);
    let frame = place.frame();
    let mut rect = Align2::CENTER_BOTTOM.anchor_size(tip - vec2(0.0, 5.0), galley.size());
    rect = rect.translate(vec2(
        (frame.left() + 2.0 - rect.left()).max(0.0) - (rect.right() - frame.right() + 2.0).max(0.0),
        (frame.top() + 2.0 - rect.top()).max(0.0),
    ));
    for _ in 0..ROWS {
        if taken.iter().all(|t| !t.expand(1.0).intersects(rect)) {
            painter.rect_filled(
                rect.expand2(vec2(2.0, 0.0)),
                2.0,
                theme.ground.gamma_multiply(0.75),
            );
            painter.galley(rect.min, galley, colour);
            taken.push(rect);
            return;
        }
        rect = rect.translate(vec2(0.0, -rect.height()));
    }
}

fn area(painter: &Painter, points: &[[f64; 2]], base: &[f64], place: &Place, colour: Color32) {
    let fill = colour.gamma_multiply(0.25);
    let mut mesh = Mesh::default();
    let mut open = false;
    for (i, point) in points.iter().enumerate() {
        let (Some(top), Some(foot)) = (place.pos(*point), place.foot(point[0], base_at(base, i)))
        else {
            open = false;
            continue;
        };
        let first = mesh.vertices.len() as u32;
        mesh.colored_vertex(top, fill);
        mesh.colored_vertex(foot, fill);
        if open {
            mesh.add_triangle(first - 2, first - 1, first);
            mesh.add_triangle(first - 1, first, first + 1);
        }
        open = true;
    }
    painter.add(mesh);
}

/// The box of a bar on screen.
pub(super) fn bar_rect(place: &Place, [x, y]: [f64; 2], width: f64) -> Option<Rect> {
    let left = place.foot(x - width / 2.0, 0.0)?;
    let right = place.pos([x + width / 2.0, y])?;
    Some(Rect::from_two_pos(left, right))
}

/// The box of a heat map on screen, cut to the frame.
pub(super) fn cell_rect(cells: &Cells, index: usize, place: &Place) -> Option<Rect> {
    let [x, y] = cells.sides(index)?;
    let low = place.foot(x[0], y[0])?;
    let high = place.pos([x[1], y[1]])?;
    let rect = Rect::from_two_pos(low, high).intersect(place.frame());
    rect.is_positive().then_some(rect)
}

fn boxes(painter: &Painter, cells: &Cells, place: &Place, theme: Theme) {
    let mut mesh = Mesh::default();
    for (i, colour) in cells.colours().into_iter().enumerate() {
        let Some(rect) = cell_rect(cells, i, place) else {
            continue;
        };
        match colour {
            Some([r, g, b]) => mesh.add_colored_rect(rect, Color32::from_rgb(r, g, b)),
            // No value: the ground with a stroke through it.
            None => {
                let stroke = (1.0, theme.faint.gamma_multiply(0.6));
                painter.line_segment([rect.left_bottom(), rect.right_top()], stroke);
            }
        }
    }
    painter.add(mesh);
}

/// A point of a form.
pub(super) fn form(at: Pos2, radius: f32, shape: plot_svg::Shape, colour: Color32) -> Shape {
    let corner = |[x, y]: [f64; 2]| at + radius * vec2(x as f32, y as f32);
    let corners: Vec<Pos2> = shape.corners().iter().copied().map(corner).collect();
    let stroke = Stroke::new(0.45 * radius, colour);
    match (shape, &corners[..]) {
        (plot_svg::Shape::Ring, _) => Shape::circle_stroke(at, radius, stroke),
        (plot_svg::Shape::Cross, [a, b, c, d]) => Shape::Vec(vec![
            Shape::line_segment([*a, *b], stroke),
            Shape::line_segment([*c, *d], stroke),
        ]),
        (_, []) => Shape::circle_filled(at, radius, colour),
        _ => Shape::convex_polygon(corners, colour, Stroke::NONE),
    }
}

/// What a series looks like, for the legend.
pub(super) fn sample(painter: &Painter, series: &Series, rect: Rect, theme: Theme) {
    let colour = colour_of(series);
    let middle = rect.center();
    match &series.marks {
        Marks::Line { width, dash, .. } => {
            let ends = [rect.left_center(), rect.right_center()];
            let stroke = Stroke::new(thickness(*width, theme), colour);
            match dash.pattern() {
                None => {
                    painter.line_segment(ends, stroke);
                }
                Some([dash, gap]) => {
                    painter.extend(Shape::dashed_line(&ends, stroke, dash as f32, gap as f32));
                }
            }
        }
        Marks::Stems { .. } => {
            let top = pos2(middle.x, rect.top() + 2.0);
            painter.line_segment([pos2(middle.x, rect.bottom()), top], (theme.line, colour));
            painter.circle_filled(top, 2.5 * theme.scale, colour);
        }
        Marks::Area { .. } => {
            painter.rect_filled(
                rect.shrink2(vec2(0.0, 1.0)),
                0.0,
                colour.gamma_multiply(0.4),
            );
        }
        Marks::Bars { .. } => {
            let half = vec2(0.3 * rect.width(), 1.0);
            painter.rect_filled(rect.shrink2(half), 0.0, colour);
        }
        Marks::Points { radius, shape, .. } => {
            painter.add(form(middle, size(*radius, theme).min(5.0), *shape, colour));
        }
        Marks::Cells { .. } => {}
    }
}
