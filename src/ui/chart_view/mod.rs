//! A [`Chart`] in the window: the same data that its files have, with read-outs, clicks and a menu
//! to save it.
//!
//! egui_plot has the grid, the vertical axis, panning and zooming; the marks are painted here, so
//! that heat maps, forms and dashes look as they do in files. A drag pans, Ctrl and the wheel
//! zoom, the right button zooms into a box, a double click shows everything again. In a chart
//! whose page has something to drag ([`ChartView::held`]) a drag is the page's and pans nothing.

mod bar;
mod edge;
mod head;
mod hit;
mod marks;
mod menu;
mod place;

use eframe::egui;
use egui::{Id, Rect, Response, Sense, Ui, UiBuilder, Vec2, pos2, vec2};
use egui_plot::{Plot, PlotBounds, PlotTransform};

use super::{
    axes,
    model_view::named,
    theme::{Theme, grey},
};
use crate::app::{
    plot_svg::{Chart, Scale, Series},
    ticks,
};
use edge::Edge;
pub use hit::Hit;
pub use menu::{ChartForm, ChartWish};
use place::{Place, coordinate};

/// Smallest chart, points.
const LEAST_SIZE: Vec2 = vec2(140.0, 110.0);

/// Part of the panels' height that the lower panel gets.
const LOWER_SHARE: f32 = 0.3;

/// Height of the colour strip, points.
const STRIP: f32 = 12.0;

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
        draw(ui, chart, Id::unique(("chart", id)), size, theme, LIVE)
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
            ..LIVE
        };
        draw(ui, chart, Id::unique(("chart", id)), size, theme, how)
    }

    /// Draws a chart with its notes and without its menu, for pictures.
    pub fn bare(ui: &mut Ui, chart: &Chart, size: Vec2, theme: Theme) -> ChartResponse {
        let how = How { bare: true, ..LIVE };
        draw(ui, chart, Id::unique("bare chart"), size, theme, how)
    }
}

/// How a chart is drawn.
#[derive(Clone, Copy)]
struct How {
    /// With its notes and without its menu.
    bare: bool,
    /// Whether a drag pans.
    pans: bool,
}

/// As charts in the window are.
const LIVE: How = How {
    bare: false,
    pans: true,
};

/// What is shown of the main panel, in plot coordinates: `[x, y]` from low to high.
type Bounds = [[f64; 2]; 2];

/// A part of the chart that was panned or zoomed to.
#[derive(Clone, Copy, PartialEq)]
struct Zoom {
    /// What the chart showed by itself across, and its scales: another axis forgets the zoom.
    of: ([f64; 2], Scale, Scale),
    shown: Bounds,
}

fn draw(ui: &mut Ui, chart: &Chart, id: Id, size: Vec2, theme: Theme, how: How) -> ChartResponse {
    let How { bare, pans } = how;
    let (whole, _) = ui.allocate_exact_size(size.max(LEAST_SIZE), Sense::hover());
    let mut area = whole;
    let mut ui = ui.new_child(UiBuilder::new().max_rect(whole).id_salt(id));
    ui.spacing_mut().item_spacing.y = 2.0;
    let wish = head::title(&mut ui, chart, theme, bare);
    head::legend(&mut ui, chart, theme);
    area.min.y = ui.cursor().top() + 2.0;
    if bare {
        area.max.y -= head::notes(&mut ui, chart, area, theme);
    }
    let layout = Layout::new(&ui, chart, area, theme);
    layout.y_labels(&ui, chart, theme);

    let key = id.with("zoom");
    let of = (chart.x_limits(), chart.x_scale, chart.y_scale);
    let zoom: Option<Zoom> = ui.data(|d| d.get_temp::<Zoom>(key)).filter(|z| z.of == of);
    let own = [
        chart.x_limits().map(|x| coordinate(x, chart.x_scale)),
        chart.y_limits().map(|y| coordinate(y, chart.y_scale)),
    ];
    let bounds = zoom.map_or(own, |zoom| zoom.shown);
    let main = layout.panel(&mut ui, chart, ("main", pans), bounds, theme);
    let lower = chart.residual.as_ref().map(|panel| {
        let bounds = [bounds[0], panel.y_limits()];
        (
            panel,
            layout.panel(&mut ui, chart, ("lower", false), bounds, theme),
        )
    });
    remember(&ui, key, of, &main);

    let title = if chart.title.is_empty() {
        "Chart"
    } else {
        &chart.title
    };
    named(&main.response, egui::Role::Image, title);
    let place = Place::new(main.transform, chart.x_scale, chart.y_scale);
    marks::paint(&ui, &chart.series, &place, theme);
    let lower = lower.map(|(panel, drawn)| {
        let name = format!("{title}: {}", panel.y_label);
        named(&drawn.response, egui::Role::Image, &name);
        let place = Place::new(drawn.transform, chart.x_scale, Scale::Linear);
        marks::paint(&ui, &panel.series, &place, theme);
        (panel, drawn, place)
    });
    if let Some(colours) = &chart.strip {
        edge::strip(&ui, colours, chart.x_limits(), &place);
    }
    layout.edge.draw(&ui, chart, &place, layout.foot, theme);
    if let Some(cells) = chart.heat_map() {
        bar::draw(&ui, cells, *main.transform.frame(), theme);
    }

    let pointed_main = main.response.hover_pos().and_then(|at| {
        let hit = hit::find(&chart.series, &place, at, theme)?;
        Some((hit, &place))
    });
    let pointed_lower = || {
        let (panel, drawn, place) = lower.as_ref()?;
        let hit = hit::find(&panel.series, place, drawn.response.hover_pos()?, theme)?;
        let series = hit.series + chart.series.len();
        Some((Hit { series, ..hit }, place))
    };
    let pointed = pointed_main.or_else(pointed_lower);
    let response = match &lower {
        Some((_, drawn, _)) if drawn.response.hovered() => &drawn.response,
        _ => &main.response,
    };
    if let Some((hit, place)) = &pointed
        && let Some(series) = chart.all_series().nth(hit.series)
    {
        hit::mark(&ui, series, *hit, place, theme);
        if !response.dragged() {
            hit::read_out(response, chart, series, *hit);
        }
    }
    let pointed = pointed.map(|(hit, _)| hit);
    let dragged = main
        .response
        .dragged_by(egui::PointerButton::Primary)
        .then(|| main.response.interact_pointer_pos())
        .flatten();
    ChartResponse {
        dragged: dragged.map(|at| place.values(at)),
        clicked: pointed.filter(|_| response.clicked()),
        pointed,
        wish,
        response: main.response,
        transform: main.transform,
    }
}

