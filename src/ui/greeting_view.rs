//! The ways to begin, over the first screen; Escape leaves what is below them.

use eframe::egui;
use egui::{Context, Key, RichText, Ui, vec2};

use super::{kit::tile_button, theme::Theme};
use crate::{app::pages::Page, languages::said};

/// Where a tile leads.
const TILES: [(&str, &str, Page); 3] = [
    (
        later!("Show a class"),
        later!("Short lessons on live data: predict, do it, see why. Or take one by yourself."),
        Page::Lessons,
    ),
    (
        later!("Design a light"),
        later!("Mix lines, LEDs and lamps with faders, and see what the mixture does to colours."),
        Page::Mix,
    ),
    (
        later!("How many numbers?"),
        later!("See how few numbers a spectrum needs, and what each of them buys."),
        Page::Tradeoff,
    ),
];

/// How to begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Beginning {
    Page(Page),
    /// With a lamp whose every knob is live.
    Live,
    /// With a spectrum of one's own.
    Own,
}

/// The ways below the tiles.
const BUTTONS: [(&str, &str, Beginning); 4] = [
    (
        later!("Is this a good light?"),
        later!("Shows how the light on the screen treats skin, colours and white."),
        Beginning::Page(Page::Quality),
    ),
    (
        later!("Light through a prism"),
        later!("Shows the light fanned out into its colours; F5 shows it to a class."),
        Beginning::Page(Page::Prism),
    ),
    (
        later!("Play with the waves"),
        later!("Shows FL11, a lamp of many lines: pull Waves and Lines, and everything follows."),
        Beginning::Live,
    ),
    (
        later!("Open my own spectrum"),
        later!("Opens a file; it can also be dropped on the window."),
        Beginning::Own,
    ),
];

/// Draws the tiles; gives the way that was chosen, and whether they are to go.
pub(super) fn show(context: &Context, theme: Theme) -> (Option<Beginning>, bool) {
    let mut chosen = None;
    let modal = egui::Modal::new(egui::Id::unique("greeting")).show(context, |ui| {
        ui.set_max_width((720.0 * theme.scale).min(ui.ctx().content_rect().width() - 48.0));
        ui.label(RichText::new(said!("What would you like to do?")).size(20.0 * theme.scale));
        ui.add_space(8.0);
        let wide = ui.available_width() >= 560.0 * theme.scale;
        let gap = ui.spacing().item_spacing.x;
        let mut tiles = |ui: &mut Ui, width: f32| {
            for (title, words, page) in TILES {
                if tile(ui, said(title), said(words), width) {
                    chosen = Some(Beginning::Page(page));
                }
            }
        };
        let most = (ui.ctx().content_rect().height() - 168.0).max(64.0);
        egui::ScrollArea::vertical()
            .max_height(most)
            .show(ui, |ui| {
                let room = ui.available_width();
                if wide {
                    ui.horizontal_top(|ui| tiles(ui, (room - 2.0 * gap) / 3.0));
                } else {
                    ui.vertical(|ui| tiles(ui, room));
                }
            });
        ui.add_space(8.0);
        ui.horizontal_wrapped(|ui| {
            for (words, meaning, way) in BUTTONS {
                if ui
                    .button(said(words))
                    .on_hover_text(said(meaning))
                    .clicked()
                {
                    chosen = Some(way);
                }
            }
        });
        ui.add_space(8.0);
        let leave = said!("Esc: begin with what is on the screen. Help brings this back.");
        ui.add(egui::Label::new(RichText::new(leave).weak()).wrap());
    });
    let leaves = modal.should_close() || context.input(|i| i.key_pressed(Key::Escape));
    (chosen, leaves || chosen.is_some())
}

/// Around a tile's words, points.
const MARGIN: f32 = 12.0;

/// A tile as high as the longest of all.
fn tile(ui: &mut Ui, title: &str, words: &str, width: f32) -> bool {
    let head = egui::TextStyle::Heading.resolve(ui.style());
    let body = egui::TextStyle::Body.resolve(ui.style());
    let (ink, strong) = (ui.visuals().text_color(), ui.visuals().strong_text_color());
    let room = width - 2.0 * MARGIN;
    let lay = |text: &str, font: &egui::FontId, ink: egui::Color32| {
        ui.painter()
            .layout(text.to_owned(), font.clone(), ink, room)
    };
    let highest = TILES.map(|(title, words, _)| {
        lay(said(title), &head, strong).size().y + lay(said(words), &body, ink).size().y
    });
    let highest = highest.into_iter().fold(0.0, f32::max);
    let (head, body) = (lay(title, &head, strong), lay(words, &body, ink));
    let size = vec2(width, highest + 2.0 * MARGIN + 6.0);
    let (rect, response) = tile_button(ui, size, title);
    let painter = ui.painter();
    let at = rect.min + vec2(MARGIN, MARGIN);
    let below = at + vec2(0.0, head.size().y + 6.0);
    painter.galley(at, head, strong);
    painter.galley(below, body, ink);
    response.clicked()
}
