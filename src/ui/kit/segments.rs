//! One of a few, side by side in one frame.

use eframe::egui;
use egui::{Frame, Margin, Ui};

/// A segmented control: each with its title and meaning. Whether another one was chosen.
pub fn segments<T: Copy + PartialEq>(
    ui: &mut Ui,
    now: &mut T,
    all: impl IntoIterator<Item = T>,
    words: impl Fn(T) -> (&'static str, &'static str),
) -> bool {
    let before = *now;
    Frame::new()
        .fill(ui.visuals().extreme_bg_color)
        .stroke(ui.visuals().widgets.noninteractive.bg_stroke)
        .corner_radius(6)
        .inner_margin(Margin::same(2))
        .show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = egui::vec2(2.0, 2.0);
                for one in all {
                    let (title, meaning) = words(one);
                    let item = ui.selectable_value(now, one, title);
                    if !meaning.is_empty() {
                        item.on_hover_text(meaning);
                    }
                }
            });
        });
    *now != before
}
