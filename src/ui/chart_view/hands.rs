//! Panning and zooming: what part of the axes a chart shows. egui_plot has the drags, the wheel is
//! this file's: it zooms the horizontal axis around the pointer, of a diagram whose axes are alike
//! both. While something is dragged anywhere, and for a moment after, the vertical axis holds still.

use eframe::egui;
use egui::{Id, Rect, Response, Ui, UiBuilder, Vec2};
use egui_plot::{Plot, PlotBounds, PlotTransform};

use super::{How, paint};
use crate::{
    app::chart::{Chart, Drawing, Scale, View, root, square},
    ui::kit::named,
};

/// What is shown of a panel, in coordinates of egui_plot: of each axis the first and the last.
type Bounds = [[f64; 2]; 2];

/// The part of an axis that was panned or zoomed to.
#[derive(Clone, Copy, PartialEq)]
struct Zoom {
    /// What the chart showed by itself, and its scale: another axis forgets the zoom.
    of: ([f64; 2], Scale),
    shown: [f64; 2],
}

/// The vertical axis of a chart as it was before a drag.
#[derive(Clone, Copy)]
struct Held {
    y: [f64; 2],
    scale: Scale,
    /// Until when it is shown, s.
    until: f64,
}

/// How long the vertical axis holds still after a drag, s.
const HOLD: f64 = 1.0;

/// The limits of the vertical axis, held while something is dragged.
fn held(ui: &Ui, id: Id, chart: &Chart, own: [f64; 2]) -> [f64; 2] {
    let (now, drags) = ui.input(|i| (i.time, i.pointer.is_decidedly_dragging()));
    let before = ui.data(|data| data.get_temp::<Held>(id));
    let before = before.filter(|held| held.scale == chart.y_scale);
    let holds = before.filter(|held| drags || now < held.until);
    let y = holds.map_or(own, |held| held.y);
    let until = match (drags, holds) {
        (true, _) => now + HOLD,
        (false, held) => held.map_or(0.0, |held| held.until),
    };
    if y != own && !drags {
        let left = std::time::Duration::from_secs_f64((until - now).max(0.0));
        ui.ctx().request_repaint_after(left);
    }
    let scale = chart.y_scale;
    ui.data_mut(|data| data.insert_temp(id, Held { y, scale, until }));
    y
}

fn keys(id: Id, how: How) -> [Id; 2] {
    [id.with("x zoom"), how.y_of.unwrap_or(id).with("y zoom")]
}

/// Shows everything again.
pub(crate) fn reset(ui: &Ui, id: Id, how: How) {
    let keys = keys(id, how);
    ui.data_mut(|data| keys.map(|key| data.remove::<Zoom>(key)));
}

/// What hands did to a chart in one frame.
pub(super) struct Hands {
    pub view: View,
    pub main: Response,
    pub lower: Option<Response>,
    /// Of the main panel.
    pub transform: PlotTransform,
}

impl Hands {
    /// Lets hands move the panels of a drawing that begins at an origin.
    pub(super) fn on(ui: &mut Ui, drawing: &Drawing<'_>, origin: Vec2, id: Id, how: How) -> Self {
        let chart = drawing.chart;
        let (keys, mut own) = (keys(id, how), chart.whole_view());
        own.y = held(ui, keys[1].with("held"), chart, own.y);
        let of = [(own.x, chart.x_scale), ([0.0; 2], chart.y_scale)];
        let mut bounds = [(own.x, chart.x_scale), (own.y, chart.y_scale)].map(coordinates);
        let whole = bounds;
        for k in 0..2 {
            let zoom = ui.data(|d| d.get_temp::<Zoom>(keys[k]));
            if let Some(zoom) = zoom.filter(|zoom| zoom.of == of[k]) {
                bounds[k] = zoom.shown;
            }
        }
        let rect = |field| paint::rect(origin, field);
        let main = panel(ui, rect(drawing.main), "main", bounds, how);
        let mut shown = main.shown(bounds);
        if let Some((factor, at)) = main.wheel(ui, how) {
            let axes = if chart.even { 2 } else { 1 };
            for (range, at) in shown.iter_mut().zip(at).take(axes) {
                *range = range.map(|end| at + factor * (end - at));
            }
        }
        for k in 0..2 {
            if shown[k] != bounds[k] {
                shown[k] = near_data(shown[k], whole[k]);
            }
        }
        let lower = chart.residual.as_ref().zip(drawing.lower);
        let lower = lower.map(|(lower, field)| {
            let asked = [shown[0], lower.y_limits()];
            let drawn = panel(ui, rect(field), "lower", asked, how);
            let moved = drawn.shown(asked)[0];
            if moved != shown[0] {
                shown[0] = near_data(moved, whole[0]);
            }
            drawn.response
        });
        for k in 0..2 {
            if shown[k] != bounds[k] {
                let zoom = Zoom {
                    of: of[k],
                    shown: shown[k],
                };
                ui.data_mut(|d| d.insert_temp(keys[k], zoom));
            }
        }
        let is_whole = (0..2).all(|k| shown[k] == whole[k]);
        let fits = !is_whole && fit_button(ui, rect(drawing.main), chart);
        if fits || main.response.double_clicked() && how.moves && how.fits {
            reset(ui, id, how);
            ui.ctx().request_repaint();
        }
        Self {
            view: View {
                x: values(shown[0], chart.x_scale),
                y: values(shown[1], chart.y_scale),
            },
            main: main.response,
            lower,
            transform: main.transform,
        }
    }
}

