//! Strips of colour below each other over one axis, with the names of lines.

use eframe::egui;
use egui::{Align2, Color32, FontId, Mesh, Painter, Rect, Sense, Shape, TextStyle, Ui, pos2, vec2};

use crate::{
    app::{dispersion::StripShown, ticks::short},
    ui::{
        kit::drawing,
        theme::{Theme, grey},
    },
};

/// Height of the first strip and of those beside it, points.
const STRIPS: [f32; 2] = [48.0, 32.0];

/// Height of the plot of what falls on a strip, points.
const PLOT: f32 = 36.0;

/// How far apart hatching lines are, points.
const HATCH: f32 = 7.0;

/// Height of a row of names, points, and how many there are.
const NAME_ROW: f32 = 15.0;
const NAME_ROWS: usize = 2;

/// Free space below a strip, points.
const GAP: f32 = 4.0;

/// Height of a row of numbers below them, points.
const SCALE: f32 = 17.0;

/// What is below the strips.
pub(super) struct Axis<'a> {
    /// Values at both ends.
    pub ends: [f64; 2],
    /// What it counts.
    pub label: &'a str,
    /// Wavelengths with their places, nm and the unit of the axis; empty where there are none.
    pub nm: &'a [[f64; 2]],
    /// What is told of a value under the pointer.
    pub tells: &'a dyn Fn(f64) -> String,
}

impl Axis<'_> {
    /// How far a value is from the left end, 0-1 inside.
    pub(super) fn share(&self, value: f64) -> f32 {
        let [from, to] = self.ends;
        ((value - from) / (to - from)) as f32
    }
}

/// Height of all that [`show`] draws, with a line of words below it, points.
pub(super) fn height(strips: &[StripShown], axis: &Axis<'_>, theme: Theme) -> f32 {
    let one = |(index, strip): (usize, &StripShown)| {
        NAME_ROW * name_rows(strip) + strip_height(index) + plot_height(strip) + GAP
    };
    let scales = if axis.nm.is_empty() { 1.0 } else { 2.0 };
    let words = 22.0;
    let all: f32 = strips.iter().enumerate().map(one).sum();
    (all + scales * SCALE + words) * theme.scale
}

/// Rows of names below a strip.
fn name_rows(strip: &StripShown) -> f32 {
    match strip.marks.is_empty() {
        true => 1.0,
        false => NAME_ROWS as f32,
    }
}

fn strip_height(index: usize) -> f32 {
    STRIPS[index.min(1)]
}

/// Height of the plot below a strip, points.
fn plot_height(strip: &StripShown) -> f32 {
    if strip.heights.is_empty() { 0.0 } else { PLOT }
}

pub(super) fn show(ui: &mut Ui, strips: &[StripShown], axis: &Axis<'_>, theme: Theme) {
    let scale = theme.scale;
    let font = TextStyle::Small.resolve(ui.style());
    let ink = ui.visuals().text_color();
    for (index, strip) in strips.iter().enumerate() {
        let names = name_rows(strip) * NAME_ROW * scale;
        let plotted = plot_height(strip) * scale;
        let high = strip_height(index) * scale;
        let size = vec2(ui.available_width(), high + plotted + names);
        let name = tr!("Strip of {strip}", strip = strip.name);
        let (area, response) = drawing(ui, size, Sense::hover(), &name);
        let whole = area.with_max_y(area.bottom() - names);
        let field = whole.with_max_y(area.top() + high);
        let painter = ui.painter();
        painter.rect_filled(whole, 0.0, grey(super::bench::ROOM));
        columns(painter, field, &strip.colours.rgb);
        plot(ui, whole.with_min_y(field.bottom()), strip);
        hatch(painter, whole, strip, axis);
        let at = whole.left_bottom() + vec2(0.0, 1.0);
        let taken = painter.text(at, Align2::LEFT_TOP, &strip.name, font.clone(), ink);
        let ground = ui.visuals().panel_fill;
        let looks = (&font, theme.faint, ground);
        marks(painter, whole, strip, axis, looks, taken);
        let pointed = response.hover_pos().filter(|at| whole.contains(*at));
        if let Some(at) = pointed {
            let share = f64::from((at.x - field.left()) / field.width());
            let [from, to] = axis.ends;
            response.on_hover_text_at_pointer((axis.tells)(from + share * (to - from)));
        }
        ui.add_space(GAP * scale);
    }
    if !strips.is_empty() {
        ui.scope(|ui| ticks(ui, axis, &font, theme));
    }
}

/// What falls on each place: all of the light in the strip's colours, the smooth part as a curve.
fn plot(ui: &Ui, field: Rect, strip: &StripShown) {
    let painter = ui.painter();
    if strip.heights.is_empty() {
        return;
    }
    let width = field.width() / strip.heights.len() as f32;
    let top = |height: f64| field.bottom() - (height as f32) * (field.height() - 3.0);
    let mut mesh = Mesh::default();
    let mut smooth = Vec::new();
    for (index, ([all, part], [r, g, b])) in
        strip.heights.iter().zip(&strip.colours.rgb).enumerate()
    {
        let left = field.left() + width * index as f32;
        // As bright as the room at least: what is dim has its height too.
        let ink = Color32::from_rgb((*r).max(70), (*g).max(70), (*b).max(70));
        let bar = Rect::from_x_y_ranges(left..=left + width, top(*all)..=field.bottom());
        mesh.add_colored_rect(bar, ink);
        smooth.push(pos2(left + 0.5 * width, top(*part)));
    }
    painter.add(mesh);
    painter.add(Shape::line(smooth, (1.0, grey(225))));
    painter.line_segment([field.left_top(), field.right_top()], (1.0, grey(60)));
    let at = field.left_top() + vec2(6.0, 3.0);
    let words = said!("irradiance, heights by roots; the line is the smooth part");
    let painter = painter.with_clip_rect(field.intersect(painter.clip_rect()));
    super::bench::write(
        ui,
        &painter,
        (at, Align2::LEFT_TOP, words, grey(150)),
        &mut Vec::new(),
    );
}

