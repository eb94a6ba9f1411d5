//! The patches under both lights, and by how much the colour of each moves.

use eframe::egui;
use egui::{
    Align2, CornerRadius, RichText, ScrollArea, Sense, Stroke, TextStyle, Ui, Vec2, pos2, vec2,
};

use super::{Shown, names};
use crate::{
    app::products::two_lights::TwoLightsSheet,
    color::Swatch,
    study::products::TwoLights,
    ui::{kit::copy_button, pages::PageContext, swatch},
};

/// Most fields in one row: the ColorChecker makes two rows.
const PER_ROW: usize = 12;

/// Rows of fields that are seen at a time.
const ROWS: usize = 2;

/// Width of a field from which on its lower figure has a letter, points.
const LETTERED: f32 = 40.0;

/// The patches, what they do and how well the models tell it.
pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &TwoLightsSheet,
    shown: &Shown,
) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("Patches under both lights").heading());
        copy_button(ui, names::COPY_PATCHES, "", || sheet.table().csv());
    });
    let (Some(exact), Some(model)) = (&sheet.exact, &sheet.model) else {
        return;
    };
    if let (Some(mean), Some((off, most, by))) = (model.mean(), sheet.shift_error()) {
        ui.label(format!(
            "By the models of both lights {mean:.2} on average: a surface's shift differs by \
             {off:.3} on average, by {by:.3} at most ({}).",
            sheet.names[most]
        ))
        .on_hover_text(
            "The same shift with both lights replaced by their models (same settings, whites of \
             the measured lights), and its difference to the shift by the measured lights.",
        );
    }
    ui.weak(
        "Left under the first light, right under the second; above as measured, the strip below \
         by the models. Under each field its shift ΔE₀₀, measured and (m) by the models.",
    );
    ui.weak(if context.app.document().view.adapt_patches {
        "Each half is shown adapted to its own light, as the figures have it."
    } else {
        "Each half keeps the tint of its own light, which the figures leave out (Adapt takes it \
         away)."
    });
    ui.add_space(2.0);
    fields(ui, context, (sheet, shown), [exact, model]);
}

fn fields(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (sheet, shown): (&TwoLightsSheet, &Shown),
    [exact, model]: [&TwoLights; 2],
) {
    let gap = 4.0;
    let scale = context.theme.scale;
    let count = sheet.names.len();
    let width = ((ui.available_width() - 10.0 - gap * (PER_ROW - 1) as f32) / PER_ROW as f32)
        .min(90.0 * scale)
        .floor();
    let text = ui.text_style_height(&TextStyle::Small);
    let size = vec2(width, 40.0 * scale + 2.0 * text + 2.0);
    let rows = count.div_ceil(PER_ROW);
    let seen = rows.min(ROWS) as f32;
    // Half a row more tells that there are more.
    let half = if rows > ROWS { 0.5 } else { 0.0 };
    let worst = exact.worst();
    let chosen = context
        .memory
        .products
        .two_lights
        .patch
        .min(count.max(1) - 1);
    let mut clicked = None;
    ScrollArea::vertical()
        .id_salt("fields under two lights")
        .max_height((seen + half) * (size.y + gap))
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.spacing_mut().item_spacing = vec2(gap, gap);
            for row in 0..rows {
                ui.horizontal(|ui| {
                    for i in row * PER_ROW..count.min((row + 1) * PER_ROW) {
                        let field = Field {
                            name: &sheet.names[i],
                            colours: [&shown.exact[i], &shown.model[i]],
                            shifts: [exact, model].map(|both| both.patches[i].delta_e_2000),
                            worst: worst == Some(i),
                            chosen: chosen == i,
                        };
                        if field.show(ui, size) {
                            clicked = Some(i);
                        }
                    }
                });
            }
        });
    if let Some(patch) = clicked {
        context.memory.products.two_lights.patch = patch;
    }
}

/// One patch: above as measured, below by the models; left and right the two lights.
struct Field<'a> {
    name: &'a str,
    /// As measured and by the models, each under both lights.
    colours: [&'a [Swatch; 2]; 2],
    /// CIEDE2000, measured and by the models.
    shifts: [f64; 2],
    worst: bool,
    chosen: bool,
}

impl Field<'_> {
    fn show(&self, ui: &mut Ui, size: Vec2) -> bool {
        let Self {
            name,
            colours: [exact, model],
            shifts,
            worst,
            chosen,
        } = *self;
        let (rect, response) = ui.allocate_exact_size(size, Sense::click());
        let said = format!(
            "{name}: shift {:.3}, by the models {:.3}",
            shifts[0], shifts[1]
        );
        response.widget_info(|| {
            egui::WidgetInfo::selected(egui::Role::Button, ui.is_enabled(), chosen, &said)
        });
        if !ui.is_rect_visible(rect) {
            return response.clicked();
        }
        let text = ui.text_style_height(&TextStyle::Small);
        let colours = rect.with_max_y(rect.bottom() - 2.0 * text - 2.0);
        let seam = (colours.top() + 0.7 * colours.height()).round();
        let lower = colours.with_min_y(seam);
        let [left, right] = exact.map(|s| swatch::colour(s.rgb8));
        swatch::paint_split(ui, colours, left, right);
        // No corners where the two parts meet: what differs is seen as a step.
        let [left, right] = model.map(|s| swatch::colour(s.rgb8));
        let (l, r) = lower.split_left_right_at_x(lower.center().x.round());
        let corner = |sw, se| CornerRadius {
            sw,
            se,
            ..CornerRadius::ZERO
        };
        ui.painter().rect_filled(l, corner(3, 0), left);
        ui.painter().rect_filled(r, corner(0, 3), right);
        let (first, second) = colours.split_left_right_at_x(colours.center().x.round());
        for (swatch, half) in exact.iter().zip([first, second]) {
            if !swatch.in_gamut {
                swatch::out_of_gamut_mark(ui, half);
            }
        }
        if chosen {
            let stroke = Stroke::new(2.0, ui.visuals().strong_text_color());
            swatch::outline(ui, colours, stroke);
        } else if response.hovered() || response.has_focus() {
            swatch::outline(ui, colours, ui.visuals().widgets.active.bg_stroke);
        } else {
            // A white patch is seen on a white ground.
            swatch::outline(ui, colours, ui.visuals().widgets.noninteractive.bg_stroke);
        }
        let font = TextStyle::Small.resolve(ui.style());
        let (strong, weak) = (ui.visuals().text_color(), ui.visuals().weak_text_color());
        let mark = if worst { "▲" } else { "" };
        // In little room the lower figure stands alone; the tooltip says which it is.
        let letter = if rect.width() < LETTERED { "" } else { "m " };
        let x = rect.center().x;
        for (line, words, colour) in [
            (2.0, format!("{mark}{:.2}", shifts[0]), strong),
            (1.0, format!("{letter}{:.2}", shifts[1]), weak),
        ] {
            let at = pos2(x, rect.bottom() - line * text);
            ui.painter()
                .text(at, Align2::CENTER_TOP, words, font.clone(), colour);
        }
        let clicked = response.clicked();
        swatch::menu(&response, exact.map(|swatch| swatch.rgb8));
        response.on_hover_text(format!(
            "{name}: ΔE₀₀ {:.3} between the two lights, {:.3} by their models{}.\nMeasured: left \
             {}, right {}. Models: left {}, right {}.\nClick to make a metamer of it.",
            shifts[0],
            shifts[1],
            if worst { " (the most)" } else { "" },
            exact[0].hex(),
            exact[1].hex(),
            model[0].hex(),
            model[1].hex(),
        ));
        clicked
    }
}
