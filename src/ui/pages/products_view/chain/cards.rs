//! The chain as a row of large swatches: the light and every step, with the share that each lets
//! through between them.

use eframe::egui;
use egui::{
    Align, Color32, CursorIcon, Frame, Label, Layout, Margin, Rect, RichText, ScrollArea, Sense,
    Stroke, Ui, UiBuilder, Vec2, vec2,
};

use super::{super::change, choose, chosen, knobs, move_link, names};
use crate::{
    app::{
        Command,
        charts::products::chain::{ChainSheet, Place},
        product_report::scaled,
        ticks::short,
    },
    study::products::Colours,
    ui::{
        kit::{Chooser, down, lights, named_choice},
        pages::PageContext,
        swatch,
    },
};

/// Width of a card and of the arrow between two, height of its swatch and of all of it, points.
const CARD: f32 = 172.0;
const ARROW: f32 = 58.0;
const SWATCH: f32 = 96.0;
pub(super) const HEIGHT: f32 = 202.0;

/// All cards, the light's first; `held` is the stage that the pointer holds.
pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    held: &mut Option<usize>,
) {
    ScrollArea::horizontal()
        .id_salt("cards of the chain")
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 0.0;
                card(ui, context, sheet, Place::Light);
                let count = sheet.stages();
                let mut rects = Vec::with_capacity(count);
                for index in 0..count {
                    arrow(ui, context, sheet, index);
                    let response = card(ui, context, sheet, Place::Stage(index));
                    if response.drag_started() {
                        *held = Some(index);
                    }
                    rects.push(response.rect);
                }
                carry(ui, context, sheet, &rects, held);
            });
        });
}

/// From one swatch to the next, with the share of the light that the step lets through.
fn arrow(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet, index: usize) {
    let scale = context.theme.scale;
    let (rect, response) = ui.allocate_exact_size(vec2(ARROW, HEIGHT) * scale, Sense::hover());
    let step = &sheet.told.passage.steps[index];
    let y = rect.top() + (32.0 + 0.5 * SWATCH) * scale;
    let ink = context.theme.faint;
    let ends = [rect.left() + 7.0, rect.right() - 7.0];
    let tip = egui::pos2(ends[1], y);
    ui.painter().hline(ends[0]..=ends[1], y, (1.5, ink));
    for up in [-4.0, 4.0] {
        ui.painter()
            .line_segment([tip, tip + vec2(-5.0, up)], (1.5, ink));
    }
    let words = step.transmission[0].map_or("–".to_owned(), percent);
    let font = egui::TextStyle::Body.resolve(ui.style());
    let at = egui::pos2(rect.center().x, y - 4.0);
    let colour = ui.visuals().strong_text_color();
    ui.painter()
        .text(at, egui::Align2::CENTER_BOTTOM, words, font, colour);
    response.on_hover_text("Share of the brightness that this step lets through, exact.");
}

/// A share in two digits.
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    match value {
        v if v >= 9.95 => format!("{v:.0} %"),
        v if v >= 0.095 => format!("{v:.1} %"),
        v if v > 0.0 => "< 0.1 %".to_owned(),
        _ => "0 %".to_owned(),
    }
}

/// A card in the hand: where it would land, and landing.
fn carry(
    ui: &Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    rects: &[Rect],
    held: &mut Option<usize>,
) {
    let Some(from) = held.filter(|held| *held < rects.len()) else {
        *held = None;
        return;
    };
    let Some(pointer) = ui.input(|i| i.pointer.latest_pos()) else {
        return;
    };
    let slot = rects.iter().filter(|r| r.center().x < pointer.x).count();
    ui.set_cursor_icon(CursorIcon::Grabbing);
    let x = match slot.checked_sub(1) {
        Some(before) => rects[before].right() + 4.0,
        None => rects[0].left() - 4.0,
    };
    let colour = ui.visuals().widgets.active.bg_stroke.color;
    ui.painter().vline(x, rects[0].y_range(), (3.0, colour));
    let layer = egui::LayerId::new(egui::Order::Tooltip, ui.scope_id().with("held card"));
    let painter = ui.ctx().layer_painter(layer);
    let font = egui::TextStyle::Body.resolve(ui.style());
    let words = sheet.told.names[from].clone();
    let galley = painter.layout_no_wrap(words, font, ui.visuals().strong_text_color());
    let ghost = Rect::from_min_size(pointer + vec2(14.0, 4.0), galley.size() + vec2(12.0, 8.0));
    painter.rect(
        ghost,
        4.0,
        ui.visuals().window_fill,
        Stroke::new(1.0, colour),
        egui::StrokeKind::Inside,
    );
    painter.galley(ghost.min + vec2(6.0, 4.0), galley, Color32::WHITE);
    if ui.input(|i| i.key_pressed(egui::Key::Escape)) {
        *held = None;
    } else if !ui.input(|i| i.pointer.any_down()) {
        *held = None;
        // Taking it out moves what is behind it by one.
        let to = if slot > from { slot - 1 } else { slot };
        move_link(context, from, to);
    }
}

