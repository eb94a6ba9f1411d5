//! Surfaces under lights as fields of colour with their names: beside each light's reference, or
//! under two lights.

use eframe::egui;
use egui::{CornerRadius, Rect, Response, Sense, Stroke, TextStyle, Ui, Vec2, pos2, vec2};

use super::{kit::cut_words, swatch, theme::Theme};
use crate::{
    app::{Board, Lit, verdicts::Seen},
    languages::{fixed, with_colon},
};

/// Part of a field's height at which the references of two lights begin.
const SEAM: f32 = 0.68;

/// Rows of small type under a field: its name, and how far it moves.
const ROWS: f32 = 2.0;

/// A surface and what the fields of a board share.
pub(super) struct Field<'a> {
    /// Under each light that has a reference.
    pub lit: Vec<&'a Lit>,
    /// What is read out, and told where it is pointed at.
    pub said: String,
    /// Whether it is one of those that are pointed out.
    pub lights_up: bool,
    /// Where its reflectance comes from.
    pub source: &'a str,
}

impl Field<'_> {
    /// Draws it with its name; a field of a size, words included.
    pub(super) fn show(&self, ui: &mut Ui, size: Vec2, theme: Theme) -> Response {
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let Some(first) = self.lit.first() else {
            return response;
        };
        let said = &self.said;
        response.widget_info(|| {
            let is_on = ui.is_enabled();
            egui::WidgetInfo::selected(egui::Role::Button, is_on, self.lights_up, said)
        });
        if !ui.is_rect_visible(rect) {
            return response;
        }
        let text = ui.text_style_height(&TextStyle::Small);
        let colours = rect.with_max_y(rect.bottom() - ROWS * text - 3.0);
        self.colours(ui, colours, theme);
        let edge = match (self.lights_up, response.hovered() || response.has_focus()) {
            (true, _) => Stroke::new(2.5, ui.visuals().strong_text_color()),
            (false, true) => ui.visuals().widgets.active.bg_stroke,
            // A white surface is seen on a white ground.
            (false, false) => ui.visuals().widgets.noninteractive.bg_stroke,
        };
        swatch::outline(ui, colours, edge);
        let font = TextStyle::Small.resolve(ui.style());
        let strong = ui.visuals().strong_text_color();
        let ink = if self.lights_up {
            strong
        } else {
            ui.visuals().text_color()
        };
        let moved = self.lit.iter().map(|lit| fixed(lit.delta_e_2000, 1));
        let moved: Vec<String> = moved.collect();
        let lines = [(&first.name, ink), (&moved.join(" | "), theme.faint)];
        for (row, (words, ink)) in (1_u8..).zip(lines.into_iter().rev()) {
            let words = cut_words(ui, words, font.clone(), ink, rect.width());
            let left = rect.center().x - words.size().x / 2.0;
            let at = pos2(left, rect.bottom() - f32::from(row) * text);
            ui.painter().galley(at, words, ink);
        }
        let colours = first.swatches.map(|swatch| swatch.rgb8);
        swatch::menu(&response, colours);
        response.on_hover_text(match self.source {
            "" => said.clone(),
            source => format!("{said}\n{}", tr!("Measured: {source}.", source)),
        })
    }

    /// One light beside its reference; two lights, and below each its own reference.
    fn colours(&self, ui: &Ui, rect: Rect, theme: Theme) {
        let halves = |k: usize| {
            let all = self.lit.iter();
            all.map(move |lit| swatch::colour(lit.swatches[k].rgb8))
                .collect::<Vec<_>>()
        };
        let [of_lights, of_references] = [halves(0), halves(1)];
        match (&of_lights[..], &of_references[..]) {
            ([lamp], [reference]) => swatch::paint_split(ui, rect, *lamp, *reference),
            ([a, b, ..], [below_a, below_b, ..]) => {
                swatch::paint_split(ui, rect, *a, *b);
                let seam = (rect.top() + SEAM * rect.height()).round();
                let (left, right) = rect
                    .with_min_y(seam)
                    .split_left_right_at_x(rect.center().x.round());
                let corner = |sw, se| CornerRadius {
                    sw,
                    se,
                    ..CornerRadius::ZERO
                };
                ui.painter().rect_filled(left, corner(3, 0), *below_a);
                ui.painter().rect_filled(right, corner(0, 3), *below_b);
            }
            _ => return,
        }
        swatch::ticks(ui, rect, 4.0 * theme.scale);
        if !self
            .lit
            .iter()
            .all(|lit| lit.swatches.iter().all(|s| s.in_gamut))
        {
            swatch::out_of_gamut_mark(ui, rect);
        }
    }
}

/// How far a surface is from its reference under each light.
pub(super) fn from_references(lit: &[&Lit], lights: &[&str]) -> String {
    let name = lit.first().map_or("", |lit| &lit.name);
    let each = lit.iter().zip(lights).map(|(lit, light)| {
        let delta = lit.delta_e_2000;
        let seen = Seen::of(delta).seen();
        tr!(
            "under {light} ΔE₀₀ {delta} from its reference, {seen}",
            light,
            delta = fixed(delta, 1),
            seen
        )
    });
    let each: Vec<String> = each.collect();
    with_colon(name, each.join("; "))
}

/// What the halves of the fields are, in a line.
pub(super) fn caption(lights: &[&str]) -> String {
    match lights {
        [light] => tr!(
            "left {light}, right its reference; below the difference ΔE₀₀, each by its own white",
            light
        ),
        [first, second, ..] => tr!(
            "left {first}, right {second}, the strip below each its reference; below the \
             differences ΔE₀₀ from them, each by its own white",
            first,
            second
        ),
        [] => String::new(),
    }
}

/// Names of the lights that have a reference.
pub(super) fn referenced<'a>(board: &Board, names: impl Iterator<Item = &'a str>) -> Vec<&'a str> {
    let all = board.sides.iter().zip(names);
    all.filter_map(|(side, name)| side.is_some().then_some(name))
        .collect()
}

/// Between fields, points.
pub(super) const GAP: f32 = 8.0;

/// How wide one of some fields in a row is.
pub(super) fn width(room: f32, in_row: usize) -> f32 {
    ((room - GAP * (in_row - 1) as f32) / in_row as f32).floor()
}

/// A field's size with the words under it.
pub(super) fn size(ui: &Ui, width: f32, colours: f32) -> Vec2 {
    let text = ui.text_style_height(&TextStyle::Small);
    vec2(width, colours + ROWS * text + 3.0)
}
