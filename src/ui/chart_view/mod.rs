//! A [`Chart`] in the window: the drawing that its files have, with read-outs, clicks and a menu
//! to save it.
//!
//! A drag pans, the wheel zooms around the pointer (with Ctrl where the page scrolls), a drag with
//! the right button zooms into a box, a click of it opens the menu, a double click or the button
//! "fit" shows everything again. In a chart whose page has something to drag
//! ([`ChartView::held`]) a drag is the page's and pans nothing.

mod hands;
mod hit;
mod kept;
mod menu;
pub mod paint;
mod screen;

use eframe::egui;
use egui::{Align, Id, Label, Layout, Response, RichText, Sense, Ui, UiBuilder, Vec2, vec2};
use egui_plot::PlotTransform;

use super::{kit::named, theme::Theme};
use crate::app::chart::{Chart, Drawing, Looks, Plot, Series};
use hands::Hands;
pub(super) use hands::reset;
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
    /// Whether a double click shows everything again.
    pub fits: bool,
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
        fits: true,
        y_of: None,
    };

    /// As part of a view that has a head and read-outs of its own.
    pub(super) const PART: Self = Self {
        titled: false,
        legend: false,
        tells: false,
        ..Self::PAGE
    };

    fn looks(self, theme: Theme) -> Looks {
        Looks {
            scale: f64::from(theme.scale),
            // Charts are written for a line of 1.8.
            line: f64::from(theme.line) / 1.8,
            whole: false,
            legend: self.legend,
            theme: theme.of_charts(),
        }
    }
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
    // The head is above the drawing in a row of charts too.
    let down = Layout::top_down(Align::Min);
    let builder = UiBuilder::new().max_rect(whole).layout(down).id_salt(id);
    let mut ui = ui.new_child(builder);
    ui.spacing_mut().item_spacing.y = 2.0;
    let mut wish = None;
    if how.titled {
        wish = title(&mut ui, chart, theme);
        area.min.y = ui.cursor().top();
    }
    let sides = [area.width(), area.height()].map(f64::from);
    let looks = how.looks(theme);
    let drawing = Drawing::new(chart, sides, looks);
    let origin = area.min.to_vec2();
    for (series, field) in chart.legend_series().iter().zip(&drawing.legend) {
        let rect = paint::rect(origin, *field);
        let entry = ui.interact(rect, id.with(&series.name), Sense::hover());
        named(&entry, egui::Role::Label, &series.name);
    }

    // What is drawn lies under what egui_plot shows while a hand draws a box.
    let below = ui.painter().add(egui::Shape::Noop);
    let hands = Hands::on(&mut ui, &drawing, origin, id, how);
    let shapes = kept::shapes(&ui, id, (&drawing, looks), hands.view, origin);
    ui.painter().set(below, egui::Shape::Vec(shapes));
    let name = match chart.title.is_empty() {
        true => said!("Chart"),
        false => &chart.title,
    };
    named(&hands.main, egui::Role::Image, name);
    if let Some((panel, response)) = chart.residual.as_ref().zip(hands.lower.as_ref()) {
        let name = crate::languages::with_colon(name, &panel.y_label);
        named(response, egui::Role::Image, &name);
    }

    let (main, lower) = drawing.plots(hands.view);
    let screen = |plot| Screen { plot, origin };
    let over = |series: &[Series], response: &Response, plot: Plot| {
        let at = response.hover_pos().filter(|_| how.tells)?;
        let hit = hit::find(series, &screen(plot), at, theme)?;
        Some((hit, screen(plot), response.clone()))
    };
    let in_lower = || {
        let panel = chart.residual.as_ref()?;
        let (hit, screen, response) = over(&panel.series, hands.lower.as_ref()?, lower?)?;
        let series = hit.series + chart.series.len();
        Some((Hit { series, ..hit }, screen, response))
    };
    let pointed = over(&chart.series, &hands.main, main).or_else(in_lower);
    if let Some((hit, screen, response)) = &pointed
        && let Some(series) = chart.all_series().nth(hit.series)
    {
        hit::mark(&ui, series, *hit, screen, theme);
        if !response.dragged() {
            hit::read_out(response, chart, series, *hit);
        }
    }
    let main = screen(main);
    let response = hands.main;
    wish = wish.or_else(|| menu::on_right_click(&response, chart));
    let dragged = response.dragged_by(egui::PointerButton::Primary);
    let dragged = response.interact_pointer_pos().filter(|_| dragged);
    let clicked = pointed.as_ref().filter(|(_, _, over)| over.clicked());
    ChartResponse {
        dragged: dragged.map(|at| main.values(at)),
        clicked: clicked.map(|(hit, ..)| *hit),
        pointed: pointed.as_ref().map(|(hit, ..)| *hit),
        wish,
        response,
        transform: hands.transform,
        main,
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
