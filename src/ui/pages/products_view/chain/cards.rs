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
        chart::Ink,
        charts::products::chain::{ChainSheet, Place},
        product_report::scaled,
        ticks::short,
    },
    languages::{fixed, said, with_sign},
    study::products::Colours,
    ui::{
        kit::{Chooser, down, lights, named_choice},
        pages::PageContext,
        swatch,
        theme::Theme,
    },
};

/// Least and greatest width of a card, and width of the arrow between two, points.
const CARD: [f32; 2] = [204.0, 240.0];
const LEAST_PRESENTED: f32 = 166.0;
const ARROW: f32 = 58.0;

/// Sizes of the cards, points.
#[derive(Clone, Copy)]
struct Sizes {
    card: Vec2,
    arrow: f32,
    swatch: f32,
}

impl Sizes {
    /// Cards share the width; before a class they have no buttons, so that the spectrum has room.
    fn of(theme: Theme, stages: usize, room: f32) -> Self {
        let [least, most] = match theme.presents {
            true => [LEAST_PRESENTED, CARD[1]],
            false => CARD,
        }
        .map(|width| width * theme.scale);
        let arrow = ARROW * theme.scale;
        // The last card's edge is inside.
        let share = (room - 4.0 - arrow * stages as f32) / (stages + 1) as f32;
        let [swatch, high] = match theme.presents {
            true => [40.0, 120.0],
            false => [96.0, 202.0],
        };
        Self {
            card: vec2(share.clamp(least, most).floor(), high * theme.scale),
            arrow,
            swatch: swatch * theme.scale,
        }
    }
}

/// All cards, the light's first; `held` is the stage that the pointer holds.
pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    held: &mut Option<usize>,
) {
    let count = sheet.stages();
    let sizes = Sizes::of(context.theme, count, ui.available_width());
    ScrollArea::horizontal()
        .id_salt("cards of the chain")
        .auto_shrink([false, true])
        .show(ui, |ui| {
            ui.horizontal_top(|ui| {
                ui.spacing_mut().item_spacing.x = 0.0;
                card(ui, context, sheet, Place::Light, sizes);
                let mut rects = Vec::with_capacity(count);
                for index in 0..count {
                    arrow(ui, context, sheet, index, sizes);
                    let response = card(ui, context, sheet, Place::Stage(index), sizes);
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
fn arrow(ui: &mut Ui, context: &PageContext<'_>, sheet: &ChainSheet, index: usize, sizes: Sizes) {
    let size = vec2(sizes.arrow, sizes.card.y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let passages = std::iter::once(&sheet.told.passage).chain(&sheet.second);
    let steps = passages.filter_map(|passage| passage.steps.get(index));
    let y = rect.top() + 32.0 * context.theme.scale + 0.5 * sizes.swatch;
    let ink = context.theme.faint;
    let ends = [rect.left() + 7.0, rect.right() - 7.0];
    let tip = egui::pos2(ends[1], y);
    ui.painter().hline(ends[0]..=ends[1], y, (1.5, ink));
    for up in [-4.0, 4.0] {
        ui.painter()
            .line_segment([tip, tip + vec2(-5.0, up)], (1.5, ink));
    }
    let shares: Vec<String> = steps
        .map(|step| step.transmission[0].map_or("–".to_owned(), percent))
        .collect();
    let font = egui::TextStyle::Body.resolve(ui.style());
    let inks = [
        ui.visuals().strong_text_color(),
        context.theme.ink(Ink::Second),
    ];
    // Of two lights the first above the arrow, the second below it.
    let places = [
        (y - 4.0, egui::Align2::CENTER_BOTTOM),
        (y + 4.0, egui::Align2::CENTER_TOP),
    ];
    for ((words, ink), (y, align)) in shares.iter().zip(inks).zip(places) {
        let at = egui::pos2(rect.center().x, y);
        ui.painter().text(at, align, words, font.clone(), ink);
    }
    response.on_hover_text(match shares.len() {
        1 => said!("Share of the brightness that this step lets through, exact."),
        _ => {
            said!(
                "Share of the brightness that this step lets through, above of the light, below of \
                 the second one, exact."
            )
        }
    });
}

/// A share in two digits.
fn percent(share: f64) -> String {
    let value = 100.0 * share;
    match value {
        v if v >= 9.95 => format!("{} %", fixed(v, 0)),
        v if v >= 0.095 => format!("{} %", fixed(v, 1)),
        v if v > 0.0 => with_sign("< 0.1 %".to_owned()),
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
    sizes: Sizes,
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
                    let size = sizes.card - vec2(18.0, 14.0);
                    ui.set_min_size(size);
                    ui.set_max_size(size);
                    ui.spacing_mut().item_spacing = vec2(4.0, 4.0);
                    ui.vertical(|ui| match place {
                        Place::Light => light_card(ui, context, sheet, sizes),
                        Place::Stage(index) => stage_card(ui, context, sheet, index, sizes),
                    });
                });
        })
        .response;
    let name = match place {
        Place::Light => tr!(
            "Light: {light}",
            light = context.app.document().light.name()
        ),
        Place::Stage(index) => tr!(
            "Step {number}: {name}",
            number = index + 1,
            name = sheet.told.names[index]
        ),
    };
    named_choice(&response, egui::Role::Button, is_chosen, &name);
    if response.clicked() {
        choose(context, place);
    }
    response
}

fn light_card(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet, sizes: Sizes) {
    let app = context.app;
    let chosen = Chooser {
        name: said(names::LIGHT),
        meaning: said!("Another light, shipped or your own; it becomes the window's light."),
        says: app.document().light.name(),
        offers: lights,
        width: ui.available_width() - 24.0,
    }
    .show(ui, app);
    if let Some(entry) = chosen {
        context.commands.push(Command::Show(entry));
    }
    let light = sheet.told.passage.light;
    swatch_of(ui, context, sheet, (Place::Light, &light), sizes);
    let words = match &app.document().second {
        Some(second) => RichText::new(tr!("right {light}", light = second.name()))
            .color(context.theme.ink(Ink::Second)),
        None => RichText::new(said!("the light")).weak(),
    };
    ui.add(Label::new(words).truncate());
}

fn stage_card(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    index: usize,
    sizes: Sizes,
) {
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
    let place = Place::Stage(index);
    swatch_of(ui, context, sheet, (place, &step.colours), sizes);
    let second = sheet.second_at(place);
    let of = std::iter::once((&sheet.told.passage, step.colours)).chain(second);
    let left: Vec<String> = of
        .filter_map(|(passage, colours)| scaled(passage, colours.exact))
        .map(|(xyz, _)| percent(xyz.y / 100.0))
        .collect();
    let left = match &left[..] {
        [] => said!("no visible light").to_owned(),
        [one] => tr!("{share} of the light left", share = one),
        more => tr!("{shares} left", shares = more.join(" | ")),
    };
    ui.add(Label::new(RichText::new(left).weak()).truncate());
    ui.horizontal(|ui| {
        knobs::thickness(ui, context, link, index);
        knobs::times(ui, context, link, index);
    });
    if !context.theme.presents {
        order(ui, context, (chain.len(), index));
    }
}

/// The buttons that move a step or take it out.
fn order(ui: &mut Ui, context: &mut PageContext<'_>, (count, index): (usize, usize)) {
    let number = index + 1;
    ui.horizontal(|ui| {
        let mut button = |sign: &str, name: String, meaning: &str, on: bool| {
            let button = egui::Button::new(sign).small();
            let response = ui.add_enabled(on, button);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, on, &name));
            response.on_hover_text(meaning).clicked()
        };
        if button(
            "←",
            tr!("Move up step {number}", number),
            said!("Earlier in the chain."),
            index > 0,
        ) {
            move_link(context, index, index - 1);
        }
        if button(
            "→",
            tr!("Move down step {number}", number),
            said!("Later in the chain."),
            number < count,
        ) {
            move_link(context, index, index + 1);
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            let remove = ui.small_button(said!("Remove"));
            let name = tr!("Remove step {number}", number);
            remove.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &name));
            let meaning = said!("Takes this step out of the chain.");
            if remove.on_hover_text(meaning).clicked() {
                change(context, |products| drop(products.chain.remove(index)));
            }
        });
    });
}

