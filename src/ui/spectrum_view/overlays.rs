//! Spectra laid over the subject: on its axis, and named where they stand.

use eframe::egui;
use egui::{Align2, Ui, vec2};
use egui_plot::{PlotPoint, PlotTransform};

use super::{
    super::theme::{Theme, ink},
    axis::Axis,
};
use crate::app::{App, Entry};

/// An overlay's curve in plot coordinates.
pub(super) fn overlay_points(overlay: &Entry, app: &App, axis: Axis) -> Vec<[f64; 2]> {
    let spectrum = &overlay.spectrum;
    let document = app.document();
    let factor = if overlay.kind() == document.subject_entry().kind() {
        document.scale.factor(spectrum).unwrap_or(1.0)
    } else {
        // Watts and fractions have no common axis: another kind is drawn to the same height.
        let top = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
        let own = top(spectrum.samples.values());
        if own > 0.0 {
            app.scale_factor() * top(&app.derived().measured) / own
        } else {
            1.0
        }
    };
    let own = Axis { factor, ..axis };
    let samples = &spectrum.samples;
    samples
        .nm()
        .iter()
        .zip(samples.values())
        .filter_map(|(nm, v)| Some([*nm, own.place(*v)?]))
        .collect()
}

/// Overlays named in the plot; more names would hide the curves.
const MOST_NAMED: usize = 6;

/// Writes each overlay's name at its highest point in view: inks alone do not tell them apart.
pub(super) fn overlay_names(
    ui: &Ui,
    app: &App,
    theme: Theme,
    axis: Axis,
    transform: &PlotTransform,
) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let painter = ui.painter().with_clip_rect(*transform.frame());
    let [left, right] = [transform.bounds().min()[0], transform.bounds().max()[0]];
    let inks = theme.inks.overlays;
    for (i, overlay) in app.document().overlays.iter().enumerate().take(MOST_NAMED) {
        let highest = overlay_points(overlay, app, axis)
            .into_iter()
            .filter(|[nm, _]| (left..=right).contains(nm))
            .max_by(|a, b| a[1].total_cmp(&b[1]));
        let Some([nm, height]) = highest else {
            continue;
        };
        let at = transform.position_from_point(&PlotPoint::new(nm, height));
        let galley = painter.layout_no_wrap(
            overlay.name().to_owned(),
            font.clone(),
            ink(inks[i % inks.len()]),
        );
        let frame = transform.frame();
        let mut rect = Align2::LEFT_CENTER.anchor_size(at + vec2(6.0, 0.0), galley.size());
        if rect.right() > frame.right() {
            rect = Align2::RIGHT_CENTER.anchor_size(at - vec2(6.0, 0.0), galley.size());
        }
        rect = rect.translate(vec2(0.0, (frame.top() + 1.0 - rect.top()).max(0.0)));
        painter.rect_filled(rect, 2.0, theme.ground.gamma_multiply(0.75));
        painter.galley(rect.min, galley, ink(inks[i % inks.len()]));
    }
}