/// A panel as egui_plot drew it.
struct Drawn {
    response: Response,
    transform: PlotTransform,
    asked: Bounds,
}

/// Keeps what a hand did to the view; a double click forgets it.
fn remember(ui: &Ui, key: Id, of: ([f64; 2], Scale, Scale), main: &Drawn) {
    if main.response.double_clicked() {
        ui.data_mut(|d| d.remove::<Zoom>(key));
        ui.ctx().request_repaint();
        return;
    }
    let (min, max) = (main.transform.bounds().min(), main.transform.bounds().max());
    let shown = [[min[0], max[0]], [min[1], max[1]]];
    let by_hand = main.response.contains_pointer() || main.response.dragged();
    let sound = shown.iter().all(|[low, high]| low < high);
    if shown != main.asked && by_hand && sound {
        ui.data_mut(|d| d.insert_temp(key, Zoom { of, shown }));
    }
}

/// Where the parts of a chart stand.
struct Layout {
    main: Rect,
    lower: Option<Rect>,
    /// Where the labels of the horizontal axis begin.
    foot: f32,
    y_width: f32,
    edge: Edge,
    across: usize,
}

impl Layout {
    fn new(ui: &Ui, chart: &Chart, area: Rect, theme: Theme) -> Self {
        let line = edge::line_height(ui);
        let numbers = y_width(ui, chart, area, theme);
        let beyond = chart.heat_map().map_or(14.0 * theme.scale, |cells| {
            bar::room(ui, cells, area.height())
        });
        let width = (area.width() - beyond).max(60.0);
        let edge = Edge::new(ui, chart, width - numbers);
        let y_width = numbers.max(edge.overhang).min(0.5 * width);

        let top = area.top() + label_room(&chart.y_label, chart, line);
        let strip = if chart.strip.is_some() {
            STRIP + 3.0
        } else {
            0.0
        };
        let room = (area.bottom() - top - strip - edge.height).max(40.0);
        let between = 2.0 + line + edge::LIFT;
        let share = if chart.residual.is_some() {
            LOWER_SHARE
        } else {
            0.0
        };
        let panels = (room - if share > 0.0 { between } else { 0.0 }).max(40.0);
        let at = |top: f32, height: f32| {
            Rect::from_min_size(pos2(area.left(), top), vec2(width, height))
        };
        let main = at(top, panels * (1.0 - share));
        let bottom = main.bottom() + strip;
        let lower = (share > 0.0).then(|| at(bottom + between, panels * share));
        Self {
            main,
            lower,
            foot: lower.map_or(bottom, |lower| lower.bottom()),
            y_width,
            edge,
            across: ((width - y_width) / (70.0 * theme.scale)).clamp(2.0, 14.0) as usize,
        }
    }

    /// What the vertical axes count, over their upper ends; names of axes never cover data.
    fn y_labels(&self, ui: &Ui, chart: &Chart, theme: Theme) {
        let lower = self.lower.iter().zip(&chart.residual);
        let lower = lower.map(|(rect, panel)| (*rect, panel.y_label.as_str()));
        for (rect, label) in [(self.main, chart.y_label.as_str())]
            .into_iter()
            .chain(lower)
        {
            edge::y_label(ui, label, rect, theme);
        }
    }