/// Size of the button that shows everything again, points.
const FIT: Vec2 = Vec2::new(36.0, 22.0);

/// In the corner of a chart that does not show all it has: the way back.
fn fit_button(ui: &mut Ui, frame: Rect, chart: &Chart) -> bool {
    let size = FIT.max(Vec2::new(0.0, ui.spacing().interact_size.y));
    let size = Vec2::new(size.x * size.y / FIT.y, size.y);
    let corner = frame.right_bottom() - size - Vec2::splat(6.0);
    let button = egui::Button::new(said!("fit"));
    let response = ui.put(Rect::from_min_size(corner, size), button);
    named(
        &response,
        egui::Role::Button,
        &tr!("Fit the view {title}", title = chart.title),
    );
    response
        .on_hover_text(said!(
            "Shows everything again (double click on an empty place, Home)."
        ))
        .clicked()
}

/// How far beyond its data a chart can be moved, as a part of their extent.
const BEYOND: f64 = 0.25;

/// What is shown of an axis, moved back where it leaves the data behind; no wider than them with
/// what lies a little beyond.
fn near_data([low, high]: [f64; 2], [first, last]: [f64; 2]) -> [f64; 2] {
    let beyond = BEYOND * (last - first);
    let (first, last) = (first - beyond, last + beyond);
    let length = (high - low).min(last - first);
    // By rounding the ends of data that are all shown may cross.
    let low = low.min(last - length).max(first);
    [low, low + length]
}

/// A panel as egui_plot has the hands on it.
struct Panel {
    response: Response,
    transform: PlotTransform,
}

impl Panel {
    /// What is shown now: what was asked for, unless a hand moved it.
    fn shown(&self, asked: Bounds) -> Bounds {
        let (min, max) = (self.transform.bounds().min(), self.transform.bounds().max());
        let by_hand = self.response.contains_pointer() || self.response.dragged();
        let shown = [[min[0], max[0]], [min[1], max[1]]];
        if by_hand && shown.iter().all(|[low, high]| low < high) {
            shown
        } else {
            asked
        }
    }

    /// By which factor the wheel widens what is shown around which place; in a page that scrolls the
    /// wheel is the page's, unless Ctrl is held.
    fn wheel(&self, ui: &Ui, how: How) -> Option<(f64, [f64; 2])> {
        const A_NOTCH: f32 = 200.0;
        let at = self.response.hover_pos().filter(|_| how.moves)?;
        let in_page = ui
            .stack()
            .iter()
            .any(|part| part.kind() == Some(egui::UiKind::ScrollArea));
        let factor = ui.input_mut(|input| {
            let pinched = input.zoom_delta();
            let wheel = match in_page {
                true => 0.0,
                false => std::mem::take(&mut input.smooth_scroll_delta).y,
            };
            pinched * (wheel / A_NOTCH).exp()
        });
        let place = self.transform.value_from_position(at);
        (factor != 1.0).then(|| (f64::from(1.0 / factor), [place.x, place.y]))
    }
}

/// Nothing but the hands: what is to be seen is painted beside.
fn panel(ui: &mut Ui, rect: Rect, name: &str, bounds: Bounds, how: How) -> Panel {
    let is_main = name == "main";
    let mut ui = ui.new_child(UiBuilder::new().max_rect(rect).id_salt(name));
    let plot = Plot::new(name)
        .width(rect.width())
        .height(rect.height())
        .min_size(Vec2::ZERO)
        .show_axes(false)
        .show_grid(false)
        .show_background(false)
        .show_x(false)
        .show_y(false)
        .show_crosshair(false)
        .allow_drag([how.pans && how.moves, how.pans && how.moves && is_main])
        .allow_zoom(false)
        .allow_boxed_zoom(is_main && how.moves)
        .allow_scroll(false)
        .allow_axis_zoom_drag(false)
        .allow_double_click_reset(false)
        .label_formatter(|_| None);
    let shown = plot.show(&mut ui, |plot| {
        let [x, y] = bounds;
        plot.set_plot_bounds(PlotBounds::from_min_max([x[0], y[0]], [x[1], y[1]]));
    });
    Panel {
        response: shown.response,
        transform: shown.transform,
    }
}

/// Values as coordinates of egui_plot.
fn coordinates((range, scale): ([f64; 2], Scale)) -> [f64; 2] {
    match scale {
        Scale::Linear => range,
        Scale::Root => range.map(root),
        Scale::Log10 => range.map(f64::log10),
    }
}

/// Coordinates of egui_plot as values.
fn values(range: [f64; 2], scale: Scale) -> [f64; 2] {
    match scale {
        Scale::Linear => range,
        Scale::Root => range.map(square),
        Scale::Log10 => range.map(|at| 10_f64.powf(at)),
    }
}

#[cfg(test)]
mod tests {
    use super::near_data;

    #[test]
    fn a_chart_cannot_be_moved_far_from_its_data() {
        let whole = [400.0, 800.0];
        assert_eq!(near_data([450.0, 500.0], whole), [450.0, 500.0]);
        assert_eq!(near_data([350.0, 750.0], whole), [350.0, 750.0]);
        assert_eq!(near_data([0.0, 100.0], whole), [300.0, 400.0]);
        assert_eq!(near_data([1000.0, 1400.0], whole), [500.0, 900.0]);
        assert_eq!(near_data([-1e6, 1e6], whole), [300.0, 900.0]);
    }
}
