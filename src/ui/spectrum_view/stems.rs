//! Spikes as stems: where they stand, how they are drawn, what is written above them.

use eframe::egui;
use egui::{Align2, Color32, Rect, Ui, vec2};
use egui_plot::{Line, PlotPoint, PlotPoints, PlotTransform, Points};

use super::{super::theme::Theme, axis::Axis};
use crate::{app::App, spectrum::Spike};

/// Foot and tip of each stem in the spectrum's own numbers.
pub(super) fn stem_tips(
    spikes: &[Spike],
    width_nm: f64,
    base_at: impl Fn(f64) -> f64,
) -> Vec<(f64, f64, f64)> {
    spikes
        .iter()
        .map(|s| {
            let base = base_at(s.at_nm);
            (s.at_nm, base, base + s.stem_height(width_nm))
        })
        .collect()
}

/// Draws stems with their heads.
pub(super) fn draw_stems(
    plot: &mut egui_plot::PlotUi<'_>,
    tips: &[(f64, f64, f64)],
    axis: Axis,
    theme: Theme,
    colour: Color32,
    radius: f32,
) {
    let mut heads = Vec::new();
    for (nm, base, tip) in tips {
        let foot = axis.place(*base).unwrap_or_else(|| axis.floor.log10());
        let Some(top) = axis.place(*tip) else {
            continue;
        };
        plot.line(
            Line::new("", PlotPoints::from(vec![[*nm, foot], [*nm, top]]))
                .color(colour)
                .width(theme.line * 1.2)
                .allow_hover(false),
        );
        heads.push([*nm, top]);
    }
    plot.points(
        Points::new("spikes", PlotPoints::from(heads))
            .color(colour)
            .radius(radius * theme.scale)
            .allow_hover(false),
    );
}

/// Where the model's tips stand in plot coordinates.
pub(super) fn tips(app: &App, axis: Axis) -> Vec<Option<[f64; 2]>> {
    let derived = app.derived();
    let width = app.document().settings.max_width_nm;
    stem_tips(&derived.model.spikes, width, |nm| {
        derived.band.interpolate(&derived.smooth, nm)
    })
    .into_iter()
    .map(|(nm, _, tip)| Some([nm, axis.place(tip)?]))
    .collect()
}

/// Labels above the tips: moved up where they would overlap, left out where there is no room.
pub(super) fn labels(ui: &Ui, app: &App, theme: Theme, axis: Axis, transform: &PlotTransform) {
    let font = egui::TextStyle::Small.resolve(ui.style());
    let painter = ui.painter().with_clip_rect(*transform.frame());
    let mut taken: Vec<Rect> = Vec::new();
    for ((spike, name), tip) in app
        .derived()
        .model
        .spikes
        .iter()
        .zip(app.spike_names())
        .zip(tips(app, axis))
    {
        let Some([x, y]) = tip else { continue };
        let text = match &name.label {
            Some(name) => name.clone(),
            None => format!("{:.1}", spike.at_nm),
        };
        let galley = painter.layout_no_wrap(text, font.clone(), ui.visuals().text_color());
        let tip = transform.position_from_point(&PlotPoint::new(x, y));
        let mut rect = Align2::CENTER_BOTTOM.anchor_size(tip - vec2(0.0, 7.0), galley.size());
        let frame = transform.frame();
        // Beside the frame's edges a label slides in; above its top it hangs below the edge.
        rect = rect.translate(vec2(
            (frame.left() + 2.0 - rect.left()).max(0.0)
                - (rect.right() - frame.right() + 2.0).max(0.0),
            (frame.top() + 2.0 - rect.top()).max(0.0),
        ));
        const MOST_ROWS: usize = 5;
        let mut rows = 0;
        while rows < MOST_ROWS && taken.iter().any(|t| t.expand(1.0).intersects(rect)) {
            rect = rect.translate(vec2(0.0, -galley.size().y));
            rows += 1;
        }
        if rows == MOST_ROWS || rect.top() < frame.top() {
            continue;
        }
        let ground = theme.ground.gamma_multiply(0.75);
        painter.rect_filled(rect.expand2(vec2(2.0, 0.0)), 2.0, ground);
        painter.galley(rect.min, galley, ui.visuals().text_color());
        taken.push(rect);
    }
}
