//! The verdict in little room, beside the patches or over them.

use eframe::egui;
use egui::{Label, RichText, Ui, vec2};

use super::{
    kit::down,
    steps_view::through_a_prism,
    swatch,
    theme::Theme,
    verdict_view::{SWATCH, counts, figure, split},
};
use crate::app::{
    App, Pair,
    answers::{Worst, judged, of_how_many, verdict, verdict_alone},
    behind_slit::BehindSlit,
    verdicts::Seen,
};
use crate::io::many;

/// Below this height swatch, word and numbers stand in one line, points.
const LINE: f32 = 56.0;

/// Least width of a swatch with words below it, points.
const CAPTIONS: f32 = 96.0;

/// Swatch, word and numbers in little room.
pub(super) fn brief(ui: &mut Ui, app: &App, theme: Theme) {
    let outline = ui.visuals().widgets.noninteractive.bg_stroke;
    let is_line = ui.available_height() < LINE * theme.scale;
    egui::Frame::new()
        .stroke(outline)
        .corner_radius(4)
        .inner_margin(if is_line { 4 } else { 8 })
        .show(ui, |ui| {
            ui.set_min_size(ui.available_size());
            let height = ui.available_height();
            let worst = match judged(app) {
                Ok(worst) => worst,
                Err(why) => return drop(ui.add(Label::new(why).wrap())),
            };
            if is_line {
                return ui
                    .horizontal_centered(|ui| brief_line(ui, app, theme, (height, &worst)))
                    .inner;
            }
            ui.horizontal_top(|ui| {
                let width = (0.4 * ui.available_width()).min(120.0 * theme.scale);
                down(ui, vec2(width, height), |ui| {
                    ui.set_width(width);
                    let says = width >= CAPTIONS * theme.scale;
                    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
                    let captions = if says { row } else { 0.0 };
                    let swatch = (height - captions).min(SWATCH * theme.scale);
                    split(ui, app, theme, swatch - 16.0, says);
                });
                let rest = ui.available_width().max(0.0);
                down(ui, vec2(rest, height), |ui| {
                    let seen = Seen::of(worst.delta_e_2000);
                    let size = if theme.scale > 1.0 { 14.0 } else { 18.0 };
                    let words = RichText::new(verdict_alone(app, seen)).size(size * theme.scale);
                    let words = Label::new(words.color(ui.visuals().strong_text_color()));
                    ui.add(words.wrap()).on_hover_text(verdict(app, seen));
                    let (off, of) = (figure(worst.delta_e_2000), of_how_many(app));
                    // Large type has room for the numbers alone.
                    let is_large = theme.scale > 1.0;
                    let words = match is_large {
                        true => format!("ΔE₀₀ {off}"),
                        false => format!("ΔE₀₀ {off} at worst{of}"),
                    };
                    ui.add(Label::new(words).truncate());
                    // Without room for it, the words above and the numbers are enough.
                    let has_room = height >= 92.0 && theme.scale <= 1.0;
                    if let Some(behind) = BehindSlit::of(app).filter(|_| has_room) {
                        let words = format!("Instrument: {} % off", behind.percent());
                        ui.add(Label::new(words).truncate())
                            .on_hover_text(behind.step.meaning_behind_slit());
                    }
                    let (numbers, instead) = counts(app);
                    let words = match is_large {
                        true => many::numbers(numbers),
                        false => format!("{}, not {instead}", many::numbers(numbers)),
                    };
                    ui.add(Label::new(words).wrap());
                });
            });
        });
}

/// Swatch, strip, verdict and numbers before a class, over each other.
pub(super) fn presented(ui: &mut Ui, app: &App, theme: Theme) {
    let strong = ui.visuals().strong_text_color();
    ui.spacing_mut().item_spacing.y = 4.0;
    let worst = judged(app);
    match &worst {
        Err(why) => drop(ui.add(Label::new(*why).wrap())),
        Ok(_) => {
            split(ui, app, theme, 72.0, false);
            through_a_prism(ui, app, theme);
        }
    }
    ui.add_space(6.0);
    if let Ok(worst) = worst {
        let seen = Seen::of(worst.delta_e_2000);
        let words = RichText::new(verdict_alone(app, seen)).size(20.0 * theme.scale);
        ui.add(Label::new(words.color(strong)).wrap())
            .on_hover_text(verdict(app, seen));
        ui.add_space(6.0);
        let words = format!("To the eye: {}", seen.word().to_lowercase());
        ui.add(Label::new(words).wrap())
            .on_hover_text(seen.meaning());
    }
    if let Some(behind) = BehindSlit::of(app) {
        let words = format!("To an instrument: {}", behind.step.word().to_lowercase());
        ui.add(Label::new(words).wrap())
            .on_hover_text(behind.step.meaning_behind_slit());
    }
    ui.add_space(6.0);
    let (numbers, instead) = counts(app);
    ui.horizontal(|ui| {
        let size = 32.0 * theme.scale;
        ui.label(RichText::new(numbers.to_string()).size(size).color(strong));
        let word = if numbers == 1 { "number" } else { "numbers" };
        ui.label(format!("{word},\nnot {instead}"));
    });
}

/// Two surfaces in the same place, one beside the other under the light.
pub(super) fn pair(ui: &mut Ui, pair: &Pair, theme: Theme) {
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let has_words = ui.available_height() >= LINE * theme.scale + row;
    let words = if has_words { row } else { 0.0 };
    let room = ui.available_size();
    let [left, right] = &pair.names;
    let name = format!(
        "Surfaces: {left} {}, {right} {}, under {}",
        pair.swatches[0].hex(),
        pair.swatches[1].hex(),
        pair.light
    );
    let [a, b] = &pair.swatches;
    swatch::split(ui, vec2(room.x, (room.y - words).max(1.0)), a, b, &name).on_hover_text(format!(
        "Left {left}, right {right}, both under {}.",
        pair.light
    ));
    if has_words {
        let words = format!("{left} | {right}, under {}", pair.light);
        ui.add(Label::new(RichText::new(words).color(theme.faint)).truncate());
    }
}

/// The same in one line.
fn brief_line(ui: &mut Ui, app: &App, theme: Theme, (height, worst): (f32, &Worst)) {
    let width = 64.0 * theme.scale;
    ui.allocate_ui(vec2(width, height), |ui| {
        ui.set_width(width);
        split(ui, app, theme, height - 16.0, false);
    });
    let seen = Seen::of(worst.delta_e_2000);
    let words = RichText::new(verdict_alone(app, seen)).color(ui.visuals().strong_text_color());
    ui.label(words).on_hover_text(verdict(app, seen));
    let (numbers, instead) = counts(app);
    let (off, of) = (figure(worst.delta_e_2000), of_how_many(app));
    let words = format!(
        "ΔE₀₀ {off} at worst{of}, {}, not {instead}",
        many::numbers(numbers)
    );
    ui.add(Label::new(words).truncate());
}
