//! A [`Chart`] in the window: the drawing that its files have, with read-outs, clicks and a menu
//! to save it.
//!
//! egui_plot has the hands on it: a drag pans, Ctrl and the wheel zoom, the right button zooms
//! into a box, a double click shows everything again. In a chart whose page has something to drag
//! ([`ChartView::held`]) a drag is the page's and pans nothing.

mod hit;
mod menu;
pub mod paint;
mod screen;

use eframe::egui;
use egui::{Align, Id, Label, Layout, Rect, Response, RichText, Sense, Ui, UiBuilder, Vec2, vec2};
use egui_plot::{Plot, PlotBounds, PlotTransform};

use super::{model_view::named, theme::Theme};
use crate::app::chart::{Chart, Drawing, Looks, Scale, View};
pub use hit::Hit;
use menu::menu;
pub use menu::{ChartForm, ChartWish};
pub use screen::Screen;

/// Smallest chart, points.
const LEAST_SIZE: Vec2 = vec2(140.0, 90.0);

/// A chart in the window.
pub struct ChartView;

/// What one frame told.
#[derive(Debug)]
pub struct ChartResponse {
    /// The point or box that was clicked.
    pub clicked: Option<Hit>,
    /// The point or box under the pointer.
    pub pointed: Option<Hit>,
    /// What the menu was asked for; for [`Window::save_chart`](super::Window::save_chart).
    pub wish: Option<ChartWish>,
    /// Where the pointer drags the main panel, in the units of the axes.
    pub dragged: Option<[f64; 2]>,
    /// The main panel, called like the chart.
    pub response: Response,
    /// From screen to the main panel and back; on logarithmic axes of decimal logarithms.
    pub transform: PlotTransform,
    /// The main panel as it was drawn.
    pub main: Screen,
}

/// How a chart stands in its page.
#[derive(Clone, Copy)]
pub(super) struct How {
    /// With its title and its menu.
    pub titled: bool,
    /// With the names of its series.
    pub legend: bool,
    /// Whether hands move the view.
    pub moves: bool,
    /// Whether a drag pans.
    pub pans: bool,
    /// Whether points are read out where they are pointed at.
    pub tells: bool,
    /// What the vertical axis is of: another one forgets its zoom, the horizontal one stays.
    pub y_of: Option<Id>,
}

impl How {
    /// As charts of pages are.
    const PAGE: Self = Self {
        titled: true,
        legend: true,
        moves: true,
        pans: true,
        tells: true,
        y_of: None,
    };

    /// As part of a view that has a head and read-outs of its own.
    pub const PART: Self = Self {
        titled: false,
        legend: false,
        tells: false,
        ..Self::PAGE
    };
}

impl ChartView {
    /// Draws a chart with its menu. `id` tells it apart from others; it keeps the zoom.
    pub fn show(
        ui: &mut Ui,
        chart: &Chart,
        id: impl std::hash::Hash + std::fmt::Debug,
        size: Vec2,
        theme: Theme,
    ) -> ChartResponse {
        draw(ui, chart, Id::unique(("chart", id)), size, theme, How::PAGE)
    }

    /// The same with drags left to the page: they do not pan.
    pub fn held(
        ui: &mut Ui,
        chart: &Chart,
        id: impl std::hash::Hash + std::fmt::Debug,
        size: Vec2,
        theme: Theme,
    ) -> ChartResponse {
        let how = How {
            pans: false,
            ..How::PAGE
        };
        draw(ui, chart, Id::unique(("chart", id)), size, theme, how)
    }

    /// Shows everything again.
    pub(super) fn reset(ui: &Ui, id: Id, how: How) {
        ui.data_mut(|data| {
            for key in keys(id, how) {
                data.remove::<Zoom>(key);
            }
        });
    }
}

/// What is shown of a panel, in coordinates of egui_plot: of each axis the first and the last.
type Bounds = [[f64; 2]; 2];

/// The part of an axis that was panned or zoomed to.
#[derive(Clone, Copy, PartialEq)]
struct Zoom {
    /// What the chart showed by itself, and its scale: another axis forgets the zoom.
    of: ([f64; 2], Scale),
    shown: [f64; 2],
}

fn keys(id: Id, how: How) -> [Id; 2] {
    [id.with("x zoom"), how.y_of.unwrap_or(id).with("y zoom")]
}

