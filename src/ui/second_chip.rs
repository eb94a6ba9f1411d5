//! The second light in the top bar.

use eframe::egui;
use egui::{Color32, Sense, Ui, vec2};

use super::{
    kit::{cut_words, named, named_choice},
    theme::Theme,
};
use crate::{
    app::{App, Entry, chart::Ink},
    languages::said,
};

/// What the second light was clicked for.
pub(super) enum Wish {
    /// Another one.
    Choose,
    /// None.
    NoMore,
}

/// The second light: its name asks for another one, and the cross for none.
pub(super) fn show(
    ui: &mut Ui,
    app: &App,
    second: &Entry,
    is_choosing: bool,
    width: f32,
    theme: Theme,
) -> Option<Wish> {
    let height = 32.0 * theme.scale;
    let cross = 26.0 * theme.scale;
    let font = egui::TextStyle::Button.resolve(ui.style());
    let ink = ui.visuals().strong_text_color();
    let words = tr!("vs {light}", light = second.name());
    let galley = cut_words(ui, &words, font.clone(), ink, width - cross - 36.0);
    let size = vec2(
        (galley.size().x + cross + 36.0).min(width.max(60.0)),
        height,
    );
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let (chosen, left) = (
        rect.with_max_x(rect.right() - cross),
        rect.with_min_x(rect.right() - cross),
    );
    let id = ui.scope_id().with("second light");
    let name = ui.interact(chosen, id, Sense::click());
    named_choice(
        &name,
        egui::Role::Button,
        is_choosing,
        &tr!("Compared with {light}", light = second.name()),
    );
    let close = ui.interact(left, id.with("no more"), Sense::click());
    named(&close, egui::Role::Button, said(NO_MORE));
    let visuals = ui.visuals();
    let lit = |response: &egui::Response| response.hovered() || response.has_focus();
    let fill = match (is_choosing, lit(&name)) {
        (true, _) => visuals.selection.bg_fill,
        (false, true) => visuals.widgets.hovered.bg_fill,
        (false, false) => visuals.widgets.inactive.bg_fill,
    };
    let painter = ui.painter();
    painter.rect_filled(rect, 4.0, fill);
    if lit(&close) {
        painter.rect_filled(left, 4.0, visuals.widgets.active.bg_fill);
    }
    // The ink that it has in every picture.
    let mark = egui::Rect::from_min_size(rect.min, vec2(4.0, height));
    painter.rect_filled(mark, 2.0, theme.ink(Ink::Second));
    let y = rect.center().y;
    let at = egui::pos2(rect.left() + 14.0, y - galley.size().y / 2.0);
    painter.galley(at, galley, Color32::WHITE);
    let middle = egui::Align2::CENTER_CENTER;
    painter.text(left.center(), middle, "✕", font, ink);
    let summary = app.compared().map_or("", |compared| &compared.summary);
    let (chooses, closes) = (name.clicked(), close.clicked());
    name.on_hover_text(tr!("{summary}\nClick to choose another.", summary));
    close.on_hover_text(said!("Compares no more."));
    if closes {
        return Some(Wish::NoMore);
    }
    chooses.then_some(Wish::Choose)
}

/// What the cross of the second light is called.
const NO_MORE: &str = later!("Compare no more");
