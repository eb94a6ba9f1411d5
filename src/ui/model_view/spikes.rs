//! The knobs of the lines.

use eframe::egui;
use egui::{Slider, SliderClamping, Ui};

use super::{named, names};
use crate::app::{Detector, GRADIENTS_PERCENT, Settings, THRESHOLDS_PERCENT, WIDTHS_NM, ticks};

/// The sliders' own reach; more can be typed.
const SLIDER_THRESHOLDS: std::ops::RangeInclusive<f64> = 0.1..=5.0;
const SLIDER_WIDTHS_NM: std::ops::RangeInclusive<f64> = 2.0..=20.0;

/// The least line: by its slope or its share of the power.
fn threshold_row(ui: &mut Ui, settings: &mut Settings) {
    let enabled = settings.spikes;
    if settings.detector == Detector::Gradient {
        let label = ui.add_enabled(enabled, egui::Label::new("Slope"));
        ui.add_enabled(
            enabled,
            Slider::new(&mut settings.gradient_percent, GRADIENTS_PERCENT)
                .logarithmic(true)
                .custom_formatter(|v, _| ticks::short(v))
                .suffix(" %/nm"),
        )
        .labelled_by(label.id)
        .on_hover_text("Least slope of a line's flanks, percent of the largest value per nm.");
    } else {
        let label = ui.add_enabled(enabled, egui::Label::new(names::THRESHOLD));
        ui.add_enabled(
            enabled,
            Slider::new(&mut settings.threshold_percent, SLIDER_THRESHOLDS)
                .logarithmic(true)
                .clamping(SliderClamping::Never)
                .custom_formatter(|v, _| ticks::short(v))
                .suffix(" %"),
        )
        .labelled_by(label.id)
        .on_hover_text(format!(
            "Least share of the total power that a spike must carry, percent. {} to {} can be \
             typed.",
            THRESHOLDS_PERCENT.start(),
            THRESHOLDS_PERCENT.end()
        ));
    }
    ui.end_row();
}

/// Draws what is taken for a line.
pub(super) fn spike_rows(ui: &mut Ui, settings: &mut Settings) {
    ui.checkbox(&mut settings.spikes, names::SPIKES)
        .on_hover_text("Take lines out of the spectrum and keep each as a place and a weight.");
    ui.horizontal(|ui| {
        ui.add_enabled_ui(settings.spikes, |ui| {
            let chosen = match settings.detector {
                Detector::Energy => "by energy",
                Detector::Gradient => "by gradient",
            };
            let combo = egui::ComboBox::from_id_salt("detector")
                .selected_text(chosen)
                .width(ui.spacing().combo_width)
                .show_ui(ui, |ui| {
                    ui.selectable_value(&mut settings.detector, Detector::Energy, "by energy")
                        .on_hover_text(
                            "Prominent, narrow peaks whose energy is above the threshold.",
                        );
                    ui.selectable_value(&mut settings.detector, Detector::Gradient, "by gradient")
                        .on_hover_text("The paper's way: steep on both sides.");
                });
            named(&combo.response, egui::Role::ComboBox, "Spike detector");
            combo
                .response
                .on_hover_text("How lines are told from the smooth part.");
            ui.add_enabled(
                settings.detector == Detector::Energy,
                egui::Checkbox::new(&mut settings.dips, names::DIPS),
            )
            .on_disabled_hover_text("The gradient detector only looks for lines that stand up.")
            .on_hover_text(
                "Look for absorption lines as well; they become spikes of negative weight.",
            );
        });
    });
    ui.end_row();

    threshold_row(ui, settings);
    let enabled = settings.spikes;
    let label = ui.add_enabled(enabled, egui::Label::new(names::WIDTH));
    ui.add_enabled(
        enabled,
        Slider::new(&mut settings.max_width_nm, SLIDER_WIDTHS_NM)
            .clamping(SliderClamping::Never)
            .custom_formatter(|v, _| ticks::short(v))
            .suffix(" nm"),
    )
    .labelled_by(label.id)
    .on_hover_text(format!(
        "Full width at half maximum of the widest line that may become a spike, nm. {} to {} can \
         be typed.",
        WIDTHS_NM.start(),
        WIDTHS_NM.end()
    ));
    ui.end_row();
}
