//! Colour and error: the two colours side by side, and every number with its unit.

use eframe::egui;
use egui::{RichText, Ui, vec2};

use super::{
    swatch,
    theme::{Theme, section},
};
use crate::{
    app::{App, derived::Colour},
    color::Swatch,
};

/// Draws the panel; `is_titled` where a tab above says already what it is.
pub fn show(ui: &mut Ui, app: &App, theme: Theme, is_titled: bool) {
    if !app.document().is_about_light() {
        section(ui, &format!("Colour under {}", app.document().light.name()));
    } else if !is_titled {
        section(ui, "Colour and error");
    }
    let colour = &app.derived().colour;
    let (Some(exact), Some(model)) = (colour.exact, colour.model) else {
        ui.weak(match colour.exact {
            None => "No visible light in this range: there is no colour to show.",
            Some(_) => "The model has no colour in this range: there is nothing to compare.",
        });
        errors(ui, app);
        warnings(ui, app, theme);
        return;
    };
    let size = vec2(ui.available_width(), 32.0 * theme.scale);
    swatch::split(
        ui,
        size,
        &exact.swatch,
        &model.swatch,
        &format!(
            "Colour: measured {}, model {}",
            exact.swatch.hex(),
            model.swatch.hex()
        ),
    )
    .on_hover_text(format!(
        "Left as measured, right by the model. {}.{}",
        capitalised(exact.swatch.mapping.words()),
        if exact.swatch.in_gamut && model.swatch.in_gamut {
            ""
        } else {
            " A triangle marks a colour outside sRGB: the screen cannot show it."
        }
    ));
    ui.horizontal(|ui| {
        hex(ui, "measured", &exact.swatch);
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            hex(ui, "model", &model.swatch);
            ui.with_layout(
                egui::Layout::centered_and_justified(egui::Direction::LeftToRight),
                |ui| differences(ui, app),
            );
        });
    });
    numbers(ui, app, exact, model, colour.full);
    errors(ui, app);
    warnings(ui, app, theme);
}

/// Least height of a row of numbers, points: denser than rows of controls.
const ROW: f32 = 16.0;

fn hex(ui: &mut Ui, whose: &str, swatch: &Swatch) {
    let text = swatch.hex();
    let button = ui
        .add(egui::Button::new(RichText::new(&text).monospace()).small())
        .on_hover_text(format!("sRGB of the {whose} colour. Click to copy."));
    button.widget_info(|| {
        egui::WidgetInfo::labeled(egui::Role::Button, true, format!("Copy {whose} {text}"))
    });
    if button.clicked() {
        ui.ctx().copy_text(text);
    }
}

fn differences(ui: &mut Ui, app: &App) {
    let colour = &app.derived().colour;
    let (Some(delta_e), Some(delta_uv)) = (colour.delta_e_2000, colour.delta_uv) else {
        return;
    };
    let text = format!("ΔE₀₀ {delta_e:.3}   Δu′v′ {delta_uv:.5}");
    ui.label(RichText::new(text).strong()).on_hover_text(
        "CIEDE2000 between measured and model (the white is the measured light), and their \
         distance in the CIE 1976 chromaticity diagram.",
    );
}

fn numbers(ui: &mut Ui, app: &App, exact: Colour, model: Colour, full: Option<Colour>) {
    let observer = app.document().settings.observer.title();
    egui::Grid::new("colour numbers")
        .num_columns(4)
        .min_row_height(ROW)
        .spacing([10.0, 2.0])
        .show(ui, |ui| {
            ui.weak("");
            ui.weak("measured")
                .on_hover_text("On the model's range, 1 nm trapezoid.");
            ui.weak("model");
            ui.weak("360-830")
                .on_hover_text("The measured spectrum by plain 1 nm sums over 360 to 830 nm.");
            ui.end_row();
            let mut row = |name: &str, hint: String, of: &dyn Fn(Colour) -> String| {
                ui.label(name).on_hover_text(hint);
                for colour in [Some(exact), Some(model), full] {
                    ui.monospace(colour.map_or_else(|| "–".to_owned(), of));
                }
                ui.end_row();
            };
            let tristimulus = |what: &str| {
                format!(
                    "Tristimulus value {what} ({observer}); 100 is the Y of the measured light."
                )
            };
            row("X", tristimulus("X"), &|c| format!("{:.3}", c.xyz.x));
            row("Y", tristimulus("Y"), &|c| format!("{:.3}", c.xyz.y));
            row("Z", tristimulus("Z"), &|c| format!("{:.3}", c.xyz.z));
            let chromaticity = "Chromaticity, no unit.".to_owned();
            row("x, y", chromaticity.clone(), &|c| {
                format!("{:.4} {:.4}", c.xy[0], c.xy[1])
            });
            row("u′, v′", chromaticity, &|c| {
                format!("{:.4} {:.4}", c.uv[0], c.uv[1])
            });
            if exact.cct.is_some() {
                row(
                    "CCT",
                    "Correlated colour temperature after Ohno 2013, CIE 1931.".to_owned(),
                    &|c| match c.cct {
                        Some(Ok(cct)) => format!("{:.0} K", cct.kelvin),
                        _ => "–".to_owned(),
                    },
                );
                row(
                    "Duv",
                    "Distance from the blackbody locus in CIE 1960 uv; above it is positive."
                        .to_owned(),
                    &|c| match c.cct {
                        Some(Ok(cct)) => format!("{:+.4}", cct.duv),
                        _ => "–".to_owned(),
                    },
                );
            }
        });
    if let Some(Err(why)) = exact.cct {
        ui.weak(capitalised(&why.to_string()));
    }
}

fn errors(ui: &mut Ui, app: &App) {
    let Some(errors) = app.derived().errors else {
        return;
    };
    let percent = |share: f64| format!("{:.2} %", 100.0 * share);
    egui::Grid::new("errors")
        .num_columns(4)
        .min_row_height(ROW)
        .spacing([10.0, 2.0])
        .show(ui, |ui| {
            let cell = |ui: &mut Ui, name: &str, hint: &str, value: String| {
                ui.label(name).on_hover_text(hint);
                ui.monospace(value);
            };
            cell(
                ui,
                "rms 10 nm",
                "Root mean square of model minus measured over that of the spectrum, both behind a \
                 Gaussian blur of 10 nm full width at half maximum.",
                percent(errors.relative_rms_10nm),
            );
            cell(
                ui,
                "1 nm",
                "The same on the 1 nm grid. A spike has no width: there it stands against a line \
                 of several nm, so lamps with broad lines show large numbers.",
                percent(errors.relative_rms),
            );
            ui.end_row();
            cell(
                ui,
                "largest",
                "Largest difference over the largest value.",
                percent(errors.max_abs),
            );
            cell(
                ui,
                "lowest",
                "Lowest value of the smooth part over the largest value; negative is a lobe below \
                 zero.",
                percent(errors.lowest),
            );
            ui.end_row();
            cell(
                ui,
                "energy",
                "Power of the model over that of the spectrum, less one.",
                // Adding zero turns -0 into 0.
                format!("{:+.3} %", (1e5 * errors.energy).round() / 1e3 + 0.0),
            );
            ui.end_row();
        });
}

fn warnings(ui: &mut Ui, app: &App, theme: Theme) {
    for warning in &app.derived().warnings {
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.colored_label(theme.warning, "▲");
            ui.small(warning);
        });
    }
}

/// A sentence's first letter.
pub(super) fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}
