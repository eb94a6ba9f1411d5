//! The chain as cards: the light and every factor, with what they do in small.

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
        numbers::{short_delta_e, short_percent},
        product_report::scaled,
        ticks::short,
    },
    io::many::capitalised,
    study::products::Colours,
    ui::{
        entry_row::draw_curve,
        kit::{Chooser, lights, named_choice, warning},
        pages::PageContext,
        swatch,
        theme::Theme,
    },
};

/// Height of the small spectrum on a card, points.
const SPARK: f32 = 34.0;

/// Width of the split swatch on a card, points.
const SWATCH: f32 = 54.0;

/// All cards, the light's first; `held` is the stage that the pointer holds.
pub(super) fn show(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    width: f32,
    held: &mut Option<usize>,
) {
    ScrollArea::vertical()
        .id_salt("cards of the chain")
        .auto_shrink(false)
        .show(ui, |ui| {
            // The bar of the scroll area stands over the right edge.
            ui.set_width(width - 10.0);
            ui.spacing_mut().item_spacing.y = 5.0;
            card(ui, context, sheet, Place::Light);
            let count = sheet.stages();
            let mut rects = Vec::with_capacity(count);
            for index in 0..count {
                let response = card(ui, context, sheet, Place::Stage(index));
                if response.drag_started() {
                    *held = Some(index);
                }
                rects.push(response.rect);
            }
            carry(ui, context, sheet, &rects, held);
            if count == 0 {
                ui.add_space(8.0);
                ui.label(
                    "The chain is empty: nothing stands in the light's way. Add a filter, a \
                     glass or a surface above; files that you open join the list.",
                );
            } else if count > 1 {
                ui.weak("Drag cards into another order, or use their arrows.");
            }
        });
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
    let slot = rects.iter().filter(|r| r.center().y < pointer.y).count();
    ui.set_cursor_icon(CursorIcon::Grabbing);
    let y = match slot.checked_sub(1) {
        Some(above) => rects[above].bottom() + 2.5,
        None => rects[0].top() - 2.5,
    };
    let colour = ui.visuals().widgets.active.bg_stroke.color;
    ui.painter().hline(rects[0].x_range(), y, (3.0, colour));
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
        // Taking it out moves what is below it up by one.
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
                    ui.set_width(ui.available_width());
                    ui.spacing_mut().item_spacing.y = 3.0;
                    match place {
                        Place::Light => light_card(ui, context, sheet),
                        Place::Stage(index) => stage_card(ui, context, sheet, index),
                    }
                });
        })
        .response;
    let name = match place {
        Place::Light => format!("Light: {}", context.app.document().light.name()),
        Place::Stage(index) => format!("Stage {}: {}", index + 1, sheet.told.names[index]),
    };
    named_choice(&response, egui::Role::Button, is_chosen, &name);
    if response.clicked() {
        choose(context, place);
    }
    response
}

fn light_card(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet) {
    let app = context.app;
    ui.horizontal(|ui| {
        ui.weak("Light");
        let chosen = Chooser {
            name: names::LIGHT,
            meaning: "Another light, shipped or your own; it becomes the window's light.",
            says: app.document().light.name(),
            offers: lights,
            width: ui.available_width() - 4.0,
        }
        .show(ui, app);
        if let Some(entry) = chosen {
            context.commands.push(Command::Show(entry));
        }
    });
    let light = sheet.told.passage.light;
    picture(ui, context, sheet, Place::Light, &light);
    figures(ui, context, sheet, &light, None);
}

fn stage_card(ui: &mut Ui, context: &mut PageContext<'_>, sheet: &ChainSheet, index: usize) {
    let app = context.app;
    let chain = &app.document().products.chain;
    let (Some(link), Some(step)) = (chain.get(index), sheet.told.passage.steps.get(index)) else {
        return;
    };
    let number = index + 1;
    ui.horizontal(|ui| {
        grip(ui, context.theme);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            let mut button = |sign: &str, what: &str, meaning: &str, on: bool| {
                let button = egui::Button::new(sign).small();
                let response = ui.add_enabled(on, button);
                let name = format!("{what} stage {number}");
                response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, on, &name));
                response.on_hover_text(meaning).clicked()
            };
            if button("×", "Remove", "Takes this factor out of the chain.", true) {
                change(context, |products| drop(products.chain.remove(index)));
            }
            let last = index + 1 == chain.len();
            if button("↓", "Move down", "Later in the chain.", !last) {
                move_link(context, index, index + 1);
            }
            if button("↑", "Move up", "Earlier in the chain.", index > 0) {
                move_link(context, index, index - 1);
            }
            ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
                let name = RichText::new(format!("{number}  {}", link.entry.name())).strong();
                ui.add(Label::new(name).truncate()).on_hover_text(format!(
                    "{}\n{}",
                    link.entry.key, link.entry.spectrum.source
                ));
            });
        });
    });
    picture(ui, context, sheet, Place::Stage(index), &step.colours);
    figures(ui, context, sheet, &step.colours, Some(step.transmission));
    ui.horizontal(|ui| {
        knobs::thickness(ui, context, link, index);
        knobs::times(ui, context, link, index);
    });
    for note in &sheet.notes[index] {
        let words = RichText::new(capitalised(note)).small();
        warning(ui, context.theme, words);
    }
}

