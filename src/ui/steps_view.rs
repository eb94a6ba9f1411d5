//! How far a model is off, at a glance: both spectra as strips of colour, and four steps of a
//! difference.

use std::sync::Arc;

use eframe::egui;
use egui::{
    Align, Align2, CornerRadius, Id, Layout, Rect, RichText, Sense, Stroke, StrokeKind, Ui, vec2,
};

use super::{
    kit::{drawing, kept, named_choice},
    swatch,
    theme::{Theme, grey, of_seen},
};
use crate::{
    app::{App, behind_slit, verdicts::Seen},
    languages::{said, with_colon},
};

/// Height of the strip, points: half of it each.
const STRIP: f32 = 32.0;

/// What stands in the strip below the swatch, for those who have it read out.
const STRIP_NAME: &str = later!("Through a prism: measured above, model below");

/// Both spectra as strips of colour, the model's below the light's: what only an instrument sees.
pub(super) fn through_a_prism(ui: &mut Ui, app: &App, theme: Theme) {
    let colours = match app.document().is_about_light() {
        true => {
            let id = Id::unique("through a prism");
            let make = || Arc::new(behind_slit::strip(app));
            kept(ui.ctx(), id, app.revision(), make)
        }
        false => Arc::default(),
    };
    if colours.is_empty() {
        return;
    }
    let size = vec2(ui.available_width(), STRIP * theme.scale);
    let (rect, response) = drawing(ui, size, Sense::hover(), said(STRIP_NAME));
    let mut mesh = egui::Mesh::default();
    let width = rect.width() / colours.len() as f32;
    for (k, both) in colours.iter().enumerate() {
        let left = rect.left() + k as f32 * width;
        for (row, colour) in both.iter().enumerate() {
            let top = rect.top() + row as f32 * rect.height() / 2.0;
            let at = egui::pos2(left, top);
            let field = Rect::from_min_size(at, vec2(width, rect.height() / 2.0));
            mesh.add_colored_rect(field, swatch::colour(*colour));
        }
    }
    ui.painter().add(mesh);
    // The eye sees nothing at the end of the long wavelengths: it is dark in both looks.
    for (row, words) in [said!("measured"), said!("model")].into_iter().enumerate() {
        let middle = rect.top() + (row as f32 + 0.5) * rect.height() / 2.0;
        let font = egui::FontId::proportional(11.0 * theme.scale);
        let at = egui::pos2(rect.right() - 4.0, middle);
        let ink = grey(200);
        ui.painter()
            .text(at, Align2::RIGHT_CENTER, words, font, ink);
    }
    response.on_hover_text(said!(
        "Through a prism, behind a slit of 10 nm: 380 to 780 nm where the range reaches, each \
         wavelength as bright as the light is there."
    ));
}

/// What a difference is judged by: both have the same four steps.
pub(super) const TO_THE_EYE: &str = later!("To the eye");
pub(super) const TO_AN_INSTRUMENT: &str = later!("To an instrument");

/// Whose scale it is, and the four words, the one that holds filled.
pub(super) fn scale(
    ui: &mut Ui,
    of: &str,
    now: Seen,
    meaning: fn(Seen) -> &'static str,
    theme: Theme,
) {
    let gap = 4.0;
    let font = egui::TextStyle::Small.resolve(ui.style());
    let wide = |words: &str| {
        let ink = ui.visuals().text_color();
        let galley = ui
            .painter()
            .layout_no_wrap(words.to_owned(), font.clone(), ink);
        galley.size().x
    };
    let widths = Seen::ALL.map(|seen| wide(seen.word()));
    // Both rows begin at the same place.
    let label = wide(said(TO_THE_EYE)).max(wide(said(TO_AN_INSTRUMENT))) + gap;
    let total = widths.iter().sum::<f32>();
    let room = ui.available_width() - 4.0 * gap - label;
    let air = ((room - total) / 4.0).max(4.0);
    let height = 24.0 * theme.scale;
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = gap;
        let size = vec2(label, height);
        ui.allocate_ui_with_layout(size, Layout::left_to_right(Align::Center), |ui| {
            ui.set_min_size(size);
            ui.label(RichText::new(of).small());
        });
        for (seen, width) in Seen::ALL.into_iter().zip(widths) {
            let (rect, response) =
                ui.allocate_exact_size(vec2(width + air, height), Sense::hover());
            let is_now = seen == now;
            let painter = ui.painter();
            let (ink, stroke) = if is_now {
                painter.rect_filled(rect, 3.0, of_seen(seen, theme.dark));
                let ink = if theme.dark { 18 } else { 255 };
                (grey(ink), Stroke::NONE)
            } else {
                let outline = ui.visuals().widgets.noninteractive.bg_stroke;
                (theme.faint, outline)
            };
            painter.rect_stroke(rect, CornerRadius::same(3), stroke, StrokeKind::Inside);
            painter.text(
                rect.center(),
                Align2::CENTER_CENTER,
                seen.word(),
                font.clone(),
                ink,
            );
            let name = with_colon(of, seen.word().to_lowercase());
            named_choice(&response, egui::Role::Label, is_now, &name);
            response.on_hover_text(meaning(seen));
        }
    });
}