/// Hatches what rests on an extrapolated index.
fn hatch(painter: &Painter, field: Rect, strip: &StripShown, axis: &Axis<'_>) {
    for ends in &strip.doubtful {
        let [a, b] = ends.map(|end| field.left() + axis.share(end) * field.width());
        let part = Rect::from_x_y_ranges(a.min(b)..=a.max(b), field.y_range()).intersect(field);
        let painter = painter.with_clip_rect(part.intersect(painter.clip_rect()));
        let count = ((part.width() + part.height()) / HATCH).ceil().max(0.0) as usize;
        for i in 0..count {
            let foot = pos2(
                part.left() - part.height() + HATCH * i as f32,
                part.bottom(),
            );
            let head = foot + vec2(part.height(), -part.height());
            painter.line_segment([foot, head], (1.0, grey(120)));
        }
    }
}

/// A box for each column.
fn columns(painter: &Painter, field: Rect, rgb: &[[u8; 3]]) {
    let mut mesh = Mesh::default();
    let width = field.width() / rgb.len().max(1) as f32;
    for (index, [r, g, b]) in rgb.iter().enumerate() {
        let left = field.left() + width * index as f32;
        let column = Rect::from_x_y_ranges(left..=left + width, field.y_range());
        mesh.add_colored_rect(column, Color32::from_rgb(*r, *g, *b));
    }
    painter.add(mesh);
}

/// Names of lines below the strip, each with a stroke to its place; those without room are left
/// out, for the table has them.
fn marks(
    painter: &Painter,
    field: Rect,
    strip: &StripShown,
    axis: &Axis<'_>,
    (font, ink, ground): (&FontId, Color32, Color32),
    title: Rect,
) {
    let (mut taken, mut named) = (vec![title], Vec::new());
    for (value, name) in &strip.marks {
        let share = axis.share(*value);
        let x = field.left() + share * field.width();
        if !(0.0..=1.0).contains(&share) {
            continue;
        }
        let galley = painter.layout_no_wrap(name.clone(), font.clone(), ink);
        let size = galley.size();
        let left =
            (x - 0.5 * size.x).clamp(field.left(), (field.right() - size.x).max(field.left()));
        let place = (0..NAME_ROWS).map(|row| {
            let top = field.bottom() + row as f32 * size.y + 1.0;
            Rect::from_min_size(pos2(left, top), size)
        });
        let free = |place: &Rect| {
            taken
                .iter()
                .all(|other| !other.intersects(place.expand2(vec2(4.0, -1.0))))
        };
        if let Some(place) = place.into_iter().find(free) {
            painter.vline(x, field.bottom()..=place.top() + 2.0, (1.0, ink));
            taken.push(place);
            named.push((place, galley));
        }
    }
    // No stroke runs through another name.
    for (place, galley) in named {
        painter.rect_filled(place, 0.0, ground);
        painter.galley(place.min, galley, ink);
    }
}

/// A row of numbers with ticks and what it counts at the right end.
fn scale(
    ui: &mut Ui,
    label: &str,
    marks: impl Iterator<Item = (f32, String)>,
    (font, theme): (&FontId, Theme),
) {
    let size = vec2(ui.available_width(), SCALE * theme.scale);
    let (area, _) = ui.allocate_exact_size(size, Sense::hover());
    let painter = ui.painter();
    let label = painter.layout_no_wrap(label.to_owned(), font.clone(), theme.faint);
    let end = area.right() - label.size().x;
    let top = area.top() + 3.0;
    painter.galley(pos2(end, top), label, theme.faint);
    let mut free_from = area.left();
    let mut marks: Vec<(f32, String)> = marks.collect();
    marks.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (share, words) in marks {
        let x = area.left() + share * area.width();
        painter.vline(x, area.top()..=top, (1.0, theme.faint));
        let galley = painter.layout_no_wrap(words, font.clone(), theme.faint);
        let left = (x - 0.5 * galley.size().x).max(area.left());
        // Nothing is written over another number, and nothing is cut.
        if left >= free_from && left + galley.size().x < end - 8.0 {
            free_from = left + galley.size().x + 8.0;
            painter.galley(pos2(left, top), galley, theme.faint);
        }
    }
}

/// Numbers below the strips: wavelengths where there are some, and places.
fn ticks(ui: &mut Ui, axis: &Axis<'_>, font: &FontId, theme: Theme) {
    ui.spacing_mut().item_spacing.y = 0.0;
    if !axis.nm.is_empty() {
        let marks = axis.nm.iter().map(|[nm, at]| (axis.share(*at), short(*nm)));
        let inside = marks.filter(|(share, _)| (0.0..=1.0).contains(share));
        scale(ui, "nm", inside, (font, theme));
    }
    let [from, to] = axis.ends;
    let step = step_of((to - from).abs() / 10.0);
    let (least, most) = (from.min(to), from.max(to));
    let first = (least / step).ceil() as i64;
    let values = (0..=10).map(|i| (first + i) as f64 * step);
    let marks = values
        .filter(|value| *value <= most)
        .map(|value| (axis.share(value), short(value)));
    scale(ui, axis.label, marks, (font, theme));
}

/// The round step at or above a size: 1, 2 or 5 of its decade.
fn step_of(size: f64) -> f64 {
    let decade = 10.0_f64.powf(size.max(1e-9).log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade);
    steps
        .into_iter()
        .find(|step| *step >= size)
        .unwrap_or(steps[3])
}