/// Six dots: this can be taken in the hand.
fn grip(ui: &mut Ui, theme: Theme) {
    let (rect, _) = ui.allocate_exact_size(vec2(8.0, 14.0) * theme.scale, Sense::hover());
    for row in 0..3 {
        for column in 0..2 {
            let at = rect.center()
                + vec2(column as f32 * 4.0 - 2.0, row as f32 * 4.0 - 4.0) * theme.scale;
            ui.painter()
                .circle_filled(at, 1.2 * theme.scale, theme.faint);
        }
    }
}

/// The small spectrum and the split swatch of a card.
fn picture(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    sheet: &ChainSheet,
    place: Place,
    colours: &Colours,
) {
    let theme = context.theme;
    ui.horizontal(|ui| {
        let swatch_width = SWATCH * theme.scale;
        let size = vec2(
            (ui.available_width() - swatch_width - 6.0).max(40.0),
            SPARK * theme.scale,
        );
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
        let index = place.index();
        ui.painter().rect_filled(rect, 2.0, theme.ground);
        let [exact, smooth] = &sheet.small_curves[index];
        let within = rect.shrink2(vec2(2.0, 2.0));
        for (heights, colour) in [(smooth, Ink::Smooth), (exact, Ink::Measured)] {
            draw_curve(ui, within, heights, Stroke::new(1.2, theme.ink(colour)));
        }
        response.on_hover_text(
            "The exact light behind this stage and the model's smooth part, over the exact peak.",
        );
        swatch_of(ui, sheet, colours, index, swatch_width).map_or_else(
            || {
                ui.weak("no colour")
                    .on_hover_text("No visible light in this range.");
            },
            |clicked| {
                if clicked {
                    choose(context, place);
                }
            },
        );
    });
}

/// The split swatch; whether it was clicked, `None` without a colour.
fn swatch_of(
    ui: &mut Ui,
    sheet: &ChainSheet,
    colours: &Colours,
    index: usize,
    width: f32,
) -> Option<bool> {
    let passage = &sheet.told.passage;
    let (exact, model) = (
        scaled(passage, colours.exact)?,
        scaled(passage, colours.model)?,
    );
    let name = match index {
        0 => "Light, exact and model".to_owned(),
        stage => format!("Stage {stage}, exact and model"),
    };
    let size = Vec2::new(width, ui.available_height());
    let response = swatch::split(ui, size, &exact.1, &model.1, &name);
    let clicked = response.clicked();
    response.on_hover_text(format!(
        "Left exact {}, right the model {}, the light's Y as the screen's white.\nY {} and {} of \
         the light's 100.",
        exact.1.hex(),
        model.1.hex(),
        short(exact.0.y),
        short(model.0.y),
    ));
    Some(clicked)
}

/// Transmission, luminance and error of a card.
fn figures(
    ui: &mut Ui,
    context: &PageContext<'_>,
    sheet: &ChainSheet,
    colours: &Colours,
    passes: Option<[Option<f64>; 2]>,
) {
    let y = |xyz| scaled(&sheet.told.passage, xyz).map(|(xyz, _)| xyz.y);
    let [exact, model] = [colours.exact, colours.model].map(y);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 3.0;
        let font = egui::TextStyle::Small.resolve(ui.style());
        let inks = [context.theme.faint, ui.visuals().text_color()];
        let mut pair = |what: &str, text: String, meaning: &str| {
            // One text, so that a figure is never parted from its name.
            let mut job = egui::text::LayoutJob::default();
            for (text, colour) in [what, &text].into_iter().zip(inks) {
                let format = egui::TextFormat::simple(font.clone(), colour);
                job.append(text, if job.text.is_empty() { 0.0 } else { 4.0 }, format);
            }
            ui.add(Label::new(job).extend()).on_hover_text(meaning);
            ui.add_space(4.0);
        };
        if let Some([exact, model]) = passes {
            pair(
                "passes",
                format!(
                    "{} | {}",
                    short_percent(exact, false),
                    short_percent(model, false)
                ),
                "Transmission or reflection of this factor for this light: Y out over Y in, \
                 exact | model.",
            );
        }
        pair(
            "Y",
            format!("{} | {}", plain(exact), plain(model)),
            "Luminance, the light's at 100: exact | model.",
        );
        pair(
            "ΔE₀₀",
            short_delta_e(colours.delta_e_2000),
            "CIEDE2000 between exact and model; the white is the exact light.",
        );
        pair(
            "lum.",
            short_percent(colours.luminance_error, true),
            "Luminance error: Y model over Y exact, minus 1.",
        );
    });
}

fn plain(value: Option<f64>) -> String {
    value.map_or_else(
        || "–".to_owned(),
        |value| short((1e3 * value).round() / 1e3 + 0.0),
    )
}
