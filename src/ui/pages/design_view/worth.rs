//! What a mixture is worth: its figures in large type, surfaces under it, and where it goes.

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{longer, set};
use crate::{
    app::{
        Command, MadeFor,
        chart::Ink,
        design::{Beside, Desk, DeskSurfaces, MainFigure, mix::Snapshot},
    },
    languages::said,
    ui::{
        kit::{Choice, column, copy_button, named},
        pages::PageContext,
        swatch,
        theme::Theme,
    },
};

/// Height of a surface, points.
const SURFACE: f32 = 48.0;

/// Height of so many rows of surfaces with their title, points.
pub(super) fn height(rows: usize) -> f32 {
    rows as f32 * (SURFACE + 8.0) + 46.0
}

/// Figures in large type with their names above and a word beside them, three in a row; below each
/// that of the second light, which has a name.
pub(super) fn main_figures(
    ui: &mut Ui,
    theme: Theme,
    figures: &[MainFigure],
    second: Option<(&str, Vec<MainFigure>)>,
) {
    let in_row = if ui.available_width() < 290.0 * theme.scale {
        2
    } else {
        3
    };
    let width = ui.available_width() / in_row as f32;
    // Where there is little room that of the second light takes the place of the word.
    let below = second.is_some() && in_row == 3;
    let high = if below { 58.0 } else { 44.0 };
    let its = |name| {
        let (light, all) = second.as_ref()?;
        let figure = all
            .iter()
            .find(|figure: &&MainFigure| figure.name == name)?;
        Some((*light, figure.value.as_str()))
    };
    for row in figures.chunks(in_row) {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            for figure in row {
                let size = vec2(width, high * theme.scale);
                let shown = column(ui, size, |ui| {
                    ui.spacing_mut().item_spacing = vec2(5.0, 1.0);
                    ui.label(RichText::new(figure.name).small().color(theme.faint));
                    let value = RichText::new(&figure.value)
                        .size(20.0 * theme.scale)
                        .strong();
                    ui.horizontal(|ui| {
                        ui.label(value);
                        match its(figure.name).filter(|_| !below) {
                            // The unit stands beside the mixture's.
                            Some((light, value)) => {
                                let bare = value.trim_end_matches(|c| !char::is_numeric(c));
                                of_second(ui, theme, (light, bare));
                            }
                            None => word_of(ui, theme, figure),
                        }
                    });
                    if let Some(second) = its(figure.name).filter(|_| below) {
                        of_second(ui, theme, second);
                    }
                    ui.response()
                });
                shown.on_hover_text(match its(figure.name) {
                    Some((light, value)) => format!("{}\n{light}: {value}.", said(figure.meaning)),
                    None => said(figure.meaning).to_owned(),
                });
            }
        });
    }
}

/// How good a figure is.
fn word_of(ui: &mut Ui, theme: Theme, figure: &MainFigure) {
    let colour = match figure.word {
        "low" | "coloured" => theme.warning,
        _ => theme.faint,
    };
    let word = RichText::new(said(figure.word)).small().color(colour);
    ui.add(egui::Label::new(word).truncate());
}

/// The figure of the second light.
fn of_second(ui: &mut Ui, theme: Theme, (light, value): (&str, &str)) {
    let words = RichText::new(value).small().color(theme.ink(Ink::Second));
    let label = ui.add(egui::Label::new(words).truncate());
    named(&label, egui::Role::Label, &format!("{light}: {value}"));
}

const TO_LIBRARY: &str = later!("To the library");
const SAVE_AS: &str = later!("Save as");

/// Width that the row of what is kept needs in English, points: a narrower one has two.
const KEPT: f32 = 348.0;

/// Height of what is kept in a width, points.
pub(super) fn kept_height(ui: &Ui, width: f32, scale: f32) -> f32 {
    let needs = KEPT * scale * longer([TO_LIBRARY, SAVE_AS, later!("Copy as CSV")]);
    let rows = if width < needs { 2.0 } else { 1.0 };
    let spacing = ui.spacing();
    rows * spacing.interact_size.y + (rows - 1.0) * spacing.item_spacing.y
}