    /// An empty panel: grid and vertical axis.
    fn panel(
        &self,
        ui: &mut Ui,
        chart: &Chart,
        (name, pans): (&str, bool),
        bounds: Bounds,
        theme: Theme,
    ) -> Drawn {
        let is_main = name == "main";
        let rect = if is_main {
            self.main
        } else {
            self.lower.unwrap_or(self.main)
        };
        let y_scale = if is_main {
            chart.y_scale
        } else {
            Scale::Linear
        };
        let down = down(rect.height(), theme);
        let (marks, labels) = y_ticks(bounds[1], y_scale, down);
        let mut ui = ui.new_child(UiBuilder::new().max_rect(rect).id_salt(name));
        let plot = Plot::new(name)
            .width(rect.width())
            .height(rect.height())
            .show_axes([false, true])
            .show_x(false)
            .show_y(false)
            .show_crosshair(false)
            .allow_drag(pans)
            .allow_zoom(is_main)
            .allow_boxed_zoom(is_main)
            .allow_scroll(false)
            .allow_axis_zoom_drag(false)
            .allow_double_click_reset(false)
            .label_formatter(|_| None);
        let across = self.across;
        let plot = match (chart.x_names.is_empty(), chart.x_scale) {
            // Names have no in-between that a line could help to read.
            (false, _) => plot.x_grid_spacer(|_| Vec::new()),
            (true, Scale::Linear) => plot.x_grid_spacer(axes::marks(across)),
            (true, Scale::Log10) => plot.x_grid_spacer(axes::log_marks(across)),
        };
        let plot = match y_scale {
            Scale::Linear => plot.y_grid_spacer(axes::marks(down)),
            Scale::Log10 => plot.y_grid_spacer(axes::log_marks(down)),
        };
        // Marks of a view that a hand is moving just now are not yet among the labels.
        let words = move |at: f64| match marks.iter().position(|mark| *mark == at) {
            Some(index) => labels[index].clone(),
            None => ticks::short(place::value(at, y_scale)),
        };
        let small = egui::TextStyle::Small.resolve(ui.style());
        ui.style_mut()
            .text_styles
            .insert(egui::TextStyle::Body, small);
        let plot = axes::dress(plot, theme, self.y_width, |_| String::new(), words);
        let shown = plot.show(&mut ui, |plot| {
            let [x, y] = bounds;
            plot.set_plot_bounds(PlotBounds::from_min_max([x[0], y[0]], [x[1], y[1]]));
        });
        let zero = shown.transform.position_from_point_y(0.0);
        let frame = *shown.transform.frame();
        let is_map = is_main && chart.heat_map().is_some();
        if y_scale == Scale::Linear
            && !is_map
            && (frame.top()..frame.bottom() - 1.0).contains(&zero)
        {
            let colour = grey(if theme.dark { 95 } else { 150 });
            ui.painter().hline(frame.x_range(), zero, (1.0, colour));
        }
        Drawn {
            response: shown.response,
            transform: shown.transform,
            asked: bounds,
        }
    }
}

/// Room over a panel for the name of its vertical axis.
fn label_room(label: &str, chart: &Chart, line: f32) -> f32 {
    let bar = chart
        .heat_map()
        .is_some_and(|cells| !cells.label.is_empty());
    if label.is_empty() && !bar {
        4.0
    } else {
        line + edge::LIFT
    }
}

/// About how many marks a vertical axis has.
fn down(height: f32, theme: Theme) -> usize {
    (height / (36.0 * theme.scale)).clamp(3.0, 10.0) as usize
}

/// Marks of a vertical axis, in coordinates of the plot, and what is written at them.
fn y_ticks([low, high]: [f64; 2], scale: Scale, target: usize) -> (Vec<f64>, Vec<String>) {
    match scale {
        Scale::Linear => {
            let marks = ticks::nice_ticks(low, high, target);
            let labels = ticks::tick_labels(&marks);
            (marks, labels)
        }
        Scale::Log10 => {
            let marks = ticks::log_ticks(10_f64.powf(low), 10_f64.powf(high), target);
            let labels = marks.iter().copied().map(ticks::short).collect();
            (marks.into_iter().map(f64::log10).collect(), labels)
        }
    }
}

/// Room for the widest number of the vertical axes, points.
fn y_width(ui: &Ui, chart: &Chart, area: Rect, theme: Theme) -> f32 {
    let down = down(area.height(), theme);
    let own = chart.y_limits().map(|y| coordinate(y, chart.y_scale));
    let lower = chart.residual.iter().map(|p| (p.y_limits(), Scale::Linear));
    let widths = std::iter::once((own, chart.y_scale))
        .chain(lower)
        .flat_map(|(limits, scale)| y_ticks(limits, scale, down).1)
        .map(|label| edge::width(ui, &label, &egui::TextStyle::Small));
    widths.fold(24.0, f32::max) + 12.0
}

/// The colour of a series.
fn colour_of(series: &Series) -> egui::Color32 {
    super::theme::ink(series.colour)
}
