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
    answers::{Worst, judged, verdict, verdict_alone},
    behind_slit::BehindSlit,
    verdicts::Seen,
};
use crate::{io::many, languages::said};

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
                Err(why) => return drop(ui.add(Label::new(said(why)).wrap())),
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
                    // Large type has room for the numbers alone.
                    let is_large = theme.scale > 1.0;
                    let words = match is_large {
                        true => format!("ΔE₀₀ {}", figure(worst.delta_e_2000)),
                        false => at_worst(app, &worst),
                    };
                    ui.add(Label::new(words).truncate());
                    // Without room for it, the words above and the numbers are enough.
                    let has_room = height >= 92.0 && theme.scale <= 1.0;
                    if let Some(behind) = BehindSlit::of(app).filter(|_| has_room) {
                        let words = tr!("Instrument: {share} % off", share = behind.percent());
                        ui.add(Label::new(words).truncate())
                            .on_hover_text(behind.step.meaning_behind_slit());
                    }
                    let (numbers, instead) = counts(app);
                    let words = match is_large {
                        true => many::numbers(numbers),
                        false => tr!(
                            "{numbers}, not {instead}",
                            numbers = many::numbers(numbers),
                            instead
                        ),
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
    match worst {
        Err(why) => drop(ui.add(Label::new(said(why)).wrap())),
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
        let words = match seen {
            Seen::Hardly => said!("To the eye: hard to tell"),
            Seen::SideBySide => said!("To the eye: slight"),
            Seen::Visible => said!("To the eye: clear"),
            Seen::Large => said!("To the eye: large"),
        };
        ui.add(Label::new(words).wrap())
            .on_hover_text(seen.meaning());
    }
    if let Some(behind) = BehindSlit::of(app) {
        let words = match behind.step {
            Seen::Hardly => said!("To an instrument: hard to tell"),
            Seen::SideBySide => said!("To an instrument: slight"),
            Seen::Visible => said!("To an instrument: clear"),
            Seen::Large => said!("To an instrument: large"),
        };
        ui.add(Label::new(words).wrap())
            .on_hover_text(behind.step.meaning_behind_slit());
    }
    ui.add_space(6.0);
    let (numbers, instead) = counts(app);
    ui.horizontal(|ui| {
        let size = 32.0 * theme.scale;
        ui.label(RichText::new(numbers.to_string()).size(size).color(strong));
        // The number itself stands before it, in large type.
        ui.label(match numbers {
            1 => tr!("number,\nnot {instead}", instead),
            _ => tr!("numbers,\nnot {instead}", instead),
        });
    });
}

/// Two surfaces in the same place, one beside the other under the light.
pub(super) fn pair(ui: &mut Ui, pair: &Pair, theme: Theme) {
    let row = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    let has_words = ui.available_height() >= LINE * theme.scale + row;
    let words = if has_words { row } else { 0.0 };
    let room = ui.available_size();
    let [left, right] = &pair.names;
    let name = tr!(
        "Surfaces: {left} {left_hex}, {right} {right_hex}, under {light}",
        left,
        left_hex = pair.swatches[0].hex(),
        right,
        right_hex = pair.swatches[1].hex(),
        light = pair.light
    );
    let [a, b] = &pair.swatches;
    swatch::split(ui, vec2(room.x, (room.y - words).max(1.0)), a, b, &name).on_hover_text(tr!(
        "Left {left}, right {right}, both under {light}.",
        left,
        right,
        light = pair.light
    ));
    if has_words {
        let words = tr!(
            "{left} | {right}, under {light}",
            left,
            right,
            light = pair.light
        );
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
    let counted = tr!(
        "{numbers}, not {instead}",
        numbers = many::numbers(numbers),
        instead
    );
    let words = format!("{}, {counted}", at_worst(app, worst));
    ui.add(Label::new(words).truncate());
}

/// How far the worst surface is off, and of how many it is.
fn at_worst(app: &App, worst: &Worst) -> String {
    let off = figure(worst.delta_e_2000);
    match &app.derived().patches {
        Some(patches) => tr!(
            "ΔE₀₀ {off} at worst of {count}",
            off,
            count = patches.items.len()
        ),
        None => tr!("ΔE₀₀ {off} at worst", off),
    }
}