/// Where the mixture goes, and desks to come back to.
pub(super) fn kept_row(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 6.0;
        let recipe = desk.recipe();
        let button = ui
            .add_enabled(recipe.is_some(), egui::Button::new(said(TO_LIBRARY)))
            .on_hover_text(said!(
                "Keeps the mixture as a light of your own and shows it everywhere. It follows the \
                 lights that it is made of."
            ));
        if let Some(recipe) = recipe.filter(|_| button.clicked()) {
            let place = MadeFor::Shown;
            context.commands.push(Command::Make { recipe, place });
        }
        ui.weak(said(SAVE_AS));
        kept(ui, context, desk);
        copy_button(
            ui,
            said!("Copy the channels as CSV"),
            said!(
                "Channels with their drive in per cent, their share of the power, and values for \
                 lighting desks of 8 and 16 bits (DMX)."
            ),
            || desk.table().csv(),
        );
    });
}

/// Surfaces, at the left as under the mixture, at the right as under the second light, without one
/// as under the mixture's reference.
pub(super) fn surfaces(
    ui: &mut Ui,
    context: &mut PageContext<'_>,
    (surfaces, second): (&[Beside], Option<&str>),
    in_row: usize,
) {
    let scale = context.theme.scale;
    let seen = surfaces.len().min(2 * in_row);
    ui.horizontal(|ui| {
        ui.strong(tr!("{n} surfaces" | "{n} surfaces" % seen));
        let beside = second.unwrap_or(said!("its reference"));
        let words = match surfaces.len() {
            0 => said!("a light without a colour temperature has no white to adapt to").to_owned(),
            count if count > seen => {
                tr!(
                    "this mixture | {beside}; the first {seen} of {count}",
                    beside,
                    seen,
                    count
                )
            }
            _ => tr!("this mixture | {beside}", beside),
        };
        let label = egui::Label::new(RichText::new(words).small()).truncate();
        ui.add(label).on_hover_text(said!(
            "Each half as an eye adapted to its light sees it. The reference of a mixture is a \
             blackbody, from 5000 K on daylight, of the same temperature."
        ));
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let choice = Choice {
                name: said!("Surfaces under the mixture"),
                meaning: said!("The surfaces below."),
                width: 130.0 * scale,
            };
            let now = &mut context.pages.mix.surfaces;
            choice.pick(ui, now, DeskSurfaces::ALL, |one| {
                (one.title(), one.meaning())
            });
        });
    });
    let gap = 8.0;
    let rows = surfaces.len().div_ceil(in_row).clamp(1, 2);
    let whole = vec2(
        ui.available_width(),
        rows as f32 * (SURFACE * scale + gap) + gap,
    );
    column(ui, whole, |ui| {
        let ground = ui.max_rect();
        ui.painter()
            .rect_filled(ground, 4.0, context.theme.swatch_ground);
        let mut inside = ui.new_child(egui::UiBuilder::new().max_rect(ground.shrink(gap)));
        let ui = &mut inside;
        ui.spacing_mut().item_spacing = vec2(gap, gap);
        let count = in_row.min(surfaces.len()).max(1) as f32;
        let width = (ui.available_width() - gap * (count - 1.0)) / count;
        let size = vec2(width.max(8.0), SURFACE * scale);
        for row in surfaces.chunks(in_row).take(2) {
            ui.horizontal(|ui| {
                for one in row {
                    let words = &one.words;
                    let shown = swatch::split(ui, size, &one.test, &one.other, words);
                    swatch::ticks(ui, shown.rect, 5.0 * scale);
                    shown.on_hover_text(words);
                }
            });
        }
    });
}

/// Desks to come back to.
fn kept(ui: &mut Ui, context: &mut PageContext<'_>, desk: &Desk) {
    let mut back = None;
    for (slot, name) in context.pages.mix.kept.iter_mut().zip(["A", "B", "C"]) {
        let is_here = slot.as_ref().is_some_and(|kept| kept.mix == desk.mix);
        let button = ui.selectable_label(is_here, name);
        let words = match slot {
            Some(kept) => format!(
                "{}\n{}",
                kept.words,
                said!("Click to restore this mix; right click to forget it.")
            ),
            None => tr!(
                "Saves this mix as {slot}, to restore and to compare.",
                slot = name
            ),
        };
        if button.secondary_clicked() {
            *slot = None;
        } else if button.clicked() {
            match slot {
                Some(kept) => back = Some(kept.mix.clone()),
                None => {
                    *slot = Some(Snapshot {
                        mix: desk.mix.clone(),
                        words: desk.sentence(),
                    });
                }
            }
        }
        button.on_hover_text(words);
    }
    if let Some(mix) = back {
        set(context, mix);
    }
}
