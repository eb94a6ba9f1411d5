//! The values under the pointer.

use eframe::egui;
use egui::{Color32, Rect, Ui, vec2};

use super::super::{
    chart_view::Screen,
    theme::{Theme, grey},
};
use crate::{
    app::{App, answers::spike_words, spike_under, ticks},
    color::{Srgb, srgb_from_wavelength_over},
    languages::fixed,
};

/// How near to a spike's place the pointer must be to be on it, points.
const SPIKE_REACH: f32 = 6.0;

/// The values under the pointer, in the plot's top right corner; in the left one where the pointer is
/// there.
pub(super) fn hover(ui: &Ui, app: &App, theme: Theme, plot: &Screen) {
    let Some(pointer) = ui.input(|i| i.pointer.hover_pos()) else {
        return;
    };
    // A dialog may lie over the plot.
    if !ui.rect_contains_pointer(plot.frame()) {
        return;
    }
    let derived = app.derived();
    let [nm, _] = plot.values(pointer);
    if !derived.band.contains(nm) {
        return;
    }
    ui.painter()
        .vline(pointer.x, plot.frame().y_range(), (0.6, theme.faint));
    let value =
        |values: &[f64]| ticks::short(app.scale_factor() * derived.band.interpolate(values, nm));
    let samples = &app.document().subject_entry().spectrum.samples;
    let measured = if (samples.first_nm()..=samples.last_nm()).contains(&nm) {
        tr!("measured {value}", value = value(&derived.measured))
    } else {
        said!("not measured").to_owned()
    };
    let mut text = tr!(
        "{place} nm   {measured}   model {value}",
        place = fixed(nm, 1),
        measured,
        value = value(&derived.model_values())
    );
    // A line is named where a spike stands, and nowhere else.
    let reach = (plot.values(pointer + egui::vec2(SPIKE_REACH, 0.0))[0] - nm).abs();
    let under = spike_under(derived.model.lines(), app.spike_names(), nm, reach);
    if let Some((spike, name)) = under {
        text = spike_words(app, *spike, name);
    }
    let [r, g, b, _] = theme.ground.to_array();
    let Srgb([r, g, b]) = srgb_from_wavelength_over(nm, Srgb([r, g, b]));
    let font = egui::TextStyle::Body.resolve(ui.style());
    let galley = ui
        .painter()
        .layout_no_wrap(text, font, ui.visuals().strong_text_color());
    let size = galley.size() + vec2(38.0, 10.0);
    let frame = plot.frame().shrink(6.0);
    let right = Rect::from_min_size(frame.right_top() - vec2(size.x, 0.0), size);
    let ground = match right.expand(12.0).contains(pointer) {
        true => Rect::from_min_size(frame.min, size),
        false => right,
    };
    let corner = ground.min + vec2(30.0, 5.0);
    let field = Rect::from_min_size(
        ground.min + vec2(8.0, 6.0),
        vec2(14.0, galley.size().y - 2.0),
    );
    let painter = ui.painter().with_clip_rect(plot.frame());
    painter.rect_filled(ground, 3.0, ui.visuals().panel_fill);
    painter.rect_filled(field, 2.0, Color32::from_rgb(r, g, b));
    painter.rect_stroke(
        field,
        2.0,
        egui::Stroke::new(1.0, grey(128)),
        egui::StrokeKind::Outside,
    );
    painter.galley(corner, galley, ui.visuals().strong_text_color());
}
