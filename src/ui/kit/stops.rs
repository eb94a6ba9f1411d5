//! A slider with marks: a track, a handle, ticks where something happens, and a line under the part
//! where all is well.

use eframe::egui;
use egui::{
    Key, Rect, Response, Sense, Ui,
    accesskit::{Action, ActionData},
    pos2, vec2,
};

use crate::ui::theme::Theme;

/// What a slider shows beside its value; places are 0 at the left end and 1 at the right.
#[derive(Clone, Copy, Debug)]
pub struct Stops<'a> {
    /// What screen readers and tests call it.
    pub name: &'a str,
    /// Where something happens.
    pub ticks: &'a [f64],
    /// From where on all is well.
    pub well_from: Option<f64>,
    /// From where on noise is drawn.
    pub noise_from: Option<f64>,
    /// Where arrow keys lead from a place, by so many of them.
    pub stepped: fn(f64, f64) -> f64,
    /// The value, for screen readers.
    pub value: f64,
    /// The values at both ends.
    pub ends: [f64; 2],
    /// From a value to its place: screen readers set values.
    pub place_of: fn(f64) -> f64,
}

/// Height that can be taken hold of, points.
const HEIGHT: f32 = 32.0;
/// Width and height of the handle, points.
const HANDLE: [f32; 2] = [12.0, 22.0];

/// Keeps the arrow keys for what has the keyboard: those to the sides, or all.
pub fn hold_arrows(ui: &Ui, id: egui::Id, all: bool) {
    let keys = egui::EventFilter {
        horizontal_arrows: true,
        vertical_arrows: all,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, keys));
}

impl Stops<'_> {
    /// Draws the slider `width` points wide and moves its place.
    pub fn show(self, ui: &mut Ui, place: &mut f64, width: f32, theme: Theme) -> Response {
        let scale = theme.scale;
        let size = vec2(width.max(24.0), HEIGHT * scale);
        let (rect, mut response) = ui.allocate_exact_size(size, Sense::click_and_drag());
        let [handle_width, handle_height] = HANDLE.map(|side| side * scale);
        let left = rect.left() + handle_width / 2.0;
        let right = rect.right() - handle_width / 2.0;
        let middle = rect.center().y;
        let before = *place;
        if let Some(pointer) = response.interact_pointer_pos() {
            *place = f64::from((pointer.x - left) / (right - left)).clamp(0.0, 1.0);
        }
        if response.has_focus() {
            hold_arrows(ui, response.id, false);
            let steps = ui.input(|i| {
                i.num_presses(Key::ArrowRight) as f64 - i.num_presses(Key::ArrowLeft) as f64
            });
            *place = (self.stepped)(*place, steps).clamp(0.0, 1.0);
        }
        self.obey_reader(ui, response.id, place);
        if *place != before {
            response.mark_changed();
        }
        let name = self.name.to_owned();
        response.widget_info(|| egui::WidgetInfo::slider(true, self.value, &name));
        let [least, most] = [
            self.ends[0].min(self.ends[1]),
            self.ends[0].max(self.ends[1]),
        ];
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_min_numeric_value(least);
            node.set_max_numeric_value(most);
            for action in [Action::SetValue, Action::Increment, Action::Decrement] {
                node.add_action(action);
            }
        });
        let x = |place: f64| left + (right - left) * place.clamp(0.0, 1.0) as f32;
        let painter = ui.painter();
        let half = 2.0 * scale;
        let track = |from: f32, to: f32| {
            Rect::from_min_max(pos2(from, middle - half), pos2(to, middle + half))
        };
        painter.rect_filled(track(left, right), half, theme.track);
        painter.rect_filled(track(left, x(*place)), half, theme.accent);
        for tick in self.ticks {
            let x = x(*tick);
            let ends = middle + half + 3.0 * scale..=middle + half + 8.0 * scale;
            painter.vline(x, ends, (scale, theme.faint));
        }
        if let Some(from) = self.noise_from {
            // Taller than the ticks, and over the track, of which the rest is noise.
            let x = x(from);
            let ends = middle - half - 8.0 * scale..=middle + half + 8.0 * scale;
            painter.vline(x, ends, (2.0 * scale, theme.warning));
        }
        if let Some(from) = self.well_from {
            let below = middle + half + 5.0 * scale;
            let well = crate::ui::theme::of_seen(crate::app::verdicts::Seen::Hardly, theme.dark);
            painter.hline(x(from)..=right, below, (2.0 * scale, well));
        }
        let handle =
            Rect::from_center_size(pos2(x(*place), middle), vec2(handle_width, handle_height));
        let visuals = ui.style().interact(&response);
        let fill = if theme.dark { 222 } else { 255 };
        painter.rect(
            handle,
            3.0,
            crate::ui::theme::grey(fill),
            egui::Stroke::new(1.0, visuals.fg_stroke.color.gamma_multiply(0.5)),
            egui::StrokeKind::Inside,
        );
        if response.has_focus() {
            let stroke = ui.visuals().widgets.active.bg_stroke;
            painter.rect_stroke(handle.expand(2.0), 4.0, stroke, egui::StrokeKind::Outside);
        }
        response
    }

    /// What a screen reader asks of the slider.
    fn obey_reader(&self, ui: &Ui, id: egui::Id, place: &mut f64) {
        let (steps, value) = ui.input(|input| {
            let count = |action| input.num_accesskit_action_requests(id, action) as f64;
            let values = input
                .accesskit_action_requests(id, Action::SetValue)
                .filter_map(|request| match request.data {
                    Some(ActionData::NumericValue(value)) if value.is_finite() => Some(value),
                    _ => None,
                });
            let steps = count(Action::Increment) - count(Action::Decrement);
            (steps, values.last())
        });
        if let Some(value) = value {
            *place = (self.place_of)(value).clamp(0.0, 1.0);
        }
        *place = (self.stepped)(*place, steps).clamp(0.0, 1.0);
    }
}
