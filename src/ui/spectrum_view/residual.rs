//! The residual under the spectrum, on the same wavelengths.

use eframe::egui;
use egui::{Align2, Id, Ui, vec2};
use egui_plot::{Line, Plot, PlotPoints};

use super::{
    super::{
        axes,
        theme::{Theme, ink},
    },
    Y_WIDTH, columns, width,
};
use crate::app::{App, ticks};

/// Model minus measured, linked to the main plot's horizontal axis.
pub(super) fn residual(
    ui: &mut Ui,
    app: &App,
    theme: Theme,
    factor: f64,
    height: f32,
    link: Id,
    reset: bool,
) {
    let derived = app.derived();
    let band = derived.band;
    let points: Vec<[f64; 2]> = band
        .grid()
        .zip(&derived.residual)
        .map(|(nm, v)| [nm, v * factor])
        .collect();
    let top = derived.measured.iter().fold(0.0_f64, |m, v| m.max(v.abs()));
    let least = if top > 0.0 { 1e-6 * top * factor } else { 1.0 };
    let key = &app.document().subject_entry().key;
    let plot_width = width(ui, band, theme);
    let mut plot = Plot::new(("residual", key, app.document().scale))
        .height(height)
        .width(plot_width)
        .x_grid_spacer(axes::marks(columns(plot_width, band, theme)))
        .link_axis(link, [true, false])
        .link_cursor(link, [true, false])
        .allow_scroll(false)
        .allow_double_click_reset(false)
        .show_crosshair(false)
        .default_x_bounds(band.min_nm(), band.max_nm())
        .auto_bounds([false, true])
        // Rounding is not worth an axis of its own.
        .include_y(-least)
        .include_y(least)
        .set_margin_fraction(vec2(0.0, 0.12))
        .y_grid_spacer(axes::marks((height / (36.0 * theme.scale)) as usize))
        .label_formatter(|_| None);
    plot = axes::dress(
        plot,
        theme,
        Y_WIDTH * theme.scale,
        |_| String::new(),
        ticks::short,
    );
    if reset {
        plot = plot.reset();
    }
    let response = plot.show(ui, |plot| {
        if !app.is_measured_in_range() {
            return;
        }
        plot.line(
            Line::new("residual", PlotPoints::from(points))
                .color(ink(theme.inks.residual))
                .width(theme.line)
                .allow_hover(false),
        );
    });
    response.response.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Image, true, "Residual: model minus measured")
    });
    let frame = response.transform.frame();
    ui.painter().text(
        frame.left_top() + vec2(6.0, 4.0),
        Align2::LEFT_TOP,
        "model − measured",
        egui::TextStyle::Small.resolve(ui.style()),
        theme.faint,
    );
}
