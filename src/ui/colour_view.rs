//! Colour and error: the two colours side by side, and every number with its unit.

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{
    kit::{figure_grid, named, small_warnings},
    swatch,
    theme::{Theme, section},
};
use crate::{
    app::{
        App,
        answers::judged,
        derived::Colour,
        figures::{OF_COLOUR, OF_LIGHT, SHARES, by_key},
        readings::COUNTS,
    },
    color::Swatch,
    io::many::capitalised,
    languages::{fixed, said},
    study::Measure,
};

/// Draws the panel; `is_titled` where a tab above says already what it is.
pub(super) fn show(ui: &mut Ui, app: &App, theme: Theme, is_titled: bool) {
    if !app.document().is_about_light() {
        section(
            ui,
            &tr!("Colour under {light}", light = app.document().light.name()),
        );
    } else if !is_titled {
        section(ui, said!("Colour and error"));
    }
    let colour = &app.derived().colour;
    let is_counts = judged(app) == Err(COUNTS);
    let (Some(exact), Some(model), false) = (colour.exact, colour.model, is_counts) else {
        ui.weak(match colour.exact {
            _ if is_counts => said(COUNTS),
            None => said!("No visible light in this range: there is no colour to show."),
            Some(_) => said!("The model has no colour in this range: there is nothing to compare."),
        });
        errors(ui, app);
        small_warnings(ui, theme, &app.derived().warnings);
        return;
    };
    let size = vec2(ui.available_width(), 32.0 * theme.scale);
    let mapping = capitalised(crate::languages::said(exact.swatch.mapping.words()));
    let mut about = tr!("Left as measured, right by the model. {mapping}.", mapping);
    if !(exact.swatch.in_gamut && model.swatch.in_gamut) {
        about += " ";
        about += said!("A triangle marks a colour outside sRGB: the screen cannot show it.");
    }
    swatch::split(
        ui,
        size,
        &exact.swatch,
        &model.swatch,
        &tr!(
            "Colour: measured {measured}, model {model}",
            measured = exact.swatch.hex(),
            model = model.swatch.hex()
        ),
    )
    .on_hover_text(about);
    ui.horizontal(|ui| {
        hex(ui, false, &exact.swatch);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            hex(ui, true, &model.swatch);
            ui.with_layout(
                egui::Layout::centered_and_justified(egui::Direction::LeftToRight),
                |ui| differences(ui, app),
            );
        });
    });
    numbers(ui, exact, model, colour.full);
    errors(ui, app);
    small_warnings(ui, theme, &app.derived().warnings);
}

fn hex(ui: &mut Ui, is_model: bool, swatch: &Swatch) {
    let text = swatch.hex();
    let (meaning, name) = if is_model {
        let meaning = said!("sRGB of the model colour. Click to copy.");
        (meaning, tr!("Copy model {colour}", colour = text))
    } else {
        let meaning = said!("sRGB of the measured colour. Click to copy.");
        (meaning, tr!("Copy measured {colour}", colour = text))
    };
    let button = ui
        .add(egui::Button::new(RichText::new(&text).monospace()).small())
        .on_hover_text(meaning);
    named(&button, egui::Role::Button, &name);
    if button.clicked() {
        ui.ctx().copy_text(text);
    }
}

fn differences(ui: &mut Ui, app: &App) {
    let colour = &app.derived().colour;
    let (Some(delta_e), Some(delta_uv)) = (colour.delta_e_2000, colour.delta_uv) else {
        return;
    };
    let text = format!("ΔE₀₀ {}   Δu′v′ {}", fixed(delta_e, 3), fixed(delta_uv, 5));
    ui.label(RichText::new(text).strong()).on_hover_text(said!(
        "CIEDE2000 between measured and model (the white is the measured light), and their \
         distance in the CIE 1976 chromaticity diagram."
    ));
}

fn numbers(ui: &mut Ui, exact: Colour, model: Colour, full: Option<Colour>) {
    // Where they have no room side by side they scroll.
    egui::ScrollArea::horizontal()
        .id_salt("colour numbers")
        .show(ui, |ui| grid(ui, exact, model, full));
    if let Some(Err(why)) = exact.cct {
        ui.weak(capitalised(&why.to_string()));
    }
}

fn grid(ui: &mut Ui, exact: Colour, model: Colour, full: Option<Colour>) {
    figure_grid(ui, "colour numbers", |ui| {
        ui.weak("");
        ui.weak(said!("measured"))
            .on_hover_text(said!("On the model's range, 1 nm trapezoid."));
        ui.weak(said!("model"));
        ui.weak("360-830").on_hover_text(said!(
            "The measured spectrum by plain 1 nm sums over 360 to 830 nm."
        ));
        ui.end_row();
        let of_light = by_key(&OF_LIGHT).filter(|_| exact.cct.is_some());
        // Two of a kind stand in one row; for three there is no room.
        for figures in by_key(&OF_COLOUR)
            .chain(of_light)
            .flat_map(|kind| kind.chunks(if kind.len() > 2 { 1 } else { 2 }))
        {
            let titles: Vec<&str> = figures.iter().map(|f| f.figure.title()).collect();
            ui.label(titles.join(", "))
                .on_hover_text(figures[0].figure.meaning());
            for colour in [Some(exact), Some(model), full] {
                let written = figures
                    .iter()
                    .map(|row| Some(row.figure.written((row.of)(&colour?)?)));
                let written: Option<Vec<String>> = written.collect();
                ui.monospace(written.map_or_else(|| "–".to_owned(), |w| w.join(" ")));
            }
            ui.end_row();
        }
    });
}

fn errors(ui: &mut Ui, app: &App) {
    if !app.derived().has_errors() {
        return;
    }
    figure_grid(ui, "errors", |ui| {
        for pair in SHARES.chunks(2) {
            for measure in pair {
                let (figure, value) = (measure.figure(), app.derived().figures[*measure]);
                let name = match measure {
                    // Behind its like it need not say of what.
                    Measure::Rms => "1 nm",
                    _ => figure.short(),
                };
                ui.label(name).on_hover_text(figure.meaning());
                ui.monospace(value.map_or_else(String::new, |v| figure.written(v)));
            }
            ui.end_row();
        }
    });
}
