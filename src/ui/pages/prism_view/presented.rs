//! Prism and rainbow before a class: the drawing, the strip below it, and three sliders.

use crate::ui::kit::slide;
use eframe::egui;
use egui::{Slider, Ui, vec2};

use super::{PrismView, axis_of, drawn, drop, model, names, strips, told};
use crate::{
    app::{
        dispersion::{PrismShown, RainbowShown, StripShown, sky},
        pages::{PrismMemory, RainbowMemory, STOPS},
    },
    languages::{fixed, said},
    ui::{
        kit::form,
        pages::{PageContext, presented::head},
        theme::Theme,
    },
};

/// Most that the strip's rows grow by: the drawing needs the room.
const STRIP_SCALE: f32 = 1.5;

/// Looks of the strip, and the strip of the light alone without the plot below it.
fn only_first(all: &[StripShown], theme: Theme) -> (Theme, Vec<StripShown>) {
    let theme = Theme {
        scale: theme.scale.min(STRIP_SCALE),
        ..theme
    };
    let first = all.iter().take(1).cloned();
    let first = first.map(|strip| StripShown {
        heights: Vec::new(),
        ..strip
    });
    (theme, first.collect())
}

/// Room for a slider's value, points of usual type.
const VALUE: f32 = 64.0;

/// Main controls at the foot, each under its name.
fn row<const N: usize>(ui: &mut Ui, theme: Theme, add: [&mut dyn FnMut(&mut Ui); N]) {
    ui.columns(N, |columns| {
        for (ui, add) in columns.iter_mut().zip(add) {
            ui.spacing_mut().slider_width = ui.available_width() - VALUE * theme.scale;
            add(ui);
        }
    });
}

/// Height of that row, points.
fn row_height(ui: &Ui) -> f32 {
    let line = ui.text_style_height(&egui::TextStyle::Body);
    line + ui.spacing().interact_size.y + 4.0 * ui.spacing().item_spacing.y
}

/// Keeps the height of what stands below the drawing for the next frame, which comes at once where
/// it was another.
fn measured(ui: &Ui, top: f32, below: &mut Option<f32>) {
    let height = ui.cursor().top() - top;
    if below.is_none_or(|before| (before - height).abs() > 0.5) {
        *below = Some(height);
        ui.ctx().request_repaint();
    }
}

/// A slider below its name.
fn below(ui: &mut Ui, (name, meaning): (&str, &str), slider: Slider<'_>) {
    let label = ui.label(name).on_hover_text(meaning);
    ui.add(slider).labelled_by(label.id).on_hover_text(meaning);
}

fn exposed(ui: &mut Ui, stops: &mut f64) {
    let of = slide(stops, STOPS.range()).step_by(0.1).fixed_decimals(1);
    let meaning = said!("Brightness of the picture, in stops; each doubles it.");
    below(ui, (said(names::EXPOSURE), meaning), of);
}

/// Height of a strip without words below it, points.
fn strip_height(strip: &[StripShown], axis: &strips::Axis<'_>, theme: Theme) -> f32 {
    const WORDS: f32 = 40.0;
    strips::height(strip, axis, theme) - WORDS * theme.scale
}

