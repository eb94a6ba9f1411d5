//! The three ways to begin, over the first screen; Escape leaves what is below them.

use eframe::egui;
use egui::{Align2, Context, Key, RichText, Ui, vec2};

use super::theme::Theme;
use crate::app::pages::Page;

/// Where a tile leads.
const TILES: [(&str, &str, Page); 3] = [
    (
        "Show a class",
        "Look at a lamp: lines on a glow. Pull the two sliders and watch curve and colours.",
        Page::Spectrum,
    ),
    (
        "See what light does",
        "Send a light through glass and off surfaces; compare two lights on the same colours.",
        Page::Chain,
    ),
    (
        "How many numbers?",
        "Find out how few numbers a spectrum is worth, and what each of them buys.",
        Page::Tradeoff,
    ),
];

/// Draws the tiles; gives the page that was chosen, and whether they are to go.
pub fn show(context: &Context, theme: Theme) -> (Option<Page>, bool) {
    let mut chosen = None;
    let modal = egui::Modal::new(egui::Id::unique("greeting")).show(context, |ui| {
        ui.set_max_width((720.0 * theme.scale).min(ui.ctx().content_rect().width() - 48.0));
        ui.label(RichText::new("What would you like to do?").size(20.0));
        ui.add_space(8.0);
        let wide = ui.available_width() >= 560.0;
        let mut tiles = |ui: &mut Ui| {
            for (title, words, page) in TILES {
                if tile(ui, title, words, wide) {
                    chosen = Some(page);
                }
            }
        };
        if wide {
            ui.horizontal(|ui| tiles(ui));
        } else {
            ui.vertical(|ui| tiles(ui));
        }
        ui.add_space(8.0);
        ui.weak("Esc: begin with what is on the screen. Help brings this back.");
    });
    let leaves = modal.should_close() || context.input(|i| i.key_pressed(Key::Escape));
    (chosen, leaves || chosen.is_some())
}

fn tile(ui: &mut Ui, title: &str, words: &str, wide: bool) -> bool {
    let width = if wide {
        (ui.available_width().min(700.0) - 32.0) / 3.0
    } else {
        ui.available_width()
    };
    let width = width.clamp(150.0, 220.0_f32.max(width.min(220.0)));
    let size = vec2(
        if wide { 210.0 } else { width },
        if wide { 128.0 } else { 84.0 },
    );
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::click());
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, title));
    let visuals = ui.style().interact(&response);
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, visuals.bg_fill);
    let ink = ui.visuals().strong_text_color();
    painter.text(
        rect.min + vec2(12.0, 18.0),
        Align2::LEFT_CENTER,
        title,
        egui::FontId::proportional(18.0),
        ink,
    );
    let font = egui::TextStyle::Body.resolve(ui.style());
    let galley = painter.layout(
        words.to_owned(),
        font,
        ui.visuals().text_color(),
        size.x - 24.0,
    );
    painter.galley(rect.min + vec2(12.0, 38.0), galley, ink);
    response.clicked()
}
