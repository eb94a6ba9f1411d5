//! Through reflectances: each patch under the measured light and under the model.

use eframe::egui;
use egui::{Align2, Ui, vec2};

use super::{kit::Choice, swatch, theme::Theme};
use crate::app::{App, Command, View, derived::PatchComparison, library::Library};

/// Most patches in one row: the ColorChecker makes two rows.
const PER_ROW: usize = 12;

/// A choice among the sets of reflectances.
pub(super) fn set_choice(ui: &mut Ui, choice: Choice<'_>, app: &App, commands: &mut Vec<Command>) {
    let now = &app.document().patch_set;
    choice.show(ui, set_title(now), |ui| {
        let groups = Library::bundled().all_groups();
        for group in groups.filter(|g| g.items.iter().any(|p| p.kind.is_factor())) {
            let response = ui.selectable_label(*now == group.id, set_title(&group.id));
            if response.on_hover_text(&group.title).clicked() {
                commands.push(Command::PatchSet(group.id.clone()));
            }
        }
    });
}

/// The row above the patches: the set and its errors.
pub fn head(ui: &mut Ui, app: &App, commands: &mut Vec<Command>) {
    let document = app.document();
    let choice = Choice {
        name: "Patch set",
        meaning: "Whose reflectances the light falls on.",
        width: 128.0,
    };
    set_choice(ui, choice, app, commands);
    if let Some(patches) = &app.derived().patches {
        ui.label("mean ΔE₀₀");
        ui.strong(format!("{:.3}", patches.mean));
        ui.label("worst");
        ui.strong(format!("{:.3}", patches.max)).on_hover_text(
            patches
                .items
                .get(patches.worst)
                .map_or_else(String::new, |p| p.name.clone()),
        );
    }
    let mut adapt = document.view.adapt_patches;
    if ui
        .checkbox(&mut adapt, "Adapt")
        .on_hover_text(
            "Shows the patches as an eye adapted to the light sees them (Bradford). It changes \
             the colours on screen, not the errors.",
        )
        .changed()
    {
        commands.push(Command::View(View {
            adapt_patches: adapt,
            ..document.view
        }));
    }
}

/// The patches themselves.
pub fn patches(ui: &mut Ui, app: &App, theme: Theme, commands: &mut Vec<Command>) {
    let Some(comparison) = &app.derived().patches else {
        ui.add_space(6.0);
        ui.weak(if app.document().is_about_light() {
            "There is no visible light for the patches in this range."
        } else {
            "The model is of a reflectance: choose the light above to see patches under it."
        });
        return;
    };
    egui::ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| grid(ui, app, comparison, theme, commands));
}

fn grid(
    ui: &mut Ui,
    app: &App,
    comparison: &PatchComparison,
    theme: Theme,
    commands: &mut Vec<Command>,
) {
    let spacing = 4.0;
    ui.spacing_mut().item_spacing = vec2(spacing, 2.0);
    let width = (ui.available_width() - spacing * (PER_ROW - 1) as f32) / PER_ROW as f32;
    let text_height = 13.0 * theme.scale;
    let rows = comparison.items.len().div_ceil(PER_ROW).max(1);
    // Two rows fill the panel; more of them scroll.
    let height = ((ui.available_height() - 6.0) / rows.min(2) as f32 - text_height - 4.0)
        .clamp(18.0, 60.0 * theme.scale);
    let selected = app.document().patch;
    for (row, chunk) in comparison.items.chunks(PER_ROW).enumerate() {
        ui.horizontal(|ui| {
            for (column, patch) in chunk.iter().enumerate() {
                let index = row * PER_ROW + column;
                ui.allocate_ui(vec2(width, height + text_height), |ui| {
                    ui.vertical(|ui| {
                        let name = format!("{}: ΔE00 {:.3}", patch.name, patch.delta_e_2000);
                        let response = swatch::split(
                            ui,
                            vec2(width, height),
                            &patch.exact_swatch,
                            &patch.model_swatch,
                            &name,
                        );
                        if selected == Some(index) {
                            let stroke = egui::Stroke::new(2.0, ui.visuals().strong_text_color());
                            swatch::outline(ui, response.rect, stroke);
                        }
                        if response.clicked() {
                            let patch = (selected != Some(index)).then_some(index);
                            commands.push(Command::Patch(patch));
                        }
                        response.on_hover_text(format!(
                            "{}: ΔE₀₀ {:.4}\nLeft under the measured light {}, right under the \
                             model {}.\nClick to see its product in the plot.",
                            patch.name,
                            patch.delta_e_2000,
                            patch.exact_swatch.hex(),
                            patch.model_swatch.hex(),
                        ));
                        let (rect, _) =
                            ui.allocate_exact_size(vec2(width, text_height), egui::Sense::hover());
                        let worst = index == comparison.worst;
                        ui.painter().text(
                            rect.center(),
                            Align2::CENTER_CENTER,
                            delta_words(patch.delta_e_2000, worst),
                            egui::TextStyle::Small.resolve(ui.style()),
                            if worst {
                                ui.visuals().strong_text_color()
                            } else {
                                ui.visuals().text_color()
                            },
                        );
                    });
                });
            }
        });
    }
}

/// A short error; the worst one is marked by a sign, not by colour.
fn delta_words(delta: f64, worst: bool) -> String {
    let number = if delta < 0.0095 {
        "<.01".to_owned()
    } else if delta < 9.95 {
        format!("{delta:.2}")
    } else {
        format!("{delta:.1}")
    };
    if worst {
        format!("▲{number}")
    } else {
        number
    }
}

/// A patch set's short title for the menu.
pub(super) fn set_title(id: &str) -> String {
    let known = match id {
        "colorchecker_ohta" => "ColorChecker 24",
        "tm30_ces99_5nm" => "TM-30, 99 samples",
        "cri_tcs" => "CRI test colours",
        "nist_cqs_vs" => "NIST CQS samples",
        "pmc_chart" => "Memory colours",
        "aces_training_190" => "AMPAS 190",
        "metals_refractiveindex" => "Metals",
        "usgs_splib07" => "USGS materials",
        "filters_glass_cc0" => "Filter glasses",
        "ideal_filters" => "Ideal filters",
        "everyday_surfaces" => "Everyday surfaces",
        other => other,
    };
    known.to_owned()
}
