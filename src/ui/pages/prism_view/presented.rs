//! Prism and rainbow before a class: the drawing, the strip below it, and three sliders.

use eframe::egui;
use egui::{Slider, Ui, vec2};

use super::{
    PrismView, axis_of, drawn, drop, exposure, model, names, slider, strips, told,
};
use crate::{
    app::dispersion::{APEXES_DEG, IMPACTS, PrismShown, RainbowShown, SLITS_MM, StripShown, sky},
    ui::{
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

/// A row of main controls at the foot.
fn row(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 16.0;
        add(ui);
    });
}

/// Height of that row, points.
fn row_height(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y + 2.0 * ui.spacing().item_spacing.y
}

impl PrismView {
    /// The bench and the strip; whether a hand wants the whole window back.
    pub(in crate::ui::pages) fn present_prism(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
    ) -> bool {
        let key = (
            context.app.revision(),
            context.memory.dispersion.prism.clone(),
        );
        let app = context.app;
        let shown = &*self
            .prism
            .get(key, |(_, memory)| PrismShown::of(app, memory));
        let leaves = head(ui, &shown.sentence);
        let (theme, strip) = only_first(&shown.strips, context.theme);
        let tells = |x_mm: f64| told(shown, x_mm);
        let axis = axis_of(shown, &tells);
        let left = ui.available_height()
            - strips::height(&strip, &axis, theme)
            - row_height(ui);
        let size = vec2(ui.available_width(), left.max(super::LEAST));
        drawn(ui, context, shown, size);
        strips::show(ui, &strip, &axis, theme);
        row(ui, |ui| {
            let memory = &mut context.memory.dispersion.prism;
            let of = Slider::new(&mut memory.apex_deg, APEXES_DEG)
                .step_by(0.5)
                .suffix("\u{b0}");
            let meaning = "The angle between the two faces that the light goes through.";
            slider(ui, (names::APEX, meaning), of);
            let of = Slider::new(&mut memory.slit_mm, SLITS_MM)
                .logarithmic(true)
                .fixed_decimals(2)
                .suffix(" mm");
            let meaning = "Width of the beam. Wide, lines run together and the middle turns white.";
            slider(ui, (names::SLIT, meaning), of);
            let sent = memory.sent;
            model::knobs(ui, context, sent);
        });
        leaves
    }

    /// The drop, the sky and the strip; whether a hand wants the whole window back.
    pub(in crate::ui::pages) fn present_rainbow(
        &mut self,
        ui: &mut Ui,
        context: &mut PageContext<'_>,
    ) -> bool {
        let key = (context.app.revision(), context.memory.dispersion.rainbow);
        let app = context.app;
        let sky = &*self.sky.get((), |()| sky());
        let shown = &*self
            .rainbow
            .get(key, |(_, memory)| RainbowShown::of(app, memory, sky));
        let leaves = head(ui, &shown.sentence);
        let (theme, strip) = only_first(&shown.strips, context.theme);
        let axis = strips::Axis {
            ends: shown.ends_deg,
            label: "\u{b0} from the point opposite the sun",
            nm: &[],
            tells: &|angle| format!("{angle:.2}\u{b0} from the point opposite the sun"),
        };
        let left = ui.available_height()
            - strips::height(&strip, &axis, theme)
            - row_height(ui);
        let high = left.max(super::LEAST);
        let picture = &mut self.picture;
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            if let Some(drawing) = &shown.drop {
                let wide = high.min(0.4 * ui.available_width());
                let moved = drop::show(ui, drawing, vec2(wide, high), context.theme);
                let impact = &mut context.memory.dispersion.rainbow.impact;
                *impact = moved.map_or(*impact, |to| to.clamp(*IMPACTS.start(), *IMPACTS.end()));
            }
            if let Some(strip) = shown.strips.first() {
                let size = vec2(ui.available_width(), high);
                picture.show(ui, (&strip.colours.rgb, shown.ends_deg), size);
            }
        });
        strips::show(ui, &strip, &axis, theme);
        row(ui, |ui| {
            let memory = &mut context.memory.dispersion.rainbow;
            exposure(ui, &mut memory.stops);
            let of = Slider::new(&mut memory.impact, IMPACTS)
                .fixed_decimals(2)
                .suffix(" radii");
            let meaning = "How far off its middle the coloured rays meet the drop.";
            slider(ui, (names::IMPACT, meaning), of);
        });
        leaves
    }
}
