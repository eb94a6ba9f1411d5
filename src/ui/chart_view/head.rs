//! Over the panels: title, menu, names of the series; under them, in pictures, the notes.

use eframe::egui;
use egui::{Align, Label, Layout, Rect, RichText, Sense, Ui, UiBuilder, vec2};

use super::{
    super::theme::Theme,
    marks,
    menu::{ChartWish, menu},
};
use crate::app::plot_svg::Chart;

/// The title, and at its right the menu.
pub(super) fn title(ui: &mut Ui, chart: &Chart, theme: Theme, bare: bool) -> Option<ChartWish> {
    if bare {
        if !chart.title.is_empty() {
            ui.label(RichText::new(&chart.title).heading());
        }
        return None;
    }
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

/// Names of the series with samples, in as many rows as they need.
pub(super) fn legend(ui: &mut Ui, chart: &Chart, theme: Theme) {
    let entries = chart.legend_series();
    if entries.is_empty() {
        return;
    }
    let height = ui.text_style_height(&egui::TextStyle::Small);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 5.0;
        for series in entries {
            // Sample and name stay together where the row ends.
            let name = egui::WidgetText::from(RichText::new(&series.name).small());
            let longest = ui.max_rect().width() - 40.0;
            let galley = name.into_galley(
                ui,
                Some(egui::TextWrapMode::Truncate),
                longest,
                egui::TextStyle::Small,
            );
            let sample = 22.0 * theme.scale;
            let size = vec2(sample + 5.0 + galley.size().x + 12.0, height);
            let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
            response
                .widget_info(|| egui::WidgetInfo::labeled(egui::Role::Label, true, &series.name));
            let mark = Rect::from_min_size(rect.min, vec2(sample, rect.height()));
            marks::sample(ui.painter(), series, mark, theme);
            let colour = ui.visuals().text_color();
            let corner = rect.min + vec2(sample + 5.0, (rect.height() - galley.size().y) / 2.0);
            ui.painter().galley(corner, galley, colour);
        }
    });
}

/// Writes the notes at the lower end of an area and returns the height they take.
pub(super) fn notes(ui: &mut Ui, chart: &Chart, area: Rect, theme: Theme) -> f32 {
    if chart.notes.is_empty() {
        return 0.0;
    }
    let font = egui::TextStyle::Small.resolve(ui.style());
    let text = chart.notes.join("\n");
    let galley = ui.painter().layout(text, font, theme.faint, area.width());
    let height = galley.size().y;
    let corner = egui::pos2(area.left(), area.bottom() - height);
    let rect = Rect::from_min_size(corner, galley.size());
    // A widget of its own, for those who have the picture read out.
    let inner = ui.new_child(UiBuilder::new().max_rect(rect).id_salt("notes"));
    inner.painter().galley(corner, galley, theme.faint);
    height + 6.0
}