impl PrismView {
    /// The bench and the strip; whether a hand wants the whole window back.
    pub(in crate::ui::pages) fn present_prism(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
        in_lesson: bool,
    ) -> bool {
        let key = (context.app.revision(), context.pages.prism.clone());
        let app = context.app;
        let shown = &*self
            .prism
            .get(key, |(_, memory)| PrismShown::of(app, memory));
        let leaves = head(ui, &shown.sentence);
        let (theme, strip) = only_first(&shown.strips, context.theme);
        let tells = |x_mm: f64| told(shown, x_mm);
        let axis = axis_of(shown, &tells);
        let guess = || strip_height(&strip, &axis, theme) + row_height(ui);
        let left = ui.available_height() - self.below[0].unwrap_or_else(guess);
        let size = vec2(ui.available_width(), left.max(super::LEAST));
        drawn(ui, context, (shown, &axis), size);
        let top = ui.cursor().top();
        strips::show(ui, &strip, &axis, theme);
        let theme = context.theme;
        let bench = &mut context.pages.prism;
        let (apex, slit, stops) = (&mut bench.apex_deg, &mut bench.slit_mm, &mut bench.stops);
        let apex = &mut |ui: &mut Ui| {
            let of = slide(apex, PrismMemory::APEX.reach.range())
                .step_by(0.5)
                .suffix("\u{b0}");
            let meaning = said!("The angle between the two faces that the light goes through.");
            below(ui, (said(names::APEX), meaning), of);
        };
        let slit = &mut |ui: &mut Ui| {
            let of = slide(slit, PrismMemory::SLIT.reach.range())
                .logarithmic(true)
                .fixed_decimals(2)
                .suffix(" mm");
            let meaning =
                said!("Width of the beam. Wide, lines run together and the middle turns white.");
            below(ui, (said(names::SLIT), meaning), of);
        };
        if in_lesson {
            // The lesson points at it.
            let sent = bench.sent;
            let lines = &mut |ui: &mut Ui| {
                ui.spacing_mut().slider_width = 0.4 * ui.available_width();
                form(ui, "lines presented", |form| {
                    model::knobs(form, context, sent)
                });
            };
            row(ui, theme, [lines]);
        } else {
            let bright = &mut |ui: &mut Ui| exposed(ui, stops);
            row(ui, theme, [apex, slit, bright]);
        }
        measured(ui, top, &mut self.below[0]);
        leaves
    }

    /// The drop, the sky and the strip; whether a hand wants the whole window back.
    pub(in crate::ui::pages) fn present_rainbow(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
    ) -> bool {
        let key = (context.app.revision(), context.pages.rainbow);
        let app = context.app;
        let sky = &*self.sky.get((), |()| sky());
        let shown = &*self
            .rainbow
            .get(key, |(_, memory)| RainbowShown::of(app, memory, sky));
        let leaves = head(ui, &shown.sentence);
        let (theme, strip) = only_first(&shown.strips, context.theme);
        let axis = strips::Axis {
            ends: shown.ends_deg,
            label: said!("° from the point opposite the sun"),
            nm: &[],
            tells: &|angle| {
                tr!(
                    "{angle}° from the point opposite the sun",
                    angle = fixed(angle, 2)
                )
            },
        };
        let guess = || strip_height(&strip, &axis, theme) + row_height(ui);
        let left = ui.available_height() - self.below[1].unwrap_or_else(guess);
        let high = left.max(super::LEAST);
        let picture = &mut self.picture;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            if let Some(drawing) = &shown.drop {
                let wide = high.min(0.4 * ui.available_width());
                let moved = drop::show(ui, drawing, vec2(wide, high), context.theme);
                let impact = &mut context.pages.rainbow.impact;
                *impact = moved.map_or(*impact, |to| {
                    to.clamp(
                        *RainbowMemory::IMPACT.reach.range().start(),
                        *RainbowMemory::IMPACT.reach.range().end(),
                    )
                });
            }
            if let Some(strip) = shown.strips.first() {
                let size = vec2(ui.available_width(), high);
                let colours = (&strip.colours.rgb[..], shown.ends_deg);
                picture.show(ui, colours, (size, None), context.theme);
            }
        });
        let top = ui.cursor().top();
        strips::show(ui, &strip, &axis, theme);
        let memory = &mut context.pages.rainbow;
        let (stops, impact) = (&mut memory.stops, &mut memory.impact);
        let bright = &mut |ui: &mut Ui| exposed(ui, stops);
        let rays = &mut |ui: &mut Ui| {
            let of = slide(impact, RainbowMemory::IMPACT.reach.range())
                .fixed_decimals(2)
                .suffix(" r");
            let meaning = said!("How far off its middle the coloured rays meet the drop, radii.");
            below(ui, (said(names::IMPACT), meaning), of);
        };
        row(ui, context.theme, [bright, rays]);
        measured(ui, top, &mut self.below[1]);
        leaves
    }
}