/// One card; its response is the card's own, below what stands on it.
fn card(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    place: Place,
) -> egui::Response {
    let count = sheet.stages();
    let is_chosen = chosen(context, count) == place;
    let sense = match place {
        Place::Light => Sense::click(),
        Place::Stage(_) => Sense::click_and_drag(),
    };
    let salt = ("card", place.index());
    let builder = UiBuilder::new().id_salt(salt).sense(sense);
    let response = ui
        .scope_builder(builder, |ui| {
            // A press on words is a press on the card.
            ui.style_mut().interaction.selectable_labels = false;
            let visuals = ui.visuals();
            let own = ui.response();
            let stroke = if is_chosen || own.has_focus() {
                Stroke::new(2.0, visuals.widgets.active.bg_stroke.color)
            } else {
                visuals.widgets.noninteractive.bg_stroke
            };
            let fill = if own.hovered() && !is_chosen {
                visuals.widgets.inactive.bg_fill
            } else {
                visuals.faint_bg_color
            };
            Frame::new()
                .fill(fill)
                .stroke(stroke)
                .corner_radius(4)
                .inner_margin(Margin::symmetric(8, 6))
                .show(ui, |ui| {
                    let size = vec2(CARD, HEIGHT) * context.theme.scale - vec2(18.0, 14.0);
                    ui.set_min_size(size);
                    ui.set_max_size(size);
                    ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
                    ui.vertical(|ui| match place {
                        Place::Light => light_card(ui, context, sheet),
                        Place::Stage(index) => stage_card(ui, context, sheet, index),
                    });
                });
        })
        .response;
    let name = match place {
        Place::Light => format!("Light: {}", context.app.document().light.name()),
        Place::Stage(index) => format!("Step {}: {}", index + 1, sheet.told.names[index]),
    };
    named_choice(&response, egui::Role::Button, is_chosen, &name);
    if response.clicked() {
        choose(context, place);
    }
    response
}

fn light_card(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet) {
    let app = context.app;
    let chosen = Chooser {
        name: names::LIGHT,
        meaning: "Another light, shipped or your own; it becomes the window's light.",
        says: app.document().light.name(),
        offers: lights,
        width: ui.available_width() - 24.0,
    }
    .show(ui, app);
    if let Some(entry) = chosen {
        context.commands.push(Command::Show(entry));
    }
    let light = sheet.told.passage.light;
    swatch_of(ui, context, sheet, Place::Light, &light);
    ui.weak("the light");
}

fn stage_card(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet, index: usize) {
    let app = context.app;
    let chain = &app.document().products.chain;
    let (Some(link), Some(step)) = (chain.get(index), sheet.told.passage.steps.get(index)) else {
        return;
    };
    let name = RichText::new(link.entry.name()).strong();
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
    down(ui, size, |ui| {
        ui.set_min_height(size.y);
        ui.add(Label::new(name).truncate()).on_hover_text(format!(
            "{}\n{}",
            link.entry.key, link.entry.spectrum.source
        ));
    });
    swatch_of(ui, context, sheet, Place::Stage(index), &step.colours);
    let left = match (scaled(&sheet.told.passage, step.colours.exact), index) {
        (Some((xyz, _)), _) => format!("{} of the light left", percent(xyz.y / 100.0)),
        (None, _) => "no visible light".to_owned(),
    };
    ui.add(Label::new(RichText::new(left).weak()).truncate());
    ui.horizontal(|ui| {
        knobs::thickness(ui, context, link, index);
        knobs::times(ui, context, link, index);
    });
    order(ui, context, (chain.len(), index));
}

/// The buttons that move a step or take it out.
fn order(ui: &mut Ui, context: &mut PageContext<'_>, (count, index): (usize, usize)) {
    let number = index + 1;
    ui.horizontal(|ui| {
        let mut button = |sign: &str, what: &str, meaning: &str, on: bool| {
            let button = egui::Button::new(sign).small();
            let response = ui.add_enabled(on, button);
            let name = format!("{what} step {number}");
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, on, &name));
            response.on_hover_text(meaning).clicked()
        };
        if button("←", "Move up", "Earlier in the chain.", index > 0) {
            move_link(context, index, index - 1);
        }
        if button("→", "Move down", "Later in the chain.", number < count) {
            move_link(context, index, index + 1);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let remove = ui.small_button("Remove");
            let name = format!("Remove step {number}");
            remove.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
            let meaning = "Takes this step out of the chain.";
            if remove.on_hover_text(meaning).clicked() {
                change(context, |products| drop(products.chain.remove(index)));
            }
        });
    });
}

/// The swatch of a place, exact and by the model; a click chooses it.
fn swatch_of(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    place: Place,
    colours: &Colours,
) {
    let passage = &sheet.told.passage;
    let both = [colours.exact, colours.model].map(|xyz| scaled(passage, xyz));
    let size = Vec2::new(ui.available_width(), SWATCH * context.theme.scale);
    let [Some(exact), Some(model)] = both else {
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        ui.painter().rect_filled(rect, 3.0, Color32::BLACK);
        return;
    };
    let name = match place {
        Place::Light => "Light, exact and model".to_owned(),
        Place::Stage(index) => format!("Step {}, exact and model", index + 1),
    };
    let response = swatch::split(ui, size, &exact.1, &model.1, &name);
    if response.clicked() {
        choose(context, place);
    }
    response.on_hover_text(format!(
        "Left exact {}, right the model {}, the light's Y as the screen's white.\nY {} and {} of \
         the light's 100.",
        exact.1.hex(),
        model.1.hex(),
        short(exact.0.y),
        short(model.0.y),
    ));
}