/// Draws a chart into a part of the window.
pub(super) fn draw(
    ui: &mut Ui,
    chart: &Chart,
    id: Id,
    size: Vec2,
    theme: Theme,
    how: How,
) -> ChartResponse {
    let (whole, _) = ui.allocate_exact_size(size.max(LEAST_SIZE), Sense::hover());
    let mut area = whole;
    let mut ui = ui.new_child(UiBuilder::new().max_rect(whole).id_salt(id));
    ui.spacing_mut().item_spacing.y = 2.0;
    let mut wish = None;
    if how.titled {
        wish = title(&mut ui, chart, theme);
        area.min.y = ui.cursor().top();
    }
    let looks = Looks {
        scale: f64::from(theme.scale),
        // Charts are written for a line of 1.8.
        line: f64::from(theme.line) / 1.8,
        whole: false,
        legend: how.legend,
    };
    let sides = [area.width(), area.height()].map(f64::from);
    let drawing = Drawing::new(chart, sides, looks);
    let origin = area.min.to_vec2();
    for (series, field) in chart.legend_series().iter().zip(&drawing.legend) {
        let rect = paint::rect(origin, *field);
        let entry = ui.interact(rect, id.with(&series.name), Sense::hover());
        named(&entry, egui::Role::Label, &series.name);
    }

    // What is drawn lies under what egui_plot shows while a hand draws a box.
    let below = ui.painter().add(egui::Shape::Noop);
    let keys = keys(id, how);
    let of = [(chart.x_limits(), chart.x_scale), ([0.0; 2], chart.y_scale)];
    let own = chart.whole_view();
    let mut bounds = [(own.x, chart.x_scale), (own.y, chart.y_scale)].map(coordinates);
    for k in 0..2 {
        let zoom = ui.data(|d| d.get_temp::<Zoom>(keys[k]));
        if let Some(zoom) = zoom.filter(|zoom| zoom.of == of[k]) {
            bounds[k] = zoom.shown;
        }
    }
    let rect = |field| paint::rect(origin, field);
    let main = panel(&mut ui, rect(drawing.main), "main", bounds, how);
    let mut shown = main.shown(bounds);
    let lower = chart.residual.as_ref().zip(drawing.lower);
    let lower = lower.map(|(lower, field)| {
        let asked = [shown[0], lower.y_limits()];
        let drawn = panel(&mut ui, rect(field), "lower", asked, how);
        shown[0] = drawn.shown(asked)[0];
        (lower, drawn.response)
    });
    if main.response.double_clicked() && how.moves && how.tells {
        ChartView::reset(&ui, id, how);
        ui.ctx().request_repaint();
    } else {
        for k in 0..2 {
            if shown[k] != bounds[k] {
                let zoom = Zoom {
                    of: of[k],
                    shown: shown[k],
                };
                ui.data_mut(|d| d.insert_temp(keys[k], zoom));
            }
        }
    }
    let view = View {
        x: values(shown[0], chart.x_scale),
        y: values(shown[1], chart.y_scale),
    };
    let shapes = paint::shapes(ui.painter(), origin, &drawing.primitives(view));
    ui.painter().set(below, egui::Shape::Vec(shapes));

    let name = match chart.title.is_empty() {
        true => "Chart",
        false => &chart.title,
    };
    named(&main.response, egui::Role::Image, name);
    if let Some((panel, response)) = &lower {
        let name = format!("{name}: {}", panel.y_label);
        named(response, egui::Role::Image, &name);
    }
    let (plot, lower_plot) = drawing.plots(view);
    let screen = |plot| Screen { plot, origin };
    let main_screen = screen(plot);
    let mut response = &main.response;
    let mut pointed = None;
    if how.tells {
        pointed = response.hover_pos().and_then(|at| {
            let hit = hit::find(&chart.series, &main_screen, at, theme)?;
            Some((hit, main_screen))
        });
        if let (None, Some((panel, lower)), Some(plot)) = (&pointed, &lower, lower_plot)
            && let Some(at) = lower.hover_pos()
        {
            response = lower;
            pointed = hit::find(&panel.series, &screen(plot), at, theme).map(|hit| {
                let series = hit.series + chart.series.len();
                (Hit { series, ..hit }, screen(plot))
            });
        }
    }
    if let Some((hit, screen)) = &pointed
        && let Some(series) = chart.all_series().nth(hit.series)
    {
        hit::mark(&ui, series, *hit, screen, theme);
        if !response.dragged() {
            hit::read_out(response, chart, series, *hit);
        }
    }
    let pointed = pointed.map(|(hit, _)| hit);
    let clicked = pointed.filter(|_| response.clicked());
    let dragged = main
        .response
        .dragged_by(egui::PointerButton::Primary)
        .then(|| main.response.interact_pointer_pos())
        .flatten();
    ChartResponse {
        dragged: dragged.map(|at| main_screen.values(at)),
        clicked,
        pointed,
        wish,
        response: main.response,
        transform: main.transform,
        main: main_screen,
    }
}

/// The title, and at its right the menu.
fn title(ui: &mut Ui, chart: &Chart, theme: Theme) -> Option<ChartWish> {
    let row = vec2(ui.available_width(), 20.0 * theme.scale);
    let layout = Layout::right_to_left(Align::Center);
    ui.allocate_ui_with_layout(row, layout, |ui| {
        let wish = menu(ui, chart);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            if chart.title.is_empty() {
                return;
            }
            let title = ui.add(Label::new(RichText::new(&chart.title).strong()).truncate());
            if !chart.notes.is_empty() {
                title.on_hover_text(chart.notes.join("\n"));
            }
        });
        wish
    })
    .inner
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
        .allow_zoom([how.moves, how.moves && is_main])
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
        Scale::Log10 => range.map(f64::log10),
    }
}

/// Coordinates of egui_plot as values.
fn values(range: [f64; 2], scale: Scale) -> [f64; 2] {
    match scale {
        Scale::Linear => range,
        Scale::Log10 => range.map(|at| 10_f64.powf(at)),
    }
}