/// The swatch of a place, exact and by the model, or of two lights, each exact; a click chooses it.
fn swatch_of(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    (place, colours): (Place, &Colours),
    sizes: Sizes,
) {
    let passage = &sheet.told.passage;
    let exact = scaled(passage, colours.exact);
    let second = sheet.second_at(place);
    let other = match &second {
        Some((passage, colours)) => scaled(passage, colours.exact),
        None => scaled(passage, colours.model),
    };
    let size = Vec2::new(ui.available_width(), sizes.swatch);
    let (Some(exact), Some(other)) = (exact, other) else {
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        ui.painter().rect_filled(rect, 3.0, Color32::BLACK);
        return;
    };
    let document = context.app.document();
    let halves = match &document.second {
        Some(second) => tr!(
            "{one} and {other}",
            one = document.light.name(),
            other = second.name()
        ),
        None => said!("exact and model").to_owned(),
    };
    let name = match place {
        Place::Light => tr!("Light, {halves}", halves),
        Place::Stage(index) => tr!("Step {number}, {halves}", number = index + 1, halves),
    };
    let response = swatch::split(ui, size, &exact.1, &other.1, &name);
    if response.clicked() {
        choose(context, place);
    }
    let [left, right] = match &document.second {
        Some(second) => [document.light.name(), second.name()],
        None => [said!("exact"), said!("the model")],
    };
    response.on_hover_text(tr!(
        "Left {left} {left_hex}, right {right} {right_hex}, the light's Y as the screen's \
         white.\nY {left_y} and {right_y} of the light's 100.",
        left,
        left_hex = exact.1.hex(),
        right,
        right_hex = other.1.hex(),
        left_y = short(exact.0.y),
        right_y = short(other.0.y)
    ));
}
